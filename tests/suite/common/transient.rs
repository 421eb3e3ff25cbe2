//! CONTACT's sphere that is shifted and rolls: tests/data/contact_25_1/transient.csv.

use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::material::Material;
use wheelrail::planar::{Indentation, PlanarCase, StepMotion, TransientContact, TransientResult};

use super::planar::steel_case;
use super::{Table, column, read_table, value};

/// Runs of 80 states.
pub const RUNS: [&str; 3] = ["catt_shift", "totforce", "trans_roll"];

pub const MU: f64 = 0.4;
/// Displacement in a state of the runs with shifts: x, y [m], turn [rad].
const SHIFT: [f64; 3] = [0.7138e-6, 0.8059e-6, -0.1735e-3];
pub const CREEPAGE: [f64; 3] = [3.563e-3, 4.022e-3, -0.8662];
const STEP: f64 = 2e-4;
/// Distance of the contact from the point that moments refer to, along the surface [mm].
const ARM: f64 = 8.7215;
/// Radius of the sphere [m].
const RADIUS: f64 = 0.1;

/// A state of a run: its number, normal force [N], and Fx, Fy [N], moment about the contact [N mm].
#[derive(Clone, Copy, Debug)]
pub struct State {
    pub number: usize,
    pub load: f64,
    pub forces: [f64; 3],
}

/// States of one run.
pub fn states(run: &str) -> Vec<State> {
    let table: Table = read_table("contact_25_1/transient.csv");
    let named = column(&table, "run");
    let rows = table.rows.iter().filter(|row| &row[named] == run);
    rows.map(|row| {
        let v = |name: &str| value(&table, row, name);
        let (fx, fy) = (v("fx_N"), v("fs_N"));
        let moment = match run {
            "catt_shift" | "totforce" => v("mn_Nmm") + ARM * fx - v("s_mm") * fy,
            "trans_roll" => v("mn_Nmm") + ARM * fx,
            _ => v("mn_Nmm"),
        };
        State { number: v("state") as usize, load: v("fn_N"), forces: [fx, fy, moment] }
    })
    .collect()
}

/// Separation of the sphere from the plane.
pub fn separation() -> Vec<[f64; 2]> {
    (-200..=200)
        .map(|i| 1e-4 * f64::from(i))
        .map(|y| [y, RADIUS - (RADIUS * RADIUS - y * y).sqrt()])
        .collect()
}

/// The sphere under `load` [N].
pub fn case(separation: &[[f64; 2]], load: f64) -> PlanarCase<'_> {
    let rubber = Material { young_modulus: 2.56 * 2e8, poisson_ratio: 0.28 };
    PlanarCase {
        indentation: Indentation::Load(load),
        friction: MU,
        wheel_material: rubber,
        rail_material: rubber,
        normal_model: NormalModel::BoundaryElement,
        tangential_model: TangentialModel::BoundaryElement,
        ..steel_case(separation, RADIUS, 0.0)
    }
}

/// A contact with the elements of the reference.
pub fn contact() -> TransientContact {
    TransientContact::with_element_size([STEP; 2]).unwrap()
}

/// Errors of the force, and of the moment over the radius of the contact, over the friction limit
/// [%].
pub fn errors(found: &TransientResult, state: &State) -> [f64; 2] {
    let limit = MU * state.load;
    let radius = 0.5e3 * found.contact.length;
    let [fx, fy, moment] = state.forces;
    let force = (found.contact.fx - fx).hypot(found.contact.fy - fy);
    [100.0 * force / limit, 100.0 * (1e3 * found.contact.mz - moment).abs() / (limit * radius)]
}

/// Goes through a run, and hands each contact with its case and result to `look`; the errors of
/// the states that are given, by their numbers.
pub fn follow(
    run: &str,
    mut look: impl FnMut(&TransientContact, &PlanarCase, &TransientResult),
) -> Vec<(usize, [f64; 2])> {
    let (states, separation) = (states(run), separation());
    let mut contact = contact();
    let mut all = Vec::new();
    for n in 1..=80 {
        // Loads of the states that are left out lie between those given.
        let next = states.iter().find(|state| state.number >= n).unwrap();
        let last = states.iter().rev().find(|state| state.number <= n).unwrap_or(next);
        let creepage = if run == "trans_roll" { CREEPAGE } else { [0.0; 3] };
        let case = PlanarCase { creepage, ..case(&separation, 0.5 * (last.load + next.load)) };
        let motion = match (run, n) {
            ("trans_roll", _) => StepMotion { rolled: STEP, ..StepMotion::default() },
            ("catt_shift", 1) => {
                StepMotion { shift: SHIFT.map(|d| 20.0 * d), ..StepMotion::default() }
            }
            _ => StepMotion { rolled: STEP, shift: SHIFT, ..StepMotion::default() },
        };
        let found = contact.step(&case, &motion).unwrap();
        look(&contact, &case, &found);
        if next.number == n {
            all.push((n, errors(&found, next)));
        }
    }
    all
}
