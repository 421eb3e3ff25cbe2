//! One instance of the wheel unit behind its C interface, as a master sees it.
#![allow(unsafe_code)]

use std::error::Error;
use std::ffi::CString;
use std::ptr::null_mut;

use wheelrail::fmi::v2::types::{
    CO_SIMULATION, CallbackFunctions, Component, FALSE, FmuState, Status, ValueReference,
};
use wheelrail::fmi::v2::{
    fmi2DoStep, fmi2EnterInitializationMode, fmi2ExitInitializationMode, fmi2FreeInstance,
    fmi2GetDirectionalDerivative, fmi2GetFMUstate, fmi2GetReal, fmi2Instantiate, fmi2SetFMUstate,
    fmi2SetInteger, fmi2SetReal, fmi2SetRealInputDerivatives, fmi2SetupExperiment,
};
use wheelrail::variables::{GUID, find};

/// A wheel that rolls at 20 m/s, without creep forces: its vertical motion is what the master
/// computes.
pub struct Unit {
    component: Component,
    /// Height, vertical velocity.
    inputs: [ValueReference; 2],
    force: ValueReference,
    state: FmuState,
    time: f64,
    /// Forces read, and derivatives of the force, since the last look.
    pub evaluations: u32,
    pub derivatives: u32,
}

fn accepted(status: Status) -> Result<(), Box<dyn Error>> {
    if status <= Status::Warning { Ok(()) } else { Err("the unit refused a call".into()) }
}

impl Unit {
    /// An instance with that `normal.damping` [N s/m], ready to step.
    pub fn new(damping: f64) -> Result<Self, Box<dyn Error>> {
        let functions = CallbackFunctions {
            logger: None,
            allocate_memory: None,
            free_memory: None,
            step_finished: None,
            component_environment: null_mut(),
        };
        let guid = CString::new(GUID)?;
        let reference = |name: &str| find(name).map(|v| v.reference as ValueReference);
        // SAFETY: FMI 2.0, 2.1.5: texts are null-terminated, the location may be null, the struct
        // is filled in.
        let component = unsafe {
            let (name, none) = (c"wheel".as_ptr(), std::ptr::null());
            let (guid, functions) = (guid.as_ptr(), &raw const functions);
            fmi2Instantiate(name, CO_SIMULATION, guid, none, functions, FALSE, FALSE)
        };
        let unit = Self {
            component,
            inputs: [reference("wheel.z")?, reference("wheel.vz")?],
            force: reference("wheel.force.z")?,
            state: null_mut(),
            time: 0.0,
            evaluations: 0,
            derivatives: 0,
        };
        unit.set(&[reference("normal.damping")?], &[damping])?;
        // SAFETY: FMI 2.0, 2.1.7: arrays of one element; 1 stands for none.
        accepted(unsafe { fmi2SetInteger(component, &reference("tangential.model")?, 1, &1) })?;
        accepted(fmi2SetupExperiment(component, FALSE, 0.0, 0.0, FALSE, 0.0))?;
        accepted(fmi2EnterInitializationMode(component))?;
        accepted(fmi2ExitInitializationMode(component))?;
        unit.set(&[reference("wheel.vx")?, reference("wheel.pitch_rate")?], &[20.0, -43.5])?;
        Ok(unit)
    }

    fn set(&self, references: &[ValueReference], values: &[f64]) -> Result<(), Box<dyn Error>> {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold as many elements as the count says.
        accepted(unsafe {
            let (start, count) = (references.as_ptr(), references.len());
            fmi2SetReal(self.component, start, count, values.as_ptr())
        })
    }

    /// Sets height [m] and vertical velocity [m/s].
    pub fn place(&self, motion: [f64; 2]) -> Result<(), Box<dyn Error>> {
        self.set(&self.inputs, &motion)
    }

    /// The vertical force of the rail on the wheel, down [N].
    pub fn force(&mut self) -> Result<f64, Box<dyn Error>> {
        let mut force = 0.0;
        self.evaluations += 1;
        // SAFETY: FMI 2.0, 2.1.7: arrays of one element.
        accepted(unsafe { fmi2GetReal(self.component, &raw const self.force, 1, &raw mut force) })?;
        Ok(force)
    }

    /// Lets the height go on with a velocity [m/s] over the next step.
    pub fn carry_on(&self, velocity: f64) -> Result<(), Box<dyn Error>> {
        // SAFETY: FMI 2.0, 4.2.1: arrays of one element.
        accepted(unsafe {
            let (height, order, value) = (&raw const self.inputs[0], &1, &raw const velocity);
            fmi2SetRealInputDerivatives(self.component, height, 1, order, value)
        })
    }

    /// Steps over `h` [s].
    pub fn step(&mut self, h: f64) -> Result<(), Box<dyn Error>> {
        accepted(fmi2DoStep(self.component, self.time, h, FALSE))?;
        self.time += h;
        Ok(())
    }

    /// Derivatives of the force with respect to height [N/m] and vertical velocity [N s/m].
    pub fn derivatives(&mut self) -> Result<[f64; 2], Box<dyn Error>> {
        self.derivatives += 1;
        let mut slopes = [0.0; 2];
        for (slope, input) in slopes.iter_mut().zip(&self.inputs) {
            // SAFETY: FMI 2.0, 2.1.9: arrays of one element.
            accepted(unsafe {
                let (force, seed, slope) = (&raw const self.force, &1.0, &raw mut *slope);
                fmi2GetDirectionalDerivative(self.component, force, 1, input, 1, seed, slope)
            })?;
        }
        Ok(slopes)
    }

    /// Keeps the state as it is now.
    pub fn keep(&mut self) -> Result<(), Box<dyn Error>> {
        // SAFETY: FMI 2.0, 2.1.8: a pointer to one state pointer.
        accepted(unsafe { fmi2GetFMUstate(self.component, &raw mut self.state) })
    }

    /// Goes back to the state kept, `h` [s] before.
    pub fn go_back(&mut self, h: f64) -> Result<(), Box<dyn Error>> {
        self.time -= h;
        accepted(fmi2SetFMUstate(self.component, self.state))
    }
}

impl Drop for Unit {
    fn drop(&mut self) {
        fmi2FreeInstance(self.component);
    }
}
