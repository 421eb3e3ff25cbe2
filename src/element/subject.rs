//! What can be evaluated as a whole: one wheel, or a wheelset of two.

use std::fmt::Debug;
use std::path::PathBuf;
use std::slice;

use super::work_pairs::{WorkPairs, work_pairs};
use super::{Element, Gradient, Input, Output, Parameters};
use crate::error::ContactError;

/// Derivatives of a weighted sum of outputs by inputs and parameters.
#[derive(Clone, Debug)]
pub struct BySubject<S: Subject> {
    /// By the inputs.
    pub input: S::Input,
    /// Those of the elements, in the order of [`PREFIXES`](Subject::PREFIXES).
    pub sweeps: Vec<Sweep>,
}

/// What sweeps back through one element have found.
#[derive(Clone, Debug, Default)]
pub struct Sweep {
    /// Derivatives of the weighted sum, at the height that the wheel has.
    pub gradient: Gradient,
    /// Derivatives of that height, where it follows a load.
    pub height: Gradient,
    /// Derivative of the sum by that height.
    pub share: f64,
}

impl<S: Subject> Default for BySubject<S> {
    fn default() -> Self {
        Self { input: S::Input::default(), sweeps: Vec::new() }
    }
}

impl<S: Subject> BySubject<S> {
    /// The derivative by the parameter with the FMI name `name`, where sweeps know of it: of the
    /// element whose prefix it has, or of all that have it in common. Nothing where one of them has
    /// none.
    pub fn parameter(&self, name: &str) -> Option<f64> {
        let of = |sweep: &Sweep, name: &str| {
            let [own, height] =
                [&sweep.gradient, &sweep.height].map(|gradient| gradient.parameters.named());
            let place = own.iter().position(|(known, _)| *known == name)?;
            Some(own[place].1 + sweep.share * height[place].1)
        };
        let own = self.sweeps.iter().zip(S::PREFIXES).find_map(|(sweep, prefix)| {
            let name = name.strip_prefix(prefix)?;
            (!prefix.is_empty()).then(|| of(sweep, name))
        });
        let all = || self.sweeps.iter().map(|sweep| of(sweep, name)).sum::<Option<f64>>();
        let found = own.unwrap_or_else(all);
        found.filter(|slope| !self.sweeps.is_empty() && !slope.is_nan())
    }
}

/// One or two elements with what they have in common; inputs and outputs are those of the whole.
///
/// Everything that works with any of them, such as the FMI interface, is written in terms of this.
pub trait Subject: Clone + Debug {
    /// What is fixed once it is made.
    type Parameters: Clone + Debug + Default + PartialEq;
    /// What an evaluation depends on besides.
    type Input: Copy + Debug + Default + PartialEq;
    /// What an evaluation gives.
    type Output: Copy + Debug + Default + PartialEq;
    /// Heights of first touch, which follow from parameters and starting input [m].
    type Nominal: Copy + Debug + Default + PartialEq;

    /// What stands before the names of variables of each element.
    const PREFIXES: &'static [&'static str];

    /// Loads the profiles, which are looked for in `profile_folders`, checks the parameters and
    /// sizes all scratch memory.
    ///
    /// # Errors
    /// The parameter or profile at fault, by its name.
    fn prepare(
        parameters: &Self::Parameters,
        start: &Self::Input,
        profile_folders: &[PathBuf],
    ) -> Result<Self, ContactError>;

    /// Heights of first touch for the starting input.
    fn nominal(&self) -> Self::Nominal;

    /// Evaluates the forces; allocates nothing.
    ///
    /// # Errors
    /// The input at fault, by its name; `output` is then as before.
    fn evaluate_all(
        &mut self,
        input: &Self::Input,
        output: &mut Self::Output,
    ) -> Result<(), ContactError>;

    /// The same, and wears off what a time of `duration` ≥ 0 [s] wears off.
    ///
    /// # Errors
    /// As for [`evaluate_all`](Self::evaluate_all), or a bad duration.
    fn advance_all(
        &mut self,
        input: &Self::Input,
        output: &mut Self::Output,
        duration: f64,
    ) -> Result<(), ContactError>;

    /// Moves rails with a mass on over a step of `duration` ≥ 0 [s], during which the inputs go
    /// from `from` straight to `to`; other rails stay.
    ///
    /// # Errors
    /// The input at fault, by its name, or a bad duration; the rails are then where they were.
    fn move_all_rails(
        &mut self,
        from: &Self::Input,
        to: &Self::Input,
        duration: f64,
    ) -> Result<(), ContactError>;

    /// The derivative of the outputs in the direction `direction` of the inputs, as rates; all is
    /// left as it was.
    ///
    /// # Errors
    /// The input at fault, by its name, or why there is none; `rates` is then as before.
    fn directional_derivative_of_all(
        &mut self,
        input: &Self::Input,
        direction: &Self::Input,
        rates: &mut Self::Output,
    ) -> Result<(), ContactError>;

    /// The derivatives of Σ weight · output by inputs and parameters, for the price of a few
    /// evaluations however many these are; all is left as it was.
    ///
    /// # Errors
    /// The input at fault, by its name, or why there are none; what was `found` holds a part then.
    fn adjoint_derivative_of_all(
        &mut self,
        input: &Self::Input,
        weights: &Self::Output,
        found: &mut BySubject<Self>,
    ) -> Result<(), ContactError>;

    /// Its elements, in the order of [`PREFIXES`](Self::PREFIXES).
    fn elements(&self) -> &[Element];

    /// Its elements, to be changed.
    fn elements_mut(&mut self) -> &mut [Element];

    /// The parameters of each element.
    fn parameters_of_elements(parameters: &Self::Parameters) -> &[Parameters];

    /// How often a solver fell back to a simpler model, as reported.
    fn fallback_count(output: &Self::Output) -> i32;

    /// Load of element number `k` where loads are given, and what its rails carry [N].
    fn load_and_carried(k: usize, input: &Self::Input, output: &Self::Output) -> [f64; 2];

    /// The output of element number `k`.
    fn output_of_element(k: usize, output: &Self::Output) -> &Output;

    /// Forces on all bodies beside the velocities at which they do work.
    fn work_pairs(input: &Self::Input, output: &Self::Output) -> WorkPairs;

    /// The input of element number `k` where it was evaluated: with the height, and for a wheelset
    /// the roll, that `output` has found.
    fn input_of_element(&self, k: usize, input: &Self::Input, output: &Self::Output) -> Input;

    /// Distance of the wheel marker of element number `k` from the centre of the wheelset; `alone`
    /// if the subject does not know of one [m].
    fn lever(&self, k: usize, alone: f64) -> f64;

    /// Puts the counts of the elements as they are into `output`.
    fn report_fallbacks(&self, output: &mut Self::Output);
}

/// What a subject has under the same meaning as a method of its own.
macro_rules! forwarded {
    () => {
        fn prepare(
            parameters: &Self::Parameters,
            start: &Self::Input,
            profile_folders: &[std::path::PathBuf],
        ) -> Result<Self, ContactError> {
            Self::new(parameters, start, profile_folders)
        }

        fn evaluate_all(
            &mut self,
            input: &Self::Input,
            output: &mut Self::Output,
        ) -> Result<(), ContactError> {
            self.evaluate(input, output)
        }

        fn advance_all(
            &mut self,
            input: &Self::Input,
            output: &mut Self::Output,
            duration: f64,
        ) -> Result<(), ContactError> {
            self.advance(input, output, duration)
        }

        fn move_all_rails(
            &mut self,
            from: &Self::Input,
            to: &Self::Input,
            duration: f64,
        ) -> Result<(), ContactError> {
            self.move_rails(from, to, duration)
        }

        fn directional_derivative_of_all(
            &mut self,
            input: &Self::Input,
            direction: &Self::Input,
            rates: &mut Self::Output,
        ) -> Result<(), ContactError> {
            self.directional_derivative(input, direction, rates)
        }
    };
}
pub(crate) use forwarded;

impl Subject for Element {
    type Parameters = Parameters;
    type Input = Input;
    type Output = Output;
    type Nominal = f64;

    const PREFIXES: &'static [&'static str] = &[""];

    forwarded!();

    fn nominal(&self) -> f64 {
        self.nominal_wheel_z()
    }

    fn adjoint_derivative_of_all(
        &mut self,
        input: &Input,
        weights: &Output,
        found: &mut BySubject<Self>,
    ) -> Result<(), ContactError> {
        found.sweeps.resize_with(1, Sweep::default);
        let gradient = &mut found.sweeps[0].gradient;
        self.adjoint_derivative(input, weights, gradient)?;
        found.input = gradient.input;
        Ok(())
    }

    fn elements(&self) -> &[Element] {
        slice::from_ref(self)
    }

    fn elements_mut(&mut self) -> &mut [Element] {
        slice::from_mut(self)
    }

    fn parameters_of_elements(parameters: &Parameters) -> &[Parameters] {
        slice::from_ref(parameters)
    }

    fn fallback_count(output: &Output) -> i32 {
        output.fallback_count
    }

    fn load_and_carried(_: usize, input: &Input, output: &Output) -> [f64; 2] {
        [input.wheel_load, output.load_carried]
    }

    fn output_of_element(_: usize, output: &Output) -> &Output {
        output
    }

    fn work_pairs(input: &Input, output: &Output) -> WorkPairs {
        work_pairs((&input.wheel, &output.wheel), input.rails.iter().zip(&output.rails))
    }

    fn input_of_element(&self, _: usize, input: &Input, output: &Output) -> Input {
        let mut found = *input;
        found.wheel.position[2] = output.wheel_z;
        found
    }

    fn lever(&self, _: usize, alone: f64) -> f64 {
        alone
    }

    fn report_fallbacks(&self, output: &mut Output) {
        output.fallback_count = Element::fallback_count(self);
    }
}
