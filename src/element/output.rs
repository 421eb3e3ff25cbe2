//! What an evaluation gives.

use super::input::Input;
use super::parameters::foundation::TrackState;
use super::parameters::{Mirror, RAILS};
use crate::math::numbers::{Numbers, numbers};
use crate::math::real::Real;

/// Patches that are reported one by one; forces hold any number.
pub const REPORTED_PATCHES: usize = 8;

/// Force on a body and moment about its marker, in the track frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench<T = f64> {
    /// Force [N].
    pub force: [T; 3],
    /// Moment about the marker of the body [N m].
    pub moment: [T; 3],
}

/// One loaded zone; forces are those on the wheel.
///
/// With the contact angle γ, on both sides of the track, the axes of the contact frame are in the
/// track frame e = (1, 0, 0), t = (0, cos γ, sin γ) and n = (0, -sin γ, cos γ): along the track,
/// across in the contact plane, to the right, and into the rail. By them the patch acts on the wheel
/// with
///
/// ```text
/// F_x e + F_t t - N n       [F_x, F_t] = creep_force, N = normal_force
/// ```
///
/// With flat and kinematic creepage that is [`Output::wheel`]'s force, summed over the patches. With
/// curved creepage, the default, the tractions of each strip lie in its own tangent plane, so that
/// they have a resultant along n too, which `wheel` and `rails` have and no patch tells: on S1002
/// and 60E1 some thousandths of N on a gauge corner, more with Piotrowski and Kik, whose patches wrap
/// around it. On bodies uneven along the track n leans ahead, which γ does not tell either.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Patch<T = f64> {
    /// Number of the rail, 1 for `rail[1]`; 0 for no patch.
    pub rail: i32,
    /// Normal force, damping included, ≥ 0 [N].
    pub normal_force: T,
    /// Creep force on the wheel, `F_x` along the track, positive forward, and `F_t` along the lateral
    /// axis t of the contact frame [N].
    pub creep_force: [T; 2],
    /// Moment of the tractions on the wheel about the contact normal n, at the patch's position
    /// [N m].
    pub spin_moment: T,
    /// Roll of the contact frame about the track's x axis, negative on the right tread [rad].
    pub contact_angle: T,
    /// Centroid of the normal load in the track frame [m].
    pub position: [T; 3],
    /// Lateral coordinate of the centroid on the wheel profile, on both sides from the nominal
    /// rolling circle and positive towards the field side [m].
    pub wheel_y: T,
    /// Lateral coordinate of the centroid on the rail profile as it is given, neither inclined nor
    /// mirrored. It grows towards the field side on both sides of the track, and on a
    /// [`mirrored`](super::parameters::RailParameters::mirrored) rail, as a check rail is, towards
    /// the track centre [m].
    pub rail_y: T,
    /// Distance from the axle of the wheel's surface at the centroid of the load [m].
    pub rolling_radius: T,
    /// Overlap of the undeformed bodies along the contact normal [m].
    pub penetration: T,
    /// Greatest pressure [Pa].
    pub max_pressure: T,
    /// Greatest extent along x [m].
    pub length: T,
    /// Extent across [m].
    pub width: T,
    /// Area [m²].
    pub area: T,
    /// Longitudinal, lateral [-] and spin [1/m] creepage at the patch's position.
    pub creepage: [T; 3],
    /// Coefficient of friction as slip and heat leave it, the mean over the load, ≥ 0 [-].
    pub friction_coefficient: T,
    /// Mean rise of temperature over the pressure as if all of the zone slid, where friction
    /// depends on it; otherwise 0 [K].
    pub temperature: T,
    /// Share of the area that slips, 0 to 1 [-].
    pub slip_share: T,
    /// Power turned into heat [W].
    pub frictional_power: T,
    /// T-gamma damage of the rail by one passage, as a share of its life; negative where wear
    /// outruns cracks [-].
    pub tgamma_damage: T,
    /// Surface fatigue index: above 0 the surface ratchets [-].
    pub surface_fatigue_index: T,
}

/// What a body has lost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct BodyWear {
    /// Worn area of the cross section so far [m²].
    pub area: f64,
    /// Worn volume so far: of the whole circumference of a wheel, of the distance that a rail
    /// stands for [m³].
    pub volume: f64,
    /// Greatest depth of the profile in use [m].
    pub depth: f64,
}

/// Where the rails of a side are on their foundation, in their frame; pairs are lateral and
/// vertical, down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Deflection<T = f64> {
    /// Deflection from where they rest without a wheel, which the inputs of the rails come on top
    /// of [m].
    pub deflection: [T; 2],
    /// Velocity; 0 for rails without mass [m/s].
    pub velocity: [T; 2],
    /// Estimated error that the last step left in the deflection of rails with a mass, ≥ 0 [m].
    pub step_error: f64,
}

impl From<TrackState> for Deflection {
    fn from(state: TrackState) -> Self {
        let TrackState { deflection, velocity, step_error } = state;
        Self { deflection, velocity, step_error }
    }
}

/// All outputs; one field for each FMU output of `docs/variables.csv`, but for those of hosts that
/// step. Forces are in the track frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Output<T = f64> {
    /// On the wheel, about the wheel marker.
    pub wheel: Wrench<T>,
    /// On each rail, about the rail marker.
    pub rails: [Wrench<T>; RAILS],
    /// Height of the wheel marker: the one found if the load is given, else that of the input [m].
    pub wheel_z: T,
    /// Vertical force that all rails together carry, down: the load, where that is given and the
    /// rails can carry it [N].
    pub load_carried: T,
    /// Where the rails are on their foundation.
    pub foundation: Deflection<T>,
    /// Number of loaded zones found.
    pub patch_count: i32,
    /// How often a solver fell back to a simpler model since initialisation.
    pub fallback_count: i32,
    /// Largest distance left between surfaces that carry pressure, or overlap left elsewhere, over
    /// the greatest overlap, of boundary elements, and of strips at their nodes before the last
    /// Newton step; 0 for other models [-].
    pub normal_residual: T,
    /// Largest slip of boundary elements that contradicts the friction law, over the largest rigid
    /// slip; 0 for other models [-].
    pub tangential_residual: T,
    /// Dissipated energy per distance, spin included [J/m].
    pub wear_number: T,
    /// Power turned into heat [W].
    pub frictional_power: T,
    /// The heaviest patches, heaviest first.
    pub patches: [Patch<T>; REPORTED_PATCHES],
    /// Wear of the wheel.
    pub wheel_wear: BodyWear,
    /// Wear of each rail.
    pub rail_wear: [BodyWear; RAILS],
}

impl<T: Real> Output<T> {
    /// The patches that there are, heaviest first; no more than [`REPORTED_PATCHES`] of them.
    pub fn patches(&self) -> impl Iterator<Item = &Patch<T>> {
        self.patches.iter().take_while(|patch| patch.rail > 0)
    }

    /// Back to nothing, in place: most of it are patches.
    #[inline]
    pub(crate) fn clear(&mut self) {
        let Self { wheel, rails, wheel_z, load_carried, patch_count, fallback_count, .. } = self;
        *wheel = Wrench::default();
        *rails = [Wrench::default(); RAILS];
        (*wheel_z, *load_carried) = (T::default(), T::default());
        (*patch_count, *fallback_count) = (0, 0);
        self.foundation = Deflection::default();
        let Self { normal_residual, tangential_residual, .. } = self;
        (*normal_residual, *tangential_residual) = (T::default(), T::default());
        let Self { wear_number, frictional_power, patches, wheel_wear, rail_wear, .. } = self;
        (*wear_number, *frictional_power) = (T::default(), T::default());
        patches.fill(Patch::default());
        *wheel_wear = BodyWear::default();
        *rail_wear = [BodyWear::default(); RAILS];
    }

    /// The same in other numbers, each one made by `turn` from the own one; counts and wear, which
    /// have no derivatives, are left out.
    pub fn each<S: Default>(&self, mut turn: impl FnMut(T) -> S) -> Output<S> {
        Numbers::each(self, &mut turn)
    }

    /// The height of the wheel in `input`, the load that its rails carry there, and the heaviest of
    /// its `patches`, which get into that order.
    pub(super) fn report(&mut self, input: &Input<T>, patches: &mut [Patch<T>]) {
        self.wheel_z = input.wheel.position[2];
        self.load_carried = T::from(0.0) - self.wheel.force[2];
        heaviest_first(patches);
        for (slot, patch) in self.patches.iter_mut().zip(patches) {
            *slot = *patch;
        }
    }
}

numbers!(Wrench: force, moment);
numbers!(Deflection: deflection, velocity; ..Deflection::default());
numbers!(
    Patch: normal_force, creep_force, spin_moment, contact_angle, position, wheel_y, rail_y,
    rolling_radius, penetration, max_pressure, length, width, area, creepage, friction_coefficient,
    temperature, slip_share, frictional_power, tgamma_damage, surface_fatigue_index; kept rail
);
numbers!(
    Output: wheel, rails, wheel_z, load_carried, foundation, normal_residual, tangential_residual,
    wear_number, frictional_power, patches; ..Output::default()
);

/// The patch with the greatest normal force, if there is one.
pub(super) fn heaviest(patches: &[Patch]) -> Option<&Patch> {
    patches.iter().max_by(|a, b| a.normal_force.total_cmp(&b.normal_force))
}

/// Sorts patches.
pub(super) fn heaviest_first<T: Real>(patches: &mut [Patch<T>]) {
    patches.sort_unstable_by(|a, b| b.normal_force.value().total_cmp(&a.normal_force.value()));
}

/// Profile coordinates stay those of the right side.
impl<T: Real> Mirror for Output<T> {
    fn mirrored(&self) -> Self {
        Self {
            wheel: self.wheel.mirrored(),
            rails: self.rails.map(|rail| rail.mirrored()),
            foundation: self.foundation.mirrored(),
            patches: self.patches.map(|patch| patch.mirrored()),
            ..*self
        }
    }
}

impl<T: Real> Deflection<T> {
    fn mirrored(&self) -> Self {
        let ([y, z], [vy, vz]) = (self.deflection, self.velocity);
        Self { deflection: [-y, z], velocity: [-vy, vz], ..*self }
    }
}

impl<T: Real> Wrench<T> {
    fn mirrored(&self) -> Self {
        let ([fx, fy, fz], [mx, my, mz]) = (self.force, self.moment);
        Self { force: [fx, -fy, fz], moment: [-mx, my, -mz] }
    }
}

impl<T: Real> Patch<T> {
    fn mirrored(&self) -> Self {
        let [x, y, z] = self.position;
        let [longitudinal, lateral, spin] = self.creepage;
        Self {
            creep_force: [self.creep_force[0], -self.creep_force[1]],
            spin_moment: -self.spin_moment,
            contact_angle: -self.contact_angle,
            position: [x, -y, z],
            creepage: [longitudinal, -lateral, -spin],
            ..*self
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::element::parameters::{CreepageModel, Side};
    use crate::element::{Element, Parameters};

    /// Force on the wheel beyond those of its one patch along e, t and n, over the normal force [-].
    fn beyond(side: Side, creepage_model: CreepageModel) -> [f64; 3] {
        let parameters = Parameters { side, creepage_model, ..Parameters::default() };
        let (mut input, mut output) = (Input::default(), Output::default());
        input.wheel.position[1] = 0.7566;
        (input.wheel.velocity[0], input.wheel.pitch_rate) = (20.0, -20.0 / 0.46);
        input.wheel.yaw = 3e-3;
        let mut input = side.mirror(input);
        let mut element = Element::new(&parameters, &input, &[]).unwrap();
        input.wheel.position[2] = element.nominal_wheel_z() + 1e-4;
        element.evaluate(&input, &mut output).unwrap();
        assert_eq!(output.patch_count, 1);
        let Patch { contact_angle, creep_force: [along, across], normal_force, .. } =
            output.patches[0];
        let (sine, cosine) = contact_angle.sin_cos();
        let [x, y, z] = output.wheel.force;
        let beyond =
            [x - along, y * cosine + z * sine - across, z * cosine - y * sine + normal_force];
        beyond.map(|force| force / normal_force)
    }

    /// Sum of a patch over the force on the wheel: rounding of a few terms [-].
    const ROUNDING: f64 = 1e-13;

    #[test]
    fn the_force_on_the_wheel_is_that_of_its_patch_but_for_curved_tractions_along_the_normal() {
        for side in [Side::Right, Side::Left] {
            for creepage in [CreepageModel::Flat, CreepageModel::Curved] {
                let [x, t, n] = beyond(side, creepage);
                assert_abs_diff_eq!(x, 0.0, epsilon = ROUNDING);
                assert_abs_diff_eq!(t, 0.0, epsilon = ROUNDING);
                if creepage == CreepageModel::Flat {
                    assert_abs_diff_eq!(n, 0.0, epsilon = ROUNDING);
                } else {
                    assert!((1e-3..3e-3).contains(&n.abs()), "{n}");
                }
            }
        }
    }
}
