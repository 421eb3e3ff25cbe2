//! The load on the surface of a body: rectangles with uniform tractions, as the corners that their
//! closed forms need.

use super::corner::{Corners, LANES, state_under};
use super::state::State;
use crate::boundary_element::grid::Grid;
use crate::error::ContactError;
use crate::material::Material;
use crate::planar::{ContactField, NormalModel, PlanarCase, TangentialModel, fields};

/// The body under whose surface stresses are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// The wheel: depth counts upwards, against the normal of the contact frame.
    Wheel,
    /// The rail: depth counts along the normal of the contact frame.
    Rail,
}

/// Part of the surface that a search looks under.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    pub grid: Grid,
    /// Elements with load on them.
    pub loaded: Vec<usize>,
}

/// Pressure and tractions on the surface of a half-space, uniform on each of many rectangles.
///
/// x is along rolling, y to the right, z ≥ 0 the depth below the surface of this body: for the rail
/// the contact frame, for the wheel its mirror image, so that a pressure pushes towards positive z on
/// either. Tractions are those on this body. Origin: that of the fields it is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceLoad {
    corners: Vec<Corners>,
    material: Material,
    pub(super) parts: Vec<Part>,
    max_pressure: f64,
    /// Depth at which the limit on the surface is taken [m].
    surface: f64,
    /// How blunt the edges of elements are, ε of [`super::corner`]; 0 for sharp ones [m].
    blunt: f64,
}

/// Width over which a jump between elements is spread, over the side of an element: 1/(2e).
const BLUNT: f64 = 0.5 / std::f64::consts::E;

/// Points farther away than this are none of the body [m].
const MAX_DISTANCE: f64 = 1e3;

/// The limit on the surface is taken at this depth over the side of an element: the arc tangents and
/// logarithms of the surface are finite there, and what changes over it is beyond all digits asked.
const SURFACE: f64 = 1e-9;

impl SurfaceLoad {
    /// The load of `fields` on `body`, which is of `material`.
    pub fn of_fields(fields: &[ContactField], body: Body, material: Material) -> Self {
        // The fields have the tractions on the wheel.
        let sign = match body {
            Body::Wheel => 1.0,
            Body::Rail => -1.0,
        };
        let mut load = Self::none(material);
        for field in fields {
            load.add(field.grid, |k| {
                let [x, y] = field.traction[k];
                [sign * x, sign * y, field.pressure[k]]
            });
        }
        load.with_blunt_edges()
    }

    /// The same load where jumps of tractions between elements are those of a grid over smooth ones,
    /// as of every contact: on the surface they are spread over the smaller side of an element, so
    /// that stresses have bounds there. What is below an element's size is hardly changed.
    #[must_use]
    pub fn with_blunt_edges(mut self) -> Self {
        self.blunt = if self.parts.is_empty() { 0.0 } else { BLUNT * self.element() };
        self
    }

    /// The load on `body` in the planar problem `case`, of its models and its materials; origin: that
    /// of the separation.
    ///
    /// The elements are those of the case where one of its models has boundary elements, else as many
    /// across as it has strips and as many along as these have elements. Tractions are those that
    /// [`fields`] has to show: with linear theory and FaStrip none, with tables those of FASTSIM.
    ///
    /// # Errors
    /// As [`fields`].
    pub fn below(case: &PlanarCase, body: Body) -> Result<Self, ContactError> {
        let material = match body {
            Body::Wheel => case.wheel_material,
            Body::Rail => case.rail_material,
        };
        let has_elements = case.normal_model == NormalModel::BoundaryElement
            || case.tangential_model == TangentialModel::BoundaryElement;
        let elements =
            if has_elements { case.elements } else { [case.elements_along, case.strips] };
        let fields = fields(&PlanarCase { elements, ..*case })?;
        Ok(Self::of_fields(&fields, body, material))
    }

    /// No load on a body of `material`; the edges of the elements that are added are sharp.
    pub fn none(material: Material) -> Self {
        let (corners, parts) = (Vec::new(), Vec::new());
        let surface = f64::INFINITY;
        Self { corners, material, parts, max_pressure: 0.0, surface, blunt: 0.0 }
    }

    /// Adds the elements of `grid`, element k with the `traction` (q_x, q_y, p) on this body: along
    /// x, along y, and pressure [Pa].
    pub fn add(&mut self, grid: Grid, traction: impl Fn(usize) -> [f64; 3]) {
        let loaded: Vec<usize> =
            (0..grid.len()).filter(|&k| traction(k).iter().any(|q| *q != 0.0)).collect();
        for &k in &loaded {
            self.max_pressure = self.max_pressure.max(traction(k)[2]);
        }
        self.surface = self.surface.min(SURFACE * grid.dx.min(grid.dy));
        let at = |i: usize, j: usize| {
            // Outside of the grid there is no load; i and j count from one row before it.
            let inside = (1..=grid.along).contains(&i) && (1..=grid.across).contains(&j);
            if inside { traction((j - 1) * grid.along + i - 1) } else { [0.0; 3] }
        };
        let mut free = LANES;
        for j in 0..=grid.across {
            for i in 0..=grid.along {
                // The corner ahead of the element (i, j) and left of it; columns run backwards.
                let [own, ahead] = [at(i + 1, j + 1), at(i, j + 1)];
                let [left, both] = [at(i + 1, j), at(i, j)];
                let sum = [0, 1, 2].map(|c| ahead[c] - own[c] + left[c] - both[c]);
                if sum.iter().all(|q| *q == 0.0) {
                    continue;
                }
                if free == LANES {
                    self.corners.push(Corners::NONE);
                    free = 0;
                }
                if let Some(last) = self.corners.last_mut() {
                    last.x[free] = grid.leading_x + (0.5 - i as f64) * grid.dx;
                    last.y[free] = grid.left_y + (j as f64 - 0.5) * grid.dy;
                    for (lanes, q) in last.traction.iter_mut().zip(sum) {
                        lanes[free] = q;
                    }
                    free += 1;
                }
            }
        }
        self.parts.push(Part { grid, loaded });
    }

    /// The material of the body.
    pub fn material(&self) -> Material {
        self.material
    }

    /// Greatest pressure of an element [Pa].
    pub fn max_pressure(&self) -> f64 {
        self.max_pressure
    }

    /// The smaller side of an element; infinite without any [m].
    pub(crate) fn element(&self) -> f64 {
        let sides = self.parts.iter().map(|part| part.grid.dx.min(part.grid.dy));
        sides.fold(f64::INFINITY, f64::min)
    }

    /// Least and greatest x and y of the loaded elements; none without load [m].
    pub fn extent(&self) -> Option<[[f64; 2]; 2]> {
        let mut extent = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for Part { grid, loaded } in &self.parts {
            for k in loaded {
                let place = [grid.x(k % grid.along), grid.y(k / grid.along)];
                let sizes = [grid.dx, grid.dy];
                for (range, (value, size)) in extent.iter_mut().zip(place.into_iter().zip(sizes)) {
                    *range = [range[0].min(value - 0.5 * size), range[1].max(value + 0.5 * size)];
                }
            }
        }
        (extent[0][0] < extent[0][1]).then_some(extent)
    }

    /// Displacement and stress at each of `points` (x, y, depth) into `states`; allocates nothing. On
    /// the surface it is the limit from inside the body, on the edge of an element the mean of both
    /// sides, and with sharp edges without bounds where tractions jump.
    ///
    /// # Errors
    /// A coordinate that is not finite, farther away than a kilometre, or above the surface; fewer
    /// states than points.
    pub fn states(&self, points: &[[f64; 3]], states: &mut [State]) -> Result<(), ContactError> {
        if states.len() != points.len() {
            let count = states.len() as f64;
            return Err(ContactError::bad_value("states", count, "as many as there are points"));
        }
        for (point, state) in points.iter().zip(states) {
            check(point)?;
            *state = self.state(*point);
        }
        Ok(())
    }

    /// Displacement and stress at one point (x, y, depth).
    ///
    /// # Errors
    /// As [`Self::states`].
    pub fn state_at(&self, point: [f64; 3]) -> Result<State, ContactError> {
        check(&point)?;
        Ok(self.state(point))
    }

    /// The same for a point of the body.
    pub(crate) fn state(&self, [x, y, z]: [f64; 3]) -> State {
        if self.corners.is_empty() {
            return State::default();
        }
        let Self { corners, material: Material { poisson_ratio, .. }, surface, blunt, .. } = self;
        let mut state =
            state_under(corners, [x, y, z.max(*surface)], *poisson_ratio, blunt * blunt);
        let modulus = self.material.shear_modulus();
        state.displacement = state.displacement.map(|u| u / modulus);
        state
    }
}

/// Whether a point is one of the body.
fn check(&[x, y, depth]: &[f64; 3]) -> Result<(), ContactError> {
    for (name, value) in [("x", x), ("y", y)] {
        if !(-MAX_DISTANCE..=MAX_DISTANCE).contains(&value) {
            let allowed = "a distance in metres, -1000 to 1000";
            return Err(ContactError::bad_value(name, value, allowed));
        }
    }
    if !(0.0..=MAX_DISTANCE).contains(&depth) {
        return Err(ContactError::bad_value("depth", depth, "a depth in metres, 0 to 1000"));
    }
    Ok(())
}
