//! Stresses of results: strips against Hertz, every normal model, tractions on both bodies.

use super::hertz::{ellipse_axis, greatest};
use super::*;
use crate::allocations;
use crate::common::planar::steel_case;
use crate::common::summary::Summary;
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::element::{Element, Input, Parameters};
use wheelrail::material::MaterialPair;
use wheelrail::normal::hertz;
use wheelrail::planar::{Indentation, PlanarCase, solve};
use wheelrail::subsurface::{Body, Measure, State, lattice};

/// Steel bodies whose ellipse is known: curvatures along and across [1/m].
struct Bodies {
    separation: Vec<[f64; 2]>,
    radius: f64,
    load: f64,
    max_pressure: f64,
    /// Along and across [m].
    semi_axes: [f64; 2],
}

fn bodies(along: f64, across: f64) -> Bodies {
    let modulus = MaterialPair::new(BOOK, BOOK).contact_modulus;
    let e = hertz::ellipse(along, across, 6e-5, modulus);
    let y = (-50..=50).map(|i| 0.03 * f64::from(i) * e.semi_axis_across);
    Bodies {
        separation: y.map(|y| [y, across * y * y]).collect(),
        radius: 0.5 / along,
        load: e.load,
        max_pressure: 1.5 * e.load / (PI * e.semi_axis_along * e.semi_axis_across),
        semi_axes: [e.semi_axis_along, e.semi_axis_across],
    }
}

fn case(bodies: &Bodies, normal_model: NormalModel, elements: usize) -> PlanarCase<'_> {
    PlanarCase {
        indentation: Indentation::Load(bodies.load),
        wheel_material: BOOK,
        rail_material: BOOK,
        normal_model,
        tangential_model: TangentialModel::None,
        elements: [elements; 2],
        ..steel_case(&bodies.separation, bodies.radius, 0.0)
    }
}

/// Curvatures of ellipses along and across, from long to wide.
const CURVATURES: [[f64; 2]; 6] =
    [[1.1, 9.0], [1.1, 3.0], [1.1, 1.5], [1.1, 0.8], [1.1, 0.4], [1.1, 0.15]];

/// Hertz's pressure over an ellipse as means over elements.
fn ellipse_of([a, b]: [f64; 2], count: usize, max_pressure: f64) -> SurfaceLoad {
    ellipse([a, b], count, [0.0, 0.0, max_pressure], BOOK)
}

/// Errors of the greatest equivalent stresses and of their depths below a contact of these `bodies`.
fn errors(load: &SurfaceLoad, [a, b]: [f64; 2], max_pressure: f64) -> [[f64; 2]; 2] {
    let small = a.min(b);
    [Measure::VonMises, Measure::Tresca].map(|measure| {
        let found = load.greatest(measure).unwrap();
        let exact = greatest(2.0, |z| measure.of(&ellipse_axis(a.max(b) / small, 1.0, z)));
        [found.value / max_pressure / exact[0] - 1.0, found.point[2] / small / exact[1] - 1.0]
    })
}

#[test]
fn twenty_strips_have_the_maxima_of_hertz() {
    let mut summary = Summary::new("subsurface");
    let all: Vec<Bodies> =
        CURVATURES.iter().map(|[along, across]| bodies(*along, *across)).collect();
    let mut add = |name: &str, aim: &str, load: &dyn Fn(&Bodies) -> SurfaceLoad| {
        let found = all.iter().flat_map(|own| errors(&load(own), own.semi_axes, own.max_pressure));
        let found: Vec<[f64; 2]> = found.collect();
        for (c, quantity) in ["stress", "depth"].into_iter().enumerate() {
            let errors = found.iter().map(|error| 100.0 * error[c]);
            summary.add(&format!("{name}: {quantity} [%]"), errors, aim);
        }
        found.iter().flatten().map(|error| error.abs()).fold(0.0, f64::max)
    };
    add("means of Hertz's pressure, 40 x 40", "0.5", &|own| {
        ellipse_of(own.semi_axes, 40, own.max_pressure)
    });
    let elements = |own: &Bodies, count: usize| {
        SurfaceLoad::below(&case(own, NormalModel::BoundaryElement, count), Body::Rail).unwrap()
    };
    add("boundary elements, 40 x 40", "0.5", &|own| elements(own, 40));
    add("boundary elements, 20 x 20", "", &|own| elements(own, 20));
    let mut worst = 0.0;
    for count in [10, 14, 20, 40] {
        let aim = if count == 20 { "2" } else { "" };
        let found = add(&format!("20 strips, {count} elements along"), aim, &|own| {
            let case = case(own, NormalModel::Strips, 40);
            let case = PlanarCase { elements_along: count, ..case };
            SurfaceLoad::below(&case, Body::Rail).unwrap()
        });
        if count == 20 {
            worst = found;
        }
    }
    summary.write();
    assert!(worst <= tolerance::SUBSURFACE_STRIPS, "{worst}");
}

#[test]
fn every_normal_model_has_stresses() {
    let bodies = bodies(1.1, 1.3);
    let value = |model, elements| {
        let load = SurfaceLoad::below(&case(&bodies, model, elements), Body::Wheel).unwrap();
        load.greatest(Measure::VonMises).unwrap().value
    };
    let exact = value(NormalModel::BoundaryElement, 40);
    for model in [
        NormalModel::Hertz,
        NormalModel::PiotrowskiKik,
        NormalModel::PiotrowskiKikCorrected,
        NormalModel::Strips,
    ] {
        let error = value(model, 20) / exact - 1.0;
        assert!(error.abs() <= tolerance::SUBSURFACE_MODELS, "{model:?}: {error}");
    }
}

#[test]
fn tractions_act_on_the_wheel_and_against_them_on_the_rail() {
    let bodies = bodies(1.1, 1.3);
    let [a, b] = bodies.semi_axes;
    // All of the patch slides: the tractions are friction times pressure.
    for (model, elements) in [
        (TangentialModel::Marches, 20),
        (TangentialModel::Fastsim, 20),
        (TangentialModel::BoundaryElement, 20),
    ] {
        let case = PlanarCase {
            tangential_model: model,
            creepage: [0.03, 0.04, 0.0],
            ..case(&bodies, NormalModel::Strips, elements)
        };
        let force = solve(&case).unwrap();
        assert!(force.fx < 0.0 && force.fy < 0.0);
        for (body, sign) in [(Body::Wheel, 1.0), (Body::Rail, -1.0)] {
            let share = [force.fx, force.fy].map(|f| sign * f / force.normal_force);
            let exact = ellipse([a, b], 40, [share[0], share[1], 1.0], BOOK);
            let load = SurfaceLoad::below(&case, body).unwrap();
            for [x, y, z] in lattice(&[-0.5, 0.0, 0.4], &[-0.6, 0.1], &[0.4, 0.8, 2.0]) {
                let point = [x * a, y * b, z * a.min(b)];
                let [found, exact] = [&load, &exact].map(|l| l.state_at(point).unwrap().stress);
                let scaled = found.components().map(|s| s / bodies.max_pressure);
                for (found, exact) in scaled.into_iter().zip(exact.components()) {
                    assert!(
                        (found - exact).abs() < tolerance::SUBSURFACE_TRACTIONS,
                        "{model:?} {body:?} {point:?}: {found} {exact}"
                    );
                }
            }
        }
    }
}

#[test]
fn an_element_has_stresses_in_its_own_materials() {
    let mut parameters = Parameters { rail_poisson_ratio: 0.35, ..Parameters::default() };
    let mut input = Input::default();
    let speed = 20.0;
    (input.wheel.velocity[0], input.wheel.pitch_rate) = (speed, -speed / 0.459);
    let mut element = Element::new(&parameters, &input, &[]).unwrap();
    input.wheel.position[2] = element.nominal_wheel_z() + 8e-5;
    let contacts = element.flat_contacts(&input).unwrap();
    let case = parameters.flat_case(&contacts[0], speed).unwrap();
    let [wheel, rail] =
        [Body::Wheel, Body::Rail].map(|body| SurfaceLoad::below(&case, body).unwrap());
    assert_eq!(wheel.material().poisson_ratio.to_bits(), 0.28f64.to_bits());
    assert_eq!(rail.material(), parameters.materials()[1]);
    parameters.tangential_model = TangentialModel::None;
    let alone = SurfaceLoad::below(&parameters.flat_case(&contacts[0], speed).unwrap(), Body::Rail)
        .unwrap();
    let largest = wheel.max_pressure();
    let surface = |load: &SurfaceLoad, point| load.state_at(point).unwrap().stress;
    let mut sheared = 0.0f64;
    for point in lattice(&[-3e-3, 0.0, 3e-3], &[-1e-3, 1e-3], &[0.0, 2e-3]) {
        let [wheel, rail, alone] = [&wheel, &rail, &alone].map(|load| surface(load, point));
        // Shear along the surface depends on no elastic constant but through tractions, which are
        // opposite.
        assert!((wheel.xz + rail.xz - 2.0 * alone.xz).abs() < 1e-2 * largest);
        assert!((rail.zz + wheel.zz - 2.0 * alone.zz).abs() < 1e-2 * largest);
        sheared = sheared.max((wheel.xz - rail.xz).abs());
    }
    assert!(sheared > 1e-3 * largest, "no tractions: {sheared}");
}

#[test]
fn given_points_allocate_nothing() {
    let load = ellipse([1.0, 0.5], 20, [0.1, 0.2, 1.0], BOOK);
    let points = lattice(&[0.0, 0.3], &[-0.2, 0.1], &[0.0, 0.5, 1.0]);
    let mut states = vec![State::default(); points.len()];
    let before = allocations::count();
    load.states(&points, &mut states).unwrap();
    assert_eq!(allocations::count(), before);
    assert!(states.iter().all(|state| state.stress.zz < 0.0));
}
