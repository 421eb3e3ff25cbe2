//! Which tangential contact models there are.

/// Tangential contact model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum TangentialModel {
    /// No creep force.
    None,
    /// Full adhesion without bound: the limit of FASTSIM for infinite friction.
    Linear,
    /// Kalker's march through the strips of the true patch.
    Fastsim,
    /// Strip theory where the strips adhere, directions of FASTSIM where they slip.
    Fastrip,
    /// The force of the ellipse with the same moments of load, from a table of boundary element
    /// solutions; no tractions.
    Tables,
    /// FASTSIM on the true patch, its force corrected by its error on that ellipse.
    FastsimCorrected,
    /// The half-space solution on rectangular elements: slow, for checking the others.
    BoundaryElement,
    /// Marches through the strips of the true patch, which feel each other through the half-space,
    /// their force corrected by its error on the ellipse.
    #[default]
    Marches,
}

impl TangentialModel {
    /// Whether tractions are known that belong to its creep force, if it has one: those of its own, or
    /// of FASTSIM.
    pub fn has_tractions(self) -> bool {
        match self {
            Self::Linear | Self::Fastrip => false,
            Self::None
            | Self::Fastsim
            | Self::Tables
            | Self::FastsimCorrected
            | Self::BoundaryElement
            | Self::Marches => true,
        }
    }
}

/// How the three flexibilities of the simplified theory enter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Flexibilities {
    /// One for each creepage.
    Three,
    /// Blended towards a common one as the creepage grows (Vollebregt and Voltr 2023).
    #[default]
    Blended,
}
