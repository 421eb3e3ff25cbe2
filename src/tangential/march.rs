//! Forces by integration along the strips of a zone, and of its lobes where it has a neck.

use super::boundary_element::LoadedElements;
use super::convergence::Convergence;
use super::creep_number::CreepNumber;
use super::equivalent_ellipse::LoadedPart;
use super::fastsim::Fastsim;
use super::field::ContactField;
use super::flexibility::ZoneFlexibility;
use super::lobes::Lobes;
use super::neck::{Extent, Side};
use super::rule::Rule;
use super::zone_model::{RollingZone, ZoneModel};
use super::{Creepage, Flexibilities, LoadedZone, Rolling, StripForce};
use crate::math::real::Real;

/// The model that marches through the strips of a zone by the rule `R`.
#[derive(Clone, Debug)]
pub struct March<R> {
    /// The rule.
    pub rule: R,
    /// How the flexibilities enter.
    pub flexibilities: Flexibilities,
}

/// What strips are marched with: the whole zone, or one of its lobes.
#[derive(Clone, Copy, Debug)]
struct Part<T> {
    /// Share in the force.
    share: T,
    extent: Extent<T>,
    three: ZoneFlexibility<T>,
    /// The flexibilities that the march has.
    blended: ZoneFlexibility<T>,
    /// Creepage that the flexibilities L1 and L2 belong to.
    mean: Creepage<T>,
}

impl<T: Real> Part<T> {
    /// Share of this march in the force of a strip at `y`.
    #[inline]
    fn weight(&self, y: T) -> T {
        self.share * self.extent.member(y)
    }

    /// What of `loaded` slips as it does here.
    fn of<'a>(&self, loaded: &LoadedZone<'a, T>) -> LoadedZone<'a, T> {
        match self.extent {
            Extent::Whole => *loaded,
            Extent::Lobe(..) => LoadedZone { slip: loaded.slip.of_part(self.mean), ..*loaded },
        }
    }
}

impl<R> March<R> {
    /// Hands the number of each part of `zone` (the whole, the left and the right of its `lobes`)
    /// and the force of each strip in it to `each`, which adds them up.
    pub(super) fn part_forces<T: CreepNumber>(
        &self,
        zone: &RollingZone<'_, T>,
        lobes: Option<&Lobes<T>>,
        mut each: impl FnMut(usize, usize, StripForce<T>),
    ) where
        R: Rule<T>,
    {
        let parts = self.parts(zone, lobes);
        for (rolling, share) in zone.directions() {
            self.march(zone, rolling, share, &parts, &mut each);
        }
    }

    /// Hands the force of each strip of `zone` to `each` as it rolls in one direction, which has
    /// `share` in the force: where another model has no solution.
    pub(super) fn in_direction<T: CreepNumber>(
        &self,
        zone: &RollingZone<'_, T>,
        lobes: Option<&Lobes<T>>,
        (rolling, share): (Rolling, T),
        each: &mut dyn FnMut(usize, StripForce<T>),
    ) where
        R: Rule<T>,
    {
        let parts = self.parts(zone, lobes);
        self.march(zone, rolling, share, &parts, |_, j, force| each(j, force));
    }

    /// The marches of which the force of `zone` is made up: one, or those of the whole and of its
    /// lobes.
    fn parts<T: CreepNumber>(
        &self,
        &RollingZone { ref loaded, limit, .. }: &RollingZone<'_, T>,
        lobes: Option<&Lobes<T>>,
    ) -> [Option<Part<T>>; 3] {
        let &LoadedZone { zone, strips, material, slip, .. } = loaded;
        let is_blended = self.flexibilities == Flexibilities::Blended;
        let part = |share: T, extent: Extent<T>, mean: Creepage<T>, of_limit: T| {
            let three = ZoneFlexibility::new(zone, strips, material, &extent)?;
            let blended = if is_blended { three.blended(&mean, limit * of_limit) } else { three };
            Some(Part { share, extent, three, blended, mean })
        };
        let share = lobes.map_or(T::from(0.0), |lobes| lobes.neck.share);
        let whole = if share < 1.0 {
            part(-share + 1.0, Extent::Whole, slip.mean(), T::from(1.0))
        } else {
            None
        };
        let Some(&Lobes { neck, parts: [left, right] }) = lobes else {
            return [whole, None, None];
        };
        let lobe = |side, carried: Option<LoadedPart<T>>| {
            // What has no friction holds nothing.
            let carried = carried.filter(|carried| carried.friction > 0.0)?;
            let of_limit = carried.share * carried.friction;
            part(share, Extent::Lobe(neck, side), carried.creepage, of_limit)
        };
        [whole, lobe(Side::Left, left), lobe(Side::Right, right)]
    }

    fn march<T: CreepNumber>(
        &self,
        RollingZone { loaded, state, .. }: &RollingZone<'_, T>,
        rolling: Rolling,
        share: T,
        parts: &[Option<Part<T>>; 3],
        mut each: impl FnMut(usize, usize, StripForce<T>),
    ) where
        R: Rule<T>,
    {
        // Damping that takes load away takes creep force away, so that a lost contact has none.
        // Where friction bounds the force its limit does so.
        let share = if R::IS_BOUNDED { share } else { share * state.load_factor.at_most(1.0) };
        let strips = loaded.strips;
        for (n, part) in parts.iter().enumerate() {
            let Some(part) = part else { continue };
            let Part { three, blended, .. } = part;
            let add = |j: usize, force: StripForce<T>| {
                let weight = part.weight(strips.y[j]);
                if weight > 0.0 {
                    each(n, j, force.times(weight).times(share));
                }
            };
            self.rule.strip_forces(&part.of(loaded), rolling, three, blended, add);
        }
    }
}

impl<T: CreepNumber, R: Rule<T>> ZoneModel<T> for March<R> {
    fn strip_forces(
        &self,
        zone: &RollingZone<'_, T>,
        each: &mut dyn FnMut(usize, StripForce<T>),
    ) -> Convergence {
        let lobes = Lobes::of(&zone.loaded);
        self.part_forces(zone, lobes.as_ref(), |_, j, force| each(j, force));
        Convergence::default()
    }
}

impl March<Fastsim> {
    /// Enters the tractions of a zone that rolls forward into `field`, whose grid is that of
    /// `elements`.
    pub(super) fn draw(
        &self,
        rolling: &RollingZone<'_>,
        elements: &LoadedElements,
        field: &mut ContactField,
    ) {
        let loaded = &rolling.loaded;
        let strips = loaded.strips;
        let parts = self.parts(rolling, Lobes::of(loaded).as_ref());
        for (row, strip) in elements.rows_of(loaded.zone) {
            // Of a zone with a neck that description which has more weight in the force.
            let weight = |part: &&Part<f64>| part.weight(strips.y[strip]);
            let heavier = |a: &&Part<f64>, b: &&Part<f64>| weight(a).total_cmp(&weight(b));
            let Some(part) = parts.iter().flatten().max_by(heavier) else { continue };
            let marched = self.rule.tractions(&part.of(loaded), strip, &part.blended);
            for i in 0..field.grid.along {
                let t = (strips.x[strip] - field.grid.x(i)) / strips.half_length[strip];
                let step = 0.5 * (1.0 + t) * marched.len() as f64;
                let (traction, slips) = marched[(step.max(0.0) as usize).min(marched.len() - 1)];
                field.enter(row, i, traction, slips);
            }
        }
    }
}
