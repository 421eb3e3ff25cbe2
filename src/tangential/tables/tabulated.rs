//! Look-ups in plain numbers and in numbers with derivatives.

use super::ellipse_force::{EllipseForce, ForceSlopes};
use super::scales::Scales;
use crate::math::real::Real;

/// Forces of ellipses by their creepages.
pub trait ForceTable {
    /// Force of an ellipse with these `scales` for finite creepages `v`.
    fn force(&self, scales: &Scales, v: [f64; 3]) -> EllipseForce;

    /// The same with its derivatives.
    fn force_and_slopes(&self, scales: &Scales, v: [f64; 3]) -> (EllipseForce, ForceSlopes);
}

/// Creep force of an ellipse of ln(a/b) = `log_ratio` for finite creepages `v`.
pub fn tabulated<T: Real>(
    table: &impl ForceTable,
    log_ratio: T,
    poisson_ratio: T,
    v: [T; 3],
) -> EllipseForce<T> {
    let scales = Scales::of(log_ratio.value(), poisson_ratio.value());
    let at = v.map(T::value);
    if !T::HAS_SLOPES {
        let EllipseForce { force, slip_share } = table.force(&scales, at);
        return EllipseForce { force: force.map(T::from), slip_share: slip_share.into() };
    }
    let (found, slopes) = table.force_and_slopes(&scales, at);
    // Poisson's ratio moves backwards alone. It enters by the scales, along which the force moves in
    // proportion.
    let by_ratio = T::IS_BACKWARD.then(|| {
        let along = scales.with_ratio_along(poisson_ratio.value());
        table.force_and_slopes(&along, at).1
    });
    let with_slopes = |value: f64, k: usize| {
        let [by_x, by_y, by_spin, by_t] = slopes[k];
        let own = [(&v[0], by_x), (&v[1], by_y), (&v[2], by_spin), (&log_ratio, by_t)];
        let ratio = by_ratio.as_ref().map(|by| (&poisson_ratio, by[k][3] - by_t));
        T::combined(value, own.into_iter().chain(ratio))
    };
    let [x, y, moment] = found.force;
    EllipseForce {
        force: [with_slopes(x, 0), with_slopes(y, 1), with_slopes(moment, 2)],
        slip_share: with_slopes(found.slip_share, 3),
    }
}
