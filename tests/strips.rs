//! The strip model against CONTACT and Hertz; see the heads of the files under tests/data.

mod common;
mod tolerance;

use std::fmt::Write;

use common::planar::{HertzRow, steel_case};
use common::{column, read_table, value, write_report};
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::planar::{PlanarCase, PlanarResult, solve};

/// Points (y, f) of a separation of the reference [m].
fn separation(case: &str) -> Vec<[f64; 2]> {
    let table = read_table(&format!("contact_25_1/planar/{case}.csv"));
    table
        .rows
        .iter()
        .map(|row| [1e-3 * value(&table, row, "y_mm"), 1e-3 * value(&table, row, "f_mm")])
        .collect()
}

struct Compared {
    name: String,
    regions: usize,
    /// Errors of normal force, greatest pressure and area [-].
    errors: [f64; 3],
    result: PlanarResult,
}

/// The 32 planar cases with `strips` strips by `model`.
fn planar_cases(model: NormalModel, strips: usize) -> Vec<Compared> {
    let table = read_table("contact_25_1/planar_normal.csv");
    let case_column = column(&table, "case");
    table
        .rows
        .iter()
        .filter(|row| std::env::var("CASE").map_or(true, |c| format!("{} {}", &row[case_column], &row[1]) == c))
        .map(|row| {
            let v = |name: &str| value(&table, row, name);
            let points = separation(&row[case_column]);
            let result = solve(&PlanarCase {
                normal_model: model,
                tangential_model: TangentialModel::None,
                strips,
                ..steel_case(&points, 1e-3 * v("radius_mm"), 1e-3 * v("approach_mm"))
            })
            .unwrap();
            Compared {
                name: format!("{} {}", &row[case_column], v("approach_mm")),
                regions: v("regions") as usize,
                errors: [
                    result.normal_force / v("normal_force_n") - 1.0,
                    1e-6 * result.max_pressure / v("max_pressure_mpa") - 1.0,
                    1e6 * result.area / v("area_mm2") - 1.0,
                ],
                result,
            }
        })
        .collect()
}

#[test]
fn planar_patches_are_those_of_contact() {
    let mut report = String::from("strips,case,regions,patches,fallback,n,p_max,area\n");
    for strips in [11, 15, 21, 31, 41] {
        for c in planar_cases(NormalModel::Strips, strips) {
            let [n, p, a] = c.errors.map(|e| 100.0 * e);
            writeln!(
                report,
                "{strips},{},{},{},{},{n:.3},{p:.3},{a:.3}",
                c.name, c.regions, c.result.patches, c.result.fallback
            )
            .unwrap();
        }
    }
    write_report("strips_planar.csv", &report);
}

#[test]
fn ellipses_are_those_of_hertz() {
    let mut report = String::from("strips,a_over_b,n,p0,area\n");
    for strips in [11, 15, 21, 31] {
        for row in HertzRow::all() {
            let points = row.separation();
            let result = solve(&PlanarCase {
                normal_model: NormalModel::Strips,
                strips,
                ..steel_case(&points, 0.5 / row.along, row.approach)
            })
            .unwrap();
            let errors = [
                result.normal_force / row.load,
                result.max_pressure / row.max_pressure,
                result.area / row.area,
            ]
            .map(|ratio| 100.0 * (ratio - 1.0));
            writeln!(report, "{strips},{},{:?}{}", row.axis_ratio, errors, result.fallback).unwrap();
        }
    }
    write_report("strips_hertz.csv", &report);
}
