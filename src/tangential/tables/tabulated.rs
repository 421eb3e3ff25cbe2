//! Look-ups in plain numbers and in numbers with derivatives.

use super::ellipse_force::{EllipseForce, ForceSlopes};
use super::scales::Scales;
use crate::math::dual::Dual;
use crate::math::real::Real;
use crate::math::tape::Taped;

/// Forces of ellipses by their creepages.
pub trait ForceTable {
    /// Force of an ellipse with these `scales` for finite creepages `v`.
    fn force(&self, scales: &Scales, v: [f64; 3]) -> EllipseForce;

    /// The same with its derivatives.
    fn force_and_slopes(&self, scales: &Scales, v: [f64; 3]) -> (EllipseForce, ForceSlopes);
}

/// Numbers for which forces are looked up.
pub trait Tabulated: Real {
    /// Creep force of an ellipse of ln(a/b) = `log_ratio` for finite creepages `v`.
    fn tabulated(
        table: &impl ForceTable,
        log_ratio: Self,
        poisson_ratio: Self,
        v: [Self; 3],
    ) -> EllipseForce<Self>;
}

impl Tabulated for f64 {
    #[inline]
    fn tabulated(
        table: &impl ForceTable,
        log_ratio: f64,
        poisson_ratio: f64,
        v: [f64; 3],
    ) -> EllipseForce {
        table.force(&Scales::of(log_ratio, poisson_ratio), v)
    }
}

impl<const N: usize> Tabulated for Dual<N> {
    fn tabulated(
        table: &impl ForceTable,
        log_ratio: Self,
        poisson_ratio: Self,
        v: [Self; 3],
    ) -> EllipseForce<Self> {
        // Poisson's ratio does not move.
        with_slopes(table, log_ratio, poisson_ratio.value, v)
    }
}

impl Tabulated for Taped {
    fn tabulated(
        table: &impl ForceTable,
        log_ratio: Self,
        poisson_ratio: Self,
        v: [Self; 3],
    ) -> EllipseForce<Self> {
        let scales = Scales::of(log_ratio.value(), poisson_ratio.value());
        let at = v.map(Self::value);
        let (found, slopes) = table.force_and_slopes(&scales, at);
        // The ratio enters by the scales alone, along which the force moves in proportion.
        let along = scales.with_ratio_along(poisson_ratio.value());
        let (_, with_ratio) = table.force_and_slopes(&along, at);
        let with_slopes = |value: f64, k: usize| {
            let [by_x, by_y, by_spin, by_t] = slopes[k];
            let by_ratio = with_ratio[k][3] - by_t;
            let numbers = [&v[0], &v[1], &v[2], &log_ratio, &poisson_ratio];
            let all = numbers.into_iter().zip([by_x, by_y, by_spin, by_t, by_ratio]);
            Self::combined(value, all)
        };
        let [x, y, moment] = found.force;
        EllipseForce {
            force: [with_slopes(x, 0), with_slopes(y, 1), with_slopes(moment, 2)],
            slip_share: with_slopes(found.slip_share, 3),
        }
    }
}

/// What a table tells, moved along its slopes.
fn with_slopes<T: Real>(
    table: &impl ForceTable,
    log_ratio: T,
    poisson_ratio: f64,
    v: [T; 3],
) -> EllipseForce<T> {
    let scales = Scales::of(log_ratio.value(), poisson_ratio);
    let (found, slopes) = table.force_and_slopes(&scales, v.map(T::value));
    let with_slopes = |value: f64, by: &[f64; 4]| {
        let moved = v[0] * by[0] + v[1] * by[1] + v[2] * by[2] + log_ratio * by[3];
        T::moving(value, moved)
    };
    let [x, y, moment] = found.force;
    EllipseForce {
        force: [
            with_slopes(x, &slopes[0]),
            with_slopes(y, &slopes[1]),
            with_slopes(moment, &slopes[2]),
        ],
        slip_share: with_slopes(found.slip_share, &slopes[3]),
    }
}
