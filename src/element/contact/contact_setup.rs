//! One contact of the wheel with a rail: its frame and its bodies, how they move there, and its
//! friction.
//!
//! The same for plain numbers and for those with derivatives, whichever normal model solves it.

use nalgebra::Vector3;

use super::models::Models;
use super::number::ElementNumber;
use super::rail_frame::RailFrame;
use super::rail_friction::{LastPlace, RailFriction};
use super::rail_walk::{RailPlace, RailWalk};
use super::zone_surface::{self, ZoneSurface};
use crate::element::input::{Input, WheelMotion};
use crate::element::parameters::NormalModel;
use crate::friction::StripFriction;
use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::line_separation::RailSeparation;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::rail_outline::RailOutline;
use crate::geometry::rail::varying_rail::VaryingRail;
use crate::geometry::uneven::wavy_section::WavySection;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::kinematics::creepage::{ContactAxes, RelativeMotion};
use crate::math::real::Real;
use crate::normal::{Strips, Zone, damping};

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

/// Waves of a contact whose pressure may lie on several of them.
#[derive(Clone, Copy, Debug)]
pub struct ContactWaves<'a> {
    /// The waves along the track.
    pub section: WavySection<'a>,
    /// By how much those of rail and wheel are steeper in the mean of the pressure than where the
    /// bodies are nearest [-].
    pub steeper: [f64; 2],
}

/// One contact of the wheel with a rail: where it is, and how the bodies move there.
pub struct ContactSetup<'a, T = f64> {
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
    /// Waves of both bodies, where a strip may touch more than one.
    pub waves: Option<ContactWaves<'a>>,
    /// How its normal motion is damped.
    pub damped: Damped<T>,
    /// Resultant of the normal loads of its strips over their sum: below one where their normals
    /// diverge. Friction is bounded by the loads themselves, strip by strip, so that a patch that
    /// wraps around the rail holds a little more than μ times its normal force [-].
    pub resultant_share: T,
    /// How far its load is ahead of the contact line of a round wheel, where that is known better
    /// than by its strips [m].
    pub ahead: Option<T>,
    /// Friction over the surface of the rail, where it is not the same everywhere.
    pub friction: Option<&'a RailFriction>,
    /// Whether the strips lie on the arc of the rail, from the place of the contact on, and not
    /// across its frame.
    pub is_on_arc: bool,
}

impl<T: ElementNumber> ContactSetup<'_, T> {
    /// The wheel, its x from its marker, so that no result depends on the station by rounding.
    pub(in crate::element) fn wheel(&self) -> WheelMotion<T> {
        wheel_here(self.input)
    }

    /// Motion of the wheel against the rail at points with their x from the wheel marker.
    pub(in crate::element) fn motion(&self) -> RelativeMotion<T> {
        relative_motion(self.input, self.k, &self.frame)
    }

    /// Velocity of the wheel marker along the rail [m/s].
    pub(in crate::element) fn forward(&self) -> T {
        let velocity = self.input.wheel.velocity;
        self.frame
            .course()
            .map_or(velocity[0], |_| Vector3::from(velocity).dot(&self.frame.along()))
    }

    /// Contact angle, about the track [rad].
    pub(in crate::element) fn contact_angle(&self) -> T {
        if self.frame.course().is_none() {
            return self.contact.angle() + self.frame.roll;
        }
        let normal = self.frame.direction(self.contact.normal());
        (T::from(0.0) - normal.y).atan2(normal.z)
    }

    /// The axes of the contact frame in the track frame.
    pub(in crate::element) fn axes(&self) -> ContactAxes<T> {
        ContactAxes::along(
            self.frame.along(),
            self.frame.direction(self.contact.tangent),
            self.frame.direction(self.contact.normal()),
        )
    }

    /// Depth along the normal of the even contact line at parameter `u` [m].
    pub(in crate::element) fn depth(&self, u: T) -> T {
        let at = self.line.at(u);
        let to = [at.point[0] - self.contact.origin[0], at.point[1] - self.contact.origin[1]];
        let axis = self.contact.normal();
        to[0] * axis[0] + to[1] * axis[1]
    }

    /// Point and tangent of the wheel's surface at parameter `u` of the contact line and `x` along
    /// the track from the wheel marker, in the track frame.
    pub(in crate::element) fn surface(&self, u: T, x: T) -> [Vector3<T>; 2] {
        // A Hertzian ellipse can be wider than the wheel.
        let [start, end] = self.line.range();
        let at = self.line.at(u.within(start, end));
        let point = self.frame.point(at.point, x);
        let tangent = self.frame.direction(at.tangent);
        [point, tangent / tangent.dot(&tangent).sqrt()]
    }

    /// A point given by its x from the wheel marker and its lateral coordinate and depth in the
    /// contact frame.
    pub(in crate::element) fn track_point(&self, x: T, y: T, depth: T) -> Vector3<T> {
        let (o, t, n) = (self.contact.origin, self.contact.tangent, self.contact.normal());
        let point = [o[0] + y * t[0] + depth * n[0], o[1] + y * t[1] + depth * n[1]];
        self.frame.point(point, x)
    }

    /// How far the load of `zone` is ahead of the contact line of a round wheel [m].
    fn ahead_of_line(&self, zone: &Zone<T>, models: &Models<T>) -> T {
        let (is_ellipse, line) = (models.normal == NormalModel::Hertz, self.line.round());
        let centre = |u| line.place(if is_ellipse { self.contact.u } else { u });
        self.ahead.unwrap_or_else(|| zone_surface::ahead(zone, &models.strips, centre))
    }

    /// The surface of the wheel in `zone` on a rail whose section varies along the track, or of one
    /// whose own section varies around.
    pub(in crate::element) fn met_surface(
        &self,
        zone: &Zone<T>,
        models: &Models<T>,
    ) -> ZoneSurface<T> {
        let (line, ahead) = (&self.line.round(), self.ahead_of_line(zone, models));
        let Some(mut along) = self.rail.along(self.contact.rail_s) else {
            return ZoneSurface::beside_round(ahead);
        };
        if let Some(ContactWaves { section, .. }) = self.waves {
            // Between the places where it is nearest the wheel is as it is there.
            let [raised, lever] = section.wheel(zone.x.value(), line.nominal_radius());
            (along.raised, along.lever) = (raised.into(), lever.into());
        }
        let share = line.share_of_height(self.contact.normal());
        let line_ahead = self.line.ahead_of_round(self.contact.u);
        let radius = line.circle_radius(zone.u);
        let mut met = ZoneSurface::met(share, radius, &along, line_ahead, ahead);
        // A rail without waves leans as its rows do, whatever the wheel is like.
        let is_even = |varying: &VaryingRail| varying.has_waves() && !varying.is_corrugated();
        if self.rail.rail.variation().is_some_and(is_even) {
            met.lean = along.lean;
        }
        met
    }

    /// Normal force with damping over that without [-].
    pub(in crate::element) fn load_factor(
        &self,
        motion: &RelativeMotion<T>,
        models: &Models<T>,
    ) -> T {
        let [load, penetration] = match self.damped {
            Damped::Alone => [models.strips.load(), self.contact.penetration],
            Damped::Together(whole) => whole,
            Damped::By(load_factor) => return load_factor,
        };
        let closing_speed = self.closing_speed(motion, models);
        let damped = damping::damped_load(load, penetration, closing_speed, models.damping);
        if load > 0.0 { damped / load } else { T::from(0.0) }
    }

    /// Speed at which the bodies close along the normal, without the turning of a round wheel
    /// [m/s].
    fn closing_speed(&self, motion: &RelativeMotion<T>, models: &Models<T>) -> T {
        let strips = &models.strips;
        let load = strips.load();
        // Uneven bodies may touch in several places at once: their mean approach velocity has no
        // jump where the first one changes.
        let mean = |place: &dyn Fn(&Zone<T>) -> T| {
            strips.zones.iter().map(|zone| zone.load * place(zone)).sum::<T>() / load
        };
        let along = self.rail.along(self.contact.rail_s);
        let x = if along.is_some() && load > 0.0 {
            // Ahead of where an even rail is touched, so that one that does not vary is one.
            self.line.round().at(self.contact.u).x + mean(&|zone| self.ahead_of_line(zone, models))
        } else {
            self.line.at(self.contact.u).x
        };
        // The wheel's surface of first touch lies deeper in the rail by the penetration.
        let touch = self.track_point(x, T::from(0.0), self.contact.penetration);
        let normal = self.frame.direction(self.contact.normal());
        let even = motion.approach_velocity(touch).dot(&normal);
        if along.is_some() || self.line.varies_around() {
            let along = along.unwrap_or_default();
            let x = self.line.at(self.contact.u).x + along.ahead;
            let speeds = rail_speeds(self.input, self.k, self.rail.rail, &self.frame);
            let rise = self.rail.rise(self.contact.rail_s, x);
            let rail = RailOutline::closing_speed(&along, rise, speeds);
            let ahead = self.line.ahead_of_round(self.contact.u) + along.lever;
            let arm = self.frame.along() * ahead;
            let steeper = self.steeper(speeds);
            return even + rail + steeper + motion.turning_velocity(arm).dot(&normal);
        }
        even
    }

    /// Speed at which waves close by their mean slopes beyond that by those where the bodies are
    /// nearest, for the `speeds` of wheel and roller [m/s].
    fn steeper(&self, [forward, turning]: [T; 2]) -> T {
        let Some(ContactWaves { section, steeper: [rail, wheel] }) = self.waves else {
            return T::from(0.0);
        };
        let lever = wheel * section.lever_per_slope(self.line.nominal_radius());
        ((forward + turning) * rail - self.input.wheel.pitch_rate * lever)
            * self.line.share_of_height(self.contact.normal())
    }

    /// Gives each of the `strips` that has none yet a friction of its own, where that is not the
    /// same all over the rail.
    pub(in crate::element) fn fill_friction(
        &self,
        separation: &T::Separation<'_>,
        strips: &mut Strips<T>,
    ) {
        let Some(friction) = self.friction else { return };
        // A Hertzian ellipse can be wider than the wheel.
        let [start, end] = self.line.range();
        let mut walk = RailWalk::new(self.rail, self.contact);
        let (hand, mut last) = (self.rail.rail.hand(), LastPlace::default());
        let Strips { y, u, x, friction: own, .. } = strips;
        let places = y.iter().zip(u.iter()).zip(x.iter()).skip(own.len());
        own.extend(places.map(|((&y, &u), &x)| {
            let place = if self.is_on_arc {
                RailPlace::at(&self.rail, self.contact.rail_s + y)
            } else {
                // A separation remembers its last point; what is found with it later is not to
                // depend on friction.
                walk.to(y, || separation.clone().rail_parameter(u.within(start, end)))
            };
            friction.at(&place, hand, self.station(&place, x), self.input, &mut last)
        }));
    }

    /// Station of a `place` of the rail `x` along it from the wheel marker [m].
    #[inline]
    fn station(&self, place: &RailPlace<T>, x: T) -> T {
        let along_track = self.frame.course().map_or(x, |course| {
            let [y, z] = self.rail.at(place.s).point;
            course.on_rail([x, y, z])[0]
        });
        self.input.track_s + self.input.wheel.position[0] + along_track
    }

    /// Friction at a `place` of the rail and `x` along the track from the wheel marker, where it is
    /// not the same all over the rail.
    #[inline]
    pub(in crate::element) fn strip_friction(
        &self,
        place: &RailPlace<T>,
        x: T,
    ) -> Option<StripFriction<T>> {
        let hand = self.rail.rail.hand();
        self.friction.map(|friction| {
            let station = self.station(place, x);
            friction.at(place, hand, station, self.input, &mut LastPlace::default())
        })
    }
}

/// The motion of the wheel, whose place along the track is that from which x is counted.
fn wheel_here<T: Real>(input: &Input<T>) -> WheelMotion<T> {
    let [_, y, z] = input.wheel.position;
    WheelMotion { position: [T::from(0.0), y, z], ..input.wheel }
}

/// Motion of the wheel against rail number `k`, from 0, at points with their x from the wheel
/// marker.
pub(in crate::element) fn relative_motion<T: Real>(
    input: &Input<T>,
    k: usize,
    frame: &RailFrame<T>,
) -> RelativeMotion<T> {
    frame.relative_motion(&wheel_here(input), &input.rails[k], input.wheel.position[0])
}

/// Speed of the wheel along the `frame` of rail number `k`, from 0, and how fast the arc on its top
/// grows if that is a roller [m/s].
pub(in crate::element) fn rail_speeds<T: Real>(
    input: &Input<T>,
    k: usize,
    rail: &PlacedRail,
    frame: &RailFrame<T>,
) -> [T; 2] {
    let (wheel, motion) = (&input.wheel, &input.rails[k]);
    let forward = frame.course().map_or(wheel.velocity[0], |_| {
        let [x, y, z] = wheel.velocity;
        Vector3::new(x, y - motion.vy, z - motion.vz).dot(&frame.along())
    });
    [forward, motion.pitch_rate * rail.roller_radius()]
}
