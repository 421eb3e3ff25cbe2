//! Flats by sections around the wheel.

use super::*;

/// Median, 95 % and worst by a normal model on the flat of CONTACT's table, of every `step`-th row:
/// height [m], place [m], creep force over the friction limit; and the greatest pressure where no
/// edge lies in the patch.
fn on_flat(
    normal_model: NormalModel,
    tangential_model: TangentialModel,
    step: usize,
) -> [[f64; 3]; 4] {
    let parameters = Parameters { normal_model, tangential_model, ..Parameters::default() };
    let cases = errors_on_flat(&parameters, step);
    let of = |k: usize| spread(cases.iter().map(|case| case.errors[k]).collect());
    let smooth = cases.iter().filter(|case| case.pitch.abs() > tolerance::FLAT_WITHOUT_EDGE);
    let pressure = spread(smooth.map(|case| case.errors[1]).collect());
    let found = [of(0), of(2), of(3), pressure];
    let mut report = String::from("quantity,median,95,worst\n");
    for (quantity, [median, most, worst]) in
        ["height", "place", "force", "pressure"].iter().zip(found)
    {
        writeln!(report, "{quantity},{median:.3e},{most:.3e},{worst:.3e}").unwrap();
    }
    for case in &cases {
        println!("{} {:?}", case.name, case.errors);
    }
    println!("{normal_model:?}: {report}");
    if step == 1 {
        crate::common::write_report(&format!("varying_flat_{normal_model:?}.csv"), &report);
    }
    assert!(found[0][0] <= tolerance::VARYING_HEIGHT);
    assert!(found[1][0] <= tolerance::VARYING_PLACE);
    found
}

#[test]
fn strips_stand_on_a_flat_as_by_contact() {
    on_flat(NormalModel::Strips, TangentialModel::Marches, 1);
}

#[test]
fn boundary_elements_roll_over_a_flat_as_by_contact() {
    // As many as debug builds have time for.
    let [_, _, force, pressure] =
        on_flat(NormalModel::BoundaryElement, TangentialModel::BoundaryElement, 6);
    assert!(force[1] <= tolerance::VARYING_FORCE && pressure[0] <= tolerance::VARYING_PRESSURE);
}

#[test]
#[ignore = "fifteen loads by boundary elements: minutes in debug builds"]
fn boundary_elements_roll_over_all_of_a_flat_as_by_contact() {
    let [_, _, force, pressure] =
        on_flat(NormalModel::BoundaryElement, TangentialModel::BoundaryElement, 1);
    assert!(force[1] <= tolerance::VARYING_FORCE && pressure[0] <= tolerance::VARYING_PRESSURE);
}

#[test]
fn boundary_elements_stand_on_both_ends_of_a_flat_that_is_hollow() {
    let folder = wheel_with_flat(1.8);
    let parameters =
        Parameters { normal_model: NormalModel::BoundaryElement, ..Parameters::default() };
    let (mut element, mut input) = on_crown(&parameters, &folder);
    (input.wheel_load, input.friction) = (1e4, 0.0);
    let mut last = None;
    for i in -2..=2 {
        input.wheel.pitch = 2e-5 * f64::from(i);
        let output = evaluate(&mut element, &input);
        let patches = &output.patches[..output.patch_count as usize];
        let place = patches.iter().map(|p| p.normal_force * p.position[0]).sum::<f64>() / 1e4;
        let length = patches.iter().map(|p| p.length).fold(0.0, f64::max);
        println!("{i} {place:e} {length} {:e} {:?}", output.wheel_z, output.wheel.moment);
        assert_relative_eq!(output.wheel.force[2], -1e4, max_relative = tolerance::SIMILARITY);
        // What presses ahead turns the wheel.
        let moment = output.wheel.moment[1];
        assert_relative_eq!(moment, 1e4 * place, max_relative = 1e-6, epsilon = 1e-6);
        if i == 0 {
            // From one end to the other; a tenth of an element of symmetry.
            assert!(length > 0.02 && place.abs() < 1e-4, "{length} {place}");
        }
        // The load goes over bit by bit.
        let moved = last.map_or(0.0, |last: f64| place - last);
        assert!(moved.abs() < 0.2 * length, "{i} {moved}");
        last = Some(place);
    }
}
