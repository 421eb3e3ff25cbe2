//! Distance of the undeformed wheel and rail along the normal of a contact frame.

use crate::math::real::Real;

/// Separation at one place of the contact line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SeparationPoint<T = f64> {
    /// Lateral coordinate in the contact frame, from the contact point [m].
    pub y: T,
    /// Derivative of `y` with respect to the parameter of the line, > 0 [-].
    pub dy: T,
    /// Separation of the two lines less that at the contact point; infinite where no normal meets
    /// both [m].
    pub f: T,
    /// Coordinate of the contact line along the track, from the wheel marker; where bodies are not
    /// even, of the place at which they are nearest [m].
    pub x: T,
}

/// The separation of two contact lines as a function of a parameter that grows with y.
///
/// The contact point has y = 0 and f = 0.
pub trait Separation {
    /// The separation at parameter `u` [m].
    fn at(&mut self, u: f64) -> SeparationPoint;

    /// As [`at`](Self::at) for each of the parameters `us`.
    fn fill(&mut self, us: &[f64], found: &mut [SeparationPoint]) {
        for (u, found) in us.iter().zip(found) {
            *found = self.at(*u);
        }
    }

    /// The separation [m] and its derivative by the parameter `u` where that comes with it [-].
    fn with_rate(&mut self, _: f64) -> Option<[f64; 2]> {
        None
    }

    /// As [`at`](Self::at), with the derivative of the separation by `u` [-]; by a difference over
    /// 0.2 µm unless there is a better way.
    fn with_slope(&mut self, u: f64) -> (SeparationPoint, f64) {
        let step = 1e-7;
        let (before, after) = (self.at(u - step).f, self.at(u + step).f);
        (self.at(u), (after - before) / (2.0 * step))
    }

    /// Coordinate of the contact line along the track at parameter `u`, as in
    /// [`SeparationPoint::x`] [m].
    fn along(&mut self, u: f64) -> f64 {
        self.at(u).x
    }
}

/// The separation as what is found on it needs it: with derivatives, where the numbers have them.
///
/// Searches go by values. What they find moves with pose and level, and has the derivatives of that
/// movement.
pub trait FrameSeparation<T: Real> {
    /// The separation at parameter `u` [m].
    fn point(&mut self, u: T) -> SeparationPoint<T>;

    /// As [`point`](Self::point) for each of the parameters `us`.
    fn points(&mut self, us: &[T], found: &mut [SeparationPoint<T>]) {
        for (u, found) in us.iter().zip(found) {
            *found = self.point(*u);
        }
    }

    /// Coordinate of the contact line along the track at parameter `u`, as in
    /// [`SeparationPoint::x`] [m].
    fn centre_at(&mut self, u: T) -> T;

    /// Value of the separation at parameter `u` [m].
    fn value(&mut self, u: f64) -> f64;

    /// Value of the separation at parameter `u` and of its derivative by it, where that comes with
    /// it [m, -].
    fn value_with_rate(&mut self, u: f64) -> Option<[f64; 2]>;

    /// The parameter at which the separation is `level`, found at the value `u` [m].
    fn edge(&mut self, u: f64, level: T) -> T;

    /// The separation at a probe that is a local minimum [m].
    fn minimum(&mut self, probe: &Probe) -> T;
}

impl<S: Separation> FrameSeparation<f64> for S {
    #[inline]
    fn point(&mut self, u: f64) -> SeparationPoint {
        self.at(u)
    }

    #[inline]
    fn points(&mut self, us: &[f64], found: &mut [SeparationPoint]) {
        self.fill(us, found);
    }

    #[inline]
    fn centre_at(&mut self, u: f64) -> f64 {
        self.along(u)
    }

    #[inline]
    fn value(&mut self, u: f64) -> f64 {
        self.at(u).f
    }

    #[inline]
    fn value_with_rate(&mut self, u: f64) -> Option<[f64; 2]> {
        self.with_rate(u)
    }

    #[inline]
    fn edge(&mut self, u: f64, _: f64) -> f64 {
        u
    }

    #[inline]
    fn minimum(&mut self, probe: &Probe) -> f64 {
        probe.f
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
