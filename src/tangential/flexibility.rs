//! Flexibilities of the simplified theory for a loaded zone of any outline.
//!
//! The zone is given the ellipse with the second moments of its outline, a² = 4 <x²> and b² = 4
//! <y²>. The creep forces that full adhesion gives on the true zone (Piotrowski and Kik 2008, eqs
//! 21 and 22) are set equal to those of Kalker's linear theory on the ellipse, creepage by
//! creepage:
//!
//! ```text
//! L1 = 2 ∫ x_l² dy / (G c² c11),  L2 = 2 ∫ x_l² dy / (G c² c22),  L3 = (2/3) ∫ x_l³ dy / (G c³ c23),  c² = a b
//! ```
//!
//! The paper's ellipse has the length to width ratio and the area of the zone. One long strip, or a
//! wide shoulder that carries little, changes that ratio at will; it changes moments no more than
//! it matters, and those of two zones go over into those of one with two lobes.

use std::f64::consts::PI;

use super::Creepage;
use super::kalker_coefficients::kalker_coefficients;
use super::neck::Extent;
use super::outline::Outline;
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// How the three flexibilities of the simplified theory enter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Flexibilities {
    /// One for each creepage.
    Three,
    /// Blended towards a common one as the creepage grows (Vollebregt and Voltr 2023).
    #[default]
    Blended,
}

/// Flexibility for each creepage: displacement over traction [m/Pa].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ZoneFlexibility<T = f64> {
    /// For longitudinal creepage, L1.
    pub longitudinal: T,
    /// For lateral creepage, L2.
    pub lateral: T,
    /// For spin, L3.
    pub spin: T,
    /// Semi-axis a of the equivalent ellipse along rolling [m].
    pub semi_axis_along: T,
    /// G c² c11 and G c² c22: linear creep force over creepage [N].
    stiffness: [T; 2],
}

impl<T: Real> ZoneFlexibility<T> {
    /// The three flexibilities of `zone`, whose strips count as far as they belong to `extent`;
    /// nothing where that has no area.
    pub fn new(
        zone: &Zone<T>,
        strips: &Strips<T>,
        material: &MaterialPair<T>,
        extent: &Extent<T>,
    ) -> Option<Self> {
        let Outline { ellipse, squares, cubes } = Outline::of(zone, strips, extent)?;
        let c = kalker_coefficients(ellipse.along / ellipse.across, material.poisson_ratio);
        let c_squared = ellipse.along * ellipse.across;
        let scale = material.shear_modulus * c_squared;
        Some(Self {
            longitudinal: squares * 2.0 / (scale * c.c11),
            lateral: squares * 2.0 / (scale * c.c22),
            spin: cubes * (2.0 / 3.0) / (scale * c_squared.sqrt() * c.c23),
            semi_axis_along: ellipse.along,
            stiffness: [scale * c.c11, scale * c.c22],
        })
    }

    /// Kalker's three flexibilities of an ellipse with semi-axes `along` and `across` > 0 [m].
    pub fn of_ellipse(along: T, across: T, material: &MaterialPair<T>) -> Self {
        let c = kalker_coefficients(along / across, material.poisson_ratio);
        let scale = material.shear_modulus * along * across;
        Self {
            longitudinal: along * 8.0 / (material.shear_modulus * 3.0 * c.c11),
            lateral: along * 8.0 / (material.shear_modulus * 3.0 * c.c22),
            spin: along * PI * (along / across).sqrt() / (material.shear_modulus * 4.0 * c.c23),
            semi_axis_along: along,
            stiffness: [scale * c.c11, scale * c.c22],
        }
    }

    /// The flexibilities blended towards a common one as the creepage grows to three times that of
    /// linear saturation.
    ///
    /// Source: Vollebregt and Voltr, Vehicle System Dynamics 61 (2023) 309-317. `friction_limit` is
    /// μ N > 0 [N].
    pub fn blended(&self, creepage: &Creepage<T>, friction_limit: T) -> Self {
        let a = self.semi_axis_along;
        let spin = creepage.spin * (a * PI * a / 4.0) / (a * 8.0 / 3.0);
        let squares = [creepage.longitudinal.powi(2), creepage.lateral.powi(2), spin * spin];
        let total = squares.iter().copied().sum::<T>();
        if total <= 0.0 {
            return *self;
        }
        let common = total
            / (squares[0] / self.longitudinal + squares[1] / self.lateral + squares[2] / self.spin);
        let saturation = (friction_limit / self.stiffness[0]).powi(2)
            + (friction_limit / self.stiffness[1]).powi(2);
        let share = (((squares[0] + squares[1]) / saturation).sqrt() / 3.0).at_most(1.0);
        let blend = |own: T| (-share + 1.0) * own + share * common;
        Self {
            longitudinal: blend(self.longitudinal),
            lateral: blend(self.lateral),
            spin: blend(self.spin),
            ..*self
        }
    }
}
