//! The remarks on an evaluation: the one list that the C interface, Python and the command line
//! tell from.

use super::input::Input;
use super::output::{Output, Patch};
use super::parameters::{FrictionDistribution, Motion, Parameters, TangentialModel, VerticalMode};
use super::remark::Remark;
use super::subject::Subject;
use super::vertical_load::is_carried;
use super::wheel_on_rails::Element;
use crate::friction::MAX_FRICTION;
use crate::geometry::profiles::profile::Profile;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::math::real::Real;
use crate::normal::NormalModel;

/// Slip from which on a wheel counts as sliding, far beyond where creep forces are full and what a
/// driven or braked wheel is led at [-].
const SLIDING: f64 = 0.25;
/// Distance of the centroid of a patch from the end of a profile, over the width of the patch, below
/// which the patch counts as cut off [-].
const AT_THE_END: f64 = 0.6;
/// Distance beyond which even a wide patch is not at the end of a profile [m].
const FAR_FROM_THE_END: f64 = 6e-3;
/// Penetration from which on it is looked whether the wheel is inside a rail [m].
const LOOKS_INSIDE: f64 = 1e-3;
/// Yaw from which on it is looked whether a force begins with a jump [rad]: measured worn wheels
/// were found to do so from 0.035 on, new ones from 0.05.
const LOOKS_OVER_THE_SIDE: f64 = 0.03;

/// What is odd about the evaluation of `input` that gave `output`: the number of the element and the
/// remark; of a kind no more than one for each element. Allocates nothing.
///
/// ```
/// use wheelrail::element::{Element, Input, Output, Parameters, remarks};
///
/// let (parameters, mut input) = (Parameters::default(), Input::default());
/// let mut element = Element::new(&parameters, &input, &[])?;
/// input.wheel.position[2] = element.nominal_wheel_z() + 1e-4;
/// // Without a pitch rate the wheel is locked.
/// input.wheel.velocity[0] = 20.0;
/// let mut output = Output::default();
/// element.evaluate(&input, &mut output)?;
/// let mut told = Vec::new();
/// remarks(&element, &parameters, &input, &output, |_, remark| {
///     told.push(remark.message("").to_string());
/// });
/// assert!(told[0].starts_with("the wheel slides on rail[1] with a slip of 100 %"));
/// # Ok::<(), wheelrail::error::ContactError>(())
/// ```
pub fn remarks<S: Subject>(
    subject: &S,
    parameters: &S::Parameters,
    input: &S::Input,
    output: &S::Output,
    mut tell: impl FnMut(usize, Remark),
) {
    let own = S::parameters_of_elements(parameters);
    for (k, (element, own)) in subject.elements().iter().zip(own).enumerate() {
        if let Some(depth) = element.sunk() {
            tell(k, Remark::Sunk { depth });
        }
        if own.vertical_mode == VerticalMode::Load {
            let [load, carried] = S::load_and_carried(k, input, output);
            if !is_carried(load, carried) {
                tell(k, Remark::LoadMissed { load, carried });
            }
        }
        let whole = output;
        let output = S::output_of_element(k, output);
        if output.patches[0].rail == 0 {
            continue;
        }
        let at = || subject.input_of_element(k, input, whole);
        if let Some(unlike) = element.unlike_materials(own, &output.patches[0]) {
            tell(k, unlike);
        }
        if let Some(slides) = element.slides(output, || at().wheel.velocity[0]) {
            tell(k, slides);
        }
        let Patch { rail, friction_coefficient: coefficient, .. } = output.patches[0];
        if coefficient > MAX_FRICTION {
            tell(k, Remark::Friction { rail: rail as usize, coefficient });
        }
        element.profile_ends(output, at, &mut |remark| tell(k, remark));
    }
}

/// What is odd about where a row of a table has the wheels, after its evaluation: as of a place in
/// which a run starts. Looks closer only where there is no contact, or a deep one.
pub fn place_remark<S: Subject>(
    subject: &mut S,
    parameters: &S::Parameters,
    input: &S::Input,
    output: &S::Output,
    mut tell: impl FnMut(usize, Remark),
) {
    for k in 0..S::PREFIXES.len() {
        let patch = &S::output_of_element(k, output).patches[0];
        let is_loaded =
            S::parameters_of_elements(parameters)[k].vertical_mode == VerticalMode::Load;
        // A load that is not carried, and a wheel that is sunk, are told as such.
        if is_loaded || subject.elements()[k].sunk().is_some() {
            continue;
        }
        let at = subject.input_of_element(k, input, output);
        let is_shallow = patch.rail > 0 && patch.penetration < LOOKS_INSIDE;
        if is_shallow && at.wheel.yaw.abs() < LOOKS_OVER_THE_SIDE {
            continue;
        }
        let element = &mut subject.elements_mut()[k];
        if patch.rail == 0 && !element.is_far_from_rails(&at) {
            continue;
        }
        if let Some(place) = element.odd_place(&at) {
            tell(k, Remark::Place(place));
        }
    }
}

/// The remark on an input that is given, by its FMI name without the side of a wheelset, if it has no
/// effect with these parameters.
pub fn without_effect(parameters: &Parameters, name: &str) -> Option<Remark> {
    let friction = |wanted: FrictionDistribution| {
        let distribution = parameters.friction_distribution;
        (distribution != wanted).then_some((
            "friction.distribution",
            name_of_distribution(distribution),
            name_of_distribution(wanted),
        ))
    };
    let vertical = |wanted: VerticalMode| {
        let mode = parameters.vertical_mode;
        (mode != wanted).then_some(("vertical.mode", name_of_mode(mode), name_of_mode(wanted)))
    };
    let turned = (parameters.motion != Motion::Given).then_some(("motion", "rolling", "given"));
    let inputs = [
        ("wheel.pitch_rate", turned),
        ("wheelset.pitch_rate", turned),
        ("wheel.load", vertical(VerticalMode::Load)),
        ("wheel.z", vertical(VerticalMode::Penetration)),
        ("wheelset.z", vertical(VerticalMode::Penetration)),
        ("wheelset.roll", vertical(VerticalMode::Penetration)),
        ("friction.coefficient", friction(FrictionDistribution::Uniform)),
        ("friction.tread.coefficient", friction(FrictionDistribution::Regions)),
        ("friction.gauge_face.coefficient", friction(FrictionDistribution::Regions)),
    ];
    let (input, found) = inputs.into_iter().find(|(input, _)| *input == name)?;
    let (parameter, chosen, with) = found?;
    Some(Remark::NoEffect { input, parameter, chosen, with })
}

impl Element {
    /// Whether a wheel without contact is beside all its rails or farther above them than any
    /// bounce, by bounds.
    fn is_far_from_rails(&self, input: &Input) -> bool {
        let input = self.side.mirror(*input);
        self.height_near_touch(&input) - input.wheel.position[2] > super::start::FAR_ABOVE
    }

    /// Whether the materials of wheel and rails are so unlike that creep forces are off, as the models
    /// leave that out or the solver did not settle.
    fn unlike_materials(&self, parameters: &Parameters, patch: &Patch) -> Option<Remark> {
        let (material, is_coupled) = (&self.models.material, self.models.is_coupled());
        if is_coupled && !self.models.is_uncoupled {
            return None;
        }
        let has_friction = parameters.tangential_model != TangentialModel::None
            && patch.friction_coefficient > 0.0;
        (has_friction && material.is_unlike()).then_some(Remark::UnlikeMaterials {
            coupling: material.coupling,
            did_not_settle: is_coupled,
        })
    }

    /// Whether the heaviest patch slides all over with a slip that no rolling wheel has.
    fn slides(&self, output: &Output, speed: impl FnOnce() -> f64) -> Option<Remark> {
        let patch = &output.patches[0];
        // Creepage refers to the mean of the two speeds.
        let creepage = patch.creepage[0].abs();
        let slip = 2.0 * creepage / (2.0 + creepage);
        // Without friction nothing comes of it.
        if slip < SLIDING || patch.frictional_power <= 0.0 {
            return None;
        }
        let rail = patch.rail as usize;
        let turns = self.rails[rail - 1].as_ref().is_some_and(|own| own.rail.roller_radius() > 0.0);
        let rolling = (!turns).then(|| -speed() / patch.rolling_radius);
        Some(Remark::Slides { rail, slip: slip.min(1.0), rolling })
    }

    /// Patches that the end of a profile cuts off.
    fn profile_ends(
        &self,
        output: &Output,
        input: impl Fn() -> Input,
        tell: &mut impl FnMut(Remark),
    ) {
        let mut told = [false; 2];
        for patch in output.patches() {
            let rail = patch.rail as usize;
            let Some(contact) = &self.rails[rail - 1] else { continue };
            let found = [
                self.end_of_wheel(&contact.wheel, patch),
                Self::end_of_rail(&contact.rail, patch, || input().rails[rail - 1].z),
            ];
            for (of_rail, y) in found.into_iter().enumerate() {
                if let Some(y) = y.filter(|_| !std::mem::replace(&mut told[of_rail], true)) {
                    let is_reference = self.models.normal == NormalModel::BoundaryElement;
                    let (of_rail, pressure) = (of_rail == 1, patch.max_pressure);
                    tell(Remark::ProfileEnd { rail, of_rail, y, pressure, is_reference });
                }
            }
        }
    }

    /// Where the wheel's profile ends under the patch, if it does [m].
    fn end_of_wheel(&self, wheel: &Profile, patch: &Patch) -> Option<f64> {
        let at = [patch.wheel_y, patch.rolling_radius - self.nominal_radius];
        let curve = &wheel.curve;
        let ends = [curve.start(), curve.end()].map(|s| curve.at(s).point);
        ends.into_iter().find(|end| is_near(*end, at, patch.width)).map(|end| end[0])
    }

    /// Where the rail's profile ends under the patch, if it does, with its marker raised by `raised`
    /// [m].
    fn end_of_rail(rail: &PlacedRail, patch: &Patch, raised: impl FnOnce() -> f64) -> Option<f64> {
        if rail.varies_along_track() {
            return None;
        }
        let curve = rail.curve();
        // As wide as it is across, a patch on a steep face is narrow.
        let reach = reach(patch.width);
        let across_reach = reach * patch.contact_angle.cos().abs();
        let ends = [curve.start(), curve.end()].map(|s| curve.at(s).point);
        let across = |end: [f64; 2]| rail.profile_point(end)[0];
        let end =
            ends.into_iter().find(|end| (across(*end) - patch.rail_y).abs() < across_reach)?;
        // The underside of a head ends below the gauge corner.
        let height = end[1] + rail.marker[1] + raised();
        ((height - patch.position[2]).abs() < reach).then(|| across(end))
    }
}

fn name_of_mode(mode: VerticalMode) -> &'static str {
    match mode {
        VerticalMode::Penetration => "penetration",
        VerticalMode::Load => "load",
    }
}

fn name_of_distribution(distribution: FrictionDistribution) -> &'static str {
    match distribution {
        FrictionDistribution::Uniform => "uniform",
        FrictionDistribution::Regions => "regions",
        FrictionDistribution::Profile => "profile",
    }
}

fn is_near(end: [f64; 2], at: [f64; 2], width: f64) -> bool {
    (end[0] - at[0]).hypotenuse(end[1] - at[1]) < reach(width)
}

/// Distance of the end of a profile below which it cuts off a patch of that width [m].
fn reach(width: f64) -> f64 {
    (AT_THE_END * width).min(FAR_FROM_THE_END)
}
