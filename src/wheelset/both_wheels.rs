//! The balance of both wheels of an axle under given loads.
//!
//! Unknowns are those of each wheel by itself. Its height is that of its place of contact: what the
//! roll of the axle does to that is taken off. Heights of both tell that of the axle, and its roll.

use super::{Input, LEFT, RIGHT};
use crate::element::{Balance, Carried, Placed, PosedWheel};

/// Balances of both wheels.
pub struct BothWheels {
    wheels: [Wheel; 2],
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
}

impl BothWheels {
    /// From a first pose of both at the wheelset of `input`, whose `markers` are so far to the right
    /// [m].
    pub fn at(input: &Input, markers: [f64; 2], posed: &[PosedWheel; 2]) -> Self {
        let wheels = posed.each_ref().map(Wheel::at);
        Self { wheels, markers, at: height_and_roll(input), left_before: 0.0 }
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
    }

    /// Greatest residual at the last pose, over loads and their depths [-].
    fn left(&self) -> f64 {
        let left = self.wheels.iter().flat_map(|wheel| wheel.balance.left());
        left.fold(0.0, |greatest, left| left.abs().max(greatest))
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
        let (mut down, mut by_roll, mut most) = ([0.0; 2], [0.0; 2], 0.0_f64);
        for k in [RIGHT, LEFT] {
            let Wheel { balance, height, down_with_roll, .. } = &self.wheels[k];
            let (next, step) = balance.next()?;
            about[k] = next;
            (down[k], by_roll[k]) = (about[k].z - height, self.markers[k] - down_with_roll);
            most = most.max(step);
        }
        let turn = (down[RIGHT] - down[LEFT]) / (by_roll[RIGHT] - by_roll[LEFT]);
        let [z, roll] = self.at;
        input.wheelset.position[2] = z + down[RIGHT] - by_roll[RIGHT] * turn;
        input.wheelset.roll = roll + turn;
        turn.is_finite().then_some(most)
    }
}

/// Height and roll of the wheelset of an input [m, rad].
fn height_and_roll(input: &Input) -> [f64; 2] {
    let [_, _, z] = input.wheelset.position;
    [z, input.wheelset.roll]
}
