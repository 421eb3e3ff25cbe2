//! Walks of any motion: friction creates no energy, nothing jumps, and the work is bounded.

use super::*;
use crate::common::planar::STEEL;
use crate::common::random::Random;

/// Two lobes 8 mm apart with a ridge of 20 μm between them, the right one 10 μm deeper.
fn lobes() -> Vec<[f64; 2]> {
    (-120..=120)
        .map(|i| 1e-4 * f64::from(i))
        .map(|y| [y, 2e-5 * (1.0 - (y / 4e-3).powi(2)).powi(2) - 1e-5 * y / 8e-3])
        .collect()
}

#[test]
fn walks_with_steps_of_any_size_stay_within_the_law() {
    let separation = lobes();
    let mut random = Random::new(54);
    let mut contact = TransientContact::with_element_size([5e-4, 5e-4]).unwrap();
    let (mut patches, mut most_sweeps, mut ended) = ([0; 3], 0, 0);
    let mut before: Option<TransientResult> = None;
    for step in 0..100 {
        let approach = random.within(-2e-5, 1.2e-4);
        let scale = 10f64.powf(random.within(-5.0, -2.0));
        let creepage = [random.about(scale), random.about(scale), 50.0 * random.about(scale)];
        let distance = match step % 5 {
            0 => 0.0,
            1 => 10f64.powf(random.within(-12.0, -4.0)),
            2 => random.within(0.0, 4e-4),
            3 => random.within(4e-4, 1e-2),
            _ => 10f64.powf(random.within(-2.0, 1.0)),
        };
        let distance = if step % 7 < 3 { -distance } else { distance };
        let shift = if step % 3 == 0 { random.about(1e-5) } else { 0.0 };
        let case = PlanarCase {
            creepage,
            friction: random.within(0.05, 0.6),
            ..case(&separation, 0.45, Indentation::Approach(approach), 0.0, STEEL)
        };
        let motion =
            StepMotion { rolled: distance, shift: [shift, -shift, 0.0], ..Default::default() };
        let earlier = contact.history().clone();
        let found = contact.step(&case, &motion).unwrap();
        assert!(found.converged, "step {step}: {found:?}");
        patches[found.contact.patches.min(2)] += 1;
        most_sweeps = most_sweeps.max(found.sweeps);
        let Some(field) = contact.field() else {
            ended += 1;
            assert_eq!(found.contact.fx.to_bits(), 0.0f64.to_bits());
            continue;
        };
        assert_obeys(field, &case, &found);
        let limit = case.friction * found.contact.normal_force;
        let size = found.contact.fx.hypot(found.contact.fy);
        assert!(size <= (1.0 + 1e-9) * limit, "step {step}: {size} of {limit}");

        // From the same history the same, to the bit; next to it, next to it.
        let mut again = contact.clone();
        again.set_history(earlier.clone());
        assert_eq!(again.step(&case, &motion).unwrap(), found);
        assert_eq!(again.history(), contact.history());
        if step % 4 == 0 {
            let near = StepMotion { rolled: distance * (1.0 + 1e-7), ..motion };
            again.set_history(earlier);
            let near = again.step(&case, &near).unwrap();
            let moved =
                (near.contact.fx - found.contact.fx).hypot(near.contact.fy - found.contact.fy);
            // Steady rolling stops earlier.
            let most = if found.substeps == 0 { 1e-4 } else { 1e-5 };
            assert!(moved <= most * limit, "step {step}: {}", moved / limit);
        }
        // Where nothing moves, nothing changes.
        let mut still = contact.clone();
        let same = PlanarCase { creepage: [0.0; 3], ..case };
        let rest = still.step(&same, &StepMotion::default()).unwrap();
        let moved = (rest.contact.fx - found.contact.fx).hypot(rest.contact.fy - found.contact.fy);
        let tolerance = if found.substeps == 0 { 1e-4 } else { 2e-6 };
        assert!(moved <= tolerance * limit, "step {step}: {}", moved / limit);
        before = Some(found);
    }
    assert!(before.is_some() && patches.iter().all(|&n| n >= 5) && ended >= 5, "{patches:?}");
    // Ninety substeps at most.
    assert!(most_sweeps < 8000, "{most_sweeps}");
}

#[test]
fn where_the_way_of_solving_changes_forces_do_not() {
    let separation = sphere(0.3, 0.02);
    let size = 6e-4;
    let case = PlanarCase {
        creepage: [0.002, -0.001, 0.3],
        ..case(&separation, 0.46, Indentation::Approach(8e-5), 0.3, STEEL)
    };
    let mut contact = TransientContact::with_element_size([size; 2]).unwrap();
    let first = contact.step(&case, &shifted(4e-6, 8e-6)).unwrap();
    let length = contact.field().unwrap().contact.grid.along as f64 * size;
    let limit = 0.3 * first.contact.normal_force;
    let history = contact.history().clone();
    // One substep and two; two and three; at the length of the contact; where substeps begin to
    // grow, and where tractions are carried; where the step is steady rolling.
    let grown = length + 11.0 * size;
    let changes = [size, 2.0 * size, length, grown, 1.7 * length, 20.0 * length];
    for (n, distance) in changes.into_iter().enumerate() {
        let [below, above] = [1.0 - 1e-6, 1.0 + 1e-6].map(|factor| {
            contact.set_history(history.clone());
            contact.step(&case, &rolled(factor * distance)).unwrap()
        });
        assert!(n > 1 && n < 5 || below.substeps != above.substeps, "{n}");
        let jump = (above.contact.fx - below.contact.fx).hypot(above.contact.fy - below.contact.fy);
        // Two substeps of half an element are more exact than one; the steady model stops earlier.
        let most = [5e-4, 5e-4, 1e-4, 1e-4, 1e-5, 1e-4][n];
        assert!(jump < most * limit, "{n}: {:e}", jump / limit);
    }
}

#[test]
fn a_closed_path_of_shifts_costs_work() {
    let separation = sphere(0.3, 0.02);
    let case = case(&separation, 0.3, Indentation::Approach(8e-5), 0.3, STEEL);
    let mut random = Random::new(7);
    for _ in 0..6 {
        let mut contact = TransientContact::with_element_size([5e-4; 2]).unwrap();
        let path: Vec<[f64; 2]> =
            (0..5).map(|_| [random.about(8e-6), random.about(8e-6)]).collect();
        let limit = 0.3 * contact.step(&case, &shifted(0.0, 0.0)).unwrap().contact.normal_force;
        let (mut at, mut spent, mut rounds) = ([0.0; 2], 0.0, Vec::new());
        let mut force = [0.0; 2];
        for _ in 0..2 {
            spent = 0.0;
            for point in path.iter().chain([&[0.0; 2]]) {
                let parts = 8;
                let step = [0, 1].map(|c| (point[c] - at[c]) / f64::from(parts));
                for _ in 0..parts {
                    let found = contact.step(&case, &shifted(step[0], step[1])).unwrap();
                    let now = [found.contact.fx, found.contact.fy];
                    for c in 0..2 {
                        spent -= 0.5 * (force[c] + now[c]) * step[c];
                    }
                    force = now;
                    assert!(found.work >= 0.0);
                }
                at = *point;
            }
            rounds.push(force);
        }
        // The second round ends as it began, so that all that is spent goes into friction.
        let change = (rounds[1][0] - rounds[0][0]).hypot(rounds[1][1] - rounds[0][1]);
        assert!(spent > 0.0 && change < 0.02 * limit, "{spent} {change} of {limit}");
    }
}
