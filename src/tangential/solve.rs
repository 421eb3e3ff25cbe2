//! The chosen tangential model: from a loaded zone and how it rolls to its creep force.

use super::boundary_element::LoadedElements;
use super::convergence::Convergence;
use super::creep_number::CreepNumber;
use super::field::ContactField;
use super::flash_temperature::FlashTemperature;
use super::forces::{CreepForce, StripForce};
use super::friction_law::FrictionLaw;
use super::model::{Model, Settings, TangentialModel};
use super::rolling::RollingState;
use super::under_law::UnderLaw;
use super::zone_model::RollingZone;
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// The chosen tangential model with its settings.
#[derive(Clone, Debug)]
pub struct Tangential {
    kind: TangentialModel,
    model: Model,
    /// Elements along and across a zone whose pressure is not yet on a grid.
    elements: [usize; 2],
    /// Of tread and gauge face, where slip changes friction or bodies are not clean.
    laws: Option<[FrictionLaw; 2]>,
    /// Where heat changes friction.
    flash_temperature: Option<FlashTemperature>,
}

/// Whether there can be tractions by the `model` under a `load` with a friction `limit` [N].
fn acts<T: Real>(model: TangentialModel, load: T, limit: T) -> bool {
    let is_bounded = model != TangentialModel::Linear;
    model != TangentialModel::None && load > 0.0 && (!is_bounded || limit > 0.0)
}

impl Tangential {
    /// The model of that `kind`.
    pub fn new(kind: TangentialModel, settings: &Settings) -> Self {
        let (model, elements) = (kind.with(settings), settings.elements);
        Self { kind, model, elements, laws: None, flash_temperature: None }
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

    /// Which model it is.
    pub fn model(&self) -> TangentialModel {
        self.kind
    }

    /// Whether the forces of the strips are corrected as a whole.
    pub fn is_corrected(&self) -> bool {
        matches!(self.kind, TangentialModel::FastsimCorrected | TangentialModel::Marches)
    }

    /// `zone` of `strips` in `state` under the laws of friction.
    pub fn under_law<T: Real>(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        material: &MaterialPair<T>,
        state: &RollingState<T>,
    ) -> UnderLaw<T> {
        let heat = self.flash_temperature.as_ref();
        if T::IS_BACKWARD {
            let laws = self.laws.as_ref().map(|laws| [0, 1].map(|k| laws[k].known::<T>(k)));
            return UnderLaw::of(laws.as_ref(), heat, zone, strips, material, state);
        }
        UnderLaw::of(self.laws.as_ref(), heat, zone, strips, material, state)
    }

    /// The creep force on the wheel of a zone by itself with one creepage at its centroid of load;
    /// nothing where there is nothing to compute: no model, no friction, no load or no creepage.
    pub fn creep_force<T: CreepNumber>(
        &mut self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        material: &MaterialPair<T>,
        state: &RollingState<T>,
    ) -> Option<CreepForce<T>> {
        let law = self.under_law(zone, strips, material, state);
        let rolling = RollingZone::flat(zone, strips, &law);
        (self.acts_on(zone, &law) && !rolling.state.creepage.is_zero()).then(|| {
            let mut total = CreepForce::<T>::default();
            total.convergence = self.roll(std::iter::once(rolling), |_, j, force| {
                total.add(zone, strips, j, &force);
            });
            total
        })
    }

    /// Whether there can be tractions in a zone under `law`: with a model, load, and friction that
    /// bounds them.
    pub fn acts_on<T: Real>(&self, zone: &Zone<T>, law: &UnderLaw<T>) -> bool {
        acts(self.kind, zone.load * law.state.load_factor, law.state.friction_limit(zone))
    }

    /// Hands the force on the wheel of each strip of `zones`, which are all that feel each other in
    /// the order of their places across, to `each`: with the number of the zone among them and that
    /// of the strip. It adds them up: a strip may come twice. Zones on which the model does not
    /// [act](Self::acts_on) have none.
    pub fn roll<'a, T: CreepNumber>(
        &mut self,
        zones: impl Iterator<Item = RollingZone<'a, T>> + Clone,
        each: impl FnMut(usize, usize, StripForce<T>),
    ) -> Convergence {
        let kind = self.kind;
        let zones = zones.enumerate().filter(|(_, RollingZone { loaded, state, limit, .. })| {
            acts(kind, loaded.zone.load * state.load_factor, *limit)
        });
        self.model.roll(zones, each)
    }

    /// Pressure and tractions of a zone with one creepage that rolls forward; of all zones where
    /// the normal model has boundary elements. Models without tractions show pressure alone.
    pub fn field(
        &mut self,
        zone: &Zone,
        strips: &Strips,
        material: &MaterialPair,
        state: &RollingState,
    ) -> ContactField {
        let law = self.under_law(zone, strips, material, state);
        let state = law.state;
        let elements = LoadedElements::of(zone, strips, self.elements);
        let mut field = ContactField::of_pressure(elements.grid, elements.pressure.clone());
        let friction = state.friction * state.load_factor;
        if friction <= 0.0 || state.creepage.is_zero() {
            return field;
        }
        let zone = RollingZone::flat(zone, strips, &law);
        self.model.draw(&zone, &elements, &mut field);
        field
    }
}
