//! Points at which stresses are asked for.

/// `count` numbers from `from` to `to`, both of them among these; `from` alone for one.
pub fn evenly(from: f64, to: f64, count: usize) -> Vec<f64> {
    let step = (to - from) / count.saturating_sub(1).max(1) as f64;
    (0..count).map(|k| from + k as f64 * step).collect()
}

/// All points (x, y, depth) of a lattice, x the outermost and the depth the innermost: a plane for
/// one x or one y, a vertical line for one of both [m].
pub fn lattice(x: &[f64], y: &[f64], depth: &[f64]) -> Vec<[f64; 3]> {
    let mut points = Vec::with_capacity(x.len() * y.len() * depth.len());
    for &x in x {
        for &y in y {
            points.extend(depth.iter().map(|&z| [x, y, z]));
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depth_is_the_innermost() {
        let found = lattice(&[1.0, 2.0], &[5.0, 6.0], &evenly(0.0, 3.0, 2));
        let expected = [
            [1.0, 5.0, 0.0],
            [1.0, 5.0, 3.0],
            [1.0, 6.0, 0.0],
            [1.0, 6.0, 3.0],
            [2.0, 5.0, 0.0],
            [2.0, 5.0, 3.0],
            [2.0, 6.0, 0.0],
            [2.0, 6.0, 3.0],
        ];
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
            approx::assert_relative_eq!(found, expected);
        }
        assert_eq!(evenly(4.0, 9.0, 1).len(), 1);
        approx::assert_relative_eq!(evenly(4.0, 9.0, 1)[0], 4.0);
        assert!(evenly(4.0, 9.0, 0).is_empty());
    }
}
