//! Rails whose section varies along the track, and rollers.

use std::f64::consts::TAU;

use super::*;
use crate::common::varying::{bent, head, of_slices, slices};
use wheelrail::element::parameters::FlatShape;

/// `parameters` on a rail of slices that stand at `at(place)` [mm].
fn judge_rail(name: &str, parameters: &Parameters, at: impl Fn(f64) -> [f64; 2]) {
    let places = (-30..=30).map(|i| 20.0 * f64::from(i));
    let folder = slices(places, |place| head(at(place)));
    let mut parameters = of_slices(parameters.clone());
    parameters.rails[0].profile = folder.path().join("rail.slcs").to_str().unwrap().into();
    judge_few(name, &parameters);
}

#[test]
fn of_rails_that_are_even_rise_or_run_off() {
    let parameters = Parameters { normal_model: NormalModel::Hertz, ..default() };
    judge_rail("rail_of_slices", &parameters, |_| [0.0, 0.0]);
    judge_rail("rising_rail", &parameters, |place| [0.0, 0.02 * place]);
    judge_rail("oblique_rail", &parameters, |place| [0.02 * place, 0.0]);
}

#[test]
fn of_normal_models_on_bent_rails() {
    for (name, normal_model, tangential_model) in [
        ("bent_rail_hertz", NormalModel::Hertz, TangentialModel::Tables),
        (
            "bent_rail_corrected",
            NormalModel::PiotrowskiKikCorrected,
            TangentialModel::FastsimCorrected,
        ),
    ] {
        let creepage_model = CreepageModel::Curved;
        let parameters = Parameters { normal_model, tangential_model, creepage_model, ..default() };
        judge_rail(name, &parameters, bent);
    }
    let vertical_mode = VerticalMode::Load;
    judge_rail("bent_rail_load", &Parameters { vertical_mode, ..Parameters::default() }, bent);
}

#[test]
fn of_strips_on_bent_rails() {
    let normal_model = NormalModel::Strips;
    let strips = Parameters { normal_model, strips: 15, elements_along: 15, ..default() };
    judge_rail("bent_rail_strips", &strips, bent);
}

#[test]
fn of_rollers() {
    let mut parameters = default();
    parameters.rails[0].roller_radius = 0.5;
    judge_few("roller", &parameters);
    let normal_model = NormalModel::Strips;
    let strips = Parameters { normal_model, strips: 15, elements_along: 15, ..parameters };
    judge_few("roller_strips", &strips);
}

#[test]
fn of_strips_over_waves() {
    let normal_model = NormalModel::Strips;
    let strips = Parameters { normal_model, strips: 15, elements_along: 15, ..default() };
    let mut corrugated = strips.clone();
    let wave = &mut corrugated.rails[0].corrugation;
    (wave.amplitude, wave.wavelength) = (1e-5, 0.06);
    judge_few("corrugated_strips", &corrugated);
    let mut uneven = strips.clone();
    let wave = &mut uneven.wheel.out_of_round;
    (wave.amplitude, wave.order) = (2e-5, 40);
    judge_few("out_of_round_strips", &uneven);
    uneven.rails[0].roller_radius = 0.5;
    judge_few("out_of_round_on_roller", &uneven);
    uneven.rails[0] = corrugated.rails[0].clone();
    judge_rail("waves_on_bent_rail", &uneven, bent);
    // On its flat, which the poses are not far from.
    let mut flat = strips;
    flat.wheel.flat.length = 0.2;
    flat.wheel.flat.depth = 2e-3;
    flat.wheel.flat.shape = FlatShape::Worn;
    judge_few("flat_strips", &flat);
}

#[test]
fn of_corrugated_rollers_they_are_refused_by_name() {
    let mut parameters = default();
    parameters.normal_model = NormalModel::Strips;
    let rail = &mut parameters.rails[0];
    rail.roller_radius = 0.5;
    (rail.corrugation.amplitude, rail.corrugation.wavelength) = (1e-5, TAU * 0.5 / 60.0);
    let mut own = element(&parameters);
    let input = Input::default();
    let asked = own.directional_derivative(&input, &input, &mut Output::default());
    let told = asked.unwrap_err().to_string();
    assert!(told.contains("rail[k].roller_radius") && told.contains("even around"), "{told}");
}
