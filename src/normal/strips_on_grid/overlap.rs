//! The intervals of a contact line in which the undeformed bodies overlap.

use super::line::{Line, LinePlace, OverlapLine};
use crate::geometry::separation::Probe;
use crate::math::real::Real;
use crate::math::room::Room;
use crate::math::root::bracketed;

/// One end of an interval of overlap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct End {
    /// Parameter of the line [m].
    pub u: f64,
    /// Coordinate across [m].
    pub y: f64,
    /// Derivative of the overlap by the coordinate across; nothing where a body ends [-].
    pub slope: Option<f64>,
}

/// A part of an interval in which the overlap grows to a peak and falls again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lobe {
    /// Number of the interval.
    pub interval: usize,
    /// Its peak, and the valley behind it if another lobe follows in the interval.
    pub peak: Turn,
    pub valley: Option<Turn>,
}

/// A place at which the overlap is greatest or least beside itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turn {
    /// Parameter of the line [m].
    pub u: f64,
    /// Coordinate across [m].
    pub y: f64,
}

/// The intervals of a contact line in which the bodies overlap, and the lobes in them.
#[derive(Clone, Debug)]
pub(super) struct Overlaps {
    pub intervals: Room<[End; 2]>,
    pub lobes: Room<Lobe>,
}

/// Most intervals of overlap of one rail, and lobes in all of them; further lobes belong to the last ones.
pub(super) const MOST_OVERLAPS: usize = 32;
pub(super) const MOST_LOBES: usize = 2 * MOST_OVERLAPS;
/// Newton steps towards an end before it is bracketed.
const MOST_STEPS: usize = 6;
/// Last Newton step towards an end [m]; what is left is of the order of its square.
const LAST_STEP: f64 = 1e-8;
/// Bracket of an end that Newton's method does not find [m].
const BRACKET: f64 = 1e-15;

impl Overlaps {
    pub fn new() -> Self {
        Self { intervals: Room::new(MOST_OVERLAPS), lobes: Room::new(MOST_LOBES) }
    }

    /// Takes the intervals in which the overlap `level` - f is positive, from the `probes`, between two of which it changes its
    /// sign at most once, and among which are all places where it is least or greatest.
    pub fn fill(&mut self, line: &mut impl Line, probes: &[Probe], level: f64) {
        self.intervals.clear();
        self.lobes.clear();
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
                None => end_at(line.place(probes[inside].u), false),
            };
            let left = end(begin, begin.checked_sub(1));
            let right = end(k - 1, Some(k).filter(|&k| k < probes.len()));
            // Rounding may leave nothing of an overlap of picometres.
            if right.y > left.y {
                self.intervals.push([left, right]);
                self.add_lobes(line, &probes[begin..k]);
            }
        }
    }

    /// Adds the lobes of the last interval, in which the `probes` are.
    fn add_lobes(&mut self, line: &mut impl Line, probes: &[Probe]) {
        let interval = self.intervals.len() - 1;
        let mut turn = |probe: &Probe| Turn { u: probe.u, y: line.place(probe.u).y };
        let mut peak = &probes[0];
        for (k, probe) in probes.iter().enumerate() {
            if probe.f < peak.f {
                peak = probe;
            }
            let is_valley = k > 0
                && probes[k - 1].f <= probe.f
                && probes.get(k + 1).is_some_and(|next| next.f < probe.f);
            // The last lobe of the interval needs room too.
            if is_valley && self.lobes.len() + 1 < self.lobes.capacity() {
                self.lobes.push(Lobe { interval, peak: turn(peak), valley: Some(turn(probe)) });
                peak = &probes[k + 1];
            }
        }
        if self.lobes.len() < self.lobes.capacity() {
            self.lobes.push(Lobe { interval, peak: turn(peak), valley: None });
        }
    }
}

/// The place between two probes at which the overlap ends.
fn crossing(line: &mut impl Line, inside: &Probe, outside: &Probe, level: f64) -> End {
    let (a, b) = ((inside.u, level - inside.f), (outside.u, level - outside.f));
    let (low, high) = (a.0.min(b.0), a.0.max(b.0));
    let mut u = if b.1.is_finite() { a.0 + (b.0 - a.0) * a.1 / (a.1 - b.1) } else { a.0 };
    for _ in 0..MOST_STEPS {
        let place = line.place(u);
        let step = -place.overlap / place.overlap_slope;
        u += step;
        if !(u >= low && u <= high) {
            break;
        }
        if step.abs() <= LAST_STEP {
            return end_at(line.place(u), true);
        }
    }
    let u = bracketed(a, b, BRACKET, |u| line.place(u).overlap);
    end_at(line.place(u), true)
}

fn end_at(place: LinePlace, is_free: bool) -> End {
    let LinePlace { u, y, dy, overlap_slope, .. } = place;
    End { u, y, slope: is_free.then_some(overlap_slope / dy) }
}

impl End {
    /// Coordinate across as it moves with `line` [m].
    pub(super) fn moving<T: Real>(&self, line: &mut impl OverlapLine<T>) -> T {
        match self.slope {
            Some(slope) if T::HAS_SLOPES && slope != 0.0 => {
                let overlap = line.at(T::from(self.y), self.u).overlap;
                let moved = T::moving(self.y, -overlap / slope);
                // What a slope that is a little off has left.
                let rest = line.at(moved, self.u).overlap;
                T::moving(self.y, moved - rest / slope)
            }
            _ => T::from(self.y),
        }
    }
}
