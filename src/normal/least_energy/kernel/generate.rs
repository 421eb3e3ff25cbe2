//! The exact potential of two strips, and the table made of it.
//!
//! A unit load spread as a semi-ellipse of half length a is a uniform disc of radius a seen along
//! its plane. The distance x - x' of two points of two strips is then that of two points of two
//! discs, projected, and their distance in the plane has the density of the area that two circles
//! share over the product of their areas. Written as a stack of uniform discs, which are
//! semi-ellipses again, this is
//!
//! ```text
//! E(d, a_i, a_j) = 2/π ∫ sin²θ g(s, d) dθ from 0 to π      s = (p + q) (1 - sqrt(1 - t²) cos θ)
//! g(s, d) = 4/π sqrt(s + d²) (K(m) - E(m)) / s             m = s / (s + d²)
//! ```
//!
//! with p, q and t as in the kernel, and g the potential of a unit semi-ellipse of half length √s
//! at a point abreast of its middle. The mean over two equal hats is one over distances that a
//! cubic B-spline weighs. It is taken of g, once for all pairs.

use std::f64::consts::{FRAC_2_PI, PI};

use super::{FUNCTIONS, GREATEST_W, PIECES, ROWS, SOFTEST, SOFTNESS, knot};
use crate::math::elliptic;
use crate::math::quadrature::GaussLegendre;
use crate::math::spline::{SplineEnd, interpolating_slopes};

/// Points of a panel of quadrature.
const POINTS: usize = 10;

/// Halvings of the panels of distances, from h towards 0: far below the lengths √s, as their
/// potential is logarithmic at no distance.
const DISTANCE_HALVINGS: i32 = 40;

/// Halvings of the panels of angles: to where sin²θ leaves nothing of a logarithm.
const ANGLE_HALVINGS: i32 = 12;

/// Range of log2 of s/h² over which the mean of g is tabulated: from angles that do not count any
/// more for the shortest strips, to the longest pair.
const LOG_RANGE: [i32; 2] = [-52, 21];

/// Steps to each unit of that logarithm: cubic interpolation is exact to 1e-9 then.
const LOG_STEPS: usize = 32;

/// Intervals of t from 0 to 1 over which the kernel is fitted.
const FIT_STEPS: usize = 64;

/// The potential by quadrature.
pub(super) struct Potential {
    /// K h of one semi-ellipse and a point abreast of its middle over log2(s/h²): values and slopes
    /// by step.
    rows: Vec<[Vec<f64>; 2]>,
    /// 1 - cos θ, and the weight of θ in the mean.
    angles: Vec<[f64; 2]>,
    /// t, and the weight of its error.
    fit: Vec<[f64; 2]>,
}

/// Places and weights from `from` to `from + long`.
fn panel(rule: &GaussLegendre, from: f64, long: f64) -> impl Iterator<Item = [f64; 2]> {
    let (half, middle) = (0.5 * long, from + 0.5 * long);
    rule.nodes.iter().zip(&rule.weights).map(move |(x, weight)| [middle + half * x, half * weight])
}

/// Places and weights from 0 to `end` in panels that halve towards 0, where the integrand is not
/// smooth.
fn graded(rule: &GaussLegendre, end: f64, halvings: i32) -> Vec<[f64; 2]> {
    let lengths = (1..=halvings).map(|n| end * 0.5f64.powi(n));
    let mut places: Vec<_> = lengths.flat_map(|long| panel(rule, long, long)).collect();
    places.extend(panel(rule, 0.0, end * 0.5f64.powi(halvings)));
    places
}

/// Cubic B-spline of distance: the density of the distance of two points in equal hats.
fn two_hats(v: f64) -> f64 {
    match v.abs() {
        v if v < 1.0 => 2.0 / 3.0 - v * v * (1.0 - v / 2.0),
        v if v < 2.0 => (2.0 - v).powi(3) / 6.0,
        _ => 0.0,
    }
}

/// g(s, d): potential of a unit semi-ellipse of half length √s at the distance d of its middle.
fn abreast(s: f64, d: f64) -> f64 {
    let square = s + d * d;
    let complement = d * d / square;
    // (K - E)/m varies slowly: with m as rounded in both it keeps its digits where m vanishes.
    let m = 1.0 - complement;
    if m <= 0.0 {
        return 1.0 / d;
    }
    let ratio = elliptic::complete(complement).first_minus_second / m;
    2.0 * FRAC_2_PI / square.sqrt() * ratio
}

/// Places of the least squares over t, and their weights.
///
/// The errors weigh as pairs occur: neighbours in a patch are about equally long.
fn fit() -> Vec<[f64; 2]> {
    let place = |i: usize| {
        let square = (i as f64 / FIT_STEPS as f64).powi(2);
        let weight = (1.0 - square) / (square + 0.3) + 0.05;
        [square.sqrt(), weight * weight]
    };
    (0..=FIT_STEPS).map(place).collect()
}

/// r = sqrt(t² + σ) of row `row`.
fn root(row: usize, w: f64, t: f64) -> f64 {
    let [rate, base] = SOFTNESS[row];
    (t * t + SOFTEST + 1.0 / (rate * w + base)).sqrt()
}

/// w dr/dw and w² d²r/dw².
#[cfg(test)]
fn root_slopes(row: usize, w: f64, t: f64) -> [f64; 2] {
    let [rate, base] = SOFTNESS[row];
    let soft = 1.0 / (rate * w + base);
    let (step, root) = (w * rate * soft, root(row, w, t));
    [-soft * step / (2.0 * root), soft * step * step * (1.0 / root - soft / (4.0 * root.powi(3)))]
}

impl Potential {
    /// Does the quadrature over the hats.
    pub(super) fn new() -> Self {
        let rule = GaussLegendre::new(POINTS);
        // Distances over h with their weights in each row.
        let mut distances = graded(&rule, 1.0, DISTANCE_HALVINGS);
        distances.extend((1..ROWS).flat_map(|from| panel(&rule, from as f64, 1.0)));
        let distances: Vec<(f64, [f64; ROWS - 1])> = distances
            .into_iter()
            .map(|[d, weight]| {
                let parts = |row: usize| two_hats(d - row as f64) + two_hats(d + row as f64);
                (d, std::array::from_fn(|row| weight * parts(row)))
            })
            .collect();
        let count = LOG_STEPS * (LOG_RANGE[1] - LOG_RANGE[0]).unsigned_abs() as usize;
        let mut values = vec![Vec::new(); ROWS];
        for step in 0..=count {
            let s = (f64::from(LOG_RANGE[0]) + step as f64 / LOG_STEPS as f64).exp2();
            let mut sums = [0.0; ROWS];
            for (d, weights) in &distances {
                let potential = abreast(s, *d);
                for (sum, weight) in sums.iter_mut().zip(weights) {
                    *sum += weight * potential;
                }
            }
            sums[ROWS - 1] = abreast(s, 1.0);
            for (row, sum) in values.iter_mut().zip(sums) {
                row.push(sum);
            }
        }
        let steps: Vec<f64> = (0..=count).map(|step| step as f64).collect();
        let with_slopes = |values: Vec<f64>| {
            let slopes = interpolating_slopes(&steps, &values, [SplineEnd::Natural; 2]);
            [values, slopes]
        };
        let rows = values.into_iter().map(with_slopes).collect();
        let angles = graded(&rule, PI, ANGLE_HALVINGS)
            .into_iter()
            .map(|[angle, weight]| {
                let share = FRAC_2_PI * angle.sin().powi(2);
                [2.0 * (angle / 2.0).sin().powi(2), share * weight]
            })
            .collect();
        Self { rows, angles, fit: fit() }
    }

    /// K h of all rows for `w` and 0 ≤ `t` ≤ 1, without fit.
    pub(super) fn exact(&self, w: f64, t: f64) -> [f64; ROWS] {
        let most = (1.0 - t * t).sqrt();
        let least = t * t / (1.0 + most);
        let mut sums = [0.0; ROWS];
        for [one_less_cosine, weight] in &self.angles {
            let logarithm = (2.0 * w * (least + most * one_less_cosine)).log2();
            let place = (logarithm - f64::from(LOG_RANGE[0])) * LOG_STEPS as f64;
            let step = place.max(0.0) as usize;
            let x = place - step as f64;
            let y = 1.0 - x;
            let share = [y * y * (1.0 + 2.0 * x), x * x * (1.0 + 2.0 * y), x * y * y, -x * x * y];
            for (sum, [value, slope]) in sums.iter_mut().zip(&self.rows) {
                let mean = share[0] * value[step]
                    + share[1] * value[step + 1]
                    + share[2] * slope[step]
                    + share[3] * slope[step + 1];
                *sum += weight * mean;
            }
        }
        sums
    }

    /// F and G of each row at `w`: of least squares over t.
    pub(super) fn functions(&self, w: f64) -> [f64; FUNCTIONS] {
        let values: Vec<_> = self.fit.iter().map(|[t, _]| self.exact(w, *t)).collect();
        let mut functions = [0.0; FUNCTIONS];
        for (row, pair) in functions.chunks_exact_mut(2).enumerate() {
            // About the means: roots differ by little where |t| is rounded off much.
            let mean = |of: &dyn Fn(usize) -> f64| {
                let parts = self.fit.iter().enumerate().map(|(i, [_, weight])| weight * of(i));
                parts.sum::<f64>() / self.fit.iter().map(|[_, weight]| weight).sum::<f64>()
            };
            let roots: Vec<f64> = self.fit.iter().map(|[t, _]| root(row, w, *t)).collect();
            let [root, value] = [mean(&|i| roots[i]), mean(&|i| values[i][row])];
            let square = mean(&|i| (roots[i] - root).powi(2));
            pair[1] = mean(&|i| (roots[i] - root) * (values[i][row] - value)) / square;
            pair[0] = value - pair[1] * root;
        }
        functions
    }

    /// w dF/dw and w dG/dw, then w² d²F/dw² and w² d²G/dw², by differences of the fourth order.
    pub(super) fn slopes(&self, w: f64) -> [[f64; FUNCTIONS]; 2] {
        let step = 1.0 / 64.0;
        let at = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|n| self.functions(w * (1.0 + n * step)));
        let sum = |shares: [f64; 5]| {
            std::array::from_fn(|k| at.iter().zip(shares).map(|(f, share)| share * f[k]).sum())
        };
        let (a, b) = (1.0 / (12.0 * step), 1.0 / (12.0 * step * step));
        [sum([a, -8.0 * a, 0.0, 8.0 * a, -a]), sum([-b, 16.0 * b, -30.0 * b, 16.0 * b, -b])]
    }
}

/// The table as it is committed.
fn text(potential: &Potential) -> String {
    let short = |number: &f64| {
        let digits = format!("{number:.11}");
        let short = digits.trim_end_matches('0').trim_end_matches('.');
        if short == "-0" { "0".to_owned() } else { short.to_owned() }
    };
    let line = |numbers: &[f64]| numbers.iter().map(short).collect::<Vec<_>>().join(" ") + "\n";
    let version = env!("CARGO_PKG_VERSION");
    let mut text = format!(
        "# Mutual potential of two strips with semi-elliptical loads: means over hats.\n\
         # Made by: cargo test --release --lib write_the_table -- --ignored, version {version}.\n\
         # Quadrature with elliptic integrals, fit over t: generate.rs beside this file.\n\
         # All numbers are without dimension: K h = F(w) + sqrt(t^2 + s(w)) G(w), s as in mod.rs.\n\
         # A line a knot of w, from {} to {GREATEST_W} in {PIECES} pieces, equal in an octave.\n\
         # Columns: F G of 0, 1, 2, 3, 4 hats apart, F G of further ones.\n\
         # Last two lines: w dF/dw and w dG/dw at both ends.\n\
         # Licence as the crate: MIT OR Apache-2.0.\n",
        knot(0)
    );
    for number in 0..=PIECES {
        text += &line(&potential.functions(knot(number)));
    }
    for end in [0, PIECES] {
        text += &line(&potential.slopes(knot(end))[0]);
    }
    text
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::{FILE, Kernel, numbers};
    use super::*;

    /// E [1/m] by its definition: quadrature along both strips, for d not much below their lengths.
    fn by_definition(d: f64, a: [f64; 2]) -> f64 {
        let count = 300;
        let along = |a: f64| {
            let place = move |n: i32| {
                let angle = PI * f64::from(n) / f64::from(count + 1);
                [a * angle.cos(), 2.0 * angle.sin().powi(2) / f64::from(count + 1)]
            };
            (1..=count).map(place)
        };
        let inner = |x: f64| along(a[1]).map(|[y, weight]| weight / (x - y).hypot(d)).sum::<f64>();
        along(a[0]).map(|[x, weight]| weight * inner(x)).sum()
    }

    #[test]
    fn the_potential_is_that_of_its_definition() {
        let potential = Potential::new();
        for (w, t) in [(0.01, 0.5), (0.3, 0.0), (1.0, 0.7), (4.0, 1.0), (30.0, 0.2)] {
            let lengths = [1.0 + t, 1.0 - t].map(|share: f64| (w * share).sqrt());
            let exact = by_definition(1.0, lengths);
            assert_relative_eq!(potential.exact(w, t)[ROWS - 1], exact, max_relative = 1e-8);
            // Two to four hats apart nothing is singular: Gauss over each span of the spline.
            let rule = GaussLegendre::new(12);
            for row in [3, 4] {
                let spans = (-2..2).flat_map(|from| panel(&rule, f64::from(from), 1.0));
                let mean: f64 = spans
                    .map(|[v, weight]| {
                        weight * two_hats(v) * by_definition(row as f64 + v, lengths)
                    })
                    .sum();
                assert_relative_eq!(potential.exact(w, t)[row], mean, max_relative = 1e-8);
            }
        }
    }

    #[test]
    fn hats_that_touch_see_the_mean_logarithm() {
        // A long strip beside a point: E = 4/(π a) (ln(4 a/d) - 1); mean of ln d over two hats one
        // and no distance apart from their fourth differences of d⁴/24 (ln d - 25/12).
        let fourth = |x: i32| {
            let x = f64::from(x.abs());
            if x > 0.0 { x.powi(4) / 24.0 * (x.ln() - 25.0 / 12.0) } else { 0.0 }
        };
        let potential = Potential::new();
        let w = GREATEST_W / 2.0;
        let a = (2.0 * w).sqrt();
        for (row, found) in potential.exact(w, 1.0)[..ROWS - 1].iter().enumerate() {
            let shares = [1.0, -4.0, 6.0, -4.0, 1.0];
            let parts = shares.iter().zip(-2..).map(|(share, v)| share * fourth(row as i32 + v));
            let mean = (4.0 * a).ln() - 1.0 - parts.sum::<f64>();
            let exact = 4.0 / (PI * a) * mean;
            // The next term has the square of the distance over a, up to 6e-5.
            assert_relative_eq!(*found, exact, max_relative = 1e-4);
        }
    }

    #[test]
    fn the_committed_table_is_this_one() {
        let made = numbers(&text(&Potential::new())).unwrap();
        let committed = numbers(FILE).unwrap();
        assert_eq!(made.len(), committed.len());
        for (made, committed) in made.iter().zip(committed) {
            assert_relative_eq!(*made, committed, epsilon = 1e-8);
        }
    }

    #[test]
    fn the_fit_over_t_is_as_close_as_stated() {
        let (potential, kernel) = (Potential::new(), Kernel::shared());
        for w in (0..=PIECES).step_by(5).map(knot) {
            for (t, bound) in [(0.0, 1e-3), (0.1, 1e-3), (0.3, 1e-3), (0.6, 1e-3), (1.0, 1e-2)] {
                for (row, exact) in potential.exact(w, t).into_iter().enumerate() {
                    let [value, _, _] = kernel.value(row, [w * (1.0 + t), w * (1.0 - t)], 0.5, 1.0);
                    assert_relative_eq!(value, exact, max_relative = bound);
                }
            }
        }
    }

    #[test]
    fn splines_follow_the_functions() {
        let (potential, kernel) = (Potential::new(), Kernel::shared());
        // Far below the error of the fit over t, 1e-3; that of the second derivative moves only the
        // steps on the way to a solution.
        let bounds = [1e-5, 2e-4, 5e-3];
        let mut worst = [0.0_f64; 3];
        for number in 0..8 * PIECES {
            // Places in the first, a middle and the last piece of each octave.
            if ![0, 1, 3, 5, 7, 30, 33, 63].contains(&(number % 64)) {
                continue;
            }
            let part = (number % 8) as f64 / 8.0;
            let w = knot(number / 8) * (1.0 - part) + knot(number / 8 + 1) * part;
            let [first, second] = potential.slopes(w);
            let exact = [potential.functions(w), first, second];
            for (row, t) in (0..ROWS).flat_map(|row| [0.0_f64, 0.3, 1.0].map(|t| (row, t))) {
                let (root, [rise, bend]) = (root(row, w, t), root_slopes(row, w, t));
                let [value, first, second] = exact.map(|f| [f[2 * row], f[2 * row + 1]]);
                let exact = [
                    value[0] + root * value[1],
                    first[0] + root * first[1] + rise * value[1],
                    second[0] + root * second[1] + 2.0 * rise * first[1] + bend * value[1],
                ];
                // At constant t the kernel varies with w alone.
                let [p, q] = [w * (1.0 + t), w * (1.0 - t)];
                let [k, kp, kq, kpp, kpq, kqq] = kernel.second(row, p, q, 1.0);
                let found = [k, p * kp + q * kq, p * p * kpp + 2.0 * p * q * kpq + q * q * kqq];
                for i in 0..3 {
                    worst[i] = worst[i].max((found[i] - exact[i]).abs() / exact[0]);
                }
            }
        }
        println!("errors over K h of value, first and second derivative: {worst:.8?}");
        assert!(worst.iter().zip(bounds).all(|(error, bound)| *error < bound), "{worst:?}");
    }

    /// Writes the table anew.
    #[test]
    #[ignore = "writes into the source tree"]
    fn write_the_table() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        let file = folder.join("src/normal/least_energy/kernel/strips.kernel");
        std::fs::write(file, text(&Potential::new())).unwrap();
    }
}
