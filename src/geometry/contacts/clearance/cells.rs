//! Curves laid over cells of equal width across.

use crate::geometry::curves::curve::Curve;

/// Lateral spacing of the tables [m].
pub(super) const CELL: f64 = 5e-4;

/// Spacing of the samples of both bodies along their curves [m].
pub(super) const SAMPLE: f64 = 1e-4;

/// Points of a curve with their parameters.
pub(super) fn samples(curve: &Curve) -> impl Iterator<Item = ([f64; 2], f64)> {
    let length = curve.end() - curve.start();
    let count = (length / SAMPLE).ceil() as usize;
    (0..=count)
        .map(move |i| curve.start() + length * i as f64 / count as f64)
        .map(|s| (curve.at(s).point, s))
}

/// Least and greatest y and z of the samples.
pub(super) fn extent(curve: &Curve) -> [[f64; 2]; 2] {
    samples(curve).fold([[f64::INFINITY, f64::NEG_INFINITY]; 2], |extent, (p, _)| {
        [0, 1].map(|i| [extent[i][0].min(p[i]), extent[i][1].max(p[i])])
    })
}

/// Number of the cells from `left` to `right` [m].
pub(super) fn cell_count(left: f64, right: f64) -> usize {
    ((right - left) / CELL) as usize + 1
}

/// Fills `least` with the least of each value and its neighbours up to `reach` to either side,
/// where values within less are known already.
pub(super) fn put_least_within(values: &[f64], reach: usize, least: &mut Vec<f64>) {
    least.clear();
    least.extend((0..values.len()).map(|i| {
        let before = values[i.saturating_sub(reach)];
        let after = values[(i + reach).min(values.len() - 1)];
        values[i].min(before).min(after)
    }));
}
