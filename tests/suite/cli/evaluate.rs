//! `wheelrail evaluate`.

use super::*;

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

/// Poses of touching, flanging and lifted wheels, with parameters that change from row to row.
fn poses(count: usize) -> Vec<String> {
    let models = ["piotrowski_kik", "strips", "hertz"];
    let pose = |i: usize| {
        // The same places every time, as evenly spread as those of a Weyl sequence.
        let even = |step: f64| (step * (i + 1) as f64).fract() - 0.5;
        let (y, z, yaw) =
            (0.75 + 0.016 * even(0.819), -0.4598 + 4e-4 * even(0.671), 0.01 * even(0.549));
        format!(
            "{},{},{y:.6},{z:.6},{yaw:.5},20,-43.5",
            models[i % 3],
            ["right", "left"][i / 3 % 2]
        )
    };
    (0..count).map(pose).collect()
}

const POSES: &str = "normal.model,side,wheel.y,wheel.z,wheel.yaw,wheel.vx,wheel.pitch_rate\n";

/// Lines of the result on so many threads, without the header.
fn evaluated(rows: &[String], threads: &str) -> Vec<String> {
    let (_folder, path) = written(&format!("{POSES}{}\n", rows.join("\n")));
    let output = Command::new(env!("CARGO_BIN_EXE_wheelrail"))
        .args(["evaluate", &path])
        .env("RAYON_NUM_THREADS", threads)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap().lines().skip(1).map(Into::into).collect()
}

#[test]
fn evaluate_gives_the_same_bits_on_any_number_of_threads_and_in_any_order() {
    let rows = poses(120);
    let one = evaluated(&rows, "1");
    assert_eq!(one.len(), rows.len());
    assert_eq!(evaluated(&rows, "3"), one);
    // Each row with rows of other parameters before it.
    let shuffled: Vec<String> =
        (0..rows.len()).map(|i| rows[i * 77 % rows.len()].clone()).collect();
    let found = evaluated(&shuffled, "2");
    for (i, line) in found.iter().enumerate() {
        assert_eq!(*line, one[i * 77 % rows.len()], "{}", shuffled[i]);
    }
}

#[test]
fn evaluate_counts_the_fallbacks_of_each_row_by_itself() {
    // A load that nothing can carry is one.
    let (_folder, path) = written("vertical.mode,wheel.load\nload,1e12\nload,5e4\nload,1e12\n");
    let rows = success(&["evaluate", &path]);
    let counts: Vec<&str> = rows.iter().map(|row| row["fallback_count"].as_str()).collect();
    assert_eq!(counts, ["1", "0", "1"]);
}

#[test]
fn evaluate_reads_decimal_commas_and_exponents_of_fortran() {
    let plain = written("wheel.y,wheel.z,wheel.yaw\n0.7512,-0.4597,0.0015\n");
    // What is computed; the columns of the table stand before it as they are.
    let computed = |path: &str| {
        let output = wheelrail(&["evaluate", path, "--outputs", "wheel.force.*,patch_count"]);
        let text = String::from_utf8(output.stdout).unwrap();
        let cells =
            |line: &str| line.split([',', ';', '\t']).rev().take(4).map(str::to_owned).collect();
        text.lines().map(cells).collect::<Vec<Vec<String>>>()
    };
    let wanted = computed(&plain.1);
    assert_eq!(wanted.len(), 2);
    for text in [
        "wheel.y;wheel.z;wheel.yaw\n0,7512;-0,4597;1,5E-3\n",
        "wheel.y\twheel.z\twheel.yaw\r\n0,7512\t-0,4597\t0,0015\r\n",
        "wheel.y;wheel.z;wheel.yaw\n0.7512;-0.4597;1.5e-3\n",
        "wheel.y,wheel.z,wheel.yaw\n7.512D-1,-0.4597d0,1.5D-3\n",
    ] {
        let (_folder, path) = written(text);
        assert_eq!(computed(&path), wanted, "{text}");
    }
}

#[test]
fn columns_of_the_table_pass_through_and_outputs_are_those_asked_for() {
    let (_folder, path) =
        written("id;y;vx;friction\n\"first; of all\";0,7512;20;0,4\nb;0,75;20;0,3\n");
    let output = wheelrail(&["evaluate", &path, "--outputs", "wheel.force.z,patch[1].con*"]);
    assert!(output.status.success(), "{output:?}");
    let text = String::from_utf8(output.stdout).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("id;y;vx;friction;wheel.force.z;patch[1].contact_angle"));
    assert!(lines.next().unwrap().starts_with("\"first; of all\";0.7512;20;0.4;-"));
    for (table, words) in [
        ("y,wheel.y\n0.75,0.75\n", "wheel.y is there twice"),
        ("yy\n0.75\n", "there is no variable \"yy\""),
    ] {
        let (_folder, path) = written(table);
        let said = String::from_utf8(wheelrail(&["evaluate", &path]).stderr).unwrap();
        assert!(said.contains(words), "{said}");
    }
    let said = wheelrail(&["evaluate", &path, "--outputs", "wheel.force.q"]).stderr;
    assert!(String::from_utf8(said).unwrap().contains("the nearest name is wheel.force"));
}

#[test]
fn evaluate_leaves_an_older_result_alone_unless_all_goes_well() {
    let (folder, path) = written("wheel.z,rail[1].profile\n-0.46,60E1\n-0.46,60E1\n-0.46,no.prr\n");
    let result = folder.path().join("result.csv");
    let to = result.to_str().unwrap();
    std::fs::write(&result, "older\n").unwrap();
    // Refused when its turn comes: the rows before it are kept beside.
    let message = failure(&["evaluate", &path, "-o", to]);
    let part = folder.path().join("result.csv.partial");
    let kept = format!("the first 2 rows are in {}", part.display());
    assert!(message.contains("row 3 (line 4)") && message.contains(&kept), "{message}");
    assert_eq!(std::fs::read_to_string(&result).unwrap(), "older\n");
    assert_eq!(table(&std::fs::read(&part).unwrap()).len(), 2);
    std::fs::remove_file(part).unwrap();
    // Refused as it stands.
    std::fs::write(&path, "wheel.z\n-0.46\nup\n").unwrap();
    assert!(failure(&["evaluate", &path, "-o", to]).contains("\"up\""));
    assert!(failure(&["evaluate", &path, "-o", &path]).contains("this command reads it"));
    assert_eq!(std::fs::read_to_string(&result).unwrap(), "older\n");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "wheel.z\n-0.46\nup\n");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2);
    std::fs::write(&path, "wheel.z\n-0.46\n").unwrap();
    assert!(wheelrail(&["evaluate", &path, "-o", to]).status.success());
    assert_eq!(table(&std::fs::read(&result).unwrap()).len(), 1);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[cfg(target_os = "linux")]
#[test]
fn evaluate_names_the_file_that_cannot_be_written() {
    let (_folder, path) = written("wheel.z\n-0.46\n");
    let message = failure(&["evaluate", &path, "-o", "/dev/full"]);
    assert!(message.contains("cannot write /dev/full: No space left"), "{message}");
    let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_wheelrail"))
        .args(["evaluate", &path])
        .stdout(full)
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("cannot write standard output: No space left"), "{message}");
}

#[cfg(unix)]
#[test]
fn evaluate_keeps_whole_rows_when_it_is_interrupted() {
    let (folder, path) = written(&format!("wheel.z\n{}", "-0.4597\n".repeat(20_000)));
    let result = folder.path().join("result.csv");
    std::fs::write(&result, "older\n").unwrap();
    // Where tests run in the background some signals are ignored, which programs inherit and
    // respect.
    let unignored = "import os, signal, sys\n\
                     for name in ('SIGINT', 'SIGTERM', 'SIGHUP'):\n    \
                         signal.signal(getattr(signal, name), signal.SIG_DFL)\n\
                     os.execv(sys.argv[1], sys.argv[1:])";
    let mut child = Command::new("python3")
        .args(["-c", unignored, env!("CARGO_BIN_EXE_wheelrail")])
        .args(["evaluate", &path, "-o", result.to_str().unwrap()])
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // Until some rows are written.
    let under_way = || {
        let files = std::fs::read_dir(folder.path()).unwrap().map(Result::unwrap);
        let mut parts =
            files.filter(|file| file.path().extension().is_some_and(|e| e == "partial"));
        parts.any(|part| part.metadata().is_ok_and(|about| about.len() > 100_000))
    };
    while !under_way() {
        assert!(child.try_wait().unwrap().is_none(), "done too soon");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    let message = String::from_utf8(output.stderr).unwrap();
    let part = folder.path().join("result.csv.partial");
    let kept = std::fs::read_to_string(&part).unwrap();
    assert!(kept.ends_with('\n'));
    let rows = table(kept.as_bytes()).len();
    assert!(rows > 10);
    let said = format!("stopped: the first {rows} rows are in {}", part.display());
    assert!(message.contains(&said), "{message}");
    assert_eq!(std::fs::read_to_string(&result).unwrap(), "older\n");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 3);
}
