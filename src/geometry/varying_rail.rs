//! A rail whose section varies along the track, as the wheel above it meets it: the outline of all its sections.
//!
//! The section at x from the axle is met by a part of the wheel that stands higher than its lowest points, by
//!
//! ```text
//! D(x) = sqrt((x - x_l)² + z²) - z
//! ```
//!
//! for a point of the rail at the height z below the axle, with x_l the place of the contact line, which is zero where the wheel does not yaw. Moved down
//! by that, every section can be compared with the even contact line. What the wheel can touch is the envelope of all sections that are moved so:
//! on each row v of the surface P the x at which
//!
//! ```text
//! n · F_x = 0,   F(x, v) = P + D e
//! ```
//!
//! with e the direction down in the plane of the rolling circles and n the normal of the wheel opposite. Along the row the bodies are nearest there, and
//! where they touch their normals have the same part along x, so that the place is the one of a search in three dimensions. Where the surface is
//! the same all along the track it is x_l, and the envelope is the section. Strips of the contact lie along the rows: a rail whose edge runs off
//! sideways turns its patch with it.

use crate::geometry::contact_line::{ContactLine, WheelPose};
use crate::geometry::curve::{Curve, Knot};
use crate::geometry::slices::{Rows, Slices, arc};
use crate::math::room::Room;

/// Rows of which only one is looked through for hollows.
const STRIDE: usize = 4;
/// How far below the wheel a row surely stays where its place is no longer looked for [m].
const FAR_BELOW: f64 = 0.02;
/// How far below the wheel rows surely stay of which a few are enough: nothing touches there [m].
const APART: f64 = 3e-4;
/// Distance of these few [m].
const WIDE: f64 = 2e-3;
/// Radius of the lowest points of any wheel over its nominal one, and steepest flank of any wheel [-].
const LARGEST: f64 = 1.1;
const STEEPEST_FLANK: f64 = 3.0;
/// Distance of rows over which their places and those of the wheel opposite go on as before [m].
const CLOSE: f64 = 3e-3;
/// Greatest difference of places along the track of two rows that are taken for a trend [m].
const TREND: f64 = 5e-3;
/// How far beside the wheel rows are looked at [m].
const BESIDE: f64 = 0.01;
/// Farthest place of touch from the axle [m].
const REACH: f64 = 0.12;
/// Newton steps to the place along a row, the last of them, and the longest [m].
const MOST_STEPS: usize = 8;
/// What is left of it is of the order of its square over the distance of slices.
const LAST_STEP: f64 = 1e-5;
const LONGEST_STEP: f64 = 0.02;
/// Spacing at which a row that is hollow for the wheel is looked through [m].
const SCAN: f64 = 4e-3;
/// Curvature along the track from which on a row may be hollow for a wheel, over that of the wheel [-].
const HOLLOW_SHARE: f64 = 0.7;
/// Least distance of two rows on the envelope [m].
const LEAST_ARC: f64 = 1e-6;
/// Cells of the table of the wheel [m].
const CELL: f64 = 1e-3;

/// Where a wheel meets a varying rail along the track.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Along {
    /// How far ahead of the even contact line the bodies are nearest [m].
    pub ahead: f64,
    /// Curvature of the rail along the track, along the normal of its section at a place across that does not change; positive where it bulges [1/m].
    pub curvature: f64,
    /// Slope of the rail there: tangent of the angle by which its normal leans forward [-].
    pub lean: f64,
    /// How fast its rows drift across there [-].
    pub drift: f64,
}

impl Along {
    /// Each of them by its own function of itself.
    fn each(value: impl Fn(fn(&Self) -> f64) -> f64) -> Self {
        Self {
            ahead: value(|a| a.ahead),
            curvature: value(|a| a.curvature),
            lean: value(|a| a.lean),
            drift: value(|a| a.drift),
        }
    }

    /// What a curvature along the track is along the lean, over itself: cos³ of the angle [-].
    #[must_use]
    pub fn shortening(&self) -> f64 {
        (1.0 + self.lean * self.lean).powf(-1.5)
    }
}

/// A rail whose section varies.
#[derive(Clone, Debug)]
pub struct VaryingRail {
    rows: Rows,
    /// For each row and slice the number of slices up to it between which the row may be hollow.
    hollows: Vec<u32>,
    /// By slices but the last, and rows within each: where a row can be met by a wheel between this slice and the next one.
    bounds: Vec<Bound>,
    /// Parameter and radius of the wheel over cells of its width; of what lies lowest.
    wheel: WheelTable,
    /// Rows of the envelope: parameters and what belongs to them.
    along: Room<[Along; 2]>,
    knots: Room<Knot>,
    kept: Room<Met>,
    met: Room<Met>,
}

/// Where a row is within reach.
#[derive(Clone, Copy, Debug)]
struct Bound {
    /// Range of y [m].
    y: [f64; 2],
    /// Least z [m].
    least: f64,
    /// Least z of what a wheel meets, lowered by what its part above stands higher [m].
    top: f64,
}

/// A wheel by its width.
#[derive(Clone, Debug)]
struct WheelTable {
    start: f64,
    /// Parameter of the lowest point of each cell, and its z [m].
    cells: Vec<[f64; 2]>,
}

/// A row that the wheel meets.
#[derive(Clone, Copy, Debug, Default)]
struct Met {
    row: usize,
    point: [f64; 2],
    /// F_v and F_x.
    direction: [f64; 2],
    first: [f64; 2],
    /// Where it is, from the wheel marker [m].
    x: f64,
    along: Along,
    /// Parameter of the wheel opposite and coordinate to the right there; nothing where it is not looked for.
    opposite: Option<[f64; 2]>,
}

/// A row at one place: point and derivative across, both with their derivatives along the track.
#[derive(Clone, Copy, Debug)]
struct RowPoint {
    value: [f64; 4],
    first: [f64; 4],
    second: [f64; 2],
}

/// The wheel above the rail.
struct Over<'a> {
    line: &'a ContactLine<'a>,
    marker: [f64; 2],
    /// Directions to the right and down in the plane across the track [-].
    right: [f64; 2],
    down: [f64; 2],
    yaws: bool,
    nominal_radius: f64,
    /// How far to either side and below a yawed and rolled wheel may be beyond its table [m].
    margin: [f64; 2],
    station: f64,
    /// Number of the slice before the station, and of those around all that is within reach.
    slice: usize,
    within: [usize; 2],
}

impl WheelTable {
    fn new(wheel: &Curve) -> Self {
        let mut table = Self { start: 0.0, cells: Vec::new() };
        table.put(wheel);
        table
    }

    fn put(&mut self, wheel: &Curve) {
        let (from, length) = (wheel.start(), wheel.end() - wheel.start());
        let count = (length / (0.2 * CELL)).ceil() as usize;
        let sample = |i: usize| {
            let s = from + length * i as f64 / count as f64;
            (s, wheel.at(s).point)
        };
        let range = (0..=count).map(|i| sample(i).1[0]);
        let [least, greatest] = range.fold([f64::MAX, f64::MIN], |[a, b], y| [a.min(y), b.max(y)]);
        self.start = least;
        self.cells.clear();
        self.cells.resize(((greatest - least) / CELL) as usize + 1, [from, f64::NEG_INFINITY]);
        for (s, [y, z]) in (0..=count).map(sample) {
            let cell = &mut self.cells[((y - least) / CELL) as usize];
            if z > cell[1] {
                *cell = [s, z];
            }
        }
    }

    /// Number of the cell at `y`, and whether it is on the wheel or not far beside.
    fn cell(&self, y: f64) -> Option<usize> {
        let cell = (y - self.start) / CELL;
        let beside = BESIDE / CELL;
        let last = self.cells.len() - 1;
        (cell > -beside && cell < last as f64 + beside).then(|| (cell.max(0.0) as usize).min(last))
    }

    /// Greatest z of the wheel from one place across to another one [m].
    fn lowest(&self, [from, to]: [f64; 2]) -> f64 {
        let cell = |y: f64| ((y - self.start) / CELL).max(0.0) as usize;
        let cells = &self.cells[cell(from).min(self.cells.len())..];
        let count = (cell(to) + 1).saturating_sub(cell(from)).min(cells.len());
        cells[..count].iter().map(|c| c[1]).fold(f64::NEG_INFINITY, f64::max)
    }
}

impl VaryingRail {
    /// The rail of `slices`, whose points and directions `point` and `direction` put where it stands, turned left to right if `turned`, under wheels with the
    /// profile `wheel` and the radius `nominal_radius` [m].
    #[must_use]
    pub fn new(
        slices: &Slices,
        point: impl Fn([f64; 2]) -> [f64; 2],
        direction: impl Fn([f64; 2]) -> [f64; 2],
        turned: bool,
        wheel: &Curve,
        nominal_radius: f64,
    ) -> Self {
        let rows = slices.rows(point, direction);
        let rows = if turned { rows.turned() } else { rows };
        let count = rows.parameter.len();
        let most = HOLLOW_SHARE / nominal_radius;
        let mut hollows = vec![0; count * rows.places.len()];
        for i in 1..rows.places.len() {
            let h = rows.places[i] - rows.places[i - 1];
            for j in 0..count {
                let [from, to] = [i - 1, i].map(|i| rows.knots[i * count + j]);
                // Second derivatives at both ends, between which that of a cubic is straight.
                let bends = |c: usize| {
                    let rise = 3.0 * (to.value[c] - from.value[c]) / h;
                    [
                        2.0 * (rise - 2.0 * from.slope[c] - to.slope[c]) / h,
                        2.0 * (from.slope[c] + 2.0 * to.slope[c] - rise) / h,
                    ]
                };
                let (y, z) = (bends(0), bends(1));
                // Along any normal between that of the section and the vertical: hollow is what bends up.
                let is_hollow = [from, to].into_iter().any(|knot| {
                    let [_, _, dy, dz] = knot.value;
                    let limit = most * dy.hypot(dz);
                    [0, 1]
                        .into_iter()
                        .any(|end| (y[end] * dz).abs() - z[end].min(0.0) * dy.hypot(dz) > limit)
                });
                hollows[i * count + j] = hollows[(i - 1) * count + j] + u32::from(is_hollow);
            }
        }
        Self {
            hollows,
            bounds: bounds(&rows, nominal_radius),
            wheel: WheelTable::new(wheel),
            along: Room::new(count),
            knots: Room::new(count),
            kept: Room::new(count),
            met: Room::new(count),
            rows,
        }
    }

    /// Most rows of the envelope.
    #[must_use]
    pub fn most_knots(&self) -> usize {
        self.rows.parameter.len()
    }

    /// Faces between neighbouring slices and rows, by their corners (y, z) [m].
    pub fn faces(&self) -> impl Iterator<Item = [[f64; 2]; 4]> + Clone + '_ {
        let count = self.rows.parameter.len();
        let slices = self.rows.knots.chunks(count).zip(self.rows.knots.chunks(count).skip(1));
        slices
            .flat_map(|(here, next)| {
                here.windows(2).zip(next.windows(2)).map(|(a, b)| {
                    [a[0], a[1], b[0], b[1]].map(|knot| [knot.value[0], knot.value[1]])
                })
            })
            .filter(|face| face.iter().all(|corner| corner[0].is_finite()))
    }

    /// Row `j` at `x` from the wheel at `station`; the surface is held at its ends.
    fn row(&self, j: usize, run: [usize; 2], station: f64, near: usize) -> RowPoint {
        let places = &self.rows.places;
        let count = self.rows.parameter.len();
        let [first, last] = run;
        let held = |i: usize| {
            let knot = self.rows.knots[i * count + j];
            RowPoint { value: knot.value, first: [0.0; 4], second: [0.0; 2] }
        };
        if station <= places[first] {
            return held(first);
        }
        if station >= places[last] {
            return held(last);
        }
        let mut i = near.clamp(first, last.max(first + 1) - 1);
        while places[i] > station {
            i -= 1;
        }
        while places[i + 1] <= station {
            i += 1;
        }
        let (from, to) = (&self.rows.knots[i * count + j], &self.rows.knots[(i + 1) * count + j]);
        let h = places[i + 1] - places[i];
        let u = station - places[i];
        let mut point = RowPoint { value: [0.0; 4], first: [0.0; 4], second: [0.0; 2] };
        let inverse = 1.0 / h;
        for c in 0..4 {
            let rise = (to.value[c] - from.value[c]) * inverse;
            let (a, b) = (from.slope[c], to.slope[c]);
            let c2 = (3.0 * rise - 2.0 * a - b) * inverse;
            let c3 = (a + b - 2.0 * rise) * inverse * inverse;
            point.value[c] = from.value[c] + u * (a + u * (c2 + u * c3));
            point.first[c] = a + u * (2.0 * c2 + u * 3.0 * c3);
            if c < 2 {
                point.second[c] = 2.0 * c2 + u * 6.0 * c3;
            }
        }
        point
    }

    /// Lays the envelope for the wheel of `line`, which stands at `pose` above `station` [m], into `curve`; allocates nothing within the room that it has. False where
    /// there is no rail within reach.
    pub fn pass(
        &mut self,
        line: &ContactLine,
        pose: &WheelPose,
        station: f64,
        curve: &mut Curve,
    ) -> bool {
        let (sine, cosine) = pose.roll.sin_cos();
        let radius = line.nominal_radius();
        let yawed = STEEPEST_FLANK * radius * pose.yaw * pose.yaw;
        let slice = self.rows.places.partition_point(|p| *p <= station).max(1) - 1;
        let over = Over {
            line,
            marker: [pose.marker[1], pose.marker[2]],
            right: [cosine, sine],
            down: [-sine, cosine],
            yaws: pose.yaw != 0.0,
            nominal_radius: radius,
            margin: [CELL + yawed, APART + 0.5 * STEEPEST_FLANK * yawed],
            station,
            slice,
            within: [
                self.rows.places.partition_point(|p| *p <= station - REACH).max(1) - 1,
                self.rows
                    .places
                    .partition_point(|p| *p < station + REACH)
                    .min(self.rows.places.len() - 1),
            ],
        };
        let mut met = std::mem::take(&mut self.met);
        met.clear();
        let Rows { parameter, parts, .. } = &self.rows;
        let count = parameter.len();
        let mut before: Option<Met> = None;
        let (mut kept, mut looked) = (None, None);
        for j in 0..count {
            let below = self.below(&over, j);
            let is_end = |k: usize| k == 0 || k + 1 == count || parts[k - 1] != parts[k + 1];
            let is_far = kept.is_none_or(|k: usize| parameter[j] - parameter[k] > WIDE);
            if !(below < 0.0 || is_far || is_end(j)) {
                continue;
            }
            kept = Some(j);
            if below > FAR_BELOW {
                met.extend(self.aside(&over, j));
                continue;
            }
            let looks = looked.is_none_or(|k: usize| j - k >= STRIDE);
            if looks {
                looked = Some(j);
            }
            let beside = before.filter(|m| parameter[j] - parameter[m.row] < CLOSE);
            let trend = match (beside, met.len().checked_sub(2).map(|k| met[k])) {
                (Some(b), Some(a)) if (b.x - a.x).abs() < TREND => {
                    (b.x - a.x) / (parameter[b.row] - parameter[a.row])
                }
                _ => 0.0,
            };
            let guess = beside.map(|b| b.x + trend * (parameter[j] - parameter[b.row]));
            if let Some(here) = self.meet(&over, j, guess, beside, looks) {
                met.push(here);
                before = Some(here);
            }
        }
        let is_there = self.lay(&met, curve);
        self.met = met;
        is_there
    }

    /// How far row `j` is surely below the wheel but for the margin within which it counts as near [m].
    fn below(&self, over: &Over, j: usize) -> f64 {
        let count = self.rows.parameter.len();
        let slice = over.slice.min(self.rows.places.len().max(2) - 2);
        let Bound { y, top, .. } = self.bounds[slice * count + j];
        let z = top - over.marker[1];
        let [first, last] = y.map(|y| y - over.marker[0]);
        let across = [first, last].map(|y| y * over.right[0] + z * over.right[1]);
        let lowest = self.wheel.lowest([across[0] - over.margin[0], across[1] + over.margin[0]]);
        let highest = (first * over.down[0]).min(last * over.down[0]) + z * over.down[1];
        highest - (lowest + over.nominal_radius) - over.margin[1]
    }

    /// Row `j` as it is under the axle; nothing where it is not there.
    fn aside(&self, over: &Over, j: usize) -> Option<Met> {
        let run = self.run(j, over)?;
        let range = self.reach(run, over);
        if range[0] > range[1] {
            return None;
        }
        let x = 0.0_f64.clamp(range[0], range[1]);
        let p = self.row(j, run, over.station + x, over.slice);
        Some(over.under_axle(j, &p, x))
    }

    /// From where to where a run of slices is within reach [m].
    fn reach(&self, [first, last]: [usize; 2], over: &Over) -> [f64; 2] {
        let places = &self.rows.places;
        // A row that goes on to the end of the rail is held there.
        let from = if first == 0 { -REACH } else { places[first] - over.station };
        let to = if last + 1 == places.len() { REACH } else { places[last] - over.station };
        [from.max(-REACH), to.min(REACH)]
    }

    /// Makes a curve of the rows that are met.
    fn lay(&mut self, met: &[Met], curve: &mut Curve) -> bool {
        let Self { rows, along, knots, kept, .. } = self;
        along.clear();
        knots.clear();
        kept.clear();
        for m in met {
            let speed = pattern_speed(rows, m.row);
            let size = m.direction[0].hypot(m.direction[1]);
            // Where the rows are met in another place they may turn back: what is covered is no part of the outline.
            let mut is_covered = false;
            while let Some(b) = kept.last() {
                let to = [m.point[0] - b.point[0], m.point[1] - b.point[1]];
                if dot(to, [b.direction[0] + m.direction[0], b.direction[1] + m.direction[1]]) > 0.0
                {
                    break;
                }
                is_covered = to[0] * b.direction[1] - to[1] * b.direction[0] <= 0.0;
                if is_covered {
                    break;
                }
                kept.pop();
                knots.pop();
            }
            if is_covered {
                continue;
            }
            let parameter = match kept.last() {
                None => rows.parameter[m.row],
                Some(b) => {
                    let reached = arc(b.point, b.direction, m.point, m.direction);
                    if reached.is_nan() || reached < LEAST_ARC {
                        continue;
                    }
                    // As long as the section is that of the pattern the parameter is its own.
                    let grown = if rows.parts[b.row] == rows.parts[m.row] {
                        let [from, to] = [b, m].map(|m| {
                            let [y, z, dy, dz] = rows.pattern[m.row];
                            ([y, z], [dy, dz])
                        });
                        let own = rows.parameter[m.row] - rows.parameter[b.row];
                        reached * (own / arc(from.0, from.1, to.0, to.1))
                    } else {
                        reached
                    };
                    knots[knots.len() - 1].s + grown
                }
            };
            kept.push(*m);
            knots.push(Knot {
                s: parameter,
                point: m.point,
                tangent: m.direction.map(|d| d * speed / size),
            });
        }
        // The envelope goes on to the next row, and along the track with it.
        for k in 1..knots.len().saturating_sub(1) {
            let apart = rows.parameter[kept[k + 1].row] - rows.parameter[kept[k - 1].row];
            let moved = kept[k + 1].x - kept[k - 1].x;
            // Rows that are met in different places are not neighbours on the envelope.
            let rate = if moved.abs() < TREND { moved / apart } else { 0.0 };
            let [a, b] = [kept[k].direction, kept[k].first];
            let direction = [a[0] + rate * b[0], a[1] + rate * b[1]];
            let speed = knots[k].tangent[0].hypot(knots[k].tangent[1]);
            let size = direction[0].hypot(direction[1]);
            if dot(direction, a) > 0.0 {
                knots[k].tangent = direction.map(|d| d * speed / size);
            }
        }
        if knots.len() < 2 {
            return false;
        }
        // Slopes by the neighbours, weighted by their distance.
        let last = knots.len() - 1;
        for k in 0..=last {
            let (a, b) = (k.max(1) - 1, (k + 1).min(last));
            let [before, behind] = [[a, k], [k, b]].map(|[from, to]| {
                [knots[to].s - knots[from].s, 1.0 / (knots[to].s - knots[from].s)]
            });
            let slope = |of: fn(&Along) -> f64| {
                let rise = |from: usize, to: usize| of(&kept[to].along) - of(&kept[from].along);
                if a == k {
                    return rise(k, b) * behind[1];
                }
                if b == k {
                    return rise(a, k) * before[1];
                }
                let (one, other) = (rise(a, k) * before[1], rise(k, b) * behind[1]);
                (one * behind[0] + other * before[0]) / (before[0] + behind[0])
            };
            along.push([kept[k].along, Along::each(slope)]);
        }
        curve.put_through(knots);
        true
    }

    /// The run of slices of row `j` that the wheel is over, or the nearest one within reach.
    fn run(&self, j: usize, over: &Over) -> Option<[usize; 2]> {
        let places = &self.rows.places;
        let count = self.rows.parameter.len();
        let of = |i: usize| self.rows.runs[i * count + j].map(|run| run.map(|i| i as usize));
        let (before, after) = (over.slice, (over.slice + 1).min(places.len() - 1));
        match (of(before), of(after)) {
            (Some(a), Some(b)) if a != b => {
                let middle = 0.5 * (places[before] + places[after]);
                Some(if over.station < middle { a } else { b })
            }
            (Some(run), _) | (None, Some(run)) => Some(run),
            (None, None) => {
                let behind = (0..before).rev().take_while(|&i| over.station - places[i] < REACH);
                let ahead = (after..places.len()).take_while(|&i| places[i] - over.station < REACH);
                behind.chain(ahead).find_map(of)
            }
        }
    }

    /// Where the wheel meets row `j`, from the place `guess` and the row `beside` if there are any; nothing where the row is not there.
    fn meet(
        &self,
        over: &Over,
        j: usize,
        guess: Option<f64>,
        beside: Option<Met>,
        looks_through: bool,
    ) -> Option<Met> {
        let run = self.run(j, over)?;
        let range = self.reach(run, over);
        if range[0] > range[1] {
            return None;
        }
        let at = |x: f64| self.row(j, run, over.station + x, over.slice);
        let start = guess.unwrap_or(0.0).clamp(range[0], range[1]);
        let mut x = start;
        let mut p = at(x);
        let [y, _] = over.in_wheel(&p);
        let near = beside.and_then(|b| b.opposite).filter(|[_, own]| (y - own).abs() < CLOSE);
        let near = near.map(|[u, own]| u + y - own);
        let Some(near) = near.or_else(|| self.wheel.cell(y).map(|cell| self.wheel.cells[cell][0]))
        else {
            return Some(over.under_axle(j, &p, x));
        };
        // A wheel that stands upright there may touch.
        let Some(mut opposite) = over.opposite(near, y) else {
            return Some(over.under_axle(j, &p, x));
        };
        let centre = opposite.x;
        if guess.is_none() {
            x = centre.clamp(range[0], range[1]);
        }
        if looks_through && self.is_hollow(j, over) {
            x = self.scanned(j, run, over, (x, &p), [centre, range[0], range[1]]);
        }
        if (x - start).abs() > 0.0 {
            p = at(x);
            opposite = over.opposite(opposite.u, over.in_wheel(&p)[0]).unwrap_or(opposite);
        }
        let mut met = Self::state(over, &p, x, &opposite);
        for _ in 0..MOST_STEPS {
            let step = (-met.g / met.bend.max(0.1 / over.nominal_radius))
                .clamp(-LONGEST_STEP, LONGEST_STEP);
            let next = (x + step).clamp(range[0], range[1]);
            let moved = next - x;
            if moved == 0.0 {
                break;
            }
            x = next;
            p = at(x);
            opposite = over.opposite(opposite.u, over.in_wheel(&p)[0]).unwrap_or(opposite);
            met = Self::state(over, &p, x, &opposite);
            if moved.abs() < LAST_STEP {
                break;
            }
        }
        let State { point, direction, first, curvature, lean, drift, .. } = met;
        let along = Along { ahead: x - opposite.x, curvature, lean, drift };
        let opposite = Some([opposite.u, over.in_wheel(&p)[0]]);
        Some(Met { row: j, point, direction, first, x, along, opposite })
    }

    /// Whether row `j` may be hollow within reach.
    fn is_hollow(&self, j: usize, over: &Over) -> bool {
        let count = self.rows.parameter.len();
        let [from, to] = over.within;
        self.hollows[to * count + j] > self.hollows[from * count + j]
    }

    /// The sample of row `j` that is highest for the wheel.
    fn scanned(
        &self,
        j: usize,
        run: [usize; 2],
        over: &Over,
        (place, here): (f64, &RowPoint),
        [centre, from, to]: [f64; 3],
    ) -> f64 {
        let normal = [-here.value[3], here.value[2]];
        let mut best = (f64::INFINITY, centre);
        // No farther than where a wheel stands higher than the row ever rises.
        let rows = self.rows.parameter.len();
        let slice = over.slice.min(self.rows.places.len().max(2) - 2);
        let rise = (here.value[1] - self.bounds[slice * rows + j].least).max(0.0);
        let far = (2.0 * LARGEST * over.nominal_radius * rise).sqrt() + (place - centre).abs();
        let [from, to] = [from.max(centre - far).min(to), to.min(centre + far).max(from)];
        let count = ((to - from) / SCAN).ceil().max(1.0) as usize;
        for i in 0..=count {
            let x = from + (to - from) * i as f64 / count as f64;
            let p = self.row(j, run, over.station + x, over.slice);
            let to = [p.value[0] - over.marker[0], p.value[1] - over.marker[1]];
            let z = to[0] * over.down[0] + to[1] * over.down[1];
            let down = (x - centre).hypot(z) - z;
            let height: f64 =
                [0, 1].iter().map(|&i| normal[i] * (p.value[i] + down * over.down[i])).sum();
            if height < best.0 {
                best = (height, x);
            }
        }
        best.1
    }

    /// The condition of touch at `x` on a row, opposite to a point of the wheel.
    fn state(over: &Over, p: &RowPoint, x: f64, wheel: &Opposite) -> State {
        let first = [p.first[0], p.first[1]];
        let across = [p.value[2], p.value[3]];
        let to = [p.value[0] - over.marker[0], p.value[1] - over.marker[1]];
        let z = dot(to, over.down);
        let away = x - wheel.x;
        let radius = away.hypot(z);
        let (sine, cosine) = (away / radius, z / radius);
        let down = radius - z;
        // D along a direction of the surface: by its height, and by the place of the contact line.
        let lowered = |v: [f64; 2]| {
            dot(v, over.down) * (cosine - 1.0) - sine * wheel.advance * dot(v, over.right)
        };
        let by_row = lowered(across);
        let along = sine + lowered(first);
        let normal = wheel.normal;
        let tangent = [normal[1], -normal[0]];
        let share = dot(normal, over.down);
        let drift = dot(tangent, first);
        let rail = dot(normal, [p.second[0], p.second[1]]) + wheel.curvature * drift * drift;
        State {
            point: [0, 1].map(|i| p.value[i] + down * over.down[i]),
            direction: [0, 1].map(|i| across[i] + by_row * over.down[i]),
            first: [0, 1].map(|i| first[i] + along * over.down[i]),
            g: dot(normal, first) + share * along,
            bend: rail + share * cosine * cosine / radius,
            curvature: rail,
            drift,
            lean: -dot(normal, first),
        }
    }

    /// Where the wheel that passed last meets the rail at parameter `s` of the envelope.
    #[must_use]
    pub fn along(&self, s: f64) -> Along {
        let n = self.along.len();
        if n < 2 {
            return Along::default();
        }
        let i = self.knots.partition_point(|k| k.s <= s).clamp(1, n - 1) - 1;
        let [from, to] = [&self.along[i], &self.along[i + 1]];
        let h = self.knots[i + 1].s - self.knots[i].s;
        let t = ((s - self.knots[i].s) / h).clamp(0.0, 1.0);
        Along::each(|of| {
            let [(a, m), (b, q)] = [from, to].map(|[value, slope]| (of(value), h * of(slope)));
            a + t * (m + t * (3.0 * (b - a) - 2.0 * m - q + t * (m + q - 2.0 * (b - a))))
        })
    }
}

/// What holds at a place of a row.
struct State {
    point: [f64; 2],
    direction: [f64; 2],
    first: [f64; 2],
    g: f64,
    bend: f64,
    curvature: f64,
    drift: f64,
    lean: f64,
}

impl Over<'_> {
    /// Coordinates to the right and down from the marker in the plane across the track [m].
    fn in_wheel(&self, p: &RowPoint) -> [f64; 2] {
        let to = [p.value[0] - self.marker[0], p.value[1] - self.marker[1]];
        [self.right, self.down].map(|axis| dot(to, axis))
    }

    /// Row `j` at `x`, where nothing touches it.
    fn under_axle(&self, j: usize, p: &RowPoint, x: f64) -> Met {
        let [_, z] = self.in_wheel(p);
        let down = x.hypot(z) - z;
        Met {
            row: j,
            point: [0, 1].map(|i| p.value[i] + down * self.down[i]),
            direction: [p.value[2], p.value[3]],
            first: [0.0; 2],
            x,
            along: Along::default(),
            opposite: None,
        }
    }

    /// The point of the contact line at `y` across, from the parameter `u` near it; nothing where the wheel stands upright.
    fn opposite(&self, mut u: f64, y: f64) -> Option<Opposite> {
        let [start, end] = self.line.range();
        for _ in 0..MOST_OPPOSITE_STEPS {
            let (at, derivative) = self.line.even_with_derivative(u);
            let to = [at.point[0] - self.marker[0], at.point[1] - self.marker[1]];
            let rate = dot(derivative, self.right);
            if rate < LEAST_RATE {
                return None;
            }
            let step = ((y - dot(to, self.right)) / rate).clamp(-CELL, CELL);
            let next = (u + step).clamp(start, end);
            let step = next - u;
            if step.abs() < STRAIGHT || next <= start || next >= end {
                // Over the last step the line is as good as an arc.
                let curvature = self.line.curvature(u);
                let size = derivative[0].hypot(derivative[1]);
                let [ty, tz] = derivative.map(|d| d / size);
                let turn = -curvature * size * step;
                let tangent = [ty - turn * tz, tz + turn * ty];
                let advance = if self.yaws { self.line.advance(u) } else { 0.0 };
                let x = if self.yaws { at.x + advance * step } else { 0.0 };
                let normal = [-tangent[1], tangent[0]];
                return Some(Opposite { u: next, x, advance: advance / rate, normal, curvature });
            }
            u = next;
        }
        None
    }
}

/// A point of the contact line.
struct Opposite {
    u: f64,
    /// Its place along the track, and the derivative of that across [m, -].
    x: f64,
    advance: f64,
    /// Normal into the rail, and curvature of the wheel across, positive where it bulges [1/m].
    normal: [f64; 2],
    curvature: f64,
}

/// How fast the section of the pattern passes row `j` [-].
fn pattern_speed(rows: &Rows, j: usize) -> f64 {
    let [_, _, dy, dz] = rows.pattern[j];
    dy.hypot(dz)
}

/// Bounds of all rows under a wheel of `radius` between each slice and the next.
fn bounds(rows: &Rows, radius: f64) -> Vec<Bound> {
    let Rows { places, knots, .. } = rows;
    let count = rows.parameter.len();
    let none =
        Bound { y: [f64::INFINITY, f64::NEG_INFINITY], least: f64::INFINITY, top: f64::INFINITY };
    let spans = places.len() - 1;
    // The points that control a cubic go around it.
    let mut own = vec![none; count * spans];
    for (i, own) in own.chunks_mut(count).enumerate() {
        let third = (places[i + 1] - places[i]) / 3.0;
        for (j, bound) in own.iter_mut().enumerate() {
            for (k, way) in [(i, third), (i + 1, -third)] {
                let knot = &knots[k * count + j];
                for way in [0.0, way] {
                    let [y, z] = [0, 1].map(|c| knot.value[c] + way * knot.slope[c]);
                    bound.y = [bound.y[0].min(y), bound.y[1].max(y)];
                    bound.least = bound.least.min(z);
                }
            }
        }
    }
    let mut all = vec![none; count * spans];
    for (i, all) in all.chunks_mut(count).enumerate() {
        let (first, last) = (places[i] - REACH, places[i + 1] + REACH);
        for k in (0..spans).filter(|&k| places[k + 1] >= first && places[k] <= last) {
            let away = (places[k] - places[i + 1]).max(places[i] - places[k + 1]).max(0.0);
            let drop = 0.5 * away * away / (LARGEST * radius);
            for (bound, own) in all.iter_mut().zip(&own[k * count..]) {
                bound.y = [bound.y[0].min(own.y[0]), bound.y[1].max(own.y[1])];
                bound.least = bound.least.min(own.least);
                bound.top = bound.top.min(own.least + drop);
            }
        }
    }
    all
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Newton steps to a point of the contact line, and the last of them [m].
const MOST_OPPOSITE_STEPS: usize = 12;
const STRAIGHT: f64 = 1e-6;
/// Least share of its parameter by which the contact line goes across: a flank is not followed as if it stood upright.
const LEAST_RATE: f64 = 0.1;
