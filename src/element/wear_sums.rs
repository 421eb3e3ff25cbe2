//! Wear of the wheel and the rails of one element: what a patch wears off goes into the sums along
//! the profiles.

use serde::{Deserialize, Serialize};

use super::output::BodyWear;
use super::parameters::{RAILS, WearDistribution, WearModel, WearParameters};
use crate::geometry::contacts::line_separation::LineSeparation;
use crate::geometry::contacts::line_separation::RailSeparation;
use crate::geometry::contacts::separation::Separation;
use crate::geometry::curves::curve::Curve;
use crate::math::fixed_vec::FixedVec;
use crate::normal::{Strips, Zone};
use crate::tangential::UnderLaw;
use crate::wear::distribution::spread;
use crate::wear::worn_arc::Body;
use crate::wear::{ArcState, StripLoad, WornArc};

/// Most nodes at which the interpenetration of a patch is sampled.
const MAX_NODES: usize = 512;
/// Least and greatest number of cells across a patch; in between they are as wide as those of the
/// sums.
const CELLS: [f64; 2] = [16.0, 80.0];
/// Cells between two strips that share out what both wear off.
const PANEL_CELLS: usize = 4;

/// What wear has to remember: all of it, profiles follow.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct WearState {
    /// Time since the last update of the profiles [s].
    pub clock: f64,
    /// The wheel.
    pub wheel: ArcState,
    /// The rails that there are.
    pub rails: [Option<ArcState>; RAILS],
}

impl WearState {
    /// Copies `other` over it, without allocating if both are of the same element.
    pub fn copy_from(&mut self, other: &Self) {
        self.clock = other.clock;
        self.wheel.copy_from(&other.wheel);
        for (own, other) in self.rails.iter_mut().zip(&other.rails) {
            match (own, other) {
                (Some(own), Some(other)) => own.copy_from(other),
                (own, other) => own.clone_from(other),
            }
        }
    }
}

/// How a zone rolls, as far as wear needs to know.
pub struct ZoneWear {
    /// Its state under the laws of friction.
    pub law: UnderLaw,
    /// Radius of the wheel's normal section along x [m].
    pub section_radius: f64,
    /// Range of the parameter of the contact line [m].
    pub range: [f64; 2],
}

/// Rates and sums of wear.
#[derive(Clone, Debug)]
pub struct WearSums {
    pub parameters: WearParameters,
    /// Time since the last update of the profiles [s].
    pub clock: f64,
    pub wheel: WornArc,
    pub rails: [Option<WornArc>; RAILS],
    /// The curve of the wheel in use, from which its contacts take it over.
    pub wheel_curve: Curve,
    /// Time for which the evaluation under way stands, times the acceleration factor [s]; 0 where
    /// it is none of a step.
    duration: f64,
    /// Dissipation over speed [J/m] and slip area [m²] of each strip.
    dissipation: FixedVec<f64>,
    slip_area: FixedVec<f64>,
    /// Volume rate of wheel and rail in each strip [m³/s].
    rates: FixedVec<[f64; 2]>,
    /// Nodes across the zone: parameter of the contact line and of the rail in use,
    /// interpenetration and worn depth [m].
    nodes: FixedVec<[f64; 2]>,
    interpenetration: FixedVec<f64>,
    worn: FixedVec<f64>,
    shares: FixedVec<f64>,
}

impl WearSums {
    /// No wear yet of these curves.
    pub fn new(
        parameters: &WearParameters,
        strips: usize,
        nominal_radius: f64,
        wheel: &Curve,
        rails: [Option<&Curve>; RAILS],
    ) -> Self {
        let distance = parameters.rail_distance;
        Self {
            parameters: *parameters,
            clock: 0.0,
            wheel: WornArc::new(wheel, Body::Wheel { nominal_radius }),
            rails: rails.map(|rail| rail.map(|rail| WornArc::new(rail, Body::Rail { distance }))),
            wheel_curve: wheel.clone(),
            duration: 0.0,
            dissipation: FixedVec::new(strips),
            slip_area: FixedVec::new(strips),
            rates: FixedVec::new(strips),
            nodes: FixedVec::new(MAX_NODES),
            interpenetration: FixedVec::new(MAX_NODES),
            worn: FixedVec::new(MAX_NODES),
            shares: FixedVec::new(MAX_NODES),
        }
    }

    /// Whether the evaluation under way belongs to a step of time.
    #[inline]
    pub fn is_recording(&self) -> bool {
        self.duration > 0.0
    }

    /// Makes the next evaluation stand for `duration` [s]; 0 ends that.
    pub fn record_for(&mut self, duration: f64) {
        self.duration = duration * self.parameters.acceleration_factor;
    }

    /// Wear of the wheel and of each rail.
    pub fn output(&self) -> (BodyWear, [BodyWear; RAILS]) {
        let of =
            |arc: &WornArc| BodyWear { area: arc.area(), volume: arc.volume(), depth: arc.depth() };
        let rails = [0, 1].map(|k| self.rails[k].as_ref().map_or_else(BodyWear::default, of));
        (of(&self.wheel), rails)
    }

    /// Makes ready for `count` strips.
    pub fn begin_strips(&mut self, count: usize) {
        for column in [&mut self.dissipation, &mut self.slip_area] {
            column.clear();
            column.resize(count, 0.0);
        }
    }

    /// Adds to strip `j` its dissipation over the reference speed [J/m] and area that slips [m²].
    #[inline]
    pub fn add_strip(&mut self, j: usize, dissipation: f64, slip_area: f64) {
        self.dissipation[j] += dissipation;
        self.slip_area[j] += slip_area;
    }

    /// Adds the wear of zone number `index` of `strips`, whose strips were added before, on rail
    /// `k` to the sums.
    pub fn record(
        &mut self,
        k: usize,
        index: usize,
        strips: &Strips,
        state: &ZoneWear,
        separation: &mut LineSeparation,
    ) {
        let zone = strips.zones[index];
        let [wheel, rail] = self.rates(&zone, strips, state);
        if wheel + rail <= 0.0 || self.rails[k].is_none() {
            return;
        }
        // A Hertzian ellipse can be wider than the wheel.
        let [start, end] = state.range;
        let [left, right] = edges(&zone, strips).map(|u| u.clamp(start, end));
        // Neighbours on the same contact line keep to their own half of what lies between.
        let before = index.checked_sub(1).map(|i| edges(&strips.zones[i], strips)[1]);
        let after = strips.zones.get(index + 1).map(|zone| edges(zone, strips)[0]);
        let limits = [
            before.map_or(start, |edge| 0.5 * (edge + left)).max(start).min(left),
            after.map_or(end, |edge| 0.5 * (edge + right)).min(end).max(right),
        ];
        let is_spread = self.parameters.distribution == WearDistribution::Interpenetration
            && self.sample(
                k,
                &zone,
                strips,
                state.section_radius,
                [left, right],
                limits,
                separation,
            );
        if is_spread {
            self.deposit_shares(k, [wheel, rail]);
        } else {
            self.deposit_strips(k, &zone, strips, [left, right], separation);
        }
    }

    /// Fills `rates` with the volume rates of the strips; returns those of the zone, of wheel and
    /// rail [m³/s].
    fn rates(&mut self, zone: &Zone, strips: &Strips, state: &ZoneWear) -> [f64; 2] {
        let WearParameters { model, wheel, rail, .. } = self.parameters;
        let UnderLaw { state: rolling, factors, .. } = &state.law;
        self.rates.clear();
        let mut total = [0.0; 2];
        let own = &self.dissipation[zone.range()];
        let dissipated: f64 = own.iter().map(|d| d.max(0.0)).sum();
        let patch = match model {
            WearModel::BritishRail if dissipated > 0.0 => [&wheel, &rail]
                .map(|law| law.british_rail_rate(dissipated, rolling.speed) / dissipated),
            _ => [0.0; 2],
        };
        for i in 0..zone.count {
            let j = zone.first + i;
            let area = 2.0 * strips.half_length[j] * strips.width[j];
            let dissipation = self.dissipation[j].max(0.0);
            let strip = StripLoad {
                power: dissipation * rolling.speed,
                area,
                slip_share: (self.slip_area[j] / area.max(f64::MIN_POSITIVE)).min(1.0),
                pressure: strips.pressure[j] * rolling.load_factor,
                speed: rolling.speed,
                friction: strips.friction.get(j).map_or(rolling.friction, |own| own.under(factors)),
            };
            let rates = if model == WearModel::BritishRail {
                patch.map(|rate| rate * dissipation)
            } else {
                [&wheel, &rail].map(|law| law.strip_rate(model, &strip))
            };
            total = [total[0] + rates[0], total[1] + rates[1]];
            self.rates.push(rates);
        }
        total
    }

    /// Samples interpenetration and worn depth across a zone and as far beyond as wear may have
    /// widened it, within `limits`, and spreads its wear; false where that leads to nothing.
    #[allow(clippy::too_many_arguments)] // a zone, its place and its neighbours
    fn sample(
        &mut self,
        k: usize,
        zone: &Zone,
        strips: &Strips,
        section_radius: f64,
        [left, right]: [f64; 2],
        limits: [f64; 2],
        separation: &mut LineSeparation,
    ) -> bool {
        let width = right - left;
        if width.is_nan() || width <= 0.0 {
            return false;
        }
        let Self { wheel, rails, nodes, interpenetration, worn, shares, .. } = self;
        let Some(rail) = &rails[k] else { return false };
        let cells = (width / wheel.cell()).clamp(CELLS[0], CELLS[1]).ceil();
        let step = width / cells;
        let edge = [left, right].map(|u| separation.at(u).f);
        // No material is missing beyond the greatest depth: there the region ends.
        let most_worn = wheel.most_pending() + rail.most_pending();
        let mut reach = [0usize; 2];
        if most_worn > 0.0 {
            let most_beyond = (0.25 * MAX_NODES as f64) as usize - 1;
            for (end, sign) in [(0, -1.0), (1, 1.0)] {
                let from = [left, right][end];
                for i in 1..=most_beyond {
                    let u = from + sign * i as f64 * step;
                    let inside = u >= limits[0] && u <= limits[1];
                    let rise = if inside { separation.at(u).f - edge[end] } else { f64::INFINITY };
                    if !rise.is_finite() {
                        break;
                    }
                    reach[end] = i;
                    if rise > most_worn {
                        break;
                    }
                }
            }
        }
        nodes.clear();
        interpenetration.clear();
        worn.clear();
        let count = cells as usize + reach[0] + reach[1];
        let mut shape = EllipseShape { strips, zone, at: 0, edges: [left, right], section_radius };
        for i in 0..=count {
            let place = i as f64 - reach[0] as f64;
            let u = left + place * step;
            let at = separation.at(u);
            if !at.f.is_finite() {
                // A body ends within the patch.
                return false;
            }
            let value = if i < reach[0] {
                (edge[0] - at.f).min(0.0)
            } else if i > reach[0] + cells as usize {
                (edge[1] - at.f).min(0.0)
            } else {
                shape.interpenetration(u)
            };
            let rail_s = separation.last_rail_parameter();
            let depth =
                wheel.pending_depth(wheel.to_base(u)) + rail.pending_depth(rail.to_base(rail_s));
            nodes.push([u, rail_s]);
            interpenetration.push(if value.is_finite() { value } else { -1.0 });
            worn.push(depth);
        }
        spread(interpenetration, worn, shares)
    }

    /// Adds the wear of a zone, rates of wheel and rail [m³/s], by the shares of its nodes.
    fn deposit_shares(&mut self, k: usize, rates: [f64; 2]) {
        let volumes = rates.map(|rate| rate * self.duration);
        let Self { wheel, rails, nodes, shares, .. } = self;
        let Some(rail) = &mut rails[k] else { return };
        let mut last = [wheel.to_base(nodes[0][0]), rail.to_base(nodes[0][1])];
        for (share, node) in shares.iter().zip(&nodes[1..]) {
            let next = [wheel.to_base(node[0]), rail.to_base(node[1])];
            wheel.deposit(last[0], next[0], share * volumes[0]);
            rail.deposit(last[1], next[1], share * volumes[1]);
            last = next;
        }
    }

    /// Adds the wear of each strip of a zone where it lies: most of it there, less and less towards the
    /// strips beside it.
    fn deposit_strips(
        &mut self,
        k: usize,
        zone: &Zone,
        strips: &Strips,
        [left, right]: [f64; 2],
        separation: &mut LineSeparation,
    ) {
        let duration = self.duration;
        let Self { wheel, rails, rates, .. } = self;
        let Some(rail) = &mut rails[k] else { return };
        // Places of strip `i` and of its neighbours; the edges before the first and behind the last.
        let place = |i: usize| match i {
            0 => left,
            i if i > zone.count => right,
            i => strips.u[zone.first + i - 1].clamp(left, right),
        };
        let mut last = [wheel.to_base(left), rail.to_base(separation.rail_parameter(left))];
        for panel in 0..=zone.count {
            let start = last;
            let [before, from, to, behind] =
                [panel.saturating_sub(1), panel, panel + 1, panel + 2].map(place);
            // What the strips at both ends of the panel put on it.
            let share = |own: f64, other: f64| if own > 0.0 { own / (own + other) } else { 0.0 };
            let shares = [share(to - from, from - before), share(to - from, behind - to)];
            let volumes = [panel.checked_sub(1), Some(panel)].map(|strip| {
                let rate = strip.and_then(|strip| rates.get(strip)).copied().unwrap_or_default();
                rate.map(|rate| rate * duration)
            });
            let stop = [wheel.to_base(to), rail.to_base(separation.rail_parameter(to))];
            for cell in 0..PANEL_CELLS {
                let [begin, end] = [cell, cell + 1].map(|k| k as f64 / PANEL_CELLS as f64);
                // Of a hat that rises from one end of the panel to the other.
                let rising = end * end - begin * begin;
                let falling = 2.0 * (end - begin) - rising;
                let of = |body: usize| {
                    shares[0] * falling * volumes[0][body] + shares[1] * rising * volumes[1][body]
                };
                let next = [0, 1].map(|body| start[body] + (stop[body] - start[body]) * end);
                wheel.deposit(last[0], next[0], of(0));
                rail.deposit(last[1], next[1], of(1));
                last = next;
            }
        }
    }
}

/// Parameters of the contact line at the edges of a zone [m].
fn edges(zone: &Zone, strips: &Strips) -> [f64; 2] {
    let [left, right] = strips.edges(zone);
    let (first, last) = (zone.first, zone.first + zone.count - 1);
    // Per lateral distance, over the outermost strips at either end.
    let rate = |a: usize, b: usize| {
        let rate = (strips.u[b] - strips.u[a]) / (strips.y[b] - strips.y[a]);
        if rate.is_finite() && rate > 0.0 { rate } else { 1.0 }
    };
    let inner = (first + 1).min(last);
    let outer = last.saturating_sub(1).max(first);
    [
        strips.u[first] - (strips.y[first] - left).max(0.0) * rate(first, inner),
        strips.u[last] + (right - strips.y[last]).max(0.0) * rate(outer, last),
    ]
}

/// Interpenetration function within a zone as its strips have it, g = `half_length²`/(2 R), asked
/// for at growing places.
struct EllipseShape<'a> {
    strips: &'a Strips,
    zone: &'a Zone,
    /// Number of strips passed.
    at: usize,
    edges: [f64; 2],
    section_radius: f64,
}

impl EllipseShape<'_> {
    fn interpenetration(&mut self, u: f64) -> f64 {
        let Zone { first, count, .. } = *self.zone;
        while self.at < count && self.strips.u[first + self.at] <= u {
            self.at += 1;
        }
        let node = |i: usize| {
            let j = first + i;
            [self.strips.u[j], self.strips.half_length[j].powi(2) / (2.0 * self.section_radius)]
        };
        let before = if self.at == 0 { [self.edges[0], 0.0] } else { node(self.at - 1) };
        let after = if self.at == count { [self.edges[1], 0.0] } else { node(self.at) };
        let length = after[0] - before[0];
        if length <= 0.0 {
            return 0.5 * (before[1] + after[1]);
        }
        let share = ((u - before[0]) / length).clamp(0.0, 1.0);
        before[1] + share * (after[1] - before[1])
    }
}
