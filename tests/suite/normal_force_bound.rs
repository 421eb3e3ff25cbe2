//! Whatever the outlines, the normal force stays within what the size of the contact can carry.
//!
//! A half-space that is pressed by δ somewhere, over a region of which no point is further away
//! than r, carries N ≤ π E* δ r: the displacement there is the integral of the pressure over the
//! distance, by π E*. Worn, kinked and yawed outlines, which fold, are those on which a quadrature
//! of that integral may go wrong.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use crate::common::random::Random;
use crate::common::wheel::rolling;
use tempfile::TempDir;
use wheelrail::element::output::Patch;
use wheelrail::element::parameters::NormalModel;
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::load_profile;
use wheelrail::material::{Material, MaterialPair};

/// What wear has taken off at a place of a profile, from the arc length along it [m].
type Depth = fn(f64) -> f64;

/// Distance along the scars after which they begin anew, and their greatest depth [m].
const PITCH: f64 = 3e-3;
const DEEPEST: f64 = 4e-4;

/// How far along its pitch a place lies, -1 to 1.
fn share(s: f64) -> f64 {
    2.0 * (s / PITCH).fract() - 1.0
}

/// Grooves side by side, with the sharp edges that wear in a narrow patch leaves.
fn grooves(s: f64) -> f64 {
    DEEPEST * (1.0 - share(s).powi(2)).max(0.0)
}

/// Facets as a grinding stone leaves them.
fn facets(s: f64) -> f64 {
    0.3 * DEEPEST * (1.0 - share(s).abs())
}

/// Steps of a twentieth of a millimetre.
fn steps(s: f64) -> f64 {
    if share(s) > 0.0 { 5e-5 } else { 0.0 }
}

fn unworn(_: f64) -> f64 {
    0.0
}

/// Writes the profile `name` with `depth` taken off along its normal, from flank to tread of a
/// wheel and over the head of a rail.
fn write_worn(path: &Path, name: &str, kind: ProfileKind, depth: Depth) {
    let curve = load_profile("profile", name, kind, 0.0, &[]).unwrap().curve;
    let mut text = String::from("# smoothing_mm 0\ny_mm,z_mm\n");
    let count = 2000;
    for i in 0..=count {
        let s = curve.start() + f64::from(i) / f64::from(count) * (curve.end() - curve.start());
        let p = curve.at(s);
        let ([y, z], [ty, tz]) = (p.point, p.first);
        // Out of the wheel is down, out of the rail is up.
        let into = if kind == ProfileKind::Wheel { [tz, -ty] } else { [-tz, ty] };
        let is_worn = match kind {
            ProfileKind::Wheel => y > -0.046 && y < 0.03 && ty > 0.1,
            ProfileKind::Rail => y.abs() < 0.033 && ty > 0.1,
        };
        let off = if is_worn { depth(s - curve.start()) } else { 0.0 };
        writeln!(text, "{:.7},{:.7}", 1e3 * (y + off * into[0]), 1e3 * (z + off * into[1]))
            .unwrap();
    }
    fs::write(path, text).unwrap();
}

/// Greatest distance between any two points of the patches [m].
fn extent(patches: &[Patch]) -> f64 {
    let mut extent = 0.0f64;
    for a in patches {
        for b in patches {
            let apart: f64 = (0..3).map(|i| (a.position[i] - b.position[i]).powi(2)).sum();
            let own = [a, b].map(|p| 0.5 * p.length.hypot(p.width));
            extent = extent.max(apart.sqrt() + own[0] + own[1]);
        }
    }
    extent
}

/// The greatest normal force over E* δ times the extent of the contact, over random poses with
/// outlines worn by `wheel` and `rail`.
fn greatest_share(model: NormalModel, wheel: Depth, rail: Depth, poses: usize) -> (f64, Input) {
    let folder: TempDir = tempfile::tempdir().unwrap();
    write_worn(&folder.path().join("wheel.csv"), "S1002", ProfileKind::Wheel, wheel);
    write_worn(&folder.path().join("rail.csv"), "60E1", ProfileKind::Rail, rail);
    let mut parameters = Parameters { normal_model: model, ..Parameters::default() };
    parameters.damping = 0.0;
    parameters.normal_elements = [12, 12];
    parameters.wheel.profile = "wheel.csv".into();
    parameters.rails[0].profile = "rail.csv".into();
    let folders = [folder.path().to_owned()];
    let mut element = Element::new(&parameters, &Input::default(), &folders).unwrap();
    let steel = Material { young_modulus: 2.1e11, poisson_ratio: 0.28 };
    let modulus = MaterialPair::new(steel, steel).contact_modulus;
    let mut random = Random::new(19);
    let (mut worst, mut worst_input) = (0.0, Input::default());
    for _ in 0..poses {
        // From the flank, 76 degrees steep and yawed until its outline folds, to the field side.
        let mut input = rolling(random.within(-2e-3, 9e-3), 0.0);
        input.wheel.yaw = random.about(0.04);
        input.wheel.roll = random.about(0.01);
        input.friction = 0.0;
        let depth = 10f64.powf(random.within(-7.0, -3.7));
        input.wheel.position[2] = element.touching_height(&input) + depth;
        let mut output = Output::default();
        element.evaluate(&input, &mut output).unwrap();
        let count = usize::try_from(output.patch_count).unwrap();
        let patches = &output.patches[..count.min(output.patches.len())];
        let force: f64 = patches.iter().map(|p| p.normal_force).sum();
        let deepest = patches.iter().map(|p| p.penetration).fold(0.0, f64::max);
        let share = force / (modulus * deepest * extent(patches));
        if share > worst {
            (worst, worst_input) = (share, input);
        }
    }
    (worst, worst_input)
}

#[test]
fn the_normal_force_is_bounded_by_modulus_penetration_and_size() {
    use NormalModel::{BoundaryElement, Hertz, PiotrowskiKik, PiotrowskiKikCorrected, Strips};
    let outlines: [(&str, Depth, Depth); 4] = [
        ("unworn", unworn, unworn),
        ("grooves", grooves, unworn),
        ("facets", facets, facets),
        ("steps", steps, grooves),
    ];
    let models = [
        (Hertz, 60),
        (PiotrowskiKik, 400),
        (PiotrowskiKikCorrected, 200),
        (Strips, 15),
        (BoundaryElement, 10),
    ];
    for (name, wheel, rail) in outlines {
        for (model, poses) in models {
            let (worst, input) = greatest_share(model, wheel, rail, poses);
            println!("{name}, {model:?}: {worst:.3} E* δ size");
            if std::env::var_os("ALL").is_none() {
                assert!(worst <= std::f64::consts::PI, "{name}, {model:?}: {worst} at {input:?}");
            }
        }
    }
}
