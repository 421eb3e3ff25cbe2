//! Elements of all steps: one endless lattice, so that tractions of one step have elements in the
//! next.

use crate::boundary_element::grid::Grid;

/// Elements of one size that cover the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    /// Length and width of an element [m].
    pub size: [f64; 2],
    /// (x, y) of the centre of element (0, 0); y from the origin of the separation [m].
    pub origin: [f64; 2],
}

/// A rectangle of elements. Columns are counted along x, rows along y.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Window {
    /// First column (the trailing one) and first row (the leftmost).
    pub first: [i64; 2],
    /// Columns and rows.
    pub count: [usize; 2],
}

/// Elements beyond the extent of a contact on each side.
const MARGIN: i64 = 1;

/// Part of an element by which an extent may be missed.
const ROUNDING: f64 = 1e-6;

impl Lattice {
    /// That of which `grid` is a part, its y counted from `contact_y`.
    pub fn through(grid: &Grid, contact_y: f64) -> Self {
        let origin = [grid.x(grid.along - 1), grid.left_y + contact_y];
        Self { size: [grid.dx, grid.dy], origin }
    }

    /// The elements over an extent (least and greatest x, then y) and one more on each side.
    pub fn over(&self, extent: [[f64; 2]; 2]) -> Window {
        let mut window = Window::default();
        for (axis, extent) in extent.into_iter().enumerate() {
            let [from, to] = extent.map(|value| (value - self.origin[axis]) / self.size[axis]);
            let first = (from + 0.5 + ROUNDING).floor() as i64 - MARGIN;
            let last = (to - 0.5 - ROUNDING).ceil() as i64 + MARGIN;
            window.first[axis] = first;
            window.count[axis] = usize::try_from(last - first + 1).unwrap_or(1);
        }
        window
    }

    /// Elements of `size` whose borders lie at whole multiples of it [m].
    pub fn with_borders_at_multiples(size: [f64; 2]) -> Self {
        Self { size, origin: size.map(|size| 0.5 * size) }
    }

    /// The window that `grid` is, a part of this lattice, its y as those of the lattice.
    pub fn window_of(&self, grid: &Grid) -> Window {
        let place = |at: f64, axis: usize| ((at - self.origin[axis]) / self.size[axis]).round();
        let leading = place(grid.leading_x, 0) as i64;
        let first = [leading + 1 - grid.along as i64, place(grid.left_y, 1) as i64];
        Window { first, count: [grid.along, grid.across] }
    }

    /// The centre of the element in a column and row [m].
    pub fn centre(&self, at: [i64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.origin[axis] + at[axis] as f64 * self.size[axis])
    }

    /// The place `at` [m] in columns and rows, whole at the centres of elements.
    pub fn place_of(&self, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| (at[axis] - self.origin[axis]) / self.size[axis])
    }

    /// The elements of `window` as a grid, y counted from `contact_y`.
    pub fn grid(&self, window: &Window, contact_y: f64) -> Grid {
        let Window { first, count } = *window;
        let leading = first[0] + count[0] as i64 - 1;
        Grid {
            along: count[0],
            across: count[1],
            dx: self.size[0],
            dy: self.size[1],
            leading_x: self.origin[0] + leading as f64 * self.size[0],
            left_y: self.origin[1] + first[1] as f64 * self.size[1] - contact_y,
        }
    }
}

impl Window {
    /// The least window whose centres surround all of the `places` in columns and rows.
    pub fn around(places: &[[f64; 2]]) -> Self {
        let mut window = Self::default();
        for axis in 0..2 {
            let of_axis = || places.iter().map(|place| place[axis]);
            let first = of_axis().fold(f64::INFINITY, f64::min).floor() as i64;
            let last = of_axis().fold(f64::NEG_INFINITY, f64::max).floor() as i64 + 1;
            window.first[axis] = first;
            window.count[axis] = usize::try_from(last - first + 1).unwrap_or(0);
        }
        window
    }

    /// Column and row of element number `k` of its grid.
    pub fn element(&self, k: usize) -> [i64; 2] {
        let Self { first, count } = *self;
        let columns = count[0].max(1);
        // Grids begin with the leading column.
        let column = first[0] + count[0] as i64 - 1 - (k % columns) as i64;
        [column, first[1] + (k / columns) as i64]
    }

    /// The number in its grid of the element in that column and row, if it has it.
    pub fn place(&self, at: [i64; 2]) -> Option<usize> {
        let Self { first, count } = *self;
        let behind = usize::try_from(first[0] + count[0] as i64 - 1 - at[0]).ok()?;
        let row = usize::try_from(at[1] - first[1]).ok()?;
        (behind < count[0] && row < count[1]).then_some(row * count[0] + behind)
    }

    /// The values of its elements at a `place` in columns and rows, linear between their centres; 0
    /// outside.
    pub fn between(&self, place: [f64; 2], values: &[[f64; 2]]) -> [f64; 2] {
        let low = place.map(f64::floor);
        let share = [0, 1].map(|axis| place[axis] - low[axis]);
        let mut sum = [0.0; 2];
        for (i, along) in [1.0 - share[0], share[0]].into_iter().enumerate() {
            for (j, across) in [1.0 - share[1], share[1]].into_iter().enumerate() {
                let at = [low[0] as i64 + i as i64, low[1] as i64 + j as i64];
                if let Some(value) = self.place(at).and_then(|k| values.get(k)) {
                    for c in 0..2 {
                        sum[c] += along * across * value[c];
                    }
                }
            }
        }
        sum
    }

    /// Whether it has no more elements than `most`.
    pub fn is_within(&self, most: usize) -> bool {
        self.count[0].saturating_mul(self.count[1]) <= most
    }

    /// The least window with the elements of both.
    pub fn with(&self, other: &Self) -> Self {
        let mut both = *self;
        for axis in 0..2 {
            let end = |window: &Self| window.first[axis] + window.count[axis] as i64;
            both.first[axis] = self.first[axis].min(other.first[axis]);
            let last = end(self).max(end(other));
            both.count[axis] = usize::try_from(last - both.first[axis]).unwrap_or(0);
        }
        both
    }

    /// Values of the elements of `from` on those of this window, in the order of grids: the default
    /// where `from` has none.
    pub fn values_of<T: Copy + Default>(&self, from: &Self, values: &[T]) -> Vec<T> {
        let mut own = vec![T::default(); self.count[0] * self.count[1]];
        for j in 0..self.count[1] {
            let row = self.first[1] + j as i64 - from.first[1];
            let Ok(row) = usize::try_from(row) else { continue };
            if row >= from.count[1] {
                continue;
            }
            for i in 0..self.count[0] {
                // Grids begin with the leading column.
                let behind = from.first[0] + from.count[0] as i64
                    - (self.first[0] + self.count[0] as i64)
                    + i as i64;
                if let Ok(column) = usize::try_from(behind)
                    && column < from.count[0]
                {
                    own[j * self.count[0] + i] = values[row * from.count[0] + column];
                }
            }
        }
        own
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_is_found_again_on_its_own_lattice() {
        let grid = Grid::over([-3.1e-3, 4.7e-3], [1e-3, 9e-3], 22, 12);
        let lattice = Lattice::through(&grid, 0.02);
        // One element of the grid on each side is margin.
        let extent = [[-3.1e-3 + grid.dx, 4.7e-3 - grid.dx], [0.021 + grid.dy, 0.029 - grid.dy]];
        let window = lattice.over(extent);
        let found = lattice.grid(&window, 0.02);
        assert_eq!((found.along, found.across), (22, 12));
        assert!((found.leading_x - grid.leading_x).abs() < 1e-15);
        assert!((found.left_y - grid.left_y).abs() < 1e-15);
        let moved = Grid { left_y: grid.left_y + 0.02, ..grid };
        assert_eq!(lattice.window_of(&moved), window);
        for k in [0, 21, 22, 100, 263] {
            assert_eq!(window.place(window.element(k)), Some(k));
        }
        assert_eq!(window.place([window.first[0] - 1, window.first[1]]), None);
    }

    #[test]
    fn values_stay_with_their_elements() {
        let all = Window { first: [-2, 5], count: [5, 4] };
        let grid = Lattice { size: [1.0; 2], origin: [0.0; 2] }.grid(&all, 0.0);
        let values = grid.sample(|x, y| 100.0 * x + y);
        for part in [
            Window { first: [-1, 6], count: [3, 2] },
            Window { first: [-4, 3], count: [9, 4] },
            Window { first: [10, 5], count: [3, 4] },
        ] {
            let grid = Lattice { size: [1.0; 2], origin: [0.0; 2] }.grid(&part, 0.0);
            let expected = grid.sample(|x, y| {
                let inside = (-2.0..=2.0).contains(&x) && (5.0..=8.0).contains(&y);
                if inside { 100.0 * x + y } else { 0.0 }
            });
            assert_eq!(part.values_of(&all, &values), expected);
            assert_eq!(all.with(&part).with(&all), all.with(&part));
        }
    }
}
