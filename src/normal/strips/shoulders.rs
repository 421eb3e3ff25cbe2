//! Shoulders: bulges on a flank of the overlap without a ridge before them.
//!
//! One lobe of pressure does not describe a wide bulge beside a narrow peak, ridge or not: its few terms for κ put the load up to 1.2 % off, and where there is little
//! or no pressure between the two no edges are found at all. An overlap is therefore cut at shoulders too.

use super::cell::{Cell, Top};
use crate::geometry::separation::Probe;
use crate::math::room::Room;

/// Share of a shoulder over that of a ridge that counts as much.
const SHOULDER: f64 = 0.5;
/// Most places at which a concave line above the overlap is looked for.
const MOST_TOUCHES: usize = 512;

/// Cuts the cells from number `begin` on, those of one interval of overlap, at shoulders that count more than `least_share`; the least of
/// those shares, or infinity.
///
/// On a shoulder the overlap lies below a straight line that touches it on both sides, the least concave line above all of it. Its share is the most
/// that it does so, over that line, times the root of the lower of the two places of touch, over that line too: what lies beyond a long
/// flank counts little. Where such a straight line goes over a ridge that is a cut already there is no other one.
pub(super) fn cut_shoulders(
    probes: &[Probe],
    level: f64,
    least_share: f64,
    cells: &mut Room<Cell>,
    begin: usize,
) -> f64 {
    let [first, last] = cells[begin].probes;
    let at = |i: usize| [probes[i].u, level - probes[i].f];
    // Whether the middle one of three places lies on or below the line through the others.
    let is_below = |i: usize, j: usize, k: usize| {
        let [a, b, c] = [at(i), at(j), at(k)];
        (b[1] - a[1]) * (c[0] - a[0]) <= (c[1] - a[1]) * (b[0] - a[0])
    };
    if (first + 1..last).all(|i| !is_below(i - 1, i, i + 1)) {
        return f64::INFINITY;
    }
    let mut touches = [0u16; MOST_TOUCHES];
    if last - first >= MOST_TOUCHES {
        return f64::INFINITY;
    }
    let mut count = 0;
    for i in first..=last {
        let place = |k: usize| first + usize::from(touches[k]);
        while count >= 2 && is_below(place(count - 2), place(count - 1), i) {
            count -= 1;
        }
        touches[count] = (i - first) as u16;
        count += 1;
    }
    let mut next = f64::INFINITY;
    let mut k = begin;
    for pair in touches[..count].windows(2) {
        let [a, b] = [pair[0], pair[1]].map(|touch| first + usize::from(touch));
        let [left, right] = [at(a), at(b)];
        let slope = (right[1] - left[1]) / (right[0] - left[0]);
        let line = |u: f64| left[1] + slope * (u - left[0]);
        let below = |i: usize| 1.0 - at(i)[1] / line(probes[i].u);
        let Some(most) = (a + 1..b).max_by(|&i, &j| below(i).total_cmp(&below(j))) else {
            continue;
        };
        let lower = left[1].min(right[1]) / line(probes[most].u);
        let share = SHOULDER * below(most) * lower.sqrt();
        while cells[k].range[1] <= left[0] && k + 1 < cells.len() {
            k += 1;
        }
        let has_cut = cells[k].joined && cells[k].range[1] < right[0];
        if share <= least_share || has_cut || cells.len() == cells.capacity() {
            continue;
        }
        next = next.min(share);
        let place = vertex([most - 1, most, most + 1].map(|i| [probes[i].u, below(i)]));
        let [mut before, mut after] = [cells[k]; 2];
        (before.range[1], after.range[0], before.joined) = (place, place, true);
        before.ridge = None;
        if cells[k].deepest[0] < place {
            (after.deepest, after.top) = (right, Top::Shoulder);
        } else {
            (before.deepest, before.top) = (left, Top::Shoulder);
        }
        cells[k] = before;
        cells.insert(k + 1, after);
    }
    next
}

/// Where the parabola through three points is highest, the middle one being the highest of the three.
fn vertex([left, middle, right]: [[f64; 2]; 3]) -> f64 {
    let slope = |a: [f64; 2], b: [f64; 2]| (b[1] - a[1]) / (b[0] - a[0]);
    let (before, after) = (slope(left, middle), slope(middle, right));
    if before <= after {
        return middle[0];
    }
    let (half_before, half_after) = (0.5 * (left[0] + middle[0]), 0.5 * (middle[0] + right[0]));
    half_before + before / (before - after) * (half_after - half_before)
}

#[cfg(test)]
mod tests {
    use super::super::cell::fill;
    use super::super::cell::tests::probes;
    use super::*;

    #[test]
    fn a_shoulder_is_cut_where_it_is_furthest_below_a_straight_line() {
        // A peak at zero, and a bulge on its flank 3 mm out.
        let f = |u: f64| {
            let bulge = 1.0 - (u / 1e-3 - 3.0).powi(2);
            if u < 1e-3 { u * u } else { 1e-6 + 1e-3 * (u - 1e-3) - 4e-7 * bulge.max(0.0) }
        };
        let mut cells = Room::new(8);
        let share = fill(&probes(f), 4e-6, 0.02, &mut cells);
        assert!(share > 0.02 && share < 0.2, "{share}");
        assert_eq!(cells.len(), 2);
        assert!(cells[0].joined && !cells[1].joined && cells[1].is_on_shoulder());
        approx::assert_relative_eq!(cells[0].range[1], 2e-3, max_relative = 0.05);
        approx::assert_relative_eq!(cells[1].range[0], cells[0].range[1]);
        // Passed over, and where there is none.
        assert!(fill(&probes(f), 4e-6, share, &mut cells).is_infinite() && cells.len() == 1);
        let concave = |u: f64| u * u + 0.2 * u.abs().powi(3);
        assert!(fill(&probes(concave), 4e-6, 0.0, &mut cells).is_infinite());
        assert_eq!(cells.len(), 1);
    }

    #[test]
    fn the_vertex_of_a_parabola_is_found() {
        let at = |u: f64| [u, 2.0 - (u - 0.3).powi(2)];
        approx::assert_relative_eq!(vertex([at(-0.5), at(0.1), at(1.0)]), 0.3, epsilon = 1e-12);
    }
}
