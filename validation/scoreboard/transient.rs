//! Contact with memory, which boundary elements alone have.

use wheelrail::element::parameters::NormalModel;

use crate::common::transient::{RUNS, follow};
use crate::family::{Case, Family, none};
use crate::setting::Setting;

/// CONTACT's tests of shift and transient rolling on one contact.
pub const FAMILY: Family = Family {
    title: "Sphere that is shifted and rolls from there",
    source: "`tests/data/contact_25_1/transient.csv`",
    text: "CONTACT's own tests of Cattaneo's shift and transient rolling, every second of 80 states of 0.2 mm, on its elements of 0.2 mm; planar problems by boundary elements alone. Its difference \
           along x is of first order, that of the project of second.",
    quantities: &["creep force [% of the limit]", "spin moment [% of limit times radius]"],
    is_random: false,
    needs_folder: false,
    solve: |setting, _| solve(setting),
    others: none,
};

fn solve(setting: &Setting) -> Option<Vec<Case>> {
    if setting.parameters().normal_model != NormalModel::BoundaryElement {
        return None;
    }
    let runs = RUNS.into_iter().map(|run| (run, follow(run, |_, _, _| ())));
    let cases = runs.flat_map(|(run, states)| {
        let case = move |(n, errors): (usize, [f64; 2])| Case {
            name: format!("{run} {n}"),
            errors: errors.to_vec(),
        };
        states.into_iter().map(case)
    });
    Some(cases.collect())
}
