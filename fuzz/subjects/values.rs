//! Numbers and inputs from the bytes of a fuzzer, and what every result must be.

use arbitrary::{Result, Unstructured};
use wheelrail::element::parameters::{FrictionDistribution, NormalModel, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};

/// Greatest coefficient that a file of friction may have.
const MAX_FRICTION: f64 = 10.0;

/// Any number, infinities and what is none among them.
pub fn any(u: &mut Unstructured) -> Result<f64> {
    const SPECIAL: [f64; 8] =
        [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN_POSITIVE, -1.0];
    Ok(match u.int_in_range(0..=9u8)? {
        0 => *u.choose(&SPECIAL)?,
        1 => f64::from_bits(u.arbitrary()?),
        2 => u.arbitrary::<i16>()?.into(),
        _ => within(u, 1.0)?,
    })
}

/// A number from minus `reach` to `reach`, small ones as likely as large ones.
pub fn within(u: &mut Unstructured, reach: f64) -> Result<f64> {
    let share = f64::from(u.arbitrary::<i16>()?) / 32768.0;
    Ok(if u.arbitrary()? { reach * share } else { reach * share.powi(7) })
}

/// A wheel somewhere at, above, beside, below or inside the rail, moving anyhow.
pub fn input(u: &mut Unstructured) -> Result<Input> {
    let mut input = Input::default();
    let wheel = &mut input.wheel;
    wheel.position = [within(u, 10.0)?, 0.75 + within(u, 0.2)?, -0.46 + within(u, 0.05)?];
    (wheel.roll, wheel.yaw, wheel.pitch) = (within(u, 0.2)?, within(u, 0.2)?, within(u, 10.0)?);
    wheel.velocity = [within(u, 150.0)?, within(u, 5.0)?, within(u, 5.0)?];
    (wheel.roll_rate, wheel.yaw_rate, wheel.pitch_rate) =
        (within(u, 5.0)?, within(u, 5.0)?, within(u, 350.0)?);
    for rail in &mut input.rails {
        (rail.y, rail.z, rail.roll) = (within(u, 0.02)?, within(u, 0.02)?, within(u, 0.1)?);
        (rail.vy, rail.vz, rail.roll_rate) = (within(u, 1.0)?, within(u, 1.0)?, within(u, 1.0)?);
    }
    input.wheel_load = within(u, 3e5)?;
    input.track_s = within(u, 1e5)?;
    input.friction = within(u, 2.0)?.abs();
    (input.tread_friction, input.gauge_face_friction) = (input.friction, 0.5 * input.friction);
    Ok(input)
}

/// Whether models take so long that a fuzzer would get nowhere.
pub fn is_slow(parameters: &Parameters) -> bool {
    parameters.normal_model == NormalModel::BoundaryElement
        || parameters.tangential_model == TangentialModel::BoundaryElement
        || (parameters.normal_model == NormalModel::Strips && parameters.strips > 15)
        || parameters.strips * parameters.elements_along > 2500
}

/// Evaluates an element of `parameters` and asserts what holds for every admitted input.
pub fn evaluate(element: &mut Element, parameters: &Parameters, input: &Input) {
    let mut output = Output::default();
    if let Err(refusal) = element.evaluate(input, &mut output) {
        assert!(input.check().is_err(), "{refusal}");
        assert_eq!(output, Output::default(), "a refusal changes nothing");
        return;
    }
    let wrenches = [output.wheel, output.rails[0], output.rails[1]];
    for wrench in wrenches {
        let finite = wrench.force.iter().chain(&wrench.moment).all(|v| v.is_finite());
        assert!(finite, "{input:?} gives {wrenches:?}");
    }
    // NaN is not ≥ 0.
    assert!(output.wear_number >= 0.0 && output.wear_number.is_finite(), "{input:?}");
    assert!(output.frictional_power >= 0.0 && output.frictional_power.is_finite(), "{input:?}");
    for patch in &output.patches {
        let force = patch.creep_force[0].hypot(patch.creep_force[1]);
        let friction = match parameters.friction_distribution {
            FrictionDistribution::Uniform => input.friction,
            FrictionDistribution::Regions => input.tread_friction.max(input.gauge_face_friction),
            FrictionDistribution::Profile => MAX_FRICTION,
        };
        // Loads that lie within 60 degrees of their resultant are at most twice as much together.
        let is_bounded = force <= 2.0 * friction * patch.normal_force;
        let is_linear = parameters.tangential_model == TangentialModel::Linear;
        assert!(is_bounded || is_linear, "{input:?} gives {patch:?}");
        assert!(patch.normal_force >= 0.0 && patch.max_pressure >= 0.0, "{patch:?}");
    }
    for axis in 0..3 {
        let sum: f64 = wrenches.iter().map(|w| w.force[axis]).sum();
        let size: f64 = wrenches.iter().map(|w| w.force[axis].abs()).sum();
        assert!(sum.abs() <= 1e-9 * size + 1e-9, "wheel and rails: {sum} N of {size} N");
    }
}
