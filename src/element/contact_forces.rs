//! From the loaded zones of a contact to forces on wheel and rail.

use nalgebra::Vector3;

use super::curved_zone::Tractions;
use super::input::{Input, WheelMotion};
use super::models::Models;
use super::number::ElementNumber;
use super::output::{Output, Patch, Wrench};
use super::parameters::{CreepageModel, NormalModel};
use super::rail_frame::RailFrame;
use super::rail_friction::{LastPlace, RailFriction};
use super::rail_walk::{RailPlace, RailWalk};
use super::wear_sums::WearSums;
use super::work::Work;
use super::zone_surface::{ZoneSurface, closing_speed};
use crate::friction::StripFriction;
use crate::geometry::contact::Contact;
use crate::geometry::contact_line::ContactLine;
use crate::geometry::line_separation::{Lifting, RailSeparation};
use crate::geometry::rail_outline::RailOutline;
use crate::kinematics::creepage::{
    ContactAxes, Creepage, RelativeMotion, RollingSpeed, kinematic_creepage, rolling_speed,
};
use crate::math::real::Real;
use crate::math::smooth_step::smooth_step;
use crate::normal::{Strips, Zone, damping};
use crate::tangential::{Convergence, RollingState, StripForce, UnderLaw};
use crate::wear::rcf;

/// How the normal motion of a contact is damped.
#[derive(Clone, Copy, Debug)]
pub enum Damped<T> {
    /// By its own load and penetration.
    Alone,
    /// By the load and the deepest penetration of all that shares one stiffness [N, m].
    Together([T; 2]),
    /// Its normal force with damping over that without is known [-].
    By(T),
}

/// Brings the solution of one contact to forces on both bodies.
pub struct ContactForces<'a, T = f64> {
    /// Number of the rail, from 0.
    pub k: usize,
    /// The input, of a right side.
    pub input: &'a Input<T>,
    /// The frame of the rail.
    pub frame: RailFrame<T>,
    /// The contact line of the wheel in that frame.
    pub line: ContactLine<'a, T>,
    /// The rail.
    pub rail: RailOutline<'a, T>,
    /// The contact.
    pub contact: Contact<T>,
    /// Slopes of rail and wheel along the track in the contact [-].
    pub slopes: [f64; 2],
    /// How its normal motion is damped.
    pub damped: Damped<T>,
    /// Resultant of the normal loads of its strips over their sum: below one where their normals diverge. Friction is bounded by the loads
    /// themselves, strip by strip, so that a patch that wraps around the rail holds a little more than μ times its normal force [-].
    pub resultant_share: T,
    /// Friction over the surface of the rail, where it is not the same everywhere.
    pub friction: Option<&'a RailFriction>,
    /// Whether the strips lie on the arc of the rail, from the place of the contact on, and not across its frame.
    pub is_on_arc: bool,
}

/// A loaded zone and how it rolls.
struct ZoneRolling<T> {
    zone: Zone<T>,
    /// Centroid of its load, x from the wheel marker [m].
    position: Vector3<T>,
    axes: ContactAxes<T>,
    rolling_radius: T,
    /// Forward velocity of the wheel over the rail's surface [m/s].
    forward: T,
    speed: RollingSpeed<T>,
    /// Normal force with damping over that without [-].
    load_factor: T,
    /// How much deeper than the even contact line the wheel is along the normal [m].
    surface_depth: T,
    /// Lean of the strips of a rail that varies along the track [-].
    lean: T,
}

impl<T: ElementNumber> ContactForces<'_, T> {
    /// Adds the forces of all zones in `models.strips` to `output` and their patches to `models.patches`; returns how many zones
    /// fell back to a simpler tangential model.
    pub fn add(
        &self,
        separation: &mut T::Separation<'_>,
        models: &mut Models<T>,
        output: &mut Output<T>,
        work: &mut Work,
    ) -> u64 {
        let mut fallbacks = 0;
        let [station, ..] = self.input.wheel.position;
        let wheel = self.wheel();
        let wheel_marker = Vector3::from(wheel.position);
        let motion = self.motion();
        let even_axes = self.axes();
        let lifting = separation.lifting();
        let load_factor = self.load_factor(&motion, lifting.as_ref(), models);
        self.fill_friction(separation, &mut models.strips);
        for index in 0..models.strips.zones.len() {
            let zone = models.strips.zones[index];
            if zone.load <= 0.0 || zone.width <= 0.0 {
                continue;
            }
            work.zones += 1;
            let surface = match &lifting {
                Some(lifting) => {
                    T::zone_surface(&self.line, self.contact.u, lifting, &zone, models)
                }
                None if self.rail.varies() || self.line.varies_around() => {
                    self.met_surface(&zone, models)
                }
                None => ZoneSurface::even(),
            };
            let axes = even_axes.leaning(surface.lean);
            let rolling = self.rolling(&motion, zone, &surface, load_factor, models.minimum_speed);
            let ZoneRolling { position, rolling_radius, speed, forward, .. } = rolling;
            let wheel_point = self.line.wheel_point(zone.u);
            let (law, tractions) = self.tractions(&motion, models, &rolling);
            work.marches += u64::from(tractions.is_some());
            let tractions = tractions.unwrap_or_default();
            let Convergence { fell_back, residual } = tractions.convergence;
            fallbacks += u64::from(fell_back);
            output.tangential_residual = output.tangential_residual.at_least(residual);
            let normal_force = zone.load * load_factor * self.resultant_share;
            let pressing = axes.normal * -normal_force;
            let bearing = match lifting {
                None => {
                    // Where the even part of the normal meets the axle, the part that leans does too.
                    let even =
                        position - Vector3::x() * surface.ahead - even_axes.normal * surface.depth;
                    position + (meeting_axle(&wheel, even, even_axes.normal) - even)
                }
                Some(_) => position,
            };
            add(&mut output.wheel, tractions.force, position - wheel_marker, tractions.moment);
            add(&mut output.wheel, pressing, bearing - wheel_marker, Vector3::zeros());
            let creep_force =
                [axes.longitudinal, axes.lateral].map(|axis| tractions.force.dot(&axis));
            let position = position + Vector3::x() * station;
            let (rail, marker) = (&mut output.rails[self.k], self.frame.marker);
            add(rail, -tractions.force, position - marker, -tractions.moment);
            add(rail, -pressing, bearing + Vector3::x() * station - marker, Vector3::zeros());
            let dissipation = tractions.dissipation.at_least(0.0);
            if models.wear.as_deref().is_some_and(WearSums::is_recording) {
                T::record(&self.line, self.k, index, &law, models, separation);
            }
            let frictional_power = dissipation * speed.reference;
            output.wear_number += dissipation;
            output.frictional_power += frictional_power;
            let slip = law.state.creepage;
            models.patches.push(Patch {
                rail: self.k as i32 + 1,
                normal_force,
                creep_force,
                spin_moment: tractions.moment.dot(&axes.normal),
                contact_angle: self.contact.angle() + self.frame.roll,
                position: position.into(),
                wheel_y: wheel_point.y,
                rail_y: self.rail.profile_y(separation.rail_parameter(zone.u)),
                rolling_radius,
                penetration: self.contact.penetration,
                max_pressure: zone.max_pressure * load_factor,
                length: zone.length,
                width: zone.width,
                area: zone.area,
                creepage: [slip.longitudinal, slip.lateral, slip.spin],
                friction_coefficient: law.state.friction,
                temperature: law.temperature,
                slip_share: (tractions.slip_area / zone.area).at_most(1.0),
                frictional_power,
                tgamma_damage: rcf::tgamma_damage(dissipation, creep_force[0] * forward > 0.0),
                surface_fatigue_index: rcf::surface_fatigue_index(
                    normal_force,
                    creep_force,
                    zone.area,
                    models.shear_yield,
                ),
            });
        }
        fallbacks
    }

    /// The wheel, its x from its marker, so that no result depends on the station by rounding.
    fn wheel(&self) -> WheelMotion<T> {
        wheel_here(self.input)
    }

    /// Motion of the wheel against the rail at points with their x from the wheel marker.
    pub(super) fn motion(&self) -> RelativeMotion<T> {
        relative_motion(self.input, self.k, &self.frame)
    }

    /// The surface of the wheel in `zone` on a rail whose section varies along the track, or of one whose own section varies around.
    fn met_surface(&self, zone: &Zone<T>, models: &Models<T>) -> ZoneSurface<T> {
        let (is_ellipse, line) = (models.normal == NormalModel::Hertz, &self.line.round());
        let centre = |u| line.even_at(if is_ellipse { self.contact.u } else { u }).x;
        if self.line.varies_around() {
            return ZoneSurface::beside_round(zone, &models.strips, centre);
        }
        let share = line.lifting_share(self.contact.normal());
        ZoneSurface::met(share, line.lifting_radius(zone.u), zone, &models.strips, centre)
    }

    /// How a zone rolls.
    fn rolling(
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

    /// Gives each of the `strips` a friction of its own, where that is not the same all over the rail.
    pub(super) fn fill_friction(&self, separation: &T::Separation<'_>, strips: &mut Strips<T>) {
        let Some(friction) = self.friction else { return };
        // A Hertzian ellipse can be wider than the wheel.
        let [start, end] = self.line.range();
        let mut walk = RailWalk::new(self.rail, self.contact);
        let (hand, mut last) = (self.rail.rail.hand(), LastPlace::default());
        let Strips { y, u, x, friction: own, .. } = strips;
        own.extend(y.iter().zip(u.iter()).zip(x.iter()).map(|((&y, &u), &x)| {
            let place = if self.is_on_arc {
                RailPlace::at(&self.rail, self.contact.rail_s + y)
            } else {
                // A separation remembers its last point; what is found with it later is not to depend on friction.
                walk.to(y, || separation.clone().rail_parameter(u.within(start, end)))
            };
            friction.at(&place, hand, self.station(x), self.input, &mut last)
        }));
    }

    /// Station of a place `x` along the track from the wheel marker [m].
    #[inline]
    fn station(&self, x: T) -> T {
        self.input.track_s + self.input.wheel.position[0] + x
    }

    /// Friction at a `place` of the rail and `x` along the track from the wheel marker, where it is not the same all over the rail.
    #[inline]
    pub(super) fn strip_friction(&self, place: &RailPlace<T>, x: T) -> Option<StripFriction<T>> {
        let hand = self.rail.rail.hand();
        self.friction.map(|friction| {
            friction.at(place, hand, self.station(x), self.input, &mut LastPlace::default())
        })
    }

    /// How the first zone in `models.strips` rolls on bodies without deviations, with its flat creepage.
    pub(super) fn rolling_state(&self, models: &Models<T>) -> RollingState<T> {
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

    /// How a zone rolls under the laws of friction, and its tractions on the wheel where there are any.
    fn tractions(
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

    /// The axes of the contact frame in the track frame.
    pub(super) fn axes(&self) -> ContactAxes<T> {
        ContactAxes::along_track(
            self.frame.direction(self.contact.tangent),
            self.frame.direction(self.contact.normal()),
        )
    }

    /// Normal force with damping over that without [-].
    fn load_factor(
        &self,
        motion: &RelativeMotion<T>,
        lifting: Option<&Lifting>,
        models: &Models<T>,
    ) -> T {
        let [load, penetration] = match self.damped {
            Damped::Alone => [models.strips.load(), self.contact.penetration],
            Damped::Together(whole) => whole,
            Damped::By(load_factor) => return load_factor,
        };
        let closing_speed = self.closing_speed(motion, lifting, &models.strips);
        let damped = damping::damped_load(load, penetration, closing_speed, models.damping);
        if load > 0.0 { damped / load } else { T::from(0.0) }
    }

    /// Depth along the normal of the even contact line at parameter `u` [m].
    fn depth(&self, u: T) -> T {
        let at = self.line.even_at(u);
        let to = [at.point[0] - self.contact.origin[0], at.point[1] - self.contact.origin[1]];
        let axis = self.contact.normal();
        to[0] * axis[0] + to[1] * axis[1]
    }

    /// Speed at which the bodies close along the normal, without the turning of a round wheel [m/s].
    fn closing_speed(
        &self,
        motion: &RelativeMotion<T>,
        lifting: Option<&Lifting>,
        strips: &Strips<T>,
    ) -> T {
        let wheel = &self.input.wheel;
        let load = strips.load();
        // Uneven bodies may touch in several places at once: their mean closing speed has no jump where the first one changes.
        let along = self.rail.along(self.contact.rail_s);
        let x = if (lifting.is_some() || along.is_some()) && load > 0.0 {
            strips.zones.iter().map(|zone| zone.load * zone.x).sum::<T>() / load
        } else {
            self.line.even_at(self.contact.u).x
        };
        // The wheel's surface of first touch lies deeper in the rail by the penetration.
        let touch = self.track_point(x, T::from(0.0), self.contact.penetration);
        let normal = self.frame.direction(self.contact.normal());
        let even = motion.closing_velocity(touch).dot(&normal);
        let [forward, ..] = wheel.velocity;
        if let Some(along) = along {
            return even + forward * along.lean;
        }
        if self.line.varies_around() {
            let ahead = self.line.ahead_of_round(self.contact.u);
            return even + motion.turning_velocity(ahead).dot(&normal);
        }
        let Some(lifting) = lifting else { return even };
        let radius = self.line.nominal_radius();
        even + closing_speed(lifting, self.slopes, forward, wheel.pitch_rate, radius)
    }

    /// Point and tangent of the wheel's surface at parameter `u` of the contact line and `x` along the track from the wheel marker, in
    /// the track frame.
    fn surface(&self, u: T, x: T) -> [Vector3<T>; 2] {
        // A Hertzian ellipse can be wider than the wheel.
        let [start, end] = self.line.range();
        let at = self.line.even_at(u.within(start, end));
        let point = self.frame.marker + self.frame.direction(at.point) + Vector3::x() * x;
        let tangent = self.frame.direction(at.tangent);
        [point, tangent / tangent.dot(&tangent).sqrt()]
    }

    /// A point given by its x from the wheel marker and its lateral coordinate and depth in the contact frame.
    pub(super) fn track_point(&self, x: T, y: T, depth: T) -> Vector3<T> {
        let (o, t, n) = (self.contact.origin, self.contact.tangent, self.contact.normal());
        let point = [o[0] + y * t[0] + depth * n[0], o[1] + y * t[1] + depth * n[1]];
        self.frame.marker + self.frame.direction(point) + Vector3::x() * x
    }
}

/// The motion of the wheel, whose place along the track is that from which x is counted.
fn wheel_here<T: Real>(input: &Input<T>) -> WheelMotion<T> {
    let [_, y, z] = input.wheel.position;
    WheelMotion { position: [T::from(0.0), y, z], ..input.wheel }
}

/// Motion of the wheel against rail number `k`, from 0, at points with their x from the wheel marker.
pub(super) fn relative_motion<T: Real>(
    input: &Input<T>,
    k: usize,
    frame: &RailFrame<T>,
) -> RelativeMotion<T> {
    frame.relative_motion(&wheel_here(input), &input.rails[k], input.wheel.position[0])
}

/// The place at which the normal force of a patch on an even wheel acts: `position`, moved along x so that the line of action along `normal`
/// meets the axle of the `wheel`, as every normal of a surface of revolution does.
///
/// With the axle u through the marker M and (P - M) · (n × u) = 0, n without a part along x,
///
/// ```text
/// x - M_x = u_x ((y - M_y) n_z - (z - M_z) n_y) / (u_y n_z - u_z n_y)
/// ```
///
/// A wheel that does not yaw has its normals over the axle. Those of a flank lie ahead of it or behind, by r tan(angle) sin(yaw); the
/// centroid of the load is a little off that, because the normal there is not that of the contact frame. Normals along the axle, as of
/// a flange back, meet it nowhere and have no moment about it.
fn meeting_axle<T: Real>(
    wheel: &WheelMotion<T>,
    position: Vector3<T>,
    normal: Vector3<T>,
) -> Vector3<T> {
    let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) = (wheel.roll.sin_cos(), wheel.yaw.sin_cos());
    // R_x(roll) R_z(yaw) e_y
    let axle = Vector3::new(-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll);
    let to = position - Vector3::from(wheel.position);
    let facing = axle.y * normal.z - axle.z * normal.y;
    let [none, all] = FACING;
    if facing.abs() <= none {
        return position;
    }
    let share = smooth_step(((facing.abs() - none) / (all - none)).at_most(1.0));
    let x = axle.x * (to.y * normal.z - to.z * normal.y) / facing;
    position + Vector3::x() * (share * (x - to.x))
}

/// Sines of the angle between normal and axle below which the normal force acts at the centroid of the load, and from which on where its line
/// meets the axle: within 1 to 3 degrees the rim of a flange back is only as good as the smoothing over of its two ends.
const FACING: [f64; 2] = [0.02, 0.05];

/// Adds a force on a body that acts at `arm` from its marker, and a free moment.
fn add<T: Real>(wrench: &mut Wrench<T>, force: Vector3<T>, arm: Vector3<T>, moment: Vector3<T>) {
    let moment = arm.cross(&force) + moment;
    for i in 0..3 {
        wrench.force[i] += force[i];
        wrench.moment[i] += moment[i];
    }
}
