//! Stresses below the surface: CONTACT's square, Hertz, equilibrium, what strips are worth.

mod balance;
mod fatigue;
mod hertz;
mod results;
mod square;

use std::f64::consts::PI;

use wheelrail::boundary_element::grid::Grid;
use wheelrail::material::Material;
use wheelrail::subsurface::SurfaceLoad;

use crate::tolerance;

/// Poisson's ratio of the figures in text books.
const BOOK: Material = Material { young_modulus: 2.1e11, poisson_ratio: 0.3 };

/// Integral of √(1 - t²) from -1, clamped.
fn half_disk(t: f64) -> f64 {
    let t = t.clamp(-1.0, 1.0);
    0.5 * (t * (1.0 - t * t).sqrt() + t.asin()) + 0.25 * PI
}

/// Hertz's pressure over the ellipse with semi-axes `a` along and `b` across, 1 at most, on `count`
/// by `count` elements; of each the mean, and the tractions (along x, along y, pressure) that `share`
/// makes of it.
fn ellipse([a, b]: [f64; 2], count: usize, share: [f64; 3], material: Material) -> SurfaceLoad {
    let grid = Grid::over([-a, a], [-b, b], count, count);
    let lines = 32;
    let mean = |k: usize| {
        let (x, y) = (grid.x(k % grid.along), grid.y(k / grid.along));
        let line = |l: usize| {
            // The middle of one of the lines along x, over which the integral is exact.
            let y = y + grid.dy * ((l as f64 + 0.5) / f64::from(lines) - 0.5);
            let half = (1.0 - (y / b).powi(2)).max(0.0).sqrt();
            let ends = [x + 0.5 * grid.dx, x - 0.5 * grid.dx].map(|x| half_disk(x / (a * half)));
            half * half * a * (ends[0] - ends[1]) / grid.dx
        };
        (0..lines as usize).map(line).sum::<f64>() / f64::from(lines)
    };
    let pressure: Vec<f64> = (0..grid.len()).map(mean).collect();
    let mut load = SurfaceLoad::none(material);
    load.add(grid, |k| share.map(|share| share * pressure[k]));
    load
}
