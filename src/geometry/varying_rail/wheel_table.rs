//! A wheel by its width: where its profile lies lowest, for a quick look from a row of a rail.

use crate::geometry::curve::Curve;

/// Cells of the table [m].
pub(super) const CELL: f64 = 1e-3;
/// How far beside the wheel rows are looked at [m].
const BESIDE: f64 = 0.01;

/// Parameter and height of a wheel over cells of its width; of what lies lowest.
#[derive(Clone, Debug)]
pub(super) struct WheelTable {
    start: f64,
    /// Parameter of the lowest point of each cell, and its z [m].
    cells: Vec<[f64; 2]>,
}

impl WheelTable {
    /// The table of the profile `wheel`.
    pub fn new(wheel: &Curve) -> Self {
        let (from, length) = (wheel.start(), wheel.end() - wheel.start());
        let count = (length / (0.2 * CELL)).ceil() as usize;
        let sample = |i: usize| {
            let s = from + length * i as f64 / count as f64;
            (s, wheel.at(s).point)
        };
        let range = (0..=count).map(|i| sample(i).1[0]);
        let [least, greatest] = range.fold([f64::MAX, f64::MIN], |[a, b], y| [a.min(y), b.max(y)]);
        let mut cells = vec![[from, f64::NEG_INFINITY]; ((greatest - least) / CELL) as usize + 1];
        for (s, [y, z]) in (0..=count).map(sample) {
            let cell = &mut cells[((y - least) / CELL) as usize];
            if z > cell[1] {
                *cell = [s, z];
            }
        }
        Self { start: least, cells }
    }

    /// Parameter of the lowest point of the cell at `y` [m]; nothing where that is far beside the
    /// wheel.
    pub fn parameter(&self, y: f64) -> Option<f64> {
        let cell = (y - self.start) / CELL;
        let beside = BESIDE / CELL;
        let last = self.cells.len() - 1;
        let is_near = cell > -beside && cell < last as f64 + beside;
        is_near.then(|| self.cells[(cell.max(0.0) as usize).min(last)][0])
    }

    /// Greatest z of the wheel from one place across to another one [m].
    pub fn lowest(&self, [from, to]: [f64; 2]) -> f64 {
        let cell = |y: f64| ((y - self.start) / CELL).max(0.0) as usize;
        let cells = &self.cells[cell(from).min(self.cells.len())..];
        let count = (cell(to) + 1).saturating_sub(cell(from)).min(cells.len());
        cells[..count].iter().map(|c| c[1]).fold(f64::NEG_INFINITY, f64::max)
    }
}
