//! Parts of a rail that begin or end along the track: beyond the end there is nothing to touch.

use crate::common;
use crate::tolerance;
use std::fmt::Write;
use std::fs;

use crate::common::varying::of_slices;
use crate::common::wheel::{evaluate, rolling, the_patch};
use approx::assert_relative_eq;
use tempfile::TempDir;
use wheelrail::element::input::INPUT_NAMES;
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};

/// Height of the axle over the crown at first touch [m].
const WHEEL: f64 = 0.46;
const DEPTH: f64 = 1e-4;

/// A crown of radius 300 mm and half a width of 12 mm that rises by `slope` and is there on one
/// side of station 0, which `is_there` tells of the places [mm], beside a ledge 20 mm below that
/// goes on.
pub fn ending(slope: f64, is_there: impl Fn(f64) -> bool) -> TempDir {
    let folder = TempDir::new().unwrap();
    let ledge: Vec<[f64; 2]> = (0..=20).map(|i| [-60.0 + f64::from(i), 20.0]).collect();
    let length = |points: &[[f64; 2]]| -> f64 {
        points.windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).sum()
    };
    let text = |points: &[[f64; 2]]| {
        points.iter().fold(String::from("# mirror_z 0\n"), |mut text, [y, z]| {
            writeln!(text, "{y:.9} {z:.9}").unwrap();
            text
        })
    };
    fs::write(folder.path().join("ledge.txt"), text(&ledge)).unwrap();
    let (mut listed, mut features) = (String::new(), String::new());
    for place in (-10..=10).map(|i| 20.0 * f64::from(i)) {
        if !is_there(place) {
            writeln!(listed, "{place} 'ledge.txt'").unwrap();
            writeln!(features, "{place} 0 {:.6} -1 -1", length(&ledge)).unwrap();
            continue;
        }
        let crown: Vec<[f64; 2]> = (-40..=40)
            .map(|i| 0.3 * f64::from(i) / 300.0)
            .map(|angle: f64| [300.0 * angle.sin(), 300.0 * (1.0 - angle.cos()) - slope * place])
            .collect();
        let between: Vec<[f64; 2]> = (1..40)
            .map(|i| f64::from(i) / 40.0)
            .map(|share| [-40.0 + 28.0 * share, 20.0 + share * (crown[0][1] - 20.0)])
            .collect();
        let all = [ledge.clone(), between, crown.clone()].concat();
        fs::write(folder.path().join(format!("{place}.txt")), text(&all)).unwrap();
        writeln!(listed, "{place} '{place}.txt'").unwrap();
        let whole = length(&all);
        let ends = [length(&ledge), whole - length(&crown), whole];
        let [a, b, c] = ends.map(|end| format!("{end:.6}"));
        writeln!(features, "{place} 0 {a} {b} {c}").unwrap();
    }
    let text = format!("0 1\n21\n4 0 0\n1\n{listed}{features}");
    fs::write(folder.path().join("rail.slcs"), text).unwrap();
    folder
}

fn parameters(normal_model: NormalModel) -> Parameters {
    let mut parameters = of_slices(Parameters { normal_model, ..Parameters::default() });
    parameters.wheel.profile = "cylindrical".into();
    parameters.tangential_model = TangentialModel::None;
    parameters.damping = 0.0;
    parameters
}

fn element(parameters: &Parameters, folder: &TempDir) -> Element {
    Element::new(parameters, &Input::default(), &[folder.path().to_path_buf()]).unwrap()
}

/// What a wheel over the `station` [m] feels that is 0.1 mm below first touch on the crown.
fn over(element: &mut Element, station: f64) -> Output {
    over_slope(element, station, 0.0)
}

/// The same of a crown that rises by `slope` for ever.
fn over_slope(element: &mut Element, station: f64, slope: f64) -> Output {
    let mut input = Input { track_s: station, ..Input::default() };
    input.wheel.position[2] = DEPTH - slope * station - WHEEL * slope.hypot(1.0);
    evaluate(element, &input)
}

#[test]
fn a_wheel_that_rolls_off_an_end_loses_its_force_without_a_jump() {
    let folder = ending(0.0, |place| place <= 0.0);
    let half = (2.0 * DEPTH * WHEEL).sqrt();
    for model in [NormalModel::Strips, NormalModel::PiotrowskiKik, NormalModel::Hertz] {
        let mut element = element(&parameters(model), &folder);
        let whole = over(&mut element, -0.05).wheel.force[2];
        let mut last: Vec<f64> = Vec::new();
        for i in 0..=800 {
            let station = -0.025 + 5e-5 * f64::from(i);
            let output = over(&mut element, station);
            if output.patch_count > 0 && model == NormalModel::Strips {
                let patch = the_patch(&output);
                // From where the patch begins, or at last the overlap, to the end of the rail; but
                // for what it is longer than that of a ball.
                let begin = if station < 0.0 { half * 0.5_f64.sqrt() } else { half };
                assert!(
                    patch.length < (begin - station).max(0.0) + 6e-4,
                    "{station}: {}",
                    patch.length
                );
            }
            last.push(output.wheel.force[2] / whole);
        }
        for window in last.windows(4) {
            let [a, b, c, d] = [0, 1, 2, 3].map(|i| window[i]);
            assert!(b <= a + tolerance::WALK_JUMPS[0], "{model:?}: {a} {b}");
            // Where the end comes into the patch and where the wheel is over it the force bends,
            // by some 0.4 % over 50 µm.
            let jump = (d - c - b + a).abs();
            assert!(jump < 8e-3, "{model:?}: {jump:e} at {a}");
        }
        // Whole as long as the end is outside of the overlap, and nothing where the wheel is above.
        let before = over(&mut element, -1.01 * half).wheel.force[2];
        assert_relative_eq!(before, whole, max_relative = 1e-9);
        assert!(over(&mut element, 1.01 * half).patch_count == 0);
        let left = over(&mut element, 0.95 * half).wheel.force[2] / whole;
        assert!(left > 0.0 && left < 0.05, "{model:?}: {left}");
    }
}

#[test]
fn the_slope_of_a_part_goes_on_to_its_end() {
    // The wheel touches 9.2 mm ahead, and stands on the end from there on.
    let slope = 0.02;
    let folder = ending(slope, |place| place <= 0.0);
    for model in [NormalModel::Strips, NormalModel::PiotrowskiKik] {
        let mut element = element(&parameters(model), &folder);
        let mut forces = [-0.025, -0.0092 - 1e-4, -0.0092 + 1e-4].map(|station| {
            let output = over_slope(&mut element, station, slope);
            (output.wheel.force, the_patch(&output).position[0])
        });
        let (whole, ahead) = forces[0];
        println!("{model:?}: {forces:?}");
        assert_relative_eq!(whole[0] / whole[2], slope, max_relative = 2e-2);
        assert_relative_eq!(ahead, 0.0092, epsilon = 1e-4);
        for (force, _) in &mut forces {
            *force = force.map(|own| own / whole[2]);
        }
        let [_, (before, x), (behind, beside)] = forces;
        for axis in [0, 2] {
            assert_relative_eq!(before[axis], behind[axis], epsilon = 0.03);
        }
        assert_relative_eq!(x, beside, epsilon = 3e-4);
    }
}

#[test]
fn strips_and_boundary_elements_carry_alike_over_an_end() {
    let folder = ending(0.0, |place| place <= 0.0);
    let models = [NormalModel::Strips, NormalModel::BoundaryElement];
    let mut elements = models.map(|model| element(&parameters(model), &folder));
    let wholes = elements.each_mut().map(|element| over(element, -0.05).wheel.force[2]);
    let half = 0.5 * over(&mut elements[1], -0.05).patches[0].length;
    let mut all = Vec::new();
    for i in -24..=20 {
        let station = 5e-4 * f64::from(i);
        let outputs = elements.each_mut().map(|element| over(element, station));
        let [strips, boundary] = [0, 1].map(|k| outputs[k].wheel.force[2] / wholes[k]);
        let end = outputs[1].patches[0];
        println!(
            "{:5.1} mm: {strips:.4} {boundary:.4}, {:.0} {:.0} MPa",
            1e3 * station,
            1e-6 * outputs[0].patches[0].max_pressure,
            1e-6 * end.max_pressure
        );
        // From where the patch begins, or at last the overlap, to the end of the rail, and an
        // element more.
        let begin = if station < 0.0 { half } else { (2.0 * DEPTH * WHEEL).sqrt() };
        assert!(end.length < (begin - station).max(0.0) + 6e-4, "{station}: {}", end.length);
        all.push([strips, boundary]);
    }
    for [strips, boundary] in &all {
        // A sharp end presses harder than an ellipse does, and less where it hardly touches.
        assert!((strips - boundary).abs() < 0.1, "{strips} {boundary}");
    }
    // Half a millimetre is a twentieth of the way.
    for pair in all.windows(2) {
        let [before, behind] = [pair[0][1], pair[1][1]];
        assert!(behind < before + 1e-3 && before - behind < 0.07, "{before} {behind}");
    }
}

#[test]
fn a_part_that_begins_is_one_that_ends_seen_backwards() {
    let (ends, begins) = (ending(0.0, |place| place <= 0.0), ending(0.0, |place| place >= 0.0));
    for model in [NormalModel::Strips, NormalModel::BoundaryElement] {
        let parameters = parameters(model);
        let (mut ends, mut begins) = (element(&parameters, &ends), element(&parameters, &begins));
        for station in [-6e-3, -2e-3, 0.0, 3e-3] {
            let (one, other) = (over(&mut ends, station), over(&mut begins, -station));
            let size = one.wheel.force[2].abs();
            println!("{model:?} {station}: {:?} {:?}", one.wheel.force, other.wheel.force);
            for (axis, sign) in [(0, -1.0), (1, 1.0), (2, 1.0)] {
                let (a, b) = (one.wheel.force[axis], sign * other.wheel.force[axis]);
                // Over the rail both are the same to 1e-12; strips of a wheel on the end itself
                // are 1e-5 apart, for a reason that is not known.
                assert_relative_eq!(a / size, b / size, epsilon = 1e-7 / 3e-3);
            }
        }
    }
}

#[test]
fn a_wheel_on_an_end_is_pushed_away_from_its_axle() {
    let folder = ending(0.0, |place| place <= 0.0);
    for model in [NormalModel::Strips, NormalModel::BoundaryElement] {
        let mut element = element(&parameters(model), &folder);
        for station in [0.0, 4e-3] {
            let output = over(&mut element, station);
            let [fx, _, fz] = output.wheel.force;
            // Forward, off the rail.
            assert!(fx > 0.0, "{fx}");
            assert_relative_eq!(output.wheel.moment[1] / (fz * WHEEL), 0.0, epsilon = 1e-6);
        }
    }
}

#[test]
fn rolling_off_an_end_takes_damping_from_the_force() {
    let folder = ending(0.0, |place| place <= 0.0);
    let mut parameters = parameters(NormalModel::Strips);
    parameters.damping = 1e5;
    let mut element = element(&parameters, &folder);
    for station in [2e-3, 5e-3] {
        let mut still = Input { track_s: station, ..Input::default() };
        still.wheel.position[2] = DEPTH - WHEEL;
        let mut rolls = still;
        let speed = 1.0;
        (rolls.wheel.velocity[0], rolls.wheel.pitch_rate) = (speed, -speed / WHEEL);
        // The wheel's circle goes up over the end as one does that is lifted.
        let mut lifted = still;
        lifted.wheel.velocity[2] = -speed * station / (WHEEL * WHEEL - station * station).sqrt();
        let [still, rolls, lifted] =
            [still, rolls, lifted].map(|input| evaluate(&mut element, &input).wheel.force[2]);
        assert!(rolls / still < 0.999, "{}", rolls / still);
        assert_relative_eq!(rolls / still, lifted / still, epsilon = 1e-3);
    }
}

#[test]
fn derivatives_over_an_end_are_those_of_differences() {
    let folder = ending(0.0, |place| place <= 0.0);
    let mut parameters = parameters(NormalModel::Strips);
    parameters.tangential_model = Parameters::default().tangential_model;
    let mut element = element(&parameters, &folder);
    let mut all = Vec::new();
    for station in [-3e-3, 2e-3] {
        let mut input = rolling(1e-3, 10.0);
        input.track_s = station;
        input.wheel.position[2] = DEPTH - WHEEL;
        let mut columns = Vec::new();
        element.jacobian(&input, &mut columns).unwrap();
        for (name, step) in [("track.s", 2e-7), ("wheel.x", 2e-7), ("wheel.z", 2e-8)] {
            let i = INPUT_NAMES.iter().position(|own| *own == name).unwrap();
            let mut beside = |by: f64| {
                let mut all = input.to_array();
                all[i] += by;
                let output = evaluate(&mut element, &Input::from_array(all));
                let patch = output.patches[0];
                let [x, _, _] = patch.position;
                let [fx, fy, fz] = output.wheel.force;
                [fx, fy, fz, patch.normal_force, 1e6 * x, 1e6 * patch.length]
            };
            let (low, high) = (beside(-step), beside(step));
            let of = &columns[i];
            let ([fx, fy, fz], patch) = (of.wheel.force, of.patches[0]);
            let [x, _, _] = patch.position;
            let found = [fx, fy, fz, patch.normal_force, 1e6 * x, 1e6 * patch.length];
            for k in 0..6 {
                let wanted = (high[k] - low[k]) / (2.0 * step);
                println!("{station} {name} {k}: {:e} {wanted:e}", found[k]);
                all.push([found[k], wanted]);
            }
        }
    }
    for direction in all.chunks(6) {
        // Of the greatest slope, that of the vertical force.
        let size = direction.iter().fold(0.0_f64, |most, [_, wanted]| most.max(wanted.abs()));
        for [found, wanted] in direction {
            assert!((found - wanted).abs() < 1e-3 * size, "{found:e} {wanted:e}");
        }
    }
}

#[test]
fn a_wheel_rolls_off_an_end_onto_what_lies_below_without_a_warning() {
    // The ledge is 20 mm below: a wheel that falls finds it.
    let folder = ending(0.0, |place| place <= 0.0);
    let mut element = element(&parameters(NormalModel::Strips), &folder);
    let mut input = Input { track_s: 0.19, ..Input::default() };
    input.wheel.position[1] = 0.75 - 0.05;
    let touch = element.touching_height(&input);
    assert_relative_eq!(touch, 0.02 - WHEEL, epsilon = 1e-9);
    let gone = common::wheel::pressed(&mut element, &input, 0.0);
    assert_eq!(evaluate(&mut element, &gone).fallback_count, 0);
}
