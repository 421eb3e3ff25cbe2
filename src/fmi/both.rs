//! Functions that both interfaces have with the same arguments.
#![allow(unsafe_code)]
// The names are the standard's, and so is the contract of their pointers.
#![allow(non_snake_case, clippy::missing_safety_doc)]

use std::ptr::null_mut;

use super::arguments::{One, Pointed, texts};
use super::bytes;
use super::error::FmiError;
use super::exported::functions;
use super::guard::{ALIVE, CONTINUOUS, EVENT, INITIALIZATION, RUNNING};
use super::logger::Category;
use super::types::Status;

/// An entry as those of [`functions`], with the names of the function in FMI 2.0 and in FMI 3.0.
macro_rules! both {
    ($(
        $(#[$attribute:meta])*
        $safety:ident fn $v2:ident $v3:ident($($arguments:tt)*)
            in $states:expr => |$instance:tt, $logger:tt| $body:expr;
    )*) => {
        /// Those of FMI 2.0.
        pub mod v2 {
            use super::*;
            use crate::fmi::v2::types::*;

            functions! { V2; $(
                $(#[$attribute])*
                $safety fn $v2($($arguments)*) in $states => |$instance, $logger| $body;
            )* }
        }

        /// Those of FMI 3.0.
        pub mod v3 {
            use super::*;
            use crate::fmi::v3::types::*;

            functions! { V3; $(
                $(#[$attribute])*
                $safety fn $v3($($arguments)*) in $states => |$instance, $logger| $body;
            )* }
        }
    };
}

both! {
    unsafe fn fmi2SetDebugLogging fmi3SetDebugLogging(
        loggingOn: Boolean, nCategories: usize, categories[nCategories]: *const Text,
    ) in ALIVE => |_, logger| {
        // SAFETY: FMI 2.0, 2.1.5, and FMI 3.0, 2.3.1: the categories are texts.
        let names = unsafe { texts("categories", categories)? };
        logger.set_categories(loggingOn != FALSE, &names)
    };

    /// Loads the profiles; if one of them cannot be had, the mode is not left.
    safe fn fmi2ExitInitializationMode fmi3ExitInitializationMode()
    in INITIALIZATION => |i, logger| {
        let status = i.exit_initialization(logger)?;
        logger.log(Status::Ok, Category::Events, format_args!("initialized"));
        Ok(status)
    };

    /// Writes worn profiles, where that is asked for; if one cannot be written, the run is not
    /// ended.
    safe fn fmi2Terminate fmi3Terminate() in RUNNING => |i, logger| {
        i.terminate()?;
        logger.log(Status::Ok, Category::Events, format_args!("terminated"));
        Ok(())
    };

    /// As after instantiation; log categories stay.
    safe fn fmi2Reset fmi3Reset() in ALIVE => |i, logger| {
        i.reset();
        logger.log(Status::Ok, Category::Events, format_args!("reset"));
        Ok(())
    };

    /// A new state where null is handed over; another one of this instance is written over.
    unsafe fn fmi2GetFMUstate fmi3GetFMUState(FMUstate[One]: *mut FmuState) in ALIVE => |i, _| {
        i.save(FMUstate.get()).map(|key| FMUstate.set(key))
    };

    safe fn fmi2SetFMUstate fmi3SetFMUState(FMUstate: FmuState) in ALIVE => |i, _| i.load(FMUstate);

    /// The host's pointer is null afterwards; null does nothing.
    unsafe fn fmi2FreeFMUstate fmi3FreeFMUState(
        FMUstate[usize::from(!FMUstate.is_null())]: *mut FmuState,
    ) in ALIVE => |i, _| {
        if let Some(held) = FMUstate.first_mut().filter(|held| !held.is_null()) {
            i.snapshots.remove(*held).ok_or(FmiError::UnknownState("FMUstate"))?;
            *held = null_mut();
        }
        Ok(())
    };

    unsafe fn fmi2SerializedFMUstateSize fmi3SerializedFMUStateSize(
        FMUstate: FmuState, size[One]: *mut usize,
    ) in ALIVE => |i, _| {
        size.set(bytes::write(i.saved(FMUstate)?).len());
        Ok(())
    };

    /// Into at least as many bytes as the function before asks for.
    unsafe fn fmi2SerializeFMUstate fmi3SerializeFMUState(
        FMUstate: FmuState, serializedState: *mut Byte, size: usize,
    ) in ALIVE => |i, _| {
        let bytes = bytes::write(i.saved(FMUstate)?);
        // SAFETY: FMI 2.0, 2.1.8, and FMI 3.0, 2.2.10: there are `size` bytes.
        let target = unsafe { serializedState.cast::<u8>().lend("serializedState", size)? };
        bytes::room(i.interface, target, bytes.len())?.copy_from_slice(&bytes);
        Ok(())
    };

    /// A state of any instance of this unit, in this process or another, and of the unit of the
    /// other version of FMI with the same variables.
    unsafe fn fmi2DeSerializeFMUstate fmi3DeserializeFMUState(
        serializedState: *const Byte, size: usize, FMUstate[One]: *mut FmuState,
    ) in ALIVE => |i, _| {
        // SAFETY: FMI 2.0, 2.1.8, and FMI 3.0, 2.2.10: there are `size` bytes.
        let bytes = unsafe { serializedState.cast::<u8>().lend("serializedState", size)? };
        i.put(FMUstate.get(), bytes::read(bytes)?).map(|key| FMUstate.set(key))
    };

    safe fn fmi2EnterContinuousTimeMode fmi3EnterContinuousTimeMode()
    in EVENT => |i, logger| i.enter_continuous_time(logger);

    /// Need not be called, no event follows.
    unsafe fn fmi2CompletedIntegratorStep fmi3CompletedIntegratorStep(
        _: Boolean, enterEventMode[One]: *mut Boolean, terminateSimulation[One]: *mut Boolean,
    ) in CONTINUOUS => |_, _| {
        enterEventMode.set(FALSE);
        terminateSimulation.set(FALSE);
        Ok(())
    };

    /// Forces do not depend on it.
    safe fn fmi2SetTime fmi3SetTime(time: f64) in EVENT | CONTINUOUS => |i, _| i.set_time(time);
}
