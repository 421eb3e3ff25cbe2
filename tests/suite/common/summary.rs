//! Figures that the documents show: a test leaves them, `cargo bench --bench documents` writes them
//! into docs.

use super::{spread, write_report};

/// A table of errors, one row for each quantity.
pub struct Summary {
    name: String,
    rows: csv::Writer<Vec<u8>>,
}

impl Summary {
    /// An empty table; documents name it `name`.
    pub fn new(name: &str) -> Self {
        let mut rows = csv::Writer::from_writer(Vec::new());
        rows.write_record(["quantity", "cases", "median", "95 %", "worst", "aim"]).unwrap();
        Self { name: name.into(), rows }
    }

    /// A row of the absolute values of `errors`, with what is aimed at: median, 95 % and worst as in
    /// `0.1 / - / 0.8`, or the worst alone. docs/validation.md lists what is beyond.
    pub fn add(&mut self, quantity: &str, errors: impl IntoIterator<Item = f64>, aim: &str) {
        let errors: Vec<f64> = errors.into_iter().map(f64::abs).collect();
        self.row(quantity, errors.len(), spread(errors), aim);
    }

    /// A row of three numbers that are no errors.
    pub fn row(&mut self, quantity: &str, cases: usize, numbers: [f64; 3], aim: &str) {
        let [median, most, worst] = numbers.map(rounded);
        let cases = cases.to_string();
        self.rows.write_record([quantity, &cases, &median, &most, &worst, aim]).unwrap();
    }

    /// Leaves the table under target/reports.
    pub fn write(self) {
        let text = String::from_utf8(self.rows.into_inner().unwrap()).unwrap();
        println!("{}\n{text}", self.name);
        write_report(&format!("summary_{}.csv", self.name), &text);
    }
}

/// A number with two digits that count.
pub fn rounded(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    let digits = 1 - x.abs().log10().floor() as i32;
    if (0..=4).contains(&digits) {
        return format!("{x:.*}", digits as usize);
    }
    if (-3..0).contains(&digits) {
        return format!("{x:.0}");
    }
    format!("{x:.1e}")
}
