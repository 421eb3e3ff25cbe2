//! Derivatives backwards: of one weighted sum of the outputs by all that it depends on.
//!
//! As forwards, searches go by plain numbers, and what they found moves as its equations tell; all
//! the rest is evaluated once more, on a tape ([`Tape`]). One sweep back along it then gives the
//! derivatives by everything at once.

use super::derivative_memory::AdjointMemory;
use super::derivatives::{Height, WAVES, at_this_input};
use super::gradient::{Back, Gradient};
use super::input::{HEIGHT, INPUTS, Input, LOAD, PLACES, move_all};
use super::output::Output;
use super::quasi_static_rails::solve;
use super::rail::moving_contact::Kink;
use super::wheel_on_rails::Element;
use crate::error::ContactError;
use crate::geometry::curves::knot_slopes::KnotSlopes;
use crate::leaves;
use crate::math::numbers::Numbers;
use crate::math::tape::{Tape, Taped};

const _: () = assert!(leaves::INPUTS as usize == INPUTS);

impl Element {
    /// The derivatives of Σ weight · output by all that the outputs depend on, into `gradient`:
    /// with the Jacobian J of the outputs, Jᵀ · weights, for the price of a few evaluations however
    /// many numbers these are. Counts and wear have none.
    ///
    /// They are those of [`jacobian`](Self::jacobian), and by much more. The first calls allocate,
    /// as much as the longest of them needs. The element is left as it was.
    ///
    /// # Errors
    /// The input at fault, by its FMU name, or [`ContactError::NoDerivative`], where there are none
    /// forwards; `gradient` is then as before.
    pub fn adjoint_derivative(
        &mut self,
        input: &Input,
        weights: &Output,
        gradient: &mut Gradient,
    ) -> Result<(), ContactError> {
        let input = self.admitted(input)?;
        self.check_models()?;
        if self.models.uneven.is_some() {
            // Of the parameters, on some of which places on the waves hang.
            let reason = "backwards they are there for bodies that are even along the track";
            return Err(ContactError::NoDerivative { name: Some(WAVES), reason });
        }
        let weights = self.side.mirror(*weights);
        let mut memory = self.backwards.take().unwrap_or_else(|| self.adjoint_memory());
        let found = self.carried_at(&input).and_then(|at| {
            let back = self.go_back(&at, &weights, &mut memory)?;
            self.look_back(&back, &mut memory, gradient)
        });
        self.backwards = Some(memory);
        found.map_err(at_this_input)?;
        let by_input = gradient.input;
        gradient.parameters.nominal_radius += self.back_to_radius(&input, &by_input);
        let by_input = self.rolling.map_or(by_input, |rolling| rolling.back_to_turning(by_input));
        gradient.input = self.side.mirror(by_input);
        Ok(())
    }

    /// Brings what the last sweep has found to the inputs, parameters and profiles of a right wheel.
    fn look_back(
        &self,
        back: &Back,
        memory: &mut AdjointMemory,
        gradient: &mut Gradient,
    ) -> Result<(), Kink> {
        let AdjointMemory { tape, wheel, rails, .. } = memory;
        let contacts = self.rails.each_ref().map(Option::as_ref);
        if let Some(contact) = contacts.iter().flatten().next() {
            wheel.clear(&contact.wheel.curve);
        }
        for (contact, knots) in contacts.iter().zip(rails.iter_mut()) {
            if let Some(contact) = contact {
                knots.clear(contact.rail.curve());
            }
        }
        for (look, by) in tape.looks() {
            for (contact, knots) in contacts.iter().zip(rails.iter_mut()) {
                let Some(contact) = contact else { continue };
                let (own, under) = (&contact.wheel.curve, contact.rail.curve());
                if let Some(piece) = own.number_at(look.piece) {
                    wheel.add(own, piece, look.distance, by);
                } else if let Some(piece) = under.number_at(look.piece) {
                    knots.add(under, piece, look.distance, by);
                }
            }
        }
        self.fill(back, |leaf| tape.slope_of(leaf), (wheel, rails), gradient)
    }

    fn adjoint_memory(&self) -> Box<AdjointMemory> {
        Box::new(AdjointMemory {
            tape: Tape::default(),
            models: self.models.in_other_numbers(self.outline_rows()),
            output: Output::default(),
            seeds: Vec::new(),
            wheel: KnotSlopes::default(),
            rails: Default::default(),
        })
    }

    /// Records the outputs of a right wheel `at` an input and goes back from them; leaves the
    /// derivatives on the tape.
    fn go_back(
        &mut self,
        at: &(Input, Height),
        weights: &Output,
        memory: &mut AdjointMemory,
    ) -> Result<Back, Kink> {
        let (input, height) = at;
        let values = input.to_array();
        let input =
            Input::from_array(std::array::from_fn(|i| Taped::leaf(values[i], leaves::input(i))));
        let AdjointMemory { tape, models, output, seeds, .. } = memory;
        if let Some(follower) = &mut models.strip_follower {
            follower.forget();
        }
        seeds.clear();
        if *height == Height::Touching {
            *output = Output::default();
            let deepest = tape.record(leaves::COUNT, || self.deepest(&input, models))?;
            let mut by_input = [0.0; INPUTS];
            let Some(deepest) = deepest else {
                by_input[HEIGHT] = weights.wheel_z;
                return Ok(Back { by_input, ..Back::default() });
            };
            // The contact stays one point.
            seeds.push((deepest, 1.0));
            let by_height = memory.sweep(true, [0.0; 2])[HEIGHT];
            memory.seeds[0].1 = -weights.wheel_z / by_height;
            by_input = memory.sweep(true, [0.0; 2]);
            by_input[HEIGHT] = 0.0;
            return Ok(Back { by_input, ..Back::default() });
        }
        tape.record(leaves::COUNT, || self.moving_forces(&input, models, output))?;
        output.each_with(weights, &mut |number, weight| seeds.push((number, weight)));
        seeds.retain(|(_, weight)| *weight != 0.0);
        let is_loaded = *height == Height::Loaded;
        let gives_way = self.rails_at().is_none();
        let mut by_input = memory.sweep(true, [0.0; 2]);
        if !(is_loaded || gives_way) {
            return Ok(Back { by_input, ..Back::default() });
        }
        let by_z = memory.sweep(false, [0.0, 1.0]);
        // By the inputs as the height follows the load.
        let following = |own: &[f64; INPUTS]| {
            let mut own = *own;
            if is_loaded {
                let share = -own[HEIGHT] / by_z[HEIGHT];
                own.iter_mut().zip(&by_z).for_each(|(own, by)| *own += share * by);
            }
            own
        };
        let (mut forces, mut by_stiffness) = ([0.0; 2], [0.0; 2]);
        if gives_way {
            let stiffness = self.foundation.stiffness;
            let rows = [memory.sweep(false, [1.0, 0.0]), by_z].map(|row| following(&row));
            let pulled = following(&by_input);
            let ways = PLACES.map(|place| {
                let mut way = [0.0; INPUTS];
                move_all(&mut way, place, 1.0);
                way
            });
            let along = |row: &[f64; INPUTS], j: usize| -> f64 {
                row.iter().zip(&ways[j]).map(|(by, way)| by * way).sum()
            };
            // The transposed matrix of the forces by where the rails are.
            let matrix = [0, 1].map(|j| {
                [0, 1].map(|i| {
                    // A wheel under a given load follows the height of its rails.
                    let slope = if is_loaded && j == 1 { 0.0 } else { -along(&rows[i], j) };
                    f64::from(u8::from(i == j)) - slope / stiffness[i]
                })
            });
            let right = [0, 1].map(|j| along(&pulled, j) + weights.foundation.deflection[j]);
            let share = solve(matrix, right).ok_or("the rails find no hold")?;
            forces = [0, 1].map(|i| -share[i] / stiffness[i]);
            // Springs give way by the force over their stiffness.
            let [_, y, z] = memory.output.wheel.force.map(|force| force.value);
            by_stiffness = [y, z].map(|force| -force);
            for i in 0..2 {
                by_stiffness[i] *= -share[i] / (stiffness[i] * stiffness[i]);
            }
            by_input = memory.sweep(true, forces);
        }
        if is_loaded {
            let share = -by_input[HEIGHT] / by_z[HEIGHT];
            forces[1] += share;
            by_input = memory.sweep(true, forces);
            by_input[LOAD] += share;
            by_input[HEIGHT] = 0.0;
        }
        Ok(Back { by_input, by_stiffness })
    }
}
