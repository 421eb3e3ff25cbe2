//! Derivatives of arrays, element by element.

use super::{Target, places};
use crate::element::subject::Subject;
use crate::fmi::error::FmiError;
use crate::fmi::instance::Instance;
use crate::fmi::types::ValueReference;
use crate::variables::Described;

impl<S: Described + Subject> Instance<S> {
    /// Puts Σ ∂ unknown/∂ known · `seed` into `sensitivity`, element by element, as
    /// [`directional_derivative`](Self::directional_derivative) does. The event indicator moves in
    /// steps: its derivative is 0 in between.
    pub fn directional_derivative_of_arrays(
        &mut self,
        unknowns: &[ValueReference],
        knowns: &[ValueReference],
        seed: &[f64],
        sensitivity: &mut [f64],
    ) -> Result<(), FmiError> {
        self.survey(unknowns, ("nSensitivity", sensitivity.len()), |_| true)?;
        self.survey(knowns, ("nSeed", seed.len()), |_| true)?;
        self.check_sides(unknowns, knowns)?;
        let [unknown_places, known_places] = self.flatten(unknowns, knowns);
        let in_table = unknown_places.len();
        let found = self.directional_derivative(
            &unknown_places,
            &known_places,
            seed,
            &mut sensitivity[..in_table],
        );
        self.flattened = [unknown_places, known_places];
        found?;
        // From the last to the first, to leave room for event indicators.
        let (mut from, mut to) = (in_table, sensitivity.len());
        for &reference in unknowns.iter().rev() {
            let target = self.target(reference)?;
            for _ in 0..target.len() {
                to -= 1;
                sensitivity[to] = match target {
                    Target::Elements(_) => {
                        from -= 1;
                        sensitivity[from]
                    }
                    Target::Time | Target::EventIndicator | Target::Dummy => 0.0,
                };
            }
        }
        Ok(())
    }

    /// Puts Σ `seed` · ∂ unknown/∂ known into `sensitivity`, element by element, as
    /// [`adjoint_derivative`](Self::adjoint_derivative) does; that of the event indicator is 0.
    pub fn adjoint_derivative_of_arrays(
        &mut self,
        unknowns: &[ValueReference],
        knowns: &[ValueReference],
        seed: &[f64],
        sensitivity: &mut [f64],
    ) -> Result<(), FmiError> {
        self.survey(unknowns, ("nSeed", seed.len()), |_| true)?;
        self.survey(knowns, ("nSensitivity", sensitivity.len()), |_| true)?;
        self.check_sides(unknowns, knowns)?;
        let [unknown_places, known_places] = self.flatten(unknowns, knowns);
        let mut seeds = std::mem::take(&mut self.seeds);
        seeds.clear();
        let mut from = 0;
        for &reference in unknowns {
            let target = self.target(reference)?;
            let own = &seed[from..from + target.len()];
            if matches!(target, Target::Elements(_)) {
                seeds.extend_from_slice(own);
            }
            from += target.len();
        }
        let found = self.adjoint_derivative(&unknown_places, &known_places, &seeds, sensitivity);
        self.flattened = [unknown_places, known_places];
        self.seeds = seeds;
        found
    }

    /// Checks that neither time nor a state nor an event indicator stands where it cannot.
    fn check_sides(
        &self,
        unknowns: &[ValueReference],
        knowns: &[ValueReference],
    ) -> Result<(), FmiError> {
        for (references, role, reason) in [
            (unknowns, "unknown", "it is no output"),
            (knowns, "known", "it is no input and no parameter"),
        ] {
            for &reference in references {
                let target = self.target(reference)?;
                let is_misplaced = match target {
                    Target::Elements(_) => false,
                    Target::Time => true,
                    Target::EventIndicator | Target::Dummy => role == "known",
                };
                if is_misplaced {
                    let name = target.name();
                    return Err(FmiError::NoDerivative { name, role, reason });
                }
            }
        }
        Ok(())
    }

    /// Places of the elements of both in the table, in memory that is lent by the instance.
    fn flatten(
        &mut self,
        unknowns: &[ValueReference],
        knowns: &[ValueReference],
    ) -> [Vec<ValueReference>; 2] {
        let mut flattened = std::mem::take(&mut self.flattened);
        for (own, references) in flattened.iter_mut().zip([unknowns, knowns]) {
            own.clear();
            own.extend(places(S::UNIT, references));
        }
        flattened
    }
}
