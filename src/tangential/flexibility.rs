//! Flexibilities of the simplified theory for a loaded zone of any outline.
//!
//! The zone is given the ellipse with its length to width ratio and its area, a/b = L/W and π a b = area. The creep forces
//! that full adhesion gives on the true zone (Piotrowski and Kik 2008, eqs 21 and 22) are set equal to those of
//! Kalker's linear theory on the ellipse, creepage by creepage:
//!
//! ```text
//! L1 = 2 ∫ x_l² dy / (G c² c11),  L2 = 2 ∫ x_l² dy / (G c² c22),  L3 = (2/3) ∫ x_l³ dy / (G c³ c23),  c² = a b
//! ```

use std::f64::consts::PI;

use super::Creepage;
use super::kalker_coefficients::kalker_coefficients;
use crate::material::MaterialPair;
use crate::normal::{Strips, Zone};

/// Flexibility for each creepage: displacement over traction [m/Pa].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ZoneFlexibility {
    /// For longitudinal creepage, L1.
    pub longitudinal: f64,
    /// For lateral creepage, L2.
    pub lateral: f64,
    /// For spin, L3.
    pub spin: f64,
    /// Semi-axis a of the equivalent ellipse along rolling [m].
    pub semi_axis_along: f64,
    /// G c² c11 and G c² c22: linear creep force over creepage [N].
    stiffness: [f64; 2],
}

impl ZoneFlexibility {
    /// The three flexibilities of `zone`, whose area is positive.
    #[must_use]
    pub fn new(zone: &Zone, strips: &Strips, material: &MaterialPair) -> Self {
        let (mut second, mut third) = (0.0, 0.0);
        for j in zone.first..zone.first + zone.count {
            let (a, width) = (strips.half_length[j], strips.width[j]);
            second += width * a * a;
            third += width * a * a * a;
        }
        let axis_ratio = zone.length / zone.width;
        let c_squared = zone.area / PI;
        let c = kalker_coefficients(axis_ratio, material.poisson_ratio);
        let scale = material.shear_modulus * c_squared;
        Self {
            longitudinal: 2.0 * second / (scale * c.c11),
            lateral: 2.0 * second / (scale * c.c22),
            spin: 2.0 / 3.0 * third / (scale * c_squared.sqrt() * c.c23),
            semi_axis_along: (c_squared * axis_ratio).sqrt(),
            stiffness: [scale * c.c11, scale * c.c22],
        }
    }

    /// Kalker's three flexibilities of an ellipse with semi-axes `along` and `across` > 0 [m].
    #[must_use]
    pub fn of_ellipse(along: f64, across: f64, material: &MaterialPair) -> Self {
        let c = kalker_coefficients(along / across, material.poisson_ratio);
        let scale = material.shear_modulus * along * across;
        Self {
            longitudinal: 8.0 * along / (3.0 * material.shear_modulus * c.c11),
            lateral: 8.0 * along / (3.0 * material.shear_modulus * c.c22),
            spin: PI * along * (along / across).sqrt() / (4.0 * material.shear_modulus * c.c23),
            semi_axis_along: along,
            stiffness: [scale * c.c11, scale * c.c22],
        }
    }

    /// The flexibilities blended towards a common one as the creepage grows to three times that of linear saturation.
    ///
    /// Source: Vollebregt and Voltr, Vehicle System Dynamics 61 (2023) 309-317. `friction_limit` is μ N > 0 [N].
    #[must_use]
    pub fn blended(&self, creepage: &Creepage, friction_limit: f64) -> Self {
        let a = self.semi_axis_along;
        let spin = creepage.spin * (PI * a * a / 4.0) / (8.0 * a / 3.0);
        let squares = [creepage.longitudinal.powi(2), creepage.lateral.powi(2), spin * spin];
        let total = squares.iter().sum::<f64>();
        if total <= 0.0 {
            return *self;
        }
        let common = total
            / (squares[0] / self.longitudinal + squares[1] / self.lateral + squares[2] / self.spin);
        let saturation = (friction_limit / self.stiffness[0]).powi(2)
            + (friction_limit / self.stiffness[1]).powi(2);
        let share = (((squares[0] + squares[1]) / saturation).sqrt() / 3.0).min(1.0);
        let blend = |own: f64| (1.0 - share) * own + share * common;
        Self {
            longitudinal: blend(self.longitudinal),
            lateral: blend(self.lateral),
            spin: blend(self.spin),
            ..*self
        }
    }
}
