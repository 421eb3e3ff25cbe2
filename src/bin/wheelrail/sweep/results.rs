//! What a sweep leaves: a table of jumps, the history, a figure.

use std::path::Path;

use anyhow::Result;
use wheelrail::variables::Variable;

use super::path::Found;
use crate::figures::sweep::{self as figure, Curve};
use crate::output;

/// Jumps below this share of the largest value are not marked in figures.
const MIN_MARKED_JUMP: f64 = 1e-9;

/// What one value of the parameter that is varied gave.
pub struct Swept {
    /// That value; empty where none is varied.
    pub name: String,
    /// The outputs at each step.
    pub history: Vec<Vec<f64>>,
    /// What was found of them.
    pub found: Vec<Found>,
}

/// All that was swept.
pub struct Results<'a> {
    /// The parameter that is varied.
    pub varied: Option<&'a str>,
    /// The outputs in the order of the histories.
    pub outputs: Vec<&'static Variable>,
    /// What each value gave.
    pub swept: Vec<Swept>,
    /// Steps from one row to the next.
    pub steps: usize,
}

impl Results<'_> {
    /// Place on the path of a step, in rows from 1.
    fn place(&self, step: usize) -> f64 {
        1.0 + step as f64 / self.steps as f64
    }

    /// Writes a row for each output that changes.
    pub fn write(&self, destination: Option<&Path>) -> Result<()> {
        let table = output::table(destination)?;
        let columns = ["output", "unit", "largest", "roughness", "jump", "at"];
        table.write_record(self.varied.into_iter().chain(columns))?;
        for Swept { name, found, .. } in &self.swept {
            for row in found {
                let at = if row.jump > 0.0 { format!("{:.9}", row.at) } else { String::new() };
                let cells = [
                    row.variable.name.to_owned(),
                    row.variable.unit.to_owned(),
                    format!("{:.6e}", row.largest),
                    format!("{:.2e}", row.roughness),
                    format!("{:.2e}", row.jump),
                    at,
                ];
                table.write_record(self.varied.map(|_| name.clone()).into_iter().chain(cells))?;
            }
        }
        table.finish()
    }

    /// Writes every step.
    pub fn write_history(&self, file: &Path) -> Result<()> {
        let table = output::table(Some(file))?;
        let names = ["at"].into_iter().chain(self.outputs.iter().map(|v| v.name));
        table.write_record(self.varied.into_iter().chain(names))?;
        for Swept { name, history, .. } in &self.swept {
            for (step, row) in history.iter().enumerate() {
                let at = self.place(step);
                let cells = [at].into_iter().chain(row.iter().copied()).map(|v| format!("{v:?}"));
                table.write_record(self.varied.map(|_| name.clone()).into_iter().chain(cells))?;
            }
        }
        table.finish()
    }

    /// Draws forces along the path.
    pub fn draw(&self, file: &Path) -> Result<()> {
        let curve = |swept: &Swept, output: &str, name: String| {
            let column = self.outputs.iter().position(|v| v.name == output);
            let drawn = |f: &&Found| f.variable.name == output && f.jump > MIN_MARKED_JUMP;
            let jump = swept.found.iter().find(drawn);
            Curve {
                name,
                points: (swept.history.iter().enumerate())
                    .filter_map(|(i, row)| Some((self.place(i), row[column?])))
                    .collect(),
                jump: jump.map(|f| (f.at, f.jump)),
            }
        };
        let panels: Vec<(String, Vec<Curve>)> = if let Some(varied) = self.varied {
            let axes = ["x", "y", "z"].into_iter();
            axes.map(|axis| {
                let output = format!("wheel.force.{axis}");
                let curves = self.swept.iter().map(|s| curve(s, &output, s.name.clone())).collect();
                (format!("{output} [N] by {varied}"), curves)
            })
            .collect()
        } else {
            let forces = ["x", "y", "z"].map(|axis| format!("wheel.force.{axis}"));
            let patches = [1, 2, 3].map(|k| format!("patch[{k}].normal_force"));
            [
                ("Force on the wheel [N]", forces),
                ("Normal force of the heaviest patches [N]", patches),
            ]
            .map(|(title, names)| {
                let curves = names.map(|name| curve(&self.swept[0], &name, name.clone()));
                (title.to_owned(), curves.into())
            })
            .into()
        };
        figure::draw(file, &panels)
    }
}
