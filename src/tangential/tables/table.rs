//! The table of creep forces in memory.

use super::bound::Bound;
use super::ellipse_force::{EllipseForce, ForceSlopes};
use super::interpolated::{Interpolated, LimitSlopes, Limits, Query};
use super::nodes::Nodes;
use super::scales::Scales;
use super::sliding;
use super::splines::Splines;
use super::tabulated::ForceTable;
use crate::math::until_unload::UntilUnload;

/// The committed table.
const FILE: &[u8] = include_bytes!("creep_forces.table");

/// The table in memory.
#[derive(Clone, Debug)]
pub struct CreepForceTable {
    splines: Splines,
}

impl CreepForceTable {
    /// The committed table, laid out on first use in the process; takes some milliseconds then.
    ///
    /// # Panics
    /// If the file in the library has another size than the code, which a test excludes.
    pub fn shared() -> &'static Self {
        static TABLE: UntilUnload<CreepForceTable> = UntilUnload::new();
        TABLE.get_or_init(|| {
            let nodes = Nodes::from_bytes(FILE).expect("the table in the library is whole");
            Self::new(&nodes)
        })
    }

    /// A table of these numbers.
    pub fn new(nodes: &Nodes) -> Self {
        Self { splines: Splines::new(nodes) }
    }

    /// The numbers of the committed table, with their error estimates.
    pub fn committed_nodes() -> Option<Nodes> {
        Nodes::from_bytes(FILE)
    }

    /// Creep force of an ellipse with these `scales` for finite creepages `v`.
    pub fn force(&self, scales: &Scales, v: [f64; 3]) -> EllipseForce {
        ForceTable::force(self, scales, v)
    }

    /// The same with its derivatives.
    pub fn force_and_slopes(&self, scales: &Scales, v: [f64; 3]) -> (EllipseForce, ForceSlopes) {
        ForceTable::force_and_slopes(self, scales, v)
    }
}

impl ForceTable for CreepForceTable {
    fn force(&self, scales: &Scales, v: [f64; 3]) -> EllipseForce {
        let Some(query) = Query::of(scales, v) else { return EllipseForce::default() };
        let sliding = sliding::closed_form(query.log_ratio[0], query.v);
        let limits = Limits { linear: scales.linear(query.v), sliding };
        let Interpolated { found, left } = self.splines.between(&query, &limits);
        EllipseForce { force: Bound::of(&found.force, left).applied(found.force), ..found }
    }

    fn force_and_slopes(&self, scales: &Scales, v: [f64; 3]) -> (EllipseForce, ForceSlopes) {
        let Some(query) = Query::of(scales, v) else {
            let [x, y, moment] = scales.linear_slopes([0.0; 3]);
            return (EllipseForce::default(), [x, y, moment, [0.0; 4]]);
        };
        let (sliding, sliding_slopes) =
            sliding::closed_form_and_slopes(query.log_ratio[0], query.v);
        let limits = Limits { linear: scales.linear(query.v), sliding };
        let slopes = LimitSlopes { linear: scales.linear_slopes(query.v), sliding: sliding_slopes };
        let (Interpolated { found, left }, slopes, left_slopes) =
            self.splines.between_with_slopes(scales, &query, &limits, &slopes);
        let bound = Bound::of(&found.force, left);
        let slopes = bound.applied_to_slopes(&found.force, slopes, left_slopes);
        (EllipseForce { force: bound.applied(found.force), ..found }, slopes)
    }
}
