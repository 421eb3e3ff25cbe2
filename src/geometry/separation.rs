//! Distance of the undeformed wheel and rail along the normal of a contact frame.

/// Separation at one place of the contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeparationPoint {
    /// Lateral coordinate in the contact frame, from the contact point [m].
    pub y: f64,
    /// Derivative of `y` with respect to the parameter of the line, > 0 [-].
    pub dy: f64,
    /// Separation of the two lines less that at the contact point; infinite where no normal meets both [m].
    pub f: f64,
    /// Coordinate of the contact line along the track, from the wheel marker; where bodies are not even, of the place at which they
    /// are nearest [m].
    pub x: f64,
}

/// The separation of two contact lines as a function of a parameter that grows with y.
///
/// The contact point has y = 0 and f = 0.
pub trait Separation {
    /// The separation at parameter `u` [m].
    fn at(&mut self, u: f64) -> SeparationPoint;

    /// As [`at`](Self::at), with the derivative of the separation by `u` [-]; by a difference over 0.2 µm unless there is a better way.
    fn with_slope(&mut self, u: f64) -> (SeparationPoint, f64) {
        let step = 1e-7;
        let (before, after) = (self.at(u - step).f, self.at(u + step).f);
        (self.at(u), (after - before) / (2.0 * step))
    }

    /// Coordinate of the contact line along the track at parameter `u`, as in [`SeparationPoint::x`] [m].
    fn along(&mut self, u: f64) -> f64 {
        self.at(u).x
    }
}

/// A place at which the separation is known well enough to bracket the edges of loaded zones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// Parameter of the line [m].
    pub u: f64,
    /// Separation, exact at the local minima and maxima, an estimate in between [m].
    pub f: f64,
}
