//! The binary as scripts see it: tables in, tables out, and messages that say where a table is wrong.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

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
        &["tables", "--help"],
        &["evaluate", "-h"],
        &["patch", "-h"],
        &["conicity", "-h"],
        &["compare", "-h"],
        &["plot", "-h"],
    ] {
        let output = wheelrail(arguments);
        assert!(output.status.success());
        assert!(String::from_utf8(output.stdout).unwrap().contains("Usage: wheelrail"));
    }
}

#[test]
fn evaluate_answers_every_row_with_every_output() {
    let rows = success(&["evaluate", &example("wheel_positions.csv")]);
    assert_eq!(rows.len(), 5);
    let lifted = &rows[0];
    assert_eq!(lifted["patch_count"], "0");
    assert_eq!(lifted["wheel.force.z"], "0.0");
    for row in &rows[1..] {
        assert!(number(row, "patch_count") >= 1.0);
        assert!(number(row, "wheel.force.z") < 0.0);
        assert!(number(row, "patch[1].normal_force") > 0.0);
        let touching = number(row, "nominal.wheel_z");
        assert!((-0.465..-0.455).contains(&touching), "{touching}");
    }
}

#[test]
fn evaluate_treats_the_left_wheel_as_the_mirror_image() {
    let (_folder, path) = written(
        "side,wheel.y,wheel.z,wheel.yaw,wheel.vx,wheel.pitch_rate\n\
         right,0.752,-0.4597,0.002,10,-21.7\n\
         left,-0.752,-0.4597,-0.002,10,-21.7\n",
    );
    let rows = success(&["evaluate", &path]);
    for (column, sign) in [("wheel.force.x", 1.0), ("wheel.force.y", -1.0), ("wheel.force.z", 1.0)]
    {
        let (right, left) = (number(&rows[0], column), number(&rows[1], column));
        assert!(right != 0.0 && (left - sign * right).abs() <= 1e-9 * right.abs(), "{column}");
    }
}

#[test]
fn evaluate_writes_to_the_file_that_is_named() {
    let (folder, path) = written("wheel.z\n-0.46\n");
    let result = folder.path().join("result.csv");
    let output = wheelrail(&["evaluate", &path, "-o", result.to_str().unwrap()]);
    assert!(output.status.success() && output.stdout.is_empty());
    assert_eq!(table(&std::fs::read(result).unwrap()).len(), 1);
}

#[test]
fn evaluate_takes_profile_files_relative_to_the_cases() {
    let (folder, path) = written("wheel.profile,wheel.z\nprofiles/cone.txt,-0.4598\n");
    std::fs::create_dir(folder.path().join("profiles")).unwrap();
    let cone = lines(-60..=60, " ", |y| -0.05 * y);
    std::fs::write(folder.path().join("profiles/cone.txt"), cone).unwrap();
    let rows = success(&["evaluate", &path]);
    assert!(number(&rows[0], "patch[1].normal_force") > 0.0);
}

#[test]
fn evaluate_complains_with_row_column_and_remedy() {
    let message = |text: &str| {
        let (_folder, path) = written(text);
        failure(&["evaluate", &path])
    };
    let unknown = message("wheel.yy\n1\n");
    assert!(unknown.contains("cases.csv, column \"wheel.yy\""), "{unknown}");
    assert!(unknown.contains("the nearest name is wheel.y"), "{unknown}");
    let output = message("wheel.force.z\n1\n");
    assert!(output.contains("computed by the element"), "{output}");
    let word = message("wheel.y,wheel.z\n0.75,-0.46\n0.75,up\n");
    assert!(word.contains("row 2 (line 3), column \"wheel.z\""), "{word}");
    assert!(word.contains("\"up\""), "{word}");
    let item = message("normal.model\nhertzian\n");
    assert!(item.contains("column \"normal.model\"") && item.contains("piotrowski_kik"), "{item}");
    let range = message("friction.coefficient\n-0.1\n");
    assert!(range.contains("row 1 (line 2), column \"friction.coefficient\""), "{range}");
    let profile = message("wheel.y,rail[1].profile\n0.75,60E1\n0.75,no_such.prr\n");
    assert!(profile.contains("row 2 (line 3), column \"rail[1].profile\""), "{profile}");
    assert!(profile.contains("no_such.prr"), "{profile}");
    let missing = failure(&["evaluate", "no_such_file.csv"]);
    assert!(missing.contains("cannot read no_such_file.csv"), "{missing}");
}

#[test]
fn patch_gives_the_load_it_was_asked_for_and_the_approach_that_belongs_to_it() {
    let rows = success(&["patch", &example("planar_contacts.csv")]);
    assert_eq!(rows.len(), 4);
    for row in &rows {
        assert!(number(row, "normal_force_n") > 0.0 && number(row, "time_us") > 0.0);
        assert_eq!(row["fallback"], "0");
        // Friction bounds the creep force.
        let force = number(row, "fx_n").hypot(number(row, "fy_n"));
        assert!(force <= 0.3 * number(row, "normal_force_n") * (1.0 + 1e-9));
    }
    let loaded = number(&rows[1], "normal_force_n");
    assert!((loaded - 80e3).abs() < 1.0, "{loaded}");
    assert!(number(&rows[2], "fx_n") < 0.0, "a wheel that is too fast is held back");
    assert!(number(&rows[3], "fy_n") < 0.0);
}

#[test]
fn patch_meets_hertz_on_a_parabola() {
    // Radii 0.5 m along and across, steel: a = b, a³ = 3 N R/(4 E*), p0 = 3 N/(2 π a²).
    let separation = "y_mm,f_mm\n".to_owned() + &lines(-20..=20, ",", |y| y * y / 1000.0);
    let (folder, path) =
        written("separation,radius_mm,load_n,normal_model\nf.csv,500,50000,hertz\n");
    std::fs::write(folder.path().join("f.csv"), separation).unwrap();
    let rows = success(&["patch", &path]);
    let (load, radius): (f64, f64) = (50e3, 0.5);
    let modulus = 2.1e11 / (2.0 * (1.0 - 0.28 * 0.28));
    let a = (0.75 * load * radius / modulus).cbrt();
    let pressure = 1e-6 * 1.5 * load / (std::f64::consts::PI * a * a);
    let found = number(&rows[0], "max_pressure_mpa");
    assert!((found / pressure - 1.0).abs() < 1e-3, "{found} MPa instead of {pressure} MPa");
    assert!((number(&rows[0], "length_mm") / (2e3 * a) - 1.0).abs() < 1e-3);
    assert!((number(&rows[0], "normal_force_n") / load - 1.0).abs() < 1e-6);
}

#[test]
fn patch_complains_with_row_column_and_remedy() {
    let message = |text: &str| {
        let (folder, path) = written(text);
        let parabola = lines(-10..=10, ",", |y| y * y / 600.0);
        std::fs::write(folder.path().join("f.csv"), format!("y_mm,f_mm\n{parabola}")).unwrap();
        std::fs::write(folder.path().join("bad.csv"), "y_mm,f_mm\n0,0\n1,?\n").unwrap();
        failure(&["patch", &path])
    };
    let unknown = message("separation,radius_mm,aproach_mm\nf.csv,460,0.05\n");
    assert!(unknown.contains("column \"aproach_mm\": unknown"), "{unknown}");
    assert!(unknown.contains("approach_mm, load_n"), "{unknown}");
    let neither = message("separation,radius_mm\nf.csv,460\n");
    assert!(neither.contains("row 1 (line 2): give approach_mm or load_n"), "{neither}");
    let both = message("separation,radius_mm,approach_mm,load_n\nf.csv,460,0.05,1e4\n");
    assert!(both.contains("not both"), "{both}");
    let file = message("separation,radius_mm,load_n\nf.csv,460,1e4\nnone.csv,460,1e4\n");
    assert!(file.contains("row 2 (line 3), column \"separation\""), "{file}");
    assert!(file.contains("none.csv"), "{file}");
    let cell = message("separation,radius_mm,load_n\nbad.csv,460,1e4\n");
    assert!(cell.contains("bad.csv, row 2 (line 3), column \"f_mm\": \"?\""), "{cell}");
    let radius = message("separation,radius_mm,load_n\nf.csv,-460,1e4\n");
    assert!(radius.contains("column \"radius_mm\": -460 is not admitted"), "{radius}");
    let model = message("separation,radius_mm,load_n,normal_model\nf.csv,460,1e4,kik\n");
    assert!(
        model.contains("column \"normal_model\"") && model.contains("piotrowski_kik"),
        "{model}"
    );
}

#[test]
fn evaluate_carries_a_given_load_with_the_models_it_is_asked_for() {
    let (_folder, path) = written(
        "vertical.mode,wheel.load,normal.model,normal.shape_fit,creepage.model,tangential.model,wheel.vx,wheel.pitch_rate\n\
         load,50000,piotrowski_kik_corrected,paper,curved,linear,20,-43\n\
         load,50000,piotrowski_kik,,kinematic,fastsim,20,-43\n",
    );
    for row in success(&["evaluate", &path]) {
        assert!((number(&row, "wheel.force.z") + 5e4).abs() < 1e-3);
        let depth = number(&row, "vertical.wheel_z") - number(&row, "nominal.wheel_z");
        assert!((2e-5..2e-4).contains(&depth), "{depth}");
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
fn compare_measures_wheels_and_planar_contacts() {
    let (folder, path) = written(
        "wheel.y,wheel.load,vertical.mode,wheel.vx,wheel.pitch_rate,normal.model,tangential.model,normal.elements_along,normal.elements_across\n\
         0.747,50000,load,20,-43.4,piotrowski_kik,fastsim,12,12\n\
         0.747,50000,load,20,-43.4,boundary_element,boundary_element,12,12\n",
    );
    let figure = folder.path().join("errors.svg");
    let summary = folder.path().join("summary.csv");
    let rows = success(&[
        "compare",
        &path,
        "--figure",
        figure.to_str().unwrap(),
        "--summary",
        summary.to_str().unwrap(),
    ]);
    assert_eq!(rows.len(), 2);
    assert_eq!(rows[0]["wheel.y"], "0.747");
    for row in &rows {
        assert!((number(row, "reference_normal_force_n") / 5e4 - 1.0).abs() < 0.01);
    }
    assert!(number(&rows[0], "max_pressure_error_percent").abs() > 1.0);
    for quantity in ["normal_force", "max_pressure", "area", "creep_force", "spin_moment"] {
        let error = number(&rows[1], &format!("{quantity}_error_percent"));
        assert!(error.abs() < 0.5, "{quantity} {error}");
    }
    assert!(std::fs::read_to_string(figure).unwrap().contains("Creep force"));
    assert!(table(&std::fs::read(summary).unwrap()).len() >= 5);

    std::fs::write(folder.path().join("f.csv"), parabola()).unwrap();
    std::fs::write(
        &path,
        "separation,radius_mm,load_n,creepage_longitudinal,normal_model,elements_along,elements_across\n\
         f.csv,460,50000,0.001,hertz,12,12\n",
    )
    .unwrap();
    let rows = success(&["compare", &path]);
    assert!(number(&rows[0], "max_pressure_error_percent").abs() < 2.0);
    assert!(number(&rows[0], "reference_fx_n") < -1000.0);
}

fn parabola() -> String {
    let points =
        (-60..=60).map(|i| 0.25 * f64::from(i)).map(|y| format!("{y},{}\n", y * y / 600.0));
    format!("y_mm,f_mm\n{}", points.collect::<String>())
}

#[test]
fn plot_draws_a_wheel_and_a_planar_contact() {
    let (folder, path) = written(
        "wheel.y,wheel.z,wheel.vx,wheel.pitch_rate,normal.elements_along,normal.elements_across\n\
         0.747,-0.4597,20,-43.4,12,12\n",
    );
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let (figure, fields) = (file("contact.svg"), file("fields.csv"));
    let output = wheelrail(&["plot", &path, "-o", &figure, "--fields", &fields]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let drawn = std::fs::read_to_string(&figure).unwrap();
    assert!(drawn.contains("S1002 on 60E1") && drawn.contains("boundary_element"));
    assert!(drawn.matches("<rect").count() > 300);
    let rows = table(&std::fs::read(&fields).unwrap());
    let of = |models: &str| rows.iter().filter(|row| row["models"].starts_with(models)).count();
    assert!(of("piotrowski_kik") > 80 && of("boundary_element") > 80);
    assert!(rows.iter().any(|row| row["state"] == "slip"));

    std::fs::write(folder.path().join("f.csv"), parabola()).unwrap();
    std::fs::write(&path, "separation,radius_mm,approach_mm\nf.csv,460,0.05\n").unwrap();
    assert!(wheelrail(&["plot", &path, "-o", &figure]).status.success());
    let refused = wheelrail(&["plot", &path, "--row", "2"]);
    assert!(String::from_utf8_lossy(&refused.stderr).contains("has rows 1 to 1"));
    let refused = wheelrail(&["plot", &path, "-o", "contact.txt"]);
    assert!(String::from_utf8_lossy(&refused.stderr).contains("ends in .svg"));
}

#[test]
fn plot_draws_worn_profiles_and_their_depth() {
    let mut parameters = wheelrail::element::Parameters::default();
    parameters.wear.model = wheelrail::element::parameters::WearModel::FrictionalWork;
    parameters.wear.acceleration_factor = 1e7;
    let mut input = wheelrail::element::Input::default();
    let mut element = wheelrail::element::Element::new(&parameters, &input, &[]).unwrap();
    input.wheel.position[2] = element.nominal_wheel_z() + 7e-5;
    (input.wheel.velocity[0], input.wheel.pitch_rate) = (20.0, -43.7);
    let mut output = wheelrail::element::Output::default();
    element.advance(&input, &mut output, 1e-2).unwrap();
    let folder = TempDir::new().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let (wheel, rail) = (file("wheel.csv"), file("rail.csv"));
    for (path, profile) in [(&wheel, element.worn_wheel()), (&rail, element.worn_rail(0))] {
        wheelrail::io::save_profile("file", path.as_ref(), &profile.unwrap()).unwrap();
    }
    let (figure, fields) = (file("worn.svg"), file("depth.csv"));
    let output = wheelrail(&[
        "plot",
        "--worn-wheel",
        &wheel,
        "--worn-rail",
        &rail,
        "-o",
        &figure,
        "--fields",
        &fields,
    ]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let drawn = std::fs::read_to_string(&figure).unwrap();
    for text in ["Worn wheel", "Worn rail", "S1002", "wheel.csv", "wear depth [mm]"] {
        assert!(drawn.contains(text), "{text}");
    }
    let rows = table(&std::fs::read(&fields).unwrap());
    let deepest = |body: &str| {
        let depths = rows.iter().filter(|row| row["body"] == body);
        depths.map(|row| row["depth_mm"].parse::<f64>().unwrap()).fold(0.0, f64::max)
    };
    let depth = 1e3 * element_depth(&element);
    assert!((deepest("wheel") - depth).abs() < 0.01 * depth, "{} {depth}", deepest("wheel"));
    assert!(deepest("rail") > 0.0 && deepest("rail") < depth);
    let refused = wheelrail(&["plot", "--worn-wheel", &file("none.csv"), "-o", &figure]);
    assert!(String::from_utf8_lossy(&refused.stderr).contains("none.csv"));
    assert!(!wheelrail(&["plot"]).status.success());
}

/// Greatest wear depth of an element's wheel [m].
fn element_depth(element: &wheelrail::element::Element) -> f64 {
    let depth = element.wear_depth(wheelrail::element::WornBody::Wheel);
    depth.iter().map(|p| p[1]).fold(0.0, f64::max)
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

    // Piotrowski and Kik have one contact point for an overlap: where the deepest of two minima changes, the force jumps.
    let (folder, path) = written("wheel.y,wheel.z\n0.7495,-0.4597\n0.7508,-0.4597\n");
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
    let (folder, path) = written("wheel.y,wheel.z\n0.7495,-0.4597\n0.7508,-0.4597\n");
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

#[test]
fn tables_are_measured_against_solutions_and_refuse_what_they_cannot() {
    let rows = success(&["tables", "--check", "4", "--elements", "8,12", "--axis-ratio", "3"]);
    assert_eq!(rows.len(), 4);
    assert!(rows.iter().all(|row| number(row, "mean") <= number(row, "worst")));
    let force = rows.iter().find(|row| row["quantity"] == "force_over_limit").unwrap();
    // Eight elements along are coarse.
    assert!(number(force, "worst") > 0.0 && number(force, "worst") < 0.05, "{force:?}");
    let message = failure(&["tables", "--check", "4", "--elements", "12,8"]);
    assert!(message.contains("--elements"), "{message}");
    let message = failure(&["tables", "--check", "4", "--poisson-ratio", "0.7"]);
    assert!(message.contains("--poisson-ratio"), "{message}");
}

#[test]
fn patch_takes_tables_and_falling_friction() {
    let (folder, _) = written("");
    let parabola = lines(-20..=20, ",", |y| y * y / 1000.0);
    std::fs::write(folder.path().join("f.csv"), format!("y_mm,f_mm\n{parabola}")).unwrap();
    let cases = folder.path().join("all.csv");
    let head = "separation,radius_mm,load_n,creepage_longitudinal,tangential_model,falling_share,falling_decay_s_per_m,speed_m_s";
    let text = format!(
        "{head}\nf.csv,460,80000,0.1,tables,1,0,10\nf.csv,460,80000,0.1,fastsim_corrected,0.4,0.7,10\n"
    );
    std::fs::write(&cases, text).unwrap();
    let rows = success(&["patch", cases.to_str().unwrap()]);
    let share = |k: usize| -number(&rows[k], "fx_n") / number(&rows[k], "normal_force_n");
    assert!((share(0) / 0.3 - 1.0).abs() < 1e-3, "{}", share(0));
    let falling = 0.3 * (0.4 + 0.6 * (-0.7_f64).exp());
    assert!((share(1) / falling - 1.0).abs() < 1e-3, "{} for {falling}", share(1));
}
