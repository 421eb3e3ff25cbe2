//! A wheel by its width: where its profile lies lowest, for a quick look from a row of a rail.

use crate::geometry::curves::curve::Curve;

/// Cells of the table [m].
pub(super) const CELL: f64 = 1e-3;
/// How far beside the wheel rows are looked at [m].
const BESIDE: f64 = 0.01;

/// Parameter and height of a wheel over cells of its width; of what lies lowest.
#[derive(Clone, Debug)]
pub(super) struct WheelTable {
    start: f64,
    /// Parameter of the lowest point of the profile in each cell, and its z [m].
    cells: Vec<[f64; 2]>,
    /// Greatest z over 1, 2, 4 and so on cells of all that the wheel turns to the rail, by their
    /// first one [m].
    lows: Vec<Vec<f64>>,
}

impl WheelTable {
    /// The table of the profile `wheel`, none of which lies outside of it or of the `sides` of
    /// outlines, by the ends (y, z) of each [m].
    pub fn new(wheel: &Curve, sides: impl Iterator<Item = [[f64; 2]; 2]> + Clone) -> Self {
        let samples = samples(wheel).map(|[_, y, _]| y);
        let range = samples.chain(sides.clone().flatten().map(|[y, _]| y));
        let [least, greatest] = range.fold([f64::MAX, f64::MIN], |[a, b], y| [a.min(y), b.max(y)]);
        let count = ((greatest - least) / CELL) as usize + 1;
        let none = [wheel.start(), f64::NEG_INFINITY];
        let mut table = Self { start: least, cells: vec![none; count], lows: Vec::new() };
        table.follow(wheel);
        let mut lows: Vec<f64> = table.cells.iter().map(|cell| cell[1]).collect();
        for [a, b] in sides {
            let [left, right] =
                [a[0].min(b[0]), a[0].max(b[0])].map(|y| ((y - least) / CELL) as usize);
            for low in &mut lows[left..=right] {
                *low = low.max(a[1]).max(b[1]);
            }
        }
        let mut width = 1;
        while 2 * width <= count {
            let next = lows.iter().zip(&lows[width..]).map(|(a, b)| a.max(*b)).collect();
            table.lows.push(std::mem::replace(&mut lows, next));
            width *= 2;
        }
        table.lows.push(lows);
        table
    }

    /// Takes the parameters of the profile `wheel`, which lies within the outlines of the table.
    pub fn follow(&mut self, wheel: &Curve) {
        self.cells.fill([wheel.start(), f64::NEG_INFINITY]);
        let last = self.cells.len() - 1;
        for [s, y, z] in samples(wheel) {
            let cell = &mut self.cells[(((y - self.start).max(0.0) / CELL) as usize).min(last)];
            if z > cell[1] {
                *cell = [s, z];
            }
        }
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
        let cell = |y: f64| ((y - self.start) * (1.0 / CELL)).max(0.0) as usize;
        let (first, last) = (cell(from), cell(to).min(self.cells.len() - 1));
        if to < self.start || first > last {
            return f64::NEG_INFINITY;
        }
        let level = (last - first + 1).ilog2() as usize;
        let lows = &self.lows[level];
        lows[first].max(lows[last + 1 - (1 << level)])
    }
}

/// Points of a profile by parameter, y and z, a fifth of a cell apart.
fn samples(wheel: &Curve) -> impl Iterator<Item = [f64; 3]> + '_ {
    let (from, length) = (wheel.start(), wheel.end() - wheel.start());
    let count = (length / (0.2 * CELL)).ceil() as usize;
    (0..=count).map(move |i| {
        let s = from + length * i as f64 / count as f64;
        let [y, z] = wheel.at(s).point;
        [s, y, z]
    })
}
