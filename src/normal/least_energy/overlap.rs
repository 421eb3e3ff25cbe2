//! The intervals of a contact line in which the undeformed bodies overlap.

use super::line::OverlapLine;
use crate::geometry::contacts::separation::Probe;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;
use crate::math::root::bracketed;

/// One end of an interval of overlap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct End {
    /// Parameter of the line [m].
    pub u: f64,
    /// Whether the overlap goes to zero there; else a body ends.
    pub is_free: bool,
}

/// The intervals of a contact line in which the bodies overlap.
#[derive(Clone, Debug)]
pub(super) struct Overlaps {
    pub intervals: FixedVec<[End; 2]>,
}

/// Most intervals of overlap of one rail.
pub(super) const MAX_OVERLAPS: usize = 32;
/// Overlap below which there is none [m]: what the rounding of coordinates of a metre leaves.
pub(super) const ROUNDING: f64 = 1e-15;
/// Newton steps towards an end before it is bracketed.
const MAX_STEPS: usize = 6;
/// Last Newton step towards an end [m]; what is left is of the order of its square.
const LAST_STEP: f64 = 1e-8;
/// Bracket of an end that Newton's method does not find [m].
const BRACKET: f64 = 1e-15;

impl Overlaps {
    pub fn new() -> Self {
        Self { intervals: FixedVec::new(MAX_OVERLAPS) }
    }

    /// Takes the intervals in which the overlap `level` - f is positive, from the `probes`, between
    /// two of which it changes its sign at most once.
    pub fn fill(&mut self, line: &mut impl OverlapLine, probes: &[Probe], level: f64) {
        self.intervals.clear();
        if probes.iter().all(|probe| level - probe.f < ROUNDING) {
            return;
        }
        let is_inside = |probe: &Probe| level > probe.f;
        let mut k = 0;
        while k < probes.len() && self.intervals.len() < self.intervals.capacity() {
            if !is_inside(&probes[k]) {
                k += 1;
                continue;
            }
            let begin = k;
            while k < probes.len() && is_inside(&probes[k]) {
                k += 1;
            }
            let mut end = |inside: usize, outside: Option<usize>| match outside {
                Some(outside) => crossing(line, &probes[inside], &probes[outside], level),
                None => End { u: probes[inside].u, is_free: false },
            };
            let left = end(begin, begin.checked_sub(1));
            let right = end(k - 1, Some(k).filter(|&k| k < probes.len()));
            // Rounding may leave nothing of an overlap of picometres.
            if right.u > left.u {
                self.intervals.push([left, right]);
            }
        }
    }
}

/// The place between two probes at which the overlap ends.
fn crossing(line: &mut impl OverlapLine, inside: &Probe, outside: &Probe, level: f64) -> End {
    let (a, b) = ((inside.u, level - inside.f), (outside.u, level - outside.f));
    let (low, high) = (a.0.min(b.0), a.0.max(b.0));
    let mut u = if b.1.is_finite() { a.0 + (b.0 - a.0) * a.1 / (a.1 - b.1) } else { a.0 };
    for _ in 0..MAX_STEPS {
        let place = line.place(u);
        let step = -place.overlap / place.overlap_slope;
        u += step;
        if !(u >= low && u <= high) {
            break;
        }
        if step.abs() <= LAST_STEP {
            return End { u, is_free: true };
        }
    }
    let u = bracketed(a, b, BRACKET, |u| line.place(u).overlap);
    End { u, is_free: true }
}

impl End {
    /// Parameter of the line as it moves with `line` [m].
    pub fn moving<T: Real>(&self, line: &mut impl OverlapLine<T>) -> T {
        if !T::HAS_SLOPES {
            return T::from(self.u);
        }
        if !self.is_free {
            return line.body_end(self.u);
        }
        let place = line.place(T::from(self.u));
        let slope = place.overlap_slope.value();
        if slope == 0.0 { T::from(self.u) } else { T::moving(self.u, -place.overlap / slope) }
    }
}
