//! Which tangential contact models there are.

use super::boundary_element::LoadedElements;
use super::convergence::Convergence;
use super::coupled_marches::CoupledMarches;
use super::creep_number::CreepNumber;
use super::ellipse_force::{Corrected, Tabulated};
use super::fastrip::Fastrip;
use super::fastsim::{Fastsim, TractionBound};
use super::field::ContactField;
use super::flexibility::Flexibilities;
use super::forces::StripForce;
use super::linear::Linear;
use super::march::March;
use super::on_elements::OnElements;
use super::tables::CreepForceTable;
use super::zone_model::{RollingZone, ZoneModel};

/// What models are made from.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// How the flexibilities of the simplified theory enter.
    pub flexibilities: Flexibilities,
    /// Shape of the traction bound.
    pub bound: TractionBound,
    /// Elements along each strip, ≥ 1.
    pub elements_along: usize,
    /// Boundary elements along and across a zone whose pressure is not yet on a grid, ≥ 1.
    pub elements: [usize; 2],
    /// Most strips that zones have together; more allocate.
    pub strips: usize,
}

impl Settings {
    fn fastsim(&self) -> March<Fastsim> {
        let rule = Fastsim::new(self.elements_along, self.bound);
        March { rule, flexibilities: self.flexibilities }
    }
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

/// The list of models: of each its name, the type that has it, how that is made from the settings,
/// the function by which zones roll, and whether there are tractions that belong to its force.
macro_rules! models {
    ($settings:ident: $(
        $(#[$about:meta])*
        $name:ident($model:ty) = $made:expr, roll: $roll:expr, has_tractions: $has:literal;
    )*) => {
        /// Tangential contact model.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum TangentialModel {
            $($(#[$about])* $name,)*
        }

        /// A model with its settings and its memory.
        #[derive(Clone, Debug)]
        pub(super) enum Model {
            $($name($model),)*
        }

        impl TangentialModel {
            /// Whether tractions are known that belong to its creep force, if it has one: those of
            /// its own, or of FASTSIM.
            pub fn has_tractions(self) -> bool {
                match self { $(Self::$name => $has,)* }
            }

            pub(super) fn with(self, $settings: &Settings) -> Model {
                match self { $(Self::$name => Model::$name($made),)* }
            }
        }

        impl Model {
            /// Hands the force on the wheel of each strip of `zones` to `each`: see
            /// [`Tangential::roll`](super::Tangential::roll).
            pub fn roll<'a, T: CreepNumber>(
                &mut self,
                zones: impl Iterator<Item = (usize, RollingZone<'a, T>)> + Clone,
                each: impl FnMut(usize, usize, StripForce<T>),
            ) -> Convergence {
                match self { $(Self::$name(model) => $roll(model, zones, each),)* }
            }
        }
    };
}

models! { settings:
    /// No creep force.
    None(()) = (), roll: |&mut (), _, _| Convergence::default(), has_tractions: true;
    /// Full adhesion without bound: the limit of FASTSIM for infinite friction.
    Linear(March<Linear>) = March { rule: Linear, flexibilities: Flexibilities::Three },
        roll: one_by_one, has_tractions: false;
    /// Kalker's march through the strips of the true patch.
    Fastsim(March<Fastsim>) = settings.fastsim(), roll: one_by_one, has_tractions: true;
    /// Strip theory where the strips adhere, directions of FASTSIM where they slip.
    Fastrip(March<Fastrip>) = March {
            rule: Fastrip::new(settings.elements_along), flexibilities: settings.flexibilities,
        },
        roll: one_by_one, has_tractions: false;
    /// The force of the ellipse with the same moments of load, from a table of boundary element
    /// solutions; no tractions.
    Tables(Tabulated) = Tabulated { table: CreepForceTable::shared(), shown: settings.fastsim() },
        roll: one_by_one, has_tractions: true;
    /// FASTSIM on the true patch, its force corrected by its error on that ellipse.
    FastsimCorrected(Corrected) = Corrected {
            march: settings.fastsim(), table: CreepForceTable::shared(), circle: Box::default(),
        },
        roll: one_by_one, has_tractions: true;
    /// The half-space solution on rectangular elements: slow, for checking the others.
    BoundaryElement(OnElements) =
        OnElements { count: settings.elements, otherwise: settings.fastsim() },
        roll: one_by_one, has_tractions: true;
    /// Marches through the strips of the true patch, which feel each other through the half-space,
    /// their force corrected by its error on the ellipse.
    #[default]
    Marches(CoupledMarches) = CoupledMarches::new(settings.strips),
        roll: |model, zones, each| CoupledMarches::roll(model, &zones, each), has_tractions: true;
}

impl Model {
    /// Enters the tractions of a zone that rolls forward into `field`, whose grid is that of the
    /// elements; of models that correct forces those before the correction.
    pub fn draw(&mut self, zone: &RollingZone, on: &LoadedElements, field: &mut ContactField) {
        match self {
            Self::Fastsim(march)
            | Self::Tables(Tabulated { shown: march, .. })
            | Self::FastsimCorrected(Corrected { march, .. }) => march.draw(zone, on, field),
            Self::BoundaryElement(_) => OnElements::draw(zone, on, field),
            Self::Marches(model) => model.draw(zone, on, field),
            Self::None(()) | Self::Linear(_) | Self::Fastrip(_) => {}
        }
    }
}
