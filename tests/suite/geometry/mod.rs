//! The contact search and the contact line against brute force.

mod outline;

use crate::tolerance;
use std::path::PathBuf;

use crate::common::random::Random;
use wheelrail::element::{Element, Input, Parameters};
use wheelrail::geometry::contact_line::{ContactLine, WheelPose};
use wheelrail::geometry::contacts::clearance::Clearance;
use wheelrail::geometry::contacts::contact_search::ContactSearch;
use wheelrail::geometry::profile::{Profile, ProfileKind};
use wheelrail::geometry::rail::placed_rail::PlacedRail;
use wheelrail::io::load_profile;

const RADIUS: f64 = 0.46;
/// Lateral position of the nominal rolling circle of a centred wheel in the track [m].
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
        let placed = PlacedRail::by_gauge(&rail.curve, inclination, 1.435, 0.014, false).unwrap();
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

/// Signed distance of the line from the rail at steps of 20 µm; up to 0.4 mm where it is beyond a
/// millimetre.
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

/// Poses over the whole range; two in three as deep as real contacts, one in three where a wheel
/// changes from tread to flange.
fn random_pose(pair: &mut Pair, random: &mut Random, index: usize) -> WheelPose {
    let (shift, depth) = (random.about(12e-3), random.within(-1e-3, 3e-3));
    let (roll, yaw) = (random.about(0.02), random.about(0.05));
    match index % 3 {
        0 => pair.pose(shift, depth, roll, yaw),
        1 => pair.pose(shift, 0.05 * depth, roll, yaw),
        _ => pair.pose(5.2e-3 + 0.03 * shift, 0.02 * depth.abs(), 0.02 * roll, 0.02 * yaw),
    }
}

/// What the search and brute force have at one pose.
struct Found {
    /// Deepest penetration by brute force, negative above the rail [m].
    brute: f64,
    contacts: usize,
    /// Difference of the deepest penetrations, where there is one [m].
    difference: f64,
}

/// Searches at `pose` and asserts that all contacts are found, and none is made up.
fn compare(pair: &mut Pair, pose: &WheelPose) -> Found {
    search(pair, pose);
    let line = ContactLine::new(&pair.wheel.curve, RADIUS, pose);
    let scan = dense_scan(&line, &pair.rail);
    let contacts = &pair.search.contacts;
    let brute = deepest(&scan);
    let mut difference = 0.0;
    if brute > tolerance::MISSED_PENETRATION {
        let lifted = pair.ranges.is_empty();
        assert!(!lifted, "{}: touches by {brute}, called lifted: {pose:?}", pair.name);
        let found = contacts.iter().map(|c| c.penetration).fold(0.0, f64::max);
        difference = (found - brute).abs();
        assert!(
            difference < tolerance::DEEPEST_PENETRATION,
            "{}: found {found}, brute force {brute}: {pose:?}",
            pair.name
        );
    }
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
    Found { brute, contacts: contacts.len(), difference }
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
            let Found { brute, contacts, difference } = compare(&mut pair, &pose);
            touching += i32::from(brute > tolerance::MISSED_PENETRATION);
            several += i32::from(contacts > 1);
            worst = worst.max(difference);
        }
    }
    println!("{touching} touching, {several} with several contacts, worst difference {worst:e} m");
    assert!(touching > 150 && several > 20, "{touching}, {several}");
}

/// The height of first touch of a wheel that yaws so far, and what is found about it, against brute
/// force.
fn touch_of_a_yawed_wheel(pair: &mut Pair, [shift, roll, yaw]: [f64; 3]) {
    let touch = pair.pose(shift, 0.0, roll, yaw);
    for depth in [-1e-7, 1e-6, 1e-4] {
        let mut pose = touch;
        pose.marker[2] += depth;
        let Found { brute, .. } = compare(pair, &pose);
        let is_above = depth < 0.0;
        assert!(
            (brute < tolerance::MISSED_PENETRATION) == is_above,
            "{}: {brute} at {depth}: {pose:?}",
            pair.name
        );
    }
}

/// Wheels that yaw so far that their lines run three times as fast at the foot of the flange.
fn yawed_wheels(poses: usize, seed: u64) {
    let mut random = Random::new(seed);
    for wheel in ["S1002", "S1002_worn.txt"] {
        let mut pair = Pair::new(wheel, "60E1");
        for _ in 0..poses {
            let shift = random.within(-5e-3, 1e-2);
            let attitude = [shift, random.about(0.02), random.about(0.08)];
            touch_of_a_yawed_wheel(&mut pair, attitude);
        }
    }
}

#[test]
fn wheels_that_yaw_far_begin_to_touch_where_brute_force_does() {
    yawed_wheels(250, 11);
    // A dip beside a place where the curvature of the wheel steps, and with it how fast the line
    // runs.
    let mut pair = Pair::new("S1002", "60E1");
    touch_of_a_yawed_wheel(&mut pair, [4.100_357_9e-3, -2.072_777_6e-3, 0.049_343_896]);
    touch_of_a_yawed_wheel(&mut pair, [8.627_967_4e-3, 8.328_903_6e-3, -0.053_036_582]);
}

#[test]
#[ignore = "long: cargo test --release --test suite geometry:: -- --ignored"]
fn twenty_thousand_wheels_that_yaw_far_begin_to_touch_where_brute_force_does() {
    yawed_wheels(10_000, 12);
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

#[test]
fn a_flange_that_runs_at_the_rail_touches_ahead_of_the_axle() {
    let mut pair = Pair::new("S1002", "60E1");
    for yaw in [-0.04, -0.01, 0.01, 0.04] {
        let pose = pair.pose(8e-3, 5e-5, 0.0, yaw);
        search(&mut pair, &pose);
        let line = ContactLine::new(&pair.wheel.curve, RADIUS, &pose);
        let flange = pair.search.contacts.iter().find(|c| c.angle().abs() > 0.6).unwrap();
        let x = line.at(flange.u).x;
        // r tan(contact angle) sin(yaw), and the lateral coordinate of the flange turned by the
        // yaw.
        let expected =
            -line.wheel_point(flange.u).rolling_radius * flange.angle().tan() * yaw.sin()
                - line.wheel_point(flange.u).y * yaw.sin();
        assert!(x * yaw > 0.0, "yaw {yaw}: flange touches at {x}");
        assert!((x / expected - 1.0).abs() < tolerance::FLANGE_AHEAD, "{x} against {expected}");
    }
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
