//! Planar problems: the separation of two bodies over one plane, with the approach or the load
//! given.

use std::collections::HashMap;

use wheelrail::element::parameters::TangentialModel;
use wheelrail::planar::{Indentation, PlanarCase, PlanarResult, solve};

use crate::common::planar::{HertzRow, creepage_of, hertzian_bodies, separations, steel_case};
use crate::common::{Table, column, read_table, value};
use crate::family::{Case, Family, none};
use crate::setting::Setting;

/// Coefficient of friction of all sets.
const FRICTION: f64 = 0.3;
const NORMAL: [&str; 3] = ["N [%]", "p_max [%]", "area [%]"];
const CREEP: [&str; 2] =
    ["creep force [% of the limit]", "spin moment [% of limit times sqrt(ab)]"];

/// All families of planar problems.
pub const FAMILIES: [Family; 4] = [
    Family {
        title: "Planar problems of wheel and rail, normal",
        source: "`tests/data/contact_25_1/planar_normal.csv`",
        text: "32 approaches of eight separations of S1002 on UIC60, some of two regions. The area of the reference is that of its elements, carried to none.",
        quantities: &NORMAL,
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(normal(setting)),
        others: fast_normal,
    },
    Family {
        title: "Planar problems of wheel and rail, rolling",
        source: "`tests/data/contact_25_1/planar_tangential.csv`",
        text: "Eight of these patches, 82 states of creepage each. The reference is uncertain by 0.2 % of the limit in the mean, 1.1 % at worst.",
        quantities: &CREEP,
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(rolling(setting)),
        others: fast_rolling,
    },
    Family {
        title: "Ellipses of Hertz, normal",
        source: "`tests/data/hertz/ellipses.csv`",
        text: "Ratios of the semi-axes from 0.1 to 10 in closed form.",
        quantities: &NORMAL,
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(ellipses(setting)),
        others: none,
    },
    Family {
        title: "Ellipses of Hertz, rolling",
        source: "`tests/data/contact_25_1/hertz_tangential.csv`",
        text: "300 random ellipses under given load, from full adhesion to full sliding, with and without spin.",
        quantities: &[CREEP[0]],
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(rolling_ellipses(setting)),
        others: none,
    },
];

fn by(setting: &Setting, case: &PlanarCase) -> PlanarResult {
    solve(&setting.of_case(case)).expect("a good case")
}

/// Errors of load, greatest pressure and area [%].
fn normal_errors(found: [f64; 3], expected: [f64; 3]) -> Vec<f64> {
    found.into_iter().zip(expected).map(|(a, b)| 100.0 * (a / b - 1.0)).collect()
}

fn expected_normal(table: &Table, row: &csv::StringRecord, area: &str) -> [f64; 3] {
    [("normal_force_n", 1.0), ("max_pressure_mpa", 1e6), (area, 1e-6)]
        .map(|(name, scale)| scale * value(table, row, name))
}

/// A planar case by its separation and approach.
fn name(row: &csv::StringRecord) -> String {
    format!("{} at {} mm", &row[0], &row[1])
}

fn normal(setting: &Setting) -> Vec<Case> {
    let (table, separations) = (read_table("contact_25_1/planar_normal.csv"), separations());
    let of = |row: &csv::StringRecord| {
        let v = |name: &str| value(&table, row, name);
        let separation = &separations[&row[0]];
        let case = steel_case(separation, 1e-3 * v("radius_mm"), 1e-3 * v("approach_mm"));
        let mut case = setting.of_case(&case);
        case.tangential_model = TangentialModel::None;
        let found = solve(&case).expect("a good case");
        let sizes = [found.normal_force, found.max_pressure, found.area];
        let expected = expected_normal(&table, row, "area_extrapolated_mm2");
        Case { name: name(row), errors: normal_errors(sizes, expected) }
    };
    table.rows.iter().map(of).collect()
}

/// CONTACT's own simplified solutions.
fn fast_normal() -> Vec<(String, Vec<Case>)> {
    let exact = read_table("contact_25_1/planar_normal.csv");
    let fast = read_table("contact_25_1/planar_normal_fast.csv");
    let method = column(&fast, "method");
    let of = |wanted: &str| {
        let rows = fast.rows.iter().filter(|row| &row[method] == wanted);
        let cases = rows.map(|row| {
            let same = |other: &&csv::StringRecord| (&other[0], &other[1]) == (&row[0], &row[1]);
            let other = exact.rows.iter().find(same).expect("a case of planar_normal.csv");
            let expected = expected_normal(&exact, other, "area_mm2");
            let found = expected_normal(&fast, row, "area_mm2");
            Case { name: name(row), errors: normal_errors(found, expected) }
        });
        (format!("CONTACT's {wanted}"), cases.collect())
    };
    ["KPEC", "ANALYN"].map(of).into()
}

fn rolling(setting: &Setting) -> Vec<Case> {
    let separations = separations();
    let table = read_table("contact_25_1/planar_tangential.csv");
    let sizes = read_table("contact_25_1/planar_normal.csv");
    let elements = column(&table, "elements");
    let of = |row: &csv::StringRecord| {
        let v = |name: &str| value(&table, row, name);
        let creepage = creepage_of(&v);
        let separation = &separations[&row[0]];
        let found = by(
            setting,
            &PlanarCase {
                creepage,
                ..steel_case(separation, 1e-3 * v("radius_mm"), 1e-3 * v("approach_mm"))
            },
        );
        rolling_case(&table, &sizes, row, [found.fx, found.fy, found.mz])
    };
    table.rows.iter().filter(|row| &row[elements] == "40").map(of).collect()
}

/// Errors of force and moment `found` [N, N m] in a row of planar_tangential.csv.
fn rolling_case(table: &Table, sizes: &Table, row: &csv::StringRecord, found: [f64; 3]) -> Case {
    let v = |name: &str| value(table, row, name);
    let limit = FRICTION * v("normal_force_n");
    let same = |other: &&csv::StringRecord| (&other[0], &other[1]) == (&row[0], &row[1]);
    let patch = sizes.rows.iter().find(same).expect("a case of planar_normal.csv");
    let size = (1e-6 * value(sizes, patch, "area_mm2") / std::f64::consts::PI).sqrt();
    let [fx, fy, mz] = found;
    let force = (fx - v("fx_n")).hypot(fy - v("fy_n")) / limit;
    let moment = (mz - 1e-3 * v("mz_nmm")).abs() / (limit * size);
    let [x, y, spin] = creepage_of(&v);
    let name = format!("{}, creepage {x:.1e} {y:.1e} {spin:.1e}/m", name(row));
    Case { name, errors: vec![100.0 * force, 100.0 * moment] }
}

/// CONTACT's own simplified solutions.
fn fast_rolling() -> Vec<(String, Vec<Case>)> {
    const KEYS: [&str; 5] =
        ["case", "approach_mm", "creepage_longitudinal", "creepage_lateral", "spin_per_mm"];
    let [exact, fast, sizes] = ["planar_tangential", "planar_tangential_fast", "planar_normal"]
        .map(|name| read_table(&format!("contact_25_1/{name}.csv")));
    let key = |table: &Table, row: &csv::StringRecord| {
        KEYS.map(|name| row[column(table, name)].to_owned())
    };
    let elements = column(&exact, "elements");
    let rows = exact.rows.iter().filter(|row| &row[elements] == "40");
    let known: HashMap<_, _> = rows.map(|row| (key(&exact, row), row)).collect();
    let method = column(&fast, "method");
    let of = |wanted: &str| {
        let cases = fast.rows.iter().filter(|row| &row[method] == wanted).map(|row| {
            let found = [("fx_n", 1.0), ("fy_n", 1.0), ("mz_nmm", 1e-3)]
                .map(|(name, scale)| scale * value(&fast, row, name));
            rolling_case(&exact, &sizes, known[&key(&fast, row)], found)
        });
        (format!("CONTACT's {wanted}"), cases.collect())
    };
    ["ANALYN+FASTSIM", "KPEC+FASTSIM", "KPEC+FASTRIP"].map(of).into()
}

fn ellipses(setting: &Setting) -> Vec<Case> {
    let of = |row: &HertzRow| {
        let separation = row.separation();
        let case = steel_case(&separation, 0.5 / row.along, row.approach);
        let mut case = setting.of_case(&case);
        case.tangential_model = TangentialModel::None;
        let found = solve(&case).expect("a good case");
        let sizes = [found.normal_force, found.max_pressure, found.area];
        let expected = [row.load, row.max_pressure, row.area];
        Case { name: format!("a/b = {}", row.axis_ratio), errors: normal_errors(sizes, expected) }
    };
    HertzRow::all().iter().map(of).collect()
}

fn rolling_ellipses(setting: &Setting) -> Vec<Case> {
    let table = read_table("contact_25_1/hertz_tangential.csv");
    let of = |(number, row): (usize, &csv::StringRecord)| {
        let v = |name: &str| value(&table, row, name);
        let load = v("normal_force_n");
        let (radius, separation) = hertzian_bodies(1e-3 * v("a_mm"), 1e-3 * v("b_mm"), load);
        let found = by(
            setting,
            &PlanarCase {
                indentation: Indentation::Load(load),
                creepage: creepage_of(&v),
                ..steel_case(&separation, radius, 0.0)
            },
        );
        let limit = FRICTION * load;
        let missed =
            (found.fx / limit - v("fx_over_mu_n")).hypot(found.fy / limit - v("fy_over_mu_n"));
        Case { name: format!("row {}", number + 1), errors: vec![100.0 * missed] }
    };
    table.rows.iter().enumerate().map(of).collect()
}
