//! How the wear of a patch is spread across it: in proportion to the interpenetration function,
//! less what is already worn.
//!
//! Source: Piotrowski and Kik 2008, section 6. With g(y) the interpenetration function of the
//! profiles as they were last updated and w(y) the depth that both bodies have lost since then, the
//! wear of a step goes where
//!
//! ```text
//! g'(y) = max(0, g(y) - w(y) + c),   ∫ g' dy = ∫ max(0, g) dy
//! ```
//!
//! Outside the patch g is negative, minus the separation there, so that the region widens as it
//! wears. The constant area, and with it the load that the same penetration carries, fixes c.

/// Fills `shares`, one for each cell between two neighbouring nodes, with the part of a patch's
/// wear that falls into it; the parts sum to one. False, with nothing to be used in `shares`, where
/// the interpenetration has no area.
///
/// `interpenetration` g [m] and `worn` w ≥ 0 [m] at the nodes, which are equally spaced and at
/// least two.
pub fn spread(interpenetration: &[f64], worn: &[f64], shares: &mut Vec<f64>) -> bool {
    debug_assert!(interpenetration.len() == worn.len() && worn.len() >= 2);
    let area = |shift: f64, is_worn: bool| {
        let at = |i: usize| interpenetration[i] + shift - if is_worn { worn[i] } else { 0.0 };
        (1..worn.len())
            .map(|i| positive_part(at(i - 1), at(i)))
            .fold([0.0; 2], |sum, [area, length]| [sum[0] + area, sum[1] + length])
    };
    let [wanted, _] = area(0.0, false);
    if wanted <= 0.0 {
        return false;
    }
    // The area is convex in c and no smaller than wanted where c makes up for all wear: Newton
    // comes down from there.
    let mut shift = worn.iter().copied().fold(0.0, f64::max);
    for _ in 0..MAX_STEPS {
        let [found, length] = area(shift, true);
        if found - wanted <= ACCURACY * wanted || length <= 0.0 {
            break;
        }
        shift = (shift - (found - wanted) / length).max(0.0);
    }
    shares.clear();
    let level = |i: usize| interpenetration[i] - worn[i] + shift;
    shares.extend((1..worn.len()).map(|i| positive_part(level(i - 1), level(i))[0]));
    let sum: f64 = shares.iter().sum();
    if sum <= 0.0 {
        return false;
    }
    for share in shares.iter_mut() {
        *share /= sum;
    }
    true
}

/// Most Newton steps; five are the rule.
const MAX_STEPS: usize = 40;
/// Excess of the area that ends them, as a share.
const ACCURACY: f64 = 1e-12;

/// Area of the positive part of a straight line from `a` to `b` over a length of one, and the
/// length where it is positive.
fn positive_part(a: f64, b: f64) -> [f64; 2] {
    match (a > 0.0, b > 0.0) {
        (true, true) => [0.5 * (a + b), 1.0],
        (true, false) => [0.5 * a * (a / (a - b)), a / (a - b)],
        (false, true) => [0.5 * b * (b / (b - a)), b / (b - a)],
        (false, false) => [0.0, 0.0],
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn parabola(nodes: usize) -> Vec<f64> {
        (0..nodes)
            .map(|i| -2.0 + 4.0 * i as f64 / (nodes - 1) as f64)
            .map(|y| 1.0 - y * y)
            .collect()
    }

    #[test]
    fn without_wear_the_shares_are_those_of_the_interpenetration() {
        let g = parabola(401);
        let mut shares = Vec::new();
        assert!(spread(&g, &vec![0.0; 401], &mut shares));
        assert_relative_eq!(shares.iter().sum::<f64>(), 1.0, epsilon = 1e-14);
        // Area of the parabola 4/3; that of a cell of 0.01 at its top.
        assert_relative_eq!(shares[200], 0.01 / (4.0 / 3.0), max_relative = 1e-4);
        assert!(shares[99] == 0.0 && shares[100] > 0.0);
    }

    #[test]
    fn worn_material_moves_wear_outwards_at_constant_area() {
        let g = parabola(401);
        // Worn flat over the middle by half the depth.
        let worn: Vec<f64> = g.iter().map(|g| (g - 0.5).max(0.0)).collect();
        let mut shares = Vec::new();
        assert!(spread(&g, &worn, &mut shares));
        assert!(shares[90] > 0.0, "the region has widened");
        // Flat in the middle: equal shares.
        assert_relative_eq!(shares[200], shares[220], max_relative = 1e-12);
        assert_relative_eq!(shares.iter().sum::<f64>(), 1.0, epsilon = 1e-14);
    }

    #[test]
    fn wear_in_a_hole_stops_until_its_surroundings_are_as_deep() {
        let g = parabola(401);
        let mut worn = vec![0.0; 401];
        worn[195..=205].fill(1.5);
        let mut shares = Vec::new();
        assert!(spread(&g, &worn, &mut shares));
        assert!(shares[196..204].iter().all(|&s| s == 0.0));
        assert!(!spread(&[-1.0, -2.0], &[0.0, 0.0], &mut shares));
    }
}
