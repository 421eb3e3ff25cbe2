//! Derivatives of a number by the knots of a curve, which shape it: what was seen of the curve at
//! some parameters goes back to the points and tangents of the knots beside these.

use super::curve::Curve;
use crate::math::transposed_spline::add_by_values;

/// Derivatives by a knot.
#[derive(Clone, Copy, Debug, Default)]
pub struct ByKnot {
    /// By (y, z) of its point.
    pub point: [f64; 2],
    /// By (y, z) of its tangent.
    pub tangent: [f64; 2],
}

/// Derivatives by all knots of a curve, whose parameters stay.
#[derive(Clone, Debug, Default)]
pub struct KnotSlopes {
    /// One for each knot.
    pub knots: Vec<ByKnot>,
    work: Work,
}

/// Memory for going back through the splines.
#[derive(Clone, Debug, Default)]
struct Work {
    parameters: Vec<f64>,
    by_values: [Vec<f64>; 2],
    by_slopes: Vec<f64>,
    solver: [Vec<f64>; 2],
}

impl KnotSlopes {
    /// Becomes that of a number that does not depend on `curve`.
    pub fn clear(&mut self, curve: &Curve) {
        self.knots.clear();
        self.knots.resize(curve.knots().count(), ByKnot::default());
    }

    /// Adds what a look at piece number `piece` of `curve`, `u` behind its start, is `by` point,
    /// first and second derivative.
    pub fn add(&mut self, curve: &Curve, piece: usize, u: f64, by: [[f64; 2]; 3]) {
        let h = curve.piece_length(piece);
        for axis in 0..2 {
            let [point, first, second] = by.map(|by| by[axis]);
            // By the coefficients of the powers of u.
            let c0 = point;
            let c1 = point * u + first;
            let c2 = point * u * u + first * 2.0 * u + second * 2.0;
            let c3 = point * u * u * u + first * 3.0 * u * u + second * 6.0 * u;
            // c2 = (3 chord - 2 t - t')/h, c3 = (t + t' - 2 chord)/h².
            let (c2, c3) = (c2 / h, c3 / (h * h));
            let chord = (3.0 * c2 - 2.0 * c3) / h;
            self.knots[piece].point[axis] += c0 - chord;
            self.knots[piece].tangent[axis] += c1 - 2.0 * c2 + c3;
            self.knots[piece + 1].point[axis] += chord;
            self.knots[piece + 1].tangent[axis] += c3 - c2;
        }
    }

    /// The same of a look at the parameter `s` [m].
    pub fn add_at(&mut self, curve: &Curve, s: f64, by: [[f64; 2]; 3]) {
        let (piece, u) = curve.place(s);
        self.add(curve, piece, u, by);
    }

    /// Derivatives by normal displacements of the points of `curve` to its `side`, 1 for the one
    /// that is to the right of its tangent with z down (a wheel's outside) and -1 for the other
    /// one, as [`Curve::displaced`] has it; `found` gets them.
    pub fn by_displacements(&mut self, curve: &Curve, side: f64, found: &mut Vec<f64>) {
        let Self { knots, work: Work { parameters, by_values, by_slopes, solver } } = self;
        parameters.clear();
        parameters.extend(curve.knots());
        for (axis, by_values) in by_values.iter_mut().enumerate() {
            by_values.clear();
            by_values.extend(knots.iter().map(|by| by.point[axis]));
            by_slopes.clear();
            by_slopes.extend(knots.iter().map(|by| by.tangent[axis]));
            add_by_values(parameters, by_slopes, by_values, solver);
        }
        let [y, z] = by_values;
        let normals = parameters.iter().map(|&s| curve.normal(s, side));
        found.clear();
        found.extend(normals.zip(y.iter().zip(z)).map(|([ny, nz], (y, z))| ny * *y + nz * *z));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::curves::curve::Knot;

    #[test]
    fn displacements_move_what_is_seen_as_they_say() {
        let knots: Vec<Knot> = (0..7)
            .map(|i| {
                let s = 0.01 * f64::from(i * i + i);
                let (sine, cosine) = (20.0 * s).sin_cos();
                Knot { s, point: [0.05 * sine, 0.05 - 0.05 * cosine], tangent: [cosine, sine] }
            })
            .collect();
        let curve = Curve::through(&knots);
        let (s, by) = (0.17, [[0.3, -2.0], [0.02, 0.01], [1e-4, -3e-4]]);
        let seen = |curve: &Curve| -> f64 {
            let at = curve.at(s);
            let all = [at.point, at.first, at.second];
            all.iter().zip(&by).flat_map(|(a, b)| [a[0] * b[0], a[1] * b[1]]).sum()
        };
        let mut slopes = KnotSlopes::default();
        slopes.clear(&curve);
        slopes.add_at(&curve, s, by);
        for side in [1.0, -1.0] {
            let mut found = Vec::new();
            slopes.by_displacements(&curve, side, &mut found);
            for (i, found) in found.into_iter().enumerate() {
                let displaced = |way: f64| {
                    let mut ways = [0.0; 7];
                    ways[i] = way;
                    seen(&curve.displaced(&ways, side))
                };
                // Linear but for rounding.
                let step = 1e-3;
                let difference = (displaced(step) - displaced(-step)) / (2.0 * step);
                approx::assert_relative_eq!(found, difference, epsilon = 1e-11);
            }
        }
    }
}
