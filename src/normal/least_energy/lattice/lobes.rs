//! Height and width of the lobe that a place of an overlap belongs to.
//!
//! What is another lobe is not decided: all places of an interval count, but those behind a valley
//! the less the deeper it is, by the eighth power of the least share on the way over the lower one
//! of both ends. Behind a valley of three quarters it is a tenth.
//!
//! Lobes that rise from a common overlap press each other down: of each only the top carries load. A
//! place lies on a pedestal p, the greatest m (1 - (m/s)⁴)⁸ on all ways to other places, with m the
//! least share on the way and s that of the lower end: nothing on a single lobe, and about the
//! depth of the valley on lobes with a deep one between them.

use std::ops::Range;

use crate::math::real::Real;
use crate::math::vectors::with_vectors;

/// Steps of an interval. Two intervals that join have half of them each: with so many, and closer at
/// the ends, forces jump by 1e-4 at most where they do.
pub(super) const STEPS: usize = 44;
/// Places of an interval: where steps begin and end.
pub(super) const PLACES: usize = STEPS + 1;
/// How much closer to each other places are at the ends of an interval than in the mean, where the
/// overlap is steep.
const CLOSE: f64 = 0.6;
/// Places over the length of their interval.
pub(super) const AT: [f64; PLACES] = {
    let mut at = [0.0; PLACES];
    let mut k = 0;
    while k < PLACES {
        let t = k as f64 / STEPS as f64;
        at[k] = t * (1.0 - CLOSE) + t * t * (3.0 - 2.0 * t) * CLOSE;
        k += 1;
    }
    at
};
/// Share of each place in an integral over the interval.
const WEIGHTS: [f64; PLACES] = {
    let mut weights = [0.0; PLACES];
    let mut k = 0;
    while k < STEPS {
        let half = 0.5 * (AT[k + 1] - AT[k]);
        weights[k] += half;
        weights[k + 1] += half;
        k += 1;
    }
    weights
};
/// What is found for each place: five sums and the pedestal.
const SUMS: usize = 6;

/// Integrals over the lobe of each of the places of an interval, over its length: of the share of the
/// depth there, its square and its cube, and with `SKEWED` of the square times what else is known of
/// the places and times the square of that; and the pedestal; for shares that are not negative.
pub(super) fn sums<T: Real, const SKEWED: bool>(
    shares: &[T; PLACES],
    others: &[T; PLACES],
) -> [[T; PLACES]; SUMS] {
    if is_one_lobe(shares) {
        over_all(shares, others)
    } else if T::IS_BACKWARD {
        sums_backward(shares, others)
    } else {
        over_lobes::<T, SKEWED>(shares, others)
    }
}

/// Whether shares do not rise any more where they have fallen: all places then count as much, and
/// none lies on a pedestal.
fn is_one_lobe<T: Real>(shares: &[T; PLACES]) -> bool {
    let mut falls = false;
    shares.windows(2).all(|pair| {
        falls |= pair[1] < pair[0];
        !(falls && pair[1] > pair[0])
    })
}

/// The sums over all places.
fn over_all<T: Real>(shares: &[T; PLACES], others: &[T; PLACES]) -> [[T; PLACES]; SUMS] {
    let mut sums = [T::from(0.0); SUMS];
    for ((&share, &other), weight) in shares.iter().zip(others).zip(WEIGHTS) {
        let own = share * weight;
        let square = share * own;
        let product = square * other;
        let terms = [own, square, square * share, product, product * other];
        for (sum, term) in sums.iter_mut().zip(terms) {
            *sum += term;
        }
    }
    sums.map(|sum| [sum; PLACES])
}

/// The [`sums`] of any shares.
fn over_lobes<T: Real, const SKEWED: bool>(
    shares: &[T; PLACES],
    others: &[T; PLACES],
) -> [[T; PLACES]; SUMS] {
    with_vectors(
        #[inline(always)]
        || {
            let zero = [T::from(0.0); PLACES];
            let mut sums = [zero; SUMS];
            // Least share on the way from each place to the one that is added.
            let mut least = zero;
            for (place, (&share, &other)) in shares.iter().zip(others).enumerate() {
                least[place] = share;
                let own = [share, other, T::from(WEIGHTS[place])];
                add::<T, SKEWED>(own, shares, &mut least, &mut sums, 0..place + 1);
            }
            for (place, (&share, &other)) in shares.iter().zip(others).enumerate().rev() {
                least[place] = share;
                let own = [share, other, T::from(WEIGHTS[place])];
                add::<T, SKEWED>(own, shares, &mut least, &mut sums, place + 1..PLACES);
            }
            sums
        },
    )
}

/// Adds what a place with such a share and something else gives to the lobes of the `places`, and
/// raises their pedestals to what the way to it tells.
#[inline(always)]
fn add<T: Real, const SKEWED: bool>(
    [share, other, weight]: [T; 3],
    shares: &[T; PLACES],
    least: &mut [T; PLACES],
    [first, second, third, fourth, fifth, pedestal]: &mut [[T; PLACES]; SUMS],
    places: Range<usize>,
) {
    let own = share * weight;
    let (square, cube) = (share * own, share * share * own);
    let product = square * other;
    let other_square = product * other;
    // Of one length that is known to be right, so that the loop has no bounds to check and is made
    // of wide instructions.
    let count = places.len();
    let (shares, least) = (&shares[places.clone()][..count], &mut least[places.clone()][..count]);
    let [first, second, third] =
        [first, second, third].map(|sums| &mut sums[places.clone()][..count]);
    let [fourth, fifth, pedestal] =
        [fourth, fifth, pedestal].map(|sums| &mut sums[places.clone()][..count]);
    for place in 0..count {
        least[place] = least[place].min(share);
        // A place without a share belongs to what a place with hardly any belongs to.
        let none = f64::MIN_POSITIVE;
        let dip = (least[place] + none) / (shares[place].min(share) + none);
        let power = (dip * dip) * (dip * dip);
        let weight = power * power;
        let valley = T::from(1.0) - power;
        let valley = (valley * valley) * (valley * valley);
        pedestal[place] = pedestal[place].max(least[place] * (valley * valley));
        first[place] += weight * own;
        second[place] += weight * square;
        third[place] += weight * cube;
        if SKEWED {
            fourth[place] += weight * product;
            fifth[place] += weight * other_square;
        }
    }
}

/// [`sums`] as numbers that derivatives go back from: these are known as a whole.
fn sums_backward<T: Real>(shares: &[T; PLACES], others: &[T; PLACES]) -> [[T; PLACES]; SUMS] {
    let values = shares.map(T::value);
    let own_others = others.map(T::value);
    let sums = over_lobes::<f64, true>(&values, &own_others);
    let mut moving = [[T::from(0.0); PLACES]; SUMS];
    for place in 0..PLACES {
        let (by_share, by_other) = slopes_at(place, &values, &own_others);
        for (sum, moving) in moving.iter_mut().enumerate() {
            let operands = shares.iter().zip(by_share[sum]);
            let by_other = sum.checked_sub(3).and_then(|n| by_other.get(n));
            let more = by_other.map(|&by_other| others.iter().zip(by_other));
            moving[place] =
                T::combined(sums[sum][place], operands.chain(more.into_iter().flatten()));
        }
    }
    moving
}

/// Derivatives of the five sums and the pedestal of a `place` by all shares, and of the last two
/// sums by all others.
fn slopes_at(
    place: usize,
    shares: &[f64; PLACES],
    others: &[f64; PLACES],
) -> ([[f64; PLACES]; SUMS], [[f64; PLACES]; 2]) {
    let (mut by_share, mut by_other) = ([[0.0; PLACES]; SUMS], [[0.0; PLACES]; 2]);
    // The pedestal, the place of the valley and that of the lower end that it comes from, and its
    // derivatives by these.
    let mut pedestal = (0.0, [place; 2], [0.0; 2]);
    let mut add = |least: usize, k: usize| {
        let (share, other) = (shares[k], others[k]);
        let none = f64::MIN_POSITIVE;
        let lower = if shares[place] <= share { place } else { k };
        let dip = (shares[least] + none) / (shares[lower] + none);
        let power = (dip * dip) * (dip * dip);
        let weight = power * power;
        let valley = 1.0 - power;
        let height = shares[least] * valley.powi(8);
        if height > pedestal.0 {
            let turn = 32.0 * valley.powi(7) * power;
            pedestal = (height, [least, lower], [valley.powi(8) - turn, turn * dip]);
        }
        let square = share * share;
        let terms = [share, square, square * share, square * other, square * other * other];
        let rates =
            [1.0, 2.0 * share, 3.0 * square, 2.0 * share * other, 2.0 * share * other * other];
        let [terms, rates] =
            [terms, rates].map(|numbers| numbers.map(|number| number * WEIGHTS[k]));
        for sum in 0..5 {
            by_share[sum][k] += weight * rates[sum];
            // Where there is no share, it does not move.
            for (of, sign) in [(least, 8.0), (lower, -8.0)] {
                if least != lower && shares[of] > 0.0 {
                    by_share[sum][of] += sign * weight * terms[sum] / shares[of];
                }
            }
        }
        by_other[0][k] += weight * square * WEIGHTS[k];
        by_other[1][k] += weight * square * 2.0 * other * WEIGHTS[k];
    };
    let mut least = place;
    for k in place..PLACES {
        least = if shares[least] <= shares[k] { least } else { k };
        add(least, k);
    }
    least = place;
    for k in (0..place).rev() {
        least = if shares[least] <= shares[k] { least } else { k };
        add(least, k);
    }
    let (_, places, rates) = pedestal;
    for (place, rate) in places.into_iter().zip(rates) {
        by_share[SUMS - 1][place] += rate;
    }
    (by_share, by_other)
}
