//! A strip between the rounds: what it is, what others do to it, and its tractions.

use std::f64::consts::PI;

use super::functions::Four;
use super::influence::{Own, Pair};
use super::march::{CELLS, Sums};
use crate::kinematics::creepage::Creepage;
use crate::math::real::Real;

/// A loaded strip that rolls forward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip<T = f64> {
    /// Place across [m].
    pub y: T,
    /// Half length > 0 [m].
    pub half_length: T,
    /// Width > 0 [m].
    pub width: T,
    /// Friction limit per width > 0 [N/m].
    pub limit: T,
    /// Shear modulus of the bodies as it seems > 0 [Pa].
    pub shear_modulus: T,
    /// Rigid slip in its middle.
    pub creepage: Creepage<T>,
    /// Load [N].
    pub load: T,
    /// How much of it belongs to the left lobe of its zone, where that has a neck [-].
    pub left: T,
}

/// Creepage that does to the march of a strip of the half length `a` what these gradients do. A
/// longitudinal one that grows along the strip does as much as a third of what it is at the leading
/// edge, where all of it adheres.
pub(super) fn felt<T: Real>(a: T, shear_modulus: T, [along, across]: &[Four<T>; 2]) -> Creepage<T> {
    let factor = T::from(GRADIENT) / shear_modulus;
    let even = |[zeroth, _, second, _]: &Four<T>| *zeroth + a * a * *second * 0.5;
    let odd = |[_, first, _, other_first]: &Four<T>| *first + *other_first;
    Creepage {
        longitudinal: factor * (even(along) + a * odd(along) * (1.0 / 3.0)),
        lateral: factor * even(across),
        spin: factor * odd(across),
    }
}

/// Tractions of a strip in sums: what it does to the body that creeps, with the other sign.
#[derive(Clone, Copy, Debug, Default)]
pub struct Resultant<T = f64> {
    /// Moments ∫ f x^k over the strip, k = 0, 1, along the track and across [N, N m].
    pub moments: [[T; 2]; 2],
    /// Share of its length that slips [-].
    pub slip_share: f64,
}

/// Moments of the tractions of a strip, arranged for products with a [`Pair`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Moments<T> {
    /// (1, 0, 1, 2), then (0, 1, 0, -) and (2, -, 2, -); what is not used is any of them.
    odd: Four<T>,
    even: [Four<T>; 2],
}

/// Factor of the gradients that go with a [`Pair`], times the shear modulus.
const GRADIENT: f64 = 2.0 / (PI * PI);

/// A strip and how it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct State<T> {
    pub strip: Strip<T>,
    pub own: Own<T>,
    /// Along the track and across.
    pub growth: [Growth<T>; 2],
    /// Mean bound of its tractions [Pa].
    pub bound: T,
    /// What sums of tractions times t^k over the cells are multiplied by, k = 0, 1, 2.
    weights: [T; 3],
    /// Moment of its spin over its width where all adheres [N m].
    turning: T,
    pub moments: [Moments<T>; 2],
    pub gradients: [Four<T>; 2],
    /// What does not come from marches.
    pub given: [Four<T>; 2],
    pub resultant: Resultant<T>,
}

/// Growth of the tractions of a strip over a cell, in one direction.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Growth<T> {
    /// By its rigid slip: constant and by t.
    rigid: [T; 2],
    /// By the gradients that others cause: the constant and the square part of the constant growth,
    /// of that by t, of that by T₂(t).
    caused: [T; 4],
}

impl<T: Real> Moments<T> {
    fn none() -> Self {
        Self::of([T::from(0.0); 3])
    }

    /// Of the moments ∫ f x^k, k = 0, 1, 2.
    #[inline(always)]
    pub fn of([zeroth, first, second]: [T; 3]) -> Self {
        Self {
            odd: [first, zeroth, first, second],
            even: [[zeroth, first, zeroth, first], [second; 4]],
        }
    }

    /// The moments.
    #[inline(always)]
    pub fn each(&self) -> [T; 3] {
        let [first, zeroth, _, second] = self.odd;
        [zeroth, first, second]
    }
}

/// Adds the gradients that another strip causes, which lies below if `IS_BELOW`: what is crossed has
/// the sign of its side.
#[inline(always)]
pub(super) fn receive<const F: bool, const IS_BELOW: bool, T: Real>(
    [along, across]: &mut [Four<T>; 2],
    pair: &Pair<T>,
    [x, y]: &[Moments<T>; 2],
) {
    let sided = |c: T| if IS_BELOW { c } else { -c };
    for lane in 0..4 {
        let [first, second] = [sided(pair.crossed[0][lane]), sided(pair.crossed[1][lane])];
        along[lane] = along[lane]
            .add_product::<F>(pair.along[lane], x.odd[lane])
            .add_product::<F>(first, y.even[0][lane])
            .add_product::<F>(second, y.even[1][lane]);
        across[lane] = across[lane]
            .add_product::<F>(pair.across[lane], y.odd[lane])
            .add_product::<F>(first, x.even[0][lane])
            .add_product::<F>(second, x.even[1][lane]);
    }
}

/// Products lane by lane.
#[inline(always)]
fn product<T: Real>(a: &Four<T>, b: &Four<T>) -> Four<T> {
    std::array::from_fn(|lane| a[lane] * b[lane])
}

/// Sums lane by lane.
#[inline(always)]
fn sum<T: Real>(a: &Four<T>, b: &Four<T>) -> Four<T> {
    std::array::from_fn(|lane| a[lane] + b[lane])
}

impl<T: Real> Growth<T> {
    /// Constant growth and that by t and by T₂(t) with these gradients.
    #[inline(always)]
    pub fn under<const F: bool>(&self, [zeroth, first, second, other_first]: &Four<T>) -> [T; 3] {
        let [constant, square, linear, by_second] = self.caused;
        [
            self.rigid[0].add_product::<F>(constant, *zeroth).add_product::<F>(square, *second),
            self.rigid[1].add_product::<F>(linear, *first + *other_first),
            by_second * *second,
        ]
    }
}

impl<T: Real> State<T> {
    pub fn new(strip: Strip<T>) -> Self {
        Self {
            strip,
            own: Own::default(),
            growth: [Growth::default(); 2],
            bound: T::from(0.0),
            weights: [T::from(0.0); 3],
            turning: T::from(0.0),
            moments: [Moments::none(); 2],
            gradients: [[T::from(0.0); 4]; 2],
            given: [[T::from(0.0); 4]; 2],
            resultant: Resultant::default(),
        }
    }

    /// Lays out what marches through a strip of this `own` need; nothing comes from others yet.
    #[inline(always)]
    pub fn begin(&mut self, own: Own<T>) {
        let Strip { half_length: a, width, limit, creepage, shear_modulus, .. } = self.strip;
        let zeroth = a * (2.0 / CELLS as f64) * width;
        let first = zeroth * a;
        self.own = own;
        self.growth = self.growth();
        (self.bound, self.weights) = (limit / (a * 2.0), [zeroth, first, first * a]);
        // Rigid slip grows across it, and its load is a hat, whose mean square is a sixth of w².
        let per_slip = shear_modulus * a * a * width * 2.0 / own.flexibility[0][0];
        self.turning = per_slip * creepage.spin * width * width * (1.0 / 6.0);
        (self.gradients, self.given) = ([[T::from(0.0); 4]; 2], [[T::from(0.0); 4]; 2]);
    }

    /// Growth of the tractions along the track and across.
    #[inline(always)]
    fn growth(&self) -> [Growth<T>; 2] {
        let &Strip { half_length: a, creepage, shear_modulus, .. } = &self.strip;
        let rigid = [[creepage.longitudinal, T::from(0.0)], [creepage.lateral, creepage.spin * a]];
        let step = a * (2.0 / CELLS as f64);
        let mut growth = [Growth::default(); 2];
        for component in 0..2 {
            let [flexibility, by_first, by_second, _] = self.own.flexibility[component];
            let per_flexibility = step / flexibility;
            let [constant, linear] = rigid[component];
            let caused = per_flexibility * GRADIENT;
            // Of x² to T₂.
            let square = caused * (a * a * 0.5);
            let by_slip = shear_modulus * per_flexibility;
            growth[component] = Growth {
                rigid: [constant * by_slip, linear * by_first * by_slip],
                caused: [caused, square, caused * by_first * a, square * by_second],
            };
        }
        growth
    }

    /// Begins with the gradients that are given and those that it causes itself beyond those in its
    /// march.
    #[inline(always)]
    pub fn begin_gradients(&mut self) {
        let [x, y] = &self.moments;
        self.gradients = [
            sum(&product(&self.own.along, &x.odd), &self.given[0]),
            sum(&product(&self.own.across, &y.odd), &self.given[1]),
        ];
    }

    /// Sums of the tractions of the march, along the track and across.
    pub fn marched(&self) -> [T; 2] {
        [0, 1].map(|component| self.moments[component].each()[0])
    }

    /// Takes the moments of the tractions after a march.
    #[inline(always)]
    pub fn take_sums(&mut self, sums: &Sums<T>, lane: usize) {
        for component in 0..2 {
            let mut moments = [T::from(0.0); 3];
            for (k, moment) in moments.iter_mut().enumerate() {
                *moment = sums.moments[component][k][lane] * self.weights[k];
            }
            self.moments[component] = Moments::of(moments);
            self.resultant.moments[component] = [moments[0], moments[1]];
        }
        // Where it slides, all of it is dragged as its middle is, and friction holds no more than its
        // load turns about that.
        let ([x, y], bound) = (self.marched(), self.strip.limit * self.strip.width);
        let slides = ((x * x + y * y) / (bound * bound)).at_most(1.0);
        let share = self.turning / (bound * self.strip.width * (1.0 / 3.0));
        self.resultant.moments[1][1] +=
            self.turning * (-slides + 1.0) / (share * share + 1.0).sqrt();
        self.resultant.slip_share = sums.slipping[lane] / CELLS as f64;
    }
}
