//! Spline coefficients over up to four coordinates, four channels at each knot, and sums over them.

use crate::math::vectors::with_vectors;

/// Channels of a knot: longitudinal and lateral force, moment, share of slip.
pub type Channels = [f64; 4];

/// Coefficients on a grid; the last coordinate varies fastest.
#[derive(Clone, Debug)]
pub struct Coefficients {
    /// Coefficients along each coordinate: three more than intervals, or one where there is none
    /// (the second, or the last two).
    pub counts: [usize; 4],
    /// [first][second][third][fourth] and channels. Single precision: a look-up reads 4 KiB of
    /// them.
    pub values: Vec<[f32; 4]>,
}

/// Place along one coordinate: first coefficient and the weights of it and those behind it, with
/// their derivatives by the coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Index of the first coefficient.
    pub first: usize,
    /// Weights.
    pub weights: [f64; 4],
    /// Their derivatives.
    pub slopes: [f64; 4],
}

/// A sum over coefficients, and its derivatives by the four coordinates.
pub type Sums = [Channels; 5];

impl Coefficients {
    /// The spline at `places`.
    pub fn value(&self, places: &[Place; 4]) -> Channels {
        let [_, n1, n2, n3] = self.counts;
        value(&self.values, [n1 * n2 * n3, n2 * n3, n3], n1.min(4), places)
    }

    /// The spline at `places` with its derivatives.
    pub fn value_and_slopes(&self, places: &[Place; 4]) -> Sums {
        let [_, n1, n2, n3] = self.counts;
        value_and_slopes(&self.values, [n1 * n2 * n3, n2 * n3, n3], n1.min(4), places)
    }

    /// The value along the first two coordinates alone, where the others have one coefficient.
    pub fn plane_value(&self, places: [&Place; 2]) -> Channels {
        let mut sum = [0.0; 4];
        for i in 0..4 {
            let from = (places[0].first + i) * self.counts[1] + places[1].first;
            let Some(row) = self.values.get(from..from + 4) else { continue };
            for (j, knot) in row.iter().enumerate() {
                let weight = places[0].weights[i] * places[1].weights[j];
                for (sum, value) in sum.iter_mut().zip(knot) {
                    *sum += weight * f64::from(*value);
                }
            }
        }
        sum
    }

    /// The same with derivatives; the last two are 0.
    pub fn plane_value_and_slopes(&self, places: [&Place; 2]) -> Sums {
        let mut sums = [[0.0; 4]; 5];
        for i in 0..4 {
            for j in 0..4 {
                let at = (places[0].first + i) * self.counts[1] + places[1].first + j;
                let weights = [
                    places[0].weights[i] * places[1].weights[j],
                    places[0].slopes[i] * places[1].weights[j],
                    places[0].weights[i] * places[1].slopes[j],
                ];
                for (sum, weight) in sums.iter_mut().zip(weights) {
                    for (sum, value) in sum.iter_mut().zip(&self.values[at]) {
                        *sum += weight * f64::from(*value);
                    }
                }
            }
        }
        sums
    }
}

fn value(values: &[[f32; 4]], strides: [usize; 3], depth: usize, places: &[Place; 4]) -> Channels {
    with_vectors(
        #[inline(always)]
        || {
            let mut sum = [0.0; 4];
            let from = places[3].first;
            let inner = places[3].weights;
            for i in 0..4 {
                for j in 0..depth {
                    let outer = places[0].weights[i] * places[1].weights[j];
                    let at = (places[0].first + i) * strides[0]
                        + (places[1].first + j) * strides[1]
                        + places[2].first * strides[2]
                        + from;
                    for k in 0..4 {
                        let weight = outer * places[2].weights[k];
                        let at = at + k * strides[2];
                        let Some(row) = values.get(at..at + 4) else { continue };
                        for c in 0..4 {
                            let along = inner[0] * f64::from(row[0][c])
                                + inner[1] * f64::from(row[1][c])
                                + inner[2] * f64::from(row[2][c])
                                + inner[3] * f64::from(row[3][c]);
                            sum[c] += weight * along;
                        }
                    }
                }
            }
            sum
        },
    )
}

fn value_and_slopes(
    values: &[[f32; 4]],
    strides: [usize; 3],
    depth: usize,
    places: &[Place; 4],
) -> Sums {
    with_vectors(
        #[inline(always)]
        || {
            let mut sums = [[0.0; 4]; 5];
            let from = places[3].first;
            for i in 0..4 {
                // By the second, third and fourth coordinate.
                let mut plane = [[0.0; 4]; 4];
                for j in 0..depth {
                    let at = (places[0].first + i) * strides[0]
                        + (places[1].first + j) * strides[1]
                        + places[2].first * strides[2]
                        + from;
                    let mut line = [[0.0; 4]; 3];
                    for k in 0..4 {
                        let at = at + k * strides[2];
                        let Some(row) = values.get(at..at + 4) else { continue };
                        let (weight, slope) = (places[2].weights[k], places[2].slopes[k]);
                        for c in 0..4 {
                            let (mut along, mut along_slope) = (0.0, 0.0);
                            for (l, knot) in row.iter().enumerate() {
                                along += places[3].weights[l] * f64::from(knot[c]);
                                along_slope += places[3].slopes[l] * f64::from(knot[c]);
                            }
                            line[0][c] += weight * along;
                            line[1][c] += slope * along;
                            line[2][c] += weight * along_slope;
                        }
                    }
                    let (weight, slope) = (places[1].weights[j], places[1].slopes[j]);
                    for c in 0..4 {
                        plane[0][c] += weight * line[0][c];
                        plane[1][c] += slope * line[0][c];
                        plane[2][c] += weight * line[1][c];
                        plane[3][c] += weight * line[2][c];
                    }
                }
                let (weight, slope) = (places[0].weights[i], places[0].slopes[i]);
                for c in 0..4 {
                    sums[0][c] += weight * plane[0][c];
                    sums[1][c] += slope * plane[0][c];
                    sums[2][c] += weight * plane[1][c];
                    sums[3][c] += weight * plane[2][c];
                    sums[4][c] += weight * plane[3][c];
                }
            }
            sums
        },
    )
}
