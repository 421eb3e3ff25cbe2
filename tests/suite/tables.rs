//! The table of creep forces: its limits, its derivatives, its accuracy on ellipses and on real
//! patches.

use crate::common::planar::{STEEL, steel_case};
use crate::common::random::Random;
use crate::common::summary::Summary;
use crate::common::{Table, column, quantiles, read_table, value};
use crate::tolerance;
use approx::assert_abs_diff_eq;
use wheelrail::normal::NormalModel;
use wheelrail::planar::{Indentation, PlanarCase, solve};
use wheelrail::tangential::TangentialModel;
use wheelrail::tangential::kalker_coefficients::kalker_coefficients;
use wheelrail::tangential::tables::generate::{ELEMENTS, EllipseNodes};
use wheelrail::tangential::tables::nodes::{RING, SATURATIONS, SLIDING_RING};
use wheelrail::tangential::tables::scales::Scales;
use wheelrail::tangential::tables::sliding::sliding_force;
use wheelrail::tangential::tables::{CreepForceTable, EllipseForce};

fn table() -> &'static CreepForceTable {
    CreepForceTable::shared()
}

/// ln(a/b), inside the table and beyond.
fn random_log_ratio(random: &mut Random) -> f64 {
    random.about(4.0)
}

/// Creepages of any direction, their scaled length from 1e-2 to 1e2.
fn random_creepage(random: &mut Random) -> [f64; 3] {
    let length = 10f64.powf(random.about(2.0));
    [random.about(1.0), random.about(1.0), random.about(1.0)].map(|v| length * v / 3.0)
}

#[test]
fn the_committed_table_knows_its_errors() {
    let nodes = CreepForceTable::committed_nodes().unwrap();
    let [mean, p95, worst] = quantiles(nodes.error);
    println!("estimated error of the nodes: mean {mean:.5}, 95 % {p95:.5}, worst {worst:.5}");
    let [most_mean, most_worst] = tolerance::TABLE_NODES;
    assert!(mean > 0.0 && mean <= most_mean && worst <= most_worst);
}

#[test]
fn nodes_of_the_committed_table_are_what_the_generator_makes() {
    let nodes = CreepForceTable::committed_nodes().unwrap();
    for (i, j, k) in [(0, 11, 100), (3, 1, 30), (6, 5, 240), (8, 7, 5), (12, 3, 200)] {
        let ellipse = EllipseNodes::number(i, ELEMENTS);
        let (made, error) = ellipse.creep_node(j, k).unwrap();
        let n = (i * SATURATIONS + j - 1) * RING + k;
        // Kept as 16-bit integers and bytes.
        assert_abs_diff_eq!(made[..], nodes.creep[n][..], epsilon = 5e-4);
        assert_abs_diff_eq!(error, nodes.error[n], epsilon = 1.01e-4);
    }
    for (i, k) in [(0, 100), (5, 1000), (12, 777)] {
        let made = EllipseNodes::number(i, ELEMENTS).sliding_node(k);
        assert_abs_diff_eq!(made[..], nodes.sliding[i * SLIDING_RING + k][..], epsilon = 3e-5);
    }
}

#[test]
fn small_creepages_follow_the_linear_law_whatever_poissons_ratio() {
    let mut random = Random::new(1);
    for nu in [0.0, 0.28, 0.5] {
        for _ in 0..200 {
            let log_ratio = random_log_ratio(&mut random);
            let [x, y, z] = random_creepage(&mut random);
            let small = 1e-6 / (x.abs() + y.abs() + z.abs());
            let v = [x, y, z].map(|v| small * v);
            let found = table().force(&Scales::of(log_ratio, nu), v).force;
            let c = kalker_coefficients(log_ratio.exp(), nu);
            let linear = [-c.c11 * v[0], -c.c22 * v[1] - c.c23 * v[2], c.c23 * v[1] - c.c33 * v[2]];
            // What is left is of second order.
            let size = 1e-6 * (c.c11 + c.c22 + c.c23 + c.c33);
            for k in 0..3 {
                assert_abs_diff_eq!(found[k], linear[k], epsilon = 10.0 * size * size);
            }
        }
    }
}

#[test]
fn great_creepages_slide_in_full() {
    let mut random = Random::new(2);
    let mut errors = [Vec::new(), Vec::new()];
    for _ in 0..2000 {
        let log_ratio = random.about(2.9);
        let v = random_creepage(&mut random);
        let length = v[0].hypot(v[1]).hypot(v[2]);
        let great = v.map(|v| 1e9 * v / length);
        let found = table().force(&Scales::of(log_ratio, 0.1), great).force;
        let exact = sliding_force(log_ratio, v);
        errors[0].push((found[0] - exact[0]).hypot(found[1] - exact[1]));
        errors[1].push((found[2] - exact[2]).abs());
        // Without spin the limit is met to rounding.
        let found = table().force(&Scales::of(log_ratio, 0.1), [great[0], great[1], 0.0]).force;
        let slip = v[0].hypot(v[1]);
        assert_abs_diff_eq!(found[0], -v[0] / slip, epsilon = 1e-7);
        assert_abs_diff_eq!(found[1], -v[1] / slip, epsilon = 1e-7);
        assert_abs_diff_eq!(found[2], 0.0, epsilon = 1e-7);
    }
    for (errors, bounds) in errors.into_iter().zip(tolerance::TABLE_SLIDING) {
        let [mean, p95, worst] = quantiles(errors);
        println!("full sliding: mean {mean:.5}, 95 % {p95:.5}, worst {worst:.5}");
        assert!(mean <= bounds[0] && worst <= bounds[1]);
    }
}

#[test]
fn forces_keep_the_symmetries_and_the_friction_limit() {
    let mut random = Random::new(3);
    for _ in 0..5000 {
        let scales = Scales::of(random_log_ratio(&mut random), 0.28);
        let [x, y, z] = random_creepage(&mut random);
        let force = |v| table().force(&scales, v);
        let found = force([x, y, z]);
        assert!(found.force[0].hypot(found.force[1]) <= 1.0 + 1e-12, "{found:?}");
        assert!((0.0..=1.0).contains(&found.slip_share));
        let [fx, fy, mz] = found.force;
        assert_abs_diff_eq!(force([x, -y, -z]).force[..], [fx, -fy, -mz][..], epsilon = 1e-14);
        assert_abs_diff_eq!(force([-x, -y, -z]).force[..], [-fx, -fy, -mz][..], epsilon = 1e-14);
    }
}

#[test]
fn extreme_creepages_give_finite_forces() {
    let extremes = [0.0, 1e-300, -1e-80, 1e-20, 1.0, -1e30, 1e80, 1e100];
    for log_ratio in [-40.0, -3.0, 0.0, 2.9, 13.0] {
        let scales = Scales::of(log_ratio, 0.28);
        for x in extremes {
            for y in extremes {
                for z in extremes {
                    let (found, slopes) = table().force_and_slopes(&scales, [x, y, z]);
                    let value = table().force(&scales, [x, y, z]).force;
                    assert_abs_diff_eq!(found.force[..], value[..], epsilon = 1e-14);
                    assert!(found.force.iter().all(|f| f.is_finite()));
                    assert!(slopes.iter().flatten().all(|s| s.is_finite()), "{x} {y} {z}");
                }
            }
        }
    }
}

#[test]
fn derivatives_are_those_of_differences_and_have_no_jumps() {
    let mut random = Random::new(4);
    // States on the seams of the table, too: no spin, no longitudinal creepage, pure creepages,
    // knots of ln(a/b), the friction limit.
    let mut states: Vec<(f64, [f64; 3])> =
        (0..400).map(|_| (random_log_ratio(&mut random), random_creepage(&mut random))).collect();
    for (x, y, z) in [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (0, 1, 1), (1, 0, 1), (0, -1, 1)]
    {
        for length in [0.01, 0.3, 1.0] {
            states.push((0.0, [x, y, z].map(|v| length * f64::from(v))));
        }
    }
    let nu = 0.3;
    let mut worst: f64 = 0.0;
    for (log_ratio, v) in states {
        let size = v.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        let at = |n: usize, h: f64| {
            let (mut log_ratio, mut v) = (log_ratio, v);
            if n < 3 {
                v[n] += h;
            } else {
                log_ratio += h;
            }
            table().force_and_slopes(&Scales::of(log_ratio, nu), v)
        };
        let (found, slopes) = at(0, 0.0);
        let norm = slopes.iter().flatten().fold(0.0, |most: f64, s| most.max(s.abs()));
        for n in 0..4 {
            let h = if n < 3 { 1e-6 * size } else { 1e-6 };
            let (plus, minus) = (at(n, h), at(n, -h));
            for (k, slopes) in slopes.iter().enumerate() {
                let value = |f: &EllipseForce| if k < 3 { f.force[k] } else { f.slip_share };
                if k == 3 && !(1e-3..0.999).contains(&found.slip_share) {
                    continue;
                }
                let slope = (value(&plus.0) - value(&minus.0)) / (2.0 * h);
                let scale = if n < 3 { norm } else { norm.max(1.0) };
                let error = (slopes[n] - slope).abs() / scale;
                worst = worst.max(error);
                assert!(error < tolerance::TABLE_SLOPES, "{log_ratio} {v:?}, d{k}/d{n}: {error:e}");
                let jump = (plus.1[k][n] - minus.1[k][n]).abs() / scale;
                assert!(jump < 1e-3, "{log_ratio} {v:?}, d{k}/d{n} jumps by {jump:e}");
            }
        }
    }
    println!("derivatives against differences: {worst:e}");
}

#[test]
fn states_between_the_nodes_and_other_poissons_ratios_meet_boundary_elements() {
    let mut random = Random::new(5);
    for (nu, [most_mean, most_worst]) in [
        (0.28, tolerance::TABLE_BETWEEN),
        (0.0, tolerance::TABLE_POISSON),
        (0.5, tolerance::TABLE_POISSON),
    ] {
        let mut errors = Vec::new();
        for _ in 0..30 {
            let log_ratio = random.about(1.8);
            let ellipse = EllipseNodes::new(log_ratio, nu, [12, 18]);
            let v = random_creepage(&mut random).map(|v| 0.1 * v);
            let exact = ellipse.force(v).unwrap().force;
            let found = table().force(&Scales::of(log_ratio, nu), v).force;
            errors.push((found[0] - exact[0]).hypot(found[1] - exact[1]));
        }
        let [mean, p95, worst] = quantiles(errors);
        println!("ν = {nu}: mean {mean:.4}, 95 % {p95:.4}, worst {worst:.4}");
        assert!(mean <= most_mean && worst <= most_worst);
    }
}

#[test]
fn three_hundred_ellipses_roll_as_by_contact() {
    let data = read_table("contact_25_1/hertz_tangential.csv");
    let (mut forces, mut moments) = (Vec::new(), Vec::new());
    for row in &data.rows {
        let v = |name: &str| value(&data, row, name);
        let (a, b) = (v("a_mm"), v("b_mm"));
        let c = (a * b).sqrt();
        let limit = 0.3 * v("normal_force_n");
        let scale = 82e3 * c * c / limit;
        let creepage = [
            scale * v("creepage_longitudinal"),
            scale * v("creepage_lateral"),
            scale * c * v("spin_per_mm"),
        ];
        let found = table().force(&Scales::of((a / b).ln(), 0.28), creepage).force;
        forces.push((found[0] - v("fx_over_mu_n")).hypot(found[1] - v("fy_over_mu_n")));
        moments.push((found[2] - v("mz_44_nmm") / (limit * c)).abs());
    }
    let found = quantiles(forces);
    println!("300 ellipses: {found:.4?}, moment {:.4?}", quantiles(moments));
    for (found, most) in found.into_iter().zip(tolerance::TABLE_ELLIPSES) {
        assert!(found <= most);
    }
}

/// Points of a separation of the planar cases.
fn separation_of(name: &str) -> Vec<[f64; 2]> {
    let data = read_table(&format!("contact_25_1/planar/{name}.csv"));
    let row = |row| [1e-3 * value(&data, row, "y_mm"), 1e-3 * value(&data, row, "f_mm")];
    data.rows.iter().map(row).collect()
}

/// Errors of force over μ N and of moment over μ N c on real patches, all cases of CONTACT with 40
/// elements across.
fn planar_errors(data: &Table, base: &PlanarCase) -> [Vec<f64>; 2] {
    let mut errors = [Vec::new(), Vec::new()];
    let mut separation = (String::new(), Vec::new());
    for row in data.rows.iter().filter(|row| &row[column(data, "elements")] == "40") {
        let v = |name: &str| value(data, row, name);
        if separation.0 != row[0] {
            separation = (row[0].to_string(), separation_of(&row[0]));
        }
        let found = solve(&PlanarCase {
            separation: &separation.1,
            radius: 1e-3 * v("radius_mm"),
            indentation: Indentation::Approach(1e-3 * v("approach_mm")),
            creepage: [v("creepage_longitudinal"), v("creepage_lateral"), 1e3 * v("spin_per_mm")],
            ..*base
        })
        .unwrap();
        assert!(!found.fallback);
        let limit = 0.3 * v("normal_force_n");
        let c = (found.area / std::f64::consts::PI).sqrt();
        errors[0].push((found.fx - v("fx_n")).hypot(found.fy - v("fy_n")) / limit);
        errors[1].push((found.mz - 1e-3 * v("mz_nmm")).abs() / (limit * c));
    }
    errors
}

#[test]
fn real_patches_roll_as_by_contact() {
    let data = read_table("contact_25_1/planar_tangential.csv");
    let mut summary = Summary::new("table_profiles");
    for (model, most_force, most_moment) in [
        (TangentialModel::Tables, tolerance::TABLE_PROFILES, tolerance::TABLE_PROFILES_MOMENT),
        (
            TangentialModel::FastsimCorrected,
            tolerance::CORRECTED_PROFILES,
            tolerance::CORRECTED_PROFILES_MOMENT,
        ),
    ] {
        let base = PlanarCase {
            normal_model: NormalModel::Strips,
            tangential_model: model,
            strips: 25,
            elements_along: 25,
            wheel_material: STEEL,
            rail_material: STEEL,
            ..steel_case(&[], 0.46, 1e-4)
        };
        let errors = planar_errors(&data, &base);
        for (name, errors) in ["force", "moment"].into_iter().zip(&errors) {
            let title = format!("{model:?}: {name} [% of the limit]");
            summary.add(&title, errors.iter().map(|error| 100.0 * error), "");
        }
        let [forces, moments] = errors.map(quantiles);
        println!("{model:?}: force {forces:.4?}, moment {moments:.4?}");
        for (found, most) in forces.into_iter().zip(most_force) {
            assert!(found <= most, "{model:?}: {forces:?}");
        }
        assert!(moments[0] <= most_moment, "{model:?}: {moments:?}");
    }
    summary.write();
}
