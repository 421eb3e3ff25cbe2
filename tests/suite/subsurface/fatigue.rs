//! Shakedown limits of lines and circles, Dang Van's stress and maps of passages.

use super::*;
use crate::common::planar::steel_case;
use wheelrail::fatigue::{ContactFatigue, DangVan, FatigueMap, Response, Strength};
use wheelrail::planar::{PlanarCase, TangentialModel};
use wheelrail::subsurface::{Body, evenly};

fn fatigue(load: &SurfaceLoad, force: [f64; 3], area: f64, strength: &Strength) -> ContactFatigue {
    ContactFatigue::below(load, force, area, strength).unwrap().expect("a load")
}

/// Shear stress τ_xz below a line contact of half width and pressure 1 that slips with friction `f`:
/// McEwen's formulas (Johnson 1985, eqs 4.49 and 7.8).
fn line_shear(x: f64, z: f64, f: f64) -> f64 {
    let sum = 1.0 - x * x + z * z;
    let root = (sum * sum + 4.0 * x * x * z * z).sqrt();
    let (m, n) = ((0.5 * (root + sum)).sqrt(), (0.5 * (root - sum)).sqrt() * x.signum());
    let square = m * m + n * n;
    let pressed = -n * (m * m - z * z) / square;
    let along = -(m * (1.0 + (z * z + n * n) / square) - 2.0 * z);
    pressed + f * along
}

/// An ellipse that is a line of half width and pressure 1 but for a thousandth.
fn long(friction: f64) -> ContactFatigue {
    let load = ellipse([1.0, LENGTH], 40, [friction, 0.0, 1.0], BOOK);
    let normal = 2.0 * PI / 3.0 * LENGTH;
    fatigue(&load, [friction * normal, 0.0, normal], PI * LENGTH, &Strength::default())
}

/// Half the length of it.
const LENGTH: f64 = 30.0;

#[test]
fn lines_shake_down_up_to_the_known_limits() {
    for friction in [0.0, 0.2, 0.5] {
        let own = long(friction);
        let places = evenly(-2.0, 2.0, 801).into_iter();
        let shears = places.flat_map(|x| evenly(1e-9, 2.0, 401).into_iter().map(move |z| (x, z)));
        let greatest = shears.map(|(x, z)| line_shear(x, z, friction).abs()).fold(0.0, f64::max);
        let error = own.shakedown_limit * greatest - 1.0;
        assert!(error.abs() < tolerance::FATIGUE_LIMIT, "{friction}: {own:?} {greatest}");
        assert!((own.used_friction - friction).abs() < 1e-12);
        // Known figures: 4 without friction, 1/f where the surface decides.
        let known =
            if friction < 0.1 { Some(4.0) } else { (friction > 0.4).then_some(1.0 / friction) };
        if let Some(known) = known {
            assert!(
                (own.shakedown_limit / known - 1.0).abs() < tolerance::FATIGUE_LIMIT,
                "{own:?}"
            );
        }
        assert!(own.elastic_limit < own.shakedown_limit);
        if friction <= 0.0 {
            // First yield by von Mises: 0.558 p0 at 0.70 half widths.
            assert!((own.elastic_limit / 3.1 - 1.0).abs() < tolerance::FATIGUE_KNOWN, "{own:?}");
        }
    }
}

#[test]
fn a_circle_shakes_down_at_the_known_limit_and_responds_by_its_load() {
    let load = ellipse([1.0, 1.0], 24, [0.0, 0.0, 1.0], BOOK);
    let force = [0.0, 0.0, 2.0 * PI / 3.0];
    for (shear_yield, response) in
        [(1.0, Response::Elastic), (0.25, Response::Shakedown), (0.2, Response::Plastic)]
    {
        let mut strength = Strength::default();
        strength.shear_yield = shear_yield;
        let own = fatigue(&load, force, PI, &strength);
        assert_eq!(own.response, response, "{own:?}");
        // 4.7 (Ponter, Hearle and Johnson 1985); first yield 2.8 by von Mises.
        assert!((own.shakedown_limit / 4.7 - 1.0).abs() < tolerance::FATIGUE_KNOWN, "{own:?}");
        assert!((own.elastic_limit / 2.8 - 1.0).abs() < tolerance::FATIGUE_KNOWN, "{own:?}");
        // Without friction the surface does not ratchet: -2 k/(3 p_mean).
        assert!((own.surface_index + shear_yield).abs() < 1e-3 * shear_yield, "{own:?}");
        assert!((own.subsurface_index - 1.0 / 6.0).abs() < 1e-3, "{own:?}");
    }
}

#[test]
fn the_stress_of_dang_van_is_near_the_estimate_for_ellipses() {
    let strength = Strength::default();
    for axes in [[1.0, 1.0], [1.0, 2.0], [2.0, 1.0]] {
        for friction in [0.0, 0.2] {
            let load = ellipse(axes, 24, [friction, 0.0, 1.0], BOOK);
            let normal = 2.0 * PI / 3.0 * axes[0] * axes[1];
            let area = PI * axes[0] * axes[1];
            let own = fatigue(&load, [friction * normal, 0.0, normal], area, &strength);
            let share = own.dang_van.value / own.subsurface_index;
            assert!(
                (share - 1.0).abs() < tolerance::FATIGUE_ESTIMATE,
                "{axes:?} {friction} {own:?}"
            );
            // No place beside it is worse.
            let judged = DangVan::new(&load, &strength).unwrap();
            let [y, depth] = own.dang_van.place;
            for [dy, dz] in [[0.05, 0.0], [-0.05, 0.0], [0.0, 0.05], [0.0, -0.05]] {
                assert!(judged.at([y + dy, depth + dz]) <= own.dang_van.value * (1.0 + 1e-9));
            }
        }
    }
}

#[test]
fn weight_and_residual_stress_move_the_stress_of_dang_van_as_they_say() {
    let load = ellipse([1.0, 1.5], 20, [0.1, 0.05, 1.0], BOOK);
    let mut strength = Strength::default();
    let at = |strength: &Strength| DangVan::new(&load, strength).unwrap().at([0.2, 0.5]);
    let plain = at(&strength);
    strength.residual = -0.3;
    assert!((at(&strength) - plain + 0.1).abs() < 1e-12);
    (strength.dang_van, strength.residual) = (0.0, -0.3);
    // Compression counts in the body's favour.
    assert!(at(&strength) >= plain);
}

#[test]
fn a_map_keeps_the_worst_and_counts_passages_where_they_went() {
    let load = ellipse([1e-3, 2e-3], 16, [0.1, 0.0, 1e9], BOOK);
    let mut strength = Strength::default();
    (strength.shear_yield, strength.endurance) = (2e8, Some(1e8));
    let arcs = evenly(-0.02, 0.02, 81);
    let depths = evenly(0.25e-3, 4e-3, 16);
    let mut map = FatigueMap::new(arcs.clone(), depths.clone(), strength).unwrap();
    let empty = map.clone();
    let (left, right) = (map.passage(&load, -0.01), map.passage(&load, 0.01));
    map.add(&left, 0.0).unwrap();
    assert_eq!(map, empty, "no passage leaves no trace");
    map.add(&left, 3.0).unwrap();
    map.add(&right, 2.0).unwrap();
    map.add(&left, 1.0).unwrap();
    let at = |i: usize, j: usize| map.cells()[i * depths.len() + j];
    let judged = DangVan::new(&load, &strength).unwrap();
    let mut counted = [0; 2];
    for (i, arc) in arcs.iter().enumerate() {
        for (j, depth) in depths.iter().enumerate() {
            let (own, other) = (at(i, j), at(arcs.len() - 1 - i, j));
            // A place at a distance from one contact is as one beyond the other: the load is the
            // same, and its tractions have no part across.
            let apart = own.dang_van - other.dang_van;
            assert!(apart.abs() < 1e-6 * 1e9, "{arc} {depth}: {own:?} {other:?}");
            let [near, passages] = if *arc < 0.0 { [-0.01, 4.0] } else { [0.01, 2.0] };
            if (arc - near).abs() < 2.5e-3 {
                let alone = judged.at([arc - near, *depth]);
                assert!((own.dang_van - alone.max(0.0)).abs() < 1e-6 * alone.abs());
                for (k, (count, beyond)) in
                    [(own.beyond_endurance, alone > 1e8), (own.plastic, own.shear > 2e8)]
                        .into_iter()
                        .enumerate()
                {
                    assert!((count - if beyond { passages } else { 0.0 }).abs() < 1e-12);
                    counted[k] += usize::from(beyond);
                }
            }
        }
    }
    assert!(counted.iter().all(|count| *count > 10), "{counted:?}");
    assert!(at(40, 3).dang_van.abs() < 1e-3, "nothing came near the middle");
    let message = map.add(&left, f64::NAN).unwrap_err().to_string();
    assert!(message.contains("passages = NaN"), "{message}");
}

#[test]
fn strengths_and_models_without_tractions_are_refused_by_name() {
    let mut strength = Strength::default();
    strength.shear_yield = -1.0;
    let load = ellipse([1.0, 1.0], 4, [0.0, 0.0, 1.0], BOOK);
    let message = ContactFatigue::below(&load, [0.0, 0.0, 1.0], 1.0, &strength).unwrap_err();
    assert!(message.to_string().contains("shear_yield = -1"), "{message}");
    let message = FatigueMap::new(vec![0.0], vec![-1.0], Strength::default()).unwrap_err();
    assert!(message.to_string().contains("depth = -1"), "{message}");
    let separation: Vec<[f64; 2]> =
        evenly(-0.01, 0.01, 201).into_iter().map(|y| [y, 2.0 * y * y]).collect();
    let case = PlanarCase {
        tangential_model: TangentialModel::Linear,
        ..steel_case(&separation, 0.46, 5e-5)
    };
    let message = ContactFatigue::of(&case, Body::Rail, &Strength::default()).unwrap_err();
    assert!(message.to_string().contains("linear"), "{message}");
}
