//! Rollers and rails whose section varies along the track: there backwards where there are forwards,
//! and none by what their rows do not go back to.

use super::parameters::compare_to;
use super::*;
use crate::common::varying::{bent, head, of_slices, slices};
use wheelrail::element::parameters::Placement;

/// Rollers, and rails of slices that bend and rise, with the folders that these are in.
fn ways() -> Vec<(&'static str, Parameters, Option<tempfile::TempDir>)> {
    let smooth = Parameters { tangential_model: TangentialModel::Tables, ..Parameters::default() };
    let mut roller = smooth.clone();
    roller.rails[0].roller_radius = 0.5;
    let mut corrugated = Parameters { normal_model: NormalModel::PiotrowskiKik, ..roller.clone() };
    corrugated.rails[0].placement = Placement::Origin;
    corrugated.rails[0].position = [0.7525, 0.0];
    let mut all = vec![("roller", roller, None), ("roller at its origin", corrugated, None)];
    for normal_model in [NormalModel::Strips, NormalModel::PiotrowskiKik, NormalModel::Hertz] {
        let places = (-15..=15).map(|i| 40.0 * f64::from(i));
        let folder = slices(places, |place| head(bent(place)));
        let mut parameters = of_slices(Parameters { normal_model, ..smooth.clone() });
        parameters.rails[0].profile = folder.path().join("rail.slcs").to_str().unwrap().into();
        all.push(("slices", parameters, Some(folder)));
    }
    all
}

#[test]
fn of_inputs_they_are_there_where_they_are_forwards() {
    for (name, parameters, _folder) in ways() {
        judge(name, &parameters);
        for vertical_mode in [VerticalMode::Penetration, VerticalMode::Load] {
            let parameters = Parameters { vertical_mode, ..parameters.clone() };
            let mut own = element(&parameters);
            let (mut random, mut refused) = (Random::new(71), 0);
            for _ in 0..30 {
                let mut input = random_input(&mut own, &mut random);
                input.wheel_load = random.within(3e4, 1.2e5);
                input.track_s = random.about(0.3);
                let weights = weights(&mut random, &evaluate(&mut own, &input));
                let forwards = own.jacobian(&input, &mut Vec::new());
                let mut gradient = Gradient::default();
                let backwards = own.adjoint_derivative(&input, &weights, &mut gradient);
                refused += u32::from(forwards.is_err());
                assert_eq!(forwards, backwards, "{name}: {input:?}");
            }
            println!("{name} {vertical_mode:?}: none at {refused} of 30");
            assert!(refused < 15, "{name}");
        }
    }
}

#[test]
fn of_parameters_they_are_those_of_differences_or_not_there() {
    for (name, parameters, _folder) in ways() {
        let input = pose(&parameters, &mut Random::new(41));
        let tolerance = match name {
            "slices" => tolerance::BACKWARDS_ON_SLICES,
            _ => tolerance::BACKWARDS_DIFFERENCES,
        };
        let effective = compare_to(tolerance, name, &parameters, &input);
        for there in ["wheel.nominal_radius", "rail.young_modulus", "wheel.poisson_ratio"] {
            assert!(effective.contains(&there), "{name}: {effective:?}");
        }
        assert!(!effective.contains(&"rail[1].inclination"), "{name}: {effective:?}");
        let mut own = element(&parameters);
        let mut gradient = Gradient::default();
        own.adjoint_derivative(&input, &Output::default(), &mut gradient).unwrap();
        assert!(gradient.parameters.inclination[0].is_nan());
        let by_gauge = parameters.rails[0].placement == Placement::Gauge;
        assert_eq!(gradient.parameters.gauge_depth.is_nan(), by_gauge, "{name}");
        assert!(gradient.rail_points[0].is_empty(), "{name}");
        assert!(!gradient.wheel_points.is_empty(), "{name}");
    }
}
