//! Equivalent conicity: the reference cases of EN 15302 from Δr on, and profiles with closed forms
//! from the profiles on.

use crate::tolerance;
use std::fmt::Write;

use crate::common::wheel::{plain_parameters, rail_marker};
use crate::common::{read_table, value, write_report};
use approx::assert_relative_eq;
use wheelrail::conicity::{RollingRadiusDifference, TrackedWheelset};
use wheelrail::element::Parameters;

#[test]
fn the_reference_cases_of_en_15302_are_met_within_a_part_of_their_tolerances() {
    let mut report = String::from("case,amplitude_mm,conicity,expected,share_of_tolerance\n");
    let (mut inside, mut outside, mut worst) = (0, 0, 0.0f64);
    for case in 1..=9 {
        let table = read_table(&format!("en15302/E{case}_difference.csv"));
        let v = |row, name| 1e-3 * value(&table, row, name);
        let points = table.rows.iter().map(|row| [v(row, "y_mm"), v(row, "difference_mm")]);
        let difference = RollingRadiusDifference::new(points.collect());
        let table = read_table(&format!("en15302/E{case}_conicity.csv"));
        for row in &table.rows {
            let v = |name| value(&table, row, name);
            let amplitude = v("amplitude_mm");
            let Some(found) = difference.equivalent_conicity(1e-3 * amplitude) else {
                // A turning point beyond the table of Δr.
                assert!(amplitude > 5.0, "E{case}, {amplitude} mm");
                outside += 1;
                continue;
            };
            let share = (found - v("conicity")).abs() / (v("upper") - v("conicity"));
            worst = worst.max(share);
            inside += 1;
            writeln!(report, "E{case},{amplitude},{found:.5},{},{share:.4}", v("conicity"))
                .unwrap();
        }
    }
    println!("{inside} amplitudes, {outside} beyond the tables, worst {worst:.4} of the tolerance");
    write_report("en15302.csv", &report);
    assert!(inside >= 475 && worst < tolerance::EN_15302, "{report}");
}

/// Conicity of a wheelset at 3 mm, and its rolling radii every 0.1 mm.
fn swept(parameters: &Parameters) -> (RollingRadiusDifference, f64) {
    let radii = TrackedWheelset::new(parameters, 1.5, &[]).unwrap().sweep(6e-3, 1e-4);
    assert_eq!(radii.len(), 121);
    let difference = RollingRadiusDifference::of(&radii).unwrap();
    let conicity = difference.equivalent_conicity(3e-3).unwrap();
    (difference, conicity)
}

#[test]
fn cones_have_the_conicity_of_their_angle_whatever_the_rail() {
    for (rail, tangent) in [("arc:0.3", 0.05), ("arc:1", 0.1), ("60E1", 0.025)] {
        let (difference, conicity) = swept(&plain_parameters(&format!("conical:{tangent}"), rail));
        for [y, found] in difference.points() {
            assert_relative_eq!(*found, 2.0 * tangent * y, epsilon = tolerance::ROLLING_RADIUS);
        }
        assert_relative_eq!(conicity, tangent, max_relative = tolerance::CONE_CONICITY);
    }
}

#[test]
fn arcs_on_arcs_have_the_rolling_radii_of_their_closed_form() {
    let (wheel, rail) = (0.5, 0.3);
    let mut parameters = plain_parameters("arc:0.5", "arc:0.3");
    // Rail heads inside the nominal rolling circles: contacts towards the flange.
    parameters.gauge = 1.41;
    let top = rail_marker(&parameters)[1];
    let (difference, conicity) = swept(&parameters);
    // Both centres of curvature and the contact lie on one line.
    let place = |side: f64, y: f64| wheel * (top - 0.75 - side * y) / (wheel - rail);
    let radius = |place: f64| wheel - (wheel * wheel - place * place).sqrt();
    for [y, found] in difference.points() {
        let expected = radius(place(1.0, *y)) - radius(place(-1.0, *y));
        assert_relative_eq!(*found, expected, epsilon = tolerance::ROLLING_RADIUS);
    }
    let tangent = -place(1.0, 0.0) / (wheel * wheel - place(1.0, 0.0).powi(2)).sqrt();
    let expected = tangent * wheel / (wheel - rail);
    println!("{conicity} by the formula for small amplitudes {expected}");
    assert_relative_eq!(conicity, expected, max_relative = tolerance::ARC_CONICITY);
}

#[test]
fn s1002_on_60e1_is_antisymmetric_and_steeper_than_the_cone_of_its_tread() {
    let (difference, conicity) = swept(&Parameters::default());
    let [outermost, ..] = difference.points()[0];
    println!("tan γe(3 mm) {conicity:.4}, from {outermost}");
    // Mirror image.
    for ([_, right], [_, left]) in difference.points().iter().zip(difference.points().iter().rev())
    {
        assert_relative_eq!(*right, -left, epsilon = 1e-12);
    }
    assert!((0.1..0.3).contains(&conicity), "{conicity}");
}
