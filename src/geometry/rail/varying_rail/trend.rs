//! How the place at which rows are met goes on from one to the next.

use super::touch::{CLOSE, Start};
use crate::geometry::sections::rows::envelope::TREND;
use crate::geometry::sections::rows::met::Met;

/// Where a row was met.
#[derive(Clone, Copy)]
struct Last {
    row: usize,
    /// Along the track [m], and the point of the wheel opposite as of [`Start`].
    place: f64,
    opposite: Option<[f64; 2]>,
}

impl Last {
    fn start(&self) -> Start {
        Start { place: self.place, opposite: self.opposite }
    }
}

/// The last three rows that were met.
#[derive(Default)]
pub(super) struct Trend {
    last: [Option<Last>; 3],
}

impl Trend {
    /// Goes on to the row that was `found`.
    pub fn follow(&mut self, found: &Met) {
        let [a, b, _] = self.last;
        let Met { row, place, opposite, .. } = *found;
        self.last = [Some(Last { row, place, opposite }), a, b];
    }

    /// Where a row is sought from the one that was met last.
    pub fn beside(&self) -> Start {
        self.last[0].as_ref().map_or_else(Start::default, Last::start)
    }

    /// Where row `j` is sought, by the row parameters: where the parabola through the last rows
    /// leads, or as many of them as go on from one to the next.
    pub fn start(&self, parameter: &[f64], j: usize) -> Start {
        let [Some(last), before, first] = &self.last else { return Start::default() };
        let away = |m: &Last, of: &Last| parameter[of.row] - parameter[m.row];
        let ahead = parameter[j] - parameter[last.row];
        if ahead > CLOSE {
            return last.start();
        }
        // Place, and parameter of the wheel along the axle.
        let of = |m: &Last| m.opposite.map(|[u, axial]| [m.place, u, axial]);
        let goes_on =
            |m: &Last, to: &Last| away(m, to) < CLOSE && (to.place - m.place).abs() < TREND;
        let before = before.as_ref().filter(|m| goes_on(m, last));
        let (Some(a), Some(b)) = (of(last), before.and_then(of)) else {
            return last.start();
        };
        let near = before.map_or(0.0, |m| away(m, last));
        let slope = [0, 1, 2].map(|c| (a[c] - b[c]) / near);
        let first = first.as_ref().zip(before).filter(|(m, to)| goes_on(m, to));
        let bend = first.and_then(|(m, to)| {
            let (c, far) = (of(m)?, away(m, to));
            Some([0, 1, 2].map(|k| (slope[k] - (b[k] - c[k]) / far) / (near + far)))
        });
        let bend = bend.unwrap_or_default();
        let [place, u, axial] =
            [0, 1, 2].map(|k| a[k] + ahead * (slope[k] + (ahead + near) * bend[k]));
        Start { place, opposite: Some([u, axial]) }
    }
}
