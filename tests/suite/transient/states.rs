//! Contacts that begin, end, split, merge and move; given forces; histories; refusals.

use super::*;
use crate::common::planar::STEEL;
use wheelrail::error::ContactError;
use wheelrail::planar::{FrictionLaw, History, StripFriction, solve};

/// Lobes at ±`place`, the right one `higher` [m] than the left.
fn lobes(place: f64, higher: f64) -> Vec<[f64; 2]> {
    (-150..=150)
        .map(|i| 1.6e-4 * f64::from(i))
        .map(|y| {
            let (left, right) = (y + place, y - place);
            [y, (left * left / 0.3).min(right * right / 0.3 + higher)]
        })
        .collect()
}

const SIZE: [f64; 2] = [4e-4, 4e-4];

#[test]
fn zones_split_and_merge_without_jumps() {
    // The ridge between two lobes 6 mm apart is 20 μm above them.
    let separation: Vec<[f64; 2]> = (-100..=100)
        .map(|i| 1e-4 * f64::from(i))
        .map(|y| [y, 2e-5 * (1.0 - (y / 3e-3).powi(2)).powi(2)])
        .collect();
    let mut contact = TransientContact::with_element_size(SIZE).unwrap();
    let mut before: Option<TransientResult> = None;
    let (mut seen, mut greatest) = (Vec::new(), 0.0_f64);
    for n in 0..110 {
        let approach = 4e-5 + 3e-5 * (f64::from(n) * 0.08).sin();
        let case = PlanarCase {
            creepage: [0.001, 0.0005, 0.0],
            ..case(&separation, 0.45, Indentation::Approach(approach), 0.3, STEEL)
        };
        let found = contact.step(&case, &rolled(2e-4)).unwrap();
        assert!(found.converged);
        assert_obeys(contact.field().unwrap(), &case, &found);
        if let Some(before) = before {
            let load = found.contact.normal_force - before.contact.normal_force;
            let limit = 0.3 * found.contact.normal_force;
            let change =
                (found.contact.fx - before.contact.fx).hypot(found.contact.fy - before.contact.fy);
            // Rolled distance and the load that comes and goes bring changes, merging does not.
            let expected = 0.3 * load.abs() + 0.06 * limit;
            assert!(change < expected, "state {n}: {change} of {limit}, load by {load}");
            if before.contact.patches != found.contact.patches {
                seen.push(found.contact.patches);
                greatest = greatest.max(change / limit);
            }
        }
        before = Some(found);
    }
    assert!(seen.contains(&1) && seen.contains(&2) && seen.len() >= 3, "{seen:?}");
    assert!(greatest < 0.06, "{greatest}");
}

#[test]
fn a_new_contact_has_no_history() {
    // The right lobe is reached late, and far enough away to feel the left one little.
    let separation = lobes(1.2e-2, 3e-5);
    let mut contact = TransientContact::with_element_size(SIZE).unwrap();
    let state = |approach: f64| PlanarCase {
        creepage: [0.0012, 0.0, 0.0],
        ..case(&separation, 0.45, Indentation::Approach(approach), 0.3, STEEL)
    };
    for _ in 0..60 {
        contact.step(&state(2.5e-5), &rolled(4e-4)).unwrap();
    }
    assert_eq!(contact.step(&state(2.5e-5), &rolled(4e-4)).unwrap().contact.patches, 1);
    let alone: Vec<[f64; 2]> = separation.iter().copied().filter(|point| point[0] > 1e-3).collect();
    let mut fresh = TransientContact::with_element_size(SIZE).unwrap();
    for n in 0..12 {
        let found = contact.step(&state(6e-5), &rolled(4e-4)).unwrap();
        assert_eq!(found.contact.patches, 2);
        let field = &contact.field().unwrap().contact;
        let area = field.grid.element_area();
        // Its load is less than that of the lobe alone, which the left one does not press down.
        let on_right = (0..field.grid.len())
            .filter(|k| field.grid.y(k / field.grid.along) > 1e-3)
            .map(|k| [area * field.traction[k][0], area * field.pressure[k]]);
        let [force, load] = on_right.fold([0.0; 2], |sum, k| [sum[0] + k[0], sum[1] + k[1]]);
        let case = PlanarCase { separation: &alone, ..state(6e-5) };
        let expected = fresh.step(&case, &rolled(4e-4)).unwrap();
        let limit = 0.3 * expected.contact.normal_force;
        let error = force / (0.3 * load) - expected.contact.fx / limit;
        assert!(error.abs() < 0.06, "state {n}: {error}");
        assert!(n > 0 || expected.contact.fx.abs() < 0.3 * limit);
    }
}

#[test]
fn what_lifts_off_forgets() {
    let separation = sphere(0.3, 0.02);
    let mut contact = TransientContact::with_element_size(SIZE).unwrap();
    let state = |approach: f64| PlanarCase {
        creepage: [0.001, 0.001, 0.1],
        ..case(&separation, 0.45, Indentation::Approach(approach), 0.3, STEEL)
    };
    let first = contact.step(&state(5e-5), &rolled(3e-4)).unwrap();
    let second = contact.step(&state(5e-5), &rolled(3e-4)).unwrap();
    assert!(second.contact.fx.abs() > 1.5 * first.contact.fx.abs());
    let lifted = contact.step(&state(-1e-6), &rolled(3e-4)).unwrap();
    assert!(lifted.contact.patches == 0 && contact.field().is_none());
    assert_eq!(contact.step(&state(5e-5), &rolled(3e-4)).unwrap(), first);
}

#[test]
fn a_contact_that_moves_sideways_takes_its_tractions_along() {
    // Along the rail nothing changes but the place of the contact on the particles.
    let place = |y: f64| -> Vec<[f64; 2]> {
        sphere(0.3, 0.02).iter().map(|point| [point[0] + y, point[1]]).collect()
    };
    let mut contact = TransientContact::with_element_size([2e-4; 2]).unwrap();
    let at = place(0.0);
    let state = case(&at, 0.3, Indentation::Approach(5e-5), 0.3, STEEL);
    let before = contact.step(&state, &shifted(-2e-6, 0.0)).unwrap();
    let limit = 0.3 * before.contact.normal_force;
    let mut last = before.contact.fx;
    for n in 1..=60 {
        let moved = place(2e-4 * f64::from(n));
        let case = PlanarCase { separation: &moved, ..state };
        let found = contact.step(&case, &StepMotion::default()).unwrap();
        assert_obeys(contact.field().unwrap(), &case, &found);
        // Fresh particles on one side, loaded ones left behind on the other.
        assert!(found.contact.fx < last + 1e-6 * limit, "{n}: {} after {last}", found.contact.fx);
        assert!(last - found.contact.fx < 0.05 * limit);
        last = found.contact.fx;
    }
    assert!(last < 0.2 * before.contact.fx, "{last} of {}", before.contact.fx);
}

#[test]
fn given_forces_are_carried_and_their_creepage_becomes_the_steady_one() {
    let separation = sphere(0.3, 0.02);
    let state = PlanarCase {
        creepage: [0.0, 0.0, 0.2],
        elements: [20, 20],
        ..case(&separation, 0.45, Indentation::Load(2e4), 0.3, STEEL)
    };
    for share in
        [[Some(-0.4), None], [None, Some(0.7)], [Some(0.5), Some(-0.5)], [Some(0.95), None]]
    {
        let force = share.map(|share: Option<f64>| share.map(|share| share * 0.3 * 2e4));
        let mut contact = TransientContact::new();
        let mut found = TransientResult::default();
        let step = 1.2e-3;
        for _ in 0..40 {
            let motion = StepMotion { rolled: step, force, ..StepMotion::default() };
            found = contact.step(&state, &motion).unwrap();
            for (force, carried) in force.iter().zip([found.contact.fx, found.contact.fy]) {
                let missing = force.map_or(0.0, |force| force - carried);
                assert!(missing.abs() < 2e-6 * 6e3, "{share:?}: {missing}");
            }
        }
        let [x, y, _] = found.displacement.map(|d| d / step);
        let steady = solve(&PlanarCase { creepage: [x, y, 0.2], ..state }).unwrap();
        let error = (steady.fx - found.contact.fx).hypot(steady.fy - found.contact.fy);
        assert!(error < 1e-3 * 6e3, "{share:?}: {}", error / 6e3);
        // At once as steady rolling.
        let motion = StepMotion { rolled: 2.0, force, ..StepMotion::default() };
        let at_once = contact.step(&state, &motion).unwrap();
        assert_eq!(at_once.substeps, 0);
        let [a, b, _] = at_once.displacement.map(|d| d / 2.0);
        assert!((a - x).hypot(b - y) < 1e-3 * x.hypot(y), "{share:?}: {a} {b} of {x} {y}");
    }
}

#[test]
fn backward_rolling_is_the_mirror_image_of_forward_rolling() {
    let separation = sphere(0.3, 0.02);
    let state = |creepage: [f64; 3]| PlanarCase {
        creepage,
        ..case(&separation, 0.45, Indentation::Approach(6e-5), 0.3, STEEL)
    };
    let mut ahead = TransientContact::with_element_size(SIZE).unwrap();
    let mut back = TransientContact::with_element_size(SIZE).unwrap();
    // A turn of direction, substeps, and steady rolling.
    for distance in [3e-4, 1.1e-3, -2e-4, -9e-3, 0.0, 2.0] {
        let [x, y, spin] = [0.0015, -0.001, 0.3];
        let found = ahead.step(&state([x, y, spin]), &rolled(distance)).unwrap();
        let seen = back.step(&state([-x, y, -spin]), &rolled(-distance)).unwrap();
        let limit = 0.3 * found.contact.normal_force;
        let expected = [-found.contact.fx, found.contact.fy, -found.contact.mz];
        let seen_forces = [seen.contact.fx, seen.contact.fy, seen.contact.mz];
        for (k, (a, b)) in seen_forces.into_iter().zip(expected).enumerate() {
            assert!((a - b).abs() < 1e-7 * limit, "{distance}, {k}: {a} {b}");
        }
        assert!((seen.work - found.work).abs() <= 1e-4 * found.work + 1e-8);
        assert_eq!(seen.substeps, found.substeps);
        assert!(distance == 0.0 || found.contact.fx.abs() > 0.01 * limit);
    }
    let steady = solve(&state([0.0015, -0.001, 0.3])).unwrap();
    let found = ahead.step(&state([0.0015, -0.001, 0.3]), &rolled(2.0)).unwrap();
    assert!((steady.fx - found.contact.fx).abs() < 0.01 * 0.3 * steady.normal_force);
}

#[test]
fn histories_are_numbers_and_come_back_to_the_bit() {
    let separation = sphere(0.3, 0.02);
    let state = PlanarCase {
        creepage: [0.002, 0.0, 0.2],
        elements: [20, 20],
        ..case(&separation, 0.45, Indentation::Load(2e4), 0.3, STEEL)
    };
    let mut contact = TransientContact::new();
    for _ in 0..3 {
        contact.step(&state, &rolled(7e-4)).unwrap();
    }
    let numbers = contact.history().to_numbers();
    let history = History::from_numbers(&numbers).unwrap();
    assert_eq!(&history, contact.history());
    let next = contact.step(&state, &rolled(7e-4)).unwrap();
    let mut other = TransientContact::new();
    other.set_history(history);
    assert_eq!(other.step(&state, &rolled(7e-4)).unwrap(), next);
    assert_eq!(other.history(), contact.history());
    let none = History::default().to_numbers();
    assert_eq!(History::from_numbers(&none).unwrap(), History::default());
    for broken in [&numbers[..9], &numbers[..numbers.len() - 1], &[f64::NAN; 20]] {
        let error = History::from_numbers(broken).unwrap_err().to_string();
        assert!(error.starts_with("history = "), "{error}");
    }
}

#[test]
fn friction_across_bounds_its_own_rows() {
    let separation = sphere(0.3, 0.02);
    let across = [(-1e-4, StripFriction::of(0.1)), (1e-4, StripFriction::of(0.5))];
    let state = PlanarCase {
        friction_across: &across,
        creepage: [0.05, 0.0, 0.0],
        ..case(&separation, 0.45, Indentation::Approach(5e-5), 0.3, STEEL)
    };
    let mut contact = TransientContact::with_element_size([4e-4, 4e-4]).unwrap();
    contact.step(&state, &rolled(1e-2)).unwrap();
    let field = &contact.field().unwrap().contact;
    for k in 0..field.grid.len() {
        let y = field.grid.y(k / field.grid.along);
        let expected = if y < -2e-4 {
            0.1
        } else if y > 2e-4 {
            0.5
        } else {
            0.3
        };
        let share = -field.traction[k][0] / field.pressure[k];
        assert!(field.pressure[k] == 0.0 || (share - expected).abs() < 0.01, "{y}: {share}");
    }
}

#[test]
fn refusals_name_the_variable_and_leave_the_history() {
    let separation = sphere(0.3, 0.02);
    let good = PlanarCase {
        creepage: [0.001, 0.0, 0.0],
        ..case(&separation, 0.45, Indentation::Load(2e4), 0.3, STEEL)
    };
    let mut contact = TransientContact::with_element_size(SIZE).unwrap();
    contact.step(&good, &rolled(1e-3)).unwrap();
    let before = contact.history().clone();
    let soft = Material { young_modulus: 1e11, ..STEEL };
    let far: Vec<[f64; 2]> = separation.iter().map(|point| [point[0] + 100.0, point[1]]).collect();
    let falling = FrictionLaw { falling_share: 0.4, falling_decay: 0.6, ..FrictionLaw::default() };
    let force = |force| StepMotion { rolled: 1e-3, force, ..StepMotion::default() };
    for (case, motion, expected) in [
        (good, rolled(-1e7), "rolled = -10000000 is not admitted"),
        (good, rolled(f64::NAN), "rolled = NaN"),
        (good, shifted(f64::INFINITY, 0.0), "shift_x = inf"),
        (good, force([Some(7e3), None]), "force_longitudinal = 7000"),
        (good, force([None, Some(f64::NAN)]), "force_lateral = NaN"),
        (good, force([Some(5e3), Some(5e3)]), "force_longitudinal = 5000"),
        (PlanarCase { friction: -0.1, ..good }, rolled(1e-3), "friction = -0.1"),
        (PlanarCase { wheel_material: soft, ..good }, rolled(1e-3), "wheel young_modulus = 1"),
        (PlanarCase { separation: &far, ..good }, rolled(1e-3), "separation y = "),
        (PlanarCase { friction_law: falling, ..good }, rolled(1e-3), "falling share = 0.4"),
        (
            PlanarCase { normal_model: NormalModel::Strips, ..good },
            rolled(1e-3),
            "normal_model = \"Strips\" is not admitted: BoundaryElement",
        ),
        (
            PlanarCase { tangential_model: TangentialModel::Fastsim, ..good },
            rolled(1e-3),
            "tangential_model = \"Fastsim\"",
        ),
        (
            PlanarCase { indentation: Indentation::Approach(-1e-5), ..good },
            force([Some(1.0), None]),
            "force_longitudinal = 1 is not admitted: 0 where there is no contact",
        ),
    ] {
        let error: ContactError = contact.step(&case, &motion).unwrap_err();
        let text = error.to_string();
        assert!(text.starts_with(expected), "{text} for {expected}");
        assert_eq!(contact.history(), &before, "{text}");
        assert!(contact.field().is_some());
    }
    for size in [[0.0, 1e-3], [1e-3, -1.0], [f64::NAN, 1e-3], [10.0, 1.0]] {
        assert!(TransientContact::with_element_size(size).is_err());
    }
    let mut fine = TransientContact::with_element_size([1e-6, 1e-4]).unwrap();
    let text = fine.step(&good, &rolled(1e-3)).unwrap_err().to_string();
    assert!(text.starts_with("element_length = 0.000001"), "{text}");
}
