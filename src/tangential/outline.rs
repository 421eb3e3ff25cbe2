//! The outline of a zone, or of a lobe of it, and the equivalent ellipse: type and formulas of its
//! semi-axes a and b from second moments.
//!
//! For the flexibilities L1, L2 and L3 the moments are those of the outline, which [`Outline::of`]
//! sums. For the table of creep forces they are those of the load, which
//! [`equivalent_ellipse`](super::equivalent_ellipse) sums, together with the creepage and the
//! friction of that ellipse.

use super::neck::Extent;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// Semi-axes of an ellipse with the second moments of a zone, or of a part of it. For a Hertzian
/// pressure these are
///
/// ```text
/// of the load:     <x²> = a²/5,  <y²> = b²/5,  and of a semi-ellipse of half length x_l <x²> = x_l²/4
/// of the outline:  <x²> = a²/4,  <y²> = b²/4,  and of a strip of half length x_l <x²> = x_l²/3
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EquivalentEllipse<T = f64> {
    /// Along rolling, > 0 [m].
    pub along: T,
    /// Across, > 0 [m].
    pub across: T,
}

/// Greatest ratio of the semi-axes.
const MAX_RATIO: f64 = 1e6;

impl<T: Real> EquivalentEllipse<T> {
    /// From the means of x_l², of y² about the centroid and of the square of the strips' width over
    /// the load [m²].
    pub(super) fn of_load(along: T, across: T, within: T) -> Self {
        Self::of_moments(along * 1.25, across * 5.0, within * 5.0)
    }

    /// From a², b² and, with the factor of b², the mean square of the width of strips [m²], which
    /// counts where a single strip has no moment of its own.
    fn of_moments(along: T, across: T, within: T) -> Self {
        let along = along.sqrt();
        let across = across.max(within / 12.0).sqrt();
        Self { along, across: across.max(along / MAX_RATIO) }
    }

    /// c = sqrt(a b) [m].
    pub fn mean_radius(&self) -> T {
        (self.along * self.across).sqrt()
    }
}

/// What of the outline of a zone, or of a part of it, is in its flexibilities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline<T = f64> {
    /// The ellipse with its second moments.
    pub ellipse: EquivalentEllipse<T>,
    /// ∫ x_l² dy [m³].
    pub squares: T,
    /// ∫ x_l³ dy [m⁴].
    pub cubes: T,
}

impl<T: Real> Outline<T> {
    /// That of the strips of `zone` as far as they belong to `extent`; nothing where that has no
    /// area.
    pub fn of(zone: &Zone<T>, strips: &Strips<T>, extent: &Extent<T>) -> Option<Self> {
        let [mut area, mut squares, mut cubes] = [T::from(0.0); 3];
        let [mut first, mut across, mut within] = [T::from(0.0); 3];
        for j in zone.range() {
            let (half_length, width) = (strips.half_length[j], strips.width[j]);
            let weight = half_length * width * extent.member(strips.y[j]);
            let y = strips.y[j] - zone.y;
            area += weight;
            squares += weight * half_length;
            cubes += weight * half_length * half_length;
            first += weight * y;
            across += weight * y * y;
            within += weight * width * width;
        }
        (area > 0.0).then(|| {
            let [along, within] = [cubes / area, within / area];
            let across = across / area - (first / area).powi(2);
            let ellipse =
                EquivalentEllipse::of_moments(along * (4.0 / 3.0), across * 4.0, within * 4.0);
            Self { ellipse, squares, cubes }
        })
    }
}
