//! Corrected creep forces under different laws of tread and gauge face.

use super::*;

/// Friction of a patch that a law of its own lets fall.
const STEEP: FrictionLaw = FrictionLaw {
    falling_law: FallingLaw::Exponential,
    falling_share: 0.2,
    falling_decay: 3.0,
    ..CLEAN
};

const CLEAN: FrictionLaw = FrictionLaw {
    falling_law: FallingLaw::Exponential,
    falling_share: 1.0,
    falling_decay: 0.0,
    reduction: 1.0,
    reduction_share: 1.0,
    reduction_decay: 0.0,
};

#[test]
fn corrected_creep_forces_stay_within_the_friction_that_laws_of_tread_and_gauge_face_leave() {
    let changeover = Changeover { inclination: -0.15, width: 0.2 };
    let base = Parameters {
        friction_law: CLEAN,
        gauge_face_law: STEEP,
        friction_changeover: changeover,
        ..Parameters::default()
    };
    let mut element = element(&regions(base));
    let mut random = Random::new(77);
    let mut mixed = 0;
    for _ in 0..SLIDING_POSES {
        let mut input = random_input(&mut element, &mut random);
        input.wheel.pitch_rate *= 1.0 + random.within(2e-3, 3e-2);
        (input.tread_friction, input.gauge_face_friction) = (0.5, 0.5);
        let output = evaluate(&mut element, &input);
        for patch in output.patches.iter().take(output.patch_count as usize) {
            let most = tolerance::most_friction(false, patch.penetration);
            let limit = most * patch.friction_coefficient * patch.normal_force;
            let [x, y] = patch.creep_force;
            assert!(x.hypot(y) <= limit, "{patch:?}\n{input:?}");
            mixed += usize::from((0.12..0.45).contains(&patch.friction_coefficient));
        }
    }
    // Some of them have friction of both laws.
    assert!(mixed >= 10, "{mixed}");
}
