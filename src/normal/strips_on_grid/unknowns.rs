//! The unknowns of Newton's method, and the loads on strips and cells that they mean.

use super::equations::{CellLoad, Strip, length_per_pressure};
use super::grid::Grid;
use super::scales::Scales;
use crate::math::fixed_vec::FixedVec;

/// The unknowns: z at the nodes and χ at the knots.
#[derive(Clone, Debug)]
pub(super) struct Unknowns {
    pub z: FixedVec<f64>,
    pub shape: Vec<f64>,
    /// χ and 1/c at the nodes, and their strips.
    pub shapes: FixedVec<f64>,
    length_per_pressure: FixedVec<f64>,
    pub strips: FixedVec<Strip>,
    /// Loads of the cells, their strips, and the derivatives of the logarithms of half lengths by z
    /// and χ at both ends.
    pub cells: Vec<CellLoad>,
    pub cell_strips: Vec<Strip>,
    pub cell_lengths: Vec<[[f64; 2]; 2]>,
}

impl Unknowns {
    /// Memory for up to `nodes` nodes, `knots` knots and `cells` cells.
    pub fn new(nodes: usize, knots: usize, cells: usize) -> Self {
        Self {
            z: FixedVec::new(nodes),
            shape: vec![0.0; knots],
            shapes: FixedVec::new(nodes),
            length_per_pressure: FixedVec::new(nodes),
            strips: FixedVec::new(nodes),
            cells: vec![CellLoad::default(); cells],
            cell_strips: vec![Strip::default(); cells],
            cell_lengths: vec![[[0.0; 2]; 2]; cells],
        }
    }

    /// The ellipse, cut to the overlap.
    pub fn start(&mut self, grid: &Grid, scales: &Scales) {
        self.z.clear();
        self.z.extend(grid.nodes.iter().map(|node| {
            let level =
                (node.place.overlap / grid.samples.depth - scales.level) / (1.0 - scales.level);
            scales.load * level.max(-1.0)
        }));
        self.shape.fill(scales.shape);
    }

    /// Loads, shapes and strips of the present unknowns.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn place(&mut self, grid: &Grid, scales: &Scales) {
        self.shapes.clear();
        self.shapes.extend(grid.nodes.iter().map(|node| node.between.value(&self.shape)));
        self.length_per_pressure.clear();
        self.length_per_pressure.extend(self.shapes.iter().map(|shape| (-shape).exp()));
        self.strips.clear();
        self.strips.extend(self.z.iter().zip(self.length_per_pressure.iter()).map(
            |(&z, &length_per_pressure)| {
                Strip::new(z.max(0.0), length_per_pressure, scales.least_square)
            },
        ));
        for (c, cell) in grid.cells.iter().enumerate() {
            let load = CellLoad::new(cell.nodes.map(|node| self.end(node, scales)));
            let [per_pressure, by_z, by_shape] = self.length_per_pressure_between(cell.nodes);
            let strip = Strip::new(load.weighted, per_pressure[0], scales.least_square);
            let by_per_pressure = strip.length_by_load * load.weighted / per_pressure[0];
            self.cell_lengths[c] = [0, 1].map(|end| {
                let by_load = strip.length_by_load * load.slopes[end][1];
                [by_load + by_per_pressure * by_z[end], by_per_pressure * by_shape[end]]
            });
            (self.cells[c], self.cell_strips[c]) = (load, strip);
        }
    }

    /// z at an end of a cell; before and behind an overlap nothing is loaded.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn end(&self, node: Option<usize>, scales: &Scales) -> f64 {
        node.map_or(-scales.load, |j| self.z[j])
    }

    /// 1/c between two nodes, and its derivatives by z and by χ of both.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn length_per_pressure_between(&self, nodes: [Option<usize>; 2]) -> [[f64; 2]; 3] {
        let of = |node: Option<usize>| {
            node.map_or([0.0; 2], |j| [self.z[j].max(0.0), self.length_per_pressure[j]])
        };
        let [a, b] = nodes.map(of);
        let [mean, share] = length_per_pressure(a, b);
        let squares = a[0] * a[0] + b[0] * b[0];
        let by_z = if squares > 0.0 {
            [2.0 * a[0] * (a[1] - mean) / squares, 2.0 * b[0] * (b[1] - mean) / squares]
        } else {
            [0.0; 2]
        };
        // Rows without load have some 1/c too.
        let mean = if mean > 0.0 { mean } else { 1.0 };
        [[mean; 2], by_z, [-share * a[1], (share - 1.0) * b[1]]]
    }
}
