//! A host that calls the exported functions as an importer does and keeps what the logger gets.
#![allow(unsafe_code, dead_code)]
// The box fixes the address that the logger gets.
#![allow(clippy::unnecessary_box_returns)]

use std::ffi::{CStr, CString, c_char, c_void};
use std::ptr::null_mut;
use std::sync::Mutex;

use wheelrail::fmi::v2::types::{
    CO_SIMULATION, CallbackFunctions, CallbackLogger, Component, FALSE, FmuState, MODEL_EXCHANGE,
    Status, TRUE, Text, ValueReference,
};
use wheelrail::fmi::v2::*;
use wheelrail::variables::{Unit, WHEEL, WHEELSET, find};

/// One message as the logger got it.
#[derive(Clone, Debug)]
pub struct Message {
    pub instance_name: String,
    pub status: Status,
    pub category: String,
    pub text: String,
}

/// Answer of a call from within the logger.
type Answer = Box<dyn FnMut(&Message) + Send>;

/// The host's side of one instance; its address is the component environment.
pub struct Host {
    pub component: Component,
    /// Whose variables it names.
    pub unit: &'static Unit,
    pub messages: Mutex<Vec<Message>>,
    pub on_message: Mutex<Option<Answer>>,
}

/// The logger without variable arguments: there are none.
type PlainLogger = unsafe extern "C" fn(*mut c_void, Text, Status, Text, Text);

unsafe extern "C" fn record(
    environment: *mut c_void,
    name: Text,
    status: Status,
    category: Text,
    format: Text,
) {
    // SAFETY: FMI 2.0, 2.1.5: the environment is the one that `Host::new` handed over, and the
    // texts are null-terminated.
    let (host, name, category, format) = unsafe {
        let read = |text| CStr::from_ptr(text).to_str().unwrap().to_owned();
        (&*environment.cast::<Host>(), read(name), read(category), read(format))
    };
    // A format without arguments.
    let text = format.replace("%%", "%");
    assert_eq!(text.replace('%', "%%"), format);
    let message = Message { instance_name: name, status, category, text };
    host.messages.lock().unwrap().push(message.clone());
    if let Some(answer) = &mut *host.on_message.lock().unwrap() {
        answer(&message);
    }
}

/// The recording logger in the type of the standard.
pub fn logger() -> CallbackLogger {
    // SAFETY: on the platforms of the tests a variadic call without variable arguments is that of a
    // plain function.
    unsafe { std::mem::transmute::<PlainLogger, CallbackLogger>(record) }
}

/// What `fmi2Instantiate` gets; change what a test is about.
pub struct Arguments {
    pub name: Option<CString>,
    pub fmu_type: i32,
    pub guid: Option<CString>,
    pub location: Option<CString>,
    pub logging_on: bool,
}

impl Default for Arguments {
    fn default() -> Self {
        let resources = format!("file://{}/fmu/resources", env!("CARGO_MANIFEST_DIR"));
        Self {
            name: Some(c"front left".into()),
            fmu_type: CO_SIMULATION,
            guid: Some(CString::new(WHEEL.guid).unwrap()),
            location: Some(CString::new(resources).unwrap()),
            logging_on: false,
        }
    }
}

impl Arguments {
    /// For an instance of a unit.
    pub fn of(unit: &Unit) -> Self {
        Self { guid: Some(CString::new(unit.guid).unwrap()), ..Self::default() }
    }
}

impl Host {
    /// Saves the state of the instance into `state`.
    pub fn save(&self, state: &mut FmuState) {
        // SAFETY: FMI 2.0, 2.1.8: a pointer to one state pointer.
        let saved = unsafe { fmi2GetFMUstate(self.component, state) };
        assert_eq!(saved, Status::Ok, "{}", self.last());
    }

    /// The bytes of a `state`.
    pub fn serialize(&self, state: FmuState) -> Vec<u8> {
        let mut size = 0;
        // SAFETY: FMI 2.0, 2.1.8: a pointer to one size.
        let asked = unsafe { fmi2SerializedFMUstateSize(self.component, state, &raw mut size) };
        assert_eq!(asked, Status::Ok, "{}", self.last());
        let mut bytes = vec![0u8; size];
        let start = bytes.as_mut_ptr().cast::<c_char>();
        // SAFETY: FMI 2.0, 2.1.8: an array of `size` bytes.
        let written = unsafe { fmi2SerializeFMUstate(self.component, state, start, size) };
        assert_eq!(written, Status::Ok, "{}", self.last());
        bytes
    }

    /// A host with an instance, or with null if it was refused.
    pub fn instantiate(arguments: &Arguments) -> Box<Self> {
        let is_wheelset =
            arguments.guid.as_ref().is_some_and(|guid| guid.to_str() == Ok(WHEELSET.guid));
        let mut host = Box::new(Self {
            component: null_mut(),
            unit: if is_wheelset { &WHEELSET } else { &WHEEL },
            messages: Mutex::default(),
            on_message: Mutex::default(),
        });
        let functions = CallbackFunctions {
            logger: Some(logger()),
            allocate_memory: None,
            free_memory: None,
            step_finished: None,
            component_environment: (&raw const *host).cast_mut().cast(),
        };
        let start = |text: &Option<CString>| text.as_ref().map_or(std::ptr::null(), |t| t.as_ptr());
        // SAFETY: FMI 2.0, 2.1.5: texts are null-terminated or null, the struct is filled in.
        host.component = unsafe {
            fmi2Instantiate(
                start(&arguments.name),
                arguments.fmu_type,
                start(&arguments.guid),
                start(&arguments.location),
                &raw const functions,
                FALSE,
                if arguments.logging_on { TRUE } else { FALSE },
            )
        };
        host
    }

    /// A host with an instance before initialization.
    pub fn new() -> Box<Self> {
        let host = Self::instantiate(&Arguments::default());
        assert!(!host.component.is_null(), "{:?}", host.messages.lock().unwrap());
        host
    }

    /// A host with an instance in initialization mode.
    pub fn initializing() -> Box<Self> {
        Self::initializing_with(&Arguments::default())
    }

    /// The same for other arguments.
    pub fn initializing_with(arguments: &Arguments) -> Box<Self> {
        let host = Self::instantiate(arguments);
        assert!(!host.component.is_null(), "{:?}", host.messages.lock().unwrap());
        assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.0, FALSE, 0.0), Status::Ok);
        assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
        host
    }

    /// A host with an instance that is ready to step.
    pub fn stepping() -> Box<Self> {
        let host = Self::initializing();
        assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
        host
    }

    /// The same for a unit.
    pub fn stepping_of(unit: &Unit) -> Box<Self> {
        let host = Self::initializing_with(&Arguments::of(unit));
        assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
        host
    }

    /// The value reference of a variable of its unit.
    pub fn reference(&self, name: &str) -> ValueReference {
        ValueReference::try_from(self.unit.find(name).unwrap().reference).unwrap()
    }

    /// A host with an instance for model exchange, initialized.
    pub fn in_event_mode() -> Box<Self> {
        let arguments = Arguments { fmu_type: MODEL_EXCHANGE, ..Arguments::default() };
        let host = Self::instantiate(&arguments);
        assert_eq!(fmi2SetupExperiment(host.component, FALSE, 0.0, 0.5, FALSE, 0.0), Status::Ok);
        assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
        assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
        host
    }

    /// Text of the last message; empty if there is none.
    pub fn last(&self) -> String {
        self.messages.lock().unwrap().last().map_or(String::new(), |m| m.text.clone())
    }

    pub fn set_reals(&self, values: &[(&str, f64)]) -> Status {
        let references: Vec<ValueReference> =
            values.iter().map(|(n, _)| self.reference(n)).collect();
        let values: Vec<f64> = values.iter().map(|(_, v)| *v).collect();
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold as many elements as the count says.
        unsafe {
            fmi2SetReal(self.component, references.as_ptr(), references.len(), values.as_ptr())
        }
    }

    pub fn get_reals(&self, names: &[&str]) -> Result<Vec<f64>, Status> {
        let references: Vec<ValueReference> = names.iter().map(|n| self.reference(n)).collect();
        let mut values = vec![0.0; names.len()];
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold as many elements as the count says.
        let status = unsafe {
            fmi2GetReal(self.component, references.as_ptr(), references.len(), values.as_mut_ptr())
        };
        if status <= Status::Warning { Ok(values) } else { Err(status) }
    }

    pub fn get_real(&self, name: &str) -> f64 {
        self.get_reals(&[name]).unwrap_or_else(|_| panic!("{}", self.last()))[0]
    }

    pub fn set_integer(&self, name: &str, value: i32) -> Status {
        // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
        unsafe { fmi2SetInteger(self.component, &self.reference(name), 1, &raw const value) }
    }

    pub fn set_boolean(&self, name: &str, value: bool) -> Status {
        let value = if value { TRUE } else { FALSE };
        // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
        unsafe { fmi2SetBoolean(self.component, &self.reference(name), 1, &raw const value) }
    }

    pub fn get_integer(&self, name: &str) -> i32 {
        let mut value = 0;
        // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
        let status =
            unsafe { fmi2GetInteger(self.component, &self.reference(name), 1, &raw mut value) };
        assert!(status <= Status::Warning, "{}", self.last());
        value
    }

    pub fn set_text(&self, name: &str, value: &str) -> Status {
        let value = CString::new(value).unwrap();
        let start = value.as_ptr();
        // SAFETY: FMI 2.0, 2.1.2 and 2.1.7: arrays of one element, a null-terminated text.
        unsafe { fmi2SetString(self.component, &self.reference(name), 1, &raw const start) }
    }

    /// Sets time derivatives of inputs: name, order, value.
    pub fn set_input_derivatives(&self, values: &[(&str, i32, f64)]) -> Status {
        let references: Vec<ValueReference> =
            values.iter().map(|(name, ..)| self.reference(name)).collect();
        let (orders, values): (Vec<i32>, Vec<f64>) = values.iter().map(|&(_, o, v)| (o, v)).unzip();
        let (count, r, o) = (references.len(), references.as_ptr(), orders.as_ptr());
        // SAFETY: FMI 2.0, 4.2.1: all arrays hold as many elements as the count says.
        unsafe { fmi2SetRealInputDerivatives(self.component, r, count, o, values.as_ptr()) }
    }

    pub fn step(&self, time: f64, step: f64) -> Status {
        fmi2DoStep(self.component, time, step, TRUE)
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        fmi2FreeInstance(self.component);
    }
}

/// The value reference of a variable of a wheel.
pub fn reference(name: &str) -> ValueReference {
    ValueReference::try_from(find(name).unwrap().reference).unwrap()
}
