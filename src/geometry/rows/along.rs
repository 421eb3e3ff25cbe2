//! Where along the track two bodies are nearest, of which one varies.

use crate::math::real::Real;

/// Where a wheel meets a varying rail along the track.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Along<T = f64> {
    /// How far ahead of the even contact line the bodies are nearest [m].
    pub ahead: T,
    /// Curvature of the rail along the track, along the normal of its section and along the row;
    /// positive where it bulges [1/m].
    pub curvature: T,
    /// Slope of the rail there: tangent of the angle by which its normal leans forward [-].
    pub lean: T,
    /// How fast its rows drift across there [-].
    pub drift: T,
    /// How fast the gap grows along the row there: zero, but where the wheel stands on an end [-].
    pub gap: T,
}

impl<T: Real> Along<T> {
    /// Each of them by its own function of itself.
    pub(super) fn each(value: impl Fn(fn(&Self) -> T) -> T) -> Self {
        Self {
            ahead: value(|a| a.ahead),
            curvature: value(|a| a.curvature),
            lean: value(|a| a.lean),
            drift: value(|a| a.drift),
            gap: value(|a| a.gap),
        }
    }

    /// The same in plain numbers, or as dual numbers without derivatives.
    #[must_use]
    pub fn fixed<U: Real>(&self) -> Along<U> {
        let Self { ahead, curvature, lean, drift, gap } = *self;
        let [ahead, curvature, lean, drift, gap] =
            [ahead, curvature, lean, drift, gap].map(|x| U::from(x.value()));
        Along { ahead, curvature, lean, drift, gap }
    }

    /// What a curvature along the track is along the lean, over itself: cos³ of the angle [-].
    #[must_use]
    pub fn shortening(&self) -> T {
        T::from(1.0) / (self.lean * self.lean + 1.0).three_halves()
    }
}
