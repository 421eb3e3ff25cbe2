//! How well the tractions of zones fulfil the law of friction.

/// How the tractions of zones converged.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Convergence {
    /// Zones for which boundary elements did not converge: FASTSIM took their place.
    pub fallbacks: u64,
    /// Largest slip of boundary elements that contradicts the law of friction, over the largest rigid
    /// slip; 0 for other models [-].
    pub residual: f64,
}

impl Convergence {
    /// That of a model which did not converge and has no tractions.
    pub fn failed() -> Self {
        Self { fallbacks: 1, residual: 0.0 }
    }

    /// That of a model which converged to `residual`.
    pub fn to(residual: f64) -> Self {
        Self { fallbacks: 0, residual }
    }

    /// That of two solutions for one zone: the worse of both.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            fallbacks: self.fallbacks.max(other.fallbacks),
            residual: self.residual.max(other.residual),
        }
    }

    /// That of several zones with others beside them.
    #[must_use]
    pub fn beside(self, other: Self) -> Self {
        Self { fallbacks: self.fallbacks + other.fallbacks, ..self.and(other) }
    }
}
