//! `wheelrail plot`.

use super::*;

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
    assert!(of("strips") > 80 && of("boundary_element") > 80);
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
