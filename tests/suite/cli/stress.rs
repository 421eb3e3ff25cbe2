//! `wheelrail stress`.

use super::*;

#[test]
fn stress_finds_and_draws_the_greatest_stresses() {
    let (folder, path) =
        written("wheel.y,wheel.z,wheel.vx,wheel.pitch_rate\n0.747,-0.4597,20,-43.4\n");
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let (figure, points) = (file("stress.svg"), file("points.csv"));
    let rail = success(&["stress", &path, "-o", &figure, "--points", &points]);
    let names: Vec<&str> = rail.iter().map(|row| row["stress"].as_str()).collect();
    assert_eq!(names, ["von_mises", "tresca", "hydrostatic", "orthogonal_shear"]);
    assert!((0.4..0.8).contains(&number(&rail[0], "over_p0")), "{rail:?}");
    assert!((0.5..6.0).contains(&number(&rail[0], "depth_mm")), "{rail:?}");
    assert!(number(&rail[2], "value_mpa") < -300.0, "{rail:?}");
    let drawn = std::fs::read_to_string(&figure).unwrap();
    for text in
        ["of the rail", "S1002 on 60E1", "von Mises stress over p0", "Along rolling", "mm deep"]
    {
        assert!(drawn.contains(text), "{text}");
    }
    assert!(drawn.matches("<polygon").count() > 10);
    let rows = table(&std::fs::read(&points).unwrap());
    assert!(rows.len() > 10_000);
    let largest = rows.iter().map(|row| number(row, "von_mises_mpa")).fold(0.0, f64::max);
    let found = number(&rail[0], "value_mpa");
    assert!(largest <= found * (1.0 + 1e-6) && largest > 0.97 * found, "{largest} {found}");

    // Bodies of one material carry the same pressure, and opposite tractions.
    let wheel = success(&["stress", &path, "--body", "wheel", "-o", &figure]);
    let [a, b] = [&rail, &wheel].map(|rows| number(&rows[0], "value_mpa"));
    assert!((a / b - 1.0).abs() < 0.1, "{a} {b}");
    assert!(std::fs::read_to_string(&figure).unwrap().contains("of the wheel"));
}

#[test]
fn stress_below_a_planar_contact_is_that_of_hertz() {
    let (folder, path) = written(
        "separation,radius_mm,load_n,poisson_ratio,tangential_model\nf.csv,460,20000,0.3,none\n",
    );
    std::fs::write(folder.path().join("f.csv"), parabola()).unwrap();
    let figure = folder.path().join("stress.svg");
    let figure = figure.to_str().unwrap();
    let rows = success(&["stress", &path, "-o", figure]);
    // Between a line and a circle.
    assert!((0.55..0.67).contains(&number(&rows[0], "over_p0")), "{rows:?}");
    assert!((0.57..0.70).contains(&number(&rows[1], "over_p0")), "{rows:?}");
    let message = failure(&["stress", &path, "--row", "2", "-o", figure]);
    assert!(message.contains("has rows 1 to 1"), "{message}");
    let message = failure(&["stress", &path, "-o", "stress.txt"]);
    assert!(message.contains("ends in .svg"), "{message}");
    // A millimetre apart.
    let lifted = "y_mm,f_mm\n-4,1.1\n-2,1.03\n0,1\n2,1.03\n4,1.1\n";
    std::fs::write(folder.path().join("lifted.csv"), lifted).unwrap();
    std::fs::write(&path, "separation,radius_mm,approach_mm\nlifted.csv,460,0.05\n").unwrap();
    let message = failure(&["stress", &path, "-o", figure]);
    assert!(message.contains("do not touch"), "{message}");
}

#[test]
fn contacts_that_remember_are_refused_where_tractions_are_those_of_steady_rolling() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (path, figure) = (file("run.csv"), file("figure.svg"));
    let table = "wheel.y,wheel.z,wheel.vx,wheel.pitch_rate,normal.model,tangential.model,tangential.history\n\
                 0.747,-0.4597,20,-43.4,boundary_element,boundary_element,transient\n";
    std::fs::write(&path, table).unwrap();
    for command in ["stress", "fatigue", "plot"] {
        let message = failure(&[command, &path, "-o", &figure]);
        let refused = "tangential.history = \"transient\" is not admitted: steady";
        assert!(message.contains("row 1") && message.contains(refused), "{command}: {message}");
    }
    success(&["evaluate", &path]);
}
