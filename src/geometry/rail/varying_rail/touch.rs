//! Where the wheel meets a row of the rail.

use super::bounds::{Bounds, LARGEST};
use super::deviation::Deviation;
use super::over::{OnRow, Opposite, Over};
use super::wheel_table::WheelTable;
use crate::geometry::sections::rows::along::Along;
use crate::geometry::sections::rows::met::{Gap, Met};
use crate::geometry::sections::rows::plane::dot;
use crate::geometry::sections::rows::surface::Surface;
use crate::math::dual::Dual;
use crate::math::real::Real;

/// Distance of rows over which their places and those of the wheel opposite go on as before [m].
pub(super) const CLOSE: f64 = 3e-3;
/// Steps to the place along a row, and the longest of them [m].
const MAX_STEPS: usize = 20;
const LONGEST_STEP: f64 = 0.02;
/// A step that is no longer made: it turns the outline by less than rounding [m].
const LAST_STEP: f64 = 1e-12;
/// Steps to about the contact line.
const STEPS_TO_LINE: usize = 3;
/// Spacing at which a row that is hollow for the wheel is looked through [m].
const SCAN: f64 = 4e-3;

/// What holds at a place of a row.
struct State<T> {
    point: [T; 2],
    direction: [T; 2],
    first: [T; 2],
    /// n · F_x, and about its derivative along the track [1/m].
    g: T,
    bend: T,
    curvature: T,
    drift: T,
    lean: T,
    /// Component of the normal down [-], and how far below the wheel the row is [m].
    share: T,
    below: T,
    deviation: Deviation<T>,
}

impl<T: Real> State<T> {
    /// The condition of touch at a place of a `row`, opposite to the point `wheel` of a wheel with a
    /// `deviation` there.
    fn new(over: &Over<T>, row: &OnRow<T>, wheel: &Opposite<T>, deviation: Deviation<T>) -> Self {
        let OnRow { x, point: p, across: [_, z], .. } = row;
        let (x, z) = (*x, *z);
        let first = [p.first[0], p.first[1]];
        let across = [p.value[2], p.value[3]];
        let away = x - wheel.x;
        let radius = (away * away + z * z).sqrt();
        let (sine, cosine) = (away / radius, z / radius);
        let height = radius - deviation.raised;
        let down = height - z;
        // D along a direction of the surface: by its height, and by the place of the contact line.
        let [more_along, more_right, more_down] = deviation.slopes;
        let lowered = |v: [T; 2]| {
            dot(v, over.down) * (cosine - 1.0 - more_down)
                - (sine * wheel.advance + more_right) * dot(v, over.right)
        };
        let by_row = lowered(across);
        let along = sine - more_along + lowered(first);
        let normal = wheel.normal;
        let tangent = [normal[1], -normal[0]];
        let share = dot(normal, over.down);
        let drift = dot(tangent, first);
        let rail = dot(normal, p.second) + wheel.curvature * drift * drift;
        Self {
            point: [0, 1].map(|i| p.value[i] + down * over.down[i]),
            direction: [0, 1].map(|i| across[i] + by_row * over.down[i]),
            first: [0, 1].map(|i| first[i] + along * over.down[i]),
            g: dot(normal, first) + share * along,
            bend: rail + share * (cosine * cosine / radius - deviation.bend),
            curvature: rail,
            drift,
            lean: -dot(normal, first),
            share,
            below: height - wheel.radius,
            deviation,
        }
    }

    /// What is met at a place of row `j`, where the curvature along the track of the wheel is by
    /// `bulge` that of more than its section on the contact line.
    fn met(self, j: usize, row: &OnRow<T>, wheel: &Opposite<T>, bulge: T) -> Met<T> {
        let Self { point, direction, first, curvature, lean, drift, g, deviation, .. } = self;
        let OnRow { place, x, across: [y, _], .. } = *row;
        let along = Along {
            ahead: x - wheel.x,
            curvature,
            lean,
            drift,
            gap: g,
            raised: deviation.unround,
            lever: deviation.lever,
            bulge: self.share * bulge,
            waves: self.share * deviation.waves,
        };
        let [height, share, growth] =
            [self.below, self.share, dot(wheel.normal, direction)].map(T::value);
        let gap = Gap { height, share, growth };
        Met { row: j, point, direction, first, place, x, gap, along, opposite: Some([wheel.u, y]) }
    }

    /// How fast the condition grows along the track, at least [1/m].
    fn slope(&self, over: &Over<T>) -> f64 {
        self.bend.value().max(0.1 / over.nominal_radius())
    }
}

/// Where a row is sought.
#[derive(Clone, Copy, Default)]
pub(super) struct Start {
    /// Along the track [m].
    pub place: f64,
    /// Parameter of the wheel about opposite, and the coordinate to the right that it belongs to; if
    /// known [m].
    pub opposite: Option<[f64; 2]>,
    /// Whether the rows before lead there; else the contact line is gone to first.
    pub goes_on: bool,
}

impl Start {
    /// Where the row `beside` was met.
    pub fn of(beside: Option<&Met>) -> Self {
        let of = |b: &Met| Self { place: b.place, opposite: b.opposite, goes_on: false };
        beside.map_or_else(Self::default, of)
    }
}

/// A place of a row with the point of the wheel that is opposite.
#[derive(Clone, Copy)]
struct Spot {
    row: OnRow,
    wheel: Opposite,
    deviation: Deviation,
}

impl Spot {
    fn new(over: &Over, row: OnRow, wheel: Opposite) -> Self {
        Self { row, wheel, deviation: over.deviation(row.x, row.across, &wheel) }
    }

    /// What holds there.
    fn state(&self, over: &Over) -> State<f64> {
        State::new(over, &self.row, &self.wheel, self.deviation)
    }

    /// What is met there of row `j`.
    fn met(&self, over: &Over, state: State<f64>, j: usize) -> Met {
        let bulge = over.bulge(&self.deviation, self.row.across, &self.wheel);
        state.met(j, &self.row, &self.wheel, bulge)
    }
}

/// A rail and the wheel that is looked for.
pub(super) struct Touch<'a> {
    pub surface: &'a Surface,
    pub bounds: &'a Bounds,
    pub wheel: &'a WheelTable,
}

impl Touch<'_> {
    /// Row `j` as it is under the axle; nothing where it is not there.
    pub fn aside(&self, over: &Over, j: usize) -> Option<Met> {
        let run = self.surface.run(j, over.station, over.within.slice)?;
        let [from, to] = over.reach(self.surface, run)?;
        let at = |place: f64| over.row(self.surface, j, run, place.clamp(from, to));
        let row = at(0.0);
        // Along the rows the axle is elsewhere than along the track.
        let row = if over.is_along_rows() { at(row.place - row.x / row.rate) } else { row };
        Some(over.under_axle(j, &row))
    }

    /// Row `j` about where the wheel meets it, from the row `beside` if there is one; nothing where
    /// the row is not there.
    pub fn about(&self, over: &Over, j: usize, beside: Option<&Met>) -> Option<Met> {
        let run = self.surface.run(j, over.station, over.within.slice)?;
        let ends = over.reach(self.surface, run)?;
        let Some(spot) = self.begin(over, (j, run), ends, Start::of(beside)) else {
            return self.aside(over, j);
        };
        let state = spot.state(over);
        // Over a short way the wheel is as good as a circle.
        let fall = 0.5 * state.g * state.g / state.slope(over);
        let met = spot.met(over, state, j);
        let gap = Gap { height: met.gap.height - fall / met.gap.share, ..met.gap };
        Some(Met { gap, ..met })
    }

    /// Where the wheel meets row `j`, sought from `start`; nothing where the row is not there.
    pub fn meet(&self, over: &Over, j: usize, start: Start, looks_through: bool) -> Option<Met> {
        let run = self.surface.run(j, over.station, over.within.slice)?;
        let ends = over.reach(self.surface, run)?;
        // Where the wheel stands upright, or nothing of it is opposite, the row is as good as beside
        // it, wherever those beside it are met.
        let Some(spot) = self.begin(over, (j, run), ends, start) else {
            return self.aside(over, j);
        };
        if !(looks_through && self.is_hollow(over, j)) {
            return Some(self.settle(over, (j, run), spot, ends));
        }
        let (best, other) = self.valleys((j, run), over, &spot, ends);
        let [met, too] = [Some(best), other].map(|place| {
            let row = over.row(self.surface, j, run, place?);
            let wheel = over.opposite(spot.wheel.u, row.across[0]).unwrap_or(spot.wheel);
            Some(self.settle(over, (j, run), Spot::new(over, row, wheel), ends))
        });
        // Two valleys about as high: samples do not tell which one is higher.
        let height = |met: &Met| dot(spot.wheel.normal, met.point);
        met.into_iter().chain(too).min_by(|a, b| height(a).total_cmp(&height(b)))
    }

    /// Whether row `j` or the wheel may be hollow.
    pub fn is_hollow(&self, over: &Over, j: usize) -> bool {
        self.bounds.is_hollow(j, over.within.ends) || over.is_hollow()
    }

    /// Row `j` on a `run` of slices `from` one place `to` another one, at the place of `start`;
    /// nothing where the wheel stands upright or nothing of it is opposite.
    fn begin(
        &self,
        over: &Over,
        (j, run): (usize, [usize; 2]),
        [from, to]: [f64; 2],
        start: Start,
    ) -> Option<Spot> {
        let at = |place: f64| over.row(self.surface, j, run, place.clamp(from, to));
        let mut row = at(start.place);
        let [y, _] = row.across;
        let near = start.opposite.filter(|[_, own]| (y - own).abs() < CLOSE);
        let near = near.map(|[u, own]| u + y - own).or_else(|| self.wheel.parameter(y))?;
        let mut wheel = over.opposite(near, y)?;
        // What is known of the row beside it may lead far from the contact line.
        let steps = if start.goes_on { 0 } else { STEPS_TO_LINE };
        for _ in 0..steps {
            if (wheel.x - row.x).abs() < CLOSE {
                break;
            }
            row = at(row.place + (wheel.x - row.x) / row.rate);
            wheel = over.opposite(wheel.u, row.across[0]).unwrap_or(wheel);
        }
        Some(Spot::new(over, row, wheel))
    }

    /// Where the wheel meets row `j` on a `run` of slices `from` one place `to` another one, by
    /// Newton steps from a `spot` on it.
    fn settle(
        &self,
        over: &Over,
        (j, run): (usize, [usize; 2]),
        mut spot: Spot,
        [from, to]: [f64; 2],
    ) -> Met {
        let mut state = spot.state(over);
        // A chord tells more than what is about the slope, but one across a place where slices bend
        // may lead beyond where the slope has the other sign.
        let (mut behind, mut ahead) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut chord = 0.0;
        for _ in 0..MAX_STEPS {
            let row = spot.row;
            let side = if state.g < 0.0 { &mut behind } else { &mut ahead };
            *side = row.place;
            let towards = |slope: f64| {
                row.place + (-state.g / slope).clamp(-LONGEST_STEP, LONGEST_STEP) / row.rate
            };
            let by_chord = Some(chord).filter(|chord| *chord > 0.0).map(towards);
            let by_chord = by_chord.filter(|next| (behind..=ahead).contains(next));
            let next = by_chord.unwrap_or_else(|| towards(state.slope(over)));
            // Exactly on an end where it is held there.
            let is_held = !(from..=to).contains(&next);
            let next = next.clamp(from, to);
            if (next - row.place).abs() <= if is_held { 0.0 } else { LAST_STEP } {
                break;
            }
            let before = (row.x, state.g);
            let row = over.row(self.surface, j, run, next);
            let wheel = over.opposite(spot.wheel.u, row.across[0]).unwrap_or(spot.wheel);
            spot = Spot::new(over, row, wheel);
            state = spot.state(over);
            chord = (state.g - before.1) / (row.x - before.0);
        }
        spot.met(over, state, j)
    }

    /// The row that was `found`, as it moves with a round wheel; `fixed` is the same wheel at rest.
    pub fn moving<T: Real>(&self, over: &Over<T>, fixed: &Over<Dual<2>>, found: &Met) -> Met<T> {
        let (j, slice) = (found.row, over.within.slice);
        let mut place = T::from(found.place);
        // Both were there when it was found.
        let Some(run) = self.surface.run(j, over.station.value(), slice) else {
            return over.under_axle(j, &over.row(self.surface, j, [0, 0], place));
        };
        let mut is_held = false;
        if let Some(ends) = over.reach(self.surface, run)
            && let Some(end) =
                ends.into_iter().find(|end| end.value().to_bits() == found.place.to_bits())
        {
            (place, is_held) = (end, true);
        }
        let Some([u, _]) = found.opposite else {
            return over.under_axle(j, &over.row(self.surface, j, run, place));
        };
        let (.., rates) = self.equations(over, j, run, place, u.into());
        let (at_place, at_u) = (Dual::variable(found.place, 0), Dual::variable(u, 1));
        let (.., slopes) = self.equations(fixed, j, run, at_place, at_u);
        let [[a, b], [c, d]] = slopes.map(|equation| equation.slopes);
        let u = if is_held {
            T::moving(u, -rates[0] / b)
        } else {
            let inverse = -1.0 / (a * d - b * c);
            place = T::moving(found.place, (rates[0] * d - rates[1] * b) * inverse);
            T::moving(u, (rates[1] * a - rates[0] * c) * inverse)
        };
        let (row, opposite, state, _) = self.equations(over, j, run, place, u);
        let bulge = state.deviation.curvature;
        state.met(j, &row, &opposite, bulge)
    }

    /// Row `j` at a `place` along the track, the point `u` of the wheel, what holds there, and what
    /// the wheel is beside the row and the slope of their distance.
    fn equations<T: Real>(
        &self,
        over: &Over<T>,
        j: usize,
        run: [usize; 2],
        place: T,
        u: T,
    ) -> (OnRow<T>, Opposite<T>, State<T>, [T; 2]) {
        let row = over.row(self.surface, j, run, place);
        let [y, _] = row.across;
        let (opposite, missing) = over.on_line(u, y);
        let deviation = over.of_round(row.x, y, &opposite, opposite.x).unwrap_or_default();
        let state = State::new(over, &row, &opposite, deviation);
        let g = state.g;
        (row, opposite, state, [missing, g])
    }

    /// The sample of row `j` about which it is highest for the wheel, and the one about which it
    /// may be higher still.
    fn valleys(
        &self,
        (j, run): (usize, [usize; 2]),
        over: &Over,
        spot: &Spot,
        [from, to]: [f64; 2],
    ) -> (f64, Option<f64>) {
        let Spot { row: here, wheel: opposite, deviation } = spot;
        let normal = [-here.point.value[3], here.point.value[2]];
        let [across, _] = here.across;
        let centre = here.place + (opposite.x - here.x) / here.rate;
        // No farther than where a wheel stands higher than the row ever rises.
        let own = if over.varies_around() { 0.0 } else { deviation.raised };
        let rise =
            (over.height_of(here) - own - self.bounds.of(j, over.within.slice).least).max(0.0);
        let far = (2.0 * LARGEST * over.nominal_radius() * rise).sqrt()
            + (here.place - centre).abs()
            + over.reach_around();
        let [from, to] = [from.max(centre - far).min(to), to.min(centre + far).max(from)];
        let spacing = SCAN.min(self.surface.corrugation.bounds().spacing).min(over.spacing());
        let count = ((to - from) / spacing).ceil().max(1.0) as usize;
        let at = |i: usize| from + (to - from) * i as f64 / count as f64;
        let height = |i: usize| -> f64 {
            let OnRow { x, point, across: [_, z], .. } = over.row(self.surface, j, run, at(i));
            let raised = over.deviation(x, [across, z], opposite).raised;
            let away = x - opposite.x;
            let down = (away * away + z * z).sqrt() - z - raised;
            [0, 1].iter().map(|&i| normal[i] * (point.value[i] + down * over.down[i])).sum()
        };
        // Bottom by the parabola through three samples, how far below it may be, and the sample.
        let mut lowest = [(f64::INFINITY, 0.0, None); 2];
        let (mut before, mut own) = (f64::INFINITY, height(0));
        for i in 0..=count {
            let after = if i < count { height(i + 1) } else { f64::INFINITY };
            if own <= before && own <= after {
                let bend = before - 2.0 * own + after;
                let fall = if bend.is_finite() && bend > 0.0 {
                    [(before - after).powi(2) / (8.0 * bend), 0.125 * bend]
                } else {
                    [0.0; 2]
                };
                let valley = (own - fall[0], fall[1], Some(at(i)));
                if valley.0 < lowest[0].0 {
                    lowest = [valley, lowest[0]];
                } else if valley.0 < lowest[1].0 {
                    lowest[1] = valley;
                }
            }
            (before, own) = (own, after);
        }
        let [(bottom, below, best), (next, next_below, other)] = lowest;
        (best.unwrap_or(centre), other.filter(|_| next - bottom < below + next_below))
    }
}
