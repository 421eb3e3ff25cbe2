//! Correction of the shape of the contact area: ratio of length to width as of a Hertzian ellipse.
//!
//! Source: Piotrowski and Kik, Vehicle System Dynamics 46 (2008) 27-48, section 2.4. Virtual
//! penetration of a Hertzian pair gives an area of ratio L/W = sqrt(B/A) of the curvatures, the
//! ellipse has another one. With the length L and the width W of the interpenetration region
//!
//! ```text
//! Lc/Wc = β(L/W),  Lc Wc = L W                                   (14), (15), (16)
//! y' = y Wc/W about the contact point,  Rc = Lc²/(8 δ0)          (17), (18)
//! ```
//!
//! **Several zones.** L is the length at the contact point and W the sum of the widths of all
//! zones: what the gaps between them take away is not contact. The loaded parts are stretched,
//! outwards from the contact point, and the gaps keep their width. A zone that appears begins with
//! no width and two zones that merge keep their sum, so that the correction, and the force, is
//! continuous there; with the distance of the outermost edges for W, or with a ratio for each zone,
//! it would jump.

use super::hertz::axis_ratio;
use super::{Strips, Zone};
use crate::geometry::contacts::separation::FrameSeparation;
use crate::math::quadrature::GaussLegendre;
use crate::math::real::Real;

/// How the corrected ratio follows from that of the interpenetration region.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum ShapeFit {
    /// The ratio of the semi-axes of the Hertzian ellipse; smooth where length and width are equal.
    #[default]
    Hertz,
    /// The paper's fit, up to 5 % off Hertz for slender areas; where length and width are equal the
    /// ratio jumps by 0.6 %.
    Paper,
}

/// Ratios beyond are corrected as these [-].
const RATIOS: [f64; 2] = [1e-3, 1e3];

impl ShapeFit {
    /// Corrected ratio β of length to width from the `ratio` L/W > 0 of the interpenetration region
    /// [-].
    pub fn corrected_ratio<T: Real>(self, ratio: T) -> T {
        let ratio = ratio.within(RATIOS[0], RATIOS[1]);
        let is_long = ratio >= 1.0;
        // A/B ≤ 1 of the paper, and how many times longer one axis is than the other.
        let curvatures = if is_long { ratio.powi(-2) } else { ratio * ratio };
        let elongation = match self {
            Self::Hertz => axis_ratio(T::from(1.0) / curvatures).0,
            Self::Paper => {
                let polynomial = curvatures * (curvatures * -0.1053 + 0.5837);
                T::from(1.0) / (polynomial + curvatures.sqrt() * 0.5184)
            }
        };
        if is_long { elongation } else { T::from(1.0) / elongation }
    }
}

/// Corrects the zones of `strips`, whose pressures are not yet scaled, from the length L of the
/// interpenetration region [m]; returns Lc/L.
pub fn apply<T: Real>(
    fit: ShapeFit,
    length: T,
    rule: &GaussLegendre,
    separation: &mut impl FrameSeparation<T>,
    strips: &mut Strips<T>,
) -> T {
    let width: T = strips.zones.iter().map(|zone| zone.width).sum();
    if width <= 0.0 || length <= 0.0 {
        return T::from(1.0);
    }
    let ratio = length / width;
    let shortening = (fit.corrected_ratio(ratio) / ratio).sqrt();
    let stretch = T::from(1.0) / shortening;
    // Loaded width between the contact point and the zone under way, before it is stretched.
    let (mut to_the_right, mut to_the_left) = (T::from(0.0), T::from(0.0));
    let count = strips.zones.len();
    for index in 0..count {
        let [left, right] = edges(&strips.zones[index], strips, rule);
        if right > 0.0 {
            let anchor = left.at_least(0.0);
            to_the_left += anchor - left;
            stretch_zone(index, stretch, to_the_right - anchor, rule, separation, strips);
            to_the_right += right - anchor;
        }
    }
    for index in (0..count).rev() {
        let [left, right] = edges(&strips.zones[index], strips, rule);
        if right <= 0.0 {
            stretch_zone(index, stretch, -to_the_left - right, rule, separation, strips);
            to_the_left += right - left;
        }
    }
    shortening
}

/// Left and right edge of a zone [m]: from the outermost strips, a few micrometres away, they are
/// reached along the tangent.
fn edges<T: Real>(zone: &Zone<T>, strips: &Strips<T>, rule: &GaussLegendre) -> [T; 2] {
    let last = zone.count - 1;
    [(0, -1.0), (last, 1.0)].map(|(i, end)| {
        let j = zone.first + i;
        strips.y[j] + strips.width[j] * (end - rule.nodes[i]) / rule.weights[i]
    })
}

/// Least derivative of y along the line that is believed in: zones some nanometres wide have no
/// better one than rounding.
const MIN_SLOPE: f64 = 0.1;

/// Moves the strips of a zone from y to y + (`stretch` - 1)(y + `offset`) and shortens them as much
/// as they get wider.
fn stretch_zone<T: Real>(
    index: usize,
    stretch: T,
    offset: T,
    rule: &GaussLegendre,
    separation: &mut impl FrameSeparation<T>,
    strips: &mut Strips<T>,
) {
    let Zone { first, count, width, length, .. } = strips.zones[index];
    let half_range =
        (strips.u[first + count - 1] - strips.u[first]) / (rule.nodes[count - 1] - rule.nodes[0]);
    for i in 0..count {
        let j = first + i;
        let shift = (stretch - 1.0) * (strips.y[j] + offset);
        // Along the tangent: what is left is half the curvature times the square of the shift.
        let dy = (strips.width[j] / (half_range * rule.weights[i])).at_least(MIN_SLOPE);
        strips.u[j] += shift / dy;
        strips.x[j] = separation.centre_at(strips.u[j]);
        strips.y[j] += shift;
        strips.width[j] *= stretch;
        strips.half_length[j] /= stretch;
        strips.pressure[j] /= stretch;
    }
    strips.zones[index].width = stretch * width;
    strips.zones[index].length = length / stretch;
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_round_area_stays_and_the_ratio_of_the_inverse_is_the_inverse() {
        assert_relative_eq!(ShapeFit::Hertz.corrected_ratio(1.0), 1.0, max_relative = 1e-12);
        for fit in [ShapeFit::Hertz, ShapeFit::Paper] {
            for ratio in [1.1, 2.0, 7.0, 80.0] {
                let product = fit.corrected_ratio(ratio) * fit.corrected_ratio(1.0 / ratio);
                assert_relative_eq!(product, 1.0, max_relative = 1e-12);
            }
        }
    }

    #[test]
    fn the_ratio_is_smooth_where_length_and_width_are_equal() {
        // d ln β/d ln (L/W) of a nearly round Hertzian ellipse is 4/3.
        for ratio in [1.0 - 1e-5, 1.0 + 1e-5] {
            let slope = ShapeFit::Hertz.corrected_ratio(ratio).ln() / ratio.ln();
            assert_relative_eq!(slope, 4.0 / 3.0, max_relative = 1e-4);
        }
        let [below, above] =
            [1.0 - 1e-9, 1.0 + 1e-9].map(|ratio| ShapeFit::Paper.corrected_ratio(ratio));
        assert_relative_eq!(above / below, 1.0064, max_relative = 1e-3);
    }

    #[test]
    fn the_fit_of_the_paper_is_within_five_percent_of_hertz_down_to_a_hundredth() {
        let mut worst: f64 = 0.0;
        for i in 0..=100 {
            let ratio = 10f64.powf(0.01 * f64::from(i));
            let [hertz, paper] =
                [ShapeFit::Hertz, ShapeFit::Paper].map(|fit| fit.corrected_ratio(ratio));
            worst = worst.max((paper / hertz - 1.0).abs());
        }
        assert!(worst > 0.03 && worst < 0.06, "{worst}");
    }

    #[test]
    fn ratios_without_bound_stay_finite() {
        for ratio in [1e-300, 1e300] {
            let corrected = ShapeFit::Hertz.corrected_ratio(ratio);
            assert!(corrected.is_finite() && corrected > 0.0);
        }
    }
}
