//! The contacts of an element as planar problems, to look at them one by one.

use nalgebra::Vector3;

use crate::element::contact::contact_setup::ContactSetup;
use crate::element::contact::rail_walk::RailPlace;
use crate::friction::StripFriction;
use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::line_separation::LineSeparation;
use crate::geometry::contacts::separation::Separation;
use crate::kinematics::creepage::rolling_speed;

/// One contact frame laid flat: the planar problem whose solution are its patches, but for the
/// shift of the contact line along the track that a yawed wheel has.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FlatContact {
    /// Number of the rail, from 1.
    pub rail: i32,
    /// Contact angle; negative on the right tread [rad].
    pub contact_angle: f64,
    /// Contact point of the wheel in the track frame, y and z [m].
    pub position: [f64; 2],
    /// Separation f from the contact point: points (y, f), y growing [m].
    pub separation: Vec<[f64; 2]>,
    /// Radius of the wheel's normal section along x, together with that of a rail that varies along
    /// the track [m].
    pub radius: f64,
    /// Approach [m].
    pub penetration: f64,
    /// Longitudinal, lateral [-] and spin [1/m] creepage at the contact point of the plane body that
    /// creeps as the wheel does in the middle of the overlap.
    pub creepage: [f64; 3],
    /// Coefficient of friction at the contact point, without sliding [-].
    pub friction: f64,
    /// Friction at places y of the separation, where it is not the same all over the rail; else
    /// empty.
    pub friction_across: Vec<(f64, StripFriction)>,
    /// Place of the contact point along the profiles of wheel and rail, the parameter of their curves
    /// ([`Element::worn_wheel`](crate::element::Element::worn_wheel), `worn_rail`); it grows with y of
    /// the contact frame, arc by arc [m].
    pub profile_arcs: [f64; 2],
    /// Outline of the wheel near the contact in the track frame, points (y, z) [m].
    pub wheel: Vec<[f64; 2]>,
    /// Outline of the rail near the contact in the track frame, points (y, z) [m].
    pub rail_head: Vec<[f64; 2]>,
}

/// Points of a separation.
const POINTS: usize = 401;
/// How far from the contact point a separation goes, and the outlines [m].
const REACH: f64 = 0.02;
/// Separations beyond this do not close [m].
const BEYOND: f64 = 1e-3;

impl ContactSetup<'_> {
    /// The contact laid flat, without the overlaps that others have `taken`, each from one parameter
    /// of the contact line to another; its own are taken then [m].
    pub fn flattened(
        &self,
        separation: &mut LineSeparation,
        radius: f64,
        minimum_speed: f64,
        taken: &mut Vec<[f64; 2]>,
    ) -> FlatContact {
        let [start, end] = self.line.range();
        let (from, to) = ((self.contact.u - REACH).max(start), (self.contact.u + REACH).min(end));
        let mut points: Vec<[f64; 2]> = Vec::with_capacity(POINTS);
        let mut outline = Vec::with_capacity(POINTS);
        let mut friction_across = Vec::new();
        let Contact { u, penetration, .. } = self.contact;
        let place = self.track_point(self.line.at(u).x, 0.0, self.depth(u));
        // Parameter, place across and weight: the square of the overlap is about as the load is spread.
        let mut overlaps: Vec<[f64; 3]> = Vec::with_capacity(POINTS);
        for step in 0..POINTS {
            let u = from + (to - from) * step as f64 / (POINTS - 1) as f64;
            let at = separation.at(u);
            let point: Vector3<f64> = self.frame.point(self.line.at(u).point, 0.0);
            outline.push([point.y, point.z]);
            let grows = points.last().is_none_or(|last| at.y > last[0]);
            if at.f < BEYOND && grows {
                points.push([at.y, at.f]);
                let overlap = (penetration - at.f).max(0.0);
                overlaps.push([u, at.y, overlap * overlap * at.dy]);
                let place = RailPlace::at(&self.rail, separation.last_rail_parameter());
                let own = self.strip_friction(&place, at.x);
                friction_across.extend(own.map(|own| (at.y, own)));
            }
        }
        let kept = self.apart(&overlaps, &points, taken);
        let is_kept = |y: f64| y >= kept[0] && y <= kept[1];
        points.retain(|&[y, _]| is_kept(y));
        overlaps.retain(|&[_, y, _]| is_kept(y));
        friction_across.retain(|&(y, _)| is_kept(y));
        let runs = overlaps.split(|[.., weight]| *weight <= 0.0);
        taken.extend(runs.filter_map(|run| Some([run.first()?[0], run.last()?[0]])));
        // The overlap around the contact point, not others that it reaches to.
        let own = overlaps
            .split(|[.., weight]| *weight <= 0.0)
            .find(|run| run.last().is_some_and(|last| last[0] >= u));
        let middle = own.map_or([u, 0.0], |own| {
            let weight: f64 = own.iter().map(|at| at[2]).sum();
            [0, 1].map(|k| own.iter().map(|at| at[2] * at[k]).sum::<f64>() / weight)
        });
        let creepage = self.flat_creepage(middle, minimum_speed);
        let curve = self.rail.rail.curve();
        let (from, to) = (
            (self.contact.rail_s - REACH).max(curve.start()),
            (self.contact.rail_s + REACH).min(curve.end()),
        );
        let rail_head = (0..POINTS).map(|step| {
            let s = from + (to - from) * step as f64 / (POINTS - 1) as f64;
            let point = self.frame.point(curve.at(s).point, 0.0);
            [point.y, point.z]
        });
        FlatContact {
            rail: self.k as i32 + 1,
            contact_angle: self.contact_angle(),
            position: [place.y, place.z],
            separation: points,
            radius,
            penetration,
            creepage,
            friction: self
                .strip_friction(&RailPlace::at(&self.rail, self.contact.rail_s), place.x)
                .map_or(self.input.friction, |own| own.under(&[1.0; 2])),
            friction_across,
            profile_arcs: [self.contact.u, self.contact.rail_s],
            wheel: outline,
            rail_head: rail_head.collect(),
        }
    }

    /// From where to where across it lies apart from what others have `taken`: up to the greatest
    /// separation on the way to them; `overlaps` have the parameters and places of its `points` [m].
    fn apart(&self, overlaps: &[[f64; 3]], points: &[[f64; 2]], taken: &[[f64; 2]]) -> [f64; 2] {
        let own = self.contact.u;
        let before = taken.iter().map(|run| run[1]).filter(|&u| u < own).reduce(f64::max);
        let behind = taken.iter().map(|run| run[0]).filter(|&u| u > own).reduce(f64::min);
        let greatest = |from: f64, to: f64| {
            let between =
                overlaps.iter().zip(points).filter(|(at, _)| at[0] >= from && at[0] <= to);
            between.map(|(_, point)| *point).max_by(|a, b| a[1].total_cmp(&b[1])).map(|at| at[0])
        };
        [
            before.and_then(|u| greatest(u, own)).unwrap_or(f64::NEG_INFINITY),
            behind.and_then(|u| greatest(own, u)).unwrap_or(f64::INFINITY),
        ]
    }

    /// Longitudinal, lateral and spin creepage that a plane has at the contact point if it creeps as
    /// the wheel does at parameter `u` of its line, which lies `y` beside that point [-, -, 1/m].
    fn flat_creepage(&self, [u, y]: [f64; 2], minimum_speed: f64) -> [f64; 3] {
        let motion = self.motion();
        // On the wheel: in free rolling a tenth of a millimetre counts.
        let place = self.track_point(self.line.at(u).x, y, self.depth(u));
        let speed = rolling_speed(
            self.forward() - motion.roller_speed(place),
            self.input.wheel.pitch_rate,
            self.line.wheel_point(u).rolling_radius,
            minimum_speed,
        );
        let creepage = motion.creepage(place, &self.axes(), speed.reference);
        [creepage.longitudinal + creepage.spin * y, creepage.lateral, creepage.spin]
    }
}
