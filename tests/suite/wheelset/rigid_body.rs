//! Both wheels against wheels moved by hand, and the sum of what they feel.

use super::*;
use nalgebra::{Matrix3, Vector3};
use wheelrail::element::Element;

/// Rotation matrix R = `R_x(roll)` `R_z(yaw)` `R_y(pitch)`, factor by factor.
fn rotation(roll: f64, yaw: f64, pitch: f64) -> Matrix3<f64> {
    let ((sr, cr), (sy, cy), (sp, cp)) = (roll.sin_cos(), yaw.sin_cos(), pitch.sin_cos());
    let about_x = Matrix3::new(1.0, 0.0, 0.0, 0.0, cr, -sr, 0.0, sr, cr);
    let about_z = Matrix3::new(cy, -sy, 0.0, sy, cy, 0.0, 0.0, 0.0, 1.0);
    let about_y = Matrix3::new(cp, 0.0, sp, 0.0, 1.0, 0.0, -sp, 0.0, cp);
    about_x * about_z * about_y
}

/// Angular velocity in the track frame: ω = roll_rate e_x + yaw_rate e_z' + pitch_rate e_axle.
fn angular_velocity(motion: &WheelMotion) -> Vector3<f64> {
    let rolled = rotation(motion.roll, 0.0, 0.0);
    let turned = rotation(motion.roll, motion.yaw, 0.0);
    Vector3::x() * motion.roll_rate
        + rolled * Vector3::z() * motion.yaw_rate
        + turned * Vector3::y() * motion.pitch_rate
}

/// The input of a wheel whose marker is a point of the body `along` e_y from the centre.
fn by_hand(input: &Input, side: usize, along: f64) -> element::Input {
    let centre = &input.wheelset;
    let arm = rotation(centre.roll, centre.yaw, centre.pitch) * Vector3::new(0.0, along, 0.0);
    let position = Vector3::from(centre.position) + arm;
    let velocity = Vector3::from(centre.velocity) + angular_velocity(centre).cross(&arm);
    element::Input {
        wheel: WheelMotion { position: position.into(), velocity: velocity.into(), ..*centre },
        wheel_load: 0.0,
        rails: input.sides[side].rails,
        track_s: input.track_s,
        friction: input.sides[side].friction,
        tread_friction: input.sides[side].tread_friction,
        gauge_face_friction: input.sides[side].gauge_face_friction,
        ..element::Input::default()
    }
}

#[test]
fn each_side_is_a_wheel_moved_with_the_rigid_body() {
    let parameters = Parameters::default();
    let mut wheelset = wheelset(&parameters);
    let mut wheels = [Side::Right, Side::Left].map(|side| {
        let own = element::Parameters { side, ..element::Parameters::default() };
        let mut start = element::Input::default();
        start.wheel.position[1] = if side == Side::Left { -HALF } else { HALF };
        Element::new(&own, &start, &[]).unwrap()
    });
    let mut random = Random::new(21);
    let (mut marker_error, mut force_error, mut loaded) = (0.0_f64, 0.0_f64, 0);
    for _ in 0..200 {
        let input = random_input(&mut random);
        let output = evaluate(&mut wheelset, &input);
        for (k, along) in [(RIGHT, HALF), (LEFT, -HALF)] {
            let (own, hand) = (input.of_side(k, along).wheel, by_hand(&input, k, along).wheel);
            let differences = (0..3).flat_map(|i| {
                [own.position[i] - hand.position[i], (own.velocity[i] - hand.velocity[i]) / 60.0]
            });
            marker_error = marker_error.max(largest(differences));
            let mut alone = element::Output::default();
            wheels[k].evaluate(&by_hand(&input, k, along), &mut alone).unwrap();
            loaded += i32::from(alone.patch_count > 0);
            let size = largest(components(&alone.wheel)).max(1.0);
            let pairs =
                [(output.sides[k].wheel, alone.wheel), (output.sides[k].rails[0], alone.rails[0])];
            for (ours, theirs) in pairs {
                let difference = components(&ours).zip(components(&theirs)).map(|(a, b)| a - b);
                force_error = force_error.max(largest(difference) / size);
            }
            // With the same marker to the last bit, the same forces to the last bit.
            wheels[k].evaluate(&input.of_side(k, along), &mut alone).unwrap();
            assert_eq!(format!("{alone:?}"), format!("{:?}", output.sides[k]));
        }
    }
    println!("markers {marker_error:e}, forces {force_error:e}, {loaded} wheels in contact");
    assert!(loaded > 300);
    assert!(marker_error < tolerance::WHEELSET_MARKER);
    assert!(force_error < tolerance::WHEELSET_FORCE);
}

#[test]
fn the_total_is_the_sum_of_both_sides_with_moments_about_the_centre() {
    let mut wheelset = wheelset(&Parameters::default());
    let mut random = Random::new(22);
    for _ in 0..100 {
        let input = random_input(&mut random);
        let output = evaluate(&mut wheelset, &input);
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for (side, along) in output.sides.iter().zip([HALF, -HALF]) {
            let arm = rotation(input.wheelset.roll, input.wheelset.yaw, 0.0) * Vector3::y() * along;
            let own = Vector3::from(side.wheel.force);
            force += own;
            moment += Vector3::from(side.wheel.moment) + arm.cross(&own);
        }
        let size = force.amax();
        assert!(
            (force - Vector3::from(output.wheelset.force)).amax() <= tolerance::ROUNDING * size
        );
        assert!(
            (moment - Vector3::from(output.wheelset.moment)).amax() <= tolerance::ROUNDING * size
        );
        let [right, left] = &output.sides;
        assert_eq!(output.patch_count, right.patch_count + left.patch_count);
        let power = right.frictional_power + left.frictional_power;
        assert!((output.frictional_power - power).abs() <= tolerance::ROUNDING * power);
        let wear = right.wear_number + left.wear_number;
        assert!((output.wear_number - wear).abs() <= tolerance::ROUNDING * wear);
    }
}
