//! Random walks over bodies that vary along the track or around the axle, in steps of 0.1 µm: where
//! the default element jumps, and by how much.
//!
//! Lines as those of even bodies (`walk`), along which the station and the turn of the wheel change
//! too.

use crate::tolerance;
use std::f64::consts::TAU;
use std::fmt::Write;

use crate::common::random::Random;
use crate::common::summary::Summary;
use crate::common::varying::{head, of_slices, slices};
use crate::common::walk::{FRICTION, Line, follow};
use crate::common::write_report;
use crate::rail_end;
use crate::varying_rail::crossing::crossing;
use crate::varying_wheel::eccentric;
use tempfile::TempDir;
use wheelrail::element::parameters::{FlatShape, TangentialModel};
use wheelrail::element::{Element, Input, Parameters};

/// Wheels.
const WHEELS: [&str; 2] = ["S1002", "S1002_worn.txt"];

/// A wheel on a rail, and where it is looked at.
struct Scene {
    name: &'static str,
    parameters: Parameters,
    /// Where profiles and sections are.
    folder: Option<TempDir>,
    /// Range of the lateral places, from that of a wheelset in the middle [m].
    aside: [f64; 2],
    /// How far from station 0 [m], and turns of the wheel [rad].
    within: [f64; 2],
}

impl Scene {
    fn new(name: &'static str, change: impl FnOnce(&mut Parameters)) -> Self {
        let mut parameters = Parameters::default();
        change(&mut parameters);
        let (aside, within) = ([-8e-3, 9e-3], [0.1, 0.3]);
        Self { name, parameters, folder: None, aside, within }
    }

    fn of_slices(name: &'static str, folder: TempDir, aside: [f64; 2]) -> Self {
        let scene = Self::new(name, |parameters| *parameters = of_slices(parameters.clone()));
        Self { folder: Some(folder), aside, within: [0.05, 0.3], ..scene }
    }
}

fn corrugated(parameters: &mut Parameters, amplitude: f64, wavelength: f64) {
    let wave = &mut parameters.rails[0].corrugation;
    (wave.amplitude, wave.wavelength) = (amplitude, wavelength);
}

/// A head whose sections drift to the side and fall, with a bend in between.
fn drifting() -> TempDir {
    slices((-10..=10).map(|i| 25.0 * f64::from(i)), |place| {
        head([0.03 * place + 0.5 * (place / 60.0).sin(), 2e-3 * place])
    })
}

fn scenes() -> Vec<Scene> {
    let flat = |length: f64, shape: FlatShape| {
        move |parameters: &mut Parameters| {
            (parameters.wheel.flat.length, parameters.wheel.flat.shape) = (length, shape);
        }
    };
    let mut eccentric_wheel = Scene::new("an eccentric wheel, by sections", |_| ());
    eccentric_wheel.parameters.profile_smoothing = 0.0;
    eccentric_wheel.parameters.wheel.profile = "wheel.slcw".into();
    eccentric_wheel.folder = Some(eccentric());
    // Its rails have no sides for a flange.
    let mut over_crossing =
        Scene::of_slices("a crossing with wing, groove and nose", crossing(), [-0.02, 0.02]);
    over_crossing.parameters.wheel.profile = "conical:0.02".into();
    let mut end =
        Scene::of_slices("the end of a rail", rail_end::ending(0.0, |s| s <= 0.0), [-5e-3, 5e-3]);
    end.parameters.wheel.profile = "cylindrical".into();
    end.within[0] = 0.02;
    let mut waves = Scene::of_slices("sections that drift, corrugated", drifting(), [-8e-3, 9e-3]);
    corrugated(&mut waves.parameters, 2e-5, 0.033);
    let mut both = Scene::of_slices("a worn flat on sections", drifting(), [-8e-3, 9e-3]);
    flat(0.06, FlatShape::Worn)(&mut both.parameters);
    vec![
        Scene::of_slices("sections that drift", drifting(), [-8e-3, 9e-3]),
        over_crossing,
        end,
        Scene::new("a roller of 0.8 m", |p| p.rails[0].roller_radius = 0.8),
        Scene::new("a roller with waves of 33 mm, 20 µm", |p| {
            p.rails[0].roller_radius = 0.8;
            corrugated(p, 2e-5, TAU * 0.8 / 152.0);
        }),
        Scene::new("corrugation of 33 mm, 20 µm", |p| corrugated(p, 2e-5, 0.033)),
        Scene::new("corrugation of 33 mm, 60 µm", |p| corrugated(p, 6e-5, 0.033)),
        Scene::new("corrugation of 38 mm, 230 µm", |p| corrugated(p, 2.3e-4, 0.038)),
        Scene::new("a wheel out of round, order 6, 0.3 mm", |p| {
            let wave = &mut p.wheel.out_of_round;
            (wave.amplitude, wave.order) = (3e-4, 6);
        }),
        eccentric_wheel,
        Scene::new("a fresh flat of 50 mm", flat(0.05, FlatShape::Fresh)),
        Scene::new("a worn flat of 60 mm", flat(0.06, FlatShape::Worn)),
        waves,
        both,
    ]
}

/// Walks so many lines over each of the bodies, with the normal force alone and with creep forces.
fn walk(lines: usize, seed: u64) {
    let profiles = concat!(env!("CARGO_MANIFEST_DIR"), "/fmu/resources/profiles");
    let mut report = String::from(
        "bodies,wheel,tangential,jump,y_mm,z_mm,roll_mrad,yaw_mrad,pitch_mrad,station_mm\n",
    );
    let mut missed = String::new();
    let mut summary = Summary::new("walk_uneven");
    for (number, scene) in scenes().into_iter().enumerate() {
        let mut jumps = [const { Vec::new() }; 2];
        let mut fallbacks = 0;
        let own = scene.parameters.wheel.profile.as_str();
        let wheels = if own == WHEELS[0] { &WHEELS[..] } else { &[own] };
        for &wheel in wheels {
            for forces in [0, 1] {
                let mut parameters = scene.parameters.clone();
                parameters.wheel.profile = wheel.into();
                if forces == 0 {
                    parameters.tangential_model = TangentialModel::None;
                }
                let own = scene.folder.iter().map(|folder| folder.path().to_path_buf());
                let folders: Vec<_> = own.chain([profiles.into()]).collect();
                let mut element = Element::new(&parameters, &Input::default(), &folders).unwrap();
                let mut random = Random::new(seed + number as u64);
                for _ in 0..lines {
                    let line =
                        Line::over_uneven(&mut element, &mut random, scene.aside, scene.within);
                    // Loads over themselves, creep forces over the limit.
                    let (share, most) = ([1.0, FRICTION][forces], tolerance::WALK_JUMPS[forces]);
                    let found = follow(&mut element, &line, share, most, &mut Vec::new());
                    jumps[forces].push(found.jump);
                    if found.jump > most {
                        let input = line.at(found.at);
                        let motion = input.wheel;
                        let [_, y, z] = motion.position;
                        let model = parameters.tangential_model;
                        let row = [y, z, motion.roll, motion.yaw, motion.pitch, input.track_s]
                            .map(|number| format!("{:.9}", 1e3 * number))
                            .join(",");
                        let name = scene.name;
                        writeln!(report, "{name},{wheel},{model:?},{:.2e},{row}", found.jump)
                            .unwrap();
                        writeln!(missed, "{} {wheel}: {:e}", scene.name, found.jump).unwrap();
                    }
                }
                fallbacks += element.fallbacks();
            }
        }
        let [load, limit] = jumps;
        let name = scene.name;
        summary.add(&format!("load; {name}"), load, "1e-4");
        summary.add(&format!("with creep forces; {name}"), limit, "1e-3");
        println!("{name}: {fallbacks} fallbacks");
    }
    summary.write();
    write_report("walk_uneven.csv", &report);
    println!("{report}");
    assert!(missed.is_empty(), "{missed}");
}

#[test]
fn a_short_walk_over_bodies_that_vary_has_no_jumps() {
    walk(1, 1);
}

#[test]
#[ignore = "ten minutes unoptimized"]
fn a_long_walk_over_bodies_that_vary_has_no_jumps() {
    walk(40, 200);
}
