//! Rails whose section varies along the track, and rollers.

use super::*;
use crate::common::varying::{of_slices, slices};

/// A head of arcs of radius 300, 80 and 13 mm with steep sides, moved by (`y`, `z`) [mm].
fn head([y, z]: [f64; 2]) -> String {
    let arcs = [(300.0, 0.05), (80.0, 0.3), (13.0, 1.4)];
    let (mut side, mut from) = (vec![[0.0, 0.0]], 0.0);
    for (radius, to) in arcs {
        let [start_y, start_z] = side[side.len() - 1];
        let count = (radius * (to - from) / 0.3_f64).ceil();
        side.extend((1..=count as usize).map(|i| {
            let angle: f64 = from + (to - from) * i as f64 / count;
            let across = angle.sin() - from.sin();
            [start_y + radius * across, start_z + radius * (from.cos() - angle.cos())]
        }));
        from = to;
    }
    let [end_y, end_z] = side[side.len() - 1];
    side.extend((1..=60).map(|i| {
        let along = 0.3 * f64::from(i);
        [end_y + along * from.cos(), end_z + along * from.sin()]
    }));
    let other: Vec<_> = side[1..].iter().rev().map(|[y, z]| [-y, *z]).collect();
    let points = other.iter().chain(&side);
    points
        .fold(String::new(), |text, own| text + &format!("{:.12} {:.12}\n", own[0] + y, own[1] + z))
}

/// `parameters` on a rail of slices that stand at `at(place)` [mm].
fn judge_rail(name: &str, parameters: &Parameters, at: impl Fn(f64) -> [f64; 2]) {
    let places = (-30..=30).map(|i| 20.0 * f64::from(i));
    let folder = slices(places, |place| head(at(place)));
    let mut parameters = of_slices(parameters.clone());
    parameters.rails[0].profile = folder.path().join("rail.slcs").to_str().unwrap().into();
    judge_few(name, &parameters);
}

/// A rail that bends to the side and up and down along the track [mm].
fn bent(place: f64) -> [f64; 2] {
    let wave = place / 80.0;
    [0.8 * wave.sin(), 0.5 * (1.3 * wave).cos()]
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
