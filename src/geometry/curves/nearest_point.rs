//! The point of a rail's curve nearest to a given one.

use crate::geometry::curves::curve::Curve;
use crate::math::real::Real;

/// Samples for the coarse search of the nearest point.
const COARSE_POINTS: usize = 32;

/// Samples to either side of one of them for the nearest point of all.
const FINE_POINTS: i32 = 32;

/// How far beyond an end of the curve the foot of the normal has to lie so that nothing is opposite
/// [m].
const BEYOND: f64 = 1e-9;

/// Newton steps for the nearest point; two or three are the rule.
const MAX_STEPS: usize = 20;

/// The point of a rail nearest to a given point, and the signed distance.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Nearest {
    /// Parameter of the rail's curve [m].
    pub s: f64,
    /// Distance, negative inside the rail; positive where the rail ends [m].
    pub distance: f64,
    /// Unit tangent (y, z) of the rail there, towards the field side.
    pub tangent: [f64; 2],
    /// The point (y, z) [m].
    pub point: [f64; 2],
    /// How far the parameter moves when the given point moves by one along the tangent: 1/(1 +
    /// curvature · distance) where the parameter is the arc [-].
    pub ratio: f64,
    /// Whether the rail's curve ends there, so that nothing lies opposite.
    pub beyond_end: bool,
}

/// Points (y, z) of a curve at equal steps of the parameter [m]: where a search without a neighbour
/// begins.
#[derive(Clone, Debug)]
pub(in crate::geometry) struct CoarsePoints(Vec<[f64; 2]>);

impl CoarsePoints {
    /// Those of `curve`.
    pub fn of(curve: &Curve) -> Self {
        Self(coarse_points(curve).collect())
    }

    /// Takes those of another curve; allocates nothing.
    pub fn take(&mut self, curve: &Curve) {
        self.0.clear();
        self.0.extend(coarse_points(curve));
    }

    /// A parameter of `curve`, which they are of, near its point nearest to `point`, for a search
    /// without a neighbour.
    pub fn nearest(&self, curve: &Curve, point: [f64; 2]) -> f64 {
        let mut best = (f64::INFINITY, 0);
        for (i, p) in self.0.iter().enumerate() {
            let (y, z) = (p[0] - point[0], p[1] - point[1]);
            let distance = y * y + z * z;
            if distance < best.0 {
                best = (distance, i);
            }
        }
        let (start, end) = (curve.start(), curve.end());
        start + (end - start) * best.1 as f64 / COARSE_POINTS as f64
    }

    /// The point of `curve`, which they are of, nearest to `point`, to within `tolerance` [m], by
    /// all points around the nearest of them: Newton steps from far off a wall may end on another
    /// side.
    #[cold]
    pub fn nearest_of_all(&self, curve: &Curve, point: [f64; 2], tolerance: f64) -> Nearest {
        let away = |s: f64| {
            let [y, z] = curve.at(s).point;
            (y - point[0]).hypotenuse(z - point[1])
        };
        let step = (curve.end() - curve.start()) / COARSE_POINTS as f64;
        let coarse = self.nearest(curve, point);
        let (mut closest, mut best) = (away(coarse), coarse);
        for i in -FINE_POINTS..=FINE_POINTS {
            let s = curve.within(coarse + step * f64::from(i) / f64::from(FINE_POINTS));
            let own = away(s);
            if own < closest {
                (closest, best) = (own, s);
            }
        }
        let found = nearest(curve, point, best, tolerance);
        // Of a corner there may be no point to go to that is nearer.
        if (found.s - best).abs() <= 2.0 * step { found } else { standing(curve, point, best) }
    }
}

/// The point of `curve` at parameter `s`, as the one nearest to `point`.
fn standing(curve: &Curve, point: [f64; 2], s: f64) -> Nearest {
    let p = curve.at(s);
    let speed = p.first[0].hypotenuse(p.first[1]);
    let tangent = p.first.map(|first| first / speed);
    let to = [point[0] - p.point[0], point[1] - p.point[1]];
    let side = (to[0] * tangent[1] - to[1] * tangent[0]).signum();
    Nearest {
        s,
        distance: side * to[0].hypotenuse(to[1]),
        tangent,
        point: p.point,
        ratio: 1.0 / speed,
        beyond_end: false,
    }
}

/// The point of the `curve` of a rail nearest to `point` [m], found from the parameter `guess` near
/// it, to within `tolerance` [m].
#[inline]
pub(in crate::geometry) fn nearest(
    curve: &Curve,
    point: [f64; 2],
    guess: f64,
    tolerance: f64,
) -> Nearest {
    let mut s = curve.within(guess);
    let mut p = curve.at(s);
    let mut beyond_end = false;
    let mut ratio = 1.0;
    for _ in 0..MAX_STEPS {
        let to = [point[0] - p.point[0], point[1] - p.point[1]];
        let along = to[0] * p.first[0] + to[1] * p.first[1];
        let speed = p.first[0] * p.first[0] + p.first[1] * p.first[1];
        let bending = to[0] * p.second[0] + to[1] * p.second[1];
        // Beyond the centre of curvature the distance has no minimum to go to: go on as on a
        // straight line.
        let slope = if speed - bending > 0.2 * speed { speed - bending } else { speed };
        let stiffness = 1.0 / slope;
        ratio = speed * stiffness;
        let free = s + along * stiffness;
        let next = curve.within(free);
        let moved = next - s;
        beyond_end = (next - free).abs() > BEYOND;
        s = next;
        if moved.abs() <= tolerance {
            // Over so short a step the curve is as good as its tangent and its curvature.
            for i in 0..2 {
                p.point[i] += moved * (p.first[i] + 0.5 * moved * p.second[i]);
                p.first[i] += moved * p.second[i];
            }
            break;
        }
        p = curve.at(s);
    }
    let to = [point[0] - p.point[0], point[1] - p.point[1]];
    let slowness = 1.0 / (p.first[0] * p.first[0] + p.first[1] * p.first[1]).sqrt();
    let tangent = [p.first[0] * slowness, p.first[1] * slowness];
    // Outward normal (t_z, -t_y): up on the top of the head.
    let distance = if beyond_end {
        (to[0] * to[0] + to[1] * to[1]).sqrt()
    } else {
        to[0] * tangent[1] - to[1] * tangent[0]
    };
    Nearest { s, distance, tangent, point: p.point, ratio: ratio * slowness, beyond_end }
}

/// Points at equal steps of the parameter.
fn coarse_points(curve: &Curve) -> impl Iterator<Item = [f64; 2]> {
    let (start, length) = (curve.start(), curve.end() - curve.start());
    (0..=COARSE_POINTS)
        .map(move |i| curve.at(start + length * i as f64 / COARSE_POINTS as f64).point)
}
