//! `wheelrail fatigue`.

use super::*;

#[test]
fn fatigue_judges_contacts_and_maps_them_below_the_profile() {
    let (folder, path) = written(
        "id,passages,wheel.y,wheel.load,vertical.mode,motion,wheel.vx,wheel.yaw\n\
         tread,10,0.747,60000,load,rolling,20,0.002\n\
         head,2,0.751,60000,load,rolling,20,0.01\n",
    );
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let (figure, map) = (file("fatigue.svg"), file("map.csv"));
    let arguments =
        ["fatigue", &path, "-o", &figure, "--map", &map, "--endurance", "100", "--step", "2"];
    let rows = success(&arguments);
    assert!(rows.len() >= 2 && rows[0]["row"] == "1" && rows.last().unwrap()["row"] == "2");
    for row in &rows {
        let [limit, factor] = ["shakedown_limit", "p0_over_k"].map(|column| number(row, column));
        assert!(number(row, "elastic_limit") < limit, "{row:?}");
        assert_eq!(row["response"] == "plastic", factor > limit, "{row:?}");
        assert!((factor - number(row, "p0_mpa") / 300.0).abs() < 1e-4, "{row:?}");
    }
    let cells = table(&std::fs::read(&map).unwrap());
    let most = |column: &str| cells.iter().map(|row| number(row, column)).fold(0.0, f64::max);
    let greatest = rows.iter().map(|row| number(row, "dang_van_mpa")).fold(0.0, f64::max);
    // The map has a place every two millimetres.
    assert!((0.7..=1.01).contains(&(most("dang_van_mpa") / greatest)), "{greatest}");
    assert!(most("passages_beyond_endurance") >= 10.0);
    let drawn = std::fs::read_to_string(&figure).unwrap();
    for text in ["Shakedown map", "Dang Van below rail 1, 60E1", "used friction", "depth [mm]"] {
        assert!(drawn.contains(text), "{text}");
    }
    // Residual compression helps.
    let pressed = success(&["fatigue", &path, "-o", &figure, "--residual", "-300"]);
    let fell = greatest
        - pressed.iter().map(|row| number(row, "dang_van_mpa")).fold(f64::NEG_INFINITY, f64::max);
    assert!((fell - 100.0).abs() < 1.0, "{fell}");
}

#[test]
fn fatigue_says_what_it_cannot_take() {
    let (folder, path) =
        written("separation,radius_mm,load_n,tangential_model\nf.csv,460,20000,none\n");
    std::fs::write(folder.path().join("f.csv"), parabola()).unwrap();
    let figure = folder.path().join("fatigue.svg");
    let figure = figure.to_str().unwrap();
    let rows = success(&["fatigue", &path, "-o", figure]);
    assert_eq!((rows.len(), rows[0]["rail"].as_str()), (1, "0"));
    let message = failure(&["fatigue", &path, "-o", figure, "--map", "map.csv"]);
    assert!(message.contains("planar problems have no profile"), "{message}");
    let message = failure(&["fatigue", &path, "-o", figure, "--shear-yield", "0"]);
    assert!(message.contains("--shear-yield 0 is not admitted"), "{message}");
    let message = failure(&["fatigue", &path, "-o", figure, "--step", "7"]);
    assert!(message.contains("--step 7"), "{message}");
    std::fs::write(&path, "passages,wheel.z\n-1,-0.4597\n").unwrap();
    let message = failure(&["fatigue", &path, "-o", figure]);
    assert!(message.contains("column \"passages\"") && message.contains("-1"), "{message}");
    std::fs::write(&path, "rail[1].profile,wheel.z\n60E1,-0.4597\n54E1,-0.4597\n").unwrap();
    let message = failure(&["fatigue", &path, "-o", figure]);
    assert!(message.contains("one profile: 54E1 here, 60E1"), "{message}");
    std::fs::write(&path, "wheel.z\n-0.5\n").unwrap();
    let output = wheelrail(&["fatigue", &path, "-o", figure]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && message.contains("no row has a contact"), "{message}");
}
