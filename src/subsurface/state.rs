//! Displacement and stress at a point, and the values that strength is judged by.

/// A stress tensor in the axes of the contact plane, x along rolling, y to the right, z into the
/// body; tension is positive [Pa].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stress {
    /// Normal stress along x.
    pub xx: f64,
    /// Normal stress along y.
    pub yy: f64,
    /// Normal stress along the depth: minus the pressure on the surface.
    pub zz: f64,
    /// Shear stress in planes parallel to the surface, between x and y.
    pub xy: f64,
    /// Shear stress on planes parallel to the surface, along y: minus the traction on the surface.
    pub yz: f64,
    /// Shear stress on planes parallel to the surface, along x: minus the traction on the surface.
    pub xz: f64,
}

impl From<[f64; 6]> for Stress {
    /// From xx, yy, zz, xy, yz, xz.
    fn from([xx, yy, zz, xy, yz, xz]: [f64; 6]) -> Self {
        Self { xx, yy, zz, xy, yz, xz }
    }
}

impl Stress {
    /// xx, yy, zz, xy, yz, xz [Pa].
    pub fn components(&self) -> [f64; 6] {
        [self.xx, self.yy, self.zz, self.xy, self.yz, self.xz]
    }

    /// Mean of the normal stresses, negative in compression [Pa].
    pub fn hydrostatic(&self) -> f64 {
        (self.xx + self.yy + self.zz) / 3.0
    }

    /// Second invariant of the deviator, ≥ 0 [Pa²].
    fn second_invariant(&self) -> f64 {
        let [xy, yz, zx] = [self.xx - self.yy, self.yy - self.zz, self.zz - self.xx];
        (xy * xy + yz * yz + zx * zx) / 6.0
            + self.xy * self.xy
            + self.yz * self.yz
            + self.xz * self.xz
    }

    /// Third invariant of the deviator, its determinant [Pa³].
    fn third_invariant(&self) -> f64 {
        let mean = self.hydrostatic();
        let [x, y, z] = [self.xx - mean, self.yy - mean, self.zz - mean];
        x * (y * z - self.yz * self.yz) - self.xy * (self.xy * z - self.yz * self.xz)
            + self.xz * (self.xy * self.yz - y * self.xz)
    }

    /// Equivalent stress of von Mises, √(3 J₂), ≥ 0: that of a rod in tension; √3 times the shear
    /// stress in pure shear [Pa].
    pub fn von_mises(&self) -> f64 {
        (3.0 * self.second_invariant()).sqrt()
    }

    /// Equivalent stress of Tresca, ≥ 0: the greatest less the least principal stress, twice the
    /// greatest shear stress [Pa].
    pub fn tresca(&self) -> f64 {
        // Principal stresses of the deviator: 2 √(J₂/3) cos(θ - 2πk/3), cos 3θ = √27 J₃/(2 J₂^1.5).
        let (second, third) = (self.second_invariant(), self.third_invariant());
        let size = second * second.sqrt();
        if size <= 0.0 {
            return 0.0;
        }
        let cosine = (0.5 * 27f64.sqrt() * third / size).clamp(-1.0, 1.0);
        2.0 * second.sqrt() * (cosine.acos() / 3.0 + std::f64::consts::FRAC_PI_3).sin()
    }

    /// Greatest shear stress on the plane parallel to the surface, √(τ_xz² + τ_yz²), ≥ 0: in rolling
    /// it turns its sign from one side of the patch to the other [Pa].
    pub fn orthogonal_shear(&self) -> f64 {
        (self.xz * self.xz + self.yz * self.yz).sqrt()
    }
}

/// What a body undergoes at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Displacement of the body's particles by the load, along x, y and into the body, relative to
    /// those far away [m].
    pub displacement: [f64; 3],
    /// Stress.
    pub stress: Stress,
}

/// A value of the stress that may be looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Measure {
    /// [`Stress::von_mises`].
    VonMises,
    /// [`Stress::tresca`].
    Tresca,
    /// [`Stress::hydrostatic`]; the greatest is that of greatest size, of either sign.
    Hydrostatic,
    /// [`Stress::orthogonal_shear`].
    OrthogonalShear,
}

impl Measure {
    /// All of them.
    pub const ALL: [Self; 4] =
        [Self::VonMises, Self::Tresca, Self::Hydrostatic, Self::OrthogonalShear];

    /// Its value [Pa].
    pub fn of(self, stress: &Stress) -> f64 {
        match self {
            Self::VonMises => stress.von_mises(),
            Self::Tresca => stress.tresca(),
            Self::Hydrostatic => stress.hydrostatic(),
            Self::OrthogonalShear => stress.orthogonal_shear(),
        }
    }

    /// Its name in tables and in Python.
    pub fn name(self) -> &'static str {
        match self {
            Self::VonMises => "von_mises",
            Self::Tresca => "tresca",
            Self::Hydrostatic => "hydrostatic",
            Self::OrthogonalShear => "orthogonal_shear",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn equivalent_stresses_of_simple_states_are_known() {
        let pull = Stress { xx: 3.0, ..Stress::default() };
        assert_relative_eq!(pull.von_mises(), 3.0, max_relative = 1e-14);
        assert_relative_eq!(pull.tresca(), 3.0, max_relative = 1e-7);
        assert_relative_eq!(pull.hydrostatic(), 1.0, max_relative = 1e-14);
        for shear in [
            Stress { xy: 2.0, ..Stress::default() },
            Stress { yz: -2.0, ..Stress::default() },
            Stress { xz: 2.0, ..Stress::default() },
        ] {
            assert_relative_eq!(shear.von_mises(), 12f64.sqrt(), max_relative = 1e-14);
            assert_relative_eq!(shear.tresca(), 4.0, max_relative = 1e-14);
        }
        let pressed = Stress { xx: -5.0, yy: -5.0, zz: -5.0, ..Stress::default() };
        assert_eq!([pressed.von_mises(), pressed.tresca()].map(f64::to_bits), [0, 0]);
    }

    #[test]
    fn tresca_is_the_distance_of_the_extreme_eigenvalues() {
        for k in 0..200 {
            let s = |n: u32| (f64::from(k * 6 + n) * 1.7).sin() * 10.0;
            let stress = Stress::from([s(0), s(1), s(2), s(3), s(4), s(5)]);
            let [x, y, z, xy, yz, xz] = stress.components();
            let principal = nalgebra::Matrix3::new(x, xy, xz, xy, y, yz, xz, yz, z);
            let principal = principal.symmetric_eigenvalues();
            assert_relative_eq!(
                stress.tresca(),
                principal.max() - principal.min(),
                max_relative = 1e-9
            );
        }
    }
}
