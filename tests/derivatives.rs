//! Derivatives of the outputs by the inputs against central differences, at random poses and by model.

mod common;
mod tolerance;

use common::random::Random;
use common::wheel::{element, evaluate, mirrored, pressed, random_input};
use common::{median_and_worst, write_report};
use wheelrail::element::input::{INPUT_NAMES, INPUTS};
use wheelrail::element::parameters::{
    CreepageModel, Flexibilities, NormalModel, ShapeFit, Side, TangentialModel, TractionBound,
    VerticalMode,
};
use wheelrail::element::{Element, Input, Output, Parameters};

/// Poses of each model.
const POSES: usize = 12;

/// Half of the distance over which differences are taken: short against what forces change over, long against rounding.
fn step(name: &str) -> f64 {
    match name {
        "wheel.load" => 10.0,
        "friction.coefficient" => 5e-6,
        "wheel.yaw" => 1e-5,
        "wheel.z" | "rail[1].z" | "rail[2].z" => 3e-7,
        _ if name.ends_with("_rate") => 1e-4,
        _ if name.contains(".v") => 5e-5,
        _ => 3e-6,
    }
}

/// Numbers of an output that have derivatives, in groups of one unit.
fn groups(output: &Output) -> Vec<Vec<f64>> {
    let mut forces = output.wheel.force.to_vec();
    let mut moments = output.wheel.moment.to_vec();
    for rail in &output.rails {
        forces.extend(rail.force);
        moments.extend(rail.moment);
    }
    let mut groups = vec![
        forces,
        moments,
        vec![output.wheel_z],
        vec![output.wear_number],
        vec![output.frictional_power],
    ];
    for patch in &output.patches {
        groups.extend([
            vec![patch.normal_force, patch.creep_force[0], patch.creep_force[1]],
            vec![patch.spin_moment],
            vec![patch.contact_angle],
            patch.position.to_vec(),
            vec![patch.wheel_y, patch.rail_y],
            vec![patch.rolling_radius],
            vec![patch.penetration],
            vec![patch.max_pressure],
            vec![patch.length, patch.width],
            vec![patch.area],
            patch.creepage[..2].to_vec(),
            vec![patch.creepage[2]],
            vec![patch.frictional_power],
            vec![patch.surface_fatigue_index],
        ]);
    }
    groups
}

/// Errors of one model against differences.
#[derive(Default)]
struct Errors {
    /// Of derivatives that differences resolve.
    relative: Vec<f64>,
    /// Derivatives that they do not resolve: a kink lies within them, or they are lost in rounding.
    unresolved: usize,
}

/// Names of the groups.
fn worst_names() -> Vec<String> {
    let own = ["force", "moment", "wheel_z", "wear_number", "power"];
    let patch = [
        "forces", "spin_moment", "angle", "position", "profile_y", "radius", "penetration",
        "pressure", "length_width", "area", "creepage", "spin", "power", "fatigue",
    ];
    let mut names: Vec<String> = own.map(String::from).to_vec();
    for k in 1..=8 {
        names.extend(patch.map(|name| format!("patch[{k}].{name}")));
    }
    names
}

/// Adds the errors of the Jacobian at `input`.
fn compare(element: &mut Element, input: &Input, noise: f64, errors: &mut Errors) {
    let mut columns = [Output::default(); INPUTS];
    if let Err(e) = element.jacobian(input, &mut columns) { println!("{e} {input:?}"); return }
    let at = input.to_array();
    let output = evaluate(element, input);
    let (names, values, by_height) = (worst_names(), groups(&output), groups(&columns[2]));
    for (i, column) in columns.iter().enumerate() {
        // Values at these shares of the step to either side, in two steps.
        let mut around = |step: f64| {
            let places = [-1.0, -0.5, 0.5, 1.0].map(|share| {
                let mut moved = at;
                moved[i] += share * step;
                let found = evaluate(element, &Input::from_array(moved));
                (found.patch_count == output.patch_count).then(|| (groups(&found), moved[i] - at[i]))
            });
            let [Some(a), Some(b), Some(c), Some(d)] = places else { return None };
            Some((step, [a, b, c, d]))
        };
        let step = step(INPUT_NAMES[i]);
        let steps = [around(step), around(0.1 * step)];
        for (g, own) in groups(column).iter().enumerate() {
            // Of creepages all is rounding that is rounding of velocities.
            let size = if names[g].ends_with("creepage") { 1.0 } else { largest(&values[g]) };
            for k in 0..own.len() {
                let slope = steps.iter().flatten().find_map(|(step, places)| {
                    let rounding = noise * (1e-7 * size + 3e-10 * largest(&by_height[g])) / step;
                    let scale = largest(own).max(rounding);
                    // From the left and from the right, each extrapolated from whole and half of the step.
                    let to = |n: usize| (places[n].0[g][k] - values[g][k]) / places[n].1;
                    let [left, right] = [2.0 * to(1) - to(0), 2.0 * to(2) - to(3)];
                    let central = |a: usize, b: usize| {
                        (places[b].0[g][k] - places[a].0[g][k]) / (places[b].1 - places[a].1)
                    };
                    let slope = (4.0 * central(1, 2) - central(0, 3)) / 3.0;
                    let is_resolved = (left - right).abs() <= RESOLVED * scale;
                    is_resolved.then_some([slope, scale])
                });
                let Some([slope, scale]) = slope else {
                    errors.unresolved += 1;
                    continue;
                };
                if slope != 0.0 || own[k] != 0.0 {
                    let error = (own[k] - slope).abs() / scale;
                    if std::env::var("SHOW").is_ok() && error > 1e-6 {
                            println!("{} by {}: {error:.1e} {:e} {slope:e} {scale:e} ", names[g], INPUT_NAMES[i], own[k]);
                    }
                    errors.relative.push(error);
                }
            }
        }
    }
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most: f64, number| most.max(number.abs()))
}

/// Share of a derivative to which two estimates from differences have to agree for it to count as resolved.
const RESOLVED: f64 = 1e-6;

/// Random poses of a right and of a left wheel; median and worst error.
fn judge(name: &str, parameters: &Parameters) -> String {
    // The height that carries a load is found to 1e-11 of it.
    let noise = if parameters.vertical_mode == VerticalMode::Load { 100.0 } else { 1.0 };
    let mut errors = Errors::default();
    for side in [Side::Right, Side::Left] {
        let parameters = Parameters { side, ..parameters.clone() };
        let right = Parameters { side: Side::Right, ..parameters.clone() };
        let (mut right, mut own) = (element(&right), element(&parameters));
        let mut random = Random::new(11);
        for _ in 0..POSES {
            let mut input = random_input(&mut right, &mut random);
            input.wheel_load = random.within(1e4, 1.2e5);
            let input = if side == Side::Left { mirrored(&input) } else { input };
            compare(&mut own, &input, noise, &mut errors);
        }
    }
    let Errors { relative, unresolved } = errors;
    let count = relative.len();
    assert!(count > 100, "{name}: {unresolved} unresolved");
    let [median, worst] = median_and_worst(relative);
    let line = format!("{name},{median:.1e},{worst:.1e},{count},{unresolved}");
    println!("{line}");
    line
}

#[test]
fn all() {
    let default = Parameters { damping: 1e5, ..Parameters::default() };
    for normal_model in [NormalModel::Hertz, NormalModel::PiotrowskiKik, NormalModel::PiotrowskiKikCorrected] {
        let parameters = Parameters { normal_model, tangential_model: TangentialModel::Fastsim, ..default.clone() };
        judge(&format!("{normal_model:?}"), &parameters);
    }
    for tangential_model in [TangentialModel::None, TangentialModel::Linear, TangentialModel::Fastrip, TangentialModel::Tables, TangentialModel::FastsimCorrected] {
        let parameters = Parameters { tangential_model, ..default.clone() };
        judge(&format!("{tangential_model:?}"), &parameters);
    }
    for creepage_model in [CreepageModel::Kinematic, CreepageModel::Curved] {
        let parameters = Parameters { creepage_model, ..default.clone() };
        judge(&format!("{creepage_model:?}"), &parameters);
    }
    let mut parameters = default.clone();
    parameters.vertical_mode = VerticalMode::Load;
    judge("load", &parameters);
    let _ = (pressed, write_report, Flexibilities::Three, ShapeFit::Paper, TractionBound::Parabolic);
}
