//! Making and freeing instances.

use super::types::{
    Boolean, ClockUpdate, Component, ComponentEnvironment, FALSE, IntermediateUpdate, LogMessage,
    Preemption, Text, ValueReference,
};
use crate::fmi::arguments::{name, text, text_or_empty};
use crate::fmi::callback::Callback;
use crate::fmi::error::FmiError;
use crate::fmi::guard::{self, Call, NEVER, Request};
use crate::fmi::interface::Interface;
use crate::fmi::life_cycle::Purpose;
use crate::fmi::logger::Logger;

/// `fmi3GetVersion`: of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> Text {
    c"3.0".as_ptr()
}

/// The functions that make instances. Whatever else a host announces is never made use of: the unit
/// neither returns early nor asks for intermediate updates.
macro_rules! instantiate {
    ($($name:ident($($more:tt: $type:ty),*), ($($last:ty),*) => $purpose:expr;)*) => {$(
        #[doc = concat!(
            "`", stringify!($name), "`: null, explained to the logger, if an argument is not good."
        )]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            instance_name: Text,
            token: Text,
            resource_path: Text,
            _visible: Boolean,
            logging_on: Boolean,
            $($more: $type,)*
            environment: ComponentEnvironment,
            log_message: Option<LogMessage>,
            $(_: Option<$last>,)*
        ) -> Component {
            // SAFETY: FMI 3.0, 2.2.3 and 2.3.1: all three are texts or null.
            let (instance_name, identity, location) = unsafe {
                let location = text_or_empty("resourcePath", resource_path);
                (name(instance_name), text("instantiationToken", token), location)
            };
            let callback = log_message.map(|function| Callback::v3(function, environment));
            let logger = Logger::new(callback, Interface::V3, logging_on != FALSE);
            let call = Call::new(Interface::V3, stringify!($name), NEVER);
            let purpose = $purpose;
            guard::instantiate(Request { call, instance_name, purpose, identity, location }, logger)
        }
    )*};
}

instantiate! {
    fmi3InstantiateModelExchange(), () => Ok(Purpose::ModelExchange);
    fmi3InstantiateCoSimulation(
        event_mode_used: Boolean, _: Boolean, _: *const ValueReference, _: usize
    ), (IntermediateUpdate) => match event_mode_used {
        FALSE => Ok(Purpose::CoSimulation),
        // FMI 3.0, 2.3.1: to be refused where `hasEventMode` is not set.
        _ => Err(FmiError::NotSupported("hasEventMode")),
    };
    fmi3InstantiateScheduledExecution(), (ClockUpdate, Preemption, Preemption)
        => Err(FmiError::None("scheduled execution"));
}

/// `fmi3FreeInstance`: null, freed and forged handles do nothing.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3FreeInstance(component: Component) {
    guard::free(component);
}
