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
use super::rigid_slip::RigidSlip;
use super::rule::Rule;
use super::{LoadedZone, Rolling, StripForce};
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

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

    /// Hands the force of each strip of `loaded` on the wheel to `each`.
    pub fn strip_forces<T: Real>(
        &self,
        loaded: &LoadedZone<'_, impl RigidSlip<T>, T, impl Marched<T>>,
        rolling: Rolling,
        flexibility: &ZoneFlexibility<T>,
        mut each: impl FnMut(usize, StripForce<T>),
    ) {
        let &LoadedZone { zone, strips, slip, .. } = loaded;
        let range = zone.range();
        let n = self.profile.len() as f64;
        let parabola = match self.bound {
            TractionBound::Elliptic => T::from(0.0),
            TractionBound::Parabolic => {
                let moment: T =
                    range.clone().map(|j| strips.width(j) * strips.half_length(j).powi(3)).sum();
                if moment > 0.0 { zone.load * 0.75 / moment } else { T::from(0.0) }
            }
        };
        let direction = rolling.direction();
        for start in range.clone().step_by(LANES) {
            let mut input = LaneInput::<T>::default();
            let lanes = (range.end - start).min(LANES);
            let mut areas = [T::from(0.0); LANES];
            for (lane, area) in areas.iter_mut().enumerate().take(lanes) {
                let j = start + lane;
                let a = strips.half_length(j);
                let step = a * 2.0 / n;
                let growth = slip.growth(j, flexibility);
                input.step_x[lane] = -step * growth.longitudinal;
                input.step_y[lane] = -step * growth.lateral;
                input.step_y_per_abscissa[lane] = -step * direction * a * growth.twist;
                input.bound[lane] = loaded.friction_coefficient(j)
                    * match self.bound {
                        TractionBound::Elliptic => strips.pressure(j),
                        TractionBound::Parabolic => parabola * a * a,
                    };
                *area = strips.width(j) * step;
            }
            let sums = input.march(lanes, self.elements());
            for (lane, area) in areas.into_iter().enumerate().take(lanes) {
                let j = start + lane;
                let arm = strips.half_length(j) * direction;
                each(
                    j,
                    StripForce {
                        longitudinal: area * sums.x[lane],
                        lateral: area * sums.y[lane],
                        moment: area * arm * sums.y_abscissa[lane],
                        slip_area: area * sums.slipping[lane],
                    },
                );
            }
        }
    }
}

impl<T: Real> Rule<T> for Fastsim {
    fn strip_forces(
        &self,
        loaded: &LoadedZone<'_, impl RigidSlip<T>, T>,
        rolling: Rolling,
        _: &ZoneFlexibility<T>,
        blended: &ZoneFlexibility<T>,
        each: impl FnMut(usize, StripForce<T>),
    ) {
        self.strip_forces(loaded, rolling, blended, each);
    }
}

impl Fastsim {
    /// Traction on the wheel of each element of strip `j` of a zone that rolls forward, leading
    /// edge first, and whether it slips; as in [`strip_forces`](Self::strip_forces).
    pub fn tractions(
        &self,
        loaded: &LoadedZone<'_, impl RigidSlip>,
        j: usize,
        flexibility: &ZoneFlexibility,
    ) -> Vec<([f64; 2], bool)> {
        let &LoadedZone { zone, strips, slip, .. } = loaded;
        let a = strips.half_length[j];
        let step = 2.0 * a / self.profile.len() as f64;
        let growth = slip.growth(j, flexibility);
        let bound = loaded.friction_coefficient(j) * self.bounding_pressure(zone, strips, j);
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

    /// The pressure p_n that bounds the traction at the centre of strip `j` [Pa].
    fn bounding_pressure(&self, zone: &Zone, strips: &Strips, j: usize) -> f64 {
        match self.bound {
            TractionBound::Elliptic => strips.pressure[j],
            TractionBound::Parabolic => {
                let range = zone.range();
                let moment: f64 =
                    range.map(|j| strips.width[j] * strips.half_length[j].powi(3)).sum();
                let square = strips.half_length[j].powi(2);
                if moment > 0.0 { 0.75 * zone.load * square / moment } else { 0.0 }
            }
        }
    }
}

/// Strips that can be marched through.
pub trait Marched<T> {
    /// Half length of strip `j` [m].
    fn half_length(&self, j: usize) -> T;

    /// Its width [m].
    fn width(&self, j: usize) -> T;

    /// Pressure at its centre [Pa].
    fn pressure(&self, j: usize) -> T;
}

/// Plain strips can be marched through with dual numbers for the creepage.
impl<S: Real + Into<T>, T: Real> Marched<T> for Strips<S> {
    #[inline]
    fn half_length(&self, j: usize) -> T {
        self.half_length[j].into()
    }

    #[inline]
    fn width(&self, j: usize) -> T {
        self.width[j].into()
    }

    #[inline]
    fn pressure(&self, j: usize) -> T {
        self.pressure[j].into()
    }
}
