//! The chosen tangential model: from a loaded zone and how it rolls to its creep force.

use super::convergence::Convergence;
use super::creep_number::CreepNumber;
use super::fastrip::Fastrip;
use super::fastsim::{Fastsim, TractionBound};
use super::fastsim_correction::EllipseStrips;
use super::flash_temperature::FlashTemperature;
use super::forces::{CreepForce, StripForce};
use super::friction_law::FrictionLaw;
use super::loaded_zone::LoadedZone;
use super::model::{Flexibilities, TangentialModel};
use super::neck::Lobes;
use super::rigid_slip::{FlatSlip, RigidSlip};
use super::rolling::{Rolling, RollingState};
use super::strips::Scratch;
use super::tables::CreepForceTable;
use super::under_law::UnderLaw;
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// Points along each strip of the strip model that was not told another number.
const STRIP_POINTS: usize = 15;

/// The chosen tangential model with its settings.
#[derive(Clone, Debug)]
pub struct Tangential {
    pub(super) model: TangentialModel,
    pub(super) flexibilities: Flexibilities,
    pub(super) fastsim: Fastsim,
    pub(super) elements: [usize; 2],
    pub(super) fastrip: Fastrip,
    /// The table and a circle to stretch, for the models that use them.
    pub(super) table: Option<&'static CreepForceTable>,
    pub(super) ellipse_strips: Option<EllipseStrips>,
    /// The solver of the strip model.
    pub(super) traction_strips: Option<Scratch>,
    /// Of tread and gauge face, where slip changes friction or bodies are not clean.
    pub(super) laws: Option<[FrictionLaw; 2]>,
    /// Where heat changes friction.
    pub(super) flash_temperature: Option<FlashTemperature>,
}

/// How the tractions of a zone were found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Solved<T = f64> {
    /// Friction limit of the zone as it slips [N].
    pub limit: T,
    /// How they converged.
    pub convergence: Convergence,
}

impl Tangential {
    /// A model with `elements_along` ≥ 1 elements along each strip, or boundary elements on a grid
    /// of `elements` along and across a zone whose pressure is not yet on one.
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

    /// The same with `points` along each strip of the strip model, 4 to 15, in zones of up to
    /// `strips` strips; larger ones allocate.
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

    /// `zone` of `strips` in `state` under the laws of friction.
    #[must_use]
    pub fn under_law<T: Real>(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        material: &MaterialPair<T>,
        state: &RollingState<T>,
    ) -> UnderLaw<T> {
        let heat = self.flash_temperature.as_ref();
        UnderLaw::of(self.laws.as_ref(), heat, zone, strips, material, state)
    }

    /// The creep force on the wheel of a zone with one creepage at its centroid of load; nothing
    /// where there is nothing to compute: no model, no friction, no load or no creepage.
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

    /// As [`creep_force`](Self::creep_force), of a zone with the friction and the elastic constants
    /// of `law`, which is that of [`under_law`](Self::under_law); `each` gets the number of each
    /// strip and the force on it, as from [`strip_forces`](Self::strip_forces).
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
        let solved = self.strip_forces(zone, strips, &slip, law, |j, force| {
            total.add(zone, strips, j, &force);
            each(j, &force);
        })?;
        Some(CreepForce { convergence: solved.convergence, ..total })
    }

    /// Hands the force on the wheel of each strip of a zone with the rigid slip `slip` to `each`,
    /// which adds them up: a strip may come twice. Nothing where there was nothing to compute.
    /// `law` is that of the mean creepage of `slip`.
    ///
    /// Between forward and backward rolling, which only the floor of the reference speed and wheels
    /// that spin against their motion leave room for, the forces of both directions are mixed, so
    /// that the force has no jump.
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
        let mut solved = Solved { limit, convergence: Convergence::default() };
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
                solved.convergence = solved.convergence.and(Convergence::failed());
            }
            if let Some(solver) = &self.traction_strips {
                let add = |j, force: StripForce<T>| each(j, force.times(share));
                let settled = T::on_strips(&mut solver.lend(), &loaded, rolling, add);
                let convergence =
                    settled.map_or(Convergence::failed(), |settled| settled.convergence());
                solved.convergence = solved.convergence.and(convergence);
                if settled.is_some() {
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
