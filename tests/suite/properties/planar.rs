//! Strips of any zone, and planar contacts of bodies of any size.

use super::*;
use crate::common::planar::{STEEL, steel_case};
use std::f64::consts::FRAC_PI_2;
use wheelrail::element::parameters::Flexibilities;
use wheelrail::kinematics::creepage::Creepage;
use wheelrail::material::MaterialPair;
use wheelrail::normal::{Strips, Zone};
use wheelrail::planar::{PlanarCase, solve};
use wheelrail::tangential::fastsim::TractionBound;
use wheelrail::tangential::{RollingState, RollingZone, Settings, Tangential};

/// Strips of one zone as a normal model could leave them, only rougher: each of its own.
fn any_zone() -> impl Strategy<Value = (Zone, Strips)> {
    let strip = (1e-4..1e-2f64, 1e5..3e9f64, 1e-5..2e-3f64, -2e-3..2e-3f64);
    prop::collection::vec(strip, 1..40).prop_map(|rows| {
        let mut strips = Strips::with_capacity(1, rows.len());
        let mut zone: Zone = Zone { count: rows.len(), ..Zone::default() };
        let mut edge = 0.0;
        let (mut x_moment, mut y_moment) = (0.0, 0.0);
        for (half_length, pressure, width, x) in rows {
            let y = edge + 0.5 * width;
            edge += width;
            for (column, value) in [
                (&mut strips.y, y),
                (&mut strips.width, width),
                (&mut strips.x, x),
                (&mut strips.half_length, half_length),
                (&mut strips.pressure, pressure),
                (&mut strips.u, y),
            ] {
                column.push(value);
            }
            let load = FRAC_PI_2 * half_length * width * pressure;
            zone.load += load;
            zone.area += 2.0 * half_length * width;
            zone.max_pressure = zone.max_pressure.max(pressure);
            zone.length = zone.length.max(2.0 * half_length);
            x_moment += load * x;
            y_moment += load * y;
        }
        zone.width = edge;
        (zone.x, zone.y) = (x_moment / zone.load, y_moment / zone.load);
        strips.zones.push(zone);
        (zone, strips)
    })
}

/// Settings of a model with few elements.
fn settings(flexibilities: Flexibilities, bound: TractionBound) -> Settings {
    Settings { flexibilities, bound, elements_along: 10, elements: [8, 8], strips: 8 }
}

#[test]
fn no_strip_carries_more_than_friction_times_its_pressure() {
    let tangential: Vec<_> = [TractionBound::Elliptic, TractionBound::Parabolic]
        .into_iter()
        .flat_map(|bound| BOUNDED.map(|model| (model, bound)))
        .flat_map(|pair| [Flexibilities::Three, Flexibilities::Blended].map(|f| (pair, f)))
        .map(|((model, bound), flexibilities)| {
            (model, bound, Tangential::new(model, &settings(flexibilities, bound)))
        })
        .collect();
    let material = MaterialPair::new(STEEL, STEEL);
    let creepage = [around(0.0, 1.0), around(0.0, 1.0), around(0.0, 1.0)];
    let size = -6.0..0.0f64;
    proptest!(cases(), |(
        (zone, strips) in any_zone(),
        [longitudinal, lateral, spin] in creepage,
        size in size,
        friction in 0.0..2.0f64,
        forward_share in prop_oneof![Just(0.0), Just(1.0), 0.0..1.0f64],
        load_factor in 0.0..2.0f64,
    )| {
        let size = 10f64.powf(size);
        let creepage = Creepage {
            longitudinal: size * longitudinal, lateral: size * lateral, spin: 300.0 * size * spin,
        };
        let state = RollingState { creepage, forward_share, friction, load_factor, speed: 20.0 };
        for (model, bound, mut tangential) in tangential.clone() {
            let mut forces = vec![[0.0; 2]; zone.count];
            let law = tangential.under_law(&zone, &strips, &material, &state);
            let rolling = RollingZone::flat(&zone, &strips, &law);
            tangential.roll(std::iter::once(rolling), |_, j, force| {
                forces[j][0] += force.longitudinal;
                forces[j][1] += force.lateral;
            });
            let total = [0, 1].map(|i| forces.iter().map(|f| f[i]).sum::<f64>());
            let limit = friction * load_factor * zone.load;
            let excess = total[0].hypot(total[1]) - limit * (1.0 + 1e-9);
            prop_assert!(excess <= 0.0, "{model:?} {bound:?}: {total:?} beyond {limit}");
            // Corrections hold for the zone as a whole; a parabola has another bound, of the same
            // sum.
            let is_corrected =
                matches!(model, TangentialModel::FastsimCorrected | TangentialModel::Marches);
            if is_corrected || bound == TractionBound::Parabolic {
                continue;
            }
            for (j, force) in forces.iter().enumerate() {
                let area = strips.half_length[j] * strips.width[j];
                let limit = friction * load_factor * FRAC_PI_2 * area * strips.pressure[j];
                let found = force[0].hypot(force[1]);
                prop_assert!(found <= limit * (1.0 + 1e-9), "{model:?}: strip {j} {found} of {limit}");
            }
        }
    });
}

/// An elliptic zone in even strips, `ratio` times as long as wide.
fn ellipse(ratio: f64, count: usize) -> (Zone, Strips) {
    let (a, b) = (5e-3 * ratio.sqrt(), 5e-3 / ratio.sqrt());
    let mut strips = Strips::with_capacity(1, count);
    let mut zone = Zone { count, length: 2.0 * a, width: 2.0 * b, ..Zone::default() };
    let width = 2.0 * b / count as f64;
    for j in 0..count {
        let y = -b + (j as f64 + 0.5) * width;
        let height = (1.0 - (y / b).powi(2)).sqrt();
        for (column, value) in [
            (&mut strips.y, y),
            (&mut strips.width, width),
            (&mut strips.x, 0.0),
            (&mut strips.half_length, a * height),
            (&mut strips.pressure, 1e9 * height),
            (&mut strips.u, y),
        ] {
            column.push(value);
        }
        zone.load += FRAC_PI_2 * a * height * width * 1e9 * height;
        zone.area += 2.0 * a * height * width;
        zone.max_pressure = zone.max_pressure.max(1e9 * height);
    }
    strips.zones.push(zone);
    (zone, strips)
}

#[test]
fn friction_on_an_ellipse_takes_energy() {
    let models = BOUNDED.map(|model| {
        let settings = settings(Flexibilities::Three, TractionBound::Elliptic);
        (model, Tangential::new(model, &settings))
    });
    let material = MaterialPair::new(STEEL, STEEL);
    let creepage = [around(0.0, 1.0), around(0.0, 1.0), around(0.0, 1.0)];
    proptest!(cases(), |(
        ratio in -3.5..MOST_SLENDER.log10(),
        count in 4..30usize,
        [longitudinal, lateral, spin] in creepage,
        size in -5.0..-1.0f64,
        friction in 0.05..2.0f64,
    )| {
        let (zone, strips) = ellipse(10f64.powf(ratio), count);
        let size = 10f64.powf(size);
        let creepage = Creepage {
            longitudinal: size * longitudinal, lateral: size * lateral, spin: 200.0 * size * spin,
        };
        let state =
            RollingState { creepage, forward_share: 1.0, friction, load_factor: 1.0, speed: 20.0 };
        for (model, mut tangential) in models.clone() {
            let law = tangential.under_law(&zone, &strips, &material, &state);
            let rolling = RollingZone::flat(&zone, &strips, &law);
            let mut sum = [0.0; 3];
            tangential.roll(std::iter::once(rolling), |_, j, found| {
                sum[0] += found.longitudinal;
                sum[1] += found.lateral;
                sum[2] += found.moment - strips.y[j] * found.longitudinal;
            });
            let limit = friction * zone.load * (1.0 + 1e-9);
            prop_assert!(sum[0].hypot(sum[1]) <= limit, "{model:?}: {sum:?} beyond {limit}");
            let Creepage { longitudinal, lateral, spin } = creepage;
            let powers = [sum[0] * longitudinal, sum[1] * lateral, sum[2] * spin];
            let rounding = 1e-9 * powers.iter().map(|power| power.abs()).sum::<f64>();
            let power = powers.iter().sum::<f64>();
            prop_assert!(power <= rounding, "{model:?}: {sum:?} by {creepage:?}");
        }
    });
}

prop_compose! {
    /// A smooth separation with up to a few minima, larger or smaller by `scale`.
    fn planar_shape()(
        across in 0.2..20.0f64,
        waves in prop::collection::vec((0.0..3e-6f64, 200.0..900.0f64, 0.0..6.0f64), 0..3),
        radius in 0.1..2.0f64,
        approach in -5.0..-3.5f64,
        creepage in [around(0.0, 3e-3), around(0.0, 3e-3), around(0.0, 1.0)],
        friction in 0.05..1.0f64,
    ) -> PlanarShape {
        PlanarShape { across, waves, radius, approach: 10f64.powf(approach), creepage, friction }
    }
}

#[derive(Clone, Debug)]
struct PlanarShape {
    across: f64,
    waves: Vec<(f64, f64, f64)>,
    radius: f64,
    approach: f64,
    creepage: [f64; 3],
    friction: f64,
}

impl PlanarShape {
    /// Points out to where a parabola is three times as far as the approach, `scale` times as
    /// large.
    fn separation(&self, scale: f64) -> Vec<[f64; 2]> {
        let reach = (3.0 * (self.approach + 1e-5) / self.across).sqrt();
        let f = |y: f64| {
            let waves = self.waves.iter().map(|(a, k, phase)| a * (1.0 - (k * y + phase).cos()));
            self.across * y * y + waves.sum::<f64>()
        };
        (-60..=60).map(|i| reach * f64::from(i) / 60.0).map(|y| [scale * y, scale * f(y)]).collect()
    }

    fn case<'a>(
        &self,
        separation: &'a [[f64; 2]],
        scale: f64,
        normal_model: NormalModel,
        tangential_model: TangentialModel,
    ) -> PlanarCase<'a> {
        let [longitudinal, lateral, spin] = self.creepage;
        PlanarCase {
            creepage: [longitudinal, lateral, spin / scale],
            friction: self.friction,
            normal_model,
            tangential_model,
            strips: 9,
            elements_along: 10,
            ..steel_case(separation, scale * self.radius, scale * self.approach)
        }
    }
}

#[test]
fn bodies_of_another_size_carry_its_square() {
    // All but strips, whose nodes go by curvatures over a length of profiles as they are.
    let normal = prop::sample::select(&NORMAL[..3]);
    let models = (normal, prop::sample::select(&TANGENTIAL[..]), planar_shape());
    proptest!(cases(), |((normal, tangential, shape) in models, scale in 0.2..5.0f64)| {
        let (one, other) = (shape.separation(1.0), shape.separation(scale));
        let one = solve(&shape.case(&one, 1.0, normal, tangential)).unwrap();
        let other = solve(&shape.case(&other, scale, normal, tangential)).unwrap();
        prop_assert_eq!((one.patches, one.fallback), (other.patches, other.fallback));
        let allowed = tolerance::SIMILARITY * one.normal_force * shape.friction.max(1.0);
        let scaled = [other.fx, other.fy, other.normal_force].map(|f| f / (scale * scale));
        assert_close(scaled, [one.fx, one.fy, one.normal_force], allowed, "force");
        let pressure = (other.max_pressure - one.max_pressure).abs();
        prop_assert!(pressure <= tolerance::SIMILARITY * one.max_pressure);
    });
}

#[test]
fn creepage_and_friction_grow_together() {
    let models =
        (prop::sample::select(&NORMAL[..]), prop::sample::select(&BOUNDED[..]), planar_shape());
    proptest!(cases(), |((normal, tangential, shape) in models, factor in 0.2..5.0f64)| {
        let separation = shape.separation(1.0);
        let case = shape.case(&separation, 1.0, normal, tangential);
        let more = PlanarCase {
            creepage: case.creepage.map(|c| factor * c),
            friction: factor * case.friction,
            ..case
        };
        let (one, other) = (solve(&case).unwrap(), solve(&more).unwrap());
        let allowed = tolerance::SIMILARITY * case.friction * one.normal_force;
        let scaled = [other.fx, other.fy, other.normal_force].map(|f| f / factor);
        assert_close(scaled, [one.fx, one.fy, one.normal_force / factor], allowed, "creep force");
    });
}
