//! Piotrowski and Kik, Vehicle System Dynamics 46 (2008) 27-48: the printed results of the normal
//! problem, and the correction of the shape of the contact area.

use crate::common::planar::{HertzRow, steel_case};
use crate::tolerance;
use approx::assert_relative_eq;
use wheelrail::element::parameters::{
    Flexibilities, NormalModel, ShapeFit, TangentialModel, TractionBound,
};
use wheelrail::geometry::contacts::separation::{Probe, Separation, SeparationPoint};
use wheelrail::material::{Material, MaterialPair};
use wheelrail::math::quadrature::GaussLegendre;
use wheelrail::normal::{self, NormalProblem, Strips};
use wheelrail::planar::{PlanarCase, solve};
use wheelrail::tangential::{Creepage, RollingState, Settings, Tangential};

/// A separation that gives the printed results of table 1: a power of y on either side of the
/// contact point, with a cusp that no spline carries. It is not the authors' curve.
struct Table1;

const VIRTUAL_PENETRATION: f64 = 0.55;
const APPROACH: f64 = 1e-4;
const WIDTH: f64 = 24.4e-3;

impl Separation for Table1 {
    fn at(&mut self, u: f64) -> SeparationPoint {
        let (width, power) =
            if u < 0.0 { (0.2121 * WIDTH, 3.4116) } else { (0.7879 * WIDTH, 0.5686) };
        let (t, q) = (u.abs() / width, 0.2842);
        let f = VIRTUAL_PENETRATION * APPROACH * ((1.0 - q) * t.powf(power) + q * t.powi(12));
        SeparationPoint { y: u, dy: 1.0, f, x: 0.0 }
    }
}

/// L, W [mm], area [mm²], N [kN], p [MPa], and the creep forces on the wheel [kN].
fn table_1(model: NormalModel, fit: ShapeFit) -> ([f64; 5], [f64; 2]) {
    let probes = [-0.01, 0.0, 0.03].map(|u| Probe { u, f: Table1.at(u).f });
    let steel = Material { young_modulus: 2.1e11, poisson_ratio: 0.3 };
    // Many strips for the cusp.
    let rule = GaussLegendre::new(1000);
    let problem = NormalProblem {
        approach: APPROACH,
        radius: 0.3,
        contact_modulus: MaterialPair::new(steel, steel).contact_modulus,
        contact_u: 0.0,
        lateral_curvature: 0.0,
        rule: &rule,
        elements: [1; 2],
    };
    let mut strips = Strips::with_capacity(1, rule.nodes.len());
    let (epsilon, separation) = (VIRTUAL_PENETRATION, &mut Table1);
    let left_out = normal::solve(model, epsilon, fit, &problem, separation, &probes, &mut strips);
    assert_eq!((left_out, strips.zones.len()), (0, 1));
    let zone = strips.zones[0];
    assert_relative_eq!(strips.width.iter().sum::<f64>(), zone.width, max_relative = 1e-12);
    // νx = 0.002, νy = 0, φ = 0.001 1/mm and f = 0.4, given at the contact point; FASTSIM with
    // Kalker's three flexibilities.
    let (longitudinal, spin) = (0.002, 1.0);
    let creepage = Creepage { longitudinal: longitudinal - spin * zone.y, lateral: 0.0, spin };
    let state =
        RollingState { creepage, forward_share: 1.0, friction: 0.4, load_factor: 1.0, speed: 1.0 };
    let settings = Settings {
        flexibilities: Flexibilities::Three,
        bound: TractionBound::Elliptic,
        elements_along: 100,
        elements: [1; 2],
        strips: 1,
    };
    let mut fastsim = Tangential::new(TangentialModel::Fastsim, &settings);
    let pair = MaterialPair::new(steel, steel);
    let force = fastsim.creep_force(&zone, &strips, &pair, &state).unwrap();
    let normal = [
        1e3 * zone.length,
        1e3 * zone.width,
        1e6 * zone.area,
        1e-3 * zone.load,
        1e-6 * zone.max_pressure,
    ];
    (normal, [1e-3 * force.longitudinal, 1e-3 * force.lateral])
}

#[test]
fn table_1_of_the_paper_comes_out() {
    let uncorrected = [11.5, 24.4, 208.5, 134.3, 1045.0];
    let corrected = [10.2, 27.6, 208.5, 136.6, 1063.0];
    let cases = [
        (NormalModel::PiotrowskiKik, ShapeFit::Hertz, uncorrected),
        (NormalModel::PiotrowskiKikCorrected, ShapeFit::Hertz, corrected),
        (NormalModel::PiotrowskiKikCorrected, ShapeFit::Paper, corrected),
    ];
    for (model, fit, printed) in cases {
        let (found, [fx, fy]) = table_1(model, fit);
        println!("{model:?} {fit:?}: {found:.3?}");
        // The separation has the normal solution of the paper and not its moments, so that these
        // are not judged.
        println!("    Fx {fx:.1}, Fy {fy:.1} kN, together {:.1} kN", fx.hypot(fy));
        for (found, printed) in found.into_iter().zip(printed) {
            assert_relative_eq!(found, printed, max_relative = tolerance::PAPER_TABLE_1);
        }
        if model == NormalModel::PiotrowskiKikCorrected {
            // Rc = Lc²/(8 δ0)
            let radius = found[0].powi(2) / (8.0 * 1e3 * VIRTUAL_PENETRATION * APPROACH);
            assert_relative_eq!(radius, 235.5, max_relative = tolerance::PAPER_TABLE_1);
        }
    }
}

fn corrected<'a>(case: &PlanarCase<'a>) -> PlanarCase<'a> {
    PlanarCase { normal_model: NormalModel::PiotrowskiKikCorrected, strips: 40, ..*case }
}

#[test]
fn the_corrected_area_of_hertzian_bodies_has_the_ratio_of_the_hertzian_ellipse() {
    // Greatest error of force and pressure against Hertz, before and after.
    let mut errors = [[0.0f64; 2]; 2];
    for row in HertzRow::all() {
        let separation = row.separation();
        let plain = steel_case(&separation, 0.5 / row.along, row.approach);
        let plain = PlanarCase { normal_model: NormalModel::PiotrowskiKik, strips: 40, ..plain };
        let (before, after) = (solve(&plain).unwrap(), solve(&corrected(&plain)).unwrap());
        let ratio = after.length / after.width;
        assert_relative_eq!(ratio, row.axis_ratio, max_relative = tolerance::CORRECTED_RATIO);
        assert_relative_eq!(after.area, before.area, max_relative = tolerance::ROUNDING);
        for (errors, result) in errors.iter_mut().zip([before, after]) {
            errors[0] = errors[0].max((result.normal_force / row.load - 1.0).abs());
            errors[1] = errors[1].max((result.max_pressure / row.max_pressure - 1.0).abs());
        }
    }
    let [before, after] = errors;
    println!("worst of N and p: {before:.3?} before, {after:.3?} after");
    assert!(after[1] < tolerance::CORRECTED_PRESSURE && before[1] > after[1]);
    assert!(after[0] < tolerance::CORRECTED_FORCE);
}

/// Normal force of two dents 5 mm apart, one `lower` than the other, with a ridge of `ridge`
/// between them [m].
fn two_dents(lower: f64, ridge: f64) -> (f64, usize) {
    let points: Vec<[f64; 2]> = (-120..=240)
        .map(|i| {
            let y = 5e-5 * f64::from(i);
            let t = y / 5e-3;
            // Zero at the first dent, `lower` at the second.
            let f = 16.0 * ridge * (t * (1.0 - t)).powi(2) + lower * t * t * (3.0 - 2.0 * t);
            [y, f.max(0.0) + if t > 1.0 { 1e-4 * (t - 1.0).powi(2) } else { 0.0 }]
        })
        .collect();
    let result = solve(&corrected(&steel_case(&points, 0.46, 6e-5))).unwrap();
    (result.normal_force, result.patches)
}

/// Greatest change from step to step, over the mean force, and the numbers of zones seen.
fn greatest_step(steps: i32, case: impl Fn(f64) -> (f64, usize)) -> (f64, Vec<usize>) {
    let all: Vec<(f64, usize)> =
        (0..=steps).map(|i| case(f64::from(i) / f64::from(steps))).collect();
    let jump = all.windows(2).map(|w| (w[1].0 - w[0].0).abs() / w[0].0).fold(0.0, f64::max);
    let mut zones: Vec<usize> = all.iter().map(|one| one.1).collect();
    zones.dedup();
    (jump, zones)
}

#[test]
fn the_corrected_force_is_continuous_where_zones_appear_and_where_they_merge() {
    // The virtual penetration is 33 µm.
    let appearing = |s: f64| two_dents(4e-5 - 2e-5 * s, 1e-4);
    let merging = |s: f64| two_dents(5e-6, 5e-5 - 4e-5 * s);
    for case in [&appearing as &dyn Fn(f64) -> (f64, usize), &merging] {
        let (coarse, zones) = greatest_step(50, case);
        let (fine, _) = greatest_step(800, case);
        println!("{coarse:e} {fine:e} {zones:?}");
        assert_eq!(zones.iter().max(), Some(&2));
        assert_eq!(zones.iter().min(), Some(&1));
        assert!(fine < tolerance::SHRINKING * coarse, "{fine} after {coarse}");
    }
}

#[test]
fn the_corrected_force_is_smooth_where_length_and_width_are_equal() {
    // Round at R = 0.3 m.
    let force = |radius: f64| {
        let points: Vec<[f64; 2]> =
            (-60..=60).map(|i| 1e-4 * f64::from(i)).map(|y| [y, 0.5 * y * y / 0.3]).collect();
        solve(&corrected(&steel_case(&points, radius, 6e-5))).unwrap().normal_force
    };
    let slope = |radius: f64| (force(radius + 1e-5) - force(radius - 1e-5)) / 2e-5;
    let [below, at, above] = [0.2995, 0.3, 0.3005].map(slope);
    assert_relative_eq!(at, 0.5 * (below + above), max_relative = 1e-3);
}

/// An outline that folds, as that of a yawed wheel with a groove worn into its flank: behind the
/// edge of the groove it turns `back` [m], over `gap` [m] of its parameter, and comes forward
/// again. Only what lies outside of the crossing is loaded.
struct Folded {
    gap: f64,
    back: f64,
}

/// Relative curvatures to the left and to the right of the contact point [1/m], and where the first
/// one ends and the second one begins to be outside [m].
const FOLDED_CURVATURES: [f64; 2] = [250.0, 10.0];
const FIRST_BRANCH: f64 = 5.5e-4;
const CROSSING: f64 = 4.5e-4;

impl Separation for Folded {
    fn at(&mut self, u: f64) -> SeparationPoint {
        let parabola = |y: f64| 0.5 * FOLDED_CURVATURES[usize::from(y > 0.0)] * y * y;
        let fold = (u - FIRST_BRANCH) / self.gap;
        let (y, dy, f) = if fold < 0.0 {
            (u, 1.0, parabola(u))
        } else if fold < 1.0 {
            (FIRST_BRANCH - self.back * fold, 0.15, f64::INFINITY)
        } else {
            let y = u - self.gap - self.back;
            (y, 1.0, if y > CROSSING { parabola(y) } else { 1e-4 })
        };
        SeparationPoint { y, dy, f, x: 0.0 }
    }
}

#[test]
fn the_force_on_an_outline_that_folds_is_bounded_by_what_the_size_of_the_contact_carries() {
    let steel = Material { young_modulus: 2.1e11, poisson_ratio: 0.3 };
    let contact_modulus = MaterialPair::new(steel, steel).contact_modulus;
    let rule = GaussLegendre::new(12);
    let (mut worst, mut least) = (0f64, f64::INFINITY);
    for model in [NormalModel::PiotrowskiKik, NormalModel::PiotrowskiKikCorrected] {
        for i in 0..=60 {
            for j in 0..=30 {
                let (gap, back) = (5e-4 * f64::from(i) / 60.0 + 1e-6, 6e-4 * f64::from(j) / 30.0);
                let mut folded = Folded { gap, back };
                let end = FIRST_BRANCH + gap + back + 1.5e-3;
                let probes = [-2e-3, 0.0, end].map(|u| Probe { u, f: folded.at(u).f });
                let problem = NormalProblem {
                    approach: 8e-6,
                    radius: 0.95,
                    contact_modulus,
                    contact_u: 0.0,
                    lateral_curvature: FOLDED_CURVATURES[1],
                    rule: &rule,
                    elements: [1; 2],
                };
                let mut strips = Strips::with_capacity(1, rule.nodes.len());
                let fit = ShapeFit::Hertz;
                let left_out =
                    normal::solve(model, 0.55, fit, &problem, &mut folded, &probes, &mut strips);
                assert_eq!(left_out, 0, "{model:?}, fold of {gap} back by {back}");
                let furthest = strips.half_length.iter().zip(strips.y.iter());
                let furthest = furthest.map(|(a, y)| a.hypot(*y)).fold(0.0, f64::max);
                let most = std::f64::consts::PI * contact_modulus * problem.approach * furthest;
                (worst, least) = (worst.max(strips.load() / most), least.min(strips.load() / most));
            }
        }
    }
    println!("force over its bound: {least} to {worst}");
    assert!(worst <= 1.0 && least > 0.0, "{least} to {worst}");
}
