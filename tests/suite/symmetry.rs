//! Mirror image and reversal bit for bit, with every pair of real-time models: no side and no way
//! along the track is another one's approximation.

use crate::common::random::Random;
use crate::common::wheel::{element, evaluate, mirrored, random_input, reversed};
use wheelrail::element::output::Wrench;
use wheelrail::element::parameters::{CreepageModel, NormalModel, Side, TangentialModel};
use wheelrail::element::{Element, Input, Parameters};

/// Poses of each pair of models.
const POSES: usize = 8;

fn real_time_models() -> Vec<Parameters> {
    use NormalModel::{Hertz, PiotrowskiKik, PiotrowskiKikCorrected, Strips};
    use TangentialModel::{Fastrip, Fastsim, FastsimCorrected, Linear, Marches, None, Tables};
    let tangential = [None, Linear, Fastsim, Fastrip, Tables, FastsimCorrected, Marches];
    let mut all = Vec::new();
    for normal_model in [Hertz, PiotrowskiKik, PiotrowskiKikCorrected, Strips] {
        for tangential_model in tangential {
            for creepage_model in
                [CreepageModel::Kinematic, CreepageModel::Flat, CreepageModel::Curved]
            {
                let default = Parameters::default();
                all.push(Parameters { normal_model, tangential_model, creepage_model, ..default });
            }
        }
    }
    all
}

/// `image` is `wrench` in the mirror that turns the signs of forces to `signs`; moments turn the
/// other way.
fn assert_image(wrench: Wrench, image: Wrench, signs: [f64; 3], what: &str) {
    for (i, sign) in signs.into_iter().enumerate() {
        let pairs =
            [(wrench.force[i], sign * image.force[i]), (wrench.moment[i], -sign * image.moment[i])];
        for (own, other) in pairs {
            // Equal as numbers: a zero may have either sign.
            assert!((own - other).abs() <= 0.0, "{what}, component {i}: {own} and {other}");
        }
    }
}

fn what(parameters: &Parameters) -> String {
    let Parameters { normal_model, tangential_model, creepage_model, .. } = parameters;
    format!("{normal_model:?}, {tangential_model:?}, {creepage_model:?}")
}

#[test]
fn the_left_wheel_is_the_mirror_image_of_the_right_one_bit_for_bit() {
    for parameters in real_time_models() {
        let mut right = element(&parameters);
        let left = Parameters { side: Side::Left, ..parameters.clone() };
        let mut left = Element::new(&left, &mirrored(&Input::default()), &[]).unwrap();
        let mut random = Random::new(31);
        for _ in 0..POSES {
            let input = random_input(&mut right, &mut random);
            let (one, other) =
                (evaluate(&mut right, &input), evaluate(&mut left, &mirrored(&input)));
            for (one, other) in [(one.wheel, other.wheel), (one.rails[0], other.rails[0])] {
                assert_image(one, other, [1.0, -1.0, 1.0], &what(&parameters));
            }
        }
    }
}

#[test]
fn running_backwards_is_the_mirror_image_across_the_track_bit_for_bit() {
    for parameters in real_time_models() {
        let mut element = element(&parameters);
        let mut random = Random::new(32);
        for _ in 0..POSES {
            let input = random_input(&mut element, &mut random);
            let (forth, back) =
                (evaluate(&mut element, &input), evaluate(&mut element, &reversed(&input)));
            for (forth, back) in [(forth.wheel, back.wheel), (forth.rails[0], back.rails[0])] {
                assert_image(forth, back, [-1.0, 1.0, 1.0], &what(&parameters));
            }
        }
    }
}
