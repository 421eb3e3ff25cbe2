//! A new profile from the unworn one and the sums of what is worn off.
//!
//! The sums are smoothed once, by a positive kernel that keeps them, and always from all that was
//! ever worn off: what was smoothed is never smoothed again, so that no material wanders however
//! often a profile is updated. From the volume V' per length of arc follows the depth d of the
//! layer along the inward normal,
//!
//! ```text
//! V' = ∫_0^d B(t) (1 - κ t) dt,   B = 2π (r - t cos γ) on a wheel, the distance it stands for on a rail
//! ```
//!
//! κ the curvature of the unworn profile, positive where it bulges, and a single factor close to
//! one on all depths makes the volume between the two curves exactly that of the law. Depths run as
//! a cubic spline, so that the new curve is as smooth as the unworn one, and equal to it where
//! nothing is worn off.

use super::body::Body;
use super::scratch::Scratch;
use super::section::{Station, arc_length, hermite, moments};
use super::smoothing::smooth;
use super::worn_arc::WornArc;
use crate::geometry::curves::curve::{Curve, Knot};
use crate::math::quadrature::GaussLegendre;
use crate::math::real::Real;
use crate::math::spline::{SplineEnd, put_interpolating_slopes};

/// Greatest depth [m]; with it the share of the radius of a bulge that may go. Sums beyond are not
/// taken off.
const MAX_DEPTH: f64 = 0.01;
const MAX_SHARE_OF_RADIUS: f64 = 0.5;

/// What an update has found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct UpdateReport {
    /// Volume between the unworn and the new curve [m³].
    pub volume: f64,
    /// Whether some of the worn off material was more than can be taken off: the profile is worn
    /// through there.
    pub is_worn_through: bool,
}

impl WornArc {
    /// Adds what was worn off since the last update to the totals; the curve follows with
    /// [`worn_curve`](Self::worn_curve).
    pub fn take_pending(&mut self) {
        for (total, pending) in self.state.total.iter_mut().zip(&mut self.state.pending) {
            *total += std::mem::take(pending);
        }
        (self.state.pending_area, self.state.most_pending) = (0.0, 0.0);
    }

    /// The curve that the totals leave of the unworn one, with `smoothing` the wavelength of which
    /// half is kept [m]; from now on it is the curve in use.
    pub fn worn_curve(&mut self, smoothing: f64) -> (Curve, UpdateReport) {
        let mut curve = self.base.clone();
        let report = self.put_worn_curve(smoothing, &mut curve);
        (curve, report)
    }

    /// As [`worn_curve`](Self::worn_curve), into `curve`: allocates nothing where that has room for
    /// the knots.
    pub fn put_worn_curve(&mut self, smoothing: f64, curve: &mut Curve) -> UpdateReport {
        let wanted: f64 = self.state.total.iter().sum::<f64>() * self.cell;
        if wanted <= 0.0 {
            self.worn_knots.clone_from(&self.base_knots);
            (self.area, self.depth) = (0.0, 0.0);
            curve.copy_from(&self.base);
            return UpdateReport::default();
        }
        // Out of the arc while it is worked with.
        let mut scratch = std::mem::take(&mut self.scratch);
        let is_worn_through = self.smoothed_depths(smoothing, &mut scratch);
        self.depths_at_knots(&mut scratch);
        let Scratch { at_knots: depths, knots, .. } = &mut scratch;
        let mut factor = 1.0;
        self.offset(depths, factor, knots);
        let mut lost = self.lost(depths, knots, &self.rule);
        if !is_worn_through {
            // Volume is close to proportional to the depth: each turn leaves the square of the
            // error.
            for _ in 0..MAX_TURNS {
                if (lost[0] - wanted).abs() <= ACCURACY * wanted {
                    break;
                }
                factor *= wanted / lost[0];
                self.offset(depths, factor, knots);
                lost = self.lost(depths, knots, &self.rule);
            }
        }
        let [volume, area] = lost;
        self.area = area;
        self.depth = depths.iter().map(|[depth, _]| factor * depth).fold(0.0, f64::max);
        self.worn_knots.clear();
        self.worn_knots.extend(knots.iter().map(|k| k.s));
        curve.put_through(knots);
        self.scratch = scratch;
        UpdateReport { volume, is_worn_through }
    }

    /// Wear depth along the unworn arc as the totals give it with `smoothing` [m]: parameter of
    /// each cell's middle and depth [m].
    pub fn depth_over_arc(&self, smoothing: f64) -> Vec<[f64; 2]> {
        let mut scratch = Scratch::default();
        self.smoothed_depths(smoothing, &mut scratch);
        let middle = |i: usize| self.start + (i as f64 + 0.5) * self.cell;
        scratch.depths.iter().enumerate().map(|(i, &depth)| [middle(i), depth]).collect()
    }

    /// Fills `depths` of `scratch` with the depth in the middle of each cell for the smoothed
    /// totals [m]; whether some were too much.
    fn smoothed_depths(&self, smoothing: f64, scratch: &mut Scratch) -> bool {
        let Scratch { kernel, smoothed, depths, .. } = scratch;
        smooth(&self.state.total, self.cell, smoothing, kernel, smoothed);
        let mut is_worn_through = false;
        depths.clear();
        depths.extend(smoothed.iter().zip(&self.spread).enumerate().map(
            |(i, (volume, spread))| {
                if *volume <= 0.0 {
                    return 0.0;
                }
                let [bulge, shrinking] = self.bending[i];
                let most = MAX_DEPTH.min(MAX_SHARE_OF_RADIUS / bulge.max(1e-9));
                let layer = |d: f64| {
                    d - (shrinking + bulge) * d * d / 2.0 + shrinking * bulge * d * d * d / 3.0
                };
                let wanted = volume / spread;
                if wanted >= layer(most) {
                    is_worn_through = true;
                    return most;
                }
                // The layer grows with the depth throughout: Newton within the bracket.
                let (mut low, mut high) = (0.0, most);
                let mut depth = wanted.min(most);
                for _ in 0..MAX_STEPS {
                    let excess = layer(depth) - wanted;
                    if excess > 0.0 {
                        high = depth;
                    } else {
                        low = depth;
                    }
                    let growth = (1.0 - shrinking * depth) * (1.0 - bulge * depth);
                    let next = depth - excess / growth;
                    let next = if next > low && next < high { next } else { 0.5 * (low + high) };
                    if (next - depth).abs() <= 1e-15 * most {
                        break;
                    }
                    depth = next;
                }
                depth
            },
        ));
        is_worn_through
    }

    /// Fills `at_knots` of `scratch` with the depth at each knot of the unworn curve [m] and its
    /// derivative by the arc, by a spline through the middles of the cells.
    fn depths_at_knots(&self, scratch: &mut Scratch) {
        let Scratch { depths, middles, rows, slopes, at_knots, .. } = scratch;
        let first = self.start + 0.5 * self.cell;
        middles.clear();
        middles.extend((0..depths.len()).map(|i| first + i as f64 * self.cell));
        put_interpolating_slopes(middles, depths, [SplineEnd::Natural; 2], rows, slopes);
        let last = depths.len() - 2;
        let at = |s: &f64| {
            let place = ((s - first) / self.cell).clamp(0.0, (last + 1) as f64);
            let i = (place as usize).min(last);
            // Between cells without wear a spline only swings.
            if (i.saturating_sub(2)..=(i + 3).min(last + 1)).all(|k| depths[k] <= 0.0) {
                return [0.0; 2];
            }
            let values = [depths[i], depths[i + 1]];
            hermite(place - i as f64, self.cell, values, [slopes[i], slopes[i + 1]])
        };
        at_knots.clear();
        at_knots.extend(self.base_knots.iter().map(at));
    }

    /// Fills `knots` with those of the unworn curve moved inwards by `factor` times their depths.
    fn offset(&self, depths: &[[f64; 2]], factor: f64, knots: &mut Vec<Knot>) {
        knots.clear();
        let unworn = self.stations.iter().zip(depths).zip(&self.base_knots);
        knots.extend(unworn.map(|((station, depth), &s)| {
            let Station { point, first, inward, curvature, .. } = station;
            let [depth, slope] = depth.map(|d| factor * d);
            if depth == 0.0 && slope == 0.0 {
                return Knot { s, point: *point, tangent: *first };
            }
            let length = first[0].hypotenuse(first[1]);
            let along = 1.0 - curvature * depth;
            let turned = [0, 1].map(|i| along * first[i] / length + slope * inward[i]);
            let scale = length / turned[0].hypotenuse(turned[1]);
            Knot {
                s,
                point: [0, 1].map(|i| point[i] + depth * inward[i]),
                tangent: turned.map(|t| t * scale),
            }
        }));
        // The parameter stays as close to the arc as it was.
        let mut s = knots[0].s;
        for i in 1..knots.len() {
            let length = self.base_knots[i] - self.base_knots[i - 1];
            let stretch = if is_bare(&depths[i - 1..=i]) {
                1.0
            } else {
                let pair = [&knots[i - 1], &knots[i]];
                let after = arc_length(pair.map(|k| k.point), pair.map(|k| k.tangent));
                (after / self.stations[i].length).max(MIN_STRETCH)
            };
            s += length * stretch;
            knots[i].s = s;
        }
    }

    /// Volume and area of the section between the unworn curve and the one through `knots`
    /// [m³, m²].
    fn lost(&self, depths: &[[f64; 2]], knots: &[Knot], rule: &GaussLegendre) -> [f64; 2] {
        let radius = self.body.radius();
        let (mut squares, mut area) = (0.0, 0.0);
        for i in (1..knots.len()).filter(|&i| !is_bare(&depths[i - 1..=i])) {
            let after = moments(radius, [&knots[i - 1], &knots[i]], rule);
            squares += after[0] - self.stations[i].before[0];
            area += after[1] - self.stations[i].before[1];
        }
        // Where wear reaches an end of the profile, the step there closes the outline.
        for (i, sign) in [(0, 1.0), (knots.len() - 1, -1.0)] {
            let (from, to) = (self.stations[i].point, knots[i].point);
            let dy = sign * (to[0] - from[0]);
            let (a, b) = (radius + from[1], radius + to[1]);
            squares += dy * (a * a + a * b + b * b) / 3.0;
            area += dy * 0.5 * (from[1] + to[1]);
        }
        match self.body {
            Body::Wheel { .. } => [-std::f64::consts::PI * squares, -area],
            Body::Rail { distance } => [distance * area, area],
        }
    }
}

/// Whether nothing is worn off at any of these knots.
fn is_bare(depths: &[[f64; 2]]) -> bool {
    depths.iter().flatten().all(|d| *d == 0.0)
}

/// Most turns towards the volume, and the share that may be missing.
const MAX_TURNS: usize = 3;
const ACCURACY: f64 = 1e-9;
/// Most steps towards a depth.
const MAX_STEPS: usize = 60;
/// Least length of a worn piece over that of the unworn one: a parameter has to grow.
const MIN_STRETCH: f64 = 0.05;

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::geometry::profiles::profile::ProfileKind;
    use crate::geometry::profiles::standard_profiles::built_in;

    const WHEEL: Body = Body::Wheel { nominal_radius: 0.46 };
    const RAIL: Body = Body::Rail { distance: 1e3 };

    fn arc(name: &str, kind: ProfileKind, body: Body) -> WornArc {
        WornArc::new(&built_in(name, kind).unwrap().unwrap().curve, body)
    }

    /// Volume between two curves by their outlines in fine steps.
    fn outline_volume(before: &Curve, after: &Curve, body: Body) -> f64 {
        let integral = |curve: &Curve| -> f64 {
            let knots: Vec<f64> = curve.knots().collect();
            let rule = GaussLegendre::new(12);
            let mut sum = 0.0;
            for pair in knots.windows(2) {
                for (node, weight) in rule.nodes.iter().zip(&rule.weights) {
                    let h = pair[1] - pair[0];
                    let p = curve.at(pair[0] + 0.5 * (1.0 + node) * h);
                    let height = match body {
                        Body::Wheel { nominal_radius } => {
                            -std::f64::consts::PI * (nominal_radius + p.point[1]).powi(2)
                        }
                        Body::Rail { distance } => distance * p.point[1],
                    };
                    sum += 0.5 * h * weight * height * p.first[0];
                }
            }
            sum
        };
        integral(after) - integral(before)
    }

    #[test]
    fn the_volume_between_the_curves_is_what_was_worn_off() {
        for (name, kind, body) in
            [("S1002", ProfileKind::Wheel, WHEEL), ("60E1", ProfileKind::Rail, RAIL)]
        {
            for depth in [1e-7, 1e-5, 1e-3] {
                let mut arc = arc(name, kind, body);
                let length = arc.base.end() - arc.base.start();
                // Over flank and tread, gauge corner and head.
                for share in [0.3, 0.35, 0.45, 0.6] {
                    let s = arc.base.start() + share * length;
                    arc.deposit(s, s + 6e-3, depth * 6e-3 * arc.spread[100]);
                    arc.deposit(s + 2e-3, s + 4e-3, depth * 2e-3 * arc.spread[100]);
                }
                let wanted = arc.volume();
                arc.take_pending();
                let (curve, report) = arc.worn_curve(2e-3);
                assert!(!report.is_worn_through);
                assert_relative_eq!(report.volume, wanted, max_relative = 1e-9);
                let measured = outline_volume(&arc.base, &curve, body);
                // Outlines of 1 m³ and 130 m³ of metal are subtracted here.
                let rounding = 1e-13 * if kind == ProfileKind::Wheel { 0.03 } else { 1.0 };
                assert_relative_eq!(measured, wanted, max_relative = 1e-9, epsilon = rounding);
                assert!(arc.depth() > depth && arc.depth() < 3.0 * depth);
            }
        }
    }

    #[test]
    fn where_nothing_is_worn_off_the_curve_stays_bit_for_bit() {
        let mut arc = arc("S1002", ProfileKind::Wheel, WHEEL);
        let middle = 0.6 * arc.base.end();
        arc.deposit(middle, middle + 5e-3, 1e-6);
        arc.take_pending();
        let (curve, _) = arc.worn_curve(2e-3);
        for i in 0..100 {
            let s = arc.base.start() + 0.005 * f64::from(i) * (middle - 5e-3 - arc.base.start());
            let (a, b) = (curve.at(s).point, arc.base.at(s).point);
            assert_relative_eq!(a[0], b[0], epsilon = 1e-16);
            assert_relative_eq!(a[1], b[1], epsilon = 1e-16);
        }
        let inside = arc.to_base(middle + 2e-3);
        assert_relative_eq!(inside, middle + 2e-3, epsilon = 2e-4);
    }

    #[test]
    fn many_updates_smooth_no_more_than_one() {
        let worn = |updates: usize| {
            let mut arc = arc("60E1", ProfileKind::Rail, RAIL);
            let middle = 0.5 * (arc.base.start() + arc.base.end());
            for _ in 0..updates {
                arc.deposit(middle, middle + 3e-3, 3e-4 / updates as f64);
                arc.take_pending();
                let _ = arc.worn_curve(2e-3);
            }
            arc.worn_curve(2e-3).0
        };
        let (once, often) = (worn(1), worn(50));
        for i in 0..400 {
            let s = once.end() * (0.3 + 0.001 * f64::from(i));
            let (a, b) = (once.at(s).point, often.at(s).point);
            assert!((a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 1e-15);
        }
    }

    #[test]
    fn more_than_there_is_is_reported_and_leaves_a_finite_curve() {
        let mut arc = arc("S1002", ProfileKind::Wheel, WHEEL);
        let s = 0.4 * arc.base.end();
        arc.deposit(s, s + 2e-3, 1.0);
        arc.take_pending();
        let (curve, report) = arc.worn_curve(2e-3);
        assert!(report.is_worn_through && report.volume < 1.0);
        for i in 0..1000 {
            let p = curve.at(curve.start() + 1e-3 * f64::from(i) * (curve.end() - curve.start()));
            assert!(p.point.iter().chain(&p.first).chain(&p.second).all(|x| x.is_finite()));
        }
    }
}
