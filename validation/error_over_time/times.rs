//! What one evaluation of the element takes.

use std::hint::black_box;
use std::time::{Duration, Instant};

use wheelrail::element::parameters::VerticalMode;
use wheelrail::element::{Element, Input, Output};

use crate::choices::Choice;

/// Shortest stretch that is timed, and how many of them. The least counts: what else runs only adds.
const STRETCH: Duration = Duration::from_millis(1);
const STRETCHES: usize = 31;
/// Step aside between evaluations, so that nothing is reused [m].
const STEP: f64 = 1e-10;

/// Time of one evaluation, height or load given [s].
pub fn time(choice: Choice, given: VerticalMode, input: &Input) -> f64 {
    let mut subject = Subject::new(choice, given, input);
    let begin = Instant::now();
    subject.run(3);
    let once = begin.elapsed() / 3;
    let repeats = (STRETCH.as_secs_f64() / once.as_secs_f64().max(1e-9)).ceil() as usize;
    let times = (0..STRETCHES).map(|_| {
        let begin = Instant::now();
        subject.run(repeats);
        begin.elapsed().as_secs_f64() / repeats as f64
    });
    times.fold(f64::INFINITY, f64::min)
}

/// An element and its input.
struct Subject {
    element: Element,
    input: Input,
    output: Output,
    step: f64,
}

impl Subject {
    fn new(choice: Choice, given: VerticalMode, input: &Input) -> Self {
        let parameters = choice.parameters(given);
        let element = Element::new(&parameters, input, &[]).expect("built-in profiles");
        Self { element, input: *input, output: Output::default(), step: STEP }
    }

    fn run(&mut self, repeats: usize) {
        for _ in 0..repeats {
            self.step = -self.step;
            self.input.wheel.position[1] += self.step;
            self.element.evaluate(black_box(&self.input), &mut self.output).expect("a good input");
            black_box(&self.output);
        }
    }
}

/// A run whose instructions are counted.
pub fn evaluate(choice: Choice, given: VerticalMode, input: &Input, evaluations: usize) {
    let mut subject = Subject::new(choice, given, input);
    // What happens once only.
    subject.run(1);
    subject.run(evaluations);
}
