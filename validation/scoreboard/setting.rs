//! What is compared: the default models, and the others that users choose between.

use wheelrail::element::Parameters;
use wheelrail::element::parameters::{CreepageModel, NormalModel, TangentialModel};
use wheelrail::planar::PlanarCase;

/// A choice of models.
#[derive(Clone, Copy)]
pub struct Setting {
    /// As the page names it.
    pub name: &'static str,
    change: fn(&mut Parameters),
    /// Whether it takes milliseconds.
    pub is_slow: bool,
}

/// Strips and elements of the most accurate models that work in real time.
const FINE: usize = 40;
/// Boundary elements along and across.
const ELEMENTS: usize = 40;

/// All of them.
pub const SETTINGS: [Setting; 5] = [
    Setting { name: "by default", change: |_| (), is_slow: false },
    Setting {
        name: "`strips` 15 + `fastsim_corrected`",
        change: |p| p.tangential_model = TangentialModel::FastsimCorrected,
        is_slow: false,
    },
    Setting {
        name: "`strips` 40 + `tables`",
        change: |p| {
            p.strips = FINE;
            p.tangential_model = TangentialModel::Tables;
        },
        is_slow: false,
    },
    Setting {
        name: "`piotrowski_kik` + `fastsim`, flat",
        change: |p| {
            p.normal_model = NormalModel::PiotrowskiKik;
            p.strips = 12;
            p.tangential_model = TangentialModel::Fastsim;
            p.creepage_model = CreepageModel::Flat;
        },
        is_slow: false,
    },
    Setting { name: "`boundary_element` 40 x 40", change: boundary, is_slow: true },
];

fn boundary(parameters: &mut Parameters) {
    parameters.normal_model = NormalModel::BoundaryElement;
    parameters.tangential_model = TangentialModel::BoundaryElement;
    parameters.normal_elements = [ELEMENTS; 2];
}

impl Setting {
    /// Parameters of a wheel on a rail, without damping, so that loads are those of the
    /// penetration.
    pub fn parameters(&self) -> Parameters {
        let mut parameters = Parameters { damping: 0.0, ..Parameters::default() };
        (self.change)(&mut parameters);
        parameters
    }

    /// A planar case by these models.
    pub fn of_case<'a>(&self, case: &PlanarCase<'a>) -> PlanarCase<'a> {
        let parameters = self.parameters();
        PlanarCase {
            normal_model: parameters.normal_model,
            strips: parameters.strips,
            elements: parameters.normal_elements,
            tangential_model: parameters.tangential_model,
            elements_along: parameters.elements_along,
            bound: parameters.bound,
            flexibilities: parameters.flexibilities,
            ..*case
        }
    }
}

/// The reference itself, where the project is its own.
pub fn reference() -> Setting {
    SETTINGS[SETTINGS.len() - 1]
}
