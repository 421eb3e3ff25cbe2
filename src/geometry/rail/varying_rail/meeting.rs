//! Which rows of a rail the wheel above it is to meet, and where it does.

use super::few::{Few, NEAR, goes_on};
use super::over::Over;
use super::touch::Touch;
use super::trend::Trend;
use crate::geometry::sections::rows::met::Met;
use crate::math::fixed_vec::FixedVec;

/// How far below the wheel the few rows surely are of which nothing is asked where none is known to
/// be nearer [m].
const FAR_BELOW: f64 = 0.02;
/// Distance from the wheel from which on a row is put as it is under the axle, wherever it was met:
/// under waves rows that nothing touches may be met far apart from each other, and an outline
/// through them turn back. More than [`NEAR`], up to which rows between them are looked at [m].
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
                if let Some(found) = touch.meet(over, j, start, looks_through) {
                    met.push(found);
                    trend.follow(&found);
                }
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
        let nearest = nearest.filter(|met| met.opposite.is_some());
        let least = nearest.map_or(0.0, |met| met.gap.height.max(0.0));
        let far = nearest.map_or(FAR_BELOW, |_| least + NEAR);
        wide.clear();
        let is_near = |low: &f64| *low <= far;
        // Beside the rows that may touch one more on either side is enough.
        let (Some(from), Some(to)) =
            (lows.iter().position(is_near), lows.iter().rposition(is_near))
        else {
            wide.extend(rows.filter_map(|(j, _)| touch.aside(over, j)));
            return;
        };
        let mut trend = Trend::default();
        for (j, low) in rows.skip(from.saturating_sub(1)).take(to + 2 - from.saturating_sub(1)) {
            let met = (low <= far).then(|| touch.meet(over, j, trend.start(parameter, j), true));
            let (found, low) = match met.flatten() {
                Some(met) if is_untouched(&met, least) => (touch.aside(over, j), met.gap.height),
                Some(met) => (Some(met), low),
                None => (touch.aside(over, j), low),
            };
            let Some(mut found) = found else { continue };
            if found.opposite.is_none() {
                found.gap.height = low;
            }
            wide.push(found);
            trend.follow(&found);
        }
    }
}

/// Whether a row that was met stays away from a wheel that was lowered by `way` [m].
fn is_untouched(met: &Met, way: f64) -> bool {
    met.gap.lowered(way) > UNTOUCHED
}
