//! The way down at which the nodes of a problem carry a given vertical force.

use super::StripSolver;
use crate::normal::{Descent, Slope};

impl StripSolver {
    /// Goes down until the loads have the force that `descent` asks for, as closely as makes sense;
    /// false where Newton's method does not converge.
    pub(super) fn descend(&mut self, descent: &mut Descent, contact_modulus: f64) -> bool {
        let Self { newton, lattice, cosines, .. } = self;
        cosines.clear();
        cosines.extend(lattice.nodes.iter().map(|node| descent.cosine(node.tangent)));
        let unit = lattice.scales.load * contact_modulus;
        let mut is_settled = true;
        descent.run(|_, step| {
            is_settled &= step == 0.0 || newton.lower(cosines, step);
            let [reached, stiffness] = newton.carried(cosines);
            (reached * unit, Slope::Known(stiffness * unit))
        });
        is_settled
    }
}
