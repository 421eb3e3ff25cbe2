//! The equivalent stress of Dang Van over a passage.

use super::smallest_ball::{Point, centre};
use super::strength::Strength;
use crate::subsurface::greatest::{COLUMNS, DEPTHS, FOUND, climb};
use crate::subsurface::{Stress, SurfaceLoad, evenly, lattice};

/// Stresses along a line below a passing contact, and what Dang Van's criterion makes of them.
///
/// ```text
/// σ_DV = max over t of ( τ(t) + c (σ_h(t) + σ_h,res) )
/// ```
///
/// τ is the greatest shear stress of s(t) - s_m, s the deviator and s_m the centre of the smallest
/// ball that holds its path: the part that does not vary is taken up by residual stresses once the
/// material has shaken down (Dang Van, Griveau and Message 1989; for wheels Ekberg, Kabo and
/// Andersson 2002). The unloaded state belongs to the path. Where the material does not shake down,
/// σ_DV is no measure of its life.
pub struct DangVan<'a> {
    load: &'a SurfaceLoad,
    weight: f64,
    residual: f64,
    /// Least and greatest x of the load [m].
    x: [f64; 2],
}

/// An equivalent stress and its place below a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equivalent {
    /// The stress [Pa].
    pub value: f64,
    /// y from the origin of the load, and depth [m].
    pub place: [f64; 2],
}

/// Thickness of the surface layer over the patch's shorter side.
const LAYER: f64 = 0.1;
/// Stresses along a line.
const STEPS: usize = 64;

/// What one particle has gone through.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Undergone {
    /// Equivalent stress of Dang Van [Pa].
    pub equivalent: f64,
    /// Greatest shear stress on planes parallel to the surface [Pa].
    pub shear: f64,
}

impl<'a> DangVan<'a> {
    /// Passages of `load` over a material of `strength`; nothing without load.
    pub fn new(load: &'a SurfaceLoad, strength: &Strength) -> Option<Self> {
        let [x, _] = load.extent()?;
        Some(Self { load, weight: strength.dang_van, residual: strength.residual, x })
    }

    /// Equivalent stress at the `place` (y, depth ≥ 0) from the origin of the load [Pa].
    pub fn at(&self, place: [f64; 2]) -> f64 {
        self.undergone(place).equivalent
    }

    /// Where it is greatest below the surface layer, by steps along both axes from the best of a lattice
    /// of places; nothing without load.
    ///
    /// The surface layer is a tenth of the patch's shorter side, or an element where that is more:
    /// there tractions rule, roughness and the surface index.
    pub fn greatest(&self) -> Option<Equivalent> {
        let [_, [left, right]] = self.load.extent()?;
        let sides = [self.x[1] - self.x[0], right - left];
        let least = (LAYER * sides[0].min(sides[1])).max(self.load.element());
        let size = sides[0].max(sides[1]).max(2.0 * least);
        let factor = (size / least).powf(1.0 / (DEPTHS - 1) as f64);
        let depths: Vec<f64> = (0..DEPTHS).map(|k| least * factor.powi(k as i32)).collect();
        let at = |point: [f64; 3]| (point, self.at([point[1], point[2]]));
        let places = lattice(&[0.0], &evenly(left, right, COLUMNS), &depths);
        let best = places.into_iter().map(at).max_by(|a, b| a.1.total_cmp(&b.1))?;
        let across = (right - left) / COLUMNS as f64;
        let step = [0.0, across, 0.5 * best.0[2] * (factor - 1.0)];
        let ([_, y, depth], value) = climb(best, step, &(least..=2.0 * size), FOUND * least, at);
        Some(Equivalent { value, place: [y, depth] })
    }

    /// What a particle at the `place` (y, depth) goes through.
    pub(super) fn undergone(&self, [y, depth]: [f64; 2]) -> Undergone {
        let [low, high] = self.x;
        // Stresses fall within half the length of the patch, or the depth where that is greater.
        let beyond = 0.5 * (high - low) + 2.0 * depth;
        let (start, length) = (high + beyond, high - low + 2.0 * beyond);
        let mut path = [Stress::default(); STEPS + 1];
        for (k, stress) in path[..STEPS].iter_mut().enumerate() {
            let x = start - length * (k as f64 + 0.5) / STEPS as f64;
            *stress = self.load.state([x, y, depth]).stress;
        }
        let shear = path.iter().map(Stress::orthogonal_shear).fold(0.0, f64::max);
        Undergone { equivalent: equivalent(&path, self.weight, self.residual), shear }
    }
}

/// σ_DV of the states of a `path`, with the weight c and the residual hydrostatic stress [Pa].
fn equivalent(path: &[Stress], weight: f64, residual: f64) -> f64 {
    let points: Vec<Point> = path.iter().map(deviator).collect();
    let middle = centre(&points);
    let states = path.iter().zip(&points);
    let all = states.map(|(stress, point)| {
        let shear = 0.5 * stress_of(&(point - middle)).tresca();
        shear + weight * (stress.hydrostatic() + residual)
    });
    all.fold(f64::NEG_INFINITY, f64::max)
}

/// The deviator of a stress as a vector whose length is that of the tensor [Pa].
fn deviator(stress: &Stress) -> Point {
    let root = std::f64::consts::SQRT_2;
    let along = stress.zz - stress.hydrostatic();
    let shear = [stress.xy, stress.yz, stress.xz].map(|s| root * s);
    let across = (stress.xx - stress.yy) / root;
    Point::new(across, 1.5f64.sqrt() * along, shear[0], shear[1], shear[2])
}

/// The stress without hydrostatic part that has this deviator.
fn stress_of(point: &Point) -> Stress {
    let root = std::f64::consts::SQRT_2;
    let [half, zz] = [point[0] / root, point[1] / 1.5f64.sqrt()];
    let [xy, yz, xz] = [point[2] / root, point[3] / root, point[4] / root];
    Stress { xx: half - 0.5 * zz, yy: -half - 0.5 * zz, zz, xy, yz, xz }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const WEIGHT: f64 = 0.3;

    #[test]
    fn a_deviator_has_its_length_and_comes_back() {
        let stress = Stress::from([3.0, -1.0, 7.0, 2.0, -4.0, 0.5]);
        let point = deviator(&stress);
        // s:s = 2 J₂ = 2 σ_vM²/3.
        assert_relative_eq!(
            point.norm_squared(),
            2.0 / 3.0 * stress.von_mises().powi(2),
            max_relative = 1e-12
        );
        let back = stress_of(&point);
        let mean = stress.hydrostatic();
        assert_relative_eq!(back.xx, stress.xx - mean, epsilon = 1e-12);
        assert_relative_eq!(back.yy, stress.yy - mean, epsilon = 1e-12);
        assert_relative_eq!(back.zz, stress.zz - mean, epsilon = 1e-12);
        assert_relative_eq!(back.xz, stress.xz, epsilon = 1e-12);
    }

    #[test]
    fn paths_of_simple_tests_have_known_equivalents() {
        let found = |path: &[Stress]| equivalent(path, WEIGHT, 0.0);
        let pull = |s: f64| Stress { xx: s, ..Stress::default() };
        let twist = |s: f64| Stress { xz: s, ..Stress::default() };
        // Tension and compression: half the amplitude, and the hydrostatic stress of the peak.
        assert_relative_eq!(
            found(&[pull(2.0), pull(-2.0)]),
            1.0 + WEIGHT * 2.0 / 3.0,
            max_relative = 1e-12
        );
        // Pulsating: half of that amplitude.
        assert_relative_eq!(
            found(&[pull(2.0), pull(0.0)]),
            0.5 + WEIGHT * 2.0 / 3.0,
            max_relative = 1e-12
        );
        // Shear has no hydrostatic part; what does not vary of it does not count.
        let wanted = 1.5;
        assert_relative_eq!(found(&[twist(wanted), twist(-wanted)]), wanted, max_relative = 1e-12);
        assert_relative_eq!(
            found(&[twist(10.0 + wanted), twist(10.0 - wanted)]),
            wanted,
            max_relative = 1e-12
        );
        // Residual stress adds with its weight.
        let pressed = equivalent(&[twist(1.0), twist(-1.0)], WEIGHT, -2.0);
        assert_relative_eq!(pressed, 1.0 - 2.0 * WEIGHT, max_relative = 1e-12);
    }
}
