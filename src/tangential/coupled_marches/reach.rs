//! How far the tractions of a march reach to both sides of its strip.

use crate::math::real::Real;

/// Share of the distance to the edge of a zone within which tractions are taken as like those of
/// the strip: they fall towards the edge.
const SHARE: f64 = 0.8;

/// Reach to both sides from the distances to both edges [m].
pub(super) fn reach_within<T: Real>(edges: [T; 2]) -> [T; 2] {
    edges.map(|distance| (distance * SHARE).at_least(f64::MIN_POSITIVE))
}
