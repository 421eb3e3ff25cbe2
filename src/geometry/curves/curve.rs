//! A plane curve of cubic pieces, as which every wheel and rail profile is evaluated.
//!
//! Each piece is the cubic Hermite interpolant of the points and tangents at its two knots, so that
//! a cubic spline (values and first derivatives at the knots) is carried over exactly. The
//! parameter is close to arc length, which makes steep flanks and vertical faces as good as the
//! tread.

use crate::math::real::{Cubic, Real};
use crate::math::spline::{SplineEnd, interpolating_slopes};

/// Point and tangent of a curve at one knot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knot<T = f64> {
    /// Curve parameter, close to arc length, strictly growing from knot to knot [m].
    pub s: T,
    /// Point (y, z) in the profile frame [m].
    pub point: [T; 2],
    /// Derivative of the point with respect to `s`, of length close to one [-].
    pub tangent: [T; 2],
}

/// Point and derivatives of a curve with respect to its parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct CurvePoint<T = f64> {
    /// Point (y, z) [m].
    pub point: [T; 2],
    /// First derivative [-].
    pub first: [T; 2],
    /// Second derivative [1/m].
    pub second: [T; 2],
}

impl<T: Real> CurvePoint<T> {
    #[inline(always)]
    fn of([point, first, second]: [[T; 2]; 3]) -> Self {
        Self { point, first, second }
    }

    /// Curvature (y' z'' - z' y'')/|(y', z')|³: positive where the curve turns towards positive z,
    /// as a rail head does seen along growing y [1/m].
    pub fn curvature(&self) -> T {
        let squared = self.first[0] * self.first[0] + self.first[1] * self.first[1];
        (self.first[0] * self.second[1] - self.first[1] * self.second[0]) / squared.three_halves()
    }
}

/// One cubic piece: coefficients of (y, z) in growing powers of `s - start`.
#[derive(Clone, Copy, Debug)]
struct Piece {
    start: f64,
    /// Where the next piece starts; not a number for the last one, so that no parameter is beyond
    /// it.
    next: f64,
    coefficients: Cubic,
}

/// A plane curve of cubic pieces (y(s), z(s)) in a profile frame [m].
#[derive(Clone, Debug)]
pub struct Curve {
    pieces: Vec<Piece>,
    start: f64,
    end: f64,
    /// For equal bins over the parameter range the first piece that reaches into the bin.
    bins: Vec<u32>,
    bins_per_length: f64,
    last_bin: f64,
}

/// Bins for each piece: on even knots a search takes one comparison.
const BINS_PER_PIECE: usize = 4;

impl Curve {
    /// The curve through at least two knots with strictly growing parameters.
    ///
    /// # Panics
    /// With fewer than two knots or parameters that do not grow: profiles are checked before.
    pub fn through(knots: &[Knot]) -> Self {
        let mut curve = Self {
            pieces: Vec::new(),
            start: 0.0,
            end: 0.0,
            bins: Vec::new(),
            bins_per_length: 0.0,
            last_bin: 0.0,
        };
        curve.put_through(knots);
        curve
    }

    /// Becomes the curve through other knots; allocates nothing within the room that there is.
    ///
    /// # Panics
    /// As [`through`](Self::through).
    pub fn put_through(&mut self, knots: &[Knot]) {
        assert!(knots.len() >= 2, "a curve needs two knots");
        assert!(knots.windows(2).all(|k| k[1].s > k[0].s), "knot parameters must grow");
        let Self { pieces, bins, .. } = self;
        pieces.clear();
        pieces.extend(knots.windows(2).map(|k| piece(&k[0], &k[1])));
        if let Some(last) = pieces.last_mut() {
            last.next = f64::NAN;
        }
        let (start, end) = (knots[0].s, knots[knots.len() - 1].s);
        let count = BINS_PER_PIECE * pieces.len();
        let bins_per_length = count as f64 / (end - start);
        bins.clear();
        let mut first = 0;
        bins.extend((0..=count).map(|bin| {
            // A bin holds what is rounded to its number; a little more makes up for rounding
            // errors.
            let s = start + (bin as f64 - 0.51) / bins_per_length;
            while first + 1 < pieces.len() && pieces[first + 1].start <= s {
                first += 1;
            }
            first as u32
        }));
        (self.start, self.end) = (start, end);
        (self.bins_per_length, self.last_bin) = (bins_per_length, count as f64);
    }

    /// Becomes `other`; allocates nothing within the room that there is.
    pub fn copy_from(&mut self, other: &Self) {
        self.pieces.clone_from(&other.pieces);
        self.bins.clone_from(&other.bins);
        (self.start, self.end) = (other.start, other.end);
        (self.bins_per_length, self.last_bin) = (other.bins_per_length, other.last_bin);
    }

    /// Makes room for curves through `knots` knots.
    pub fn reserve(&mut self, knots: usize) {
        self.pieces.reserve(knots.saturating_sub(self.pieces.len()));
        self.bins.reserve((BINS_PER_PIECE * knots).saturating_sub(self.bins.len()));
    }

    /// Smallest admitted parameter [m].
    pub fn start(&self) -> f64 {
        self.start
    }

    /// Largest admitted parameter [m].
    pub fn end(&self) -> f64 {
        self.end
    }

    /// The parameter of the range that is nearest to `s`; its start where `s` is not a number [m].
    #[inline]
    pub fn within(&self, s: f64) -> f64 {
        let s = if s > self.start { s } else { self.start };
        if s < self.end { s } else { self.end }
    }

    /// Point and derivatives at `s` [m]; outside the range the end pieces are continued.
    // Taken apart where it is used: half of its callers leave out the second derivative.
    #[inline(always)]
    pub fn at<T: Real>(&self, s: T) -> CurvePoint<T> {
        let p = self.piece_at(s.value());
        CurvePoint::of(s.on_cubic(p.start, &p.coefficients, std::ptr::from_ref(p).addr()))
    }

    /// The pieces of several parameters [m]: see [`PieceLanes::at`].
    // Inside each instruction set or not at all: a call would not be vectorised.
    #[inline(always)]
    pub(in crate::geometry) fn pieces_at<const N: usize>(&self, s: &[f64; N]) -> PieceLanes<N> {
        let mut lanes = PieceLanes { start: [0.0; N], coefficients: [[[0.0; N]; 2]; 4] };
        for lane in 0..N {
            let piece = self.piece_at(s[lane]);
            lanes.start[lane] = piece.start;
            for (lanes, own) in lanes.coefficients.iter_mut().zip(&piece.coefficients) {
                (lanes[0][lane], lanes[1][lane]) = (own[0], own[1]);
            }
        }
        lanes
    }

    /// Parameters at which the pieces meet, both ends included [m].
    pub fn knots(&self) -> impl Iterator<Item = f64> + '_ {
        self.pieces.iter().map(|p| p.start).chain(std::iter::once(self.end))
    }

    /// Unit normal of the curve at `s` to its `side`: 1 for (-z', y'), -1 for the other one.
    pub fn normal(&self, s: f64, side: f64) -> [f64; 2] {
        let [y, z] = self.at(s).first;
        let scale = side / y.hypotenuse(z);
        [-z * scale, y * scale]
    }

    /// The curve with its knots displaced along their normals to its `side`, as of
    /// [`normal`](Self::normal), by `ways` [m], one for each, and its tangents by the slopes of the
    /// natural cubic splines through these displacements.
    ///
    /// # Panics
    /// With another number of ways.
    pub fn displaced(&self, ways: &[f64], side: f64) -> Self {
        let parameters: Vec<f64> = self.knots().collect();
        assert_eq!(parameters.len(), ways.len(), "one way for each knot");
        let moved: Vec<[f64; 2]> = (parameters.iter().zip(ways))
            .map(|(&s, way)| self.normal(s, side).map(|n| n * way))
            .collect();
        let slopes = [0, 1].map(|axis| {
            let values: Vec<f64> = moved.iter().map(|moved| moved[axis]).collect();
            interpolating_slopes(&parameters, &values, [SplineEnd::Natural; 2])
        });
        let knots: Vec<Knot> = (parameters.iter().enumerate())
            .map(|(k, &s)| {
                let CurvePoint { point, first, .. } = self.at(s);
                let point = [0, 1].map(|axis| point[axis] + moved[k][axis]);
                Knot { s, point, tangent: [0, 1].map(|axis| first[axis] + slopes[axis][k]) }
            })
            .collect();
        Self::through(&knots)
    }

    /// Number of the piece at `s`, and how far behind its start that is [m].
    pub(in crate::geometry) fn place(&self, s: f64) -> (usize, f64) {
        let piece = self.piece_at(s);
        let number = self.number_at(std::ptr::from_ref(piece).addr()).unwrap_or(0);
        (number, s - piece.start)
    }

    /// Number of the piece that lies at this address, if it is one of this curve.
    pub(crate) fn number_at(&self, address: usize) -> Option<usize> {
        let from = self.pieces.as_ptr().addr();
        let number = address.checked_sub(from)? / size_of::<Piece>();
        (number < self.pieces.len()).then_some(number)
    }

    /// Length of piece `number` by its parameter [m].
    pub(in crate::geometry) fn piece_length(&self, number: usize) -> f64 {
        let end = self.pieces.get(number + 1).map_or(self.end, |next| next.start);
        end - self.pieces[number].start
    }

    /// First and last parameter of each piece [m].
    pub fn spans(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.knots().zip(self.knots().skip(1)).map(|(from, to)| [from, to])
    }

    #[inline(always)]
    fn piece_at(&self, s: f64) -> &Piece {
        // Adding 2^52 leaves the rounded number in the low bits; maximum and minimum turn any s,
        // not a number included, into a valid index.
        let bin = ((s - self.start) * self.bins_per_length).max(0.0);
        let bin = if bin < self.last_bin { bin } else { self.last_bin };
        let bin = (bin + 4_503_599_627_370_496.0).to_bits() as u32;
        let mut index = self.bins[bin as usize] as usize;
        let mut piece = &self.pieces[index];
        while piece.next <= s {
            index += 1;
            piece = &self.pieces[index];
        }
        piece
    }
}

/// The pieces of several parameters, by columns: a loop over them is compiled to vector
/// instructions.
pub(in crate::geometry) struct PieceLanes<const N: usize> {
    start: [f64; N],
    coefficients: [[[f64; N]; 2]; 4],
}

impl<const N: usize> PieceLanes<N> {
    /// As [`Curve::at`] for the parameter `s` of `lane` [m].
    #[inline(always)]
    pub(in crate::geometry) fn at(&self, lane: usize, s: f64) -> CurvePoint {
        let mut own = [[0.0; 2]; 4];
        for (own, lanes) in own.iter_mut().zip(&self.coefficients) {
            *own = [lanes[0][lane], lanes[1][lane]];
        }
        CurvePoint::of((s - self.start[lane]).cubic(&own))
    }
}

fn piece(from: &Knot, to: &Knot) -> Piece {
    let h = to.s - from.s;
    let cubic = |i: usize| {
        let slope = (to.point[i] - from.point[i]) / h;
        let (m0, m1) = (from.tangent[i], to.tangent[i]);
        [from.point[i], m0, (3.0 * slope - 2.0 * m0 - m1) / h, (m0 + m1 - 2.0 * slope) / (h * h)]
    };
    let (y, z) = (cubic(0), cubic(1));
    Piece {
        start: from.s,
        next: to.s,
        coefficients: [0, 1, 2, 3].map(|power| [y[power], z[power]]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_carried_over_exactly_on_uneven_knots() {
        let f = |s: f64| [s, 2.0 - s + 3.0 * s * s - s * s * s];
        let d = |s: f64| [1.0, -1.0 + 6.0 * s - 3.0 * s * s];
        let knots: Vec<Knot> = [-1.0, -0.9, 0.3, 0.31, 2.0]
            .iter()
            .map(|&s| Knot { s, point: f(s), tangent: d(s) })
            .collect();
        let curve = Curve::through(&knots);
        for i in 0..=300 {
            let s = -1.0 + 0.01 * f64::from(i);
            let p = curve.at(s);
            approx::assert_relative_eq!(p.point[1], f(s)[1], epsilon = 1e-12);
            approx::assert_relative_eq!(p.first[1], d(s)[1], epsilon = 1e-12);
            approx::assert_relative_eq!(p.second[1], 6.0 - 6.0 * s, epsilon = 1e-10);
        }
    }
}
