//! Planar contact problems with memory.

use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use wheelrail::planar::{History, StepMotion, TransientContact as Contact};

use crate::contacts::field_dict;
use crate::errors::refused;
use crate::planar::case;
use crate::units::Wheel;

/// A planar contact that is followed through states.
#[pyclass(module = "wheelrail._native")]
pub struct TransientContact {
    contact: Contact,
}

#[pymethods]
#[allow(clippy::needless_pass_by_value)]
impl TransientContact {
    /// With elements of a length and width, or those of the first state.
    #[new]
    fn new(py: Python<'_>, size: Option<[f64; 2]>) -> PyResult<Self> {
        let contact = match size {
            Some(size) => Contact::with_element_size(size),
            None => Ok(Contact::new()),
        };
        Ok(Self { contact: contact.map_err(|error| refused(py, &error, None))? })
    }

    /// Goes one step on: the numbers of `given` as for `planar_solve`, the distance rolled, shift
    /// and turn, and given forces. Returns those of `planar_solve`, displacement (x, y, turn), work
    /// of friction, substeps, sweeps and whether all settled.
    #[allow(clippy::too_many_arguments)]
    fn step(
        &mut self,
        py: Python<'_>,
        wheel: &Wheel,
        separation: PyReadonlyArray2<'_, f64>,
        given: PyReadonlyArray1<'_, f64>,
        by_load: bool,
        rolled: f64,
        shift: [f64; 3],
        force: [Option<f64>; 2],
    ) -> PyResult<[f64; 16]> {
        let (separation, _) = separation.as_slice()?.as_chunks::<2>();
        let given = given.as_slice()?;
        let motion = StepMotion { rolled, shift, force, ..StepMotion::default() };
        let contact = &mut self.contact;
        let found = py.detach(|| contact.step(&case(wheel, separation, given, by_load), &motion));
        let found = found.map_err(|error| refused(py, &error, None))?;
        let contact = &found.contact;
        let [x, y, turn] = found.displacement;
        Ok([
            contact.normal_force,
            contact.max_pressure,
            contact.area,
            contact.length,
            contact.width,
            contact.fx,
            contact.fy,
            contact.mz,
            contact.patches as f64,
            x,
            y,
            turn,
            found.work,
            found.substeps as f64,
            found.sweeps as f64,
            f64::from(u8::from(found.converged)),
        ])
    }

    /// Pressure and tractions of the last step, with the slip distance and the work of friction of
    /// each element in it; None without contact.
    fn field<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(field) = self.contact.field() else { return Ok(None) };
        let dict = field_dict(py, &field.contact)?;
        let shape = [field.contact.grid.across, field.contact.grid.along];
        let plane = |values: Vec<f64>| PyArray1::from_vec(py, values).reshape(shape);
        for (c, name) in ["slip_distance_x", "slip_distance_y"].into_iter().enumerate() {
            dict.set_item(name, plane(field.slip.iter().map(|s| s[c]).collect())?)?;
        }
        dict.set_item("friction_work", plane(field.work.clone())?)?;
        Ok(Some(dict))
    }

    /// All that the next step depends on, as numbers.
    #[getter]
    fn history<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.contact.history().to_numbers())
    }

    /// Goes on from another history.
    fn set_history(&mut self, py: Python<'_>, numbers: PyReadonlyArray1<'_, f64>) -> PyResult<()> {
        let history = History::from_numbers(numbers.as_slice()?);
        self.contact.set_history(history.map_err(|error| refused(py, &error, None))?);
        Ok(())
    }
}
