//! The normal contact problem, and the list of normal models.

use crate::math::quadrature::GaussLegendre;

/// Normal contact model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum NormalModel {
    /// An ellipse at each contact point from the curvatures there.
    Hertz,
    /// Virtual penetration, semi-elliptical strips (Piotrowski and Kik 2008).
    PiotrowskiKik,
    /// The same with the ratio of length to width of the contact area corrected (section 2.4
    /// there).
    PiotrowskiKikCorrected,
    /// Strips coupled through the half-space whose pressures have the least energy, all overlaps of
    /// a rail in one problem: see [`least_energy`](super::least_energy).
    #[default]
    Strips,
    /// The half-space solution on rectangular elements: slow, for checking the others.
    BoundaryElement,
}

/// What all normal models are told about one contact frame.
#[derive(Clone, Copy, Debug)]
pub struct NormalProblem<'a, T = f64> {
    /// Approach: overlap of the undeformed bodies at the contact point, > 0 [m].
    pub approach: T,
    /// Radius of the normal section of the wheel along x, > 0 [m].
    pub radius: T,
    /// Contact modulus E* of the two bodies [Pa].
    pub contact_modulus: f64,
    /// Parameter of the contact line at the contact point [m].
    pub contact_u: T,
    /// Relative curvature of the two profiles at the contact point, f''(0) without yaw [1/m].
    pub lateral_curvature: T,
    /// Quadrature rule across a zone; its nodes are the strips.
    pub rule: &'a GaussLegendre,
    /// Elements along and across the contact, for the model with boundary elements.
    pub elements: [usize; 2],
}

/// Strips across a zone of the models with a rule of quadrature, where `strips` are asked for: one
/// more than an odd number, as the middle of a rule is about where the bodies touch first, and what
/// a strip does there grows beyond all bounds.
pub fn strips_of_rule(strips: usize) -> usize {
    strips.next_multiple_of(2)
}
