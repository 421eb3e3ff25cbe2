//! The wheel for which a rail that varies is prepared.

use crate::geometry::curves::curve::Curve;
use crate::geometry::uneven::waviness::Waviness;
use crate::geometry::wheel::varying_wheel::VaryingWheel;

/// A wheel on a rail that varies.
#[derive(Clone, Debug)]
pub struct WheelAbove<'a> {
    /// Its profile; of one whose section varies around the first one.
    pub profile: &'a Curve,
    /// Radius of its nominal rolling circle [m].
    pub nominal_radius: f64,
    /// Deviations over the arc of that.
    pub waves: Waviness,
    /// The wheel, if its section varies around.
    pub around: Option<&'a VaryingWheel>,
}

impl WheelAbove<'_> {
    /// Sides of outlines within which its profile lies at any pitch, beside the profile itself.
    pub(super) fn sides(&self) -> impl Iterator<Item = [[f64; 2]; 2]> + Clone + '_ {
        self.around.into_iter().flat_map(VaryingWheel::sides)
    }
}
