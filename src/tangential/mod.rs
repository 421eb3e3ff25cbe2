//! Tangential contact: creep forces of loaded zones.

pub mod fastsim;
pub mod flexibility;
pub mod kalker_coefficients;

pub use crate::kinematics::creepage::Creepage;
use crate::material::MaterialPair;
use crate::normal::{Strips, Zone};
use fastsim::{Fastsim, TractionBound};
use flexibility::ZoneFlexibility;

/// Tangential contact model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TangentialModel {
    /// No creep force.
    None,
    /// Kalker's march through the strips of the true patch.
    #[default]
    Fastsim,
}

/// How the three flexibilities of the simplified theory enter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Flexibilities {
    /// One for each creepage.
    Three,
    /// Blended towards a common one as the creepage grows (Vollebregt and Voltr 2023).
    #[default]
    Blended,
}

/// Which end of the strips leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rolling {
    /// The contact moves towards positive x.
    Forward,
    /// The contact moves towards negative x.
    Backward,
}

/// Creep force of one zone on the wheel, in the contact frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CreepForce {
    /// Longitudinal force [N].
    pub longitudinal: f64,
    /// Lateral force [N].
    pub lateral: f64,
    /// Moment about the normal through the centroid of the load [N m].
    pub spin_moment: f64,
    /// Area that slips [m²].
    pub slip_area: f64,
}

/// How a zone rolls and how much friction it has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingState {
    /// Creepage at the centroid of load of the zone.
    pub creepage: Creepage,
    /// 1 when rolling forward, 0 when backward; see [`rolling_speed`](crate::kinematics::creepage::rolling_speed) [-].
    pub forward_share: f64,
    /// Coefficient of friction, ≥ 0 [-].
    pub friction: f64,
    /// Normal force with damping over that without, ≥ 0 [-].
    pub load_factor: f64,
}

/// The chosen tangential model with its settings.
#[derive(Clone, Debug)]
pub struct Tangential {
    model: TangentialModel,
    flexibilities: Flexibilities,
    fastsim: Fastsim,
}

impl Tangential {
    /// A model with `elements_along` ≥ 1 elements along each strip.
    #[must_use]
    pub fn new(
        model: TangentialModel,
        flexibilities: Flexibilities,
        bound: TractionBound,
        elements_along: usize,
    ) -> Self {
        Self { model, flexibilities, fastsim: Fastsim::new(elements_along, bound) }
    }

    /// The creep force of a zone on the wheel; nothing where there is nothing to compute: no model, no friction, no load or no
    /// creepage.
    ///
    /// Between forward and backward rolling, which only the floor of the reference speed and wheels that spin against
    /// their motion leave room for, the forces of both directions are mixed, so that the force has no jump.
    #[must_use]
    pub fn creep_force(
        &self,
        zone: &Zone,
        strips: &Strips,
        material: &MaterialPair,
        state: &RollingState,
    ) -> Option<CreepForce> {
        let RollingState { creepage, forward_share, friction, load_factor } = *state;
        let limit = friction * zone.load * load_factor;
        if self.model == TangentialModel::None || limit <= 0.0 || creepage.is_zero() {
            return None;
        }
        let mut flexibility = ZoneFlexibility::new(zone, strips, material);
        if self.flexibilities == Flexibilities::Blended {
            flexibility = flexibility.blended(&creepage, limit);
        }
        let march = |rolling| {
            let friction = friction * load_factor;
            self.fastsim.creep_force(zone, strips, &flexibility, &creepage, rolling, friction)
        };
        let backward_share = 1.0 - forward_share;
        Some(if backward_share <= 0.0 {
            march(Rolling::Forward)
        } else if forward_share <= 0.0 {
            march(Rolling::Backward)
        } else {
            let (forward, backward) = (march(Rolling::Forward), march(Rolling::Backward));
            let mix = |f: f64, b: f64| forward_share * f + backward_share * b;
            CreepForce {
                longitudinal: mix(forward.longitudinal, backward.longitudinal),
                lateral: mix(forward.lateral, backward.lateral),
                spin_moment: mix(forward.spin_moment, backward.spin_moment),
                slip_area: mix(forward.slip_area, backward.slip_area),
            }
        })
    }
}
