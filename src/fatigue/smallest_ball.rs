//! The smallest ball that holds given points.

use nalgebra::{DMatrix, DVector, SVector};

/// A point of the space of deviators.
pub type Point = SVector<f64, 5>;

/// Most steps from one set of points on the ball to the next.
const MAX_STEPS: usize = 200;
/// Distance that is rounding, over the radius.
const ROUNDING: f64 = 1e-12;

/// Centre of the smallest ball that holds all `points`; the origin without points.
///
/// The centre walks from a point on towards the centre of the ball through the points that it
/// touches, until the ball touches another one; once there, the point that the centre does not need
/// is let go (Fischer, Gärtner and Kutz 2003). The radius falls all the way.
pub fn centre(points: &[Point]) -> Point {
    let Some(mut centre) = points.first().copied() else { return Point::zeros() };
    let farthest = (0..points.len())
        .max_by(|&a, &b| distance(points, a, &centre).total_cmp(&distance(points, b, &centre)));
    let mut on_ball: Vec<usize> = farthest.into_iter().collect();
    let mut left_out = Vec::new();
    for _ in 0..MAX_STEPS {
        let Some((weights, step)) = to_circumcentre(points, &on_ball, &centre) else {
            // The last point lies in the plane of the others and on their ball, to rounding.
            left_out.extend(on_ball.pop());
            continue;
        };
        let touched = points[on_ball[0]] - centre;
        let (radius, along) = (touched.norm(), step.dot(&touched));
        let mut first = (1.0, None);
        if step.norm() > ROUNDING * radius {
            let others =
                (0..points.len()).filter(|k| !on_ball.contains(k) && !left_out.contains(k));
            for k in others {
                let own = points[k] - centre;
                let nears = along - step.dot(&own);
                let share = 0.5 * (radius * radius - own.norm_squared()) / nears;
                if nears > 0.0 && share < first.0 {
                    first = (share.max(0.0), Some(k));
                }
            }
        }
        centre += first.0 * step;
        if let (_, Some(k)) = first {
            on_ball.push(k);
            continue;
        }
        let Some((least, weight)) =
            weights.iter().copied().enumerate().min_by(|a, b| a.1.total_cmp(&b.1))
        else {
            break;
        };
        if weight >= 0.0 {
            break;
        }
        on_ball.remove(least);
    }
    centre
}

fn distance(points: &[Point], k: usize, centre: &Point) -> f64 {
    (points[k] - centre).norm_squared()
}

/// The point nearest to `centre` in the plane through the points `on_ball`, which have the same
/// distance from it: its weights by these points, and the way there. None where the points do not
/// span a plane of their number.
fn to_circumcentre(
    points: &[Point],
    on_ball: &[usize],
    centre: &Point,
) -> Option<(Vec<f64>, Point)> {
    let (base, others) = on_ball.split_first()?;
    let base = points[*base];
    if others.is_empty() {
        return Some((vec![1.0], base - centre));
    }
    let spans: Vec<Point> = others.iter().map(|&k| points[k] - base).collect();
    let columns = DMatrix::from_fn(base.len(), spans.len(), |i, j| spans[j][i]);
    let factors = (spans.len() <= base.len()).then(|| columns.qr())?;
    let lengths = factors.r().diagonal().abs();
    if lengths.min() <= ROUNDING * lengths.max() {
        return None;
    }
    let along = DVector::from_fn(base.len(), |i, _| centre[i] - base[i]);
    let shares = factors.r().solve_upper_triangular(&(factors.q().transpose() * along))?;
    let foot = spans.iter().zip(shares.iter()).fold(base, |sum, (span, share)| sum + span * *share);
    let mut weights = vec![1.0 - shares.sum()];
    weights.extend(shares.iter());
    Some((weights, foot - centre))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn radius(points: &[Point], centre: &Point) -> f64 {
        points.iter().map(|point| (point - centre).norm()).fold(0.0, f64::max)
    }

    #[test]
    fn balls_of_simple_bodies_are_known() {
        assert_relative_eq!(centre(&[]), Point::zeros());
        let one = Point::new(1.0, -2.0, 3.0, 0.0, 5.0);
        assert_relative_eq!(centre(&[one]), one);
        assert_relative_eq!(centre(&[one, -one, one]), Point::zeros(), epsilon = 1e-12);
        // A regular simplex in six dimensions, seen in five: here the axes and one more point.
        let mut simplex: Vec<Point> = (0..5).map(|k| Point::ith(k, 1.0)).collect();
        simplex.push(Point::repeat((1.0 - 6f64.sqrt()) / 5.0));
        let middle = simplex.iter().sum::<Point>() / 6.0;
        assert_relative_eq!(centre(&simplex), middle, epsilon = 1e-12);
        // An obtuse triangle lies in the ball of its longest side.
        let flat = [Point::ith(0, 1.0), Point::ith(0, -1.0), Point::ith(1, 0.2)];
        assert_relative_eq!(centre(&flat), Point::zeros(), epsilon = 1e-12);
    }

    #[test]
    fn the_ball_of_a_smooth_path_is_as_small_however_the_path_is_turned() {
        for case in 0..100 {
            let turn = f64::from(case) * 0.37;
            let path = |sign: f64| -> Vec<Point> {
                let at = |k: i32| {
                    let t = -3.0 + 6.0 * f64::from(k) / 63.0;
                    let decay = 1.0 / (1.0 + t * t);
                    let (a, b) = (decay * (1.0 - turn.cos() * t), decay * decay * t);
                    Point::new(a, decay, sign * b * turn.sin(), sign * a * b, t * decay)
                };
                (0..64).map(at).chain([Point::zeros()]).collect()
            };
            let [own, other] = [1.0, -1.0].map(|sign| {
                let points = path(sign);
                radius(&points, &centre(&points))
            });
            assert_relative_eq!(own, other, max_relative = 1e-10);
        }
    }

    #[test]
    fn no_centre_beside_it_has_a_smaller_ball() {
        for case in 0..200 {
            let number = |n: usize| ((case * 131 + n) as f64 * 1.9).sin() * 7.0 % 1.0;
            let count = 2 + case % 40;
            // Every third set lies in a plane, with points that are there twice.
            let flat = if case % 3 == 0 { 0.0 } else { 1.0 };
            let points: Vec<Point> = (0..count)
                .map(|k| {
                    let n = 5 * (k % (count - 1));
                    let [c, d, e] = [2, 3, 4].map(|c| flat * number(n + c));
                    Point::new(number(n), number(n + 1), c, d, e)
                })
                .collect();
            let found = centre(&points);
            let size = radius(&points, &found);
            for axis in 0..5 {
                for step in [1e-6, -1e-6, 1e-2, -1e-2] {
                    let beside = found + Point::ith(axis, step * size);
                    assert!(radius(&points, &beside) >= size * (1.0 - 1e-12), "{case}");
                }
            }
            // The centre is a mean of the points that it touches.
            let touched = points.iter().filter(|p| (*p - found).norm() >= size * (1.0 - 1e-9));
            for other in &points {
                let away = found - other;
                let behind = touched.clone().any(|p| (p - found).dot(&away) >= -1e-9 * size * size);
                assert!(behind, "{case}");
            }
        }
    }
}
