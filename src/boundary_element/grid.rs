//! The rectangular elements of a contact plane.

/// A rectangle of equal elements. Element (i, j) is number j · along + i: rows of constant y, in
/// each the leading edge (greatest x) first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Elements along rolling.
    pub along: usize,
    /// Rows across.
    pub across: usize,
    /// Length of an element along x, > 0 [m].
    pub dx: f64,
    /// Width of an element along y, > 0 [m].
    pub dy: f64,
    /// x of the centres of the leading elements [m].
    pub leading_x: f64,
    /// y of the centres of the leftmost row [m].
    pub left_y: f64,
}

impl Grid {
    /// `along` by `across` elements that fill the rectangle `x` by `y`, each from its least to its
    /// greatest coordinate [m].
    pub fn over(x: [f64; 2], y: [f64; 2], along: usize, across: usize) -> Self {
        let (dx, dy) = ((x[1] - x[0]) / along as f64, (y[1] - y[0]) / across as f64);
        Self { along, across, dx, dy, leading_x: x[1] - 0.5 * dx, left_y: y[0] + 0.5 * dy }
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.along * self.across
    }

    /// Whether there is no element.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// x of the centre of elements in column `i` [m].
    pub fn x(&self, i: usize) -> f64 {
        self.leading_x - i as f64 * self.dx
    }

    /// y of the centre of elements in row `j` [m].
    pub fn y(&self, j: usize) -> f64 {
        self.left_y + j as f64 * self.dy
    }

    /// Area of an element [m²].
    pub fn element_area(&self) -> f64 {
        self.dx * self.dy
    }

    /// Whether a `pressure` of the elements acts at the border.
    pub fn is_loaded_at_the_border(&self, pressure: &[f64]) -> bool {
        let is_border = |k: usize| {
            let (i, j) = (k % self.along, k / self.along);
            i == 0 || i + 1 == self.along || j == 0 || j + 1 == self.across
        };
        pressure.iter().enumerate().any(|(k, &p)| p > 0.0 && is_border(k))
    }

    /// A field of the elements seen in a mirror across x.
    pub fn mirrored<T: Copy>(&self, field: &[T]) -> Vec<T> {
        field.chunks_exact(self.along).flat_map(|row| row.iter().rev().copied()).collect()
    }

    /// A field of vectors (x, y) seen in that mirror.
    pub fn mirrored_vectors(&self, field: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut seen = self.mirrored(field);
        for vector in &mut seen {
            vector[0] = -vector[0];
        }
        seen
    }

    /// The value of `field(x, y)` at the centres of all elements.
    pub fn sample(&self, mut field: impl FnMut(f64, f64) -> f64) -> Vec<f64> {
        let mut values = Vec::with_capacity(self.len());
        for j in 0..self.across {
            let y = self.y(j);
            values.extend((0..self.along).map(|i| field(self.x(i), y)));
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn elements_fill_the_rectangle_from_the_leading_edge() {
        let grid = Grid::over([-1.0, 3.0], [2.0, 5.0], 8, 6);
        assert_relative_eq!(grid.x(0), 2.75);
        assert_relative_eq!(grid.x(7), -0.75);
        assert_relative_eq!(grid.y(0), 2.25);
        assert_relative_eq!(grid.y(5), 4.75);
        let sampled = grid.sample(|x, y| 10.0 * x + y);
        assert_eq!(sampled.len(), grid.len());
        assert_relative_eq!(sampled[8], 10.0 * 2.75 + 2.75);
    }
}
