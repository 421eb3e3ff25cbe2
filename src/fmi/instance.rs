//! A wheel or a wheelset with its variables and its place in the life cycle: what it holds. What is
//! done with it stands in the files that import this one.

use std::ffi::CString;
use std::path::PathBuf;

use super::adjoint_scratch::AdjointScratch;
use super::coupling::LastStep;
use super::differences::DerivativeScratch;
use super::extrapolation::Extrapolation;
use super::held::Held;
use super::interface::Interface;
use super::life_cycle::{Experiment, Purpose, State};
use super::slots::Slots;
use super::snapshot::Snapshot;
use super::types::ValueReference;
use crate::element::Remark;
use crate::variables::{Described, ValuesOf};

/// The kinds of remarks that were told of each element and are not over yet.
pub(super) type Told = [[bool; Remark::KINDS]; MAX_ELEMENTS];

/// An input without effect.
#[derive(Clone, Copy, Debug)]
pub(super) struct Idle {
    /// Its value reference.
    pub reference: usize,
    /// The value it starts from.
    pub start: f64,
    /// What is said of it, and the side of a wheelset.
    pub remark: Remark,
    pub side: &'static str,
}

/// Most elements of a unit: the wheels of a wheelset.
const MAX_ELEMENTS: usize = 2;

/// An instance of one unit.
#[derive(Debug)]
pub struct Instance<S: Described> {
    /// Through which it was made.
    pub interface: Interface,
    /// What it is made for.
    pub purpose: Purpose,
    /// Place in the life cycle.
    pub state: State,
    /// Where it starts, and again after a reset.
    starts: Box<ValuesOf<S>>,
    pub(super) values: ValuesOf<S>,
    pub(super) profile_folders: Vec<PathBuf>,
    pub(super) element: Option<S>,
    /// Parameters were set since the element was made from them.
    pub(super) parameters_changed: bool,
    /// The input for which the nominal height was found.
    pub(super) nominal_input: Option<S::Input>,
    /// Inputs were set, or the element made, since the outputs were evaluated.
    pub(super) outputs_stale: bool,
    pub(super) experiment: Option<Experiment>,
    /// The continuous state of the variant that has one.
    pub(super) dummy_state: Option<f64>,
    pub(super) time: f64,
    /// Time derivatives of the inputs over the next step.
    pub(super) extrapolation: Extrapolation,
    /// The input for which stiffness and damping were found.
    pub(super) slopes_at: Option<S::Input>,
    /// Where the last step began, if energy is monitored.
    pub(super) last_step: Option<LastStep>,
    /// Memory for directional derivatives.
    pub(super) derivatives: Option<Box<DerivativeScratch<S>>>,
    /// The same for adjoint derivatives, once they have been asked for.
    pub(super) backwards: Option<Box<AdjointScratch<S>>>,
    /// Seeds of those by elements.
    pub(super) seeds: Vec<f64>,
    /// Whole numbers of the last event of model exchange.
    pub(super) held: Held,
    /// What the host was told of the outputs evaluated last.
    pub(super) told: Told,
    /// Places of the elements of unknowns and knowns of a derivative through FMI 3.0.
    pub(super) flattened: [Vec<ValueReference>; 2],
    /// Inputs that have no effect with these parameters, with the value they start from: said when
    /// they get another one.
    pub(super) idle: Vec<Idle>,
    /// Texts handed out by the last call that read texts.
    pub(super) handed_out: Vec<CString>,
    /// States handed out and not freed yet.
    pub snapshots: Slots<Snapshot<S>>,
}

impl<S: Described> Instance<S> {
    /// An instance with start values; profiles are looked for in the folders, in order.
    pub fn new(
        interface: Interface,
        purpose: Purpose,
        profile_folders: Vec<PathBuf>,
        starts: Box<ValuesOf<S>>,
        has_state: bool,
    ) -> Self {
        let most_flattened = match interface {
            Interface::V2 => 0,
            Interface::V3 => S::UNIT.variables.len(),
        };
        Self {
            interface,
            purpose,
            state: State::Instantiated,
            values: (*starts).clone(),
            starts,
            profile_folders,
            element: None,
            parameters_changed: true,
            nominal_input: None,
            outputs_stale: true,
            experiment: None,
            dummy_state: has_state.then_some(0.0),
            time: 0.0,
            extrapolation: Extrapolation::new(S::UNIT),
            slopes_at: None,
            last_step: None,
            derivatives: None,
            backwards: None,
            seeds: Vec::new(),
            held: Held::new::<S>(),
            told: Told::default(),
            flattened: [(); 2].map(|()| Vec::with_capacity(most_flattened)),
            idle: Vec::new(),
            handed_out: Vec::new(),
            snapshots: Slots::new(),
        }
    }

    /// Back to what it was after instantiation; states handed out stay good.
    pub fn reset(&mut self) {
        let snapshots = std::mem::replace(&mut self.snapshots, Slots::new());
        let folders = std::mem::take(&mut self.profile_folders);
        let (starts, has_state) = (self.starts.clone(), self.dummy_state.is_some());
        let (interface, purpose) = (self.interface, self.purpose);
        *self = Self { snapshots, ..Self::new(interface, purpose, folders, starts, has_state) };
    }

    /// Whether there is an element of the parameters as they are.
    pub(super) fn is_prepared(&self) -> bool {
        self.element.is_some() && !self.parameters_changed
    }

    /// End of the last step, or start time [s].
    pub fn time(&self) -> f64 {
        self.time
    }
}
