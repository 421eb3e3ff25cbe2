//! What the models do that march through the strips of a zone: how tractions grow along a strip.

use super::flexibility::ZoneFlexibility;
use super::forces::StripForce;
use super::loaded_zone::LoadedZone;
use super::rolling::Rolling;

/// How tractions grow along a strip.
pub trait Rule<T> {
    /// Whether friction bounds them.
    const IS_BOUNDED: bool = true;

    /// Hands the force on the wheel of each strip of `loaded` to `each`. `three` are the
    /// flexibilities of the zone, one for each creepage, `blended` those that the march has.
    fn strip_forces(
        &self,
        loaded: &LoadedZone<'_, T>,
        rolling: Rolling,
        three: &ZoneFlexibility<T>,
        blended: &ZoneFlexibility<T>,
        each: impl FnMut(usize, StripForce<T>),
    );
}
