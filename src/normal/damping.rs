//! Damping of the normal motion.
//!
//! Linear in the approach velocity, with a coefficient that follows the root of the contact
//! stiffness, as for a contact of constant damping ratio. Where the contact begins it vanishes
//! faster than the elastic load, so that neither the force nor its slope jumps there and the
//! pressure stays bounded; the bodies never pull at each other:
//!
//! ```text
//! N = max(0, N_e + c δ'),  c = c_ref sqrt(k/k_ref) δ²/(δ² + δ_ref²),  k = 3 N_e/(2 δ)
//! k_ref = 5e8 N/m,  δ_ref = 10 µm
//! ```
//!
//! The stiffness k is that of a Hertzian load N_e ~ δ^(3/2). Under a wheel load of 50 kN (δ about
//! 65 µm) the last factor is 0.98.

use crate::leaves::DAMPING;
use crate::math::real::Real;

/// Contact stiffness at which the damping coefficient is the one given [N/m].
pub const REFERENCE_STIFFNESS: f64 = 5e8;

/// Penetration at which half of the damping is there [m].
pub const REFERENCE_PENETRATION: f64 = 1e-5;

/// Normal force with damping [N] from the elastic load `load` ≥ 0 [N] at `penetration` > 0 [m], the
/// approach velocity [m/s] (positive when approaching) and the coefficient c_ref ≥ 0 at the
/// reference stiffness [N s/m].
pub fn damped_load<T: Real>(load: T, penetration: T, closing_speed: T, coefficient: f64) -> T {
    // Backwards it may be the damping that counts.
    if (coefficient == 0.0 && !T::IS_BACKWARD) || load <= 0.0 {
        return load;
    }
    let stiffness = load * 1.5 / penetration;
    let onset = penetration * penetration
        / (penetration * penetration + REFERENCE_PENETRATION * REFERENCE_PENETRATION);
    let damping = (stiffness / REFERENCE_STIFFNESS).sqrt().times(coefficient, DAMPING) * onset;
    (load + damping * closing_speed).at_least(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn damping_sets_in_more_softly_than_the_elastic_load() {
        let mut before = 0.0;
        for power in (-120..=-60).map(|p| f64::from(p) / 10.0) {
            let penetration = 10f64.powf(power);
            let load = 7e10 * penetration.powf(1.5);
            let factor = damped_load(load, penetration, 0.1, 1e5) / load;
            assert!(factor > before && factor < 3.0, "{factor} at {penetration}");
            before = factor;
        }
    }
}
