//! Half of a wheelset on rails with a mass, under two masters.

use crate::common::wheel::{element, evaluate, rolling};
use wheelrail::element::parameters::{Foundation, FoundationModel, NormalModel};
use wheelrail::element::{Element, Input, Output, Parameters};

const MASS: f64 = 700.0;
const LOAD: f64 = 5e4;

/// How the master moves the wheel over a step.
#[derive(Clone, Copy, Debug)]
enum Master {
    /// The force of the beginning is held.
    Held,
    /// The force goes with the wheel by its exact derivatives, on rails that stay (rule of the
    /// trapezoid).
    Implicit,
}

struct Bounce {
    element: Element,
    input: Input,
    rest: f64,
}

impl Bounce {
    fn new() -> Self {
        let foundation = Foundation { model: FoundationModel::Mass, ..Foundation::default() };
        let parameters =
            Parameters { foundation, normal_model: NormalModel::Hertz, ..Parameters::default() };
        let massless = Foundation { model: FoundationModel::Massless, ..foundation };
        let mut resting = element(&Parameters { foundation: massless, ..parameters.clone() });
        let mut input = rolling(0.0, 20.0);
        let touching = resting.touching_height(&input);
        let (mut low, mut high) = (touching, touching + 3e-3);
        for _ in 0..60 {
            let z = 0.5 * (low + high);
            input.wheel.position[2] = z;
            let is_high = -evaluate(&mut resting, &input).wheel.force[2] < LOAD;
            *if is_high { &mut low } else { &mut high } = z;
        }
        let rest = low;
        input.wheel.position[2] = rest;
        let mut element = element(&parameters);
        // The rails rest under the wheel at rest; then it is lifted by 20 um.
        element.move_rails(&input, &input, 0.0).unwrap();
        input.wheel.position[2] -= 2e-5;
        Self { element, input, rest }
    }

    fn step(&mut self, master: Master, h: f64) {
        let force = evaluate(&mut self.element, &self.input).wheel.force[2] + LOAD;
        let mut slopes = [0.0; 2];
        if let Master::Implicit = master {
            for (k, slope) in slopes.iter_mut().enumerate() {
                let mut direction = Input::at_rest();
                let wheel = &mut direction.wheel;
                *[&mut wheel.position[2], &mut wheel.velocity[2]][k] = 1.0;
                let mut rates = Output::default();
                self.element.directional_derivative(&self.input, &direction, &mut rates).unwrap();
                *slope = rates.wheel.force[2];
            }
        }
        let v = self.input.wheel.velocity[2];
        let change = h * (force + 0.5 * h * slopes[0] * v)
            / (MASS - 0.5 * h * slopes[1] - 0.25 * h * h * slopes[0]);
        let mut next = self.input;
        next.wheel.velocity[2] += change;
        next.wheel.position[2] += h * (v + 0.5 * change);
        let parts = (h / 1e-4).ceil().max(1.0);
        let mut from = self.input;
        for part in 1..=parts as u32 {
            let mut to = next;
            let share = f64::from(part) / parts;
            let between = |a: f64, b: f64| a + share * (b - a);
            let (wheel, end) = (&self.input.wheel, &next.wheel);
            to.wheel.position[2] = between(wheel.position[2], end.position[2]);
            to.wheel.velocity[2] = between(v, end.velocity[2]);
            self.element.move_rails(&from, &to, h / parts).unwrap();
            from = to;
        }
        self.input = next;
    }
}

/// Heights over the place at rest in steps of `h` up to 0.1 s [m].
fn heights(master: Master, h: f64) -> Vec<f64> {
    let mut bounce = Bounce::new();
    let steps = (0.1 / h).round() as u32;
    let mut step = |_| {
        bounce.step(master, h);
        bounce.input.wheel.position[2] - bounce.rest
    };
    (0..steps).map(&mut step).collect()
}

fn greatest(heights: &[f64]) -> f64 {
    heights.iter().fold(0.0, |most, height| most.max(height.abs()))
}

#[test]
fn exact_derivatives_on_rails_that_stay_make_a_master_stable_at_any_step() {
    for h in [1e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2] {
        let found = heights(Master::Implicit, h);
        let end = greatest(&found[found.len() - found.len() / 10 - 1..]);
        println!("implicit {h}: {:e} {end:e}", greatest(&found));
        // Half a millimetre of track has been sprung by 20 um.
        assert!(greatest(&found) < 1e-4 && end < 2e-5, "{h}: {end:e}");
    }
}

#[test]
fn held_forces_are_stable_with_damping_and_both_masters_come_to_the_same_from_both_sides() {
    // After one swing there and back.
    let at = |master: Master, h: f64| heights(master, h)[(0.01 / h).round() as usize - 1];
    let steps = [1e-4, 5e-5, 2.5e-5];
    let [held, implicit] =
        [Master::Held, Master::Implicit].map(|master| steps.map(|h| at(master, h)));
    println!("{held:?} {implicit:?}");
    let between = |k: usize| held[k] - implicit[k];
    // Of first order in the step of the master, whose motion the rails hear of a step late.
    for k in 0..2 {
        assert!((between(k) / between(k + 1) - 2.0).abs() < 0.3, "{held:?} {implicit:?}");
    }
    let found = heights(Master::Held, 5e-4);
    assert!(greatest(&found) < 1e-4 && found[found.len() - 1].abs() < 1e-6, "{found:?}");
}
