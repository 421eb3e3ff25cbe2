//! Equilibrium, Hooke's law, forces on planes, decay and mirrors.

use super::*;
use wheelrail::subsurface::{State, Stress, evenly, lattice};

/// A load without symmetry.
fn oblique() -> SurfaceLoad {
    let grid = Grid::over([-1.0, 1.2], [-0.7, 0.9], 7, 5);
    let mut load = SurfaceLoad::none(BOOK);
    load.add(grid, |k| {
        let k = k as f64;
        [0.4 * (1.3 * k).sin(), 0.3 * (0.7 * k).cos(), 1.0 + (2.1 * k).sin()]
    });
    load
}

/// Force (along x, along y, into the body) of the load of `oblique`.
fn force() -> [f64; 3] {
    let mut sum = [0.0; 3];
    for k in 0..35 {
        let k = f64::from(k);
        let own = [0.4 * (1.3 * k).sin(), 0.3 * (0.7 * k).cos(), 1.0 + (2.1 * k).sin()];
        sum = [0, 1, 2].map(|c| sum[c] + own[c] * 2.2 * 1.6 / 35.0);
    }
    sum
}

/// Derivatives of a state along each axis by central differences of fourth order.
fn slopes(load: &SurfaceLoad, point: [f64; 3], h: f64) -> [State; 3] {
    [0, 1, 2].map(|axis| {
        let at = |steps: f64| {
            let mut moved = point;
            moved[axis] += steps * h;
            load.state_at(moved).unwrap()
        };
        let states = [at(-2.0), at(-1.0), at(1.0), at(2.0)];
        let slope = |f: &dyn Fn(&State) -> f64| {
            let [a, b, c, d] = states.each_ref().map(f);
            (a - 8.0 * b + 8.0 * c - d) / (12.0 * h)
        };
        State {
            displacement: [0, 1, 2].map(|c| slope(&|s| s.displacement[c])),
            stress: [0, 1, 2, 3, 4, 5].map(|c| slope(&|s| s.stress.components()[c])).into(),
        }
    })
}

fn places() -> Vec<[f64; 3]> {
    lattice(&[-1.5, -0.33, 0.4, 1.1], &[-0.9, 0.1, 0.75], &[0.05, 0.3, 1.0, 4.0])
}

#[test]
fn stresses_are_in_equilibrium_and_those_of_the_displacements() {
    let load = oblique();
    let (modulus, nu) = (BOOK.shear_modulus(), BOOK.poisson_ratio);
    for point in places() {
        let [dx, dy, dz] = slopes(&load, point, 0.01 * point[2]);
        let (sx, sy, sz) = (dx.stress, dy.stress, dz.stress);
        let unbalanced = [sx.xx + sy.xy + sz.xz, sx.xy + sy.yy + sz.yz, sx.xz + sy.yz + sz.zz];
        for force in unbalanced {
            assert!(force.abs() < tolerance::SUBSURFACE_BALANCE, "{point:?}: {unbalanced:?}");
        }
        let (ux, uy, uz) = (dx.displacement, dy.displacement, dz.displacement);
        let lame = 2.0 * modulus * nu / (1.0 - 2.0 * nu) * (ux[0] + uy[1] + uz[2]);
        let normal = |strain: f64| lame + 2.0 * modulus * strain;
        let shear = |a: f64, b: f64| modulus * (a + b);
        let hooke = Stress {
            xx: normal(ux[0]),
            yy: normal(uy[1]),
            zz: normal(uz[2]),
            xy: shear(ux[1], uy[0]),
            yz: shear(uy[2], uz[1]),
            xz: shear(ux[2], uz[0]),
        };
        let found = load.state_at(point).unwrap().stress;
        for (found, hooke) in found.components().into_iter().zip(hooke.components()) {
            assert!((found - hooke).abs() < tolerance::SUBSURFACE_BALANCE, "{point:?}");
        }
    }
}

#[test]
fn every_plane_carries_the_load() {
    let load = oblique();
    let force = force();
    for depth in [0.5, 2.0] {
        // Tangents take the plane into a square.
        let angles = evenly(-0.5 * PI, 0.5 * PI, 401);
        let step = angles[1] - angles[0];
        let mut sum = [0.0; 3];
        let inner = &angles[1..400];
        for (a, b) in inner.iter().flat_map(|a| inner.iter().map(move |b| (*a, *b))) {
            let point = [a.tan().clamp(-900.0, 900.0), b.tan().clamp(-900.0, 900.0), depth];
            let stress = load.state_at(point).unwrap().stress;
            let area = step * step / (a.cos() * b.cos()).powi(2);
            sum = [sum[0] - area * stress.xz, sum[1] - area * stress.yz, sum[2] - area * stress.zz];
        }
        for (sum, force) in sum.into_iter().zip(force) {
            assert!(
                (sum - force).abs() < tolerance::SUBSURFACE_PLANE * force.abs().max(1.0),
                "{depth}: {sum} {force}"
            );
        }
    }
}

#[test]
fn far_away_the_load_is_a_point_force() {
    let load = oblique();
    let [_, _, normal] = force();
    let [small, large] = [30.0, 60.0].map(|far| {
        let state = load.state_at([0.3 * far, -0.2 * far, far]).unwrap();
        let stress = state.stress.components().map(|s| s * far * far);
        (stress, state.displacement.map(|u| u * far))
    });
    // Stresses fall with the square of the distance, displacements with the distance.
    for (small, large) in small.0.iter().zip(large.0).chain(small.1.iter().zip(large.1)) {
        let size = if large.abs() > 1e-6 { normal } else { normal / BOOK.shear_modulus() };
        assert!((small - large).abs() < tolerance::SUBSURFACE_FAR * size, "{small} {large}");
    }
    // Right below a point force: σ_z = -3 N/(2π z²) (Johnson 1985, eq. 3.19).
    let load = ellipse([1.0, 1.0], 12, [0.0, 0.0, 1.0], BOOK);
    let found = load.state_at([0.0, 0.0, 100.0]).unwrap().stress.zz;
    let exact = -3.0 * (2.0 * PI / 3.0) / (2.0 * PI * 1e4);
    assert!((found / exact - 1.0).abs() < tolerance::SUBSURFACE_FAR, "{found} {exact}");
}

#[test]
fn mirrored_loads_have_mirrored_stresses() {
    let grid = Grid::over([-1.0, 1.0], [-0.5, 0.5], 6, 4);
    let traction = |k: usize| {
        let k = k as f64;
        [(1.3 * k).sin(), (0.7 * k).cos(), 1.0 + (2.1 * k).sin()]
    };
    let (mut load, mut other) = (SurfaceLoad::none(BOOK), SurfaceLoad::none(BOOK));
    load.add(grid, traction);
    // Mirrored along y, and the axes exchanged.
    other.add(grid, |k| {
        let [x, y, p] = traction((3 - k / 6) * 6 + k % 6);
        [x, -y, p]
    });
    for [x, y, z] in places() {
        let own = load.state_at([x, y, z]).unwrap();
        let mirrored = other.state_at([x, -y, z]).unwrap();
        let Stress { xx, yy, zz, xy, yz, xz } = mirrored.stress;
        let back = Stress { xx, yy, zz, xy: -xy, yz: -yz, xz };
        for (a, b) in own.stress.components().into_iter().zip(back.components()) {
            assert!((a - b).abs() < tolerance::SUBSURFACE_MIRROR, "{a} {b}");
        }
        assert!((own.displacement[1] + mirrored.displacement[1]).abs() < 1e-22);
    }
    // A traction along y does along y what one along x does along x.
    let square = Grid::over([-1.0, 1.0], [-1.0, 1.0], 1, 1);
    let (mut along, mut across) = (SurfaceLoad::none(BOOK), SurfaceLoad::none(BOOK));
    along.add(square, |_| [1.0, 0.0, 0.0]);
    across.add(square, |_| [0.0, 1.0, 0.0]);
    for [x, y, z] in places() {
        let a = along.state_at([x, y, z]).unwrap();
        let b = across.state_at([y, x, z]).unwrap();
        let Stress { xx, yy, zz, xy, yz, xz } = b.stress;
        let turned = Stress { xx: yy, yy: xx, zz, xy, yz: xz, xz: yz };
        for (a, b) in a.stress.components().into_iter().zip(turned.components()) {
            assert!((a - b).abs() < tolerance::SUBSURFACE_MIRROR, "{a} {b}");
        }
        assert!((a.displacement[0] - b.displacement[1]).abs() < 1e-22);
    }
}
