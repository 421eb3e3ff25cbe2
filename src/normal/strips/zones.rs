//! Loaded zones out of the lobes.

use std::f64::consts::PI;
use std::ops::Range;

use super::solver::StripSolver;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

impl StripSolver {
    /// Hands `nodes` over as the strips of a zone, whose width and place in the list are left to the caller.
    pub(super) fn push_zone(
        &self,
        nodes: Range<usize>,
        contact_modulus: f64,
        strips: &mut Strips,
    ) -> Zone {
        let mut zone: Zone = Zone { first: strips.y.len(), count: nodes.len(), ..Zone::default() };
        for i in nodes {
            let nodes = &self.nodes;
            let pressure = PI * contact_modulus * nodes.pressure[i];
            strips.y.push(nodes.y[i]);
            strips.width.push(nodes.width[i]);
            strips.x.push(nodes.x[i]);
            strips.half_length.push(nodes.half_length[i]);
            strips.pressure.push(pressure);
            strips.u.push(nodes.u[i]);
            zone.length = zone.length.max(2.0 * nodes.half_length[i]);
            zone.max_pressure = zone.max_pressure.max(pressure);
        }
        zone
    }

    /// Hands the lobes over as strips; lobes with a joint are one zone, unless there is a gap at it.
    pub(super) fn emit(&self, contact_modulus: f64, strips: &mut Strips) {
        let n = self.rule.count();
        let mut number = 0;
        while number < self.lobes.len() {
            let begin = number;
            while self.goes_on(number) {
                number += 1;
            }
            number += 1;
            let count = (number - begin) * n;
            if !strips.has_room_for(count) {
                continue;
            }
            let mut zone = self.push_zone(begin * n..number * n, contact_modulus, strips);
            for lobe in &self.lobes[begin..number] {
                let greatest = PI
                    * contact_modulus
                    * greatest_pressure(&self.rule.nodes, |t| self.nodes.pressure[lobe.first + t]);
                zone.max_pressure = zone.max_pressure.max(greatest);
            }
            zone.width = self.cells[self.lobes[number - 1].cell].load_ends[1]
                - self.cells[self.lobes[begin].cell].load_ends[0];
            strips.summarise(&mut zone);
            strips.zones.push(zone);
        }
    }
}

/// Greatest pressure of a lobe with the pressures `q` at `nodes`: the vertex of the parabola of its square, exact on ellipses.
pub(super) fn greatest_pressure<T: Real>(nodes: &[f64], q: impl Fn(usize) -> T) -> T {
    let n = nodes.len();
    let most = (0..n).fold(0, |best, t| if q(t) > q(best) { t } else { best });
    if most == 0 || most == n - 1 {
        return q(most);
    }
    let t = &nodes[most - 1..=most + 1];
    let square = [most - 1, most, most + 1].map(|k| q(k) * q(k));
    let (left, right) = (t[0] - t[1], t[2] - t[1]);
    let slopes = [(square[0] - square[1]) / left, (square[2] - square[1]) / right];
    let bend = (slopes[1] - slopes[0]) / (right - left);
    let slope = slopes[0] - bend * left;
    let vertex = if bend < 0.0 { (slope * -0.5 / bend).within(left, right) } else { T::from(0.0) };
    (square[1] + vertex * (slope + bend * vertex)).max(square[1]).sqrt()
}
