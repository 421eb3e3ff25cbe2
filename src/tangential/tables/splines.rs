//! From the tabulated numbers to spline coefficients, once in a process.
//!
//! Over the two angles every channel is carried on by its symmetry: across the equator (mirror
//! image along) longitudinal force is odd, the rest even; a step of π in azimuth turns lateral
//! force and moment; over the pole elevation goes back and azimuth turns by π.
//!
//! Lateral force and moment vanish on the pole with slopes that must be those of a plane, or the
//! derivatives would depend on the side one comes from. So the plane p y + q z is taken off
//! beforehand and what is left is held flat there.

use std::f64::consts::{FRAC_PI_2, PI};

use super::coefficients::Coefficients;
use super::nodes::{
    AZIMUTH_CELLS, ELEVATION_CELLS, Nodes, RATIOS, RING, SATURATION_CELLS, SATURATIONS,
    SLIDING_AZIMUTH_CELLS, SLIDING_ELEVATION_CELLS, SLIDING_RING,
};
use crate::math::b_spline;

/// The table as splines.
#[derive(Clone, Debug)]
pub struct Splines {
    /// Correction K less its plane at the pole, and share of slip, over ln(a/b), s, χ, ψ.
    pub creep: Coefficients,
    /// (p, q) of lateral force, then of moment, over ln(a/b) and s.
    pub planes: Coefficients,
    /// Full sliding less its closed form, over ln(a/b), -, χ, ψ.
    pub sliding: Coefficients,
}

impl Splines {
    /// Those of `nodes`.
    pub fn new(nodes: &Nodes) -> Self {
        let saturations = SATURATION_CELLS + 1;
        // [channel][ratio][saturation][elevation][azimuth] with elevation and azimuth as
        // coefficients already
        let mut creep: [Vec<f64>; 4] = Default::default();
        let mut planes: [Vec<f64>; 4] = Default::default();
        for i in 0..RATIOS {
            let ring = |j: usize| {
                let from = (i * SATURATIONS + j - 1) * RING;
                &nodes.creep[from..from + RING]
            };
            for j in 0..saturations {
                let at: Vec<[f64; 4]> = (0..RING).map(|k| saturation_end(&ring, j, k)).collect();
                for c in 0..4 {
                    let mut values: Vec<f64> = at.iter().map(|v| v[c]).collect();
                    if c == 1 || c == 2 {
                        let plane = pole_plane(&values);
                        planes[2 * c - 2].push(plane[0]);
                        planes[2 * c - 1].push(plane[1]);
                        take_off(&mut values, plane);
                    }
                    creep[c].extend(sphere(&values, [ELEVATION_CELLS, AZIMUTH_CELLS], c));
                }
            }
        }
        let angles = [ELEVATION_CELLS + 3, AZIMUTH_CELLS + 3];
        let mut sliding: [Vec<f64>; 4] = Default::default();
        for ring in nodes.sliding.chunks_exact(SLIDING_RING) {
            for c in 0..3 {
                let values: Vec<f64> = ring.iter().map(|v| v[c]).collect();
                let cells = [SLIDING_ELEVATION_CELLS, SLIDING_AZIMUTH_CELLS];
                sliding[c].extend(sphere(&values, cells, c));
            }
        }
        sliding[3] = vec![0.0; sliding[0].len()];
        let sliding_angles = [SLIDING_ELEVATION_CELLS + 3, SLIDING_AZIMUTH_CELLS + 3];
        Self {
            creep: interleaved(creep, [RATIOS, saturations, angles[0], angles[1]]),
            planes: interleaved(planes, [RATIOS, saturations, 1, 1]),
            sliding: interleaved(sliding, [RATIOS, 1, sliding_angles[0], sliding_angles[1]]),
        }
    }
}

/// Values at saturation `j` in 0..=SATURATION_CELLS: tabulated in between; at the ends nothing and
/// everything slips, and K, which counts for nothing there, carries on as a parabola.
fn saturation_end<'a>(ring: &impl Fn(usize) -> &'a [[f64; 4]], j: usize, k: usize) -> [f64; 4] {
    let parabola = |a: usize, b: usize, c: usize| {
        let [a, b, c] = [a, b, c].map(|j| ring(j)[k]);
        [0, 1, 2].map(|n| 3.0 * a[n] - 3.0 * b[n] + c[n])
    };
    match j {
        0 => {
            let [x, y, m] = parabola(1, 2, 3);
            [x, y, m, 0.0]
        }
        j if j == SATURATION_CELLS => {
            let [x, y, m] = parabola(j - 1, j - 2, j - 3);
            [x, y, m, 1.0]
        }
        j => ring(j)[k],
    }
}

/// Slopes by y and z at the pole, from the first harmonic on the two rings next to it: the even
/// part of its ratio to cos χ.
fn pole_plane(values: &[f64]) -> [f64; 2] {
    let harmonic = |ring: usize, of: fn(f64) -> f64| {
        let from = (ELEVATION_CELLS - ring) * AZIMUTH_CELLS;
        let across = (FRAC_PI_2 * ring as f64 / ELEVATION_CELLS as f64).sin();
        let sum: f64 = (0..AZIMUTH_CELLS)
            .map(|k| values[from + k] * of(PI * k as f64 / AZIMUTH_CELLS as f64))
            .sum();
        2.0 * sum / (AZIMUTH_CELLS as f64 * across)
    };
    [f64::cos, f64::sin].map(|of| (4.0 * harmonic(1, of) - harmonic(2, of)) / 3.0)
}

fn take_off(values: &mut [f64], [p, q]: [f64; 2]) {
    for (k, value) in values.iter_mut().enumerate() {
        let [_, y, z] = super::nodes::ring_direction(k, ELEVATION_CELLS, AZIMUTH_CELLS);
        *value -= p * y + q * z;
    }
}

/// Coefficients over both angles of `values` on rings and pole: [elevation][azimuth].
fn sphere(values: &[f64], [elevations, azimuths]: [usize; 2], channel: usize) -> Vec<f64> {
    let is_turned = channel == 1 || channel == 2;
    let turn = if is_turned { -1.0 } else { 1.0 };
    // Along each ring, carried on by a turn to either side, so that its ends have no say.
    let mut rings: Vec<Vec<f64>> = values[..elevations * azimuths]
        .chunks_exact(azimuths)
        .map(|ring| {
            let scaled = |sign: f64| ring.iter().map(move |v| sign * v);
            let long: Vec<f64> =
                scaled(turn).chain(scaled(1.0)).chain(scaled(turn)).chain(scaled(1.0)).collect();
            let mut own = b_spline::coefficients(&long)[azimuths..2 * azimuths + 3].to_vec();
            // To the last bit, or forces would jump by a rounding at the seam.
            for k in 0..3 {
                own[azimuths + k] = turn * own[k];
            }
            own
        })
        .collect();
    let pole = if is_turned { 0.0 } else { values[elevations * azimuths] };
    rings.push(vec![pole; azimuths + 3]);
    let mut result = vec![0.0; (elevations + 3) * (azimuths + 3)];
    for k in 0..azimuths + 3 {
        let column: Vec<f64> = rings.iter().map(|ring| ring[k]).collect();
        let coefficients = if is_turned {
            flat_at_the_end(&column)
        } else {
            mirrored_at_both_ends(&column, if channel == 0 { -1.0 } else { 1.0 })
        };
        for (row, c) in coefficients.into_iter().enumerate() {
            result[row * (azimuths + 3) + k] = c;
        }
    }
    result
}

/// Coefficients of a function that is even about its end and even (`sign` 1) or odd (-1) about its
/// beginning.
fn mirrored_at_both_ends(values: &[f64], sign: f64) -> Vec<f64> {
    let n = values.len() - 1;
    // Far enough to both sides for the ends to have no say.
    let at = |k: usize| {
        let (turns, rest) = (k / (2 * n), k % (2 * n));
        let inside = values[if rest <= n { rest } else { 2 * n - rest }];
        // f(k + 2 n) = f(-k) = sign f(k); k = 4 n is the first value.
        if turns.is_multiple_of(2) { inside } else { sign * inside }
    };
    let long: Vec<f64> = (0..=8 * n).map(at).collect();
    let mut own = b_spline::coefficients(&long)[4 * n..5 * n + 3].to_vec();
    own[0] = sign * own[2];
    own[n + 2] = own[n];
    if sign < 0.0 {
        own[1] = 0.0;
    }
    own
}

/// Coefficients of a function that is even about its beginning, and odd and flat about its end: the
/// last but one value is not met.
fn flat_at_the_end(values: &[f64]) -> Vec<f64> {
    let n = values.len() - 1;
    // Unknown are c_0 to c_{n-2}; c_{n-1} = c_n = 0 = c_{n+1}, c_{-1} = c_1.
    let count = n - 1;
    let (mut upper, mut right) = (vec![0.0; count], vec![0.0; count]);
    for k in 0..count {
        let before = if k > 0 { [upper[k - 1], right[k - 1]] } else { [0.0; 2] };
        let pivot = 4.0 - before[0];
        upper[k] = if k == 0 { 2.0 } else { 1.0 } / pivot;
        right[k] = (6.0 * values[k] - before[1]) / pivot;
    }
    for k in (0..count - 1).rev() {
        right[k] -= upper[k] * right[k + 1];
    }
    let mut coefficients = vec![right[1]];
    coefficients.extend(right);
    coefficients.extend([0.0; 3]);
    coefficients
}

/// Interpolates along the first two of `counts`, where there is more than one value, and brings the
/// channels together.
fn interleaved(channels: [Vec<f64>; 4], mut counts: [usize; 4]) -> Coefficients {
    let channels = channels.map(|mut values| {
        let mut sizes = counts;
        for axis in [0, 1] {
            if sizes[axis] > 1 {
                values = along(&values, sizes, axis);
                sizes[axis] += 2;
            }
        }
        values
    });
    for count in &mut counts[..2] {
        *count += if *count > 1 { 2 } else { 0 };
    }
    let values =
        (0..channels[0].len()).map(|k| [0, 1, 2, 3].map(|c| channels[c][k] as f32)).collect();
    Coefficients { counts, values }
}

fn along(values: &[f64], counts: [usize; 4], axis: usize) -> Vec<f64> {
    let inner: usize = counts[axis + 1..].iter().product();
    let outer: usize = counts[..axis].iter().product();
    let count = counts[axis];
    let mut result = vec![0.0; outer * (count + 2) * inner];
    let mut line = vec![0.0; count];
    for o in 0..outer {
        for i in 0..inner {
            for (k, value) in line.iter_mut().enumerate() {
                *value = values[(o * count + k) * inner + i];
            }
            for (k, c) in b_spline::coefficients(&line).into_iter().enumerate() {
                result[(o * (count + 2) + k) * inner + i] = c;
            }
        }
    }
    result
}
