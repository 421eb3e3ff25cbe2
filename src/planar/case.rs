//! What a planar contact problem is given by, and which values are admitted.

use crate::error::ContactError;
use crate::friction::StripFriction;
use crate::material::Material;
use crate::normal::{NormalModel, ShapeFit};
use crate::tangential::fastsim::TractionBound;
use crate::tangential::flash_temperature::FlashTemperature;
use crate::tangential::friction_law::FrictionLaw;
use crate::tangential::{Flexibilities, TangentialModel};

/// How deep the bodies are pressed together.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Indentation {
    /// Given approach δ from f = 0 [m].
    Approach(f64),
    /// Given normal force, ≥ 0 [N].
    Load(f64),
}

/// A planar contact problem.
#[derive(Clone, Copy, Debug)]
pub struct PlanarCase<'a> {
    /// Points (y, f) of the separation, at least four, y growing, within 1 km [m].
    pub separation: &'a [[f64; 2]],
    /// Radius R of the wheel's normal section along x, 1e-4 to 1e6 [m].
    pub radius: f64,
    /// Approach or load.
    pub indentation: Indentation,
    /// Longitudinal, lateral [-] and spin [1/m] creepage at the origin of the separation; beyond
    /// 1e6 they count as 1e6.
    pub creepage: [f64; 3],
    /// Coefficient of friction, ≥ 0; without effect where there is friction across [-].
    pub friction: f64,
    /// Friction at places y, which grow: linear in between, constant beyond; empty for one
    /// coefficient [m].
    pub friction_across: &'a [(f64, StripFriction)],
    /// Material of the wheel.
    pub wheel_material: Material,
    /// Material of the rail.
    pub rail_material: Material,
    /// Normal contact model.
    pub normal_model: NormalModel,
    /// Virtual over true penetration, 0 to 1 [-].
    pub virtual_penetration: f64,
    /// Ratio of length to width that a corrected contact area gets.
    pub shape_fit: ShapeFit,
    /// Tangential contact model.
    pub tangential_model: TangentialModel,
    /// Strips across each zone.
    pub strips: usize,
    /// Elements along each strip.
    pub elements_along: usize,
    /// Boundary elements along and across the contact.
    pub elements: [usize; 2],
    /// Shape of the traction bound.
    pub bound: TractionBound,
    /// How the flexibilities enter.
    pub flexibilities: Flexibilities,
    /// How friction falls with sliding, and the initial slope on contaminated rails; of the tread
    /// where there is friction across.
    pub friction_law: FrictionLaw,
    /// The same of the gauge face.
    pub gauge_face_law: FrictionLaw,
    /// How friction falls with the temperature that sliding makes.
    pub flash_temperature: FlashTemperature,
    /// Rolling speed, ≥ 0: of friction that falls with speed or temperature alone [m/s].
    pub speed: f64,
}

/// Approaches beyond this are no contact of wheel and rail [m].
pub(super) const MAX_APPROACH: f64 = 0.02;

/// Points of a separation beyond this are none of wheel and rail [m].
const MAX_DISTANCE: f64 = 1e3;
/// Least and greatest radius of a wheel's section [m].
const RADII: (f64, f64) = (1e-4, 1e6);
/// Least and greatest Young's modulus [Pa].
const MODULI: (f64, f64) = (1e3, 1e18);

impl PlanarCase<'_> {
    /// Whether every value is one that can be solved.
    ///
    /// # Errors
    /// The first value at fault, by its name.
    pub(super) fn check(&self) -> Result<(), ContactError> {
        let distance = "a distance in metres, -1000 to 1000";
        let require = |name: &str, value: f64, fits: bool, allowed: &'static str| {
            if value.is_finite() && fits {
                Ok(())
            } else {
                Err(ContactError::bad_value(name, value, allowed))
            }
        };
        let points = self.separation;
        require("separation", points.len() as f64, points.len() >= 4, "at least 4 points")?;
        for pair in points.windows(2) {
            require("separation f", pair[0][1], pair[0][1].abs() <= MAX_DISTANCE, distance)?;
            require("separation y", pair[0][0], pair[0][0].abs() <= MAX_DISTANCE, distance)?;
            require(
                "separation y",
                pair[1][0],
                pair[1][0] > pair[0][0],
                "greater than the y before it",
            )?;
        }
        for (name, value) in ["separation y", "separation f"].iter().zip(points[points.len() - 1]) {
            require(name, value, value.abs() <= MAX_DISTANCE, distance)?;
        }
        let (least, most) = RADII;
        let fits = (least..=most).contains(&self.radius);
        require("radius", self.radius, fits, "a radius in metres, 1e-4 to 1e6")?;
        match self.indentation {
            Indentation::Approach(a) => {
                require("approach", a, a <= MAX_APPROACH, "a finite number up to 20 mm")?;
            }
            Indentation::Load(n) => require("load", n, n >= 0.0, "a finite number, at least 0")?,
        }
        let names = ["creepage_longitudinal", "creepage_lateral", "spin"];
        for (name, value) in names.iter().zip(self.creepage) {
            require(name, value, true, "a finite number")?;
        }
        require("friction", self.friction, self.friction >= 0.0, "a finite number, at least 0")?;
        for (body, m) in [("wheel", self.wheel_material), ("rail", self.rail_material)] {
            require(
                &format!("{body} young_modulus"),
                m.young_modulus,
                (MODULI.0..=MODULI.1).contains(&m.young_modulus),
                "a modulus in Pa, 1e3 to 1e18",
            )?;
            let nu = m.poisson_ratio;
            require(&format!("{body} poisson_ratio"), nu, (0.0..=0.5).contains(&nu), "0 to 0.5")?;
        }
        require("speed", self.speed, self.speed >= 0.0, "a finite number, at least 0")?;
        let mut before = f64::NEG_INFINITY;
        for &(y, StripFriction { tread, gauge_face, gauge_face_share }) in self.friction_across {
            require("friction_across y", y, y > before, "greater than the y before it")?;
            before = y;
            for coefficient in [tread, gauge_face] {
                let fits = coefficient >= 0.0;
                require("friction_across", coefficient, fits, "a finite number, at least 0")?;
            }
            let (share, fits) = (gauge_face_share, (0.0..=1.0).contains(&gauge_face_share));
            require("friction_across gauge face", share, fits, "0 to 1")?;
        }
        for law in [&self.friction_law, &self.gauge_face_law] {
            for (name, value) in
                [("falling share", law.falling_share), ("reduction share", law.reduction_share)]
            {
                require(name, value, (0.0..=1.0).contains(&value), "0 to 1")?;
            }
            for (name, value) in
                [("falling decay", law.falling_decay), ("reduction decay", law.reduction_decay)]
            {
                require(name, value, value >= 0.0, "a finite number, at least 0")?;
            }
            let fits = (1e-3..=1.0).contains(&law.reduction);
            require("reduction", law.reduction, fits, "0.001 to 1")?;
        }
        let heat = &self.flash_temperature;
        require("flash share", heat.share, (0.0..=1.0).contains(&heat.share), "0 to 1")?;
        require("flash onset", heat.onset, heat.onset >= 0.0, "a finite number, at least 0")?;
        for (name, value) in [
            ("flash range", heat.range),
            ("conductivity", heat.conductivity),
            ("heat capacity", heat.heat_capacity),
        ] {
            require(name, value, value > 0.0, "a finite number greater than 0")?;
        }
        let epsilon = self.virtual_penetration;
        require("virtual_penetration", epsilon, epsilon > 0.0 && epsilon < 1.0, "between 0 and 1")?;
        let counts = 4..=200;
        require("strips", self.strips as f64, counts.contains(&self.strips), "4 to 200")?;
        require(
            "elements_along",
            self.elements_along as f64,
            counts.contains(&self.elements_along),
            "4 to 200",
        )?;
        for (name, count) in ["elements_along", "elements_across"].into_iter().zip(self.elements) {
            require(name, count as f64, counts.contains(&count), "4 to 200")?;
        }
        Ok(())
    }
}
