//! Loaded zones: the intervals of the contact line on which the separation stays below a level.

use crate::geometry::contacts::separation::{FrameSeparation, Probe};
use crate::math::real::Real;
use crate::math::root::bracketed;

/// The two edges of a loaded zone as parameters of the contact line [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge<T = f64> {
    /// Left edge.
    pub left: T,
    /// Right edge.
    pub right: T,
}

/// Calls `found` for every interval with f < `level`, in growing u; at the ends of the probes it is
/// cut off.
///
/// A probe below the level starts or carries on a zone; the edge lies between it and its neighbour
/// above the level and is found as a root, so that it is a smooth function of the level and of the
/// geometry. Every local minimum and maximum is a probe with an exact value, so that no zone and no
/// gap is missed.
pub fn for_each_zone<T: Real, S: FrameSeparation<T>>(
    separation: &mut S,
    probes: &[Probe],
    level: T,
    mut found: impl FnMut(&mut S, Edge<T>),
) {
    let (moving_level, level) = (level, level.value());
    let mut i = 0;
    while i < probes.len() {
        let from = i;
        i += 1;
        if probes[from].f >= level {
            continue;
        }
        let left = edge(separation, probes[..=from].iter().rev(), level);
        let right = edge(separation, probes[from..].iter(), level);
        if let (Some(left), Some(right)) = (left, right)
            && right > left
        {
            // What is below the level by estimate may not be, and the other way round: the edges
            // say where a zone ends.
            i += probes[i..].partition_point(|probe| probe.u <= right);
            let [left, right] = [left, right].map(|u| separation.edge(u, moving_level));
            found(separation, Edge { left, right });
        }
    }
}

/// Walks from a probe inside a zone to the first one outside and returns the root in between; the
/// last probe where all are inside, and nothing where the first is not inside itself.
fn edge<'a, T: Real>(
    separation: &mut impl FrameSeparation<T>,
    probes: impl Iterator<Item = &'a Probe>,
    level: f64,
) -> Option<f64> {
    // The root of a separation is close to linear, as a separation is close to a parabola: a secant
    // finds it at once.
    let height = |f: f64| f.max(0.0).sqrt() - level.sqrt();
    let mut inside: Option<(f64, f64)> = None;
    for probe in probes {
        // The estimates are good to a few percent: only close to the level the separation itself
        // decides.
        let f = if (probe.f - level).abs() > ESTIMATE_MARGIN * level {
            probe.f
        } else {
            separation.value(probe.u)
        };
        if f < level {
            inside = Some((probe.u, height(f)));
            continue;
        }
        let inside = inside?;
        // f may be infinite where no normal meets both lines: a large finite value bisects just as
        // well.
        let outside = (probe.u, height(f).min(1.0));
        return Some(root(separation, inside, outside, height));
    }
    inside.map(|(u, _)| u)
}

/// The place between `inside` and `outside` at which the `height` of the separation vanishes: by
/// Newton steps where it comes with its derivative, as long as they stay between what is known,
/// else in a bracket.
fn root<T: Real>(
    separation: &mut impl FrameSeparation<T>,
    mut inside: (f64, f64),
    mut outside: (f64, f64),
    height: impl Fn(f64) -> f64,
) -> f64 {
    let mut u = (inside.0 * outside.1 - outside.0 * inside.1) / (outside.1 - inside.1);
    let mut before = 0.0;
    for _ in 0..MAX_NEWTON_STEPS {
        let Some([f, rate]) = separation.value_with_rate(u) else { break };
        let above = height(f);
        let step = -above * 2.0 * f.sqrt() / rate;
        let next = u + step;
        if above < 0.0 {
            inside = (u, above);
        } else {
            outside = (u, above.min(1.0));
        }
        let [left, right] = [inside.0.min(outside.0), inside.0.max(outside.0)];
        if !(next >= left && next <= right) {
            break;
        }
        // Each step leaves its square, by a factor that the last two steps tell.
        let left_over = step * (step / before) * (step / before);
        if step.abs() <= LAST_STEP || left_over.abs() <= EDGE_LEFT_OVER {
            return next;
        }
        (u, before) = (next, step);
    }
    bracketed(inside, outside, EDGE_BRACKET, |u| height(separation.value(u)).min(1.0))
}

/// Distance from the level, as a share of it, from which an estimated separation is on the side it
/// seems to be on.
const ESTIMATE_MARGIN: f64 = 0.3;

/// Newton steps towards an edge; two are the rule.
const MAX_NEWTON_STEPS: usize = 6;

/// Newton step that is the last one, and what may be left of an edge after longer ones [m]. Where
/// the separation has a kink, what is left is a part of the last step.
const LAST_STEP: f64 = 1e-9;
const EDGE_LEFT_OVER: f64 = 1e-15;
/// Bracket within which an edge is interpolated: what is left is its square times a curvature over
/// a slope [m].
const EDGE_BRACKET: f64 = 1e-7;
