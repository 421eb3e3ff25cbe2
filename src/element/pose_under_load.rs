//! A pose of a wheel whose load is sought: its forces, and what its normal model tells of the way
//! down from there.

use super::balance::{Carried, Placed};
use super::input::Input;
use super::output::{Output, Patch, heaviest};
use super::wheel_on_rails::Element;
use crate::normal::{Descent, Pose, way_between};

/// Vertical force of the normal forces of `patches` [N].
pub(super) fn normal_force_down(patches: &[Patch]) -> f64 {
    patches.iter().map(|patch| patch.normal_force * patch.contact_angle.cos()).sum()
}

impl Element {
    /// Forces at the height of `input` (right side), whose load is sought, or, by the normal model,
    /// after the way down to the normal force of what is known `about` them; nothing where it is not
    /// one rail that presses, or not the deeper the more.
    pub(super) fn press(
        &mut self,
        about: &Carried,
        pose: Pose,
        input: &Input,
        output: &mut Output,
    ) -> Option<Placed> {
        let by_strips = self.models.strip_solver.is_some();
        self.models.descent = by_strips.then(|| Descent::to(about.normal).at(pose));
        let left_out = self.forces(input, output);
        let descent = self.models.descent.take();
        let [_, lateral, vertical] = output.wheel.force;
        let patches = &self.models.patches;
        let heaviest = heaviest(patches)?;
        let (z, slope) = (input.wheel.position[2], heaviest.contact_angle.tan());
        let (carried, aside) = (-vertical, lateral / vertical);
        if carried.is_nan() || carried <= 0.0 {
            return None;
        }
        let (load, vertical) = (input.wheel_load, carried);
        if let Some(descent) = descent {
            let Descent { way, resting, reached: normal, stiffness, growth, rails, .. } = descent;
            let is_known = rails == 1 && stiffness > 0.0;
            return is_known.then_some(Placed {
                z,
                way,
                resting,
                normal,
                vertical,
                carried: carried * growth,
                is_lowered: true,
                aside,
                stiffness,
                slope,
                left_out,
            });
        }
        let resting = normal_force_down(patches);
        let normal = resting * load / carried;
        let stiffness = about.stiffness * (resting / about.normal).cbrt();
        (!by_strips && resting > 0.0 && normal > 0.0).then_some(Placed {
            z,
            way: way_between(resting, stiffness, normal),
            resting,
            normal,
            vertical,
            carried: load,
            is_lowered: false,
            aside,
            stiffness: about.stiffness * (normal / about.normal).cbrt(),
            slope,
            left_out,
        })
    }
}
