//! Which rows of a rail the wheel above it is to meet, and where it does.

use super::few::{Few, NEAR, goes_on};
use super::over::Over;
use super::touch::Touch;
use super::trend::Trend;
use crate::geometry::sections::rows::met::{Gap, Met, Untouched};
use crate::math::fixed_vec::FixedVec;

/// How far below the wheel the few rows surely are of which nothing is asked where none is known to
/// be nearer [m].
const FAR_BELOW: f64 = 0.02;
/// Distance from the wheel from which on nothing touches a row, wherever it was met: under waves
/// such rows may be met far apart from each other, and an outline through them turn back. More than
/// [`NEAR`], up to which rows between them are looked at [m].
const UNTOUCHED: f64 = 1e-3;

/// The rows that a wheel meets.
#[derive(Clone, Debug)]
pub(super) struct Meeting {
    /// How far the few rows surely are below the wheel [m].
    lows: FixedVec<f64>,
    /// The few rows where they are met.
    wide: FixedVec<Met>,
    met: FixedVec<Met>,
}

impl Meeting {
    /// Room for `count` rows.
    pub fn new(count: usize) -> Self {
        let wide = FixedVec::new(count);
        Self { lows: FixedVec::new(count), met: wide.clone(), wide }
    }

    /// All rows that were met last, in their order, and a few of the others.
    pub fn met(&self) -> &[Met] {
        &self.met
    }

    /// Meets all rows that may touch the wheel `over` them, and `few` of the others, which surely
    /// are by `lows` below it [m].
    pub fn meet(&mut self, touch: &Touch, few: &Few, over: &Over, lows: impl Iterator<Item = f64>) {
        self.lows.clear();
        self.lows.extend(lows);
        self.meet_few(touch, few, over);
        let Self { wide, met, .. } = self;
        met.clear();
        let rows = &touch.surface.rows;
        let opposite = wide.iter().filter(|met| met.opposite.is_some());
        let least = opposite.map(|met| met.gap.height).reduce(f64::min).unwrap_or(0.0).max(0.0);
        let is_wavy = touch.surface.is_corrugated() || over.has_hollow_waves();
        let mut trend = Trend::default();
        for (k, here) in wide.iter().enumerate() {
            met.push(*here);
            trend.follow(here);
            let next = wide.get(k + 1);
            let next = next.filter(|next| next.row > here.row + 1);
            let next = next.filter(|next| few.is_near(rows, [here, next], least));
            let Some(next) = next else { continue };
            // Rows between two that are met in one valley are met in it.
            let looks_through = is_wavy && !goes_on(rows, [here, next]);
            for j in here.row + 1..next.row {
                let start = trend.start(&rows.parameter, j);
                let found = touch.meet(over, j, start, looks_through);
                if let Some(found) = found.filter(|found| !is_untouched(found, least)) {
                    met.push(found);
                    trend.follow(&found);
                } else if touch.is_there(over, j) {
                    met.push(untouched(j, f64::INFINITY));
                }
            }
        }
        self.lay_untouched(touch, over);
    }

    /// Takes the rows that nothing touches where those beside them are met, in between by the row
    /// parameter: the outline goes on from one to the other without turning back, however the rows
    /// drift. Where no row is met they are taken under the axle.
    fn lay_untouched(&mut self, touch: &Touch, over: &Over) {
        let met = &mut self.met;
        let parameter = &touch.surface.rows.parameter;
        let place =
            |met: &Met| met.opposite.map(|own| [parameter[met.row], own.place, met.along.ahead]);
        let (mut before, mut after, mut known) = (None, None, 0);
        for k in 0..met.len() {
            if met[k].opposite.is_some() {
                before = place(&met[k]);
                continue;
            }
            if k >= known {
                let next = (k..met.len()).find(|&i| met[i].opposite.is_some());
                (after, known) = (next.and_then(|i| place(&met[i])), next.unwrap_or(met.len()));
            }
            let Met { row, gap, .. } = met[k];
            let at = between(before, after, parameter[row]);
            if let Some(found) = touch.aside(over, row, at) {
                met[k] = Met { gap: Gap { height: gap.height, ..found.gap }, ..found };
            }
        }
    }

    /// Meets the `few` rows but for those that are farther below the wheel than the one that may be
    /// nearest.
    fn meet_few(&mut self, touch: &Touch, few: &Few, over: &Over) {
        let Self { lows, wide, .. } = self;
        let parameter = &touch.surface.rows.parameter;
        let rows = few.rows.iter().copied().zip(lows.iter().copied());
        let first = rows.clone().min_by(|a, b| a.1.total_cmp(&b.1));
        let nearest = first.and_then(|(j, _)| touch.meet(over, j, None, true));
        let least = nearest.map_or(0.0, |met| met.gap.height.max(0.0));
        let far = nearest.map_or(FAR_BELOW, |_| least + NEAR);
        wide.clear();
        let is_near = |low: &f64| *low <= far;
        // Beside the rows that may touch one more on either side is enough.
        let (Some(from), Some(to)) =
            (lows.iter().position(is_near), lows.iter().rposition(is_near))
        else {
            let there = rows.filter(|(j, _)| touch.is_there(over, *j));
            wide.extend(there.map(|(j, low)| untouched(j, low)));
            return;
        };
        let mut trend = Trend::default();
        for (j, low) in rows.skip(from.saturating_sub(1)).take(to + 2 - from.saturating_sub(1)) {
            let may_touch = low <= far;
            let start = trend.start(parameter, j);
            let met = may_touch.then(|| touch.meet(over, j, start, true)).flatten();
            let found = match met {
                Some(met) if !is_untouched(&met, least) => met,
                _ if !touch.is_there(over, j) => continue,
                Some(met) => untouched(j, met.gap.height),
                // Where the wheel stands upright, or nothing of it is opposite.
                None if may_touch => untouched(j, f64::INFINITY),
                None => untouched(j, low),
            };
            wide.push(found);
            trend.follow(&found);
        }
    }
}

/// Whether a row that was met stays away from a wheel that was lowered by `way` [m].
fn is_untouched(met: &Met, way: f64) -> bool {
    met.gap.lowered(way) > UNTOUCHED
}

/// Row `row`, which nothing touches, `height` below the wheel at least [m], before it is known where
/// it is taken.
fn untouched(row: usize, height: f64) -> Met {
    Met { row, gap: Gap { height, share: 1.0, growth: 0.0 }, ..Met::default() }
}

/// Where a row of the given `parameter` is taken between two that are met: of each its parameter,
/// place and how far ahead of the contact line that is [m].
fn between(before: Option<[f64; 3]>, after: Option<[f64; 3]>, parameter: f64) -> Untouched {
    let (Some(a), Some(b)) = (before.or(after), after.or(before)) else {
        return Untouched::default();
    };
    let way = b[0] - a[0];
    let share = if way > 0.0 { (parameter - a[0]) / way } else { 0.0 };
    let [place, ahead] = [1, 2].map(|k| a[k] + share * (b[k] - a[k]));
    Untouched { place, ahead }
}
