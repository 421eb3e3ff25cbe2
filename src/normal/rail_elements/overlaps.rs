//! Where along the arc of a rail the undeformed bodies overlap: the stretches about the contacts
//! that the search has found.

use super::section::{LAST_STEP, Row, Section};
use crate::geometry::contacts::contact_search::ContactSearch;

/// Places of the arc between which the bodies overlap, and what was found on the way.
pub(super) struct Overlap {
    /// Arc, parameter of the contact line, and from where to where along the track the bodies
    /// overlap there, in growing arc [m].
    pub places: Vec<[f64; 4]>,
    /// An end of the rail along the track that cuts it, from the wheel marker [m].
    pub end: Option<f64>,
}

impl Overlap {
    pub(super) fn range(&self) -> [f64; 2] {
        [self.places[0][0], self.places[self.places.len() - 1][0]]
    }
}

impl Section<'_> {
    /// The stretches of overlap about the contacts of `search`, in growing arc, those that share a
    /// place as one.
    ///
    /// The surfaces about a contact may overlap in several stretches: each of its probes that may
    /// lie in one is a place to begin at.
    pub(super) fn overlaps(&self, search: &ContactSearch) -> Vec<Overlap> {
        let mut all: Vec<Overlap> = Vec::new();
        for contact in search.contacts.iter() {
            all.extend(self.overlap(contact.rail_s, contact.u));
            for probe in &search.probes[contact.probes[0]..contact.probes[1]] {
                if probe.f >= contact.penetration {
                    continue;
                }
                let opposite = self.line.at(probe.u).point;
                let guess = self.rail.coarse_nearest(opposite);
                let rail_s = self.rail.nearest(opposite, guess, LAST_STEP).s;
                let arc = self.arcs.arc(rail_s);
                let is_known = all.iter().any(|o| o.range()[0] <= arc && arc <= o.range()[1]);
                if !is_known {
                    all.extend(self.overlap(rail_s, probe.u));
                }
            }
        }
        all.sort_by(|a, b| a.range()[0].total_cmp(&b.range()[0]));
        let mut apart: Vec<Overlap> = Vec::new();
        for next in all {
            match apart.last_mut() {
                Some(last) if last.range()[1] > next.range()[0] => {
                    last.places.extend(next.places);
                    last.end = last.end.or(next.end);
                    last.places.sort_by(|a, b| a[0].total_cmp(&b[0]));
                }
                _ => apart.push(next),
            }
        }
        apart
    }

    /// The stretch of overlap about the parameter `rail_s` of the rail, the contact line sought
    /// near the parameter `near`.
    fn overlap(&self, rail_s: f64, near: f64) -> Option<Overlap> {
        let middle = self.arcs.arc(rail_s);
        let mut end = None;
        let mut place = |arc: f64, row: &Row| {
            let ([from, to], [begin, last]) = (self.stretch(row), row.ends);
            end = end.or(row.ends.into_iter().find(|end| from < *end && *end < to));
            [arc, row.u, from.max(begin), to.min(last)]
        };
        let first = self.row(middle, near).filter(|row| row.overlap > 0.0)?;
        let mut places = vec![place(middle, &first)];
        for side in [-1.0, 1.0] {
            let (mut arc, mut step, mut u) = (middle, FIRST_STEP, near);
            // One place outside is part of the stretch.
            while let Some(row) = self.row(arc + side * step, u) {
                arc += side * step;
                u = row.u;
                places.push(place(arc, &row));
                if row.overlap <= 0.0 {
                    break;
                }
                step = (1.5 * step).min(LONGEST_STEP);
            }
        }
        places.sort_by(|a, b| a[0].total_cmp(&b[0]));
        (places.len() > 1).then_some(Overlap { places, end })
    }

    /// From where to where along the track the bodies overlap at `row` [m], with all that lies
    /// between.
    fn stretch(&self, row: &Row) -> [f64; 2] {
        let even = self.line.wheel_point(row.u).section_radius;
        let share = (1.0 + even * row.course.curvature).max(MIN_CURVATURE_SHARE);
        let radius = even / share;
        let half = (2.0 * radius * row.overlap.max(0.0)).sqrt();
        let mut stretch = [row.x - half, row.x + half];
        // A wheel that varies around may overlap again beyond what its curvature tells.
        let reach = self.line.reach(row.u, row.x, row.overlap).filter(|_| row.overlap > 0.0);
        for (side, last) in reach.into_iter().flatten().enumerate() {
            let (first, mut guess) = (stretch[side], [row.u, row.overlap - row.course.lift]);
            let sign = if side == 0 { -1.0 } else { 1.0 };
            let steps = (sign * (last - first) / SCAN).ceil().max(0.0) as usize;
            for i in 1..=steps {
                let x = first + sign * SCAN * i as f64;
                let Some(at) = self.line.surface_along(x, row.point, row.normal(), guess) else {
                    break;
                };
                guess = [at.s, at.depth];
                if at.depth + row.course.more(x - row.x) > 0.0 {
                    stretch[side] = x + sign * SCAN;
                }
            }
        }
        stretch
    }

    /// The row at `arc` where the wheel may overlap.
    pub(super) fn row_near(&self, arc: f64, overlaps: &[Overlap]) -> Option<Row> {
        let overlap = overlaps.iter().find(|o| o.range()[0] <= arc && arc <= o.range()[1])?;
        let k = overlap.places.partition_point(|place| place[0] <= arc);
        let (a, b) =
            (overlap.places[k.max(1) - 1], overlap.places[k.clamp(1, overlap.places.len() - 1)]);
        let share = if b[0] > a[0] { (arc - a[0]) / (b[0] - a[0]) } else { 0.0 };
        self.row(arc, a[1] + share * (b[1] - a[1]))
    }
}

/// First step along the arc and the longest [m].
const FIRST_STEP: f64 = 2e-6;
const LONGEST_STEP: f64 = 5e-4;
/// Spacing at which a wheel that varies around is looked through for its overlap along the track:
/// that of its outline [m].
const SCAN: f64 = 2e-3;
/// Least curvature of wheel and rail together along the track, over that of the wheel, by which the
/// length of a contact is estimated [-].
const MIN_CURVATURE_SHARE: f64 = 0.05;
