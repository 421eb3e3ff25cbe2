//! Crossings, wheels that are not round, and how far results of two elements are apart.

use std::f64::consts::TAU;
use std::fmt::Write;
use std::fs;

use crate::common::random::Random;
use crate::common::varying::of_slices;
use crate::common::wheel::random_input;
use tempfile::TempDir;
use wheelrail::element::input::RailMotion;
use wheelrail::element::parameters::NormalModel;
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::load_profile;

/// How far the eccentric wheel stands beside its axle [m].
pub const ECCENTRICITY: f64 = 5e-4;
/// Length of the flat of the wheels with one [m].
pub const FLAT: f64 = 0.05;

pub fn element(parameters: &Parameters, folder: &TempDir) -> Element {
    Element::new(parameters, &Input::default(), &[folder.path().to_path_buf()]).unwrap()
}

pub fn write(folder: &TempDir, name: &str, text: &str) {
    fs::write(folder.path().join(name), text).unwrap();
}

/// Height of the crossing at a `station` [m], down positive, and how far it has run off there [m].
pub fn crossing_at(station: f64) -> [f64; 2] {
    let place = 1e3 * station;
    [1e-3 * (0.5 * (0.02 * place).tanh() - 1e-5 * place * place), 0.03 * station]
}

/// A crown of radius 300 mm, so wide that no wheel touches its ends, moved by (`y`, `z`) [mm]: what
/// is found at the end of a body depends on how the search steps there.
fn wide_crown([y, z]: [f64; 2]) -> String {
    (-120..=120).fold(String::new(), |text, i| {
        let angle = 0.5 * f64::from(i) / 300.0;
        let point = [300.0 * angle.sin() + y, 300.0 * (1.0 - angle.cos()) + z];
        text + &format!("{:.9} {:.9}\n", point[0], point[1])
    })
}

/// Slices `step` mm apart in `rail.slcs`: a crown of radius 300 mm that runs off by 3:100 and drops
/// by 1 mm on the way; a table of a rail that is the same all along in `even.csv`; one of a wheel
/// that is the same all around in `same.csv`.
pub fn folder(step: f64) -> TempDir {
    let folder = crossing_of(step, wide_crown);
    write(&folder, "even.csv", "station_m,profile\n-1,60E1\n-0.02,60E1\n0.03,60E1\n2,60E1\n");
    let around = "angle_deg,profile\n-180,S1002\n-60,S1002\n60,S1002\n180,S1002\n";
    write(&folder, "same.csv", around);
    folder
}

/// The same rail of sections at given (y, z) [mm].
pub fn crossing_of(step: f64, section: impl Fn([f64; 2]) -> String) -> TempDir {
    let count = (300.0 / step) as i32;
    let places = (-count..=count).map(|i| step * f64::from(i));
    crate::common::varying::slices(places, |place| {
        let [down, aside] = crossing_at(1e-3 * place);
        section([1e3 * aside, 1e3 * down])
    })
}

/// A wheel by slices with the points of the profile `name` in `wheel.slcw` and `round.txt`: at the
/// given angles [rad], its points raised as `raised` says of angle and radius [m].
pub fn wheel_of(
    folder: &TempDir,
    name: &str,
    angles: impl Iterator<Item = f64>,
    raised: impl Fn(f64, f64) -> f64,
) {
    let wheel = load_profile("wheel", name, ProfileKind::Wheel, 0.0, &[]).unwrap();
    let (start, end) = (wheel.curve.start(), wheel.curve.end());
    let points: Vec<[f64; 2]> = (0..=500)
        .map(|i| wheel.curve.at(start + (end - start) * f64::from(i) / 500.0).point)
        .collect();
    let section = |raised: &dyn Fn(f64) -> f64| {
        let mut text = String::from("# mirror_z 0\n# mirror_y 0\n");
        for [y, z] in &points {
            let z = z + raised(0.46 + z);
            writeln!(text, "{:.10} {:.10}", 1e3 * y, 1e3 * z).unwrap();
        }
        text
    };
    write(folder, "round.txt", &section(&|_| 0.0));
    let (mut listed, mut count) = (String::new(), 0);
    for angle in angles {
        let file = format!("around{count}.txt");
        write(folder, &file, &section(&|radius| raised(angle, radius)));
        writeln!(listed, "{angle:.12} '{file}'").unwrap();
        count += 1;
    }
    write(folder, "wheel.slcw", &format!("0 1\n{count}\n0 0 0\n1\n{listed}"));
}

/// The wheel S1002 that turns about an axle beside its own: at angle 0 it reaches farthest.
pub fn eccentric(folder: &TempDir) {
    let angles = (-36..36).map(|i| f64::from(i) * TAU / 72.0);
    wheel_of(folder, "S1002", angles, |angle, radius| {
        let (sine, cosine) = angle.sin_cos();
        let beside = ECCENTRICITY * sine;
        ECCENTRICITY * cosine + (radius * radius - beside * beside).sqrt() - radius
    });
}

/// What is taken off a worn flat at the angle `angle` from its middle [m].
pub fn worn(angle: f64) -> f64 {
    let away = 0.46 * angle;
    let depth = FLAT * FLAT / (16.0 * 0.46);
    if away.abs() < 0.5 * FLAT { 0.5 * depth * (1.0 + (TAU * away / FLAT).cos()) } else { 0.0 }
}

pub fn on_crossing(parameters: Parameters, wheel: &str) -> Parameters {
    let mut parameters = of_slices(parameters);
    parameters.wheel.profile = wheel.into();
    parameters
}

pub fn largest(numbers: [f64; 3]) -> f64 {
    numbers.iter().fold(0.0, |most, number| most.max(number.abs()))
}

/// Difference of force and moment [m] over the greatest force.
pub fn apart(one: &Output, other: &Output) -> [f64; 2] {
    let size = largest(one.wheel.force) + 1e3;
    let wrenches = [[one.wheel.force, other.wheel.force], [one.wheel.moment, other.wheel.moment]];
    wrenches.map(|[a, b]| largest([0, 1, 2].map(|i| a[i] - b[i])) / size)
}

/// A wheel anyhow on the crossing, pressed on it, without yaw: with it a search that ends at a
/// nanometre turns the frame on the flank and the force with it.
pub fn anyhow(element: &mut Element, random: &mut Random) -> Input {
    let mut input = random_input(element, random);
    input.rails[0] = RailMotion::default();
    input.wheel.yaw = 0.0;
    input.track_s = random.about(0.1);
    input.wheel.position[2] = element.touching_height(&input) + random.within(1e-6, 1.2e-4);
    input
}

pub const REAL_TIME: [NormalModel; 3] =
    [NormalModel::Strips, NormalModel::Hertz, NormalModel::PiotrowskiKik];
