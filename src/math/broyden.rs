//! Several equations in as many unknowns, by Broyden's method.

use nalgebra::{SMatrix, SVector};

/// Where the unknowns are, what is left of the equations there, and what a step is believed to take
/// off that.
#[derive(Clone, Debug)]
pub struct Broyden<const N: usize> {
    matrix: SMatrix<f64, N, N>,
    at: SVector<f64, N>,
    left: SVector<f64, N>,
}

impl<const N: usize> Broyden<N> {
    /// From `at` with what is `left` there; a step Δ is to take `matrix` Δ off it.
    pub fn new(matrix: SMatrix<f64, N, N>, at: SVector<f64, N>, left: SVector<f64, N>) -> Self {
        Self { matrix, at, left }
    }

    /// Takes over what is `left` elsewhere, and corrects the matrix so that it would have told it
    /// (Broyden 1965).
    pub fn take(&mut self, at: SVector<f64, N>, left: SVector<f64, N>) {
        let step = at - self.at;
        let square = step.norm_squared();
        if square > 0.0 {
            let off = self.left - left - self.matrix * step;
            self.matrix += off * step.transpose() / square;
        }
        (self.at, self.left) = (at, left);
    }

    /// Where nothing would be left, and the step to there; nothing where the matrix is singular.
    pub fn next(&self) -> Option<[SVector<f64, N>; 2]> {
        let step = self.matrix.try_inverse()? * self.left;
        let is_finite = step.iter().all(|number| number.is_finite());
        is_finite.then_some([self.at + step, step])
    }

    /// Unknown number `i` where nothing would be left of that equation, as a step of that alone is
    /// believed to do.
    pub fn next_alone(&self, i: usize) -> f64 {
        self.at[i] + self.left[i] / self.matrix[(i, i)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Vector2};

    #[test]
    fn two_curves_meet() {
        // x² + y² = 2 and x = y³.
        let left =
            |at: &SVector<f64, 2>| Vector2::new(2.0 - at.norm_squared(), at.y.powi(3) - at.x);
        let start = Vector2::new(1.2, 0.9);
        let matrix = Matrix2::new(2.4, 1.8, 1.0, -2.4);
        let mut search = Broyden::new(matrix, start, left(&start));
        for _ in 0..8 {
            let [at, _] = search.next().unwrap();
            search.take(at, left(&at));
        }
        let [at, step] = search.next().unwrap();
        assert!(step.norm() < 1e-14 && (at - Vector2::new(1.0, 1.0)).norm() < 1e-14, "{at} {step}");
    }

    #[test]
    fn linear_equations_take_one_step_and_a_singular_matrix_none() {
        let matrix = Matrix2::new(2.0, 1.0, 0.0, 3.0);
        let search = Broyden::new(matrix, Vector2::new(0.0, 0.0), Vector2::new(4.0, 6.0));
        let [at, step] = search.next().unwrap();
        assert!((at - Vector2::new(1.0, 2.0)).norm() < 1e-15 && at == step);
        let flat = Broyden::new(Matrix2::new(1.0, 2.0, 2.0, 4.0), at, Vector2::new(1.0, 1.0));
        assert!(flat.next().is_none());
    }
}
