//! Contact with memory: planar problems followed through a series of states.

mod closed_forms;
mod contact_program;
mod states;
mod walk;

use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::material::Material;
use wheelrail::planar::{
    Indentation, PlanarCase, StepMotion, TransientContact, TransientField, TransientResult,
};
use wheelrail::tangential::field::Adherence;

use crate::common::planar::steel_case;

/// A case of boundary elements with bodies of one material.
fn case(
    separation: &[[f64; 2]],
    radius: f64,
    indentation: Indentation,
    friction: f64,
    material: Material,
) -> PlanarCase<'_> {
    PlanarCase {
        indentation,
        friction,
        wheel_material: material,
        rail_material: material,
        normal_model: NormalModel::BoundaryElement,
        tangential_model: TangentialModel::BoundaryElement,
        ..steel_case(separation, radius, 0.0)
    }
}

/// Material with shear modulus `shear` [Pa].
fn material(shear: f64, poisson_ratio: f64) -> Material {
    Material { young_modulus: 2.0 * (1.0 + poisson_ratio) * shear, poisson_ratio }
}

/// Separation of a sphere of `radius` from a plane out to `half_width`.
fn sphere(radius: f64, half_width: f64) -> Vec<[f64; 2]> {
    (-200..=200)
        .map(|i| half_width * f64::from(i) / 200.0)
        .map(|y| [y, radius - (radius * radius - y * y).sqrt()])
        .collect()
}

/// A step over `rolled` [m].
fn rolled(rolled: f64) -> StepMotion {
    StepMotion { rolled, ..StepMotion::default() }
}

/// A shift by `x` and `y` [m].
fn shifted(x: f64, y: f64) -> StepMotion {
    StepMotion { shift: [x, y, 0.0], ..StepMotion::default() }
}

/// Whether `field` obeys the friction law at every element, and adds up to `result`.
fn assert_obeys(field: &TransientField, case: &PlanarCase, result: &TransientResult) {
    let contact = &field.contact;
    let area = contact.grid.element_area();
    let (mut force, mut work) = ([0.0; 2], 0.0);
    let greatest = contact.pressure.iter().copied().fold(0.0, f64::max);
    for k in 0..contact.grid.len() {
        let (p, s) = (contact.traction[k], field.slip[k]);
        let bound = case.friction * contact.pressure[k];
        let size = p[0].hypot(p[1]);
        assert!(size <= bound + 1e-9 * greatest, "element {k}: {size} beyond {bound}");
        let power = p[0] * s[0] + p[1] * s[1];
        assert!(field.work[k] >= 0.0, "element {k}: {}", field.work[k]);
        // Over several substeps slip adds up, and the traction is that of the last.
        assert!(result.substeps > 1 || power <= 0.0, "element {k}: {power}");
        match contact.adherence[k] {
            Adherence::None => assert!(bound == 0.0 && size == 0.0),
            Adherence::Slip => assert!(size >= (1.0 - 1e-9) * bound, "{k}: {size} of {bound}"),
            // What slipped earlier in the step may adhere in the end.
            Adherence::Adhesion => {}
        }
        for c in 0..2 {
            force[c] += area * p[c];
        }
        work += field.work[k];
    }
    assert!((force[0] - result.contact.fx).abs() <= 1e-9 * area * greatest);
    assert!((force[1] - result.contact.fy).abs() <= 1e-9 * area * greatest);
    assert!((work - result.work).abs() <= 1e-9 * result.work);
}
