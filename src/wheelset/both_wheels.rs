//! The balance of both wheels of an axle under given loads.
//!
//! Unknowns are those of each wheel by itself. Its height is that of its place of contact: what the
//! roll of the axle does to that is taken off. Heights of both tell that of the axle, and its roll.

use nalgebra::{SMatrix, SVector};

use super::{Input, LEFT, RIGHT};
use crate::element::{Balance, Carried, Placed, PosedWheel};
use crate::math::broyden::Broyden;

/// Balances of both wheels, solved together.
pub struct BothWheels {
    wheels: [Wheel; 2],
    search: Broyden<6>,
    /// Places of the markers along the axle [m].
    markers: [f64; 2],
    /// Height and roll of the wheelset at the last pose [m, rad].
    at: [f64; 2],
    /// Greatest residual at the pose before that [-].
    left_before: f64,
}

/// One of both.
struct Wheel {
    balance: Balance,
    /// The pose before the last one.
    before: Option<Placed>,
    /// Height of its marker at the last pose [m].
    marker: f64,
    /// The same less what went down with the roll on the way there [m].
    height: f64,
    /// How far down it may go with the roll there [m].
    down_with_roll: f64,
}

impl Wheel {
    fn at(posed: &PosedWheel) -> Self {
        let &PosedWheel { placed, down_with_roll, .. } = posed;
        let z = placed.z;
        Self { balance: posed.balance(), before: None, marker: z, height: z, down_with_roll }
    }

    /// Takes over another pose, the axle turned by `roll` since the last one.
    fn take(&mut self, roll: f64, posed: &PosedWheel) {
        let &PosedWheel { placed, about, down_with_roll, .. } = posed;
        let mean = 0.5 * (down_with_roll + self.down_with_roll);
        self.height += placed.z - self.marker - mean * roll;
        (self.before, self.marker) = (Some(self.balance.last()), placed.z);
        self.down_with_roll = down_with_roll;
        self.balance.take(&Placed { z: self.height, ..placed }, about.aside);
    }

    /// The unknowns of a pose.
    fn unknowns(&self, posed: &PosedWheel) -> [f64; 3] {
        self.balance.unknowns(&Carried { z: self.height, ..posed.tried() })
    }
}

impl BothWheels {
    /// From a first pose of both at the wheelset of `input`, whose `markers` are so far to the right
    /// [m].
    pub fn at(input: &Input, markers: [f64; 2], posed: &[PosedWheel; 2]) -> Self {
        let wheels = posed.each_ref().map(Wheel::at);
        let mut matrix = SMatrix::<f64, 6, 6>::zeros();
        for (k, wheel) in wheels.iter().enumerate() {
            let own = SMatrix::<f64, 3, 3>::from(wheel.balance.matrix()).transpose();
            matrix.fixed_view_mut::<3, 3>(3 * k, 3 * k).copy_from(&own);
        }
        let search = Broyden::new(matrix, unknowns(&wheels, posed), residuals(&wheels));
        Self { wheels, search, markers, at: height_and_roll(input), left_before: 0.0 }
    }

    /// Takes over what another pose of both tells.
    pub fn take(&mut self, input: &Input, posed: &[PosedWheel; 2]) {
        self.left_before = self.left();
        let [_, before] = self.at;
        self.at = height_and_roll(input);
        let [_, roll] = self.at;
        for (wheel, posed) in self.wheels.iter_mut().zip(posed) {
            wheel.take(roll - before, posed);
        }
        self.search.take(unknowns(&self.wheels, posed), residuals(&self.wheels));
    }

    /// Greatest residual at the last pose, over loads and their depths [-].
    fn left(&self) -> f64 {
        residuals(&self.wheels).amax()
    }

    /// What the next step will leave of that, if it leaves as great a share as the last one.
    pub fn left_next(&self) -> f64 {
        let left = self.left();
        if self.left_before > 0.0 { left * left / self.left_before } else { left }
    }

    /// How far all forces of wheel `k` have to go on beyond the last pose, over what changed from the
    /// one before to it, for its load to be carried; nothing where both do not tell.
    pub fn further(&self, k: usize) -> Option<f64> {
        let wheel = &self.wheels[k];
        wheel.balance.further(&wheel.before?, true)
    }

    /// Puts the wheelset of `input` where nothing would be left, and what is then known of both
    /// wheels but for their heights; the greatest step to there but for
    /// deflections, over loads and their depths [-].
    pub fn next(&self, input: &mut Input, about: &mut [Carried; 2]) -> Option<f64> {
        let [next, step] = self.search.next()?;
        let (mut down, mut by_roll, mut most) = ([0.0; 2], [0.0; 2], 0.0_f64);
        for k in [RIGHT, LEFT] {
            let Wheel { balance, height, down_with_roll, .. } = &self.wheels[k];
            about[k] = balance.carried([0, 1, 2].map(|i| next[3 * k + i]));
            (down[k], by_roll[k]) = (about[k].z - height, self.markers[k] - down_with_roll);
            most = most.max(step.fixed_rows::<2>(3 * k).amax());
        }
        let turn = (down[RIGHT] - down[LEFT]) / (by_roll[RIGHT] - by_roll[LEFT]);
        let [z, roll] = self.at;
        input.wheelset.position[2] = z + down[RIGHT] - by_roll[RIGHT] * turn;
        input.wheelset.roll = roll + turn;
        turn.is_finite().then_some(most)
    }
}

/// Of the right wheel, then of the left one.
fn unknowns(wheels: &[Wheel; 2], posed: &[PosedWheel; 2]) -> SVector<f64, 6> {
    let [right, left] = [RIGHT, LEFT].map(|k| wheels[k].unknowns(&posed[k]));
    SVector::from_iterator(right.into_iter().chain(left))
}

/// What is left of both balances, in the same order.
fn residuals(wheels: &[Wheel; 2]) -> SVector<f64, 6> {
    SVector::from_iterator(wheels.iter().flat_map(|wheel| wheel.balance.left()))
}

/// Height and roll of the wheelset of an input [m, rad].
fn height_and_roll(input: &Input) -> [f64; 2] {
    let [_, _, z] = input.wheelset.position;
    [z, input.wheelset.roll]
}
