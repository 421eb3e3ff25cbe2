//! The outline of a rail under a wheel, at parameters with derivatives.

use crate::geometry::curves::curve::CurvePoint;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::varying_rail::{Along, MovingOutline};
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

    /// Where the wheel meets a rail that varies at parameter `s`, waves of both bridged over the
    /// distance `reach` to either side of the place `x` from the wheel marker [m]; nothing for
    /// others.
    pub fn along_bridged(&self, s: T, x: T, reach: T) -> Option<Along<T>> {
        let varying = self.rail.variation()?;
        let mut along = self.along(s)?;
        if !varying.has_waves() {
            return Some(along);
        }
        let on = self.at(s);
        let share = on.first[0] / on.first[0].hypotenuse(on.first[1]);
        let point = [x, on.point[0], on.point[1]];
        let (rail, wheel) = match self.moving {
            None => {
                let (point, reach) = (point.map(T::value), reach.value());
                let own = [varying.bridged(point, reach), varying.waves_over(point, reach)];
                let [rail, wheel] = own.map(|bulge| bulge.map(T::from));
                (rail, wheel)
            }
            Some(moving) => {
                (moving.bridged(varying, point, reach), moving.waves_over(varying, point, reach))
            }
        };
        if let Some(more) = rail {
            along.curvature += share * more;
        }
        along.waves = wheel.map_or(along.waves, |waves| share * waves);
        Some(along)
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

    /// Speed at which the rail closes along the normal of its outline at parameter `s`, where the
    /// wheel meets it `along` the track, at `x` from the wheel marker, as the wheel goes `forward`
    /// over its slope and the arc on top of a roller is `turning` [m/s].
    pub fn closing_speed(&self, along: &Along<T>, s: T, x: T, [forward, turning]: [T; 2]) -> T {
        let climbing = forward * (along.lean + along.gap);
        let Some(varying) = self.rail.variation().filter(|varying| varying.is_corrugated()) else {
            return climbing;
        };
        let CurvePoint { point, first, .. } = self.at(s);
        let upward = first[0] / first[0].hypotenuse(first[1]);
        // A rail has none; corrugated rollers have no derivatives.
        let rise = varying.rise([x.value(), point[1].value()]);
        climbing + turning * upward * rise
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
