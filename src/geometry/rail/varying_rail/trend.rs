//! How the place at which rows are met goes on from one to the next.

use super::touch::{CLOSE, Start};
use crate::geometry::sections::rows::envelope::TREND;
use crate::geometry::sections::rows::met::Met;

/// The last three rows that were met.
#[derive(Default)]
pub(super) struct Trend {
    last: [Option<Met>; 3],
}

impl Trend {
    /// Goes on to the row that was `found`.
    pub fn follow(&mut self, found: &Met) {
        let [a, b, _] = self.last;
        self.last = [Some(*found), a, b];
    }

    /// The row that was met last.
    pub fn beside(&self) -> Option<&Met> {
        self.last[0].as_ref()
    }

    /// Where row `j` is sought, by the row parameters: where the parabola through the last rows
    /// leads, or as many of them as go on from one to the next; where the row `other` was met if
    /// there are none.
    pub fn start(&self, parameter: &[f64], j: usize, other: &Met) -> Start {
        let [Some(last), before, first] = &self.last else { return Start::of(Some(other)) };
        let away = |m: &Met, of: &Met| parameter[of.row] - parameter[m.row];
        let ahead = parameter[j] - parameter[last.row];
        if ahead > CLOSE {
            return Start::of(Some(last));
        }
        // Place, and parameter of the wheel along the axle.
        let of = |m: &Met| m.opposite.map(|[u, axial]| [m.place, u, axial]);
        let goes_on = |m: &Met, to: &Met| away(m, to) < CLOSE && (to.place - m.place).abs() < TREND;
        let before = before.as_ref().filter(|m| goes_on(m, last));
        let (Some(a), Some(b)) = (of(last), before.and_then(of)) else {
            return Start::of(Some(last));
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
