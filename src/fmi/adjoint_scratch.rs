//! Memory of an instance for adjoint derivatives.

use super::types::ValueReference;
use crate::element::subject::{BySubject, Subject};
use crate::variables::{Described, ValuesOf};

/// Memory for derivatives backwards.
#[derive(Clone, Debug)]
pub struct AdjointScratch<S: Described + Subject> {
    /// Weights, and derivatives by inputs.
    pub(super) weights: ValuesOf<S>,
    pub(super) found: BySubject<S>,
    /// Unknowns that have none backwards, and derivatives by one known.
    pub(super) others: Vec<ValueReference>,
    pub(super) column: Vec<f64>,
}

impl<S: Described + Subject> Default for AdjointScratch<S> {
    fn default() -> Self {
        Self {
            weights: ValuesOf::default(),
            found: BySubject::default(),
            others: Vec::new(),
            column: Vec::new(),
        }
    }
}
