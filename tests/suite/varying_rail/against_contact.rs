//! Rails that vary against CONTACT's table of them.

use super::*;
use wheelrail::element::output::Patch;

/// Median and worst of the errors on a rail by a normal model: height and place [m], pressure and
/// creep force, over the friction limit.
fn against_contact(rail: &str, normal_model: NormalModel) -> [[f64; 2]; 4] {
    let mut parameters = Parameters { normal_model, ..Parameters::default() };
    if normal_model == NormalModel::BoundaryElement {
        // As in CONTACT, whose contact is flat.
        parameters.tangential_model = TangentialModel::BoundaryElement;
        parameters.creepage_model = CreepageModel::Flat;
    }
    let errors = errors_against_contact(rail, &parameters);
    assert!(errors.len() > 20);
    let [height, pressure, place, force] =
        [0, 1, 2, 3].map(|k| median_and_worst(errors.iter().map(|(_, own)| own[k]).collect()));
    let mut report = String::from("quantity,median,worst\n");
    let named = [("height", height), ("pressure", pressure), ("place", place), ("force", force)];
    for (quantity, [median, worst]) in named {
        writeln!(report, "{quantity},{median:.3e},{worst:.3e}").unwrap();
    }
    println!("{rail}, {normal_model:?}: {report}");
    common::write_report(&format!("varying_{rail}_{normal_model:?}.csv"), &report);
    [height, pressure, place, force]
}

#[test]
fn a_wing_rail_that_runs_off_is_met_as_by_contact() {
    let [height, pressure, place, force] = against_contact("wing", NormalModel::Strips);
    assert!(height[0] <= tolerance::VARYING_HEIGHT);
    assert!(pressure[0] <= tolerance::VARYING_PRESSURE);
    assert!(place[0] <= tolerance::VARYING_PLACE);
    assert!(force[0] <= tolerance::PASSED_ALONG_TRACK);
}

/// Rolling along its rows on the planes of the element and with its creepages, boundary elements on
/// the exact surfaces of the wing have the element's creep forces.
#[test]
fn a_wing_rail_that_runs_off_has_the_creep_forces_of_rolling_along_its_rows() {
    let outputs = outputs_of("wing", &Parameters::default());
    let patches: Vec<_> = outputs.iter().map(|output| output.patches[0]).collect();
    let median = |course: f64| {
        let found = on_planes("wing", &Whose::Element(&patches), course, f64::INFINITY);
        let pairs = found.iter().zip(&patches);
        let apart = |(plane, patch): (&OnPlane, &Patch)| {
            let [a, b] = [0, 1].map(|c| plane.force[c] - patch.creep_force[c]);
            a.hypot(b) / plane.limit
        };
        spread(pairs.map(apart).collect())
    };
    let (along_rows, along_track) = (median(0.1_f64.atan()), median(0.0));
    println!("along rows {along_rows:.4?}, along the track {along_track:.4?}");
    assert!(along_rows[0] <= tolerance::VARYING_FORCE, "{along_rows:?}");
    assert!(along_rows[0] < along_track[0], "{along_rows:?} {along_track:?}");
}

#[test]
fn a_nose_that_rises_is_met_as_by_contact() {
    let [height, _, place, _] = against_contact("nose", NormalModel::Strips);
    assert!(height[0] <= tolerance::VARYING_HEIGHT);
    assert!(place[0] <= tolerance::VARYING_PLACE);
}

#[test]
#[ignore = "some fifty loads by boundary elements: minutes in debug builds"]
fn boundary_elements_meet_a_rail_that_varies_as_contact_does() {
    let [height, pressure, place, force] = against_contact("wing", NormalModel::BoundaryElement);
    assert!(height[0] <= tolerance::VARYING_HEIGHT);
    assert!(pressure[0] <= tolerance::VARYING_PRESSURE);
    assert!(place[0] <= tolerance::VARYING_PLACE);
    assert!(force[0] <= tolerance::PASSED_ALONG_TRACK);
    let [height, _, place, force] = against_contact("nose", NormalModel::BoundaryElement);
    assert!(height[0] <= tolerance::VARYING_HEIGHT);
    assert!(place[0] <= tolerance::VARYING_PLACE);
    assert!(force[0] <= tolerance::VARYING_FORCE);
}

/// Rolling along the track and with the plane of the reference, which is not that of the surfaces,
/// boundary elements have its creep forces.
#[test]
fn on_the_plane_of_contact_creep_forces_are_those_of_contact() {
    // Behind the last but one of its slices the nose is another one in the reference.
    for (name, last) in [("wing", f64::INFINITY), ("nose", 0.09)] {
        let errors = errors_on_plane(name, &Whose::Contact, 0.0, last);
        assert!(errors.len() > 30);
        let [median, most, worst] = spread(errors.iter().map(|(_, own)| own[1]).collect());
        println!("{name}: {median:.4} {most:.4} {worst:.4}");
        assert!(most <= tolerance::VARYING_FORCE, "{name}: {median} {most} {worst}");
    }
}
