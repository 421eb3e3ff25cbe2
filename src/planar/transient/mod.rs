//! A planar contact problem followed through a series of states: contact with memory.
//!
//! Each step has a state (separation, radius, indentation, creepage, friction), the distance rolled
//! since the state before, and a shift. The pressure is that of the state; tractions follow from
//! those of the step before ([`crate::boundary_element::transient`]), on elements of one endless
//! lattice, so that contacts grow, shrink, move, split, merge, end and begin.
//!
//! A step longer than an element is divided into steps of an element, and, beyond the length of the
//! contact, of a tenth of what lies behind them in the step. Of a step many times as long as the
//! contact nothing but steady rolling is left: it is solved as that.

mod given_force;
mod history;
mod lattice;

pub use history::History;

use super::case::{Indentation, PlanarCase};
use super::line::PlanarLine;
use super::{
    ELEMENT_APPROACH, MAX_ZONES, PlanarResult, approach_for, friction_at, press_together,
    zone_edges,
};
use crate::boundary_element::friction::Tractions;
use crate::boundary_element::grid::Grid;
use crate::boundary_element::rolling::{steady_rolling, steady_rolling_within};
use crate::boundary_element::transient::{Memory, TOLERANCE, TransientStep};
use crate::error::ContactError;
use crate::kinematics::creepage::bounded;
use crate::material::MaterialPair;
use crate::math::quadrature::GaussLegendre;
use crate::normal::boundary_element::{GridPressure, fill_rows, solve_on_grid};
use crate::normal::{ElementPressure, NormalModel, NormalProblem, Strips};
use crate::open::Open;
use crate::tangential::TangentialModel;
use crate::tangential::field::{Adherence, ContactField};
use given_force::{Forces, displacement_for};
use lattice::{Lattice, Window};

/// How the bodies move in a step, besides the creepage of its state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepMotion {
    /// Distance rolled towards +x, 0 to 1e6 [m].
    pub rolled: f64,
    /// Displacement of the wheel against the rail along x and y [m] and turn about the normal
    /// through the origin of the separation [rad], on top of creepage times the distance rolled.
    pub shift: [f64; 3],
    /// Longitudinal and lateral creep force on the wheel at the end of the step, where it is given
    /// [N]: that component of the displacement is found, and what creepage and shift say of it is
    /// where the search begins.
    pub force: [Option<f64>; 2],
    #[doc(hidden)]
    pub open: Open,
}

/// What a step leads to; forces on the wheel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct TransientResult {
    /// Forces and contact at the end of the step.
    pub contact: PlanarResult,
    /// Rigid displacement of the wheel against the rail in the step along x and y [m] and turn
    /// [rad]: as given, or as found for given forces.
    pub displacement: [f64; 3],
    /// Work that friction takes up in the step, ≥ 0 [J].
    pub work: f64,
    /// Steps that it was divided into; 0 where it is solved as steady rolling.
    pub substeps: usize,
    /// Sweeps of the tangential solver.
    pub sweeps: usize,
    /// Whether the tractions of all of them settled.
    pub converged: bool,
}

/// Pressure, tractions and slip element by element at the end of a step.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct TransientField {
    /// Pressure and tractions on the wheel; y from the origin of the separation. Slip is over the
    /// distance rolled, as the mean of the step; none in a shift.
    pub contact: ContactField,
    /// Slip of the wheel against the rail in the step [m].
    pub slip: Vec<[f64; 2]>,
    /// Work of friction in the step, ≥ 0 [J].
    pub work: Vec<f64>,
}

/// A planar problem that is followed through a series of states.
#[derive(Clone, Debug, Default)]
pub struct TransientContact {
    history: History,
    last: Option<TransientField>,
}

/// Lengths of the contact, as wide as long, after which nothing is left of its history: it falls to
/// 1/e in about 0.6 of them. In wider ones it takes longer, as the logarithm of the width.
const FORGOTTEN: f64 = 20.0;

/// Share of the way behind it in the step that a further substep may be long, beyond the length of
/// the contact.
const GROWTH: f64 = 0.1;

/// Most elements along or across a contact, and between it and that of the step before.
const MAX_ELEMENTS: usize = 1000;
const MAX_BETWEEN: usize = 4000;

/// Least and greatest size of an element [m].
const SIZES: (f64, f64) = (1e-7, 1.0);

/// Farthest that is rolled in a step [m].
const MAX_ROLLED: f64 = 1e6;

impl TransientContact {
    /// A contact whose elements are those of its first state: [`PlanarCase::elements`] over the
    /// extent of all zones. Later states have elements of the same size.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// A contact with elements of the length and width `size` [m], one of them centred at x = 0 on
    /// the origin of the separation.
    ///
    /// # Errors
    /// A size that is not positive, or that is beyond 0.1 μm to 1 m.
    pub fn with_element_size(size: [f64; 2]) -> Result<Self, ContactError> {
        for (name, size) in ["element_length", "element_width"].into_iter().zip(size) {
            if !(SIZES.0..=SIZES.1).contains(&size) {
                return Err(ContactError::bad_value(name, size, "a size in metres, 1e-7 to 1"));
            }
        }
        let lattice = Some(Lattice { size, origin: [0.0; 2] });
        Ok(Self { history: History { lattice, ..History::default() }, last: None })
    }

    /// What the next step depends on.
    #[must_use]
    pub fn history(&self) -> &History {
        &self.history
    }

    /// Goes back, or on, to another history: steps after it are those after it before, to the bit.
    pub fn set_history(&mut self, history: History) {
        *self = Self { history, last: None };
    }

    /// Pressure, tractions and slip of the last step; nothing before the first, after a new history
    /// and without contact.
    #[must_use]
    pub fn field(&self) -> Option<&TransientField> {
        self.last.as_ref()
    }

    /// Goes one step on, to the state `case`. The models of `case` are boundary elements, its
    /// friction does not fall.
    ///
    /// # Errors
    /// A value that is not admitted, a load that no approach carries or a creep force that the
    /// contact cannot carry, each by its name. The history stays as it was.
    pub fn step(
        &mut self,
        case: &PlanarCase,
        motion: &StepMotion,
    ) -> Result<TransientResult, ContactError> {
        check(case, motion, &self.history)?;
        let mut history = self.history.clone();
        history.materials = Some([case.wheel_material, case.rail_material]);
        if history.lattice.is_none() {
            history.lattice = first_lattice(case)?;
        }
        let pressed = match &history.lattice {
            Some(lattice) => press_on(lattice, case)?,
            None => None,
        };
        let Some((lattice, Pressed { strips, contact_y, field })) = history.lattice.zip(pressed)
        else {
            if let Some((name, force)) = first_force(motion) {
                return Err(ContactError::bad_value(name, force, "0 where there is no contact"));
            }
            (history.window, history.tractions) = (Window::default(), Vec::new());
            *self = Self { history, last: None };
            let displacement = displacement(case, motion);
            return Ok(TransientResult { displacement, converged: true, ..Default::default() });
        };
        let grid = field.grid;
        let window = lattice.over(lattice_extent(&grid, contact_y));
        debug_assert_eq!(window.count, [grid.along, grid.across]);
        let grid = Grid { left_y: grid.left_y + contact_y, ..grid };
        let mut walk = Walk::new(case, motion, grid, window, &field)?;
        walk.go(&history, lattice)?;
        let mut result = walk.result(&strips);
        result.contact.fallback = false;
        history.window = window;
        history.tractions.clone_from(&walk.tractions);
        let last = walk.field(field.pressure);
        *self = Self { history, last: Some(last) };
        Ok(result)
    }
}

/// Least and greatest x, then y, of the elements inside the margin of `grid`.
fn lattice_extent(grid: &Grid, contact_y: f64) -> [[f64; 2]; 2] {
    let y = grid.left_y + contact_y;
    [
        [grid.x(grid.along - 2) - 0.5 * grid.dx, grid.x(1) + 0.5 * grid.dx],
        [y + 0.5 * grid.dy, y + (grid.across as f64 - 1.5) * grid.dy],
    ]
}

/// Whether a step is one that can be solved.
fn check(case: &PlanarCase, motion: &StepMotion, history: &History) -> Result<(), ContactError> {
    case.check()?;
    let text = |name: &str, value: String| {
        let allowed = "BoundaryElement in contact with memory".into();
        Err(ContactError::BadText { name: name.into(), value, allowed })
    };
    if case.normal_model != NormalModel::BoundaryElement {
        return text("normal_model", format!("{:?}", case.normal_model));
    }
    if case.tangential_model != TangentialModel::BoundaryElement {
        return text("tangential_model", format!("{:?}", case.tangential_model));
    }
    for (law, name) in [(&case.friction_law, ""), (&case.gauge_face_law, " of the gauge face")] {
        if !law.is_on() {
            continue;
        }
        let (number, value) = if law.falling_share < 1.0 {
            ("falling share", law.falling_share)
        } else if law.reduction < 1.0 {
            ("reduction", law.reduction)
        } else {
            ("reduction share", law.reduction_share)
        };
        let allowed = "1 in contact with memory: one coefficient on clean bodies";
        return Err(ContactError::bad_value(format!("{number}{name}"), value, allowed));
    }
    if case.flash_temperature.is_on() {
        let allowed = "1 in contact with memory: friction that does not fall";
        let share = case.flash_temperature.share;
        return Err(ContactError::bad_value("flash share", share, allowed));
    }
    let require = |name: &str, value: f64, fits: bool, allowed: &'static str| {
        if value.is_finite() && fits {
            Ok(())
        } else {
            Err(ContactError::bad_value(name, value, allowed))
        }
    };
    let rolled = motion.rolled;
    let fits = (0.0..=MAX_ROLLED).contains(&rolled);
    require("rolled", rolled, fits, "a distance in metres, 0 to 1e6")?;
    for (name, value) in ["shift_x", "shift_y", "turn"].into_iter().zip(motion.shift) {
        require(name, value, value.abs() <= MAX_ROLLED, "a finite number, -1e6 to 1e6")?;
    }
    for (name, value) in FORCES.into_iter().zip(motion.force) {
        require(name, value.unwrap_or(0.0), true, "a finite number")?;
    }
    for ((body, own), before) in [("wheel", case.wheel_material), ("rail", case.rail_material)]
        .into_iter()
        .zip(history.materials.unwrap_or([case.wheel_material, case.rail_material]))
    {
        for (name, value, before) in [
            ("young_modulus", own.young_modulus, before.young_modulus),
            ("poisson_ratio", own.poisson_ratio, before.poisson_ratio),
        ] {
            let same = value.to_bits() == before.to_bits();
            require(&format!("{body} {name}"), value, same, "what it was in the first state")?;
        }
    }
    Ok(())
}

/// Names of given forces.
const FORCES: [&str; 2] = ["force_longitudinal", "force_lateral"];

/// The first force that is given and not zero.
fn first_force(motion: &StepMotion) -> Option<(&'static str, f64)> {
    let forces = FORCES.into_iter().zip(motion.force);
    forces.filter_map(|(name, force)| Some((name, force?))).find(|(_, force)| force.abs() > 0.0)
}

/// Rigid displacement of a step as its state and motion say.
fn displacement(case: &PlanarCase, motion: &StepMotion) -> [f64; 3] {
    let mut whole = motion.shift;
    for (whole, creepage) in whole.iter_mut().zip(case.creepage) {
        *whole += motion.rolled * bounded(creepage);
    }
    whole
}

/// The normal solution of a state.
struct Pressed {
    strips: Strips,
    contact_y: f64,
    field: ElementPressure,
}

/// Elements over the extent of the first state.
fn first_lattice(case: &PlanarCase) -> Result<Option<Lattice>, ContactError> {
    let super::Pressed { strips, contact_y, .. } = press_together(case)?;
    Ok(strips.elements.map(|field| Lattice::through(&field.grid, contact_y)))
}

/// The normal solution of `case` on elements of `lattice`; nothing without contact.
fn press_on(lattice: &Lattice, case: &PlanarCase) -> Result<Option<Pressed>, ContactError> {
    let mut line = PlanarLine::new(case.separation);
    let (least, contact_y) = (line.least, line.contact);
    let rule = GaussLegendre::new(case.strips);
    let material = MaterialPair::new(case.wheel_material, case.rail_material);
    let probes = std::mem::take(&mut line.probes);
    let mut refused = None;
    let mut found = None;
    // `approach` counts from first touch.
    let mut press = |approach: f64| {
        found = None;
        if approach <= 0.0 || refused.is_some() {
            return 0.0;
        }
        let problem = NormalProblem {
            approach,
            radius: case.radius,
            contact_modulus: material.contact_modulus,
            contact_u: line.contact,
            lateral_curvature: line.curve.at(line.contact).second[1],
            rule: &rule,
            elements: case.elements,
        };
        let grid = |[x, y]: [[f64; 2]; 2]| {
            let window = lattice.over([x, y.map(|y| y + contact_y)]);
            for axis in 0..2 {
                if window.count[axis] > MAX_ELEMENTS {
                    let name = ["element_length", "element_width"][axis];
                    let allowed = "a size with at most 1000 elements over the contact";
                    refused = Some(ContactError::bad_value(name, lattice.size[axis], allowed));
                    return None;
                }
            }
            Some(lattice.grid(&window, contact_y))
        };
        let across = case.elements[1];
        match solve_on_grid(&problem, across, &mut line, &probes, grid) {
            GridPressure::None => 0.0,
            GridPressure::Lost => {
                let allowed = "an approach whose pressure is found";
                refused.get_or_insert(ContactError::bad_value("approach", approach, allowed));
                0.0
            }
            GridPressure::Found(field, u) => {
                let load = field.pressure.iter().sum::<f64>() * field.grid.element_area();
                found = Some((field, u));
                load
            }
        }
    };
    match case.indentation {
        Indentation::Approach(approach) => {
            press(approach - least);
        }
        Indentation::Load(load) if load > 0.0 => {
            let approach = approach_for(load, ELEMENT_APPROACH, &mut press);
            if let Ok(approach) = approach {
                press(approach);
            }
            if refused.is_none() {
                approach?;
            }
        }
        Indentation::Load(_) => {}
    }
    if let Some(error) = refused {
        return Err(error);
    }
    let Some((field, u)) = found else { return Ok(None) };
    let mut strips = Strips::with_capacity(MAX_ZONES, 0);
    fill_rows(&mut strips, field.clone(), &u);
    Ok(Some(Pressed { strips, contact_y, field }))
}

/// One step from its first substep to its last.
struct Walk {
    grid: Grid,
    window: Window,
    material: MaterialPair,
    /// μ p_n of each element [Pa].
    bound: Vec<f64>,
    /// Friction limit [N].
    limit: f64,
    rolled: f64,
    force: [Option<f64>; 2],
    displacement: [f64; 3],
    // What has been found on the way.
    tractions: Vec<[f64; 2]>,
    slips: Vec<bool>,
    slip: Vec<[f64; 2]>,
    work: Vec<f64>,
    found: [f64; 3],
    substeps: usize,
    sweeps: usize,
    converged: bool,
}

impl Walk {
    fn new(
        case: &PlanarCase,
        motion: &StepMotion,
        grid: Grid,
        window: Window,
        field: &ElementPressure,
    ) -> Result<Self, ContactError> {
        let mut bound = field.pressure.clone();
        for (j, row) in bound.chunks_exact_mut(grid.along).enumerate() {
            let friction = friction_at(case, grid.y(j));
            let friction = friction.map_or(case.friction, |own| own.under(&[1.0; 2]));
            for bound in row {
                *bound *= friction;
            }
        }
        let limit = bound.iter().sum::<f64>() * grid.element_area();
        let [x, y] = motion.force.map(|force| force.unwrap_or(0.0));
        if x.hypot(y) >= limit
            && let Some((name, force)) = first_force(motion)
        {
            let allowed = "a creep force below the friction limit, that of both components";
            return Err(ContactError::bad_value(name, force, allowed));
        }
        let count = grid.len();
        Ok(Self {
            grid,
            window,
            material: MaterialPair::new(case.wheel_material, case.rail_material),
            bound,
            limit,
            rolled: motion.rolled,
            force: motion.force,
            displacement: displacement(case, motion),
            tractions: vec![[0.0; 2]; count],
            slips: vec![false; count],
            slip: vec![[0.0; 2]; count],
            work: vec![0.0; count],
            found: [0.0; 3],
            substeps: 0,
            sweeps: 0,
            converged: true,
        })
    }

    fn go(&mut self, history: &History, lattice: Lattice) -> Result<(), ContactError> {
        self.tractions = self.window.values_of(&history.window, &history.tractions);
        let length = self.grid.along as f64 * self.grid.dx;
        let width = self.grid.across as f64 * self.grid.dy;
        let slower = 1.0 + 0.5 * (width / length).max(1.0).ln();
        if self.rolled > FORGOTTEN * slower * length {
            return self.steady();
        }
        // Tractions of before may act on elements that are in contact no more.
        let both = if history.tractions.is_empty() {
            self.window
        } else {
            self.window.with(&history.window)
        };
        for axis in 0..2 {
            if both.count[axis] > MAX_BETWEEN {
                let name = ["radius", "separation y"][axis];
                let moved = (both.count[axis] - self.window.count[axis]) as f64;
                let allowed = "a contact within 4000 elements of that of the step before";
                return Err(ContactError::bad_value(name, moved * lattice.size[axis], allowed));
            }
        }
        let before = both.values_of(&history.window, &history.tractions);
        let both_grid = lattice.grid(&both, 0.0);
        let mut rest = self.rolled;
        // Of the length of the substep before.
        let mut operator: Option<(f64, TransientStep)> = None;
        let mut memory: Option<(f64, Memory)> = None;
        loop {
            let behind = self.rolled - rest;
            let longest = self.grid.dx.max(GROWTH * (behind - length));
            // No crumbs at the end.
            let parts = (rest / longest - 1e-9).ceil();
            let rolled = if parts > 2.0 { longest } else { rest / parts.max(1.0) };
            let share = if self.rolled > 0.0 { rolled / self.rolled } else { 1.0 };
            let (grid, material) = (&self.grid, &self.material);
            let carried = if behind > 0.0 {
                memory = memory.filter(|(of, _)| same(*of, rolled));
                let new = || (rolled, Memory::new(grid, material, rolled));
                memory.get_or_insert_with(new).1.carried(&self.tractions)
            } else {
                let carried = Memory::new(&both_grid, material, rolled).carried(&before);
                self.window.values_of(&both, &carried)
            };
            operator = operator.filter(|(of, _)| same(*of, rolled));
            let new = || (rolled, TransientStep::new(grid, material, rolled));
            let step = &operator.get_or_insert_with(new).1;
            let mut solve = |rigid: &[[f64; 2]], start: &[[f64; 2]], _: bool| {
                step.solve(&self.bound, rigid, start)
            };
            let stiffness = self.stiffness();
            let done = advance(
                &self.grid,
                &self.tractions,
                &carried,
                self.displacement.map(|d| share * d),
                (self.force, self.limit, 1.0 / stiffness),
                &mut solve,
            )?;
            self.take(&done, 1.0);
            self.substeps += 1;
            rest -= rolled;
            if parts <= 1.0 || rest <= 0.0 {
                return Ok(());
            }
        }
    }

    /// The whole step as steady rolling.
    fn steady(&mut self) -> Result<(), ContactError> {
        let carried = vec![[0.0; 2]; self.grid.len()];
        let (grid, material, bound) = (&self.grid, &self.material, &self.bound);
        // Slopes of forces need tractions that have settled well.
        let mut solve = |rigid: &[[f64; 2]], _: &[[f64; 2]], slopes: bool| {
            if slopes {
                steady_rolling_within(TOLERANCE, grid, material, bound, rigid)
            } else {
                steady_rolling(grid, material, bound, rigid)
            }
        };
        let length = self.grid.along as f64 * self.grid.dx;
        let done = advance(
            grid,
            &self.tractions,
            &carried,
            self.displacement.map(|d| d / self.rolled),
            (self.force, self.limit, 1.0 / (self.stiffness() * length)),
            &mut solve,
        )?;
        self.take(&done, self.rolled);
        Ok(())
    }

    /// About the force over the displacement of a contact that adheres [N/m].
    fn stiffness(&self) -> f64 {
        let loaded = self.bound.iter().filter(|&&g| g > 0.0).count() as f64;
        let radius = (loaded * self.grid.element_area() / std::f64::consts::PI).sqrt();
        4.0 * self.material.shear_modulus * radius / (2.0 - self.material.poisson_ratio)
    }

    /// Takes over what a substep leads to; displacements and slip count `times`.
    fn take(&mut self, done: &Advanced, times: f64) {
        let Advanced { tractions: found, displacement } = done;
        self.sweeps += found.sweeps;
        self.converged &= found.converged;
        for (sum, part) in self.found.iter_mut().zip(displacement) {
            *sum += times * part;
        }
        let area = self.grid.element_area();
        for k in 0..self.grid.len() {
            let p = [found.x[k], found.y[k]];
            self.tractions[k] = p;
            self.slips[k] = found.slips[k];
            let square = p[0] * p[0] + p[1] * p[1];
            if !found.slips[k] || square <= 0.0 {
                continue;
            }
            // Against the traction, as the law has it: what the iteration leaves besides is error.
            let s = [found.slip_x[k], found.slip_y[k]];
            let against = (-(s[0] * p[0] + s[1] * p[1]) / square).max(0.0) * times;
            for c in 0..2 {
                self.slip[k][c] -= against * p[c];
            }
            self.work[k] += against * square * area;
        }
    }

    fn result(&self, strips: &Strips) -> TransientResult {
        let mut contact = PlanarResult { patches: strips.zones.len(), ..PlanarResult::default() };
        let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
        for zone in strips.zones.iter() {
            contact.normal_force += zone.load;
            contact.max_pressure = contact.max_pressure.max(zone.max_pressure);
            contact.area += zone.area;
            contact.length = contact.length.max(zone.length);
            let edges = zone_edges(strips, zone.first, zone.count);
            left = left.min(edges[0]);
            right = right.max(edges[1]);
        }
        contact.width = (right - left).max(0.0);
        let [fx, fy] = force_of(&self.grid, &self.tractions);
        (contact.fx, contact.fy) = (fx, fy);
        let area = self.grid.element_area();
        contact.mz = self.tractions.iter().enumerate().fold(0.0, |sum, (k, p)| {
            let (x, y) = (self.grid.x(k % self.grid.along), self.grid.y(k / self.grid.along));
            sum + area * (x * p[1] - y * p[0])
        });
        TransientResult {
            contact,
            displacement: self.found,
            work: self.work.iter().sum(),
            substeps: self.substeps,
            sweeps: self.sweeps,
            converged: self.converged,
        }
    }

    fn field(self, pressure: Vec<f64>) -> TransientField {
        let mut contact = ContactField::of_pressure(self.grid, pressure);
        contact.traction = self.tractions;
        for (k, adherence) in contact.adherence.iter_mut().enumerate() {
            if contact.pressure[k] > 0.0 {
                *adherence = if self.slips[k] { Adherence::Slip } else { Adherence::Adhesion };
            }
        }
        if self.rolled > 0.0 {
            let over = self.slip.iter().map(|s| s.map(|s| s / self.rolled));
            contact.slip = Some(over.collect());
        }
        TransientField { contact, slip: self.slip, work: self.work }
    }
}

/// Whether two distances are the same but for rounding.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs()
}

/// Sum of the tractions [N].
fn force_of(grid: &Grid, tractions: &[[f64; 2]]) -> [f64; 2] {
    let area = grid.element_area();
    [0, 1].map(|c| tractions.iter().map(|p| p[c]).sum::<f64>() * area)
}

/// What a substep leads to.
struct Advanced {
    tractions: Tractions,
    displacement: [f64; 3],
}

/// Solves a substep with the rigid displacement (x, y, turn), of which a component whose `force` is
/// given is found, less what is `carried`.
///
/// `solve` is for a rigid displacement of each element and tractions to begin with, and is told
/// whether slopes are found from it.
fn advance(
    grid: &Grid,
    before: &[[f64; 2]],
    carried: &[[f64; 2]],
    displacement: [f64; 3],
    (force, limit, compliance): ([Option<f64>; 2], f64, f64),
    solve: &mut dyn FnMut(&[[f64; 2]], &[[f64; 2]], bool) -> Tractions,
) -> Result<Advanced, ContactError> {
    let turn = displacement[2];
    let rigid = |d: [f64; 2]| -> Vec<[f64; 2]> {
        let carried = carried.iter().enumerate();
        let rigid = carried.map(|(k, carried)| {
            let (x, y) = (grid.x(k % grid.along), grid.y(k / grid.along));
            [d[0] - turn * y - carried[0], d[1] + turn * x - carried[1]]
        });
        rigid.collect()
    };
    let start = [displacement[0], displacement[1]];
    let Some((name, value)) =
        FORCES.into_iter().zip(force).find_map(|(name, force)| Some((name, force?)))
    else {
        let tractions = solve(&rigid(start), before, false);
        return Ok(Advanced { tractions, displacement });
    };
    let mut problem = Solved { grid, before, rigid, solve, sweeps: 0 };
    let found = displacement_for(&mut problem, force, start, limit, compliance);
    let Some(([x, y], mut tractions)) = found else {
        let allowed = "a creep force that the contact carries";
        return Err(ContactError::bad_value(name, value, allowed));
    };
    tractions.sweeps = problem.sweeps;
    Ok(Advanced { tractions, displacement: [x, y, turn] })
}

/// A substep as forces by displacements.
struct Solved<'a, R> {
    grid: &'a Grid,
    before: &'a [[f64; 2]],
    rigid: R,
    solve: &'a mut dyn FnMut(&[[f64; 2]], &[[f64; 2]], bool) -> Tractions,
    sweeps: usize,
}

impl<R: Fn([f64; 2]) -> Vec<[f64; 2]>> Forces for Solved<'_, R> {
    type Found = Tractions;

    fn at(&mut self, displacement: [f64; 2], near: Option<&Tractions>) -> (Tractions, [f64; 2]) {
        let start = near.map(|t| t.x.iter().zip(&t.y).map(|(x, y)| [*x, *y]).collect::<Vec<_>>());
        let start = start.as_deref().unwrap_or(self.before);
        let found = (self.solve)(&(self.rigid)(displacement), start, true);
        self.sweeps += found.sweeps;
        let area = self.grid.element_area();
        let force = [&found.x, &found.y].map(|p| p.iter().sum::<f64>() * area);
        (found, force)
    }
}
