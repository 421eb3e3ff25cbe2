//! Forces by a march through the strips of a zone, and of its lobes where it has a waist.

use super::equivalent_ellipse::LoadedPart;
use super::flexibility::ZoneFlexibility;
use super::linear;
use super::rigid_slip::RigidSlip;
use super::waist::{LobeSlip, Side, Waist};
use super::{
    CreepNumber, Creepage, Flexibilities, Rolling, RollingState, StripForce, Tangential,
    TangentialModel,
};
use crate::material::MaterialPair;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// What strips are marched with: the whole zone, or one of its lobes.
#[derive(Clone, Copy, Debug)]
pub(super) struct MarchedPart<T> {
    /// Share in the force, and of a lobe which one.
    share: T,
    lobe: Option<(Waist<T>, Side)>,
    three: ZoneFlexibility<T>,
    /// The flexibilities that the march has.
    pub blended: ZoneFlexibility<T>,
    /// Creepage that the flexibilities L1 and L2 belong to.
    pub mean: Creepage<T>,
}

impl<T: Real> MarchedPart<T> {
    /// Share of this march in the force of a strip at `y`.
    #[inline]
    pub fn weight(&self, y: T) -> T {
        self.lobe.map_or(self.share, |(waist, side)| self.share * waist.member(side, y))
    }
}

impl Tangential {
    /// The marches of which the force of `zone` is made up: one, or those of the whole and of its lobes.
    pub(super) fn marched_parts<T: CreepNumber>(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        material: &MaterialPair<T>,
        slip: &impl RigidSlip<T>,
        state: &RollingState<T>,
    ) -> [Option<MarchedPart<T>>; 3] {
        let limit = state.friction * zone.load * state.load_factor;
        let is_blended =
            self.model != TangentialModel::Linear && self.flexibilities == Flexibilities::Blended;
        let part = |share: T, lobe, three: ZoneFlexibility<T>, mean: Creepage<T>, of_load: T| {
            let blended = if is_blended { three.blended(&mean, limit * of_load) } else { three };
            MarchedPart { share, lobe, three, blended, mean }
        };
        let waist = Waist::of(zone, strips);
        let lobes = waist.map_or(T::from(0.0), |waist| waist.share);
        let whole = (lobes < 1.0).then(|| {
            let three = ZoneFlexibility::new(zone, strips, material);
            part(-lobes + 1.0, None, three, slip.mean(), T::from(1.0))
        });
        let Some(waist) = waist else { return [whole, None, None] };
        let [left, right] = waist.lobes(zone, strips, slip);
        let lobe = |side, loaded: Option<LoadedPart<T>>| {
            let loaded = loaded?;
            let member = |y| waist.member(side, y);
            let three = ZoneFlexibility::of_part(zone, strips, material, member)?;
            Some(part(lobes, Some((waist, side)), three, loaded.creepage, loaded.share))
        };
        [whole, lobe(Side::Left, left), lobe(Side::Right, right)]
    }

    /// Hands the force of each strip of `zone` to `each`, which adds them up: a strip may come twice.
    #[allow(clippy::too_many_arguments)] // what a zone is, how it moves, and where its forces go
    pub(super) fn march<T: CreepNumber>(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        parts: &[Option<MarchedPart<T>>; 3],
        material: &MaterialPair<T>,
        slip: &impl RigidSlip<T>,
        friction: T,
        rolling: Rolling,
        mut each: impl FnMut(usize, StripForce<T>),
    ) {
        for part in parts.iter().flatten() {
            let add = |j: usize, force: StripForce<T>| {
                let weight = part.weight(strips.y[j]);
                if weight > 0.0 {
                    each(j, force.times(weight));
                }
            };
            if part.lobe.is_none() {
                self.march_part(zone, strips, part, material, slip, friction, rolling, add);
            } else {
                let slip = LobeSlip { zone: slip, mean: part.mean };
                self.march_part(zone, strips, part, material, &slip, friction, rolling, add);
            }
        }
    }

    #[allow(clippy::too_many_arguments)]
    fn march_part<T: CreepNumber>(
        &self,
        zone: &Zone<T>,
        strips: &Strips<T>,
        part: &MarchedPart<T>,
        material: &MaterialPair<T>,
        slip: &impl RigidSlip<T>,
        friction: T,
        rolling: Rolling,
        each: impl FnMut(usize, StripForce<T>),
    ) {
        let MarchedPart { three, blended, .. } = part;
        match self.model {
            TangentialModel::None | TangentialModel::Tables => {}
            TangentialModel::Linear => {
                linear::strip_forces(zone, strips, blended, slip, rolling, each);
            }
            TangentialModel::Fastsim
            | TangentialModel::FastsimCorrected
            | TangentialModel::BoundaryElement => {
                let march = &self.fastsim;
                march.strip_forces(zone, strips, blended, slip, rolling, friction, each);
            }
            TangentialModel::Fastrip => self.fastrip.strip_forces(
                zone,
                strips,
                three,
                blended,
                slip,
                rolling,
                friction,
                material.poisson_ratio,
                each,
            ),
        }
    }
}
