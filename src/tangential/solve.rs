//! The chosen tangential model: from a loaded zone and how it rolls to its creep force.

use super::boundary_element::LoadedElements;
use super::convergence::Convergence;
use super::coupled_marches::CoupledMarches;
use super::creep_number::CreepNumber;
use super::ellipse_force::{Corrected, Tabulated};
use super::fastrip::Fastrip;
use super::fastsim::{Fastsim, TractionBound};
use super::field::ContactField;
use super::flash_temperature::FlashTemperature;
use super::forces::{CreepForce, StripForce};
use super::friction_law::FrictionLaw;
use super::linear::Linear;
use super::march::March;
use super::model::{Flexibilities, TangentialModel};
use super::on_elements::OnElements;
use super::rolling::RollingState;
use super::tables::CreepForceTable;
use super::under_law::UnderLaw;
use super::zone_model::{RollingZone, ZoneModel};
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// The chosen tangential model with its settings.
#[derive(Clone, Debug)]
pub struct Tangential {
    model: Model,
    /// Elements along and across a zone whose pressure is not yet on a grid.
    elements: [usize; 2],
    /// Of tread and gauge face, where slip changes friction or bodies are not clean.
    laws: Option<[FrictionLaw; 2]>,
    /// Where heat changes friction.
    flash_temperature: Option<FlashTemperature>,
}

/// The models, one [`ZoneModel`] each.
#[derive(Clone, Debug)]
enum Model {
    None,
    Linear(March<Linear>),
    Fastsim(March<Fastsim>),
    Fastrip(March<Fastrip>),
    Tables(Tabulated),
    FastsimCorrected(Corrected),
    BoundaryElement(OnElements),
    Marches(CoupledMarches),
}

/// Forces of `zones` that do not feel each other.
fn one_by_one<'a, T: CreepNumber>(
    model: &impl ZoneModel<T>,
    zones: impl Iterator<Item = (usize, RollingZone<'a, T>)>,
    mut each: impl FnMut(usize, usize, StripForce<T>),
) -> Convergence {
    zones.fold(Convergence::default(), |sum, (n, zone)| {
        sum.beside(model.strip_forces(&zone, &mut |j, force| each(n, j, force)))
    })
}

/// Whether there can be tractions by the `model` under a `load` with a friction `limit` [N].
fn acts<T: Real>(model: TangentialModel, load: T, limit: T) -> bool {
    let is_bounded = model != TangentialModel::Linear;
    model != TangentialModel::None && load > 0.0 && (!is_bounded || limit > 0.0)
}

impl Tangential {
    /// A model with `elements_along` ≥ 1 elements along each strip, or boundary elements on a grid
    /// of `elements` along and across a zone whose pressure is not yet on one.
    pub fn new(
        model: TangentialModel,
        flexibilities: Flexibilities,
        bound: TractionBound,
        elements_along: usize,
        elements: [usize; 2],
    ) -> Self {
        let fastsim = March { rule: Fastsim::new(elements_along, bound), flexibilities };
        let table = CreepForceTable::shared;
        let model = match model {
            TangentialModel::None => Model::None,
            TangentialModel::Linear => {
                Model::Linear(March { rule: Linear, flexibilities: Flexibilities::Three })
            }
            TangentialModel::Fastsim => Model::Fastsim(fastsim),
            TangentialModel::Fastrip => {
                Model::Fastrip(March { rule: Fastrip::new(elements_along), flexibilities })
            }
            TangentialModel::Tables => Model::Tables(Tabulated { table: table(), shown: fastsim }),
            TangentialModel::FastsimCorrected => Model::FastsimCorrected(Corrected {
                march: fastsim,
                table: table(),
                circle: Box::default(),
            }),
            TangentialModel::BoundaryElement => {
                Model::BoundaryElement(OnElements { count: elements, otherwise: fastsim })
            }
            TangentialModel::Marches => Model::Marches(CoupledMarches::new(elements[1])),
        };
        Self { model, elements, laws: None, flash_temperature: None }
    }

    /// The same for zones that have up to `strips` strips together; more allocate.
    #[must_use]
    pub fn for_strips(mut self, strips: usize) -> Self {
        if let Model::Marches(marches) = &mut self.model {
            *marches = CoupledMarches::new(strips);
        }
        self
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
        match &self.model {
            Model::None => TangentialModel::None,
            Model::Linear(_) => TangentialModel::Linear,
            Model::Fastsim(_) => TangentialModel::Fastsim,
            Model::Fastrip(_) => TangentialModel::Fastrip,
            Model::Tables(_) => TangentialModel::Tables,
            Model::FastsimCorrected(_) => TangentialModel::FastsimCorrected,
            Model::BoundaryElement(_) => TangentialModel::BoundaryElement,
            Model::Marches(_) => TangentialModel::Marches,
        }
    }

    /// Whether the forces of the strips are corrected as a whole.
    pub fn is_corrected(&self) -> bool {
        matches!(self.model, Model::FastsimCorrected(_) | Model::Marches(_))
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
        acts(self.model(), zone.load * law.state.load_factor, law.state.friction_limit(zone))
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
        let kind = self.model();
        let zones = zones.enumerate().filter(|(_, RollingZone { loaded, state, limit, .. })| {
            acts(kind, loaded.zone.load * state.load_factor, *limit)
        });
        match &mut self.model {
            Model::None => Convergence::default(),
            Model::Linear(model) => one_by_one(model, zones, each),
            Model::Fastsim(model) => one_by_one(model, zones, each),
            Model::Fastrip(model) => one_by_one(model, zones, each),
            Model::Tables(model) => one_by_one(model, zones, each),
            Model::FastsimCorrected(model) => one_by_one(model, zones, each),
            Model::BoundaryElement(model) => one_by_one(model, zones, each),
            Model::Marches(model) => {
                model.roll(&zones, each);
                Convergence::default()
            }
        }
    }

    /// Pressure and tractions of a zone with one creepage that rolls forward; of all zones where
    /// the normal model has boundary elements. FASTSIM, marches and boundary elements have
    /// tractions to show, the tables and corrected FASTSIM those of FASTSIM, corrections none, other
    /// models pressure alone.
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
        match &mut self.model {
            Model::Fastsim(march)
            | Model::Tables(Tabulated { shown: march, .. })
            | Model::FastsimCorrected(Corrected { march, .. }) => {
                march.draw(&zone, &elements, &mut field);
            }
            Model::BoundaryElement(_) => OnElements::draw(&zone, &elements, &mut field),
            Model::Marches(model) => model.draw(&zone, &elements, &mut field),
            Model::None | Model::Linear(_) | Model::Fastrip(_) => {}
        }
        field
    }
}
