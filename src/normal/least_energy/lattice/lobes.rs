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
/// there, its square and its cube, for shares that are not negative.
///
/// Compiled for several instruction sets; no operation is fused or reordered, so that all of them
/// give the same bits.
#[multiversion(targets("x86_64+avx2", "aarch64+neon"))]
pub(super) fn sums<T: Real>(shares: &[T; PLACES]) -> [[T; PLACES]; 3] {
    let zero = [T::from(0.0); PLACES];
    let mut sums = [zero; 3];
    // Least share on the way from each place to the one that is added.
    let mut least = zero;
    for (place, &share) in shares.iter().enumerate() {
        least[place] = share;
        add(share, shares, &mut least, &mut sums, 0..place + 1);
    }
    for (place, &share) in shares.iter().enumerate().rev() {
        least[place] = share;
        add(share, shares, &mut least, &mut sums, place + 1..PLACES);
    }
    sums
}

/// Adds what a place with so much `share` gives to the lobes of the `places`.
#[allow(clippy::inline_always)]
#[inline(always)]
fn add<T: Real>(
    share: T,
    shares: &[T; PLACES],
    least: &mut [T; PLACES],
    [first, second, third]: &mut [[T; PLACES]; 3],
    places: Range<usize>,
) {
    let (square, cube) = (share * share, share * share * share);
    for place in places {
        least[place] = least[place].min(share);
        // Of two that are nothing, none belongs to the other.
        let dip = least[place] / (shares[place].min(share) + f64::MIN_POSITIVE);
        let fourth = (dip * dip) * (dip * dip);
        let weight = fourth * fourth;
        first[place] += weight * share;
        second[place] += weight * square;
        third[place] += weight * cube;
    }
}
