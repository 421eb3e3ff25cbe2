//! Functions of FMI 3.0 for what the unit does not have: variables of other types, clocks,
//! structural parameters, dependencies of single elements, partitions. Each says so to the logger.

use super::calls;
use super::types::{Binary, Boolean, Component, Status, ValueReference};
use crate::fmi::any_instance::on_instance;
use crate::fmi::arguments::array;
use crate::fmi::error::FmiError;
use crate::fmi::guard::{Call, guard};

/// Reading or setting variables of a type that none has: only no variables at all are accepted.
///
/// # Safety
/// FMI 3.0, 2.2.6: `references` holds `count` elements.
unsafe fn no_variables(
    call: Call,
    component: Component,
    references: *const ValueReference,
    count: usize,
    value_count: usize,
) -> Status {
    guard(component, call, |instance, _| {
        // SAFETY: the caller's promise.
        let references = unsafe { array("valueReferences", references, count)? };
        on_instance!(instance, |i| i.accept_none(references, ("nValues", value_count)))
    })
}

fn none(call: Call, component: Component, what: &'static str) -> Status {
    guard(component, call, |_, _| Err(FmiError::None(what)))
}

/// Functions that read and set variables of one type.
macro_rules! no_variables {
    ($($get:ident $get_call:ident $set:ident $set_call:ident $type:ty;)*) => {
        $(
            #[doc = concat!("`", stringify!($get), "`: no variable is of this type.")]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $get(
                component: Component,
                references: *const ValueReference,
                count: usize,
                _values: *mut $type,
                value_count: usize,
            ) -> Status {
                // SAFETY: FMI 3.0, 2.2.6: the array holds `nValueReferences` elements.
                unsafe { no_variables(calls::$get_call, component, references, count, value_count) }
            }

            #[doc = concat!("`", stringify!($set), "`: no variable is of this type.")]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $set(
                component: Component,
                references: *const ValueReference,
                count: usize,
                _values: *const $type,
                value_count: usize,
            ) -> Status {
                // SAFETY: FMI 3.0, 2.2.6: the array holds `nValueReferences` elements.
                unsafe { no_variables(calls::$set_call, component, references, count, value_count) }
            }
        )*
    };
}

no_variables! {
    fmi3GetFloat32 GET_FLOAT32 fmi3SetFloat32 SET_FLOAT32 f32;
    fmi3GetInt8 GET_INT8 fmi3SetInt8 SET_INT8 i8;
    fmi3GetUInt8 GET_UINT8 fmi3SetUInt8 SET_UINT8 u8;
    fmi3GetInt16 GET_INT16 fmi3SetInt16 SET_INT16 i16;
    fmi3GetUInt16 GET_UINT16 fmi3SetUInt16 SET_UINT16 u16;
    fmi3GetUInt32 GET_UINT32 fmi3SetUInt32 SET_UINT32 u32;
    fmi3GetUInt64 GET_UINT64 fmi3SetUInt64 SET_UINT64 u64;
}

/// `fmi3GetBinary`: no variable is of this type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetBinary(
    component: Component,
    references: *const ValueReference,
    count: usize,
    _sizes: *mut usize,
    _values: *mut Binary,
    value_count: usize,
) -> Status {
    // SAFETY: FMI 3.0, 2.2.6: the array holds `nValueReferences` elements.
    unsafe { no_variables(calls::GET_BINARY, component, references, count, value_count) }
}

/// `fmi3SetBinary`: no variable is of this type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetBinary(
    component: Component,
    references: *const ValueReference,
    count: usize,
    _sizes: *const usize,
    _values: *const Binary,
    value_count: usize,
) -> Status {
    // SAFETY: FMI 3.0, 2.2.6: the array holds `nValueReferences` elements.
    unsafe { no_variables(calls::SET_BINARY, component, references, count, value_count) }
}

/// `fmi3GetClock`: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetClock(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _values: *mut Boolean,
) -> Status {
    none(calls::GET_CLOCK, component, "clocks")
}

/// `fmi3SetClock`: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetClock(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _values: *const Boolean,
) -> Status {
    none(calls::SET_CLOCK, component, "clocks")
}

/// `fmi3GetIntervalDecimal`: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetIntervalDecimal(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _intervals: *mut f64,
    _qualifiers: *mut i32,
) -> Status {
    none(calls::GET_INTERVAL_DECIMAL, component, "clocks")
}

/// `fmi3GetIntervalFraction`: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetIntervalFraction(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _counters: *mut u64,
    _resolutions: *mut u64,
    _qualifiers: *mut i32,
) -> Status {
    none(calls::GET_INTERVAL_FRACTION, component, "clocks")
}

/// `fmi3GetShiftDecimal`: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetShiftDecimal(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _shifts: *mut f64,
) -> Status {
    none(calls::GET_SHIFT_DECIMAL, component, "clocks")
}

/// `fmi3GetShiftFraction`: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetShiftFraction(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _counters: *mut u64,
    _resolutions: *mut u64,
) -> Status {
    none(calls::GET_SHIFT_FRACTION, component, "clocks")
}

/// `fmi3SetIntervalDecimal`: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetIntervalDecimal(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _intervals: *const f64,
) -> Status {
    none(calls::SET_INTERVAL_DECIMAL, component, "clocks")
}

/// `fmi3SetIntervalFraction`: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetIntervalFraction(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _counters: *const u64,
    _resolutions: *const u64,
) -> Status {
    none(calls::SET_INTERVAL_FRACTION, component, "clocks")
}

/// `fmi3SetShiftDecimal`: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetShiftDecimal(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _shifts: *const f64,
) -> Status {
    none(calls::SET_SHIFT_DECIMAL, component, "clocks")
}

/// `fmi3SetShiftFraction`: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetShiftFraction(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _counters: *const u64,
    _resolutions: *const u64,
) -> Status {
    none(calls::SET_SHIFT_FRACTION, component, "clocks")
}

/// `fmi3EnterConfigurationMode`: there are no structural parameters.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3EnterConfigurationMode(component: Component) -> Status {
    none(calls::ENTER_CONFIGURATION_MODE, component, "structural parameters")
}

/// `fmi3ExitConfigurationMode`: there are no structural parameters.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3ExitConfigurationMode(component: Component) -> Status {
    none(calls::EXIT_CONFIGURATION_MODE, component, "structural parameters")
}

/// `fmi3ActivateModelPartition`: there is no scheduled execution.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3ActivateModelPartition(
    component: Component,
    _clock: ValueReference,
    _activation_time: f64,
) -> Status {
    none(calls::ACTIVATE_MODEL_PARTITION, component, "scheduled execution")
}

/// `fmi3GetNumberOfVariableDependencies`: not supported.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetNumberOfVariableDependencies(
    component: Component,
    _reference: ValueReference,
    _count: *mut usize,
) -> Status {
    guard(component, calls::GET_NUMBER_OF_DEPENDENCIES, |_, _| {
        Err(FmiError::NotSupported("providesPerElementDependencies"))
    })
}

/// `fmi3GetVariableDependencies`: not supported.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVariableDependencies(
    component: Component,
    _dependent: ValueReference,
    _elements_of_dependent: *mut usize,
    _independents: *mut ValueReference,
    _elements_of_independents: *mut usize,
    _kinds: *mut i32,
    _count: usize,
) -> Status {
    guard(component, calls::GET_DEPENDENCIES, |_, _| {
        Err(FmiError::NotSupported("providesPerElementDependencies"))
    })
}
