//! The separation at several places at once.
//!
//! The steps are those of one place after the other, as loops over [`LANES`] places that are
//! compiled to vector instructions. The point of the rail is looked for from the contact point, as
//! far along the arc of the curvature there as the place is across. What is not found in a few
//! steps, and what no loop can do, is done one by one.

use super::{LineSeparation, MIN_COSINE};
use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::separation::{Separation, SeparationPoint};
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::math::vectors::with_vectors;

/// Places that are looked up at once.
const LANES: usize = 8;
type Lanes = [f64; LANES];

/// Newton steps for the points of the rail opposite to those of the wheel; one or two are the rule.
const MAX_STEPS: usize = 5;
/// Distance over which the rail's curve is a parabola to rounding [m]: the start is the same for
/// all places, so that steps are not as short as from place to place.
const NEAR: f64 = 2e-7;

impl LineSeparation<'_> {
    /// As [`Separation::fill`].
    pub(super) fn fill_lanes(&mut self, us: &[f64], found: &mut [SeparationPoint]) {
        let is_even = !self.line.varies_around();
        if is_even {
            fill_blocks(self.line, self.rail, &self.contact, us, found);
        }
        for (u, found) in us.iter().zip(found) {
            if !is_even || found.f.is_nan() {
                *found = self.at(*u);
            }
        }
    }
}

/// Fills `found` for the parameters `us` block by block; the separation is not a number where it
/// was not found.
fn fill_blocks(
    line: &ContactLine,
    rail: &PlacedRail,
    contact: &Contact,
    us: &[f64],
    found: &mut [SeparationPoint],
) {
    with_vectors(
        #[inline(always)]
        || {
            for (us, found) in us.chunks(LANES).zip(found.chunks_mut(LANES)) {
                // Idle lanes do what the last one does.
                let lanes: Lanes = std::array::from_fn(|lane| us[lane.min(us.len() - 1)]);
                let block = block(line, rail, contact, &lanes);
                found.copy_from_slice(&block[..found.len()]);
            }
        },
    );
}

// Inside each instruction set or not at all: a call would not be vectorised.
#[inline(always)]
fn block(
    line: &ContactLine,
    rail: &PlacedRail,
    contact: &Contact,
    us: &Lanes,
) -> [SeparationPoint; LANES] {
    let (origin, tangent, normal) = (contact.origin, contact.tangent, contact.normal());
    let along = |v: &[f64; 2], axis: &[f64; 2]| v[0] * axis[0] + v[1] * axis[1];
    let from_origin = |point: &[f64; 2]| [point[0] - origin[0], point[1] - origin[1]];
    let pieces = line.profile().pieces_at(us);
    let [mut x, mut y, mut dy, mut depth] = [[0.0; LANES]; 4];
    for lane in 0..LANES {
        let p = pieces.at(lane, us[lane]);
        let (at, derivative) = line.outline_with_derivative(&p);
        let to = from_origin(&at.point);
        x[lane] = at.x;
        y[lane] = along(&to, &tangent);
        dy[lane] = along(&derivative, &tangent);
        let is_ended = line.follows_rim(&p) || dy[lane] < MIN_COSINE;
        depth[lane] = if is_ended { f64::NAN } else { along(&to, &normal) };
    }
    let curve = rail.curve();
    let curvature = rail.curvature(contact.rail_s);
    let lengthening = curvature * curvature / 6.0;
    let mut s = y.map(|y| curve.within(contact.rail_s + y * (1.0 + lengthening * y * y)));
    let (mut opposite, mut rail_s) = ([f64::NAN; LANES], s);
    for _ in 0..MAX_STEPS {
        let pieces = curve.pieces_at(&s);
        let mut missing = [0.0; LANES];
        for lane in 0..LANES {
            let p = pieces.at(lane, s[lane]);
            let cosine = along(&p.first, &tangent);
            let to = from_origin(&p.point);
            let steepness = 1.0 / cosine;
            let step = -(along(&to, &tangent) - y[lane]) * steepness;
            // As for one place: over the last step the curve is a parabola.
            let last = step * (1.0 - 0.5 * (step * along(&p.second, &tangent) * steepness));
            let at_last = along(&to, &normal)
                + last * (along(&p.first, &normal) + 0.5 * last * along(&p.second, &normal));
            let is_near = step.abs() <= NEAR;
            let has_turned = cosine < MIN_COSINE;
            opposite[lane] = if is_near && !has_turned { at_last } else { f64::NAN };
            rail_s[lane] = s[lane] + last;
            missing[lane] = if is_near || has_turned { 0.0 } else { 1.0 };
            // What is found stays, and is found again.
            s[lane] = if is_near { s[lane] } else { curve.within(s[lane] + step) };
        }
        if missing.iter().sum::<f64>() == 0.0 {
            break;
        }
    }
    if let Some(varying) = rail.variation() {
        for (x, s) in x.iter_mut().zip(rail_s) {
            *x += varying.ahead(s);
        }
    }
    std::array::from_fn(|lane| SeparationPoint {
        x: x[lane],
        y: y[lane],
        dy: dy[lane],
        f: opposite[lane] - depth[lane] + contact.penetration,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::contacts::contact_search::ContactSearch;
    use crate::geometry::profiles::profile::ProfileKind;
    use crate::geometry::wheel::contact_line::WheelPose;
    use crate::io::load_profile;

    /// Calls `each` for the contacts of S1002 on 60E1 from tread to flange, straight and yawed, as
    /// deep as `depth` [m].
    fn for_each_contact(depth: f64, mut each: impl FnMut(LineSeparation)) {
        let load = |name, kind| load_profile("profile", name, kind, 0.0, &[]).unwrap().curve;
        let (wheel, rail) = (load("S1002", ProfileKind::Wheel), load("60E1", ProfileKind::Rail));
        let rail = PlacedRail::by_gauge(&rail, 0.025, 1.435, 0.014, false).unwrap();
        let mut search = ContactSearch::new(&wheel);
        let mut contacts = 0;
        for i in 0..60 {
            let yaw = if i % 3 == 0 { 0.0 } else { 1e-3 * f64::from(i % 7) };
            let y = 0.74 + 3e-4 * f64::from(i) - rail.marker[0];
            let mut pose = WheelPose { marker: [0.0, y, -0.465], roll: 1e-3, yaw };
            // Down to the depth in steps.
            for _ in 0..200 {
                let line = ContactLine::new(&wheel, 0.46, &pose);
                search.search(&line, &rail, &[line.range()]);
                if search.contacts.iter().any(|contact| contact.penetration > depth) {
                    break;
                }
                pose.marker[2] += 1e-4;
            }
            let line = ContactLine::new(&wheel, 0.46, &pose);
            contacts += search.contacts.len();
            for contact in search.contacts.iter() {
                each(LineSeparation::new(&line, &rail, *contact));
            }
        }
        assert!(contacts >= 60, "{contacts}");
    }

    #[test]
    fn many_places_are_as_one_by_one_in_any_order() {
        let (mut worst, mut beyond) = (0.0f64, 0);
        for_each_contact(1e-5, |mut separation| {
            for reach in [5e-4, 5e-3, 6e-2] {
                let u = |i: usize| separation.contact.u + reach * (0.083 * i as f64 - 1.0);
                let us: [f64; 25] = std::array::from_fn(u);
                let mut found = [SeparationPoint::default(); 25];
                separation.fill(&us, &mut found);
                let mut single = found;
                for (u, own) in us.iter().zip(&mut single).rev() {
                    separation.fill(&[*u], std::slice::from_mut(own));
                }
                // What is done one by one, far away, starts from the last place.
                assert!(reach > 0.01 || found == single);
                for (u, found) in us.iter().zip(found) {
                    let at = separation.at(*u);
                    assert_eq!(at.f.is_finite(), found.f.is_finite());
                    assert_eq!(SeparationPoint { f: found.f, ..at }, found);
                    if at.f.is_finite() {
                        worst = worst.max((at.f - found.f).abs());
                    } else {
                        beyond += 1;
                    }
                }
            }
        });
        // One by one the last Newton step may be 3 µm long.
        assert!(worst < 1e-12, "{worst:e}");
        assert!(beyond > 0);
    }

    #[test]
    fn the_rate_is_that_of_differences() {
        for_each_contact(1e-5, |mut separation| {
            for i in 0..9 {
                let u = separation.contact.u + 1e-3 * (f64::from(i) - 4.1);
                let [f, rate] = separation.with_rate(u).unwrap();
                let [before, after] = [-1e-7, 1e-7].map(|step| separation.at(u + step).f);
                if before.is_finite() && after.is_finite() {
                    approx::assert_abs_diff_eq!(rate, (after - before) / 2e-7, epsilon = 3e-6);
                    assert!((f - before).abs() < 1e-6);
                }
            }
        });
    }
}
