//! Height and width of the lobe that a place of an overlap belongs to.
//!
//! What is another lobe is not decided: all places of an interval count, but those behind a valley
//! the less the deeper it is, by the eighth power of the least share on the way over the lower one
//! of both ends. Behind a valley of three quarters it is a tenth.

use std::ops::Range;

use multiversion::multiversion;

use crate::math::real::Real;

/// Steps of an interval.
pub(super) const STEPS: usize = 32;
/// Places of an interval: where steps begin and end.
pub(super) const PLACES: usize = STEPS + 1;

/// Sums over the lobe of each of some places that are equally far apart: of the share of the depth
/// there, its square and its cube, and with `SKEWED` of the square times what else is known of the
/// places and times the square of that; for shares that are not negative.
///
/// Compiled for several instruction sets; no operation is fused or reordered, so that all of them
/// give the same bits.
#[multiversion(targets("x86_64+avx2", "aarch64+neon"))]
pub(super) fn sums<T: Real, const SKEWED: bool>(
    shares: &[T; PLACES],
    others: &[T; PLACES],
) -> [[T; PLACES]; 5] {
    let zero = [T::from(0.0); PLACES];
    let mut sums = [zero; 5];
    // Least share on the way from each place to the one that is added.
    let mut least = zero;
    for (place, (&share, &other)) in shares.iter().zip(others).enumerate() {
        least[place] = share;
        add::<T, SKEWED>([share, other], shares, &mut least, &mut sums, 0..place + 1);
    }
    for (place, (&share, &other)) in shares.iter().zip(others).enumerate().rev() {
        least[place] = share;
        add::<T, SKEWED>([share, other], shares, &mut least, &mut sums, place + 1..PLACES);
    }
    sums
}

/// Adds what a place with such a share and something else gives to the lobes of the `places`.
#[allow(clippy::inline_always)]
#[inline(always)]
fn add<T: Real, const SKEWED: bool>(
    [share, other]: [T; 2],
    shares: &[T; PLACES],
    least: &mut [T; PLACES],
    [first, second, third, fourth, fifth]: &mut [[T; PLACES]; 5],
    places: Range<usize>,
) {
    let (square, cube) = (share * share, share * share * share);
    let product = square * other;
    let other_square = product * other;
    for place in places {
        least[place] = least[place].min(share);
        // A place without a share belongs to what a place with hardly any belongs to.
        let none = f64::MIN_POSITIVE;
        let dip = (least[place] + none) / (shares[place].min(share) + none);
        let power = (dip * dip) * (dip * dip);
        let weight = power * power;
        first[place] += weight * share;
        second[place] += weight * square;
        third[place] += weight * cube;
        if SKEWED {
            fourth[place] += weight * product;
            fifth[place] += weight * other_square;
        }
    }
}
