//! Derivatives of the outputs by the inputs against central differences, at random poses and by
//! model.

mod differences;
mod varying_rails;

use crate::common;
use crate::common::random::Random;
use crate::common::wheel::{element, evaluate, mirrored, pressed, random_input, rolling};
use differences::{groups, judge, judge_few, largest};
use wheelrail::element::input::INPUTS;
use wheelrail::element::parameters::{
    Changeover, CreepageModel, Flexibilities, FrictionDistribution, FrictionLaw, NormalModel,
    ShapeFit, Side, TangentialModel, TractionBound, VerticalMode,
};
use wheelrail::element::{Input, Output, Parameters};

fn default() -> Parameters {
    Parameters { damping: 1e5, ..Parameters::default() }
}

#[test]
fn of_normal_models() {
    for (name, normal_model) in [
        ("hertz", NormalModel::Hertz),
        ("piotrowski_kik", NormalModel::PiotrowskiKik),
        ("piotrowski_kik_corrected", NormalModel::PiotrowskiKikCorrected),
    ] {
        judge(name, &Parameters { normal_model, ..default() }, &[]);
    }
}

#[test]
fn of_strips() {
    let normal_model = NormalModel::Strips;
    let strips = Parameters { normal_model, strips: 15, elements_along: 15, ..default() };
    judge("strips", &strips, &[]);
    let tangential_model = TangentialModel::Tables;
    let creepage_model = CreepageModel::Curved;
    judge("strips_tables", &Parameters { tangential_model, creepage_model, ..strips }, &[]);
}

#[test]
fn of_the_simpler_tangential_models() {
    for (name, tangential_model) in [
        ("none", TangentialModel::None),
        ("linear", TangentialModel::Linear),
        ("fastrip", TangentialModel::Fastrip),
    ] {
        judge(name, &Parameters { tangential_model, ..default() }, &[]);
    }
}

#[test]
fn of_tabulated_forces() {
    for (name, tangential_model) in [
        ("tables", TangentialModel::Tables),
        ("fastsim_corrected", TangentialModel::FastsimCorrected),
        ("marches", TangentialModel::Marches),
    ] {
        judge(name, &Parameters { tangential_model, ..default() }, &[]);
    }
}

#[test]
fn of_creepage_models() {
    for (name, creepage_model) in
        [("kinematic", CreepageModel::Kinematic), ("curved", CreepageModel::Curved)]
    {
        judge(name, &Parameters { creepage_model, ..default() }, &[]);
    }
    let tangential_model = TangentialModel::FastsimCorrected;
    let creepage_model = CreepageModel::Curved;
    judge("curved_corrected", &Parameters { creepage_model, tangential_model, ..default() }, &[]);
}

#[test]
fn of_other_options() {
    let mut parameters = default();
    parameters.friction_law.falling_share = 0.4;
    parameters.friction_law.falling_decay = 0.6;
    parameters.friction_law.reduction = 0.5;
    parameters.friction_law.reduction_share = 0.3;
    parameters.friction_law.reduction_decay = 0.6;
    judge("friction_law", &parameters, &[]);
    parameters.tangential_model = TangentialModel::Tables;
    judge("friction_law_tables", &parameters, &[]);
    parameters.flash_temperature.share = 0.4;
    judge("flash_temperature", &parameters, &[]);
    parameters = Parameters {
        bound: TractionBound::Parabolic,
        flexibilities: Flexibilities::Three,
        shape_fit: ShapeFit::Paper,
        normal_model: NormalModel::PiotrowskiKikCorrected,
        ..default()
    };
    judge("paper", &parameters, &[]);
}

#[test]
fn of_friction_over_the_rail() {
    let law = FrictionLaw {
        falling_share: 0.4,
        falling_decay: 0.6,
        reduction: 0.5,
        ..FrictionLaw::default()
    };
    let regions = Parameters {
        friction_distribution: FrictionDistribution::Regions,
        friction_changeover: Changeover { inclination: -0.15, width: 0.6 },
        gauge_face_law: law,
        ..default()
    };
    judge("friction_regions", &regions, &[]);
    let normal_model = NormalModel::PiotrowskiKik;
    let tangential_model = TangentialModel::Tables;
    judge(
        "friction_regions_tables",
        &Parameters { normal_model, tangential_model, ..regions },
        &[],
    );
    let folder = tempfile::TempDir::new().unwrap();
    let file = folder.path().join("friction.csv");
    let rows = "station_m inclination_deg friction\n-9 -40 0.1\n-9 5 0.5\n12 -35 0.3\n12 7 0.2\n";
    std::fs::write(&file, rows).unwrap();
    let profile = Parameters {
        friction_distribution: FrictionDistribution::Profile,
        friction_profile: file.to_str().unwrap().into(),
        ..default()
    };
    judge("friction_profile", &profile, &[]);
    std::fs::write(&file, rows.replace("inclination_deg", "place_mm")).unwrap();
    let normal_model = NormalModel::PiotrowskiKik;
    judge("friction_by_place", &Parameters { normal_model, ..profile }, &[]);
}

#[test]
fn of_a_given_load() {
    let parameters = Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() };
    judge("load", &parameters, &[]);
}

#[test]
fn of_several_patches_and_two_rails() {
    let mut parameters = default();
    parameters.rails[1].enabled = true;
    parameters.rails[1].inclination = 0.0;
    // A second head under the outer part of the tread.
    parameters.rails[1].position = [0.81, 0.0];
    let mut element = element(&parameters);
    let mut inputs = Vec::new();
    let mut patches = [0; 2];
    for (shift, yaw, depth) in [
        (-3e-3, 1e-3, 1.0e-4),
        (0.0, 1e-3, 4e-5),
        (5.35e-3, 1e-3, 1e-4),
        (5.4e-3, 8e-3, 1.3e-4),
        (2e-3, -4e-3, 1.5e-4),
    ] {
        let mut input = rolling(shift, 20.0);
        input.wheel.yaw = yaw;
        input.wheel.velocity[1] = 0.02;
        // The second head takes part of the load.
        input.rails[1].z = 2e-3;
        let touching = pressed(&mut element, &input, 0.0).wheel.position[2];
        input.rails[1].z = -0.2;
        let second = pressed(&mut element, &input, 0.0).wheel.position[2] + 0.2;
        input.rails[1].z = touching - second - 3e-5 + 1e-6;
        let input = pressed(&mut element, &input, depth);
        let found = evaluate(&mut element, &input);
        let of_rail = |k: i32| found.patches.iter().filter(|p| p.rail == k).count();
        patches = [patches[0].max(of_rail(1)), patches[1].max(of_rail(2))];
        inputs.push(input);
    }
    assert!(patches[0] >= 2 && patches[1] >= 1, "{patches:?}");
    judge("two_rails", &parameters, &inputs);
}

#[test]
fn one_direction_is_the_product_with_the_jacobian_and_changes_nothing() {
    for vertical_mode in [VerticalMode::Penetration, VerticalMode::Load] {
        for side in [Side::Right, Side::Left] {
            let parameters = Parameters { vertical_mode, side, ..Parameters::default() };
            let mut element = element(&parameters);
            let mut right = common::wheel::element(&Parameters { side: Side::Right, ..parameters });
            let mut random = Random::new(3);
            let mut input = random_input(&mut right, &mut random);
            input.wheel_load = 6e4;
            let input = if side == Side::Left { mirrored(&input) } else { input };
            let before = evaluate(&mut element, &input);
            let mut columns = Vec::new();
            element.jacobian(&input, &mut columns).unwrap();
            let direction: [f64; INPUTS] = std::array::from_fn(|_| random.about(1.0));
            let mut rates = Output::default();
            element
                .directional_derivative(&input, &Input::from_array(direction), &mut rates)
                .unwrap();
            for (g, (_, found)) in groups(&rates).iter().enumerate() {
                for (k, rate) in found.iter().enumerate() {
                    let parts = columns.iter().zip(direction);
                    let (mut sum, mut size) = (0.0, 0.0);
                    for part in parts.map(|(column, d)| d * groups(column)[g].1[k]) {
                        sum += part;
                        size += part.abs();
                    }
                    // Where the height follows, it is much less than its parts.
                    let by_height = 1e-14 * groups(&columns[2])[g].1[k].abs().max(1e9);
                    let error = (rate - sum).abs();
                    assert!(error <= 1e-11 * size + by_height, "group {g}: {rate} {sum}");
                }
            }
            assert_eq!(evaluate(&mut element, &input), before);
        }
    }
}

#[test]
fn a_wheel_without_load_touches_where_it_did_before() {
    let parameters = Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() };
    let mut element = element(&parameters);
    let mut input = rolling(1e-3, 20.0);
    (input.wheel.yaw, input.wheel.roll) = (0.01, 2e-3);
    let mut columns = Vec::new();
    element.jacobian(&input, &mut columns).unwrap();
    for (i, step) in [(1, 1e-6), (3, 1e-6), (4, 1e-5), (12, 1e-6), (13, 1e-6), (14, 1e-6)] {
        let at = input.to_array();
        let mut height = |sign: f64| {
            let mut moved = at;
            moved[i] += sign * step;
            evaluate(&mut element, &Input::from_array(moved)).wheel_z
        };
        let slope = (height(1.0) - height(-1.0)) / (2.0 * step);
        let found = columns[i].wheel_z;
        approx::assert_abs_diff_eq!(found, slope, epsilon = 1e-6);
        assert!(largest(&columns[i].wheel.force) <= 0.0);
    }
}
