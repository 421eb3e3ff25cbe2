//! Contacts that a search has found, as they move with the pose of wheel and rail.
//!
//! The search goes by plain numbers. What it finds fulfils equations, whose derivatives give those
//! of what was found (implicit functions): with P(u) on the contact line and its tangent t(u), Q(s)
//! on the rail,
//!
//! ```text
//! (P(u) - Q(s)) · Q'(s) = 0,   t(u) × Q'(s) = 0
//! ```

use crate::geometry::contacts::contact::Contact;
use crate::geometry::curves::curve::CurvePoint;
use crate::geometry::rail::rail_outline::RailOutline;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::math::dual::Dual;
use crate::math::real::Real;

/// Sine of the angle between the two lines up to which a place counts as one where they are
/// parallel: a search leaves 1e-9.
const PARALLEL: f64 = 1e-6;

/// The two equations of a place where the lines are parallel and face each other.
fn equations<T: Real>(line: &ContactLine<T>, on: &CurvePoint<T>, u: T) -> [T; 2] {
    let at = line.at(u);
    let to = [at.point[0] - on.point[0], at.point[1] - on.point[1]];
    let along = |v: [T; 2]| v[0] * on.first[0] + v[1] * on.first[1];
    [along(to), at.tangent[0] * on.first[1] - at.tangent[1] * on.first[0]]
}

/// Parameters `u` of the line and `s` of the rail at which the two are parallel, as they move with
/// `line`; nothing where they are not parallel or stay so to first order.
pub fn moving_place<T: Real>(
    line: &ContactLine<T>,
    rail: &RailOutline<T>,
    u: f64,
    s: f64,
) -> Option<[T; 2]> {
    let rates = equations(line, &rail.at(s.into()), u.into());
    let fixed = line.value().fixed::<Dual<2>>();
    let on = rail.rail.curve().at(Dual::variable(s, 1));
    let at = equations(&fixed, &on, Dual::variable(u, 0));
    let [[a, b], [c, d]] = [at[0].slopes, at[1].slopes];
    let determinant = a * d - b * c;
    if !(at[1].value.abs() < PARALLEL && determinant != 0.0) {
        return None;
    }
    let inverse = -1.0 / determinant;
    Some([
        T::moving(u, (rates[0] * d - rates[1] * b) * inverse),
        T::moving(s, (rates[1] * a - rates[0] * c) * inverse),
    ])
}

impl Contact {
    /// The contact as it moves with `line`; nothing where it is no place of parallel lines, which
    /// it is not where a body ends in it.
    pub fn moving<T: Real>(
        &self,
        line: &ContactLine<T>,
        rail: &RailOutline<T>,
    ) -> Option<Contact<T>> {
        let [u, s] = moving_place(line, rail, self.u, self.rail_s)?;
        let (at, on) = (line.at(u), rail.at(s));
        let slowness =
            T::from(1.0) / (on.first[0] * on.first[0] + on.first[1] * on.first[1]).sqrt();
        let tangent = on.first.map(|first| first * slowness);
        let to = [at.point[0] - on.point[0], at.point[1] - on.point[1]];
        Some(Contact {
            u,
            rail_s: s,
            penetration: to[1] * tangent[0] - to[0] * tangent[1],
            origin: on.point,
            tangent,
            probes: self.probes,
        })
    }
}
