//! The beginning of a step, from which its energy residual follows; stiffness and damping of the
//! contact, and how long a step may be.

use serde::{Deserialize, Serialize};

use crate::element::subject::Subject;
use crate::element::work_pairs::WorkPairs;
use crate::element::{ContactSlopes, Element, StepLimit};
use crate::error::ContactError;
use crate::variables::{Coupling, StepLimits};

/// The beginning of the last step: its length [s], and the forces that a host held over it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LastStep {
    /// Length [s].
    pub duration: f64,
    /// Forces and velocities at its beginning.
    pub pairs: WorkPairs,
}

/// Limit that stands for none [s]: outputs are finite.
const NO_LIMIT: f64 = 1e6;

/// Puts stiffness and damping of each contact, and the limits of the step, into `coupling`;
/// `output` is that of `input`.
pub(super) fn slopes<S: Subject>(
    subject: &mut S,
    input: &S::Input,
    output: &S::Output,
    coupling: &mut Coupling,
) -> Result<(), ContactError> {
    // Of a wheel alone the other one of its wheelset does the same.
    let mut wheels = [ContactSlopes::default(); 2];
    for k in 0..S::PREFIXES.len() {
        let at = subject.input_of_element(k, input, output);
        let lever = subject.lever(k, coupling.lever);
        let slopes = subject.elements_mut()[k].contact_slopes(&at, lever)?;
        (coupling.stiffness[k], coupling.damping[k]) = (slopes.stiffness, slopes.damping);
        wheels[k..].fill(slopes);
    }
    let limit = StepLimit::of(&wheels, &coupling.inertia);
    let is_loaded = subject.elements().iter().any(Element::follows_load);
    // The height that follows a load is not the host's to integrate.
    let normal = if is_loaded { f64::INFINITY } else { limit.normal() };
    coupling.limits = StepLimits {
        normal: normal.min(NO_LIMIT),
        creep: limit.creep().min(NO_LIMIT),
        longest: normal.min(limit.creep()).min(NO_LIMIT),
    };
    Ok(())
}
