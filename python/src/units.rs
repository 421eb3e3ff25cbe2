//! Wheel and wheelset as Python classes.

use std::path::PathBuf;

use numpy::{
    PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadwriteArray1, PyReadwriteArray2,
    ToPyArray,
};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyInt, PyTuple};
use wheelrail::element::{ContactHistory, Element, WornBody};

use crate::contacts::{contacts, field_dict};
use crate::errors::{bad_value, refused};
use crate::evaluator::{Columns, Evaluator, Found, OneRow, Places, elements};
use crate::profile::{pairs, points};
use crate::subjects::InBulk;
use crate::worker::Message;

/// Outputs of one row, its state, why it is refused, and remarks.
type FoundOne<'py> = (Bound<'py, PyArray2<f64>>, u8, Option<String>, Vec<Message>);

/// The values if all are numbers of Python, which `float64` of `NumPy` is too.
fn numbers(values: &Bound<'_, PyTuple>) -> Option<Vec<f64>> {
    let is_number =
        |v: &Bound<'_, PyAny>| v.is_instance_of::<PyFloat>() || v.is_instance_of::<PyInt>();
    values.iter_borrowed().map(|v| is_number(&v).then(|| v.extract().ok()).flatten()).collect()
}

/// A class for each subject: classes of Python have no type parameters.
macro_rules! unit {
    ($(#[$doc:meta])* $name:ident of $subject:ty) => {
        $(#[$doc])*
        #[pyclass(frozen, module = "wheelrail._native")]
        pub struct $name {
            evaluator: Evaluator<$subject>,
        }

        impl $name {
            pub fn of(evaluator: Evaluator<$subject>) -> Self {
                Self { evaluator }
            }

            pub fn evaluator(&self) -> &Evaluator<$subject> {
                &self.evaluator
            }
        }

        #[pymethods]
        #[allow(clippy::needless_pass_by_value, clippy::too_many_arguments)]
        impl $name {
            #[new]
            fn new(
                py: Python<'_>,
                settings: Vec<(String, Bound<'_, PyAny>)>,
                folders: Vec<PathBuf>,
            ) -> PyResult<Self> {
                Ok(Self { evaluator: Evaluator::new(py, settings, folders)? })
            }

            /// Height of first touch for the starting inputs [m].
            #[getter]
            fn nominal_z(&self) -> f64 {
                self.evaluator.subject.nominal_z()
            }

            /// What was mended or is suspect in files of profiles, with the parameter that names
            /// each.
            fn remarks(&self) -> Vec<(String, String)> {
                let all = elements(&self.evaluator.subject).iter().flat_map(Element::profile_remarks);
                let worth_a_look = all.filter(|(_, remark)| remark.is_warning());
                worth_a_look.map(|(name, remark)| (name.clone(), remark.to_string())).collect()
            }

            /// What is to be said of inputs that are given by FMI name.
            fn without_effect(&self, names: Vec<String>) -> Vec<(&'static str, String, String)> {
                self.evaluator.without_effect(&names)
            }

            /// Evaluates rows; refusals by row, and remarks.
            fn evaluate(
                &self,
                py: Python<'_>,
                inputs: Columns<'_>,
                outputs: Vec<usize>,
                out: PyReadwriteArray2<'_, f64>,
                states: PyReadwriteArray1<'_, u8>,
                threads: usize,
                tolerant: bool,
            ) -> PyResult<Found> {
                self.evaluator.evaluate(py, &inputs, &outputs, out, states, threads, tolerant)
            }

            /// Where inputs and outputs lie, by FMI reference, for `evaluate_one`.
            #[staticmethod]
            fn places(inputs: Vec<usize>, outputs: Vec<usize>) -> Places {
                Evaluator::<$subject>::places(inputs, &outputs)
            }

            /// Evaluates one row of numbers of Python: outputs, state, refusal and remarks; None if
            /// a value is anything else.
            fn evaluate_one<'py>(
                &self,
                py: Python<'py>,
                places: &Places,
                inputs: &Bound<'py, PyTuple>,
                tolerant: bool,
            ) -> PyResult<Option<FoundOne<'py>>> {
                let Some(inputs) = numbers(inputs) else { return Ok(None) };
                let OneRow { numbers, state, refusal, told } =
                    self.evaluator.evaluate_one(py, places, &inputs, tolerant)?;
                let numbers = numbers.to_pyarray(py).reshape([1, numbers.len()])?;
                Ok(Some((numbers, state, refusal, told)))
            }

            /// Derivatives of the outputs by the inputs for rows; refusals by row.
            fn jacobian(
                &self,
                py: Python<'_>,
                inputs: Columns<'_>,
                outputs: Vec<usize>,
                by: Vec<usize>,
                out: PyReadwriteArray2<'_, f64>,
                states: PyReadwriteArray1<'_, u8>,
                threads: usize,
                tolerant: bool,
            ) -> PyResult<Found> {
                self.evaluator.jacobian(py, &inputs, (&outputs, &by), out, states, threads, tolerant)
            }

            /// Heights of first touch for rows.
            fn touching_heights(
                &self,
                py: Python<'_>,
                inputs: Columns<'_>,
                out: PyReadwriteArray2<'_, f64>,
                states: PyReadwriteArray1<'_, u8>,
                threads: usize,
            ) -> PyResult<()> {
                self.evaluator.touching_heights(py, &inputs, out, states, threads)
            }
        }
    };
}

unit! {
    /// One wheel and the rails under it.
    Wheel of Element
}

unit! {
    /// Two wheels on one axle.
    Wheelset of wheelrail::wheelset::Wheelset
}

/// The contacts of a wheel, deepest first, with pressures and tractions; inputs by FMI reference.
#[pyfunction]
pub fn contacts_of<'py>(
    py: Python<'py>,
    wheel: &Wheel,
    inputs: Vec<(usize, f64)>,
) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let evaluator = wheel.evaluator();
    let found = py.detach(|| evaluator.borrowed(&inputs, contacts));
    let found = found.map_err(|error| refused(py, &error, None))?;
    found.iter().map(|contact| contact.dict(py)).collect()
}

/// A wheel and its rails whose profiles wear or whose contacts remember.
#[pyclass(module = "wheelrail._native")]
pub struct SteppedWheel {
    evaluator: Evaluator<Element>,
}

#[pymethods]
#[allow(clippy::needless_pass_by_value)]
impl SteppedWheel {
    #[new]
    fn new(
        py: Python<'_>,
        settings: Vec<(String, Bound<'_, PyAny>)>,
        folders: Vec<PathBuf>,
    ) -> PyResult<Self> {
        Ok(Self { evaluator: Evaluator::new(py, settings, folders)? })
    }

    /// Evaluates row after row as a step of its duration [s], which wears off what it wears off and
    /// is remembered.
    fn advance(
        &mut self,
        py: Python<'_>,
        inputs: Columns<'_>,
        durations: PyReadonlyArray1<'_, f64>,
        outputs: Vec<usize>,
        out: PyReadwriteArray2<'_, f64>,
    ) -> PyResult<()> {
        self.evaluator.advance(py, &inputs, &durations, &outputs, out)
    }

    /// What contacts remember, as numbers; none where they do not.
    #[getter]
    fn history<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let history = self.evaluator.subject.contact_history();
        PyArray1::from_vec(py, history.map(ContactHistory::to_numbers).unwrap_or_default())
    }

    /// Goes on from another history.
    fn set_history(&mut self, py: Python<'_>, numbers: PyReadonlyArray1<'_, f64>) -> PyResult<()> {
        let history = ContactHistory::from_numbers(numbers.as_slice()?);
        let history = history.map_err(|error| refused(py, &error, None))?;
        self.evaluator.subject.set_contact_history(&history);
        self.evaluator.forget_spare();
        Ok(())
    }

    /// Pressure and remembered tractions, one dict for each rail that is touched; inputs by FMI
    /// reference.
    fn fields<'py>(
        &self,
        py: Python<'py>,
        inputs: Vec<(usize, f64)>,
    ) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let evaluator = &self.evaluator;
        let found = py.detach(|| {
            evaluator.borrowed(&inputs, |element, values| element.remembered_fields(&values.input))
        });
        let fields = found.map_err(|error| refused(py, &error, None))?;
        fields.iter().map(|field| field_dict(py, field)).collect()
    }

    /// Points (y, z) of a profile with all wear so far [m]; body 0 is the wheel, 1 and 2 are the
    /// rails.
    fn profile<'py>(
        &self,
        py: Python<'py>,
        body: usize,
        count: usize,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let element = &self.evaluator.subject;
        let profile = match body.checked_sub(1) {
            None => element.worn_wheel(),
            Some(rail) => element.worn_rail(rail),
        };
        match profile {
            Some(profile) => points(py, &profile, count),
            None => Err(bad_value(
                py,
                "body",
                &format!("rail[{body}] is not there: set rail[{body}].enabled"),
            )),
        }
    }

    /// Points (y, depth) of the wear of a body as the profile in use has it [m].
    fn depth<'py>(&self, py: Python<'py>, body: usize) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let body = body.checked_sub(1).map_or(WornBody::Wheel, WornBody::Rail);
        pairs(py, &self.evaluator.subject.wear_depth(body))
    }
}
