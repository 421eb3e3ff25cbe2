//! Memory of the solver: the nodes of all lobes, and the matrices over them.

use super::closures::{Closure, OF_LOBE, Run};
use super::pair_sums::{Acting, Column, Sums, Targets};
use crate::math::linear_system;

/// Nodes of all lobes, as columns.
#[derive(Clone, Debug, Default)]
pub struct Nodes {
    /// Lateral coordinate [m].
    pub y: Vec<f64>,
    /// Parameter of the contact line [m], not a number where none is known yet.
    pub u: Vec<f64>,
    /// Derivative of the parameter by y [-].
    pub rate: Vec<f64>,
    /// Place along x and its derivative by y [m, -].
    pub x: Vec<f64>,
    pub x_slope: Vec<f64>,
    /// Unit tangent across.
    pub tangent: Vec<[f64; 2]>,
    /// Overlap and its derivative by y.
    pub overlap: Vec<f64>,
    pub overlap_slope: Vec<f64>,
    /// Radius of the normal section along x [m].
    pub radius: Vec<f64>,
    /// Weight across [m].
    pub width: Vec<f64>,
    /// Shape of the pressure at free edges, sqrt(1 - t²) or one factor of it.
    pub edge_shape: Vec<f64>,
    /// q over π E* over the edge shape [-].
    pub ratio: Vec<f64>,
    /// q over π E*, not below zero [-].
    pub pressure: Vec<f64>,
    /// Half length, above zero [m].
    pub half_length: Vec<f64>,
    /// Number of the lobe.
    pub lobe: Vec<usize>,
    /// Ratios while lobes are laid out anew.
    pub spare: Vec<f64>,
}

impl Nodes {
    /// No nodes, with room for `count`.
    pub fn with_capacity(count: usize) -> Self {
        let column = || Vec::with_capacity(count);
        Self {
            u: column(),
            rate: column(),
            y: column(),
            x: column(),
            x_slope: column(),
            tangent: Vec::with_capacity(count),
            overlap: column(),
            overlap_slope: column(),
            radius: column(),
            width: column(),
            edge_shape: column(),
            ratio: column(),
            pressure: column(),
            half_length: column(),
            lobe: Vec::with_capacity(count),
            spare: column(),
        }
    }

    /// Makes all columns `count` long.
    pub fn resize(&mut self, count: usize) {
        for column in [
            &mut self.u,
            &mut self.rate,
            &mut self.y,
            &mut self.x,
            &mut self.x_slope,
            &mut self.overlap,
            &mut self.overlap_slope,
            &mut self.radius,
            &mut self.width,
            &mut self.edge_shape,
            &mut self.ratio,
            &mut self.pressure,
            &mut self.half_length,
        ] {
            column.resize(count, 0.0);
        }
        self.tangent.resize(count, [1.0, 0.0]);
        self.lobe.resize(count, 0);
    }
}

/// One active lobe: its cell and where its nodes and unknowns begin.
#[derive(Clone, Copy, Debug)]
pub struct Lobe {
    /// Index of the cell.
    pub cell: usize,
    /// First node.
    pub first: usize,
}

/// Matrices of one assembly, and what goes into them.
#[derive(Clone, Debug, Default)]
pub struct Matrices {
    /// Strips that stay where they are, one row at a time: D and its slope d(a D)/da, then those straight across.
    pub d: Vec<f64>,
    pub slope: Vec<f64>,
    pub straight_d: Vec<f64>,
    pub straight_slope: Vec<f64>,
    /// Targets and sums of lobes.
    pub scratch: Box<Scratch>,
    /// The Newton matrix: by columns of [`stride`](linear_system::stride) numbers for lobes, by rows for strips that stay where they are.
    pub newton: Vec<f64>,
    /// Its right side: residuals, then the step.
    pub right: Vec<f64>,
    /// Unknowns that follow others, and rows and columns of the rest.
    pub closures: Vec<Closure>,
    pub runs: Vec<Run>,
    pub columns: Vec<usize>,
}

/// What a row of the Newton matrix is made of, for some nodes at once.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    pub targets: Targets,
    pub acting: Acting,
    pub sums: Sums,
    pub logarithm: Column,
}

impl Matrices {
    /// Most nodes.
    pub fn nodes(&self) -> usize {
        self.d.len()
    }

    /// Room for `lobes` lobes with `nodes` nodes and `unknowns` unknowns in all.
    pub fn new(lobes: usize, nodes: usize, unknowns: usize) -> Self {
        let row = || vec![0.0; nodes];
        Self {
            d: row(),
            slope: row(),
            straight_d: row(),
            straight_slope: row(),
            scratch: Box::default(),
            newton: vec![0.0; linear_system::room(unknowns).max(nodes * nodes)],
            right: vec![0.0; linear_system::stride(unknowns)],
            closures: Vec::with_capacity(OF_LOBE * lobes),
            runs: Vec::with_capacity(OF_LOBE * lobes),
            columns: Vec::with_capacity(unknowns),
        }
    }
}
