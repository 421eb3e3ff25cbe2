//! Loaded zones out of the loads of the nodes.

use std::f64::consts::PI;

use super::equations::{Strip, loaded_part};
use super::grid::Grid;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// The solution on a grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct Loads<'a, T = f64> {
    pub grid: &'a Grid<T>,
    /// z, which is the load per width over the contact modulus where it is positive [m], and χ, at
    /// each node.
    pub z: &'a [T],
    pub shapes: &'a [T],
}

impl<T: Real> Loads<'_, T> {
    /// Hands neighbouring loaded nodes over as the strips of a zone; returns the number of zones
    /// that found no room.
    pub fn emit(&self, contact_modulus: f64, strips: &mut Strips<T>) -> usize {
        let nodes = &self.grid.nodes;
        let is_loaded = |i: usize| self.z[i] > 0.0;
        let parts = |i: usize| self.parts(i);
        let mut left_out = 0;
        let mut begin = 0;
        while begin < nodes.len() {
            if !is_loaded(begin) {
                begin += 1;
                continue;
            }
            let mut end = begin + 1;
            while end < nodes.len() && is_loaded(end) && nodes[end - 1].neighbours[1].is_some() {
                end += 1;
            }
            let (first, count) = (begin, end - begin);
            begin = end;
            if !strips.has_room_for(count) {
                left_out += 1;
                continue;
            }
            let mut zone: Zone<T> = Zone { first: strips.y.len(), count, ..Zone::default() };
            for i in first..end {
                let node = &nodes[i];
                // Without the least half length of the equations: strips that begin to carry load
                // come out of nothing.
                let strip = Strip::new(self.z[i], (-self.shapes[i]).exp(), T::from(0.0));
                let length = strip.half_length;
                strips.y.push(node.y);
                // Half of the loaded parts of both cells: a line to the edge holds half of its
                // height.
                strips.width.push(parts(i).into_iter().sum::<T>() * 0.5);
                strips.x.push(node.place.x);
                strips.half_length.push(length);
                strips.pressure.push(strip.load / length * (2.0 / PI * contact_modulus));
                strips.u.push(node.place.u);
                zone.length = zone.length.max(length * 2.0);
            }
            strips.summarise(&mut zone);
            zone.max_pressure = self.greatest_pressure(first, end) * contact_modulus;
            let [area, width] = self.extent(first, end, [parts(first)[0], parts(end - 1)[1]]);
            (zone.area, zone.width) = (area, width);
            strips.zones.push(zone);
        }
        left_out
    }

    /// Load per width at the node on a side of node `i`; none where there is no node.
    fn beside(&self, i: usize, side: usize) -> T {
        self.grid.nodes[i].neighbours[side].map_or(T::from(0.0), |k| self.z[k].at_least(0.0))
    }

    /// Lengths of the loaded parts of both cells beside node `i`, which carries load.
    fn parts(&self, i: usize) -> [T; 2] {
        let node = &self.grid.nodes[i];
        [0, 1].map(|side| {
            let other = node.neighbours[side].map_or(T::from(0.0), |k| self.z[k]);
            let [_, [part, ..]] = loaded_part(self.z[i], other);
            part * (node.reach[side] - node.y).abs()
        })
    }

    /// Greatest pressure over the contact modulus of the nodes from `first` to `end`: the vertex of
    /// the parabola of its square, exact on ellipses.
    ///
    /// Linear elements that meet a concave load in their nodes lie above it by a twelfth of its
    /// second difference, so that they hold as much.
    fn greatest_pressure(&self, first: usize, end: usize) -> T {
        let square = |i: usize| {
            let node = &self.grid.nodes[i];
            let [left, right] = [node.y - node.reach[0], node.reach[1] - node.y];
            let own = self.z[i];
            let slopes = [(own - self.beside(i, 0)) / left, (self.beside(i, 1) - own) / right];
            let bend = (slopes[1] - slopes[0]) * 2.0 / (left + right);
            // Where a body ends a node may carry load that has a neighbour on one side only.
            let is_inner = left > 0.0 && right > 0.0;
            let excess = if is_inner { bend.at_most(0.0) * left * right } else { T::from(0.0) };
            let load = own + excess * (1.0 / 12.0);
            load.at_least(0.0) * self.shapes[i].exp() * (2.0 / PI)
        };
        let most =
            (first..end).fold(first, |best, i| if square(i) > square(best) { i } else { best });
        let middle = square(most);
        if most == first || most + 1 == end {
            return middle.sqrt();
        }
        let y = |i: usize| self.grid.nodes[i].y;
        let (left, right) = (y(most - 1) - y(most), y(most + 1) - y(most));
        let slopes = [(square(most - 1) - middle) / left, (square(most + 1) - middle) / right];
        let bend = (slopes[1] - slopes[0]) / (right - left);
        let slope = slopes[0] - bend * left;
        let vertex = if bend < 0.0 { slope * -0.5 / bend } else { T::from(0.0) };
        (middle + vertex * (slope + bend * vertex)).max(middle).sqrt()
    }

    /// Area and width of the nodes from `first` to `end`, with the loaded parts of the outer cells:
    /// the square of the half length is linear between nodes and to the edges.
    fn extent(&self, first: usize, end: usize, parts: [T; 2]) -> [T; 2] {
        let nodes = &self.grid.nodes;
        let square = |i: usize| self.z[i] * (-self.shapes[i]).exp() * (2.0 / PI);
        let mut area = T::from(0.0);
        for i in first..end - 1 {
            let (p, q) = (square(i), square(i + 1));
            let (a, b) = (p.sqrt(), q.sqrt());
            area += (nodes[i + 1].y - nodes[i].y) * (p + a * b + q) / (a + b) * (4.0 / 3.0);
        }
        for (part, outer) in parts.into_iter().zip([first, end - 1]) {
            area += part * square(outer).sqrt() * (4.0 / 3.0);
        }
        [area, nodes[end - 1].y - nodes[first].y + parts[0] + parts[1]]
    }
}
