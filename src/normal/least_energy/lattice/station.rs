//! The places of an interval of overlap up to which nodes are counted.

use crate::math::real::Real;

/// A place up to which nodes are measured.
#[derive(Clone, Copy, Debug)]
pub(super) struct Station<T> {
    /// Coordinate across [m], and number of the sample before it.
    pub y: T,
    pub sample: usize,
    /// Number of the interval of overlap.
    pub interval: usize,
    /// Overlap, not below zero [m]; that over the depth of the parabola [-].
    pub overlap: T,
    pub share: T,
    /// Integrals of that, its square and its cube over the lobe [m].
    pub lobe: [T; 3],
    /// Share of the depth on which the lobe stands [-].
    pub pedestal: T,
    /// Place along the track [m].
    pub x: T,
    /// Middle of the lobe along the track [m], and how much further from it strips lie than the
    /// line of greatest overlap does, over how far that lies [-].
    pub centre: T,
    pub spread: T,
    /// Measure of the nodes up to here [-].
    pub measure: T,
}

/// Calls `each` with every two neighbouring stations of one interval.
pub(super) fn for_pairs<T: Real>(
    stations: &[Station<T>],
    mut each: impl FnMut(&Station<T>, &Station<T>),
) {
    for pair in stations.windows(2) {
        if pair[0].interval == pair[1].interval {
            each(&pair[0], &pair[1]);
        }
    }
}
