//! The solver: from a loaded zone to the forces of its strips.

use multiversion::multiversion;

use super::equations::{Equations, Strip};
use super::influence::Influence;
use super::layout::{Between, Carrier, Layout};
use super::newton::{Newton, Settled};
use super::points::Points;
use super::sizes::NODES;
use super::span::Span;
use crate::kinematics::creepage::Creepage;
use crate::math::dual::Dual;
use crate::math::real::Real;
use crate::tangential::forces::StripForce;
use crate::tangential::loaded_zone::LoadedZone;
use crate::tangential::rigid_slip::RigidSlip;
use crate::tangential::rolling::Rolling;

/// Solver with its scratch memory; it keeps no result.
#[derive(Clone, Debug)]
pub struct TractionStrips {
    pub(super) points: Points,
    pub(super) layout: Layout,
    pub(super) influence: Influence,
    pub(super) newton: Newton,
    pub(super) moving: Moving,
}

/// A number and its derivative in one direction.
pub(super) type One = Dual<1>;

/// Memory for derivatives in one direction.
#[derive(Clone, Debug)]
pub(super) struct Moving {
    pub layout: Layout<One>,
    pub influence: Influence<One>,
    pub strips: Vec<Strip<One>>,
}

impl Moving {
    pub fn with_capacity(points: usize, strips: usize) -> Self {
        Self {
            layout: Layout::with_capacity(strips),
            influence: Influence::with_capacity(points),
            strips: vec![Strip::default(); NODES],
        }
    }
}

impl TractionStrips {
    /// With `points` along each strip, 4 to [`MAX_POINTS`], for zones of up to `strips` strips;
    /// larger ones allocate.
    #[must_use]
    pub fn new(points: usize, strips: usize) -> Self {
        Self {
            points: Points::new(points),
            layout: Layout::with_capacity(strips),
            influence: Influence::with_capacity(points),
            newton: Newton::new(),
            moving: Moving::with_capacity(points, strips),
        }
    }

    /// Hands the force of each strip of `span`, which is of `loaded`, on the wheel to `each`; nothing
    /// where there is no solution.
    pub fn strip_forces(
        &mut self,
        loaded: &LoadedZone<'_, impl RigidSlip>,
        span: &Span,
        rolling: Rolling,
        mut each: impl FnMut(usize, StripForce),
    ) -> Option<Settled> {
        let settled = self.settle(loaded, span, rolling)?;
        for (place, j) in self.layout.places.iter().zip(span.strips.clone()) {
            each(j, self.force(loaded, rolling, j, place, &self.newton.strips));
        }
        Some(settled)
    }

    /// Solves for the tractions of `span`.
    fn settle(
        &mut self,
        loaded: &LoadedZone<'_, impl RigidSlip>,
        span: &Span,
        rolling: Rolling,
    ) -> Option<Settled> {
        let carrier = |j| carrier(loaded, span, rolling, j, |x| x);
        if !self.layout.lay(span.strips.clone(), span.edges, carrier) {
            return None;
        }
        let settled = solve(self, loaded.material.poisson_ratio, loaded.material.shear_modulus);
        settled.left.is_finite().then_some(settled)
    }

    /// Force of strip `j` with the `place` between nodes whose states are `states`.
    fn force<T: Real>(
        &self,
        loaded: &LoadedZone<'_, impl RigidSlip<T>, T>,
        rolling: Rolling,
        j: usize,
        place: &Between<T>,
        states: &[Strip<T>],
    ) -> StripForce<T> {
        let strips = loaded.strips;
        let (bound, a) =
            (loaded.friction_coefficient(j) * strips.pressure[j], strips.half_length[j]);
        self.resultant([bound, a, strips.width[j]], rolling, place, states)
    }

    /// Force of a strip with this bound in its middle [Pa], half length and width [m].
    pub(super) fn resultant<T: Real>(
        &self,
        [bound, half_length, width]: [T; 3],
        rolling: Rolling,
        place: &Between<T>,
        states: &[Strip<T>],
    ) -> StripForce<T> {
        let points = &self.points;
        let [one, other] = between(place, states);
        let mut sums = [T::from(0.0); 4];
        let slips = |strip: &Strip<T>, l: usize| {
            f64::from(u8::from(strip.v[0][l].hypot(strip.v[1][l]) > 1.0))
        };
        for l in 0..points.count {
            let mix = |b: usize| one.r[b][l] + place.share * (other.r[b][l] - one.r[b][l]);
            let (weight, y) = (points.weights[l], mix(1));
            sums[0] += mix(0) * weight;
            sums[1] += y * weight;
            sums[2] += y * (weight * points.tractions[l]);
            let [first, second] = [slips(one, l), slips(other, l)];
            sums[3] += (place.share * (second - first) + first) * points.shares[l];
        }
        let scale = -(bound * half_length * width);
        // Backwards the strip is the same seen in a mirror along x.
        let mirrored = scale * rolling.direction();
        StripForce {
            longitudinal: mirrored * sums[0],
            lateral: scale * sums[1],
            moment: mirrored * half_length * sums[2],
            slip_area: half_length * width * sums[3] * 2.0,
        }
    }

    /// Tractions on the wheel of a zone that rolls forward over their bounds, and whether it slips,
    /// at the place t of a strip, -1 to 1 at the leading edge, as a function of the number of the
    /// strip in the zone and t; nothing where there is no solution.
    pub fn tractions(
        &mut self,
        loaded: &LoadedZone<'_, impl RigidSlip>,
    ) -> Option<impl Fn(usize, f64) -> ([f64; 2], bool)> {
        let span = Span::of(loaded.zone, loaded.strips, None);
        self.settle(loaded, &span, Rolling::Forward)?;
        let own = &*self;
        Some(move |strip: usize, t: f64| {
            let place = &own.layout.places[strip];
            let [one, other] = between(place, &own.newton.strips);
            let places = &own.points.tractions[..own.points.count];
            let behind = places.partition_point(|&at| at > t).min(places.len() - 1);
            let ahead = behind.saturating_sub(1);
            let span = places[ahead] - places[behind];
            let back = if span > 0.0 { ((places[ahead] - t) / span).clamp(0.0, 1.0) } else { 0.0 };
            let at = |b: usize, l: usize| one.r[b][l] + place.share * (other.r[b][l] - one.r[b][l]);
            let r = [0, 1].map(|b| at(b, ahead) + back * (at(b, behind) - at(b, ahead)));
            let nearest = if back < 0.5 { ahead } else { behind };
            let strip = if place.share < 0.5 { one } else { other };
            let slips = strip.v[0][nearest].hypot(strip.v[1][nearest]) > 1.0;
            (r.map(|r| -r), slips)
        })
    }
}

/// The states between which a strip is.
fn between<'a, T>(place: &Between<T>, states: &'a [Strip<T>]) -> [&'a Strip<T>; 2] {
    [place.node, (place.node + 1).min(states.len() - 1)].map(|k| &states[k])
}

/// Strip `j` of a `span` of `loaded` as the layout has it, in the numbers that `to` makes; backward
/// rolling seen in a mirror along x.
pub(super) fn carrier<T: Real, O: Real>(
    loaded: &LoadedZone<'_, impl RigidSlip<T>, T>,
    span: &Span<T>,
    rolling: Rolling,
    j: usize,
    to: impl Fn(T) -> O,
) -> Carrier<O> {
    let (strips, direction) = (loaded.strips, rolling.direction());
    let creepage = loaded.slip.creepage(j);
    Carrier {
        x: to(strips.x[j]) * direction,
        y: to(strips.y[j]),
        half_length: to(strips.half_length[j]),
        bound: to(loaded.friction_coefficient(j) * strips.pressure[j]),
        width: to(strips.width[j] * span.share(strips.y[j])),
        creepage: Creepage {
            longitudinal: to(creepage.longitudinal) * direction,
            lateral: to(creepage.lateral),
            spin: to(creepage.spin) * direction,
        },
        passed: O::from(0.0),
    }
}

/// Compiled for several instruction sets, the widest one chosen at run time.
#[multiversion(targets("x86_64+avx512f+avx512dq", "x86_64+avx2", "aarch64+neon"))]
pub(super) fn solve(own: &mut TractionStrips, poisson_ratio: f64, shear_modulus: f64) -> Settled {
    let TractionStrips { points, layout, influence, newton, .. } = own;
    let nodes = &layout.nodes;
    influence.fill(nodes, points, poisson_ratio);
    newton.solve(&Equations { nodes, points, influence, shear_modulus })
}
