//! Rough sections around the wheel: a row is met where it reaches farthest, of many places that
//! reach nearly as far.

use super::*;

/// Waves of the radius: height and length [m], phase at the middle and how fast it turns across
/// [rad, rad/m].
const WAVES_AROUND: [[f64; 4]; 4] = [
    [0.8e-5, 5e-3, 0.4, 300.0],
    [1.2e-5, 7e-3, 1.9, -200.0],
    [1.6e-5, 11e-3, 4.0, 120.0],
    [2.2e-5, 17e-3, 2.7, -80.0],
];
/// Depth and half the length of a hollow flat [m].
const FLAT: [f64; 2] = [4e-4, 0.02];
const RADIUS: f64 = 0.45;
/// Radius of the crown under the wheel [m].
const CROWN: f64 = 0.3;
/// Distance of sections along the circle [m], and how many lie to either side.
const SECTIONS: (f64, i32) = (5e-4, 180);

/// What the radius at `arc` around the circle and `y` across is beyond that of the cylinder [m].
fn rise(arc: f64, y: f64) -> f64 {
    let wave = |[height, length, phase, turn]: [f64; 4]| {
        height * (TAU * arc / length + phase + turn * y).cos()
    };
    let [depth, half] = FLAT;
    let flat = 0.5 * depth * (1.0 + (0.5 * TAU * (arc / half).clamp(-1.0, 1.0)).cos());
    WAVES_AROUND.into_iter().map(wave).sum::<f64>() - flat
}

fn rough() -> TempDir {
    let folder = TempDir::new().unwrap();
    let (apart, count) = SECTIONS;
    let mut listed = String::new();
    for k in -count..=count {
        let arc = apart * f64::from(k);
        let mut section = String::from("# mirror_z 0\n# mirror_y 0\n");
        for i in -60..=60 {
            let y = 5e-4 * f64::from(i);
            writeln!(section, "{:.4} {:.10}", 1e3 * y, 1e3 * rise(arc, y)).unwrap();
        }
        fs::write(folder.path().join(format!("{}.txt", k + count)), section).unwrap();
        writeln!(listed, "{:.12} '{}.txt'", arc / RADIUS, k + count).unwrap();
    }
    let text = format!("0 1\n{}\n0 0 0\n1\n{listed}", 2 * count + 1);
    fs::write(folder.path().join("wheel.slcw"), text).unwrap();
    folder
}

/// Height at which a wheel `beside` the crown that has turned forward by `arc` touches it first, by
/// the places of a fine net.
fn scanned(arc: f64, beside: f64) -> f64 {
    let on = |x: f64, y: f64| {
        let crown = CROWN - (CROWN * CROWN - (y + beside).powi(2)).sqrt();
        let radius = RADIUS + rise(arc + RADIUS * (x / RADIUS).asin(), y);
        crown - (radius * radius - x * x).sqrt()
    };
    let least = |[x0, y0]: [f64; 2], [half_x, half_y]: [f64; 2]| {
        let places = (-100..=100).flat_map(|i| (-100..=100).map(move |j| [i, j]));
        let at = places
            .map(|[i, j]| [x0 + half_x * f64::from(i) / 100.0, y0 + half_y * f64::from(j) / 100.0]);
        at.min_by(|a, b| on(a[0], a[1]).total_cmp(&on(b[0], b[1]))).unwrap()
    };
    let rough = least([0.0, -beside], [0.03, 0.01]);
    let [x, y] = least(rough, [6e-4, 2e-4]);
    on(x, y)
}

#[test]
fn a_rough_wheel_touches_where_it_reaches_farthest() {
    let folder = rough();
    let (mut element, mut input) = on_crown(&Parameters::default(), &folder);
    input.wheel_load = 0.0;
    let mut random = Random::new(59);
    let mut worst = (0.0_f64, [0.0; 2]);
    for _ in 0..200 {
        let (arc, beside) = (random.about(0.05), random.about(0.012));
        input.wheel.pitch = -arc / RADIUS;
        input.wheel.position[1] = beside;
        let away = evaluate(&mut element, &input).wheel_z - scanned(arc, beside);
        if away.abs() > worst.0.abs() {
            worst = (away, [arc, beside]);
        }
    }
    assert!(worst.0.abs() <= tolerance::ROUGH_TOUCH, "{worst:?}");
}
