//! The wheels of a vehicle: what a time step of all of them costs, and how cost grows.
//! `cargo bench --no-default-features --bench vehicle` writes its section of docs/benchmarks.md.

#[path = "../page/mod.rs"]
mod page;

use std::fmt::Write;
use std::hint::black_box;
use std::time::{Duration, Instant};

use page::microseconds;
use wheelrail::element::parameters::{
    CreepageModel, NormalModel, Parameters, Side, TangentialModel, VerticalMode,
};
use wheelrail::element::{Element, Input, Output};
use wheelrail::wheelset;

/// Wheels of a vehicle.
const WHEELS: usize = 8;
/// Shortest stretch that is timed, and how many of them.
const STRETCH: Duration = Duration::from_millis(3);
const STRETCHES: usize = 40;
/// Step of the height between evaluations, so that nothing is reused [m].
const STEP: f64 = 1e-10;
const SPEED: f64 = 30.0;
/// Load of a wheel [N].
const LOAD: f64 = 6e4;

/// Lateral shift of a wheelset towards the right rail [m], yaw [rad], and whether its wheels touch.
type Wheelset = (f64, f64, bool);

/// A name and the wheelsets of the vehicle, the first one leading.
type Scene = (&'static str, [Wheelset; WHEELS / 2]);

const SCENES: [Scene; 3] = [
    (
        "straight track",
        [(0.8e-3, 2e-4, true), (-0.5e-3, -1e-4, true), (1.2e-3, 3e-4, true), (0.2e-3, 0.0, true)],
    ),
    (
        "curve, flanges touch",
        [(5.4e-3, 8e-3, true), (-1.5e-3, 1e-3, true), (5.3e-3, 6e-3, true), (-2e-3, 1e-3, true)],
    ),
    (
        "half of the wheels lifted",
        [(0.8e-3, 2e-4, false), (-0.5e-3, -1e-4, true), (1.2e-3, 3e-4, false), (0.2e-3, 0.0, true)],
    ),
];

/// Models by name, with their changes of the default parameters.
type Models = (&'static str, fn(&mut Parameters));

const MODELS: [Models; 5] = [
    ("hertz + fastsim 20", |p| {
        choose(p, NormalModel::Hertz, 12, TangentialModel::Fastsim, 20);
    }),
    ("piotrowski_kik 12 + fastsim 20", |p| {
        choose(p, NormalModel::PiotrowskiKik, 12, TangentialModel::Fastsim, 20);
    }),
    ("piotrowski_kik 30 + fastsim 30", |p| {
        choose(p, NormalModel::PiotrowskiKik, 30, TangentialModel::Fastsim, 30);
    }),
    ("piotrowski_kik 12 + tables", |p| {
        choose(p, NormalModel::PiotrowskiKik, 12, TangentialModel::Tables, 20);
    }),
    ("by default", |_| {}),
];

fn choose(
    parameters: &mut Parameters,
    normal: NormalModel,
    strips: usize,
    tangential: TangentialModel,
    along: usize,
) {
    // A row is of two models, and creepage that is one triple for each patch.
    parameters.creepage_model = CreepageModel::Flat;
    parameters.normal_model = normal;
    parameters.strips = strips;
    parameters.tangential_model = tangential;
    parameters.elements_along = along;
}

/// An element with its input.
struct Wheel {
    element: Element,
    input: Input,
    output: Output,
    step: f64,
}

impl Wheel {
    fn new(parameters: &Parameters, side: Side, (shift, yaw, touches): Wheelset) -> Self {
        let parameters = Parameters { side, ..parameters.clone() };
        let mut input = Input::default();
        if side == Side::Left {
            input.wheel.position[1] *= -1.0;
        }
        input.wheel.position[1] += shift;
        input.wheel.yaw = yaw;
        input.wheel.velocity[0] = SPEED;
        input.wheel.pitch_rate = -SPEED / 0.46;
        input.wheel.position[2] = if touches { loaded_height(&parameters, &input) } else { -0.462 };
        let element = Element::new(&parameters, &input, &[]).expect("built-in profiles");
        Self { element, input, output: Output::default(), step: STEP }
    }

    fn evaluate(&mut self) {
        self.step = -self.step;
        self.input.wheel.position[2] += self.step;
        self.element.evaluate(black_box(&self.input), &mut self.output).expect("a good input");
        black_box(&self.output);
    }
}

/// The height at which the wheel carries its load [m].
fn loaded_height(parameters: &Parameters, input: &Input) -> f64 {
    let parameters = Parameters { vertical_mode: VerticalMode::Load, ..parameters.clone() };
    let input = Input { wheel_load: LOAD, ..*input };
    let mut element = Element::new(&parameters, &input, &[]).expect("built-in profiles");
    let mut output = Output::default();
    element.evaluate(&input, &mut output).expect("a good input");
    output.wheel_z
}

fn vehicle(parameters: &Parameters, wheelsets: &[Wheelset]) -> Vec<Wheel> {
    let sides = [Side::Right, Side::Left];
    let wheels =
        wheelsets.iter().flat_map(|&set| sides.map(|side| Wheel::new(parameters, side, set)));
    wheels.collect()
}

/// Least time of one call of `work` [s]: what else runs only adds.
fn time(mut work: impl FnMut()) -> f64 {
    work();
    let begin = Instant::now();
    work();
    let once = begin.elapsed().as_secs_f64().max(1e-9);
    let repeats = (STRETCH.as_secs_f64() / once).ceil() as usize;
    let times = (0..STRETCHES).map(|_| {
        let begin = Instant::now();
        for _ in 0..repeats {
            work();
        }
        begin.elapsed().as_secs_f64() / repeats as f64
    });
    times.fold(f64::INFINITY, f64::min)
}

fn round(wheels: &mut [Wheel]) -> f64 {
    time(|| wheels.iter_mut().for_each(Wheel::evaluate))
}

fn line(text: &mut String, line: std::fmt::Arguments) {
    text.write_fmt(line).expect("writing to a string cannot fail");
    text.push('\n');
}

fn main() {
    if !std::env::args().any(|argument| argument == "--bench") {
        println!("run by: cargo bench --no-default-features --bench vehicle");
        return;
    }
    let text = scenes() + &coach() + &growth() + &instances();
    println!("{text}");
    page::write("vehicle", text.trim_end());
}

/// A vehicle by scene and models, on one thread.
fn scenes() -> String {
    let mut text = format!(
        "**{WHEELS} wheels of a vehicle**, one evaluation each, one thread. Times real time: at one evaluation of all wheels in every step.\n\n\
         | scene | models | patches | all wheels [µs] | evaluations a second | times real time at 1 kHz | at 10 kHz |\n|---|---|---|---|---|---|---|\n"
    );
    for (scene, wheelsets) in SCENES {
        for (models, change) in MODELS {
            let mut parameters = Parameters::default();
            change(&mut parameters);
            let mut wheels = vehicle(&parameters, &wheelsets);
            let time = round(&mut wheels);
            let patches: i32 = wheels.iter().map(|wheel| wheel.output.patch_count).sum();
            line(
                &mut text,
                format_args!(
                    "| {scene} | `{models}` | {patches} | {} | {:.0} 000 | {:.1} | {:.1} |",
                    microseconds(time),
                    1e-3 * WHEELS as f64 / time,
                    1e-3 / time,
                    1e-4 / time,
                ),
            );
        }
    }
    text + "\n"
}

/// A coach that sways on straight track, by the models that an element starts with:
/// its four wheelsets evaluated in each step, heights given or loads.
fn coach() -> String {
    let mut text = format!(
        "**A coach of {} wheelsets**, default models, {STEPS} steps of 1 ms over sways of 5 mm, {SPEED} m/s, one thread: time of all steps over that of the \
         run.\n\n| given | median of a step [µs] | slowest | of the time of the run | faster than real time |\n|---|---|---|---|---|\n",
        WHEELS / 2
    );
    for (name, mode) in [("heights", VerticalMode::Penetration), ("loads", VerticalMode::Load)] {
        let mut times = steps_of_coach(mode);
        let share = times.iter().sum::<f64>() / (1e-3 * STEPS as f64);
        times.sort_by(f64::total_cmp);
        line(
            &mut text,
            format_args!(
                "| {name} | {} | {} | {share:.2} | {} |",
                microseconds(times[STEPS / 2]),
                microseconds(times[STEPS - 1]),
                if share < 1.0 { "yes" } else { "no" },
            ),
        );
    }
    text + "\n"
}

/// Steps of the coach.
const STEPS: usize = 2000;

/// Times of its steps [s].
fn steps_of_coach(mode: VerticalMode) -> Vec<f64> {
    let mut parameters = wheelset::Parameters::default();
    for side in &mut parameters.sides {
        side.vertical_mode = mode;
    }
    let start = wheelset::Input::default();
    let new = || wheelset::Wheelset::new(&parameters, &start, &[]).expect("built-in profiles");
    let mut coach: Vec<wheelset::Wheelset> = (0..WHEELS / 2).map(|_| new()).collect();
    let mut output = wheelset::Output::default();
    let mut at = |step: usize| {
        for (k, own) in coach.iter_mut().enumerate() {
            // Each wheelset a way behind the one before, with the yaw of its sway.
            let angle = SWAY_RATE * (1e-3 * step as f64) - k as f64;
            let mut input = start;
            for side in &mut input.sides {
                side.wheel_load = LOAD;
            }
            let motion = &mut input.wheelset;
            motion.position[1] = SWAY * angle.sin();
            motion.position[2] = own.nominal_z() + SUNK;
            motion.yaw = SWAY * SWAY_RATE / SPEED * angle.cos();
            motion.velocity = [SPEED, SWAY * SWAY_RATE * angle.cos(), 0.0];
            motion.pitch_rate = -SPEED / 0.46;
            own.evaluate(black_box(&input), &mut output).expect("a good input");
            black_box(&output);
        }
    };
    at(0);
    let mut timed = |step| {
        let begin = Instant::now();
        at(step);
        begin.elapsed().as_secs_f64()
    };
    (0..STEPS).map(&mut timed).collect()
}

/// Amplitude of the sway of a wheelset [m], its rate [rad/s], and how far it is below first touch in
/// the middle of the track [m].
const SWAY: f64 = 5e-3;
const SWAY_RATE: f64 = 8.0;
const SUNK: f64 = 1e-4;

/// Growth with strips, elements and patches, Piotrowski-Kik and FASTSIM.
fn growth() -> String {
    let tread = [(-3e-3, 1e-3, true)];
    let evaluated = |parameters: &Parameters, wheelset: Wheelset| {
        let mut wheel = [Wheel::new(parameters, Side::Right, wheelset)];
        (round(&mut wheel), wheel[0].output.patch_count)
    };
    let mut text = String::from(
        "**Growth**, one tread patch, `piotrowski_kik` + `fastsim` [µs].\n\n| strips \\ elements along | 8 | 16 | 32 | 64 |\n|---|---|---|---|---|\n",
    );
    for strips in [8, 16, 32, 64] {
        let times = [8, 16, 32, 64].map(|along| {
            let mut parameters = Parameters::default();
            choose(
                &mut parameters,
                NormalModel::PiotrowskiKik,
                strips,
                TangentialModel::Fastsim,
                along,
            );
            microseconds(evaluated(&parameters, tread[0]).0)
        });
        line(&mut text, format_args!("| {strips} | {} |", times.join(" | ")));
    }
    text += "\nPatches, default models [µs]:";
    let mut second = Parameters::default();
    second.rails[1].enabled = true;
    for (name, parameters, wheelset) in [
        ("tread", Parameters::default(), (-3e-3, 1e-3, true)),
        ("tread and flange root", Parameters::default(), (5.35e-3, 1e-3, true)),
        ("tread, check rail out of reach", second, (-3e-3, 1e-3, true)),
    ] {
        let (time, patches) = evaluated(&parameters, wheelset);
        text += &format!(" {name} ({patches}) {},", microseconds(time));
    }
    text.pop();
    text + ".\n\n"
}

/// Instances on one and two threads, default models.
fn instances() -> String {
    let mut text = String::from(
        "**Instances**, straight track, default models: time of one evaluation of all of them over their number [µs].\n\n\
         | instances | one thread | two threads |\n|---|---|---|\n",
    );
    let wheelsets = SCENES[0].1;
    for count in [1, 8, 64] {
        let mut wheels: Vec<Wheel> = Vec::new();
        while wheels.len() < count {
            wheels.extend(vehicle(&Parameters::default(), &wheelsets));
        }
        wheels.truncate(count);
        let one = round(&mut wheels) / count as f64;
        let two = if count > 1 {
            microseconds(on_two_threads(&mut wheels) / count as f64)
        } else {
            String::new()
        };
        line(&mut text, format_args!("| {count} | {} | {two} |", microseconds(one)));
    }
    text
}

/// Time of one evaluation of all wheels, half of them on each of two threads that run on for a
/// while [s].
fn on_two_threads(wheels: &mut [Wheel]) -> f64 {
    let (left, right) = wheels.split_at_mut(wheels.len() / 2);
    let times = std::thread::scope(|scope| {
        let halves = [left, right].map(|half| scope.spawn(|| round(half)));
        halves.map(|half| half.join().expect("an evaluation does not panic"))
    });
    times[0].max(times[1])
}
