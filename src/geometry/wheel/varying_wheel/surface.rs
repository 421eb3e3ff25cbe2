//! The surface of a wheel whose section varies around: where straight lines meet it.
//!
//! Between its rows the surface is a cubic across at each angle. With the depth d along the line
//! P + d e, the row v and the angle ψ from straight below,
//!
//! ```text
//! S(v, ψ) = P + d e
//! ```
//!
//! by Newton's method: d by the plane tangent at the last place, v and ψ by what is left within it.

use super::vectors::{cross, dot, in_plane};
use super::{Place, VaryingWheel};
use crate::geometry::wheel::surface_point::{Below, SurfacePoint};

/// Newton steps to a place: three are the rule.
const MAX_STEPS: usize = 12;
/// Newton step that is the last one [m], and least cosine of the angle between line and normal: as
/// of round wheels.
const LAST_STEP: f64 = 1e-8;
const MIN_COSINE: f64 = 0.1;

impl VaryingWheel {
    /// How far to either side of where a round wheel is met this one may overlap a rail that it
    /// overlaps by `depth` at most, both [m]: all of it lies within the circle of its highest
    /// places.
    pub fn reach(&self, depth: f64) -> f64 {
        self.reach * self.radius + (2.0 * self.radius * depth.max(0.0)).sqrt()
    }

    /// Where the straight line from `from` in the unit direction `direction` meets the wheel that
    /// was laid last, sought near the parameter s of its outline and at the distance `depth`, all
    /// in coordinates from the marker along the axle, forward and down; nothing where it does not.
    pub fn surface_along(
        &self,
        from: [f64; 3],
        direction: [f64; 3],
        guess: [f64; 2],
    ) -> Option<SurfacePoint> {
        self.met_along(from, direction, guess).map(|(point, _)| point)
    }

    /// The surface below the point `from`, with the directions along the track, to the right and
    /// down, sought near the parameter s of its outline and the depth of `guess`, all as of
    /// [`surface_along`](Self::surface_along).
    pub fn below(
        &self,
        from: [f64; 3],
        [forward, right, down]: [[f64; 3]; 3],
        guess: [f64; 2],
    ) -> Option<Below> {
        let (SurfacePoint { depth, normal, .. }, place) = self.met_along(from, down, guess)?;
        let facing = dot(normal, down);
        let slopes = [forward, right].map(|way| -dot(normal, way) / facing);
        // The way along the track on the surface by the tangents of row and circle.
        let way = [0, 1, 2].map(|i| forward[i] + slopes[0] * down[i]);
        let [a, b] = in_plane(way, place.across, place.around);
        let bend =
            (2.0 * a * b * dot(normal, place.twist) + b * b * dot(normal, place.bend)) / facing;
        Some(Below { depth, slopes, bend })
    }

    /// As [`surface_along`](Self::surface_along), and the place itself.
    fn met_along(
        &self,
        from: [f64; 3],
        direction: [f64; 3],
        [s, mut depth]: [f64; 2],
    ) -> Option<(SurfacePoint, Place)> {
        let Self { stand, surface, radius, .. } = self;
        let parameter = &surface.rows.parameter;
        let (first, last) = (parameter[0], parameter[parameter.len() - 1]);
        let over = radius * stand.angle;
        let start = self.envelope.row_parameter(surface, s);
        let at = |depth: f64| [0, 1, 2].map(|i| from[i] + depth * direction[i]);
        let [_, ahead, down] = at(depth);
        let (mut v, mut psi) = (start, ahead.atan2(down));
        for _ in 0..MAX_STEPS {
            if !(v > first && v < last) {
                return None;
            }
            let p = surface.between(v, over + radius * psi, over, stand.slice)?;
            let here = self.turned(&p, psi);
            let (a, b) = (here.across, here.around);
            let normal = cross(a, b);
            let size = dot(normal, normal).sqrt();
            let normal = normal.map(|n| n / size);
            let facing = dot(normal, direction);
            // Not a number where rows meet in a point.
            if facing.is_nan() || facing <= MIN_COSINE {
                return None;
            }
            let to = at(depth);
            let missing = [0, 1, 2].map(|i| here.point[i] - to[i]);
            let step = dot(normal, missing) / facing;
            depth += step;
            let aside = [0, 1, 2].map(|i| step * direction[i] - missing[i]);
            let [along_row, around] = in_plane(aside, a, b);
            v += along_row;
            psi += around;
            if step.abs() + along_row.abs() + (radius * around).abs() <= LAST_STEP {
                // The parameter of the outline moves as the rows do.
                return Some((SurfacePoint { s: s + v - start, depth, normal }, here));
            }
        }
        None
    }
}
