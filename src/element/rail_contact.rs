//! The contact of one wheel with one rail: pose, search, normal and tangential models, forces on both bodies.

use nalgebra::Vector3;

use super::evaluate::Work;
use super::input::{Input, RailMotion, WheelMotion};
use super::output::{Output, Patch, Wrench};
use super::parameters::Parameters;
use crate::geometry::clearance::Clearance;
use crate::geometry::contact::Contact;
use crate::geometry::contact_line::{ContactLine, WheelPose};
use crate::geometry::contact_search::{ContactSearch, MOST_CONTACTS};
use crate::geometry::line_separation::LineSeparation;
use crate::geometry::placed_rail::PlacedRail;
use crate::geometry::profile::Profile;
use crate::kinematics::creepage::{RelativeMotion, rolling_speed};
use crate::material::{Material, MaterialPair};
use crate::math::quadrature::GaussLegendre;
use crate::math::room::Room;
use crate::normal::{self, NormalModel, NormalProblem, Strips, damping};
use crate::tangential::{RollingState, Tangential};

/// Most loaded zones of one contact frame.
const MOST_ZONES: usize = 8;

/// The chosen models and their scratch memory, shared by the rails of an element.
#[derive(Clone, Debug)]
pub struct Models {
    normal: NormalModel,
    virtual_penetration: f64,
    damping: f64,
    tangential: Tangential,
    minimum_speed: f64,
    material: MaterialPair,
    rule: GaussLegendre,
    strips: Strips,
    /// All loaded zones of the evaluation under way.
    pub patches: Room<Patch>,
}

impl Models {
    /// The models that checked `parameters` ask for.
    #[must_use]
    pub fn new(parameters: &Parameters) -> Self {
        let wheel = Material {
            young_modulus: parameters.wheel.young_modulus,
            poisson_ratio: parameters.wheel.poisson_ratio,
        };
        let rail = Material {
            young_modulus: parameters.rail_young_modulus,
            poisson_ratio: parameters.rail_poisson_ratio,
        };
        Self {
            normal: parameters.normal_model,
            virtual_penetration: parameters.virtual_penetration,
            damping: parameters.damping,
            tangential: Tangential::new(
                parameters.tangential_model,
                parameters.flexibilities,
                parameters.bound,
                parameters.elements_along,
            ),
            minimum_speed: parameters.minimum_speed,
            material: MaterialPair::new(wheel, rail),
            rule: GaussLegendre::new(parameters.strips),
            strips: Strips::with_capacity(MOST_ZONES, parameters.strips),
            patches: Room::new(parameters.rails.len() * MOST_CONTACTS * MOST_ZONES),
        }
    }
}

/// One rail and what is prepared for its contact with the wheel.
#[derive(Clone, Debug)]
pub struct RailContact {
    wheel: Profile,
    nominal_radius: f64,
    rail: PlacedRail,
    clearance: Clearance,
    /// Stretches of the contact line that may touch.
    ranges: Room<[f64; 2]>,
    search: ContactSearch,
}

/// Most stretches of a contact line that are searched apart from each other.
const MOST_RANGES: usize = 32;

impl RailContact {
    /// Prepares the contact of the wheel with profile `wheel` and a placed rail.
    #[must_use]
    pub fn new(wheel: &Profile, parameters: &Parameters, rail: PlacedRail) -> Self {
        let nominal_radius = parameters.wheel.nominal_radius;
        Self {
            clearance: Clearance::new(&wheel.curve, nominal_radius, rail.curve()),
            ranges: Room::new(MOST_RANGES),
            search: ContactSearch::new(&wheel.curve),
            wheel: wheel.clone(),
            nominal_radius,
            rail,
        }
    }

    /// Whether any contact appears for `input` (right side) with rail number `k`.
    pub fn touches(&mut self, k: usize, input: &Input) -> bool {
        let pose = Frame::new(&self.rail, &input.rails[k]).pose(&input.wheel);
        self.clearance.ranges(
            [pose.marker[1], pose.marker[2]],
            pose.roll,
            pose.yaw,
            &mut self.ranges,
        );
        let line = ContactLine::new(&self.wheel.curve, self.nominal_radius, &pose);
        self.search.search_within(&line, &self.rail, &self.ranges);
        !self.search.contacts.is_empty()
    }

    /// A marker height from which a wheel with the roll of `input` (right side) is surely clear of rail number `k` [m].
    pub fn clear_height(&self, k: usize, input: &Input) -> f64 {
        let frame = Frame::new(&self.rail, &input.rails[k]);
        let pose = frame.pose(&input.wheel);
        // A rolled rail turns the height about its marker.
        frame.marker.z + self.clearance.clear_height(pose.roll)
            - pose.marker[1].abs() * frame.roll.abs()
    }

    /// Adds the forces of rail number `k` to `output`; returns how many contacts or zones found no room.
    pub fn evaluate(
        &mut self,
        k: usize,
        input: &Input,
        models: &mut Models,
        output: &mut Output,
        work: &mut Work,
    ) -> u64 {
        let frame = Frame::new(&self.rail, &input.rails[k]);
        let pose = frame.pose(&input.wheel);
        self.clearance.ranges(
            [pose.marker[1], pose.marker[2]],
            pose.roll,
            pose.yaw,
            &mut self.ranges,
        );
        if self.ranges.is_empty() {
            work.lifted += 1;
            return 0;
        }
        let line = ContactLine::new(&self.wheel.curve, self.nominal_radius, &pose);
        let before = (self.search.evaluations, self.search.left_out);
        self.search.search_within(&line, &self.rail, &self.ranges);
        work.searches += 1;
        work.distances += self.search.evaluations - before.0;
        let mut left_out = self.search.left_out - before.1;
        for index in 0..self.search.contacts.len() {
            let contact = self.search.contacts[index];
            let mut separation = LineSeparation::new(&line, &self.rail, contact);
            self.search.refine_probes(&contact, &mut separation);
            models.strips.clear();
            let problem = NormalProblem {
                approach: contact.penetration,
                radius: line.wheel_point(contact.u).section_radius,
                contact_modulus: models.material.contact_modulus,
                contact_u: contact.u,
                lateral_curvature: line.curvature(contact.u) + self.rail.curvature(contact.rail_s),
                rule: &models.rule,
            };
            left_out += normal::solve(
                models.normal,
                models.virtual_penetration,
                &problem,
                &mut separation,
                &self.search.probes[contact.probes[0]..contact.probes[1]],
                &mut models.strips,
            ) as u64;
            let situation = Situation { k, input, frame, line, rail: &self.rail, contact };
            situation.add_forces(&mut separation, models, output, work);
        }
        left_out
    }
}

/// The frame of a rail that may have moved and rolled from its design position.
#[derive(Clone, Copy, Debug)]
struct Frame {
    /// Rail marker in the track frame [m].
    marker: Vector3<f64>,
    roll: f64,
    sine: f64,
    cosine: f64,
}

impl Frame {
    fn new(rail: &PlacedRail, motion: &RailMotion) -> Self {
        let (sine, cosine) = motion.roll.sin_cos();
        let marker = Vector3::new(0.0, rail.marker[0] + motion.y, rail.marker[1] + motion.z);
        Self { marker, roll: motion.roll, sine, cosine }
    }

    /// The wheel as seen from the rail.
    fn pose(&self, wheel: &WheelMotion) -> WheelPose {
        let to = Vector3::from(wheel.position) - self.marker;
        WheelPose {
            // The rail is the same all along: x counts from the wheel marker.
            marker: [
                0.0,
                to.y * self.cosine + to.z * self.sine,
                to.z * self.cosine - to.y * self.sine,
            ],
            roll: wheel.roll - self.roll,
            yaw: wheel.yaw,
        }
    }

    /// A direction (y, z) of the rail's frame in the track frame.
    fn direction(&self, [y, z]: [f64; 2]) -> Vector3<f64> {
        Vector3::new(0.0, y * self.cosine - z * self.sine, y * self.sine + z * self.cosine)
    }
}

/// One contact of the evaluation under way.
struct Situation<'a> {
    k: usize,
    input: &'a Input,
    frame: Frame,
    line: ContactLine<'a>,
    rail: &'a PlacedRail,
    contact: Contact,
}

impl Situation<'_> {
    /// Adds the forces of all zones in `models.strips` to `output` and their patches to `models.patches`.
    fn add_forces(
        &self,
        separation: &mut LineSeparation,
        models: &mut Models,
        output: &mut Output,
        work: &mut Work,
    ) {
        // All points have their x from the wheel marker, so that no result depends on the station by rounding.
        let [station, y, z] = self.input.wheel.position;
        let wheel = WheelMotion { position: [0.0, y, z], ..self.input.wheel };
        let wheel_marker = Vector3::from(wheel.position);
        let rail_motion = &self.input.rails[self.k];
        let motion = RelativeMotion::new(&wheel, rail_motion, self.frame.marker);
        let lateral = self.frame.direction(self.contact.tangent);
        let normal = self.frame.direction(self.contact.normal());
        // The wheel's surface of first touch lies deeper in the rail by the penetration.
        let touch = self.track_point(self.line.at(self.contact.u).x, 0.0, self.contact.penetration);
        let load = models.strips.load();
        let closing_speed = motion.closing_velocity(touch).dot(&normal);
        let damped =
            damping::damped_load(load, self.contact.penetration, closing_speed, models.damping);
        let load_factor = if load > 0.0 { damped / load } else { 0.0 };
        for index in 0..models.strips.zones.len() {
            let zone = models.strips.zones[index];
            if zone.load <= 0.0 || zone.width <= 0.0 {
                continue;
            }
            work.zones += 1;
            let at = self.line.at(zone.u);
            let to = [at.point[0] - self.contact.origin[0], at.point[1] - self.contact.origin[1]];
            let axis = self.contact.normal();
            let depth = to[0] * axis[0] + to[1] * axis[1];
            let position = self.track_point(zone.x, zone.y, depth);
            let wheel_point = self.line.wheel_point(zone.u);
            let speed = rolling_speed(
                wheel.velocity[0],
                wheel.pitch_rate,
                wheel_point.rolling_radius,
                models.minimum_speed,
            );
            let creepage = motion.creepage(position, lateral, normal, speed.reference);
            let state = RollingState {
                creepage,
                forward_share: speed.forward_share,
                friction: self.input.friction,
                load_factor,
            };
            let marched =
                models.tangential.creep_force(&zone, &models.strips, &models.material, &state);
            work.marches += u64::from(marched.is_some());
            let force = marched.unwrap_or_default();
            let normal_force = zone.load * load_factor;
            let on_wheel =
                Vector3::x() * force.longitudinal + lateral * force.lateral - normal * normal_force;
            let spin_moment = normal * force.spin_moment;
            add(&mut output.wheel, on_wheel, position - wheel_marker, spin_moment);
            let position = position + Vector3::x() * station;
            let arm = position - self.frame.marker;
            add(&mut output.rails[self.k], -on_wheel, arm, -spin_moment);
            let dissipation = -(force.longitudinal * creepage.longitudinal
                + force.lateral * creepage.lateral
                + force.spin_moment * creepage.spin);
            let frictional_power = (dissipation * speed.reference).max(0.0);
            output.wear_number += dissipation.max(0.0);
            output.frictional_power += frictional_power;
            models.patches.push(Patch {
                rail: self.k as i32 + 1,
                normal_force,
                creep_force: [force.longitudinal, force.lateral],
                spin_moment: force.spin_moment,
                contact_angle: self.contact.angle() + self.frame.roll,
                position: position.into(),
                wheel_y: wheel_point.y,
                rail_y: self.rail.profile_y(separation.rail_parameter(zone.u)),
                rolling_radius: wheel_point.rolling_radius,
                penetration: self.contact.penetration,
                max_pressure: zone.max_pressure * load_factor,
                length: zone.length,
                width: zone.width,
                area: zone.area,
                creepage: [creepage.longitudinal, creepage.lateral, creepage.spin],
                slip_share: (force.slip_area / zone.area).min(1.0),
                frictional_power,
            });
        }
    }

    /// A point given by its x from the wheel marker and its lateral coordinate and depth in the contact frame.
    fn track_point(&self, x: f64, y: f64, depth: f64) -> Vector3<f64> {
        let (o, t, n) = (self.contact.origin, self.contact.tangent, self.contact.normal());
        let point = [o[0] + y * t[0] + depth * n[0], o[1] + y * t[1] + depth * n[1]];
        self.frame.marker + self.frame.direction(point) + Vector3::x() * x
    }
}

/// Adds a force on a body that acts at `arm` from its marker, and a free moment.
fn add(wrench: &mut Wrench, force: Vector3<f64>, arm: Vector3<f64>, moment: Vector3<f64>) {
    let moment = arm.cross(&force) + moment;
    for i in 0..3 {
        wrench.force[i] += force[i];
        wrench.moment[i] += moment[i];
    }
}
