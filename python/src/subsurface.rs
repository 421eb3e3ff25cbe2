//! Displacements and stresses below the surface, for arrays of points.

use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyReadwriteArray1, PyReadwriteArray2};
use pyo3::prelude::*;
use wheelrail::error::ContactError;
use wheelrail::fatigue::{DangVan, Strength};
use wheelrail::material::Material;
use wheelrail::subsurface::{Body, Grid, Measure, State, SurfaceLoad as Load};

use crate::contacts::flat_contacts;
use crate::errors::refused;
use crate::planar::case;
use crate::rows::{Target, fill, threads_for};
use crate::units::Wheel;
use crate::worker::FINE;

/// Numbers of a state: displacement x, y, z, stress xx, yy, zz, xy, yz, xz, and the measures in
/// their order.
const NUMBERS: usize = 13;

/// One field: x and y of its first element, sizes, pressure and tractions of shape (across, along).
type GivenField<'py> =
    ([f64; 4], PyReadonlyArray2<'py, f64>, PyReadonlyArray2<'py, f64>, PyReadonlyArray2<'py, f64>);

/// Pressure and tractions on the surface of one body.
#[pyclass(module = "wheelrail._native", frozen)]
pub struct SurfaceLoad {
    load: Load,
}

fn body_of(is_wheel: bool) -> Body {
    if is_wheel { Body::Wheel } else { Body::Rail }
}

fn numbers_of(state: &State) -> [f64; NUMBERS] {
    let mut numbers = [0.0; NUMBERS];
    numbers[..3].copy_from_slice(&state.displacement);
    numbers[3..9].copy_from_slice(&state.stress.components());
    numbers[9..].copy_from_slice(&Measure::ALL.map(|measure| measure.of(&state.stress)));
    numbers
}

#[pymethods]
#[allow(clippy::needless_pass_by_value)]
impl SurfaceLoad {
    /// Of fields with tractions on the wheel, on a body of the material given.
    #[new]
    fn new(
        fields: Vec<GivenField<'_>>,
        is_wheel: bool,
        young_modulus: f64,
        poisson_ratio: f64,
        blunt: bool,
    ) -> PyResult<Self> {
        let sign = if is_wheel { 1.0 } else { -1.0 };
        let mut load = Load::none(Material { young_modulus, poisson_ratio });
        for ([leading_x, left_y, dx, dy], pressure, along, across) in &fields {
            let shape = pressure.as_array().dim();
            let grid = Grid {
                along: shape.1,
                across: shape.0,
                dx: *dx,
                dy: *dy,
                leading_x: *leading_x,
                left_y: *left_y,
            };
            let (p, x, y) = (pressure.as_slice()?, along.as_slice()?, across.as_slice()?);
            load.add(grid, |k| [sign * x[k], sign * y[k], p[k]]);
        }
        Ok(Self { load: if blunt { load.with_blunt_edges() } else { load } })
    }

    /// Greatest pressure, Young's modulus and Poisson's ratio.
    #[getter]
    fn constants(&self) -> [f64; 3] {
        let material = self.load.material();
        [self.load.max_pressure(), material.young_modulus, material.poisson_ratio]
    }

    /// Least and greatest x and y of the loaded elements.
    #[getter]
    fn extent(&self) -> Option<[[f64; 2]; 2]> {
        self.load.extent()
    }

    /// Fills `out`, a row for each of `points` (x, y, depth).
    fn states(
        &self,
        py: Python<'_>,
        points: PyReadonlyArray2<'_, f64>,
        mut out: PyReadwriteArray2<'_, f64>,
        mut states: PyReadwriteArray1<'_, u8>,
        threads: usize,
    ) -> PyResult<()> {
        let (points, _) = points.as_slice()?.as_chunks::<3>();
        let (numbers, states) = (out.as_slice_mut()?, states.as_slice_mut()?);
        let done = py.detach(|| {
            let mut workers = vec![(); threads_for(points.len(), threads)];
            let target = Target { numbers, width: NUMBERS, states };
            fill(target, &mut workers, |(), row, numbers, state| {
                numbers.copy_from_slice(&numbers_of(&self.load.state_at(points[row])?));
                *state = FINE;
                Ok(())
            })
        });
        done.map_err(|(row, error): (usize, ContactError)| refused(py, &error, Some(row)))
    }

    /// Fills `out` with the equivalent stress of Dang Van over a passage, a number for each of
    /// `points` (y, depth), with this weight of the hydrostatic stress and this residual one.
    fn dang_van(
        &self,
        py: Python<'_>,
        points: PyReadonlyArray2<'_, f64>,
        mut out: PyReadwriteArray1<'_, f64>,
        mut states: PyReadwriteArray1<'_, u8>,
        strength: [f64; 2],
        threads: usize,
    ) -> PyResult<()> {
        let (points, _) = points.as_slice()?.as_chunks::<2>();
        let (numbers, states) = (out.as_slice_mut()?, states.as_slice_mut()?);
        let mut of_material = Strength::default();
        [of_material.dang_van, of_material.residual] = strength;
        of_material.check().map_err(|error| refused(py, &error, None))?;
        let done = py.detach(|| {
            let passage = DangVan::new(&self.load, &of_material);
            let mut workers = vec![(); threads_for(points.len(), threads)];
            let target = Target { numbers, width: 1, states };
            fill(target, &mut workers, |(), row, numbers, state| {
                let [y, depth] = points[row];
                // The same points as for stresses.
                self.load.state_at([0.0, y, depth])?;
                numbers[0] = passage.as_ref().map_or(0.0, |passage| passage.at([y, depth]));
                *state = FINE;
                Ok(())
            })
        });
        done.map_err(|(row, error): (usize, ContactError)| refused(py, &error, Some(row)))
    }

    /// Value, place and state of the greatest of a measure, by its number; none without load.
    fn greatest(&self, py: Python<'_>, measure: usize) -> Option<(f64, [f64; 3], [f64; NUMBERS])> {
        let found = py.detach(|| self.load.greatest(*Measure::ALL.get(measure)?))?;
        Some((found.value, found.point, numbers_of(&found.state)))
    }
}

/// What the contacts of a wheel, deepest first, load the wheel or the rail with.
#[pyfunction]
pub fn loads_of(
    py: Python<'_>,
    wheel: &Wheel,
    inputs: Vec<(usize, f64)>,
    is_wheel: bool,
) -> PyResult<Vec<SurfaceLoad>> {
    let evaluator = wheel.evaluator();
    let found = py.detach(|| {
        evaluator.borrowed(&inputs, |element, values| {
            let (contacts, speed) = flat_contacts(element, values)?;
            let loads = contacts.iter().map(|contact| {
                let case = values.parameters.flat_case(contact, speed)?;
                Ok(SurfaceLoad { load: Load::below(&case, body_of(is_wheel))? })
            });
            loads.collect::<Result<Vec<_>, ContactError>>()
        })
    });
    found.map_err(|error| refused(py, &error, None))
}

/// What a planar problem loads the wheel or the rail with.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn planar_load(
    py: Python<'_>,
    wheel: &Wheel,
    separation: PyReadonlyArray2<'_, f64>,
    given: PyReadonlyArray1<'_, f64>,
    by_load: bool,
    is_wheel: bool,
) -> PyResult<SurfaceLoad> {
    let (separation, _) = separation.as_slice()?.as_chunks::<2>();
    let given = given.as_slice()?;
    let load =
        py.detach(|| Load::below(&case(wheel, separation, given, by_load), body_of(is_wheel)));
    Ok(SurfaceLoad { load: load.map_err(|error| refused(py, &error, None))? })
}
