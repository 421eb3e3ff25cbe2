//! Sums over pairs of nodes: what one source does to many targets at once.
//!
//! Targets lie side by side, so that sums over sources need no sum within a vector. Compiled for several instruction sets, the widest one
//! chosen at run time: each entry is computed by itself and sources are summed in order, so that all of them give the same bits.

use multiversion::multiversion;

use super::cell::TERMS;
use super::influence::{
    Fall, Influence, STATION, centred_at, fall, own_at, shifted_at, shifted_fall,
};

/// Numbers taken together: loops over whole vectors have no remainder, which would be taken one by one.
pub const LANES: usize = 4;
/// Most targets at once.
pub const MOST_TARGETS: usize = 8 * LANES;

/// A number for each target. Its length is known when the loops are compiled, so that columns side by side are known to be apart.
pub type Column = [f64; MOST_TARGETS];

/// Nodes at which sums are taken; what is behind the last one is any number.
#[derive(Clone, Debug, Default)]
pub struct Targets {
    /// Whole vectors of targets, and how many of them, from the first on, have targets at which falls are taken.
    pub vectors: usize,
    pub fall_vectors: usize,
    /// Place across and along [m], derivative of the latter by the former [-].
    pub y: Column,
    pub x: Column,
    pub x_slope: Column,
    /// Unit tangent across.
    pub tangent: [Column; 2],
    /// Pressure over π E* [-], half length [m] and one over it.
    pub pressure: Column,
    pub half_length: Column,
    pub inverse_length: Column,
    /// One, zero for the target that is the source.
    pub other: Column,
    /// Share of each target in the equations of the fall in its lobe, over that of the wheel [1/m].
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
    /// Influence of the source and its fall, and with the target's half length for its own.
    centre: Influences,
    fall: Falls,
    own: Influences,
    own_fall: Column,
    own_fall_slope: Column,
    own_log_fall: Column,
    own_log_fall_slope: Column,
    /// Derivatives of displacement and fall by the pressure of the source.
    pub by_pressure: Column,
    pub fall_by_pressure: Column,
    /// The latter, weighed.
    pub weighed: [f64; TERMS],
}

/// [`Influence`](super::influence::Influence) of a source on each target.
#[derive(Clone, Debug, Default)]
struct Influences {
    d: Column,
    slope: Column,
    log: Column,
    log_slope: Column,
}

impl Influences {
    // Inside each instruction set or not at all: a call would not be vectorised.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn set(&mut self, k: usize, influence: &Influence) {
        self.d[k] = influence.d;
        self.slope[k] = influence.slope;
        self.log[k] = influence.log;
        self.log_slope[k] = influence.log_slope;
    }
}

/// [`Fall`] of a source at each target.
#[derive(Clone, Debug, Default)]
struct Falls {
    d: Column,
    slope: Column,
    pull: Column,
    log: Column,
    log_slope: Column,
    log_pull: Column,
}

impl Falls {
    // Inside each instruction set or not at all: a call would not be vectorised.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn set(&mut self, k: usize, fall: &Fall) {
        self.d[k] = fall.d;
        self.slope[k] = fall.slope;
        self.pull[k] = fall.pull;
        self.log[k] = fall.log;
        self.log_slope[k] = fall.log_slope;
        self.log_pull[k] = fall.log_pull;
    }
}

/// What all sources of one lobe do to each target.
#[derive(Clone, Debug, Default)]
pub struct Sums {
    /// Displacement, and its fall from the centre to both stations.
    pub u: Column,
    pub fall: Column,
    /// Their derivatives by the shape of the lobe.
    pub by_shape: [Column; TERMS],
    pub fall_by_shape: [Column; TERMS],
    /// What takes the singularity out of the sums of the own lobe, for a pressure of one, and its derivatives by pressure with half length.
    pub own_u: Column,
    pub own_q: Column,
    pub own_fall: Column,
    pub own_fall_q: Column,
    /// Changes of displacement and fall with the scale of the own lobe.
    pub scaled_u: Column,
    pub scaled_fall: Column,
    /// Change of the fall by all sources with the logarithm of the half length of the target, which moves the stations.
    pub pulled: Column,
    /// Change of the displacement by other lobes where the target moves across.
    pub passed: Column,
    /// Changes of displacement and fall with the two edges of the lobe.
    pub by_edge: [Column; 2],
    pub fall_by_edge: [Column; 2],
    /// Fall beyond that of the wheel [m].
    pub excess: [Column; 1],
}

impl Sums {
    /// Sets to zero what is summed up over all lobes.
    pub fn begin(&mut self, vectors: usize) {
        clear([&mut self.u, &mut self.fall, &mut self.passed, &mut self.pulled], vectors);
    }

    /// Sets to zero what is summed up for each lobe.
    pub fn begin_lobe(&mut self, vectors: usize) {
        clear(self.by_shape.each_mut(), vectors);
        clear(self.fall_by_shape.each_mut(), vectors);
        clear(self.by_edge.each_mut(), vectors);
    }

    /// Sets to zero what is summed up for the own lobe alone.
    pub fn begin_own_lobe(&mut self, vectors: usize) {
        clear([&mut self.own_u, &mut self.own_q], vectors);
        clear([&mut self.own_fall, &mut self.own_fall_q], vectors);
        clear([&mut self.scaled_u, &mut self.scaled_fall], vectors);
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
    let falls = LANES * at.fall_vectors.min(at.vectors).min(MOST_TARGETS / LANES);
    let inverse = 1.0 / source.half_length;
    let place = |k: usize| ((source.x - at.x[k]) * inverse, (source.y - at.y[k]) * inverse);
    let station = STATION * inverse;
    if is_skewed {
        for k in 0..falls {
            let (xi, sigma) = place(k);
            let centre = shifted_at(xi, sigma);
            acting.centre.set(k, &centre);
            acting.fall.set(k, &shifted_fall(&centre, station * at.half_length[k], xi, sigma));
        }
        for k in falls..count {
            let (xi, sigma) = place(k);
            acting.centre.set(k, &shifted_at(xi, sigma));
        }
    } else {
        for k in 0..falls {
            let (_, sigma) = place(k);
            let centre = centred_at(sigma);
            acting.centre.set(k, &centre);
            acting.fall.set(k, &fall(&centre, station * at.half_length[k], sigma));
        }
        for k in falls..count {
            let (_, sigma) = place(k);
            acting.centre.set(k, &centred_at(sigma));
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
    let falls = LANES * at.fall_vectors.min(at.vectors).min(MOST_TARGETS / LANES);
    for k in 0..falls {
        let own = own_at((source.y - at.y[k]) * at.inverse_length[k]);
        acting.own.d[k] = own.d;
        acting.own.slope[k] = own.slope;
        acting.own.log[k] = own.log;
        acting.own_fall[k] = own.fall;
        acting.own_fall_slope[k] = own.fall_slope;
        acting.own_log_fall[k] = own.log_fall;
        acting.own_log_fall_slope[k] = own.log_fall_slope;
    }
    for k in falls..count {
        let own = centred_at((source.y - at.y[k]) * at.inverse_length[k]);
        acting.own.d[k] = own.d;
        acting.own.slope[k] = own.slope;
        acting.own.log[k] = own.log;
    }
    let Source { tangent, width, pressure: q, legendre, .. } = *source;
    let cosine =
        |k: usize| (at.tangent[0][k] * tangent[0] + at.tangent[1][k] * tangent[1]).max(0.0);
    for k in 0..count {
        let w = width * at.other[k];
        let turned = w * cosine(k);
        let (c, d, slope) = (logarithm[k], acting.centre.d[k], acting.centre.slope[k]);
        let (log, log_slope) = (acting.centre.log[k], acting.centre.log_slope[k]);
        let by_pressure = turned * slope + c * log_slope;
        let u = q * (turned * d + c * log);
        acting.by_pressure[k] = by_pressure;
        sums.u[k] += u;
        // By the logarithm of the half length: that by the pressure at given half length taken off that with it.
        let by_length = q * by_pressure - u;
        for (term, p) in legendre.iter().enumerate() {
            sums.by_shape[term][k] += by_length * p;
        }
        // The same with the half length of the target, which takes the singularity out.
        let (own_d, own_slope, own_log) = (acting.own.d[k], acting.own.slope[k], acting.own.log[k]);
        let own_log_slope = own_log * (3.0 - 2.0 * own_log);
        sums.own_u[k] += w * own_d + c * own_log;
        sums.own_q[k] += w * own_slope + c * own_log_slope;
        let own_pressure = at.pressure[k];
        sums.scaled_u[k] += w * (q * (2.0 * d - slope) - own_pressure * (2.0 * own_d - own_slope))
            + c * (q * (2.0 * log - log_slope) - own_pressure * (2.0 * own_log - own_log_slope));
    }
    for k in 0..falls {
        let w = width * at.other[k];
        let (turned, c) = (w * cosine(k), logarithm[k]);
        let fall = &acting.fall;
        let by_pressure = turned * fall.slope[k] + c * fall.log_slope[k];
        let fallen = q * (turned * fall.d[k] + c * fall.log[k]);
        acting.fall_by_pressure[k] = by_pressure;
        sums.fall[k] += fallen;
        sums.pulled[k] += q * (turned * fall.pull[k] + c * fall.log_pull[k]);
        let by_length = q * by_pressure - fallen;
        for (term, p) in legendre.iter().enumerate() {
            sums.fall_by_shape[term][k] += by_length * p;
        }
        let (own, own_slope) = (acting.own_fall[k], acting.own_fall_slope[k]);
        let (own_log, own_log_slope) = (acting.own_log_fall[k], acting.own_log_fall_slope[k]);
        sums.own_fall[k] += w * own + c * own_log;
        sums.own_fall_q[k] += w * own_slope + c * own_log_slope;
        // The stations stay where they are while the strips move apart.
        let apart = 2.0 * fall.d[k] - fall.slope[k] - fall.pull[k];
        let log_apart = 2.0 * fall.log[k] - fall.log_slope[k] - fall.log_pull[k];
        let own_pressure = at.pressure[k];
        sums.scaled_fall[k] += w * (q * apart - own_pressure * (2.0 * own - own_slope))
            + c * (q * log_apart - own_pressure * (2.0 * own_log - own_log_slope));
    }
    acting.weighed = weighed_column(at, &acting.fall_by_pressure);
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
    let falls = LANES * at.fall_vectors.min(at.vectors).min(MOST_TARGETS / LANES);
    let Source { y, x, x_slope, tangent, width, pressure: q, .. } = *source;
    let turned =
        |k: usize| width * (at.tangent[0][k] * tangent[0] + at.tangent[1][k] * tangent[1]).max(0.0);
    for k in 0..count {
        let (d, slope) = (acting.centre.d[k], acting.centre.slope[k]);
        let (dy, dx) = (at.y[k] - y, at.x[k] - x);
        let by_pressure = turned(k) * slope;
        let u = q * turned(k) * d;
        acting.by_pressure[k] = by_pressure;
        sums.u[k] += u;
        let by_length = q * by_pressure - u;
        for (term, p) in source.legendre.iter().enumerate() {
            sums.by_shape[term][k] += by_length * p;
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
    for k in 0..falls {
        let by_pressure = turned(k) * acting.fall.slope[k];
        let fallen = q * turned(k) * acting.fall.d[k];
        acting.fall_by_pressure[k] = by_pressure;
        sums.fall[k] += fallen;
        sums.pulled[k] += q * turned(k) * acting.fall.pull[k];
        let by_length = q * by_pressure - fallen;
        for (term, p) in source.legendre.iter().enumerate() {
            sums.fall_by_shape[term][k] += by_length * p;
        }
    }
    acting.weighed = weighed_column(at, &acting.fall_by_pressure);
}

/// Σ of columns times the weights of the equations of the fall.
#[multiversion(targets("x86_64+avx2", "aarch64+neon"))]
pub fn weighed<const N: usize>(at: &Targets, columns: &[Column; N]) -> [[f64; TERMS]; N] {
    columns.each_ref().map(|column| weighed_column(at, column))
}

/// Σ of one column times the weights.
// Inside each instruction set or not at all: a call would not be vectorised.
#[allow(clippy::inline_always)]
#[inline(always)]
fn weighed_column(at: &Targets, column: &Column) -> [f64; TERMS] {
    let vectors = at.fall_vectors.min(MOST_TARGETS / LANES);
    let column = &column.as_chunks::<LANES>().0[..vectors];
    at.weights.each_ref().map(|weights| {
        let mut lanes = [0.0; LANES];
        for (weights, values) in weights.as_chunks::<LANES>().0[..vectors].iter().zip(column) {
            for k in 0..LANES {
                lanes[k] += weights[k] * values[k];
            }
        }
        let [a, b, c, d] = lanes;
        (a + b) + (c + d)
    })
}
