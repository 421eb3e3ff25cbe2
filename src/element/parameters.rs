//! What is fixed once an element is initialised.

pub(super) mod checks;
pub(super) mod chosen_models;
pub(super) mod deviations;
pub(super) mod foundation;
pub(super) mod ranges;
pub(super) mod uneven;

pub use crate::friction::Changeover;
pub use crate::geometry::profiles::point_noise::AUTOMATIC_SMOOTHING;
pub use crate::geometry::uneven::waviness::FlatShape;
pub use crate::normal::{NormalModel, ShapeFit};
pub use crate::tangential::fastsim::TractionBound;
pub use crate::tangential::flash_temperature::FlashTemperature;
pub use crate::tangential::friction_law::{FallingLaw, FrictionLaw};
pub use crate::tangential::{Flexibilities, TangentialModel};
pub use crate::wear::{LawCoefficients, WearDistribution, WearModel, WearParameters};
pub use foundation::{Foundation, FoundationModel};
pub use uneven::{Corrugation, OutOfRound, WheelFlat};

use crate::defaults::with_defaults;
use crate::open::Open;

/// On which side of the track the wheel runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// Positive y.
    #[default]
    Right,
    /// Negative y: computed as the mirror image of the right side.
    Left,
}

/// What has a mirror image along the track.
pub(crate) trait Mirror: Copy {
    /// The same seen in a mirror: of a left wheel as of a right one and the reverse.
    fn mirrored(&self) -> Self;
}

impl Side {
    /// What is of a wheel on this side, as a right wheel has it, and the reverse.
    pub(crate) fn mirror<M: Mirror>(self, mut own: M) -> M {
        self.mirror_in_place(&mut own);
        own
    }

    /// As [`mirror`](Self::mirror).
    pub(crate) fn mirror_in_place<M: Mirror>(self, own: &mut M) {
        if self == Self::Left {
            *own = own.mirrored();
        }
    }
}

/// What is given of the vertical motion of the wheel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum VerticalMode {
    /// The height of the wheel; forces follow from the penetration.
    #[default]
    Penetration,
    /// The vertical force that the rails carry; the height is found.
    Load,
}

/// What turns the wheel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Motion {
    /// The pitch rate of the input.
    #[default]
    Given,
    /// The rate at which the nominal rolling circle rolls without longitudinal creepage.
    Rolling,
}

/// How creepage varies over a patch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum CreepageModel {
    /// Longitudinal creepage from the rolling radius only: no lateral creepage, no spin.
    Kinematic,
    /// One triple of creepages for each patch.
    Flat,
    /// For each strip that of its own place and tangent plane (Piotrowski and Kik 2008, section 4).
    #[default]
    Curved,
}

/// What tractions follow from besides the state of the moment.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum TangentialHistory {
    /// Nothing: they are those of steady rolling.
    #[default]
    Steady,
    /// The steps before: how bodies were displaced, and how far they have rolled since.
    Transient,
}

/// How friction is spread over the surface of the rails.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FrictionDistribution {
    /// One coefficient everywhere.
    #[default]
    Uniform,
    /// One for the tread and one for the gauge face.
    Regions,
    /// A table by inclination or place, along the track where it has stations.
    Profile,
}

with_defaults! {
    /// Wheel: profile, size and material.
    #[derive(Clone, Debug, PartialEq)]
    pub struct WheelParameters {
        /// Built-in name or file of the profile; slices or a table of sections where it varies
        /// around.
        pub profile: String = "S1002".into(),
        /// Radius of the nominal rolling circle, > 0 [m].
        pub nominal_radius: f64 = 0.46,
        /// Young's modulus, > 0 [Pa].
        pub young_modulus: f64 = 2.1e11,
        /// Poisson's ratio, 0 to 0.5 [-].
        pub poisson_ratio: f64 = 0.28,
        /// Deviation from a circle.
        pub out_of_round: OutOfRound = OutOfRound::default(),
        /// A flat.
        pub flat: WheelFlat = WheelFlat::default(),
        /// File for the worn profile at the end of a run of the FMU; empty for none.
        pub worn_file: String = String::new(),
        #[doc(hidden)]
        pub open: Open = Open::default(),
    }
}

/// What says where a rail stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Placement {
    /// The gauge: its gauge face is half the gauge from the track centre, its highest point in the
    /// plane of the rail tops.
    #[default]
    Gauge,
    /// The position of its marker, the highest point of its inclined head.
    Position,
    /// The position of the origin of its profile.
    Origin,
}

with_defaults! {
    /// One rail: profile and how it stands. Defaults are those of `rail[1]`; of `rail[2]`, see
    /// [`Parameters::rails`].
    #[derive(Clone, Debug, PartialEq)]
    pub struct RailParameters {
        /// Built-in name or file of the profile; slices or a table of sections where it varies
        /// along the track.
        pub profile: String = "60E1".into(),
        /// Whether this rail takes part.
        pub enabled: bool = true,
        /// Inclination of the profile towards the track centre, as a tangent: 1:40 is 0.025. A
        /// mirrored rail is inclined before it is turned, so that it leans away from the track
        /// centre. The same on both sides of the track [-].
        pub inclination: f64 = 0.025,
        /// What says where it stands.
        pub placement: Placement = Placement::Gauge,
        /// Its place in design position, unless it is placed by gauge: y (negative for a left
        /// wheel, as that of the wheel) and z in the track frame [m].
        pub position: [f64; 2] = [0.75, 0.0],
        /// Distance of the highest point of a roller from its axle, which is across the track at x
        /// = 0 of the track frame; 0 for a straight rail [m].
        pub roller_radius: f64 = 0.0,
        /// Whether the profile, inclined, is turned left to right: the gauge face of a check rail is
        /// on the field side. A left rail is the mirror image of a right one without it.
        pub mirrored: bool = false,
        /// Corrugation.
        pub corrugation: Corrugation = Corrugation::default(),
        /// File for the worn profile at the end of a run of the FMU; empty for none.
        pub worn_file: String = String::new(),
        #[doc(hidden)]
        pub open: Open = Open::default(),
    }
}

with_defaults! {
    /// Everything fixed over a run; one field for each FMU parameter of docs/fmi.md.
    ///
    /// There may be more fields in later versions, so that a literal names some and takes the rest
    /// from others:
    ///
    /// ```
    /// use wheelrail::element::Parameters;
    /// use wheelrail::element::parameters::{NormalModel, TangentialModel};
    ///
    /// let mut parameters = Parameters {
    ///     normal_model: NormalModel::PiotrowskiKik,
    ///     tangential_model: TangentialModel::Fastsim,
    ///     strips: 12,
    ///     ..Parameters::default()
    /// };
    /// parameters.wheel.nominal_radius = 0.5;
    /// ```
    #[derive(Clone, Debug, PartialEq)]
    pub struct Parameters {
        /// Side of the track.
        pub side: Side = Side::Right,
        /// The wheel.
        pub wheel: WheelParameters = WheelParameters::default(),
        /// The rails, `rail[1]` first; the second one is a check rail to be enabled.
        pub rails: [RailParameters; RAILS] = [
            RailParameters::default(),
            RailParameters {
                enabled: false,
                placement: Placement::Position,
                position: [0.633, 0.0],
                mirrored: true,
                ..RailParameters::default()
            },
        ],
        /// Young's modulus of the rails, > 0 [Pa].
        pub rail_young_modulus: f64 = 2.1e11,
        /// Poisson's ratio of the rails, 0 to 0.5 [-].
        pub rail_poisson_ratio: f64 = 0.28,
        /// Track gauge, > 0 [m].
        pub gauge: f64 = 1.435,
        /// Depth below the rail top at which the gauge is measured, > 0 [m].
        pub gauge_depth: f64 = 0.014,
        /// Wavelength at which the smoothing of profiles read from files halves an amplitude; 0
        /// interpolates, and a negative number (-1) leaves the choice to the noise of each file's
        /// points [m].
        pub profile_smoothing: f64 = AUTOMATIC_SMOOTHING,
        /// What is given of the vertical motion.
        pub vertical_mode: VerticalMode = VerticalMode::Penetration,
        /// What turns the wheel.
        pub motion: Motion = Motion::Given,
        /// What the rails rest on.
        pub foundation: Foundation = Foundation::default(),
        /// Normal contact model.
        pub normal_model: NormalModel = NormalModel::Strips,
        /// Virtual over true penetration, 0 < ε < 1 (paper: 0.55) [-].
        pub virtual_penetration: f64 = 0.55,
        /// Ratio of length to width that a corrected contact area gets.
        pub shape_fit: ShapeFit = ShapeFit::Hertz,
        /// Strips, 4 to 200: for [`NormalModel::Strips`] over all zones of a rail, at least 8; for the
        /// others across each zone, one more where it is odd.
        pub strips: usize = 15,
        /// Boundary elements along and across the extent of a contact, 4 to 200.
        pub normal_elements: [usize; 2] = [40, 40],
        /// Contact damping at the reference stiffness, ≥ 0 [N s/m].
        pub damping: f64 = 1e5,
        /// How creepage varies over a patch.
        pub creepage_model: CreepageModel = CreepageModel::Curved,
        /// Floor of the speed that creepages refer to, > 0 [m/s].
        pub minimum_speed: f64 = 1e-3,
        /// Tangential contact model.
        pub tangential_model: TangentialModel = TangentialModel::Marches,
        /// What tractions follow from besides the state of the moment.
        pub tangential_history: TangentialHistory = TangentialHistory::Steady,
        /// Elements along each strip, 4 to 200.
        pub elements_along: usize = 20,
        /// Shape of the traction bound.
        pub bound: TractionBound = TractionBound::Elliptic,
        /// How the flexibilities enter.
        pub flexibilities: Flexibilities = Flexibilities::Blended,
        /// How friction is spread over the surface of the rails.
        pub friction_distribution: FrictionDistribution = FrictionDistribution::Uniform,
        /// File of the table of friction; empty for none.
        pub friction_profile: String = String::new(),
        /// Where the tread changes over to the gauge face.
        pub friction_changeover: Changeover = Changeover::default(),
        /// How friction falls with sliding, and the initial slope on contaminated rails; of the
        /// tread where friction is not uniform.
        pub friction_law: FrictionLaw = FrictionLaw::default(),
        /// The same of the gauge face, where friction is not uniform.
        pub gauge_face_law: FrictionLaw = FrictionLaw::default(),
        /// How friction falls with the temperature that sliding makes.
        pub flash_temperature: FlashTemperature = FlashTemperature::default(),
        /// Yield stress of the rail in shear, for the surface fatigue index, > 0 [Pa].
        pub shear_yield: f64 = 3e8,
        /// Wear.
        pub wear: WearParameters = WearParameters::default(),
        #[doc(hidden)]
        pub open: Open = Open::default(),
    }
}

/// Number of rails an element can carry.
pub const RAILS: usize = 2;

impl Parameters {
    /// The same for a wheel of the given side; places of rails become those of that side.
    pub fn on_side(&self, side: Side) -> Self {
        let sign = if side == Side::Left { -1.0 } else { 1.0 };
        let mut parameters = Self { side, ..self.clone() };
        for rail in &mut parameters.rails {
            rail.position[0] = sign * rail.position[0].abs();
        }
        parameters
    }

    /// Whether anything is uneven along the track.
    pub fn is_uneven(&self) -> bool {
        self.wheel_is_uneven() || (0..self.rails.len()).any(|k| self.is_corrugated(k))
    }

    /// Whether the wheel is not round.
    pub(super) fn wheel_is_uneven(&self) -> bool {
        let OutOfRound { amplitude, file, .. } = &self.wheel.out_of_round;
        *amplitude != 0.0 || !file.is_empty() || self.wheel.flat.length != 0.0
    }

    /// Whether rail number `k` is there and has a height over the station.
    pub(super) fn is_corrugated(&self, k: usize) -> bool {
        let Corrugation { amplitude, file, .. } = &self.rails[k].corrugation;
        self.rails[k].enabled && (*amplitude != 0.0 || !file.is_empty())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_by_default_are_those_of_their_types() {
        let own = Parameters::default();
        assert_eq!(own.side, Side::default());
        assert_eq!(own.rails[0].placement, Placement::default());
        assert_eq!(own.vertical_mode, VerticalMode::default());
        assert_eq!(own.motion, Motion::default());
        assert_eq!(own.foundation.model, FoundationModel::default());
        assert_eq!(own.normal_model, NormalModel::default());
        assert_eq!(own.shape_fit, ShapeFit::default());
        assert_eq!(own.creepage_model, CreepageModel::default());
        assert_eq!(own.tangential_model, TangentialModel::default());
        assert_eq!(own.tangential_history, TangentialHistory::default());
        assert_eq!(own.bound, TractionBound::default());
        assert_eq!(own.flexibilities, Flexibilities::default());
        assert_eq!(own.friction_distribution, FrictionDistribution::default());
        assert_eq!(own.friction_law.falling_law, FallingLaw::default());
        assert_eq!(own.wheel.flat.shape, FlatShape::default());
        assert_eq!(own.wear.model, WearModel::default());
        assert_eq!(own.wear.distribution, WearDistribution::default());
    }
}
