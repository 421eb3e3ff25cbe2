//! Forces and moments of the whole element: balance, points of reduction, symmetry.

use crate::common::random::Random;
use crate::common::vectors::{add, assert_close, cross, dot};
use crate::common::wheel::{
    element, evaluate, mirrored, plain_parameters, pressed, rail_marker, random_input, reversed,
    rolling, the_patch,
};
use crate::tolerance;
use wheelrail::element::output::Wrench;
use wheelrail::element::parameters::{
    CreepageModel, NormalModel, Side, TangentialModel, VerticalMode,
};
use wheelrail::element::{Element, Input, Output, Parameters};

/// The default models, and curved creepage on the corrected contact area.
fn both_descriptions() -> [Parameters; 2] {
    let curved = Parameters {
        normal_model: NormalModel::PiotrowskiKikCorrected,
        creepage_model: CreepageModel::Curved,
        ..Parameters::default()
    };
    [Parameters::default(), curved]
}

#[test]
fn wheel_and_rail_push_each_other_with_opposite_wrenches() {
    both_descriptions().iter().for_each(assert_opposite_wrenches);
}

fn assert_opposite_wrenches(parameters: &Parameters) {
    let mut element = element(parameters);
    let marker = rail_marker(parameters);
    let mut random = Random::new(3);
    let mut most_patches = 0;
    for _ in 0..300 {
        let input = random_input(&mut element, &mut random);
        let output = evaluate(&mut element, &input);
        most_patches = most_patches.max(output.patch_count);
        let (wheel, rail) = (output.wheel, output.rails[0]);
        let size = dot(wheel.force, wheel.force).sqrt();
        assert_close(add(wheel.force, rail.force), [0.0; 3], tolerance::ROUNDING * size, "force");
        // About a point far from both markers.
        let point = [3.0, -2.0, 1.0];
        let moved = |at: [f64; 3], w: Wrench| {
            let arm = [0, 1, 2].map(|i| at[i] - point[i]);
            add(w.moment, cross(arm, w.force))
        };
        let rail_at = add(marker, [0.0, input.rails[0].y, input.rails[0].z]);
        let total = add(moved(input.wheel.position, wheel), moved(rail_at, rail));
        assert_close(total, [0.0; 3], 10.0 * tolerance::ROUNDING * size, "moment");
    }
    assert!(most_patches > 1);
}

#[test]
fn the_wrench_is_the_sum_of_the_patches_with_normal_forces_on_lines_through_the_axle() {
    // Strips of a curved patch have tangents of their own: their creep forces have a part along the
    // normal of the patch.
    let creepage_model = CreepageModel::Flat;
    let mut element = element(&Parameters { creepage_model, ..Parameters::default() });
    let mut random = Random::new(4);
    for _ in 0..300 {
        let input = random_input(&mut element, &mut random);
        let output = evaluate(&mut element, &input);
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        for patch in &output.patches[..output.patch_count as usize] {
            let (sine, cosine) = patch.contact_angle.sin_cos();
            let [along, across] = patch.creep_force;
            let normal = [0.0, -sine, cosine];
            let creep = [along, across * cosine, across * sine];
            let pressing = normal.map(|n| -n * patch.normal_force);
            let arm = [0, 1, 2].map(|i| patch.position[i] - input.wheel.position[i]);
            let wheel = &input.wheel;
            let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) =
                (wheel.roll.sin_cos(), wheel.yaw.sin_cos());
            let axle = [-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll];
            // Moved along x until (arm, normal, axle) lie in a plane.
            let volume = dot(arm, cross(normal, axle));
            let mut on_line = arm;
            on_line[0] -= volume / cross(normal, axle)[0];
            force = add(force, add(creep, pressing));
            moment = add(moment, add(cross(arm, creep), cross(on_line, pressing)));
            moment = add(moment, normal.map(|n| n * patch.spin_moment));
        }
        let size = dot(force, force).sqrt();
        assert_close(output.wheel.force, force, 10.0 * tolerance::ROUNDING * size, "force");
        assert_close(output.wheel.moment, moment, 10.0 * tolerance::ROUNDING * size, "moment");
    }
}

#[test]
fn moments_of_a_cylinder_on_a_crowned_rail_are_those_worked_out_by_hand() {
    let mut parameters = plain_parameters("cylindrical", "arc:0.3");
    // It would press more on the side to which the wheel drifts.
    parameters.damping = 0.0;
    let mut element = element(&parameters);
    let top = rail_marker(&parameters)[1];
    let (radius, depth, aside) = (0.46, 5e-5, 0.012);
    // The nominal rolling circle stands 12 mm to the field side of the crown; the wheel brakes and
    // drifts outwards.
    let mut input = rolling(top + aside - 0.75, 20.0);
    input.wheel.position[0] = 0.3;
    input.wheel.velocity[1] = 0.05;
    input.wheel.pitch_rate *= 0.998;
    let input = pressed(&mut element, &input, depth);
    assert!((input.wheel.position[2] + radius - depth).abs() < tolerance::TOUCHING_HEIGHT);
    let output = evaluate(&mut element, &input);
    let patch = the_patch(&output);
    let [fx, fy, fz] = output.wheel.force;
    assert!(fx < -1e3 && fy < -1e3 && fz < -1e4, "{:?}", output.wheel.force);
    let load = -fz;
    // Contact under the axle, on the crown, at the lowest circle of the wheel.
    let arm = [0.0, -aside, radius];
    let expected = add(cross(arm, [fx, fy, -load]), [0.0, 0.0, patch.spin_moment]);
    let allowed = tolerance::CONTACT_PLACE * load;
    assert_close(output.wheel.moment, expected, allowed, "about the wheel marker");
    // Written out: braking turns the wheel backwards, the load tips it outwards about x.
    let by_hand = [aside * load - radius * fy, radius * fx, aside * fx + patch.spin_moment];
    assert_close(output.wheel.moment, by_hand, allowed, "by hand");
    // On the rail the same forces act at the crown, within the depth from its marker, with the
    // marker under the wheel's x.
    let on_rail = [depth * fy, -input.wheel.position[0] * load - depth * fx, 0.3 * -fy];
    let on_rail = add(on_rail, [0.0, 0.0, -patch.spin_moment]);
    assert_close(output.rails[0].moment, on_rail, allowed, "about the rail marker");
}

#[test]
fn moments_of_a_cone_on_a_crowned_rail_are_those_worked_out_by_hand() {
    let tangent = 0.05f64;
    let mut parameters = plain_parameters("conical:0.05", "arc:0.3");
    parameters.tangential_model = TangentialModel::None;
    // Of one contact point, as the hand has it.
    parameters.normal_model = NormalModel::PiotrowskiKik;
    let mut element = element(&parameters);
    let top = rail_marker(&parameters)[1];
    // A rail that stands 3 mm further out and 2 mm deeper.
    let mut input = rolling(top - 0.75, 20.0);
    (input.rails[0].y, input.rails[0].z) = (3e-3, 2e-3);
    let input = pressed(&mut element, &input, 5e-5);
    let output = evaluate(&mut element, &input);
    let patch = the_patch(&output);
    let angle = -tangent.atan();
    assert!((patch.contact_angle - angle).abs() < tolerance::CONE_ANGLE);
    let load = patch.normal_force;
    // The cone pushes its wheel towards the track centre.
    let force = [0.0, load * angle.sin(), -load * angle.cos()];
    assert_close(output.wheel.force, force, tolerance::CONE_ANGLE * load, "force");
    // The rail's crown has the slope of the cone 15 mm inside of its top.
    let from_top = [0.0, 0.3 * angle.sin(), 0.3 * (1.0 - angle.cos())];
    let allowed = tolerance::CONTACT_PLACE * load;
    let rail_moment = cross(from_top, force.map(|f| -f));
    assert_close(output.rails[0].moment, rail_moment, allowed, "rail");
    let place = add(from_top, [0.0, top + 3e-3, 2e-3]);
    let arm = [0, 1, 2].map(|i| place[i] - input.wheel.position[i]);
    assert_close(output.wheel.moment, cross(arm, force), allowed, "wheel");
    // The rolling radius is that of the cone at the contact.
    let rolling_radius = 0.46 - tangent * arm[1];
    assert!((patch.rolling_radius - rolling_radius).abs() < tolerance::CONTACT_PLACE);
}

#[test]
fn a_driving_torque_balances_the_longitudinal_force_times_the_rolling_radius() {
    let mut element = element(&Parameters::default());
    let mut input = rolling(0.0, 20.0);
    input.wheel.pitch_rate *= 1.003;
    let input = pressed(&mut element, &input, 6e-5);
    let output = evaluate(&mut element, &input);
    let patch = the_patch(&output);
    // A wheel driven forward is pushed forward; the rail brakes its turning, which is negative.
    assert!(output.wheel.force[0] > 0.0 && output.wheel.moment[1] > 0.0);
    let torque = patch.rolling_radius * output.wheel.force[0];
    let rest = output.wheel.moment[1] - torque;
    // What is left: overlap, and the share of the spin moment in a contact inclined by a few
    // degrees.
    assert!(rest.abs() < tolerance::AXLE_MOMENT * torque, "{rest} of {torque}");
}

#[test]
fn the_left_side_is_the_mirror_image_of_the_right_bit_for_bit() {
    both_descriptions().iter().for_each(assert_mirrored_sides);
}

fn assert_mirrored_sides(parameters: &Parameters) {
    let left_parameters = Parameters { side: Side::Left, ..parameters.clone() };
    let mut right = element(parameters);
    let mut left = Element::new(&left_parameters, &mirrored(&Input::default()), &[]).unwrap();
    assert_eq!(left.nominal_wheel_z().to_bits(), right.nominal_wheel_z().to_bits());
    let mut random = Random::new(5);
    let same = |a: f64, b: f64| assert!((a - b).abs() <= 0.0, "{a} and {b}");
    for _ in 0..200 {
        let input = random_input(&mut right, &mut random);
        let (r, l) = (evaluate(&mut right, &input), evaluate(&mut left, &mirrored(&input)));
        for (r, l) in [(r.wheel, l.wheel), (r.rails[0], l.rails[0])] {
            for (i, sign) in [1.0, -1.0, 1.0].into_iter().enumerate() {
                same(l.force[i], sign * r.force[i]);
                same(l.moment[i], -sign * r.moment[i]);
            }
        }
        assert_eq!(l.patch_count, r.patch_count);
        same(l.wear_number, r.wear_number);
        for (r, l) in r.patches.iter().zip(&l.patches) {
            same(l.normal_force, r.normal_force);
            same(l.creep_force[0], r.creep_force[0]);
            same(l.creep_force[1], -r.creep_force[1]);
            same(l.spin_moment, -r.spin_moment);
            same(l.contact_angle, -r.contact_angle);
            same(l.position[0], r.position[0]);
            same(l.position[1], -r.position[1]);
            same(l.creepage[0], r.creepage[0]);
            same(l.creepage[1], -r.creepage[1]);
            same(l.creepage[2], -r.creepage[2]);
            same(l.rail_y, r.rail_y);
            same(l.max_pressure, r.max_pressure);
        }
    }
}

/// Wheel and rail turned together about the marker of the rail, motions and all.
fn turned(input: &Input, marker: [f64; 3], angle: f64) -> Input {
    let (sine, cosine) = angle.sin_cos();
    let turn =
        |y: &mut f64, z: &mut f64| (*y, *z) = (*y * cosine - *z * sine, *y * sine + *z * cosine);
    let mut all = *input;
    let rail = &mut all.rails[0];
    let [_, y, z] = add(marker, [0.0, rail.y, rail.z]);
    rail.roll += angle;
    turn(&mut rail.vy, &mut rail.vz);
    let wheel = &mut all.wheel;
    wheel.roll += angle;
    let [_, wheel_y, wheel_z] = &mut wheel.position;
    (*wheel_y, *wheel_z) = (*wheel_y - y, *wheel_z - z);
    turn(wheel_y, wheel_z);
    (*wheel_y, *wheel_z) = (*wheel_y + y, *wheel_z + z);
    let [_, vy, vz] = &mut wheel.velocity;
    turn(vy, vz);
    all
}

#[test]
fn turning_wheel_and_rail_together_turns_their_forces_and_nothing_else() {
    both_descriptions().iter().for_each(assert_turned);
}

fn assert_turned(parameters: &Parameters) {
    let mut element = element(parameters);
    let marker = rail_marker(parameters);
    let mut random = Random::new(10);
    for _ in 0..200 {
        let input = random_input(&mut element, &mut random);
        let angle = random.about(0.03);
        let (sine, cosine) = angle.sin_cos();
        let turn = |[x, y, z]: [f64; 3]| [x, y * cosine - z * sine, y * sine + z * cosine];
        let (one, two) = (
            evaluate(&mut element, &input),
            evaluate(&mut element, &turned(&input, marker, angle)),
        );
        let allowed = tolerance::MIRRORED * dot(one.wheel.force, one.wheel.force).sqrt();
        for (one, two) in [(one.wheel, two.wheel), (one.rails[0], two.rails[0])] {
            assert_close(two.force, turn(one.force), allowed, "force");
            assert_close(two.moment, turn(one.moment), allowed, "moment");
        }
        for (one, two) in one.patches.iter().zip(&two.patches).take(one.patch_count as usize) {
            assert!((two.contact_angle - one.contact_angle - angle).abs() < tolerance::MIRRORED);
            assert_close(two.creepage, one.creepage, tolerance::MIRRORED, "creepage");
        }
    }
}

#[test]
fn running_backwards_is_the_mirror_image_across_the_track() {
    both_descriptions().iter().for_each(assert_mirrored_runs);
}

fn assert_mirrored_runs(parameters: &Parameters) {
    let mut element = element(parameters);
    let mut random = Random::new(6);
    for _ in 0..200 {
        let input = random_input(&mut element, &mut random);
        let (forth, back) =
            (evaluate(&mut element, &input), evaluate(&mut element, &reversed(&input)));
        let [fx, fy, fz] = forth.wheel.force;
        let [mx, my, mz] = forth.wheel.moment;
        let allowed = tolerance::MIRRORED * dot([fx, fy, fz], [fx, fy, fz]).sqrt();
        assert_close(back.wheel.force, [-fx, fy, fz], allowed, "force");
        assert_close(back.wheel.moment, [mx, -my, -mz], allowed, "moment");
    }
}

#[test]
fn the_force_grows_as_deep_as_the_outlines_go_and_a_wheel_that_is_deeper_is_told_from_a_lifted_one()
{
    use NormalModel::{Hertz, PiotrowskiKik, PiotrowskiKikCorrected, Strips};
    for normal_model in [Hertz, PiotrowskiKik, PiotrowskiKikCorrected, Strips] {
        for y in [0.745, 0.75, 0.757] {
            let mut element = element(&Parameters { normal_model, ..Parameters::default() });
            let mut input = Input { friction: 0.0, ..Input::default() };
            input.wheel.position[1] = y;
            let touching = element.touching_height(&input);
            let what = |depth: f64| format!("{normal_model:?} at y = {y} m, {depth} m deep");
            let mut before = 0.0;
            for step in 1..=100 {
                let depth = 1e-3 * f64::from(step);
                input.wheel.position[2] = touching + depth;
                let output = evaluate(&mut element, &input);
                if let Some(sunk) = element.sunk() {
                    // Two thirds of the head.
                    assert!(depth > 0.02 && (sunk - depth).abs() < 0.01, "{}", what(depth));
                    assert_eq!((output.patch_count, output.wheel), (0, Wrench::default()));
                } else {
                    // Models that take turns differ by some per cent.
                    let force = -output.wheel.force[2];
                    assert!(force > 0.9 * before, "{}: {force} after {before}", what(depth));
                    assert!(output.patch_count > 0);
                    before = force;
                }
            }
            assert!(before > 1e8 && element.sunk().is_some());
            input.wheel.position[2] = touching - 1e-3;
            evaluate(&mut element, &input);
            assert_eq!(element.sunk(), None);
        }
    }
    // Beside the gauge face a wheel is not inside, however low it hangs.
    let mut element = element(&Parameters::default());
    let mut input = Input::default();
    for (y, z) in [(0.645, -0.40), (0.645, -0.45), (0.63, -0.44), (0.88, -0.40)] {
        (input.wheel.position[1], input.wheel.position[2]) = (y, z);
        evaluate(&mut element, &input);
        assert_eq!(element.sunk(), None, "{y} {z}");
    }
}

#[test]
fn the_height_of_first_touch_is_known_to_the_last_digit() {
    let mut element = element(&Parameters::default());
    let mut random = Random::new(11);
    for _ in 0..100 {
        let mut input = random_input(&mut element, &mut random);
        let touching = element.touching_height(&input);
        let mut contacts = |z: f64| {
            input.wheel.position[2] = z;
            element.flat_contacts(&input).unwrap().len()
        };
        assert!(contacts(touching) > 0, "{input:?}");
        assert_eq!(contacts(touching.next_down()), 0, "{input:?}");
    }
}

#[test]
fn an_overlap_that_two_contacts_reach_is_laid_flat_once() {
    let parameters = Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() };
    let mut input = Input::default();
    input.wheel.position[1] = 0.755_663;
    input.wheel.yaw = -0.002_366;
    input.wheel_load = 47_722.0;
    let mut element = Element::new(&parameters, &input, &[]).unwrap();
    let mut output = Output::default();
    element.evaluate(&input, &mut output).unwrap();
    input.wheel.position[2] = output.wheel_z;
    // The place that reaches 0.8 um deep beside the loaded one is no second contact of its load.
    let contacts = element.flat_contacts(&input).unwrap();
    assert_eq!((output.patch_count, contacts.len()), (1, 1));
}

#[test]
fn no_height_of_first_touch_comes_of_a_number_that_is_none() {
    let mut element = Element::new(&Parameters::default(), &Input::default(), &[]).unwrap();
    for break_it in [
        |input: &mut Input| input.wheel.position[1] = f64::NAN,
        |input: &mut Input| input.wheel.yaw = f64::INFINITY,
        |input: &mut Input| input.wheel.position[2] = f64::NAN,
    ] {
        let mut input = Input::default();
        break_it(&mut input);
        assert!(element.touching_height(&input).is_nan());
        assert!(element.touch(&input).is_none());
    }
}

#[test]
fn where_the_contact_line_folds_forces_stay_those_of_a_wheel() {
    // As deep as a wrong start, or a trial step of an integrator, may put a wheel.
    let poses = [
        (
            ["S1002", "60E1"],
            [
                0.767_802_915_345_906_7,
                -0.459_838_661_640_632_86,
                0.005_868_422_627_421_102,
                -0.041_875_669_075_498_306,
            ],
        ),
        (
            ["S1002", "60E1"],
            [0.755_059_183_530_687, -0.46, -0.001_981_820_227_824_553, -0.035_025_048_902_179_55],
        ),
        (
            ["S1002", "54E1"],
            [
                0.743_950_688_944_237_3,
                -0.458_866_853_528_51,
                -0.037_313_559_131_892_06,
                0.039_895_752_957_705_755,
            ],
        ),
        (
            ["S1002", "arc:0.3"],
            [
                0.757_328_507_371_125_4,
                -0.471_408_504_172_941_7,
                -0.004_239_530_335_236_374,
                0.011_769_217_773_909_787,
            ],
        ),
        (
            ["convex:0.3", "arc:0.3"],
            [
                0.718_205_034_624_300_2,
                -0.454_399_127_151_646_5,
                0.001_776_911_436_787_389_6,
                0.007_333_326_032_677_093,
            ],
        ),
    ];
    for ([wheel, rail], [y, z, roll, yaw]) in poses {
        let mut parameters = Parameters::default();
        parameters.wheel.profile = wheel.into();
        parameters.rails[0].profile = rail.into();
        let mut element = Element::new(&parameters, &Input::default(), &[]).unwrap();
        let mut output = Output::default();
        let mut force = |z: f64| {
            let mut input = Input::default();
            input.wheel.position = [0.0, y, z];
            (input.wheel.roll, input.wheel.yaw) = (roll, yaw);
            element.evaluate(&input, &mut output).unwrap();
            output.wheel.force[2]
        };
        let (here, above) = (force(z), force(z - 1e-7));
        assert!((here / above - 1.0).abs() < 0.01, "{wheel} on {rail}: {here:e} {above:e}");
    }
}
