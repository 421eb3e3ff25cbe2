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
