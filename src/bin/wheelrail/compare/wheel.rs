//! A wheel on rails by its own models and by boundary elements.

use std::path::PathBuf;
use std::time::Instant;

use wheelrail::element::output::{Output, Patch};
use wheelrail::element::parameters::{NormalModel, Parameters, VerticalMode};
use wheelrail::element::{Element, Input};
use wheelrail::error::ContactError;
use wheelrail::variables::Values;

use super::compared::{Compared, Solved};
use super::reference::{half, reference_tangential};
use crate::models::is_slow;
use crate::remarks::Found;

/// Times a case is evaluated by fast models; the median is reported.
const REPEATS: usize = 5;
/// Share of the load to which boundary elements carry it.
const LOAD_ACCURACY: f64 = 1e-5;
/// Heights tried for that.
const MAX_HEIGHTS: usize = 30;

/// Both solutions of the case `values`; profile files are looked for in `folder`.
pub fn compare(values: &Values, folder: &PathBuf) -> Result<(Compared, Found), ContactError> {
    let Values { parameters, input, .. } = values;
    let folders = std::slice::from_ref(folder);
    let mut element = Element::new(parameters, input, folders)?;
    let mut own = Output::default();
    element.evaluate(input, &mut own)?;
    let found = Found::evaluated(&element, parameters, input, &own)
        .with_start(&element)
        .with_profiles(element.profile_remarks().to_vec());
    let repeats =
        if is_slow(parameters.normal_model, parameters.tangential_model) { 1 } else { REPEATS };
    let mut times = Vec::new();
    for _ in 0..repeats {
        let begin = Instant::now();
        element.evaluate(input, &mut own)?;
        times.push(begin.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    // A height is given to the reference even where a load is: its own search would go down to
    // rounding.
    let reference_parameters = Parameters {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: reference_tangential(parameters.tangential_model),
        vertical_mode: VerticalMode::Penetration,
        damping: if parameters.vertical_mode == VerticalMode::Load {
            0.0
        } else {
            parameters.damping
        },
        ..parameters.clone()
    };
    let mut element = Element::new(&reference_parameters, input, folders)?;
    let mut exact = Output::default();
    let mut at = *input;
    if parameters.vertical_mode == VerticalMode::Load {
        at.wheel.position[2] = carrying_height(&mut element, input, own.wheel_z)?;
    }
    let begin = Instant::now();
    element.evaluate(&at, &mut exact)?;
    let time = begin.elapsed().as_secs_f64();
    let turn = element.turn_of_normals();
    let coarse_parameters = Parameters {
        normal_elements: half(reference_parameters.normal_elements),
        ..reference_parameters
    };
    let mut rough = Output::default();
    Element::new(&coarse_parameters, input, folders)?.evaluate(&at, &mut rough)?;
    let place = centroid(&exact);
    // That of the deepest contact stands for all.
    let contacts = element.flat_contacts(&at)?;
    let deepest = contacts.iter().max_by(|a, b| a.penetration.total_cmp(&b.penetration));
    let (normal, repeats) = (normal(&exact), repeats as i32 + 1);
    let compared = Compared {
        own: Solved {
            fallback: own.fallback_count >= repeats,
            ..solved(&own, place, normal, times[times.len() / 2])
        },
        reference: solved(&exact, place, normal, time),
        coarse: solved(&rough, place, normal, 0.0),
        turn: Some(turn),
        residuals: Some([exact.normal_residual, exact.tangential_residual]),
        friction: deepest.map_or(input.friction, |contact| contact.friction),
    };
    Ok((compared, found))
}

/// The height at which boundary elements carry the load of `input`, from a height close to it [m].
fn carrying_height(element: &mut Element, input: &Input, near: f64) -> Result<f64, ContactError> {
    let load = input.wheel_load;
    let touching = element.touching_height(input);
    if load <= 0.0 || near <= touching {
        return Ok(near);
    }
    let mut output = Output::default();
    // Force^(2/3) is nearly straight in the penetration.
    let bent = |force: f64| force.max(0.0).powf(2.0 / 3.0);
    let goal = bent(load);
    let (mut low, mut high) = ([touching, -goal], None::<[f64; 2]>);
    let mut z = near;
    for _ in 0..MAX_HEIGHTS {
        let mut at = *input;
        at.wheel.position[2] = z;
        element.evaluate(&at, &mut output)?;
        let force: f64 = output.rails.iter().map(|rail| rail.force[2]).sum();
        if (force - load).abs() <= LOAD_ACCURACY * load {
            break;
        }
        let missing = [z, bent(force) - goal];
        if missing[1] < 0.0 {
            low = missing;
        } else {
            high = Some(missing);
        }
        z = match high {
            Some(high) => low[0] - low[1] * (high[0] - low[0]) / (high[1] - low[1]),
            None => {
                z + (1.1 * (z - touching) * (goal / bent(force).max(1e-9) - 1.0)).clamp(1e-6, 1e-4)
            }
        };
    }
    Ok(z)
}

fn loaded(output: &Output) -> impl Iterator<Item = &Patch> {
    output.patches.iter().filter(|patch| patch.normal_force > 0.0)
}

/// Lateral direction and normal of a patch in the track frame.
fn directions(patch: &Patch) -> [[f64; 3]; 2] {
    let (sine, cosine) = patch.contact_angle.sin_cos();
    [[0.0, cosine, sine], [0.0, -sine, cosine]]
}

/// Centroid of the load [m].
fn centroid(output: &Output) -> [f64; 3] {
    let load: f64 = loaded(output).map(|patch| patch.normal_force).sum();
    [0, 1, 2].map(|c| {
        let moment: f64 = loaded(output).map(|patch| patch.normal_force * patch.position[c]).sum();
        if load > 0.0 { moment / load } else { 0.0 }
    })
}

/// Normal of the heaviest patch.
fn normal(output: &Output) -> [f64; 3] {
    directions(&output.patches[0])[1]
}

fn solved(output: &Output, place: [f64; 3], normal: [f64; 3], time: f64) -> Solved {
    let mut result = Solved {
        patches: output.patch_count as usize,
        fallback: output.fallback_count > 0,
        time,
        ..Solved::default()
    };
    for patch in loaded(output) {
        result.normal_force += patch.normal_force;
        result.max_pressure = result.max_pressure.max(patch.max_pressure);
        result.area += patch.area;
        let [lateral, own_normal] = directions(patch);
        let [along, across] = patch.creep_force;
        let force = [along, across * lateral[1], across * lateral[2]];
        let arm = [0, 1, 2].map(|c| patch.position[c] - place[c]);
        let moment = [
            arm[1] * force[2] - arm[2] * force[1],
            arm[2] * force[0] - arm[0] * force[2],
            arm[0] * force[1] - arm[1] * force[0],
        ];
        for c in 0..3 {
            result.creep_force[c] += force[c];
            result.spin_moment += normal[c] * (moment[c] + patch.spin_moment * own_normal[c]);
        }
    }
    result
}
