//! Where the wheel meets a row of the rail.

use super::bounds::{Bounds, LARGEST};
use super::over::Over;
use super::spot::{MIN_BEND, Row, Spot};
use super::wheel_table::WheelTable;
use crate::geometry::sections::rows::met::Met;
use crate::geometry::sections::rows::surface::Surface;
use crate::math::real::Real;

/// Distance of rows over which their places and those of the wheel opposite go on as before [m].
pub(super) const CLOSE: f64 = 3e-3;
/// Steps to the place along a row, and the longest of them [m].
const MAX_STEPS: usize = 20;
const LONGEST_STEP: f64 = 0.02;
/// A step over which all that is met goes along evenly [m].
const LAST_STEP: f64 = 1e-11;
/// Spacing at which a row that is hollow for the wheel is looked through [m].
const SCAN: f64 = 4e-3;

/// Where a row is sought.
#[derive(Clone, Copy, Default)]
pub(super) struct Start {
    /// Along the track [m].
    pub place: f64,
    /// Parameter of the wheel about opposite, and the coordinate along the axle that it belongs to;
    /// if known [m].
    pub opposite: Option<[f64; 2]>,
}

/// A rail and the wheel that is looked for.
pub(super) struct Touch<'a> {
    pub surface: &'a Surface,
    pub bounds: &'a Bounds,
    pub wheel: &'a WheelTable,
}

impl Touch<'_> {
    /// Row `j` under the wheel that is `over` it; nothing where it is not there.
    fn row(&self, over: &Over, j: usize) -> Option<Row<'_>> {
        let run = self.surface.run(j, over.station, over.within.slice)?;
        Some(Row { surface: self.surface, number: j, run })
    }

    /// Row `j` as it is under the axle; nothing where it is not there.
    pub fn aside(&self, over: &Over, j: usize) -> Option<Met> {
        let row = self.row(over, j)?;
        let [from, to] = over.reach(self.surface, row.run)?;
        let place = 0.0_f64.clamp(from, to);
        let point = row.at(over, place);
        Some(over.aside(j, place, &point))
    }

    /// Where the wheel meets row `j`, sought from `start`; nothing where the row is not there.
    pub fn meet(&self, over: &Over, j: usize, start: Start, looks_through: bool) -> Option<Met> {
        let row = self.row(over, j)?;
        let ends = over.reach(self.surface, row.run)?;
        // Where the wheel stands upright, or nothing of it is opposite, the row is as good as beside
        // it, wherever those beside it are met.
        let Some(spot) = self.begin(over, &row, ends, start) else {
            return self.aside(over, j);
        };
        let settled = |spot: Spot| settle(over, &row, spot, ends);
        let (found, is_held) = if looks_through && self.is_hollow(over, j) {
            let (best, other) = self.valleys(&row, over, &spot, ends);
            let near = |axial: f64| Some(spot.s + axial - spot.axial());
            let places = [Some(best), other].into_iter().flatten();
            let found =
                places.map(|place| settled(Spot::find(over, &row, place, near).unwrap_or(spot)));
            // Two valleys about as high: samples do not tell which one is higher.
            found.min_by(|(a, _), (b, _)| a.gap.total_cmp(&b.gap))?
        } else {
            settled(spot)
        };
        Some(found.found(over, j, is_held))
    }

    /// Whether row `j` or the wheel may be hollow.
    pub fn is_hollow(&self, over: &Over, j: usize) -> bool {
        self.bounds.is_hollow(j, over.within.ends) || over.is_hollow()
    }

    /// A `row` from one place to another one, at the place of `start`; nothing where the wheel
    /// stands upright or nothing of it is opposite.
    fn begin(&self, over: &Over, row: &Row, [from, to]: [f64; 2], start: Start) -> Option<Spot> {
        let place = start.place.clamp(from, to);
        Spot::find(over, row, place, |axial| {
            let near = start.opposite.filter(|[_, own]| (axial - own).abs() < CLOSE);
            near.map(|[u, own]| u + axial - own).or_else(|| self.wheel.parameter(axial))
        })
    }

    /// The row that was `found`, as it moves with a round wheel.
    pub fn moving<T: Real>(&self, over: &Over<T>, found: &Met) -> Met<T> {
        let (j, slice) = (found.row, over.within.slice);
        let place = T::from(found.place);
        // Both were there when it was found.
        let run = self.surface.run(j, over.station.value(), slice);
        let row = Row { surface: self.surface, number: j, run: run.unwrap_or_default() };
        let ends = run.and_then(|run| over.reach(self.surface, run));
        let end =
            ends.into_iter().flatten().find(|end| end.value().to_bits() == found.place.to_bits());
        let Some([s, _]) = found.opposite.filter(|_| run.is_some()) else {
            let place = end.unwrap_or(place);
            return over.aside(j, place, &row.at(over, place));
        };
        let spot = Spot::at(over, &row, end.unwrap_or(place), T::from(s));
        let [missing, slope] = spot.equations();
        let [[a, b], [c, d]] = spot.rates().map(|equation| equation.map(T::value));
        let (place, s) = if let Some(end) = end {
            (end, T::moving(s, -missing / b))
        } else {
            let inverse = -1.0 / (a * d - b * c);
            let place = T::moving(found.place, (missing * d - slope * b) * inverse);
            (place, T::moving(s, (slope * a - missing * c) * inverse))
        };
        Spot::at(over, &row, place, s).met(over, j, end.is_some())
    }

    /// The sample of a `row` about which it is highest for the wheel, and the one about which it
    /// may be higher still.
    fn valleys(
        &self,
        row: &Row,
        over: &Over,
        here: &Spot,
        [from, to]: [f64; 2],
    ) -> (f64, Option<f64>) {
        let way = over.way(here.place, &here.point);
        let on_line = over.line().even_at(here.s).x;
        let centre = here.place + (on_line - way.x) / way.rate;
        // No farther than where a wheel stands higher than the row ever rises.
        let own = if over.varies_around() { 0.0 } else { here.raised() };
        let [_, height, ..] = here.point.value;
        let rise = (height - own - self.bounds.of(row.number, over.within.slice).least).max(0.0);
        let far = (2.0 * LARGEST * over.nominal_radius() * rise).sqrt()
            + (here.place - centre).abs()
            + over.reach_around();
        let [from, to] = [from.max(centre - far).min(to), to.min(centre + far).max(from)];
        let spacing = SCAN.min(self.surface.corrugation.bounds().spacing).min(over.spacing());
        let count = ((to - from) / spacing).ceil().max(1.0) as usize;
        let at = |i: usize| from + (to - from) * i as f64 / count as f64;
        let height = |i: usize| here.height(over, at(i), &row.at(over, at(i)));
        // Bottom by the parabola through three samples, how far below it may be, and the sample.
        let mut lowest = [(f64::INFINITY, 0.0, None); 2];
        let (mut before, mut own) = (f64::INFINITY, height(0));
        for i in 0..=count {
            let after = if i < count { height(i + 1) } else { f64::INFINITY };
            if own <= before && own <= after {
                let bend = before - 2.0 * own + after;
                let fall = if bend.is_finite() && bend > 0.0 {
                    [(before - after).powi(2) / (8.0 * bend), 0.125 * bend]
                } else {
                    [0.0; 2]
                };
                let valley = (own - fall[0], fall[1], Some(at(i)));
                if valley.0 < lowest[0].0 {
                    lowest = [valley, lowest[0]];
                } else if valley.0 < lowest[1].0 {
                    lowest[1] = valley;
                }
            }
            (before, own) = (own, after);
        }
        let [(bottom, below, best), (next, next_below, other)] = lowest;
        (best.unwrap_or(centre), other.filter(|_| next - bottom < below + next_below))
    }
}

/// Where the wheel meets a `row` `from` one place `to` another one, by Newton steps from a
/// `spot` on it, and whether the row ends there.
fn settle(over: &Over, row: &Row, mut spot: Spot, [from, to]: [f64; 2]) -> (Spot, bool) {
    // Slices that bend may lead beyond where the slope has the other sign.
    let (mut behind, mut ahead) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut before: Option<[f64; 2]> = None;
    for _ in 0..MAX_STEPS {
        let side = if spot.slope < 0.0 { &mut behind } else { &mut ahead };
        *side = spot.place;
        // Of a wheel that varies around the bend is that of the round one in its place.
        let chord = before
            .filter(|_| over.varies_around())
            .map(|[place, slope]| (spot.slope - slope) / (spot.place - place));
        let bend = chord.unwrap_or(spot.bend).max(MIN_BEND / over.nominal_radius());
        let step = -spot.slope / bend;
        let mut next = spot.place + step.clamp(-LONGEST_STEP, LONGEST_STEP);
        if !(behind..=ahead).contains(&next) {
            next = 0.5 * (behind + ahead);
        }
        // Exactly on an end where it is held there.
        let is_held = !(from..=to).contains(&next);
        let next = next.clamp(from, to);
        let way = next - spot.place;
        if is_held && way == 0.0 {
            return (spot, true);
        }
        if !is_held && way.abs() <= LAST_STEP {
            spot.rest = way;
            return (spot, false);
        }
        let near = spot.parameter_after(way);
        let Some(other) = Spot::find(over, row, next, |_| Some(near)) else { break };
        before = Some([spot.place, spot.slope]);
        spot = other;
    }
    (spot, false)
}
