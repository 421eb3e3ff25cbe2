//! Cattaneo and Mindlin, Mindlin and Deresiewicz, Carter, and the steady answer in the end.

use std::f64::consts::PI;

use super::*;
use crate::common::planar::{STEEL, hertzian_bodies};
use crate::common::summary::Summary;
use wheelrail::boundary_element::rolling::steady_rolling_within;
use wheelrail::material::MaterialPair;
use wheelrail::planar::solve;

/// Rubber sphere of 50 mm on a plane, pressed to a circle of 1 mm.
struct Mindlin {
    separation: Vec<[f64; 2]>,
    /// Greatest shift before all slides [m].
    full: f64,
    /// Friction limit [N].
    limit: f64,
}

const LOAD: f64 = 9.1954;
const MU: f64 = 0.4;
const A: f64 = 1e-3;
const FORTY_ACROSS: [f64; 2] = [5e-5; 2];

impl Mindlin {
    fn new() -> Self {
        let (shear, nu) = (2e8, 0.42);
        let full = 3.0 * MU * LOAD / (16.0 * A) * 2.0 * (2.0 - nu) / shear;
        Self { separation: sphere(0.05, 4e-3), full, limit: MU * LOAD }
    }

    fn case(&self) -> PlanarCase<'_> {
        case(&self.separation, 0.05, Indentation::Load(LOAD), MU, material(2e8, 0.42))
    }

    /// Shift under a force that grows from nothing to `share` of the limit.
    fn loaded(&self, share: f64) -> f64 {
        self.full * (1.0 - (1.0 - share).powf(2.0 / 3.0))
    }

    /// Shift under a force that came from `most` down to `share` of the limit.
    fn unloaded(&self, share: f64, most: f64) -> f64 {
        self.loaded(most) - 2.0 * self.loaded(0.5 * (most - share))
    }
}

#[test]
fn a_sphere_under_a_tangential_force_sticks_and_shifts_as_cattaneo_and_mindlin_have_it() {
    let mindlin = Mindlin::new();
    let case = mindlin.case();
    let mut contact = TransientContact::with_element_size(FORTY_ACROSS).unwrap();
    let mut summary = Summary::new("transient_mindlin");
    let (mut radii, mut shifts) = (Vec::new(), Vec::new());
    for share in [0.25, 0.5, 0.75, 0.875] {
        // From rest at once, and in two steps.
        for parts in [vec![share], vec![0.4 * share, share]] {
            contact.set_history(
                TransientContact::with_element_size(FORTY_ACROSS).unwrap().history().clone(),
            );
            let mut shift = 0.0;
            for part in parts {
                let force = [None, Some(-part * mindlin.limit)];
                let step = StepMotion { force, ..StepMotion::default() };
                let found = contact.step(&case, &step).unwrap();
                assert!(found.converged);
                assert!((found.contact.fy + part * mindlin.limit).abs() < 2e-6 * mindlin.limit);
                shift += found.displacement[1];
                assert_obeys(contact.field().unwrap(), &case, &found);
            }
            let sticks = contact.field().unwrap().contact.adherence.iter();
            let sticks = sticks.filter(|&&of| of == Adherence::Adhesion).count() as f64;
            let radius = (sticks * FORTY_ACROSS[0] * FORTY_ACROSS[1] / PI).sqrt();
            let expected = A * (1.0 - share).powf(1.0 / 3.0);
            radii.push(100.0 * (radius - expected) / A);
            shifts.push(100.0 * (shift / mindlin.loaded(share) - 1.0));
        }
    }
    let most = |errors: &[f64]| errors.iter().fold(0.0_f64, |most, e| most.max(e.abs()));
    summary.add("stick radius [% of the contact radius]", radii.clone(), "1");
    summary.add("shift [%]", shifts.clone(), "1");
    summary.write();
    assert!(most(&radii) < 1.0, "{radii:?}");
    assert!(most(&shifts) < 0.3, "{shifts:?}");
}

#[test]
fn a_loop_of_load_and_unload_closes_on_that_of_mindlin_and_deresiewicz() {
    let mindlin = Mindlin::new();
    let case = mindlin.case();
    let most = 0.875;
    let mut contact = TransientContact::with_element_size(FORTY_ACROSS).unwrap();
    let (mut shift, mut force) = (0.0, 0.0);
    let mut go = |share: f64, shift: &mut f64, force: &mut f64| {
        let given =
            StepMotion { force: [Some(-share * mindlin.limit), None], ..Default::default() };
        let found = contact.step(&case, &given).unwrap();
        let area = 0.5 * (*force + found.contact.fx) * found.displacement[0];
        *shift += found.displacement[0];
        *force = found.contact.fx;
        (area, found.work)
    };
    go(most, &mut shift, &mut force);
    let (top, count) = (shift, 16);
    let (mut area, mut work, mut worst) = (0.0, 0.0, 0.0_f64);
    for sign in [1.0, -1.0] {
        for k in 1..=count {
            let share = sign * (most - 2.0 * most * f64::from(k) / f64::from(count));
            let (a, w) = go(share, &mut shift, &mut force);
            (area, work) = (area - a, work + w);
            let expected = sign * mindlin.unloaded(sign * share, most);
            worst = worst.max((shift - expected).abs() / mindlin.full);
        }
    }
    // Between the points the shift bends: the area of the closed form by the same rule.
    let mut expected = 0.0;
    for k in 0..count {
        let at = |k: i32| most - 2.0 * most * f64::from(k) / f64::from(count);
        let mean = 0.5 * (at(k) + at(k + 1)) * mindlin.limit;
        let step = mindlin.unloaded(at(k + 1), most) - mindlin.unloaded(at(k), most);
        expected += 2.0 * mean * step;
    }
    let mut summary = Summary::new("transient_loop");
    summary.add("shift along the loop [% of that at which all slides]", [100.0 * worst], "1");
    summary.add("area of the loop [%]", [100.0 * (area / expected - 1.0)], "1");
    summary.add(
        "gap of the loop [% of its area over force]",
        [100.0 * gap(shift, top, area, &mindlin)],
        "1",
    );
    summary.write();
    assert!(worst < 0.004, "{worst}");
    assert!((area / expected - 1.0).abs() < 0.012, "{area} {expected}");
    assert!(gap(shift, top, area, &mindlin) < 0.002);
    // What went in as work of the force is what friction took, but for the rule of the area.
    assert!((work / area - 1.0).abs() < 0.03, "{work} {area}");
}

/// What the loop misses, over its mean width.
fn gap(shift: f64, top: f64, area: f64, mindlin: &Mindlin) -> f64 {
    (shift - top).abs() * mindlin.limit / area
}

#[test]
fn a_long_ellipse_rolls_from_rest_to_carter() {
    // Half length 1 mm, ten times as wide; in the middle row Carter's solution of that row.
    let load = 6e3;
    let (radius, separation) = hertzian_bodies(1e-3, 1e-2, load);
    let friction = 0.3;
    let dx = 5e-5;
    let case = PlanarCase {
        creepage: [-0.0006, 0.0, 0.0],
        ..case(&separation, radius, Indentation::Load(load), friction, STEEL)
    };
    let mut contact = TransientContact::with_element_size([dx, 5e-4]).unwrap();
    let mut before = 0.0;
    for n in [1, 10, 30, 60, 1200] {
        let found = contact.step(&case, &rolled(f64::from(n) * dx)).unwrap();
        assert!(found.converged && found.contact.fx > before, "{found:?} after {before}");
        assert_obeys(contact.field().unwrap(), &case, &found);
        before = found.contact.fx;
    }
    let field = &contact.field().unwrap().contact;
    let grid = field.grid;
    let middle = (0..grid.across).min_by(|a, b| grid.y(*a).abs().total_cmp(&grid.y(*b).abs()));
    let row = middle.unwrap() * grid.along;
    let sticks = (row..row + grid.along).filter(|&k| field.adherence[k] == Adherence::Adhesion);
    let stick = sticks.count() as f64 * dx;
    let p0 = field.pressure[row..row + grid.along].iter().copied().fold(0.0, f64::max);
    let force = (row..row + grid.along).map(|k| field.traction[k][0]).sum::<f64>();
    let limit = (row..row + grid.along).map(|k| friction * field.pressure[k]).sum::<f64>();
    // Creepage over that at which all slides, 2 μ p0/E* of plane strain: what sticks, and the force.
    let material = MaterialPair::new(STEEL, STEEL);
    let share = 0.0006 * material.contact_modulus / (2.0 * friction * p0);
    let expected = 1.0 - share;
    let length = field.pressure[row..row + grid.along].iter().filter(|&&p| p > 0.0).count() as f64;
    assert!((stick / (length * dx) - expected).abs() < 0.05, "{stick} {length} {expected}");
    assert!(
        (force / limit - (1.0 - expected * expected)).abs() < 0.03,
        "{} {expected}",
        force / limit
    );

    // Steady rolling on the same elements.
    let bound: Vec<f64> = field.pressure.iter().map(|p| friction * p).collect();
    let rigid = vec![[-0.0006, 0.0]; grid.len()];
    let steady = steady_rolling_within(1e-10, &grid, &material, &bound, &rigid);
    let sum = steady.x.iter().sum::<f64>() * grid.element_area();
    let error = (sum - before) / (friction * load);
    let worst = (0..grid.len()).map(|k| (steady.x[k] - field.traction[k][0]).abs());
    let worst = worst.fold(0.0, f64::max) / (friction * p0);
    assert!(error.abs() < 1e-6 && worst < 1e-5, "{error:e} {worst:e}");
}

#[test]
fn a_metre_and_many_steps_end_in_the_steady_answer() {
    let separation = sphere(0.3, 0.02);
    let mut summary = Summary::new("transient_steady");
    let (mut at_once, mut slowly, mut stopped) = (Vec::new(), Vec::new(), Vec::new());
    for creepage in [[0.001, 0.0, 0.0], [0.0, -0.002, 0.3], [0.004, 0.003, -1.0], [0.0, 0.0, 0.4]] {
        let case = PlanarCase {
            creepage,
            elements: [24, 24],
            ..case(&separation, 0.46, Indentation::Approach(1e-4), 0.3, STEEL)
        };
        let expected = solve(&case).unwrap();
        let limit = 0.3 * expected.normal_force;
        let difference = |found: &TransientResult| {
            (found.contact.fx - expected.fx).hypot(found.contact.fy - expected.fy) / limit
        };
        let mut contact = TransientContact::new();
        let metre = contact.step(&case, &rolled(1.0)).unwrap();
        at_once.push(100.0 * difference(&metre));
        assert!((metre.contact.normal_force / expected.normal_force - 1.0).abs() < 1e-12);
        assert!((metre.contact.mz - expected.mz).abs() < 1e-6 * limit * expected.length);

        // Twenty lengths from rest, in steps that fit no elements.
        contact = TransientContact::new();
        let mut last = metre;
        for _ in 0..40 {
            last = contact.step(&case, &rolled(0.5 * expected.length)).unwrap();
        }
        stopped.push(100.0 * difference(&last));
        let field = &contact.field().unwrap().contact;
        let grid = field.grid;
        let bound: Vec<f64> = field.pressure.iter().map(|p| 0.3 * p).collect();
        let rigid: Vec<[f64; 2]> = (0..grid.len())
            .map(|k| (grid.x(k % grid.along), grid.y(k / grid.along)))
            .map(|(x, y)| [creepage[0] - creepage[2] * y, creepage[1] + creepage[2] * x])
            .collect();
        let material = MaterialPair::new(STEEL, STEEL);
        let tight = steady_rolling_within(1e-10, &grid, &material, &bound, &rigid);
        let sum = |p: &[f64]| p.iter().sum::<f64>() * grid.element_area();
        let error = (sum(&tight.x) - last.contact.fx).hypot(sum(&tight.y) - last.contact.fy);
        slowly.push(100.0 * error / limit);
    }
    let most = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
    summary.add("a metre against the steady model", at_once.clone(), "1e-4");
    summary.add("many steps against the steady model, iterated to the end", slowly.clone(), "1e-4");
    summary.add("the same against the steady model as it stops", stopped.clone(), "");
    summary.write();
    assert!(most(&at_once) < 1e-4, "{at_once:?}");
    assert!(most(&slowly) < 1e-4, "{slowly:?}");
    assert!(most(&stopped) < 0.02, "{stopped:?}");
}
