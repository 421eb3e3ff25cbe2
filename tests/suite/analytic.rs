//! Against closed forms: Hertz, Piotrowski-Kik on a sphere, Kalker's linear theory, full sliding,
//! similarity.

use crate::tolerance;
use std::f64::consts::PI;

use crate::common::planar::{HertzRow, STEEL, parabola, steel_case, steel_modulus};
use approx::assert_relative_eq;
use wheelrail::element::parameters::{Flexibilities, NormalModel};
use wheelrail::material::Material;
use wheelrail::normal::hertz;
use wheelrail::planar::{Indentation, PlanarCase, PlanarResult, solve};
use wheelrail::tangential::TangentialModel;
use wheelrail::tangential::fastsim::TractionBound;
use wheelrail::tangential::kalker_coefficients::kalker_coefficients;

/// A tangential model that knows friction and, for FASTSIM, the shape of its bound.
type Method = (TangentialModel, TractionBound);
const METHODS: [Method; 3] = [
    (TangentialModel::Fastsim, TractionBound::Elliptic),
    (TangentialModel::Fastsim, TractionBound::Parabolic),
    (TangentialModel::Fastrip, TractionBound::Elliptic),
];

#[test]
fn the_hertz_model_is_exact_from_wide_to_slender() {
    let rows = HertzRow::all();
    assert!(rows.len() > 10);
    let mut worst: f64 = 0.0;
    for row in rows {
        let e = hertz::ellipse(row.along, row.across, row.approach, steel_modulus());
        let separation = row.separation();
        let planar = solve(&steel_case(&separation, 0.5 / row.along, row.approach)).unwrap();
        for (name, found, exact) in [
            ("ellipse a", e.semi_axis_along, row.semi_axes[0]),
            ("ellipse b", e.semi_axis_across, row.semi_axes[1]),
            ("ellipse N", e.load, row.load),
            ("ellipse p0", e.max_pressure, row.max_pressure),
            ("planar a", 0.5 * planar.length, row.semi_axes[0]),
            ("planar b", 0.5 * planar.width, row.semi_axes[1]),
            ("planar N", planar.normal_force, row.load),
            ("planar p0", planar.max_pressure, row.max_pressure),
            ("planar area", planar.area, row.area),
        ] {
            let error = (found / exact - 1.0).abs();
            worst = worst.max(error);
            assert!(error <= tolerance::HERTZ, "{name} is {error:e} off in {row:?}");
        }
    }
    println!("worst error of the Hertz model: {worst:e}");
}

#[test]
fn a_given_load_finds_the_approach_that_carries_it() {
    for ratio in [0.2, 1.0, 5.0] {
        let row = HertzRow::with_ratio(ratio);
        let separation = row.separation();
        let mut case = steel_case(&separation, 0.5 / row.along, 0.0);
        case.indentation = Indentation::Load(row.load);
        let found = solve(&case).unwrap();
        assert_relative_eq!(found.normal_force, row.load, max_relative = tolerance::SIMILARITY);
        assert_relative_eq!(found.max_pressure, row.max_pressure, max_relative = tolerance::HERTZ);
    }
}

#[test]
fn piotrowski_kik_on_a_sphere_meets_its_closed_form() {
    for (radius, approach) in [(0.3, 5e-5), (0.46, 1e-5), (0.46, 1.5e-4), (1.2, 1e-4)] {
        let semi_axis = f64::sqrt(radius * approach);
        let separation = parabola(0.5 / radius, semi_axis);
        for epsilon in [0.4, 0.55, 0.7] {
            let mut case = steel_case(&separation, radius, approach);
            case.normal_model = NormalModel::PiotrowskiKik;
            case.virtual_penetration = epsilon;
            case.strips = 30;
            let found = solve(&case).unwrap();
            let hertz = 4.0 / 3.0 * steel_modulus() * radius.sqrt() * approach.powf(1.5);
            let pressure = 1.5 * hertz / (PI * semi_axis * semi_axis);
            let factor = (2.0 * epsilon).sqrt();
            let close = tolerance::PIOTROWSKI_KIK_SPHERE;
            assert_relative_eq!(found.normal_force, factor * hertz, max_relative = close);
            assert_relative_eq!(found.max_pressure, pressure / factor, max_relative = close);
            let area = factor * factor * PI * semi_axis * semi_axis;
            assert_relative_eq!(found.area, area, max_relative = close);
        }
    }
}

#[test]
fn piotrowski_kik_on_a_slender_ellipse_differs_from_hertz_as_published() {
    let row = HertzRow::with_ratio(5.0);
    let separation = row.separation();
    let mut case = steel_case(&separation, 0.5 / row.along, row.approach);
    case.normal_model = NormalModel::PiotrowskiKik;
    case.strips = 30;
    let found = solve(&case).unwrap();
    for (name, ratio, published) in [
        ("N", found.normal_force / row.load, 1.022),
        ("p0", found.max_pressure / row.max_pressure, 1.0 - 0.133),
        ("area", found.area / row.area, 1.178),
    ] {
        let miss = (ratio - published).abs();
        println!("{name}: {ratio:.5} of Hertz, published {published}");
        assert!(miss <= tolerance::PIOTROWSKI_KIK_SLENDER, "{name}: {ratio} against {published}");
    }
}

/// Force of the ellipse of `row` for creepages so small that nothing slips, or as given.
fn creep_force(row: &HertzRow, method: Method, creepage: [f64; 3]) -> PlanarResult {
    let separation = row.separation();
    let mut case = steel_case(&separation, 0.5 / row.along, row.approach);
    case.creepage = creepage;
    (case.tangential_model, case.bound) = method;
    solve(&case).unwrap()
}

#[test]
fn the_linear_limit_is_kalkers_theory() {
    let shear_modulus = STEEL.shear_modulus();
    let mut worst: f64 = 0.0;
    for ratio in [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0] {
        let row = HertzRow::with_ratio(ratio);
        let c = kalker_coefficients(ratio, STEEL.poisson_ratio);
        let squared = row.semi_axes[0] * row.semi_axes[1];
        let small = 1e-9;
        for method in METHODS {
            let along = creep_force(&row, method, [small, 0.0, 0.0]).fx;
            let across = creep_force(&row, method, [0.0, small, 0.0]).fy;
            let spin = small / squared.sqrt();
            let turned = creep_force(&row, method, [0.0, 0.0, spin]);
            for (name, found, exact) in [
                ("c11", along, c.c11 * small),
                ("c22", across, c.c22 * small),
                ("c23", turned.fy, c.c23 * squared.sqrt() * spin),
            ] {
                let error = found / (-shear_modulus * squared * exact) - 1.0;
                worst = worst.max(error.abs());
                let close = tolerance::FASTSIM_LINEAR;
                assert!(error.abs() <= close, "{name} at a/b = {ratio}, {method:?}: {error:e} off");
            }
            assert!(turned.fx.abs() < tolerance::ROUNDING * turned.fy.abs());
        }
    }
    println!("worst error of the linear limit: {worst:e}");
}

#[test]
fn full_sliding_gives_friction_times_normal_force_against_the_slip() {
    for ratio in [0.2, 1.0, 5.0] {
        let row = HertzRow::with_ratio(ratio);
        let limit = 0.3 * row.load;
        for method in METHODS {
            for sign in [-1.0, 1.0] {
                let along = creep_force(&row, method, [sign * 10.0, 0.0, 0.0]);
                let across = creep_force(&row, method, [0.0, sign * 10.0, 0.0]);
                for (found, other) in [(along.fx, along.fy), (across.fy, across.fx)] {
                    assert_relative_eq!(
                        found,
                        -sign * limit,
                        max_relative = tolerance::FULL_SLIDING
                    );
                    assert!(other.abs() < tolerance::FULL_SLIDING * limit);
                }
            }
        }
    }
}

#[test]
fn blended_flexibilities_slide_straight_against_any_slip() {
    let row = HertzRow::with_ratio(2.0);
    let separation = row.separation();
    for degrees in (0..360).step_by(15) {
        let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
        let mut case = steel_case(&separation, 0.5 / row.along, row.approach);
        case.creepage = [2.0 * cosine, 2.0 * sine, 0.0];
        case.flexibilities = Flexibilities::Blended;
        let force = solve(&case).unwrap();
        let limit = 0.3 * row.load;
        assert!((force.fx / limit + cosine).abs() < tolerance::FULL_SLIDING, "{degrees} degrees");
        assert!((force.fy / limit + sine).abs() < tolerance::FULL_SLIDING, "{degrees} degrees");
    }
}

#[test]
fn creep_forces_oppose_the_slip_and_stay_below_the_limit() {
    for ratio in [0.2, 1.0, 5.0] {
        let row = HertzRow::with_ratio(ratio);
        let spin_scale = 1.0 / (row.semi_axes[0] * row.semi_axes[1]).sqrt();
        for method in METHODS {
            for size in [1e-5, 1e-3, 3e-3, 1e-2] {
                for step in 0..64 {
                    // Directions spread over the sphere of creepages.
                    let height = 1.0 - (f64::from(step) + 0.5) / 32.0;
                    let (sine, cosine) = (2.4 * f64::from(step)).sin_cos();
                    let flat = (1.0 - height * height).sqrt();
                    let creepage =
                        [size * flat * cosine, size * flat * sine, size * height * spin_scale];
                    let f = creep_force(&row, method, creepage);
                    let power = f.fx * creepage[0] + f.fy * creepage[1] + f.mz * creepage[2];
                    assert!(power < 0.0, "{power} at a/b = {ratio}, {creepage:?}, {method:?}");
                    let most = 0.3 * f.normal_force * (1.0 + tolerance::ROUNDING);
                    assert!(f.fx.hypot(f.fy) <= most, "{f:?} at {creepage:?}");
                }
            }
        }
    }
}

/// A conformal separation with two minima, a friction case that partly slips.
fn uneven_case(scale: f64, modulus_scale: f64) -> PlanarResult {
    let separation: Vec<[f64; 2]> = (-100..=100)
        .map(|i| 1e-4 * f64::from(i))
        .map(|y| [scale * y, scale * (2.0 * y * y + 8e-6 * (1.0 - (900.0 * y).cos()))])
        .collect();
    let material = Material { young_modulus: modulus_scale * STEEL.young_modulus, ..STEEL };
    let case = PlanarCase {
        creepage: [8e-4, -5e-4, 0.3 / scale],
        wheel_material: material,
        rail_material: material,
        normal_model: NormalModel::PiotrowskiKik,
        bound: TractionBound::Parabolic,
        ..steel_case(&separation, 0.46 * scale, 8e-5 * scale)
    };
    solve(&case).unwrap()
}

#[test]
fn bodies_twice_as_large_carry_four_times_the_force() {
    let (one, two) = (uneven_case(1.0, 1.0), uneven_case(2.0, 1.0));
    assert!(one.patches >= 1 && one.patches == two.patches);
    for (name, small, large, power) in [
        ("N", one.normal_force, two.normal_force, 2),
        ("fx", one.fx, two.fx, 2),
        ("fy", one.fy, two.fy, 2),
        ("mz", one.mz, two.mz, 3),
        ("p0", one.max_pressure, two.max_pressure, 0),
        ("area", one.area, two.area, 2),
    ] {
        let error = large / (small * 2f64.powi(power)) - 1.0;
        assert!(error.abs() <= tolerance::SIMILARITY, "{name} is {error:e} off");
    }
}

#[test]
fn bodies_twice_as_stiff_carry_twice_the_force_on_the_same_area() {
    let (one, two) = (uneven_case(1.0, 1.0), uneven_case(1.0, 2.0));
    for (name, soft, stiff, factor) in [
        ("N", one.normal_force, two.normal_force, 2.0),
        ("fx", one.fx, two.fx, 2.0),
        ("fy", one.fy, two.fy, 2.0),
        ("mz", one.mz, two.mz, 2.0),
        ("p0", one.max_pressure, two.max_pressure, 2.0),
        ("area", one.area, two.area, 1.0),
    ] {
        let error = stiff / (factor * soft) - 1.0;
        assert!(error.abs() <= tolerance::SIMILARITY, "{name} is {error:e} off");
    }
}

#[test]
fn the_hertzian_force_grows_with_the_approach_to_the_power_of_three_halves() {
    let row = HertzRow::with_ratio(2.0);
    let separation = row.separation();
    for model in [NormalModel::Hertz, NormalModel::PiotrowskiKik] {
        let load = |approach: f64| {
            let mut case = steel_case(&separation, 0.5 / row.along, approach);
            case.normal_model = model;
            solve(&case).unwrap().normal_force
        };
        let exponent = (load(row.approach) / load(0.5 * row.approach)).log2();
        assert!((exponent - 1.5).abs() <= tolerance::HERTZ, "{model:?}: {exponent}");
    }
}
