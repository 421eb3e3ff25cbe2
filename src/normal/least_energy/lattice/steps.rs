//! The overlap of one interval, taken at steps that follow it: a step is halved until the place in its
//! middle agrees with the cubic between both of its ends.

use super::super::line::OverlapLine;
use super::super::overlap::{End, ROUNDING};
use super::Lattice;
use super::lobes;
use super::sample::{Sample, cubic, expected, off};
use super::station::Station;
use crate::math::real::Real;

/// Steps in each interval in which the overlap is taken at first, and how often one is halved at
/// most: a millimetre of a rail down to a hundredth of it.
const STEPS: usize = 8;
const MAX_HALVINGS: f64 = 6.0;
/// Integral that a step may be wrong by over the depth times the width of a parabola of the same
/// width and slopes at its ends: from there to twice as much the halves of the step come in.
const SAMPLE_ERROR: f64 = 1e-6;

impl<T: Real> Lattice<T> {
    /// Takes the overlap in one interval.
    pub(super) fn sample(
        &mut self,
        line: &mut impl OverlapLine<T>,
        interval: usize,
        ends: &[End; 2],
    ) {
        let zero = T::from(0.0);
        let [from, to] = [0, 1].map(|side| ends[side].moving(line));
        // Beyond the last interval there is no room for.
        if self.samples.len() + 2 * STEPS >= self.samples.capacity() {
            return;
        }
        let first = self.samples.len();
        let ends_taken = [(from, ends[0]), (to, ends[1])].map(|(u, end)| {
            let mut at = line.place(u);
            // Where an overlap ends there is none, to rounding: its powers would feel that.
            if end.is_free {
                at.overlap = zero;
            }
            Sample::of(at, interval)
        });
        let width = ends_taken[1].at.y - ends_taken[0].at.y;
        let slopes = ends_taken[0].slope[1].abs() + ends_taken[1].slope[0].abs();
        // Where all of the overlap is rounding steps would be halved without end.
        let most = (width * slopes * (SAMPLE_ERROR / 8.0) + ROUNDING) * width;
        self.samples.push(ends_taken[0]);
        self.is_folded = false;
        for k in 1..=STEPS {
            let share = k as f64 / STEPS as f64;
            let to = if k < STEPS {
                Sample::of(line.place(from + (to - from) * share), interval)
            } else {
                ends_taken[1]
            };
            self.go_to(line, to, most, [T::from(1.0), T::from(MAX_HALVINGS)]);
        }
        let [low, high] = [self.samples[first].at.y, self.samples[self.samples.len() - 1].at.y];
        if self.samples.len() - first < 2 {
            self.samples.truncate(first);
            return;
        }
        let mut sample = first;
        for k in 0..=lobes::STEPS {
            let y = low + (high - low) * lobes::AT[k];
            while sample + 2 < self.samples.len() && self.samples[sample + 1].at.y <= y {
                sample += 1;
            }
            let [a, b] = [&self.samples[sample], &self.samples[sample + 1]];
            let t = (y - a.at.y) / (b.at.y - a.at.y);
            let overlap = if (k == 0 && ends[0].is_free) || (k == lobes::STEPS && ends[1].is_free) {
                zero
            } else {
                cubic(a, b, t)[0].at_least(0.0)
            };
            self.stations.push(Station {
                y,
                sample,
                interval,
                overlap,
                share: zero,
                lobe: [zero; 3],
                pedestal: zero,
                x: a.at.x + (b.at.x - a.at.x) * t,
                centre: zero,
                spread: zero,
                measure: zero,
            });
        }
    }

    /// Takes the places up to `to`, the step halved up to `halvings` times. What is found in its
    /// middle has the `weight` beside what both ends say, so that places come and go without a jump.
    fn go_to(
        &mut self,
        line: &mut impl OverlapLine<T>,
        to: Sample<T>,
        most: T,
        [weight, halvings]: [T; 2],
    ) {
        let from = self.samples[self.samples.len() - 1];
        let found = Sample::of(line.place((from.at.u + to.at.u) * 0.5), to.interval);
        let step = [&from, &found, &to];
        let is_whole = weight.value() >= 1.0;
        let has_room = self.samples.len() + 2 * STEPS < self.samples.capacity();
        let is_halved = halvings.value() > 0.0
            && has_room
            && off(step.map(|sample| sample.overlap().map(T::value))) > most.value();
        // What counts wholly is what was found.
        let middle = if is_whole { found } else { expected(step).towards(&found, weight) };
        if !is_halved {
            self.push(middle);
            self.push(to);
            return;
        }
        let error = (off(step.map(Sample::overlap)) / most - 1.0).at_most(1.0);
        let weight = weight * error * error * (error * -2.0 + 3.0);
        let halves = [weight, halvings - 1.0];
        self.go_to(line, middle, most, halves);
        self.go_to(line, to, most, halves);
    }

    /// Adds a sample with the integrals up to it. Where the line folds, what lies behind is passed
    /// over, straight.
    fn push(&mut self, mut sample: Sample<T>) {
        let last = self.samples.len() - 1;
        let before = &mut self.samples[last];
        if sample.at.y.value() <= before.at.y.value() {
            self.is_folded = true;
            return;
        }
        if self.is_folded {
            self.is_folded = false;
            let h = sample.at.y - before.at.y;
            let slope = (sample.at.overlap - before.at.overlap) / h;
            let rate = (sample.at.u - before.at.u) / h;
            (before.slope[1], before.rate[1]) = (slope, rate);
            (sample.slope[0], sample.rate[0]) = (slope, rate);
        }
        let [_, one, two] = cubic(before, &sample, T::from(1.0));
        sample.integrals = [one, two];
        self.samples.push(sample);
    }
}
