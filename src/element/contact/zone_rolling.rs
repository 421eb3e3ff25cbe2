//! How a loaded zone rolls, and the tractions that follow.

use nalgebra::Vector3;

use super::contact_setup::ContactSetup;
use super::curved_zone::Tractions;
use super::models::Models;
use super::number::ElementNumber;
use super::zone_surface::ZoneSurface;
use crate::element::parameters::CreepageModel;
use crate::kinematics::creepage::{
    ContactAxes, Creepage, RelativeMotion, RollingSpeed, kinematic_creepage, rolling_speed,
};
use crate::normal::Zone;
use crate::tangential::{RollingState, StripForce, UnderLaw};

/// A loaded zone and how it rolls.
pub struct ZoneRolling<T> {
    pub zone: Zone<T>,
    /// Centroid of its load, x from the wheel marker [m].
    pub position: Vector3<T>,
    pub axes: ContactAxes<T>,
    pub rolling_radius: T,
    /// Forward velocity of the wheel over the rail's surface [m/s].
    pub forward: T,
    pub speed: RollingSpeed<T>,
    /// Normal force with damping over that without [-].
    pub load_factor: T,
    /// How much deeper than the even contact line the wheel is along the normal [m].
    pub surface_depth: T,
    /// Lean of the strips of a rail that varies along the track [-].
    pub lean: T,
}

impl<T: ElementNumber> ContactSetup<'_, T> {
    /// How a zone rolls.
    pub(in crate::element) fn rolling(
        &self,
        motion: &RelativeMotion<T>,
        zone: Zone<T>,
        surface: &ZoneSurface<T>,
        load_factor: T,
        minimum_speed: f64,
    ) -> ZoneRolling<T> {
        let wheel = &self.input.wheel;
        let depth = self.depth(zone.u) + surface.depth;
        let rolling_radius = self.line.wheel_point(zone.u).rolling_radius + surface.radius;
        let position = self.track_point(zone.x, zone.y, depth);
        let forward = wheel.velocity[0] - motion.roller_speed(position);
        ZoneRolling {
            zone,
            position,
            axes: self.axes().leaning(surface.lean),
            rolling_radius,
            forward,
            speed: rolling_speed(forward, wheel.pitch_rate, rolling_radius, minimum_speed),
            load_factor,
            surface_depth: surface.depth,
            lean: if self.rail.varies() { surface.lean } else { T::from(0.0) },
        }
    }

    /// How the first zone in `models.strips` rolls on bodies without deviations, with its flat
    /// creepage.
    pub(in crate::element) fn rolling_state(&self, models: &Models<T>) -> RollingState<T> {
        let motion = self.motion();
        let load_factor = self.load_factor(&motion, None, models);
        let zone = models.strips.zones[0];
        let surface =
            if self.rail.varies() { self.met_surface(&zone, models) } else { ZoneSurface::even() };
        let rolling = self.rolling(&motion, zone, &surface, load_factor, models.minimum_speed);
        let creepage = if models.creepage == CreepageModel::Kinematic {
            self.kinematic(&rolling)
        } else {
            motion.creepage(rolling.position, &rolling.axes, rolling.speed.reference)
        };
        self.state(&rolling, creepage)
    }

    fn kinematic(&self, rolling: &ZoneRolling<T>) -> Creepage<T> {
        kinematic_creepage(
            rolling.forward,
            self.input.wheel.pitch_rate,
            rolling.rolling_radius,
            rolling.speed.reference,
        )
    }

    fn state(&self, rolling: &ZoneRolling<T>, creepage: Creepage<T>) -> RollingState<T> {
        RollingState {
            creepage,
            forward_share: rolling.speed.forward_share,
            friction: self.input.friction,
            load_factor: rolling.load_factor,
            speed: rolling.speed.reference,
        }
    }

    /// How a zone rolls under the laws of friction, and its tractions on the wheel where there are
    /// any.
    pub(in crate::element) fn tractions(
        &self,
        motion: &RelativeMotion<T>,
        models: &mut Models<T>,
        rolling: &ZoneRolling<T>,
    ) -> (UnderLaw<T>, Option<Tractions<T>>) {
        let ZoneRolling { zone, position, axes, speed, surface_depth, lean, .. } = rolling;
        let Models { curved_zone, strips, tangential, material, wear, given, .. } = models;
        let material = &material.fixed();
        let mut wear = wear.as_deref_mut().filter(|wear| wear.is_recording());
        if let Some(wear) = &mut wear {
            wear.begin_zone(zone.first, zone.count);
        }
        if let Some(given) = given.take() {
            if let Some(wear) = wear {
                for (j, [dissipation, slip_area]) in given.strips.iter().enumerate() {
                    wear.add_strip(zone.first + j, dissipation.value(), slip_area.value());
                }
            }
            let state = self.state(rolling, given.creepage);
            let law = tangential.under_law(zone, strips, material, &state);
            return (law, Some(given.about(*position)));
        }
        let creepage = match models.creepage {
            CreepageModel::Flat => motion.creepage(*position, axes, speed.reference),
            CreepageModel::Kinematic => self.kinematic(rolling),
            CreepageModel::Curved => {
                let place = |u, x| {
                    let [point, tangent] = self.surface(u, x);
                    [point + axes.normal * *surface_depth, tangent]
                };
                curved_zone.place(zone, strips, motion, speed.reference, *lean, place)
            }
        };
        let state = self.state(rolling, creepage);
        let law = tangential.under_law(zone, strips, material, &state);
        let place = *position;
        let tractions = match (models.creepage, wear) {
            (CreepageModel::Curved, None) => {
                let each = |_, _, _| {};
                curved_zone.tractions(zone, strips, tangential, &law, place, each)
            }
            (CreepageModel::Curved, Some(wear)) => {
                let each = |j, dissipation: T, slip_area: T| {
                    wear.add_strip(j, dissipation.value(), slip_area.value());
                };
                curved_zone.tractions(zone, strips, tangential, &law, place, each)
            }
            (_, None) => {
                let each = |_, _: &StripForce<T>| {};
                let force = tangential.creep_force_under(zone, strips, &law, each);
                force.map(|force| Tractions::flat(&force, &creepage, axes))
            }
            (_, Some(wear)) => {
                let each = |j: usize, force: &StripForce<T>| {
                    let (x, y) = (strips.x[j] - zone.x, strips.y[j] - zone.y);
                    let dissipation = force.longitudinal
                        * (creepage.longitudinal - y * creepage.spin)
                        + force.lateral * (creepage.lateral + x * creepage.spin)
                        + force.moment * creepage.spin;
                    wear.add_strip(j, -dissipation.value(), force.slip_area.value());
                };
                let force = tangential.creep_force_under(zone, strips, &law, each);
                force.map(|force| Tractions::flat(&force, &creepage, axes))
            }
        };
        (law, tractions)
    }
}
