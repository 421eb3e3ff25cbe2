//! Places of the line from which the nearest point of the rail is hard to find.

use super::ContactSearch;
use crate::geometry::curves::curve::{Curve, Knot};
use crate::geometry::curves::nearest_point::nearest;
use crate::geometry::profiles::profile::ProfileKind;
use crate::geometry::profiles::standard_profiles::built_in;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::varying_rail::WheelAbove;
use crate::geometry::sections::slices::{Slice, Slices};
use crate::geometry::uneven::waviness::Waviness;
use crate::geometry::wheel::contact_line::{ContactLine, WheelPose};

#[test]
fn the_rim_of_a_flange_far_above_the_side_of_a_rail_does_not_touch_it() {
    let wheel = built_in("S1002", ProfileKind::Wheel).unwrap().unwrap();
    let profile = built_in("60E1", ProfileKind::Rail).unwrap().unwrap();
    let slice = |place: f64| Slice { place, profile: profile.clone(), features: vec![] };
    let slices = [-1.0, -0.5, 0.0, 0.5, 1.0].map(slice).to_vec();
    let slices = Slices::new("equal", slices, false).unwrap();
    let above = WheelAbove {
        profile: &wheel.curve,
        nominal_radius: 0.46,
        waves: Waviness::new(None),
        around: None,
    };
    let rail = PlacedRail::by_gauge(&profile.curve, 0.025, 1.435, 0.014, false).unwrap();
    let [y, z] = rail.marker;
    let mut rail = rail.varying(&slices, Waviness::new(None), &above);
    let mut search = ContactSearch::new(&wheel.curve);
    // Lateral place, height, roll, yaw; first touch is 20 to 27 mm below. The line runs from the
    // back of the flange to its rim within a step, over a hand's breadth.
    for [across, down, roll, yaw] in [
        [0.745_505_0, -0.486_815, -8.356_199e-3, -0.046_372_131],
        [0.748_725_18, -0.482_795_8, 1.396_697e-3, -0.047_381_231],
        [0.750_097_82, -0.480_849_8, 7.938_803e-3, 0.046_661_815],
        [0.748_284_78, -0.478_850_4, -4.070_715e-3, -0.046_377_202],
        [0.746_922_73, -0.491_749_5, -0.019_846_78, -0.057_595_426],
    ] {
        let pose = WheelPose { marker: [0.0, across - y, down - z], roll, yaw };
        let line = ContactLine::new(&wheel.curve, 0.46, &pose);
        rail.approach(&pose, [0.0; 2]);
        assert!(rail.pass(&line, &pose, [0.0; 2], 0.0));
        search.search(&line, &rail, &[line.range()]);
        assert!(search.contacts.is_empty(), "{:?}", search.contacts[0]);
    }
}

/// The curve through points of `curve` a millimetre apart, moved as `moved` says.
fn worn(curve: &Curve, moved: impl Fn([f64; 2]) -> [f64; 2]) -> Curve {
    let (start, end) = (curve.start(), curve.end());
    let count = ((end - start) / 1e-3).ceil() as usize;
    let at = |s: f64| moved(curve.at(s.clamp(start, end)).point);
    let knots: Vec<Knot> = (0..=count)
        .map(|i| {
            let (s, h) = (start + (end - start) * i as f64 / count as f64, 1e-5);
            let [a, b] = [(s - h).max(start), (s + h).min(end)];
            let [from, to] = [a, b].map(at);
            let tangent = [0, 1].map(|c| (to[c] - from[c]) / (b - a));
            Knot { s, point: at(s), tangent }
        })
        .collect();
    Curve::through(&knots)
}

/// Distance of a `point` from `curve`, negative inside, by all `points` of that: parameter, y and z.
fn distance(curve: &Curve, points: &[[f64; 3]], point: [f64; 2]) -> f64 {
    let away = |p: &[f64; 3]| (p[1] - point[0]).hypot(p[2] - point[1]);
    let closest = points.iter().min_by(|a, b| away(a).total_cmp(&away(b))).unwrap();
    let found = nearest(curve, point, closest[0], 1e-9);
    // Far before a corner there is no point to go to.
    if (found.s - closest[0]).abs() < 1e-3 { found.distance } else { away(closest) }
}

#[test]
fn worn_wheels_touch_rails_with_walls_where_all_points_say() {
    let wheel = built_in("S1002", ProfileKind::Wheel).unwrap().unwrap();
    let profile = built_in("60E1", ProfileKind::Rail).unwrap().unwrap();
    let rail = PlacedRail::by_gauge(&profile.curve, 0.025, 1.435, 0.014, false).unwrap();
    // A hollow tread and a hollow before the flange.
    let hollow = |[y, z]: [f64; 2]| {
        let dent = |at: f64, wide: f64| (-((y - at) / wide).powi(2)).exp();
        [y, z - 2e-3 * dent(0.0, 0.02) - 3e-3 * dent(-0.038, 0.006)]
    };
    let wheels = [wheel.curve.clone(), worn(&wheel.curve, hollow)];
    // Gauge faces cut off to walls.
    let wall = |at: f64| move |[y, z]: [f64; 2]| [if y < at { at + 0.02 * (y - at) } else { y }, z];
    let head = rail.curve();
    let rails = [head.clone(), worn(head, wall(-0.034)), worn(head, wall(-0.030))];
    let mut random = Random(1);
    let mut touching = 0;
    for (wheel, curve) in wheels.iter().flat_map(|wheel| rails.iter().map(move |r| (wheel, r))) {
        let mut search = ContactSearch::new(wheel);
        let mut rail = rail.clone();
        rail.put_curve(|own| *own = curve.clone());
        let points: Vec<[f64; 3]> = (0..600)
            .map(|i| {
                let s = curve.start() + (curve.end() - curve.start()) * f64::from(i) / 599.0;
                let [y, z] = curve.at(s).point;
                [s, y, z]
            })
            .collect();
        for _ in 0..20 {
            let [roll, yaw] = [0.02, 0.08].map(|most| random.within(-most, most));
            let mut pose =
                WheelPose { marker: [0.0, random.within(-0.02, 0.02), -0.49], roll, yaw };
            let deepest = |pose: &WheelPose| {
                let line = ContactLine::new(wheel, 0.46, pose);
                let [from, to] = line.range();
                let at = |i: i32| line.at(from + (to - from) * f64::from(i) / 499.0).point;
                let all = (0..500).map(|i| distance(curve, &points, at(i)));
                all.fold(f64::INFINITY, f64::min)
            };
            // Down to first touch, as far as points tell, and on, or up.
            for _ in 0..30 {
                pose.marker[2] += deepest(&pose).max(0.0);
            }
            let is_pressed = random.within(0.0, 1.0) < 0.5;
            pose.marker[2] += random.within(0.0, if is_pressed { 3e-4 } else { -0.03 });
            let line = ContactLine::new(wheel, 0.46, &pose);
            search.search(&line, &rail, &[line.range()]);
            let found = search.contacts.iter();
            let most = found.map(|contact| contact.penetration).fold(0.0, f64::max);
            assert!(deepest(&pose) >= -most - WAVY, "{most}: {pose:?}");
            for contact in search.contacts.iter() {
                let own = distance(curve, &points, line.at(contact.u).point);
                assert!((own + contact.penetration).abs() <= WAVY, "{own} {contact:?}: {pose:?}");
                touching += 1;
            }
        }
    }
    assert!(touching > 40, "{touching}");
}

#[test]
fn a_wheel_on_the_end_of_a_rail_goes_down_without_jumps() {
    let wheel = built_in("S1002", ProfileKind::Wheel).unwrap().unwrap();
    let profile = built_in("60E1", ProfileKind::Rail).unwrap().unwrap();
    let mut rail = PlacedRail::by_gauge(&profile.curve, 0.025, 1.435, 0.014, false).unwrap();
    // A crown that ends where the root of a flange meets it.
    let knots: Vec<Knot> = (-120..=120)
        .map(|i| {
            let (sine, cosine) = (f64::from(i) / 600.0).sin_cos();
            let (s, point) = (f64::from(i) * 5e-4, [0.3 * sine, 0.3 * (1.0 - cosine)]);
            Knot { s, point, tangent: [cosine, sine] }
        })
        .collect();
    rail.put_curve(|own| *own = Curve::through(&knots));
    let mut search = ContactSearch::new(&wheel.curve);
    for (y, yaw) in [(-0.021, 0.0), (-0.022, 0.01), (-0.024, -0.02)] {
        let mut deepest = |z: f64| {
            let pose = WheelPose { marker: [0.0, y, z], roll: -0.004, yaw };
            let line = ContactLine::new(&wheel.curve, 0.46, &pose);
            search.search(&line, &rail, &[line.range()]);
            search.contacts.iter().map(|c| [c.penetration, c.u]).next()
        };
        let touching = (0..).map(|i| -0.48 + 1e-5 * f64::from(i));
        let start = touching.clone().find(|z| deepest(*z).is_some()).unwrap() + 1e-5;
        let found: Vec<[f64; 2]> =
            (0..200).map(|i| deepest(start + 1e-6 * f64::from(i)).unwrap()).collect();
        for window in found.windows(3) {
            for (k, bend) in [2e-9, 2e-8].into_iter().enumerate() {
                let change = window[0][k] - 2.0 * window[1][k] + window[2][k];
                assert!(change.abs() < bend, "{k}: {change} at {window:?}");
            }
        }
    }
}

/// Pseudo-random numbers.
struct Random(u64);

impl Random {
    fn within(&mut self, least: f64, most: f64) -> f64 {
        let more = 1_442_695_040_888_963_407;
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(more);
        least + (most - least) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Splines through the corner of a wall are wavy: 25 µm are between places of it that are both
/// nearest. A wall that is taken for the one behind is a tenth of a metre off [m].
const WAVY: f64 = 1e-4;
