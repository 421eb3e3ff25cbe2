//! Damping of the normal motion.
//!
//! Linear in the closing speed with a coefficient that follows the root of the contact stiffness, as for a contact of constant
//! damping ratio, and so vanishes with the contact; the bodies never pull at each other:
//!
//! ```text
//! N = max(0, N_e + c δ'),  c = c_ref sqrt(k / k_ref),  k = 3 N_e / (2 δ),  k_ref = 5e8 N/m
//! ```
//!
//! The stiffness k is that of a Hertzian load N_e ~ δ^(3/2).

/// Contact stiffness at which the damping coefficient is the one given [N/m].
pub const REFERENCE_STIFFNESS: f64 = 5e8;

/// Normal force with damping [N] from the elastic load `load` ≥ 0 [N] at `penetration` > 0 [m], the closing speed [m/s]
/// (positive when approaching) and the coefficient c_ref ≥ 0 at the reference stiffness [N s/m].
#[must_use]
pub fn damped_load(load: f64, penetration: f64, closing_speed: f64, coefficient: f64) -> f64 {
    if coefficient == 0.0 || load <= 0.0 {
        return load;
    }
    let stiffness = 1.5 * load / penetration;
    (load + coefficient * (stiffness / REFERENCE_STIFFNESS).sqrt() * closing_speed).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn damping_adds_when_closing_takes_away_when_parting_and_never_pulls() {
        let at = |speed| damped_load(5e4, 7.5e-5, speed, 1e5);
        approx::assert_relative_eq!(at(0.0), 5e4);
        // k = 1e9 N/m: c = 1e5 sqrt(2).
        approx::assert_relative_eq!(at(0.1), 5e4 + 1e4 * 2f64.sqrt(), max_relative = 1e-12);
        approx::assert_relative_eq!(at(-0.1), 5e4 - 1e4 * 2f64.sqrt(), max_relative = 1e-12);
        assert!(at(-10.0).abs() <= 0.0);
    }
}
