//! Where the gauge of a rail is measured: the face of its running head.

use crate::geometry::curves::curve::Curve;
use crate::math::root::bracketed;

/// Widest gap at the depth of the gauge that is none between a running head and a guard: a flange,
/// some 30 mm wide, does not go in [m].
const WIDEST_GAP: f64 = 0.025;

/// Where the gauge of a rail is measured.
#[derive(Clone, Copy, Debug)]
pub(super) struct GaugeFace {
    /// y of its outermost point (towards negative y), and z of the top of the running head [m].
    pub place: [f64; 2],
    /// Parameter of that point, and of that top if it is not that of the rail [m].
    pub face: f64,
    pub top: Option<f64>,
}

/// The gauge face and the top of the running head, where the gauge face is `depth` below the top.
/// Of a grooved rail the head is the part on the field side of the groove; the guard is no gauge
/// face.
pub(super) fn gauge_face(curve: &Curve, depth: f64) -> Option<GaugeFace> {
    let head = heads(curve, depth, 0.0).pop()?;
    // But for rounding it is the highest point.
    if head.top[0] < ROUNDING {
        return Some(GaugeFace { place: [head.face[0], 0.0], face: head.face[1], top: None });
    }
    // A guard is higher than the head: the depth counts from the head.
    let head = heads(curve, depth, head.top[0]).pop()?;
    let place = [head.face[0], head.top[0]];
    Some(GaugeFace { place, face: head.face[1], top: Some(head.top[1]) })
}

/// Differences of heights that mean nothing [m].
const ROUNDING: f64 = 1e-9;

/// Height of the highest point of a piece between two knots, or of its end (z), and its parameter
/// [m].
fn highest_between(curve: &Curve, [from, to]: [f64; 2]) -> [f64; 2] {
    let slope = |s: f64| curve.at(s).first[1];
    // The piece of the left knot is meant at its right end too.
    let inner = to - 1e-9 * (to - from);
    let (a, b) = (slope(from), slope(inner));
    let end = curve.at(to).point[1];
    if a < 0.0 && b > 0.0 {
        let s = bracketed((from, a), (inner, b), 1e-16, slope);
        let inside = curve.at(s).point[1];
        if inside < end {
            return [inside, s];
        }
    }
    [end, to]
}

/// The one whose first number is the lesser one.
fn lesser(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    if b[0] < a[0] { b } else { a }
}

/// A part of a rail that stands higher than the depth of the gauge.
#[derive(Clone, Copy, Debug)]
struct Head {
    /// y of its gauge face, and its parameter [m].
    face: [f64; 2],
    /// y where it ends on the other side [m].
    end: f64,
    /// z of its highest point, and its parameter [m].
    top: [f64; 2],
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
                head = Some(Head { face: [y, s], end: f64::INFINITY, top: [f64::INFINITY, s] });
            } else if let Some(done) = head.take() {
                heads.push(Head { end: y, ..done });
            }
        }
        if let Some(head) = &mut head {
            head.top = lesser(head.top, highest_between(curve, [pair[0], pair[1]]));
        }
    }
    heads.extend(head);
    let mut merged: Vec<Head> = Vec::new();
    for head in heads {
        match merged.last_mut() {
            Some(last) if head.face[0] - last.end < WIDEST_GAP => {
                *last = Head {
                    face: lesser(last.face, head.face),
                    end: head.end,
                    top: lesser(last.top, head.top),
                };
            }
            _ => merged.push(head),
        }
    }
    merged
}
