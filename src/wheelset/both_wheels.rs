//! The balance of both wheels of an axle under given loads.
//!
//! Unknowns are the height and the roll of the wheelset and what those of each wheel by itself are
//! besides its height: normal force and lateral deflection of rails without mass.

use nalgebra::{SMatrix, SVector};

use super::{Input, LEFT, RIGHT};
use crate::element::{Balance, Carried, Placed, PosedWheel};
use crate::math::broyden::Broyden;

/// Balances of both wheels, solved together.
pub struct BothWheels {
    balances: [Balance; 2],
    search: Broyden<6>,
    /// Distance of the markers [m].
    between: f64,
    /// Both wheels at the pose before the last one.
    before: Option<[Placed; 2]>,
    last: [Placed; 2],
}

impl BothWheels {
    /// From a first pose of both at the wheelset of `input`, whose `markers` are so far to the right
    /// [m].
    pub fn at(input: &Input, markers: [f64; 2], posed: &[PosedWheel; 2]) -> Self {
        let balances = posed.each_ref().map(PosedWheel::balance);
        let between = markers[RIGHT] - markers[LEFT];
        let ways = [RIGHT, LEFT].map(|k| (markers[k] - posed[k].down_with_roll) / between);
        let unknowns = unknowns(&balances, input, between, posed);
        let search = Broyden::new(matrix(&balances, ways), unknowns, residuals(&balances));
        let last = posed.each_ref().map(|posed| posed.placed);
        Self { balances, search, between, before: None, last }
    }

    /// Takes over what another pose of both tells.
    pub fn take(&mut self, input: &Input, posed: &[PosedWheel; 2]) {
        self.before = Some(self.last);
        self.last = posed.each_ref().map(|posed| posed.placed);
        for (balance, posed) in self.balances.iter_mut().zip(posed) {
            balance.take(&posed.placed, posed.about.aside);
        }
        let unknowns = unknowns(&self.balances, input, self.between, posed);
        self.search.take(unknowns, residuals(&self.balances));
    }

    /// Greatest residual at the last pose, over loads and their depths [-].
    pub fn left(&self) -> f64 {
        residuals(&self.balances).amax()
    }

    /// How far all forces of wheel `k` have to go on beyond the last pose, over what changed from the
    /// one before to it, for its load to be carried; nothing where both do not tell.
    pub fn further(&self, k: usize) -> Option<f64> {
        self.balances[k].further(&self.before?[k])
    }

    /// Puts the wheelset of `input` where nothing would be left, and what is then known of both
    /// wheels but for their heights; the greatest step to there but for
    /// deflections, over loads and their depths [-].
    pub fn next(&self, input: &mut Input, about: &mut [Carried; 2]) -> Option<f64> {
        let [next, step] = self.search.next()?;
        let depth = self.balances[RIGHT].depth();
        input.wheelset.position[2] = next[0] * depth;
        input.wheelset.roll = next[1] * depth / self.between;
        for k in [RIGHT, LEFT] {
            about[k] = self.balances[k].carried([0.0, next[2 + k], next[4 + k]]);
        }
        Some(step.fixed_rows::<4>(0).amax())
    }
}

/// Height and roll of the wheelset, normal forces and deflections of both sides.
fn unknowns(
    balances: &[Balance; 2],
    input: &Input,
    between: f64,
    posed: &[PosedWheel; 2],
) -> SVector<f64, 6> {
    let [right, left] = [RIGHT, LEFT].map(|k| balances[k].unknowns(&posed[k].tried()));
    let depth = balances[RIGHT].depth();
    let [_, _, z] = input.wheelset.position;
    let turned = input.wheelset.roll * between;
    [z / depth, turned / depth, right[1], left[1], right[2], left[2]].into()
}

/// What is left of both balances.
fn residuals(balances: &[Balance; 2]) -> SVector<f64, 6> {
    let [right, left] = balances.each_ref().map(Balance::left);
    [right[0], left[0], right[1], left[1], right[2], left[2]].into()
}

/// What a step of the unknowns takes off the residuals, where markers go down with the roll by
/// `ways` over their distance, against the places of contact [-].
fn matrix(balances: &[Balance; 2], ways: [f64; 2]) -> SMatrix<f64, 6, 6> {
    let mut matrix = SMatrix::<f64, 6, 6>::zeros();
    for k in [RIGHT, LEFT] {
        let scale = balances[RIGHT].depth() / balances[k].depth();
        for (i, row) in balances[k].matrix().iter().enumerate() {
            let mut of_both = matrix.row_mut(2 * i + k);
            of_both[0] = row[0] * scale;
            of_both[1] = row[0] * scale * ways[k];
            of_both[2 + k] = row[1];
            of_both[4 + k] = row[2];
        }
    }
    matrix
}
