//! Cells: the stretches of the contact line that can carry one lobe of pressure each.
//!
//! An interval of overlap is cut at its ridges, the local minima of the overlap between two deeper places. A cell begins with at most one
//! lobe, whose edges may leave it; lobes that meet are one zone. A ridge counts by its share, the drop of the overlap from the lower of
//! the two peaks beside it, over that peak: 1 where the intervals part, 0 where ridge and peak annihilate.

use super::shoulders::cut_shoulders;
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

/// Where the lobe of a cell is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Top {
    /// At a peak of the overlap.
    #[default]
    Peak,
    /// On a shoulder, where the overlap goes on rising to one side.
    Shoulder,
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
    /// Where its lobe is.
    pub top: Top,
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

    /// Whether its lobe is on a shoulder.
    pub fn is_on_shoulder(&self) -> bool {
        self.top == Top::Shoulder
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
pub mod tests {
    use super::*;

    pub fn probes(f: impl Fn(f64) -> f64) -> Vec<Probe> {
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
}
