//! Derivatives of an element against central differences.
//!
//! Differences cannot resolve everything. Left out are those with a kink within their step, where
//! the slopes to the left and to the right differ, and errors are taken over no less than rounding
//! leaves: see `Differences`.

use super::*;
use crate::common::{median_and_worst, write_report};
use crate::tolerance;
use wheelrail::element::Element;
use wheelrail::element::input::INPUT_NAMES;

/// Random poses of each model, of a right wheel and of a left one.
const POSES: usize = 8;
/// Difference of the slopes to either side, over the slope, up to which there is no kink.
const SMOOTH: f64 = 1e-7;
/// Most derivatives that differences may leave open: strips have a kink wherever a node begins to
/// carry load.
const MAX_OPEN: f64 = 0.15;

/// Greatest of the distances over which differences are taken: short against what forces change
/// over, long against rounding.
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

/// The numbers of an output that have derivatives but for shares of slip, which FASTSIM counts in
/// elements.
pub fn groups(output: &Output) -> Vec<Group> {
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
            (0.0, vec![patch.friction_coefficient]),
            (0.0, vec![patch.temperature]),
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

/// Outputs at whole and half of a step to either side of an input, if there are as many patches as
/// there.
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

    /// Derivative of number `k` of group `g`, whose value is `value`; nothing where the slopes to
    /// both sides differ by more than `most`.
    fn slope(&self, g: usize, k: usize, value: f64, most: f64) -> Option<f64> {
        let at = |n: usize| self.places[n].1[g].1[k];
        let to = |n: usize| (at(n) - value) / self.places[n].0;
        // Extrapolated from whole and half of the step: what is left is of second order to one
        // side, of fourth to both.
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
                let error = |[slope, scale]: [f64; 2]| (rate - slope).abs() / scale;
                let found = (0..smooth.len()).find_map(|n| {
                    let [slope, scale] = smooth[n]?;
                    match smooth.get(n + 1).copied() {
                        // Of two that agree the longer one may have its bend and the shorter one
                        // its rounding.
                        Some(Some(near)) => ((slope - near[0]).abs() <= 2.0 * SMOOTH * near[1])
                            .then(|| (slope, error([slope, scale]).min(error(near)))),
                        Some(None) => None,
                        None => Some((slope, error([slope, scale]))),
                    }
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

pub fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most: f64, number| most.max(number.abs()))
}

/// Judges the Jacobian at random poses of a right and of a left wheel, and at those of `more`
/// besides.
pub fn judge(name: &str, parameters: &Parameters, more: &[Input]) {
    // Strips take their time without optimisation.
    let is_strips = parameters.normal_model == NormalModel::Strips;
    judge_poses(name, parameters, more, if is_strips { POSES / 4 } else { POSES });
}

/// The same at a quarter of the poses: on rails that vary a search takes twenty times as long.
pub fn judge_few(name: &str, parameters: &Parameters) {
    judge_poses(name, parameters, &[], POSES / 4);
}

fn judge_poses(name: &str, parameters: &Parameters, more: &[Input], count: usize) {
    // The height that carries a load is found to 1e-11 of it; Newton's method for strips leaves
    // some 1e-11 of a force.
    let noise = match (parameters.vertical_mode, parameters.normal_model) {
        (VerticalMode::Load, _) => 100.0,
        (_, NormalModel::Strips) => 10.0,
        _ => 1.0,
    };
    let mut errors = Errors::default();
    for side in [Side::Right, Side::Left] {
        let [mut right, mut own] =
            [Side::Right, side].map(|side| element(&parameters.on_side(side)));
        let mut random = Random::new(11);
        let mut random_pose = || {
            let mut input = random_input(&mut right, &mut random);
            input.wheel_load = random.within(1e4, 1.2e5);
            input
        };
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
    let most_open = if noise > 10.0 { 2.0 * MAX_OPEN } else { MAX_OPEN };
    assert!(count > 1000 && share < most_open, "{name}: {open} open of {count}");
    assert!(worst < tolerance::DERIVATIVES, "{name}: {worst:e}");
}
