//! From strip to strip along a rail: the place of its surface opposite to each.

use crate::geometry::contacts::contact::Contact;
use crate::geometry::curves::curve::CurvePoint;
use crate::geometry::rail::rail_outline::RailOutline;
use crate::math::real::Real;

/// A place on the surface of a rail.
#[derive(Clone, Copy, Debug)]
pub struct RailPlace<T = f64> {
    /// Parameter of the rail's curve [m].
    pub s: T,
    /// Derivative of the curve's point by its parameter, in the frame of the rail.
    pub tangent: [T; 2],
}

impl<T: Real> RailPlace<T> {
    /// That with the parameter `s` of the curve of `rail`.
    pub fn at(rail: &RailOutline<T>, s: T) -> Self {
        Self { s, tangent: rail.at(s).first }
    }
}

/// Longest last step of Newton's method [m]. It is off by its square over twice the radius: 0.4 nm
/// on a gauge corner of 13 mm, which turns by 3e-8 rad there.
const NEAR: f64 = 3e-6;
/// Cosine of the angle to the frame beyond which a rail has turned away: 81 degrees, steeper than
/// any flange. Closer to a right angle a step of Newton's method goes too far.
const MIN_COSINE: f64 = 0.15;

/// The last place of a walk.
#[derive(Clone, Copy, Debug)]
struct Last<T> {
    y: T,
    s: T,
    /// One over the derivative of y by s, not a number where the rail has turned away, and the
    /// second derivative.
    steepness: T,
    bend: T,
}

/// A walk along a rail in the frame of a contact.
#[derive(Clone, Debug)]
pub struct RailWalk<'a, T = f64> {
    rail: RailOutline<'a, T>,
    contact: Contact<T>,
    last: Last<T>,
}

impl<'a, T: Real> RailWalk<'a, T> {
    /// A walk from the point of the contact.
    pub fn new(rail: RailOutline<'a, T>, contact: Contact<T>) -> Self {
        let on = rail.at(contact.rail_s);
        Self { rail, contact, last: Last::at(&contact, T::from(0.0), contact.rail_s, &on) }
    }

    /// The place opposite to the lateral coordinate `y` of the frame [m]. From the last one it
    /// takes a step of Newton's method; where that is far, the parameter of the curve is that of
    /// `search` [m].
    pub fn to(&mut self, y: T, search: impl FnOnce() -> T) -> RailPlace<T> {
        self.step(y).unwrap_or_else(|| {
            let s = search();
            let on = self.rail.at(s);
            self.last = Last::at(&self.contact, y, s, &on);
            RailPlace { s, tangent: on.first }
        })
    }

    #[inline]
    fn step(&mut self, y: T) -> Option<RailPlace<T>> {
        let last = &self.last;
        let way = (y - last.y) * last.steepness;
        let guess = last.s + way - way * way * last.bend * last.steepness * 0.5;
        let on = self.rail.at(guess);
        self.last = Last::at(&self.contact, y, guess, &on);
        let origin = self.contact.origin;
        let to = [on.point[0] - origin[0], on.point[1] - origin[1]];
        let step = (y - across(&self.contact, to)) * self.last.steepness;
        // Not a number is not near.
        (step.abs() <= NEAR).then(|| {
            let s = guess + step;
            self.last.s = s;
            let tangent = [on.first[0] + step * on.second[0], on.first[1] + step * on.second[1]];
            RailPlace { s, tangent }
        })
    }
}

impl<T: Real> Last<T> {
    /// The point `on` of a rail with the parameter `s`, opposite to `y` in the frame of `contact`.
    #[inline]
    fn at(contact: &Contact<T>, y: T, s: T, on: &CurvePoint<T>) -> Self {
        let cosine = across(contact, on.first);
        let steepness =
            if cosine >= MIN_COSINE { T::from(1.0) / cosine } else { T::from(f64::NAN) };
        Self { y, s, steepness, bend: across(contact, on.second) }
    }
}

/// The component of `v` along the lateral axis of the frame of `contact`.
#[inline]
fn across<T: Real>(contact: &Contact<T>, v: [T; 2]) -> T {
    v[0] * contact.tangent[0] + v[1] * contact.tangent[1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::profiles::profile::ProfileKind;
    use crate::geometry::rail::placed_rail::PlacedRail;
    use crate::io::load_profile;
    use approx::assert_abs_diff_eq;

    #[test]
    fn places_are_opposite_to_what_they_are_asked_for() {
        let rail = load_profile("rail", "60E1", ProfileKind::Rail, 0.0, &[]).unwrap().curve;
        let rail = PlacedRail::by_gauge(&rail, 0.025, 1.435, 0.014, false).unwrap();
        let middle = 0.5 * (rail.curve().start() + rail.curve().end());
        for shift in [-0.02, 0.0, 0.012] {
            let rail_s = middle + shift;
            let on = rail.curve().at(rail_s);
            let size = on.first[0].hypotenuse(on.first[1]);
            let contact = Contact {
                u: 0.0,
                rail_s,
                penetration: 0.0,
                origin: on.point,
                tangent: on.first.map(|x| x / size),
                probes: [0; 2],
            };
            let across = |s: f64| {
                let to = [0, 1].map(|i| rail.curve().at(s).point[i] - on.point[i]);
                to[0] * contact.tangent[0] + to[1] * contact.tangent[1]
            };
            let (mut walk, mut searches) = (RailWalk::new(RailOutline::at_rest(&rail), contact), 0);
            for j in 0..=40 {
                let y = 2e-4 * f64::from(j - 20);
                let found = walk.to(y, || {
                    searches += 1;
                    let (mut low, mut high) = (rail_s - 0.02, rail_s + 0.02);
                    while high - low > 1e-12 {
                        let s = 0.5 * (low + high);
                        if across(s) < y { low = s } else { high = s }
                    }
                    low
                });
                assert_abs_diff_eq!(across(found.s), y, epsilon = 1e-11);
                let tangent = rail.curve().at(found.s).first;
                for (found, tangent) in found.tangent.into_iter().zip(tangent) {
                    assert_abs_diff_eq!(found, tangent, epsilon = 1e-6);
                }
            }
            assert!(searches <= 3, "{searches}");
        }
    }
}
