//! Where the wheel meets a row of the rail.

use super::bounds::{Bounds, LARGEST};
use super::bracket::Bracket;
use super::over::Over;
use super::spot::{Row, Spot};
use super::wheel_table::WheelTable;
use crate::geometry::sections::rows::met::{Met, Opposite, Untouched};
use crate::geometry::sections::rows::surface::Surface;
use crate::math::real::Real;

/// Distance of rows over which their places and those of the wheel opposite go on as before [m].
pub(super) const CLOSE: f64 = 3e-3;
/// Steps to the place along a row, and the longest of them [m]: halved so often, nothing is left of
/// it.
const MAX_STEPS: usize = 40;
const LONGEST_STEP: f64 = 0.02;
/// Bend of a row against the wheel, over that of the wheel, from which on a step goes by it alone:
/// below, waves change it over a step.
const STEADY_BEND: f64 = 0.1;
/// A step over which all that is met goes along evenly [m].
const LAST_STEP: f64 = 1e-11;
/// Spacing at which a row that is hollow for the wheel is looked through [m].
const SCAN: f64 = 4e-3;

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

    /// Whether row `j` is there under the wheel that is `over` it.
    pub fn is_there(&self, over: &Over, j: usize) -> bool {
        self.row(over, j).is_some_and(|row| over.reach(self.surface, row.run).is_some())
    }

    /// Row `j` where it is `untouched`, as far as it is there; nothing where it is not.
    pub fn aside(&self, over: &Over, j: usize, untouched: Untouched) -> Option<Met> {
        let row = self.row(over, j)?;
        let [from, to] = over.reach(self.surface, row.run)?;
        let place = untouched.place.clamp(from, to);
        let ahead = untouched.ahead + place - untouched.place;
        let point = row.at(over, place);
        Some(over.aside(j, Untouched { place, ahead }, &point))
    }

    /// Where the wheel meets row `j`, sought from a `start` along the track, with the parameter and
    /// the coordinate along the axle opposite, if any are known; nothing where the row is not there,
    /// the wheel stands upright or nothing of it is opposite.
    pub fn meet(
        &self,
        over: &Over,
        j: usize,
        start: Option<[f64; 3]>,
        looks_through: bool,
    ) -> Option<Met> {
        let row = self.row(over, j)?;
        let ends = over.reach(self.surface, row.run)?;
        let mut spot = self.begin(over, &row, ends, start)?;
        if !(looks_through && self.is_hollow(over, j)) {
            let rest = settle(over, &row, &mut spot, ends);
            return Some(spot.found(over, j, rest));
        }
        let (best, other) = self.valleys(&row, over, &spot, ends);
        let near = |axial: f64| Some(spot.s() + axial - spot.axial());
        let found = [Some(best), other].into_iter().flatten().map(|place| {
            let mut own = Spot::find(over, &row, place, near).unwrap_or(spot);
            let rest = settle(over, &row, &mut own, ends);
            (own, rest)
        });
        // Two valleys about as high: samples do not tell which one is higher.
        let (spot, rest) = found.min_by(|(a, _), (b, _)| a.gap.total_cmp(&b.gap))?;
        Some(spot.found(over, j, rest))
    }

    /// Whether row `j` or the wheel may be hollow.
    pub fn is_hollow(&self, over: &Over, j: usize) -> bool {
        self.bounds.is_hollow(j, over.within.ends) || over.is_hollow()
    }

    /// A `row` from one place to another one, at the place of `start`; nothing where the wheel
    /// stands upright or nothing of it is opposite.
    fn begin(
        &self,
        over: &Over,
        row: &Row,
        [from, to]: [f64; 2],
        start: Option<[f64; 3]>,
    ) -> Option<Spot> {
        let place = start.map_or(0.0, |[place, ..]| place).clamp(from, to);
        Spot::find(over, row, place, |axial| {
            let near = start.filter(|[_, _, own]| (axial - own).abs() < CLOSE);
            near.map(|[_, s, own]| s + axial - own).or_else(|| self.wheel.parameter(axial))
        })
    }

    /// The row that was `found`, as it moves with a round wheel.
    pub fn moving<T: Real>(&self, over: &Over<T>, found: &Met) -> Met<T> {
        let (j, slice) = (found.row, over.within.slice);
        // Both were there when it was found.
        let run = self.surface.run(j, over.station.value(), slice);
        let row = Row { surface: self.surface, number: j, run: run.unwrap_or_default() };
        let ends = run.and_then(|run| over.reach(self.surface, run));
        let Some(opposite) = found.opposite.filter(|_| run.is_some()) else {
            let untouched = found.untouched;
            return over.aside(j, untouched, &row.at(over, untouched.place.into()));
        };
        let Opposite { place, s, rest, .. } = opposite;
        let is_end = |end: &T| end.value().to_bits() == place.to_bits();
        let end = ends.into_iter().flatten().find(is_end);
        let spot = Spot::at(over, &row, end.unwrap_or(place.into()), s.into());
        let (way, rest) = match end {
            Some(_) => (T::from(0.0), None),
            None => (spot.rest(over), Some(T::from(rest))),
        };
        let s = T::moving(s, spot.parameter_after(way));
        let place = end.unwrap_or_else(|| T::moving(place, way));
        Spot::at(over, &row, place, s).met(over, j, rest)
    }

    /// About where a `row` is highest for the wheel by samples, and where it may be higher still.
    fn valleys(
        &self,
        row: &Row,
        over: &Over,
        here: &Spot,
        [from, to]: [f64; 2],
    ) -> (f64, Option<f64>) {
        let way = over.way(here.place, &here.point);
        let on_line = over.line().at(here.s()).x;
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
        let height = |i: usize| here.height(over, at(i), row.point(over, at(i)));
        // Height of the bottom by the parabola through three samples, how far below it may be, and
        // its place.
        let mut lowest = [(f64::INFINITY, 0.0, None); 2];
        let (mut before, mut own) = (f64::INFINITY, height(0));
        for i in 0..=count {
            let after = if i < count { height(i + 1) } else { f64::INFINITY };
            if own <= before && own <= after {
                let bend = before - 2.0 * own + after;
                let is_valley = bend.is_finite() && bend > 0.0;
                let ahead = if is_valley { 0.5 * (before - after) / bend } else { 0.0 };
                let below = if is_valley { 0.125 * bend } else { 0.0 };
                let place = at(i) + ahead * (to - from) / count as f64;
                let valley = (own - 4.0 * below * ahead * ahead, below, Some(place));
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

/// Takes the `spot` on a `row` by Newton steps to where the wheel meets that `from` one place `to`
/// another one, but for the way that is left; nothing is left where the row ends there, or at a kink.
fn settle(over: &Over, row: &Row, spot: &mut Spot, [from, to]: [f64; 2]) -> Option<f64> {
    let steady = STEADY_BEND / over.nominal_radius();
    let mut bracket = Bracket::new();
    let mut before: Option<[f64; 2]> = None;
    for _ in 0..MAX_STEPS {
        bracket.take(spot);
        // Of a wheel that varies around the bend is that of the round one in its place; where row
        // and wheel are nearly as round as each other steps by a greater one would not settle.
        let is_known = spot.bend >= steady && !over.varies_around();
        let chord = before.filter(|_| !is_known).map(|b| (spot.slope - b[1]) / (spot.place - b[0]));
        let bend = chord.filter(|chord| *chord > 0.0).unwrap_or(spot.bend.max(steady));
        let step = -spot.slope / bend;
        let next = spot.place + step.clamp(-LONGEST_STEP, LONGEST_STEP);
        // Exactly on an end where it is held there.
        if (from..=to).contains(&next) && step.abs() <= LAST_STEP {
            return Some(step);
        }
        if let Some(kink) = bracket.kink(over) {
            *spot = kink;
            break;
        }
        let next = bracket.held(next);
        let is_held = !(from..=to).contains(&next);
        let next = next.clamp(from, to);
        let way = next - spot.place;
        if is_held && way == 0.0 {
            return None;
        }
        let near = spot.parameter_after(way);
        let Some(other) = Spot::find(over, row, next, |_| Some(near)) else { break };
        before = Some([spot.place, spot.slope]);
        *spot = other;
    }
    Some(0.0)
}
