//! Where the gauge of a rail is measured: the face of its running head.

use crate::geometry::curves::curve::Curve;
use crate::math::root::bracketed;

/// Widest gap at the depth of the gauge that is none between a running head and a guard: a flange,
/// some 30 mm wide, does not go in [m].
const WIDEST_GAP: f64 = 0.025;

/// The gauge face and the top of the running head, where the gauge face is `depth` below the top:
/// y of its outermost point (towards negative y) and z of the top. Of a grooved rail the head is
/// the part on the field side of the groove; the guard is no gauge face.
pub(super) fn gauge_face(curve: &Curve, depth: f64) -> Option<[f64; 2]> {
    let head = heads(curve, depth, 0.0).pop()?;
    // But for rounding it is the highest point.
    if head.top < ROUNDING {
        return Some([head.face, 0.0]);
    }
    // A guard is higher than the head: the depth counts from the head.
    let head = heads(curve, depth, head.top).pop()?;
    Some([head.face, head.top])
}

/// Differences of heights that mean nothing [m].
const ROUNDING: f64 = 1e-9;

/// Height of the highest point of a piece between two knots, or of its end (z) [m].
fn highest_between(curve: &Curve, [from, to]: [f64; 2]) -> f64 {
    let slope = |s: f64| curve.at(s).first[1];
    // The piece of the left knot is meant at its right end too.
    let inner = to - 1e-9 * (to - from);
    let (a, b) = (slope(from), slope(inner));
    let end = curve.at(to).point[1];
    if a < 0.0 && b > 0.0 {
        let s = bracketed((from, a), (inner, b), 1e-16, slope);
        return end.min(curve.at(s).point[1]);
    }
    end
}

/// A part of a rail that stands higher than the depth of the gauge.
#[derive(Clone, Copy, Debug)]
struct Head {
    /// y of its gauge face [m].
    face: f64,
    /// y where it ends on the other side [m].
    end: f64,
    /// z of its highest point [m].
    top: f64,
}

/// The parts of a rail that are higher than `depth` below `top`, from the gauge to the field side,
/// each with a gauge face; those with a narrow gap between them are one.
fn heads(curve: &Curve, depth: f64, top: f64) -> Vec<Head> {
    let knots: Vec<f64> = curve.knots().collect();
    let below = |s: f64| curve.at(s).point[1] - top - depth;
    let mut heads: Vec<Head> = Vec::new();
    let mut head: Option<Head> = None;
    for pair in knots.windows(2) {
        let (a, b) = (below(pair[0]), below(pair[1]));
        if (a < 0.0) != (b < 0.0) {
            let s = bracketed((pair[0], a), (pair[1], b), 1e-15, below);
            let y = curve.at(s).point[0];
            if b < 0.0 {
                head = Some(Head { face: y, end: f64::INFINITY, top: f64::INFINITY });
            } else if let Some(done) = head.take() {
                heads.push(Head { end: y, ..done });
            }
        }
        if let Some(head) = &mut head {
            head.top = head.top.min(highest_between(curve, [pair[0], pair[1]]));
        }
    }
    heads.extend(head);
    let mut merged: Vec<Head> = Vec::new();
    for head in heads {
        match merged.last_mut() {
            Some(last) if head.face - last.end < WIDEST_GAP => {
                *last = Head {
                    face: last.face.min(head.face),
                    end: head.end,
                    top: last.top.min(head.top),
                };
            }
            _ => merged.push(head),
        }
    }
    merged
}
