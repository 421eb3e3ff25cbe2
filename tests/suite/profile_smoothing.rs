//! Smoothing chosen from the noise of the points: curvature and greatest pressure against the exact
//! profiles.
//!
//! Points of S1002 and 60E1, as they would stand in a file: exact but for their digits, and with
//! noise in both directions. The table stands in target/reports/profile_smoothing.csv.

use crate::tolerance;
use std::fmt::Write;
use std::fs;

use crate::common::random::Random;
use crate::common::{quantiles, write_report};
use tempfile::TempDir;
use wheelrail::element::parameters::{AUTOMATIC_SMOOTHING, NormalModel, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::geometry::profile::{Profile, ProfileKind, ProfileRemark};
use wheelrail::io::load_profile;

const WHEEL: ProfileKind = ProfileKind::Wheel;
const RAIL: ProfileKind = ProfileKind::Rail;

/// Lateral places of the wheel: tread, gauge corner, flange root [mm].
const SHIFTS_MM: [f64; 6] = [-4.0, -1.5, 0.0, 2.5, 5.2, 5.8];
/// Load of the wheel [N].
const LOAD: f64 = 8e4;

/// How the points of a file were made.
#[derive(Clone, Copy, Debug)]
struct Points {
    /// Distance along the profile [mm].
    spacing: f64,
    /// Decimals of a millimetre.
    digits: usize,
    /// Standard deviation in y and z [um].
    noise: f64,
}

impl Points {
    /// Points of a standard profile as text.
    fn text(self, name: &str, kind: ProfileKind) -> String {
        let curve = load_profile("profile", name, kind, 0.0, &[]).unwrap().curve;
        let length = curve.end() - curve.start();
        let count = (1e3 * length / self.spacing).round() as usize;
        let mut random = Random::new(1);
        // Twelve even numbers have the variance 4 of numbers within 1.
        let mut normal = || (0..12).map(|_| random.about(1.0)).sum::<f64>() / 2.0;
        (0..=count).fold(String::new(), |mut text, i| {
            let at = curve.at(curve.start() + length * i as f64 / count as f64).point;
            let [y, z] = at.map(|x| 1e3 * x + 1e-3 * self.noise * normal());
            writeln!(text, "{y:.0$} {z:.0$}", self.digits).unwrap();
            text
        })
    }
}

/// Errors of the curvature along the parts that wheels touch, over the exact one: median, 95 % and
/// worst [1/m].
fn curvature_errors(found: &Profile, name: &str, kind: ProfileKind) -> [f64; 3] {
    let exact = load_profile("profile", name, kind, 0.0, &[]).unwrap().curve;
    let middle = exact.end() - exact.start();
    let found = &found.curve;
    let lengths = (found.end() - found.start()) / middle;
    let errors = (1..2000)
        .map(|i| exact.start() + middle * f64::from(i) / 2000.0)
        .filter(|&s| exact.at(s).point[0].abs() < 0.045 && exact.at(s).point[1] < 0.012)
        .map(|s| {
            let at = found.start() + (s - exact.start()) * lengths;
            (found.at(at).curvature() - exact.at(s).curvature()).abs()
        });
    quantiles(errors.collect())
}

/// Greatest pressure at each shift [Pa].
fn pressures(wheel: &Profile, rail: &Profile) -> Vec<f64> {
    let parameters = Parameters {
        normal_model: NormalModel::Strips,
        vertical_mode: VerticalMode::Load,
        strips: 15,
        ..Parameters::default()
    };
    let mut input = Input { wheel_load: LOAD, ..Input::default() };
    let rails = [Some(rail.clone()), None];
    let mut element = Element::with_profiles(&parameters, &input, wheel, &rails).unwrap();
    let y = input.wheel.position[1];
    SHIFTS_MM
        .iter()
        .map(|shift| {
            input.wheel.position[1] = y + 1e-3 * shift;
            let mut output = Output::default();
            element.evaluate(&input, &mut output).unwrap();
            output.patches[0].max_pressure
        })
        .collect()
}

/// Wavelength that was chosen [mm].
fn chosen(profile: &Profile) -> f64 {
    let chosen = profile.remarks.iter().find_map(|remark| match remark {
        ProfileRemark::Smoothing { wavelength, .. } => Some(1e3 * wavelength),
        _ => None,
    });
    chosen.unwrap_or(f64::NAN)
}

/// Measures `cases` with each smoothing and writes the table; the worst errors of the greatest
/// pressure [%], case by case.
fn measure(cases: &[Points], smoothings: &[f64], name: &str) -> Vec<f64> {
    let folder = TempDir::new().unwrap();
    let folders = [folder.path().to_path_buf()];
    let [wheel, rail] = [("S1002", WHEEL), ("60E1", RAIL)]
        .map(|(name, kind)| load_profile("profile", name, kind, 0.0, &[]).unwrap());
    let reference = pressures(&wheel, &rail);
    let mut report = String::from(
        "spacing_mm,digits,noise_um,smoothing,wheel_mm,rail_mm,wheel curvature median,95 %,rail curvature median,95 %,\
         p_max median %,worst %\n",
    );
    let mut worst_errors = Vec::new();
    for points in cases {
        for (file, kind) in [("S1002", WHEEL), ("60E1", RAIL)] {
            fs::write(folder.path().join(format!("{file}.txt")), points.text(file, kind)).unwrap();
        }
        for &smoothing in smoothings {
            let load = |file: &str, kind| load_profile("p", file, kind, smoothing, &folders);
            let (wheel, rail) =
                (load("S1002.txt", WHEEL).unwrap(), load("60E1.txt", RAIL).unwrap());
            let found = pressures(&wheel, &rail);
            let errors = found.iter().zip(&reference).map(|(f, r)| 100.0 * (f / r - 1.0).abs());
            let [median, _, worst] = quantiles(errors.collect());
            let [w, r] = [(&wheel, "S1002"), (&rail, "60E1")]
                .map(|(profile, name)| curvature_errors(profile, name, profile.kind));
            let row = format!(
                "{},{},{},{smoothing},{:.2},{:.2},{:.3},{:.2},{:.3},{:.2},{median:.2},{worst:.2}",
                points.spacing,
                points.digits,
                points.noise,
                chosen(&wheel),
                chosen(&rail),
                w[0],
                w[1],
                r[0],
                r[1]
            );
            println!("{row}");
            writeln!(report, "{row}").unwrap();
            worst_errors.push(worst);
        }
    }
    write_report(name, &report);
    worst_errors
}

#[test]
fn exact_points_give_the_pressures_of_the_exact_profiles() {
    let cases = [(0.1, 5), (0.5, 4), (0.5, 6)].map(|(spacing, digits)| Points {
        spacing,
        digits,
        noise: 0.0,
    });
    for (points, worst) in
        cases.iter().zip(measure(&cases, &[AUTOMATIC_SMOOTHING], "profile_smoothing_exact.csv"))
    {
        assert!(worst < tolerance::EXACT_POINTS_PRESSURE, "{points:?}: {worst} %");
    }
}

#[test]
#[ignore = "the whole table: minutes"]
fn chosen_smoothing_beside_a_fixed_one_on_exact_points() {
    let all = |spacing| [4, 5, 6, 7].map(|digits| Points { spacing, digits, noise: 0.0 });
    let cases: Vec<Points> = [0.1, 0.5, 1.0].into_iter().flat_map(all).collect();
    measure(&cases, &[AUTOMATIC_SMOOTHING, 0.004], "profile_smoothing.csv");
}

#[test]
#[ignore = "the whole table: long, since the strip model is slow on noise that is left"]
fn chosen_smoothing_beside_a_fixed_one_on_noisy_points() {
    let all = |spacing| [1.0, 5.0, 20.0].map(|noise| Points { spacing, digits: 4, noise });
    let cases: Vec<Points> = [0.1, 0.5, 1.0].into_iter().flat_map(all).collect();
    measure(&cases, &[AUTOMATIC_SMOOTHING, 0.004], "profile_smoothing_noise.csv");
}
