//! Zones with a neck: two lobes that are about to part, or have just joined.
//!
//! One ellipse for the whole and one for each lobe are different forces, so that a step from the
//! one to the other would be a jump where zones join. Instead a zone with a neck is mixed of both,
//! by how deep the neck is: with q the load per width and d the least of its shares in the lower of
//! the greatest q on either side,
//!
//! ```text
//! F = (1 - w) F_whole + w (F_left + F_right),      w = 1 at d = 0, where zones join, 0 from d = 1/2 on
//! d = min_j q_j/min(max_{k≤j} q_k, max_{k≥j} q_k)
//! ```
//!
//! This holds for ellipses from the table and for integration along the strips alike: each lobe has
//! its own flexibilities, and its own mean creepage acts through L1 and L2.
//!
//! All of it is a continuous function of the strips.

use crate::math::real::Real;
use crate::math::smooth_step::smooth_step;
use crate::normal::{Strips, Zone};

/// Depth of a neck from which on a zone is one.
const WHOLE: f64 = 0.5;

/// A neck and what is left and right of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neck<T = f64> {
    /// Share w of the two lobes in the force, above 0 to 1.
    pub share: T,
    /// Where it is, as the lateral coordinate of strips [m].
    y: T,
    /// Width over which strips go over from one lobe to the other [m].
    blend: T,
}

/// Which of two lobes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// That of smaller y.
    Left,
    /// That of greater y.
    Right,
}

/// What of a zone is looked at: the whole, or a lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent<T = f64> {
    /// The whole.
    Whole,
    /// What lies on one side of a neck.
    Lobe(Neck<T>, Side),
}

impl<T: Real> Extent<T> {
    /// Share of a strip at `y` [m] that belongs to it, 0 to 1.
    #[inline]
    pub fn member(&self, y: T) -> T {
        match self {
            Self::Whole => T::from(1.0),
            Self::Lobe(neck, side) => neck.member(*side, y),
        }
    }
}

impl<T: Real> Neck<T> {
    /// The neck of `zone`, if it has one.
    pub fn of(zone: &Zone<T>, strips: &Strips<T>) -> Option<Self> {
        let range = zone.range();
        let [ys, lengths, pressures] =
            [&strips.y, &strips.half_length, &strips.pressure].map(|column| &column[range.clone()]);
        // Then no strip carries less than some on either side.
        if rises_and_falls(ys, lengths, pressures) {
            return None;
        }
        // Stretches of one strip, as uneven bodies have them, count together.
        let load = |j: usize| {
            let y = ys[j];
            let own = |k: usize| lengths[k] * pressures[k];
            let is_next = j + 1 < ys.len() && ys[j + 1] == y;
            if !is_next && (j == 0 || ys[j - 1] != y) {
                return own(j);
            }
            (0..ys.len()).filter(|&k| ys[k] == y).map(own).sum()
        };
        let mut greatest = (T::from(0.0), 0);
        for j in 0..ys.len() {
            let own = load(j);
            if own > greatest.0 {
                greatest = (own, j);
            }
        }
        let (count, peak) = (ys.len(), greatest.1);
        let mut deepest = (T::from(WHOLE), None);
        for_each_depth(count, peak, load, |j, depth| {
            if depth < deepest.0 {
                deepest = (depth, Some(j));
            }
        });
        let (least, Some(at)) = deepest else { return None };
        // Where it is: the strips between peaks, the more the less they carry; where zones join
        // that strip alone which carries nothing. Ways from there, so that it is not rounded then.
        let at = ys[at];
        let [mut sum, mut first, mut second] = [T::from(0.0); 3];
        for_each_depth(count, peak, load, |j, depth| {
            // A strip may carry nothing at all.
            let [own, least] = [depth, least].map(|depth| depth.at_least(f64::MIN_POSITIVE));
            let weight = strips.width[range.start + j] * ((-depth + 1.0) * (least / own)).powi(2);
            let way = ys[j] - at;
            sum += weight;
            first += weight * way;
            second += weight * way * way;
        });
        if sum <= 0.0 {
            return None;
        }
        let way = first / sum;
        let square = (second / sum - way * way).at_least(0.0);
        // An even distribution as wide as that of these strips.
        let blend = (square * 12.0).sqrt().at_least(f64::MIN_POSITIVE);
        Some(Self { share: smooth_step(-(least / WHOLE) + 1.0), y: at + way, blend })
    }

    /// Share of a strip at `y` that belongs to the lobe on one side, 0 to 1.
    fn member(&self, side: Side, y: T) -> T {
        match side {
            Side::Left => self.left(y),
            Side::Right => -self.left(y) + 1.0,
        }
    }

    /// Share of a strip at `y` that belongs to the left lobe, 0 to 1.
    pub fn left(&self, y: T) -> T {
        // Half of the one strip that a neck without width lies on belongs to either side. What that
        // neck moves by is what its strip does, which backwards would be a difference of infinities.
        if T::IS_BACKWARD && self.blend <= f64::MIN_POSITIVE && y >= self.y && y <= self.y {
            return T::from(0.5);
        }
        let x = ((self.y - y) / self.blend + 0.5).within(0.0, 1.0);
        smooth_step(x)
    }
}

/// Whether the load of strips of these half lengths and pressures, each at a y of its own, rises to
/// one peak and falls from there, as that of most zones.
fn rises_and_falls<T: Real>(ys: &[T], lengths: &[T], pressures: &[T]) -> bool {
    let mut last = (T::from(f64::NEG_INFINITY), T::from(0.0));
    let mut falls = false;
    ys.iter().zip(lengths).zip(pressures).all(|((&y, &length), &pressure)| {
        let load = length * pressure;
        let goes_on = y != last.0 && !(falls && load > last.1);
        falls |= load < last.1;
        last = (y, load);
        goes_on
    })
}

/// Hands to `each` those of `count` strips that carry less than some on either side, with their
/// loads over the lower of the greatest on either side; `peak` carries most of all.
fn for_each_depth<T: Real>(
    count: usize,
    peak: usize,
    load: impl Fn(usize) -> T,
    mut each: impl FnMut(usize, T),
) {
    let mut walk = |strips: &mut dyn Iterator<Item = usize>| {
        let mut greatest = T::from(0.0);
        for j in strips {
            let own = load(j);
            if own < greatest {
                each(j, own / greatest);
            } else {
                greatest = own;
            }
        }
    };
    walk(&mut (0..peak));
    walk(&mut (peak + 1..count).rev());
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal::LoadedStrip;
    use approx::assert_abs_diff_eq;

    /// Strips of equal width with these loads per width.
    fn strips(loads: &[f64]) -> (Zone, Strips) {
        let mut strips = Strips::with_capacity(1, loads.len());
        for (j, q) in loads.iter().enumerate() {
            let (y, width, half_length, pressure) = (1e-3 * j as f64, 1e-3, 1e-3, 1e3 * q);
            strips.push(LoadedStrip { y, width, half_length, pressure, ..<_>::default() });
        }
        let count = loads.len();
        (Zone { count, width: 1e-3 * count as f64, ..Zone::default() }, strips)
    }

    #[test]
    fn one_lobe_has_no_neck_and_two_have_one_between_them() {
        for loads in [&[0.2, 0.5, 1.0, 0.8, 0.3][..], &[1.0, 0.6, 0.8], &[0.1, 0.1, 0.1]] {
            let (zone, strips) = strips(loads);
            assert_eq!(Neck::of(&zone, &strips), None, "{loads:?}");
        }
        let (zone, strips) = strips(&[0.5, 1.0, 0.5, 0.0, 0.4, 0.8, 0.4]);
        let neck = Neck::of(&zone, &strips).unwrap();
        assert_abs_diff_eq!(neck.share, 1.0, epsilon = 1e-12);
        assert_abs_diff_eq!(neck.y, 3e-3, epsilon = 1e-9);
        // Of which lobe the strip is that carries nothing makes no difference.
        assert_abs_diff_eq!(neck.left(2e-3), 1.0);
        assert_abs_diff_eq!(neck.left(4e-3), 0.0);
    }

    #[test]
    fn the_strip_in_a_neck_is_half_of_each_lobe_and_its_neighbours_come_to_belong_to_one() {
        let mut before = 0.5;
        for depth in [0.3, 0.1, 0.01, 1e-4, 1e-8] {
            let (zone, strips) = strips(&[0.5, 1.0, 0.5, depth, 0.5, 1.0, 0.5]);
            let neck = Neck::of(&zone, &strips).unwrap();
            assert_abs_diff_eq!(neck.left(3e-3), 0.5, epsilon = 1e-6);
            let neighbour = neck.left(2e-3);
            assert!(neighbour >= before, "{depth}: {neighbour} after {before}");
            before = neighbour;
        }
        assert_abs_diff_eq!(before, 1.0);
    }

    #[test]
    fn a_strip_that_alone_is_the_neck_is_half_of_each_lobe_wherever_it_is() {
        for shift in [-3.3e-3, -1e-3 / 3.0, 7.7e-4, 0.1] {
            let (zone, mut strips) = strips(&[0.6, 1.5, 0.6, 1.4, 0.7, 0.3]);
            strips.y.iter_mut().for_each(|y| *y += shift);
            let neck = Neck::of(&zone, &strips).unwrap();
            assert_abs_diff_eq!(neck.left(strips.y[2]), 0.5, epsilon = 1e-12);
        }
    }

    #[test]
    fn a_third_peak_comes_up_smoothly() {
        // The third lobe overtakes the second one as the lower of the peaks beside the neck.
        let places = [-1.0, 1.0].map(|side| {
            let (zone, strips) = strips(&[1.0, 0.1, 0.5, 0.3, 0.5 + 1e-9 * side, 0.2]);
            Neck::of(&zone, &strips).unwrap()
        });
        assert_abs_diff_eq!(places[0].share, places[1].share, epsilon = 1e-7);
        assert_abs_diff_eq!(places[0].y, places[1].y, epsilon = 1e-10);
        assert_abs_diff_eq!(places[0].blend, places[1].blend, epsilon = 1e-10);
    }

    #[test]
    fn a_neck_comes_up_smoothly() {
        let mut before = 0.0;
        for i in 0..=100 {
            let neck = 0.5 - 0.005 * f64::from(i);
            let (zone, strips) = strips(&[0.5, 1.0, 0.8, neck, 0.8, 1.0, 0.5]);
            let share = Neck::of(&zone, &strips).map_or(0.0, |neck| neck.share);
            assert!(share >= before && share < before + 0.02, "{neck}: {share} after {before}");
            before = share;
        }
        assert_abs_diff_eq!(before, 1.0, epsilon = 1e-12);
    }
}
