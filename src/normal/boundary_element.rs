//! The half-space solution on rectangular elements as a normal contact model.
//!
//! The undeformed distance is f(y) + (x - x_c(y))²/(2R), x_c the contact line of a yawed wheel. A
//! solution on a coarse grid over all that the undeformed bodies overlap tells where the contact
//! is; the grid of the solution has the asked numbers of elements over the extent of all zones
//! together, and one more on each side. Rows of elements become strips with the row's own load,
//! edges and centroid.
//!
//! The edge of a row lies between the centre of its last loaded element and that of the next: as
//! pressure vanishes like the square root of the distance from it, it is where p² of the last two
//! elements extrapolates to zero.

use super::element_pressure::ElementPressure;
use super::{LoadedStrip, NormalProblem, Strips, Zone};
use crate::boundary_element::grid::Grid;
use crate::boundary_element::pressure::{PressureSolution, PressureSolver};
use crate::geometry::contacts::separation::{Probe, Separation, SeparationPoint};

/// Elements of the grid on which the extent of the contact is found.
const COARSE: usize = 24;

/// Elements beyond the extent of the contact on each side.
const MARGIN: f64 = 1.0;

/// How often the grid grows when the contact reaches its border.
const MAX_GROWTHS: usize = 4;

/// Fills the empty `strips` with the loaded zones of `problem` on `elements` along and across the
/// extent of them all.
///
/// Returns the number of zones that found no room, or nothing where the iteration did not converge.
pub fn solve(
    problem: &NormalProblem,
    elements: [usize; 2],
    separation: &mut impl Separation,
    probes: &[Probe],
    strips: &mut Strips,
) -> Option<usize> {
    let grid = |[x, y]: [[f64; 2]; 2]| Some(with_margin(x, y, elements));
    match solve_on_grid(problem, elements[1], separation, probes, grid) {
        GridPressure::None => Some(0),
        GridPressure::Lost => None,
        GridPressure::Found(field, u) => Some(fill_rows(strips, field, &u)),
    }
}

/// What [`solve_on_grid`] ends with.
pub enum GridPressure {
    /// The bodies do not overlap.
    None,
    /// The iteration did not converge, or there is no grid for the extent.
    Lost,
    /// Pressure on the elements, and the parameter of the contact line at each row.
    Found(ElementPressure, Vec<f64>),
}

/// The pressure of `problem` on the elements that `grid` puts over the extent [x], [y] of all zones
/// together, with a margin; `across` is about their number across, to find the extent with.
pub fn solve_on_grid(
    problem: &NormalProblem,
    across: usize,
    separation: &mut impl Separation,
    probes: &[Probe],
    mut grid: impl FnMut([[f64; 2]; 2]) -> Option<Grid>,
) -> GridPressure {
    let Some(box_of_overlap) = overlap(problem, separation, probes) else {
        return GridPressure::None;
    };
    let [x, y] = box_of_overlap;
    let coarse = Grid::over(x, y, COARSE, across.max(COARSE));
    let Some((solution, _)) = solve_on(coarse, problem, separation) else {
        return GridPressure::Lost;
    };
    let mut extent = extent(&coarse, &solution.pressure).unwrap_or(box_of_overlap);
    for _ in 0..MAX_GROWTHS {
        let Some(grid) = grid(extent) else { break };
        let Some((solution, rows)) = solve_on(grid, problem, separation) else { break };
        let grown = touched_borders(&grid, &solution.pressure, extent, box_of_overlap);
        if let Some(grown) = grown {
            extent = grown;
            continue;
        }
        let field = ElementPressure {
            grid,
            pressure: solution.pressure,
            strip_of_row: vec![None; grid.across],
            iterations: solution.iterations,
        };
        return GridPressure::Found(field, rows.iter().map(|row| row.0).collect());
    }
    GridPressure::Lost
}

/// The rectangle [x], [y] in which the undeformed bodies overlap.
fn overlap(
    problem: &NormalProblem,
    separation: &mut impl Separation,
    probes: &[Probe],
) -> Option<[[f64; 2]; 2]> {
    let mut edges: Option<[f64; 2]> = None;
    super::zones::for_each_zone(separation, probes, problem.approach, |_, edge| {
        let [left, right] = edges.unwrap_or([edge.left, edge.right]);
        edges = Some([left.min(edge.left), right.max(edge.right)]);
    });
    let [left, right] = edges?;
    let (y_left, y_right) = (separation.at(left).y, separation.at(right).y);
    let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
    for step in 0..=OVERLAP_STEPS {
        let u = left + (right - left) * step as f64 / OVERLAP_STEPS as f64;
        let at = separation.at(u);
        // Zones apart leave gaps between them.
        let half_length = (2.0 * problem.radius * (problem.approach - at.f).max(0.0)).sqrt();
        if half_length > 0.0 {
            least = least.min(at.x - half_length);
            greatest = greatest.max(at.x + half_length);
        }
    }
    let at = separation.at(problem.contact_u);
    let half_length = (2.0 * problem.radius * problem.approach).sqrt();
    (least, greatest) = (least.min(at.x - half_length), greatest.max(at.x + half_length));
    let fits = y_right > y_left && greatest > least && (greatest - least).is_finite();
    fits.then_some([[least, greatest], [y_left, y_right]])
}

/// Places at which the length of the overlap is looked at.
const OVERLAP_STEPS: usize = 64;

/// The grid with `elements` over the extent and a margin.
fn with_margin(x: [f64; 2], y: [f64; 2], elements: [usize; 2]) -> Grid {
    let widened = |range: [f64; 2], count: usize| {
        let margin = MARGIN * (range[1] - range[0]) / count as f64;
        [range[0] - margin, range[1] + margin]
    };
    let more = 2.0 * MARGIN;
    let count = |count: usize| count + more as usize;
    Grid::over(
        widened(x, elements[0]),
        widened(y, elements[1]),
        count(elements[0]),
        count(elements[1]),
    )
}

/// The solution on `grid` and the places of its rows.
fn solve_on(
    grid: Grid,
    problem: &NormalProblem,
    separation: &mut impl Separation,
) -> Option<(PressureSolution, Vec<(f64, SeparationPoint)>)> {
    let (distance, rows) = distances(&grid, problem, separation);
    let mut solver = PressureSolver::new(grid, problem.contact_modulus);
    let solution = solver.at_approach(&distance, problem.approach, None);
    solution.converged.then_some((solution, rows))
}

/// Undeformed distance at the centres of the elements of `grid` [m], and the places of its rows, by
/// the parameter of the contact line.
pub fn distances(
    grid: &Grid,
    problem: &NormalProblem,
    separation: &mut impl Separation,
) -> (Vec<f64>, Vec<(f64, SeparationPoint)>) {
    let mut u = problem.contact_u;
    let rows: Vec<(f64, SeparationPoint)> = (0..grid.across)
        .map(|j| {
            let at = opposite(separation, grid.y(j), u);
            u = at.0;
            at
        })
        .collect();
    let mut distance = Vec::with_capacity(grid.len());
    for (_, row) in &rows {
        // Where no normal meets both lines they are far apart.
        let f = row.f.min(BEYOND * problem.approach);
        distance.extend((0..grid.along).map(|i| {
            let x = grid.x(i) - row.x;
            f + x * x / (2.0 * problem.radius)
        }));
    }
    (distance, rows)
}

/// A distance, over the approach, that never closes.
const BEYOND: f64 = 1e3;

/// Parameter and separation of the contact line at lateral coordinate `y`, sought from the
/// parameter `u`.
fn opposite(separation: &mut impl Separation, y: f64, mut u: f64) -> (f64, SeparationPoint) {
    let mut at = separation.at(u);
    for _ in 0..MAX_STEPS {
        let step = (y - at.y) / at.dy;
        if !step.is_finite() {
            break;
        }
        u += step;
        at = separation.at(u);
        if step.abs() < PLACE {
            break;
        }
    }
    (u, at)
}

/// Newton steps to the place of a row, and the step at which it is found [m].
const MAX_STEPS: usize = 20;
const PLACE: f64 = 1e-9;

/// Leading and trailing edge of row `j`; nothing where it is not loaded.
fn row_edges(grid: &Grid, pressure: &[f64], j: usize) -> Option<[f64; 2]> {
    let row = &pressure[j * grid.along..(j + 1) * grid.along];
    let first = row.iter().position(|&p| p > 0.0)?;
    let last = row.iter().rposition(|&p| p > 0.0)?;
    if first == last {
        return Some([grid.x(first) + 0.5 * grid.dx, grid.x(first) - 0.5 * grid.dx]);
    }
    let beyond = |edge: usize, inner: usize| beyond(row[edge] * row[edge], row[inner] * row[inner]);
    Some([
        grid.x(first) + grid.dx * beyond(first, first + 1),
        grid.x(last) - grid.dx * beyond(last, last - 1),
    ])
}

/// Steps beyond the place of `edge` at which the line through `inner`, one step further inside, and
/// `edge` vanishes: 0 to 1.
fn beyond(edge: f64, inner: f64) -> f64 {
    if inner > edge { (edge / (inner - edge)).min(1.0) } else { 1.0 }
}

/// Left and right edge of the loaded rows `first` to `last`: the load of a row vanishes like the
/// distance from the edge.
fn lateral_edges(grid: &Grid, loads: &[f64], first: usize, last: usize) -> [f64; 2] {
    if first == last {
        return [grid.y(first) - 0.5 * grid.dy, grid.y(first) + 0.5 * grid.dy];
    }
    [
        grid.y(first) - grid.dy * beyond(loads[first], loads[first + 1]),
        grid.y(last) + grid.dy * beyond(loads[last], loads[last - 1]),
    ]
}

/// Sum of the pressures of each row.
fn row_loads(grid: &Grid, pressure: &[f64]) -> Vec<f64> {
    pressure.chunks_exact(grid.along).map(|row| row.iter().sum()).collect()
}

/// The rectangle of all that is loaded.
fn extent(grid: &Grid, pressure: &[f64]) -> Option<[[f64; 2]; 2]> {
    let loads = row_loads(grid, pressure);
    let first = loads.iter().position(|&load| load > 0.0)?;
    let last = loads.iter().rposition(|&load| load > 0.0)?;
    let mut x = [f64::INFINITY, f64::NEG_INFINITY];
    for [lead, trail] in (first..=last).filter_map(|j| row_edges(grid, pressure, j)) {
        x = [x[0].min(trail), x[1].max(lead)];
    }
    Some([x, lateral_edges(grid, &loads, first, last)])
}

/// The extent grown where the contact reaches the border of the grid, unless that is already beyond
/// all overlap.
fn touched_borders(
    grid: &Grid,
    pressure: &[f64],
    extent: [[f64; 2]; 2],
    most: [[f64; 2]; 2],
) -> Option<[[f64; 2]; 2]> {
    let loaded = |k: usize| pressure[k] > 0.0;
    let (along, across) = (grid.along, grid.across);
    let ends = [
        (0..across).any(|j| loaded(j * along + along - 1)),
        (0..across).any(|j| loaded(j * along)),
        (0..along).any(loaded),
        (0..along).any(|i| loaded((across - 1) * along + i)),
    ];
    let mut grown = extent;
    for (end, touched) in ends.into_iter().enumerate() {
        let (axis, side) = (end / 2, end % 2);
        let length = extent[axis][1] - extent[axis][0];
        let outward = if side == 0 { -GROWTH * length } else { GROWTH * length };
        let inside = |value: f64| value > most[axis][0] && value < most[axis][1];
        if touched && inside(extent[axis][side]) {
            grown[axis][side] = (extent[axis][side] + outward).clamp(most[axis][0], most[axis][1]);
        }
    }
    (grown != extent).then_some(grown)
}

/// Growth of a border that the contact reaches, as a share of the extent [-].
const GROWTH: f64 = 0.1;

/// Turns the rows of `field`, with the parameters `u` of the contact line, into strips and zones;
/// returns the number of zones that found no room.
pub fn fill_rows(strips: &mut Strips, field: ElementPressure, u: &[f64]) -> usize {
    let ElementPressure { grid, pressure, mut strip_of_row, iterations } = field;
    let loads = row_loads(&grid, &pressure);
    let mut left_out = 0;
    let mut j = 0;
    while j < grid.across {
        if loads[j] <= 0.0 {
            j += 1;
            continue;
        }
        let first_row = j;
        while j < grid.across && loads[j] > 0.0 {
            j += 1;
        }
        if strips.zones.len() >= strips.zones.capacity() {
            left_out += 1;
            continue;
        }
        let mut zone = Zone { first: strips.y.len(), ..Zone::default() };
        let [left, right] = lateral_edges(&grid, &loads, first_row, j - 1);
        for row in first_row..j {
            let Some([lead, trail]) = row_edges(&grid, &pressure, row) else { continue };
            let line = &pressure[row * grid.along..(row + 1) * grid.along];
            let moment: f64 = line.iter().enumerate().map(|(i, p)| p * grid.x(i)).sum();
            let half_length = 0.5 * (lead - trail);
            // Strips end where the zone does.
            let width = (right.min(grid.y(row) + 0.5 * grid.dy)
                - left.max(grid.y(row) - 0.5 * grid.dy))
            .max(0.0);
            let (load, x) = (loads[row] * grid.element_area(), moment / loads[row]);
            let (width, half_length) =
                if width > 0.0 { (width, half_length) } else { (grid.dy, 0.5 * grid.dx) };
            strip_of_row[row] = Some(strips.y.len());
            let pressure = load / (std::f64::consts::FRAC_PI_2 * half_length * width);
            let (y, u) = (grid.y(row), u[row]);
            strips.push(LoadedStrip { y, width, x, half_length, pressure, u });
            zone.max_pressure = line.iter().copied().fold(zone.max_pressure, f64::max);
            zone.length = zone.length.max(2.0 * half_length);
        }
        zone.count = strips.y.len() - zone.first;
        zone.width = right - left;
        strips.summarise(&mut zone);
        strips.zones.push(zone);
    }
    strips.elements = Some(Box::new(ElementPressure { grid, pressure, strip_of_row, iterations }));
    left_out
}
