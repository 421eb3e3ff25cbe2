//! Poses that nobody picked, against the project's own boundary elements; and walks, on which jumps
//! are looked for.

use std::f64::consts::PI;
use std::path::PathBuf;
use std::sync::OnceLock;

use rayon::prelude::*;
use tempfile::TempDir;
use wheelrail::element::output::Patch;
use wheelrail::element::parameters::{TangentialModel, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};

use crate::common::kinked_heads::{dented, ground, milled};
use crate::common::random::Random;
use crate::common::walk::{FRICTION, Line, STEP, STEPS, follow};
use crate::common::wheel::evaluate;
use crate::family::{Case, Family, none};
use crate::setting::{Setting, reference};

/// Pairs of wheel and rail, built in and worn.
pub const PAIRS: [[&str; 2]; 4] =
    [["S1002", "60E1"], ["S1002", "54E1"], ["S1002_worn.txt", "60E1"], ["S1002", "60E2"]];
/// Pairs whose rails are ground, milled and dented.
const KINKED: [[&str; 2]; 4] = [
    ["S1002", "ground.csv"],
    ["S1002_worn.txt", "ground.csv"],
    ["S1002", "milled.csv"],
    ["S1002", "dented.csv"],
];
/// Poses of each of them.
const POSES: usize = 500;

/// What is compared of each pose. Patches are those with a tenth of the load at least, the worst one
/// of a pose, where both solutions have as many; the unit of their moment is their limit times the
/// radius of a circle of their area.
const QUANTITIES: [&str; 8] = [
    "N [%]",
    "p_max [%]",
    "area [%]",
    "force [% of N]",
    "creep force [% of the limit]",
    "creep force of a patch [% of its limit]",
    "spin moment of a patch [% of limit times radius]",
    "frictional power of a patch [%]",
];

/// Random poses.
pub const FAMILIES: [Family; 2] = [
    Family {
        title: "Random poses of a rolling wheel",
        source: "the project's own `boundary_element`, 40 x 40",
        text: "Lateral shift 8 mm to both sides, yaw 12 mrad, roll 2 mrad, loads from 20 to 130 kN, creepage from none to sliding; new and worn wheels. Each model is \
               compared at the height at which the default models carry the load. Cases are named by pair and seed.",
        quantities: &QUANTITIES,
        is_random: true,
        needs_folder: false,
        solve: |setting, seed| SMOOTH_RAILS.compared(setting, seed),
        others: none,
    },
    Family {
        title: "Random poses on ground, milled and dented rails",
        source: "the project's own `boundary_element`, 40 x 40",
        text: "As above, on a rail head with facets 4 mm wide, with grooves 3 mm wide and 30 µm deep, and with four dents of 20 to 50 µm.",
        quantities: &QUANTITIES,
        is_random: true,
        needs_folder: false,
        solve: |setting, seed| KINKED_RAILS.compared(setting, seed),
        others: none,
    },
];

/// Where the profiles are: those of the units, and rails made from formulas.
fn folders() -> [PathBuf; 2] {
    static MADE: OnceLock<TempDir> = OnceLock::new();
    let made = MADE.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a folder");
        for (name, points) in
            [("ground.csv", ground()), ("milled.csv", milled()), ("dented.csv", dented())]
        {
            std::fs::write(folder.path().join(name), points).expect("a file");
        }
        folder
    });
    let own = concat!(env!("CARGO_MANIFEST_DIR"), "/fmu/resources/profiles").into();
    [own, made.path().to_owned()]
}

pub fn on(pair: [&str; 2], parameters: Parameters, input: &Input) -> Element {
    let mut parameters = parameters;
    [parameters.wheel.profile, parameters.rails[0].profile] = pair.map(String::from);
    Element::new(&parameters, input, &folders()).expect("profiles that are read")
}

/// A random pose and motion of a right wheel under a load.
pub fn random_pose(seed: u64) -> Input {
    let mut random = Random::new(seed);
    let mut input = Input::default();
    let wheel = &mut input.wheel;
    wheel.position[1] += random.about(8e-3);
    (wheel.yaw, wheel.roll) = (random.about(0.012), random.about(2e-3));
    wheel.velocity = [20.0, 20.0 * wheel.yaw + random.about(0.04), 0.0];
    wheel.pitch_rate = -20.0 / 0.46 * (1.0 + random.about(4e-3));
    input.wheel_load = random.within(2e4_f64.ln(), 1.3e5_f64.ln()).exp();
    input
}

/// N, greatest pressure and area, and the sum of the creep forces.
fn whole(output: &Output) -> ([f64; 3], [f64; 3]) {
    let mut creep = [0.0; 3];
    for patch in output.patches() {
        let (sine, cosine) = patch.contact_angle.sin_cos();
        let [x, y] = patch.creep_force;
        creep = [creep[0] + x, creep[1] + y * cosine, creep[2] + y * sine];
    }
    let load: f64 = output.patches().map(|p| p.normal_force).sum();
    let pressure = output.patches().map(|p| p.max_pressure).fold(0.0, f64::max);
    ([load, pressure, output.patches().map(|p| p.area).sum()], creep)
}

/// The pose at the height at which the default models carry its load; nothing where they do
/// not.
pub fn at_height(pair: [&str; 2], input: &Input) -> Option<Input> {
    let parameters = Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() };
    let carried = evaluate(&mut on(pair, parameters, input), input);
    let mut at = *input;
    at.wheel.position[2] = carried.wheel_z;
    (carried.fallback_count == 0).then_some(at)
}

/// A pose as the reference has it.
struct Pose {
    pair: [&'static str; 2],
    seed: u64,
    at: Input,
    exact: Output,
}

/// Poses on some pairs in a run, whose seed is the same for all settings: each is solved once, by
/// the first who asks for it.
struct Poses {
    pairs: [[&'static str; 2]; 4],
    solved: OnceLock<Vec<OnceLock<Option<Pose>>>>,
}

static SMOOTH_RAILS: Poses = Poses::on(PAIRS);
static KINKED_RAILS: Poses = Poses::on(KINKED);

impl Poses {
    const fn on(pairs: [[&'static str; 2]; 4]) -> Self {
        Self { pairs, solved: OnceLock::new() }
    }

    /// Room for all of them.
    fn all(&self) -> &[OnceLock<Option<Pose>>] {
        let count = self.pairs.len() * POSES;
        self.solved.get_or_init(|| (0..count).map(|_| OnceLock::new()).collect())
    }

    /// Pose `k` of the run with this `seed`; nothing where the default models do not carry the load.
    fn at(&self, k: usize, seed: u64) -> Option<&Pose> {
        let solve = || {
            let pair = self.pairs[k / POSES];
            let seed = seed.wrapping_mul(1000) + (k % POSES) as u64;
            let at = at_height(pair, &random_pose(seed))?;
            let exact = evaluate(&mut on(pair, reference().parameters(), &at), &at);
            Some(Pose { pair, seed, at, exact })
        };
        self.all()[k].get_or_init(solve).as_ref()
    }

    /// Cases of all poses by a setting that does not take milliseconds itself.
    fn compared(&self, setting: &Setting, seed: u64) -> Option<Vec<Case>> {
        let all = (0..self.all().len()).into_par_iter();
        let cases = all.filter_map(|k| Some(compare(setting, self.at(k, seed)?)));
        (!setting.is_slow).then(|| cases.collect())
    }
}

/// Share of the load from which on a patch is compared by itself.
const MAIN: f64 = 0.1;

/// The patches of an output with a tenth of the load at least, from field to gauge side.
fn main_patches(output: &Output) -> Vec<&Patch> {
    let load: f64 = output.patches().map(|patch| patch.normal_force).sum();
    let mut main: Vec<&Patch> =
        output.patches().filter(|patch| patch.normal_force >= MAIN * load).collect();
    main.sort_by(|a, b| a.wheel_y.total_cmp(&b.wheel_y));
    main
}

/// Errors of force, moment and power of the patch where they are greatest, in per cent; not numbers
/// where `own` has not as many patches as the `exact` solution.
fn of_patches(own: &Output, exact: &Output, friction: f64) -> [f64; 3] {
    let [own, exact] = [own, exact].map(main_patches);
    if own.len() != exact.len() {
        return [f64::NAN; 3];
    }
    let mut errors = [0.0; 3];
    for (own, exact) in own.iter().zip(exact) {
        let limit = friction * exact.normal_force;
        let radius = (exact.area / PI).sqrt();
        let [x, y] = [0, 1].map(|c| own.creep_force[c] - exact.creep_force[c]);
        let moment = own.spin_moment - exact.spin_moment;
        let power = own.frictional_power / exact.frictional_power - 1.0;
        let of_patch = [x.hypot(y) / limit, moment / (limit * radius), power];
        errors = std::array::from_fn(|k| f64::max(errors[k], 100.0 * of_patch[k].abs()));
    }
    errors
}

fn compare(setting: &Setting, pose: &Pose) -> Case {
    let Pose { pair, seed, at, exact } = pose;
    let own = evaluate(&mut on(*pair, setting.parameters(), at), at);
    let ((own_sizes, own_creep), (sizes, creep)) = (whole(&own), whole(exact));
    let distance = |a: [f64; 3], b: [f64; 3]| {
        100.0 * (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>().sqrt() / sizes[0]
    };
    let mut errors: Vec<f64> =
        own_sizes.iter().zip(sizes).map(|(a, b)| 100.0 * (a / b - 1.0)).collect();
    errors.push(distance(own.wheel.force, exact.wheel.force));
    errors.push(distance(own_creep, creep) / at.friction);
    errors.extend(of_patches(&own, exact, at.friction));
    let [wheel, rail] = pair;
    Case { name: format!("{wheel} on {rail}, seed {seed}"), errors }
}

/// Lines of each pair.
const LINES: usize = 12;

/// What walks have shown.
pub struct Walk {
    /// Way of the wheel's surface [m].
    pub way: f64,
    /// Greatest jump over the load, without creep forces, and over the friction limit, with them.
    pub jumps: [f64; 2],
    /// Jumps beyond 1e-4 and 1e-3.
    pub beyond: usize,
}

/// What is admitted as a jump, over the load and over the friction limit.
pub const JUMPS: [f64; 2] = [1e-4, 1e-3];

/// Walks with the default models.
pub fn walk(seed: u64) -> Walk {
    let all: Vec<(usize, usize)> =
        (0..PAIRS.len()).flat_map(|pair| [(pair, 0), (pair, 1)]).collect();
    let found: Vec<(usize, f64)> = all
        .into_par_iter()
        .flat_map_iter(|(pair, forces)| {
            let mut parameters = Parameters::default();
            if forces == 0 {
                parameters.tangential_model = TangentialModel::None;
            }
            let mut element = on(PAIRS[pair], parameters, &Input::default());
            let mut random = Random::new(seed.wrapping_mul(1000) + pair as u64);
            let jumps: Vec<(usize, f64)> = (0..LINES)
                .map(|_| {
                    let line = Line::random(&mut element, &mut random);
                    let share = [1.0, FRICTION][forces];
                    let most = JUMPS[forces];
                    let found = follow(&mut element, &line, share, most, &mut Vec::new());
                    (forces, found.jump)
                })
                .collect();
            jumps
        })
        .collect();
    let jumps = [0, 1].map(|forces| {
        found.iter().filter(|(f, _)| *f == forces).map(|(_, jump)| *jump).fold(0.0, f64::max)
    });
    let beyond = found.iter().filter(|(forces, jump)| *jump > JUMPS[*forces]).count();
    Walk { way: found.len() as f64 * STEP * STEPS as f64, jumps, beyond }
}
