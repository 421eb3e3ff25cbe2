//! The rows that a wheel meets as one outline.

use super::along::Along;
use super::met::Met;
use super::plane::dot;
use super::surface::Surface;
use crate::geometry::curves::curve::{CurvePoint, Knot};
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;

/// Greatest difference of places along the track of two rows that are taken for a trend [m].
pub(in crate::geometry) const TREND: f64 = 5e-3;
/// Least distance of two rows on the envelope [m].
const MIN_ARC: f64 = 1e-6;

/// The outline, and where the wheel meets the rail along it.
#[derive(Clone, Debug)]
pub(in crate::geometry) struct Envelope<T = f64> {
    /// Rows of the outline, and their knots.
    kept: FixedVec<Met<T>>,
    knots: FixedVec<Knot<T>>,
}

impl<T: Real> Envelope<T> {
    /// Room for an outline of `count` rows.
    pub fn new(count: usize) -> Self {
        Self { kept: FixedVec::new(count), knots: FixedVec::new(count) }
    }

    /// The knots of the outline.
    pub fn knots(&self) -> &[Knot<T>] {
        &self.knots
    }

    /// The rows of the outline, one for each knot.
    pub fn rows(&self) -> impl Iterator<Item = usize> + '_ {
        self.kept.iter().map(|met| met.row)
    }

    /// Becomes the outline of the rows that are `met`; false where there is none.
    pub fn lay(&mut self, surface: &Surface, met: &[Met<T>]) -> bool {
        self.knots.clear();
        self.kept.clear();
        for m in met {
            self.add(surface, m);
        }
        self.knots.len() >= 2
    }

    /// Adds a row behind those that are there.
    fn add(&mut self, surface: &Surface, m: &Met<T>) {
        let Self { kept, knots, .. } = self;
        let rows = &surface.rows;
        let speed = surface.pattern_speed(m.row);
        let size = dot(m.direction, m.direction).sqrt();
        // Where the rows are met in another place they may turn back: what is covered is no part of
        // the outline.
        let mut is_covered = false;
        while let Some(b) = kept.last() {
            let to = [m.point[0] - b.point[0], m.point[1] - b.point[1]];
            if dot(to, [b.direction[0] + m.direction[0], b.direction[1] + m.direction[1]]) > 0.0 {
                break;
            }
            is_covered = to[0] * b.direction[1] - to[1] * b.direction[0] <= 0.0;
            if is_covered {
                break;
            }
            kept.pop();
            knots.pop();
        }
        if is_covered {
            return;
        }
        let parameter = match kept.last() {
            None => rows.parameter[m.row].into(),
            Some(b) => {
                let way = [m.point[0] - b.point[0], m.point[1] - b.point[1]];
                let reached = dot(way, way).sqrt();
                if reached.value().is_nan() || reached < MIN_ARC {
                    return;
                }
                // As long as the section is that of the pattern the parameter is its own.
                let grown = if rows.parts[b.row] == rows.parts[m.row] {
                    let (from, to) = (&rows.pattern[b.row], &rows.pattern[m.row]);
                    let way = [to[0] - from[0], to[1] - from[1]];
                    let own = rows.parameter[m.row] - rows.parameter[b.row];
                    if own < MIN_ARC {
                        return;
                    }
                    reached * (own / dot(way, way).sqrt())
                } else {
                    reached
                };
                knots[knots.len() - 1].s + grown
            }
        };
        kept.push(*m);
        let tangent = m.direction.map(|d| d * speed / size);
        knots.push(Knot { s: parameter, point: m.point, tangent });
    }

    /// Point and derivatives of the outline at parameter `s` [m], as of a curve through its knots.
    pub fn at(&self, s: T) -> CurvePoint<T> {
        let i = self.knots.partition_point(|k| k.s <= s).clamp(1, self.knots.len() - 1) - 1;
        let [from, to] = [&self.knots[i], &self.knots[i + 1]];
        let (h, u) = (to.s - from.s, s - from.s);
        let zero = [T::from(0.0); 2];
        let mut at = CurvePoint { point: zero, first: zero, second: zero };
        for c in 0..2 {
            let rise = (to.point[c] - from.point[c]) / h;
            let (a, b) = (from.tangent[c], to.tangent[c]);
            let c2 = (rise * 3.0 - a * 2.0 - b) / h;
            let c3 = (a + b - rise * 2.0) / (h * h);
            at.point[c] = u * (u * (u * c3 + c2) + a) + from.point[c];
            at.first[c] = u * (u * c3 * 3.0 + c2 * 2.0) + a;
            at.second[c] = u * c3 * 6.0 + c2 * 2.0;
        }
        at
    }

    /// Row parameter of the `surface` of which the outline was laid, at parameter `s` of that [m].
    pub fn row_parameter(&self, surface: &Surface, s: T) -> T {
        let i = self.knots.partition_point(|k| k.s <= s).clamp(1, self.knots.len() - 1) - 1;
        let [a, b] = [i, i + 1].map(|k| surface.rows.parameter[self.kept[k].row]);
        (s - self.knots[i].s) / (self.knots[i + 1].s - self.knots[i].s) * (b - a) + a
    }

    /// The row of the outline nearest to its parameter `s`, if there is one.
    pub fn met_near(&self, s: f64) -> Option<&Met<T>> {
        let i = self.knots.partition_point(|k| k.s <= s);
        let beside = i.saturating_sub(1)..(i + 1).min(self.knots.len());
        let away = |k: &usize| (self.knots[*k].s.value() - s).abs();
        let nearest = beside.min_by(|a, b| away(a).total_cmp(&away(b)))?;
        self.kept.get(nearest)
    }

    /// Where the wheel meets the rail at parameter `s` of the outline.
    pub fn along(&self, s: T) -> Along<T> {
        let between = self.between(s);
        between.map_or_else(Along::default, |at| Along::each(|of| self.interpolated(&at, of)))
    }

    /// How far ahead of the even contact line that is, at parameter `s` of the outline [m].
    pub fn ahead(&self, s: T) -> T {
        let between = self.between(s);
        between.map_or_else(T::default, |at| self.interpolated(&at, |along| along.ahead))
    }

    /// The knots about parameter `s`, as far as the outline goes; nothing without an outline.
    fn between(&self, s: T) -> Option<Between<T>> {
        let Self { knots, .. } = self;
        let last = knots.len().checked_sub(1).filter(|last| *last > 0)?;
        let first = knots.partition_point(|k| k.s <= s).clamp(1, last) - 1;
        let length = |k: usize| knots[k + 1].s - knots[k].s;
        let h = length(first);
        let t = ((s - knots[first].s) / h).within(0.0, 1.0);
        let rest = -t + 1.0;
        // Of the slopes at both ends, by which the cubic goes beside the straight line.
        let slopes = [t * rest * rest, -(t * t * rest)];
        let mut own = t * t * (rest * 2.0 + 1.0);
        let mut beside = |is_there: bool, k: usize, slope: T| {
            if !is_there {
                own += slope;
                return None;
            }
            let near = length(k);
            let share = slope / (h + near);
            own += share * near;
            Some(share * h * h / near)
        };
        let before = beside(first > 0, first.wrapping_sub(1), slopes[0]);
        let behind = beside(first + 1 < last, first + 1, slopes[1]);
        Some(Between { first, before, own, behind })
    }

    /// What the function `of` the places of touch is between two of them.
    fn interpolated(&self, at: &Between<T>, of: impl Fn(&Along<T>) -> T) -> T {
        let Between { first, before, own, behind } = *at;
        let value = |k: usize| of(&self.kept[k].along);
        let (a, b) = (value(first), value(first + 1));
        let mut sum = a + (b - a) * own;
        if let Some(share) = before {
            sum += (a - value(first - 1)) * share;
        }
        if let Some(share) = behind {
            sum += (value(first + 2) - b) * share;
        }
        sum
    }
}

/// The knots about a place of an outline: a cubic between two of them, with slopes by the neighbours
/// that are weighted by their distance.
struct Between<T> {
    first: usize,
    /// Shares of the change from one to the other and of those before and behind it, where there
    /// are any.
    before: Option<T>,
    own: T,
    behind: Option<T>,
}
