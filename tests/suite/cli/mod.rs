//! The binary as scripts see it: tables in, tables out, and messages that say where a table is
//! wrong.

mod evaluate;
mod fatigue;
mod fit;
mod linearize;
mod pack;
mod patch;
mod plot;
mod remarks;
mod stress;
mod transient;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;
use wheelrail::geometry::profile::ProfileKind;

fn wheelrail(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_wheelrail")).args(arguments).output().unwrap()
}

/// A folder with one file in it, and the path of that file as text.
fn written(text: &str) -> (TempDir, String) {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("cases.csv");
    std::fs::write(&path, text).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}

/// Lines of two columns: each of `y` and its `height`.
fn lines(y: impl Iterator<Item = i32>, separator: &str, height: impl Fn(f64) -> f64) -> String {
    let lines: Vec<String> = y.map(|y| format!("{y}{separator}{}", height(y.into()))).collect();
    lines.join("\n") + "\n"
}

fn failure(arguments: &[&str]) -> String {
    let output = wheelrail(arguments);
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.starts_with("error: "), "{message}");
    message
}

/// The rows of a result by column.
fn table(output: &[u8]) -> Vec<HashMap<String, String>> {
    csv::Reader::from_reader(output).deserialize().map(Result::unwrap).collect()
}

fn success(arguments: &[&str]) -> Vec<HashMap<String, String>> {
    let output = wheelrail(arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    table(&output.stdout)
}

fn number(row: &HashMap<String, String>, column: &str) -> f64 {
    row[column].parse().unwrap()
}

fn example(name: &str) -> String {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(name);
    path.to_str().unwrap().into()
}

#[test]
fn every_subcommand_explains_itself() {
    for arguments in [
        &["--help"][..],
        &["simulate", "--help"],
        &["evaluate", "-h"],
        &["patch", "-h"],
        &["conicity", "-h"],
        &["compare", "-h"],
        &["plot", "-h"],
        &["fit", "-h"],
        &["pack", "-h"],
    ] {
        let output = wheelrail(arguments);
        assert!(output.status.success());
        assert!(String::from_utf8(output.stdout).unwrap().contains("Usage: wheelrail"));
    }
}

#[test]
fn conicity_of_a_cone_is_its_angle_in_table_and_figure() {
    let folder = TempDir::new().unwrap();
    let figure = folder.path().join("conicity.svg");
    let rows = success(&[
        "conicity",
        "--wheel-profile=conical:0.1",
        "--rail-profile=arc:0.2",
        "--inclination=0.05",
        "--range=0.004",
        "--step=0.0005",
        "--set=track.gauge=1.432",
        "--figure",
        figure.to_str().unwrap(),
    ]);
    assert_eq!(rows.len(), 17);
    for row in &rows {
        let y = number(row, "y_mm");
        assert!((number(row, "difference_mm") - 0.2 * y).abs() < 1e-5);
        if y > 0.0 {
            assert!((number(row, "conicity") - 0.1).abs() < 1e-5);
        } else {
            assert_eq!(row["conicity"], "");
        }
    }
    let svg = std::fs::read_to_string(figure).unwrap();
    assert!(svg.contains("equivalent conicity") && svg.contains("conical:0.1 on arc:0.2"));
}

#[test]
fn conicity_finds_a_profile_in_the_folder_it_runs_in() {
    let output = Command::new(env!("CARGO_BIN_EXE_wheelrail"))
        .args([
            "conicity",
            "--wheel-profile",
            "S1002_worn.txt",
            "--range",
            "1e-3",
            "--step",
            "1e-3",
        ])
        .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/fmu/resources/profiles"))
        .output()
        .unwrap();
    assert!(output.status.success(), "{output:?}");
}

#[test]
fn conicity_complains_about_options_by_name() {
    for (options, words) in [
        (&["--step=0"][..], "--step 0 is not admitted"),
        (&["--range=nan"], "--range NaN is not admitted"),
        (&["--step=1e-9"], "--step 0.000000001 is not admitted"),
        (&["--wheel-profile=nothing"], "nothing"),
        (&["--set=wheel.y=0.7"], "--set wheel.y: only parameters"),
        (&["--set=track.gouge=1"], "track.gauge"),
        (&["--running-circles=3"], "the wheels stand beside the rails"),
    ] {
        let message = failure(&[&["conicity"], options].concat());
        assert!(message.contains(words), "{message}");
    }
}

#[test]
fn simulate_says_where_a_unit_comes_from() {
    let missing = failure(&["simulate", "--fmu", "no_such.fmu"]);
    assert!(missing.contains("cannot open no_such.fmu"), "{missing}");
    let load = failure(&["simulate", "--axle-load", "1000"]);
    assert!(load.contains("--axle-load 1000 is not admitted"), "{load}");
}

#[test]
fn a_reader_that_has_had_enough_is_no_error() {
    let text = format!("wheel.z\n{}", "-0.46\n".repeat(2000));
    let (_folder, path) = written(&text);
    let mut child = Command::new(env!("CARGO_BIN_EXE_wheelrail"))
        .args(["evaluate", &path])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn no_result_goes_where_something_is_read() {
    let (folder, path) = written("wheel.y,wheel.z\n0.75,-0.4597\n0.751,-0.4597\n");
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (planar, shape) = (file("planar.csv"), file("f.csv"));
    let (profiled, cone) = (file("profiled.csv"), file("cone.txt"));
    std::fs::write(&profiled, "wheel.y,wheel.profile\n0.75,S1002\n0.75,cone.txt\n").unwrap();
    std::fs::write(&cone, lines(-60..=60, " ", |y| -0.05 * y)).unwrap();
    std::fs::write(&planar, "separation,radius_mm,approach_mm\nf.csv,460,0.05\n").unwrap();
    std::fs::write(&shape, parabola()).unwrap();
    let all = [&path, &planar, &shape, &profiled, &cone];
    let read = all.map(|path| std::fs::read(path).unwrap());
    let new = file("new.csv");
    for arguments in [
        &["evaluate", &path, "-o", &path][..],
        &["patch", &planar, "-o", &planar],
        &["patch", &planar, "-o", &shape],
        &["compare", &path, "-o", &path],
        &["compare", &path, "--summary", &path],
        &["compare", &planar, "-o", &shape],
        &["evaluate", &profiled, "-o", &cone],
        &["compare", &profiled, "-o", &cone],
        &["compare", &profiled, "--summary", &cone],
        &["sweep", &profiled, "--history", &cone],
        &["plot", &profiled, "--fields", &cone],
        &["sweep", &path, "-o", &path],
        &["sweep", &path, "--history", &path],
        &["plot", &planar, "--fields", &shape],
        &["plot", "--worn-wheel", &shape, "--fields", &shape],
        &["conicity", "--wheel-profile", &shape, "-o", &shape],
    ] {
        let message = failure(arguments);
        assert!(message.contains("this command reads it"), "{arguments:?}: {message}");
    }
    let message = failure(&["sweep", &path, "-o", &new, "--history", &new]);
    assert!(message.contains("another result goes there"), "{message}");
    let message = failure(&["evaluate", &profiled, "-o", &cone]);
    assert!(message.contains("profiled.csv, row 2 (line 3): "), "{message}");
    assert_eq!(all.map(|path| std::fs::read(path).unwrap()), read);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 5);
}

fn parabola() -> String {
    let points =
        (-60..=60).map(|i| 0.25 * f64::from(i)).map(|y| format!("{y},{}\n", y * y / 600.0));
    format!("y_mm,f_mm\n{}", points.collect::<String>())
}

#[test]
fn what_was_mended_in_a_profile_is_told_once_on_standard_error() {
    let columns = "wheel.profile,wheel.y,vertical.mode,wheel.load,normal.elements_along,normal.elements_across\n";
    let row = |y: f64| format!("up.txt,{y},load,50000,10,10\n");
    let (folder, path) = written(&format!("{columns}{}{}", row(0.75), row(0.7505)));
    let profile =
        wheelrail::io::load_profile("file", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap();
    let file = folder.path().join("up.txt");
    wheelrail::io::save_profile("file", &file, &profile).unwrap();
    // With z up, as measuring devices draw it.
    let up: String = std::fs::read_to_string(&file)
        .unwrap()
        .lines()
        .filter_map(|line| line.split_once([',', ' ']))
        .filter_map(|(y, z)| Some(format!("{y} {}\n", -z.trim().parse::<f64>().ok()?)))
        .collect();
    std::fs::write(&file, up).unwrap();
    let file = file.to_str().unwrap();
    let figure = folder.path().join("figure.svg");
    let figure = figure.to_str().unwrap();
    for arguments in [
        &["evaluate", &path][..],
        &["compare", &path],
        &["sweep", &path, "--steps", "4", "--vary", "normal.model=hertz,piotrowski_kik"],
        &["plot", &path, "-o", figure],
        &["plot", "--worn-wheel", file, "--unworn-wheel", file, "-o", figure],
        &["conicity", "--wheel-profile", file, "--range=1e-3", "--step=1e-3"],
    ] {
        let output = wheelrail(arguments);
        let told = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success(), "{told}");
        let warnings: Vec<&str> = told.lines().filter(|l| l.starts_with("warning: ")).collect();
        assert_eq!(warnings.len(), 1, "{arguments:?}: {told}");
        assert!(warnings[0].contains("up.txt:"), "{told}");
        assert!(warnings[0].contains("mirrored in z"), "{told}");
    }
}

#[test]
fn sweep_tells_a_jump_from_a_slope() {
    // Two convex bodies: nothing to jump. From above the rail to 0.1 mm inside it, and 2 mm aside.
    let (_folder, path) = written(
        "wheel.profile,rail[1].profile,rail[1].inclination,wheel.y,wheel.z\n\
         convex:0.3,arc:0.3,0,0.75,-0.4601\nconvex:0.3,arc:0.3,0,0.75,-0.4599\nconvex:0.3,arc:0.3,0,0.752,-0.4599\n",
    );
    let smooth = success(&["sweep", &path, "--steps", "50"]);
    let force = smooth.iter().find(|row| row["output"] == "wheel.force.z").unwrap();
    assert!(number(force, "jump") <= 0.0 && number(force, "largest") > 1e4, "{force:?}");
    assert!(force["at"].is_empty());

    // Piotrowski and Kik have one contact point for an overlap: where the deepest of two minima
    // changes, the force jumps.
    let (folder, path) = written(
        "wheel.y,wheel.z,normal.model\n0.7495,-0.4597,piotrowski_kik\n0.7508,-0.4597,piotrowski_kik\n",
    );
    let figure = folder.path().join("sweep.svg");
    let history = folder.path().join("history.csv");
    let found = success(&[
        "sweep",
        &path,
        "--steps",
        "40",
        "--figure",
        figure.to_str().unwrap(),
        "--history",
        history.to_str().unwrap(),
    ]);
    let force = found.iter().find(|row| row["output"] == "wheel.force.z").unwrap();
    let at = number(force, "at");
    assert!(number(force, "jump") > 0.01 && (1.0..2.0).contains(&at), "{force:?}");
    assert!(std::fs::read_to_string(figure).unwrap().contains("jumps by"));
    assert_eq!(table(&std::fs::read(history).unwrap()).len(), 41);
}

#[test]
fn sweep_compares_models_along_one_path() {
    let (folder, path) = written(
        "wheel.y,wheel.z,normal.model\n0.7495,-0.4597,piotrowski_kik\n0.7508,-0.4597,piotrowski_kik\n",
    );
    let figure = folder.path().join("sweep.svg");
    let vary = "normal.model=hertz,piotrowski_kik";
    let drawn = figure.to_str().unwrap();
    let found = success(&["sweep", &path, "--steps", "20", "--vary", vary, "--figure", drawn]);
    let jump = |model: &str| {
        let force = |row: &&HashMap<_, _>| row["output"] == "wheel.force.z";
        let row = found.iter().filter(|row| row["normal.model"] == model).find(force);
        number(row.unwrap(), "jump")
    };
    // Both jump where the deepest of two minima changes, an ellipse further.
    assert!(jump("hertz") > jump("piotrowski_kik") && jump("piotrowski_kik") > 0.01);
    let drawing = std::fs::read_to_string(figure).unwrap();
    assert!(drawing.contains("hertz, jumps by") && drawing.contains("wheel.force.z [N] by"));
}

#[test]
fn sweep_refuses_what_is_no_path() {
    let (_folder, path) = written("wheel.y,wheel.z\n0.7495,-0.4597\n");
    assert!(failure(&["sweep", &path]).contains("at least two rows"));
    let (_folder, path) = written("wheel.y,normal.model\n0.75,hertz\n0.75,strips\n");
    assert!(failure(&["sweep", &path]).contains("row 2 has other parameters"));
}
