//! One instance of a unit.
#![allow(unsafe_code)]

use std::ffi::{CStr, CString, c_char, c_int, c_void};

use anyhow::{Context, Result, anyhow, bail};
use wheelrail::fmi::v2::types::{CO_SIMULATION, CallbackFunctions, Component, FALSE, TRUE};
use wheelrail::variables::{Kind, find};

use super::archive::Fmu;
use super::functions::{GetMany, Status};
use super::logger::{self, Messages};

/// An instance of a unit; freed when dropped.
pub struct Instance<'fmu> {
    fmu: &'fmu Fmu,
    name: String,
    component: Component,
    messages: Box<Messages>,
    /// The unit keeps a pointer to it.
    _callbacks: Box<CallbackFunctions>,
}

unsafe extern "C" fn allocate(count: usize, size: usize) -> *mut c_void {
    // SAFETY: calloc admits any arguments.
    unsafe { libc::calloc(count, size) }
}

unsafe extern "C" fn release(memory: *mut c_void) {
    // SAFETY: FMI 2.0, 2.1.5: only what `allocate` gave is released.
    unsafe { libc::free(memory) };
}

impl<'fmu> Instance<'fmu> {
    /// Makes an instance called `name`.
    pub fn new(fmu: &'fmu Fmu, name: &str) -> Result<Self> {
        let messages = Box::new(Messages::default());
        let callbacks = Box::new(CallbackFunctions {
            logger: Some(logger::callback()),
            allocate_memory: Some(allocate),
            free_memory: Some(release),
            step_finished: None,
            component_environment: std::ptr::from_ref::<Messages>(&messages).cast_mut().cast(),
        });
        let c_name = text(name)?;
        let guid = text(&fmu.description.guid)?;
        let resources = text(&fmu.resource_location())?;
        // SAFETY: FMI 2.0, 2.1.5: the strings are null-terminated, and the callbacks live as long
        // as the instance.
        let component = unsafe {
            (fmu.functions.instantiate)(
                c_name.as_ptr(),
                CO_SIMULATION,
                guid.as_ptr(),
                resources.as_ptr(),
                &raw const *callbacks,
                FALSE,
                FALSE,
            )
        };
        if component.is_null() {
            bail!(
                "{}",
                explained(&format!("{name}: the unit refuses to be instantiated"), &messages)
            );
        }
        Ok(Self { fmu, name: name.into(), component, messages, _callbacks: callbacks })
    }

    /// Sets the variable called `name`, of any type, from `value` as text.
    pub fn set_text(&mut self, name: &str, value: &str) -> Result<()> {
        let variable = find(name)?;
        let reference = [variable.reference as u32];
        let what = || format!("{name} = \"{value}\"");
        let refused = |wanted: &str| anyhow!("{} is not admitted: {wanted}", what());
        let functions = &self.fmu.functions;
        let (component, reference) = (self.component, reference.as_ptr());
        // SAFETY: FMI 2.0, 2.1.7: one reference, one value.
        let set_integer = |value: c_int| unsafe {
            (functions.set_integer)(component, reference, 1, [value].as_ptr())
        };
        let status = match variable.kind {
            Kind::Real => {
                let value = [value.parse::<f64>().map_err(|_| refused("a number"))?];
                // SAFETY: FMI 2.0, 2.1.7: one reference, one value.
                unsafe { (functions.set_real)(component, reference, 1, value.as_ptr()) }
            }
            Kind::Boolean => {
                let value = value.parse::<bool>().map_err(|_| refused("true or false"))?;
                // SAFETY: FMI 2.0, 2.1.7: one reference, one value.
                unsafe {
                    (functions.set_boolean)(component, reference, 1, [c_int::from(value)].as_ptr())
                }
            }
            Kind::Integer => set_integer(value.parse().map_err(|_| refused("an integer"))?),
            Kind::Enumeration(of) => {
                let item = of.items.iter().find(|item| item.name == value);
                set_integer(item.map(|item| item.value).with_context(|| {
                    let names: Vec<&str> = of.items.iter().map(|item| item.name).collect();
                    format!("{}: \"{value}\" is not one of {}", what(), names.join(", "))
                })?)
            }
            Kind::Text => {
                let value = text(value)?;
                let values: [*const c_char; 1] = [value.as_ptr()];
                // SAFETY: FMI 2.0, 2.1.7: one reference, one string, which the unit copies.
                unsafe { (functions.set_string)(component, reference, 1, values.as_ptr()) }
            }
        };
        self.check(status, &what())
    }

    /// Sets Reals by their value references.
    ///
    /// # Panics
    /// If the numbers of references and values differ.
    pub fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Result<()> {
        assert_eq!(references.len(), values.len(), "one value for each reference");
        // SAFETY: FMI 2.0, 2.1.7: as many values as references.
        let status = unsafe {
            let set_real = self.fmu.functions.set_real;
            set_real(self.component, references.as_ptr(), references.len(), values.as_ptr())
        };
        self.check(status, "setting the inputs")
    }

    /// Gets Reals by their value references.
    ///
    /// # Panics
    /// If the numbers of references and values differ.
    pub fn get_reals(&mut self, references: &[u32], values: &mut [f64]) -> Result<()> {
        assert_eq!(references.len(), values.len(), "one value for each reference");
        // SAFETY: FMI 2.0, 2.1.7: as many values as references.
        let status = unsafe {
            let get_real = self.fmu.functions.get_real;
            get_real(self.component, references.as_ptr(), references.len(), values.as_mut_ptr())
        };
        self.check(status, "evaluating its parameters and inputs")
    }

    /// Gets one String by its value reference.
    pub fn get_string(&mut self, reference: u32) -> Result<String> {
        let text = self.get_one(self.fmu.functions.get_string, reference, std::ptr::null())?;
        if text.is_null() {
            bail!("{}: the unit has no text at value reference {reference}", self.name);
        }
        // SAFETY: FMI 2.0, 2.1.7: a text that ends with zero and stays until the next call.
        Ok(unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned())
    }

    /// Gets one Integer by its value reference.
    pub fn get_integer(&mut self, reference: u32) -> Result<i32> {
        self.get_one(self.fmu.functions.get_integer, reference, 0)
    }

    /// Gets one value, `none` before that.
    fn get_one<T: Copy>(&self, get: GetMany<T>, reference: u32, none: T) -> Result<T> {
        let mut value = [none];
        // SAFETY: FMI 2.0, 2.1.7: one reference, one value.
        let status = unsafe { get(self.component, [reference].as_ptr(), 1, value.as_mut_ptr()) };
        self.check(status, "evaluating its parameters and inputs")?;
        Ok(value[0])
    }

    /// Sets up an experiment from time 0 on and enters initialization mode.
    pub fn initialize(&mut self) -> Result<()> {
        // SAFETY: FMI 2.0, 2.1.6: plain values; no tolerance and no stop time are defined.
        let status = unsafe {
            (self.fmu.functions.setup_experiment)(self.component, FALSE, 0.0, 0.0, FALSE, 0.0)
        };
        self.check(status, "fmi2SetupExperiment")?;
        // SAFETY: FMI 2.0, 2.1.6: the instance is valid and an experiment set up.
        let status = unsafe { (self.fmu.functions.enter_initialization_mode)(self.component) };
        self.check(status, "fmi2EnterInitializationMode")
    }

    /// Leaves initialization mode; steps may follow.
    pub fn start(&mut self) -> Result<()> {
        // SAFETY: FMI 2.0, 2.1.6: the instance is valid.
        let status = unsafe { (self.fmu.functions.exit_initialization_mode)(self.component) };
        self.check(status, "fmi2ExitInitializationMode")
    }

    /// One communication step from `time` over `step` [s].
    pub fn do_step(&mut self, time: f64, step: f64) -> Result<()> {
        // SAFETY: FMI 2.0, 4.2.2: plain values; steps are not taken back.
        let status = unsafe { (self.fmu.functions.do_step)(self.component, time, step, TRUE) };
        self.check(status, &format_args!("the step at {time} s"))
    }

    /// Ends the run.
    pub fn terminate(&mut self) -> Result<()> {
        // SAFETY: FMI 2.0, 2.1.6: the instance is valid.
        let status = unsafe { (self.fmu.functions.terminate)(self.component) };
        self.check(status, "fmi2Terminate")
    }

    /// Messages of the unit that no error has shown yet.
    pub fn take_messages(&self) -> Vec<String> {
        self.messages.take()
    }

    fn check(&self, status: Status, what: &(impl std::fmt::Display + ?Sized)) -> Result<()> {
        if matches!(status, logger::OK | logger::WARNING) {
            return Ok(());
        }
        bail!("{}", explained(&format!("{}: {what} failed", self.name), &self.messages))
    }
}

/// Value references of the variables called `names`, in their order.
pub fn references(names: &[impl AsRef<str>]) -> Result<Vec<u32>> {
    names.iter().map(|name| Ok(find(name.as_ref())?.reference as u32)).collect()
}

impl Drop for Instance<'_> {
    fn drop(&mut self) {
        // SAFETY: FMI 2.0, 2.1.5: the instance came from fmi2Instantiate and is freed once.
        unsafe { (self.fmu.functions.free_instance)(self.component) };
    }
}

fn explained(summary: &str, messages: &Messages) -> String {
    let messages = messages.take();
    if messages.is_empty() { summary.into() } else { format!("{summary}: {}", messages.join("; ")) }
}

fn text(text: &str) -> Result<CString> {
    CString::new(text).with_context(|| format!("{text:?} holds a null character"))
}
