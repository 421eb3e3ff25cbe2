//! Families of cases, and the errors that a setting makes in them.

use crate::common::spread;
use crate::setting::Setting;

/// One case: its name in the file that it is from, and its errors in the order of the quantities of
/// the family; not a number where a quantity is not compared.
pub struct Case {
    pub name: String,
    pub errors: Vec<f64>,
}

/// Cases of one kind.
pub struct Family {
    /// Heading of its section.
    pub title: &'static str,
    /// Where the figures come from, as the page says it.
    pub source: &'static str,
    /// What is compared, in a sentence or two.
    pub text: &'static str,
    /// Quantities with their units.
    pub quantities: &'static [&'static str],
    /// Whether its cases are drawn anew in every run.
    pub is_random: bool,
    /// Whether it needs the folder of profiles that may not be passed on.
    pub needs_folder: bool,
    /// Errors by a setting; nothing where the setting does not know such cases or there is no
    /// folder.
    pub solve: fn(&Setting, seed: u64) -> Option<Vec<Case>>,
    /// Rows of others: name, and cases.
    pub others: fn() -> Vec<(String, Vec<Case>)>,
}

/// No others.
pub fn none() -> Vec<(String, Vec<Case>)> {
    Vec::new()
}

/// Median, 95 % and worst of a quantity over some cases, how many there are, and which one is
/// worst; nothing without cases.
pub struct Spread<'a> {
    pub count: usize,
    pub sizes: [f64; 3],
    pub worst: &'a str,
}

impl<'a> Spread<'a> {
    pub fn of(cases: &'a [Case], quantity: usize) -> Option<Self> {
        let all: Vec<(f64, &str)> = cases
            .iter()
            .map(|case| (case.errors[quantity].abs(), case.name.as_str()))
            .filter(|(error, _)| !error.is_nan())
            .collect();
        let (_, worst) = *all.iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
        let sizes = spread(all.iter().map(|(error, _)| *error).collect());
        Some(Self { count: all.len(), sizes, worst })
    }
}
