//! What the marches lack of the force of Hertzian ellipses: a table of exact forces less theirs.
//!
//! As [`tables`](crate::tangential::tables) has it, with the limits of small and of great creepages
//! of the difference instead:
//!
//! ```text
//! Δ = (1 - s)² Δ_linear(v, t) + s² (Δ_sliding(v, t) + (1 - s) K(s, X/ρ, t))
//! ```
//!
//! Δ_linear is Kalker's linear law less that of the marches: shares of the linear coefficients, which
//! are parabolas over Poisson's ratio. Δ_sliding comes from the table alone, for the ratio 0.28. The
//! exact forces at the nodes are those of the table of creep forces, which
//! boundary elements have made; the marches there are made by
//! `cargo bench --bench creep_tables -- --marches`.

use super::ellipse::MarchedEllipse;
use crate::math::b_spline;
use crate::math::until_unload::UntilUnload;
use crate::tangential::tables::generate::{POISSON_RATIO, ScaledEllipse};
use crate::tangential::tables::interpolated::{
    Interpolated, LimitSlopes, Limits, PER_RATIO, Query, ratio_place,
};
use crate::tangential::tables::nodes::{
    AZIMUTH_CELLS, ELEVATION_CELLS, Nodes, RATIOS, RING, SATURATION_CELLS, SATURATIONS,
    SLIDING_AZIMUTH_CELLS, SLIDING_ELEVATION_CELLS, SLIDING_RING, log_ratio, ring_direction,
};
use crate::tangential::tables::scales::Scales;
use crate::tangential::tables::sliding;
use crate::tangential::tables::splines::Splines;
use crate::tangential::tables::tabulated::ForceTable;
use crate::tangential::tables::{EllipseForce, ForceSlopes};

/// The committed table.
const FILE: &[u8] = include_bytes!("differences.table");

/// Creepages so small that nothing slips, and so great that everything slides.
const SMALL: f64 = 1e-9;
const GREAT: f64 = 1e6;

/// Shares of Kalker's coefficients that marches lack: of c11, of c22, of c23 in the lateral force of
/// spin, of c23 in the moment of lateral creepage, of c33.
type Lacks = [f64; 5];

/// Poisson's ratios at which they are found.
const POISSON_RATIOS: [f64; 3] = [0.0, POISSON_RATIO, 0.5];

/// Linear force and moment of the parts `lacks` of the coefficients `kalker`.
fn linear_force(lacks: Lacks, [c11, c22, c23, c33]: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let [x, y, y_spin, m, m_spin] = lacks;
    [-x * c11 * v[0], -y * c22 * v[1] - y_spin * c23 * v[2], m * c23 * v[1] - m_spin * c33 * v[2]]
}

/// What the marches on ellipse number `i` of the table lack of the linear law for each of
/// [`POISSON_RATIOS`].
fn lacks_of(i: usize) -> [Lacks; 3] {
    let mut marched = MarchedEllipse::new(log_ratio(i), POISSON_RATIO);
    POISSON_RATIOS.map(|poisson_ratio| {
        marched.poisson_ratio = poisson_ratio;
        let scales = Scales::of(log_ratio(i), poisson_ratio);
        let [x, y, spin] = [0, 1, 2].map(|k| {
            let mut v = [0.0; 3];
            v[k] = SMALL;
            let (exact, own) = (scales.linear(v), marched.force(v));
            [0, 1, 2].map(|k| 1.0 - own[k] / exact[k])
        });
        [x[0], y[1], spin[1], y[2], spin[2]]
    })
}

/// Weights at `ratio` of the values at [`POISSON_RATIOS`], of the parabola through them, and their
/// slopes.
fn weights_at(ratio: f64) -> [[f64; 3]; 2] {
    let (mut weights, mut slopes) = ([0.0; 3], [0.0; 3]);
    for (k, own) in POISSON_RATIOS.into_iter().enumerate() {
        let [a, b] = [1, 2].map(|step| POISSON_RATIOS[(k + step) % 3]);
        let per_way = 1.0 / ((own - a) * (own - b));
        weights[k] = (ratio - a) * (ratio - b) * per_way;
        slopes[k] = (2.0 * ratio - a - b) * per_way;
    }
    [weights, slopes]
}

/// The numbers of the table, from those of the exact one.
pub fn nodes(exact: &Nodes) -> Nodes {
    let mut found = Nodes { creep: Vec::new(), error: exact.error.clone(), sliding: Vec::new() };
    for i in 0..RATIOS {
        let t = log_ratio(i);
        let mut marched = MarchedEllipse::new(t, POISSON_RATIO);
        let ellipse = ScaledEllipse::new(t, POISSON_RATIO);
        let ([_, lacks, _], scales) = (lacks_of(i), Scales::of(t, POISSON_RATIO));
        let slides = |marched: &mut MarchedEllipse, v: [f64; 3]| {
            let size = v.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
            let (exact, own) =
                (sliding::sliding_force(t, v), marched.force(v.map(|v| v / size * GREAT)));
            [0, 1, 2].map(|k| exact[k] - own[k])
        };
        for k in 0..SLIDING_RING {
            let v = ring_direction(k, SLIDING_ELEVATION_CELLS, SLIDING_AZIMUTH_CELLS);
            let [x, y, m] = slides(&mut marched, v);
            // What the symmetries say.
            let [x, y, m] = match k {
                k if k < SLIDING_AZIMUTH_CELLS => [0.0, y, m],
                k if k == SLIDING_RING - 1 => [x, 0.0, 0.0],
                _ => [x, y, m],
            };
            found.sliding.push([x, y, m]);
        }
        for j in 1..=SATURATIONS {
            for k in 0..RING {
                let direction = ring_direction(k, ELEVATION_CELLS, AZIMUTH_CELLS);
                let saturation = j as f64 / SATURATION_CELLS as f64;
                let v = ellipse.creepage(direction, saturation);
                let correction = exact.creep[(i * SATURATIONS + j - 1) * RING + k];
                let slides = slides(&mut marched, v);
                let exact = ellipse.force(v, saturation, correction);
                let own = marched.force(v);
                let linear = linear_force(lacks, scales.kalker, v);
                let (squared, left) = (saturation * saturation, 1.0 - saturation);
                let mut rest = [0, 1, 2].map(|n| {
                    let limits = left * left * linear[n] + squared * slides[n];
                    (exact[n] - own[n] - limits) / (squared * left)
                });
                if k < AZIMUTH_CELLS {
                    rest[0] = 0.0;
                }
                if k == RING - 1 {
                    (rest[1], rest[2]) = (0.0, 0.0);
                }
                found.creep.push([rest[0], rest[1], rest[2], 0.0]);
            }
        }
    }
    found
}

/// The table in memory.
#[derive(Clone, Debug)]
pub struct Differences {
    splines: Splines,
    /// Coefficients of splines over ln(a/b), for each of [`POISSON_RATIOS`].
    linear: [Vec<Lacks>; 3],
}

impl Differences {
    /// The committed table, laid out on first use in the process; takes some milliseconds then.
    ///
    /// # Panics
    /// If the file in the library has another size than the code, which a test excludes.
    pub fn shared() -> &'static Self {
        static TABLE: UntilUnload<Differences> = UntilUnload::new();
        TABLE.get_or_init(|| {
            let nodes = Nodes::from_bytes(FILE).expect("the table in the library is whole");
            Self::new(&nodes)
        })
    }

    /// The numbers of the committed table.
    pub fn committed_nodes() -> Option<Nodes> {
        Nodes::from_bytes(FILE)
    }

    /// A table of these numbers.
    pub fn new(nodes: &Nodes) -> Self {
        let found: Vec<[Lacks; 3]> = (0..RATIOS).map(lacks_of).collect();
        let linear = [0, 1, 2].map(|nu| {
            let mut coefficients = vec![[0.0; 5]; RATIOS + 2];
            for n in 0..5 {
                let column: Vec<f64> = found.iter().map(|lacks| lacks[nu][n]).collect();
                for (own, c) in coefficients.iter_mut().zip(b_spline::coefficients(&column)) {
                    own[n] = c;
                }
            }
            coefficients
        });
        Self { splines: Splines::new(nodes), linear }
    }

    /// What the linear law lacks by these weights of the coefficients from number `first` on, and of
    /// [`POISSON_RATIOS`].
    fn sum(&self, first: usize, weights: [f64; 4], by_poisson: [f64; 3]) -> Lacks {
        let mut sum = [0.0; 5];
        for (linear, own) in self.linear.iter().zip(by_poisson) {
            for (lacks, weight) in linear[first..first + 4].iter().zip(weights) {
                for (sum, lacks) in sum.iter_mut().zip(lacks) {
                    *sum += own * weight * lacks;
                }
            }
        }
        sum
    }

    /// What it lacks at ln(a/b), which is brought to rest.
    fn lacks(&self, log_ratio: f64, poisson_ratio: f64) -> Lacks {
        let (place, [weights, _]) = (ratio_place(log_ratio), weights_at(poisson_ratio));
        self.sum(place.first, place.weights, weights)
    }

    /// The same with its derivatives by ln(a/b) and by Poisson's ratio.
    fn lacks_and_slopes(&self, log_ratio: f64, poisson_ratio: f64) -> [Lacks; 3] {
        let (place, [weights, slopes]) = (ratio_place(log_ratio), weights_at(poisson_ratio));
        let by_ratio = place.slopes.map(|slope| slope * PER_RATIO);
        [
            self.sum(place.first, place.weights, weights),
            self.sum(place.first, by_ratio, weights),
            self.sum(place.first, place.weights, slopes),
        ]
    }
}

impl ForceTable for Differences {
    fn force(&self, scales: &Scales, v: [f64; 3]) -> EllipseForce {
        let Some(query) = Query::of(scales, v) else { return EllipseForce::default() };
        let lacks = self.lacks(query.log_ratio[0], scales.poisson_ratio);
        let limits =
            Limits { linear: linear_force(lacks, scales.kalker, query.v), sliding: [0.0; 3] };
        let Interpolated { found, .. } = self.splines.between(&query, &limits);
        EllipseForce { slip_share: 0.0, ..found }
    }

    fn force_and_slopes(&self, scales: &Scales, v: [f64; 3]) -> (EllipseForce, ForceSlopes) {
        let slopes_of = |[lacks, by_ratio, by_poisson]: [Lacks; 3], v, ratio_slope: f64| {
            let [x, y, y_spin, m, m_spin] = lacks;
            let [c11, c22, c23, c33] = scales.kalker;
            let moved: Lacks = std::array::from_fn(|n| {
                by_ratio[n] * ratio_slope + by_poisson[n] * scales.poisson_slope
            });
            let of_lacks = linear_force(moved, scales.kalker, v);
            let of_kalker = linear_force(lacks, scales.kalker_slopes, v);
            let by_t = [0, 1, 2].map(|k| of_lacks[k] + of_kalker[k]);
            [
                [-x * c11, 0.0, 0.0, by_t[0]],
                [0.0, -y * c22, -y_spin * c23, by_t[1]],
                [0.0, m * c23, -m_spin * c33, by_t[2]],
            ]
        };
        let Some(query) = Query::of(scales, v) else {
            let [inside, _] = Query::at_rest(scales.log_ratio);
            let lacks = self.lacks_and_slopes(inside, scales.poisson_ratio);
            let [x, y, m] = slopes_of(lacks, [0.0; 3], 0.0);
            return (EllipseForce::default(), [x, y, m, [0.0; 4]]);
        };
        let [inside, ratio_slope] = query.log_ratio;
        let lacks = self.lacks_and_slopes(inside, scales.poisson_ratio);
        let limits =
            Limits { linear: linear_force(lacks[0], scales.kalker, query.v), sliding: [0.0; 3] };
        let limit_slopes =
            LimitSlopes { linear: slopes_of(lacks, query.v, ratio_slope), sliding: [[0.0; 4]; 3] };
        let (Interpolated { found, .. }, mut slopes, _) =
            self.splines.between_with_slopes(scales, &query, &limits, &limit_slopes);
        slopes[3] = [0.0; 4];
        (EllipseForce { slip_share: 0.0, ..found }, slopes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tangential::tables::CreepForceTable;
    use approx::assert_abs_diff_eq;

    #[test]
    fn nodes_of_the_committed_table_are_what_the_marches_make() {
        let exact = CreepForceTable::committed_nodes().unwrap();
        let (made, committed) = (nodes(&exact), Differences::committed_nodes().unwrap());
        // Kept as 16-bit integers of up to four.
        for (made, committed) in made.creep.iter().zip(&committed.creep) {
            assert_abs_diff_eq!(made[..], committed[..], epsilon = 2e-4);
        }
        for (made, committed) in made.sliding.iter().zip(&committed.sliding) {
            assert_abs_diff_eq!(made[..], committed[..], epsilon = 2e-4);
        }
    }

    #[test]
    fn marches_and_differences_make_up_the_exact_force_between_the_nodes() {
        let (exact, differences) = (CreepForceTable::shared(), Differences::shared());
        let mut sum = 0.0;
        let mut count = 0.0;
        for t in [-2.1, -0.7, 0.1, 1.3, 2.3] {
            let scales = Scales::of(t, POISSON_RATIO);
            let mut marched = MarchedEllipse::new(t, POISSON_RATIO);
            for v in [[0.05, 0.02, 0.1], [0.3, -0.1, 0.2], [-0.2, 0.3, -0.4], [0.0, 0.1, 0.05]] {
                let (whole, own) = (exact.force(&scales, v).force, marched.force(v));
                let missing = differences.force(&scales, v).force;
                let [x, y] = [0, 1].map(|k| own[k] + missing[k] - whole[k]);
                sum += x.hypot(y);
                count += 1.0;
            }
        }
        // Both tables interpolate.
        assert!(sum / count < 4e-3, "{}", sum / count);
    }

    #[test]
    fn slopes_are_those_of_differences() {
        let table = Differences::shared();
        for (t, v) in [(0.4, [0.3, -0.1, 0.2]), (-1.7, [0.02, 0.3, -0.5]), (2.0, [0.0, 0.1, 0.4])] {
            let at = |n: usize, h: f64| {
                let (mut t, mut v) = (t, v);
                if n < 3 {
                    v[n] += h;
                } else {
                    t += h;
                }
                table.force_and_slopes(&Scales::of(t, POISSON_RATIO), v)
            };
            let (found, slopes) = at(0, 0.0);
            let plain = table.force(&Scales::of(t, POISSON_RATIO), v);
            assert_abs_diff_eq!(found.force[..], plain.force[..], epsilon = 1e-14);
            for n in 0..4 {
                let (plus, minus) = (at(n, 1e-6).0, at(n, -1e-6).0);
                for (k, slopes) in slopes.iter().enumerate().take(3) {
                    let slope = (plus.force[k] - minus.force[k]) / 2e-6;
                    assert_abs_diff_eq!(slopes[n], slope, epsilon = 1e-6);
                }
            }
        }
    }
}
