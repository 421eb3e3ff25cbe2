//! A wheel on a rail: S1002 on 60E1 in places from tread to flange. Times are those of the element
//! there; errors those of its contacts, laid flat, light to heavy, creeping from hardly to fully,
//! against boundary elements on the same plane.
//!
//! Laid flat, so that all models have the same planar problem; what curved patches add is measured
//! by `wheelrail compare` and by the test `boundary_element`.

use rayon::prelude::*;
use wheelrail::element::parameters::{NormalModel, TangentialModel, VerticalMode};
use wheelrail::element::{Element, FlatContact, Input, Output, Parameters};
use wheelrail::planar::{PlanarCase, PlanarResult, solve};

use crate::choices::{Choice, boundary};
use crate::common::planar::steel_case;

/// Places: name, lateral shift [m] and yaw [rad].
pub const PLACES: [(&str, f64, f64); 5] = [
    ("tread", -3e-3, 1e-3),
    ("wide tread contact", 0.0, 1e-3),
    ("tread and flange root", 5.35e-3, 1e-3),
    ("flange root", 6.5e-3, 3e-3),
    ("flange", 8e-3, 5e-3),
];
/// Number of the tread among them.
pub const TREAD: usize = 0;
/// Vertical loads [N].
const LOADS: [f64; 3] = [2e4, 6e4, 1.2e5];
/// Longitudinal and lateral creepage, and factors of the spin that belongs to the contact angle.
const CREEPAGES: [[f64; 3]; 6] = [
    [2e-4, 0.0, 0.0],
    [0.0, 5e-4, 1.0],
    [1e-3, -5e-4, 1.0],
    [-1e-3, 2e-3, 0.5],
    [5e-3, 2e-3, 1.0],
    [0.0, 0.0, 1.0],
];
/// The load with which times are taken, and the creepages beyond those of the place.
const TIMED_LOAD: f64 = 6e4;
const TIMED_CREEPAGE: [f64; 2] = [1e-3, -1e-3];
/// Boundary elements along and across of the reference.
pub const REFERENCE: usize = 40;

const SPEED: f64 = 20.0;

/// A contact laid flat with a creepage, and its solution by boundary elements.
pub struct Case {
    contact: FlatContact,
    creepage: [f64; 3],
    exact: PlanarResult,
}

/// Errors of one case.
#[derive(Clone, Copy)]
pub struct Errors {
    /// Relative.
    pub load: f64,
    /// Relative.
    pub pressure: f64,
    /// Relative.
    pub area: f64,
    /// Of the creep force over the friction limit of the model's own load.
    pub force: f64,
}

/// Number of cases.
pub const COUNT: usize = PLACES.len() * LOADS.len() * CREEPAGES.len();

/// The input with which times are taken at a place.
pub fn timed_input(place: usize) -> Input {
    let (_, shift, yaw) = PLACES[place];
    let z = carrying_height(shift, yaw, TIMED_LOAD);
    Input { wheel_load: TIMED_LOAD, ..input(shift, yaw, z, TIMED_CREEPAGE) }
}

/// Solves all cases by boundary elements; `done` is called after each.
pub fn cases(done: impl Fn() + Sync) -> Vec<Case> {
    let places = PLACES.iter().flat_map(|&(_, shift, yaw)| LOADS.map(|load| (shift, yaw, load)));
    let contacts: Vec<FlatContact> =
        places.map(|(shift, yaw, load)| deepest_contact(shift, yaw, load)).collect();
    let cases: Vec<(&FlatContact, [f64; 3])> = contacts
        .iter()
        .flat_map(|contact| {
            CREEPAGES.map(|[x, y, spin]| (contact, [x, y, spin * contact.creepage[2]]))
        })
        .collect();
    cases
        .into_par_iter()
        .map(|(contact, creepage)| {
            let exact = solved(boundary(REFERENCE), contact, creepage);
            done();
            Case { contact: contact.clone(), creepage, exact }
        })
        .collect()
}

fn input(shift: f64, yaw: f64, z: f64, [longitudinal, lateral]: [f64; 2]) -> Input {
    let mut input = Input::default();
    let wheel = &mut input.wheel;
    wheel.position[1] += shift;
    wheel.position[2] = z;
    wheel.yaw = yaw;
    // A yawed wheel that rolls straight on creeps sideways by its yaw: that is taken back.
    wheel.velocity = [SPEED, SPEED * (lateral + yaw), 0.0];
    wheel.pitch_rate = -SPEED / 0.46 * (1.0 - longitudinal);
    input
}

/// The height at which strips without creep force carry `load` [m].
fn carrying_height(shift: f64, yaw: f64, load: f64) -> f64 {
    let parameters = Parameters {
        damping: 0.0,
        vertical_mode: VerticalMode::Load,
        normal_model: NormalModel::Strips,
        tangential_model: TangentialModel::None,
        ..Parameters::default()
    };
    let at_rest = Input { wheel_load: load, ..input(shift, yaw, -0.46, [0.0; 2]) };
    let mut element = Element::new(&parameters, &at_rest, &[]).expect("built-in profiles");
    let mut output = Output::default();
    element.evaluate(&at_rest, &mut output).expect("a good input");
    output.wheel_z
}

fn deepest_contact(shift: f64, yaw: f64, load: f64) -> FlatContact {
    let at = input(shift, yaw, carrying_height(shift, yaw, load), [0.0; 2]);
    let mut element = Element::new(&Parameters::default(), &at, &[]).expect("built-in profiles");
    let contacts = element.flat_contacts(&at).expect("a good input");
    let deepest = contacts.into_iter().max_by(|a, b| a.penetration.total_cmp(&b.penetration));
    deepest.expect("a loaded wheel touches")
}

fn solved(choice: Choice, contact: &FlatContact, creepage: [f64; 3]) -> PlanarResult {
    let case = PlanarCase {
        creepage,
        ..steel_case(&contact.separation, contact.radius, contact.penetration)
    };
    solve(&choice.of_case(&case)).expect("a good case")
}

/// Errors of a choice on all cases.
pub fn errors(cases: &[Case], choice: Choice) -> Vec<Errors> {
    let errors = cases.iter().map(|Case { contact, creepage, exact }| {
        let found = solved(choice, contact, *creepage);
        let relative =
            |quantity: fn(&PlanarResult) -> f64| (quantity(&found) / quantity(exact) - 1.0).abs();
        let share = |result: &PlanarResult, force: f64| force / (0.3 * result.normal_force);
        Errors {
            load: relative(|r| r.normal_force),
            pressure: relative(|r| r.max_pressure),
            area: relative(|r| r.area),
            force: (share(&found, found.fx) - share(exact, exact.fx))
                .hypot(share(&found, found.fy) - share(exact, exact.fy)),
        }
    });
    errors.collect()
}
