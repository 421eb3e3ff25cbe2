//! The generated table and field access; `build/code.rs` writes the included text.

use super::values::{Described, ValuesOf};
use super::variable::{Causality, Enumeration, Item, Kind, Unit, Value, Variable};
use crate::element::Element;
use crate::element::output::REPORTED_PATCHES;
use crate::element::parameters::{
    CreepageModel, FallingLaw, FlatShape, Flexibilities, FoundationModel, FrictionDistribution,
    Motion, NormalModel, Placement, RAILS, ShapeFit, Side, TangentialHistory, TangentialModel,
    TractionBound, VerticalMode, WearDistribution, WearModel,
};
use crate::wheelset::Wheelset;

/// A field that is an integer or an enumeration outside.
trait IntegerField {
    fn get(&self) -> i32;
    /// The value was checked against range or items before.
    fn set(&mut self, value: i32);
}

impl IntegerField for i32 {
    fn get(&self) -> i32 {
        *self
    }

    fn set(&mut self, value: i32) {
        *self = value;
    }
}

impl IntegerField for usize {
    fn get(&self) -> i32 {
        *self as i32
    }

    fn set(&mut self, value: i32) {
        *self = value as usize;
    }
}

include!(concat!(env!("OUT_DIR"), "/variables.rs"));
