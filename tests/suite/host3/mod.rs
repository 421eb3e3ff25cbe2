//! A host that calls the functions of FMI 3.0 as an importer does and keeps what the logger gets.
#![allow(unsafe_code)]
// The box fixes the address that the logger gets.
#![allow(clippy::unnecessary_box_returns)]

use std::ffi::{CStr, CString, c_void};
use std::ptr::{null, null_mut};
use std::sync::Mutex;

use wheelrail::fmi::v3::types::{
    Boolean, Component, FALSE, LogMessage, Status, TRUE, Text, ValueReference,
};
use wheelrail::fmi::v3::*;
use wheelrail::variables::{Unit, WHEEL};

/// Status, category and text of one message.
pub type Message = (Status, String, String);

/// The host's side of one instance; its address is the environment.
pub struct Host3 {
    pub component: Component,
    pub unit: &'static Unit,
    pub messages: Mutex<Vec<Message>>,
}

unsafe extern "C" fn record(
    environment: *mut c_void,
    status: Status,
    category: Text,
    message: Text,
) {
    // SAFETY: FMI 3.0, 2.3.1: the environment is the one that was handed over, and the texts are
    // null-terminated.
    let (host, category, message) = unsafe {
        let read = |text| CStr::from_ptr(text).to_str().unwrap().to_owned();
        (&*environment.cast::<Host3>(), read(category), read(message))
    };
    host.messages.lock().unwrap().push((status, category, message));
}

/// What an instance is made with; change what a test is about.
pub struct Arguments3 {
    pub exchange: bool,
    pub name: Option<CString>,
    pub token: Option<CString>,
    pub resources: Option<CString>,
    pub logging_on: Boolean,
    pub event_mode_used: Boolean,
}

impl Arguments3 {
    /// For co-simulation.
    pub fn of(unit: &Unit) -> Self {
        let resources = format!("{}/fmu/resources/", env!("CARGO_MANIFEST_DIR"));
        Self {
            exchange: false,
            name: Some(c"front left".into()),
            token: Some(CString::new(unit.guid).unwrap()),
            resources: Some(CString::new(resources).unwrap()),
            logging_on: TRUE,
            event_mode_used: FALSE,
        }
    }
}

impl Host3 {
    /// A host with an instance, or with null if it was refused.
    pub fn instantiate(unit: &'static Unit, arguments: &Arguments3) -> Box<Self> {
        let mut host = Box::new(Self { component: null_mut(), unit, messages: Mutex::default() });
        let environment = (&raw const *host).cast_mut().cast();
        let start = |text: &Option<CString>| text.as_ref().map_or(null(), |t| t.as_ptr());
        let (name, token) = (start(&arguments.name), start(&arguments.token));
        let resources = start(&arguments.resources);
        let log: Option<LogMessage> = Some(record);
        // SAFETY: FMI 3.0, 2.3.1: texts are null-terminated or null, no intermediate variables.
        host.component = unsafe {
            if arguments.exchange {
                let on = arguments.logging_on;
                fmi3InstantiateModelExchange(name, token, resources, FALSE, on, environment, log)
            } else {
                fmi3InstantiateCoSimulation(
                    name,
                    token,
                    resources,
                    FALSE,
                    arguments.logging_on,
                    arguments.event_mode_used,
                    FALSE,
                    null(),
                    0,
                    environment,
                    log,
                    None,
                )
            }
        };
        host
    }

    /// A host with an instance for co-simulation before initialization.
    pub fn new(unit: &'static Unit) -> Box<Self> {
        Self::instantiate(unit, &Arguments3::of(unit)).made()
    }

    fn made(self: Box<Self>) -> Box<Self> {
        assert!(!self.component.is_null(), "{:?}", self.messages.lock().unwrap());
        self
    }

    /// The same in initialization mode.
    pub fn initializing(unit: &'static Unit) -> Box<Self> {
        let host = Self::new(unit);
        host.initialize();
        host
    }

    /// Enters initialization mode.
    pub fn initialize(&self) {
        let entered = fmi3EnterInitializationMode(self.component, FALSE, 0.0, 0.0, FALSE, 0.0);
        assert_eq!(entered, Status::Ok, "{}", self.last());
    }

    /// The same ready to step.
    pub fn stepping(unit: &'static Unit) -> Box<Self> {
        let host = Self::initializing(unit);
        assert_eq!(fmi3ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
        host
    }

    /// A host with an initialized instance of a wheel for model exchange.
    pub fn in_event_mode() -> Box<Self> {
        let arguments = Arguments3 { exchange: true, ..Arguments3::of(&WHEEL) };
        let host = Self::instantiate(&WHEEL, &arguments).made();
        host.initialize();
        assert_eq!(fmi3ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
        host
    }

    /// Text of the last message; empty if there is none.
    pub fn last(&self) -> String {
        self.messages.lock().unwrap().last().map_or(String::new(), |m| m.2.clone())
    }

    /// The reference of a variable, an array, time or event indicator.
    pub fn reference(&self, name: &str) -> ValueReference {
        let variables = self.unit.variables;
        let place = match name {
            "time" => variables.len(),
            "event_indicator" => variables.len() + 1,
            _ => {
                let found = variables.iter().position(|v| v.array.unwrap_or(v.name) == name);
                found.unwrap_or_else(|| panic!("{name}"))
            }
        };
        ValueReference::try_from(place).unwrap()
    }

    fn references(&self, names: &[&str]) -> Vec<ValueReference> {
        names.iter().map(|name| self.reference(name)).collect()
    }

    pub fn set_reals(&self, values: &[(&str, f64)]) -> Status {
        let references: Vec<_> = values.iter().map(|(n, _)| self.reference(n)).collect();
        let values: Vec<f64> = values.iter().map(|(_, v)| *v).collect();
        let (count, c) = (references.len(), self.component);
        // SAFETY: FMI 3.0, 2.2.6: both arrays hold as many elements as the counts say.
        unsafe { fmi3SetFloat64(c, references.as_ptr(), count, values.as_ptr(), values.len()) }
    }

    /// Values of `count` elements in all.
    pub fn get_reals(&self, names: &[&str], count: usize) -> Result<Vec<f64>, Status> {
        let (references, mut values) = (self.references(names), vec![f64::NAN; count]);
        // SAFETY: FMI 3.0, 2.2.6: both arrays hold as many elements as the counts say.
        let status = unsafe {
            let (start, out) = (references.as_ptr(), values.as_mut_ptr());
            fmi3GetFloat64(self.component, start, references.len(), out, count)
        };
        if status <= Status::Warning { Ok(values) } else { Err(status) }
    }

    pub fn get_real(&self, name: &str) -> f64 {
        self.get_reals(&[name], 1).unwrap_or_else(|_| panic!("{}", self.last()))[0]
    }

    /// Whether a variable has that very value.
    pub fn reads(&self, name: &str, value: f64) -> bool {
        self.get_real(name).to_bits() == value.to_bits()
    }

    pub fn get_integers(&self, names: &[&str], count: usize) -> Result<Vec<i32>, Status> {
        let (references, mut values) = (self.references(names), vec![-7; count]);
        // SAFETY: FMI 3.0, 2.2.6: both arrays hold as many elements as the counts say.
        let status = unsafe {
            let (start, out) = (references.as_ptr(), values.as_mut_ptr());
            fmi3GetInt32(self.component, start, references.len(), out, count)
        };
        if status <= Status::Warning { Ok(values) } else { Err(status) }
    }

    pub fn set_integer(&self, name: &str, value: i32) -> Status {
        // SAFETY: FMI 3.0, 2.2.6: arrays of one element.
        unsafe { fmi3SetInt32(self.component, &self.reference(name), 1, &raw const value, 1) }
    }

    pub fn set_choice(&self, name: &str, value: i64) -> Status {
        // SAFETY: FMI 3.0, 2.2.6: arrays of one element.
        unsafe { fmi3SetInt64(self.component, &self.reference(name), 1, &raw const value, 1) }
    }

    pub fn get_choice(&self, name: &str) -> Result<i64, Status> {
        let mut value = -7;
        // SAFETY: FMI 3.0, 2.2.6: arrays of one element.
        let status =
            unsafe { fmi3GetInt64(self.component, &self.reference(name), 1, &raw mut value, 1) };
        if status == Status::Ok { Ok(value) } else { Err(status) }
    }

    pub fn set_text(&self, name: &str, value: &str) -> Status {
        let value = CString::new(value).unwrap();
        let start = value.as_ptr();
        // SAFETY: FMI 3.0, 2.2.3 and 2.2.6: arrays of one element, a null-terminated text.
        unsafe { fmi3SetString(self.component, &self.reference(name), 1, &raw const start, 1) }
    }

    pub fn get_text(&self, name: &str) -> String {
        let mut value = null();
        // SAFETY: FMI 3.0, 2.2.6: arrays of one element; the text is good until the next call.
        unsafe {
            let reference = self.reference(name);
            let status = fmi3GetString(self.component, &raw const reference, 1, &raw mut value, 1);
            assert_eq!(status, Status::Ok, "{}", self.last());
            CStr::from_ptr(value).to_str().unwrap().into()
        }
    }

    /// Makes a step; the status, and what the call says of it: flags that are never set, and the
    /// time reached.
    pub fn step_to(&self, time: f64, step: f64) -> (Status, [Boolean; 3], f64) {
        let ([mut event, mut end, mut early], mut reached) = ([7, 7, 7], f64::NAN);
        // SAFETY: FMI 3.0, 4.2.1: pointers to one value each.
        let status = unsafe {
            fmi3DoStep(
                self.component,
                time,
                step,
                TRUE,
                &raw mut event,
                &raw mut end,
                &raw mut early,
                &raw mut reached,
            )
        };
        (status, [event, end, early], reached)
    }

    pub fn step(&self, time: f64, step: f64) -> Status {
        self.step_to(time, step).0
    }
}

impl Drop for Host3 {
    fn drop(&mut self) {
        fmi3FreeInstance(self.component);
    }
}
