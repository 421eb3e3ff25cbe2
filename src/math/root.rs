//! A root of a function of one variable inside a bracket.

/// The root of `f` between `a` and `b`, where it has values of opposite sign `fa` and `fb`.
///
/// Secant steps with the Anderson-Björck change of the retained end: about 1.7 correct digits more
/// per digit and evaluation for a smooth function, never outside the bracket, and with bisection
/// whenever five steps have not brought it to two fifths. Stops when the bracket is narrower than
/// `tolerance`, when `f` vanishes, or after `MAX_STEPS`, so that it returns a point of the bracket
/// for any function.
#[inline]
pub fn bracketed(
    (mut a, mut fa): (f64, f64),
    (mut b, mut fb): (f64, f64),
    tolerance: f64,
    mut f: impl FnMut(f64) -> f64,
) -> f64 {
    debug_assert!(fa * fb <= 0.0 || !(fa * fb).is_finite());
    let mut wide = (b - a).abs();
    // The value at `a` as the secant uses it, reduced when `a` is retained; `fa` stays the true
    // one.
    let mut reduced = fa;
    // `b` is always the latest point.
    for step in 1..=MAX_STEPS {
        if fb == 0.0 || (b - a).abs() <= 2.0 * tolerance {
            break;
        }
        let mut x = (a * fb - b * reduced) / (fb - reduced);
        if step % 5 == 0 {
            if (b - a).abs() > 0.4 * wide {
                x = 0.5 * (a + b);
            }
            wide = (b - a).abs();
        }
        let (low, high) = if a < b { (a, b) } else { (b, a) };
        if !(x > low && x < high) {
            x = 0.5 * (a + b);
            if x <= low || x >= high {
                break;
            }
        }
        // A step this short may have found the root: a look just beyond it closes the bracket.
        if (x - b).abs() < tolerance {
            x = b + tolerance.copysign(a - b);
        }
        let fx = f(x);
        if (fx > 0.0) == (fb > 0.0) {
            let factor = 1.0 - fx / fb;
            reduced *= if factor > 0.0 { factor } else { 0.5 };
        } else {
            (a, fa, reduced) = (b, fb, fb);
        }
        (b, fb) = (x, fx);
    }
    // Inside the last bracket the function is straight: one more secant step costs nothing and
    // removes the jitter of its ends.
    let x = (a * fb - b * fa) / (fb - fa);
    if (x >= a && x <= b) || (x >= b && x <= a) { x } else { b }
}

/// The root of `f` next to 0 on the side of `first`, and the value there, which is the last one
/// that was asked for; `level` is the value at 0. It is looked for in steps that grow fourfold from
/// `first` to `most`; where the sign does not change until then, the better end.
pub fn outward(
    level: f64,
    first: f64,
    most: f64,
    tolerance: f64,
    mut f: impl FnMut(f64) -> f64,
) -> (f64, f64) {
    if level == 0.0 {
        return (0.0, level);
    }
    let (mut inner, mut step) = ((0.0, level), first);
    loop {
        let outer = (step, f(step));
        if outer.1 * level <= 0.0 {
            let root = bracketed(inner, outer, tolerance, &mut f);
            return (root, f(root));
        }
        if step.abs() >= most {
            return if outer.1.abs() < level.abs() { outer } else { (0.0, f(0.0)) };
        }
        inner = outer;
        step = (4.0 * step).clamp(-most, most);
    }
}

/// Steps after which [`bracketed`] returns what it has: its bisections alone gain fifteen digits.
const MAX_STEPS: usize = 260;

/// The step from the point `last` to the root of a smooth function by inverse quadratic
/// interpolation through its values (x, f) at `last` and two points before; not finite where two
/// values are equal but not zero.
#[inline]
pub fn interpolated_step([a, b]: [(f64, f64); 2], last: (f64, f64)) -> f64 {
    if last.1 == 0.0 {
        return 0.0;
    }
    let before = (b.0 - a.0) / (b.1 - a.1);
    let now = (last.0 - b.0) / (last.1 - b.1);
    last.1 * (b.1 * (now - before) / (last.1 - a.1) - now)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solve(a: f64, b: f64, f: impl Fn(f64) -> f64) -> (f64, usize) {
        let mut count = 0;
        let root = bracketed((a, f(a)), (b, f(b)), 1e-14, |x| {
            count += 1;
            f(x)
        });
        (root, count)
    }

    #[test]
    fn a_smooth_function_takes_few_evaluations() {
        let (root, count) = solve(0.0, 2.0, |x| x * x * x - 2.0);
        approx::assert_relative_eq!(root, 2f64.cbrt(), max_relative = 1e-14);
        assert!(count <= 12, "{count} evaluations");
    }

    #[test]
    fn a_flat_and_a_discontinuous_function_end_at_the_sign_change() {
        let (root, _) = solve(-1.0, 3.0, |x| (x - 0.5).powi(9));
        approx::assert_relative_eq!(root, 0.5, max_relative = 1e-3);
        let (root, count) = solve(-1.0, 3.0, |x| if x < 0.7 { -1e-3 } else { 1e6 });
        approx::assert_relative_eq!(root, 0.7, max_relative = 1e-12);
        assert!(count <= MAX_STEPS);
    }

    #[test]
    fn on_the_way_out_the_first_root_is_met_and_without_one_the_better_end() {
        // Longer than four times the way there is to its first root.
        let wave = |x: f64| (0.5 * x).cos();
        let (root, rest) = outward(1.0, 0.1, 10.0, 1e-14, wave);
        approx::assert_relative_eq!(root, std::f64::consts::PI, max_relative = 1e-13);
        assert!(rest.abs() < 1e-13);
        let (root, _) = outward(1.0, -0.1, 10.0, 1e-14, wave);
        approx::assert_relative_eq!(root, -std::f64::consts::PI, max_relative = 1e-13);
        for (most, end, slope) in [(1.0, 1.0, -0.5), (1.0, 0.0, 0.5)] {
            let (root, rest) = outward(1.0, 0.1, most, 1e-14, |x| 1.0 + slope * x);
            assert!((root - end).abs() <= 0.0 && (rest - 1.0 - slope * end).abs() <= 0.0);
        }
    }

    #[test]
    fn an_inverse_parabola_is_met_in_one_step() {
        let point = |f: f64| (0.3 + 2.0 * f - 0.7 * f * f, f);
        let step = interpolated_step([point(-1.0), point(0.5)], point(0.2));
        approx::assert_relative_eq!(point(0.2).0 + step, 0.3, max_relative = 1e-14);
        assert!(!interpolated_step([point(-1.0), (2.0, 0.2)], point(0.2)).is_finite());
    }
}
