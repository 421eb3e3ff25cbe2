//! Boundary elements on the arc of a rail: the normal problem of one wheel and one rail, all
//! overlaps together.
//!
//! An element is a stretch dx along the track by a stretch of the arc of the rail's section, with
//! the rail's own normal. The overlap b of the undeformed bodies is the distance along that normal
//! to the surface of the wheel. Pressures p ≥ 0 act along the normals, and b - A p ≤ 0, with
//! equality where p > 0. A is the influence of the half-space with the length of the arc as the
//! distance across, as the surface were laid flat: on a surface that bends away from the pressure
//! the material beneath is stiffer towards the side where it bulges and softer where it is hollow,
//! and to first order in the curvature the two bodies of like materials differ by opposite signs.
//!
//! **Energy.** A does not depend on where the wheel is, as long as elements lie on the same places
//! of the rail. So the elastic energy
//!
//! ```text
//! E = max over p ≥ 0 of  Σ a (p b - ½ p A p)        a: area of an element
//! F = -dE/dq = -Σ a p ∂b/∂q,   ∂b/∂q = N/(N·n)
//! ```
//!
//! with N the normal of the wheel where the normal n of the rail meets it: the force on the wheel
//! is the exact derivative of an energy, and as every N meets the axle, it has no moment about it.
//! Summed along n instead it differs by what Σ a p tan(N, n) leaves, which vanishes where A is a
//! convolution (Σ p ∂(A p)/∂y = 0). Elements therefore lie on a lattice that is fixed to the rail
//! across and to the wheel's centre along, with sizes from a ladder, so that the solution is that
//! of one lattice under small movements.
//!
//! **Rails whose section varies along the track.** The section is the outline that the wheel meets
//! (`geometry::varying_rail`): each row of the surface lies in it where along the track the bodies
//! are nearest, x_m. A row of elements follows that row, which may drift across. With W(x) the
//! overlap with an even rail of that outline, lean λ and curvature κ of the row along the track,
//!
//! ```text
//! b(x) = W(x) + (b(x_m) - W(x_m)) + λ (x - x_m) - ½ κ (x - x_m)²
//! ```
//!
//! along the normal of the section, and the cosine of the lean times that along the normal that
//! leans with the rail. A is as if the rows did not drift: an angle δ between row and track changes
//! distances by shares of δ²/2.

use super::Strips;
use super::boundary_element::fill_rows;
use super::element_pressure::ElementPressure;
use crate::boundary_element::grid::Grid;
use crate::boundary_element::pressure::{PressureSolver, TOLERANCE};
use crate::geometry::arc_length::ArcLength;
use crate::geometry::contact_line::ContactLine;
use crate::geometry::contact_search::ContactSearch;
use crate::geometry::placed_rail::PlacedRail;
use crate::geometry::varying_rail::Along;

/// A row of elements at one place of the rail's section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Parameter of the rail's curve [m].
    pub s: f64,
    /// Point (y, z) of the rail [m].
    pub point: [f64; 2],
    /// Unit tangent (y, z) of the rail.
    pub tangent: [f64; 2],
    /// Parameter of the wheel's contact line where the rail's normal meets it [m].
    pub u: f64,
    /// Place along the track at which the bodies are nearest, from the wheel marker [m].
    pub x: f64,
    /// Overlap there [m].
    pub overlap: f64,
    /// The rail along the track there.
    pub course: Course,
}

/// A rail along the track, where a wheel meets it; zero where its section does not vary.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Course {
    /// Height of the wheel over its contact line, along the normal of the section [m].
    pub lift: f64,
    /// Tangent of the angle by which the normal of the rail leans forward [-].
    pub lean: f64,
    /// How fast the row drifts across [-].
    drift: f64,
    /// Curvature of the rail; positive where it bulges [1/m].
    curvature: f64,
}

impl Course {
    /// What overlaps more than with an even rail, at `x` ahead of where the bodies are nearest [m].
    fn more(&self, x: f64) -> f64 {
        self.lift + x * (self.lean - 0.5 * self.curvature * x)
    }

    /// Cosine of the lean [-].
    fn cosine(&self) -> f64 {
        1.0 / self.lean.hypot(1.0)
    }
}

impl Row {
    /// The normal (y, z) into the rail.
    #[must_use]
    pub fn normal(&self) -> [f64; 2] {
        [-self.tangent[1], self.tangent[0]]
    }

    /// Point (y, z) at `x` from the wheel marker [m] of a wheel that overlaps the row by `overlap`
    /// [m], as if the wheel were laid flat along the row.
    #[must_use]
    pub fn wheel_point(&self, x: f64, overlap: f64) -> [f64; 2] {
        let ahead = x - self.x;
        let depth = overlap - self.course.lift - self.course.lean * ahead;
        let (beside, normal) = (self.course.drift * ahead, self.normal());
        [0, 1].map(|c| self.point[c] + depth * normal[c] + beside * self.tangent[c])
    }
}

/// The wheel opposite to an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opposite {
    /// Overlap of the undeformed bodies along the rail's normal, > 0 [m].
    pub overlap: f64,
    /// N/(N·n), n leaning with the rail: what the overlap grows by when the wheel moves by a unit
    /// along x, y and z.
    pub growth: [f64; 3],
}

/// The solution on the elements of a rail.
#[derive(Clone, Debug)]
pub struct RailElements {
    /// The elements: x from the wheel marker, across the arc of the rail [m].
    pub grid: Grid,
    /// Pressure on each [Pa].
    pub pressure: Vec<f64>,
    /// The places of the rows; nothing where the rail ends or no wheel lies opposite.
    pub rows: Vec<Option<Row>>,
    /// The wheel opposite to each element, where the bodies overlap.
    pub opposite: Vec<Option<Opposite>>,
    /// Greatest overlap [m].
    pub approach: f64,
    /// Iterations of conjugate gradients.
    pub iterations: usize,
    /// Largest distance left between surfaces that carry pressure, or overlap left of others, over
    /// the greatest overlap [-].
    pub residual: f64,
}

/// Places of the arc between which the bodies overlap, and what was found on the way.
struct Overlap {
    /// Arc, parameter of the contact line, and from where to where along the track the bodies
    /// overlap there, in growing arc [m].
    places: Vec<[f64; 4]>,
}

impl Overlap {
    fn range(&self) -> [f64; 2] {
        [self.places[0][0], self.places[self.places.len() - 1][0]]
    }
}

/// First step along the arc and the longest [m].
const FIRST_STEP: f64 = 2e-6;
const LONGEST_STEP: f64 = 5e-4;
/// Spacing at which a wheel that varies around is looked through for its overlap along the track:
/// that of its outline [m].
const SCAN: f64 = 2e-3;
/// Elements along and across an overlap on the grid on which the extent of its contact is found; it
/// may hold several zones.
const COARSE: [usize; 2] = [24, 48];
/// Share of the load from which on a zone has a say in the size of elements: smaller ones are
/// solved on those of the others.
const NOTABLE: f64 = 0.02;
/// Sizes of elements on the ladder between one and its half.
const RUNGS: f64 = 4.0;
/// Least curvature of wheel and rail together along the track, over that of the wheel, by which the
/// length of a contact is estimated [-].
const LEAST_CURVATURE_SHARE: f64 = 0.05;
/// Most elements of a grid, over those asked for of one zone: zones of different sizes far apart
/// share one lattice.
const MOST_ELEMENTS: f64 = 30.0;
/// Rows and columns beyond the extent that the coarse solution tells.
const MARGIN: f64 = 2.0;
/// How often the grid grows when the contact reaches its border.
const MOST_GROWTHS: usize = 6;

/// Solves for all that `line` and `rail` overlap where `search` has found them in contact, with
/// about `elements` along and across each zone, of bodies with the contact modulus `modulus` [Pa];
/// nothing where the iteration did not converge or no place was found.
#[must_use]
pub fn solve(
    line: &ContactLine,
    rail: &PlacedRail,
    search: &ContactSearch,
    elements: [usize; 2],
    modulus: f64,
) -> Option<RailElements> {
    let arcs = rail.arcs();
    let section = Section { line, rail, arcs: &arcs };
    let overlaps = section.overlaps(search);
    if overlaps.is_empty() {
        return None;
    }
    // Each overlap by itself tells the extent of its zones: that of all together is no greater.
    let mut zones = Vec::new();
    for overlap in &overlaps {
        let alone = std::slice::from_ref(overlap);
        zones.extend(section.solve_on(coarse_grid(overlap), alone, modulus)?.zones());
    }
    let mut box_of_load = extent_of(&zones)?;
    let size = element_size(&zones, box_of_load, elements);
    for _ in 0..MOST_GROWTHS {
        let grid = lattice(box_of_load, size);
        let found = section.solve_on(grid, &overlaps, modulus)?;
        match found.beyond(box_of_load) {
            Some(grown) => box_of_load = grown,
            None => return Some(found),
        }
    }
    None
}

/// The section of a rail and the wheel over it.
struct Section<'a> {
    line: &'a ContactLine<'a>,
    rail: &'a PlacedRail,
    arcs: &'a ArcLength<'a>,
}

impl Section<'_> {
    /// The row at `arc`, the contact line sought near the parameter `u`.
    fn row(&self, arc: f64, mut u: f64) -> Option<Row> {
        let s = self.arcs.parameter(arc)?;
        let on = self.rail.curve().at(s);
        let speed = on.first[0].hypot(on.first[1]);
        let tangent = on.first.map(|d| d / speed);
        let [start, end] = self.line.range();
        let along = |v: [f64; 2]| v[0] * tangent[0] + v[1] * tangent[1];
        for _ in 0..MOST_STEPS {
            if !(u > start && u < end) {
                return None;
            }
            let (at, derivative) = self.line.even_with_derivative(u);
            let to = [at.point[0] - on.point[0], at.point[1] - on.point[1]];
            let rate = along(derivative);
            if rate < LEAST_RATE {
                return None;
            }
            let step = -along(to) / rate;
            u += step;
            if step.abs() <= LAST_STEP {
                let normal = [-tangent[1], tangent[0]];
                let down = |v: [f64; 2]| v[0] * normal[0] + v[1] * normal[1];
                let overlap = down(to) + step * down(derivative);
                let course = Course::default();
                let row = Row { s, point: on.point, tangent, u, x: at.x, overlap, course };
                return match self.rail.variation() {
                    None => Some(row),
                    Some(varying) => self.met(row, &varying.along(s)),
                };
            }
        }
        None
    }

    /// An even `row` where the wheel meets it on a rail that varies; nothing where the wheel is not
    /// that long.
    fn met(&self, row: Row, along: &Along) -> Option<Row> {
        let x = row.x + along.ahead;
        let even = self.line.surface_along(x, row.point, row.normal(), [row.u, row.overlap])?;
        let course = Course {
            lift: row.overlap - even.depth,
            lean: along.lean,
            drift: along.drift,
            curvature: along.curvature,
        };
        Some(Row { x, overlap: course.cosine() * row.overlap, course, ..row })
    }

    /// The stretches of overlap about the contacts of `search`, in growing arc, those that share a
    /// place as one.
    ///
    /// The surfaces about a contact may overlap in several stretches: each of its probes that may
    /// lie in one is a place to begin at.
    fn overlaps(&self, search: &ContactSearch) -> Vec<Overlap> {
        let mut all: Vec<Overlap> = Vec::new();
        for contact in search.contacts.iter() {
            all.extend(self.overlap(contact.rail_s, contact.u));
            for probe in &search.probes[contact.probes[0]..contact.probes[1]] {
                if probe.f >= contact.penetration {
                    continue;
                }
                let opposite = self.line.even_at(probe.u).point;
                let guess = self.rail.coarse_nearest(opposite);
                let rail_s = self.rail.nearest(opposite, guess, LAST_STEP).s;
                let arc = self.arcs.arc(rail_s);
                let is_known = all.iter().any(|o| o.range()[0] <= arc && arc <= o.range()[1]);
                if !is_known {
                    all.extend(self.overlap(rail_s, probe.u));
                }
            }
        }
        all.sort_by(|a, b| a.range()[0].total_cmp(&b.range()[0]));
        let mut apart: Vec<Overlap> = Vec::new();
        for next in all {
            match apart.last_mut() {
                Some(last) if last.range()[1] > next.range()[0] => {
                    last.places.extend(next.places);
                    last.places.sort_by(|a, b| a[0].total_cmp(&b[0]));
                }
                _ => apart.push(next),
            }
        }
        apart
    }

    /// The stretch of overlap about the parameter `rail_s` of the rail, the contact line sought
    /// near the parameter `near`.
    fn overlap(&self, rail_s: f64, near: f64) -> Option<Overlap> {
        let middle = self.arcs.arc(rail_s);
        let place = |arc: f64, row: &Row| {
            let [from, to] = self.stretch(row);
            [arc, row.u, from, to]
        };
        let first = self.row(middle, near).filter(|row| row.overlap > 0.0)?;
        let mut places = vec![place(middle, &first)];
        for side in [-1.0, 1.0] {
            let (mut arc, mut step, mut u) = (middle, FIRST_STEP, near);
            // One place outside is part of the stretch.
            while let Some(row) = self.row(arc + side * step, u) {
                arc += side * step;
                u = row.u;
                places.push(place(arc, &row));
                if row.overlap <= 0.0 {
                    break;
                }
                step = (1.5 * step).min(LONGEST_STEP);
            }
        }
        places.sort_by(|a, b| a[0].total_cmp(&b[0]));
        (places.len() > 1).then_some(Overlap { places })
    }

    /// From where to where along the track the bodies overlap at `row` [m], with all that lies
    /// between.
    fn stretch(&self, row: &Row) -> [f64; 2] {
        let even = self.line.wheel_point(row.u).section_radius;
        let share = (1.0 + even * row.course.curvature).max(LEAST_CURVATURE_SHARE);
        let radius = even / share;
        let half = (2.0 * radius * row.overlap.max(0.0)).sqrt();
        let mut stretch = [row.x - half, row.x + half];
        // A wheel that varies around may overlap again beyond what its curvature tells.
        let reach = self.line.reach(row.u, row.overlap).filter(|_| row.overlap > 0.0);
        for (side, last) in reach.into_iter().flatten().enumerate() {
            let (first, mut guess) = (stretch[side], [row.u, row.overlap]);
            let sign = if side == 0 { -1.0 } else { 1.0 };
            let steps = (sign * (last - first) / SCAN).ceil().max(0.0) as usize;
            for i in 1..=steps {
                let x = first + sign * SCAN * i as f64;
                let Some(at) = self.line.surface_along(x, row.point, row.normal(), guess) else {
                    break;
                };
                guess = [at.s, at.depth];
                if at.depth > 0.0 {
                    stretch[side] = x + sign * SCAN;
                }
            }
        }
        stretch
    }

    /// The row at `arc` where the wheel may overlap.
    fn row_near(&self, arc: f64, overlaps: &[Overlap]) -> Option<Row> {
        let overlap = overlaps.iter().find(|o| o.range()[0] <= arc && arc <= o.range()[1])?;
        let k = overlap.places.partition_point(|place| place[0] <= arc);
        let (a, b) =
            (overlap.places[k.max(1) - 1], overlap.places[k.clamp(1, overlap.places.len() - 1)]);
        let share = if b[0] > a[0] { (arc - a[0]) / (b[0] - a[0]) } else { 0.0 };
        self.row(arc, a[1] + share * (b[1] - a[1]))
    }

    fn solve_on(&self, grid: Grid, overlaps: &[Overlap], modulus: f64) -> Option<RailElements> {
        let rows: Vec<Option<Row>> =
            (0..grid.across).map(|j| self.row_near(grid.y(j), overlaps)).collect();
        let mut opposite = vec![None; grid.len()];
        for (row, opposite) in rows.iter().zip(opposite.chunks_exact_mut(grid.along)) {
            let Some(row) = row.filter(|row| row.overlap > 0.0) else { continue };
            self.meet_row(&grid, &row, opposite);
        }
        let approach = opposite.iter().flatten().map(|o: &Opposite| o.overlap).fold(0.0, f64::max);
        if approach <= 0.0 {
            return None;
        }
        // What does not overlap is as far apart as the bodies overlap elsewhere.
        let distance: Vec<f64> =
            opposite.iter().map(|o| o.map_or(2.0 * approach, |o| approach - o.overlap)).collect();
        let mut solver = PressureSolver::new(grid, modulus).with_tolerance(CLOSED);
        let solution = solver.at_approach(&distance, approach, None);
        if solution.residual > TOLERANCE {
            return None;
        }
        let mut displacement = vec![0.0; grid.len()];
        solver.displace(&solution.pressure, &mut displacement);
        let left = (0..grid.len()).map(|k| {
            let overlap = approach - distance[k] - displacement[k];
            if solution.pressure[k] > 0.0 { overlap.abs() } else { overlap.max(0.0) }
        });
        Some(RailElements {
            residual: left.fold(0.0, f64::max) / approach,
            grid,
            pressure: solution.pressure,
            rows,
            opposite,
            approach,
            iterations: solution.iterations,
        })
    }

    /// Finds the wheel opposite to the elements of `row`, from the contact line to both sides as
    /// far as the bodies overlap; a wheel that varies around may do so again farther on.
    fn meet_row(&self, grid: &Grid, row: &Row, opposite: &mut [Option<Opposite>]) {
        let normal = row.normal();
        let middle =
            ((grid.leading_x - row.x) / grid.dx).round().clamp(0.0, (grid.along - 1) as f64);
        let (course, cosine) = (row.course, row.course.cosine());
        let mut meet = |i: usize, guess: &mut [f64; 2]| {
            let x = grid.x(i);
            let Some(at) = self.line.surface_along(x, row.point, normal, *guess) else {
                return false;
            };
            let overlap = cosine * (at.depth + course.more(x - row.x));
            if overlap <= 0.0 {
                *guess = [at.s, at.depth];
                return self.line.varies_around();
            }
            let across = at.normal[1] * normal[0] + at.normal[2] * normal[1];
            let facing = cosine * (course.lean * at.normal[0] + across);
            *guess = [at.s, at.depth];
            opposite[i] = Some(Opposite { overlap, growth: at.normal.map(|n| n / facing) });
            true
        };
        let from = [row.u, row.overlap - course.lift];
        let middle = middle as usize;
        let mut guess = from;
        for i in (0..=middle).rev() {
            if !meet(i, &mut guess) {
                break;
            }
        }
        guess = from;
        for i in middle + 1..grid.along {
            if !meet(i, &mut guess) {
                break;
            }
        }
    }
}

/// Distance left in the contact, over the overlap, at which iterations end [-]: forces of poses 0.1
/// µm apart then differ by what the poses do. What rounding keeps from that is taken if it is
/// within the usual tolerance.
const CLOSED: f64 = 1e-8;
/// Newton steps to the place on a normal of the rail, the last of them [m], and the least rate at
/// which that goes along with the line.
const MOST_STEPS: usize = 10;
const LAST_STEP: f64 = 1e-9;
const LEAST_RATE: f64 = 0.05;

/// A loaded zone on the elements: least and greatest x and arc [m], and its load [N].
#[derive(Clone, Copy, Debug)]
struct ZoneExtent {
    x: [f64; 2],
    y: [f64; 2],
    load: f64,
}

impl RailElements {
    /// The extents of the loaded zones.
    fn zones(&self) -> Vec<ZoneExtent> {
        let grid = &self.grid;
        let mut zones: Vec<ZoneExtent> = Vec::new();
        let mut open = false;
        for j in 0..grid.across {
            let line = &self.pressure[j * grid.along..(j + 1) * grid.along];
            let loaded = |p: &f64| *p > 0.0;
            let ends = line.iter().position(loaded).zip(line.iter().rposition(loaded));
            let Some((first, last)) = ends else {
                open = false;
                continue;
            };
            let x = [grid.x(last) - 0.5 * grid.dx, grid.x(first) + 0.5 * grid.dx];
            let y = [grid.y(j) - 0.5 * grid.dy, grid.y(j) + 0.5 * grid.dy];
            let load = line.iter().sum::<f64>() * grid.element_area();
            match zones.last_mut().filter(|_| open) {
                Some(zone) => {
                    zone.x = [zone.x[0].min(x[0]), zone.x[1].max(x[1])];
                    (zone.y[1], zone.load) = (y[1], zone.load + load);
                }
                None => zones.push(ZoneExtent { x, y, load }),
            }
            open = true;
        }
        zones
    }

    /// The box grown where the contact reaches the border of the grid.
    fn beyond(&self, [x, y]: [[f64; 2]; 2]) -> Option<[[f64; 2]; 2]> {
        let Grid { along, across, .. } = self.grid;
        let loaded = |i: usize, j: usize| self.pressure[j * along + i] > 0.0;
        let grow = [
            (0..across).any(|j| loaded(along - 1, j)),
            (0..across).any(|j| loaded(0, j)),
            (0..along).any(|i| loaded(i, 0)),
            (0..along).any(|i| loaded(i, across - 1)),
        ];
        if !grow.contains(&true) {
            return None;
        }
        let [more_x, more_y] = [x, y].map(|range| GROWTH * (range[1] - range[0]));
        let add = |touched: bool, length: f64| if touched { length } else { 0.0 };
        Some([
            [x[0] - add(grow[0], more_x), x[1] + add(grow[1], more_x)],
            [y[0] - add(grow[2], more_y), y[1] + add(grow[3], more_y)],
        ])
    }

    /// Greatest angle between the normals of rows that carry pressure [rad].
    #[must_use]
    pub fn turn_of_normals(&self) -> f64 {
        let rows = self.rows.iter().zip(self.pressure.chunks(self.grid.along));
        let loaded = rows.filter(|(_, pressure)| pressure.iter().any(|&p| p > 0.0));
        let angles =
            loaded.filter_map(|(row, _)| row.map(|row| row.tangent[1].atan2(row.tangent[0])));
        let [least, most] = angles
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], angle| [a.min(angle), b.max(angle)]);
        (most - least).max(0.0)
    }

    /// Fills the empty `strips` with the loaded rows; returns the number of zones that found no
    /// room.
    pub fn fill(&self, strips: &mut Strips) -> usize {
        let u: Vec<f64> = self.rows.iter().map(|row| row.map_or(0.0, |row| row.u)).collect();
        let field = ElementPressure {
            grid: self.grid,
            pressure: self.pressure.clone(),
            strip_of_row: vec![None; self.grid.across],
            iterations: self.iterations,
        };
        fill_rows(strips, field, &u)
    }
}

/// Growth of a border that the contact reaches, as a share of the extent [-].
const GROWTH: f64 = 0.1;

/// The grid over an overlap on which the extent of its contact is found.
fn coarse_grid(overlap: &Overlap) -> Grid {
    let mut x = [f64::INFINITY, f64::NEG_INFINITY];
    for &[_, _, from, to] in overlap.places.iter().filter(|place| place[3] > place[2]) {
        x = [x[0].min(from), x[1].max(to)];
    }
    Grid::over(x, overlap.range(), COARSE[0], COARSE[1])
}

/// The box of all zones.
fn extent_of(zones: &[ZoneExtent]) -> Option<[[f64; 2]; 2]> {
    let join = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
    zones.iter().map(|zone| [zone.x, zone.y]).reduce(|a, b| [join(a[0], b[0]), join(a[1], b[1])])
}

/// Length and width of elements, so that each notable zone has `elements` of them along and across,
/// from the ladder [m].
fn element_size(zones: &[ZoneExtent], [x, y]: [[f64; 2]; 2], elements: [usize; 2]) -> [f64; 2] {
    let load: f64 = zones.iter().map(|zone| zone.load).sum();
    let mut size = [f64::INFINITY; 2];
    for zone in zones.iter().filter(|zone| zone.load >= NOTABLE * load) {
        for (axis, range) in [zone.x, zone.y].into_iter().enumerate() {
            size[axis] = size[axis].min((range[1] - range[0]) / elements[axis] as f64);
        }
    }
    let count = (x[1] - x[0]) / size[0] * (y[1] - y[0]) / size[1];
    let most = MOST_ELEMENTS * (elements[0] * elements[1]) as f64;
    let larger = (count / most).sqrt().max(1.0);
    size.map(|size| ((larger * size).log2() * RUNGS).floor() / RUNGS).map(f64::exp2)
}

/// The part of the lattice of elements of `size` that covers a box and a margin.
fn lattice([x, y]: [[f64; 2]; 2], [dx, dy]: [f64; 2]) -> Grid {
    let cells = |range: [f64; 2], size: f64| {
        [(range[0] / size).floor() - MARGIN, (range[1] / size).ceil() + MARGIN]
    };
    let ([x_first, x_end], [y_first, y_end]) = (cells(x, dx), cells(y, dy));
    Grid {
        along: (x_end - x_first) as usize,
        across: (y_end - y_first) as usize,
        dx,
        dy,
        leading_x: (x_end - 0.5) * dx,
        left_y: (y_first + 0.5) * dy,
    }
}
