//! The last step of a search, taken by all forces at once.
//!
//! Two poses that are nearly where a wheel is carried tell what all forces become a little further
//! on: as much as goes on of the vertical one goes on of each of them.

use super::output::{Output, Patch, Wrench};
use super::parameters::RAILS;
use crate::math::fixed_vec::FixedVec;
use crate::math::numbers::Numbers;

/// The forces of a pose.
#[derive(Clone, Debug)]
pub(super) struct PoseForces {
    wheel: Wrench,
    rails: [Wrench; RAILS],
    /// Dissipated energy per distance [J/m], and power [W].
    dissipated: [f64; 2],
    patches: FixedVec<Patch>,
}

impl PoseForces {
    /// None, with room for so many patches.
    pub fn new(patches: usize) -> Self {
        Self {
            wheel: Wrench::default(),
            rails: Default::default(),
            dissipated: [0.0; 2],
            patches: FixedVec::new(patches),
        }
    }

    /// Keeps the forces of a pose.
    pub fn keep(&mut self, output: &Output, patches: &[Patch]) {
        let &Output { wheel, rails, wear_number, frictional_power, .. } = output;
        (self.wheel, self.rails) = (wheel, rails);
        self.dissipated = [wear_number, frictional_power];
        self.patches.clear();
        self.patches.extend_from_slice(patches);
    }

    /// Lets forces go on by `part` of what they changed by from these to those of `output` and
    /// `patches`; false, and nothing changed, where the patches are not the same ones.
    pub fn go_on(&self, part: f64, output: &mut Output, patches: &mut [Patch]) -> bool {
        let both = || patches.iter().zip(self.patches.iter());
        let is_alike = patches.len() == self.patches.len()
            && both().all(|(now, before)| now.rail == before.rail);
        if !is_alike {
            return false;
        }
        let mut further = |now: f64, before: f64| now + part * (now - before);
        let Output { wheel, rails, wear_number, frictional_power, .. } = output;
        *wheel = wheel.each_with(&self.wheel, &mut further);
        *rails = rails.each_with(&self.rails, &mut further);
        for (number, before) in [wear_number, frictional_power].into_iter().zip(self.dissipated) {
            *number = further(*number, before);
        }
        for (patch, before) in patches.iter_mut().zip(self.patches.iter()) {
            let slip_share = patch.slip_share;
            *patch = Patch { slip_share, ..patch.each_with(before, &mut further) };
        }
        true
    }
}
