//! Extent of the loaded zones, and the part of the lattice of elements that covers it.

use super::overlaps::Overlap;
use crate::boundary_element::grid::Grid;

/// A loaded zone on the elements: least and greatest x and arc [m], and its load [N].
#[derive(Clone, Copy, Debug)]
pub(super) struct ZoneExtent {
    x: [f64; 2],
    y: [f64; 2],
    load: f64,
}

/// The extents of the zones of `grid` that the `pressure` of its elements loads.
pub(super) fn zones(grid: &Grid, pressure: &[f64]) -> Vec<ZoneExtent> {
    let mut zones: Vec<ZoneExtent> = Vec::new();
    let mut open = false;
    for j in 0..grid.across {
        let line = &pressure[j * grid.along..(j + 1) * grid.along];
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

/// The grid over an overlap on which the extent of its contact is found.
pub(super) fn coarse_grid(overlap: &Overlap) -> Grid {
    let mut x = [f64::INFINITY, f64::NEG_INFINITY];
    for &[_, _, from, to] in overlap.places.iter().filter(|place| place[3] > place[2]) {
        x = [x[0].min(from), x[1].max(to)];
    }
    Grid::over(x, overlap.range(), COARSE[0], COARSE[1])
}

/// The box of all zones.
pub(super) fn extent_of(zones: &[ZoneExtent]) -> Option<[[f64; 2]; 2]> {
    let join = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
    zones.iter().map(|zone| [zone.x, zone.y]).reduce(|a, b| [join(a[0], b[0]), join(a[1], b[1])])
}

/// Length and width of elements, so that each notable zone has `elements` of them along and across,
/// from the ladder [m].
pub(super) fn element_size(
    zones: &[ZoneExtent],
    [x, y]: [[f64; 2]; 2],
    elements: [usize; 2],
) -> [f64; 2] {
    let load: f64 = zones.iter().map(|zone| zone.load).sum();
    let mut size = [f64::INFINITY; 2];
    for zone in zones.iter().filter(|zone| zone.load >= NOTABLE * load) {
        for (axis, range) in [zone.x, zone.y].into_iter().enumerate() {
            size[axis] = size[axis].min((range[1] - range[0]) / elements[axis] as f64);
        }
    }
    let count = (x[1] - x[0]) / size[0] * (y[1] - y[0]) / size[1];
    let most = MAX_ELEMENTS * (elements[0] * elements[1]) as f64;
    let larger = (count / most).sqrt().max(1.0);
    size.map(|size| ((larger * size).log2() * RUNGS).floor() / RUNGS).map(f64::exp2)
}

/// The part of the lattice of elements of `size` that covers a box, a margin and `room` more
/// elements on each side; along the track an element begins at `origin` [m].
pub(super) fn covering(
    [x, y]: [[f64; 2]; 2],
    [dx, dy]: [f64; 2],
    origin: f64,
    room: usize,
) -> Grid {
    let margin = MARGIN + room as f64;
    let cells = |range: [f64; 2], size: f64| {
        [(range[0] / size).floor() - margin, (range[1] / size).ceil() + margin]
    };
    let x = x.map(|x| x - origin);
    let ([x_first, x_end], [y_first, y_end]) = (cells(x, dx), cells(y, dy));
    Grid {
        along: (x_end - x_first) as usize,
        across: (y_end - y_first) as usize,
        dx,
        dy,
        leading_x: origin + (x_end - 0.5) * dx,
        left_y: (y_first + 0.5) * dy,
    }
}

/// A box, from where to where along and across, grown where the contact reaches the border of the
/// grid; nothing where it does not.
pub(super) fn beyond(
    grid: &Grid,
    pressure: &[f64],
    [x, y]: [[f64; 2]; 2],
) -> Option<[[f64; 2]; 2]> {
    let Grid { along, across, .. } = *grid;
    let loaded = |i: usize, j: usize| pressure[j * along + i] > 0.0;
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

/// Elements along and across an overlap on the grid on which the extent of its contact is found; it
/// may hold several zones.
const COARSE: [usize; 2] = [24, 48];
/// Share of the load from which on a zone has a say in the size of elements: smaller ones are
/// solved on those of the others.
const NOTABLE: f64 = 0.02;
/// Sizes of elements on the ladder between one and its half.
const RUNGS: f64 = 4.0;
/// Most elements of a grid, over those asked for of one zone: zones of different sizes far apart
/// share one lattice.
const MAX_ELEMENTS: f64 = 30.0;
/// Rows and columns beyond the extent that the coarse solution tells.
const MARGIN: f64 = 2.0;
/// Growth of a border that the contact reaches, as a share of the extent [-].
const GROWTH: f64 = 0.1;
