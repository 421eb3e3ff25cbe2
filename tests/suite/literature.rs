//! Against published or independently computed figures: Kalker's coefficients.

use crate::tolerance;
use std::fmt::Write;

use crate::common::{read_table, value, write_report};
use wheelrail::tangential::kalker_coefficients::kalker_coefficients;

/// Greatest relative errors of c11, c22, c23 over the rows of the file with a/b in or out of 0.05
/// to 20.
fn greatest_errors(inside: bool, report: &mut String) -> [f64; 3] {
    let table = read_table("kalker_coefficients.csv");
    let mut worst = [0f64; 3];
    let mut rows = 0;
    for row in &table.rows {
        let v = |name: &str| value(&table, row, name);
        let ratio = v("a_over_b");
        if (0.05..=20.0).contains(&ratio) != inside {
            continue;
        }
        rows += 1;
        let c = kalker_coefficients(ratio, v("poisson_ratio"));
        let exact = [v("c11"), v("c22"), v("c23")];
        let found = [c.c11, c.c22, c.c23];
        let errors = [0, 1, 2].map(|k| found[k] / exact[k] - 1.0);
        let [c11, c22, c23] = errors;
        writeln!(report, "{},{ratio},{c11:.5},{c22:.5},{c23:.5}", v("poisson_ratio")).unwrap();
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = worst.max(error.abs());
        }
    }
    assert!(rows >= 10, "{rows} rows are too few to judge by");
    worst
}

#[test]
fn the_fit_of_kalkers_coefficients_meets_the_exact_ones_and_its_ends_stay_near() {
    let mut report = String::from("poisson_ratio,a_over_b,c11_error,c22_error,c23_error\n");
    let inside = greatest_errors(true, &mut report);
    let outside = greatest_errors(false, &mut report);
    write_report("kalker_coefficients.csv", &report);
    println!("inside {inside:?}, outside {outside:?}");
    for k in 0..3 {
        let name = ["c11", "c22", "c23"][k];
        assert!(inside[k] <= tolerance::KALKER_FIT[k], "{name}: {:e} off", inside[k]);
        assert!(outside[k] <= tolerance::KALKER_ENDS[k], "{name} at the ends: {:e}", outside[k]);
    }
}
