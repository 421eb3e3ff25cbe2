//! Rails on springs without mass.

use crate::common::random::Random;
use crate::common::summary::Summary;
use crate::common::wheel::{
    benchmark, element, evaluate, mirrored, of_wheelset, random_input, rolling,
};
use crate::common::{median_and_worst, read_table, value};
use crate::tolerance;
use wheelrail::element::input::INPUTS;
use wheelrail::element::parameters::{
    CreepageModel, Foundation, FoundationModel, NormalModel, Side, TangentialModel, VerticalMode,
};
use wheelrail::element::{Element, Input, Output, Parameters};

fn massless(stiffness: [f64; 2]) -> Foundation {
    Foundation { model: FoundationModel::Massless, stiffness, ..Foundation::default() }
}

fn on_springs(vertical_mode: VerticalMode) -> Parameters {
    let foundation = massless(Foundation::default().stiffness);
    Parameters { foundation, vertical_mode, ..Parameters::default() }
}

/// Springs that do not give way.
const RIGID: f64 = 1e15;

/// The error of a vector over the size of another one [%].
fn percent_of(found: &[f64], expected: &[f64], size: &[f64]) -> f64 {
    let length = |x: f64, y: f64| x + y * y;
    let off: Vec<f64> = found.iter().zip(expected).map(|(a, b)| a - b).collect();
    let [off, size] = [&off, size].map(|v| v.iter().copied().fold(0.0, length).sqrt());
    100.0 * off / size
}

#[test]
fn forces_and_deflections_are_those_of_the_contact_program() {
    let table = read_table("contact_25_1/massless_rail.csv");
    let names = [
        "given load: force of the springs [% of the contact force]",
        "given load: contact force [%]",
        "given load: deflection [%]",
        "given load: height [um]",
        "given height, springs both ways: force of the springs [% of the contact force]",
        "given height, springs both ways: contact force [%]",
    ];
    let mut errors = names.map(|_| Vec::new());
    for row in &table.rows {
        let v = |name: &str| value(&table, row, name);
        let stiffness = [1e3 * v("ky_rail_N_mm"), 1e3 * v("kz_rail_N_mm")];
        let is_elastic = stiffness[1] > 0.0;
        let stiffness = stiffness.map(|k| if k > 0.0 { k } else { RIGID });
        let expected = ["dy_defl_mm", "dz_defl_mm"].map(|name| 1e-3 * v(name));
        let force = ["fx_rail_N", "fy_rail_N", "fz_rail_total_N"].map(v);
        for mode in [VerticalMode::Load, VerticalMode::Penetration] {
            let mut element = benchmark(Parameters {
                foundation: massless(stiffness),
                vertical_mode: mode,
                damping: 0.0,
                // One plane for each contact, as the reference has it.
                creepage_model: CreepageModel::Flat,
                // Where a zone parts in two, such forces jump: with 15 strips one does at the very
                // height of row 9.
                strips: 20,
                ..Parameters::default()
            });
            let mut input = of_wheelset(&v);
            // What the outer force deflects it by.
            input.rails[0].y = v("fy_outer_N") / stiffness[0];
            let output = evaluate(&mut element, &input);
            assert_eq!(output.fallback_count, 0);
            let [y, z] = output.foundation.deflection;
            let deflection = [input.rails[0].y + y, z];
            // The springs hold what the contact puts on the rail.
            for i in 0..2 {
                let left = stiffness[i] * [y, z][i] - output.rails[0].force[i + 1];
                let most = tolerance::RAIL_AT_REST * v("p1_N_N");
                assert!(left.abs() < most, "{left}");
            }
            let springs = [stiffness[0], if is_elastic { stiffness[1] } else { 0.0 }];
            let held = |deflection: &[f64; 2]| [0, 1].map(|i| deflection[i] * springs[i]);
            let springs = percent_of(&held(&deflection), &held(&expected), &force);
            let contact = percent_of(&output.rails[0].force, &force, &force);
            if mode == VerticalMode::Load {
                let whole = percent_of(&deflection, &expected, &expected);
                let height = 1e6 * (output.wheel_z - input.wheel.position[2]).abs();
                let own = [springs, contact, whole, height];
                errors.iter_mut().zip(own).for_each(|(errors, own)| errors.push(own));
            } else if is_elastic {
                errors[4].push(springs);
                errors[5].push(contact);
            }
        }
    }
    let mut summary = Summary::new("massless_rail");
    for (k, (name, errors)) in names.iter().zip(errors).enumerate() {
        let is_force = ![2, 3].contains(&k);
        let [median, worst] = median_and_worst(errors.clone());
        summary.add(name, errors, if is_force { "1 / - / 2" } else { "" });
        let [most_median, most] = tolerance::MASSLESS_RAIL.map(|share| 100.0 * share);
        assert!(!is_force || (median <= most_median && worst <= most), "{name}: {median} {worst}");
    }
    summary.write();
}

#[test]
fn rails_rest_where_the_springs_hold_the_contact_forces_whatever_was_before() {
    let normal_models = [NormalModel::Strips, NormalModel::Hertz];
    for mode in [VerticalMode::Penetration, VerticalMode::Load] {
        for normal_model in normal_models {
            let parameters = Parameters { normal_model, ..on_springs(mode) };
            let mut springs = element(&parameters);
            let mut left = element(&Parameters { side: Side::Left, ..parameters.clone() });
            let mut rigid =
                element(&Parameters { foundation: Foundation::default(), ..parameters.clone() });
            let mut random = Random::new(61);
            let (mut counted, mut most, mut missed) = (0, 0, 0);
            for _ in 0..100 {
                let mut input = random_input(&mut rigid, &mut random);
                input.wheel_load = random.within(1e3, 1.5e5);
                // As deep as it is with rails that sink.
                input.wheel.position[2] += random.within(0.0, 2e-3);
                let (before, fallbacks) = (springs.work().searches, springs.fallbacks());
                let output = evaluate(&mut springs, &input);
                if springs.fallbacks() > fallbacks {
                    missed += 1;
                    continue;
                }
                let searches = springs.work().searches - before;
                (counted, most) = (counted + searches, most.max(searches));
                let [y, z] = output.foundation.deflection;
                for (i, way) in [y, z].into_iter().enumerate() {
                    let held = parameters.foundation.stiffness[i] * way;
                    let left = (held - output.rails[0].force[i + 1]).abs();
                    let normal: f64 = output.patches.iter().map(|p| p.normal_force).sum();
                    assert!(left <= tolerance::RAIL_AT_REST * normal, "{left} {input:?}");
                }
                // Rails that are put there feel the same.
                let mut moved = input;
                moved.rails[0].y += y;
                moved.rails[0].z += z;
                let same = evaluate(&mut rigid, &moved);
                if mode == VerticalMode::Penetration {
                    assert_eq!(same.wheel, output.wheel);
                    assert_eq!(same.patches, output.patches);
                } else {
                    // The balance ends from another side.
                    let [share, floor] = tolerance::LOAD_AND_HEIGHT;
                    let square: f64 = same.wheel.force.iter().map(|force| force * force).sum();
                    let most = share * square.max(input.wheel_load.powi(2)) / input.wheel_load;
                    for (same, found) in same.wheel.force.into_iter().zip(output.wheel.force) {
                        let off = (same - found).abs();
                        assert!(off <= most + floor, "{off:e} {input:?}");
                    }
                }
                let image = evaluate(&mut left, &mirrored(&input));
                let sides = [image.foundation.deflection, [-y, z]];
                assert_eq!(sides[0].map(f64::to_bits), sides[1].map(f64::to_bits));
            }
            println!(
                "{mode:?} {normal_model:?}: {counted} searches, at most {most}, {missed} missed"
            );
            let is_smooth = normal_model == NormalModel::Strips;
            assert!(
                missed <= if is_smooth { 0 } else { tolerance::RAILS_WITHOUT_REST },
                "{missed}"
            );
        }
    }
}

/// A pose at which strips are taken and left out as the search for the load goes on.
#[test]
fn rails_rest_where_strips_come_and_go_on_the_way_to_the_load() {
    let mut parameters = on_springs(VerticalMode::Load);
    parameters.rails[0].profile = "54E1".into();
    let mut input = rolling(0.0, 50.202);
    let wheel = &mut input.wheel;
    wheel.position[1] = 0.758_106_306_905_889_5;
    (wheel.roll, wheel.yaw) = (0.009_723_962_350_286_075, 0.003_392_340_061_169_093_4);
    (wheel.velocity[1], wheel.pitch_rate) = (0.045_130_374_874_418_594, -109.535_227);
    (input.wheel_load, input.friction) = (71_278.539_835_531_7, 0.096_500_974_236_848_53);
    let output = evaluate(&mut element(&parameters), &input);
    let held = parameters.foundation.stiffness[0] * output.foundation.deflection[0];
    let left = (held + output.wheel.force[1]).abs();
    assert!(left <= tolerance::RAIL_AT_REST * input.wheel_load, "{left}");
}

#[test]
fn springs_that_do_not_give_way_are_none_and_a_lifted_wheel_needs_no_search() {
    let foundation = massless([RIGID; 2]);
    let mut stiff = element(&Parameters { foundation, ..Parameters::default() });
    let mut rigid = element(&Parameters::default());
    let mut random = Random::new(62);
    for _ in 0..20 {
        let input = random_input(&mut rigid, &mut random);
        let [found, expected] =
            [&mut stiff, &mut rigid].map(|element| evaluate(element, &input).wheel.force);
        assert!(percent_of(&found, &expected, &expected) < 1e-3, "{found:?} {expected:?}");
    }
    let before = stiff.work().searches;
    let lifted = evaluate(&mut stiff, &rolling(0.0, 20.0));
    assert_eq!((lifted.patch_count, stiff.work().searches - before), (0, 0));
    assert_eq!(lifted.foundation.deflection.map(f64::to_bits), [0.0_f64.to_bits(); 2]);
}

/// Deflection and forces.
fn results(output: &Output) -> [Vec<f64>; 2] {
    let forces = output.wheel.force.into_iter().chain(output.rails[0].force);
    [forces.collect(), output.foundation.deflection.to_vec()]
}

#[test]
fn derivatives_go_through_the_rails() {
    for mode in [VerticalMode::Penetration, VerticalMode::Load] {
        let step = 2e-7;
        let parameters = Parameters {
            // Without the kinks that differences of one step do not see.
            normal_model: NormalModel::PiotrowskiKik,
            tangential_model: TangentialModel::Tables,
            ..on_springs(mode)
        };
        let mut element = element(&parameters);
        let mut random = Random::new(63);
        let (mut worst, mut count, mut jumps) = (0.0_f64, 0, 0);
        for _ in 0..40 {
            let mut input = random_input(&mut element, &mut random);
            input.wheel_load = random.within(3e4, 9e4);
            input.wheel.position[2] += random.within(3e-4, 1.5e-3);
            let at = evaluate(&mut element, &input);
            let mut direction: [f64; INPUTS] = std::array::from_fn(|_| random.about(1.0));
            (direction[5], direction[24], direction[26]) = (0.0, 0.0, random.about(1e7));
            let direction = Input::from_array(direction);
            let mut rates = Output::default();
            if element.directional_derivative(&input, &direction, &mut rates).is_err() {
                // The end of a profile is within the contact.
                continue;
            }
            let mut columns = Vec::new();
            element.jacobian(&input, &mut columns).unwrap();
            let mut moved = |h: f64| {
                let ways = direction.to_array();
                let at = input.to_array();
                let input = Input::from_array(std::array::from_fn(|i| at[i] + h * ways[i]));
                evaluate(&mut element, &input)
            };
            let all = [-step, -0.5 * step, 0.5 * step, step].map(&mut moved);
            if at.patch_count != 1 || all.iter().any(|output| output.patch_count != 1) {
                continue;
            }
            let [a, b, c, d] = all.map(|output| results(&output));
            for (g, group) in results(&rates).iter().enumerate() {
                // At least what the softer spring makes of ways of 1.
                let least = [parameters.foundation.stiffness[0], 1.0][g];
                let size = group.iter().fold(least, |most, rate| most.max(rate.abs()));
                for (i, rate) in group.iter().enumerate() {
                    let slope = |low: &[Vec<f64>; 2], high: &[Vec<f64>; 2], h: f64| {
                        (high[g][i] - low[g][i]) / h
                    };
                    let both = (4.0 * slope(&b, &c, step) - slope(&a, &d, 2.0 * step)) / 3.0;
                    let off = (rate - both).abs() / size;
                    if (slope(&b, &c, step) - slope(&a, &d, 2.0 * step)).abs() > 1e-5 * size {
                        // The model jumps between them.
                        jumps += 1;
                        continue;
                    }
                    (worst, count) = (worst.max(off), count + 1);
                    // All columns together give the direction.
                    let parts = columns.iter().zip(direction.to_array());
                    let sum: f64 = parts.map(|(column, way)| way * results(column)[g][i]).sum();
                    assert!((sum - rate).abs() < 1e-9 * size, "{sum} {rate}");
                }
            }
        }
        println!("{mode:?}: worst of {count} rates {worst:e}, {jumps} at jumps");
        assert!(count > 150 && jumps <= 16, "{count} {jumps}");
        assert!(worst < tolerance::DERIVATIVES, "{mode:?}: {worst:e}");
    }
}

#[test]
fn models_without_derivatives_have_rails_that_give_way_too() {
    let mut parameters = on_springs(VerticalMode::Penetration);
    parameters.rails[0].corrugation.amplitude = 2e-5;
    let mut element = element(&parameters);
    let mut input = rolling(0.0, 20.0);
    let touching = element.touching_height(&input);
    input.wheel.position[2] = touching + 1e-3;
    for k in 0..5 {
        input.track_s = 0.007 * f64::from(k);
        let output = evaluate(&mut element, &input);
        let [y, z] = output.foundation.deflection;
        for (way, force, stiffness) in [
            (y, output.rails[0].force[1], parameters.foundation.stiffness[0]),
            (z, output.rails[0].force[2], parameters.foundation.stiffness[1]),
        ] {
            let left = (stiffness * way - force).abs();
            assert!(left < tolerance::RAIL_AT_REST * output.load_carried, "{left}");
        }
    }
    assert_eq!(element.fallbacks(), 0);
}

fn refused(change: impl Fn(&mut Parameters)) -> String {
    let mut parameters = on_springs(VerticalMode::Load);
    change(&mut parameters);
    Element::new(&parameters, &Input::default(), &[]).unwrap_err().to_string()
}

#[test]
fn what_no_foundation_can_have_is_refused_by_name() {
    let message = refused(|p| p.foundation.model = FoundationModel::Mass);
    assert!(message.contains("track.foundation.model = \"mass\""), "{message}");
    assert!(message.contains("vertical.mode"), "{message}");
    let message = refused(|p| p.foundation.stiffness[1] = 0.0);
    assert!(message.contains("track.foundation.stiffness.z = 0"), "{message}");
    let message = refused(|p| p.foundation.stiffness[0] = f64::NAN);
    assert!(message.contains("track.foundation.stiffness.y = NaN"), "{message}");
    let message = refused(|p| p.foundation.damping[0] = -1.0);
    assert!(message.contains("track.foundation.damping.y = -1"), "{message}");
    let message = refused(|p| p.foundation.mass = 0.0);
    assert!(message.contains("track.foundation.mass = 0"), "{message}");
    let message = refused(|p| p.foundation.longest_step = f64::INFINITY);
    assert!(message.contains("track.foundation.longest_step = inf"), "{message}");
}

#[test]
fn a_wheel_may_start_as_far_down_as_its_rails_sink() {
    let start = |depth: f64, foundation: Foundation| {
        let mut input = rolling(0.0, 20.0);
        input.wheel.position[2] = -0.46 + depth;
        let parameters = Parameters { foundation, ..Parameters::default() };
        Element::new(&parameters, &input, &[]).unwrap().start_warning()
    };
    // 3 mm are 90 kN on this track, and no contact bears them.
    let soft = massless([2e7, 3e7]);
    assert_eq!(start(3e-3, soft), None);
    assert_eq!(start(3e-3, Foundation { model: FoundationModel::Mass, ..soft }), None);
    assert!(start(3e-3, Foundation::default()).is_some());
}
