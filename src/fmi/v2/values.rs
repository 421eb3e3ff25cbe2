//! Getting and setting variables.

use std::ffi::c_char;

use super::calls;
use super::types::{Boolean, Component, FALSE, Status, TRUE, Text, ValueReference};
use crate::fmi::any_instance::on_instance;
use crate::fmi::arguments::{array, array_mut, texts};
use crate::fmi::guard::guard;
use crate::variables::Value;

/// `fmi2GetReal`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut f64,
) -> Status {
    guard(component, calls::GET_REAL, |instance, logger| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements and do not overlap.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array_mut("value", values, count)?) };
        on_instance!(instance, |i| i.get_real(references, values, logger))
    })
}

/// `fmi2SetReal`: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetReal(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const f64,
) -> Status {
    guard(component, calls::SET_REAL, |instance, _| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array("value", values, count)?) };
        on_instance!(instance, |i| i.set_real(references, values))
    })
}

/// `fmi2GetInteger`, enumerations too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetInteger(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut i32,
) -> Status {
    guard(component, calls::GET_INTEGER, |instance, logger| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements and do not overlap.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array_mut("value", values, count)?) };
        on_instance!(instance, |i| i.get_integer(references, values, logger))
    })
}

/// `fmi2SetInteger`, enumerations too: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetInteger(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const i32,
) -> Status {
    guard(component, calls::SET_INTEGER, |instance, _| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array("value", values, count)?) };
        on_instance!(instance, |i| i.set(references, |i| Value::Integer(values[i])))
    })
}

/// `fmi2GetBoolean`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBoolean(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut Boolean,
) -> Status {
    guard(component, calls::GET_BOOLEAN, |instance, logger| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements and do not overlap.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array_mut("value", values, count)?) };
        let mut out = |place: usize, value| values[place] = if value { TRUE } else { FALSE };
        on_instance!(instance, |i| i.get_boolean(references, &mut out, logger))
    })
}

/// `fmi2SetBoolean`: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetBoolean(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const Boolean,
) -> Status {
    guard(component, calls::SET_BOOLEAN, |instance, _| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array("value", values, count)?) };
        on_instance!(instance, |i| i.set(references, |i| Value::Boolean(values[i] != FALSE)))
    })
}

/// `fmi2GetString`: the texts are good until the next call on this instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetString(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut *const c_char,
) -> Status {
    guard(component, calls::GET_STRING, |instance, logger| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements and do not overlap.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array_mut("value", values, count)?) };
        on_instance!(instance, |i| i.get_text(references, values, logger))
    })
}

/// `fmi2SetString`: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetString(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const Text,
) -> Status {
    guard(component, calls::SET_STRING, |instance, _| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements.
        let (references, values) =
            unsafe { (array("vr", references, count)?, texts("value", values, count)?) };
        on_instance!(instance, |i| i.set(references, |i| Value::Text(values[i])))
    })
}
