//! FASTSIM on the true patch: integration of the traction along each strip, from its leading edge.
//!
//! Source: Kalker, Vehicle System Dynamics 11 (1982) 1-13, with three flexibilities; applied to
//! patches of any outline by Piotrowski and Kik (2008), section 3. With s the distance from the
//! leading edge of a strip, x and y from the centroid of load of the zone, μ the coefficient of
//! friction ([`LoadedZone::friction_coefficient`]) and p_n the pressure, flat creepage gives
//!
//! ```text
//! dp_x/ds = -(ξ/L1 - y φ/L3),  dp_y/ds = -(η/L2 + x φ/L3),  |p| ≤ μ p_n(x, y)
//! ```
//!
//! With curved creepage each strip j has creepages ξ_j, η_j, φ_j of its own. Their mean over the
//! zone acts through L1 and L2, what they deviate by through L3, as spin does
//! ([`rigid_slip`](super::rigid_slip)); t is the place along x from the centre of the strip:
//!
//! ```text
//! dp_x/ds = -(ξ_mean/L1 + (ξ_j - ξ_mean)/L3)
//! dp_y/ds = -(η_mean/L2 + (η_j - η_mean)/L3 + t φ_j/L3)
//! ```
//!
//! Where ξ_j = ξ - y φ and η_j = η + x φ at the centre of the strip these are the equations above.
//!
//! Each strip has its own elements of equal length, so that the result does not depend on a grid
//! that the patch slides over. The bound of an element, μ p_n, is its mean over the element: full
//! sliding gives the friction limit to rounding.

mod lanes;

use self::lanes::{Elements, LANES, LaneInput};
use super::flexibility::ZoneFlexibility;
use super::rigid_slip::Growth;
use super::rule::Rule;
use super::{LoadedZone, Rolling, StripForce};
use crate::math::real::Real;

/// Shape of the traction bound along and across a zone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum TractionBound {
    /// Friction times the semi-elliptical pressure.
    #[default]
    Elliptic,
    /// Friction times C (x_l² - x²), C such that the load of the zone is kept.
    Parabolic,
}

/// FASTSIM with a fixed number of elements along each strip.
#[derive(Clone, Debug)]
pub struct Fastsim {
    bound: TractionBound,
    /// Mean over each element of the bound of a strip, in units of its greatest value; leading edge
    /// first.
    profile: Vec<f64>,
    /// Normalised abscissa of each element's middle, 1 at the leading edge, and of the middle of
    /// the step to it.
    abscissae: Vec<[f64; 2]>,
}

impl Fastsim {
    /// `elements` ≥ 1 along each strip.
    pub fn new(elements: usize, bound: TractionBound) -> Self {
        let n = elements as f64;
        // Antiderivative of sqrt(1 - t²) or of 1 - t².
        let integral = |t: f64| match bound {
            TractionBound::Elliptic => 0.5 * (t * (1.0 - t * t).max(0.0).sqrt() + t.asin()),
            TractionBound::Parabolic => t - t * t * t / 3.0,
        };
        let edge = |i: usize| (1.0 - 2.0 * i as f64 / n).max(-1.0);
        let profile =
            (0..elements).map(|i| 0.5 * n * (integral(edge(i)) - integral(edge(i + 1)))).collect();
        let abscissae = (0..elements)
            .map(|i| {
                let middle = 1.0 - (2.0 * i as f64 + 1.0) / n;
                [middle, if i == 0 { 1.0 - 0.5 / n } else { middle + 1.0 / n }]
            })
            .collect();
        Self { bound, profile, abscissae }
    }

    fn elements(&self) -> Elements<'_> {
        Elements { profile: &self.profile, abscissae: &self.abscissae }
    }

    /// Marches through the `strips` of a zone and hands the force on the wheel of each to `each`.
    pub fn march<T: Real>(
        &self,
        strips: std::ops::Range<usize>,
        rolling: Rolling,
        strip: impl Fn(usize) -> Marched<T>,
        mut each: impl FnMut(usize, StripForce<T>),
    ) {
        let n = self.profile.len() as f64;
        let direction = rolling.direction();
        for start in strips.clone().step_by(LANES) {
            let mut input = LaneInput::<T>::default();
            let lanes = (strips.end - start).min(LANES);
            let [mut areas, mut arms] = [[T::from(0.0); LANES]; 2];
            for lane in 0..lanes {
                let Marched { half_length: a, width, growth, bound } = strip(start + lane);
                let step = a * 2.0 / n;
                input.step_x[lane] = -step * growth.longitudinal;
                input.step_y[lane] = -step * growth.lateral;
                input.step_y_per_abscissa[lane] = -step * direction * a * growth.twist;
                input.bound[lane] = bound;
                areas[lane] = width * step;
                arms[lane] = a * direction;
            }
            let sums = input.march(lanes, self.elements());
            for lane in 0..lanes {
                let area = areas[lane];
                each(
                    start + lane,
                    StripForce {
                        longitudinal: area * sums.x[lane],
                        lateral: area * sums.y[lane],
                        moment: area * arms[lane] * sums.y_abscissa[lane],
                        slip_area: area * sums.slipping[lane],
                    },
                );
            }
        }
    }

    /// C of a parabolic bound for strips of a zone that carry `load`, each given by its half length
    /// and its width; 0 where the bound is another.
    pub fn parabola<T: Real>(&self, load: T, strips: impl Iterator<Item = [T; 2]>) -> T {
        if self.bound == TractionBound::Elliptic {
            return T::from(0.0);
        }
        let moment: T = strips.map(|[half_length, width]| width * half_length.powi(3)).sum();
        if moment > 0.0 { load * 0.75 / moment } else { T::from(0.0) }
    }

    /// What bounds the traction at the centre of a strip with this `pressure` [Pa] there, over the
    /// coefficient of friction.
    #[inline]
    pub fn bounding_pressure<T: Real>(&self, parabola: T, half_length: T, pressure: T) -> T {
        match self.bound {
            TractionBound::Elliptic => pressure,
            TractionBound::Parabolic => parabola * half_length * half_length,
        }
    }

    fn parabola_of<T: Real>(&self, loaded: &LoadedZone<'_, T>) -> T {
        let (zone, strips) = (loaded.zone, loaded.strips);
        let own = zone.range();
        self.parabola(zone.load, own.map(|j| [strips.half_length[j], strips.width[j]]))
    }

    #[inline(always)]
    fn strip<T: Real>(
        &self,
        loaded: &LoadedZone<'_, T>,
        flexibility: &ZoneFlexibility<T>,
        parabola: T,
        j: usize,
    ) -> Marched<T> {
        let strips = loaded.strips;
        let half_length = strips.half_length[j];
        let pressure = self.bounding_pressure(parabola, half_length, strips.pressure[j]);
        Marched {
            half_length,
            width: strips.width[j],
            growth: loaded.slip.growth(j, flexibility),
            bound: loaded.friction_coefficient(j) * pressure,
        }
    }
}

/// A strip that is marched through.
#[derive(Clone, Copy, Debug)]
pub struct Marched<T> {
    /// Half length [m].
    pub half_length: T,
    /// Width [m].
    pub width: T,
    /// How traction grows where it adheres.
    pub growth: Growth<T>,
    /// What bounds the traction at the centre [Pa].
    pub bound: T,
}

impl<T: Real> Rule<T> for Fastsim {
    fn strip_forces(
        &self,
        loaded: &LoadedZone<'_, T>,
        rolling: Rolling,
        _: &ZoneFlexibility<T>,
        blended: &ZoneFlexibility<T>,
        each: impl FnMut(usize, StripForce<T>),
    ) {
        let parabola = self.parabola_of(loaded);
        let strip = |j: usize| self.strip(loaded, blended, parabola, j);
        self.march(loaded.zone.range(), rolling, strip, each);
    }
}

impl Fastsim {
    /// Traction on the wheel of each element of strip `j` of a zone that rolls forward, leading
    /// edge first, and whether it slips.
    pub fn tractions(
        &self,
        loaded: &LoadedZone<'_>,
        j: usize,
        flexibility: &ZoneFlexibility,
    ) -> Vec<([f64; 2], bool)> {
        let Marched { half_length: a, growth, bound, .. } =
            self.strip(loaded, flexibility, self.parabola_of(loaded), j);
        let step = 2.0 * a / self.profile.len() as f64;
        let input = LaneInput {
            step_x: [-step * growth.longitudinal; LANES],
            step_y: [-step * growth.lateral; LANES],
            step_y_per_abscissa: [-step * a * growth.twist; LANES],
            bound: [bound; LANES],
        };
        let mut found = Vec::with_capacity(self.profile.len());
        input.march_lanes::<1>(self.elements(), |[[x], [y]], [slips]| {
            found.push(([*x, *y], *slips));
        });
        found
    }
}
