//! Derivatives of the outputs by the inputs against central differences, at random poses and by model.
//!
//! Differences cannot resolve everything. Left out are those with a kink within their step, where the slopes to the left and to the right
//! differ, and errors are taken over no less than rounding leaves: see `Differences`.

mod common;
mod tolerance;

use common::random::Random;
use common::wheel::{element, evaluate, mirrored, pressed, random_input, rolling};
use common::{median_and_worst, write_report};
use wheelrail::element::input::{INPUT_NAMES, INPUTS};
use wheelrail::element::parameters::{
    CreepageModel, Flexibilities, NormalModel, ShapeFit, Side, TangentialModel, TractionBound,
    VerticalMode,
};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::wheelset::{self, Wheelset};

/// Random poses of each model, of a right wheel and of a left one.
const POSES: usize = 8;
/// Difference of the slopes to either side, over the slope, up to which there is no kink.
const SMOOTH: f64 = 1e-7;
/// Most derivatives that differences may leave open.
const MOST_OPEN: f64 = 0.1;

/// Greatest of the distances over which differences are taken: short against what forces change over, long against rounding.
fn step(name: &str) -> f64 {
    match name {
        "wheel.load" => 10.0,
        "friction.coefficient" => 5e-6,
        "wheel.yaw" => 1e-4,
        "wheel.z" | "rail[1].z" | "rail[2].z" => 3e-7,
        _ if name.ends_with("_rate") => 1e-4,
        _ if name.contains(".v") => 5e-5,
        _ => 3e-6,
    }
}

/// Numbers of one unit, and the size to which they are rounded if that is more than they are.
type Group = (f64, Vec<f64>);

/// The numbers of an output that have derivatives but for shares of slip, which FASTSIM counts in elements.
fn groups(output: &Output) -> Vec<Group> {
    let (mut forces, mut moments) = (output.wheel.force.to_vec(), output.wheel.moment.to_vec());
    for rail in &output.rails {
        forces.extend(rail.force);
        moments.extend(rail.moment);
    }
    let totals = [forces, moments, vec![output.wear_number], vec![output.frictional_power]];
    let mut groups = totals.map(|group| (0.0, group)).to_vec();
    // Coordinates are added to half a metre.
    groups.push((0.5, vec![output.wheel_z]));
    for patch in &output.patches {
        groups.extend([
            (0.0, vec![patch.normal_force, patch.creep_force[0], patch.creep_force[1]]),
            // Of creep forces some millimetres apart.
            (100.0, vec![patch.spin_moment]),
            (0.0, vec![patch.contact_angle]),
            (0.5, patch.position.to_vec()),
            (0.0, vec![patch.wheel_y, patch.rail_y]),
            (0.0, vec![patch.rolling_radius]),
            (0.0, vec![patch.penetration]),
            (0.0, vec![patch.max_pressure]),
            (0.0, vec![patch.length, patch.width]),
            (0.0, vec![patch.area]),
            // Differences of speeds over the speed.
            (1.0, patch.creepage[..2].to_vec()),
            (0.0, vec![patch.creepage[2]]),
            (0.0, vec![patch.frictional_power]),
            // What T-gamma is above 15 N, of which rounding is that of 15 N.
            (15.0 * 10e-6 / 50.0, vec![patch.tgamma_damage]),
            (0.0, vec![patch.surface_fatigue_index]),
        ]);
    }
    groups
}

/// Errors of one model against differences.
#[derive(Default)]
struct Errors {
    /// Of derivatives that differences resolve.
    relative: Vec<f64>,
    /// Number of derivatives that they leave open.
    open: usize,
}

/// Outputs at whole and half of a step to either side of an input, if there are as many patches as there.
struct Differences {
    step: f64,
    /// Distance and output.
    places: [(f64, Vec<Group>); 4],
}

impl Differences {
    fn new(element: &mut Element, input: &Input, i: usize, step: f64) -> Option<Self> {
        let at = input.to_array();
        let patches = evaluate(element, input).patch_count;
        let mut place = |share: f64| {
            let mut moved = at;
            moved[i] += share * step;
            let found = evaluate(element, &Input::from_array(moved));
            (found.patch_count == patches).then(|| (moved[i] - at[i], groups(&found)))
        };
        Some(Self { step, places: [place(-1.0)?, place(-0.5)?, place(0.5)?, place(1.0)?] })
    }

    /// Derivative of number `k` of group `g`, whose value is `value`; nothing where the slopes to both sides differ by more than `most`.
    fn slope(&self, g: usize, k: usize, value: f64, most: f64) -> Option<f64> {
        let at = |n: usize| self.places[n].1[g].1[k];
        let to = |n: usize| (at(n) - value) / self.places[n].0;
        // Extrapolated from whole and half of the step: what is left is of second order to one side, of fourth to both.
        let [left, right] = [2.0 * to(1) - to(0), 2.0 * to(2) - to(3)];
        let both = |a: usize, b: usize| (at(b) - at(a)) / (self.places[b].0 - self.places[a].0);
        ((left - right).abs() <= most).then(|| (4.0 * both(1, 2) - both(0, 3)) / 3.0)
    }
}

/// Adds the errors of the Jacobian at `input`; `noise` is that of the outputs over rounding.
fn compare(element: &mut Element, input: &Input, noise: f64, errors: &mut Errors) {
    let mut columns = Vec::new();
    element.jacobian(input, &mut columns).unwrap();
    let values = groups(&evaluate(element, input));
    let by_height = groups(&columns[2]);
    for (i, column) in columns.iter().enumerate() {
        let step = step(INPUT_NAMES[i]);
        let differences =
            [step, 0.1 * step, 0.01 * step].map(|step| Differences::new(element, input, i, step));
        for (g, (_, own)) in groups(column).iter().enumerate() {
            let size = values[g].0.max(largest(&values[g].1));
            for (k, &rate) in own.iter().enumerate() {
                let smooth = differences.each_ref().map(|d| {
                    let d = d.as_ref()?;
                    // 1e-12 of the size, and what 1e-15 m of height do.
                    let rounding = 1e-6 * size + 1e-9 * largest(&by_height[g].1);
                    let scale = largest(own).max(noise * rounding / d.step);
                    let slope = d.slope(g, k, values[g].1[k], SMOOTH * scale)?;
                    Some([slope, scale])
                });
                // Kinks to both sides may hide each other, but not from a shorter step.
                let found = (0..smooth.len()).find_map(|n| {
                    let [slope, scale] = smooth[n]?;
                    let agree = match smooth.get(n + 1) {
                        Some(Some([near, scale])) => (slope - near).abs() <= 2.0 * SMOOTH * scale,
                        Some(None) => false,
                        None => true,
                    };
                    agree.then(|| (slope, (rate - slope).abs() / scale))
                });
                match found {
                    Some((slope, error)) if slope != 0.0 || rate != 0.0 => {
                        errors.relative.push(error);
                    }
                    Some(_) => {}
                    None => errors.open += 1,
                }
            }
        }
    }
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most: f64, number| most.max(number.abs()))
}

/// Judges the Jacobian at random poses of a right and of a left wheel, and at those of `more` besides.
fn judge(name: &str, parameters: &Parameters, more: &[Input]) {
    // The height that carries a load is found to 1e-11 of it.
    let noise = if parameters.vertical_mode == VerticalMode::Load { 100.0 } else { 1.0 };
    let mut errors = Errors::default();
    for side in [Side::Right, Side::Left] {
        let [mut right, mut own] =
            [Side::Right, side].map(|side| element(&Parameters { side, ..parameters.clone() }));
        let mut random = Random::new(11);
        let mut random_pose = || {
            let mut input = random_input(&mut right, &mut random);
            input.wheel_load = random.within(1e4, 1.2e5);
            input
        };
        // Strips take their time without optimisation.
        let is_strips = parameters.normal_model == NormalModel::Strips;
        let count = if is_strips { POSES / 4 } else { POSES };
        let random_poses: Vec<Input> = (0..count).map(|_| random_pose()).collect();
        for input in random_poses.iter().chain(more) {
            let input = if side == Side::Left { mirrored(input) } else { *input };
            compare(&mut own, &input, noise, &mut errors);
        }
    }
    let Errors { relative, open } = errors;
    let count = relative.len();
    let share = open as f64 / (count + open) as f64;
    let [median, worst] = median_and_worst(relative);
    let line = format!("{name},{count},{median:.1e},{worst:.1e},{open}\n");
    println!("{line}");
    write_report(&format!("derivatives_{name}.csv"), &line);
    let most_open = if noise > 1.0 { 2.0 * MOST_OPEN } else { MOST_OPEN };
    assert!(count > 1000 && share < most_open, "{name}: {open} open of {count}");
    assert!(worst < tolerance::DERIVATIVES, "{name}: {worst:e}");
}

fn default() -> Parameters {
    Parameters { damping: 1e5, ..Parameters::default() }
}

#[test]
fn of_normal_models() {
    for (name, normal_model) in [
        ("hertz", NormalModel::Hertz),
        ("piotrowski_kik", NormalModel::PiotrowskiKik),
        ("piotrowski_kik_corrected", NormalModel::PiotrowskiKikCorrected),
    ] {
        judge(name, &Parameters { normal_model, ..default() }, &[]);
    }
}

#[test]
fn of_strips() {
    let normal_model = NormalModel::Strips;
    let strips = Parameters { normal_model, strips: 15, elements_along: 15, ..default() };
    judge("strips", &strips, &[]);
    let tangential_model = TangentialModel::Tables;
    let creepage_model = CreepageModel::Curved;
    judge("strips_tables", &Parameters { tangential_model, creepage_model, ..strips }, &[]);
}

#[test]
fn of_the_simpler_tangential_models() {
    for (name, tangential_model) in [
        ("none", TangentialModel::None),
        ("linear", TangentialModel::Linear),
        ("fastrip", TangentialModel::Fastrip),
    ] {
        judge(name, &Parameters { tangential_model, ..default() }, &[]);
    }
}

#[test]
fn of_tabulated_forces() {
    for (name, tangential_model) in [
        ("tables", TangentialModel::Tables),
        ("fastsim_corrected", TangentialModel::FastsimCorrected),
    ] {
        judge(name, &Parameters { tangential_model, ..default() }, &[]);
    }
}

#[test]
fn of_creepage_models() {
    for (name, creepage_model) in
        [("kinematic", CreepageModel::Kinematic), ("curved", CreepageModel::Curved)]
    {
        judge(name, &Parameters { creepage_model, ..default() }, &[]);
    }
    let tangential_model = TangentialModel::FastsimCorrected;
    let creepage_model = CreepageModel::Curved;
    judge("curved_corrected", &Parameters { creepage_model, tangential_model, ..default() }, &[]);
}

#[test]
fn of_other_options() {
    let mut parameters = default();
    parameters.friction_law.falling_share = 0.4;
    parameters.friction_law.falling_decay = 0.6;
    parameters.friction_law.reduction = 0.5;
    parameters.friction_law.reduction_share = 0.3;
    parameters.friction_law.reduction_decay = 0.6;
    judge("friction_law", &parameters, &[]);
    parameters.tangential_model = TangentialModel::Tables;
    judge("friction_law_tables", &parameters, &[]);
    parameters = Parameters {
        bound: TractionBound::Parabolic,
        flexibilities: Flexibilities::Three,
        shape_fit: ShapeFit::Paper,
        normal_model: NormalModel::PiotrowskiKikCorrected,
        ..default()
    };
    judge("paper", &parameters, &[]);
}

#[test]
fn of_a_given_load() {
    let parameters = Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() };
    judge("load", &parameters, &[]);
}

#[test]
fn of_several_patches_and_two_rails() {
    let mut parameters = default();
    parameters.rails[1].enabled = true;
    parameters.rails[1].inclination = 0.0;
    // A second head under the outer part of the tread.
    parameters.second_rail.position = [0.81, 0.0];
    let mut element = element(&parameters);
    let mut inputs = Vec::new();
    let mut patches = [0; 2];
    for (shift, yaw, depth) in [
        (-3e-3, 1e-3, 1.0e-4),
        (0.0, 1e-3, 4e-5),
        (5.35e-3, 1e-3, 1e-4),
        (5.4e-3, 8e-3, 1.3e-4),
        (2e-3, -4e-3, 1.5e-4),
    ] {
        let mut input = rolling(shift, 20.0);
        input.wheel.yaw = yaw;
        input.wheel.velocity[1] = 0.02;
        // The second head takes part of the load.
        input.rails[1].z = 2e-3;
        let touching = pressed(&mut element, &input, 0.0).wheel.position[2];
        input.rails[1].z = -0.2;
        let second = pressed(&mut element, &input, 0.0).wheel.position[2] + 0.2;
        input.rails[1].z = touching - second - 3e-5 + 1e-6;
        let input = pressed(&mut element, &input, depth);
        let found = evaluate(&mut element, &input);
        let of_rail = |k: i32| found.patches.iter().filter(|p| p.rail == k).count();
        patches = [patches[0].max(of_rail(1)), patches[1].max(of_rail(2))];
        inputs.push(input);
    }
    assert!(patches[0] >= 2 && patches[1] >= 1, "{patches:?}");
    judge("two_rails", &parameters, &inputs);
}

#[test]
fn of_a_wheelset() {
    for vertical_mode in [VerticalMode::Penetration, VerticalMode::Load] {
        let mut parameters = wheelset::Parameters::default();
        for side in &mut parameters.sides {
            side.vertical_mode = vertical_mode;
            // Without kinks.
            side.tangential_model = TangentialModel::Tables;
        }
        let mut input = wheelset::Input::default();
        let mut wheelset = Wheelset::new(&parameters, &input, &[]).unwrap();
        let motion = &mut input.wheelset;
        motion.position = [0.01, 2e-3, wheelset.nominal_z() + 1e-4];
        (motion.roll, motion.yaw, motion.yaw_rate) = (2e-4, 3e-3, 0.02);
        (motion.velocity, motion.pitch_rate) = ([20.0, 0.03, 0.01], -20.0 / 0.46);
        input.sides[0].wheel_load = 6e4;
        input.sides[1].wheel_load = 7e4;
        let moved = |motion: f64, turning: f64, side: f64| {
            let mut moved = input;
            let wheelset = &mut moved.wheelset;
            wheelset.position[1] += motion;
            wheelset.position[2] += 0.3 * motion;
            wheelset.velocity[1] += 100.0 * motion;
            (wheelset.yaw, wheelset.roll) = (wheelset.yaw + turning, wheelset.roll - 0.2 * turning);
            wheelset.pitch_rate += 10.0 * turning;
            moved.sides[0].rails[0].y += side;
            moved.sides[1].rails[0].vz += 100.0 * side;
            moved.sides[1].wheel_load += 1e8 * side;
            moved
        };
        for direction in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
            let at = |h: f64| {
                let [a, b, c] = direction.map(|d| d * h);
                let mut output = wheelset::Output::default();
                wheelset.clone().evaluate(&moved(a, b, c), &mut output).unwrap();
                output
            };
            let h = 1e-7;
            let (plus, minus) = (at(h), at(-h));
            let [a, b, c] = direction;
            let (there, mut rates) = (moved(a, b, c), wheelset::Output::default());
            let direction = difference(&there, &input);
            wheelset.directional_derivative(&input, &direction, &mut rates).unwrap();
            let all = |o: &wheelset::Output| {
                let wrench = o.wheelset.force.iter().chain(&o.wheelset.moment).copied();
                let mut all: Vec<f64> = wrench.collect();
                all.extend([1e9 * o.wheelset_z, 1e9 * o.roll, o.wear_number]);
                all
            };
            let found = all(&rates);
            for (k, (a, b)) in all(&plus).iter().zip(all(&minus)).enumerate() {
                let slope = (a - b) / (2.0 * h);
                let error = (found[k] - slope).abs() / largest(&found);
                assert!(error < 1e-5, "{vertical_mode:?} {k}: {} {slope}", found[k]);
            }
        }
    }
}

/// The rates of the inputs from `from` to `to` in a time of 1.
fn difference(to: &wheelset::Input, from: &wheelset::Input) -> wheelset::Input {
    let of = |to: &wheelset::Input, from: &wheelset::Input, k: usize| {
        let [to, from] = [to, from].map(|input| input.of_side(k, 0.0).to_array());
        Input::from_array(std::array::from_fn(|i| to[i] - from[i]))
    };
    let [right, left] = [0, 1].map(|k| of(to, from, k));
    let side = |input: &Input| wheelset::SideInput {
        rails: input.rails,
        wheel_load: input.wheel_load,
        friction: input.friction,
    };
    let sides = [side(&right), side(&left)];
    wheelset::Input { wheelset: right.wheel, sides, track_s: right.track_s }
}

#[test]
fn one_direction_is_the_product_with_the_jacobian_and_changes_nothing() {
    for vertical_mode in [VerticalMode::Penetration, VerticalMode::Load] {
        for side in [Side::Right, Side::Left] {
            let parameters = Parameters { vertical_mode, side, ..Parameters::default() };
            let mut element = element(&parameters);
            let mut right = common::wheel::element(&Parameters { side: Side::Right, ..parameters });
            let mut random = Random::new(3);
            let mut input = random_input(&mut right, &mut random);
            input.wheel_load = 6e4;
            let input = if side == Side::Left { mirrored(&input) } else { input };
            let before = evaluate(&mut element, &input);
            let mut columns = Vec::new();
            element.jacobian(&input, &mut columns).unwrap();
            let direction: [f64; INPUTS] = std::array::from_fn(|_| random.about(1.0));
            let mut rates = Output::default();
            element
                .directional_derivative(&input, &Input::from_array(direction), &mut rates)
                .unwrap();
            for (g, (_, found)) in groups(&rates).iter().enumerate() {
                for (k, rate) in found.iter().enumerate() {
                    let parts = columns.iter().zip(direction);
                    let (mut sum, mut size) = (0.0, 0.0);
                    for part in parts.map(|(column, d)| d * groups(column)[g].1[k]) {
                        sum += part;
                        size += part.abs();
                    }
                    // Where the height follows, it is much less than its parts.
                    let by_height = 1e-14 * groups(&columns[2])[g].1[k].abs().max(1e9);
                    let error = (rate - sum).abs();
                    assert!(error <= 1e-11 * size + by_height, "group {g}: {rate} {sum}");
                }
            }
            assert_eq!(evaluate(&mut element, &input), before);
        }
    }
}

#[test]
fn a_wheel_without_load_touches_where_it_did_before() {
    let parameters = Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() };
    let mut element = element(&parameters);
    let mut input = rolling(1e-3, 20.0);
    (input.wheel.yaw, input.wheel.roll) = (0.01, 2e-3);
    let mut columns = Vec::new();
    element.jacobian(&input, &mut columns).unwrap();
    for (i, step) in [(1, 1e-6), (3, 1e-6), (4, 1e-5), (12, 1e-6), (13, 1e-6), (14, 1e-6)] {
        let at = input.to_array();
        let mut height = |sign: f64| {
            let mut moved = at;
            moved[i] += sign * step;
            evaluate(&mut element, &Input::from_array(moved)).wheel_z
        };
        let slope = (height(1.0) - height(-1.0)) / (2.0 * step);
        let found = columns[i].wheel_z;
        approx::assert_abs_diff_eq!(found, slope, epsilon = 1e-6);
        assert!(largest(&columns[i].wheel.force) <= 0.0);
    }
}
