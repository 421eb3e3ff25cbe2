//! Numbers in which tangential problems are solved: plain ones, and ones with derivatives.

use super::boundary_element::LoadedElements;
use super::coupled_marches::MarchNumber;
use super::forces::StripForce;
use super::loaded_zone::LoadedZone;
use super::rolling::Rolling;
use crate::math::dual::Dual;
use crate::math::tape::Taped;
use crate::normal::{Strips, Zone};

/// Numbers with which tangential problems are solved; the half-space solution on elements is one of
/// plain numbers alone.
pub trait CreepNumber: MarchNumber {
    /// The elements of a zone for the half-space solution.
    fn elements(_: &Zone<Self>, _: &Strips<Self>, _: [usize; 2]) -> Option<LoadedElements> {
        None
    }

    /// Solves on the elements and hands the force of each strip to `each`; false where no solution
    /// was found.
    fn on_elements(
        _: &LoadedElements,
        _: &LoadedZone<'_, Self>,
        _: Rolling,
        _: &mut dyn FnMut(usize, StripForce<Self>),
    ) -> bool {
        false
    }
}

impl<const N: usize> CreepNumber for Dual<N> {}

impl CreepNumber for Taped {}

impl CreepNumber for f64 {
    fn elements(zone: &Zone, strips: &Strips, count: [usize; 2]) -> Option<LoadedElements> {
        Some(LoadedElements::of(zone, strips, count))
    }

    fn on_elements(
        elements: &LoadedElements,
        loaded: &LoadedZone<'_>,
        rolling: Rolling,
        each: &mut dyn FnMut(usize, StripForce),
    ) -> bool {
        let tractions = elements.tractions(loaded, rolling);
        if tractions.converged {
            elements.strip_forces(loaded.zone, loaded.strips, &tractions, each);
        }
        tractions.converged
    }
}
