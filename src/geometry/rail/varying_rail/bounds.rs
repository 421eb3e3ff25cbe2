//! Where the rows of a rail can be met by a wheel at all, and where more than once.

use crate::geometry::sections::rows::surface::{REACH, Surface};
use crate::geometry::sections::slices::Rows;
use crate::geometry::uneven::waviness::Waviness;
use crate::math::real::Real;

/// Radius of the lowest points of any wheel over its nominal one [-].
pub(super) const LARGEST: f64 = 1.1;
/// Curvature along the track from which on a row may be hollow for a wheel, over that of the wheel
/// [-].
const HOLLOW_SHARE: f64 = 0.7;

/// Where a row is within reach.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bound {
    /// Range of y [m].
    pub y: [f64; 2],
    /// Least z [m].
    pub least: f64,
    /// Least z of what a wheel meets, lowered by what its part above stands higher [m].
    pub top: f64,
}

/// Bounds of all rows, by slices but the last and rows within each: of what a wheel between this
/// slice and the next one can meet.
#[derive(Clone, Debug)]
pub(super) struct Bounds {
    all: Vec<Bound>,
    /// For each row and slice the number of slices up to it between which the row may be hollow.
    hollows: Vec<u32>,
    count: usize,
}

impl Bounds {
    /// Bounds under a wheel of `radius` [m] with the deviations `wheel` over its arc.
    pub fn new(surface: &Surface, radius: f64, wheel: &Waviness) -> Self {
        let rows = &surface.rows;
        let (rail, wheel) = (surface.corrugation.bounds(), wheel.bounds());
        Self {
            all: bounds(rows, radius, rail.range[1] + wheel.range[1]),
            hollows: hollows(rows, radius, rail.curvature),
            count: surface.count(),
        }
    }

    /// That of row `j` for a wheel behind `slice`.
    pub fn of(&self, j: usize, slice: usize) -> &Bound {
        let last = self.all.len() / self.count - 1;
        &self.all[slice.min(last) * self.count + j]
    }

    /// Whether row `j` may be hollow between two slices.
    pub fn is_hollow(&self, j: usize, [from, to]: [usize; 2]) -> bool {
        self.hollows[to * self.count + j] > self.hollows[from * self.count + j]
    }
}

/// Bounds of all rows, which waves of rail and wheel lift by up to `crest`, under a wheel of `radius` between
/// each slice and the next [m].
fn bounds(rows: &Rows, radius: f64, crest: f64) -> Vec<Bound> {
    let Rows { places, knots, .. } = rows;
    let count = rows.parameter.len();
    let none =
        Bound { y: [f64::INFINITY, f64::NEG_INFINITY], least: f64::INFINITY, top: f64::INFINITY };
    let spans = places.len() - 1;
    // The points that control a cubic go around it.
    let mut own = vec![none; count * spans];
    for (i, own) in own.chunks_mut(count).enumerate() {
        let third = (places[i + 1] - places[i]) / 3.0;
        for (j, bound) in own.iter_mut().enumerate() {
            for (k, way) in [(i, third), (i + 1, -third)] {
                let knot = &knots[k * count + j];
                for way in [0.0, way] {
                    let [y, z] = [0, 1].map(|c| knot.value[c] + way * knot.slope[c]);
                    bound.y = [bound.y[0].min(y), bound.y[1].max(y)];
                    bound.least = bound.least.min(z - crest);
                }
            }
        }
    }
    let mut all = vec![none; count * spans];
    for (i, all) in all.chunks_mut(count).enumerate() {
        let (first, last) = (places[i] - REACH, places[i + 1] + REACH);
        for k in (0..spans).filter(|&k| places[k + 1] >= first && places[k] <= last) {
            let away = (places[k] - places[i + 1]).max(places[i] - places[k + 1]).max(0.0);
            let drop = 0.5 * away * away / (LARGEST * radius);
            for (bound, own) in all.iter_mut().zip(&own[k * count..]) {
                bound.y = [bound.y[0].min(own.y[0]), bound.y[1].max(own.y[1])];
                bound.least = bound.least.min(own.least);
                bound.top = bound.top.min(own.least + drop);
            }
        }
    }
    all
}

/// For each row and slice the number of slices up to it between which the row may be hollow for a
/// wheel of `radius` [m], where corrugation is curved by up to `waves` [1/m].
fn hollows(rows: &Rows, radius: f64, waves: f64) -> Vec<u32> {
    let count = rows.parameter.len();
    let most = HOLLOW_SHARE / radius;
    let mut hollows = vec![0; count * rows.places.len()];
    for i in 1..rows.places.len() {
        let h = rows.places[i] - rows.places[i - 1];
        for j in 0..count {
            let [from, to] = [i - 1, i].map(|i| rows.knots[i * count + j]);
            // Second derivatives at both ends, between which that of a cubic is straight.
            let bends = |c: usize| {
                let rise = 3.0 * (to.value[c] - from.value[c]) / h;
                [
                    2.0 * (rise - 2.0 * from.slope[c] - to.slope[c]) / h,
                    2.0 * (from.slope[c] + 2.0 * to.slope[c] - rise) / h,
                ]
            };
            let (y, z) = (bends(0), bends(1));
            // Along any normal between that of the section and the vertical: hollow is what bends
            // up.
            let is_hollow = [from, to].into_iter().any(|knot| {
                let [_, _, dy, dz] = knot.value;
                let limit = most * dy.hypotenuse(dz);
                [0, 1].into_iter().any(|end| {
                    (y[end] * dz).abs() - (z[end].min(0.0) - waves) * dy.hypotenuse(dz) > limit
                })
            });
            hollows[i * count + j] = hollows[(i - 1) * count + j] + u32::from(is_hollow);
        }
    }
    hollows
}
