//! A loaded zone as it lies on the curved surface of the wheel: creepages and tractions of its
//! strips in their own tangent planes.
//!
//! Source: Piotrowski and Kik 2008, section 4, written for the general motion of both bodies. At
//! the point P of the wheel's surface under the centre of a strip, with the tangent t and the
//! normal n of the surface there, the relative velocity w of the two bodies gives the strip's own
//! creepages
//!
//! ```text
//! ξ = w_x / V,  η = w · t / V,  φ = (ω - ω_rail) · n / V        w_x = V ξ,  w_t = V (η + φ x) along the strip
//! ```
//!
//! The printed special case is that of a wheel that does not yaw: ξ = 1 - Ω R(η)/V, φ = Ω sin γ/V
//! in the signs used here. Tractions act along x and t at the place of the strip, so that the power
//! they take from the two bodies is just -∫ traction · slip. Pressures stay those of the flat
//! normal problem and act along the normal of the contact frame.

use nalgebra::Vector3;

use crate::kinematics::creepage::{ContactAxes, Creepage, RelativeMotion};
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};
use crate::tangential::StripForce;
use crate::tangential::rigid_slip::RigidSlip;

use super::tractions::Tractions;

/// Strips on the wheel's surface, in the track frame.
#[derive(Clone, Debug)]
pub struct CurvedStrips<T = f64> {
    /// Under the centre of each strip, x from the wheel marker [m].
    points: FixedVec<Vector3<T>>,
    /// Axes of each.
    axes: FixedVec<ContactAxes<T>>,
    creepages: FixedVec<Creepage<T>>,
}

impl<T: Real> CurvedStrips<T> {
    /// Room for that many strips.
    pub fn with_capacity(strips: usize) -> Self {
        Self {
            points: FixedVec::new(strips),
            axes: FixedVec::new(strips),
            creepages: FixedVec::new(strips),
        }
    }

    /// Most strips without allocating.
    pub fn capacity(&self) -> usize {
        self.points.capacity()
    }

    /// Forgets all strips.
    pub fn clear(&mut self) {
        self.points.clear();
        self.axes.clear();
        self.creepages.clear();
    }

    /// Takes the places and creepages of the strips of `zone`, which come after those taken before;
    /// returns the mean creepage, weighted by load.
    ///
    /// `along` is the direction along the rail, `lean` the tangent of the angle by which the normals
    /// of one that rises lean forward; `surface` gives point and tangent of the wheel at a parameter
    /// of the contact line and an x [m].
    pub fn place(
        &mut self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        motion: &RelativeMotion<T>,
        reference_speed: T,
        (along, lean): (Vector3<T>, T),
        surface: impl Fn(T, T) -> [Vector3<T>; 2],
    ) -> Creepage<T> {
        let (mut mean, mut load) = (Creepage::<T>::default(), T::from(0.0));
        // Zones without load were left out.
        self.points.resize(zone.first, Vector3::zeros());
        self.axes.resize(zone.first, leaning_axes(along, Vector3::y(), T::from(0.0)));
        self.creepages.resize(zone.first, Creepage::default());
        for j in zone.range() {
            let [point, tangent] = surface(strips.u[j], strips.x[j]);
            let axes = leaning_axes(along, tangent, lean);
            let creepage = motion.creepage(point, &axes, reference_speed);
            let weight = strips.weight(j);
            load += weight;
            mean.longitudinal += weight * creepage.longitudinal;
            mean.lateral += weight * creepage.lateral;
            mean.spin += weight * creepage.spin;
            self.points.push(point);
            self.axes.push(axes);
            self.creepages.push(creepage);
        }
        Creepage {
            longitudinal: mean.longitudinal / load,
            lateral: mean.lateral / load,
            spin: mean.spin / load,
        }
    }

    /// Rigid slip of the strips of a zone with the `mean` creepage.
    pub fn slip(&self, mean: Creepage<T>) -> RigidSlip<'_, T> {
        RigidSlip::of_strips(&self.creepages, mean)
    }

    /// Whether none of the strips creeps.
    pub fn is_still(&self) -> bool {
        self.creepages.iter().all(Creepage::is_zero)
    }

    /// Adds the force of strip `j` to `total`, about `position`; returns its dissipation over the
    /// reference speed [J/m].
    pub fn add(
        &self,
        total: &mut Tractions<T>,
        position: Vector3<T>,
        j: usize,
        strip: &StripForce<T>,
    ) -> T {
        let (axes, creepage) = (&self.axes[j], &self.creepages[j]);
        let force = axes.longitudinal * strip.longitudinal + axes.lateral * strip.lateral;
        total.force += force;
        total.moment += (self.points[j] - position).cross(&force) + axes.normal * strip.moment;
        let dissipation = strip.dissipation(creepage);
        total.dissipation += dissipation;
        total.slip_area += strip.slip_area;
        dissipation
    }
}

/// The axes of a strip `along` the rail with the tangent `tangent` across, whose normal leans forward
/// by an angle with the tangent `lean`.
fn leaning_axes<T: Real>(along: Vector3<T>, tangent: Vector3<T>, lean: T) -> ContactAxes<T> {
    ContactAxes::along(along, tangent, along.cross(&tangent)).leaning(lean)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::contact::laid_zones::{LaidZone, ZoneRolling};
    use crate::element::contact::models::Models;
    use crate::element::contact::zone_surface::ZoneSurface;
    use crate::element::output::Output;
    use crate::element::parameters::Parameters;
    use crate::element::work::Work;
    use crate::friction::StripFriction;
    use crate::geometry::contacts::contact::Contact;
    use crate::kinematics::creepage::rolling_speed;
    use crate::kinematics::motion::{RailMotion, WheelMotion};
    use crate::material::{Material, MaterialPair};
    use crate::normal::LoadedStrip;
    use crate::tangential::friction_law::FrictionLaw;
    use crate::tangential::{RollingState, TangentialModel};
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    #[test]
    fn a_wheel_that_does_not_yaw_has_the_rigid_slip_of_the_paper() {
        let (speed, turning, sideways) = (20.0, 43.1, 0.07);
        let (rolling_radius, angle): (f64, f64) = (0.461, -0.04);
        let mut wheel = WheelMotion {
            position: [0.0, 0.75, -0.46],
            velocity: [speed, sideways, sideways * angle.tan()],
            pitch_rate: -turning,
            ..crate::element::Input::default().wheel
        };
        let rail = RailMotion::default();
        let mut strips = Strips::with_capacity(1, 1);
        let columns = [&mut strips.y, &mut strips.u, &mut strips.x];
        for column in columns {
            column.push(0.0);
        }
        for column in [&mut strips.width, &mut strips.half_length, &mut strips.pressure] {
            column.push(1e-3);
        }
        let zone = Zone { first: 0, count: 1, ..Zone::default() };
        let mut curved = CurvedStrips::with_capacity(1);
        let mut creepage = |wheel: &WheelMotion| {
            let motion = RelativeMotion::new(wheel, &rail, Vector3::new(0.0, 0.76, 0.0));
            curved.clear();
            curved.place(&zone, &strips, &motion, speed, (Vector3::x(), 0.0), |_, x| {
                let point = Vector3::new(x, 0.755, wheel.position[2] + rolling_radius);
                [point, Vector3::new(0.0, angle.cos(), angle.sin())]
            })
        };
        let found = creepage(&wheel);
        let expected = 1.0 - turning * rolling_radius / speed;
        assert_relative_eq!(found.longitudinal, expected, max_relative = 1e-12);
        // The wheel moves along the tangent: V_η/cos γ.
        let expected = sideways / (speed * angle.cos());
        assert_relative_eq!(found.lateral, expected, max_relative = 1e-12);
        assert_relative_eq!(found.spin, turning * angle.sin() / speed, max_relative = 1e-12);
        // Yaw turns the axle: the wheel rolls sideways.
        wheel.yaw = 1e-3;
        let along = wheel.yaw.sin() * turning * rolling_radius / (speed * angle.cos());
        assert_relative_eq!(creepage(&wheel).lateral, expected - along, max_relative = 1e-3);
    }

    #[test]
    fn corrected_tractions_in_many_planes_stay_within_the_friction_that_laws_leave() {
        // An ellipse bent round a corner of 7 mm, from tread to gauge face.
        let (count, along, across, pressure) = (20, 4e-3, 6e-3, 1.5e9);
        let clean = FrictionLaw::default();
        let steep = FrictionLaw { falling_share: 0.3, falling_decay: 3.0, ..clean };
        let mut models = Models::new(&Parameters {
            tangential_model: TangentialModel::FastsimCorrected,
            friction_law: clean,
            gauge_face_law: steep,
            ..Parameters::default()
        });
        let strips = &mut models.strips;
        let mut curved = CurvedStrips::with_capacity(count);
        let mut zone = Zone {
            count,
            length: 2.0 * along,
            width: 2.0 * across,
            area: PI * along * across,
            max_pressure: pressure,
            ..Zone::default()
        };
        for j in 0..count {
            let place = (2.0 * j as f64 + 1.0) / count as f64 - 1.0;
            let chord = (1.0 - place * place).sqrt();
            let (y, angle) = (across * place, across * place / 7e-3);
            let (width, half_length) = (2.0 * across / count as f64, along * chord);
            let pressure = pressure * chord;
            strips.push(LoadedStrip { y, width, x: 0.0, half_length, pressure, u: y });
            strips.friction.push(StripFriction {
                gauge_face_share: 0.5 + 0.5 * place,
                ..StripFriction::of(0.4)
            });
            zone.load += 0.5 * PI * half_length * pressure * width;
            curved.points.push(Vector3::new(0.0, 7e-3 * angle.sin(), 7e-3 * (1.0 - angle.cos())));
            let tangent = Vector3::new(0.0, angle.cos(), angle.sin());
            curved.axes.push(leaning_axes(Vector3::x(), tangent, 0.0));
        }
        let steel = Material { young_modulus: 2.1e11, poisson_ratio: 0.28 };
        let mut fallen = 0;
        for case in 0..4000 {
            let at = |k: i32, n: i32| f64::from(case / k % n) / f64::from(n - 1);
            let mean = Creepage {
                longitudinal: 1e-4 * 100f64.powf(at(1, 20)),
                lateral: 1e-2 * (at(20, 10) - 0.5),
                spin: 4.0 * (at(200, 20) - 0.5),
            };
            curved.creepages.clear();
            for y in models.strips.y.iter() {
                let longitudinal = mean.longitudinal - mean.spin * y;
                curved.creepages.push(Creepage { longitudinal, ..mean });
            }
            let state = RollingState {
                creepage: mean,
                forward_share: 1.0,
                friction: 0.4,
                load_factor: 1.0,
                speed: 30.0,
            };
            let material = MaterialPair::new(steel, steel);
            let law = models.tangential.under_law(&zone, &models.strips, &material, &state);
            models.rolling.clear();
            models.rolling.strips = curved.clone();
            models.rolling.zones.push(LaidZone {
                index: 0,
                contact: Contact {
                    u: 0.0,
                    rail_s: 0.0,
                    penetration: 0.0,
                    origin: [0.0; 2],
                    tangent: [1.0, 0.0],
                    probes: [0, 0],
                },
                resultant_share: 1.0,
                origin: 0.0,
                rolling: ZoneRolling {
                    zone,
                    position: Vector3::zeros(),
                    axes: leaning_axes(Vector3::x(), Vector3::y(), 0.0),
                    rolling_radius: 0.46,
                    forward: 30.0,
                    speed: rolling_speed(30.0, -65.0, 0.46, 0.1),
                    load_factor: 1.0,
                    surface_depth: 0.0,
                    lean: 0.0,
                },
                surface: ZoneSurface::even(),
                law,
            });
            models.roll(&mut Output::default(), &mut Work::default());
            let force = models.rolling.tractions[0].force.norm();
            let limit = law.state.friction * zone.load;
            assert!(force <= limit * (1.0 + 1e-12), "{force} {limit} {mean:?}");
            fallen += usize::from(law.state.friction < 0.35);
        }
        assert!(fallen >= 100, "{fallen}");
    }
}
