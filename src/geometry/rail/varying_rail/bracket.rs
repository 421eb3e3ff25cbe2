//! Two places of a row between which the wheel meets it.
//!
//! Where slices or waves bend, Newton steps may lead beyond a place at which the slope of the gap had
//! the other sign, and where a row or the wheel has a kink they do so for ever: the gap goes down to
//! it from both sides. Its parabolas from both sides cross there.

use super::over::Over;
use super::spot::Spot;

/// Distance of two places on either side of a kink at which both are there [m]: two of the last steps
/// along a row.
const CLOSED: f64 = 2e-11;
/// Share of the last way to a kink by which a step goes beyond it, as the parabolas err by less, and
/// growth of that from step to step where it was too little. They decide how many steps it takes, not
/// where it is.
const FARTHER: f64 = 0.05;
const GROWTH: f64 = 8.0;

/// The last places behind and ahead of where the bodies are nearest.
pub(super) struct Bracket {
    sides: [Option<Spot>; 2],
    /// The side that was taken last, and how often it was before the other one.
    last: usize,
    times: i32,
    /// Length of the step that was to be made last [m].
    way: f64,
}

impl Bracket {
    /// One without sides.
    pub fn new() -> Self {
        Self { sides: [None; 2], last: 0, times: 0, way: f64::INFINITY }
    }

    /// Takes the side of a `spot`.
    pub fn take(&mut self, spot: &Spot) {
        let side = usize::from(spot.slope >= 0.0);
        self.times = if side == self.last { self.times + 1 } else { 1 };
        self.last = side;
        self.sides[side] = Some(*spot);
    }

    /// The place `next` if it lies between both sides and goes on less than half as far as the step
    /// before, or one between them at which a kink may be [m].
    pub fn held(&mut self, next: f64) -> f64 {
        let [Some(behind), Some(ahead)] = &self.sides else { return next };
        let [here, there] =
            if self.last == 0 { [behind, ahead] } else { [ahead, behind] }.map(|side| side.place);
        let is_between = |place: f64| place > behind.place && place < ahead.place;
        let before = std::mem::replace(&mut self.way, (next - here).abs());
        if is_between(next) && self.way < 0.5 * before {
            return next;
        }
        let crossing = behind.place + crossing(behind, ahead);
        // Where the one side comes near again and again farther and farther, so that the other one
        // does too.
        let way = (crossing - here).abs();
        let farther = (FARTHER * way).max(0.5 * CLOSED) * GROWTH.powi(self.times - 2);
        let next =
            if self.times > 1 { crossing + farther.copysign(there - here) } else { crossing };
        if is_between(next) {
            return next;
        }
        // The other side may be there already.
        let short = (2.0 * (crossing - there).abs()).max(0.25 * CLOSED);
        let is_there = short < FARTHER * (there - here).abs();
        if is_there { there + short.copysign(here - there) } else { 0.5 * (here + there) }
    }

    /// The row at the kink that both sides have come to, if they have.
    pub fn kink(&self, over: &Over) -> Option<Spot> {
        let [Some(behind), Some(ahead)] = &self.sides else { return None };
        let is_closed = ahead.place - behind.place <= CLOSED;
        is_closed.then(|| behind.at_kink(over, ahead).unwrap_or(*behind))
    }
}

/// How far from the place `behind` the gap is the same by the parabolas there and `ahead`: by their
/// tangents and one Newton step [m].
fn crossing(behind: &Spot, ahead: &Spot) -> f64 {
    let length = ahead.place - behind.place;
    let on_tangents =
        (behind.gap - ahead.gap + ahead.slope * length) / (ahead.slope - behind.slope);
    let at = |spot: &Spot, way: f64| {
        let slope = spot.slope + way * spot.bend;
        [spot.gap + 0.5 * way * (spot.slope + slope), slope]
    };
    let [a, a_slope] = at(behind, on_tangents);
    let [b, b_slope] = at(ahead, on_tangents - length);
    on_tangents + (a - b) / (b_slope - a_slope)
}
