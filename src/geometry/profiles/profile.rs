//! A wheel or rail profile: a named curve in its own frame.

use crate::geometry::curves::curve::Curve;
pub use crate::geometry::profiles::profile_error::ProfileError;
pub use crate::geometry::profiles::profile_kind::ProfileKind;
pub use crate::geometry::profiles::profile_remark::ProfileRemark;

/// A right-side profile: y to the field side, z down [m]; the curve runs from the flange back
/// (the gauge side of a rail) to the field side.
#[derive(Clone, Debug)]
pub struct Profile {
    /// Built-in name or file, for messages.
    pub name: String,
    /// Of which body.
    pub kind: ProfileKind,
    /// The curve in the profile frame [m].
    pub curve: Curve,
    /// What was found and mended in its file.
    pub remarks: Vec<ProfileRemark>,
}

/// Smallest rectangle along the axes of the profile frame that holds a profile.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Bounds {
    /// Smallest and largest y [m].
    pub y: [f64; 2],
    /// Smallest and largest z [m].
    pub z: [f64; 2],
}

impl Profile {
    /// Exact bounds of the curve, from its knots and the turning points between them.
    pub fn bounds(&self) -> Bounds {
        let mut bounds =
            Bounds { y: [f64::INFINITY, f64::NEG_INFINITY], z: [f64::INFINITY, f64::NEG_INFINITY] };
        self.visit_extremes(|_, point| {
            for (range, value) in [(&mut bounds.y, point[0]), (&mut bounds.z, point[1])] {
                *range = [range[0].min(value), range[1].max(value)];
            }
        });
        bounds
    }

    /// Points (y, z) of the profile, by which its surface is displaced: those of its file but for
    /// what was mended and smoothed, of formulas points that are as dense [m].
    pub fn points(&self) -> Vec<[f64; 2]> {
        self.curve.knots().map(|s| self.curve.at(s).point).collect()
    }

    /// The profile with each of its [`points`](Self::points) displaced along the normal of the
    /// surface, out of the body where the displacement is positive (wear is negative), and a smooth
    /// surface in between: displacements are natural cubic splines along the profile [m].
    ///
    /// # Panics
    /// With another number of displacements than points.
    pub fn displaced(&self, displacements: &[f64]) -> Self {
        let curve = self.curve.displaced(displacements, self.kind.outside());
        Self { curve, ..self.clone() }
    }

    /// Parameter of the highest point (smallest z) of the profile, the first of several [m].
    pub fn highest(&self) -> f64 {
        let mut best = (self.curve.start(), f64::INFINITY);
        self.visit_extremes(|s, point| {
            if point[1] < best.1 {
                best = (s, point[1]);
            }
        });
        best.0
    }

    /// Calls with every knot and every point at which y or z turns.
    fn visit_extremes(&self, mut visit: impl FnMut(f64, [f64; 2])) {
        let knots: Vec<f64> = self.curve.knots().collect();
        for pair in knots.windows(2) {
            let (start, end) = (self.curve.at(pair[0]), self.curve.at(pair[1]));
            visit(pair[0], start.point);
            let h = pair[1] - pair[0];
            for i in 0..2 {
                // The derivative is d + c u + e u² over the piece.
                let (d, c) = (start.first[i], start.second[i]);
                let e = (end.first[i] - d - c * h) / (h * h);
                for u in quadratic_roots(e, c, d) {
                    if u > 0.0 && u < h {
                        visit(pair[0] + u, self.curve.at(pair[0] + u).point);
                    }
                }
            }
        }
        visit(self.curve.end(), self.curve.at(self.curve.end()).point);
    }
}

/// Real roots of `a u² + b u + c`; what is not there is NaN or infinite.
fn quadratic_roots(a: f64, b: f64, c: f64) -> [f64; 2] {
    let q = -0.5 * (b + b.signum() * (b * b - 4.0 * a * c).sqrt());
    [q / a, c / q]
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::geometry::curves::curve_sections::{arc, curve_of};

    #[test]
    fn bounds_reach_the_turning_points_between_knots() {
        let section = arc([0.0, 0.3], 0.3, -1.9, -1.1);
        let profile = Profile {
            name: "arc".into(),
            kind: ProfileKind::Rail,
            curve: curve_of(&[section]),
            remarks: Vec::new(),
        };
        let bounds = profile.bounds();
        assert_relative_eq!(bounds.z[0], 0.0, epsilon = 1e-11);
        assert_relative_eq!(bounds.z[1], 0.3 - 0.3 * 1.1f64.sin(), epsilon = 1e-11);
        assert_relative_eq!(bounds.y[0], 0.3 * 1.9f64.cos(), epsilon = 1e-11);
        assert_relative_eq!(bounds.y[1], 0.3 * 1.1f64.cos(), epsilon = 1e-11);
        let top = profile.curve.at(profile.highest());
        assert_relative_eq!(top.point[0], 0.0, epsilon = 1e-9);
        assert_relative_eq!(top.first[1], 0.0, epsilon = 1e-8);
    }
}
