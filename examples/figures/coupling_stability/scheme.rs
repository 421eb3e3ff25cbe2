//! How a master carries a mass on the contact over a communication step.

use std::error::Error;

use super::unit::Unit;

/// Half of a wheelset [kg].
pub const MASS: f64 = 700.0;
/// Its weight and what rests on it [N].
pub const LOAD: f64 = 5e4;
/// Steps of the unit in one of [`Scheme::SmallSteps`].
const SMALL_STEPS: u32 = 10;
/// Rounds after which an iteration ends in any case.
const MAX_ROUNDS: u32 = 60;

/// What a master does with the forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scheme {
    /// Holds the force of the step's beginning.
    Held,
    /// The same ten times in a step.
    SmallSteps,
    /// Lets the unit carry the height on with its velocity, and holds the force of the step's end.
    CarriedOn,
    /// Takes the force with its directional derivatives, in the rule of the trapezoid.
    Linearised,
    /// Repeats the step, with rollback, until the mean of the forces at both ends has made the
    /// motion.
    Iterated,
}

pub const SCHEMES: [Scheme; 5] =
    [Scheme::Held, Scheme::SmallSteps, Scheme::CarriedOn, Scheme::Linearised, Scheme::Iterated];

impl Scheme {
    pub fn name(self) -> &'static str {
        match self {
            Self::Held => "held force",
            Self::SmallSteps => "held force, ten small steps",
            Self::CarriedOn => "input derivatives",
            Self::Linearised => "linearly implicit",
            Self::Iterated => "iterated with rollback",
        }
    }

    /// Height [m] and velocity [m/s] after a step of `h` [s].
    pub fn step(
        self,
        unit: &mut Unit,
        start: [f64; 2],
        h: f64,
    ) -> Result<[f64; 2], Box<dyn Error>> {
        match self {
            Self::Held => held(unit, start, h),
            Self::SmallSteps => {
                let small = h / f64::from(SMALL_STEPS);
                (0..SMALL_STEPS).try_fold(start, |motion, _| held(unit, motion, small))
            }
            Self::CarriedOn => {
                unit.place(start)?;
                unit.carry_on(start[1])?;
                unit.step(h)?;
                Ok(moved(start, unit.force()?, h))
            }
            Self::Linearised => {
                unit.place(start)?;
                let force = unit.force()? + LOAD;
                let [by_height, by_velocity] = unit.derivatives()?;
                unit.step(h)?;
                // m Δv = h (F + F_z Δz/2 + F_v Δv/2), Δz = h (v + Δv/2).
                let mass = MASS - 0.5 * h * by_velocity - 0.25 * h * h * by_height;
                let change = h * (force + 0.5 * h * by_height * start[1]) / mass;
                Ok(ended(start, start[1] + change, h))
            }
            Self::Iterated => iterated(unit, start, h),
        }
    }
}

/// Under a constant force.
fn moved([z, v]: [f64; 2], force: f64, h: f64) -> [f64; 2] {
    let acceleration = (force + LOAD) / MASS;
    [z + h * (v + 0.5 * h * acceleration), v + h * acceleration]
}

/// With the mean of the velocities.
fn ended([z, v]: [f64; 2], new: f64, h: f64) -> [f64; 2] {
    [z + 0.5 * h * (v + new), new]
}

fn held(unit: &mut Unit, start: [f64; 2], h: f64) -> Result<[f64; 2], Box<dyn Error>> {
    unit.place(start)?;
    let force = unit.force()?;
    unit.step(h)?;
    Ok(moved(start, force, h))
}

/// Secants on the velocity at the end. What is missing there grows with it, so that there is one
/// answer.
fn iterated(unit: &mut Unit, start: [f64; 2], h: f64) -> Result<[f64; 2], Box<dyn Error>> {
    unit.place(start)?;
    let first = unit.force()?;
    unit.keep()?;
    let missing = |unit: &mut Unit, velocity: f64| -> Result<f64, Box<dyn Error>> {
        unit.step(h)?;
        unit.place(ended(start, velocity, h))?;
        let mean = 0.5 * (first + unit.force()?);
        Ok(velocity - start[1] - h * (mean + LOAD) / MASS)
    };
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut before = start[1];
    let mut error_before = missing(unit, before)?;
    let mut velocity = before - error_before;
    for _ in 0..MAX_ROUNDS {
        unit.go_back(h)?;
        let error = missing(unit, velocity)?;
        if error.abs() <= 1e-12 * (1e-3 + velocity.abs()) {
            break;
        }
        for (place, error) in [(before, error_before), (velocity, error)] {
            if error < 0.0 { low = place.max(low) } else { high = place.min(high) }
        }
        let secant = velocity - error * (velocity - before) / (error - error_before);
        (before, error_before) = (velocity, error);
        let is_between = secant > low && secant < high;
        let middle = 0.5 * (low + high);
        velocity = if is_between || !middle.is_finite() { secant } else { middle };
    }
    Ok(ended(start, velocity, h))
}
