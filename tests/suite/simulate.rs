//! `wheelrail simulate` on the packaged FMU: the run of the README, Klingel's wave, and wrong use.

use crate::host::{Arguments, Host};
use crate::packaged;
use crate::tolerance;
use std::collections::HashMap;
use std::path::Path;
use std::process::{Command, Output};

use tempfile::TempDir;
use wheelrail::fmi::v2::fmi2ExitInitializationMode;
use wheelrail::fmi::v2::types::Status;
use wheelrail::variables::WHEELSET;

type Row = HashMap<String, f64>;

/// Runs `wheelrail simulate` on the packaged unit with `options`, what it writes going to `folder`.
fn simulate(folder: &Path, options: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_wheelrail"))
        .args(["simulate", "--fmu"])
        .arg(packaged::fmu())
        .arg("--output")
        .arg(folder)
        .args(options)
        .output()
        .unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The columns of `history.csv` that are filled in every row.
fn history(folder: &Path) -> Vec<Row> {
    let mut reader = csv::Reader::from_path(folder.join("history.csv")).unwrap();
    let rows = reader.deserialize::<HashMap<String, String>>().map(Result::unwrap);
    rows.map(|row| {
        row.into_iter().filter_map(|(name, cell)| Some((name, cell.parse().ok()?))).collect()
    })
    .collect()
}

fn offset(row: &Row) -> f64 {
    row["y_mm"] - row["track_y_mm"]
}

#[test]
fn a_wheelset_meets_the_ramp_and_returns_to_the_middle_of_the_track() {
    let folder = TempDir::new().unwrap();
    let output = simulate(folder.path(), &[]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let printed = text(&output.stdout);
    for word in ["1500 kg", "100 kN", "2c/k", "Written", "evaluations"] {
        assert!(printed.contains(word), "{word} is missing in {printed}");
    }
    let rows = history(folder.path());

    let start = &rows[0];
    let load = start["right_force_z_n"] + start["left_force_z_n"];
    assert!((load + 100e3).abs() < 1.0, "the wheels carry {load} N");
    assert!(start["pitch_rate_rad_s"] < 0.0, "rolling forward has a negative pitch rate");
    let still = rows.iter().filter(|row| row["distance_m"] < 4.9);
    let drift = still.map(|row| row["y_mm"].abs()).fold(0.0, f64::max);
    assert!(drift < 1e-6, "without a ramp the wheelset drifts by {drift} mm");

    // The track moves away to the right from under the wheelset, which follows.
    let behind: Vec<&Row> = rows.iter().filter(|row| row["distance_m"] > 6.0).collect();
    let farthest = behind.iter().map(|row| offset(row)).fold(0.0, f64::min);
    assert!((-5.0..-3.0).contains(&farthest), "{farthest} mm");
    assert!(behind[0]["yaw_mrad"] > 0.0, "displaced to the left, it is steered to the right");
    let end = offset(behind[behind.len() - 1]);
    assert!(end.abs() < 0.5, "{end} mm remain");
    for row in &rows {
        for column in ["right_force_z_n", "left_force_z_n"] {
            assert!((-80e3..-20e3).contains(&row[column]), "{column} = {}", row[column]);
        }
    }
    for (name, words) in [
        ("motion.svg", ["Wheelset: S1002 on 60E1", "distance [m]"]),
        ("patches.svg", ["Left rail head", "Right wheel"]),
    ] {
        let figure = std::fs::read_to_string(folder.path().join(name)).unwrap();
        assert!(figure.contains("</svg>") && figure.contains("S1002 on 60E1"), "{name}");
        assert!(words.iter().all(|word| figure.contains(word)), "{name}");
        let bands = figure.matches("<rect").count();
        assert!(name != "patches.svg" || bands > 1000, "{bands} bands");
    }
}

/// The number behind `word` in a text.
fn number_behind(printed: &str, word: &str) -> f64 {
    let rest = &printed[printed.find(word).unwrap() + word.len()..];
    rest.split_whitespace().next().unwrap().trim_end_matches(',').parse().unwrap()
}

/// What is printed by differences the unit of a wheelset gives as outputs by derivatives.
#[test]
fn the_limits_of_the_step_are_those_that_the_unit_puts_out() {
    let folder = TempDir::new().unwrap();
    let output = simulate(folder.path(), &["--length", "0.1"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let printed = text(&output.stdout);
    let host = Host::initializing_with(&Arguments::of(&WHEELSET));
    assert_eq!(host.set_boolean("coupling.monitor", true), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    let row = &history(folder.path())[0];
    let at = [
        ("wheelset.z", 1e-3 * row["z_mm"]),
        ("wheelset.vx", 15.0),
        ("wheelset.pitch_rate", row["pitch_rate_rad_s"]),
    ];
    assert_eq!(host.set_reals(&at), Status::Ok, "{}", host.last());
    for (word, name) in [
        ("k = ", "right.contact.stiffness"),
        ("c = ", "right.contact.damping"),
        ("2c/k = ", "coupling.normal_limit"),
        ("creep forces: h ≤ ", "coupling.creep_limit"),
    ] {
        let (printed, found) = (number_behind(&printed, word), host.get_real(name));
        println!("{name} {found:e}, printed {printed:e}");
        assert!((found / printed - 1.0).abs() < tolerance::LIMIT_BY_DIFFERENCES, "{name} {found}");
    }
}

/// Klingel 1883: a free pair of cones oscillates with the wavelength 2π sqrt(e r / tan γ), e being
/// half the distance of the contact points and r the rolling radius. Klingel's rails are edges. On
/// heads of radius R the contact moves as the wheelset rolls over: conicity tan γ (e + R γ)/(e - r
/// γ), and the points at rail level move e/(e - r γ) times as far as the centre; together the
/// wavelength is sqrt(e/(e + R γ)) times Klingel's, 1 % less here.
#[test]
fn free_cones_follow_klingels_wave() {
    const CONICITY: f64 = 0.05;
    const HEAD_RADIUS: f64 = 0.3;
    /// For Klingel's formula as it stands: the 1 % of round rail heads and half as much again.
    const TOLERANCE: f64 = 0.015;
    /// With round rail heads: amplitude, inertia and spin creepage remain.
    const TOLERANCE_ON_ROUND_HEADS: f64 = 0.001;
    let folder = TempDir::new().unwrap();
    let options = [
        "--wheel-profile=conical:0.05",
        "--rail-profile=arc:0.3",
        "--inclination=0",
        "--mass=500",
        "--inertia=300",
        "--stiffness=0,0,0",
        "--damping=0,0,0",
        "--speed=5",
        "--ramp=0.002",
        "--length=60",
        // Cones on arcs touch in ellipses.
        "--set=normal.model=hertz",
        "--set=tangential.model=fastsim",
    ];
    let output = simulate(folder.path(), &options);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let rows = history(folder.path());
    let half_distance = 1e-3 * rows[0]["right_patch1_position_y_mm"];
    let radius = 1e-3 * rows[0]["right_patch1_rolling_radius_mm"];
    let klingel = 2.0 * std::f64::consts::PI * (half_distance * radius / CONICITY).sqrt();
    let on_round_heads =
        klingel * (half_distance / (half_distance + HEAD_RADIUS * CONICITY.atan())).sqrt();

    let behind: Vec<(f64, f64)> = rows
        .iter()
        .filter(|row| row["distance_m"] > 6.0)
        .map(|row| (row["distance_m"], offset(row)))
        .collect();
    let crossings: Vec<f64> = behind
        .windows(2)
        .filter(|pair| pair[0].1 * pair[1].1 < 0.0)
        .map(|pair| {
            let ((s0, y0), (s1, y1)) = (pair[0], pair[1]);
            s0 + (s1 - s0) * y0 / (y0 - y1)
        })
        .collect();
    assert!(crossings.len() >= 5, "{crossings:?}");
    let half_waves = (crossings.len() - 1) as f64;
    let wavelength = 2.0 * (crossings[crossings.len() - 1] - crossings[0]) / half_waves;
    let error = wavelength / klingel - 1.0;
    assert!(error.abs() < TOLERANCE, "wavelength {wavelength} m, by Klingel {klingel} m");
    let error = wavelength / on_round_heads - 1.0;
    assert!(
        error.abs() < TOLERANCE_ON_ROUND_HEADS,
        "wavelength {wavelength} m, on round heads {on_round_heads} m"
    );
    println!("wavelength {wavelength} m, Klingel {klingel} m, on round heads {on_round_heads} m");
}

#[test]
fn a_run_repeats_to_the_last_bit() {
    let runs = [(); 2].map(|()| {
        let folder = TempDir::new().unwrap();
        let output = simulate(folder.path(), &["--length=8"]);
        assert!(output.status.success(), "{}", text(&output.stderr));
        std::fs::read(folder.path().join("history.csv")).unwrap()
    });
    assert!(runs[0] == runs[1]);
}

#[test]
fn wrong_use_is_explained() {
    let folder = TempDir::new().unwrap();
    let message = |options: &[&str]| {
        let output = simulate(folder.path(), options);
        assert_eq!(output.status.code(), Some(1));
        text(&output.stderr)
    };
    let unknown = message(&["--set", "normal.modell=hertz"]);
    assert!(unknown.contains("no variable \"normal.modell\""), "{unknown}");
    let item = message(&["--set", "normal.model=kik"]);
    assert!(item.contains("\"kik\" is not one of hertz"), "{item}");
    let profile = message(&["--wheel-profile", "no_such.prw"]);
    assert!(profile.contains("no_such.prw"), "{profile}");
    let damping = message(&["--set", "normal.damping=0"]);
    assert!(damping.contains("--set normal.damping=1e5"), "{damping}");
}

/// Slices of a crown whose height along the track is `height` of the station in mm, both in mm.
fn crowns(folder: &Path, height: impl Fn(f64) -> f64) -> String {
    let places: Vec<f64> = (-10..=60).map(|i| 50.0 * f64::from(i)).collect();
    let mut slices = String::new();
    for (i, place) in places.iter().enumerate() {
        let points: Vec<String> = (-60..=60)
            .map(|k| {
                let angle = 0.5 * f64::from(k) / 300.0;
                let z = 300.0 * (1.0 - angle.cos()) - height(*place);
                format!("{:.9} {z:.9}", 300.0 * angle.sin())
            })
            .collect();
        std::fs::write(folder.join(format!("{i}.txt")), points.join("\n")).unwrap();
        slices += &format!("{place} '{i}.txt'\n");
    }
    let path = folder.join("dip.slcs");
    std::fs::write(&path, format!("0 1\n{}\n0 0 0\n1\n{slices}", places.len())).unwrap();
    path.to_str().unwrap().into()
}

#[test]
fn a_wheelset_runs_over_a_dip_of_the_right_rail_alone() {
    let folder = TempDir::new().unwrap();
    // A wave 1 mm deep, 2 m long, from station 0 on.
    let turn = std::f64::consts::TAU / 2000.0;
    let height = |s: f64| {
        if (0.0..2000.0).contains(&s) { -0.5 * (1.0 - (turn * s).cos()) } else { 0.0 }
    };
    let rail = crowns(folder.path(), height);
    let placed = ["rail[1].placement=origin", "rail[1].position.y=0.75", "rail[1].inclination=0"];
    let mut options = vec!["--rail", &rail, "--station", "-0.4", "--speed", "2", "--length", "2.8"];
    for set in &placed {
        options.extend(["--rail-set", set]);
    }
    options.extend(["--wheel-profile", "conical:0.025", "--record-every", "0.01"]);
    let output = simulate(folder.path(), &options);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let rows = history(folder.path());
    let start = rows[0]["z_mm"] + 750.0 * 1e-3 * rows[0]["roll_mrad"];
    for row in &rows {
        // Half of a dip lowers the middle and the other half rolls the axle; slowly, so that wheels
        // stay on their rails.
        let station = 1e3 * row["distance_m"] - 400.0;
        let down = row["z_mm"] + 750.0 * 1e-3 * row["roll_mrad"] - start;
        assert!((down + height(station)).abs() < 0.03, "{station}: {down}");
        assert!(row["left_force_z_n"] < -30e3 && row["right_force_z_n"] < -30e3);
    }
    let figure = std::fs::read_to_string(folder.path().join("along_rail.svg")).unwrap();
    for part in ["dip.slcs", "station [m]", "normal force [kN]"] {
        assert!(figure.contains(part), "{part}");
    }
}

#[test]
fn what_is_wrong_with_the_right_rail_is_told() {
    let folder = TempDir::new().unwrap();
    let told = |options: &[&str], parts: &[&str]| {
        let output = simulate(folder.path(), options);
        assert!(!output.status.success());
        let message = text(&output.stderr);
        for part in parts {
            assert!(message.contains(part), "{part} is missing in {message}");
        }
    };
    told(&["--rail", "nowhere.slcs"], &["rail[1].profile", "nowhere.slcs"]);
    told(&["--rail", "60E1", "--rail-set", "wheel.y=1"], &["--rail-set wheel.y"]);
    told(&["--rail-set", "rail[1].inclination=0"], &["--rail"]);
    told(&["--rail", "60E1", "--station", "nan"], &["--station"]);
}
