//! Numbers for rolling contact fatigue of a patch.
//!
//! Both are experimental: equations and numbers are not checked against the papers they are
//! ascribed to (docs/wear.md); dimension and continuity are.

use crate::math::real::Real;

/// T-gamma damage of a rail by one passage, as a share of its life [-]: the damage function of the
/// whole life rail model (Burstow 2003, grade R220 to R260).
///
/// ```text
/// T-gamma [N]          0 .. 15   65      175   285
/// damage [1e-6]        0         10      0     -10, and on with the same slope
/// ```
///
/// `wear_number` is T-gamma [N]. Positive damage, crack growth, counts only where `is_driving`:
/// where the longitudinal creep force on the wheel points the way it runs, so that the rail is
/// pushed backwards. Beyond 175 N wear removes more than cracks grow, whatever the direction: the
/// number is negative.
pub fn tgamma_damage<T: Real>(wear_number: T, is_driving: bool) -> T {
    let [threshold, peak, balance] = [15.0, 65.0, 175.0];
    let damage = if wear_number < threshold {
        T::from(0.0)
    } else if wear_number < peak {
        (wear_number - threshold) * 10e-6 / (peak - threshold)
    } else {
        (-wear_number + balance) * 10e-6 / (balance - peak)
    };
    if is_driving { damage } else { damage.at_most(0.0) }
}

/// Surface fatigue index of a patch [-] (Ekberg, Kabo and Andersson 2002): above 0 the surface
/// ratchets.
///
/// ```text
/// FI = f - 2 A k/(3 N),  f = sqrt(Fx² + Fy²)/N,  A = π a b the area, k the yield stress in shear
/// ```
///
/// `normal_force` N > 0 [N], creep force [N], `area` [m²], `shear_yield` [Pa]; 0 without load.
pub fn surface_fatigue_index<T: Real>(
    normal_force: T,
    creep_force: [T; 2],
    area: T,
    shear_yield: f64,
) -> T {
    if normal_force <= 0.0 {
        return T::from(0.0);
    }
    let utilised = creep_force[0].hypotenuse(creep_force[1]) / normal_force;
    utilised - area * 2.0 * shear_yield / (normal_force * 3.0)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn damage_is_continuous_and_has_its_corners() {
        for (t, damage) in
            [(0.0, 0.0), (15.0, 0.0), (40.0, 5e-6), (65.0, 10e-6), (175.0, 0.0), (285.0, -10e-6)]
        {
            assert_relative_eq!(tgamma_damage(t, true), damage, epsilon = 1e-18);
            let step = tgamma_damage(t + 1e-9, true) - tgamma_damage(t - 1e-9, true);
            assert!(step.abs() < 1e-14);
        }
        assert_relative_eq!(tgamma_damage(65.0, false), 0.0);
        assert_relative_eq!(tgamma_damage(285.0, false), -10e-6, epsilon = 1e-18);
    }

    #[test]
    fn the_surface_index_vanishes_on_the_limit_of_the_shakedown_map() {
        // p0/k = 1/f for an ellipse with p0 = 3 N/(2 A).
        let (load, area, yielding) = (1e5, 1e-4, 3e8);
        let p0 = 1.5 * load / area;
        let force = load * yielding / p0;
        let index = surface_fatigue_index(load, [0.6 * force, 0.8 * force], area, yielding);
        assert_relative_eq!(index, 0.0, epsilon = 1e-15);
        assert!(surface_fatigue_index(load, [force, force], area, yielding) > 0.0);
        assert_relative_eq!(surface_fatigue_index(0.0, [0.0; 2], area, yielding), 0.0);
    }
}
