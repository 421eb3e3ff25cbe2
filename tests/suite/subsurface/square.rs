//! CONTACT's square, and rectangles that meet.

use super::*;
use crate::common::{read_table, value};
use approx::assert_relative_eq;
use wheelrail::subsurface::lattice;

#[test]
fn displacements_and_stresses_below_a_square_are_those_of_contact() {
    let material = Material { young_modulus: 2.0 * 1.28, poisson_ratio: 0.28 };
    let mut load = SurfaceLoad::none(material);
    let square = Grid::over([-0.4999, 0.5001], [-0.4998, 0.5002], 1, 1);
    load.add(square, |_| [0.999, 0.0, 1.0]);
    let table = read_table("contact_25_1/subsurface_unit_square.csv");
    assert_eq!(table.rows.len(), 190);
    let mut report = String::from("quantity,greatest,worst error\n");
    let names = [
        "ux",
        "uy",
        "uz",
        "sig_xx",
        "sig_yy",
        "sig_zz",
        "sig_xy",
        "sig_yz",
        "sig_xz",
        "sig_hydrostatic",
        "sig_von_mises",
    ];
    let (mut worst, mut greatest) = ([0.0f64; 11], [0.0f64; 11]);
    for row in &table.rows {
        let v = |name: &str| value(&table, row, name);
        let state = load.state_at(["x", "y", "z"].map(v)).unwrap();
        let mut found = state.displacement.to_vec();
        found.extend(state.stress.components());
        found.extend([state.stress.hydrostatic(), state.stress.von_mises()]);
        for ((name, found), (worst, greatest)) in
            names.iter().zip(found).zip(worst.iter_mut().zip(&mut greatest))
        {
            *worst = worst.max((found - v(name)).abs());
            *greatest = greatest.max(v(name).abs());
        }
    }
    for ((name, worst), greatest) in names.iter().zip(worst).zip(greatest) {
        report += &format!("{name},{greatest},{worst:.2e}\n");
    }
    crate::common::write_report("subsurface_square.csv", &report);
    let stress = greatest[3..].iter().copied().fold(0.0, f64::max);
    let displacement = greatest[..3].iter().copied().fold(0.0, f64::max);
    for (k, worst) in worst.into_iter().enumerate() {
        let size = if k < 3 { displacement } else { stress };
        assert!(worst <= tolerance::SUBSURFACE_SQUARE * size, "{report}");
    }
}

#[test]
fn a_rectangle_in_parts_is_the_whole_also_over_the_lines_between_them() {
    let traction = [0.3, -0.2, 1.0];
    let mut whole = SurfaceLoad::none(BOOK);
    whole.add(Grid::over([-1.0, 1.0], [-0.5, 0.5], 1, 1), |_| traction);
    let mut parts = SurfaceLoad::none(BOOK);
    parts.add(Grid::over([-1.0, 0.25], [-0.5, 0.0], 5, 4), |_| traction);
    parts.add(Grid::over([0.25, 1.0], [-0.5, 0.0], 2, 3), |_| traction);
    parts.add(Grid::over([-1.0, 1.0], [0.0, 0.5], 8, 1), |_| traction);
    // Through corners, on edges and between them, on the surface and below.
    let x = [-1.0, -0.5, 0.0, 0.1, 0.25, 1.0, 1.5];
    for point in lattice(&x, &[-0.5, -0.3, 0.0, 0.5, 0.7], &[0.0, 1e-12, 0.01, 1.0]) {
        let inside = point[0].abs() < 1.0 && point[1].abs() < 0.5;
        if point[2] < 1e-3 && !inside {
            // On the outline the stresses of a traction have no bounds.
            continue;
        }
        let [a, b] = [&whole, &parts].map(|load| load.state_at(point).unwrap());
        for (a, b) in a.stress.components().into_iter().zip(b.stress.components()) {
            assert!((a - b).abs() < tolerance::SUBSURFACE_PARTS, "{point:?}: {a} {b}");
        }
        for (a, b) in a.displacement.into_iter().zip(b.displacement) {
            assert_relative_eq!(a, b, epsilon = tolerance::SUBSURFACE_PARTS * 1e-11);
        }
    }
}

#[test]
fn the_surface_is_the_limit_from_inside_and_has_the_tractions_that_are_given() {
    let load = ellipse([1.0, 1.0], 8, [0.3, -0.1, 1.0], BOOK);
    let grid = Grid::over([-1.0, 1.0], [-1.0, 1.0], 8, 8);
    for k in 0..grid.len() {
        let [x, y] = [grid.x(k % 8), grid.y(k / 8)];
        let [on, below] = [0.0, 1e-7].map(|z| load.state_at([x, y, z]).unwrap().stress);
        for (on, below) in on.components().into_iter().zip(below.components()) {
            assert!((on - below).abs() < 1e-5, "{x} {y}: {on} {below}");
        }
        assert_relative_eq!(on.xz, 0.3 * on.zz, epsilon = 1e-6);
        assert_relative_eq!(on.yz, -0.1 * on.zz, epsilon = 1e-6);
    }
    // Every corner and edge of the surface has a finite state.
    for point in lattice(&[-1.0, -0.25, 0.0, 1.0], &[-1.0, 0.0, 0.5, 1.0], &[0.0]) {
        let state = load.state_at(point).unwrap();
        assert!(state.stress.components().iter().all(|s| s.is_finite()), "{point:?}");
        assert!(state.displacement.iter().all(|u| u.is_finite()), "{point:?}");
    }
}

#[test]
fn points_outside_of_the_body_are_refused_by_name() {
    let load = ellipse([1.0, 1.0], 4, [0.0, 0.0, 1.0], BOOK);
    for (point, name) in [
        ([f64::NAN, 0.0, 0.0], "x = NaN"),
        ([0.0, 2e3, 0.0], "y = 2000"),
        ([0.0, 0.0, -1e-9], "depth = -0.000000001"),
        ([0.0, 0.0, f64::INFINITY], "depth = inf"),
    ] {
        let message = load.state_at(point).unwrap_err().to_string();
        assert!(message.contains(name), "{message}");
    }
    let message = load.states(&[[0.0; 3]], &mut []).unwrap_err().to_string();
    assert!(message.contains("states = 0"), "{message}");
    let none = SurfaceLoad::none(BOOK);
    assert_eq!(none.state_at([0.0; 3]).unwrap(), wheelrail::subsurface::State::default());
    assert!(none.extent().is_none());
    assert!(none.greatest(wheelrail::subsurface::Measure::VonMises).is_none());
}

#[test]
fn below_pressure_alone_the_equivalent_stresses_are_those_of_contact() {
    // As the example of CONTACT prints them, to three digits.
    let material = Material { young_modulus: 2.0 * 1.28, poisson_ratio: 0.28 };
    let mut load = SurfaceLoad::none(material);
    load.add(Grid::over([-0.5, 0.5], [-0.5, 0.5], 1, 1), |_| [0.0, 0.0, 1.0]);
    let at = |point| load.state_at(point).unwrap().stress;
    let middle = at([0.0; 3]);
    for (found, printed) in [
        (at([0.0, 0.0, 0.4]).von_mises(), 0.665),
        (at([0.0, -0.4, 0.2]).tresca(), 0.696),
        (middle.hydrostatic(), -0.853),
        (middle.xx, -0.780),
        (middle.yy, -0.780),
    ] {
        assert!((found - printed).abs() <= 5e-4, "{found} {printed}");
    }
}

#[test]
fn blunt_edges_are_smooth_on_the_surface_and_sharp_ones_below_it() {
    let sharp = ellipse([1.0, 1.0], 20, [0.3, 0.1, 1.0], BOOK);
    let blunt = sharp.clone().with_blunt_edges();
    let at = |load: &SurfaceLoad, x: f64, y: f64, z: f64| load.state_at([x, y, z]).unwrap().stress;
    // On edges of the surface, beside them the centres of elements.
    for (x, y) in [(0.4, 0.05), (-0.5, 0.35), (0.2, -0.25), (0.3, 0.45)] {
        let edge = at(&blunt, x, y, 0.0);
        let centres = [-0.05, 0.05].map(|d| at(&blunt, x + d, y, 0.0));
        let mean = 0.5 * (centres[0].xx + centres[1].xx);
        assert!((edge.xx - mean).abs() < tolerance::SUBSURFACE_BLUNT[0], "{edge:?} {centres:?}");
        let below = [&sharp, &blunt].map(|load| at(load, x, y, 0.2).components());
        for (sharp, blunt) in below[0].into_iter().zip(below[1]) {
            assert!((sharp - blunt).abs() < tolerance::SUBSURFACE_BLUNT[1], "{sharp} {blunt}");
        }
    }
}
