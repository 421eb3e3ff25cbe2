//! Profile files as they are found: comments, headings, units, mirrors and stray points are mended
//! and told; rails stand by gauge or by position.
#![allow(unsafe_code)]
// The box fixes the address that the logger gets.
#![allow(clippy::unnecessary_box_returns)]

use crate::common;
use std::fmt::Write;
use std::fs;

use crate::common::wheel::{element, evaluate, pressed, rail_marker, rolling};
use crate::host::{Arguments, Host};
use tempfile::TempDir;
use wheelrail::element::parameters::{AUTOMATIC_SMOOTHING, Placement, Side};
use wheelrail::element::{Element, Input, Parameters};
use wheelrail::fmi::v2::fmi2ExitInitializationMode;
use wheelrail::fmi::v2::types::Status;
use wheelrail::geometry::profile::{Profile, ProfileKind, ProfileRemark};
use wheelrail::io::load_profile;
use wheelrail::variables::{WHEEL, WHEELSET};

/// Points of a standard profile, 0.3 mm apart [mm].
fn points(name: &str, kind: ProfileKind) -> Vec<[f64; 2]> {
    let curve = load_profile("profile", name, kind, 0.0, &[]).unwrap().curve;
    let length = curve.end() - curve.start();
    let count = (length / 3e-4).round();
    (0..=count as usize)
        .map(|i| curve.at(curve.start() + length * i as f64 / count).point.map(|x| 1e3 * x))
        .collect()
}

fn lines(points: &[[f64; 2]]) -> String {
    points.iter().fold(String::new(), |mut text, [y, z]| {
        writeln!(text, "{y:14.6} {z:14.6}").unwrap();
        text
    })
}

fn simpack(kind: u8, entries: &str, body: &str) -> String {
    format!(
        "header.begin\n  version = 1\n  type = {kind}\nheader.end\nspline.begin\n{entries}\n  point.begin\n{body}  point.end\nspline.end\n"
    )
}

fn read(file: &str, content: &str, kind: ProfileKind) -> Profile {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(file), content).unwrap();
    let folders = [folder.path().to_path_buf()];
    load_profile("profile", file, kind, AUTOMATIC_SMOOTHING, &folders)
        .unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// What was mended, as text.
fn warnings(profile: &Profile) -> Vec<String> {
    profile.remarks.iter().filter(|r| r.is_warning()).map(ToString::to_string).collect()
}

#[test]
fn files_with_peculiarities_give_the_profile_that_is_meant() {
    let (rail, wheel) = (points("60E1", ProfileKind::Rail), points("S1002", ProfileKind::Wheel));
    let scaled = |points: &[[f64; 2]], y: f64, z: f64| -> Vec<[f64; 2]> {
        points.iter().map(|p| [y * p[0], z * p[1]]).collect()
    };
    let body = lines(&rail);
    let commented = body
        .lines()
        .enumerate()
        .map(|(i, line)| match i % 4 {
            0 => format!("{line} % behind a point\n\"{line}\n"),
            1 => format!("% {line}\n{line}   \" also\n"),
            2 => format!("{line} ! and this\n"),
            _ => format!("{line} # too\n"),
        })
        .collect::<String>();
    let metres = rail.iter().fold(String::new(), |text, [y, z]| {
        text + &format!(" {:.10E}  {:.10E}\n", 1e-3 * y, 1e-3 * z)
    });
    let mut zigzag = rail.clone();
    zigzag.insert(200, [rail[200][0] - 1.1, rail[200][1]]);
    zigzag.swap(300, 301);
    let mm = "units.len.f = 1000.";
    let rails: [(&str, String, &[&str]); 10] = [
        ("plain.txt", body.clone(), &[]),
        ("comments.txt", commented.clone(), &[]),
        ("comments.prr", simpack(0, mm, &commented), &[]),
        (
            "headed.prr",
            simpack(0, mm, &format!("  y   z\n  474\n{body}")),
            &["no point", "no point"],
        ),
        (
            "headed.txt",
            format!("rail 60E1, new\ny_mm z_mm\n474\n{body}"),
            &["no point", "no point"],
        ),
        ("metres.txt", metres, &["read in metres"]),
        (
            "no_units.prr",
            simpack(0, "", &body),
            &["read in millimetres, in which it has the size of a profile; set units.len.f to"],
        ),
        ("zigzag.txt", lines(&zigzag), &["doubles back"]),
        ("up.txt", lines(&scaled(&rail, 1.0, -1.0)), &["mirrored in z"]),
        ("reversed.txt", lines(&rail.iter().rev().copied().collect::<Vec<_>>()), &[]),
    ];
    let wheels: [(&str, String, &[&str]); 4] = [
        ("up.txt", lines(&scaled(&wheel, 1.0, -1.0)), &["mirrored in z"]),
        ("flange.txt", lines(&scaled(&wheel, -1.0, 1.0)), &["mirrored in y"]),
        ("flange.prw", simpack(1, mm, &lines(&scaled(&wheel, -1.0, 1.0))), &["mirrored in y"]),
        ("turned.txt", lines(&scaled(&wheel, -1.0, -1.0)), &["mirrored in z", "mirrored in y"]),
    ];
    let all = rails
        .iter()
        .map(|case| (case, "60E1", ProfileKind::Rail))
        .chain(wheels.iter().map(|case| (case, "S1002", ProfileKind::Wheel)));
    for ((file, content, expected), name, kind) in all {
        let found = read(file, content, kind);
        let exact = load_profile("profile", name, kind, 0.0, &[]).unwrap();
        for (f, e) in found
            .bounds()
            .y
            .iter()
            .chain(&found.bounds().z)
            .zip(exact.bounds().y.iter().chain(&exact.bounds().z))
        {
            approx::assert_abs_diff_eq!(f, e, epsilon = 2e-6);
        }
        let warnings = warnings(&found);
        assert_eq!(warnings.len(), expected.len(), "{file}: {warnings:?}");
        for (warning, words) in warnings.iter().zip(*expected) {
            assert!(warning.contains(words) && warning.contains(file), "{warning}");
        }
    }
}

#[test]
fn rollers_and_grooves_are_profiles() {
    let ball: Vec<[f64; 2]> = (-499..=499)
        .map(|i| 0.1 * f64::from(i))
        .map(|y: f64| [-y, (2500.0 - y * y).sqrt() - 50.0])
        .collect();
    let wheel =
        read("ball.prw", &simpack(1, "units.len.f = 1000.", &lines(&ball)), ProfileKind::Wheel);
    assert!(warnings(&wheel).is_empty(), "{:?}", wheel.remarks);
    approx::assert_abs_diff_eq!(wheel.bounds().z[1], 0.0, epsilon = 1e-6);
    let groove: Vec<[f64; 2]> = (-200..=200)
        .map(|i| 0.1 * f64::from(i))
        .map(|y: f64| [y, -10.02 + (10.02 * 10.02 - y * y).max(0.0).sqrt()])
        .collect();
    let content = simpack(0, "units.len.f = 1000.", &lines(&groove));
    let rail = read("groove.prr", &content, ProfileKind::Rail);
    assert!(warnings(&rail)[0].contains("taken as it stands"));
    approx::assert_abs_diff_eq!(rail.bounds().z[1], 0.0, epsilon = 1e-6);
    // In two columns the file has to say so.
    let rail = read("groove.txt", &format!("# mirror_z 0\n{}", lines(&groove)), ProfileKind::Rail);
    approx::assert_abs_diff_eq!(rail.bounds().z[1], 0.0, epsilon = 1e-6);
    // A roller as an instrument sees it, with y down: turned up, its deep side the gauge side.
    let body: Vec<[f64; 2]> = points("60E1", ProfileKind::Rail)
        .into_iter()
        .filter(|p| p[0] < 0.0 || p[1] < 5.0)
        .collect();
    let roller = read("roller.ban", &format!("MINIPROF\n\n{}", lines(&body)), ProfileKind::Rail);
    assert!(warnings(&roller)[0].contains("mirrored in z"), "{:?}", roller.remarks);
    assert!(roller.bounds().y[0] < -0.036 && roller.bounds().y[1] < 0.035);
}

#[test]
fn what_was_mended_reaches_the_host_and_the_crate() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("up.txt");
    let up: Vec<[f64; 2]> =
        points("60E1", ProfileKind::Rail).iter().map(|p| [p[0], -p[1]]).collect();
    fs::write(&file, lines(&up)).unwrap();
    let name = file.to_str().unwrap();

    let mut parameters = Parameters::default();
    parameters.rails[0].profile = name.into();
    let element = Element::new(&parameters, &Input::default(), &[]).unwrap();
    let [(parameter, mirrored), (_, smoothing)] = element.profile_remarks() else { panic!() };
    assert_eq!(parameter, "rail[1].profile");
    assert!(matches!(mirrored, ProfileRemark::MirroredZ { .. }), "{mirrored}");
    assert!(matches!(smoothing, ProfileRemark::Smoothing { .. }), "{smoothing}");

    for (unit, prefix) in [(&WHEEL, ""), (&WHEELSET, "left.")] {
        for logging_on in [false, true] {
            let host = Host::initializing_with(&Arguments { logging_on, ..Arguments::of(unit) });
            host.set_text(&format!("{prefix}rail[1].profile"), name);
            assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
            let messages = host.messages.lock().unwrap();
            let told = |words: &str| messages.iter().find(|m| m.text.contains(words));
            let warning = told("mirrored in z").unwrap();
            assert_eq!(warning.status, Status::Warning);
            assert!(warning.text.starts_with(&format!("{prefix}rail[1].profile: ")), "{warning:?}");
            assert_eq!(told("no smoothing needed").is_some(), logging_on);
        }
    }
}

#[test]
fn a_rail_by_position_or_origin_stands_where_the_gauge_puts_it() {
    let by_gauge = Parameters::default();
    let [_, y, z] = rail_marker(&by_gauge);
    let mut by_position = Parameters::default();
    (by_position.rails[0].placement, by_position.rails[0].position) = (Placement::Position, [y, z]);
    let mut first = element(&by_gauge);
    let input = pressed(&mut first, &rolling(2e-3, 20.0), 6e-5);
    let expected = evaluate(&mut first, &input);
    assert_eq!(evaluate(&mut element(&by_position), &input), expected);

    // The highest point of the inclined 300 mm arc lies on the line to its centre.
    let angle = 0.025f64.atan();
    let top = [0.3 * angle.sin(), 0.3 * angle.cos() - 0.3];
    let mut by_origin = Parameters::default();
    by_origin.rails[0].placement = Placement::Origin;
    by_origin.rails[0].position = [y - top[0], z - top[1]];
    let output = evaluate(&mut element(&by_origin), &input);
    approx::assert_relative_eq!(
        output.wheel.force[2],
        expected.wheel.force[2],
        max_relative = 1e-6
    );

    // On the left everything stands in the mirror image.
    let left = by_origin.on_side(Side::Left);
    assert!(left.rails[0].position[0] < -0.7);
    let output = evaluate(&mut element(&left), &common::wheel::mirrored(&input));
    approx::assert_relative_eq!(
        output.wheel.force[2],
        expected.wheel.force[2],
        max_relative = 1e-6
    );
}

#[test]
fn a_rail_without_gauge_face_stands_by_its_origin() {
    let folder = TempDir::new().unwrap();
    let plane: Vec<[f64; 2]> = (-50..=50).map(|y| [f64::from(y), 0.0]).collect();
    fs::write(folder.path().join("plane.txt"), lines(&plane)).unwrap();
    let folders = [folder.path().to_path_buf()];
    let mut parameters = Parameters::default();
    parameters.wheel.profile = "convex:0.3".into();
    parameters.rails[0].profile = "plane.txt".into();
    parameters.rails[0].inclination = 0.0;
    let made = |parameters: &Parameters| Element::new(parameters, &Input::default(), &folders);
    let refused = made(&parameters).unwrap_err().to_string();
    assert!(refused.contains("rail[1].placement = position or origin"), "{refused}");
    parameters.rails[0].placement = Placement::Origin;
    let mut element = made(&parameters).unwrap();
    let input = pressed(&mut element, &rolling(0.0, 20.0), 5e-5);
    let output = evaluate(&mut element, &input);
    assert!(output.wheel.force[2] < -1e4, "{output:?}");
    parameters.rails[0].position[1] = 4.0;
    let wrong = made(&parameters).unwrap_err().to_string();
    assert!(wrong.contains("rail[1].position.z = 4"), "{wrong}");
}

#[test]
fn a_second_rail_may_stand_by_gauge() {
    let mut parameters = Parameters::default();
    parameters.rails[0].enabled = false;
    let second = &mut parameters.rails[1];
    (second.enabled, second.placement, second.mirrored) = (true, Placement::Gauge, false);
    let mut first = element(&Parameters::default());
    let input = pressed(&mut first, &rolling(1e-3, 20.0), 6e-5);
    let expected = evaluate(&mut first, &input);
    let found = evaluate(&mut element(&parameters), &input);
    for (f, e) in found.rails[1].force.iter().zip(expected.rails[0].force) {
        approx::assert_relative_eq!(*f, e, max_relative = 1e-12);
    }
}
