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

/// A cell of the march.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// Place t of its middle, and its square.
    powers: [f64; 2],
    /// Step to it over the length of a cell, and the means of t and T₂(t) over it times the same.
    step: [f64; 3],
    /// Half of what t and T₂(t) change by over the step, times the same.
    turn: [f64; 2],
    /// Bound in its middle over the mean of all.
    pub profile: f64,
}

/// The cells, leading edge first.
pub(super) const ALONG: [Cell; CELLS] = {
    let n = CELLS as f64;
    let mut cells =
        [Cell { powers: [0.0; 2], step: [0.0; 3], turn: [0.0; 2], profile: 0.0 }; CELLS];
    let mut k = 0;
    while k < CELLS {
        let t = 1.0 - (2 * k + 1) as f64 / n;
        let (middle, length) = if k == 0 { (1.0 - 0.5 / n, 0.5) } else { (t + 1.0 / n, 1.0) };
        cells[k] = Cell {
            powers: [t, t * t],
            step: [length, length * middle, length * (2.0 * middle * middle - 1.0)],
            turn: [length / n, 4.0 * t * length / n],
            // The mean of 1 - t² over the middles is the divisor.
            profile: (1.0 - t * t) / (2.0 / 3.0 + 1.0 / (3.0 * n * n)),
        };
        k += 1;
    }
    cells
};

/// Marches through some strips, whose sums go into `found`; `each` gets the tractions of a cell, and
/// whether they are bounded.
// Where they go out as a result, the compiler takes them apart and puts lanes of several sums into one
// vector.
#[inline(always)]
pub(super) fn march<const F: bool, T: Real>(
    strips: &Marched<T>,
    found: &mut Sums<T>,
    mut each: impl FnMut(usize, &[Lanes<T>; 2], &Lanes<bool>),
) {
    let zero = T::from(0.0);
    let mut sums = Sums::<T>::default();
    let [mut fx, mut fy] = [[zero; LANES]; 2];
    for (cell, &Cell { powers: [t, square], step, turn, profile }) in ALONG.iter().enumerate() {
        let mut slips = [false; LANES];
        let [x, y] = &strips.growth;
        for lane in 0..LANES {
            let trial = |own: T, by: &[Lanes<T>; 3]| {
                own.add_product::<F>(by[0][lane], T::from(step[0]))
                    .add_product::<F>(by[1][lane], T::from(step[1]))
                    .add_product::<F>(by[2][lane], T::from(step[2]))
            };
            let turned = |by: &[Lanes<T>; 3]| {
                (by[1][lane] * turn[0]).add_product::<F>(by[2][lane], T::from(turn[1]))
            };
            let size = |x: T, y: T| (x * x).add_product::<F>(y, y).sqrt();
            let [trial_x, trial_y] = [trial(fx[lane], x), trial(fy[lane], y)];
            let [turn_x, turn_y] = [turned(x), turned(y)];
            let mean =
                size(trial_x + turn_x, trial_y + turn_y) + size(trial_x - turn_x, trial_y - turn_y);
            // Without any traction this is infinite, and nothing slips.
            let ratio = strips.bound[lane] * (2.0 * profile) / mean;
            let scale = ratio.at_most(1.0);
            slips[lane] = scale < 1.0;
            fx[lane] = trial_x * scale;
            fy[lane] = trial_y * scale;
            sums.slipping[lane] += if scale < 1.0 { 1.0 } else { 0.0 };
        }
        for (sums, f) in sums.moments.iter_mut().zip([&fx, &fy]) {
            for lane in 0..LANES {
                sums[0][lane] += f[lane];
            }
            for lane in 0..LANES {
                sums[1][lane] = sums[1][lane].add_product::<F>(f[lane], T::from(t));
            }
            for lane in 0..LANES {
                sums[2][lane] = sums[2][lane].add_product::<F>(f[lane], T::from(square));
            }
        }
        each(cell, &[fx, fy], &slips);
    }
    *found = sums;
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_strip_that_slides_has_its_load() {
        let mean: f64 = ALONG.iter().map(|cell| cell.profile).sum::<f64>() / CELLS as f64;
        assert_relative_eq!(mean, 1.0, max_relative = 1e-14);
    }
}
