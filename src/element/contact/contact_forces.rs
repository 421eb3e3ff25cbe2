//! From the loaded zones of a contact to forces on wheel and rail.

use std::ops::Range;

use nalgebra::Vector3;

use super::contact_setup::ContactSetup;
use super::laid_zones::{LaidZone, ZoneRolling};
use super::models::Models;
use super::number::ElementNumber;
use crate::element::input::WheelMotion;
use crate::element::output::{Output, Patch, Wrench};
use crate::element::wear_sums::WearSums;
use crate::element::work::Work;
use crate::geometry::contacts::line_separation::RailSeparation;
use crate::math::real::Real;
use crate::math::smooth_step::smooth_step;
use crate::wear::rcf;

impl<T: ElementNumber> ContactSetup<'_, T> {
    /// Adds the forces of all zones in `models.strips`, which are in the frame of this contact, to
    /// `output` and their patches to `models.patches`; returns how many zones fell back to a
    /// simpler tangential model.
    pub fn add_forces(
        &self,
        separation: &mut T::Separation<'_>,
        models: &mut Models<T>,
        output: &mut Output<T>,
        work: &mut Work,
    ) -> u64 {
        models.rolling.clear();
        self.lay(separation, models, 0);
        let fallbacks = models.roll(output, work);
        self.add_laid(0..models.rolling.zones.len(), separation, models, output);
        fallbacks
    }

    /// Adds the forces of those of the zones under way that are in the frame of this contact.
    pub(in crate::element) fn add_laid(
        &self,
        zones: Range<usize>,
        separation: &mut T::Separation<'_>,
        models: &mut Models<T>,
        output: &mut Output<T>,
    ) {
        let [station, ..] = self.input.wheel.position;
        let wheel = self.wheel();
        let wheel_marker = Vector3::from(wheel.position);
        let even_axes = self.axes();
        let along = self.frame.along();
        for n in zones {
            let LaidZone { index, rolling, surface, law, .. } = models.rolling.zones[n];
            let tractions = models.rolling.tractions[n];
            let ZoneRolling { zone, position, axes, load_factor, rolling_radius, .. } = rolling;
            let ZoneRolling { speed, forward, .. } = rolling;
            let wheel_point = self.line.wheel_point(zone.u);
            let normal_force = zone.load * load_factor * self.resultant_share;
            let pressing = axes.normal * -normal_force;
            // Where the even part of the normal meets the axle, the part that leans does too.
            let even = position - along * surface.ahead - even_axes.normal * surface.depth;
            let bearing = position + (meeting_axle(&wheel, even, even_axes.normal, along) - even);
            add(&mut output.wheel, tractions.force, position - wheel_marker, tractions.moment);
            add(&mut output.wheel, pressing, bearing - wheel_marker, Vector3::zeros());
            // Along the track and across, wherever the rows go.
            let tell = |along: T, across: T, force: Vector3<T>| {
                if self.frame.course().is_none() {
                    return [along, across];
                }
                let told = axes.beside_track();
                [told.longitudinal, told.lateral].map(|axis| force.dot(&axis))
            };
            let [longitudinal, lateral] =
                [axes.longitudinal, axes.lateral].map(|axis| tractions.force.dot(&axis));
            let is_traction = longitudinal * forward > 0.0;
            let creep_force = tell(longitudinal, lateral, tractions.force);
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
            let sliding = axes.longitudinal * slip.longitudinal + axes.lateral * slip.lateral;
            let [slip_along, slip_across] = tell(slip.longitudinal, slip.lateral, sliding);
            models.patches.push(Patch {
                rail: self.k as i32 + 1,
                normal_force,
                creep_force,
                spin_moment: tractions.moment.dot(&axes.normal),
                contact_angle: self.contact_angle(),
                position: position.into(),
                wheel_y: wheel_point.y,
                rail_y: self.rail.profile_y(separation.rail_parameter(zone.u)),
                rolling_radius,
                penetration: self.contact.penetration,
                max_pressure: zone.max_pressure * load_factor,
                length: zone.length,
                width: zone.width,
                area: zone.area,
                creepage: [slip_along, slip_across, slip.spin],
                friction_coefficient: law.state.friction,
                temperature: law.temperature,
                slip_share: (tractions.slip_area / zone.area).at_most(1.0),
                frictional_power,
                tgamma_damage: rcf::tgamma_damage(dissipation, is_traction),
                surface_fatigue_index: rcf::surface_fatigue_index(
                    normal_force,
                    creep_force,
                    zone.area,
                    models.shear_yield,
                ),
            });
        }
    }
}

/// The place at which the normal force of a patch on an even wheel acts: `position`, moved `along`
/// the rail so that the line of action along `normal` meets the axle of the `wheel`, as every normal
/// of a surface of revolution does.
///
/// With the axle u through the marker M, x along the rail and (P - M) · (n × u) = 0, n without a
/// part along x,
///
/// ```text
/// x - M_x = u_x ((y - M_y) n_z - (z - M_z) n_y) / (u_y n_z - u_z n_y)
/// ```
///
/// A wheel that does not yaw has its normals over the axle. Those of a flank lie ahead of it or
/// behind, by r tan(angle) sin(yaw); the centroid of the load is a little off that, because the
/// normal there is not that of the contact frame. Normals along the axle, as of a flange back, meet
/// it nowhere and have no moment about it.
fn meeting_axle<T: Real>(
    wheel: &WheelMotion<T>,
    position: Vector3<T>,
    normal: Vector3<T>,
    along: Vector3<T>,
) -> Vector3<T> {
    let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) = (wheel.roll.sin_cos(), wheel.yaw.sin_cos());
    // R_x(roll) R_z(yaw) e_y
    let axle = Vector3::new(-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll);
    let to = position - Vector3::from(wheel.position);
    let facing = axle.cross(&normal).dot(&along);
    let [none, all] = FACING;
    if facing.abs() <= none {
        return position;
    }
    let share = smooth_step(((facing.abs() - none) / (all - none)).at_most(1.0));
    let x = axle.dot(&along) * to.cross(&normal).dot(&along) / facing;
    position + along * (share * (x - to.dot(&along)))
}

/// Sines of the angle between normal and axle below which the normal force acts at the centroid of
/// the load, and from which on where its line meets the axle: within 1 to 3 degrees the rim of a
/// flange back is only as good as the smoothing over of its two ends.
const FACING: [f64; 2] = [0.02, 0.05];

/// Adds a force on a body that acts at `arm` from its marker, and a free moment.
fn add<T: Real>(wrench: &mut Wrench<T>, force: Vector3<T>, arm: Vector3<T>, moment: Vector3<T>) {
    let moment = arm.cross(&force) + moment;
    for i in 0..3 {
        wrench.force[i] += force[i];
        wrench.moment[i] += moment[i];
    }
}
