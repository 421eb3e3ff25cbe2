//! Direction of a vector of three creepages as two angles, folded into a quarter of the sphere.
//!
//! Creep forces have two symmetries: (ξ, η, φ) → (ξ, -η, -φ) is a mirror image across, (ξ, η, φ)
//! → -(ξ, η, φ) turns all tractions. Longitudinal creepage then is positive or zero, so is spin,
//! and
//!
//! ```text
//! x = r sin χ,  y = r cos χ cos ψ,  z = r cos χ sin ψ,      0 ≤ χ ≤ π/2,  0 ≤ ψ ≤ π
//! ```
//!
//! The pole χ = π/2 is pure longitudinal creepage.

/// Two angles, how they came about, and their derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Direction {
    /// χ [rad].
    pub elevation: f64,
    /// ψ [rad].
    pub azimuth: f64,
    /// Length of the vector.
    pub length: f64,
    /// Sign by which x, and by which y and z were folded.
    pub signs: [f64; 2],
    /// Derivatives of χ and ψ by x, y, z (not folded); those of ψ are 0 on the pole.
    pub slopes: [[f64; 3]; 2],
}

impl Direction {
    /// That of a vector that is not zero and whose square is neither zero nor infinite.
    pub fn of([x, y, z]: [f64; 3]) -> Self {
        let turn = if z < 0.0 { -1.0 } else { 1.0 };
        let mirror = if x < 0.0 { -1.0 } else { 1.0 };
        let (x, y, z) = (mirror * x, turn * y, (turn * z).abs());
        let across2 = y * y + z * z;
        let across = across2.sqrt();
        let length2 = across2 + x * x;
        let length = length2.sqrt();
        let (mut by_chi, mut by_psi) = ([mirror * across / length2, 0.0, 0.0], [0.0; 3]);
        if across > 1e-12 * length {
            let inward = -x / (length2 * across) * turn;
            (by_chi[1], by_chi[2]) = (inward * y, inward * z);
            by_psi = [0.0, -turn * z / across2, turn * y / across2];
        }
        Self {
            elevation: x.atan2(across),
            azimuth: z.atan2(y),
            length,
            signs: [mirror, turn],
            slopes: [by_chi, by_psi],
        }
    }
}

/// The unit vector of two angles.
pub fn unit_vector(elevation: f64, azimuth: f64) -> [f64; 3] {
    let across = elevation.cos();
    [elevation.sin(), across * azimuth.cos(), across * azimuth.sin()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    #[test]
    fn angles_give_the_vector_back_and_have_the_slopes_of_differences() {
        for v in [[0.5, 0.2, 0.9], [-0.5, 0.2, -0.9], [0.1, -2.0, 0.3], [-1.0, -0.2, -0.1]] {
            let at = Direction::of(v);
            let [mirror, turn] = at.signs;
            let [x, y, z] = unit_vector(at.elevation, at.azimuth).map(|u| u * at.length);
            for (found, expected) in [mirror * x, turn * y, turn * z].iter().zip(v) {
                assert_abs_diff_eq!(*found, expected, epsilon = 1e-15);
            }
            for k in 0..3 {
                let shifted = |h: f64| {
                    let mut v = v;
                    v[k] += h;
                    Direction::of(v)
                };
                let (plus, minus) = (shifted(1e-6), shifted(-1e-6));
                let slope = |of: fn(&Direction) -> f64| (of(&plus) - of(&minus)) / 2e-6;
                assert_abs_diff_eq!(at.slopes[0][k], slope(|d| d.elevation), epsilon = 1e-8);
                assert_abs_diff_eq!(at.slopes[1][k], slope(|d| d.azimuth), epsilon = 1e-8);
            }
        }
    }
}
