//! The table of docs/frames.md takes other codes' quantities to ours: every row belongs together
//! and is right.

use crate::tolerance;
use std::path::Path;

use crate::common::{read_table, value};
use nalgebra::{Matrix3, Rotation3, Vector3};
use wheelrail::element::{Element, Input, Output, Parameters};

/// One row as factors of +1 and -1.
struct Row {
    code: String,
    position: Vector3<f64>,
    angles: Vector3<f64>,
    force: Vector3<f64>,
    moment: Vector3<f64>,
    creepage: Vector3<f64>,
    angle: f64,
    profile: [f64; 2],
}

fn rows() -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/frames.md");
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().skip_while(|line| !line.starts_with("|---")).skip(1);
    lines.take_while(|line| line.starts_with('|')).map(row).collect()
}

fn row(line: &str) -> Row {
    let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
    let factors = |cell: usize, names: &[&str]| -> Vec<f64> {
        let parts: Vec<&str> = cells[cell].split(", ").collect();
        assert_eq!(parts.len(), names.len(), "{line}");
        let factor = |(part, name): (&&str, &&str)| {
            assert_eq!(part.trim_start_matches('-'), *name, "{line}");
            if part.starts_with('-') { -1.0 } else { 1.0 }
        };
        parts.iter().zip(names).map(factor).collect()
    };
    let three = |cell: usize, names: [&str; 3]| Vector3::from_vec(factors(cell, &names));
    let profile = factors(7, &["y", "z"]);
    Row {
        code: cells[0].into(),
        position: three(1, ["x", "y", "z"]),
        angles: three(2, ["roll", "yaw", "pitch"]),
        force: three(3, ["Fx", "Fy", "Fz"]),
        moment: three(4, ["Mx", "My", "Mz"]),
        creepage: three(5, ["ξ", "η", "φ"]),
        angle: factors(6, &["angle"])[0],
        profile: [profile[0], profile[1]],
    }
}

/// R_x(roll) R_z(yaw) R_y(pitch) in whatever right-handed axes.
fn attitude(angles: Vector3<f64>) -> Matrix3<f64> {
    let turn = |axis, angle| Rotation3::from_axis_angle(&axis, angle);
    let [roll, yaw, pitch] = angles.into();
    (turn(Vector3::x_axis(), roll) * turn(Vector3::z_axis(), yaw) * turn(Vector3::y_axis(), pitch))
        .into_inner()
}

#[test]
fn positions_angles_and_moments_of_a_row_belong_together() {
    let rows = rows();
    assert_eq!(rows.len(), 4);
    for row in rows {
        let axes = Matrix3::from_diagonal(&row.position);
        assert!((axes.determinant() - 1.0).abs() < 1e-12, "{} is left-handed", row.code);
        let theirs = Vector3::new(0.3, -0.2, 0.7);
        let ours = attitude(row.angles.component_mul(&theirs));
        let error = (axes * attitude(theirs) * axes - ours).norm();
        assert!(error < 1e-14, "{}: {error}", row.code);
        // Force and moment are of one body, and resolved in the axes of the positions.
        let body = row.force.component_div(&row.position);
        assert!((body - Vector3::repeat(body.x)).norm() < 1e-12, "{}", row.code);
        assert!((row.moment - row.force).norm() < 1e-12, "{}", row.code);
        // Creepages are of one body against the other: ξ along x, η across, φ about the normal.
        let sign = row.creepage.x;
        let wanted = Vector3::new(1.0, row.position.y, row.position.z) * sign;
        assert!((row.creepage - wanted).norm() < 1e-12, "{}", row.code);
        // The contact angle turns about x, heights go as z.
        assert!((row.angle - row.position.x).abs() < 1e-12, "{}", row.code);
        assert!((row.profile[1] - row.position.z).abs() < 1e-12, "{}", row.code);
    }
}

#[test]
fn a_wheel_placed_in_their_frame_gives_the_forces_their_frame_expects() {
    // Right of the track's centre, flange on the rail, yawed towards it, slipping sideways.
    let mut ours = Input::default();
    ours.wheel.position = [0.0, 0.7575, -0.4598];
    ours.wheel.yaw = 0.01;
    ours.wheel.velocity = [20.0, 0.0, 0.0];
    ours.wheel.pitch_rate = -20.0 / 0.46;
    for row in rows() {
        let place = |v: [f64; 3]| row.position.component_mul(&Vector3::from(v));
        let theirs = (place(ours.wheel.position), row.angles.y * ours.wheel.yaw);
        let mut input = ours;
        input.wheel.position = row.position.component_mul(&theirs.0).into();
        input.wheel.yaw = row.angles.y * theirs.1;
        let mut element = Element::new(&Parameters::default(), &input, &[]).unwrap();
        let mut output = Output::default();
        element.evaluate(&input, &mut output).unwrap();
        let force = row.force.component_mul(&Vector3::from(output.wheel.force));
        // The rail pushes a right wheel up and towards the centre; codes that report the rail's
        // force say the opposite.
        let up = place([0.0, 0.0, -1.0]);
        let centre = place([0.0, -1.0, 0.0]);
        let on_rail = if row.code.starts_with("CONTACT") { -1.0 } else { 1.0 };
        assert!(on_rail * force.dot(&up) > 1e4, "{}: {force}", row.code);
        assert!(on_rail * force.dot(&centre) > 1e3, "{}: {force}", row.code);
    }
}

#[test]
fn the_row_of_contact_takes_its_results_to_ours() {
    let contact = rows().into_iter().find(|r| r.code.starts_with("CONTACT")).unwrap();
    let table = read_table("contact_25_1/manchester_a22.csv");
    // Right wheel, 2 mm to the right, 4.8 mrad of yaw: one patch on the tread.
    let row = table
        .rows
        .iter()
        .find(|r| &r[5] == "right" && (value(&table, r, "y_ws_mm") - 2.0).abs() < 1e-9);
    let v = |name: &str| value(&table, row.unwrap(), name);
    let (arm, roll, yaw) = (0.75, v("roll_rad"), v("yaw_rad"));
    let angles = contact.angles.component_mul(&Vector3::new(roll, yaw, 0.0));
    let centre = Vector3::new(0.0, 1e-3 * v("y_ws_mm"), 1e-3 * v("z_ws_mm") - 0.46);
    let centre = contact.position.component_mul(&centre);
    let mut input = Input::default();
    input.wheel.position = (centre + attitude(angles) * Vector3::new(0.0, arm, 0.0)).into();
    input.wheel.roll = angles.x;
    input.wheel.yaw = angles.y;
    input.wheel.velocity = [2.0, 0.0, 0.0];
    input.wheel.pitch_rate = contact.angles.z * v("pitch_vel_rad_s");
    let mut element = Element::new(&Parameters::default(), &input, &[]).unwrap();
    let mut output = Output::default();
    element.evaluate(&input, &mut output).unwrap();
    let patch = output.patches[0];
    let angle = contact.angle * v("delta_deg").to_radians();
    assert!((patch.contact_angle - angle).abs() < 0.01, "{} {angle}", patch.contact_angle);
    let creepages = [v("cksi"), v("ceta"), 1e3 * v("cphi_per_mm")];
    let wanted = contact.creepage.component_mul(&Vector3::from(creepages));
    let near = |ours: f64, theirs: f64, share: f64, what: &str| {
        assert!((ours - theirs).abs() < share * theirs.abs(), "{what}: {ours} against {theirs}");
    };
    near(patch.creepage[1], wanted.y, tolerance::FRAMES_SHARE, "lateral creepage");
    near(patch.creepage[2], wanted.z, tolerance::FRAMES_SHARE, "spin");
    let forces = [v("Fx_tr_N"), v("Fy_tr_N"), v("Fz_tr_N")];
    let wanted = contact.force.component_mul(&Vector3::from(forces));
    for (k, axis) in ["x", "y", "z"].iter().enumerate() {
        let share = output.wheel.force[k] / output.wheel.force[2];
        near(share, wanted[k] / wanted.z, tolerance::FRAMES_SHARE, &format!("force {axis}"));
    }
    assert!(output.wheel.force[2] < 0.0 && wanted.z < 0.0);
}

#[test]
fn angles_and_rates_come_from_any_rotation() {
    let [roll, yaw, pitch] = [0.05, -0.03, 2.0];
    let [roll_rate, yaw_rate, pitch_rate] = [0.4, -0.7, -43.0];
    let r = attitude(Vector3::new(roll, yaw, pitch));
    let u = r * Vector3::y();
    assert!((-u.x.asin() - yaw).abs() < 1e-14);
    assert!((u.z.atan2(u.y) - roll).abs() < 1e-14);
    // The angular velocity from differences of the rotation itself.
    let h = 1e-6;
    let at = |t: f64| {
        let angles = [roll + t * roll_rate, yaw + t * yaw_rate, pitch + t * pitch_rate];
        attitude(angles.into())
    };
    let skew = (at(h) - at(-h)) / (2.0 * h) * r.transpose();
    let omega = Vector3::new(skew[(2, 1)], skew[(0, 2)], skew[(1, 0)]);
    let e_y = Vector3::new(0.0, roll.cos(), roll.sin());
    let e_z = Vector3::new(0.0, -roll.sin(), roll.cos());
    let found_pitch_rate = omega.dot(&e_y) / yaw.cos();
    assert!((omega.dot(&e_z) - yaw_rate).abs() < 1e-6);
    assert!((found_pitch_rate - pitch_rate).abs() < 1e-6);
    assert!((omega.x + found_pitch_rate * yaw.sin() - roll_rate).abs() < 1e-6);
}
