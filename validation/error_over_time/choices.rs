//! The combinations of models that are compared.

use wheelrail::element::Parameters;
use wheelrail::element::parameters::{
    CreepageModel, Flexibilities, NormalModel, TangentialModel, TractionBound, VerticalMode,
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

/// Normal models that work in real time, those with nodes from few to many.
pub const NORMAL: [Normal; 10] = [
    normal(NormalModel::Hertz, 12),
    normal(NormalModel::PiotrowskiKik, 12),
    normal(NormalModel::PiotrowskiKikCorrected, 12),
    normal(NormalModel::Strips, 8),
    normal(NormalModel::Strips, 10),
    normal(NormalModel::Strips, 12),
    normal(NormalModel::Strips, DEFAULT_NODES),
    normal(NormalModel::Strips, 20),
    normal(NormalModel::Strips, 28),
    normal(NormalModel::Strips, 40),
];

/// Nodes of the element as it starts.
pub const DEFAULT_NODES: usize = 15;

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
    FASTSIM,
    rolling(TangentialModel::Fastsim, 30, TractionBound::Elliptic, Flexibilities::Blended),
    rolling(TangentialModel::Fastsim, 20, TractionBound::Parabolic, Flexibilities::Three),
    rolling(TangentialModel::Fastrip, 20, TractionBound::Elliptic, Flexibilities::Blended),
    rolling(TangentialModel::Tables, 4, TractionBound::Elliptic, Flexibilities::Blended),
    rolling(TangentialModel::FastsimCorrected, 20, TractionBound::Elliptic, Flexibilities::Blended),
    MARCHES,
];

/// That of the fast pair, and that of the element as it starts.
const FASTSIM: Rolling =
    rolling(TangentialModel::Fastsim, 20, TractionBound::Elliptic, Flexibilities::Blended);
pub const MARCHES: Rolling =
    rolling(TangentialModel::Marches, 20, TractionBound::Elliptic, Flexibilities::Blended);

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
            TangentialModel::Marches => "marches".into(),
            _ => "another model".into(),
        }
    }
}

impl Choice {
    /// What is compared: the fast normal model with all of the tangential ones, the default one of
    /// these with all normal models, both changed, and boundary elements for both.
    pub fn all() -> Vec<Self> {
        let fast = normal(NormalModel::PiotrowskiKik, 12);
        let default = normal(NormalModel::Strips, DEFAULT_NODES);
        let hertz = normal(NormalModel::Hertz, 12);
        let of_fast = ROLLING.map(|rolling| Self { normal: fast, rolling });
        let others = NORMAL.into_iter().filter(|&other| other != fast);
        let marched = others.map(|normal| Self { normal, rolling: MARCHES });
        let of_default = ROLLING.into_iter().filter(|&other| other != MARCHES);
        let of_default = of_default.map(|rolling| Self { normal: default, rolling });
        let hertz = [Self { normal: hertz, rolling: FASTSIM }];
        let all = hertz.into_iter().chain(of_fast).chain(marched).chain(of_default);
        all.chain(BOUNDARY.map(boundary)).collect()
    }

    /// Whether the element starts with it.
    pub fn is_default(self) -> bool {
        self.normal == normal(NormalModel::Strips, DEFAULT_NODES) && self.rolling == MARCHES
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
    pub fn parameters(self, vertical_mode: VerticalMode) -> Parameters {
        let Self { normal, rolling } = self;
        Parameters {
            vertical_mode,
            normal_model: normal.model,
            strips: normal.count,
            normal_elements: [normal.count; 2],
            tangential_model: rolling.model,
            elements_along: rolling.count,
            bound: rolling.bound,
            flexibilities: rolling.flexibilities,
            damping: 0.0,
            // One plane for each contact, as the reference of the figures has; the default takes 3 %
            // longer with its own.
            creepage_model: CreepageModel::Flat,
            ..Parameters::default()
        }
    }
}
