//! The outline of a rail under a wheel, at parameters with derivatives.

use crate::geometry::curves::curve::CurvePoint;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::varying_rail::{Along, MovingOutline, VaryingRail};
use crate::math::real::Real;

/// The outline of a rail: its section, or where that varies along the track what the wheel that
/// passed last meets.
#[derive(Clone, Copy, Debug)]
pub struct RailOutline<'a, T = f64> {
    /// The rail.
    pub rail: &'a PlacedRail,
    /// How the outline moves with the wheel, where the section varies and numbers have derivatives.
    moving: Option<&'a MovingOutline<T>>,
}

/// A strip over waves along the track.
#[derive(Clone, Copy, Debug)]
pub struct StripOverWaves<T> {
    /// Where the wheel meets the rail along the track, with slopes of the waves in the mean over the
    /// strip and without their curvature.
    pub along: Along<T>,
    /// How a corrugated roller [rises](RailOutline::rise), in the mean over the strip [-].
    pub rise: T,
    /// Place along the track of its middle, from the wheel marker [m].
    pub middle: T,
    /// Overlap there [m].
    pub overlap: T,
    /// Radius of the section of wheel and rail together [m].
    pub radius: T,
}

impl<'a, T: Real> RailOutline<'a, T> {
    /// That of `rail` as it is.
    pub fn at_rest(rail: &'a PlacedRail) -> Self {
        Self { rail, moving: None }
    }

    /// That of `rail` as it moves by `moving`, which is of a rail that varies.
    pub fn moving(rail: &'a PlacedRail, moving: Option<&'a MovingOutline<T>>) -> Self {
        Self { rail, moving: moving.filter(|_| rail.variation().is_some()) }
    }

    /// Point and derivatives at parameter `s` [m], in the frame of the rail marker.
    #[inline]
    pub fn at(&self, s: T) -> CurvePoint<T> {
        match self.moving {
            None => self.rail.curve().at(s),
            Some(moving) => moving.at(s),
        }
    }

    /// Where the wheel meets a rail that varies at parameter `s` [m]; nothing for others.
    pub fn along(&self, s: T) -> Option<Along<T>> {
        let varying = self.rail.variation()?;
        Some(match self.moving {
            None => varying.along(s.value()).fixed(),
            Some(moving) => moving.along(s),
        })
    }

    /// Place along the track of the strip at parameter `s`, where the contact line is at `x` from the
    /// wheel marker [m]: where the wheel meets a rail that varies, but for the waves of both on one
    /// that goes straight on.
    pub fn strip_place(&self, s: T, x: T) -> T {
        let is_straight = |varying: &VaryingRail| varying.is_straight() && varying.has_waves();
        if self.rail.variation().is_some_and(is_straight) {
            return x;
        }
        self.ahead(s).map_or(x, |ahead| x + ahead)
    }

    /// Whether wheel or rail have waves along the track.
    pub fn has_waves(&self) -> bool {
        self.rail.variation().is_some_and(VaryingRail::has_waves)
    }

    /// A strip over waves of either body: at parameter `s` and its [place](Self::strip_place) `x`,
    /// where the bodies overlap by `overlap` [m]. `radius` is that of both bodies together by where
    /// the wheel meets a rail without waves [m]. Nothing where neither has any.
    pub fn over_waves(
        &self,
        [s, x, overlap]: [T; 3],
        radius: impl FnOnce(&Along<T>) -> T,
    ) -> Option<StripOverWaves<T>> {
        let varying = self.rail.variation().filter(|varying| varying.has_waves())?;
        let mut along = self.along(s)?;
        let on = self.at(s);
        // A unit of height along the normal.
        let share = on.first[0] / on.first[0].hypotenuse(on.first[1]);
        let place = |x: T| [x, on.point[0], on.point[1]];
        along.waves = T::from(0.0);
        let (centre, even) = if varying.is_straight() {
            (along.lean, along.lever, along.curvature) = (T::from(0.0), T::from(0.0), T::from(0.0));
            (x, radius(&along))
        } else {
            let ([rail, wheel], curvature) = self.wave_slopes(varying, place(x));
            along.curvature += share * curvature;
            along.lean -= share * rail;
            along.lever -= wheel * self.lever_per_slope(varying, place(x));
            let even = radius(&along);
            (x - even * share * (rail + wheel), even)
        };
        let circle = [even * share, overlap / share];
        let bridge = match self.moving {
            None => {
                let found = varying.bridge(place(centre).map(T::value), circle.map(T::value));
                found.fixed()
            }
            Some(moving) => moving.bridge(varying, place(centre), circle),
        };
        let [rail, wheel] = bridge.slopes;
        let middle = centre + bridge.middle;
        along.lean += share * rail;
        if varying.wheel_has_waves() {
            along.lever += wheel * self.lever_per_slope(varying, place(middle));
        }
        let rise = if varying.roller_radius() > 0.0 {
            let ([here, _], _) = self.wave_slopes(varying, place(middle));
            self.rise(s, middle) + share * (rail - here)
        } else {
            T::from(0.0)
        };
        Some(StripOverWaves {
            along,
            rise,
            middle,
            overlap: bridge.overlap * share,
            radius: bridge.radius / share,
        })
    }

    /// See [`VaryingRail::wave_slopes`].
    fn wave_slopes(&self, varying: &VaryingRail, point: [T; 3]) -> ([T; 2], T) {
        match self.moving {
            None => {
                let (slopes, curvature) = varying.wave_slopes(point.map(T::value));
                (slopes.map(T::from), curvature.into())
            }
            Some(moving) => moving.wave_slopes(varying, point),
        }
    }

    /// See [`VaryingRail::lever_per_slope`].
    fn lever_per_slope(&self, varying: &VaryingRail, point: [T; 3]) -> T {
        match self.moving {
            None => varying.lever_per_slope(point.map(T::value)).into(),
            Some(moving) => moving.lever_per_slope(varying, point),
        }
    }

    /// How far ahead of the even contact line the wheel meets a rail that varies at parameter `s`;
    /// nothing for others [m].
    pub fn ahead(&self, s: T) -> Option<T> {
        let varying = self.rail.variation()?;
        Some(match self.moving {
            None => varying.ahead(s.value()).into(),
            Some(moving) => moving.ahead(s),
        })
    }

    /// Speed at which the rail closes along the normal of its outline where the wheel meets it `along`
    /// the track, as the wheel goes `forward` over its slope and the arc on top of a roller, which
    /// [rises](Self::rise) with it, is `turning` [m/s].
    pub fn closing_speed(along: &Along<T>, rise: T, [forward, turning]: [T; 2]) -> T {
        forward * (along.lean + along.gap) + turning * rise
    }

    /// How much higher along the normal of its outline a corrugated roller gets at parameter `s` and
    /// the place `x` from the wheel marker as the arc on its top grows; 0 for a rail, which lies still
    /// [-].
    pub fn rise(&self, s: T, x: T) -> T {
        let Some(varying) = self.rail.variation().filter(|varying| varying.is_corrugated()) else {
            return T::from(0.0);
        };
        let CurvePoint { point, first, .. } = self.at(s);
        let upward = first[0] / first[0].hypotenuse(first[1]);
        // Corrugated rollers have no derivatives.
        upward * varying.rise([x.value(), point[1].value()])
    }

    /// From where to where a rail that varies is there at parameter `s`, from the wheel marker [m],
    /// along the rows, as [`VaryingRail::ends`](crate::geometry::rail::varying_rail::VaryingRail::ends).
    pub fn ends(&self, s: T) -> Option<[T; 2]> {
        let varying = self.rail.variation()?;
        let ends = varying.ends(s.value())?;
        Some(ends.map(|end| match self.moving {
            _ if end[0].is_infinite() => end[0].into(),
            Some(moving) => moving.passed(end),
            None => varying.course().map_or(end[0], |course| course.place(end)[0]).into(),
        }))
    }

    /// Whether the section varies along the track.
    pub fn varies(&self) -> bool {
        self.rail.variation().is_some()
    }

    /// Lateral coordinate on the rail profile as given of the point with parameter `s` [m].
    pub fn profile_y(&self, s: T) -> T {
        self.rail.profile_y_of(self.at(s).point)
    }

    /// Radius of relative curvature along the track at parameter `s`, for a wheel whose even
    /// section has `radius`, but not less than of a curvature of `least` over that of the wheel
    /// [m].
    pub fn radius_along(&self, radius: T, s: T, least: f64) -> T {
        let Some(along) = self.along(s) else { return radius };
        radius / along.relative(radius).at_least(least)
    }
}
