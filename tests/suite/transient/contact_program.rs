//! CONTACT's sphere that is shifted and rolls.

use super::*;
use crate::common::quantiles;
use crate::common::summary::Summary;
use crate::common::transient::{self, CREEPAGE, MU, RUNS, follow, states};
use wheelrail::planar::solve;

#[test]
fn forces_and_moments_are_those_of_contact_through_shift_and_rolling() {
    let mut summary = Summary::new("transient_contact");
    for run in RUNS {
        let errors = follow(run, |contact, case, found| {
            assert!(found.converged && found.substeps == 1);
            assert_obeys(contact.field().unwrap(), case, found);
        });
        assert_eq!(errors.len(), 40);
        for (k, quantity) in ["creep force", "spin moment"].into_iter().enumerate() {
            let errors: Vec<f64> = errors.iter().map(|(_, errors)| errors[k]).collect();
            summary.add(&format!("{run}: {quantity}"), errors.clone(), "- / 1 / -");
            let [_, most, worst] = quantiles(errors);
            assert!(most < 0.7 && worst < 0.7, "{run}: {most} {worst}");
        }
    }

    let separation = transient::separation();
    let steady = &states("steady_roll")[0];
    let case = PlanarCase {
        creepage: CREEPAGE,
        elements: [40, 40],
        ..transient::case(&separation, steady.load)
    };
    let found = solve(&case).unwrap();
    let error = (found.fx - steady.forces[0]).hypot(found.fy - steady.forces[1]);
    let error = 100.0 * error / (MU * steady.load);
    summary.add("steady_roll: creep force", [error], "1");
    assert!(error < 0.6, "{error}");

    let mut contact = transient::contact();
    let mut errors = Vec::new();
    for state in states("trans_dqrel") {
        let creepage = [if state.number == 1 { -0.040_82 } else { -0.004_008 }, 0.0, 0.0];
        let case = PlanarCase { creepage, ..transient::case(&separation, state.load) };
        let found = contact.step(&case, &rolled(0.766e-3)).unwrap();
        assert!(found.substeps == 4);
        errors.push(transient::errors(&found, &state)[0]);
    }
    summary.add("trans_dqrel: creep force", errors.clone(), "1");
    summary.write();
    assert!(errors.iter().all(|e| *e < 0.2), "{errors:?}");
}
