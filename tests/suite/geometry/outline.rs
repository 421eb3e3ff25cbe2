//! The contact line against the outline of the turned wheel.

use super::*;
use wheelrail::geometry::curve::Curve;

/// Circle of the wheel through the profile point of parameter `s`, seen along x: where it is lowest
/// at lateral position `y`. Returns (x, z).
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

/// Lowest point (x, z) of the whole wheel at lateral position `y`, by scans of all circles ever
/// finer about the lowest.
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
        let (_, derivative) = line.with_derivative(s);
        let (before, after) = (line.at(s - step).point, line.at(s + step).point);
        for k in 0..2 {
            let difference = (after[k] - before[k]) / (2.0 * step);
            let miss = (difference - derivative[k]).abs();
            assert!(miss < tolerance::DERIVATIVE, "{miss:e} at {s}");
        }
    }
}

/// Point (x, y) of the whole wheel that lies furthest to the track centre at height `z`, on the
/// profile from its start to `end`.
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
