//! Any admitted parameters and any inputs.

use arbitrary::{Result, Unstructured};
use wheelrail::element::{Element, Parameters};
use wheelrail::variables::{Causality, Kind, VARIABLES, Value, Values};

use super::values::{any, evaluate, input, is_slow, within};

/// The bytes are changes of parameters, then inputs.
pub fn check(data: &[u8]) {
    let mut u = Unstructured::new(data);
    // Bytes that have run out end the run.
    let _ = run(&mut u);
}

fn run(u: &mut Unstructured) -> Result<()> {
    let parameters = parameters(u)?;
    if is_slow(&parameters) {
        return Ok(());
    }
    let start = input(u)?;
    let Ok(mut element) = Element::new(&parameters, &start, &[]) else { return Ok(()) };
    assert!(element.nominal_wheel_z().is_finite());
    for _ in 0..8 {
        let mut at = input(u)?;
        if u.ratio(1, 2)? {
            at.wheel.position[2] = element.touching_height(&at) + within(u, 5e-4)?;
        }
        if u.ratio(1, 8)? {
            at.wheel.position[u.choose_index(3)?] = any(u)?;
        }
        evaluate(&mut element, &parameters, &at);
    }
    Ok(())
}

/// The defaults with some parameters changed, as the FMU would admit them.
fn parameters(u: &mut Unstructured) -> Result<Parameters> {
    let mut values = Values::default();
    for _ in 0..u.int_in_range(0..=8u8)? {
        let variable = u.choose(VARIABLES)?;
        if variable.causality != Causality::Parameter {
            continue;
        }
        let value = match variable.kind {
            Kind::Real => {
                let Some(Value::Real(start)) = variable.start else { continue };
                Value::Real(if u.arbitrary()? {
                    start * 2f64.powf(within(u, 3.0)?)
                } else {
                    any(u)?
                })
            }
            Kind::Integer | Kind::Enumeration(_) => Value::Integer(u.int_in_range(0..=40)?),
            Kind::Boolean => Value::Boolean(u.arbitrary()?),
            Kind::Text => Value::Text(u.choose(&PROFILES)?),
        };
        // What is not admitted is left out.
        let _ = values.set(variable, value);
    }
    Ok(values.parameters)
}

/// Texts for all text parameters; most do not fit most of them.
const PROFILES: [&str; 12] = [
    "S1002",
    "60E1",
    "60E2",
    "54E1",
    "conical:0.05",
    "cylindrical",
    "arc:0.5",
    "arc:0.3",
    "flat",
    "convex:0.3",
    "",
    "no such file",
];
