//! A wheel or a wheelset that is evaluated for arrays.

use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use numpy::{PyReadonlyArray1, PyReadwriteArray1, PyReadwriteArray2};
use pyo3::prelude::*;
use pyo3::types::PyString;
use wheelrail::element::Element;
use wheelrail::error::ContactError;
use wheelrail::variables::{Enumeration, Kind, Value, ValuesOf, Variable};

use crate::errors::{bad_value, refused, unknown};
use crate::rows::{Target, fill, threads_for};
use crate::subjects::{InBulk, put};

/// States of a row.
pub const FINE: u8 = 0;
pub const REFUSED: u8 = 1;
pub const SUNK: u8 = 2;

/// Columns of inputs: FMI reference and a value for every row.
pub type Columns<'py> = Vec<(usize, PyReadonlyArray1<'py, f64>)>;

/// What all evaluations start from, and subjects for the threads.
pub struct Evaluator<S: InBulk> {
    pub values: ValuesOf<S>,
    pub subject: S,
    /// Those that no thread uses now.
    spare: Mutex<Vec<S>>,
}

impl<S: InBulk> Evaluator<S> {
    /// From values by FMI name: parameters, and inputs as they start and stay where no array gives
    /// them.
    pub fn new(
        py: Python<'_>,
        settings: Vec<(String, Bound<'_, PyAny>)>,
        folders: Vec<PathBuf>,
    ) -> PyResult<Self> {
        let mut values = ValuesOf::<S>::default();
        for (name, value) in &settings {
            let variable = S::UNIT.find(name).map_err(|error| unknown(py, &error))?;
            set(py, &mut values, variable, value)?;
        }
        let (parameters, input) = (&values.parameters, &values.input);
        let subject = py
            .detach(|| S::prepare(parameters, input, &folders))
            .map_err(|error| refused(py, &error, None))?;
        Ok(Self { values, subject, spare: Mutex::new(Vec::new()) })
    }

    /// Fills `out` with the `outputs`, FMI references, of each row.
    ///
    /// A row that is refused is an error, or NaN where `tolerant`; its state says so.
    // What Python hands over, one by one.
    #[allow(clippy::too_many_arguments)]
    pub fn evaluate(
        &self,
        py: Python<'_>,
        inputs: &Columns<'_>,
        outputs: &[usize],
        mut out: PyReadwriteArray2<'_, f64>,
        mut states: PyReadwriteArray1<'_, u8>,
        threads: usize,
        tolerant: bool,
    ) -> PyResult<HashMap<usize, String>> {
        let readers = readers::<S>(outputs);
        self.for_rows(
            py,
            inputs,
            (out.as_slice_mut()?, states.as_slice_mut()?),
            threads,
            tolerant,
            |worker, numbers| {
                let Worker { subject, values, .. } = worker;
                for element in subject.elements_mut() {
                    // What a row gives must not depend on those before it.
                    element.set_fallbacks(0);
                }
                subject.evaluate_all(&values.input, &mut values.output)?;
                for (number, read) in numbers.iter_mut().zip(&readers) {
                    *number = read.of(values);
                }
                let sunk = subject.elements().iter().any(|element| element.sunk().is_some());
                Ok(if sunk { SUNK } else { FINE })
            },
        )
    }

    /// Fills `out` with the derivatives of `outputs` by the inputs `by`: output after output, those
    /// by all inputs of each.
    // What Python hands over, one by one.
    #[allow(clippy::too_many_arguments)]
    pub fn jacobian(
        &self,
        py: Python<'_>,
        inputs: &Columns<'_>,
        (outputs, by): (&[usize], &[usize]),
        mut out: PyReadwriteArray2<'_, f64>,
        mut states: PyReadwriteArray1<'_, u8>,
        threads: usize,
        tolerant: bool,
    ) -> PyResult<HashMap<usize, String>> {
        let readers = readers::<S>(outputs);
        self.for_rows(
            py,
            inputs,
            (out.as_slice_mut()?, states.as_slice_mut()?),
            threads,
            tolerant,
            |worker, numbers| {
                let Worker { subject, values, rates } = worker;
                subject.derivatives(&values.input, by, rates)?;
                for (k, rate) in rates.iter().enumerate() {
                    values.output = *rate;
                    for (number, read) in numbers[k..].iter_mut().step_by(by.len()).zip(&readers) {
                        *number = read.of(values);
                    }
                }
                Ok(FINE)
            },
        )
    }

    /// Fills `out` with the heights of first touch.
    pub fn touching_heights(
        &self,
        py: Python<'_>,
        inputs: &Columns<'_>,
        mut out: PyReadwriteArray2<'_, f64>,
        mut states: PyReadwriteArray1<'_, u8>,
        threads: usize,
    ) -> PyResult<()> {
        let target = (out.as_slice_mut()?, states.as_slice_mut()?);
        self.for_rows(py, inputs, target, threads, false, |worker, numbers| {
            numbers[0] = worker.subject.touching_height(&worker.values.input);
            Ok(FINE)
        })?;
        Ok(())
    }

    /// Wears as time goes on: evaluates row after row, each for its duration [s]; the state stays
    /// in the subject.
    pub fn advance(
        &mut self,
        py: Python<'_>,
        inputs: &Columns<'_>,
        durations: &PyReadonlyArray1<'_, f64>,
        outputs: &[usize],
        mut out: PyReadwriteArray2<'_, f64>,
    ) -> PyResult<()> {
        let columns = slices(inputs)?;
        let durations = durations.as_slice()?;
        let readers = readers::<S>(outputs);
        let out = out.as_slice_mut()?;
        // Spare ones have the profiles of before.
        self.spare.lock().unwrap_or_else(PoisonError::into_inner).clear();
        let Self { values, subject, .. } = self;
        let mut values = values.clone();
        let done = py.detach(|| {
            for (row, numbers) in out.chunks_mut(readers.len().max(1)).enumerate() {
                for (reference, column) in &columns {
                    put(&mut values, *reference, column[row]);
                }
                let ValuesOf { input, output, .. } = &mut values;
                subject.advance_all(input, output, durations[row]).map_err(|error| (row, error))?;
                for (number, read) in numbers.iter_mut().zip(&readers) {
                    *number = read.of(&values);
                }
            }
            Ok(())
        });
        done.map_err(|(row, error): (usize, ContactError)| refused(py, &error, Some(row)))
    }

    /// The values with the given inputs, for one evaluation.
    pub fn values_with(&self, inputs: &[(usize, f64)]) -> ValuesOf<S> {
        let mut values = self.values.clone();
        for (reference, value) in inputs {
            put(&mut values, *reference, *value);
        }
        values
    }

    /// A subject for a while.
    pub fn borrowed<R>(&self, use_it: impl FnOnce(&mut S) -> R) -> R {
        let mut subject = self.taken();
        let result = use_it(&mut subject);
        self.given_back(vec![subject]);
        result
    }

    fn for_rows(
        &self,
        py: Python<'_>,
        inputs: &Columns<'_>,
        (numbers, states): (&mut [f64], &mut [u8]),
        threads: usize,
        tolerant: bool,
        work: impl Fn(&mut Worker<S>, &mut [f64]) -> Result<u8, ContactError> + Sync + Send,
    ) -> PyResult<HashMap<usize, String>> {
        let columns = slices(inputs)?;
        let rows = states.len();
        let width = numbers.len() / rows.max(1);
        let refusals = Mutex::new(HashMap::new());
        let done = py.detach(|| {
            let mut workers: Vec<Worker<S>> = (0..threads_for(rows, threads))
                .map(|_| Worker {
                    subject: self.taken(),
                    values: self.values.clone(),
                    rates: Vec::new(),
                })
                .collect();
            let target = Target { numbers, width, states };
            let done = fill(target, &mut workers, |worker, row, numbers, state| {
                for (reference, column) in &columns {
                    put(&mut worker.values, *reference, column[row]);
                }
                match work(worker, numbers) {
                    Ok(found) => *state = found,
                    Err(error) if tolerant => {
                        numbers.fill(f64::NAN);
                        *state = REFUSED;
                        let mut refusals = refusals.lock().unwrap_or_else(PoisonError::into_inner);
                        refusals.insert(row, error.to_string());
                    }
                    Err(error) => return Err(error),
                }
                Ok(())
            });
            self.given_back(workers.into_iter().map(|worker| worker.subject).collect());
            done
        });
        done.map_err(|(row, error)| refused(py, &error, Some(row)))?;
        Ok(refusals.into_inner().unwrap_or_else(PoisonError::into_inner))
    }

    fn taken(&self) -> S {
        let spare = self.spare.lock().unwrap_or_else(PoisonError::into_inner).pop();
        spare.unwrap_or_else(|| self.subject.clone())
    }

    fn given_back(&self, subjects: Vec<S>) {
        self.spare.lock().unwrap_or_else(PoisonError::into_inner).extend(subjects);
    }
}

/// What a thread has for its own.
struct Worker<S: InBulk> {
    subject: S,
    values: ValuesOf<S>,
    rates: Vec<S::Output>,
}

/// How the number of an output is read; its type is looked up once.
enum Reader {
    Real(usize),
    Integer(usize),
}

impl Reader {
    fn of<S: InBulk>(&self, values: &ValuesOf<S>) -> f64 {
        let found = match *self {
            Self::Real(reference) => S::real(values, reference),
            Self::Integer(reference) => S::integer(values, reference).map(f64::from),
        };
        found.unwrap_or(f64::NAN)
    }
}

fn readers<S: InBulk>(outputs: &[usize]) -> Vec<Reader> {
    let reader = |&reference: &usize| match S::UNIT.variables[reference].kind {
        Kind::Real => Reader::Real(reference),
        _ => Reader::Integer(reference),
    };
    outputs.iter().map(reader).collect()
}

fn slices<'a>(inputs: &'a Columns<'_>) -> PyResult<Vec<(usize, &'a [f64])>> {
    inputs.iter().map(|(reference, column)| Ok((*reference, column.as_slice()?))).collect()
}

/// Sets a variable from a Python value of its type; items of enumerations by name or number.
fn set<S: InBulk>(
    py: Python<'_>,
    values: &mut ValuesOf<S>,
    variable: &Variable,
    value: &Bound<'_, PyAny>,
) -> PyResult<()> {
    let wrong = || {
        let (name, shown) =
            (variable.name, value.repr().map_or_else(|_| "?".into(), |r| r.to_string()));
        bad_value(py, name, &format!("{name} = {shown} is not admitted: {}", variable.allowed))
    };
    let text: String;
    let value = match variable.kind {
        Kind::Real => Value::Real(value.extract().map_err(|_| wrong())?),
        Kind::Boolean => Value::Boolean(value.extract().map_err(|_| wrong())?),
        Kind::Integer => Value::Integer(value.extract().map_err(|_| wrong())?),
        Kind::Enumeration(e) => Value::Integer(item(e, value).ok_or_else(wrong)?),
        Kind::Text => {
            // Paths too.
            text = if value.is_instance_of::<PyString>() {
                value.extract()?
            } else {
                let path: PathBuf = value.extract().map_err(|_| wrong())?;
                path.into_os_string().into_string().map_err(|_| wrong())?
            };
            Value::Text(&text)
        }
    };
    values.set(variable, value).map_err(|error| refused(py, &error, None))
}

fn item(e: &Enumeration, value: &Bound<'_, PyAny>) -> Option<i32> {
    match value.extract::<String>() {
        Ok(name) => e.items.iter().find(|item| item.name == name).map(|item| item.value),
        Err(_) => value.extract().ok(),
    }
}

/// The elements of an evaluator's subject.
pub fn elements<S: InBulk>(subject: &S) -> &[Element] {
    subject.elements()
}
