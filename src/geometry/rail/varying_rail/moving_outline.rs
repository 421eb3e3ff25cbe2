//! The outline of a rail that varies, with derivatives.

use crate::geometry::curves::curve::CurvePoint;
use crate::geometry::sections::rows::along::Along;
use crate::geometry::sections::rows::envelope::Envelope;
use crate::geometry::sections::rows::met::Met;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;

/// The outline of a rail that varies, as it moves with the wheel that meets it.
#[derive(Clone, Debug)]
pub struct MovingOutline<T> {
    pub(super) envelope: Envelope<T>,
    pub(super) met: FixedVec<Met<T>>,
    pub(super) station: T,
}

impl<T: Real> MovingOutline<T> {
    /// Room for an outline of `count` rows.
    #[must_use]
    pub fn new(count: usize) -> Self {
        let station = T::from(0.0);
        Self { envelope: Envelope::new(count), met: FixedVec::new(count), station }
    }

    /// Point and derivatives of the outline at parameter `s` [m].
    #[must_use]
    pub fn at(&self, s: T) -> CurvePoint<T> {
        self.envelope.at(s)
    }

    /// Where the wheel meets the rail at parameter `s` of the outline.
    #[must_use]
    pub fn along(&self, s: T) -> Along<T> {
        self.envelope.along(s)
    }

    /// A place `x` of the rail from the wheel marker, as the wheel moves on [m].
    #[must_use]
    pub fn passed(&self, x: f64) -> T {
        T::moving(x, -self.station)
    }
}
