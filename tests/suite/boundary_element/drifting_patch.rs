//! A patch that drifts to the side while the wheel rolls on: which way its particles pass.

use nalgebra::Vector2;

use crate::common::planar::STEEL;
use wheelrail::boundary_element::grid::Grid;
use wheelrail::boundary_element::rolling::steady_rolling;
use wheelrail::boundary_element::shift::shift;
use wheelrail::material::MaterialPair;

/// Semi-axes of the patch along its way and across [m], load [N] and friction.
const A: f64 = 7e-3;
const B: f64 = 1.2e-3;
const LOAD: f64 = 8e4;
const FRICTION: f64 = 0.3;
/// How far it drifts for each length along the track.
const DRIFT: f64 = 0.1;
/// Longitudinal creepage.
const CREEPAGE: f64 = 3e-3;
/// Steps along the track [m], and how many are one and a half lengths of the patch.
const STEP: f64 = 5e-4;
const STEPS: i32 = 42;

/// Friction bound at a place from the middle of the patch [Pa].
fn bound(x: f64, y: f64) -> f64 {
    let (sine, cosine) = DRIFT.atan().sin_cos();
    let (along, across) = (cosine * x + sine * y, cosine * y - sine * x);
    let inside = 1.0 - (along / A).powi(2) - (across / B).powi(2);
    let pressure = 1.5 * LOAD / (std::f64::consts::PI * A * B);
    FRICTION * pressure * inside.max(0.0).sqrt()
}

/// Creep force over the friction limit where particles pass by the angle `course` from the track.
fn steady(course: f64) -> Vector2<f64> {
    let (sine, cosine) = course.sin_cos();
    let grid = Grid::over([-7.5e-3, 7.5e-3], [-2.4e-3, 2.4e-3], 60, 32);
    let bound = grid.sample(|x, y| bound(cosine * x - sine * y, sine * x + cosine * y));
    let rigid = vec![[cosine * CREEPAGE, -sine * CREEPAGE]; grid.len()];
    let found = steady_rolling(&grid, &MaterialPair::new(STEEL, STEEL), &bound, &rigid);
    let [x, y] = share(&grid, &found.x, &found.y);
    Vector2::new(cosine * x - sine * y, sine * x + cosine * y)
}

fn share(grid: &Grid, x: &[f64], y: &[f64]) -> [f64; 2] {
    [x, y].map(|p| grid.element_area() * p.iter().sum::<f64>() / (FRICTION * LOAD))
}

/// Elements that stay on the particles, over which the patch moves step by step, know nothing of
/// steady rolling: in the end they have its force along the way of the patch, not along the track.
#[test]
fn particles_pass_along_the_way_of_a_patch_that_drifts() {
    let length = STEP * f64::from(STEPS);
    let (x, y) = ([-8e-3, length + 8e-3], [-2.4e-3, DRIFT * length + 2.4e-3]);
    let grid = Grid::over(x, y, 140, 46);
    let pair = MaterialPair::new(STEEL, STEEL);
    let mut before: Option<Vec<[f64; 2]>> = None;
    let mut force = [0.0; 2];
    for k in 0..=STEPS {
        let at = STEP * f64::from(k);
        let bound = grid.sample(|x, y| bound(x - at, y - DRIFT * at));
        let found = shift(&grid, &pair, &bound, [STEP * CREEPAGE, 0.0], before.as_deref());
        assert!(found.converged);
        force = share(&grid, &found.x, &found.y);
        before = Some(found.x.iter().zip(&found.y).map(|(x, y)| [*x, *y]).collect());
    }
    let [along_track, along_way] = [0.0, DRIFT.atan()].map(steady);
    let away = |steady: Vector2<f64>| (Vector2::from(force) - steady).norm();
    println!("{force:?} {along_way:?} {along_track:?}");
    assert!(away(along_way) < 0.5 * away(along_track));
}
