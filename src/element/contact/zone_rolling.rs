//! How a loaded zone rolls.

use super::contact_setup::ContactSetup;
use super::laid_zones::{LaidZone, ZoneRolling};
use super::models::Models;
use super::number::ElementNumber;
use super::zone_surface::ZoneSurface;
use crate::element::parameters::CreepageModel;
use crate::kinematics::creepage::{Creepage, RelativeMotion, kinematic_creepage, rolling_speed};
use crate::normal::Zone;
use crate::tangential::{RollingState, UnderLaw};

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
        let forward = self.forward() - motion.roller_speed(position);
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

    /// How the first zone in `models.strips` rolls with its flat creepage.
    pub(in crate::element) fn rolling_state(&self, models: &Models<T>) -> RollingState<T> {
        let motion = self.motion();
        let load_factor = self.load_factor(&motion, models);
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

    /// Lays the zones of `models.strips` from number `first` on, which are in the frame of this
    /// contact, beside those under way.
    pub(in crate::element) fn lay(
        &self,
        separation: &T::Separation<'_>,
        models: &mut Models<T>,
        first: usize,
    ) {
        let motion = self.motion();
        let load_factor = self.load_factor(&motion, models);
        self.fill_friction(separation, &mut models.strips);
        for index in first..models.strips.zones.len() {
            let zone = models.strips.zones[index];
            if zone.load <= 0.0 || zone.width <= 0.0 {
                continue;
            }
            let surface = if self.rail.varies() || self.line.varies_around() {
                self.met_surface(&zone, models)
            } else {
                ZoneSurface::even()
            };
            let rolling = self.rolling(&motion, zone, &surface, load_factor, models.minimum_speed);
            let law = self.under_law(&motion, models, &rolling);
            models.rolling.zones.push(LaidZone {
                index,
                contact: self.contact,
                resultant_share: self.resultant_share,
                origin: if self.is_on_arc { self.contact.rail_s } else { T::from(0.0) },
                rolling,
                surface,
                law,
            });
        }
    }

    /// How a zone rolls under the laws of friction; takes its strips on the wheel's surface.
    fn under_law(
        &self,
        motion: &RelativeMotion<T>,
        models: &mut Models<T>,
        rolling: &ZoneRolling<T>,
    ) -> UnderLaw<T> {
        let ZoneRolling { zone, position, axes, speed, surface_depth, lean, .. } = rolling;
        let Models { rolling: zones, strips, tangential, material, given, creepage, .. } = models;
        let creepage = match (given, creepage) {
            (Some(given), _) => given.creepage,
            (_, CreepageModel::Flat) => motion.creepage(*position, axes, speed.reference),
            (_, CreepageModel::Kinematic) => self.kinematic(rolling),
            (_, CreepageModel::Curved) => {
                let place = |u, x| {
                    let [point, tangent] = self.surface(u, x);
                    [point + axes.normal * *surface_depth, tangent]
                };
                let course = (self.frame.along(), *lean);
                zones.strips.place(zone, strips, motion, speed.reference, course, place)
            }
        };
        let state = self.state(rolling, creepage);
        tangential.under_law(zone, strips, &material.fixed(), &state)
    }
}
