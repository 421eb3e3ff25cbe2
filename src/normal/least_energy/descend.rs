//! The way down at which the nodes of a problem carry a given vertical force.

use super::StripSolver;
use super::line::OverlapLine;
use super::newton::Newton;
use crate::geometry::contacts::separation::Probe;
use crate::normal::{Descent, Pose, Slope};

impl StripSolver {
    /// Goes down until the ellipses in the places of the overlaps of `line` have about the force that
    /// `descent` asks for; overlaps are -f at the `probes`, the contact modulus in Pa.
    pub fn guess(
        &mut self,
        line: &mut impl OverlapLine,
        probes: &[Probe],
        contact_modulus: f64,
        descent: &mut Descent,
    ) {
        let Self { overlaps, lattice, .. } = self;
        overlaps.fill(line, probes, 0.0);
        lattice.take(line, overlaps);
        descent.run(|descent, step| {
            let [force, stiffness] = lattice.lower(line, descent, step);
            (force * contact_modulus, Slope::Known(stiffness * contact_modulus))
        });
    }

    /// Goes down until the loads have the force that `descent` asks for, as closely as makes sense,
    /// or from a new pose looks down to there; false where Newton's method does not converge.
    pub(super) fn descend(&mut self, descent: &mut Descent, contact_modulus: f64) -> bool {
        let Self { newton, lattice, cosines, .. } = self;
        cosines.clear();
        cosines.extend(lattice.nodes.iter().map(|node| descent.cosine(node.tangent)));
        let unit = lattice.scales.load * contact_modulus;
        let carried = |newton: &mut Newton| {
            let [reached, stiffness] = newton.carried(cosines);
            [reached * unit, stiffness * unit]
        };
        if !descent.pose.is_same() {
            newton.keep_pose();
        }
        if descent.pose == Pose::New {
            descent.look_down(carried(newton), |way| newton.look_down(cosines, way) * unit);
            return true;
        }
        let mut is_settled = true;
        descent.run(|_, step| {
            is_settled &= step == 0.0 || newton.lower(cosines, step);
            let [reached, stiffness] = carried(newton);
            (reached, Slope::Known(stiffness))
        });
        is_settled
    }
}
