//! The march: FASTSIM from cell to cell of a strip, with gradients that change along it.
//!
//! Tractions over half length and inverse shear modulus grow by g₀ + k₁ g₁ t + k₂ g₂ T₂(t) over L,
//! where t falls from 1 at the leading edge to -1, and the bound is a parabola of the load of the
//! strip. The tractions here are against the slip: those on the wheel have the other sign.

use crate::math::real::Real;

/// Cells of a strip.
pub(super) const CELLS: usize = 8;
/// Strips that are marched through together.
pub(super) const LANES: usize = 4;
type Lanes<T> = [T; LANES];

/// What the march of some strips needs.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Marched<T> {
    /// What tractions grow by over a cell, constant, by t and by T₂(t), along the track and across.
    pub growth: [[Lanes<T>; 3]; 2],
    /// Mean bound of a cell.
    pub bound: Lanes<T>,
}

/// Sums over the cells.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums<T> {
    /// Of traction times t^k, k = 0, 1, 2, along the track and across.
    pub moments: [[Lanes<T>; 3]; 2],
    /// Number of cells that slip.
    pub slipping: Lanes<f64>,
}

/// Middle of a cell, and of the step to it.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn abscissae(cell: usize) -> [f64; 2] {
    let n = CELLS as f64;
    let middle = 1.0 - (2.0 * cell as f64 + 1.0) / n;
    [middle, if cell == 0 { 1.0 - 0.5 / n } else { middle + 1.0 / n }]
}

/// Bound in the middle of a cell over the mean of all.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn profile(cell: usize) -> f64 {
    let n = CELLS as f64;
    let [t, _] = abscissae(cell);
    // Mean of 1 - t² over the middles.
    (1.0 - t * t) / (2.0 / 3.0 + 1.0 / (3.0 * n * n))
}

/// Marches through some strips; `each` gets the tractions of a cell, and whether they are bounded.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn march<const F: bool, T: Real>(
    strips: &Marched<T>,
    mut each: impl FnMut(usize, &[Lanes<T>; 2], &Lanes<bool>),
) -> Sums<T> {
    let zero = T::from(0.0);
    let mut sums = Sums::<T>::default();
    let [mut fx, mut fy] = [[zero; LANES]; 2];
    for cell in 0..CELLS {
        let [t, step] = abscissae(cell);
        let length = if cell == 0 { 0.5 } else { 1.0 };
        let (first, second) = (length * step, length * (2.0 * step * step - 1.0));
        let share = profile(cell);
        let within = length / CELLS as f64;
        let mut slips = [false; LANES];
        let [x, y] = &strips.growth;
        for lane in 0..LANES {
            let trial = |own: T, by: &[Lanes<T>; 3]| {
                own.add_product::<F>(by[0][lane], T::from(length))
                    .add_product::<F>(by[1][lane], T::from(first))
                    .add_product::<F>(by[2][lane], T::from(second))
            };
            let turn = |by: &[Lanes<T>; 3]| {
                (by[1][lane] * within).add_product::<F>(by[2][lane], T::from(4.0 * t * within))
            };
            let size =
                |x: T, y: T| (x * x).add_product::<F>(y, y).at_least(f64::MIN_POSITIVE).sqrt();
            let [trial_x, trial_y] = [trial(fx[lane], x), trial(fy[lane], y)];
            let [turn_x, turn_y] = [turn(x), turn(y)];
            let mean =
                size(trial_x + turn_x, trial_y + turn_y) + size(trial_x - turn_x, trial_y - turn_y);
            let ratio = strips.bound[lane] * (2.0 * share) / mean;
            let scale = ratio.at_most(1.0);
            slips[lane] = scale < 1.0;
            fx[lane] = trial_x * scale;
            fy[lane] = trial_y * scale;
            sums.slipping[lane] += if scale < 1.0 { 1.0 } else { 0.0 };
            sums.moments[0][0][lane] += fx[lane];
            sums.moments[1][0][lane] += fy[lane];
            let sum = &mut sums.moments[0];
            sum[1][lane] = sum[1][lane].add_product::<F>(fx[lane], T::from(t));
            sum[2][lane] = sum[2][lane].add_product::<F>(fx[lane], T::from(t * t));
            let sum = &mut sums.moments[1];
            sum[1][lane] = sum[1][lane].add_product::<F>(fy[lane], T::from(t));
            sum[2][lane] = sum[2][lane].add_product::<F>(fy[lane], T::from(t * t));
        }
        each(cell, &[fx, fy], &slips);
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_strip_that_slides_has_its_load() {
        let mean: f64 = (0..CELLS).map(profile).sum::<f64>() / CELLS as f64;
        assert_relative_eq!(mean, 1.0, max_relative = 1e-14);
    }
}
