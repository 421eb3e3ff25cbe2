//! Falling friction and reduced initial slope with every tangential model, and through the element.

mod common;
mod tolerance;

use approx::assert_relative_eq;
use common::planar::{HertzRow, steel_case};
use wheelrail::element::parameters::{
    FallingLaw, FlashTemperature, FrictionLaw, TangentialModel, WearModel,
};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::error::ContactError;
use wheelrail::planar::{PlanarCase, PlanarResult, solve};

const BOUNDED: [TangentialModel; 5] = [
    TangentialModel::Fastsim,
    TangentialModel::Fastrip,
    TangentialModel::Tables,
    TangentialModel::FastsimCorrected,
    TangentialModel::BoundaryElement,
];

const FALLING: FrictionLaw = FrictionLaw {
    falling_law: FallingLaw::Exponential,
    falling_share: 0.38,
    falling_decay: 0.7,
    reduction: 1.0,
    reduction_share: 1.0,
    reduction_decay: 0.0,
};

/// A steel ellipse of a/b = 1 that rolls at 10 m/s.
fn rolled(
    tangential_model: TangentialModel,
    friction_law: FrictionLaw,
    creepage: [f64; 3],
) -> Result<PlanarResult, ContactError> {
    let row = HertzRow::with_ratio(1.0);
    let separation = row.separation();
    solve(&PlanarCase {
        tangential_model,
        friction_law,
        creepage,
        speed: 10.0,
        ..steel_case(&separation, 0.5 / row.along, row.approach)
    })
}

#[test]
fn full_sliding_has_the_friction_of_its_speed() {
    for model in BOUNDED {
        for creepage in [0.05, 0.1, 0.5] {
            let found = rolled(model, FALLING, [creepage, 0.0, 0.0]).unwrap();
            let friction = 0.3 * (0.38 + 0.62 * (-0.7 * 10.0 * creepage).exp());
            let share = -found.fx / found.normal_force;
            assert_relative_eq!(share, friction, max_relative = tolerance::FULL_SLIDING);
        }
    }
}

#[test]
fn without_sliding_friction_does_not_fall_and_forces_are_those_of_constant_friction() {
    for model in BOUNDED {
        let plain = rolled(model, FrictionLaw::default(), [1e-6, 0.0, 0.0]).unwrap();
        let falling = rolled(model, FALLING, [1e-6, 0.0, 0.0]).unwrap();
        assert_relative_eq!(falling.fx, plain.fx, max_relative = 1e-4);
    }
}

#[test]
fn the_initial_slope_is_reduced_and_the_limit_is_not() {
    let law = FrictionLaw { reduction: 0.5, ..FrictionLaw::default() };
    for model in BOUNDED.into_iter().chain([TangentialModel::Linear]) {
        let at = |law, creepage: f64| rolled(model, law, [0.0, creepage, 0.0]).unwrap().fy;
        let plain = at(FrictionLaw::default(), 1e-6);
        assert_relative_eq!(at(law, 1e-6), 0.5 * plain, max_relative = 2e-3);
        if model != TangentialModel::Linear {
            let limit = at(FrictionLaw::default(), 0.1);
            assert_relative_eq!(at(law, 0.1), limit, max_relative = tolerance::FULL_SLIDING);
        }
    }
}

#[test]
fn a_sliding_wheel_loses_creep_force_with_its_speed() {
    let at = |speed: f64, law: FrictionLaw| {
        let parameters = Parameters {
            friction_law: law,
            tangential_model: TangentialModel::Tables,
            ..Parameters::default()
        };
        let mut input = Input::default();
        input.wheel.position[1] -= 3e-3;
        let mut element = Element::new(&parameters, &input, &[]).unwrap();
        input.wheel.position[2] = element.nominal_wheel_z() + 5e-5;
        input.wheel.velocity[0] = speed;
        // A tenth faster than it rolls.
        input.wheel.pitch_rate = -1.1 * speed / 0.46;
        let mut output = Output::default();
        element.evaluate(&input, &mut output).unwrap();
        output.patches[0].creep_force[0] / output.patches[0].normal_force
    };
    let plain = FrictionLaw::default();
    assert_relative_eq!(at(5.0, plain), at(40.0, plain), max_relative = 1e-9);
    let [slow, fast] = [5.0, 40.0].map(|speed| at(speed, FALLING));
    assert!(fast < 0.6 * slow && slow < at(5.0, plain), "{slow} {fast}");
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    let refused = |change: fn(&mut FrictionLaw)| {
        let mut parameters = Parameters::default();
        change(&mut parameters.friction_law);
        Element::new(&parameters, &Input::default(), &[]).unwrap_err().to_string()
    };
    for (message, name) in [
        (refused(|law| law.falling_share = 1.5), "friction.falling.share"),
        (refused(|law| law.falling_decay = -1.0), "friction.falling.decay"),
        (refused(|law| law.reduction = 0.0), "friction.reduction.initial"),
        (refused(|law| law.reduction_share = f64::NAN), "friction.reduction.share"),
        (refused(|law| law.reduction_decay = -0.1), "friction.reduction.decay"),
    ] {
        assert!(message.starts_with(name), "{message}");
    }
}

#[test]
fn sliding_wears_by_what_it_slides_whatever_friction_is_left() {
    // Archard: the power over what friction is left, so that wear of a wheel that slides as a whole does not depend on friction.
    let worn = |law: FrictionLaw| {
        let mut parameters = Parameters {
            friction_law: law,
            tangential_model: TangentialModel::Fastsim,
            ..Parameters::default()
        };
        parameters.wear.model = WearModel::Archard;
        let mut input = Input::default();
        let mut element = Element::new(&parameters, &input, &[]).unwrap();
        input.wheel.position[2] = element.nominal_wheel_z() + 5e-5;
        input.wheel.velocity[0] = 20.0;
        input.wheel.pitch_rate = -1.1 * 20.0 / 0.46;
        let mut output = Output::default();
        element.advance(&input, &mut output, 1e-3).unwrap();
        output.wheel_wear.volume
    };
    let plain = worn(FrictionLaw::default());
    assert!(plain > 0.0);
    assert_relative_eq!(worn(FALLING), plain, max_relative = tolerance::FULL_SLIDING);
}

/// A steel ellipse of a/b = 1 whose friction falls to two fifths between 20 and 220 K.
fn heated(model: TangentialModel, speed: f64, creepage: f64) -> f64 {
    let row = HertzRow::with_ratio(1.0);
    let separation = row.separation();
    let found = solve(&PlanarCase {
        tangential_model: model,
        flash_temperature: HOT,
        creepage: [creepage, 0.0, 0.0],
        speed,
        ..steel_case(&separation, 0.5 / row.along, row.approach)
    });
    let found = found.unwrap();
    -found.fx / found.normal_force
}

const HOT: FlashTemperature = FlashTemperature {
    share: 0.4,
    onset: 20.0,
    range: 200.0,
    conductivity: 50.0,
    heat_capacity: 3.5325e6,
};

#[test]
fn a_hot_patch_has_the_friction_of_its_temperature() {
    let row = HertzRow::with_ratio(1.0);
    // Mean of q sqrt(a) over the load of a Hertzian ellipse, whose strips have both in proportion to their chord c: of c^1.5 over c².
    let mean = |power: f64| {
        let n = 4000;
        let chord = |i: i32| {
            let y = -1.0 + (2.0 * f64::from(i) + 1.0) / f64::from(n);
            (1.0 - y * y).sqrt()
        };
        (0..n).map(|i| chord(i).powf(power)).sum::<f64>()
    };
    let greatest = row.max_pressure * row.semi_axes[0].sqrt();
    let source = greatest * mean(3.5) / mean(2.0);
    for model in BOUNDED {
        for (speed, creepage) in [(5.0, 0.05), (20.0, 0.05), (20.0, 0.2), (60.0, 0.5)] {
            let spread = 2.0 * (50.0 * 3.5325e6 * std::f64::consts::PI * speed).sqrt();
            let rise = speed * creepage * source * 1.572_023_357 / spread;
            let found = heated(model, speed, creepage);
            let temperature = found * rise;
            let expected = 0.3 * (1.0 - 0.6 * (temperature - 20.0) / 200.0).clamp(0.4, 1.0);
            // Of twenty strips.
            assert_relative_eq!(found, expected, max_relative = 3e-3);
        }
    }
}

#[test]
fn what_adheres_stays_cold() {
    for model in BOUNDED {
        let plain = rolled(model, FrictionLaw::default(), [1e-6, 0.0, 0.0]).unwrap();
        let cold = -plain.fx / plain.normal_force;
        assert_relative_eq!(heated(model, 10.0, 1e-6), cold, max_relative = 1e-12);
    }
}
