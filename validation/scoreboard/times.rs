//! What an evaluation takes, setting beside setting in one run.

use std::time::Instant;

use wheelrail::element::Output;

use crate::family::Case;
use crate::random::{PAIRS, at_height, on, random_pose};
use crate::setting::Setting;

/// Poses of each pair of profiles, and how often each is evaluated; the least time counts, which
/// other programs have not disturbed.
const POSES: u64 = 100;
const AGAIN: usize = 5;
/// One in so many of the poses is enough for models that take milliseconds.
const SLOW: usize = 20;

/// Times of an evaluation in random poses [s], with the pose as the name of the case.
pub fn times(setting: &Setting, seed: u64) -> Vec<Case> {
    let mut cases = Vec::new();
    for pair in PAIRS {
        for seed in (0..POSES)
            .step_by(if setting.is_slow { SLOW } else { 1 })
            .map(|k| seed.wrapping_mul(1000) + k)
        {
            let Some(at) = at_height(pair, &random_pose(seed)) else { continue };
            let mut element = on(pair, setting.parameters(), &at);
            let mut output = Output::default();
            let time = |_| {
                let start = Instant::now();
                element.evaluate(&at, &mut output).expect("a good pose");
                start.elapsed().as_secs_f64()
            };
            let least = (0..AGAIN).map(time).fold(f64::INFINITY, f64::min);
            let [wheel, rail] = pair;
            let name = format!("{wheel} on {rail}, seed {seed}");
            cases.push(Case { name, errors: vec![least] });
        }
    }
    cases
}
