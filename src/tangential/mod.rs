//! Tangential contact: creep forces of loaded zones.

pub mod boundary_element;
mod ellipse_force;
pub mod equivalent_ellipse;
pub mod fastrip;
pub mod fastsim;
pub mod fastsim_correction;
pub mod field;
pub mod flash_temperature;
pub mod flexibility;
mod forces;
pub mod friction_law;
pub mod kalker_coefficients;
pub mod linear;
mod loaded_zone;
mod march;
pub mod neck;
mod outline;
mod own_friction;
pub mod rigid_slip;
pub mod strips;
pub mod tables;
mod under_law;

pub use crate::kinematics::creepage::Creepage;
pub use forces::{CreepForce, StripForce};
pub use loaded_zone::LoadedZone;
pub use under_law::UnderLaw;

use crate::material::MaterialPair;
use crate::math::dual::Dual;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};
use boundary_element::LoadedElements;
use fastrip::Fastrip;
use fastsim::{Fastsim, TractionBound};
use fastsim_correction::EllipseStrips;
use flash_temperature::FlashTemperature;
use friction_law::FrictionLaw;
use neck::Lobes;
use rigid_slip::{FlatSlip, RigidSlip};
use strips::{Scratch, Settled, TractionStrips};
use tables::CreepForceTable;

/// Tangential contact model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TangentialModel {
    /// No creep force.
    None,
    /// Full adhesion without bound: the limit of FASTSIM for infinite friction.
    Linear,
    /// Kalker's march through the strips of the true patch.
    Fastsim,
    /// Strip theory where the strips adhere, directions of FASTSIM where they slip.
    Fastrip,
    /// The force of the ellipse with the same moments of load, from a table of boundary element solutions; no tractions.
    Tables,
    /// FASTSIM on the true patch, its force corrected by what it is wrong by on that ellipse.
    #[default]
    FastsimCorrected,
    /// The half-space solution on rectangular elements: slow, for checking the others.
    BoundaryElement,
    /// The half-space solution in a few points along a few strips of the true patch.
    Strips,
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

impl Rolling {
    /// 1 when rolling forward, -1 when backward.
    fn direction(self) -> f64 {
        match self {
            Self::Forward => 1.0,
            Self::Backward => -1.0,
        }
    }
}

/// How a zone rolls and how much friction it has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingState<T = f64> {
    /// Creepage at the centroid of load of the zone.
    pub creepage: Creepage<T>,
    /// 1 when rolling forward, 0 when backward; see [`rolling_speed`](crate::kinematics::creepage::rolling_speed) [-].
    pub forward_share: T,
    /// Coefficient of friction, ≥ 0; without effect where strips have their own [-].
    pub friction: T,
    /// Normal force with damping over that without, ≥ 0 [-].
    pub load_factor: T,
    /// Speed that creepages refer to, ≥ 0 [m/s]; for friction that falls with the sliding speed alone.
    pub speed: T,
}

impl<T: Real> RollingState<T> {
    /// Friction limit μ N of `zone`, ≥ 0 [N].
    #[must_use]
    pub fn friction_limit(&self, zone: &Zone<T>) -> T {
        self.friction * zone.load * self.load_factor
    }
}

/// Points along each strip of the strip model that was not told another number.
const STRIP_POINTS: usize = 15;

/// The chosen tangential model with its settings.
#[derive(Clone, Debug)]
pub struct Tangential {
    model: TangentialModel,
    flexibilities: Flexibilities,
    fastsim: Fastsim,
    elements: [usize; 2],
    fastrip: Fastrip,
    /// The table and a circle to stretch, for the models that use them.
    table: Option<&'static CreepForceTable>,
    ellipse_strips: Option<EllipseStrips>,
    /// The solver of the strip model.
    traction_strips: Option<Scratch>,
    /// Of tread and gauge face, where slip changes friction or bodies are not clean.
    laws: Option<[FrictionLaw; 2]>,
    /// Where heat changes friction.
    flash_temperature: Option<FlashTemperature>,
}

impl Tangential {
    /// A model with `elements_along` ≥ 1 elements along each strip, or boundary elements on a grid of `elements` along and across a
    /// zone whose pressure is not yet on one.
    #[must_use]
    pub fn new(
        model: TangentialModel,
        flexibilities: Flexibilities,
        bound: TractionBound,
        elements_along: usize,
        elements: [usize; 2],
    ) -> Self {
        Self {
            model,
            flexibilities,
            fastsim: Fastsim::new(elements_along, bound),
            fastrip: Fastrip::new(elements_along),
            elements,
            table: matches!(model, TangentialModel::Tables | TangentialModel::FastsimCorrected)
                .then(CreepForceTable::shared),
            ellipse_strips: (model == TangentialModel::FastsimCorrected)
                .then(EllipseStrips::default),
            traction_strips: (model == TangentialModel::Strips)
                .then(|| Scratch::new(STRIP_POINTS, elements[1])),
            laws: None,
            flash_temperature: None,
        }
    }

    /// The same with `points` along each strip of the strip model, 4 to 15, in zones of up to `strips` strips; larger ones allocate.
    #[must_use]
    pub fn with_points(self, points: usize, strips: usize) -> Self {
        let is_strips = self.model == TangentialModel::Strips;
        Self { traction_strips: is_strips.then(|| Scratch::new(points, strips)), ..self }
    }

    /// The same with another law of friction everywhere.
    #[must_use]
    pub fn with_law(self, law: FrictionLaw) -> Self {
        self.with_laws([law; 2])
    }

    /// The same with other laws of friction on tread and gauge face.
    #[must_use]
    pub fn with_laws(self, laws: [FrictionLaw; 2]) -> Self {
        Self { laws: laws.iter().any(FrictionLaw::is_on).then_some(laws), ..self }
    }

    /// The same with friction that falls with temperature.
    #[must_use]
    pub fn with_flash_temperature(self, heat: FlashTemperature) -> Self {
        Self { flash_temperature: heat.is_on().then_some(heat), ..self }
    }

    /// The model.
    #[must_use]
    pub fn model(&self) -> TangentialModel {
        self.model
    }

    /// Whether the forces of the strips are corrected as a whole.
    #[must_use]
    pub fn is_corrected(&self) -> bool {
        self.model == TangentialModel::FastsimCorrected
    }

    /// The creep force on the wheel of a zone with one creepage at its centroid of load; nothing where there is nothing to
    /// compute: no model, no friction, no load or no creepage.
    #[must_use]
    pub fn creep_force<T: CreepNumber>(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        material: &MaterialPair<T>,
        state: &RollingState<T>,
    ) -> Option<CreepForce<T>> {
        let law = self.under_law(zone, strips, material, state);
        self.creep_force_under(zone, strips, &law, |_, _| {})
    }

    /// As [`creep_force`](Self::creep_force), of a zone with the friction and the elastic constants of `law`, which is that of [`under_law`](Self::under_law); `each` gets the number of each strip and the
    /// force on it, as from [`strip_forces`](Self::strip_forces).
    #[must_use]
    #[inline]
    pub fn creep_force_under<T: CreepNumber>(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        law: &UnderLaw<T>,
        mut each: impl FnMut(usize, &StripForce<T>),
    ) -> Option<CreepForce<T>> {
        let creepage = law.state.creepage;
        (!creepage.is_zero()).then_some(())?;
        let slip = FlatSlip { zone, strips, creepage };
        let mut total = CreepForce::<T>::default();
        let marched = self.strip_forces(zone, strips, &slip, law, |j, force| {
            total.add(zone, strips, j, &force);
            each(j, &force);
        })?;
        Some(CreepForce { fell_back: marched.fell_back, residual: marched.residual, ..total })
    }

    /// Hands the force on the wheel of each strip of a zone with the rigid slip `slip` to `each`, which adds them up: a strip may
    /// come twice. Nothing where there was nothing to compute. `law` is that of the mean creepage of `slip`.
    ///
    /// Between forward and backward rolling, which only the floor of the reference speed and wheels that spin against
    /// their motion leave room for, the forces of both directions are mixed, so that the force has no jump.
    pub fn strip_forces<T: CreepNumber>(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        slip: &impl RigidSlip<T>,
        law: &UnderLaw<T>,
        mut each: impl FnMut(usize, StripForce<T>),
    ) -> Option<Solved<T>> {
        let state = law.state;
        let limit = state.friction_limit(zone);
        let is_bounded = self.model != TangentialModel::Linear;
        let load = zone.load * state.load_factor;
        if self.model == TangentialModel::None || load <= 0.0 || (is_bounded && limit <= 0.0) {
            return None;
        }
        let loaded = LoadedZone::new(zone, strips, slip, law);
        // Strips know no ellipse, and need no lobes.
        let is_strips = self.model == TangentialModel::Strips;
        let lobes = if is_strips { None } else { Lobes::of(&loaded) };
        let mut solved = Solved { limit, fell_back: false, residual: 0.0 };
        if self.model == TangentialModel::Tables {
            let none = [CreepForce::default(); 3];
            self.ellipse_force(&loaded, lobes.as_ref(), &state, &none, each)?;
            return Some(solved);
        }
        let elements = (self.model == TangentialModel::BoundaryElement)
            .then(|| T::elements(zone, strips, self.elements))
            .flatten();
        let backward_share = -state.forward_share + 1.0;
        let parts = self.marched_parts(&loaded, lobes.as_ref(), limit);
        let mut marched = [CreepForce::<T>::default(); 3];
        for (rolling, share) in
            [(Rolling::Forward, state.forward_share), (Rolling::Backward, backward_share)]
        {
            if share <= 0.0 {
                continue;
            }
            if let Some(elements) = &elements {
                let add = |j, force: StripForce<T>| each(j, force.times(share));
                if T::on_elements(elements, &loaded, rolling, add) {
                    continue;
                }
                solved.fell_back = true;
            }
            if let Some(solver) = &self.traction_strips {
                let add = |j, force: StripForce<T>| each(j, force.times(share));
                let settled = T::on_strips(&mut solver.lend(), &loaded, rolling, add);
                solved.fell_back |= !settled.is_some_and(|settled| settled.converged());
                if let Some(settled) = settled {
                    solved.residual = solved.residual.max(settled.left);
                    continue;
                }
            }
            // Damping that takes load away takes creep force away, so that a lost contact has none.
            let share = if is_bounded { share } else { share * state.load_factor.at_most(1.0) };
            self.march(&loaded, rolling, &parts, |part, j, force| {
                let force = force.times(share);
                if self.is_corrected() {
                    marched[part].add(zone, strips, j, &force);
                }
                each(j, force);
            });
        }
        if self.is_corrected() {
            self.ellipse_force(&loaded, lobes.as_ref(), &state, &marched, each);
        }
        Some(solved)
    }
}

/// Numbers with which tangential problems are solved; the half-space solution on elements is one of plain numbers alone.
pub trait CreepNumber:
    fastsim::Marching + fastrip::Marching + tables::tabulated::Tabulated
{
    /// The elements of a zone for the half-space solution.
    #[must_use]
    fn elements(_: &Zone<Self>, _: &Strips<Self>, _: [usize; 2]) -> Option<LoadedElements> {
        None
    }

    /// Solves on strips and hands the force of each strip to `each`; nothing where there is no solution.
    fn on_strips(
        solver: &mut TractionStrips,
        loaded: &LoadedZone<'_, impl RigidSlip<Self>, Self>,
        rolling: Rolling,
        each: impl FnMut(usize, StripForce<Self>),
    ) -> Option<Settled>;

    /// Solves on the elements and hands the force of each strip to `each`; false where no solution was found.
    #[must_use]
    fn on_elements(
        _: &LoadedElements,
        _: &LoadedZone<'_, impl RigidSlip<Self>, Self>,
        _: Rolling,
        _: impl FnMut(usize, StripForce<Self>),
    ) -> bool {
        false
    }
}

impl<const N: usize> CreepNumber for Dual<N> {
    fn on_strips(
        solver: &mut TractionStrips,
        loaded: &LoadedZone<'_, impl RigidSlip<Self>, Self>,
        rolling: Rolling,
        each: impl FnMut(usize, StripForce<Self>),
    ) -> Option<Settled> {
        solver.moving_strip_forces(loaded, rolling, each)
    }
}

impl CreepNumber for f64 {
    fn on_strips(
        solver: &mut TractionStrips,
        loaded: &LoadedZone<'_, impl RigidSlip>,
        rolling: Rolling,
        each: impl FnMut(usize, StripForce),
    ) -> Option<Settled> {
        solver.strip_forces(loaded, rolling, each)
    }

    fn elements(zone: &Zone, strips: &Strips, count: [usize; 2]) -> Option<LoadedElements> {
        Some(LoadedElements::of(zone, strips, count))
    }

    fn on_elements(
        elements: &LoadedElements,
        loaded: &LoadedZone<'_, impl RigidSlip>,
        rolling: Rolling,
        each: impl FnMut(usize, StripForce),
    ) -> bool {
        let tractions = elements.tractions(loaded, rolling);
        if tractions.converged {
            elements.strip_forces(loaded.zone, loaded.strips, &tractions, each);
        }
        tractions.converged
    }
}

/// How the tractions of a zone were found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solved<T = f64> {
    /// Friction limit of the zone as it slips [N].
    pub limit: T,
    /// Whether the chosen model did not converge: FASTSIM took the place of boundary elements; strips keep their last step, within the bound.
    pub fell_back: bool,
    /// Greatest part of the bound that tractions on strips are away from the law of friction; 0 for other models [-].
    pub residual: f64,
}
