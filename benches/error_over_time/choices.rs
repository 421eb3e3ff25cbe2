//! The combinations of models that are compared.

use wheelrail::element::Parameters;
use wheelrail::element::parameters::{
    CreepageModel, Flexibilities, NormalModel, TangentialModel, TractionBound,
};
use wheelrail::planar::PlanarCase;

/// A normal model with its resolution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normal {
    pub model: NormalModel,
    /// Strips across, or boundary elements along and across.
    pub count: usize,
}

/// A tangential model with its resolution and settings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rolling {
    pub model: TangentialModel,
    /// Elements along.
    pub count: usize,
    pub bound: TractionBound,
    pub flexibilities: Flexibilities,
}

/// What the element is told to use.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    pub normal: Normal,
    pub rolling: Rolling,
}

const fn normal(model: NormalModel, count: usize) -> Normal {
    Normal { model, count }
}

/// Normal models that work in real time.
pub const NORMAL: [Normal; 9] = [
    normal(NormalModel::Hertz, 12),
    normal(NormalModel::Hertz, 30),
    normal(NormalModel::PiotrowskiKik, 12),
    normal(NormalModel::PiotrowskiKik, 30),
    normal(NormalModel::PiotrowskiKikCorrected, 30),
    normal(NormalModel::Strips, 11),
    normal(NormalModel::Strips, 15),
    normal(NormalModel::Strips, 21),
    normal(NormalModel::Strips, 31),
];

const fn rolling(
    model: TangentialModel,
    count: usize,
    bound: TractionBound,
    flexibilities: Flexibilities,
) -> Rolling {
    Rolling { model, count, bound, flexibilities }
}

/// No creep force, for the time of the normal problem alone.
pub const WITHOUT: Rolling =
    rolling(TangentialModel::None, 4, TractionBound::Elliptic, Flexibilities::Blended);

/// Tangential models that work in real time.
pub const ROLLING: [Rolling; 9] = [
    rolling(TangentialModel::Linear, 4, TractionBound::Elliptic, Flexibilities::Blended),
    rolling(TangentialModel::Fastsim, 10, TractionBound::Elliptic, Flexibilities::Blended),
    rolling(TangentialModel::Fastsim, 20, TractionBound::Elliptic, Flexibilities::Blended),
    rolling(TangentialModel::Fastsim, 30, TractionBound::Elliptic, Flexibilities::Blended),
    rolling(TangentialModel::Fastsim, 20, TractionBound::Parabolic, Flexibilities::Three),
    rolling(TangentialModel::Fastrip, 10, TractionBound::Elliptic, Flexibilities::Blended),
    rolling(TangentialModel::Fastrip, 20, TractionBound::Elliptic, Flexibilities::Blended),
    rolling(TangentialModel::Tables, 4, TractionBound::Elliptic, Flexibilities::Blended),
    rolling(TangentialModel::FastsimCorrected, 20, TractionBound::Elliptic, Flexibilities::Blended),
];

/// Boundary elements along and across.
pub const BOUNDARY: [usize; 3] = [10, 20, 30];

/// The boundary element solution of both problems with `count` elements along and across.
pub const fn boundary(count: usize) -> Choice {
    Choice {
        normal: normal(NormalModel::BoundaryElement, count),
        rolling: rolling(
            TangentialModel::BoundaryElement,
            count,
            TractionBound::Elliptic,
            Flexibilities::Blended,
        ),
    }
}

impl Normal {
    /// Its FMU name.
    pub fn model_name(self) -> &'static str {
        match self.model {
            NormalModel::Hertz => "hertz",
            NormalModel::PiotrowskiKik => "piotrowski_kik",
            NormalModel::PiotrowskiKikCorrected => "piotrowski_kik_corrected",
            NormalModel::Strips => "strips",
            NormalModel::BoundaryElement => "boundary_element",
            _ => "another model",
        }
    }

    /// Its FMU name and resolution.
    pub fn name(self) -> String {
        format!("{} {}", self.model_name(), self.count)
    }

    /// Whether it takes milliseconds.
    pub fn is_slow(self) -> bool {
        self.model == NormalModel::BoundaryElement
    }
}

impl Rolling {
    /// Its FMU name, resolution, and what is not the default.
    pub fn name(self) -> String {
        let count = self.count;
        match self.model {
            TangentialModel::None => "none".into(),
            TangentialModel::Linear => "linear".into(),
            TangentialModel::Fastsim if self.bound == TractionBound::Parabolic => {
                format!("fastsim {count}, parabolic, three")
            }
            TangentialModel::Fastsim => format!("fastsim {count}"),
            TangentialModel::Fastrip => format!("fastrip {count}"),
            TangentialModel::Tables => "tables".into(),
            TangentialModel::FastsimCorrected => format!("fastsim_corrected {count}"),
            TangentialModel::BoundaryElement => format!("boundary_element {count}"),
            TangentialModel::Strips => format!("strips {count}"),
            _ => "another model".into(),
        }
    }
}

impl Choice {
    /// All combinations, the boundary element ones last.
    pub fn all() -> Vec<Self> {
        let fast = NORMAL
            .iter()
            .flat_map(|&normal| ROLLING.iter().map(move |&rolling| Self { normal, rolling }));
        fast.chain(BOUNDARY.map(boundary)).collect()
    }

    /// Both names.
    pub fn name(self) -> String {
        format!("{} + {}", self.normal.name(), self.rolling.name())
    }

    /// A planar case by these models.
    pub fn of_case<'a>(self, case: &PlanarCase<'a>) -> PlanarCase<'a> {
        let Self { normal, rolling } = self;
        PlanarCase {
            normal_model: normal.model,
            strips: normal.count,
            elements: [normal.count; 2],
            tangential_model: rolling.model,
            elements_along: rolling.count,
            bound: rolling.bound,
            flexibilities: rolling.flexibilities,
            ..*case
        }
    }

    /// Parameters of an element with these models; without damping, so that loads are those of the
    /// penetration.
    pub fn parameters(self) -> Parameters {
        let Self { normal, rolling } = self;
        Parameters {
            normal_model: normal.model,
            strips: normal.count,
            normal_elements: [normal.count; 2],
            tangential_model: rolling.model,
            elements_along: rolling.count,
            bound: rolling.bound,
            flexibilities: rolling.flexibilities,
            damping: 0.0,
            // One plane for each contact, as the reference of the figures has.
            creepage_model: CreepageModel::Flat,
            ..Parameters::default()
        }
    }
}
