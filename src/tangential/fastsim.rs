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
//!
//! The step from one element to the next stands twice: forces come from
//! [`Fastsim::strip_forces`], which takes many strips at once (`march_strips`, and with derivatives
//! `march_with_slopes`); [`Fastsim::tractions`] serves pictures and tables of the traction.

use multiversion::multiversion;

use super::flexibility::ZoneFlexibility;
use super::rigid_slip::RigidSlip;
use super::rule::Rule;
use super::{LoadedZone, Rolling, StripForce};
use crate::math::dual::Dual;
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

/// Strips that are marched through together, that is integrated along from their leading edges.
const LANES: usize = 32;
type Lanes<T> = [T; LANES];

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
    #[must_use]
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

    /// Hands the force of each strip of `loaded` on the wheel to `each`.
    pub fn strip_forces<T: Marching>(
        &self,
        loaded: &LoadedZone<'_, impl RigidSlip<T>, T, impl Marched<T>>,
        rolling: Rolling,
        flexibility: &ZoneFlexibility<T>,
        mut each: impl FnMut(usize, StripForce<T>),
    ) {
        let &LoadedZone { zone, strips, slip, .. } = loaded;
        let range = zone.first..zone.first + zone.count;
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
            let mut march = March::<T>::default();
            let lanes = (range.end - start).min(LANES);
            let mut areas = [T::from(0.0); LANES];
            for (lane, area) in areas.iter_mut().enumerate().take(lanes) {
                let j = start + lane;
                let a = strips.half_length(j);
                let step = a * 2.0 / n;
                let growth = slip.growth(j, flexibility);
                march.step_x[lane] = -step * growth.longitudinal;
                march.step_y[lane] = -step * growth.lateral;
                march.step_y_per_abscissa[lane] = -step * direction * a * growth.twist;
                march.bound[lane] = loaded.friction_coefficient(j)
                    * match self.bound {
                        TractionBound::Elliptic => strips.pressure(j),
                        TractionBound::Parabolic => parabola * a * a,
                    };
                *area = strips.width(j) * step;
            }
            let sums = T::march(&march, lanes, &self.profile, &self.abscissae);
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

impl<T: Marching> Rule<T> for Fastsim {
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
    #[must_use]
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
        let mut p = [0.0; 2];
        let elements = self.profile.iter().zip(&self.abscissae).enumerate();
        elements
            .map(|(k, (profile, [_, abscissa]))| {
                let length = if k == 0 { 0.5 * step } else { step };
                p[0] -= length * growth.longitudinal;
                p[1] -= length * (growth.lateral + abscissa * a * growth.twist);
                let ratio = bound * profile / p[0].hypot(p[1]);
                if ratio < 1.0 {
                    p = p.map(|p| p * ratio);
                }
                (p, ratio < 1.0)
            })
            .collect()
    }

    /// The pressure p_n that bounds the traction at the centre of strip `j` [Pa].
    fn bounding_pressure(&self, zone: &Zone, strips: &Strips, j: usize) -> f64 {
        match self.bound {
            TractionBound::Elliptic => strips.pressure[j],
            TractionBound::Parabolic => {
                let range = zone.first..zone.first + zone.count;
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

/// What the march of up to `LANES` strips needs: traction increments per element and the bounds μ
/// p_n at the centres of the strips [Pa].
#[derive(Clone, Copy, Debug, Default)]
pub struct March<T> {
    step_x: Lanes<T>,
    step_y: Lanes<T>,
    step_y_per_abscissa: Lanes<T>,
    bound: Lanes<T>,
}

/// Sums over the elements of each strip.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums<T> {
    x: Lanes<T>,
    y: Lanes<T>,
    y_abscissa: Lanes<T>,
    slipping: Lanes<f64>,
}

/// Numbers with which strips are marched.
pub trait Marching: Real {
    /// Marches the strips of the first `lanes` lanes at once.
    fn march(
        march: &March<Self>,
        lanes: usize,
        profile: &[f64],
        abscissae: &[[f64; 2]],
    ) -> Sums<Self>;
}

impl Marching for f64 {
    #[inline]
    fn march(
        march: &March<f64>,
        lanes: usize,
        profile: &[f64],
        abscissae: &[[f64; 2]],
    ) -> Sums<f64> {
        march_strips(march, lanes, profile, abscissae)
    }
}

impl<const N: usize> Marching for Dual<N> {
    /// All that a strip depends on are four numbers, so that four derivatives do for any number of
    /// directions.
    fn march(march: &March<Self>, _: usize, profile: &[f64], abscissae: &[[f64; 2]]) -> Sums<Self> {
        let value = |lanes: &Lanes<Self>| lanes.map(Self::value);
        let values = March {
            step_x: value(&march.step_x),
            step_y: value(&march.step_y),
            step_y_per_abscissa: value(&march.step_y_per_abscissa),
            bound: value(&march.bound),
        };
        let (sums, slopes) = march_with_slopes(&values, profile, abscissae);
        let moving = |sum: f64, slopes: &[Lanes<f64>; 4], lane: usize| {
            let own = [
                &march.step_x[lane],
                &march.step_y[lane],
                &march.step_y_per_abscissa[lane],
                &march.bound[lane],
            ];
            let mut number = Self::from(sum);
            for (own, slopes) in own.into_iter().zip(slopes) {
                for (slope, direction) in number.slopes.iter_mut().zip(own.slopes) {
                    *slope += slopes[lane] * direction;
                }
            }
            number
        };
        Sums {
            x: std::array::from_fn(|lane| moving(sums.x[lane], &slopes[0], lane)),
            y: std::array::from_fn(|lane| moving(sums.y[lane], &slopes[1], lane)),
            y_abscissa: std::array::from_fn(|lane| moving(sums.y_abscissa[lane], &slopes[2], lane)),
            slipping: sums.slipping,
        }
    }
}

/// Marches the strips of the first `lanes` lanes at once.
///
/// Compiled for several instruction sets, the widest one chosen at run time. No operation is fused
/// or reordered, so that all of them give the same bits.
#[multiversion(targets("x86_64+avx512f", "x86_64+avx2", "aarch64+neon"))]
fn march_strips(
    march: &March<f64>,
    lanes: usize,
    profile: &[f64],
    abscissae: &[[f64; 2]],
) -> Sums<f64> {
    let mut sums = Sums::default();
    match lanes {
        0..=8 => march_lanes::<8>(march, profile, abscissae, &mut sums),
        9..=16 => march_lanes::<16>(march, profile, abscissae, &mut sums),
        _ => march_lanes::<LANES>(march, profile, abscissae, &mut sums),
    }
    sums
}

/// Marches the first `N` lanes and adds to their `sums`.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
fn march_lanes<const N: usize>(
    march: &March<f64>,
    profile: &[f64],
    abscissae: &[[f64; 2]],
    sums: &mut Sums<f64>,
) {
    let (mut px, mut py) = ([0.0; N], [0.0; N]);
    // The first element's middle is half a step behind the leading edge.
    let mut length = 0.5;
    for (bound, [abscissa, step_abscissa]) in profile.iter().zip(abscissae) {
        for lane in 0..N {
            let trial_x = px[lane] + length * march.step_x[lane];
            let trial_y = py[lane]
                + length * (march.step_y[lane] + step_abscissa * march.step_y_per_abscissa[lane]);
            let magnitude = (trial_x * trial_x + trial_y * trial_y).sqrt();
            let ratio = march.bound[lane] * bound / magnitude;
            // 0/0 of an idle lane is not a number, and `min` then takes the one.
            let scale = ratio.min(1.0);
            px[lane] = trial_x * scale;
            py[lane] = trial_y * scale;
            sums.x[lane] += px[lane];
            sums.y[lane] += py[lane];
            sums.y_abscissa[lane] += abscissa * py[lane];
            sums.slipping[lane] += if scale < 1.0 { 1.0 } else { 0.0 };
        }
        length = 1.0;
    }
}

/// As [`march_strips`], with the derivatives of the sums x, y and y times abscissa by the four
/// numbers of each lane, in their order.
#[multiversion(targets("x86_64+avx512f", "x86_64+avx2", "aarch64+neon"))]
fn march_with_slopes(
    march: &March<f64>,
    profile: &[f64],
    abscissae: &[[f64; 2]],
) -> (Sums<f64>, [[Lanes<f64>; 4]; 3]) {
    let mut sums = Sums::default();
    let mut slopes = [[[0.0; LANES]; 4]; 3];
    let (mut px, mut py) = ([0.0; LANES], [0.0; LANES]);
    let (mut px_by, mut py_by) = ([[0.0; LANES]; 4], [[0.0; LANES]; 4]);
    let mut length = 0.5;
    for (bound, [abscissa, step_abscissa]) in profile.iter().zip(abscissae) {
        // Of the trial tractions, and of the bound.
        let x_by = [length, 0.0, 0.0, 0.0];
        let y_by = [0.0, length, length * step_abscissa, 0.0];
        let bound_by = [0.0, 0.0, 0.0, *bound];
        let (mut scales, mut per_square, mut per_size) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        let (mut tx, mut ty) = ([0.0; LANES], [0.0; LANES]);
        for lane in 0..LANES {
            let trial_x = px[lane] + length * march.step_x[lane];
            let trial_y = py[lane]
                + length * (march.step_y[lane] + step_abscissa * march.step_y_per_abscissa[lane]);
            let square = trial_x * trial_x + trial_y * trial_y;
            let magnitude = square.sqrt();
            let ratio = march.bound[lane] * bound / magnitude;
            let scale = ratio.min(1.0);
            let slips = if scale < 1.0 { 1.0 } else { 0.0 };
            (tx[lane], ty[lane], scales[lane]) = (trial_x, trial_y, scale);
            // Of the scale by bound and by the square of the magnitude; nothing where the element
            // adheres.
            per_size[lane] = if scale < 1.0 { 1.0 / magnitude } else { 0.0 };
            per_square[lane] = if scale < 1.0 { -ratio / square } else { 0.0 };
            px[lane] = trial_x * scale;
            py[lane] = trial_y * scale;
            sums.x[lane] += px[lane];
            sums.y[lane] += py[lane];
            sums.y_abscissa[lane] += abscissa * py[lane];
            sums.slipping[lane] += slips;
        }
        for k in 0..4 {
            let (px_by, py_by) = (&mut px_by[k], &mut py_by[k]);
            for lane in 0..LANES {
                let (dx, dy) = (px_by[lane] + x_by[k], py_by[lane] + y_by[k]);
                let scale_by = bound_by[k] * per_size[lane]
                    + per_square[lane] * (tx[lane] * dx + ty[lane] * dy);
                px_by[lane] = dx * scales[lane] + tx[lane] * scale_by;
                py_by[lane] = dy * scales[lane] + ty[lane] * scale_by;
                slopes[0][k][lane] += px_by[lane];
                slopes[1][k][lane] += py_by[lane];
                slopes[2][k][lane] += abscissa * py_by[lane];
            }
        }
        length = 1.0;
    }
    (sums, slopes)
}
