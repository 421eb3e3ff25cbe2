//! Memory of the solver: the nodes of all lobes, and the matrices over them.

use super::pair_sums::{OWN_COLUMNS, PAIR_COLUMNS};

/// Nodes of all lobes, as columns.
#[derive(Clone, Debug, Default)]
pub struct Nodes {
    /// Lateral coordinate [m].
    pub y: Vec<f64>,
    /// Parameter of the contact line [m], not a number where none is known yet.
    pub u: Vec<f64>,
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

/// Matrices of one assembly; `stride` entries a row.
#[derive(Clone, Debug, Default)]
pub struct Matrices {
    /// D of pairs and its slope d(a D)/da, then those of the own half length.
    pub d: Vec<f64>,
    pub slope: Vec<f64>,
    pub own_d: Vec<f64>,
    pub own_slope: Vec<f64>,
    /// Scratch for columns and rows of whole vectors.
    pub padded: [Vec<f64>; 7],
    pub pairs: [Vec<f64>; PAIR_COLUMNS],
    pub own: [Vec<f64>; OWN_COLUMNS],
    pub logarithm: Vec<f64>,
    /// The Newton matrix.
    pub newton: Vec<f64>,
    /// Its right side: residuals, then the step.
    pub right: Vec<f64>,
}

impl Matrices {
    /// Most nodes.
    pub fn nodes(&self) -> usize {
        self.padded[0].len()
    }

    /// Room for `nodes` nodes, `strips` a lobe, and `unknowns` unknowns.
    pub fn new(strips: usize, nodes: usize, unknowns: usize) -> Self {
        let square = || vec![0.0; nodes * nodes];
        Self {
            d: square(),
            slope: square(),
            own_d: square(),
            own_slope: square(),
            padded: std::array::from_fn(|_| vec![0.0; nodes.next_multiple_of(LANES)]),
            pairs: std::array::from_fn(|_| vec![0.0; nodes]),
            own: std::array::from_fn(|_| vec![0.0; strips]),
            logarithm: vec![0.0; strips],
            newton: vec![0.0; unknowns * unknowns],
            right: vec![0.0; unknowns],
        }
    }
}

/// Numbers in the longest vectors: rows of so many have no remainder, which would be taken one by one.
pub const LANES: usize = 8;
