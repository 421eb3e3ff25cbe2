//! Calls of the C interface in any order, with any values, handles and counts.
#![allow(unsafe_code)]

use std::ffi::{CString, c_char, c_int, c_void};
use std::ptr::{null, null_mut};

use arbitrary::{Result, Unstructured};
use wheelrail::fmi::v2::types::{
    CallbackFunctions, Component, EventInfo, FmuState, Status, Text, ValueReference,
};
use wheelrail::fmi::v2::*;
use wheelrail::variables::{Causality, Kind, Unit, WHEEL, WHEELSET};

use super::values::{any, within};

/// Most calls of one run.
const MAX_CALLS: usize = 200;

/// The bytes are calls on wheel units.
pub fn check(data: &[u8]) {
    run(data, &WHEEL);
}

/// The bytes are calls on wheelset units.
pub fn check_wheelset(data: &[u8]) {
    run(data, &WHEELSET);
}

fn run(data: &[u8], unit: &'static Unit) {
    let mut host = Host { unit, components: Vec::new(), states: Vec::new(), bytes: Vec::new() };
    let mut u = Unstructured::new(data);
    for _ in 0..MAX_CALLS {
        // Bytes that have run out end the run.
        if u.is_empty() || host.call(&mut u).is_err() {
            break;
        }
    }
    host.end();
}

/// Handles, states and bytes that came back.
struct Host {
    unit: &'static Unit,
    components: Vec<Component>,
    states: Vec<(Component, FmuState)>,
    bytes: Vec<c_char>,
}

impl Host {
    fn end(self) {
        for component in self.components {
            fmi2FreeInstance(component);
        }
    }

    /// One of the instances, or now and then null or a handle that is none.
    fn component(&self, u: &mut Unstructured) -> Result<Component> {
        Ok(match u.int_in_range(0..=30u8)? {
            0 => null_mut(),
            1 => u.arbitrary::<usize>()? as *mut c_void,
            _ if self.components.is_empty() => null_mut(),
            _ => *u.choose(&self.components)?,
        })
    }

    fn state(&self, u: &mut Unstructured) -> Result<FmuState> {
        Ok(match u.int_in_range(0..=9u8)? {
            0 => null_mut(),
            1 => u.arbitrary::<usize>()? as *mut c_void,
            _ if self.states.is_empty() => null_mut(),
            _ => u.choose(&self.states)?.1,
        })
    }

    fn instantiate(&mut self, u: &mut Unstructured) -> Result<()> {
        if self.components.len() >= 3 {
            return Ok(());
        }
        let functions = CallbackFunctions {
            logger: None,
            allocate_memory: None,
            free_memory: None,
            step_finished: None,
            component_environment: null_mut(),
        };
        let guid = if u.ratio(1, 12)? { "{another}" } else { self.unit.guid };
        let guid = CString::new(guid).expect("no null");
        let name = if u.ratio(1, 12)? { c"" } else { c"wheel" };
        let location = c"file:///nowhere";
        let last = if u.ratio(1, 12)? { 5u8 } else { 1 };
        let kind = c_int::from(u.int_in_range(0..=last)?);
        let start = |text: &std::ffi::CStr, there: bool| if there { text.as_ptr() } else { null() };
        let [a, b, c, d] = [!u.ratio(1, 20)?, !u.ratio(1, 20)?, !u.ratio(1, 4)?, !u.ratio(1, 20)?];
        // SAFETY: texts are null-terminated or null, the struct is filled in or null.
        let component = unsafe {
            fmi2Instantiate(
                start(name, a),
                kind,
                start(&guid, b),
                start(location, c),
                if d { &raw const functions } else { null() },
                0,
                u.arbitrary()?,
            )
        };
        if !component.is_null() {
            self.components.push(component);
        }
        Ok(())
    }

    fn call(&mut self, u: &mut Unstructured) -> Result<()> {
        let component = self.component(u)?;
        let status = match u.int_in_range(0..=32u8)? {
            0 | 1 => {
                self.instantiate(u)?;
                return Ok(());
            }
            2 => {
                if u.ratio(1, 4)? {
                    fmi2FreeInstance(component);
                }
                return Ok(());
            }
            3 => fmi2SetupExperiment(component, 0, 0.0, any(u)?, u.arbitrary()?, any(u)?),
            4 | 5 => fmi2EnterInitializationMode(component),
            6 | 7 => fmi2ExitInitializationMode(component),
            8 => fmi2Terminate(component),
            9 => fmi2Reset(component),
            10 | 11 => fmi2DoStep(component, any(u)?, any(u)?, 0),
            12 => fmi2EnterEventMode(component),
            13 => fmi2EnterContinuousTimeMode(component),
            14 => fmi2SetTime(component, any(u)?),
            15 => self.save(component, u)?,
            16 => fmi2SetFMUstate(component, self.state(u)?),
            17 => self.serialize(component, u)?,
            18 => self.deserialize(component, u)?,
            19 => input_derivatives(self.unit, component, u)?,
            20 => events(component, u)?,
            21 => set_integers(self.unit, component, u)?,
            22 => set_texts(self.unit, component, u)?,
            23 => get_integers(self.unit, component, u)?,
            24 => set_booleans(self.unit, component, u)?,
            32 => directional_derivatives(self.unit, component, u)?,
            25..=28 => set_reals(self.unit, component, u)?,
            _ => get_reals(self.unit, component, u)?,
        };
        assert!(matches!(status, Status::Ok | Status::Warning | Status::Discard | Status::Error));
        Ok(())
    }

    fn save(&mut self, component: Component, u: &mut Unstructured) -> Result<Status> {
        let mut state = if u.arbitrary()? { self.state(u)? } else { null_mut() };
        let place = if u.ratio(1, 20)? { null_mut() } else { &raw mut state };
        // SAFETY: one state pointer or null.
        let status = unsafe { fmi2GetFMUstate(component, place) };
        if status == Status::Ok && self.states.len() < 8 {
            self.states.push((component, state));
        } else if status == Status::Ok && u.arbitrary()? {
            // SAFETY: one state pointer.
            return Ok(unsafe { fmi2FreeFMUstate(component, &raw mut state) });
        }
        Ok(status)
    }

    fn serialize(&mut self, component: Component, u: &mut Unstructured) -> Result<Status> {
        let state = self.state(u)?;
        let mut size = 0;
        // SAFETY: one size; then as many bytes as are said to be there.
        unsafe {
            let status = fmi2SerializedFMUstateSize(component, state, &raw mut size);
            if status != Status::Ok {
                return Ok(status);
            }
            let given = if u.ratio(1, 8)? { size / 2 } else { size };
            self.bytes.resize(given, 0);
            Ok(fmi2SerializeFMUstate(component, state, self.bytes.as_mut_ptr(), given))
        }
    }

    fn deserialize(&mut self, component: Component, u: &mut Unstructured) -> Result<Status> {
        let mut bytes = self.bytes.clone();
        if !bytes.is_empty() && u.arbitrary()? {
            let place = u.choose_index(bytes.len())?;
            bytes[place] = u.arbitrary()?;
        }
        let mut state = null_mut();
        // SAFETY: as many bytes as are said to be there, one state pointer.
        let status = unsafe {
            fmi2DeSerializeFMUstate(component, bytes.as_ptr(), bytes.len(), &raw mut state)
        };
        if status == Status::Ok && self.states.len() < 8 {
            self.states.push((component, state));
        }
        Ok(status)
    }
}

/// References that are mostly good, and sometimes of another type or of none.
fn references(
    unit: &Unit,
    u: &mut Unstructured,
    wanted: fn(Kind) -> bool,
) -> Result<Vec<ValueReference>> {
    let good: Vec<usize> =
        unit.variables.iter().filter(|v| wanted(v.kind)).map(|v| v.reference).collect();
    let count = u.int_in_range(0..=6u8)?;
    (0..count)
        .map(|_| {
            Ok(if u.ratio(1, 20)? {
                u.int_in_range(0..=2 * unit.variables.len() as u32)?
            } else {
                *u.choose(&good)? as u32
            })
        })
        .collect()
}

/// A pointer, or now and then null.
fn pointer<T>(values: &[T], u: &mut Unstructured) -> Result<*const T> {
    Ok(if u.ratio(1, 30)? { null() } else { values.as_ptr() })
}

fn set_reals(unit: &Unit, component: Component, u: &mut Unstructured) -> Result<Status> {
    let references = references(unit, u, |kind| kind == Kind::Real)?;
    let values = (references.iter())
        .map(|&r| {
            let start = unit.variables.get(r as usize).and_then(|v| match v.start {
                Some(wheelrail::variables::Value::Real(start)) => Some(start),
                _ => None,
            });
            let input =
                unit.variables.get(r as usize).is_some_and(|v| v.causality == Causality::Input);
            if input && u.ratio(7, 8)? {
                Ok(start.unwrap_or(0.0) + within(u, 0.01)?)
            } else {
                any(u)
            }
        })
        .collect::<Result<Vec<f64>>>()?;
    // SAFETY: as many elements as the count says, or null.
    Ok(unsafe {
        fmi2SetReal(component, pointer(&references, u)?, references.len(), pointer(&values, u)?)
    })
}

fn get_reals(unit: &Unit, component: Component, u: &mut Unstructured) -> Result<Status> {
    let references = references(unit, u, |kind| kind == Kind::Real)?;
    let mut values = vec![f64::NAN; references.len()];
    let target = if u.ratio(1, 30)? { null_mut() } else { values.as_mut_ptr() };
    // SAFETY: as many elements as the count says, or null.
    let status =
        unsafe { fmi2GetReal(component, pointer(&references, u)?, references.len(), target) };
    if matches!(status, Status::Ok | Status::Warning) && !target.is_null() {
        assert!(values.iter().all(|v| v.is_finite()), "{references:?}: {values:?}");
    }
    Ok(status)
}

fn set_booleans(unit: &Unit, component: Component, u: &mut Unstructured) -> Result<Status> {
    let references = references(unit, u, |kind| kind == Kind::Boolean)?;
    let values = references
        .iter()
        .map(|_| Ok(c_int::from(u.arbitrary::<bool>()?)))
        .collect::<Result<Vec<_>>>()?;
    // SAFETY: as many elements as the count says, or null.
    Ok(unsafe {
        fmi2SetBoolean(component, pointer(&references, u)?, references.len(), pointer(&values, u)?)
    })
}

fn is_whole(kind: Kind) -> bool {
    matches!(kind, Kind::Integer | Kind::Enumeration(_))
}

/// Numbers that would make an evaluation take seconds.
fn is_slow(unit: &Unit, reference: ValueReference, value: i32) -> bool {
    let is = |name| unit.find(name).is_ok_and(|v| v.reference == reference as usize);
    (is("normal.model") && value >= 5) || (is("tangential.model") && value == 7)
}

fn set_integers(unit: &Unit, component: Component, u: &mut Unstructured) -> Result<Status> {
    let references = references(unit, u, is_whole)?;
    let values = (references.iter())
        .map(|&r| {
            let value = if u.ratio(1, 8)? { u.arbitrary()? } else { u.int_in_range(0..=30)? };
            Ok(if is_slow(unit, r, value) { 2 } else { value })
        })
        .collect::<Result<Vec<c_int>>>()?;
    // SAFETY: as many elements as the count says, or null.
    Ok(unsafe {
        fmi2SetInteger(component, pointer(&references, u)?, references.len(), pointer(&values, u)?)
    })
}

fn get_integers(unit: &Unit, component: Component, u: &mut Unstructured) -> Result<Status> {
    let references = references(unit, u, is_whole)?;
    let mut values = vec![0; references.len()];
    // SAFETY: as many elements as the count says, or null.
    Ok(unsafe {
        fmi2GetInteger(component, pointer(&references, u)?, references.len(), values.as_mut_ptr())
    })
}

fn set_texts(unit: &Unit, component: Component, u: &mut Unstructured) -> Result<Status> {
    const TEXTS: [&std::ffi::CStr; 6] =
        [c"S1002", c"60E1", c"54E1", c"arc:0.3", c"", c"no such profile"];
    let references = references(unit, u, |kind| kind == Kind::Text)?;
    let texts = (references.iter())
        .map(|_| Ok(if u.ratio(1, 20)? { null() } else { u.choose(&TEXTS)?.as_ptr() }))
        .collect::<Result<Vec<Text>>>()?;
    let mut read = vec![null(); references.len()];
    // SAFETY: as many elements as the count says; null-terminated texts or null.
    Ok(unsafe {
        let status = fmi2SetString(component, references.as_ptr(), texts.len(), texts.as_ptr());
        let again =
            fmi2GetString(component, references.as_ptr(), references.len(), read.as_mut_ptr());
        status.max(again)
    })
}

fn input_derivatives(unit: &Unit, component: Component, u: &mut Unstructured) -> Result<Status> {
    let references = references(unit, u, |kind| kind == Kind::Real)?;
    let orders: Vec<c_int> =
        references.iter().map(|_| u.int_in_range(0..=4)).collect::<Result<_>>()?;
    let values: Vec<f64> = references.iter().map(|_| any(u)).collect::<Result<_>>()?;
    // SAFETY: as many elements as the count says.
    Ok(unsafe {
        fmi2SetRealInputDerivatives(
            component,
            references.as_ptr(),
            references.len(),
            orders.as_ptr(),
            values.as_ptr(),
        )
    })
}

fn directional_derivatives(
    unit: &Unit,
    component: Component,
    u: &mut Unstructured,
) -> Result<Status> {
    let unknowns = references(unit, u, |kind| kind == Kind::Real)?;
    let knowns = references(unit, u, |kind| kind == Kind::Real)?;
    let is_ordinary = u.arbitrary()?;
    let one = |u: &mut Unstructured| if is_ordinary { within(u, 1.0) } else { any(u) };
    let seed: Vec<f64> = knowns.iter().map(|_| one(u)).collect::<Result<_>>()?;
    let mut found = vec![0.0; unknowns.len()];
    // SAFETY: as many elements as the counts say.
    let status = unsafe {
        fmi2GetDirectionalDerivative(
            component,
            pointer(&unknowns, u)?,
            unknowns.len(),
            pointer(&knowns, u)?,
            knowns.len(),
            seed.as_ptr(),
            found.as_mut_ptr(),
        )
    };
    if is_ordinary && matches!(status, Status::Ok | Status::Warning) {
        assert!(found.iter().all(|v| !v.is_nan()), "{unknowns:?} by {knowns:?}: {found:?}");
    }
    Ok(status)
}

fn events(component: Component, u: &mut Unstructured) -> Result<Status> {
    let mut info = EventInfo::default();
    let (mut again, mut ends) = (0, 0);
    let mut none: [f64; 0] = [];
    // SAFETY: one struct, one number each, and no elements.
    Ok(unsafe {
        match u.int_in_range(0..=4u8)? {
            0 => fmi2NewDiscreteStates(component, &raw mut info),
            1 => fmi2CompletedIntegratorStep(component, 0, &raw mut again, &raw mut ends),
            2 => fmi2GetDerivatives(component, none.as_mut_ptr(), 0),
            3 => fmi2GetEventIndicators(component, null_mut(), u.arbitrary::<u8>()?.into()),
            _ => fmi2SetContinuousStates(component, null(), 0),
        }
    })
}
