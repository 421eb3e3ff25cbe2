//! Falling friction and reduced initial slope with every tangential model, and through the element.

use crate::common::planar::{HertzRow, parabola, steel_case};
use crate::common::summary::Summary;
use crate::common::{read_table, value};
use crate::tolerance;
use approx::assert_relative_eq;
use wheelrail::element::parameters::{
    FallingLaw, FlashTemperature, FrictionLaw, TangentialModel, WearModel,
};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::error::ContactError;
use wheelrail::planar::{Indentation, PlanarCase, PlanarResult, solve};

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
    // Archard: the power over what friction is left, so that wear of a wheel that slides as a whole
    // does not depend on friction.
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
    // Mean of q sqrt(a) over the load of a Hertzian ellipse, whose strips have both in proportion
    // to their chord c: of c^1.5 over c².
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

/// Fall of friction of a patch that slides as a whole, h, with the temperatures of `elements`
/// pieces along each of its strips, `rise` the greatest μ q s sqrt(a/V)/(2 β) and `fall` what is
/// lost for each kelvin: friction of each piece at its own temperature, summed over a circular
/// patch as CONTACT sums it (its share of the sources on the piece itself is that of a whole piece,
/// where half of it has passed).
fn as_contact_sums(elements: i32, rise: f64, fall: f64) -> f64 {
    let n = f64::from(elements);
    let (mut load, mut held) = (0.0, 0.0);
    for row in 0..elements {
        let y = (2.0 * f64::from(row) + 1.0) / n - 1.0;
        let half = (1.0 - y * y).sqrt();
        let pressure = |k: i32| {
            let x = 1.0 - (2.0 * f64::from(k) + 1.0) / n;
            (half * half - x * x).max(0.0).sqrt()
        };
        // Of the sources that a piece has passed its own friction is asked for: piece after piece
        // from the leading edge.
        let mut sources: Vec<f64> = Vec::new();
        for k in 0..elements {
            let piece = 1.0 / n;
            let before: f64 = (sources.iter().enumerate())
                .map(|(j, source)| {
                    let way = 2.0 * f64::from(k - j as i32) * piece;
                    source * ((way + piece).sqrt() - (way - piece).sqrt())
                })
                .sum();
            let own = pressure(k) * 2.0 * piece.sqrt();
            let at = |h: f64| 2.0 * rise / std::f64::consts::PI.sqrt() * (before + h * own);
            let h = (1.0 - fall * at(0.0)) / (1.0 + fall * (at(1.0) - at(0.0)));
            sources.push(h * pressure(k));
            load += pressure(k);
            held += h * pressure(k);
        }
    }
    held / load
}

#[test]
fn friction_that_falls_with_temperature_is_that_of_the_contact_program() {
    let table = read_table("contact_25_1/temperature.csv");
    let mut summary = Summary::new("temperature");
    for row in &table.rows {
        let v = |name: &str| value(&table, row, name);
        let separation = parabola(5.0, 3e-3);
        let share = 1.0 - v("fall") / 0.3;
        let case = PlanarCase {
            tangential_model: TangentialModel::FastsimCorrected,
            flash_temperature: FlashTemperature { share, onset: 0.0, range: v("fall_K"), ..HOT },
            creepage: [v("cksi"), v("ceta"), 1e3 * v("cphi_per_mm")],
            speed: 1e-3 * v("v_mm_s"),
            indentation: Indentation::Load(v("fn_N")),
            ..steel_case(&separation, 0.1, 1e-5)
        };
        let found = solve(&case).unwrap();
        let limit = 0.3 * v("fn_N");
        let expected = v("fx_N").hypot(v("fs_N")) / limit;
        let found = found.fx.hypot(found.fy) / limit;
        let half_length = (1.5 * v("fn_N") / (std::f64::consts::PI * 1e6 * v("pmax_MPa"))).sqrt();
        let rise = 0.3
            * 1e6
            * v("pmax_MPa")
            * case.speed
            * v("cksi").hypot(v("ceta"))
            * (half_length / case.speed).sqrt()
            / (2.0 * (HOT.conductivity * HOT.heat_capacity).sqrt());
        let elements = (2.0 * half_length / 2e-4).round() as i32;
        let on_grid = as_contact_sums(elements, rise, v("fall") / 0.3 / v("fall_K"));
        let name = if v("fall") > 0.0 { "falls by 0.45 in 1000 K" } else { "is constant" };
        let percent = |share: f64| [100.0 * (share - expected)];
        let here = format!("creep force, friction {name} [% of the friction limit]");
        summary.add(&here, percent(found), "");
        summary.add("the same, temperatures summed on the program's grid", percent(on_grid), "");
        // The program is between the closed form and what its own grid makes of it.
        let least = on_grid.min(found) - tolerance::FULL_SLIDING;
        assert!(expected >= least, "{expected} {on_grid} {found}");
        assert!(expected <= found + tolerance::FULL_SLIDING, "{expected} {on_grid} {found}");
    }
    summary.write();
}

#[test]
fn a_patch_tells_its_friction_and_its_temperature() {
    let told = |law: FrictionLaw, heat: FlashTemperature| {
        let parameters =
            Parameters { friction_law: law, flash_temperature: heat, ..Parameters::default() };
        let mut input = Input::default();
        let mut element = Element::new(&parameters, &input, &[]).unwrap();
        input.wheel.position[2] = element.nominal_wheel_z() + 5e-5;
        input.wheel.velocity[0] = 20.0;
        input.wheel.pitch_rate = -1.1 * 20.0 / 0.46;
        let mut output = Output::default();
        element.evaluate(&input, &mut output).unwrap();
        let patch = output.patches[0];
        let held = patch.creep_force[0].abs() / patch.normal_force;
        assert_relative_eq!(patch.friction_coefficient, held, max_relative = 5e-3);
        [patch.friction_coefficient, patch.temperature]
    };
    let cold = FlashTemperature::default();
    let unchanged = told(FrictionLaw::default(), cold);
    assert_eq!(unchanged.map(f64::to_bits), [0.3_f64, 0.0].map(f64::to_bits));
    let [fallen, _] = told(FALLING, cold);
    assert!(fallen < 0.2, "{fallen}");
    for law in [FrictionLaw::default(), FALLING] {
        let [friction, _] = told(law, cold);
        let [left, rise] = told(law, HOT);
        let expected = friction * (1.0 - 0.6 * (rise - 20.0) / 200.0).clamp(0.4, 1.0);
        assert_relative_eq!(left, expected, max_relative = 1e-3);
        assert!(rise > 50.0, "{rise}");
    }
}
