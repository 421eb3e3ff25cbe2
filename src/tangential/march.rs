//! Forces by a march through the strips of a zone, and of its lobes where it has a neck.

use super::equivalent_ellipse::LoadedPart;
use super::flexibility::ZoneFlexibility;
use super::neck::{LobeSlip, Lobes, Neck, Side};
use super::rigid_slip::RigidSlip;
use super::{
    CreepNumber, Creepage, Flexibilities, LoadedZone, Rolling, StripForce, Tangential,
    TangentialModel, linear,
};
use crate::math::real::Real;

/// What strips are marched with: the whole zone, or one of its lobes.
#[derive(Clone, Copy, Debug)]
pub(super) struct MarchedPart<T> {
    /// Share in the force, and of a lobe which one.
    share: T,
    lobe: Option<(Neck<T>, Side)>,
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
        self.lobe.map_or(self.share, |(neck, side)| self.share * neck.member(side, y))
    }
}

impl Tangential {
    /// The marches of which the force of `loaded`, whose friction limit is `limit` [N], is made up:
    /// one, or those of the whole and of its lobes.
    pub(super) fn marched_parts<T: CreepNumber>(
        &self,
        loaded: &LoadedZone<'_, impl RigidSlip<T>, T>,
        lobes: Option<&Lobes<T>>,
        limit: T,
    ) -> [Option<MarchedPart<T>>; 3] {
        let &LoadedZone { zone, strips, material, slip, .. } = loaded;
        let is_blended =
            self.model != TangentialModel::Linear && self.flexibilities == Flexibilities::Blended;
        let part = |share: T, lobe, three: ZoneFlexibility<T>, mean: Creepage<T>, of_limit: T| {
            let blended = if is_blended { three.blended(&mean, limit * of_limit) } else { three };
            MarchedPart { share, lobe, three, blended, mean }
        };
        let share = lobes.map_or(T::from(0.0), |lobes| lobes.neck.share);
        let whole = if share < 1.0 {
            ZoneFlexibility::new(zone, strips, material, |_| T::from(1.0))
                .map(|three| part(-share + 1.0, None, three, slip.mean(), T::from(1.0)))
        } else {
            None
        };
        let Some(&Lobes { neck, parts: [left, right] }) = lobes else {
            return [whole, None, None];
        };
        let lobe = |side, carried: Option<LoadedPart<T>>| {
            // What has no friction holds nothing.
            let carried = carried.filter(|carried| carried.friction > 0.0)?;
            let member = |y| neck.member(side, y);
            let three = ZoneFlexibility::new(zone, strips, material, member)?;
            let of_limit = carried.share * carried.friction;
            Some(part(share, Some((neck, side)), three, carried.creepage, of_limit))
        };
        [whole, lobe(Side::Left, left), lobe(Side::Right, right)]
    }

    /// Hands the number of each of the `parts` and the force of each strip of `loaded` in it to
    /// `each`, which adds them up: a strip may come twice.
    pub(super) fn march<T: CreepNumber>(
        &self,
        loaded: &LoadedZone<'_, impl RigidSlip<T>, T>,
        rolling: Rolling,
        parts: &[Option<MarchedPart<T>>; 3],
        mut each: impl FnMut(usize, usize, StripForce<T>),
    ) {
        let strips = loaded.strips;
        for (n, part) in parts.iter().enumerate() {
            let Some(part) = part else { continue };
            let add = |j: usize, force: StripForce<T>| {
                let weight = part.weight(strips.y[j]);
                if weight > 0.0 {
                    each(n, j, force.times(weight));
                }
            };
            if part.lobe.is_none() {
                self.march_part(loaded, rolling, part, add);
            } else {
                let slip = LobeSlip { zone: loaded.slip, mean: part.mean };
                self.march_part(&loaded.with_slip(&slip), rolling, part, add);
            }
        }
    }

    fn march_part<T: CreepNumber>(
        &self,
        loaded: &LoadedZone<'_, impl RigidSlip<T>, T>,
        rolling: Rolling,
        part: &MarchedPart<T>,
        each: impl FnMut(usize, StripForce<T>),
    ) {
        let MarchedPart { three, blended, .. } = part;
        match self.model {
            TangentialModel::None | TangentialModel::Tables => {}
            TangentialModel::Linear => linear::strip_forces(loaded, rolling, blended, each),
            TangentialModel::Fastsim
            | TangentialModel::FastsimCorrected
            | TangentialModel::BoundaryElement
            | TangentialModel::Strips => {
                self.fastsim.strip_forces(loaded, rolling, blended, each);
            }
            TangentialModel::Fastrip => {
                self.fastrip.strip_forces(loaded, rolling, three, blended, each);
            }
        }
    }
}
