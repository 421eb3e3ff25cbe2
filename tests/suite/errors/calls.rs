//! Calls of the interface, out of order or with what is no argument.

use super::*;
use crate::host::reference;
use wheelrail::fmi::v2::types::TRUE;

/// The message of an instance that is not made.
fn not_made(change: impl FnOnce(&mut Arguments)) -> String {
    let mut arguments = Arguments::default();
    change(&mut arguments);
    let host = Host::instantiate(&arguments);
    assert!(host.component.is_null());
    host.last()
}

/// The message of a call on a stepping instance, which goes on as before.
fn stepping(call: impl FnOnce(&Host) -> Status) -> String {
    refused_on(&Host::stepping(), call)
}

fn refused_on(host: &Host, call: impl FnOnce(&Host) -> Status) -> String {
    let message = refusal(host, call);
    if host.step(0.0, 1e-3) != Status::Ok {
        assert_usable(host, &message);
    }
    message
}

fn derivatives(host: &Host, name: &str, value: f64) -> Status {
    // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
    unsafe {
        fmi2SetRealInputDerivatives(host.component, &reference(name), 1, &1, &raw const value)
    }
}

/// Derivative of the variable `unknown` by the variable `known` along `seed`.
fn directional(host: &Host, unknown: &str, known: &str, seed: f64) -> Status {
    let mut found = 0.0;
    // SAFETY: FMI 2.0, 2.1.9: arrays of one element.
    unsafe {
        fmi2GetDirectionalDerivative(
            host.component,
            &reference(unknown),
            1,
            &reference(known),
            1,
            &raw const seed,
            &raw mut found,
        )
    }
}

fn called(words: &str) -> String {
    match words {
        "`fmi2Instantiate` without a name" => not_made(|a| a.name = None),
        "`fmi2Instantiate` with another GUID" => not_made(|a| a.guid = Some(c"{1-2-3}".into())),
        "`fmi2Instantiate` with type 2" => not_made(|a| a.fmu_type = 2),
        "`fmi2DoStep` before initialization" => refused_on(&Host::new(), |h| h.step(0.0, 1e-3)),
        "`fmi2GetReal` before initialization" => {
            refused_on(&Host::new(), |h| h.get_reals(&["wheel.force.z"]).unwrap_err())
        }
        "`fmi2SetReal` of a parameter after initialization" => {
            stepping(|h| h.set_reals(&[("track.gauge", 1.5)]))
        }
        "`fmi2SetReal` with a reference that no variable has" => {
            // SAFETY: FMI 2.0, 2.1.7: arrays of one element, or null, which is refused.
            stepping(|h| unsafe { fmi2SetReal(h.component, &99_999, 1, &1.0) })
        }
        "`fmi2SetReal` of an integer" => {
            let integer = reference("normal.strips");
            // SAFETY: as above.
            stepping(|h| unsafe { fmi2SetReal(h.component, &raw const integer, 1, &1.0) })
        }
        "`fmi2SetReal` without values" => {
            let real = reference("wheel.y");
            // SAFETY: as above.
            stepping(|h| unsafe { fmi2SetReal(h.component, &raw const real, 1, std::ptr::null()) })
        }
        "`fmi2SetRealInputDerivatives` that are no number" => {
            stepping(|h| derivatives(h, "wheel.y", f64::NAN))
        }
        "`fmi2SetRealInputDerivatives` of an output" => {
            stepping(|h| derivatives(h, "wheel.force.z", 1.0))
        }
        "`fmi2GetDirectionalDerivative` of an input" => {
            stepping(|h| directional(h, "wheel.y", "wheel.z", 1.0))
        }
        "`fmi2GetDirectionalDerivative` by a parameter, after initialization" => {
            stepping(|h| directional(h, "wheel.force.z", "track.gauge", 1.0))
        }
        "`fmi2GetDirectionalDerivative` along what is no number" => {
            stepping(|h| directional(h, "wheel.force.z", "wheel.z", f64::NAN))
        }
        "`fmi2GetRealOutputDerivatives`" => stepping(|h| {
            let (output, order, mut value) = (reference("wheel.force.z"), 1, 0.0);
            let order = &raw const order;
            fmi2GetRealOutputDerivatives(h.component, &raw const output, 1, order, &raw mut value)
        }),
        "`fmi2SetString` to what is not UTF-8" => refused_on(&Host::initializing(), |h| {
            let (text, variable) = (c"\xff".as_ptr(), reference("wheel.profile"));
            // SAFETY: FMI 2.0, 2.1.2 and 2.1.7: arrays of one element, a null-terminated text.
            unsafe { fmi2SetString(h.component, &raw const variable, 1, &raw const text) }
        }),
        "`fmi2DoStep` over a negative step" => stepping(|h| h.step(0.0, -1e-3)),
        "`fmi2DoStep` from a time that is no number" => stepping(|h| h.step(f64::NAN, 1e-3)),
        "`fmi2DoStep` beyond the stop time" => {
            let host = Host::new();
            let component = host.component;
            assert_eq!(fmi2SetupExperiment(component, FALSE, 0.0, 0.0, TRUE, 1.0), Status::Ok);
            assert_eq!(fmi2EnterInitializationMode(component), Status::Ok);
            assert_eq!(fmi2ExitInitializationMode(component), Status::Ok);
            refused_on(&host, |h| h.step(2.0, 1e-3))
        }
        "`fmi2SetupExperiment` that stops before it starts" => refused_on(&Host::new(), |h| {
            fmi2SetupExperiment(h.component, FALSE, 0.0, 1.0, TRUE, 0.5)
        }),
        "`fmi2SetupExperiment` with a tolerance that is no number" => {
            refused_on(&Host::new(), |h| {
                fmi2SetupExperiment(h.component, TRUE, f64::NAN, 0.0, FALSE, 0.0)
            })
        }
        "`fmi2EnterEventMode` for co-simulation" => stepping(|h| fmi2EnterEventMode(h.component)),
        "`fmi2DoStep` for model exchange" => {
            refused_on(&Host::in_event_mode(), |h| h.step(0.0, 1e-3))
        }
        "`fmi2SetFMUstate` to a state that is none" => {
            stepping(|h| fmi2SetFMUstate(h.component, null_mut()))
        }
        "`fmi2DeSerializeFMUstate` of other bytes" => stepping(|h| {
            let (bytes, mut state) = ([7; 64], null_mut());
            // SAFETY: FMI 2.0, 2.1.8: as many bytes as the count says, one state.
            unsafe { fmi2DeSerializeFMUstate(h.component, bytes.as_ptr(), 64, &raw mut state) }
        }),
        "`fmi2SetDebugLogging` of a category that is none" => stepping(|h| {
            let name = c"logEverything".as_ptr();
            // SAFETY: FMI 2.0, 2.1.5: an array of one null-terminated text.
            unsafe { fmi2SetDebugLogging(h.component, TRUE, 1, &raw const name) }
        }),
        _ => panic!("{words}: unknown"),
    }
}

#[test]
fn calls_of_the_interface() {
    let said = rows("Calls of the interface").into_iter().map(|row| {
        let message = called(&row[0]);
        (row, as_cell(&message, Path::new("/nowhere")))
    });
    compare("Calls of the interface", &said.collect::<Vec<_>>());
}
