//! Rails with a mass, which run along with the wheel: their motion over a step.
//!
//! ```text
//! m d'' = F(t, d, d') - K d - C d'
//! ```
//!
//! A Rosenbrock method of two stages (ROS2: Verwer, Spee, Blom and Hundsdorfer, SIAM Journal on
//! Scientific Computing 20 (1999) 1456) with the exact derivatives of the contact forces, by the
//! inputs too: second order, and stable whatever the stiffness of contact and pads (L-stable), so
//! that swings that a step is too long for die out in it.
//!
//! ```text
//! (1 - γhJ) k1 = f(t, u) + γh f_t,   (1 - γhJ) k2 = f(t + h, u + h k1) - 2 k1 - γh f_t,   u' = u + h (3 k1 + k2)/2,   γ = 1 - 1/√2
//! ```
//!
//! Other derivatives, as of models that have none, cost accuracy in stiff motions and no order. The
//! step from k1 alone is one of first order: what it differs by is the estimated error.

use super::derivative_memory::DIRECTIONS;
use super::derivatives::Height;
use super::input::{INPUTS, Input, PLACES, VELOCITIES, move_all};
use super::output::Output;
use super::parameters::FoundationModel;
use super::parameters::foundation::TrackState;
use super::quasi_static_rails::solve;
use super::steps::check_duration;
use super::wheel_on_rails::Element;
use crate::error::ContactError;
use crate::math::real::Real;

/// γ of the method, 1 - 1/√2: the smaller one of the two with which it is L-stable.
const GAMMA: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;

/// Forces on the rails and how they change: by place, by velocity (rows are forces), and with the
/// inputs in time.
#[derive(Clone, Copy, Debug, Default)]
struct Response {
    force: [f64; 2],
    by_place: [[f64; 2]; 2],
    by_velocity: [[f64; 2]; 2],
    in_time: [f64; 2],
}

/// Place and velocity of the rails, or rates of both.
#[derive(Clone, Copy, Debug)]
struct Motion {
    place: [f64; 2],
    velocity: [f64; 2],
}

impl Motion {
    /// What comes of adding `share` of `other`.
    fn plus(&self, share: f64, other: &Self) -> Self {
        Self {
            place: [0, 1].map(|i| self.place[i] + share * other.place[i]),
            velocity: [0, 1].map(|i| self.velocity[i] + share * other.velocity[i]),
        }
    }
}

impl Element {
    /// Where rails with a mass are since their first step; before it they rest in equilibrium.
    pub fn track_state(&self) -> Option<TrackState> {
        self.track
    }

    /// Goes back to an earlier [`track_state`](Self::track_state).
    pub fn set_track_state(&mut self, state: Option<TrackState>) {
        self.track = state;
    }

    /// Whether the rails have a mass.
    pub fn has_moving_rails(&self) -> bool {
        self.foundation.model == FoundationModel::Mass
    }

    /// Longest step in which a unit moves rails with a mass on [s].
    pub fn longest_step(&self) -> f64 {
        self.foundation.longest_step
    }

    /// Moves rails with a mass on over a step of `duration` ≥ 0 [s], during which the inputs go
    /// from `from` straight to `to`; other rails stay. The error of the new deflection is of third
    /// order in the duration, estimated in [`TrackState::step_error`].
    ///
    /// ```
    /// use wheelrail::element::parameters::{Foundation, FoundationModel};
    /// use wheelrail::element::{Element, Input, Output, Parameters};
    ///
    /// let foundation = Foundation { model: FoundationModel::Mass, ..Foundation::default() };
    /// let mut input = Input::default();
    /// let mut element = Element::new(&Parameters { foundation, ..Parameters::default() }, &input, &[])?;
    /// input.wheel.position[2] = element.nominal_wheel_z() + 1e-3;
    /// // A wheel that stands leaves the rails where they rest.
    /// element.move_rails(&input, &input, 1e-3)?;
    /// let mut output = Output::default();
    /// element.evaluate(&input, &mut output)?;
    /// let sunk = output.foundation.deflection[1];
    /// assert!((7e7 * sunk + output.wheel.force[2]).abs() < 1.0);
    /// # Ok::<(), wheelrail::error::ContactError>(())
    /// ```
    ///
    /// # Errors
    /// The input at fault, by its FMU name, or a duration that is negative or not finite; the rails
    /// are then where they were.
    pub fn move_rails(
        &mut self,
        from: &Input,
        to: &Input,
        duration: f64,
    ) -> Result<(), ContactError> {
        let [from, to] = [self.admitted(from)?, self.admitted(to)?];
        check_duration(duration)?;
        if !self.has_moving_rails() {
            return Ok(());
        }
        let [from, to] = [from, to].map(|input| self.side.mirror(input));
        let state = self.track.unwrap_or_else(|| self.rest_at(&from));
        self.track = Some(state);
        if duration > 0.0 {
            match self.moved_on(&state, &from, &to, duration) {
                Some(state) => self.track = Some(state),
                // Beyond all numbers the rails stay, and that counts.
                None => self.fallbacks += 1,
            }
        }
        Ok(())
    }

    /// Where the rails rest under `input` (right side).
    fn rest_at(&mut self, input: &Input) -> TrackState {
        let mut output = Output::default();
        self.fallbacks += self.respond(&mut input.clone(), &mut output);
        TrackState { deflection: output.foundation.deflection, ..TrackState::default() }
    }

    /// The state a step later; nothing where it leaves the range of numbers.
    fn moved_on(
        &mut self,
        state: &TrackState,
        from: &Input,
        to: &Input,
        duration: f64,
    ) -> Option<TrackState> {
        let start = Motion { place: state.deflection, velocity: state.velocity };
        let response = self.rail_response(&start, from, to, duration);
        let (share, mass) = (GAMMA * duration, self.foundation.mass);
        let at_start = self.rates(&start, response.force);
        let ahead = [0, 1].map(|i| share * response.in_time[i] / mass);
        let first = self.stage(
            &response,
            share,
            &Motion { velocity: [0, 1].map(|i| at_start.velocity[i] + ahead[i]), ..at_start },
        )?;
        let beyond = start.plus(duration, &first);
        let force = self.rail_force(&beyond, to);
        let at_end = self.rates(&beyond, force);
        let rest = at_end.plus(-2.0, &first);
        let second = self.stage(
            &response,
            share,
            &Motion { velocity: [0, 1].map(|i| rest.velocity[i] - ahead[i]), ..rest },
        )?;
        let end = start.plus(1.5 * duration, &first).plus(0.5 * duration, &second);
        let error = [0, 1].map(|i| end.place[i] - beyond.place[i]);
        let state = TrackState {
            deflection: end.place,
            velocity: end.velocity,
            step_error: error[0].hypotenuse(error[1]),
        };
        let all = end.place.iter().chain(&end.velocity);
        all.into_iter().all(|x| x.is_finite()).then_some(state)
    }

    /// Velocity and acceleration of the rails under a contact `force`.
    fn rates(&self, at: &Motion, force: [f64; 2]) -> Motion {
        let own = &self.foundation;
        let pull = |i: usize| own.stiffness[i] * at.place[i] + own.damping[i] * at.velocity[i];
        let velocity = [0, 1].map(|i| (force[i] - pull(i)) / own.mass);
        Motion { place: at.velocity, velocity }
    }

    /// Solves (1 - γhJ) k = `right` for k, γh being the `share`.
    fn stage(&self, response: &Response, share: f64, right: &Motion) -> Option<Motion> {
        let own = &self.foundation;
        let of = |slopes: &[[f64; 2]; 2], ground: &[f64; 2], i: usize, j: usize| {
            (slopes[i][j] - if i == j { ground[i] } else { 0.0 }) / own.mass
        };
        let spring = |i: usize, j: usize| of(&response.by_place, &own.stiffness, i, j);
        let damper = |i: usize, j: usize| of(&response.by_velocity, &own.damping, i, j);
        let matrix = [0, 1].map(|i| {
            [0, 1].map(|j| {
                let one = if i == j { 1.0 } else { 0.0 };
                one - share * (damper(i, j) + share * spring(i, j))
            })
        });
        let sides = [0, 1].map(|i| {
            let [y, z] = [0, 1].map(|j| spring(i, j) * right.place[j]);
            right.velocity[i] + share * (y + z)
        });
        let velocity = solve(matrix, sides)?;
        let place = [0, 1].map(|i| right.place[i] + share * velocity[i]);
        Some(Motion { place, velocity })
    }

    /// Forces of the contacts on rails that move as `at` says.
    fn rail_force(&mut self, at: &Motion, input: &Input) -> [f64; 2] {
        let mut output = Output::default();
        self.forces(&input.with_rails_moved(at.place, at.velocity), &mut output);
        let [_, y, z] = output.wheel.force;
        [-y, -z]
    }

    /// The same with what they change by; exact where there are derivatives.
    fn rail_response(&mut self, at: &Motion, from: &Input, to: &Input, duration: f64) -> Response {
        let input = from.with_rails_moved(at.place, at.velocity);
        let mut directions = [[0.0; INPUTS]; 5];
        for (direction, place) in directions.iter_mut().zip(PLACES.into_iter().chain(VELOCITIES)) {
            move_all(direction, place, 1.0);
        }
        let (start, end) = (from.to_array(), to.to_array());
        directions[4] = std::array::from_fn(|i| (end[i] - start[i]) / duration);
        let mut rates = [[0.0; 2]; DIRECTIONS];
        let exact = self.rail_rates(&(input, Height::Given), &directions, |n, force| {
            rates[n] = force;
        });
        let force = exact.unwrap_or_else(|_| {
            let force = self.rail_force(at, from);
            self.response_by_differences(at, from, force, &mut rates);
            let later = self.rail_force(at, to);
            rates[4] = [0, 1].map(|i| (later[i] - force[i]) / duration);
            force
        });
        let matrix = |n: usize| [0, 1].map(|i| [rates[n][i], rates[n + 1][i]]);
        Response { force, by_place: matrix(0), by_velocity: matrix(2), in_time: rates[4] }
    }

    /// What `force` changes by with the place and the velocity of the rails.
    fn response_by_differences(
        &mut self,
        at: &Motion,
        input: &Input,
        force: [f64; 2],
        rates: &mut [[f64; 2]; DIRECTIONS],
    ) {
        /// Ways of places [m] and of velocities [m/s].
        const STEPS: [f64; 2] = [1e-8, 1e-4];
        for (n, rate) in rates.iter_mut().enumerate().take(4) {
            let mut beside = *at;
            let moved = if n < 2 { &mut beside.place } else { &mut beside.velocity };
            moved[n % 2] += STEPS[n / 2];
            let found = self.rail_force(&beside, input);
            *rate = [0, 1].map(|i| (found[i] - force[i]) / STEPS[n / 2]);
        }
    }
}
