//! Where the wheel meets a row of the rail.

use super::bounds::{Bounds, LARGEST};
use super::deviation::Deviation;
use super::over::{Opposite, Over};
use super::wheel_table::WheelTable;
use crate::geometry::sections::rows::along::Along;
use crate::geometry::sections::rows::met::Met;
use crate::geometry::sections::rows::plane::dot;
use crate::geometry::sections::rows::surface::{RowPoint, Surface};
use crate::math::dual::Dual;
use crate::math::real::Real;

/// Distance of rows over which their places and those of the wheel opposite go on as before [m].
pub(super) const CLOSE: f64 = 3e-3;
/// Steps to the place along a row, the last of them, and the longest [m].
const MAX_STEPS: usize = 20;
/// What is left of it is of the order of its square over the distance of slices: less than
/// rounding.
const LAST_STEP: f64 = 1e-10;
const LONGEST_STEP: f64 = 0.02;
/// Spacing at which a row that is hollow for the wheel is looked through [m].
const SCAN: f64 = 4e-3;

/// What holds at a place of a row.
struct State<T> {
    point: [T; 2],
    direction: [T; 2],
    first: [T; 2],
    /// n · F_x, and about its derivative along the track [1/m].
    g: T,
    bend: T,
    curvature: T,
    drift: T,
    lean: T,
    /// Component of the normal down [-].
    share: T,
    deviation: Deviation<T>,
}

impl<T: Real> State<T> {
    /// The condition of touch at `x` on a row, opposite to a point of the wheel with a `deviation`
    /// there.
    fn new(
        over: &Over<T>,
        p: &RowPoint<T>,
        x: T,
        wheel: &Opposite<T>,
        deviation: Deviation<T>,
    ) -> Self {
        let first = [p.first[0], p.first[1]];
        let across = [p.value[2], p.value[3]];
        let [_, z] = over.in_wheel(p);
        let away = x - wheel.x;
        let radius = away.hypotenuse(z);
        let (sine, cosine) = (away / radius, z / radius);
        let down = radius - z - deviation.raised;
        // D along a direction of the surface: by its height, and by the place of the contact line.
        let [more_along, more_right, more_down] = deviation.slopes;
        let lowered = |v: [T; 2]| {
            dot(v, over.down) * (cosine - 1.0 - more_down)
                - (sine * wheel.advance + more_right) * dot(v, over.right)
        };
        let by_row = lowered(across);
        let along = sine - more_along + lowered(first);
        let normal = wheel.normal;
        let tangent = [normal[1], -normal[0]];
        let share = dot(normal, over.down);
        let drift = dot(tangent, first);
        let rail = dot(normal, p.second) + wheel.curvature * drift * drift;
        Self {
            point: [0, 1].map(|i| p.value[i] + down * over.down[i]),
            direction: [0, 1].map(|i| across[i] + by_row * over.down[i]),
            first: [0, 1].map(|i| first[i] + along * over.down[i]),
            g: dot(normal, first) + share * along,
            bend: rail + share * (cosine * cosine / radius - deviation.bend),
            curvature: rail,
            drift,
            lean: -dot(normal, first),
            share,
            deviation,
        }
    }

    /// What is met at `x` of row `row`, which is at `y` of the wheel, whose curvature along the
    /// track is by `bulge` that of more than its section on the contact line.
    fn met(self, row: usize, x: T, wheel: &Opposite<T>, y: T, bulge: T) -> Met<T> {
        let Self { point, direction, first, curvature, lean, drift, g, deviation, .. } = self;
        let along = Along {
            ahead: x - wheel.x,
            curvature,
            lean,
            drift,
            gap: g,
            raised: deviation.unround,
            lever: deviation.lever,
            bulge: self.share * bulge,
            waves: self.share * deviation.waves,
        };
        Met { row, point, direction, first, x, along, opposite: Some([wheel.u, y]) }
    }
}

/// A rail and the wheel that is looked for.
pub(super) struct Touch<'a> {
    pub surface: &'a Surface,
    pub bounds: &'a Bounds,
    pub wheel: &'a WheelTable,
}

impl Touch<'_> {
    /// Row `j` as it is under the axle; nothing where it is not there.
    pub fn aside(&self, over: &Over, j: usize) -> Option<Met> {
        let run = self.surface.run(j, over.station, over.within.slice)?;
        let [from, to] = over.reach(self.surface, j, run)?;
        let x = 0.0_f64.clamp(from, to);
        let p = over.row(self.surface, j, run, x);
        Some(over.under_axle(j, &p, x))
    }

    /// Where the wheel meets row `j`, from the place `guess` and the row `beside` if there are any;
    /// nothing where the row is not there.
    pub fn meet(
        &self,
        over: &Over,
        j: usize,
        guess: Option<f64>,
        beside: Option<Met>,
        looks_through: bool,
    ) -> Option<Met> {
        let run = self.surface.run(j, over.station, over.within.slice)?;
        let [from, to] = over.reach(self.surface, j, run)?;
        let at = |x: f64| over.row(self.surface, j, run, x);
        let start = guess.unwrap_or(0.0).clamp(from, to);
        let mut x = start;
        let mut p = at(x);
        let [y, _] = over.in_wheel(&p);
        let near = beside.and_then(|b| b.opposite).filter(|[_, own]| (y - own).abs() < CLOSE);
        let near = near.map(|[u, own]| u + y - own);
        let near = near.or_else(|| self.wheel.parameter(y));
        // Where the wheel stands upright, or nothing of it is opposite, the row is as good as beside
        // it, wherever those beside it are met.
        let Some(mut opposite) = near.and_then(|near| over.opposite(near, y)) else {
            return self.aside(over, j);
        };
        let centre = opposite.x;
        if guess.is_none() {
            x = centre.clamp(from, to);
        }
        let mut other = None;
        if looks_through && (self.bounds.is_hollow(j, over.within.ends) || over.is_hollow()) {
            (x, other) = self.valleys(j, run, over, (x, &p), &opposite, [from, to]);
        }
        if (x - start).abs() > 0.0 {
            p = at(x);
            opposite = over.opposite(opposite.u, over.in_wheel(&p)[0]).unwrap_or(opposite);
        }
        let met = self.settle(over, (j, run), x, opposite, [from, to]);
        let Some(x) = other else { return Some(met) };
        // Two valleys about as high: samples do not tell which one is higher.
        opposite = over.opposite(opposite.u, over.in_wheel(&at(x))[0]).unwrap_or(opposite);
        let too = self.settle(over, (j, run), x, opposite, [from, to]);
        let height = |met: &Met| dot(opposite.normal, met.point);
        Some(if height(&too) < height(&met) { too } else { met })
    }

    /// Where the wheel meets row `j` on a `run` of slices `from` one place `to` another one, by
    /// Newton steps from `x` and the point `opposite` to that.
    fn settle(
        &self,
        over: &Over,
        (j, run): (usize, [usize; 2]),
        mut x: f64,
        mut opposite: Opposite,
        [from, to]: [f64; 2],
    ) -> Met {
        let at = |x: f64| over.row(self.surface, j, run, x);
        let state = |p: &RowPoint, x: f64, opposite: &Opposite| {
            let deviation = over.deviation(x, over.in_wheel(p), opposite);
            State::new(over, p, x, opposite, deviation)
        };
        let mut p = at(x);
        let mut met = state(&p, x, &opposite);
        // A chord tells more than what is about the slope, but one across a place where slices bend
        // may lead beyond where the slope has the other sign.
        let (mut behind, mut ahead) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut chord = 0.0;
        for _ in 0..MAX_STEPS {
            let side = if met.g < 0.0 { &mut behind } else { &mut ahead };
            *side = x;
            let towards = |slope: f64| {
                let step = -met.g / slope.max(0.1 / over.nominal_radius());
                x + step.clamp(-LONGEST_STEP, LONGEST_STEP)
            };
            let by_chord =
                Some(towards(chord)).filter(|next| chord > 0.0 && (behind..=ahead).contains(next));
            // Exactly on an end where it is held there.
            let next = by_chord.unwrap_or_else(|| towards(met.bend)).clamp(from, to);
            let moved = next - x;
            if moved == 0.0 {
                break;
            }
            x = next;
            p = at(x);
            opposite = over.opposite(opposite.u, over.in_wheel(&p)[0]).unwrap_or(opposite);
            let before = met.g;
            met = state(&p, x, &opposite);
            if moved.abs() < LAST_STEP {
                break;
            }
            chord = (met.g - before) / moved;
        }
        let place = over.in_wheel(&p);
        let bulge = over.bulge(&met.deviation, place, &opposite);
        met.met(j, x, &opposite, place[0], bulge)
    }

    /// The row that was `found`, as it moves with a round wheel; `fixed` is the same wheel at rest.
    pub fn moving<T: Real>(&self, over: &Over<T>, fixed: &Over<Dual<2>>, found: &Met) -> Met<T> {
        let (j, slice) = (found.row, over.within.slice);
        let mut x = T::from(found.x);
        // Both were there when it was found.
        let Some(run) = self.surface.run(j, over.station.value(), slice) else {
            return over.under_axle(j, &over.row(self.surface, j, [0, 0], x), x);
        };
        let mut is_held = false;
        if let Some(ends) = over.reach(self.surface, j, run)
            && let Some(end) =
                ends.into_iter().find(|end| end.value().to_bits() == found.x.to_bits())
        {
            (x, is_held) = (end, true);
        }
        let Some([u, _]) = found.opposite else {
            return over.under_axle(j, &over.row(self.surface, j, run, x), x);
        };
        let (.., rates) = self.equations(over, j, run, x, u.into());
        let (at_x, at_u) = (Dual::variable(found.x, 0), Dual::variable(u, 1));
        let (.., slopes) = self.equations(fixed, j, run, at_x, at_u);
        let [[a, b], [c, d]] = slopes.map(|equation| equation.slopes);
        let u = if is_held {
            T::moving(u, -rates[0] / b)
        } else {
            let inverse = -1.0 / (a * d - b * c);
            x = T::moving(found.x, (rates[0] * d - rates[1] * b) * inverse);
            T::moving(u, (rates[1] * a - rates[0] * c) * inverse)
        };
        let (p, opposite, state, bulge, _) = self.equations(over, j, run, x, u);
        state.met(j, x, &opposite, over.in_wheel(&p)[0], bulge)
    }

    /// Row `j` at `x`, the point `u` of the wheel, what holds there, by how much the wheel bulges more
    /// there than on its contact line, and what the wheel is beside the row and the slope of their
    /// distance.
    fn equations<T: Real>(
        &self,
        over: &Over<T>,
        j: usize,
        run: [usize; 2],
        x: T,
        u: T,
    ) -> (RowPoint<T>, Opposite<T>, State<T>, T, [T; 2]) {
        let p = over.row(self.surface, j, run, x);
        let [y, _] = over.in_wheel(&p);
        let (opposite, missing) = over.on_line(u, y);
        let (deviation, bulge) = over.round_deviation(x, y, &opposite);
        let state = State::new(over, &p, x, &opposite, deviation);
        let g = state.g;
        (p, opposite, state, bulge, [missing, g])
    }

    /// The sample of row `j` about which it is highest for the wheel, and the one about which it
    /// may be higher still.
    fn valleys(
        &self,
        j: usize,
        run: [usize; 2],
        over: &Over,
        (place, here): (f64, &RowPoint),
        opposite: &Opposite,
        [from, to]: [f64; 2],
    ) -> (f64, Option<f64>) {
        let normal = [-here.value[3], here.value[2]];
        let (centre, [across, below]) = (opposite.x, over.in_wheel(here));
        // No farther than where a wheel stands higher than the row ever rises.
        let own = if over.varies_around() {
            0.0
        } else {
            over.deviation(place, [across, below], opposite).raised
        };
        let rise = (over.height_of(place, here) - own - self.bounds.of(j, over.within.slice).least)
            .max(0.0);
        let far = (2.0 * LARGEST * over.nominal_radius() * rise).sqrt()
            + (place - centre).abs()
            + over.reach_around();
        let [from, to] = [from.max(centre - far).min(to), to.min(centre + far).max(from)];
        let spacing = SCAN.min(self.surface.corrugation.bounds().spacing).min(over.spacing());
        let count = ((to - from) / spacing).ceil().max(1.0) as usize;
        let at = |i: usize| from + (to - from) * i as f64 / count as f64;
        let height = |i: usize| -> f64 {
            let x = at(i);
            let p = over.row(self.surface, j, run, x);
            let [_, z] = over.in_wheel(&p);
            let raised = over.deviation(x, [across, z], opposite).raised;
            let down = (x - centre).hypotenuse(z) - z - raised;
            [0, 1].iter().map(|&i| normal[i] * (p.value[i] + down * over.down[i])).sum()
        };
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
