//! Wheels of simple shapes on rollers, as CONTACT's table of them has them.

use std::fmt::Write;
use std::fs;

use tempfile::TempDir;
use wheelrail::element::parameters::Placement;
use wheelrail::element::{Element, Input, Parameters};

use super::planar::STEEL;
use super::wheel::{evaluate, pressed, the_patch};
use super::{read_table, value};

/// Errors of a wheel on a roller.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// Of normal force and greatest pressure, over those of the reference.
    pub force: f64,
    pub pressure: f64,
    /// Of the lateral place [m].
    pub place: f64,
    /// Of the contact angle [rad].
    pub angle: f64,
    /// Of the spin [1/m].
    pub spin: f64,
    /// Of the creep force, over the friction limit.
    pub creep: f64,
    /// Of the spin moment, over the limit times 1 mm.
    pub moment: f64,
}

/// A rail profile that is a cone of `angle` which falls to the field side, 200 mm wide.
fn cone(angle: f64) -> TempDir {
    let folder = TempDir::new().unwrap();
    let text = (-200..=200).fold(String::from("# mirror_z 0\n"), |mut text, i| {
        let y = 0.5 * f64::from(i);
        writeln!(text, "{y} {:.9}", y * angle.tan()).unwrap();
        text
    });
    fs::write(folder.path().join("cone.txt"), text).unwrap();
    folder
}

/// Errors of the models of `parameters` in all rows of CONTACT's table of rollers, with the name of
/// the row; approach and creepages are the reference's.
pub fn errors_against_contact(parameters: &Parameters) -> Vec<(String, Errors)> {
    let table = read_table("contact_25_1/rollers.csv");
    let folder = cone(0.2);
    let mut all = Vec::new();
    for row in &table.rows {
        let of = |name: &str| value(&table, row, name);
        let case = &row[0];
        let is_cone = ["cone", "rolled"].contains(&case);
        let mut parameters = parameters.clone();
        let (wheel, rail) =
            if is_cone { ("convex:0.1", "cone.txt") } else { ("cylindrical", "arc:0.1") };
        (parameters.wheel.profile, parameters.rails[0].profile) = (wheel.into(), rail.into());
        parameters.wheel.nominal_radius = 0.13349;
        (parameters.wheel.young_modulus, parameters.rail_young_modulus) =
            (STEEL.young_modulus, STEEL.young_modulus);
        let place = &mut parameters.rails[0];
        (place.placement, place.inclination) = (Placement::Origin, 0.0);
        place.position = [if case == "skew" { 0.0 } else { 0.2 }, 0.0];
        // The marker of the cone is its highest point, 0.1 m to the track side.
        place.roller_radius = if is_cone { 0.4 + 0.1 * 0.2_f64.tan() } else { 0.4 };
        let mut element =
            Element::new(&parameters, &Input::default(), &[folder.path().to_path_buf()]).unwrap();
        let mut input = Input::default();
        let w = &mut input.wheel;
        w.position = [0.0, 1e-3 * of("y_mm"), -0.14];
        (w.roll, w.yaw, w.pitch_rate) = (of("roll_rad"), of("yaw_rad"), of("pitch_rate_rad_s"));
        input.rails[0].pitch_rate = of("roller_pitch_rate_rad_s");
        let angle = of("angle_rad");
        let mut input = pressed(&mut element, &input, 1e-3 * of("approach_mm") / angle.cos());
        // Rates as printed give creepages to some 1e-5 alone.
        let speed = 1e-3 * of("speed_mm_s");
        let wanted = [-of("cksi"), -of("ceta")];
        for _ in 0..6 {
            let patch = the_patch(&evaluate(&mut element, &input));
            let missing = [0, 1].map(|i| speed * (wanted[i] - patch.creepage[i]));
            input.wheel.pitch_rate += missing[0] / (patch.rolling_radius * input.wheel.yaw.cos());
            input.wheel.velocity[1] += missing[1] / angle.cos();
        }
        let patch = the_patch(&evaluate(&mut element, &input));
        let limit = 0.3 * of("N_N");
        let force = patch.normal_force / of("N_N") - 1.0;
        let pressure = patch.max_pressure / (1e6 * of("pmax_MPa")) - 1.0;
        let place = patch.position[1] - 1e-3 * of("y_contact_mm");
        let turned = patch.contact_angle - angle;
        let spin = patch.creepage[2] + 1e3 * of("cphi_rad_mm");
        let [fx, fs] = patch.creep_force;
        let creep = (fx + of("Fx_N")).hypot(fs + of("Fs_N")) / limit;
        let moment = (patch.spin_moment + 1e-3 * of("Mn_Nmm")) / (limit * 1e-3);
        let errors = Errors { force, pressure, place, angle: turned, spin, creep, moment };
        all.push((case.to_owned(), errors));
    }
    all
}
