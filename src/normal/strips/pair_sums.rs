//! Sums over pairs of nodes: what one source does to many targets at once.
//!
//! Targets lie side by side, so that sums over sources need no sum within a vector. Compiled for several instruction sets, the widest one
//! chosen at run time: each entry is computed by itself and sources are summed in order, so that all of them give the same bits.

use multiversion::multiversion;

use super::cell::TERMS;
use super::influence::{centred_at, shifted_at};

/// Numbers taken together: loops over whole vectors have no remainder, which would be taken one by one.
pub const LANES: usize = 4;
/// Most targets at once.
pub const MOST_TARGETS: usize = 8 * LANES;

/// A number for each target. Its length is known when the loops are compiled, so that columns side by side are known to be apart.
pub type Column = [f64; MOST_TARGETS];

/// Nodes at which sums are taken; what is behind the last one is any number.
#[derive(Clone, Debug, Default)]
pub struct Targets {
    /// Whole vectors of targets.
    pub vectors: usize,
    /// Place across and along [m], derivative of the latter by the former [-].
    pub y: Column,
    pub x: Column,
    pub x_slope: Column,
    /// Unit tangent across.
    pub tangent: [Column; 2],
    /// Pressure over π E* [-] and one over the half length [1/m].
    pub pressure: Column,
    pub inverse_length: Column,
    /// One, zero for the target that is the source.
    pub other: Column,
    /// Share of each target in the curvature equations of its lobe, times the radius [m].
    pub weights: [Column; TERMS],
}

/// One strip that acts.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// Place across and along [m], derivative of the latter by the former [-].
    pub y: f64,
    pub x: f64,
    pub x_slope: f64,
    /// Unit tangent across.
    pub tangent: [f64; 2],
    /// Width [m], pressure over π E* [-] and half length [m].
    pub width: f64,
    pub pressure: f64,
    pub half_length: f64,
    /// Legendre polynomials of its lobe.
    pub legendre: [f64; TERMS],
    /// Change of its place and of its width with the left and the right edge of its lobe, the latter over the width [-, 1/m].
    pub travel: [f64; 2],
    pub stretch: [f64; 2],
}

/// What one source does to each target.
#[derive(Clone, Debug, Default)]
pub struct Acting {
    /// Influence of the source, and with the target's half length for its own.
    d: Column,
    slope: Column,
    bend: Column,
    own_d: Column,
    own_slope: Column,
    own_bend: Column,
    /// Derivatives of displacement and curvature by the pressure of the source.
    pub by_pressure: Column,
    pub bent_by_pressure: Column,
}

/// What all sources of one lobe do to each target.
#[derive(Clone, Debug, Default)]
pub struct Sums {
    /// Displacement and curvature.
    pub u: Column,
    pub curvature: Column,
    /// Their derivatives by the shape of the lobe.
    pub by_shape: [Column; TERMS],
    pub bent_by_shape: [Column; TERMS],
    /// What takes the singularity out of the sums of the own lobe, for a pressure of one, and its derivatives by pressure with half length.
    pub own_u: Column,
    pub own_q: Column,
    pub own_curvature: Column,
    pub own_bent_q: Column,
    /// Changes of displacement and curvature with the scale of the own lobe.
    pub scaled_u: Column,
    pub scaled_curvature: Column,
    /// Change of the displacement by other lobes where the target moves across.
    pub passed: Column,
    /// Changes of displacement and curvature with the two edges of the lobe.
    pub by_edge: [Column; 2],
    pub bent_by_edge: [Column; 2],
    /// Curvature beyond that of the wheel [1/m].
    pub excess: Column,
}

impl Sums {
    /// Sets to zero what is summed up over all lobes.
    pub fn begin(&mut self, vectors: usize) {
        clear([&mut self.u, &mut self.curvature, &mut self.passed], vectors);
    }

    /// Sets to zero what is summed up for each lobe.
    pub fn begin_lobe(&mut self, vectors: usize) {
        clear(self.by_shape.each_mut(), vectors);
        clear(self.bent_by_shape.each_mut(), vectors);
        clear(self.by_edge.each_mut(), vectors);
    }

    /// Sets to zero what is summed up for the own lobe alone.
    pub fn begin_own_lobe(&mut self, vectors: usize) {
        clear([&mut self.own_u, &mut self.own_q], vectors);
        clear([&mut self.own_curvature, &mut self.own_bent_q], vectors);
        clear([&mut self.scaled_u, &mut self.scaled_curvature], vectors);
    }
}

/// Sets whole vectors of columns to zero.
fn clear<const N: usize>(columns: [&mut Column; N], vectors: usize) {
    for column in columns {
        for vector in &mut column.as_chunks_mut::<LANES>().0[..vectors] {
            *vector = [0.0; LANES];
        }
    }
}

/// The influence of the source, shifted along x against the targets or not, on each of them.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
fn influence(source: &Source, is_skewed: bool, at: &Targets, acting: &mut Acting) {
    let count = LANES * at.vectors.min(MOST_TARGETS / LANES);
    let inverse = 1.0 / source.half_length;
    if is_skewed {
        for k in 0..count {
            let (dx, dy) = (source.x - at.x[k], source.y - at.y[k]);
            let influence = shifted_at(dx * inverse, dy * inverse);
            acting.d[k] = influence.d;
            acting.slope[k] = influence.slope;
            acting.bend[k] = influence.bend;
        }
    } else {
        for k in 0..count {
            let influence = centred_at((source.y - at.y[k]) * inverse);
            acting.d[k] = influence.d;
            acting.slope[k] = influence.slope;
            acting.bend[k] = influence.bend;
        }
    }
}

/// Adds a source in the lobe of the targets; `logarithm` has the weights of the logarithm, zero where the target is the source.
// Iterators over so many columns would not be read more easily.
#[allow(clippy::needless_range_loop)]
#[multiversion(targets("x86_64+avx2", "aarch64+neon"))]
pub fn within_lobe(
    source: &Source,
    is_skewed: bool,
    at: &Targets,
    logarithm: &Column,
    acting: &mut Acting,
    sums: &mut Sums,
) {
    influence(source, is_skewed, at, acting);
    let count = LANES * at.vectors.min(MOST_TARGETS / LANES);
    for k in 0..count {
        let own = centred_at((source.y - at.y[k]) * at.inverse_length[k]);
        acting.own_d[k] = own.d;
        acting.own_slope[k] = own.slope;
        acting.own_bend[k] = own.bend;
    }
    let Source { y, tangent, width, pressure: q, half_length: a, legendre, .. } = *source;
    let a2 = a * a;
    let inverse2 = 1.0 / a2;
    for k in 0..count {
        let w = width * at.other[k];
        let cosine = (at.tangent[0][k] * tangent[0] + at.tangent[1][k] * tangent[1]).max(0.0);
        let turned = w * cosine;
        let (c, d, slope) = (logarithm[k], acting.d[k], acting.slope[k]);
        let square = (at.y[k] - y) * (at.y[k] - y);
        let bend = acting.bend[k] * inverse2;
        // Exact straight across.
        let turn = 2.0 * acting.bend[k] * bend * d;
        let sum = 1.0 / (a2 + square);
        let b = a2 * sum;
        let e = b * sum;
        let by_pressure = turned * slope + c * b * (3.0 - 2.0 * b);
        let bent_by_pressure = turned * (slope * bend - turn) + c * e * (3.0 - 4.0 * b);
        let u = q * (turned * d + c * b);
        let curvature = q * (turned * d * bend + c * e);
        acting.by_pressure[k] = by_pressure;
        acting.bent_by_pressure[k] = bent_by_pressure;
        sums.u[k] += u;
        sums.curvature[k] += curvature;
        // By the logarithm of the half length: that by the pressure at given half length taken off that with it.
        let by_length = q * by_pressure - u;
        let bent_by_length = q * bent_by_pressure - curvature;
        for (term, p) in legendre.iter().enumerate() {
            sums.by_shape[term][k] += by_length * p;
            sums.bent_by_shape[term][k] += bent_by_length * p;
        }
        // The same with the half length of the target, which takes the singularity out.
        let (own_d, own_slope, own_b) = (acting.own_d[k], acting.own_slope[k], acting.own_bend[k]);
        let own_sum = own_b * at.inverse_length[k] * at.inverse_length[k];
        let own_turn = 2.0 * own_b * own_sum * own_d;
        let own_c = c * own_b;
        sums.own_u[k] += w * own_d + own_c;
        sums.own_q[k] += w * own_slope + own_c * (3.0 - 2.0 * own_b);
        sums.own_curvature[k] += (w * own_d + own_c) * own_sum;
        sums.own_bent_q[k] +=
            w * (own_slope * own_sum - own_turn) + own_c * own_sum * (3.0 - 4.0 * own_b);
        let own_pressure = at.pressure[k];
        let own_drop = 2.0 * own_d - own_slope;
        let drop = 2.0 * d - slope;
        sums.scaled_u[k] += w * (q * drop - own_pressure * own_drop)
            + c * (q * b * (2.0 * b - 1.0) - own_pressure * own_b * (2.0 * own_b - 1.0));
        sums.scaled_curvature[k] += w
            * (q * (drop - 2.0 * d * square * sum) * sum
                - own_pressure * (own_drop - 2.0 * own_d * square * own_sum) * own_sum);
    }
}

/// Adds a source in another lobe.
#[multiversion(targets("x86_64+avx2", "aarch64+neon"))]
pub fn from_elsewhere(
    source: &Source,
    is_skewed: bool,
    at: &Targets,
    acting: &mut Acting,
    sums: &mut Sums,
) {
    influence(source, is_skewed, at, acting);
    let count = LANES * at.vectors.min(MOST_TARGETS / LANES);
    let Source { y, x, x_slope, tangent, width, pressure: q, half_length: a, .. } = *source;
    let inverse2 = 1.0 / (a * a);
    for k in 0..count {
        let cosine = (at.tangent[0][k] * tangent[0] + at.tangent[1][k] * tangent[1]).max(0.0);
        let (d, slope) = (acting.d[k], acting.slope[k]);
        let (dy, dx) = (at.y[k] - y, at.x[k] - x);
        let bend = acting.bend[k] * inverse2;
        // Exact straight across.
        let turn = 2.0 * acting.bend[k] * bend * d;
        let turned = width * cosine;
        let by_pressure = turned * slope;
        let bent_by_pressure = turned * (slope * bend - turn);
        let u = q * turned * d;
        let curvature = u * bend;
        acting.by_pressure[k] = by_pressure;
        acting.bent_by_pressure[k] = bent_by_pressure;
        sums.u[k] += u;
        sums.curvature[k] += curvature;
        let by_length = q * by_pressure - u;
        let bent_by_length = q * bent_by_pressure - curvature;
        for (term, p) in source.legendre.iter().enumerate() {
            sums.by_shape[term][k] += by_length * p;
            sums.bent_by_shape[term][k] += bent_by_length * p;
        }
        // The distance changes where either of them moves along its line.
        let load = width * q;
        let steep = load * (d - slope) / (dy * dy + dx * dx);
        sums.passed[k] += steep * (dy + dx * at.x_slope[k]);
        let moved = steep * (dy + dx * x_slope);
        for side in 0..2 {
            sums.by_edge[side][k] += load * d * source.stretch[side] - moved * source.travel[side];
        }
    }
}

/// Σ of a column times the weights of the curvature equations.
#[multiversion(targets("x86_64+avx2", "aarch64+neon"))]
pub fn weighed(at: &Targets, column: &Column) -> [f64; TERMS] {
    let mut lanes = [[0.0; LANES]; TERMS];
    for vector in 0..at.vectors.min(MOST_TARGETS / LANES) {
        for (sum, weights) in lanes.iter_mut().zip(&at.weights) {
            for (k, sum) in sum.iter_mut().enumerate() {
                *sum += weights[LANES * vector + k] * column[LANES * vector + k];
            }
        }
    }
    lanes.map(|[a, b, c, d]| (a + b) + (c + d))
}
