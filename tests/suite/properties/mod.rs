//! Laws that hold whatever the models: action and reaction, mirror images, friction, dissipation,
//! similarity.

mod planar;

use crate::tolerance;
use std::cell::RefCell;

use crate::common::vectors::{add, assert_close, cross, dot};
use crate::common::wheel::{evaluate, mirrored, rail_marker};
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;
use wheelrail::element::output::{Patch, Wrench};
use wheelrail::element::parameters::{CreepageModel, NormalModel, Side, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};

const NORMAL: [NormalModel; 4] = [
    NormalModel::Hertz,
    NormalModel::PiotrowskiKik,
    NormalModel::PiotrowskiKikCorrected,
    NormalModel::Strips,
];
/// All but the linear one are bounded by friction.
const BOUNDED: [TangentialModel; 5] = [
    TangentialModel::Fastsim,
    TangentialModel::Fastrip,
    TangentialModel::Tables,
    TangentialModel::FastsimCorrected,
    TangentialModel::Marches,
];
const TANGENTIAL: [TangentialModel; 7] = [
    TangentialModel::None,
    TangentialModel::Linear,
    BOUNDED[0],
    BOUNDED[1],
    BOUNDED[2],
    BOUNDED[3],
    BOUNDED[4],
];
/// Length over width up to which there are tables of creep forces; beyond it spin may make energy.
const MOST_SLENDER: f64 = 20.0;
const CREEPAGE: [CreepageModel; 3] =
    [CreepageModel::Kinematic, CreepageModel::Flat, CreepageModel::Curved];

/// Every combination of real-time models, with few strips and elements.
fn models() -> impl Strategy<Value = Parameters> {
    let chosen = (
        prop::sample::select(&NORMAL[..]),
        prop::sample::select(&CREEPAGE[..]),
        prop::sample::select(&TANGENTIAL[..]),
    );
    chosen.prop_map(|(normal_model, creepage_model, tangential_model)| Parameters {
        normal_model,
        creepage_model,
        tangential_model,
        strips: 8,
        elements_along: 8,
        ..Parameters::default()
    })
}

/// Most of the creep force of a patch [N].
fn most_creep_force(parameters: &Parameters, input: &Input, patch: &Patch) -> f64 {
    let is_flat = parameters.normal_model != NormalModel::Strips;
    let most = tolerance::most_friction(is_flat, patch.penetration);
    most * input.friction * patch.normal_force
}

/// Elements that were made, with what they were made from: making one takes longer than using it.
#[derive(Default)]
struct Made(RefCell<Vec<(Parameters, Element)>>);

impl Made {
    /// The result of an element of `parameters`, on its own side of the track.
    fn evaluate(&self, parameters: &Parameters, input: &Input) -> Output {
        self.with(parameters, |element| evaluate(element, input))
    }

    fn with<T>(&self, parameters: &Parameters, use_it: impl FnOnce(&mut Element) -> T) -> T {
        let mut made = self.0.borrow_mut();
        let place = made.iter().position(|(known, _)| known == parameters).unwrap_or_else(|| {
            let right = Input::default();
            let start = if parameters.side == Side::Left { mirrored(&right) } else { right };
            made.push((parameters.clone(), Element::new(parameters, &start, &[]).unwrap()));
            made.len() - 1
        });
        use_it(&mut made[place].1)
    }
}

/// A value around `middle` within `reach`.
fn around(middle: f64, reach: f64) -> impl Strategy<Value = f64> {
    (-1.0..1.0f64).prop_map(move |t| middle + reach * t)
}

/// A depth below first touch from 1e-12 m to 20 mm, each power of ten as likely.
fn depth() -> impl Strategy<Value = f64> {
    (-12.0..-1.699f64).prop_map(|power| 10f64.powf(power))
}

/// Velocities forward and back, a locked wheel and one at rest among them.
fn speeds() -> impl Strategy<Value = (f64, f64)> {
    let rolling = (-150.0..150.0f64, around(1.0, 0.02)).prop_map(|(v, t)| (v, -v * t / 0.46));
    let any = (-150.0..150.0f64, -350.0..350.0f64);
    let locked = (-150.0..150.0f64).prop_map(|v| (v, 0.0));
    let on_the_spot = (-350.0..350.0f64).prop_map(|rate| (0.0, rate));
    prop_oneof![4 => rolling, 1 => any, 1 => locked, 1 => on_the_spot, 1 => Just((0.0, 0.0))]
}

prop_compose! {
    /// A wheel on the rail before its height is known: anything that it and the rail may do.
    fn motion()(
        y in around(0.75, 0.01),
        angles in [around(0.0, 0.02), around(0.0, 0.2)],
        (forward, pitch_rate) in speeds(),
        velocity in [around(0.0, 1.0), around(0.0, 0.1)],
        rates in [around(0.0, 0.5), around(0.0, 0.5)],
        rail in [around(0.0, 2e-3), around(0.0, 2e-3), around(0.0, 0.02)],
        rail_rates in [around(0.0, 0.2), around(0.0, 0.1), around(0.0, 0.2)],
        friction in 0.0..2.0f64,
    ) -> Input {
        let mut input = Input::default();
        let wheel = &mut input.wheel;
        wheel.position[1] = y;
        [wheel.roll, wheel.yaw] = angles;
        wheel.velocity = [forward, velocity[0], velocity[1]];
        wheel.pitch_rate = pitch_rate;
        [wheel.roll_rate, wheel.yaw_rate] = rates;
        let own = &mut input.rails[0];
        [own.y, own.z, own.roll] = rail;
        [own.vy, own.vz, own.roll_rate] = rail_rates;
        input.friction = friction;
        input
    }
}

/// The input at `depth` below first touch of an element of `parameters`.
fn pressed(made: &Made, parameters: &Parameters, input: &Input, depth: f64) -> Input {
    let mut pressed = *input;
    pressed.wheel.position[2] = made.with(parameters, |e| e.touching_height(input)) + depth;
    pressed
}

/// Cases of a property: more in release builds, which are fifty times as fast.
fn cases() -> ProptestConfig {
    let failed = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/suite/properties/regressions.txt");
    ProptestConfig {
        cases: if cfg!(debug_assertions) { 300 } else { 5000 },
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct(failed))),
        ..ProptestConfig::default()
    }
}

/// Sum of the sizes of all forces of an output.
fn size(output: &Output) -> f64 {
    let patches = output
        .patches
        .iter()
        .map(|p| p.normal_force + p.creep_force[0].hypot(p.creep_force[1]) + p.spin_moment.abs());
    // More patches than are reported do not matter here: the wrench has them all.
    patches.sum::<f64>() + dot(output.wheel.force, output.wheel.force).sqrt()
}

#[test]
fn wheel_and_rail_push_each_other_with_opposite_wrenches() {
    let made = Made::default();
    let marker = rail_marker(&Parameters::default());
    proptest!(cases(), |(parameters in models(), input in motion(), depth in depth())| {
        let input = pressed(&made, &parameters, &input, depth);
        let output = made.evaluate(&parameters, &input);
        let (wheel, rail) = (output.wheel, output.rails[0]);
        let allowed = 10.0 * tolerance::ROUNDING * size(&output);
        assert_close(add(wheel.force, rail.force), [0.0; 3], allowed, "force");
        // About a point far from both markers.
        let point = [3.0, -2.0, 1.0];
        let moved = |at: [f64; 3], w: Wrench| {
            add(w.moment, cross([0, 1, 2].map(|i| at[i] - point[i]), w.force))
        };
        let rail_at = add(marker, [0.0, input.rails[0].y, input.rails[0].z]);
        let total = add(moved(input.wheel.position, wheel), moved(rail_at, rail));
        assert_close(total, [0.0; 3], 10.0 * allowed, "moment");
    });
}

#[test]
fn the_left_side_is_the_mirror_image_of_the_right_bit_for_bit() {
    let made = Made::default();
    proptest!(cases(), |(parameters in models(), input in motion(), depth in depth())| {
        let left_parameters = Parameters { side: Side::Left, ..parameters.clone() };
        let input = pressed(&made, &parameters, &input, depth);
        let right = made.evaluate(&parameters, &input);
        let left = made.evaluate(&left_parameters, &mirrored(&input));
        prop_assert_eq!(left.patch_count, right.patch_count);
        let pairs = [(right.wheel, left.wheel), (right.rails[0], left.rails[0])];
        for (r, l) in pairs {
            assert_close(l.force, [r.force[0], -r.force[1], r.force[2]], 0.0, "force");
            assert_close(l.moment, [-r.moment[0], r.moment[1], -r.moment[2]], 0.0, "moment");
        }
        for (r, l) in right.patches.iter().zip(&left.patches) {
            let [longitudinal, lateral, spin] = r.creepage;
            assert_close(l.creepage, [longitudinal, -lateral, -spin], 0.0, "creepage");
            prop_assert!((l.contact_angle + r.contact_angle).abs() <= 0.0);
            prop_assert!((l.max_pressure - r.max_pressure).abs() <= 0.0);
            prop_assert!((l.frictional_power - r.frictional_power).abs() <= 0.0);
        }
    });
}

#[test]
fn creep_forces_stay_within_friction_and_take_energy() {
    let made = Made::default();
    proptest!(cases(), |(parameters in models(), input in motion(), depth in depth())| {
        let input = pressed(&made, &parameters, &input, depth);
        let output = made.evaluate(&parameters, &input);
        let is_linear = parameters.tangential_model == TangentialModel::Linear;
        for patch in output.patches.iter().filter(|p| p.rail > 0) {
            let [fx, fy] = patch.creep_force;
            let limit = most_creep_force(&parameters, &input, patch);
            prop_assert!(is_linear || fx.hypot(fy) <= limit, "{patch:?}");
            prop_assert!(patch.normal_force >= 0.0 && patch.max_pressure >= 0.0, "{patch:?}");
            prop_assert!(patch.frictional_power >= 0.0, "{patch:?}");
            prop_assert!((0.0..=1.0).contains(&patch.slip_share), "{patch:?}");
            // The reported power is cut at nothing; that of one creepage for the whole patch can be
            // checked without.
            let [longitudinal, lateral, spin] = patch.creepage;
            let turns = spin.abs() > 0.0 && patch.length > MOST_SLENDER * patch.width;
            if parameters.creepage_model != CreepageModel::Curved && !turns {
                let (x, y, z) = (fx * longitudinal, fy * lateral, patch.spin_moment * spin);
                let rounding = 1e-9 * (x.abs() + y.abs() + z.abs());
                prop_assert!(x + y + z <= rounding, "{patch:?}");
            }
        }
        let all = output.patches.iter().map(|p| p.frictional_power).sum::<f64>();
        prop_assert!(output.frictional_power >= all * (1.0 - 1e-9));
        prop_assert!(output.wear_number >= 0.0);
    });
}

#[test]
fn stiffer_bodies_carry_as_much_more_on_the_same_area() {
    let made = Made::default();
    proptest!(cases(), |(
        parameters in models(), input in motion(), depth in depth(), power in -3..=3i32,
    )| {
        let plain = Parameters { damping: 0.0, ..parameters };
        let factor = 10f64.powi(power);
        let stiff = Parameters {
            wheel: wheelrail::element::parameters::WheelParameters {
                young_modulus: factor * plain.wheel.young_modulus,
                ..plain.wheel.clone()
            },
            rail_young_modulus: factor * plain.rail_young_modulus,
            ..plain.clone()
        };
        let input = pressed(&made, &plain, &input, depth);
        let (one, other) = (made.evaluate(&plain, &input), made.evaluate(&stiff, &input));
        prop_assert_eq!(one.patch_count, other.patch_count);
        // At depths of picometres the depth itself is rounding.
        let allowed = tolerance::SIMILARITY * size(&one) + tolerance::NO_FORCE;
        assert_close(other.wheel.force.map(|f| f / factor), one.wheel.force, allowed, "force");
        for (a, b) in one.patches.iter().zip(&other.patches) {
            prop_assert!((a.area - b.area).abs() <= tolerance::SIMILARITY * a.area);
        }
    });
}

#[test]
fn creep_forces_depend_on_the_ratio_of_speeds_alone() {
    let made = Made::default();
    proptest!(cases(), |(
        parameters in models(), input in motion(), depth in depth(), factor in 0.1..10.0f64,
    )| {
        // A floor of the reference speed is a speed of its own.
        let parameters = Parameters { damping: 0.0, minimum_speed: 1e-6, ..parameters };
        let input = pressed(&made, &parameters, &input, depth);
        if input.wheel.velocity[0].abs() + input.wheel.pitch_rate.abs() < 1e-3 {
            return Ok(());
        }
        let mut faster = input;
        let wheel = &mut faster.wheel;
        wheel.velocity = wheel.velocity.map(|v| factor * v);
        for rate in [&mut wheel.roll_rate, &mut wheel.yaw_rate, &mut wheel.pitch_rate] {
            *rate *= factor;
        }
        let rail = &mut faster.rails[0];
        for rate in [&mut rail.vy, &mut rail.vz, &mut rail.roll_rate] {
            *rate *= factor;
        }
        let (one, other) = (made.evaluate(&parameters, &input), made.evaluate(&parameters, &faster));
        let allowed = tolerance::SIMILARITY * size(&one);
        assert_close(other.wheel.force, one.wheel.force, allowed, "force");
        let power = factor * one.frictional_power;
        prop_assert!((other.frictional_power - power).abs() <= tolerance::SIMILARITY * power.abs() + 1e-6);
    });
}

/// Numbers over six decades around that of steel.
fn modulus() -> impl Strategy<Value = f64> {
    (-3.0..3.0f64).prop_map(|power| 2.1e11 * 10f64.powf(power))
}

#[test]
fn forces_are_finite_for_bodies_of_any_size_and_stiffness() {
    let bodies = (0.1..2.0f64, modulus(), modulus(), 0.0..=0.5f64, 0.0..=0.5f64, any::<bool>());
    // A wheel on the rail, and one above, beside, below and inside it.
    let place = (depth(), any::<bool>(), -0.1..0.1f64, -0.1..0.1f64);
    let count = if cfg!(debug_assertions) { 60 } else { 5000 };
    let config = ProptestConfig { cases: count, ..cases() };
    proptest!(config, |(
        models in models(), bodies in bodies, input in motion(), place in place,
    )| {
        let (radius, wheel_modulus, rail_modulus, wheel_ratio, rail_ratio, left) = bodies;
        let mut parameters = Parameters { rail_young_modulus: rail_modulus, rail_poisson_ratio: rail_ratio, ..models };
        parameters.wheel.nominal_radius = radius;
        parameters.wheel.young_modulus = wheel_modulus;
        parameters.wheel.poisson_ratio = wheel_ratio;
        let mut input = input;
        if left {
            parameters.side = Side::Left;
            input = mirrored(&input);
        }
        let mut element = Element::new(&parameters, &input, &[]).unwrap();
        prop_assert!(element.nominal_wheel_z().is_finite());
        let (depth, elsewhere, aside, above) = place;
        input.wheel.position[2] = element.touching_height(&input) + depth;
        if elsewhere {
            input.wheel.position[1] += aside;
            input.wheel.position[2] += above;
        }
        let output = evaluate(&mut element, &input);
        let wrenches = [output.wheel, output.rails[0]];
        let mut numbers = wrenches.iter().flat_map(|w| w.force.iter().chain(&w.moment));
        prop_assert!(numbers.all(|v| v.is_finite()), "{parameters:?} {input:?} {output:?}");
        prop_assert!(output.wear_number.is_finite() && output.frictional_power.is_finite());
        let is_linear = parameters.tangential_model == TangentialModel::Linear;
        for patch in output.patches.iter().filter(|p| p.rail > 0) {
            let limit = most_creep_force(&parameters, &input, patch);
            let force = patch.creep_force[0].hypot(patch.creep_force[1]);
            prop_assert!(is_linear || force <= limit, "{patch:?}");
            let numbers = [patch.length, patch.width, patch.area, patch.penetration];
            prop_assert!(numbers.iter().all(|v| v.is_finite() && *v >= 0.0), "{patch:?}");
        }
    });
}
