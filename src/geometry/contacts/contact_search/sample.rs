//! The distance of the contact line from the rail at one of its points.

/// Distance of one point of the line from the rail.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub u: f64,
    pub distance: f64,
    /// Derivative of the distance along the line, -1 to 1.
    pub slope: f64,
    pub rail_s: f64,
    pub rail_point: [f64; 2],
    pub rail_tangent: [f64; 2],
    /// Derivative of `rail_s` with respect to `u`.
    pub rail_rate: f64,
    pub beyond_end: bool,
}

/// Where the slope may have another sign than at two neighbouring samples, where it has the same:
/// where that of the cubic through both is farthest from it. A wave of the profile that is shorter
/// than a step shows there.
pub(super) fn hidden_turn(from: &Sample, to: &Sample) -> Option<f64> {
    let (a, b) = (from.slope, to.slope);
    if a * b <= 0.0 {
        return None;
    }
    let mean = (to.distance - from.distance) / (to.u - from.u);
    // Slope a + p t + q t², t from 0 to 1.
    let (p, q) = (6.0 * mean - 4.0 * a - 2.0 * b, 3.0 * (a + b) - 6.0 * mean);
    let t = -0.5 * p / q;
    let turns = t > 0.0 && t < 1.0 && a * (a + 0.5 * p * t) < 0.0;
    turns.then_some(from.u + t * (to.u - from.u))
}
