//! Random walks of a wheel on its rail in steps of 0.1 µm: the default element has no jumps,
//! and kinks of its stiffness are small.
//!
//! A walk is made of straight lines from random poses in random directions, along which every
//! coordinate of the wheel changes at an even rate.

use crate::tolerance;
use std::fmt::Write;

use crate::common::random::Random;
use crate::common::summary::Summary;
use crate::common::walk::{FRICTION, Line, STEP, STEPS, follow};
use crate::common::wheel::rolling;
use crate::common::{quantiles, write_report};
use wheelrail::element::parameters::TangentialModel;
use wheelrail::element::{Element, Input, Parameters};

/// Pairs of wheel and rail.
const PAIRS: [[&str; 2]; 4] =
    [["S1002", "60E1"], ["S1002", "54E1"], ["S1002_worn.txt", "60E1"], ["S1002", "60E2"]];

/// Walks `lines` lines of each pair with the normal force alone and with creep forces.
fn walk(lines: usize, seed: u64) {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/fmu/resources/profiles");
    let mut report =
        String::from("wheel,rail,tangential,largest jump,y_mm,z_mm,roll_mrad,yaw_mrad\n");
    let (mut jumps, mut kinks) = ([const { Vec::new() }; 2], Vec::new());
    let mut steps = 0;
    let mut times = Vec::new();
    for (pair, [wheel, rail]) in PAIRS.into_iter().enumerate() {
        for (forces, most) in tolerance::WALK_JUMPS.into_iter().enumerate() {
            let mut parameters = Parameters::default();
            parameters.wheel.profile = wheel.into();
            parameters.rails[0].profile = rail.into();
            if forces == 0 {
                parameters.tangential_model = TangentialModel::None;
            }
            let mut element =
                Element::new(&parameters, &Input::default(), &[folder.into()]).unwrap();
            let mut random = Random::new(seed + pair as u64);
            for _ in 0..lines {
                let line = Line::random(&mut element, &mut random);
                let share = [1.0, FRICTION][forces];
                let found = follow(&mut element, &line, share, most, &mut times);
                if forces == 0 {
                    kinks.push(found.kink);
                }
                jumps[forces].push(found.jump);
                if found.jump > most {
                    let wheel_motion = line.at(found.at).wheel;
                    let [_, y, z] = wheel_motion.position;
                    writeln!(
                        report,
                        "{wheel},{rail},{:?},{:.2e},{},{},{},{}",
                        parameters.tangential_model,
                        found.jump,
                        1e3 * y,
                        1e3 * z,
                        1e3 * wheel_motion.roll,
                        1e3 * wheel_motion.yaw
                    )
                    .unwrap();
                }
            }
            steps = steps.max(element.work().most_strip_steps);
        }
    }
    let way = 1e3 * STEP * times.len() as f64;
    times.sort_by(f64::total_cmp);
    let median = times[times.len() / 2];
    let time = |share: f64| times[((times.len() - 1) as f64 * share) as usize] / median;
    let most_jumps = jumps.each_ref().map(|jumps| jumps.iter().copied().fold(0.0, f64::max));
    let [_, most_kinks, _] = quantiles(kinks.clone());
    let mut summary = Summary::new("walk");
    let [load, limit] = jumps;
    summary.add(&format!("jumps of the load on lines of 0.1 mm, {way:.0} mm in all"), load, "1e-4");
    summary.add("jumps with creep forces, over the friction limit", limit, "1e-3");
    summary.add("kinks of the stiffness over itself", kinks, "- / 0.05 / -");
    let quantiles_of_time = [0.999, 0.9999, 1.0].map(time);
    let title = "time over its median: 99.9 %, 99.99 % and greatest";
    summary.row(title, times.len(), quantiles_of_time, "- / 10 / 40");
    summary.row("greatest number of Newton steps", times.len(), [steps as f64; 3], "");
    summary.write();
    write_report("walk.csv", &report);
    println!("{report}");
    for (jump, most) in most_jumps.into_iter().zip(tolerance::WALK_JUMPS) {
        assert!(jump <= most, "{report}");
    }
    assert!(most_kinks <= tolerance::WALK_KINKS, "{report}");
}

/// Places [mm, mrad] in which two lobes join or part, or a lobe becomes a shoulder: y, z, roll and
/// yaw of S1002 on a rail.
const PLACES: [(&str, [f64; 4]); 9] = [
    ("60E1", [749.983_985_370, -459.822_129_179, -0.607_927_672, 9.160_567_296]),
    ("60E1", [751.658_144_452, -459.842_769_804, 1.592_070_045, 0.463_164_521]),
    ("60E1", [754.079_765_627, -460.126_716_977, -1.660_733_968, 0.726_345_785]),
    ("60E1", [754.763_934_198, -460.852_992_551, -3.723_601_641, -9.403_472_087]),
    ("60E1", [755.945_048_525, -460.853_181_283, -1.347_901_157, 6.705_579_111]),
    ("54E1", [746.187_896_193, -459.764_246_764, -3.827_397_654, -11.539_816_886]),
    ("54E1", [754.142_576_841, -460.286_077_837, -1.083_867_787, -9.554_593_346]),
    ("54E1", [755.670_177_135, -460.966_230_674, -1.844_449_469, -9.491_181_303]),
    ("54E1", [756.873_811_468, -460.304_898_506, 3.435_614_057, 1.026_015_306]),
];

#[test]
fn lobes_that_join_and_part_make_no_jumps() {
    for (forces, most) in tolerance::WALK_JUMPS.into_iter().enumerate() {
        for (rail, [y, z, roll, yaw]) in PLACES {
            let mut parameters = Parameters::default();
            parameters.rails[0].profile = rail.into();
            if forces == 0 {
                parameters.tangential_model = TangentialModel::None;
            }
            let mut element = Element::new(&parameters, &Input::default(), &[]).unwrap();
            let mut start = rolling(0.0, 20.0);
            start.friction = FRICTION;
            let wheel = &mut start.wheel;
            (wheel.position[1], wheel.position[2]) = (1e-3 * y, 1e-3 * z);
            // What closes sideways is damped, by zones of other normals when they join.
            (wheel.roll, wheel.yaw, wheel.velocity[1]) = (1e-3 * roll, 1e-3 * yaw, 0.05);
            let line = Line { start, y: 0.4, z: -0.6, roll: 0.0, yaw: 0.0, along: 0.0, pitch: 0.0 };
            let middle = Line { start: line.at(-0.5 * STEP * STEPS as f64), ..line };
            let share = [1.0, FRICTION][forces];
            let found = follow(&mut element, &middle, share, most, &mut Vec::new());
            let model = parameters.tangential_model;
            assert!(found.jump <= most, "{rail} {y} {model:?}: {:e} of {most:e}", found.jump);
        }
    }
}

/// A rail, a pose y, z [mm], roll and yaw [mrad] at which the lattice changes, and the direction in
/// which it does, by z and by yaw.
type Changing = (&'static str, [f64; 4], [f64; 2]);

/// A contact of which rounding is all there is begins beside another one.
const BEGINS: Changing = (
    "60E2",
    [
        758.147_822_965_098_3,
        -460.154_241_810_385_8,
        3.197_382_974_731_077_4,
        -2.550_739_887_315_671_3,
    ],
    [0.0, 20.0],
);
/// Two intervals of overlap join.
const JOIN: Changing = (
    "60E1",
    [755.941_558_070_547_7, -460.853_873_670_857_7, -1.351_038_849_480_328, 6.735_189_805_125_504],
    [0.0, 20.0],
);
/// A sample passes a jump of the wheel's curvature.
const PASSES: Changing = (
    "60E1",
    [757.452_317_019_165_4, -460.792_423_049_976_1, 1.729_263_101_576_549_8, 8.066_271_974_070_299],
    [1.0, 0.0],
);

#[test]
fn nothing_jumps_where_lattices_change() {
    let [most, _] = tolerance::WALK_JUMPS;
    for (rail, [y, z, roll, yaw], [by_z, by_yaw]) in [BEGINS, JOIN, PASSES] {
        let mut parameters = Parameters::default();
        parameters.rails[0].profile = rail.into();
        parameters.tangential_model = TangentialModel::None;
        let mut element = Element::new(&parameters, &Input::default(), &[]).unwrap();
        let mut start = rolling(0.0, 20.0);
        let wheel = &mut start.wheel;
        (wheel.position[1], wheel.position[2]) = (1e-3 * y, 1e-3 * z);
        (wheel.roll, wheel.yaw) = (1e-3 * roll, 1e-3 * yaw);
        let line = Line { start, y: 0.0, z: by_z, roll: 0.0, yaw: by_yaw, along: 0.0, pitch: 0.0 };
        let middle = Line { start: line.at(-0.5 * STEP * STEPS as f64), ..line };
        let found = follow(&mut element, &middle, 1.0, most, &mut Vec::new());
        assert!(found.jump <= most, "{rail} {y}: {:e} of {most:e}", found.jump);
    }
}

#[test]
fn a_short_walk_has_no_jumps() {
    walk(3, 1);
}

#[test]
#[ignore = "a metre of way, ten million evaluations: for a release build"]
fn a_long_walk_has_no_jumps() {
    walk(1250, 100);
}
