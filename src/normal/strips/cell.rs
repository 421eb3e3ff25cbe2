//! Cells: the stretches of the contact line that can carry one lobe of pressure each.
//!
//! An interval of overlap is cut at its ridges, the local minima of the overlap between two deeper places. A cell begins with at most one
//! lobe, whose edges may leave it; lobes that meet are one zone. A ridge counts by its share, the drop of the overlap from the lower of
//! the two peaks beside it, over that peak: 1 where the intervals part, 0 where ridge and peak annihilate.

use crate::geometry::separation::Probe;
use crate::math::room::Room;
use crate::math::root::bracketed;

/// Terms of the shape of a cell.
pub const TERMS: usize = 4;

/// What is known about a joint of two lobes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Joint {
    /// Nothing yet: a joint with a gap parts, lobes that are close get one.
    #[default]
    Untried,
    /// It had a gap, and parted.
    Parted,
    /// It is there to stay.
    Stays,
}

/// A cell and the lobe in it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cell {
    /// First and last parameter, and coordinates there [m].
    pub range: [f64; 2],
    pub bounds: [f64; 2],
    /// Whether the next cell begins at its end.
    pub joined: bool,
    /// Parameters of the probes before and after a ridge at its end; nothing where it ends otherwise [m].
    pub ridge: Option<[f64; 2]>,
    /// Coordinates where its interval of overlap begins and ends [m].
    pub reach: [f64; 2],
    /// Parameter of the deepest place and overlap there [m].
    pub deepest: [f64; 2],
    /// Probes of its interval of overlap, first and last.
    pub probes: [usize; 2],
    /// Whether it begins or ends at a shoulder, where its overlap is not deepest.
    pub on_shoulder: bool,
    /// Whether a lobe is in it.
    pub active: bool,
    /// Whether the left and the right end of the lobe is that of the lobe beside it too.
    pub met: [bool; 2],
    /// What is known about a joint with the next cell.
    pub joint: Joint,
    /// How often its free ends have been moved to where its load ends.
    pub retreats: u8,
    /// Greatest ratio of pressure with which the lobe began [-].
    pub begun_with: f64,
    /// Where its load ends: at the ends of the lobe, but for strips without load beside a joint [m].
    pub load_ends: [f64; 2],
    /// Ends of the lobe, and parameters of the line near them at the start [m].
    pub edges: [f64; 2],
    pub near: [f64; 2],
    /// Logarithm of pressure over half length, in units of E*/(2R): Legendre coefficients.
    pub shape: [f64; TERMS],
    /// Width with which the lobe began [m].
    pub start_width: f64,
    /// Greatest ratio of pressure with which the lobe begins, zero once it has begun [-], and overlap at which it then ends [m].
    pub start_ratio: f64,
    pub start_level: f64,
    /// Whether the lobe has shrunk to nothing.
    pub vanishing: bool,
    /// How often it has been given up.
    pub dropped: u8,
}

impl Cell {
    /// Whether an end of its lobe is free, and found by a condition of its own.
    pub fn is_free(&self, side: usize) -> bool {
        !self.met[side]
    }

    /// Whether strips at `abscissa`, -1 to 1 between the ends of its lobe, are on the side of a joint.
    pub fn is_beside_joint(&self, abscissa: f64) -> bool {
        self.met[0] && abscissa < 0.0 || self.met[1] && abscissa > 0.0
    }
}

/// A local extremum of the overlap, in growing u.
#[derive(Clone, Copy, Debug)]
struct Extremum {
    u: f64,
    overlap: f64,
}

/// Fills `cells` from probes with the overlap `level` - f; ridges of a share of no more than `least_share` are passed over. Returns
/// the next larger share of a ridge that is not, or infinity, so that the caller can walk through all layouts.
pub fn fill(probes: &[Probe], level: f64, least_share: f64, cells: &mut Room<Cell>) -> f64 {
    cells.clear();
    let mut next = f64::INFINITY;
    let mut first = 0;
    while first < probes.len() {
        if probes[first].f >= level {
            first += 1;
            continue;
        }
        let mut last = first;
        while last + 1 < probes.len() && probes[last + 1].f < level {
            last += 1;
        }
        let share = interval(probes, level, [first, last], least_share, cells);
        next = next.min(share);
        first = last + 1;
    }
    next
}

/// Cuts one interval of overlap, probes `first` to `last`, into cells.
fn interval(
    probes: &[Probe],
    level: f64,
    [first, last]: [usize; 2],
    least_share: f64,
    cells: &mut Room<Cell>,
) -> f64 {
    let at = |i: usize| Extremum { u: probes[i].u, overlap: level - probes[i].f };
    // Nothing is loaded where the bodies are apart: a bound a little beyond the crossing does no harm.
    let left = probes[first.saturating_sub(1)].u;
    let right = probes[(last + 1).min(probes.len() - 1)].u;
    let mut next = f64::INFINITY;
    let begin = cells.len();
    // Peaks and ridges in turn; a ridge is kept when both sides of it rise enough.
    let mut peak = at(first);
    let mut ridge: Option<Extremum> = None;
    let mut start = left;
    let push = |cells: &mut Room<Cell>, range, peak: Extremum, ridge: Option<[f64; 2]>| {
        let joined = ridge.is_some();
        if cells.len() < cells.capacity() {
            let deepest = [peak.u, peak.overlap];
            cells.push(Cell { range, joined, ridge, deepest, ..Cell::default() });
        } else if let Some(cell) = cells.last_mut() {
            // No room: the last cell reaches over the rest.
            cell.range[1] = range[1];
            (cell.joined, cell.ridge) = (joined, ridge);
        }
    };
    let beside = |low: Extremum| {
        let after = probes[first..=last].partition_point(|p| p.u <= low.u) + first;
        [probes[(after.max(2)) - 2].u, probes[after.min(last)].u]
    };
    for i in first..=last {
        let here = at(i);
        match ridge {
            None if here.overlap >= peak.overlap => peak = here,
            None => ridge = Some(here),
            Some(low) if here.overlap <= low.overlap => ridge = Some(here),
            Some(low) => {
                // Risen since the ridge: how much, of the lower of the two peaks, decides; the later peak may still grow.
                let later = peak_after(probes, level, i, last, low.overlap);
                let lower = peak.overlap.min(later);
                let share = (lower - low.overlap) / lower;
                if share > least_share {
                    next = next.min(share);
                    push(cells, [start, low.u], peak, Some(beside(low)));
                    start = low.u;
                    peak = here;
                    ridge = None;
                } else if here.overlap >= peak.overlap {
                    peak = here;
                    ridge = None;
                }
            }
        }
    }
    push(cells, [start, right], peak, None);
    for cell in &mut cells[begin..] {
        cell.probes = [first, last];
    }
    next.min(cut_shoulders(probes, level, least_share, cells, begin))
}

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
fn cut_shoulders(
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
            (after.deepest, after.on_shoulder) = (right, true);
        } else {
            (before.deepest, before.on_shoulder) = (left, true);
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

/// The highest overlap from probe `i` on before it falls below `low` again.
fn peak_after(probes: &[Probe], level: f64, i: usize, last: usize, low: f64) -> f64 {
    probes[i..=last].iter().map(|p| level - p.f).take_while(|&g| g > low).fold(0.0, f64::max)
}

/// Where the overlap is `share` of the deepest, left and right, to a few per cent of the way; the bounds where it is nowhere so little.
pub fn places(
    probes: &[Probe],
    level: f64,
    cell: &Cell,
    share: f64,
    mut overlap: impl FnMut(f64) -> f64,
) -> [f64; 2] {
    let [deepest, depth] = cell.deepest;
    let [first, last] = cell.probes;
    // The root of the depth below the peak is close to linear.
    let height = |g: f64| (depth - g.max(-depth)).max(0.0).sqrt() - ((1.0 - share) * depth).sqrt();
    let mut walk = |indices: &mut dyn Iterator<Item = usize>, bound: f64| {
        let mut inside = [deepest, height(depth)];
        for i in indices {
            let here = [probes[i].u, height(level - probes[i].f)];
            if here[1] >= 0.0 {
                let tolerance = PLACE * (here[0] - inside[0]).abs();
                let (a, b) = ((inside[0], inside[1]), (here[0], here[1]));
                return bracketed(a, b, tolerance, |u| height(overlap(u)));
            }
            inside = here;
        }
        bound
    };
    let from = first.saturating_sub(1);
    let to = (last + 1).min(probes.len() - 1);
    let left = walk(&mut (from..=to).rev().filter(|&i| probes[i].u < deepest), cell.range[0]);
    let right = walk(&mut (from..=to).filter(|&i| probes[i].u > deepest), cell.range[1]);
    [left.max(cell.range[0]), right.min(cell.range[1])]
}

/// Share of the distance between two probes to which a place is found.
const PLACE: f64 = 0.02;

#[cfg(test)]
mod tests {
    use super::*;

    fn probes(f: impl Fn(f64) -> f64) -> Vec<Probe> {
        (-100..=100).map(|i| f64::from(i) * 1e-4).map(|u| Probe { u, f: f(u) }).collect()
    }

    #[test]
    fn a_parabola_is_one_cell() {
        let mut cells = Room::new(8);
        let next = fill(&probes(|u| u * u), 4e-6, 0.1, &mut cells);
        assert!(next.is_infinite() && cells.len() == 1);
        let cell = cells[0];
        assert!(cell.range[1] >= 2e-3 && cell.range[1] < 2.2e-3);
        let half = places(&probes(|u| u * u), 4e-6, &cell, 0.5, |u| 4e-6 - u * u);
        approx::assert_relative_eq!(half[0], -(2e-6f64.sqrt()), max_relative = 1e-2);
    }

    #[test]
    fn a_ridge_parts_two_cells_by_its_share() {
        let f = |u: f64| (u * u - 9e-6).powi(2) / 81e-12 * 2e-6;
        let mut cells = Room::new(8);
        let next = fill(&probes(f), 4e-6, 0.1, &mut cells);
        approx::assert_relative_eq!(next, 0.5, max_relative = 1e-9);
        assert_eq!(cells.len(), 2);
        assert!(cells[0].joined && !cells[1].joined);
        assert!(cells[0].range[1].abs() < 1e-12);
        assert!(fill(&probes(f), 4e-6, 0.5, &mut cells).is_infinite() && cells.len() == 1);
        // Apart: two intervals.
        fill(&probes(f), 1e-6, 0.1, &mut cells);
        assert!(cells.len() == 2 && !cells[0].joined);
    }

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
        assert!(cells[0].joined && !cells[1].joined && cells[1].on_shoulder);
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
