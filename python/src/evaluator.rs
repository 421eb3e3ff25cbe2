//! A wheel or a wheelset that is evaluated for arrays.

use std::collections::HashMap;
use std::mem::take;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use numpy::{PyReadonlyArray1, PyReadwriteArray1, PyReadwriteArray2};
use pyo3::prelude::*;
use pyo3::types::PyString;
use wheelrail::element::{Element, without_effect};
use wheelrail::error::ContactError;
use wheelrail::variables::{Enumeration, Kind, Value, ValuesOf, Variable};

use crate::errors::{bad_value, refused, unknown};
use crate::rows::{Target, fill, threads_for};
use crate::subjects::{InBulk, put};
use crate::worker::{FINE, Message, REFUSED, Reader, Told, Worker, join, readers, sorted};

/// Columns of inputs: FMI reference and a value for every row.
pub type Columns<'py> = Vec<(usize, PyReadonlyArray1<'py, f64>)>;

/// What all evaluations start from, and workers for the threads.
pub struct Evaluator<S: InBulk> {
    pub values: ValuesOf<S>,
    pub subject: S,
    /// Those that no thread uses now.
    spare: Mutex<Vec<Worker<S>>>,
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
        Ok(Self::of(values, subject))
    }

    /// Of a subject that was made from these values.
    pub fn of(values: ValuesOf<S>, subject: S) -> Self {
        Self { values, subject, spare: Mutex::new(Vec::new()) }
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
    ) -> PyResult<Found> {
        let readers = readers::<S>(outputs);
        self.for_rows(
            py,
            inputs,
            (out.as_slice_mut()?, states.as_slice_mut()?),
            threads,
            tolerant,
            |worker, row, numbers| worker.evaluate(row, &readers, numbers),
        )
    }

    /// Evaluates one row with the inputs at their places.
    pub fn evaluate_one(
        &self,
        py: Python<'_>,
        places: &Places,
        inputs: &[f64],
        tolerant: bool,
    ) -> PyResult<OneRow> {
        let mut numbers = vec![0.0; places.outputs.len()];
        let (done, told) = py.detach(|| {
            let mut worker = self.taken();
            for (reference, value) in places.inputs.iter().zip(inputs) {
                put(&mut worker.values, *reference, *value);
            }
            let done = worker.evaluate(0, &places.outputs, &mut numbers);
            let told = take(&mut worker.told);
            self.given_back([worker]);
            (done, told)
        });
        match done {
            Ok(state) => Ok(OneRow { numbers, state, refusal: None, told: sorted::<S>(told) }),
            Err(error) if tolerant => {
                numbers.fill(f64::NAN);
                let refusal = Some(error.to_string());
                Ok(OneRow { numbers, state: REFUSED, refusal, told: Vec::new() })
            }
            Err(error) => Err(refused(py, &error, Some(0))),
        }
    }

    /// Where inputs and outputs lie, by FMI reference.
    pub fn places(inputs: Vec<usize>, outputs: &[usize]) -> Places {
        Places { inputs, outputs: readers::<S>(outputs) }
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
    ) -> PyResult<Found> {
        let readers = readers::<S>(outputs);
        self.for_rows(
            py,
            inputs,
            (out.as_slice_mut()?, states.as_slice_mut()?),
            threads,
            tolerant,
            |worker, _, numbers| {
                let Worker { subject, values, rates, .. } = worker;
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
        self.for_rows(py, inputs, target, threads, false, |worker, _, numbers| {
            numbers[0] = worker.subject.touching_height(&worker.values.input)?;
            Ok(FINE)
        })?;
        Ok(())
    }

    /// Goes on in time, by wear and by what contacts remember: evaluates row after row, each for its
    /// duration [s]; the state stays in the subject.
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
        self.forget_spare();
        let Self { values, subject, .. } = self;
        let mut values = values.clone();
        let done = py.detach(|| {
            let put_row = |values: &mut ValuesOf<S>, row: usize| {
                for (reference, column) in &columns {
                    put(values, *reference, column[row]);
                }
            };
            // A call that is refused leaves the state as it was.
            for row in 0..durations.len() {
                put_row(&mut values, row);
                S::check(&values.input).map_err(|error| (row, error))?;
            }
            for (row, numbers) in out.chunks_mut(readers.len().max(1)).enumerate() {
                put_row(&mut values, row);
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

    /// Forgets what threads have left, which is what the subject was before it has changed.
    pub fn forget_spare(&mut self) {
        self.spare.get_mut().unwrap_or_else(PoisonError::into_inner).clear();
    }

    /// A subject for a while, and the values with the given inputs.
    pub fn borrowed<R>(
        &self,
        inputs: &[(usize, f64)],
        use_it: impl FnOnce(&mut S, &mut ValuesOf<S>) -> R,
    ) -> R {
        let mut worker = self.taken();
        for (reference, value) in inputs {
            put(&mut worker.values, *reference, *value);
        }
        let result = use_it(&mut worker.subject, &mut worker.values);
        self.given_back([worker]);
        result
    }

    /// Fills numbers and states of the rows by `work` on them.
    pub fn for_rows(
        &self,
        py: Python<'_>,
        inputs: &Columns<'_>,
        (numbers, states): (&mut [f64], &mut [u8]),
        threads: usize,
        tolerant: bool,
        work: impl Fn(&mut Worker<S>, usize, &mut [f64]) -> Result<u8, ContactError> + Sync + Send,
    ) -> PyResult<Found> {
        let columns = slices(inputs)?;
        let rows = states.len();
        let width = numbers.len() / rows.max(1);
        let refusals = Mutex::new(HashMap::new());
        let done = py.detach(|| {
            let mut workers: Vec<Worker<S>> =
                (0..threads_for(rows, threads)).map(|_| self.taken()).collect();
            let target = Target { numbers, width, states };
            let done = fill(target, &mut workers, |worker, row, numbers, state| {
                for (reference, column) in &columns {
                    put(&mut worker.values, *reference, column[row]);
                }
                match work(worker, row, numbers) {
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
            let mut told = Told::new();
            for worker in &mut workers {
                join(&mut told, take(&mut worker.told));
            }
            self.given_back(workers);
            done.map(|()| told)
        });
        let told = done.map_err(|(row, error)| refused(py, &error, Some(row)))?;
        let refusals = refusals.into_inner().unwrap_or_else(PoisonError::into_inner);
        Ok((refusals, sorted::<S>(told)))
    }

    /// What is to be said of the inputs that are given by FMI name: those without effect.
    pub fn without_effect(&self, names: &[String]) -> Vec<(&'static str, String, String)> {
        let all = S::parameters_of_elements(&self.values.parameters);
        let mut found = Vec::new();
        for name in names {
            let side = S::PREFIXES.iter().position(|p| !p.is_empty() && name.starts_with(p));
            let (k, prefix) = side.map_or((0, ""), |k| (k, S::PREFIXES[k]));
            if let Some(remark) = without_effect(&all[k], &name[prefix.len()..]) {
                found.push((remark.title(), name.clone(), remark.message(prefix).to_string()));
            }
        }
        found
    }

    fn taken(&self) -> Worker<S> {
        let spare = self.spare.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let Some(mut worker) = spare else {
            let (subject, values) = (self.subject.clone(), self.values.clone());
            return Worker { subject, values, rates: Vec::new(), told: Told::new() };
        };
        // Rows write nothing else, and parameters hold texts, which are slow to copy.
        (worker.values.input, worker.values.output) = (self.values.input, self.values.output);
        worker
    }

    fn given_back(&self, workers: impl IntoIterator<Item = Worker<S>>) {
        self.spare.lock().unwrap_or_else(PoisonError::into_inner).extend(workers);
    }
}

/// Where inputs and outputs of an evaluation lie, looked up once for their names.
#[pyclass(frozen, module = "wheelrail._native")]
pub struct Places {
    inputs: Vec<usize>,
    outputs: Vec<Reader>,
}

/// What one row gives.
pub struct OneRow {
    /// Outputs in the order of their places.
    pub numbers: Vec<f64>,
    pub state: u8,
    /// Why it is refused.
    pub refusal: Option<String>,
    pub told: Vec<Message>,
}

/// Refusals by row, and remarks.
pub type Found = (HashMap<usize, String>, Vec<Message>);

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
