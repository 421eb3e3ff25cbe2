//! The boundary element solution against closed forms, Kalker's coefficients and CONTACT.
//!
//! The long sets are behind `--ignored` and want a release build: `cargo test --release --test boundary_element -- --ignored`.

mod common;
mod tolerance;

use std::collections::HashMap;
use std::fmt::Write;

use common::planar::{STEEL, parabola, steel_case};
use common::{quantiles, read_table, value};
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::normal::hertz;
use wheelrail::planar::{Indentation, PlanarCase, PlanarResult, solve};

fn boundary_case(
    separation: &[[f64; 2]],
    radius: f64,
    approach: f64,
    elements: [usize; 2],
) -> PlanarCase<'_> {
    PlanarCase {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: TangentialModel::None,
        elements,
        ..steel_case(separation, radius, approach)
    }
}

#[test]
fn hertz_is_met_from_slender_to_wide_ellipses() {
    for row in common::planar::HertzRow::all().iter().step_by(3) {
        let separation = row.separation();
        let radius = 0.5 / row.along;
        let r = solve(&boundary_case(&separation, radius, row.approach, [60, 60])).unwrap();
        println!(
            "a/b {} N {:+.4}% p {:+.4}% A {:+.3}% L {:+.3}% W {:+.3}%",
            row.axis_ratio,
            100.0 * (r.normal_force / row.load - 1.0),
            100.0 * (r.max_pressure / row.max_pressure - 1.0),
            100.0 * (r.area / row.area - 1.0),
            100.0 * (r.length / (2.0 * row.semi_axes[0]) - 1.0),
            100.0 * (r.width / (2.0 * row.semi_axes[1]) - 1.0)
        );
    }
}

#[test]
#[ignore]
fn planar_normal() {
    let table = read_table("contact_25_1/planar_normal.csv");
    for row in &table.rows {
        let v = |name: &str| value(&table, row, name);
        let points = read_separation(&row[0]);
        for n in [20, 30, 60] {
            let r = solve(&boundary_case(
                &points,
                1e-3 * v("radius_mm"),
                1e-3 * v("approach_mm"),
                [n, n],
            ))
            .unwrap();
            println!(
                "{} {:3} reg {}/{} N {:+.3}% p {:+.3}% A {:+.3}% L {:+.3}% W {:+.3}% fb {}",
                &row[0],
                n,
                r.patches,
                v("regions"),
                100.0 * (r.normal_force / v("normal_force_n") - 1.0),
                100.0 * (1e-6 * r.max_pressure / v("max_pressure_mpa") - 1.0),
                100.0 * (1e6 * r.area / v("area_mm2") - 1.0),
                100.0 * (1e3 * r.length / v("length_mm") - 1.0),
                100.0 * (1e3 * r.width / (v("y_max_mm") - v("y_min_mm")) - 1.0),
                r.fallback
            );
        }
    }
}

fn read_separation(case: &str) -> Vec<[f64; 2]> {
    let table = read_table(&format!("contact_25_1/planar/{case}.csv"));
    table
        .rows
        .iter()
        .map(|row| [1e-3 * value(&table, row, "y_mm"), 1e-3 * value(&table, row, "f_mm")])
        .collect()
}

#[test]
#[ignore]
fn planar_tangential() {
    let table = read_table("contact_25_1/planar_tangential.csv");
    let mut errs: HashMap<String, Vec<f64>> = HashMap::new();
    let every: usize = std::env::var("EVERY").map_or(1, |s| s.parse().unwrap());
    let n: usize = std::env::var("NEL").map_or(40, |s| s.parse().unwrap());
    let mut out = String::new();
    for row in table.rows.iter().step_by(every) {
        let v = |name: &str| value(&table, row, name);
        let points = read_separation(&row[0]);
        let case = PlanarCase {
            tangential_model: TangentialModel::BoundaryElement,
            creepage: [v("creepage_longitudinal"), v("creepage_lateral"), 1e3 * v("spin_per_mm")],
            ..boundary_case(&points, 1e-3 * v("radius_mm"), 1e-3 * v("approach_mm"), [n, n])
        };
        let r = solve(&case).unwrap();
        let lim = 0.3 * v("normal_force_n");
        let e = (r.fx - v("fx_n")).hypot(r.fy - v("fy_n")) / lim;
        errs.entry(format!("{} {}", &row[4], &row[0])).or_default().push(e);
        errs.entry(format!("{} {}", &row[4], &row[3])).or_default().push(e);
        errs.entry(format!("{} all", &row[4])).or_default().push(e);
        if r.fallback {
            println!("fallback {row:?}");
        }
        if e > 0.012 {
            writeln!(out, "{e:.4} {row:?} {:.0} {:.0}", r.fx, r.fy).unwrap();
        }
    }
    let mut keys: Vec<_> = errs.keys().cloned().collect();
    keys.sort();
    for k in keys {
        println!("{k}: {} {:?}", errs[&k].len(), quantiles(errs[&k].clone()));
    }
    println!("{out}");
}
