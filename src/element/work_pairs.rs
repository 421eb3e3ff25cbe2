//! Forces on wheel and rails beside the velocities at which they do work.

use super::input::{RailMotion, WheelMotion};
use super::output::Wrench;

/// A component of a force [N] and its velocity [m/s], or of a moment [N m] and its angular velocity
/// [rad/s], in each pair. Zeros where there are fewer: a wheelset on two rails on each side has
/// all.
pub type WorkPairs = [[f64; 2]; MAX_PAIRS];

const OF_BODY: usize = 6;
const OF_RAIL: usize = 3;
/// A body and four rails.
pub const MAX_PAIRS: usize = OF_BODY + 4 * OF_RAIL;

/// The pairs of a wheel or a wheelset with its force about its own marker, and of the rails under
/// it.
pub fn work_pairs<'a>(
    body: (&WheelMotion, &Wrench),
    rails: impl Iterator<Item = (&'a RailMotion, &'a Wrench)>,
) -> WorkPairs {
    let mut pairs = [[0.0; 2]; MAX_PAIRS];
    let (motion, wrench) = body;
    let turning = motion.angular_velocity();
    for i in 0..3 {
        pairs[i] = [wrench.force[i], motion.velocity[i]];
        // Rates near the greatest number add up to more.
        pairs[3 + i] = [wrench.moment[i], turning[i].clamp(-f64::MAX, f64::MAX)];
    }
    for (own, (motion, wrench)) in pairs[OF_BODY..].chunks_exact_mut(OF_RAIL).zip(rails) {
        own.copy_from_slice(&[
            [wrench.force[1], motion.vy],
            [wrench.force[2], motion.vz],
            [wrench.moment[0], motion.roll_rate],
        ]);
    }
    pairs
}

/// Energy that forces held over a step of `duration` [s] have put into the bodies beyond what the
/// mean of the forces at both ends would have, both at the mean of the velocities; the greatest
/// number where it is beyond all numbers [J].
///
/// ```text
/// R = ½ h Σ (F_0 - F_1) (v_0 + v_1)/2
/// ```
pub fn energy_residual(start: &WorkPairs, end: &WorkPairs, duration: f64) -> f64 {
    let pairs = start.iter().zip(end);
    let sum: f64 = pairs.map(|([f0, v0], [f1, v1])| (f0 - f1) * (v0 + v1)).sum();
    let residual = 0.25 * duration * sum;
    if residual.is_finite() { residual } else { f64::MAX }
}
