//! The contact models of an element and their scratch memory.

use super::given_tractions::GivenTractions;
use super::laid_zones::RollingZones;
use crate::element::contact_history::Remembering;
use crate::element::output::Patch;
use crate::element::parameters::{CreepageModel, Parameters, TangentialHistory, VerticalMode};
use crate::element::wear_sums::WearSums;
use crate::geometry::contacts::contact_search::MAX_CONTACTS;
use crate::geometry::rail::varying_rail::MovingOutline;
use crate::material::MaterialPair;
use crate::math::fixed_vec::FixedVec;
use crate::math::quadrature::GaussLegendre;
use crate::math::real::Real;
use crate::normal::least_energy::{MIN_STRIPS, StripFollower, StripSolver};
use crate::normal::uneven::UnevenStrips;
use crate::normal::{Descent, NormalModel, ShapeFit, Strips, strips_of_rule};
use crate::tangential::{Settings, Tangential, TangentialModel};

/// Most loaded zones of one contact frame, and of a rail where it has no contact frames: as many as
/// it may have overlaps.
const MAX_ZONES: usize = 8;
const MAX_RAIL_ZONES: usize = 32;
/// Elements along a zone where its creep force is only guessed.
const GUESSED_ALONG: usize = 8;

/// The chosen models and their scratch memory, shared by the rails of an element; with derivatives
/// where the numbers have them.
#[derive(Clone, Debug)]
pub struct Models<T = f64> {
    /// Normal contact model.
    pub normal: NormalModel,
    /// Virtual over true penetration [-].
    pub virtual_penetration: f64,
    /// Ratio of length to width that a corrected contact area gets.
    pub shape_fit: ShapeFit,
    /// Contact damping at the reference stiffness [N s/m].
    pub damping: f64,
    /// Tangential contact model with its settings.
    pub tangential: Tangential,
    /// How creepage varies over a zone.
    pub creepage: CreepageModel,
    /// The zones under way as they roll.
    pub rolling: RollingZones<T>,
    /// Floor of the speed that creepages refer to [m/s].
    pub minimum_speed: f64,
    /// Elastic constants of wheel and rails.
    pub material: MaterialPair,
    /// Boundary elements along and across a contact.
    pub elements: [usize; 2],
    /// The vertical force that normal loads are to have, where that is given and not the height.
    pub descent: Option<Descent>,
    /// Scratch memory of contacts on uneven rails or wheels, if there are any.
    pub uneven: Option<UnevenStrips>,
    /// Quadrature rule across a zone.
    pub rule: GaussLegendre,
    /// The same where a force is only guessed, and then the tangential model if it is another one:
    /// FASTSIM with few elements, which costs no more than any with a bound.
    pub coarse: GaussLegendre,
    pub guessed: Option<Tangential>,
    /// Loaded zones of the contact under way.
    pub strips: Strips<T>,
    /// Solver of the strip model, where that is the normal model, and the zones of a whole rail.
    pub strip_solver: Option<StripSolver>,
    pub rail_strips: Strips<T>,
    /// Memory for derivatives of the zones of a whole rail.
    pub strip_follower: Option<StripFollower<T>>,
    /// The outline of a rail that varies along the track, as it moves, where numbers have
    /// derivatives.
    pub outline: Option<Box<MovingOutline<T>>>,
    /// Tractions of the zone under way, where they were found together with those of other zones.
    pub given: Option<GivenTractions<T>>,
    /// Greatest angle between normals of the elements that carry pressure on one rail, where
    /// boundary elements were solved on it [rad].
    pub turn_of_normals: f64,
    /// Whether pressure and tractions on a rail were found as those of bodies of like materials, where
    /// they should have been found together.
    pub is_uncoupled: bool,
    /// All loaded zones of the evaluation under way.
    pub patches: FixedVec<Patch<T>>,
    /// Yield stress of the rail in shear, for the surface fatigue index [Pa].
    pub shear_yield: f64,
    /// Wear, if there is any.
    pub wear: Option<Box<WearSums>>,
    /// What contacts remember, if tractions follow from steps before.
    pub memory: Option<Box<Remembering>>,
}

impl Models {
    /// Largest distance left at a node of the strips of the rail under way, or overlap left, over
    /// its greatest overlap; 0 where strips were not solved [-].
    pub fn normal_residual(&self) -> f64 {
        self.strip_solver.as_ref().map_or(0.0, StripSolver::residual)
    }

    /// Lets the tangential model by which forces are guessed change places with the chosen one.
    pub fn swap_guessed(&mut self) {
        if let Some(guessed) = &mut self.guessed {
            std::mem::swap(&mut self.tangential, guessed);
        }
    }

    /// Whether pressure and tractions act on each other, the bodies being of unlike materials, and the
    /// models can tell.
    pub fn is_coupled(&self) -> bool {
        self.normal == NormalModel::BoundaryElement
            && self.tangential.model() == TangentialModel::BoundaryElement
            && self.uneven.is_none()
            && self.material.is_unlike()
    }

    /// The same models with memory for other numbers; without what only plain ones can be: a
    /// solver, uneven bodies, wear. `rows` is how many an outline of a rail that varies along the
    /// track has, if there is one.
    pub fn in_other_numbers<T: Real>(&self, rows: Option<usize>) -> Models<T> {
        let strips =
            |like: &Strips| Strips::with_capacity(like.zones.capacity(), like.y.capacity());
        Models {
            normal: self.normal,
            virtual_penetration: self.virtual_penetration,
            shape_fit: self.shape_fit,
            damping: self.damping,
            tangential: self.tangential.clone(),
            creepage: self.creepage,
            rolling: {
                let [zones, strips] = self.rolling.capacity();
                RollingZones::with_capacity(zones, strips)
            },
            minimum_speed: self.minimum_speed,
            material: self.material,
            elements: self.elements,
            descent: None,
            uneven: None,
            rule: self.rule.clone(),
            coarse: self.coarse.clone(),
            guessed: None,
            strips: strips(&self.strips),
            strip_solver: None,
            rail_strips: strips(&self.rail_strips),
            strip_follower: self.strip_solver.as_ref().map(StripFollower::new),
            outline: rows.map(|rows| Box::new(MovingOutline::new(rows))),
            given: None,
            turn_of_normals: 0.0,
            is_uncoupled: false,
            patches: FixedVec::new(self.patches.capacity()),
            shear_yield: self.shear_yield,
            wear: None,
            memory: None,
        }
    }

    /// The models that checked `parameters` ask for.
    pub fn new(parameters: &Parameters) -> Self {
        let [wheel, rail] = parameters.materials();
        let is_strips = parameters.normal_model == NormalModel::Strips;
        let is_boundary = parameters.normal_model == NormalModel::BoundaryElement;
        let of_rail = is_strips || is_boundary && !parameters.is_uneven();
        let (frames, zones) = match (of_rail, parameters.is_uneven()) {
            (true, _) => (1, MAX_RAIL_ZONES),
            // Patches of uneven bodies split along the track too.
            (false, true) => (MAX_CONTACTS, 2 * MAX_ZONES),
            (false, false) => (MAX_CONTACTS, MAX_ZONES),
        };
        let of_rule = strips_of_rule(parameters.strips);
        // Zones roll together, and strips and stretches of uneven bodies may all be in one zone.
        let most_strips =
            if is_strips { StripSolver::most_nodes(parameters.strips) } else { zones * of_rule };
        let settings = Settings {
            flexibilities: parameters.flexibilities,
            bound: parameters.bound,
            elements_along: parameters.elements_along,
            elements: parameters.normal_elements,
            strips: most_strips,
        };
        let rolling = |model, settings| {
            Tangential::new(model, settings)
                .with_laws([parameters.friction_law, parameters.gauge_face_law])
                .with_flash_temperature(parameters.flash_temperature)
        };
        let few =
            Settings { elements_along: parameters.elements_along.min(GUESSED_ALONG), ..settings };
        let is_itself_guessed =
            matches!(parameters.tangential_model, TangentialModel::None | TangentialModel::Linear);
        Self {
            normal: parameters.normal_model,
            virtual_penetration: parameters.virtual_penetration,
            shape_fit: parameters.shape_fit,
            damping: match parameters.vertical_mode {
                VerticalMode::Penetration => parameters.damping,
                // A given load is that of a wheel at rest on its rails.
                VerticalMode::Load => 0.0,
            },
            tangential: rolling(parameters.tangential_model, &settings),
            creepage: parameters.creepage_model,
            rolling: RollingZones::with_capacity(zones, most_strips),
            minimum_speed: parameters.minimum_speed,
            material: MaterialPair::new(wheel, rail),
            elements: parameters.normal_elements,
            descent: None,
            rule: GaussLegendre::new(of_rule),
            coarse: GaussLegendre::new(MIN_STRIPS),
            guessed: (!is_itself_guessed).then(|| rolling(TangentialModel::Fastsim, &few)),
            uneven: parameters.is_uneven().then(|| UnevenStrips::new(of_rule)),
            strips: Strips::with_capacity(zones, most_strips),
            strip_solver: is_strips.then(|| StripSolver::new(parameters.strips)),
            rail_strips: if of_rail {
                Strips::with_capacity(zones, most_strips)
            } else {
                Strips::with_capacity(0, 0)
            },
            strip_follower: None,
            outline: None,
            given: None,
            turn_of_normals: 0.0,
            is_uncoupled: false,
            patches: FixedVec::new(parameters.rails.len() * frames * zones),
            shear_yield: parameters.shear_yield,
            wear: None,
            memory: (parameters.tangential_history == TangentialHistory::Transient)
                .then(Box::default),
        }
    }
}
