//! Strips of least energy: against Hertz and CONTACT, their number of steps, and overlaps that join.

use crate::common;
use crate::common::planar::{HertzRow, steel_modulus};
use crate::common::summary::Summary;
use crate::common::{median_and_worst, read_table, value};
use crate::tolerance;
use wheelrail::geometry::contacts::separation::{Probe, Separation, SeparationPoint};
use wheelrail::geometry::curve::{Curve, Knot};
use wheelrail::math::quadrature::GaussLegendre;
use wheelrail::math::root::bracketed;
use wheelrail::math::spline::{SplineEnd, interpolating_slopes};
use wheelrail::normal::least_energy::{StripSolver, solve_in_frame};
use wheelrail::normal::{NormalProblem, Strips};

/// A separation f(y) as a cubic spline.
struct Planar(Curve);

impl Planar {
    fn through(points: &[[f64; 2]]) -> Self {
        let y: Vec<f64> = points.iter().map(|p| p[0]).collect();
        let f: Vec<f64> = points.iter().map(|p| p[1]).collect();
        let slopes = interpolating_slopes(&y, &f, [SplineEnd::Natural; 2]);
        let knots =
            (0..y.len()).map(|i| Knot { s: y[i], point: [y[i], f[i]], tangent: [1.0, slopes[i]] });
        Self(Curve::through(&knots.collect::<Vec<Knot>>()))
    }

    /// Knots, and places of least and greatest f between them.
    fn probes(&self) -> Vec<Probe> {
        let at = |u: f64| Probe { u, f: self.0.at(u).point[1] };
        let knots: Vec<f64> = self.0.knots().collect();
        let mut probes = vec![at(knots[0])];
        for pair in knots.windows(2) {
            let slope = |u: f64| self.0.at(u).first[1];
            let [a, b] = [slope(pair[0]), slope(pair[1].next_down())];
            if a * b < 0.0 {
                probes.push(at(bracketed((pair[0], a), (pair[1], b), 1e-15, slope)));
            }
            probes.push(at(pair[1]));
        }
        probes
    }
}

impl Separation for Planar {
    fn at(&mut self, u: f64) -> SeparationPoint {
        SeparationPoint { y: u, dy: 1.0, f: self.0.at(u).point[1], x: 0.0 }
    }

    fn with_slope(&mut self, u: f64) -> (SeparationPoint, f64) {
        (Separation::at(self, u), self.0.at(u).first[1])
    }
}

/// The zones of `line` under an `approach` counted from f = 0.
fn press(solver: &mut StripSolver, line: &mut Planar, radius: f64, approach: f64) -> Strips {
    let mut strips = Strips::with_capacity(8, 2000);
    let rule = GaussLegendre::new(8);
    let problem = NormalProblem {
        approach,
        radius,
        contact_modulus: steel_modulus(),
        contact_u: 0.0,
        lateral_curvature: 0.0,
        rule: &rule,
        elements: [1, 1],
    };
    let probes = line.probes();
    assert_eq!(solve_in_frame(solver, &problem, line, &probes, &mut strips), 0);
    strips
}

/// Errors of normal force, greatest pressure and area on all planar problems [%].
fn planar_errors(solver: &mut StripSolver) -> [Vec<f64>; 3] {
    let table = read_table("contact_25_1/planar_normal.csv");
    let mut errors = [const { Vec::new() }; 3];
    for row in &table.rows {
        let v = |name: &str| value(&table, row, name);
        let name = &row[common::column(&table, "case")];
        let points = read_table(&format!("contact_25_1/planar/{name}.csv"));
        let points: Vec<[f64; 2]> = points
            .rows
            .iter()
            .map(|row| [0, 1].map(|i| 1e-3 * row[i].parse::<f64>().unwrap()))
            .collect();
        let mut line = Planar::through(&points);
        let radius = 1e-3 * v("radius_mm");
        let strips = press(solver, &mut line, radius, 1e-3 * v("approach_mm"));
        let pressure = strips.zones.iter().map(|zone| zone.max_pressure).fold(0.0, f64::max);
        let area: f64 = strips.zones.iter().map(|zone| zone.area).sum();
        let wanted =
            [v("normal_force_n"), 1e6 * v("max_pressure_mpa"), 1e-6 * v("area_extrapolated_mm2")];
        for ((errors, found), wanted) in
            errors.iter_mut().zip([strips.load(), pressure, area]).zip(wanted)
        {
            errors.push(100.0 * (found / wanted - 1.0).abs());
        }
    }
    errors
}

#[test]
fn planar_problems_agree_with_contact() {
    let mut summary = Summary::new("planar_strips");
    for (strips, bounds, name) in
        [(15, tolerance::PLANAR_15, "PLANAR_15"), (40, tolerance::PLANAR_40, "PLANAR_40")]
    {
        let mut solver = StripSolver::new(strips);
        let targets = tolerance::targets(name);
        let errors = planar_errors(&mut solver);
        for (((errors, [median, worst]), target), name) in
            errors.into_iter().zip(bounds).zip(targets.chunks(2)).zip(["N", "p_max", "area"])
        {
            let aim = format!("{} / - / {}", target[0], target[1]);
            summary.add(&format!("{name} [%], {strips} strips"), errors.clone(), &aim);
            let [found, most] = median_and_worst(errors);
            assert!(found <= median && most <= worst, "{strips}, {name}: {found} {most}");
        }
        assert_eq!(solver.work.unsettled, 0);
        assert!(solver.work.most_steps <= tolerance::PLANAR_STEPS, "{:?}", solver.work);
    }
    summary.write();
}

#[test]
fn every_admitted_number_of_strips_has_a_solution_near_that_of_hertz() {
    for ratio in [0.2, 1.0, 5.0] {
        let row = HertzRow::with_ratio(ratio);
        let mut line = Planar::through(&row.separation());
        for count in (8..=40).chain([60, 100, 150, 200]) {
            let mut solver = StripSolver::new(count);
            let strips = press(&mut solver, &mut line, 0.5 / row.along, row.approach);
            assert_eq!(solver.work.unsettled, 0, "{count} strips, a/b {ratio}");
            let error = strips.load() / row.load - 1.0;
            assert!(error.abs() < 0.02, "{count} strips, a/b {ratio}: {error}");
        }
    }
}

#[test]
fn two_overlaps_join_and_part_without_a_jump() {
    // Two parabolas 8 mm apart, which touch at 0 and at 20 µm and overlap as one from 53 µm on.
    let lift = 2e-5;
    let points: Vec<[f64; 2]> = (-120..=120)
        .map(|i| 1.25e-4 * f64::from(i))
        .map(|y| {
            let [a, b] = [(y + 4e-3f64).powi(2) / 0.3, (y - 4e-3).powi(2) / 0.3 + lift];
            // A smooth least of both.
            let soft = 2e-6;
            [y, -soft * ((-a / soft).exp() + (-b / soft).exp()).ln()]
        })
        .collect();
    let mut solver = StripSolver::new(20);
    let mut line = Planar::through(&points);
    let loads: Vec<f64> = (0..=600)
        .map(|k| press(&mut solver, &mut line, 0.46, 3e-5 + 1e-7 * f64::from(k)).load())
        .collect();
    for (k, three) in loads.windows(3).enumerate() {
        let (rise, bend) = (three[2] - three[0], three[2] - 2.0 * three[1] + three[0]);
        assert!(rise > 0.0);
        // A jump would be one of the load, and not of the order of the change over a step.
        assert!(bend.abs() < tolerance::JOINING_BEND * rise, "step {k}: {three:?}");
    }
    assert_eq!(solver.work.unsettled, 0);
}
