//! The steps of FASTSIM along many strips at once, so that the processor takes several of them in
//! one instruction, and with derivatives.

use std::array::from_fn;

use crate::math::dual::Dual;
use crate::math::real::{Real, as_is};
use crate::math::vectors::with_vectors;

/// Strips that are marched through together, that is integrated along from their leading edges.
pub const LANES: usize = 32;
pub type Lanes<T> = [T; LANES];

/// What the march of up to `LANES` strips needs: traction increments per element and the bounds μ
/// p_n at the centres of the strips [Pa].
#[derive(Clone, Copy, Debug, Default)]
pub struct LaneInput<T> {
    pub step_x: Lanes<T>,
    pub step_y: Lanes<T>,
    pub step_y_per_abscissa: Lanes<T>,
    pub bound: Lanes<T>,
}

/// Sums over the elements of each strip.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums<T> {
    pub x: Lanes<T>,
    pub y: Lanes<T>,
    pub y_abscissa: Lanes<T>,
    pub slipping: Lanes<f64>,
}

/// The elements of a strip, see [`Fastsim`](super::Fastsim).
#[derive(Clone, Copy, Debug)]
pub struct Elements<'a> {
    pub profile: &'a [f64],
    pub abscissae: &'a [[f64; 2]],
}

/// Numbers that all a strip depends on: four derivatives do for any number of directions.
type ByFour = Dual<4>;

impl<T: Real> LaneInput<T> {
    /// The same in other numbers: of number `k` from 0 in its order.
    fn map<O: Real>(&self, to: impl Fn(T, usize) -> O) -> LaneInput<O> {
        LaneInput {
            step_x: self.step_x.map(|x| to(x, 0)),
            step_y: self.step_y.map(|x| to(x, 1)),
            step_y_per_abscissa: self.step_y_per_abscissa.map(|x| to(x, 2)),
            bound: self.bound.map(|x| to(x, 3)),
        }
    }

    /// Marches the strips of the first `lanes` lanes at once.
    pub fn march(&self, lanes: usize, elements: Elements) -> Sums<T> {
        let plain = as_is(self).map(|plain: &LaneInput<f64>| plain.march_some(lanes, elements));
        if let Some(&sums) = plain.as_ref().and_then(as_is) {
            return sums;
        }
        let sums = self.map(|x, k| ByFour::variable(x.value(), k)).march_some(lanes, elements);
        sums.map(|sum, lane| {
            if lane >= lanes {
                return sum.value.into();
            }
            let own = [
                &self.step_x[lane],
                &self.step_y[lane],
                &self.step_y_per_abscissa[lane],
                &self.bound[lane],
            ];
            T::combined(sum.value, own.into_iter().zip(sum.slopes))
        })
    }

    /// As [`march`](Self::march), as many lanes as there are instructions for.
    fn march_some(&self, lanes: usize, elements: Elements) -> Sums<T> {
        with_vectors(
            #[inline(always)]
            || match lanes {
                0..=8 => self.march_lanes::<8>(elements, |_, _| {}),
                9..=16 => self.march_lanes::<16>(elements, |_, _| {}),
                _ => self.march_lanes::<LANES>(elements, |_, _| {}),
            },
        )
    }

    /// Marches the first `N` lanes; `each` gets the tractions of an element and whether they are
    /// bounded.
    #[inline(always)]
    pub fn march_lanes<const N: usize>(
        &self,
        Elements { profile, abscissae }: Elements,
        mut each: impl FnMut([&[T; N]; 2], &[bool; N]),
    ) -> Sums<T> {
        let mut sums = Sums::default();
        let [mut px, mut py] = [[T::from(0.0); N]; 2];
        // The first element's middle is half a step behind the leading edge.
        let mut length = 0.5;
        for (bound, [abscissa, step_abscissa]) in profile.iter().zip(abscissae) {
            let mut slips = [false; N];
            for lane in 0..N {
                let trial_x = px[lane] + self.step_x[lane] * length;
                let twist = self.step_y_per_abscissa[lane] * *step_abscissa;
                let trial_y = py[lane] + (self.step_y[lane] + twist) * length;
                let magnitude = (trial_x * trial_x + trial_y * trial_y).sqrt();
                let ratio = self.bound[lane] * *bound / magnitude;
                // 0/0 of an idle lane is not a number, and the lesser one then is the one.
                let scale = ratio.at_most(1.0);
                px[lane] = trial_x * scale;
                py[lane] = trial_y * scale;
                sums.x[lane] += px[lane];
                sums.y[lane] += py[lane];
                sums.y_abscissa[lane] += py[lane] * *abscissa;
                sums.slipping[lane] += if scale < 1.0 { 1.0 } else { 0.0 };
                slips[lane] = scale < 1.0;
            }
            each([&px, &py], &slips);
            length = 1.0;
        }
        sums
    }
}

impl<T: Real> Sums<T> {
    /// The same in other numbers: of each lane.
    fn map<O: Real>(&self, to: impl Fn(T, usize) -> O) -> Sums<O> {
        Sums {
            x: from_fn(|lane| to(self.x[lane], lane)),
            y: from_fn(|lane| to(self.y[lane], lane)),
            y_abscissa: from_fn(|lane| to(self.y_abscissa[lane], lane)),
            slipping: self.slipping,
        }
    }
}
