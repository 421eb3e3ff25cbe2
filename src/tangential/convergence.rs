//! How well the tractions of a zone fulfil the law of friction.

/// How the tractions of a zone converged.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Convergence {
    /// Whether the chosen model did not converge: FASTSIM took the place of boundary elements;
    /// strips keep their last step, within the bound.
    pub fell_back: bool,
    /// Greatest part of the bound that tractions on strips are away from the law of friction; of
    /// boundary elements the largest slip that contradicts it, over the largest rigid slip; 0 for
    /// other models [-].
    pub residual: f64,
}

impl Convergence {
    /// That of a model which did not converge and has no tractions.
    #[must_use]
    pub fn failed() -> Self {
        Self { fell_back: true, residual: 0.0 }
    }

    /// That of a model which converged to `residual`.
    #[must_use]
    pub fn to(residual: f64) -> Self {
        Self { fell_back: false, residual }
    }

    /// That of two solutions which are taken together: the worse of both.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            fell_back: self.fell_back || other.fell_back,
            residual: self.residual.max(other.residual),
        }
    }
}
