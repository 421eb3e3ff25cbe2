//! Bodies of unlike materials: pressure and tractions act on each other.

use super::*;
use wheelrail::planar::{Indentation, PlanarResult, StepMotion, TransientContact};

pub(super) const ALUMINIUM: Material = Material { young_modulus: 6.026e10, poisson_ratio: 0.31 };

/// A wheel on a rail, 60 kN, of these materials, at a creepage.
fn case(
    separation: &[[f64; 2]],
    [wheel_material, rail_material]: [Material; 2],
    creepage: [f64; 3],
) -> PlanarCase<'_> {
    PlanarCase {
        wheel_material,
        rail_material,
        indentation: Indentation::Load(6e4),
        creepage,
        tangential_model: TangentialModel::BoundaryElement,
        ..boundary_case(separation, 0.46, 0.0, 24)
    }
}

fn parabola() -> Vec<[f64; 2]> {
    (-60..=60).map(|i| 2.5e-4 * f64::from(i)).map(|y| [y, 1.1 * y * y]).collect()
}

fn solved(case: &PlanarCase) -> PlanarResult {
    let result = solve(case).unwrap();
    assert!(!result.fallback, "{result:?}");
    result
}

#[test]
fn a_soft_wheel_creeps_in_free_rolling_and_a_soft_rail_the_other_way() {
    let separation = parabola();
    let limit = 0.3 * 6e4;
    for materials in [[ALUMINIUM, STEEL], [STEEL, ALUMINIUM]] {
        let coupling = MaterialPair::new(materials[0], materials[1]).coupling;
        let at = |creepage: f64| solved(&case(&separation, materials, [creepage, 0.0, 0.0]));
        let rest = at(0.0);
        // The softer body's surface is drawn together more: it has to roll ahead or behind.
        assert!(rest.fx * coupling < 0.0 && rest.fx.abs() > 0.02 * limit, "{coupling} {rest:?}");
        assert!(rest.fy.abs() < 1e-3 * limit && rest.mz.abs() < 1e-5 * limit, "{rest:?}");
        let free = wheelrail::math::root::bracketed(
            (-1e-3, at(-1e-3).fx),
            (1e-3, at(1e-3).fx),
            1e-7,
            |creepage| at(creepage).fx,
        );
        // Between those of rollers with much and with little friction, 0.9 and 1.3 K a/R; circles less.
        let half = 0.5 * rest.length;
        let shift = -free / (coupling * half / 0.46);
        assert!((0.5..1.4).contains(&shift), "{free} {shift}");
        assert!((rest.normal_force / 6e4 - 1.0).abs() < 1e-6, "{rest:?}");
    }
}

#[test]
fn tractions_move_the_pressure_and_take_energy_up() {
    let separation = parabola();
    let case = case(&separation, [ALUMINIUM, STEEL], [4e-3, 1e-3, 0.1]);
    let all = fields(&case).unwrap();
    let [field] = &all[..] else { panic!("one field") };
    let (mut load, mut moment) = (0.0, 0.0);
    for (k, p) in field.pressure.iter().enumerate() {
        load += p;
        moment += p * field.grid.x(k % field.grid.along);
    }
    let result = solved(&case);
    let shift = moment / load / result.length;
    assert!(shift.abs() > 1e-3, "the load stays in the middle: {shift}");
    let slip = field.slip.as_ref().unwrap();
    let most = 0.3 * result.max_pressure * 5e-3;
    for (k, (p, s)) in field.traction.iter().zip(slip).enumerate() {
        assert!(p[0].hypot(p[1]) <= 0.3 * field.pressure[k] * (1.0 + 1e-9), "{k}");
        if field.adherence[k] == Adherence::Slip {
            assert!(p[0] * s[0] + p[1] * s[1] <= 1e-3 * most, "{k}");
        }
    }
    // Forces are those of the tractions.
    let area = field.grid.element_area();
    let sum = |c: usize| field.traction.iter().map(|p| p[c]).sum::<f64>() * area;
    assert!((sum(0) / result.fx - 1.0).abs() < 1e-9 && (sum(1) / result.fy - 1.0).abs() < 1e-9);
}

#[test]
fn materials_that_are_almost_alike_have_almost_the_forces_of_like_ones() {
    let separation = parabola();
    let nearly = Material { young_modulus: STEEL.young_modulus * (1.0 + 1e-6), ..STEEL };
    let [like, other] = [[STEEL, STEEL], [nearly, STEEL]]
        .map(|materials| solved(&case(&separation, materials, [2e-3, -1e-3, 0.2])));
    let limit = 0.3 * 6e4;
    assert!((like.fx - other.fx).abs() < tolerance::UNLIKE_NEARLY * limit, "{like:?} {other:?}");
    assert!((like.fy - other.fy).abs() < tolerance::UNLIKE_NEARLY * limit, "{like:?} {other:?}");
    assert!((like.mz - other.mz).abs() < 1e-5 * limit, "{like:?} {other:?}");
}

#[test]
fn contact_with_memory_refuses_unlike_materials_by_their_figure() {
    let separation = parabola();
    let case = case(&separation, [ALUMINIUM, STEEL], [1e-3, 0.0, 0.0]);
    let refused = TransientContact::new().step(&case, &StepMotion::default()).unwrap_err();
    assert!(refused.to_string().contains("K of the materials = 0.1"), "{refused}");
}

#[test]
fn an_element_says_that_it_leaves_out_what_unlike_materials_do() {
    let remarks = |young_modulus: f64| {
        let mut parameters = Parameters::default();
        parameters.wheel.young_modulus = young_modulus;
        let mut input = Input::default();
        input.wheel.position[2] = -0.4597;
        let mut element = Element::new(&parameters, &input, &[]).unwrap();
        let mut output = Output::default();
        element.evaluate(&input, &mut output).unwrap();
        let mut told = Vec::new();
        wheelrail::element::remarks(&element, &parameters, &input, &output, |_, remark| {
            told.push(remark.message("").to_string());
        });
        told
    };
    let of_materials =
        |told: Vec<String>| told.into_iter().filter(|t| t.contains("unlike")).count();
    assert_eq!(of_materials(remarks(2.1e11)), 0);
    assert_eq!(of_materials(remarks(2.09e11)), 0);
    let told = remarks(0.7e11);
    assert!(told.iter().any(|t| t.contains("K = 0.11")), "{told:?}");
    assert_eq!(of_materials(told), 1);
}
