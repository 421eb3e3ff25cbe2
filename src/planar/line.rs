//! The separation of a planar contact problem as a curve.

use crate::geometry::contacts::separation::{Probe, Separation, SeparationPoint};
use crate::geometry::curves::curve::{Curve, Knot};
use crate::math::root::bracketed;
use crate::math::spline::{SplineEnd, interpolating_slopes};

/// The separation as a cubic spline, with y as parameter.
pub struct PlanarLine {
    pub curve: Curve,
    /// y of the deepest place [m].
    pub contact: f64,
    /// f there [m].
    pub least: f64,
    /// Knots and places of least and greatest f, counted from the least.
    pub probes: Vec<Probe>,
}

impl PlanarLine {
    /// The curve through points (y, f), y growing.
    pub fn new(points: &[[f64; 2]]) -> Self {
        let y: Vec<f64> = points.iter().map(|p| p[0]).collect();
        let f: Vec<f64> = points.iter().map(|p| p[1]).collect();
        let slopes = interpolating_slopes(&y, &f, [SplineEnd::Natural; 2]);
        let knots: Vec<Knot> = (0..y.len())
            .map(|i| Knot { s: y[i], point: [y[i], f[i]], tangent: [1.0, slopes[i]] })
            .collect();
        let curve = Curve::through(&knots);
        let mut probes = Vec::new();
        for pair in knots.windows(2) {
            probes.push(Probe { u: pair[0].s, f: pair[0].point[1] });
            let slope = |u: f64| curve.at(u).first[1];
            // The slope of a cubic piece is monotone on either side of its inflection.
            let (s0, s1) = (pair[0].s, pair[1].s);
            let (bend0, bend1) = (curve.at(s0).second[1], curve.at(s1.next_down()).second[1]);
            let inflection = s0 + (s1 - s0) * bend0 / (bend0 - bend1);
            let inner = if inflection > s0 && inflection < s1 { inflection } else { s1 };
            let ends = [(s0, pair[0].tangent[1]), (inner, slope(inner)), (s1, pair[1].tangent[1])];
            for end in ends.windows(2) {
                if end[0].1 * end[1].1 < 0.0 {
                    let u = bracketed(end[0], end[1], 1e-16, slope);
                    probes.push(Probe { u, f: curve.at(u).point[1] });
                }
            }
        }
        let last = &knots[knots.len() - 1];
        probes.push(Probe { u: last.s, f: last.point[1] });
        let deepest = probes.iter().copied().min_by(|a, b| a.f.total_cmp(&b.f));
        let Probe { u: contact, f: least } = deepest.unwrap_or(Probe { u: 0.0, f: 0.0 });
        for probe in &mut probes {
            probe.f -= least;
        }
        Self { curve, contact, least, probes }
    }
}

impl Separation for PlanarLine {
    fn at(&mut self, u: f64) -> SeparationPoint {
        let f = self.curve.at(u).point[1] - self.least;
        SeparationPoint { y: u - self.contact, dy: 1.0, f, x: 0.0 }
    }

    fn with_slope(&mut self, u: f64) -> (SeparationPoint, f64) {
        (self.at(u), self.curve.at(u).first[1])
    }
}
