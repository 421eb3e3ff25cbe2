//! What the commands say of odd places, forces and inputs, and of slips.

use super::{wheelrail, written};

/// The warnings of a command that succeeds.
fn warnings(arguments: &[&str]) -> Vec<String> {
    let output = wheelrail(arguments);
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{told}");
    told.lines().filter(|line| line.starts_with("warning: ")).map(Into::into).collect()
}

#[test]
fn each_kind_of_odd_place_is_told_once_with_its_first_row() {
    let all = "wheel.y,wheel.z\n0.75,-0.4597\n0.75,-0.475\n0.75,-0.476\n0.75,-0.45\n0.75,-0.42\n0.75,-0.41\n-0.75,-0.4597\n";
    let (_folder, path) = written(all);
    let told = warnings(&["evaluate", &path]);
    let counts = ["2 rows: in the air", "3 rows: inside a rail", "2 rows: too deep for a force"];
    assert_eq!(told.len(), 4 + counts.len(), "{told:?}");
    for (line, count) in told[4..].iter().zip(counts) {
        assert!(line.contains(count), "{line}");
    }
    for (line, [row, words]) in told.iter().zip([
        ["row 2 (line 3)", "15.2 mm above nominal.wheel_z = -0.459818 m"],
        ["row 4 (line 5)", "9.8 mm below nominal.wheel_z = -0.459818 m"],
        ["row 5 (line 6)", "the wheel is 39.8 mm below the top of its rail"],
        ["row 7 (line 8)", "beside its rails, with its marker at y = -0.75 m"],
    ]) {
        assert!(line.contains(row) && line.contains(words), "{line}");
    }

    let coarse = "normal.elements_along,normal.elements_across\n";
    let (folder, path) = written(&format!("wheel.z,{coarse}-0.45,10,10\n-0.41,10,10\n"));
    let figure = folder.path().join("figure.svg");
    let figure = figure.to_str().unwrap();
    for (command, expected) in [
        (
            &["compare", &path][..],
            &["row 1 (line 2): the wheel starts", "row 2 (line 3): the wheel is", "2 rows: inside"]
                [..],
        ),
        (&["sweep", &path, "--steps", "40"], &["row 1: the wheel starts", "row 1.4: the wheel is"]),
        (&["plot", &path, "-o", figure], &["warning: the wheel starts"]),
    ] {
        let told = warnings(command);
        assert_eq!(told.len(), expected.len(), "{command:?}: {told:?}");
        for (line, words) in told.iter().zip(expected) {
            assert!(line.contains(words), "{command:?}: {line}");
        }
    }
    // On the rail nothing is odd, nor where a load says how high the wheel is.
    let (_folder, path) = written("wheel.z,vertical.mode\n-0.4597,penetration\n,load\n");
    assert!(warnings(&["evaluate", &path]).is_empty());
}

#[test]
fn what_is_odd_about_forces_is_told_with_its_first_row_and_counted() {
    let table = "vertical.mode,wheel.load,wheel.y,wheel.z,wheel.vx\n\
                 load,8e4,0.75,,20\nload,8e4,0.3,,20\nload,8e4,0.2,,20\npenetration,,0.75,,50\n\
                 load,8e4,0.75,-0.45,20\npenetration,7e4,0.75,,20\n";
    let (_folder, path) = written(table);
    let told = warnings(&["evaluate", &path]);
    let expected = [
        ["row 2 (line 3): wheel.load = 80000 N, but the rails carry 0 N", "look at wheel.y"],
        ["row 2 (line 3): the wheel on the right side starts beside", "wheel.y"],
        [
            "row 4 (line 5): the wheel slides on rail[1] with a slip of 60 %",
            "wheel.pitch_rate = -108.69",
        ],
        ["row 5 (line 6): wheel.z has no effect with vertical.mode = load", "penetration"],
        ["row 6 (line 7): wheel.load has no effect with vertical.mode = penetration", "load"],
        ["2 rows: beside the rails", ""],
        ["2 rows: load not carried", ""],
    ];
    assert_eq!(told.len(), expected.len(), "{told:#?}");
    for (line, words) in told.iter().zip(expected) {
        assert!(words.iter().all(|part| line.contains(part)), "{line}");
    }
}

#[test]
fn a_wheel_at_the_end_of_a_profile_is_told() {
    let folder = tempfile::tempdir().unwrap();
    // A head that is cut off 12 mm beside its middle.
    let points = (-360..=120).map(|i| 0.1 * f64::from(i));
    let text = points.fold(String::from("# mirror_z 0\n"), |text, y| {
        text + &format!("{y:.4} {:.6}\n", 300.0 - (300.0f64.powi(2) - y * y).sqrt())
    });
    std::fs::write(folder.path().join("cut.txt"), text).unwrap();
    let path = folder.path().join("cases.csv");
    let head = "rail[1].profile,rail[1].placement,rail[1].position.y,rail[1].inclination,vertical.mode,wheel.profile,wheel.y,normal.model";
    let row = |inclination: f64, y: f64, model: &str| {
        format!("cut.txt,origin,0.75,{inclination},load,conical:0.05,{y},{model}")
    };
    // In the middle of both, where the rail leans outwards, and where the wheel is farther out.
    let rows = [
        row(0.025, 0.75, "boundary_element"),
        row(-0.08, 0.75, "boundary_element"),
        row(-0.05, 0.79, "piotrowski_kik"),
    ];
    std::fs::write(&path, format!("{head}\n{}\n", rows.join("\n"))).unwrap();
    let told = warnings(&["evaluate", path.to_str().unwrap()]);
    assert_eq!(told.len(), 2, "{told:#?}");
    for (line, words) in told.iter().zip([
        ["row 2 (line 3)", "end of rail[1].profile, y = -36.00 mm", "are no reference on an edge"],
        ["row 3 (line 4)", "end of wheel.profile, y = -70.00 mm", "bears on an edge"],
    ]) {
        assert!(words.iter().all(|part| line.contains(part)), "{line}");
    }
}

#[test]
fn slips_of_new_users_are_named() {
    let message = |arguments: &[&str]| {
        let output = wheelrail(arguments);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        String::from_utf8(output.stderr).unwrap()
    };
    // Enumerations by number, as messages and the C interface have them.
    let (_folder, path) = written("normal.model\n1\nhertz\n");
    assert!(warnings(&["evaluate", &path]).is_empty());
    let (_folder, path) = written("normal.model\n9\n");
    assert!(message(&["evaluate", &path]).contains("normal.model = \"9\""));
    // What is no table is refused in a line.
    let (_folder, path) = written(&format!("\u{1}{}\n1\n", "\u{2}x".repeat(5000)));
    let said = message(&["evaluate", &path]);
    assert!(said.len() < 400 && said.contains("this is no table"), "{said}");
}

#[test]
fn errors_over_a_text_column_are_drawn_row_by_row() {
    let coarse = "10,10\n";
    let head = "rail[1].profile,normal.elements_along,normal.elements_across\n";
    let (folder, path) = written(&format!("{head}60E1,{coarse}60E2,{coarse}"));
    let figure = folder.path().join("errors.svg");
    let output = wheelrail(&["compare", &path, "--figure", figure.to_str().unwrap()]);
    assert!(output.status.success());
    let drawn = std::fs::read_to_string(figure).unwrap();
    assert!(drawn.contains("\nrow\n"), "the rows are the abscissa");
    assert!(drawn.matches("<circle").count() >= 8);
}
