//! The strips that share one solution: those of a zone, or of one of its lobes.

use std::ops::Range;

use crate::math::real::Real;
use crate::normal::{Strips, Zone};
use crate::tangential::neck::{Neck, Side};

/// The strips that share one solution.
#[derive(Clone, Debug)]
pub struct Span<T = f64> {
    /// Their numbers.
    pub strips: Range<usize>,
    /// Where they end across [m].
    pub edges: [T; 2],
    /// The lobe of which they are.
    lobe: Option<(Neck<T>, Side)>,
}

impl<T: Real> Span<T> {
    /// The strips of `zone`, or of one of its lobes.
    #[must_use]
    pub fn of(zone: &Zone<T>, strips: &Strips<T>, lobe: Option<(Neck<T>, Side)>) -> Self {
        let range = zone.first..zone.first + zone.count;
        let edges = edges(zone, strips);
        let Some((neck, side)) = lobe else { return Self { strips: range, edges, lobe } };
        // As wide as its shares of the strips are.
        let shares = |side: Side| -> T {
            let once =
                range.clone().filter(|&j| j == range.start || strips.y[j] != strips.y[j - 1]);
            once.map(|j| strips.width[j] * neck.member(side, strips.y[j])).sum()
        };
        let [left, right] = [Side::Left, Side::Right].map(shares);
        let between = (edges[0] * right + edges[1] * left) / (left + right);
        let is_member = |j: &usize| neck.member(side, strips.y[*j]) > 0.0;
        let first = range.clone().find(is_member).unwrap_or(range.start);
        let count = range.clone().filter(is_member).count();
        let edges = match side {
            Side::Left => [edges[0], between],
            Side::Right => [between, edges[1]],
        };
        Self { strips: first..first + count, edges, lobe }
    }

    /// Share of a strip at `y` that is in it, 0 to 1.
    pub(super) fn share(&self, y: T) -> T {
        self.lobe.map_or(T::from(1.0), |(neck, side)| neck.member(side, y))
    }
}

/// Where `zone` ends: beyond its outer strips by as much as they are wider than half of the way to
/// their neighbours.
fn edges<T: Real>(zone: &Zone<T>, strips: &Strips<T>) -> [T; 2] {
    let ends = [zone.first, zone.first + zone.count - 1];
    let y = |j: usize| strips.y[j];
    let [first, last] = ends.map(y);
    let [before, behind] = zone.beyond;
    if before + behind > 0.0 {
        return [first - before, last + behind];
    }
    let whole = (zone.width - (last - first)).at_least(0.0);
    // Stretches of one strip count once.
    let inner = [
        (ends[0]..=ends[1]).find(|&j| y(j) != first),
        (ends[0]..=ends[1]).rev().find(|&j| y(j) != last),
    ];
    let [Some(second), Some(before)] = inner else {
        return [first - whole * 0.5, first + whole * 0.5];
    };
    let wider = |own: usize, next: usize| {
        (strips.width[own] - (y(own) - y(next)).abs() * 0.5).at_least(0.0)
    };
    let beyond = [wider(ends[0], second), wider(ends[1], before)];
    let scale = whole / (beyond[0] + beyond[1]).at_least(f64::MIN_POSITIVE);
    [first - beyond[0] * scale, last + beyond[1] * scale]
}
