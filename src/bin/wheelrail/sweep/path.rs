//! The element along a path of inputs, and what is to be said of each of its outputs.

use anyhow::Result;
use wheelrail::element::{Element, Input};
use wheelrail::variables::{Causality, VARIABLES, Value, Values, Variable};

/// Steps that are looked at closely, for each output.
const SUSPECTS: usize = 4;
/// How often such a step is halved: down to rounding.
const HALVINGS: u32 = 48;
/// Changes below this share of the largest value are rounding.
const ROUNDING: f64 = 1e-12;

/// What was found of one output.
pub struct Found {
    /// The output.
    pub variable: &'static Variable,
    /// Its largest value, without sign.
    pub largest: f64,
    /// Median second difference from step to step, where it changes, over the largest value.
    pub roughness: f64,
    /// Largest jump over the largest value.
    pub jump: f64,
    /// Where that is, in rows from 1.
    pub at: f64,
}

/// An element and the path of its input.
pub struct Path {
    /// The element.
    pub element: Element,
    /// The rows of the table.
    pub corners: Vec<Values>,
    /// Where it is.
    pub values: Values,
    /// What is looked at.
    pub outputs: Vec<&'static Variable>,
}

impl Path {
    /// The outputs at `place`, from 0 at the first row.
    pub fn at(&mut self, place: f64) -> Result<Vec<f64>> {
        let last = self.corners.len() - 2;
        let leg = (place.floor() as usize).min(last);
        let share = place - leg as f64;
        let (from, to) = (&self.corners[leg].input, &self.corners[leg + 1].input);
        self.values.input = between(&self.values, from, to, share);
        self.element.evaluate(&self.values.input, &mut self.values.output)?;
        let read = self.outputs.iter().map(|variable| match self.values.get(variable) {
            Value::Real(value) => value,
            _ => 0.0,
        });
        Ok(read.collect())
    }

    /// Largest value, roughness and jump of one output; none if it stays what it is.
    pub fn examine(
        &mut self,
        output: usize,
        history: &[Vec<f64>],
        steps: usize,
    ) -> Result<Option<Found>> {
        let value = |i: usize| history[i][output];
        let largest = history.iter().map(|row| row[output].abs()).fold(0.0, f64::max);
        let change = |i: usize| value(i + 1) - value(i);
        let count = history.len() - 1;
        if (0..count).all(|i| change(i).abs() <= ROUNDING * largest) {
            return Ok(None);
        }
        // Where it rests, as on a lifted wheel, there is nothing to be rough.
        let mut bends: Vec<f64> = (1..count)
            .filter(|&i| change(i).abs() > 0.0)
            .map(|i| (change(i) - change(i - 1)).abs() / largest)
            .collect();
        // How much a step stands out from its neighbours.
        let stands_out = |i: usize| {
            let neighbours = change(i.max(1) - 1) + change((i + 1).min(count - 1));
            (change(i) - 0.5 * neighbours).abs()
        };
        let mut suspects: Vec<usize> = (0..count).collect();
        suspects.sort_by(|&a, &b| stands_out(b).total_cmp(&stands_out(a)));
        let (mut jump, mut at) = (0.0, 0.0);
        for &step in suspects.iter().take(SUSPECTS) {
            let (size, place) = self.halve(output, step, steps)?;
            if size > jump {
                (jump, at) = (size, place);
            }
        }
        bends.sort_by(f64::total_cmp);
        let roughness = bends.get(bends.len() / 2).copied().unwrap_or_default();
        let jump = if jump > ROUNDING * largest { jump / largest } else { 0.0 };
        let variable = self.outputs[output];
        Ok(Some(Found { variable, largest, roughness, jump, at: at + 1.0 }))
    }

    /// What is left of the change of an output over one step when its half with the larger change
    /// is kept, again and again; and where.
    fn halve(&mut self, output: usize, step: usize, steps: usize) -> Result<(f64, f64)> {
        let place = |i: usize| i as f64 / steps as f64;
        let (mut from, mut to) = (place(step), place(step + 1));
        let (mut low, mut high) = (self.at(from)?[output], self.at(to)?[output]);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (from + to);
            if middle <= from || middle >= to {
                break;
            }
            let value = self.at(middle)?[output];
            if (value - low).abs() > (high - value).abs() {
                (to, high) = (middle, value);
            } else {
                (from, low) = (middle, value);
            }
        }
        Ok(((high - low).abs(), from))
    }
}

/// The input `share` of the way from one to another.
fn between(values: &Values, from: &Input, to: &Input, share: f64) -> Input {
    let [mut a, mut b] = [values.clone(), values.clone()];
    (a.input, b.input) = (*from, *to);
    let mut between = a.clone();
    for variable in VARIABLES.iter().filter(|v| v.causality == Causality::Input) {
        if let (Value::Real(low), Value::Real(high)) = (a.get(variable), b.get(variable)) {
            let value = if share >= 1.0 { high } else { low + share * (high - low) };
            // Between two admitted values all are admitted.
            let _ = between.set(variable, Value::Real(value));
        }
    }
    between.input
}
