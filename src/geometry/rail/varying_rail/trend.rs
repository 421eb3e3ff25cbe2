//! How the place at which rows are met goes on from one to the next.

use super::touch::CLOSE;
use crate::geometry::sections::rows::envelope::TREND;
use crate::geometry::sections::rows::met::{Met, Opposite};

/// The last three rows that were met: their numbers, and the place along the track, the parameter of
/// the wheel and the coordinate along the axle [m].
#[derive(Default)]
pub(super) struct Trend {
    last: [Option<(usize, [f64; 3])>; 3],
}

impl Trend {
    /// Goes on to the row that was `found`.
    pub fn follow(&mut self, found: &Met) {
        let [a, b, _] = self.last;
        let of = |Opposite { place, s, axial, .. }| (found.row, [place, s, axial]);
        self.last = [found.opposite.map(of), a, b];
    }

    /// Where row `j` is sought, by the row parameters: where the parabola through the last rows
    /// leads, or as many of them as go on from one to the next; nothing where none was met.
    pub fn start(&self, parameter: &[f64], j: usize) -> Option<[f64; 3]> {
        let [last, before, first] = self.last;
        let (row, a) = last?;
        let ahead = parameter[j] - parameter[row];
        let goes_on =
            |m: [f64; 3], to: [f64; 3], away: f64| away <= CLOSE && (to[0] - m[0]).abs() < TREND;
        let Some((beside, b)) = before.filter(|_| ahead <= CLOSE) else { return Some(a) };
        let near = parameter[row] - parameter[beside];
        if !goes_on(b, a, near) {
            return Some(a);
        }
        let slope = [0, 1, 2].map(|k| (a[k] - b[k]) / near);
        let bend = first.and_then(|(of, c)| {
            let far = parameter[beside] - parameter[of];
            let bend = |k: usize| (slope[k] - (b[k] - c[k]) / far) / (near + far);
            goes_on(c, b, far).then(|| [0, 1, 2].map(bend))
        });
        let bend = bend.unwrap_or_default();
        Some([0, 1, 2].map(|k| a[k] + ahead * (slope[k] + (ahead + near) * bend[k])))
    }
}
