//! Local maxima and minima of the overlap, from samples at equal distances.
//!
//! The samples are joined by cubics whose slopes are the central differences (Catmull and Rom). The
//! turns of these cubics, all of which are known, move with the samples without jumps, and come and
//! go in pairs.

use crate::math::real::Real;

/// A place between two samples at which their cubic turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turn<T> {
    /// Share of the way from the one to the other.
    pub share: T,
    /// Value of the cubic there.
    pub height: T,
    /// Whether the cubic is least there.
    pub is_valley: bool,
}

/// The turns between the second and the third of four samples, in their order.
pub(super) fn turns<T: Real>([before, from, to, behind]: [T; 4]) -> [Option<Turn<T>>; 2] {
    let [first, last] = [to - before, behind - from].map(|rise| rise * 0.5);
    let rise = to - from;
    // Slope: first + 2 b t + a t².
    let a = (first + last - rise * 2.0) * 3.0;
    let b = rise * 3.0 - first * 2.0 - last;
    let root = b * b - a * first;
    let starts_falling = first.value() < 0.0;
    // In a valley the slope rises, by the positive root.
    let turn = |is_valley: bool| {
        let positive = root.at_least(0.0).sqrt();
        let root = if is_valley { positive } else { -positive };
        // Without a difference of nearly equal numbers.
        let share = if (b * root).value() > 0.0 { -(first / (b + root)) } else { (root - b) / a };
        let share = share.within(0.0, 1.0);
        let height = from + share * (first + share * (b + share * a * (1.0 / 3.0)));
        Some(Turn { share, height, is_valley })
    };
    if starts_falling != (last.value() < 0.0) {
        return [turn(starts_falling), None];
    }
    let middle = -(b / a).value();
    let turns_back = (a.value() < 0.0) == starts_falling && middle > 0.0 && middle < 1.0;
    if turns_back && root.value() > 0.0 {
        [turn(starts_falling), turn(!starts_falling)]
    } else {
        [None; 2]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(samples: [f64; 4]) -> Vec<(f64, bool)> {
        turns(samples).into_iter().flatten().map(|t| (t.share, t.is_valley)).collect()
    }

    #[test]
    fn a_parabola_turns_at_its_vertex() {
        let vertex = 0.3;
        for (sign, is_valley) in [(1.0, true), (-1.0, false)] {
            let samples = [-1.0, 0.0, 1.0, 2.0].map(|t: f64| sign * (t - vertex).powi(2));
            let [(share, found)] = places(samples)[..] else { panic!("one turn") };
            assert!((share - vertex).abs() < 1e-15);
            assert_eq!(found, is_valley);
        }
    }

    #[test]
    fn turns_come_and_go_in_pairs_and_each_belongs_to_one_cell() {
        // A wave on a slope, along which the samples are shifted: one peak and one valley in each
        // wave.
        let wave = |t: f64| (t * 1.3).sin() + 0.4 * t;
        for shift in 0..1000 {
            let at = |k: usize| wave(k as f64 + 1e-3 * f64::from(shift));
            let found: Vec<_> = (1..29)
                .flat_map(|k| places([at(k - 1), at(k), at(k + 1), at(k + 2)]))
                .map(|(_, is_valley)| is_valley)
                .collect();
            assert!((11..=12).contains(&found.len()), "{}", found.len());
            assert!(found.windows(2).all(|pair| pair[0] != pair[1]));
        }
    }

    #[test]
    fn an_even_slope_does_not_turn() {
        assert!(places([0.0, 1.0, 2.0, 3.0]).is_empty());
        assert!(places([0.0; 4]).is_empty());
        // Slopes that rise and fall again without a change of sign.
        assert!(places([0.0, 0.2, 1.0, 1.2]).is_empty());
    }
}
