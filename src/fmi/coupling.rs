//! The beginning of a step, from which its energy residual follows; stiffness and damping of the
//! contact.

use crate::element::subject::Subject;
use crate::element::work_pairs::WorkPairs;
use crate::error::ContactError;
use crate::variables::Coupling;

/// The beginning of the last step: its length [s], and the forces that a host held over it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LastStep {
    /// Length [s].
    pub duration: f64,
    /// Forces and velocities at its beginning.
    pub pairs: WorkPairs,
}

/// Puts stiffness and damping of each contact into `coupling`; `output` is that of `input`.
pub(super) fn slopes<S: Subject>(
    subject: &mut S,
    input: &S::Input,
    output: &S::Output,
    coupling: &mut Coupling,
) -> Result<(), ContactError> {
    for k in 0..S::PREFIXES.len() {
        let at = subject.input_of_element(k, input, output);
        let slopes = subject.elements_mut()[k].vertical_slopes(&at)?;
        (coupling.stiffness[k], coupling.damping[k]) = (slopes.stiffness, slopes.damping);
    }
    Ok(())
}
