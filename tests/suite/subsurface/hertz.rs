//! Hertzian contacts: closed forms of the line, the circle and the axis of an ellipse.

use super::*;
use wheelrail::subsurface::{Measure, Stress, evenly};

/// Value and place of the greatest of a smooth function from 0 to `end`, by its samples.
pub(super) fn greatest(end: f64, f: impl Fn(f64) -> f64) -> [f64; 2] {
    let (mut low, mut high) = (0.0, end);
    let mut best = [f64::NEG_INFINITY, 0.0];
    while high - low > 1e-9 {
        for z in evenly(low, high, 41) {
            if f(z) > best[0] {
                best = [f(z), z];
            }
        }
        let step = (high - low) / 40.0;
        (low, high) = ((best[1] - step).max(0.0), best[1] + step);
    }
    best
}

/// Elements along a cylinder in contact, half width 1, and a row so wide that its ends are nowhere.
fn cylinder(count: usize) -> SurfaceLoad {
    let grid = Grid::over([-1.0, 1.0], [-1e3, 1e3], count, 1);
    let mut load = SurfaceLoad::none(BOOK);
    load.add(grid, |k| {
        let ends = [0.5, -0.5].map(|half| half_disk(grid.x(k) + half * grid.dx));
        [0.0, 0.0, (ends[0] - ends[1]) / grid.dx]
    });
    load
}

/// Stresses on the axis of a line contact (Johnson 1985, eqs 4.46), half width and pressure 1.
fn line_axis(z: f64) -> Stress {
    let s = (1.0 + z * z).sqrt();
    let (xx, zz) = (-(1.0 + 2.0 * z * z) / s + 2.0 * z, -1.0 / s);
    Stress { xx, zz, yy: BOOK.poisson_ratio * (xx + zz), ..Stress::default() }
}

/// Stresses on the axis of a circle of radius 1 (Johnson 1985, eqs 3.45).
fn circle_axis(z: f64) -> Stress {
    let zz = -1.0 / (1.0 + z * z);
    let radial = -(1.0 + BOOK.poisson_ratio) * (1.0 - z * (1.0f64).atan2(z)) - 0.5 * zz;
    Stress { xx: radial, yy: radial, zz, ..Stress::default() }
}

/// Stresses on the axis of an ellipse with semi-axes a > b (Johnson 1985, eqs 3.69), x along a.
pub(super) fn ellipse_axis(a: f64, b: f64, z: f64) -> Stress {
    let nu = BOOK.poisson_ratio;
    let squared = 1.0 - (b / a).powi(2);
    let (t, zeta) = (((b * b + z * z) / (a * a + z * z)).sqrt(), z / a);
    // Incomplete integrals of the first and second kind, cot φ = ζ, by Simpson's rule.
    let angle = (1.0f64).atan2(zeta);
    let count = 2000;
    let integral = |f: &dyn Fn(f64) -> f64| {
        let h = angle / f64::from(count);
        let weight = |k: i32| match k {
            0 => 1.0,
            k if k == count => 1.0,
            k if k % 2 == 1 => 4.0,
            _ => 2.0,
        };
        (0..=count).map(|k| weight(k) * f(h * f64::from(k))).sum::<f64>() * h / 3.0
    };
    let root = |t: f64| (1.0 - squared * t.sin().powi(2)).sqrt();
    let (first, second) = (integral(&|t| 1.0 / root(t)), integral(&root));
    let ratio = (a / b).powi(2);
    let omega_x = -0.5 * (1.0 - t) + zeta * (first - second);
    let omega_y = 0.5 + 0.5 / t - t * ratio + zeta * (ratio * second - first);
    let prime_x = 1.0 - t * ratio + zeta * (ratio * second - first);
    let prime_y = -1.0 + t + zeta * (first - second);
    let scale = 2.0 * b / (squared * a);
    Stress {
        xx: scale * (omega_x + nu * prime_x),
        yy: scale * (omega_y + nu * prime_y),
        zz: -0.5 * scale * (1.0 - t * t) / t,
        ..Stress::default()
    }
}

fn assert_maximum(found: [f64; 2], exact: [f64; 2], bounds: [f64; 2], what: &str) {
    for ((found, exact), bound) in found.into_iter().zip(exact).zip(bounds) {
        assert!((found / exact - 1.0).abs() <= bound, "{what}: {found} for {exact}");
    }
}

#[test]
fn closed_forms_have_the_maxima_of_the_text_books() {
    let of = |axis: fn(f64) -> Stress, measure: Measure| greatest(3.0, |z| measure.of(&axis(z)));
    let close = |found: [f64; 2], book: [f64; 2]| {
        let within = (found[0] - book[0]).abs() < 6e-3 && (found[1] - book[1]).abs() < 6e-3;
        assert!(within, "{found:?} {book:?}");
    };
    // Johnson 1985, sections 4.2 and 3.4: greatest shear stress, half of Tresca's.
    close(of(line_axis, Measure::Tresca), [2.0 * 0.300, 0.786]);
    close(of(line_axis, Measure::VonMises), [0.558, 0.704]);
    close(of(circle_axis, Measure::Tresca), [2.0 * 0.310, 0.48]);
    close(of(circle_axis, Measure::VonMises), [0.620, 0.48]);
}

#[test]
fn maxima_below_a_line_are_met() {
    let load = cylinder(40);
    for measure in [Measure::Tresca, Measure::VonMises] {
        let found = greatest(2.0, |z| measure.of(&load.state_at([0.0, 0.0, z]).unwrap().stress));
        // The greatest shear stress lies in the plane of x and z.
        let exact = greatest(2.0, |z| measure.of(&line_axis(z)));
        assert_maximum(found, exact, tolerance::SUBSURFACE_HERTZ, measure.name());
    }
    // Shear along the surface: a quarter of the pressure, half a half width deep, on either side.
    let shear = |x: f64, z: f64| load.state_at([x, 0.0, z]).unwrap().stress.xz;
    let exact = [0.25, 0.75f64.sqrt()];
    for sign in [1.0, -1.0] {
        let found = greatest(1.0, |x| sign * shear(-sign * x, 0.5));
        assert_maximum(found, exact, tolerance::SUBSURFACE_HERTZ, "across");
        let found = greatest(1.0, |z| sign * shear(-sign * exact[1], z));
        assert_maximum(found, [0.25, 0.5], tolerance::SUBSURFACE_HERTZ, "down");
    }
}

#[test]
fn maxima_below_a_circle_are_met_and_found() {
    let load = ellipse([1.0, 1.0], 40, [0.0, 0.0, 1.0], BOOK);
    for measure in [Measure::Tresca, Measure::VonMises] {
        let found = load.greatest(measure).unwrap();
        let exact = greatest(2.0, |z| measure.of(&circle_axis(z)));
        let place = [found.value, found.point[2]];
        assert_maximum(place, exact, tolerance::SUBSURFACE_HERTZ, measure.name());
        assert!(found.point[..2].iter().all(|x| x.abs() < 1e-3), "{found:?}");
    }
    // At the surface in the middle, and the tension at the edge, (1 - 2ν)/3 (Johnson 1985, eq. 3.44).
    let middle = load.state_at([0.0; 3]).unwrap().stress;
    let nu = BOOK.poisson_ratio;
    for found in [middle.xx, middle.yy] {
        assert!((found / (-0.5 * (1.0 + 2.0 * nu)) - 1.0).abs() < tolerance::SUBSURFACE_MIDDLE);
    }
    let edge = load.state_at([1.02, 0.0, 0.0]).unwrap().stress.xx;
    let exact = (1.0 - 2.0 * nu) / 3.0 / 1.02f64.powi(2);
    assert!((edge / exact - 1.0).abs() < tolerance::SUBSURFACE_EDGE, "{edge} {exact}");
}

#[test]
fn stresses_below_the_axis_of_ellipses_are_met() {
    for b in [0.2, 0.5, 0.8] {
        let load = ellipse([1.0, b], 40, [0.0, 0.0, 1.0], BOOK);
        for measure in [Measure::Tresca, Measure::VonMises] {
            let found = load.greatest(measure).unwrap();
            let exact = greatest(2.0, |z| measure.of(&ellipse_axis(1.0, b, z)));
            let place = [found.value, found.point[2]];
            assert_maximum(place, exact, tolerance::SUBSURFACE_HERTZ, measure.name());
        }
        for z in evenly(0.1 * b, 3.0, 30) {
            let found = load.state_at([0.0, 0.0, z]).unwrap().stress.components();
            let exact = ellipse_axis(1.0, b, z).components();
            for (found, exact) in found.into_iter().zip(exact) {
                assert!(
                    (found - exact).abs() < tolerance::SUBSURFACE_AXIS,
                    "{b} {z}: {found} {exact}"
                );
            }
        }
    }
}

#[test]
fn errors_fall_with_the_square_of_the_elements() {
    let exact = greatest(2.0, |z| circle_axis(z).von_mises())[0];
    let error = |count| {
        let load = ellipse([1.0, 1.0], count, [0.0, 0.0, 1.0], BOOK);
        (load.greatest(Measure::VonMises).unwrap().value / exact - 1.0).abs()
    };
    let errors = [10, 20, 40].map(error);
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!(order > tolerance::SUBSURFACE_ORDER, "{errors:?}");
    }
}

#[test]
fn friction_brings_the_greatest_stress_to_the_surface() {
    let deepest = |friction: f64| {
        let load = ellipse([1.0, 1.0], 24, [friction, 0.0, 1.0], BOOK);
        load.greatest(Measure::VonMises).unwrap().point[2]
    };
    assert!(deepest(0.1) > 0.3);
    assert!(deepest(0.5) < 0.05);
}
