//! What keeps interpolated forces within friction.

use super::ellipse_force::ForceSlopes;

/// The friction limit: what interpolation puts beyond it is brought back smoothly, within a margin
/// that vanishes in full sliding.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    magnitude: f64,
    /// Bounded magnitude, its derivative by the magnitude, and by the share 1 - s.
    bounded: f64,
    by_magnitude: f64,
    by_left: f64,
}

/// Margin over 1 - s.
const MARGIN: f64 = 0.02;

impl Bound {
    pub fn of(force: &[f64; 3], left: f64) -> Self {
        let magnitude = (force[0] * force[0] + force[1] * force[1]).sqrt();
        let margin = MARGIN * left;
        let over = magnitude - (1.0 - margin);
        if over <= 0.0 {
            return Self { magnitude, bounded: magnitude, by_magnitude: 1.0, by_left: 0.0 };
        }
        if over >= 2.0 * margin {
            return Self { magnitude, bounded: 1.0, by_magnitude: 0.0, by_left: 0.0 };
        }
        let share = over / (2.0 * margin);
        Self {
            magnitude,
            bounded: magnitude - 0.5 * over * share,
            by_magnitude: 1.0 - share,
            by_left: MARGIN * share * (share - 1.0),
        }
    }

    pub fn applied(&self, [x, y, moment]: [f64; 3]) -> [f64; 3] {
        if self.bounded < self.magnitude {
            let ratio = self.bounded / self.magnitude;
            return [ratio * x, ratio * y, moment];
        }
        [x, y, moment]
    }

    pub fn applied_to_slopes(
        &self,
        [x, y, _]: &[f64; 3],
        mut slopes: ForceSlopes,
        left_slopes: [f64; 4],
    ) -> ForceSlopes {
        if self.bounded >= self.magnitude {
            return slopes;
        }
        let ratio = self.bounded / self.magnitude;
        for (n, left_slope) in left_slopes.into_iter().enumerate() {
            let magnitude_slope = (x * slopes[0][n] + y * slopes[1][n]) / self.magnitude;
            let ratio_slope = (self.by_magnitude * magnitude_slope + self.by_left * left_slope
                - ratio * magnitude_slope)
                / self.magnitude;
            slopes[0][n] = ratio * slopes[0][n] + ratio_slope * x;
            slopes[1][n] = ratio * slopes[1][n] + ratio_slope * y;
        }
        slopes
    }
}
