//! Bounds of a wheel's profile from which it follows how far the contact line may be followed in
//! one step.

use super::sample::Sample;
use crate::geometry::curves::curve::Curve;
use crate::geometry::wheel::contact_line::ContactLine;

/// Step inside an interval of penetration: waves of a profile that are shorter are not told apart
/// [m].
const INSIDE_STEP: f64 = 1.5e-3;

/// Least step outside [m]; a dip that fits into it is found where the slope changes sign.
const MIN_STEP: f64 = 5e-4;

/// Length of the bins for which the concavity of the wheel is kept [m].
pub(super) const BIN: f64 = 4e-3;

/// Concavity times distance up to which the curvature of a hollow rail bounds the step.
const MAX_HOLLOW: f64 = 0.5;

/// Share of the bound that a step takes: the contact line of a yawed wheel is a little more curved
/// than the profile.
const STEP_SHARE: f64 = 0.9;

/// Bounds over bins along the profile of a wheel.
#[derive(Clone, Debug, Default)]
pub(super) struct WheelBounds {
    /// Greatest concave curvature over each bin and the next [1/m].
    concavity: Vec<f64>,
    /// Greatest factor in [`ContactLine::stretch_per_factor`] over each bin and the next [1/m].
    stretch: Vec<f64>,
}

impl WheelBounds {
    /// Takes another profile; allocates nothing within the room that there is.
    pub fn follow(&mut self, wheel: &Curve) {
        let count = ((wheel.end() - wheel.start()) / BIN).ceil() as usize + 1;
        let Self { concavity: concave, stretch, .. } = self;
        for bins in [&mut *concave, &mut *stretch] {
            bins.clear();
            bins.resize(count + 1, 0.0);
        }
        for pair in wheel.spans() {
            // Curvature is close to linear over a piece; a long one still has to reach every bin.
            let count = ((pair[1] - pair[0]) / (0.5 * BIN)) as usize + 4;
            for i in 0..=count {
                let share = (i as f64 / count as f64).clamp(0.001, 0.999);
                let s = pair[0] + share * (pair[1] - pair[0]);
                let p = wheel.at(s);
                let bin = ((s - wheel.start()) / BIN) as usize;
                concave[bin] = concave[bin].max(p.curvature());
                stretch[bin] = stretch[bin].max(ContactLine::stretch_factor(&p));
            }
        }
        // Each bin with the next.
        for bins in [concave, stretch] {
            for i in 0..count {
                bins[i] = bins[i].max(bins[i + 1]);
            }
            bins.truncate(count);
        }
    }

    /// Makes room for wheels whose profile is `longer` [m] than the one there is.
    pub fn reserve(&mut self, longer: f64) {
        let bins = (longer / BIN).ceil() as usize + 1;
        self.concavity.reserve(bins);
        self.stretch.reserve(bins);
    }

    /// How far the line may be followed without passing a penetration.
    pub fn step(&self, from: &Sample, line: &ContactLine, rail_concavity: f64) -> f64 {
        if from.distance <= 0.0 {
            return INSIDE_STEP;
        }
        let [start, end] = line.range();
        let per_factor = line.stretch_per_factor();
        let last = self.concavity.len() - 1;
        let here = (((from.u - start) / BIN) as usize).min(last);
        let stretch_over = |bin: usize| 1.0 + per_factor * self.stretch[bin];
        // The distance is 1-Lipschitz: go on until the line may have become as long as it.
        let (mut u, mut left, mut bin) = (from.u, STEP_SHARE * from.distance, here);
        loop {
            let stretch = stretch_over(bin);
            let edge = start + (bin + 1) as f64 * BIN;
            if left < stretch * (edge - u) || bin == last {
                u += left / stretch;
                break;
            }
            left -= stretch * (edge - u);
            u = edge;
            bin += 1;
        }
        let mut step = u.min(end) - from.u;
        // From afar a hollow of the rail bends the distance more, 1/(1 - concavity·d), and beyond
        // its centre without bound.
        let hollow = rail_concavity * from.distance;
        if !from.beyond_end && hollow < MAX_HOLLOW {
            let concavity = self.concavity[here] + rail_concavity / (1.0 - hollow);
            let slope = from.slope;
            // d + slope·t - concavity·t²/2 vanishes no sooner than at:
            let root = (slope * slope + 2.0 * concavity * from.distance).sqrt();
            let bound = if slope < 0.0 {
                2.0 * from.distance / (root - slope)
            } else {
                (slope + root) / concavity.max(1e-3)
            };
            // The bounds hold to the end of the next bin.
            let reach = start + (here + 2) as f64 * BIN - from.u;
            step = step.max(STEP_SHARE * bound.min(reach) / stretch_over(here));
        }
        step.max(MIN_STEP)
    }
}
