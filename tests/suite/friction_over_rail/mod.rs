//! Friction over the surface of a rail and along the track: tables, regions, with every model.

mod contact_program;
mod laws;

use crate::tolerance;
use std::fmt::Write;
use std::path::PathBuf;

use crate::common::random::Random;
use crate::common::summary::Summary;
use crate::common::wheel::{
    FRICTION_TABLES, benchmark, element, evaluate, mirrored, of_wheelset, pressed, random_input,
    rolling,
};
use crate::common::{median_and_worst, read_table, value, write_report};
use approx::assert_relative_eq;
use tempfile::TempDir;
use wheelrail::element::input::INPUT_NAMES;
use wheelrail::element::parameters::{
    Changeover, CreepageModel, FallingLaw, FrictionDistribution, FrictionLaw, NormalModel, Side,
    TangentialModel, VerticalMode,
};
use wheelrail::element::{Element, Input, Output, Parameters};

/// A folder with tables of friction.
struct Tables(TempDir);

impl Tables {
    fn new(files: &[(&str, &str)]) -> Self {
        let folder = TempDir::new().unwrap();
        for (name, text) in files {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        Self(folder)
    }

    fn folders(&self) -> Vec<PathBuf> {
        vec![self.0.path().into()]
    }

    fn element(&self, parameters: &Parameters) -> Element {
        Element::new(parameters, &Input::default(), &self.folders()).unwrap()
    }
}

fn with_table(name: &str, parameters: Parameters) -> Parameters {
    Parameters {
        friction_distribution: FrictionDistribution::Profile,
        friction_profile: name.into(),
        ..parameters
    }
}

fn regions(parameters: Parameters) -> Parameters {
    Parameters { friction_distribution: FrictionDistribution::Regions, ..parameters }
}

const FALLING: FrictionLaw = FrictionLaw {
    falling_law: FallingLaw::Rational,
    falling_share: 0.4,
    falling_decay: 0.6,
    reduction: 0.6,
    reduction_share: 0.3,
    reduction_decay: 0.5,
};

/// Normal and tangential models that go together, and how the creepage varies.
fn models() -> Vec<Parameters> {
    let normal_models = [
        NormalModel::Strips,
        NormalModel::Hertz,
        NormalModel::PiotrowskiKik,
        NormalModel::PiotrowskiKikCorrected,
    ];
    let tangential_models = [
        TangentialModel::FastsimCorrected,
        TangentialModel::Fastsim,
        TangentialModel::Fastrip,
        TangentialModel::Tables,
    ];
    let mut all = Vec::new();
    for normal_model in normal_models {
        for tangential_model in tangential_models {
            for creepage_model in [CreepageModel::Flat, CreepageModel::Curved] {
                let plain = Parameters::default();
                let own = Parameters { normal_model, tangential_model, creepage_model, ..plain };
                all.push(own);
            }
        }
    }
    all
}

/// Boundary elements for the tractions, on their own pressure and on that of strips.
fn boundary_elements() -> [Parameters; 2] {
    [NormalModel::BoundaryElement, NormalModel::Strips].map(|normal_model| Parameters {
        normal_model,
        tangential_model: TangentialModel::BoundaryElement,
        normal_elements: [12, 12],
        ..Parameters::default()
    })
}

#[test]
fn a_constant_table_and_equal_regions_give_constant_friction_bit_for_bit() {
    let tables = Tables::new(&[
        ("inclination.csv", "inclination_deg friction\n-50 0.31\n-20.5 0.31\n-3 0.31\n9 0.31\n"),
        (
            "place.csv",
            "station_m place_mm friction\n0 -20 0.31\n0 3 0.31\n7 1 0.31\n90 -9 0.31\n90 9 0.31\n",
        ),
    ]);
    let laws = [FrictionLaw::default(), FALLING];
    for (i, base) in models().into_iter().chain(boundary_elements()).enumerate() {
        let law = laws[i / 3 % 2];
        let base = Parameters { friction_law: law, gauge_face_law: law, ..base };
        let mut plain = tables.element(&base);
        let mut others = vec![
            tables.element(&with_table("inclination.csv", base.clone())),
            tables.element(&with_table("place.csv", base.clone())),
            tables.element(&regions(base.clone())),
        ];
        let mut random = Random::new(5 + i as u64);
        for _ in 0..3 {
            let mut input = random_input(&mut plain, &mut random);
            input.track_s = random.about(100.0);
            (input.friction, input.tread_friction, input.gauge_face_friction) = (0.31, 0.31, 0.31);
            let expected = evaluate(&mut plain, &input);
            for other in &mut others {
                assert_eq!(evaluate(other, &input), expected, "{base:?}\n{input:?}");
            }
        }
    }
}

#[test]
fn regions_are_a_table_of_two_inclinations() {
    let tables = Tables::new(&[("two.csv", "inclination_deg,friction\n-24,0.12\n-4,0.42\n")]);
    let changeover = Changeover { inclination: -14f64.to_radians(), width: 20f64.to_radians() };
    for base in models() {
        let base = Parameters { friction_changeover: changeover, ..base };
        let mut table = tables.element(&with_table("two.csv", base.clone()));
        let mut two = tables.element(&regions(base.clone()));
        let mut random = Random::new(11);
        for _ in 0..4 {
            let mut input = random_input(&mut two, &mut random);
            (input.tread_friction, input.gauge_face_friction) = (0.42, 0.12);
            let [a, b] = [&mut table, &mut two].map(|element| evaluate(element, &input));
            for c in 0..3 {
                let limit = 1e-9 * a.wheel.force[2].abs().max(1.0);
                assert_relative_eq!(a.wheel.force[c], b.wheel.force[c], epsilon = limit);
            }
        }
    }
}

/// A wheel between tread and gauge corner that slides along the track.
fn sliding() -> Input {
    let mut input = rolling(5.4e-3, 20.0);
    input.wheel.pitch_rate *= 1.5;
    input
}

#[test]
fn a_sliding_patch_has_the_friction_of_each_of_its_strips() {
    // Friction is linear in the place from 15 to 60 mm beside the top, and so is the force of a
    // patch that slides as a whole.
    let (a, b) = (0.2, 0.005);
    let line = |slope: f64| {
        format!("place_mm friction\n-60 {}\n15 {}\n", a - slope * -60.0, a - slope * 15.0)
    };
    let tables = Tables::new(&[("none.csv", &line(0.0)), ("rising.csv", &line(b))]);
    for base in models().into_iter().chain(boundary_elements()) {
        if base.tangential_model == TangentialModel::Tables
            || base.normal_model == NormalModel::Hertz
        {
            continue;
        }
        let base = Parameters { creepage_model: CreepageModel::Kinematic, ..base };
        let mut even = tables.element(&with_table("none.csv", base.clone()));
        let mut rising = tables.element(&with_table("rising.csv", base.clone()));
        let input = pressed(&mut even, &sliding(), 8e-5);
        // The pressure of strips goes on 12 rows of elements, which are as good as a sum of
        // trapezia.
        let on_rows = base.normal_model == NormalModel::Strips
            && base.tangential_model == TangentialModel::BoundaryElement;
        let within = if on_rows { 1.0 / 144.0 } else { tolerance::FULL_SLIDING };
        let [even, rising] = [&mut even, &mut rising].map(|element| evaluate(element, &input));
        assert!(even.patch_count >= 1);
        for (even, rising) in
            even.patches.iter().zip(&rising.patches).take(even.patch_count as usize)
        {
            let coefficient = even.creep_force[0].abs() / even.normal_force;
            assert_relative_eq!(coefficient, a, max_relative = tolerance::FULL_SLIDING);
            for patch in [even, rising] {
                let held = patch.creep_force[0].abs() / patch.normal_force;
                let told = patch.friction_coefficient;
                assert_relative_eq!(told, held, max_relative = within);
            }
            let more = rising.creep_force[0].abs() / rising.normal_force - coefficient;
            // Towards the gauge face it rises; the patch is there.
            assert!(more > 0.03, "{more}");
            // The moment is that of friction that rises across: the even patch has its force at the
            // centroid of the load.
            let lean = rising.spin_moment - even.spin_moment * (1.0 + more / coefficient);
            // Of a semi-elliptic load per width.
            let expected = 1e3 * b * even.normal_force * even.width.powi(2) / 20.0;
            let ratio = lean.abs() / expected;
            assert!(ratio > 0.3 && ratio < 3.0, "{lean} {expected}");
        }
    }
}

#[test]
fn a_left_wheel_has_the_friction_of_the_mirrored_right_one() {
    let tables = Tables::new(&[("table.csv", "inclination_deg friction\n-24 0.12\n-1 0.42\n")]);
    let base = with_table("table.csv", Parameters::default());
    let mut right = tables.element(&base);
    let left = base.on_side(Side::Left);
    let start = mirrored(&Input::default());
    let mut left = Element::new(&left, &start, &tables.folders()).unwrap();
    let mut random = Random::new(31);
    for _ in 0..20 {
        let input = random_input(&mut right, &mut random);
        let [a, b] = [evaluate(&mut right, &input), evaluate(&mut left, &mirrored(&input))];
        assert_eq!(a.wheel.force[0].to_bits(), b.wheel.force[0].to_bits());
        assert_eq!(a.wheel.force[1].to_bits(), (-b.wheel.force[1]).to_bits());
    }
}

#[test]
fn each_rail_has_its_rows() {
    let tables =
        Tables::new(&[("rails.csv", "rail inclination_deg friction\n1 -24 0.2\n2 -24 0.0\n")]);
    let mut base = with_table("rails.csv", Parameters::default());
    let one = tables.element(&base);
    assert!(one.profile_remarks().is_empty());
    base.rails[1].enabled = true;
    let mut both = tables.element(&base);
    // The flange back on the check rail, the wheel lifted from the rail.
    let mut input = rolling(0.0, 20.0);
    input.wheel.position[1] += 6e-3;
    input.wheel.position[2] = both.touching_height(&input) + 2e-4;
    input.wheel.pitch_rate *= 1.1;
    let output = evaluate(&mut both, &input);
    let [first, second] = [1, 2].map(|rail| {
        let own = output.patches[..output.patch_count as usize].iter();
        own.filter(|patch| patch.rail == rail).map(|patch| patch.creep_force[0].abs()).sum::<f64>()
    });
    assert!(first > 1e3 && second == 0.0, "{first} {second}");
}

/// Force of all bodies and frictional power.
fn results(output: &Output) -> [f64; 7] {
    let ([fx, fy, fz], [mx, my, mz]) = (output.wheel.force, output.wheel.moment);
    [fx, fy, fz, mx, my, mz, output.frictional_power]
}

#[test]
fn forces_are_continuous_where_a_patch_moves_across_a_change_of_friction() {
    let tables = Tables::new(&[
        ("inclination.csv", "inclination_deg friction\n-9 0.1\n-6 0.5\n"),
        ("place.csv", "place_mm friction\n-14.5 0.1\n-14 0.5\n"),
        (
            "station.csv",
            "station_m inclination_deg friction\n0 -9 0.1\n0 -6 0.5\n0.01 -9 0.4\n0.01 -6 0.05\n",
        ),
    ]);
    let changes = |element: &mut Element, steps: i32| {
        let mut greatest = 0.0_f64;
        let mut before: Option<[f64; 7]> = None;
        for i in 0..=steps {
            let share = f64::from(i) / f64::from(steps);
            let mut input = rolling(3.2e-3 + 1e-3 * share, 20.0);
            input.wheel.position[2] = -0.46 + 3e-4;
            input.wheel.velocity[1] = 0.05;
            input.wheel.pitch_rate *= 1.003;
            input.track_s = 0.02 * share - 0.005;
            (input.tread_friction, input.gauge_face_friction) = (0.5, 0.1);
            let found = results(&evaluate(element, &input));
            if let Some(before) = before {
                let change = (0..2).map(|c| (found[c] - before[c]).abs()).fold(0.0, f64::max);
                greatest = greatest.max(change);
            }
            before = Some(found);
        }
        greatest
    };
    let changeover = Changeover { inclination: -7.5f64.to_radians(), width: 3f64.to_radians() };
    for base in models() {
        // Other models of the normal force jump where their contact points do.
        if base.normal_model != NormalModel::Strips || base.creepage_model == CreepageModel::Flat {
            continue;
        }
        let base = Parameters { friction_changeover: changeover, ..base };
        for own in [
            with_table("inclination.csv", base.clone()),
            with_table("place.csv", base.clone()),
            with_table("station.csv", base.clone()),
            regions(base.clone()),
        ] {
            let [coarse, fine] = [100, 400].map(|steps| changes(&mut tables.element(&own), steps));
            let name = (base.tangential_model, &own.friction_profile);
            assert!(fine <= tolerance::SHRINKING * coarse, "{name:?}: {fine} of {coarse}");
        }
    }
}

#[test]
fn what_friction_takes_from_a_wheel_that_rolls_on_is_the_frictional_power() {
    let tables = Tables::new(&[("table.csv", "inclination_deg friction\n-24 0.12\n-1 0.42\n")]);
    for base in models() {
        if base.creepage_model == CreepageModel::Flat {
            continue;
        }
        let base = Parameters { damping: 0.0, ..base };
        let mut element = tables.element(&with_table("table.csv", base));
        let mut input = rolling(5.4e-3, 20.0);
        input.wheel.pitch_rate *= 1.004;
        let input = pressed(&mut element, &input, 8e-5);
        let output = evaluate(&mut element, &input);
        let power = output.wheel.force[0] * input.wheel.velocity[0]
            + output.wheel.moment[1] * input.wheel.pitch_rate;
        assert!(output.frictional_power > 1.0);
        assert_relative_eq!(-power, output.frictional_power, max_relative = 1e-9);
    }
}

#[test]
fn forces_depend_on_the_inputs_that_tell_friction_alone() {
    let tables = Tables::new(&[
        ("still.csv", "inclination_deg friction\n-24 0.1\n0 0.5\n"),
        ("stations.csv", "station_m friction\n-9 0.1\n12 0.5\n"),
    ]);
    let base = Parameters::default();
    for (own, expected) in [
        (base.clone(), [false, true, false, false]),
        (regions(base.clone()), [false, false, true, true]),
        (with_table("still.csv", base.clone()), [false; 4]),
        (with_table("stations.csv", base), [true, false, false, false]),
    ] {
        let mut element = tables.element(&own);
        // From tread to gauge face.
        let mut input = rolling(6.5e-3, 20.0);
        input.wheel.pitch_rate *= 1.01;
        let input = pressed(&mut element, &input, 8e-5);
        let mut columns = Vec::new();
        element.jacobian(&input, &mut columns).unwrap();
        let names = [
            "track.s",
            "friction.coefficient",
            "friction.tread.coefficient",
            "friction.gauge_face.coefficient",
        ];
        let found = names.map(|name| {
            let i = INPUT_NAMES.iter().position(|own| *own == name).unwrap();
            columns[i].wheel.force[0] != 0.0
        });
        assert_eq!(found, expected, "{}", own.friction_profile);
    }
}

/// Random poses in which most patches slide.
const SLIDING_POSES: usize = 300;
