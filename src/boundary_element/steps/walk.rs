//! One step: its substeps, and what they add up to.

use super::kept::Kept;
use super::lattice::{Lattice, Window};
use crate::boundary_element::friction::Tractions;
use crate::boundary_element::grid::Grid;
use crate::boundary_element::rolling::{steady_rolling, steady_rolling_within};
use crate::boundary_element::transient::{Memory, TOLERANCE, TransientStep};
use crate::material::MaterialPair;

/// Lengths of the contact, as wide as long, after which nothing is left of its history: it falls to
/// 1/e in about 0.6 of them. In wider ones it takes longer, as the logarithm of the width.
const FORGOTTEN: f64 = 20.0;

/// Share of the way behind it in the step that a further substep may be long, beyond the length of
/// the contact.
const GROWTH: f64 = 0.1;

/// Most elements between a contact and that of the step before.
const MAX_BETWEEN: usize = 4000;

/// Most elements over a contact and that of the step before, beyond which a wheel has jumped away
/// from what it left behind.
const MAX_SPAN: usize = 1_000_000;

/// Rounding of tractions at their bound [-].
const ROUNDING: f64 = 1e-12;

/// Tractions for the rigid displacement of each element and tractions to begin with; it is told
/// whether slopes are found from them.
pub type Solve<'a> = dyn FnMut(&[[f64; 2]], &[[f64; 2]], bool) -> Tractions + 'a;

/// A part of a step, for which tractions are to be found.
pub struct Part<'a> {
    /// The elements.
    pub grid: &'a Grid,
    /// What the tractions before take off the slip of each [m].
    pub carried: &'a [[f64; 2]],
    /// Tractions at its beginning [Pa].
    pub before: &'a [[f64; 2]],
    /// About its displacement over the force of a contact that adheres [m/N].
    pub compliance: f64,
    share: Share,
}

/// What share of a step a part is.
#[derive(Clone, Copy)]
enum Share {
    Of(f64),
    /// A step of that length as steady rolling, whose displacements are those of a metre [m].
    Steady(f64),
}

impl Part<'_> {
    /// What it has of a displacement `whole` of the step [m].
    pub fn of(&self, whole: f64) -> f64 {
        match self.share {
            Share::Of(share) => share * whole,
            Share::Steady(length) => whole / length,
        }
    }

    /// How many times its displacements count in the step.
    pub fn times(&self) -> f64 {
        match self.share {
            Share::Of(_) => 1.0,
            Share::Steady(length) => length,
        }
    }
}

/// One step from its first part to its last.
#[derive(Clone, Debug)]
pub struct Walk {
    /// The elements.
    pub grid: Grid,
    window: Window,
    material: MaterialPair,
    /// μ p_n of each element [Pa].
    bound: Vec<f64>,
    /// Distance rolled, either way [m].
    rolled: f64,
    backward: bool,
    // What has been found on the way.
    /// Traction (x, y) of each element at the end [Pa].
    pub tractions: Vec<[f64; 2]>,
    /// Elements that slip at the end.
    pub slips: Vec<bool>,
    /// Slip of each in the step [m].
    pub slip: Vec<[f64; 2]>,
    /// Work of friction on each in the step, ≥ 0 [J].
    pub work: Vec<f64>,
    /// Parts that the step was divided into; 0 where it is steady rolling.
    pub substeps: usize,
    /// Sweeps of all of them.
    pub sweeps: usize,
    /// Whether the tractions of all of them settled.
    pub converged: bool,
    /// Largest slip of the last part that contradicts the friction law, over the largest
    /// displacement [-].
    pub residual: f64,
}

impl Walk {
    /// A step of bodies of `material` over the distance `rolled`, negative backward [m], to where
    /// the elements of `window`, those of `grid`, have the greatest tractions `bound` [Pa].
    pub fn new(
        grid: Grid,
        window: Window,
        material: MaterialPair,
        bound: Vec<f64>,
        rolled: f64,
    ) -> Self {
        let count = grid.len();
        Self {
            grid,
            window,
            material,
            bound,
            rolled: rolled.abs(),
            backward: rolled < 0.0,
            tractions: vec![[0.0; 2]; count],
            slips: vec![false; count],
            slip: vec![[0.0; 2]; count],
            work: vec![0.0; count],
            substeps: 0,
            sweeps: 0,
            converged: true,
            residual: 0.0,
        }
    }

    /// Whether the step has jumped so far away from `kept` that nothing of it is felt.
    pub fn has_jumped(&self, kept: &Kept) -> bool {
        !self.with(kept).is_within(MAX_SPAN)
    }

    /// The axis (0: x, 1: y) along which the elements of `kept` are too far from those of the step,
    /// and how many elements the contact has moved along it.
    pub fn too_far(&self, kept: &Kept) -> Option<(usize, usize)> {
        if self.is_steady() {
            return None;
        }
        let both = self.with(kept);
        let far = (0..2).find(|&axis| both.count[axis] > MAX_BETWEEN)?;
        Some((far, both.count[far] - self.window.count[far]))
    }

    fn length(&self) -> f64 {
        self.grid.along as f64 * self.grid.dx
    }

    /// Whether nothing is left of what was before.
    fn is_steady(&self) -> bool {
        let (length, width) = (self.length(), self.grid.across as f64 * self.grid.dy);
        let slower = 1.0 + 0.5 * (width / length).max(1.0).ln();
        self.rolled > FORGOTTEN * slower * length
    }

    fn with(&self, kept: &Kept) -> Window {
        if kept.tractions.is_empty() { self.window } else { self.window.with(&kept.window) }
    }

    /// Takes the tractions of `kept` over as they are, where a step over nothing, in which nothing
    /// is displaced, leaves them: where they are within the bounds of their elements. Whether they
    /// are.
    pub fn rests(&mut self, kept: &Kept) -> bool {
        let most = 1.0 + ROUNDING;
        let fits = kept.tractions.iter().enumerate().all(|(k, p)| {
            let size = p[0].hypot(p[1]);
            let place = || self.window.place(kept.window.element(k));
            size == 0.0 || place().is_some_and(|k| size <= most * self.bound[k])
        });
        if fits {
            self.tractions = self.window.values_of(&kept.window, &kept.tractions);
            for (k, p) in self.tractions.iter().enumerate() {
                let bound = self.bound[k];
                self.slips[k] = bound > 0.0 && p[0].hypot(p[1]) >= (1.0 - ROUNDING) * bound;
            }
        }
        fits
    }

    /// Goes from the tractions `kept`, which are of the same `lattice`, to the end of the step;
    /// `advance` finds the tractions of a part, by the solver that it is given.
    ///
    /// # Errors
    /// Those of `advance`.
    pub fn go<E>(
        &mut self,
        kept: &Kept,
        lattice: Lattice,
        advance: impl FnMut(&Part<'_>, &mut Solve<'_>) -> Result<Tractions, E>,
    ) -> Result<(), E> {
        self.tractions = self.window.values_of(&kept.window, &kept.tractions);
        // Tractions of before may act on elements that are in contact no more.
        let both = self.with(kept);
        let before = both.values_of(&kept.window, &kept.tractions);
        let (window, material) = (self.window, self.material);
        let carried = |rolled: f64| {
            let grid = lattice.grid(&both, 0.0);
            window.values_of(&both, &Memory::new(&grid, &material, rolled).carried(&before))
        };
        self.go_from(carried, advance)
    }

    /// The same from tractions `kept` on elements of `coarse`, a whole number of times as long and
    /// as wide as those of `lattice`, with which they share their borders: what these carry is taken
    /// between the centres of their elements.
    ///
    /// # Errors
    /// Those of `advance`.
    pub fn go_from_coarse<E>(
        &mut self,
        kept: &Kept,
        coarse: Lattice,
        lattice: Lattice,
        advance: impl FnMut(&Part<'_>, &mut Solve<'_>) -> Result<Tractions, E>,
    ) -> Result<(), E> {
        let (window, material) = (self.window, self.material);
        let places = (0..self.grid.len()).map(|k| lattice.centre(window.element(k)));
        let places: Vec<[f64; 2]> = places.map(|at| coarse.place_of(at)).collect();
        let own = Window::around(&places);
        self.tractions = places
            .iter()
            .map(|place| {
                let at = kept.window.place(place.map(|t| t.round() as i64));
                at.map_or([0.0; 2], |at| kept.tractions[at])
            })
            .collect();
        let all = if kept.tractions.is_empty() { own } else { own.with(&kept.window) };
        let both = if all.is_within(MAX_SPAN) { all } else { own };
        let before = both.values_of(&kept.window, &kept.tractions);
        let carried = |rolled: f64| {
            let grid = coarse.grid(&both, 0.0);
            let values = Memory::new(&grid, &material, rolled).carried(&before);
            places.iter().map(|place| both.between(*place, &values)).collect()
        };
        self.go_from(carried, advance)
    }

    /// The same by what the tractions before carry into the first part, over a distance [m].
    fn go_from<E>(
        &mut self,
        carried_over: impl Fn(f64) -> Vec<[f64; 2]>,
        mut advance: impl FnMut(&Part<'_>, &mut Solve<'_>) -> Result<Tractions, E>,
    ) -> Result<(), E> {
        if self.is_steady() {
            return self.steady(advance);
        }
        let length = self.length();
        let mut rest = self.rolled;
        let compliance = 1.0 / self.stiffness();
        // Of the length of the part before.
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
            let forward = if self.backward { -rolled } else { rolled };
            let carried = if behind > 0.0 {
                memory = memory.filter(|(of, _)| same(*of, rolled));
                let new = || (rolled, Memory::new(grid, material, forward));
                memory.get_or_insert_with(new).1.carried(&self.tractions)
            } else {
                // Over an element at most, so that its share of the end of the part is a half on
                // elements of any size.
                carried_over(forward)
            };
            operator = operator.filter(|(of, _)| same(*of, rolled));
            let new = || (rolled, TransientStep::new(grid, material, forward));
            let step = &operator.get_or_insert_with(new).1;
            let bound = &self.bound;
            let part = Part {
                grid,
                carried: &carried,
                before: &self.tractions,
                compliance,
                share: Share::Of(share),
            };
            let found = advance(&part, &mut |rigid, start, _| step.solve(bound, rigid, start))?;
            self.take(&found, 1.0);
            self.substeps += 1;
            rest -= rolled;
            if parts <= 1.0 || rest <= 0.0 {
                return Ok(());
            }
        }
    }

    /// The whole step as steady rolling.
    fn steady<E>(
        &mut self,
        mut advance: impl FnMut(&Part<'_>, &mut Solve<'_>) -> Result<Tractions, E>,
    ) -> Result<(), E> {
        let carried = vec![[0.0; 2]; self.grid.len()];
        let (grid, material, bound) = (&self.grid, &self.material, &self.bound);
        let forward = |bound: &[f64], rigid: &[[f64; 2]], slopes: bool| {
            // Slopes of forces need tractions that have settled well.
            if slopes {
                steady_rolling_within(TOLERANCE, grid, material, bound, rigid)
            } else {
                steady_rolling(grid, material, bound, rigid)
            }
        };
        let backward = self.backward;
        let mut solve = |rigid: &[[f64; 2]], _: &[[f64; 2]], slopes: bool| {
            if !backward {
                return forward(bound, rigid, slopes);
            }
            let (bound, rigid) = (grid.mirrored(bound), grid.mirrored_vectors(rigid));
            forward(&bound, &rigid, slopes).mirrored(grid)
        };
        let length = self.length();
        let part = Part {
            grid,
            carried: &carried,
            before: &self.tractions,
            compliance: 1.0 / (self.stiffness() * length),
            share: Share::Steady(self.rolled),
        };
        let found = advance(&part, &mut solve)?;
        self.take(&found, self.rolled);
        Ok(())
    }

    /// About the force over the displacement of a contact that adheres [N/m].
    fn stiffness(&self) -> f64 {
        let loaded = self.bound.iter().filter(|&&g| g > 0.0).count() as f64;
        let radius = (loaded * self.grid.element_area() / std::f64::consts::PI).sqrt();
        4.0 * self.material.shear_modulus * radius / (2.0 - self.material.poisson_ratio)
    }

    /// Takes over what a part leads to; slip counts `times`.
    fn take(&mut self, found: &Tractions, times: f64) {
        self.sweeps += found.sweeps;
        self.converged &= found.converged;
        self.residual = found.residual;
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
            for (slip, p) in self.slip[k].iter_mut().zip(p) {
                *slip -= against * p;
            }
            self.work[k] += against * square * area;
        }
    }
}

/// Whether two distances are the same but for rounding.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs()
}
