//! CONTACT's sphere that is shifted and rolls: tests/data/contact_25_1/transient.csv.

use super::*;
use crate::common::summary::Summary;
use crate::common::{Table, column, quantiles, read_table, value};
use wheelrail::planar::solve;

const MU: f64 = 0.4;
/// Displacement in a state of the runs with shifts: x, y [m], turn [rad].
const SHIFT: [f64; 3] = [0.7138e-6, 0.8059e-6, -0.1735e-3];
const CREEPAGE: [f64; 3] = [0.003563, 0.004022, -0.8662];
const STEP: f64 = 2e-4;
/// Distance of the contact from the point that moments refer to, along the surface [mm].
const ARM: f64 = 8.7215;

/// States of one run: number, place [mm], load [N], Fx, Fy [N], moment about the contact [N mm].
fn states(table: &Table, run: &str) -> Vec<(usize, f64, [f64; 3])> {
    let named = column(table, "run");
    let rows = table.rows.iter().filter(|row| &row[named] == run);
    rows.map(|row| {
        let v = |name: &str| value(table, row, name);
        let (fx, fy) = (v("fx_N"), v("fs_N"));
        let moment = match run {
            "catt_shift" | "totforce" => v("mn_Nmm") + ARM * fx - v("s_mm") * fy,
            "trans_roll" => v("mn_Nmm") + ARM * fx,
            _ => v("mn_Nmm"),
        };
        (v("state") as usize, v("fn_N"), [fx, fy, moment])
    })
    .collect()
}

/// Errors of forces, and of moments over the radius of the contact, over the friction limit [%].
struct Errors {
    force: Vec<f64>,
    moment: Vec<f64>,
}

impl Errors {
    fn add(&mut self, found: &TransientResult, load: f64, expected: [f64; 3]) {
        let limit = MU * load;
        let radius = 0.5e3 * found.contact.length;
        let [x, y] = [found.contact.fx - expected[0], found.contact.fy - expected[1]];
        self.force.push(100.0 * x.hypot(y) / limit);
        let moment = 1e3 * found.contact.mz - expected[2];
        self.moment.push(100.0 * moment.abs() / (limit * radius));
    }
}

#[test]
fn forces_and_moments_are_those_of_contact_through_shift_and_rolling() {
    let table = read_table("contact_25_1/transient.csv");
    let separation = sphere(0.1, 0.02);
    let rubber = material(2e8, 0.28);
    let mut summary = Summary::new("transient_contact");
    for run in ["catt_shift", "totforce", "trans_roll"] {
        let states = states(&table, run);
        let mut errors = Errors { force: Vec::new(), moment: Vec::new() };
        let mut contact = TransientContact::with_element_size([STEP; 2]).unwrap();
        for n in 1..=80 {
            // Loads of the states that are left out lie between those given.
            let next = states.iter().find(|state| state.0 >= n).unwrap();
            let last = states.iter().rev().find(|state| state.0 <= n).unwrap_or(next);
            let load = 0.5 * (last.1 + next.1);
            let creepage = if run == "trans_roll" { CREEPAGE } else { [0.0; 3] };
            let indentation = Indentation::Load(load);
            let case = PlanarCase { creepage, ..case(&separation, 0.1, indentation, MU, rubber) };
            let motion = match (run, n) {
                ("trans_roll", _) => rolled(STEP),
                ("catt_shift", 1) => {
                    StepMotion { shift: SHIFT.map(|d| 20.0 * d), ..StepMotion::default() }
                }
                _ => StepMotion { rolled: STEP, shift: SHIFT, ..StepMotion::default() },
            };
            let found = contact.step(&case, &motion).unwrap();
            assert!(found.converged && found.substeps == 1);
            assert_obeys(contact.field().unwrap(), &case, &found);
            if next.0 == n {
                errors.add(&found, load, next.2);
            }
        }
        assert_eq!(errors.force.len(), 40);
        summary.add(&format!("{run}: creep force"), errors.force.clone(), "- / 1 / -");
        summary.add(&format!("{run}: spin moment"), errors.moment.clone(), "- / 1 / -");
        for errors in [errors.force, errors.moment] {
            let [_, most, worst] = quantiles(errors);
            assert!(most < 0.75 && worst < 0.8, "{run}: {most} {worst}");
        }
    }

    let steady = &states(&table, "steady_roll")[0];
    let case = PlanarCase {
        creepage: CREEPAGE,
        elements: [40, 40],
        ..case(&separation, 0.1, Indentation::Load(steady.1), MU, rubber)
    };
    let found = solve(&case).unwrap();
    let [x, y] = [found.fx - steady.2[0], found.fy - steady.2[1]];
    let error = 100.0 * x.hypot(y) / (MU * steady.1);
    summary.add("steady_roll: creep force", [error], "1");
    assert!(error < 0.6, "{error}");

    let mut errors = Errors { force: Vec::new(), moment: Vec::new() };
    let mut contact = TransientContact::with_element_size([STEP; 2]).unwrap();
    for (n, load, expected) in states(&table, "trans_dqrel") {
        let creepage = [if n == 1 { -0.04082 } else { -0.004008 }, 0.0, 0.0];
        let indentation = Indentation::Load(load);
        let case =
            PlanarCase { creepage, ..super::case(&separation, 0.1, indentation, MU, rubber) };
        let found = contact.step(&case, &rolled(0.766e-3)).unwrap();
        assert!(found.substeps == 4);
        errors.add(&found, load, expected);
    }
    summary.add("trans_dqrel: creep force", errors.force.clone(), "1");
    summary.write();
    assert!(errors.force.iter().all(|e| *e < 0.2), "{:?}", errors.force);
}
