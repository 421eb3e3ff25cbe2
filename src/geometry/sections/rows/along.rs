//! Where along the track two bodies are nearest, of which one or both vary.

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
    /// By how much farther from its axle than the round wheel of the contact line the wheel is
    /// there [m].
    pub raised: T,
    /// How far ahead of the axle of that round wheel the normal of the wheel passes it [m].
    pub lever: T,
    /// Curvature of the wheel beyond that of its section on the contact line, along its normal, but
    /// for its waves; positive where it bulges more [1/m].
    pub bulge: T,
    /// That of its waves [1/m].
    pub waves: T,
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
            raised: value(|a| a.raised),
            lever: value(|a| a.lever),
            bulge: value(|a| a.bulge),
            waves: value(|a| a.waves),
        }
    }

    /// The same in plain numbers, or as dual numbers without derivatives.
    pub fn fixed<U: Real>(&self) -> Along<U> {
        let number = |x: T| U::from(x.value());
        Along {
            ahead: number(self.ahead),
            curvature: number(self.curvature),
            lean: number(self.lean),
            drift: number(self.drift),
            gap: number(self.gap),
            raised: number(self.raised),
            lever: number(self.lever),
            bulge: number(self.bulge),
            waves: number(self.waves),
        }
    }

    /// What a curvature along the track is along the lean, over itself: cos³ of the angle [-].
    pub fn shortening(&self) -> T {
        T::from(1.0) / (self.lean * self.lean + 1.0).three_halves()
    }

    /// Curvature of both bodies together along the lean of a wheel whose section on the contact
    /// line has the radius `even` [m], over that of the section [-].
    ///
    /// The wheel's circle is as round along the lean as it is along the track.
    pub fn relative(&self, even: T) -> T {
        even * (self.curvature * self.shortening() + self.bulge + self.waves) + 1.0
    }
}
