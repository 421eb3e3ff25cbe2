//! The solvers of coupled marches, one for each kind of number.

use super::differences::Differences;
use super::parts::ZoneParts;
use super::solver::{DIRECTIONS, Solver};
use super::state::{Resultant, Strip};
use crate::kinematics::creepage::Creepage;
use crate::math::dual::Dual;
use crate::math::real::Real;
use crate::math::tape::Taped;
use crate::tangential::equivalent_ellipse::{EquivalentEllipse, LoadedPart};

/// The model, with solvers in plain numbers and with derivatives.
#[derive(Clone, Debug)]
pub struct CoupledMarches {
    pub(super) plain: Solver,
    moving: Solver<Dual<DIRECTIONS>>,
    /// For derivatives backwards, once they have been asked for.
    taped: Option<Box<Solver<Taped>>>,
    /// What is missing on ellipses.
    differences: &'static Differences,
}

impl CoupledMarches {
    /// For zones of up to `strips` strips; larger ones allocate.
    pub fn new(strips: usize) -> Self {
        Self {
            plain: Solver::new(strips),
            moving: Solver::new(strips),
            taped: None,
            differences: Differences::shared(),
        }
    }
}

/// Numbers with which solutions are found.
pub trait MarchNumber: Real {
    /// Solves for `zones` with their strips and hands the tractions of all strips, in their order, to
    /// `each`, which adds them up: they may come in several parts.
    fn march_strips(
        model: &mut CoupledMarches,
        zones: impl Iterator<Item = (ZoneParts<Self>, impl Iterator<Item = Strip<Self>>)> + Clone,
        poisson_ratio: Self,
        each: impl FnMut(&mut dyn Iterator<Item = Resultant<Self>>),
    );
}

impl MarchNumber for f64 {
    fn march_strips(
        model: &mut CoupledMarches,
        zones: impl Iterator<Item = (ZoneParts, impl Iterator<Item = Strip>)> + Clone,
        poisson_ratio: f64,
        mut each: impl FnMut(&mut dyn Iterator<Item = Resultant>),
    ) {
        model.plain.solve_zones(zones, poisson_ratio, model.differences);
        each(&mut model.plain.resultants().copied());
    }
}

impl<const N: usize> MarchNumber for Dual<N> {
    fn march_strips(
        model: &mut CoupledMarches,
        zones: impl Iterator<Item = (ZoneParts<Self>, impl Iterator<Item = Strip<Self>>)> + Clone,
        poisson_ratio: Self,
        mut each: impl FnMut(&mut dyn Iterator<Item = Resultant<Self>>),
    ) {
        for start in (0..N).step_by(DIRECTIONS) {
            let count = (N - start).min(DIRECTIONS);
            let few = move |x: Self| {
                let mut slopes = [0.0; DIRECTIONS];
                slopes[..count].copy_from_slice(&x.slopes[start..start + count]);
                Dual { value: x.value, slopes }
            };
            let back = |x: Dual<DIRECTIONS>| {
                let mut number = Self::from(if start == 0 { x.value } else { 0.0 });
                number.slopes[start..start + count].copy_from_slice(&x.slopes[..count]);
                number
            };
            let of_few = zones
                .clone()
                .map(|(parts, strips)| (parts.map(few), strips.map(move |strip| strip.map(few))));
            model.moving.solve_zones(of_few, few(poisson_ratio), model.differences);
            each(&mut model.moving.resultants().map(|resultant| Resultant {
                moments: resultant.moments.map(|moments| moments.map(back)),
                slip_share: if start == 0 { resultant.slip_share } else { 0.0 },
            }));
        }
    }
}

impl MarchNumber for Taped {
    fn march_strips(
        model: &mut CoupledMarches,
        zones: impl Iterator<Item = (ZoneParts<Self>, impl Iterator<Item = Strip<Self>>)> + Clone,
        poisson_ratio: Self,
        mut each: impl FnMut(&mut dyn Iterator<Item = Resultant<Self>>),
    ) {
        let most = model.plain.most_strips();
        let solver = model.taped.get_or_insert_with(|| Box::new(Solver::new(most)));
        solver.solve_zones(zones, poisson_ratio, model.differences);
        each(&mut solver.resultants().copied());
    }
}

/// The same creepage in other numbers.
fn in_numbers<T: Real, O: Real>(creepage: Creepage<T>, to: impl Fn(T) -> O) -> Creepage<O> {
    let Creepage { longitudinal, lateral, spin } = creepage;
    Creepage { longitudinal: to(longitudinal), lateral: to(lateral), spin: to(spin) }
}

impl<T: Real> Strip<T> {
    /// The same in other numbers.
    fn map<O: Real>(&self, to: impl Fn(T) -> O) -> Strip<O> {
        Strip {
            y: to(self.y),
            half_length: to(self.half_length),
            width: to(self.width),
            limit: to(self.limit),
            shear_modulus: to(self.shear_modulus),
            creepage: in_numbers(self.creepage, &to),
            load: to(self.load),
            left: to(self.left),
        }
    }
}

impl<T: Real> ZoneParts<T> {
    /// The same in other numbers.
    fn map<O: Real>(&self, to: impl Fn(T) -> O) -> ZoneParts<O> {
        let part = |part: LoadedPart<T>| LoadedPart {
            share: to(part.share),
            ellipse: EquivalentEllipse {
                along: to(part.ellipse.along),
                across: to(part.ellipse.across),
            },
            creepage: in_numbers(part.creepage, &to),
            friction: to(part.friction),
        };
        ZoneParts {
            limit: to(self.limit),
            apart: to(self.apart),
            parts: self.parts.map(|of| of.map(part)),
        }
    }
}
