//! Median, 95 % and worst of a set of errors.

use std::fmt::Write as _;

use anyhow::Result;

use super::compared::Compared;
use crate::output::Table;

/// Errors of all cases.
#[derive(Debug, Default)]
pub struct Summary {
    /// Magnitudes of the errors of normal force, pressure, area, creep force and spin moment [%].
    errors: [Vec<f64>; 5],
    /// Estimated errors of the boundary elements in the same quantities [%].
    uncertainties: [Vec<f64>; 5],
    /// Times of the models and of the boundary elements [s].
    times: [Vec<f64>; 2],
    /// How far normals turn within the reference [degrees].
    turns: Vec<f64>,
    /// Cases with more than one patch in the reference.
    separate: usize,
    fallbacks: usize,
}

const QUANTITIES: [&str; 5] = [
    "normal force [%]",
    "greatest pressure [%]",
    "area [%]",
    "creep force [% of friction limit]",
    "spin moment [% of friction limit x sqrt(area/pi)]",
];

impl Summary {
    /// Takes a case.
    pub fn add(&mut self, compared: &Compared) {
        for (errors, error) in self.errors.iter_mut().zip(compared.errors()) {
            errors.extend(error.map(f64::abs));
        }
        for (errors, error) in self.uncertainties.iter_mut().zip(compared.uncertainties()) {
            errors.extend(error);
        }
        self.turns.extend(compared.turn.map(f64::to_degrees));
        self.separate += usize::from(compared.reference.patches > 1);
        self.times[0].push(compared.own.time);
        self.times[1].push(compared.reference.time);
        self.fallbacks += usize::from(compared.own.fallback || compared.reference.fallback);
    }

    /// Quantity, number of cases, median, 95 % and worst.
    fn rows(&self) -> Vec<(String, usize, [f64; 3])> {
        let of = |errors: &[Vec<f64>; 5], whose: &str| -> Vec<_> {
            (QUANTITIES.iter().zip(errors).filter(|(_, errors)| !errors.is_empty()))
                .map(|(name, errors)| {
                    (format!("{whose}{name}"), errors.len(), quantiles(errors.clone()))
                })
                .collect()
        };
        let mut rows = of(&self.errors, "");
        rows.extend(of(&self.uncertainties, "boundary elements, half as many: "));
        if !self.turns.is_empty() {
            let name = "normals within the reference turn by [degrees]";
            rows.push((name.into(), self.turns.len(), quantiles(self.turns.clone())));
        }
        for (name, times) in ["time [us]", "time of boundary elements [us]"].iter().zip(&self.times)
        {
            let times: Vec<f64> = times.iter().map(|time| 1e6 * time).collect();
            if !times.is_empty() {
                rows.push(((*name).into(), times.len(), quantiles(times)));
            }
        }
        rows
    }

    /// As a table for reading.
    pub fn text(&self) -> String {
        let mut text = format!(
            "{:<84}{:>7} {:>11} {:>11} {:>11}\n",
            "error", "cases", "median", "95 %", "worst"
        );
        for (name, count, [median, most, worst]) in self.rows() {
            let _ =
                writeln!(text, "{name:<84}{count:>7} {median:>11.3} {most:>11.3} {worst:>11.3}");
        }
        if self.separate > 0 {
            let _ =
                writeln!(text, "cases with separate patches in the reference: {}", self.separate);
        }
        if self.fallbacks > 0 {
            let _ = writeln!(text, "cases in which a solver fell back: {}", self.fallbacks);
        }
        text
    }

    /// As CSV.
    pub fn write(&self, table: Table) -> Result<()> {
        table.write_record(["quantity", "cases", "median", "p95", "worst"])?;
        for (name, count, values) in self.rows() {
            let values = values.map(|value| format!("{value:.4}"));
            table.write_record([&[name, count.to_string()], &values[..]].concat())?;
        }
        table.finish()
    }
}

/// Median, 95 % quantile and greatest of a set that is not empty.
fn quantiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    let last = values.len() - 1;
    let median = 0.5 * (values[last / 2] + values[last.div_ceil(2)]);
    [median, values[(0.95 * last as f64).round() as usize], values[last]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_the_sorted_set() {
        let values: Vec<f64> = (0..=100).rev().map(f64::from).collect();
        assert_eq!(quantiles(values).map(|v| v as i32), [50, 95, 100]);
        assert_eq!(quantiles(vec![3.0, 1.0]).map(|v| v as i32), [2, 3, 3]);
    }
}
