//! The contact search and the contact line against brute force.

mod common;
mod tolerance;

use std::path::PathBuf;

use common::random::Random;
use wheelrail::element::{Element, Input, Parameters};
use wheelrail::geometry::clearance::Clearance;
use wheelrail::geometry::contact_line::{ContactLine, WheelPose};
use wheelrail::geometry::contact_search::ContactSearch;
use wheelrail::geometry::curve::Curve;
use wheelrail::geometry::placed_rail::PlacedRail;
use wheelrail::geometry::profile::{Profile, ProfileKind};
use wheelrail::io::load_profile;

const RADIUS: f64 = 0.46;
/// Lateral position of the running circle of a centred wheel in the track [m].
const CENTRED_Y: f64 = 0.75;

/// A wheel, a rail and what tells where they touch.
struct Pair {
    name: String,
    wheel: Profile,
    rail: PlacedRail,
    element: Element,
    search: ContactSearch,
    clearance: Clearance,
    /// Stretches of the contact line that may touch.
    ranges: Vec<[f64; 2]>,
}

impl Pair {
    fn new(wheel_name: &str, rail_name: &str) -> Self {
        Self::inclined(wheel_name, rail_name, 0.025)
    }

    fn inclined(wheel_name: &str, rail_name: &str, inclination: f64) -> Self {
        let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("fmu/resources/profiles");
        let load = |name: &str, kind| {
            load_profile("profile", name, kind, 2e-3, std::slice::from_ref(&folder))
        };
        let wheel = load(wheel_name, ProfileKind::Wheel).unwrap();
        let rail = load(rail_name, ProfileKind::Rail).unwrap();
        let mut parameters = Parameters::default();
        parameters.rails[0].inclination = inclination;
        let element = Element::with_profiles(
            &parameters,
            &Input::default(),
            &wheel,
            &[Some(rail.clone()), None],
        )
        .unwrap();
        let placed = PlacedRail::by_gauge(&rail.curve, inclination, 1.435, 0.014).unwrap();
        Self {
            name: format!("{wheel_name} on {rail_name}"),
            element,
            search: ContactSearch::new(&wheel.curve),
            clearance: Clearance::new(&wheel.curve, RADIUS, placed.curve()),
            ranges: Vec::with_capacity(32),
            wheel,
            rail: placed,
        }
    }

    /// The pose of a wheel shifted by `shift` and `depth` below the height of first touch.
    fn pose(&mut self, shift: f64, depth: f64, roll: f64, yaw: f64) -> WheelPose {
        let mut input = Input::default();
        input.wheel.position[1] = CENTRED_Y + shift;
        (input.wheel.roll, input.wheel.yaw) = (roll, yaw);
        let z = self.element.touching_height(&input) + depth;
        WheelPose { marker: [0.0, CENTRED_Y + shift - self.rail.marker[0], z], roll, yaw }
    }
}

/// Searches as the element does: from the stretches that the clearance bound leaves over.
fn search(pair: &mut Pair, pose: &WheelPose) {
    let line = ContactLine::new(&pair.wheel.curve, RADIUS, pose);
    pair.clearance.ranges(pose, &mut pair.ranges);
    pair.search.search(&line, &pair.rail, &pair.ranges);
}

/// Signed distance of the line from the rail at steps of 20 µm; up to 0.4 mm where it is beyond a millimetre.
fn dense_scan(line: &ContactLine, rail: &PlacedRail) -> Vec<[f64; 2]> {
    let [mut u, end] = line.range();
    let mut scan = Vec::new();
    while u <= end {
        let point = line.at(u).point;
        let distance = rail.nearest(point, rail.coarse_nearest(point), 1e-9).distance;
        scan.push([u, distance]);
        u += (0.5 * (distance - 1e-3)).clamp(2e-5, 4e-4);
    }
    scan
}

fn deepest(scan: &[[f64; 2]]) -> f64 {
    scan.iter().map(|point| -point[1]).fold(f64::NEG_INFINITY, f64::max)
}

/// Poses over the whole range; two in three as deep as real contacts, one in three where a wheel changes from tread to flange.
fn random_pose(pair: &mut Pair, random: &mut Random, index: usize) -> WheelPose {
    let (shift, depth) = (random.about(12e-3), random.within(-1e-3, 3e-3));
    let (roll, yaw) = (random.about(0.02), random.about(0.05));
    match index % 3 {
        0 => pair.pose(shift, depth, roll, yaw),
        1 => pair.pose(shift, 0.05 * depth, roll, yaw),
        _ => pair.pose(5.2e-3 + 0.03 * shift, 0.02 * depth.abs(), 0.02 * roll, 0.02 * yaw),
    }
}

#[test]
fn the_search_finds_what_brute_force_finds() {
    let mut random = Random::new(1);
    let mut worst: f64 = 0.0;
    let (mut touching, mut several) = (0, 0);
    for (wheel, rail) in [("S1002", "60E1"), ("S1002_worn.txt", "60E1"), ("S1002", "54E1")] {
        let mut pair = Pair::new(wheel, rail);
        for index in 0..130 {
            let pose = random_pose(&mut pair, &mut random, index);
            search(&mut pair, &pose);
            let line = ContactLine::new(&pair.wheel.curve, RADIUS, &pose);
            let scan = dense_scan(&line, &pair.rail);
            let contacts = &pair.search.contacts;
            let brute = deepest(&scan);
            if brute > tolerance::MISSED_PENETRATION {
                touching += 1;
                let lifted = pair.ranges.is_empty();
                assert!(!lifted, "{}: touches by {brute}, called lifted: {pose:?}", pair.name);
                let found = contacts.iter().map(|c| c.penetration).fold(0.0, f64::max);
                worst = worst.max((found - brute).abs());
                let miss = (found - brute).abs();
                assert!(
                    miss < tolerance::DEEPEST_PENETRATION,
                    "{}: found {found}, brute force {brute}: {pose:?}",
                    pair.name
                );
            }
            several += usize::from(contacts.len() > 1);
            // Every penetrated place lies in the interval of a contact.
            for [u, distance] in scan {
                if -distance <= tolerance::MISSED_PENETRATION {
                    continue;
                }
                let covered = contacts.iter().any(|c| {
                    let probes = &pair.search.probes[c.probes[0]..c.probes[1]];
                    (probes[0].u..=probes[probes.len() - 1].u).contains(&u)
                });
                assert!(covered, "{}: missed {distance} at {u}: {pose:?}", pair.name);
            }
            // And no contact is made up.
            for contact in contacts.iter() {
                assert!(
                    contact.penetration <= brute + tolerance::DEEPEST_PENETRATION,
                    "{}: {contact:?} against {brute}: {pose:?}",
                    pair.name
                );
            }
        }
    }
    println!("{touching} touching, {several} with several contacts, worst difference {worst:e} m");
    assert!(touching > 150 && several > 20, "{touching}, {several}");
}

#[test]
fn a_wheel_is_never_called_lifted_where_it_begins_to_touch() {
    let mut random = Random::new(2);
    let mut pair = Pair::new("S1002", "60E1");
    for _ in 0..300 {
        let (shift, roll, yaw) = (random.about(12e-3), random.about(0.02), random.about(0.05));
        let pose = pair.pose(shift, 1e-9, roll, yaw);
        search(&mut pair, &pose);
        assert!(!pair.ranges.is_empty() && !pair.search.contacts.is_empty(), "{pose:?}");
        // Nor is the height of first touch below the true one.
        let mut above = pose;
        above.marker[2] -= 1e-7;
        let line = ContactLine::new(&pair.wheel.curve, RADIUS, &above);
        let touching = deepest(&dense_scan(&line, &pair.rail));
        assert!(touching < tolerance::MISSED_PENETRATION, "touches by {touching}: {pose:?}");
    }
}

#[test]
fn a_straight_wheel_well_above_the_rail_is_called_lifted() {
    let mut pair = Pair::new("S1002", "60E1");
    for shift in [-0.01, -0.004, 0.0, 0.004, 0.01] {
        let pose = pair.pose(shift, -3e-3, 0.0, 0.0);
        search(&mut pair, &pose);
        assert!(pair.ranges.is_empty());
    }
}

/// Circle of the wheel through the profile point of parameter `s`, seen along x: where it is lowest at lateral position `y`.
/// Returns (x, z).
fn lowest_on_circle(curve: &Curve, pose: &WheelPose, s: f64, y: f64) -> Option<[f64; 2]> {
    let [profile_y, profile_z] = curve.at(s).point;
    let radius = RADIUS + profile_z;
    let turn = rotation(pose);
    // A point of the circle in the wheel's axes: (r sin α, y_w, r cos α).
    let place = |k: usize, sine: f64, cosine: f64| {
        pose.marker[k]
            + turn[k][0] * radius * sine
            + turn[k][1] * profile_y
            + turn[k][2] * radius * cosine
    };
    let (a, b) = (turn[1][0] * radius, turn[1][2] * radius);
    let to = y - pose.marker[1] - turn[1][1] * profile_y;
    let size = a.hypot(b);
    if to.abs() > size {
        return None;
    }
    let (middle, half) = (a.atan2(b), (to / size).acos());
    [middle - half, middle + half]
        .map(|angle| {
            let (sine, cosine) = angle.sin_cos();
            [place(0, sine, cosine), place(2, sine, cosine)]
        })
        .into_iter()
        .max_by(|p, q| p[1].total_cmp(&q[1]))
}

/// Rows of R_x(roll) R_z(yaw).
fn rotation(pose: &WheelPose) -> [[f64; 3]; 3] {
    let (sr, cr) = pose.roll.sin_cos();
    let (sy, cy) = pose.yaw.sin_cos();
    [[cy, -sy, 0.0], [cr * sy, cr * cy, -sr], [sr * sy, sr * cy, cr]]
}

/// Lowest point (x, z) of the whole wheel at lateral position `y`, by scans of all circles ever finer about the lowest.
fn lowest_of_wheel(curve: &Curve, pose: &WheelPose, y: f64) -> [f64; 2] {
    let (mut from, mut to, mut count) = (curve.start(), curve.end(), 16_000);
    let (mut best, mut at) = ([0.0, f64::NEG_INFINITY], from);
    for _ in 0..4 {
        let step = (to - from) / f64::from(count);
        for i in 0..=count {
            let s = (from + f64::from(i) * step).clamp(curve.start(), curve.end());
            if let Some(point) = lowest_on_circle(curve, pose, s, y)
                && point[1] > best[1]
            {
                (best, at) = (point, s);
            }
        }
        (from, to, count) = (at - 2.0 * step, at + 2.0 * step, 100);
    }
    best
}

/// Lowest point (x, z) of the contact line at lateral position `y`, from its chords of 20 µm.
fn lowest_of_line(line: &ContactLine, y: f64) -> [f64; 2] {
    let [start, end] = line.range();
    let count = ((end - start) / 2e-5) as usize;
    let points = (0..=count).map(|i| line.at(start + (end - start) * i as f64 / count as f64));
    let points: Vec<_> = points.collect();
    let mut best = [0.0, f64::NEG_INFINITY];
    for pair in points.windows(2) {
        let (from, to) = (pair[0].point, pair[1].point);
        let share = (y - from[0]) / (to[0] - from[0]);
        if (0.0..=1.0).contains(&share) {
            let z = from[1] + share * (to[1] - from[1]);
            if z > best[1] {
                best = [pair[0].x + share * (pair[1].x - pair[0].x), z];
            }
        }
    }
    best
}

#[test]
fn the_contact_line_is_the_outline_of_the_wheel_seen_along_the_rail() {
    let wheel = load_profile("wheel", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap();
    let curve = &wheel.curve;
    let (mut worst_z, mut worst_x) = (0f64, 0f64);
    for (roll, yaw) in [(0.0, 0.05), (0.0, -0.02), (0.02, 0.03), (-0.02, -0.05), (0.01, 0.002)] {
        let pose = WheelPose { marker: [0.1, -0.01, -0.46], roll, yaw };
        let line = ContactLine::new(curve, RADIUS, &pose);
        for i in 0..80 {
            // From the flange top to the field side, as far as the turned wheel reaches.
            let y = pose.marker[1] - RADIUS * roll.sin() - 0.055 + 1.4e-3 * f64::from(i);
            let [x, z] = lowest_of_wheel(curve, &pose, y);
            let found = lowest_of_line(&line, y);
            let (miss_x, miss_z) = ((x - found[0]).abs(), (z - found[1]).abs());
            (worst_x, worst_z) = (worst_x.max(miss_x), worst_z.max(miss_z));
            assert!(
                miss_z < tolerance::OUTLINE_HEIGHT && miss_x < tolerance::OUTLINE_AHEAD,
                "roll {roll}, yaw {yaw}, y {y}: line {found:?}, wheel {:?}",
                [x, z]
            );
        }
    }
    println!("worst difference of height {worst_z:e} m, of place along x {worst_x:e} m");
}

#[test]
fn the_normal_of_the_wheel_on_the_contact_line_has_no_part_along_the_rail() {
    let wheel = load_profile("wheel", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap();
    let curve = &wheel.curve;
    let pose = WheelPose { marker: [0.1, -0.01, -0.46], roll: 0.015, yaw: 0.04 };
    let turn = rotation(&pose);
    let line = ContactLine::new(curve, RADIUS, &pose);
    for i in 10..60 {
        let s = curve.start() + (curve.end() - curve.start()) * f64::from(i) / 60.0;
        let p = curve.at(s);
        if p.first[0] < 0.3 {
            continue;
        }
        let at = line.at(s);
        // The point in the wheel's axes: its radial direction, and with it the normal.
        let to = [at.x, at.point[0], at.point[1]];
        let own = |k: usize| (0..3).map(|i| turn[i][k] * (to[i] - pose.marker[i])).sum::<f64>();
        let (ahead, down) = (own(0), own(2));
        let radius = ahead.hypot(down);
        assert!((radius - RADIUS - p.point[1]).abs() < tolerance::ROUNDING, "off its circle");
        let normal = [p.first[0] * ahead / radius, -p.first[1], p.first[0] * down / radius];
        let track = |i: usize| (0..3).map(|k| turn[i][k] * normal[k]).sum::<f64>();
        assert!(track(0).abs() < tolerance::ROUNDING, "s {s}: normal has {} along x", track(0));
        let along = at.tangent[0] * track(1) + at.tangent[1] * track(2);
        assert!(along.abs() < tolerance::ROUNDING, "s {s}: tangent not across the normal");
    }
}

#[test]
fn the_derivative_of_the_line_is_that_of_its_points() {
    let wheel = load_profile("wheel", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap();
    let curve = &wheel.curve;
    let pose = WheelPose { marker: [0.0, 0.0, -0.46], roll: -0.01, yaw: 0.03 };
    let line = ContactLine::new(curve, RADIUS, &pose);
    let knots: Vec<f64> = curve.knots().collect();
    let step = 1e-6;
    for pair in knots.windows(2).filter(|k| k[1] - k[0] > 4.0 * step) {
        let s = 0.5 * (pair[0] + pair[1]);
        // The rim of a steep face is followed by height.
        if curve.at(s).first[0] < 0.1 && curve.at(s).first[0] > 0.04 {
            continue;
        }
        let (_, derivative) = line.even_with_derivative(s);
        let (before, after) = (line.at(s - step).point, line.at(s + step).point);
        for k in 0..2 {
            let difference = (after[k] - before[k]) / (2.0 * step);
            let miss = (difference - derivative[k]).abs();
            assert!(miss < tolerance::DERIVATIVE, "{miss:e} at {s}");
        }
    }
}

#[test]
fn a_flange_that_runs_at_the_rail_touches_ahead_of_the_axle() {
    let mut pair = Pair::new("S1002", "60E1");
    for yaw in [-0.04, -0.01, 0.01, 0.04] {
        let pose = pair.pose(8e-3, 5e-5, 0.0, yaw);
        search(&mut pair, &pose);
        let line = ContactLine::new(&pair.wheel.curve, RADIUS, &pose);
        let flange = pair.search.contacts.iter().find(|c| c.angle().abs() > 0.6).unwrap();
        let x = line.at(flange.u).x;
        // r tan(contact angle) sin(yaw), and the lateral coordinate of the flange turned by the yaw.
        let expected =
            -line.wheel_point(flange.u).rolling_radius * flange.angle().tan() * yaw.sin()
                - line.wheel_point(flange.u).y * yaw.sin();
        assert!(x * yaw > 0.0, "yaw {yaw}: flange touches at {x}");
        assert!((x / expected - 1.0).abs() < tolerance::FLANGE_AHEAD, "{x} against {expected}");
    }
}

/// Point (x, y) of the whole wheel that lies furthest to the track centre at height `z`, on the profile from its start to `end`.
fn innermost_of_wheel(curve: &Curve, pose: &WheelPose, end: f64, z: f64) -> [f64; 2] {
    let turn = rotation(pose);
    let (mut from, mut to, mut count) = (curve.start(), end, 40_000);
    let (mut best, mut at) = ([0.0, f64::INFINITY], from);
    for _ in 0..4 {
        let step = (to - from) / f64::from(count);
        for i in 0..=count {
            let s = (from + f64::from(i) * step).clamp(curve.start(), curve.end());
            let [profile_y, profile_z] = curve.at(s).point;
            let radius = RADIUS + profile_z;
            // The two points of the circle at that height.
            let (a, b) = (turn[2][0] * radius, turn[2][2] * radius);
            let to = z - pose.marker[2] - turn[2][1] * profile_y;
            let size = a.hypot(b);
            if to.abs() > size {
                continue;
            }
            let (middle, half) = (a.atan2(b), (to / size).acos());
            for angle in [middle - half, middle + half] {
                let own = [radius * angle.sin(), profile_y, radius * angle.cos()];
                let place =
                    |k: usize| pose.marker[k] + (0..3).map(|i| turn[k][i] * own[i]).sum::<f64>();
                if place(1) < best[1] {
                    (best, at) = ([place(0), place(1)], s);
                }
            }
        }
        (from, to, count) = (at - 2.0 * step, at + 2.0 * step, 100);
    }
    best
}

#[test]
fn the_line_along_a_flange_back_is_the_rim_of_the_turned_wheel() {
    let wheel = load_profile("wheel", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap();
    let curve = &wheel.curve;
    let start = curve.start();
    let mut worst = [0f64; 2];
    for (roll, yaw) in [(0.0, 2e-3), (0.0, -0.01), (0.0, 0.03), (0.01, 0.005), (-0.02, -0.02)] {
        let pose = WheelPose { marker: [0.1, -0.01, -0.46], roll, yaw };
        let line = ContactLine::new(curve, RADIUS, &pose);
        let count = 4000;
        let points: Vec<_> =
            (0..=count).map(|i| line.at(start + 0.04 * f64::from(i) / f64::from(count))).collect();
        let mut seen = 0;
        for step in 0..20 {
            let z = -0.015 + 1.1e-3 * f64::from(step);
            let around = points.windows(2).find(|p| p[0].point[1] <= z && p[1].point[1] > z);
            let Some([from, to]) = around else { continue };
            let share = (z - from.point[1]) / (to.point[1] - from.point[1]);
            let found = [
                from.x + share * (to.x - from.x),
                from.point[0] + share * (to.point[0] - from.point[0]),
            ];
            let expected = innermost_of_wheel(curve, &pose, start + 0.045, z);
            for k in 0..2 {
                worst[k] = worst[k].max((found[k] - expected[k]).abs());
            }
            seen += 1;
        }
        assert!(seen > 12, "roll {roll}, yaw {yaw}: {seen} heights");
    }
    println!("worst: {:e} m along x, {:e} m across", worst[0], worst[1]);
    assert!(worst[0] < tolerance::RIM_AHEAD && worst[1] < tolerance::RIM_LATERAL, "{worst:?}");
}

#[test]
fn a_cone_touches_at_its_own_angle() {
    for tangent in [0.02, 0.05, 0.09, -0.05] {
        let mut pair = Pair::inclined(&format!("conical:{tangent}"), "arc:0.3", 0.0);
        let pose = pair.pose(0.01, 2e-5, 0.0, 0.0);
        search(&mut pair, &pose);
        let [contact] = pair.search.contacts[..] else { panic!("{:?}", pair.search.contacts) };
        let angle = -f64::atan(tangent);
        assert!((contact.angle() - angle).abs() < tolerance::CONE_ANGLE, "{}", contact.angle());
        let origin = [0.3 * angle.sin(), 0.3 * (1.0 - angle.cos())];
        for k in 0..2 {
            let miss = (contact.origin[k] - origin[k]).abs();
            assert!(miss < tolerance::CONE_PLACE, "{:?} against {origin:?}", contact.origin);
        }
    }
    // On a flat as steep as itself there is one contact, whatever its place.
    let mut pair = Pair::inclined("conical:0.05", "flat", 0.05);
    let pose = pair.pose(0.01, 2e-5, 0.0, 0.0);
    search(&mut pair, &pose);
    let [contact] = pair.search.contacts[..] else { panic!("{:?}", pair.search.contacts) };
    assert!((contact.angle() + f64::atan(0.05)).abs() < tolerance::CONE_ANGLE);
}
