//! Getting and setting variables; an array stands in `values` element by element.

use super::calls;
use super::types::{Boolean, Component, FALSE, Status, TRUE, Text, ValueReference};
use crate::fmi::any_instance::on_instance;
use crate::fmi::arguments::{array, array_mut, texts};
use crate::fmi::arrays::WholeNumber;
use crate::fmi::guard::guard;

/// `fmi3GetFloat64`, time and event indicator too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFloat64(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut f64,
    value_count: usize,
) -> Status {
    guard(component, calls::GET_FLOAT64, |instance, logger| {
        // SAFETY: FMI 3.0, 2.2.6: the arrays hold `nValueReferences` and `nValues` elements and do
        // not overlap.
        let (references, values) = unsafe {
            (
                array("valueReferences", references, count)?,
                array_mut("values", values, value_count)?,
            )
        };
        on_instance!(instance, |i| i.get_reals(references, values, logger))
    })
}

/// `fmi3SetFloat64`: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFloat64(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const f64,
    value_count: usize,
) -> Status {
    guard(component, calls::SET_FLOAT64, |instance, _| {
        // SAFETY: FMI 3.0, 2.2.6: the arrays hold `nValueReferences` and `nValues` elements.
        let (references, values) = unsafe {
            (array("valueReferences", references, count)?, array("values", values, value_count)?)
        };
        on_instance!(instance, |i| i.set_reals(references, values))
    })
}

/// `fmi3GetInt32`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetInt32(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut i32,
    value_count: usize,
) -> Status {
    guard(component, calls::GET_INT32, |instance, logger| {
        // SAFETY: FMI 3.0, 2.2.6: the arrays hold `nValueReferences` and `nValues` elements and do
        // not overlap.
        let (references, values) = unsafe {
            (
                array("valueReferences", references, count)?,
                array_mut("values", values, value_count)?,
            )
        };
        let out = |i: usize, value| values[i] = value;
        on_instance!(instance, |i| {
            i.get_whole_numbers(WholeNumber::Integer, references, value_count, out, logger)
        })
    })
}

/// `fmi3SetInt32`: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetInt32(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const i32,
    value_count: usize,
) -> Status {
    guard(component, calls::SET_INT32, |instance, _| {
        // SAFETY: FMI 3.0, 2.2.6: the arrays hold `nValueReferences` and `nValues` elements.
        let (references, values) = unsafe {
            (array("valueReferences", references, count)?, array("values", values, value_count)?)
        };
        on_instance!(instance, |i| {
            let value = |place: usize| values[place];
            i.set_whole_numbers(WholeNumber::Integer, references, value_count, value)
        })
    })
}

/// `fmi3GetInt64`: enumerations.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetInt64(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut i64,
    value_count: usize,
) -> Status {
    guard(component, calls::GET_INT64, |instance, logger| {
        // SAFETY: FMI 3.0, 2.2.6: the arrays hold `nValueReferences` and `nValues` elements and do
        // not overlap.
        let (references, values) = unsafe {
            (
                array("valueReferences", references, count)?,
                array_mut("values", values, value_count)?,
            )
        };
        let out = |i: usize, value| values[i] = i64::from(value);
        on_instance!(instance, |i| {
            i.get_whole_numbers(WholeNumber::Choice, references, value_count, out, logger)
        })
    })
}

/// `fmi3SetInt64`, enumerations: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetInt64(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const i64,
    value_count: usize,
) -> Status {
    guard(component, calls::SET_INT64, |instance, _| {
        // SAFETY: FMI 3.0, 2.2.6: the arrays hold `nValueReferences` and `nValues` elements.
        let (references, values) = unsafe {
            (array("valueReferences", references, count)?, array("values", values, value_count)?)
        };
        // No item has a number beyond those of 32 bits.
        let value = |place: usize| i32::try_from(values[place]).unwrap_or(i32::MAX);
        on_instance!(instance, |i| {
            i.set_whole_numbers(WholeNumber::Choice, references, value_count, value)
        })
    })
}

/// `fmi3GetBoolean`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetBoolean(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut Boolean,
    value_count: usize,
) -> Status {
    guard(component, calls::GET_BOOLEAN, |instance, logger| {
        // SAFETY: FMI 3.0, 2.2.6: the arrays hold `nValueReferences` and `nValues` elements and do
        // not overlap.
        let (references, values) = unsafe {
            (
                array("valueReferences", references, count)?,
                array_mut("values", values, value_count)?,
            )
        };
        let out = |i: usize, value| values[i] = if value { TRUE } else { FALSE };
        on_instance!(instance, |i| i.get_booleans(references, value_count, out, logger))
    })
}

/// `fmi3SetBoolean`: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetBoolean(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const Boolean,
    value_count: usize,
) -> Status {
    guard(component, calls::SET_BOOLEAN, |instance, _| {
        // SAFETY: FMI 3.0, 2.2.6: the arrays hold `nValueReferences` and `nValues` elements.
        let (references, values) = unsafe {
            (array("valueReferences", references, count)?, array("values", values, value_count)?)
        };
        on_instance!(instance, |i| {
            i.set_booleans(references, value_count, |place| values[place] != FALSE)
        })
    })
}

/// `fmi3GetString`: the texts are good until the next call on this instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetString(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut Text,
    value_count: usize,
) -> Status {
    guard(component, calls::GET_STRING, |instance, logger| {
        // SAFETY: FMI 3.0, 2.2.6: the arrays hold `nValueReferences` and `nValues` elements and do
        // not overlap.
        let (references, values) = unsafe {
            (
                array("valueReferences", references, count)?,
                array_mut("values", values, value_count)?,
            )
        };
        on_instance!(instance, |i| i.get_texts(references, values, logger))
    })
}

/// `fmi3SetString`: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetString(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const Text,
    value_count: usize,
) -> Status {
    guard(component, calls::SET_STRING, |instance, _| {
        // SAFETY: FMI 3.0, 2.2.6: the arrays hold `nValueReferences` and `nValues` elements.
        let (references, values) = unsafe {
            (array("valueReferences", references, count)?, texts("values", values, value_count)?)
        };
        on_instance!(instance, |i| i.set_texts(references, &values))
    })
}
