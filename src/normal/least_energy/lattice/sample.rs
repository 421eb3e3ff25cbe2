//! A place at which the overlap is taken: with its slope, it is a cubic between two of them.

use super::super::line::{LinePlace, OverlapLine, Section};
use crate::math::real::{Function, Real};

/// Most places of all intervals at which the overlap is taken.
pub(super) const MAX_SAMPLES: usize = 1024;

/// A place at which the overlap is taken.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample<T> {
    pub at: LinePlace<T>,
    /// Number of the interval of overlap.
    pub interval: usize,
    /// Parameter of the line that radii are taken at: straight on between samples, so that one that
    /// comes in changes none [m].
    pub straight: T,
    /// Derivatives of the overlap and of the parameter by the coordinate across, before and behind
    /// the place: only where the line folds they are two [-].
    pub slope: [T; 2],
    pub rate: [T; 2],
    /// Integral of the overlap from the first place of the interval on, and the integral of that
    /// [m², m³].
    pub integrals: [T; 2],
}

/// Value and both integrals of the cubic between two samples at the share `t` of the way.
pub(super) fn cubic<T: Real>(a: &Sample<T>, b: &Sample<T>, t: T) -> [T; 3] {
    let ([one, two], overlaps) = (a.integrals, [a.at.overlap, b.at.overlap]);
    let numbers = [a.at.y, b.at.y, overlaps[0], overlaps[1], a.slope[1], b.slope[0], one, two, t];
    T::as_whole(numbers, &Between)
}

/// What holds between two samples as a function of both, of which each begins with its place across.
struct Between;

impl Function<9, 3> for Between {
    #[inline]
    fn at<T: Real>(&self, [from, to, a, b, a_slope, b_slope, one, two, t]: [T; 9]) -> [T; 3] {
        let h = to - from;
        let (rise, [d0, d1]) = (b - a, [a_slope * h, b_slope * h]);
        let (c0, c1, c2, c3) = (a, d0, rise * 3.0 - d0 * 2.0 - d1, d0 + d1 - rise * 2.0);
        let value = c0 + t * (c1 + t * (c2 + t * c3));
        let first = t * (c0 + t * (c1 * 0.5 + t * (c2 * (1.0 / 3.0) + t * c3 * 0.25)));
        let second =
            t * t * (c0 * 0.5 + t * (c1 * (1.0 / 6.0) + t * (c2 * (1.0 / 12.0) + t * c3 * 0.05)));
        [value, one + h * first, two + h * (t * one + h * second)]
    }
}

/// The parameter and its rate, and the slope of the overlap, between two samples.
struct Along;

impl Function<9, 3> for Along {
    #[inline]
    fn at<T: Real>(&self, [h, rise, from, a_rate, b_rate, secant, a, b, t]: [T; 9]) -> [T; 3] {
        let rates = [a_rate * h, b_rate * h];
        let bend = rise * 3.0 - rates[0] * 2.0 - rates[1];
        let turn = rates[0] + rates[1] - rise * 2.0;
        let u = from + t * (rates[0] + t * (bend + t * turn));
        let rate = (rates[0] + t * (bend * 2.0 + t * turn * 3.0)) / h;
        let slope = a + t * (secant * 6.0 - a * 4.0 - b * 2.0 + t * ((a + b - secant * 2.0) * 3.0));
        [u, rate, slope]
    }
}

/// What two samples say of the place at the share `t` of the way: overlap and parameter of the line
/// are cubics.
pub(super) fn between<T: Real>(a: &Sample<T>, b: &Sample<T>, t: T) -> Sample<T> {
    let (h, rise) = (b.at.y - a.at.y, b.at.u - a.at.u);
    let [overlap, one, two] = cubic(a, b, t);
    let secant = (b.at.overlap - a.at.overlap) / h;
    let numbers = [h, rise, a.at.u, a.rate[1], b.rate[0], secant, a.slope[1], b.slope[0], t];
    let [u, rate, slope] = T::as_whole(numbers, &Along);
    let mix = |a: T, b: T| a + (b - a) * t;
    let (x, y) = (mix(a.at.x, b.at.x), mix(a.at.y, b.at.y));
    let tangent = [0, 1].map(|axis| mix(a.at.tangent[axis], b.at.tangent[axis]));
    let at = LinePlace { u, y, overlap, x, tangent, ..a.at };
    let (slope, rate, straight) = ([slope; 2], [rate; 2], mix(a.straight, b.straight));
    Sample { at, interval: a.interval, straight, slope, rate, integrals: [one, two] }
}

/// The section along x at the place `at` the share `t` of the way between two samples.
///
/// The parameter goes straight from one to the other. Where the curvature of a wheel jumps, its
/// rate does, and with that a cubic would as a sample passes there.
pub(super) fn section<T: Real>(
    line: &mut impl OverlapLine<T>,
    [a, b]: [&Sample<T>; 2],
    t: T,
    at: LinePlace<T>,
) -> Section<T> {
    let u = a.straight + (b.straight - a.straight) * t;
    line.section(&LinePlace { u, ..at })
}

/// What both ends of a step say of the place across that was found in its middle, or, where the line
/// folds and that is not between them, of the nearer one.
pub(super) fn expected<T: Real>([from, found, to]: [&Sample<T>; 3]) -> Sample<T> {
    let h = to.at.y - from.at.y;
    if h.value() <= 0.0 {
        return *found;
    }
    between(from, to, ((found.at.y - from.at.y) / h).within(0.0, 1.0))
}

/// How far the overlap found in the middle of a step is from what both ends say, over the step [m²];
/// of three samples what [`Sample::overlap`] says.
pub(super) fn off<T: Real>([from, found, to]: [[T; 4]; 3]) -> T {
    let ([from, a, _, a_slope], [at, overlap, ..], [to, b, b_slope, _]) = (from, found, to);
    let h = to - from;
    let none = T::from(0.0);
    let [expected, ..] =
        T::as_whole([from, to, a, b, a_slope, b_slope, none, none, (at - from) / h], &Between);
    (expected - overlap).abs() * h
}

impl<T: Real> Sample<T> {
    /// The sample at such a place of interval number `interval`.
    pub fn of(at: LinePlace<T>, interval: usize) -> Self {
        let rate = T::from(1.0) / at.dy;
        let (slope, rate) = ([at.overlap_slope * rate; 2], [rate; 2]);
        Self { at, interval, straight: at.u, slope, rate, integrals: [T::from(0.0); 2] }
    }

    /// Its place across, and the overlap there with both slopes.
    pub fn overlap(&self) -> [T; 4] {
        [self.at.y, self.at.overlap, self.slope[0], self.slope[1]]
    }

    /// This one, `weight` of the way towards another one of the same place across.
    pub fn towards(&self, other: &Self, weight: T) -> Self {
        let mix = |a: T, b: T| a + (b - a) * weight;
        let (a, b) = (&self.at, &other.at);
        let both = |a: [T; 2], b: [T; 2]| [mix(a[0], b[0]), mix(a[1], b[1])];
        let at = LinePlace {
            u: mix(a.u, b.u),
            overlap: mix(a.overlap, b.overlap),
            x: mix(a.x, b.x),
            tangent: both(a.tangent, b.tangent),
            ..*b
        };
        let straight = mix(self.straight, other.straight);
        let (slope, rate) = (both(self.slope, other.slope), both(self.rate, other.rate));
        Self { at, straight, slope, rate, ..*other }
    }
}
