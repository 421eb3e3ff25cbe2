//! Sections that drift or rise evenly along the track are an even rail at an angle.

use std::fmt::Write;
use std::fs;
use wheelrail::element::output::Patch;
use wheelrail::element::parameters::NormalModel;
use wheelrail::element::{Element, Input, Output, Parameters};

use super::{element, parameters};
use crate::common::random::Random;
use crate::common::varying::slices;
use crate::common::wheel::{evaluate, rolling};
use crate::tolerance;

/// Points of a smooth head [mm]: a crown of 300 mm whose corners go over to 13 mm, down to sides of
/// 75 degrees.
fn head() -> Vec<[f64; 2]> {
    let radius = |angle: f64| 13.0 + 287.0 / (1.0 + (angle / 0.08).powi(4));
    let (mut points, mut at, mut angle, mut walked) = (vec![[0.0, 0.0]], [0.0, 0.0], 0.0_f64, 0.0);
    let step = 2e-3;
    while angle < 75_f64.to_radians() {
        let middle = angle + 0.5 * step / radius(angle);
        at = [at[0] + step * middle.cos(), at[1] + step * middle.sin()];
        angle += step / radius(middle);
        walked += step;
        if walked > 0.25 {
            walked = 0.0;
            points.push(at);
        }
    }
    let left = points[1..].iter().rev().map(|[y, z]| [-y, *z]);
    left.chain(points.iter().copied()).collect()
}

/// Scalar product.
fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A rail whose sections drift to the side and fall, and the even one that it is, in axes along it.
struct Both {
    rates: [f64; 2],
    axes: [[f64; 3]; 3],
    varying: Element,
    even: Element,
}

impl Both {
    fn new(own: &Parameters, [drift, fall]: [f64; 2]) -> Self {
        let (n, m) = (f64::hypot(1.0, drift).hypot(fall), f64::hypot(1.0, drift));
        let along = [1.0 / n, drift / n, fall / n];
        let right = [-drift / m, 1.0 / m, 0.0];
        let down = [-fall / (n * m), -fall * drift / (n * m), m / n];
        let text = |wide: f64, high: f64, [y, z]: [f64; 2]| {
            head().iter().fold(String::new(), |text, p| {
                text + &format!("{:.12} {:.12}\n", wide * p[0] + y, high * p[1] + z)
            })
        };
        // The sections are wider across and higher by as much as the rail lies askew; only one of
        // both.
        let folder = slices((-10..=10).map(|i| 100.0 * f64::from(i)), |place| {
            text(m, n / m, [drift * place, fall * place])
        });
        let mut even = own.clone();
        even.rails[0].profile = "even.txt".into();
        fs::write(folder.path().join("even.txt"), text(1.0, 1.0, [0.0; 2])).unwrap();
        let [varying, even] = [own, &even].map(|parameters| element(parameters, &folder));
        Self { rates: [drift, fall], axes: [along, right, down], varying, even }
    }

    /// The `input` of the varying rail in axes along it.
    fn turned(&self, input: &Input) -> Input {
        let [drift, fall] = self.rates;
        let [_, y, z] = input.wheel.position;
        let station = input.track_s;
        let seen = |v: [f64; 3]| self.axes.map(|axis| dot(axis, v));
        let [_, y, z] = seen([0.0, y - 0.75 - drift * station, z - fall * station]);
        let (sin_roll, cos_roll) = input.wheel.roll.sin_cos();
        let (sin_yaw, cos_yaw) = input.wheel.yaw.sin_cos();
        let [ux, uy, uz] = seen([-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll]);
        let mut turned = *input;
        turned.wheel.position = [0.0, 0.75 + y, z];
        turned.wheel.velocity = seen(input.wheel.velocity);
        (turned.wheel.roll, turned.wheel.yaw) = (uz.atan2(uy), (-ux).atan2(uy.hypot(uz)));
        turned
    }

    /// Greatest difference of force and of moment over half a metre on wheel and of the normal force
    /// and pressure of the first patch, over the force and the pressure.
    fn apart(&self, varying: &Output, even: &Output) -> f64 {
        let back = |v: [f64; 3]| [0, 1, 2].map(|c| (0..3).map(|i| self.axes[i][c] * v[i]).sum());
        let pairs = [
            (varying.wheel.force, back(even.wheel.force)),
            (varying.wheel.moment.map(|m| 2.0 * m), back(even.wheel.moment).map(|m: f64| 2.0 * m)),
        ];
        let size = varying.wheel.force.iter().fold(1.0_f64, |most, own| most.max(own.abs()));
        let wrench = pairs.iter().flat_map(|(a, b)| (0..3).map(|c| (a[c] - b[c]).abs() / size));
        let (a, b) = (&varying.patches[0], &even.patches[0]);
        let creep = |patch: &Patch| patch.creep_force[0].hypot(patch.creep_force[1]);
        let patch = [
            a.normal_force / b.normal_force - 1.0,
            a.max_pressure / b.max_pressure - 1.0,
            (creep(a) - creep(b)) / b.normal_force,
        ];
        let all = wrench.chain(patch.map(f64::abs));
        all.map(|own| if own.is_nan() { f64::INFINITY } else { own }).fold(0.0, f64::max)
    }
}

/// Differences of `poses` random poses, for each rail and model: of heights of first touch where
/// rails do not fall, and of forces; with the worst pose. `of_ellipses` is what those of one ellipse
/// are held to.
fn random_poses(models: &[NormalModel], poses: usize, seed: u64, of_ellipses: f64) -> Vec<String> {
    let mut random = Random::new(seed);
    let mut missed = Vec::new();
    let rails = [0.1, -0.1, 1.0 / 15.0, -1.0 / 30.0].map(|drift| [drift, 0.0]);
    let rising = [[0.0, 0.1], [0.0, -0.05]];
    for normal_model in models {
        for rates in rails.iter().chain(&rising) {
            // Damped, a wheel that goes off the gauge face at 2 m/s has no load there.
            let mut own = Parameters { normal_model: *normal_model, damping: 0.0, ..parameters() };
            own.wheel.profile = "S1002".into();
            let allowed = match normal_model {
                // Elements of both rails are not the same ones.
                NormalModel::BoundaryElement => tolerance::EVENLY_DRIFTING_ELEMENTS,
                NormalModel::Hertz => of_ellipses,
                _ => tolerance::EVENLY_DRIFTING,
            };
            let mut both = Both::new(&own, *rates);
            let (mut touch, mut force, mut pose) = (0.0_f64, 0.0_f64, Input::default());
            let mut wide = 0;
            for _ in 0..poses {
                let mut input = rolling(0.0, 20.0);
                input.track_s = random.about(0.3);
                let aside = rates[0] * input.track_s;
                input.wheel.position[1] = 0.75 + aside + random.within(-0.012, 0.014);
                (input.wheel.roll, input.wheel.yaw) = (random.about(0.01), random.about(0.04));
                input.wheel.velocity[1] = random.about(0.1);
                let height = both.varying.touching_height(&input);
                if rates[1] == 0.0 {
                    let even = both.turned(&input);
                    touch = touch.max((height - both.even.touching_height(&even)).abs());
                }
                input.wheel.position[2] = height + random.within(1e-6, 1.5e-4);
                let one = evaluate(&mut both.varying, &input);
                let turned = both.turned(&input);
                let other = evaluate(&mut both.even, &turned);
                assert!(one.patch_count > 0 && other.patch_count > 0, "{input:?}");
                wide += i32::from(one.patches[0].contact_angle.abs() > 0.5);
                let found = both.apart(&one, &other);
                if found > force {
                    (force, pose) = (found, input);
                }
            }
            println!(
                "{normal_model:?} {rates:?}: touch {touch:.1e} m, forces {force:.1e}, {wide} steep"
            );
            if touch > tolerance::TOUCHING_HEIGHT || force > allowed {
                let mut text = format!("{normal_model:?} {rates:?} {touch:e} {force:e}");
                write!(text, " {:?} {}", pose.wheel, pose.track_s).unwrap();
                missed.push(text);
            }
        }
    }
    missed
}

const ALL: [NormalModel; 3] = [NormalModel::Strips, NormalModel::PiotrowskiKik, NormalModel::Hertz];

#[test]
fn sections_that_drift_or_rise_evenly_are_an_even_rail_at_an_angle() {
    let missed = random_poses(&ALL, 28, 1, tolerance::EVENLY_DRIFTING);
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

#[test]
fn boundary_elements_on_sections_that_drift_or_rise_evenly_are_those_of_an_even_rail() {
    let missed = random_poses(&[NormalModel::BoundaryElement], 1, 3, tolerance::EVENLY_DRIFTING);
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

#[test]
#[ignore = "long: cargo test --release --test suite varying_rail:: -- --ignored"]
fn twenty_thousand_wheels_on_sections_that_drift_or_rise_evenly() {
    let missed = random_poses(&ALL, 1100, 2, tolerance::EVENLY_DRIFTING_ELLIPSES);
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}
