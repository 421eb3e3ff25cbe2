//! What a wheel feels that runs over corrugations and flats.

use super::*;
use crate::common;

/// Greatest change of the normal force over a step beyond that of its neighbours, over the force.
fn greatest_jump(parameters: &Parameters, depth: f64, rotate: bool) -> [f64; 2] {
    let mut element = element(parameters);
    let input = pressed(&mut element, &rolling(-2e-3, 0.0), depth);
    let count = 3000;
    let forces: Vec<[f64; 2]> = (0..count)
        .map(|i| {
            let mut input = input;
            let along = 1.2e-5 * f64::from(i) - 0.018;
            input.track_s = along;
            input.wheel.velocity[0] = 20.0;
            input.wheel.pitch_rate = -20.0 / 0.46;
            if rotate {
                input.wheel.pitch = -along / 0.46;
            }
            let output = evaluate(&mut element, &input);
            let creep: f64 = output.patches.iter().map(|p| p.creep_force[1]).sum();
            [-output.wheel.force[2], creep]
        })
        .collect();
    let size = forces.iter().map(|f| f[0]).fold(0.0, f64::max);
    [0, 1].map(|k| {
        forces
            .windows(4)
            .map(|f| {
                let [before, change, after] = [0, 1, 2].map(|i| (f[i + 1][k] - f[i][k]).abs());
                change - before.max(after)
            })
            .fold(0.0, f64::max)
            / size
    })
}

#[test]
fn the_force_has_no_jumps_over_corrugations_and_flats() {
    let mut report = String::from("case,model,damping,depth_um,normal_jump,creep_jump\n");
    let models = [NormalModel::PiotrowskiKik, NormalModel::Strips];
    for (index, normal_model, mut parameters) in all_kinds()
        .into_iter()
        .enumerate()
        .flat_map(|(index, parameters)| models.map(|model| (index, model, parameters.clone())))
    {
        if normal_model == NormalModel::Strips && parameters.wheel.flat.length > 0.0 {
            // Where a flat begins the place of first touch jumps, and strips have but one.
            continue;
        }
        for damping in [0.0, 1e5] {
            (parameters.damping, parameters.normal_model) = (damping, normal_model);
            for depth in [4e-5, 1e-4] {
                let [normal, creep] = greatest_jump(&parameters, depth, true);
                let um = 1e6 * depth;
                report += &format!(
                    "{index},{normal_model:?},{damping:.0},{um:.0},{normal:.2e},{creep:.2e}\n"
                );
                assert!(normal < tolerance::UNEVEN_JUMP, "case {index}, depth {depth}: {normal}");
                assert!(
                    creep < tolerance::UNEVEN_CREEP_JUMP,
                    "case {index}, depth {depth}: {creep}"
                );
            }
        }
    }
    print!("{report}");
    common::write_report("uneven_jumps.csv", &report);
}

/// Greatest and least contact force of a wheel of 700 kg under 80 kN, at `speed` [m/s] over a flat
/// of 50 mm, on a rail of 100 kg on a stiffness of 8e7 N/m.
fn impact(shape: FlatShape, speed: f64) -> [f64; 2] {
    let mut parameters = with_flat(0.05, shape);
    parameters.wheel.flat.angle = 0.26;
    parameters.tangential_model = TangentialModel::None;
    let mut input = rolling(-3e-3, speed);
    let mut element = element(&parameters);
    let load = 80e3;
    let stiffness = 8e7;
    input.rails[0].z = load / stiffness;
    let (mut low, mut high) = (element.touching_height(&input), -0.455);
    for _ in 0..50 {
        input.wheel.position[2] = 0.5 * (low + high);
        let carried = -evaluate(&mut element, &input).wheel.force[2] >= load;
        *(if carried { &mut high } else { &mut low }) = input.wheel.position[2];
    }
    let step = 2e-5;
    let (mut peak, mut least) = (0f64, f64::INFINITY);
    input.wheel.position[0] = 0.05;
    while input.wheel.position[0] < 0.22 {
        input.wheel.pitch = -input.wheel.position[0] / 0.46;
        let force = -evaluate(&mut element, &input).wheel.force[2];
        (peak, least) = (peak.max(force), least.min(force));
        let rail = &mut input.rails[0];
        rail.vz += step * (force - stiffness * rail.z - 1.2e5 * rail.vz) / 100.0;
        rail.z += step * rail.vz;
        let wheel = &mut input.wheel;
        wheel.velocity[2] += step * (load - force) / 700.0;
        wheel.position[2] += step * wheel.velocity[2];
        wheel.position[0] += step * speed;
    }
    [peak, least]
}

#[test]
fn a_flat_strikes_harder_with_speed_until_the_wheel_leaves_the_rail() {
    let [slow, middle, fast, faster] =
        [20.0, 40.0, 80.0, 140.0].map(|speed| impact(FlatShape::Fresh, speed / 3.6));
    let [worn_slow, _, worn_fast] =
        [20.0, 40.0, 80.0].map(|speed| impact(FlatShape::Worn, speed / 3.6));
    println!("fresh {slow:?} {middle:?} {fast:?} {faster:?}, worn {worn_slow:?} {worn_fast:?} N");
    // Below, the rail follows the wheel; above, the wheel flies and the force hardly grows any
    // more.
    assert!(slow[1] > 0.0 && fast[1] <= 0.0 && faster[1] <= 0.0);
    assert!(slow[0] > 1.5 * 80e3 && middle[0] > 1.4 * slow[0] && fast[0] > 1.2 * middle[0]);
    let growth = faster[0] / fast[0];
    assert!((0.9..1.15).contains(&growth), "{growth}");
    // Rolling wears the corners off, and the blow with them.
    assert!(worn_slow[0] < 0.8 * slow[0] && worn_fast[0] < 0.85 * fast[0]);
}
