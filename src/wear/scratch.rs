//! Memory for an update of a worn profile.

use crate::geometry::curves::curve::Knot;

/// Memory for an update: all of it is filled before it is read.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    /// Weights of the smoothing kernel.
    pub(super) kernel: Vec<f64>,
    /// Smoothed totals, and the depth that they give, in each cell [m³/m, m].
    pub(super) smoothed: Vec<f64>,
    pub(super) depths: Vec<f64>,
    /// A spline through the depths: its knots, its system and its slopes.
    pub(super) middles: Vec<f64>,
    pub(super) rows: Vec<[f64; 4]>,
    pub(super) slopes: Vec<f64>,
    /// Depth and its derivative at each knot of the worn curve, and those knots.
    pub(super) at_knots: Vec<[f64; 2]>,
    pub(super) knots: Vec<Knot>,
}

impl Scratch {
    /// Room for that many cells and knots of the worn curve.
    pub fn new(cells: usize, knots: usize) -> Self {
        let numbers = || Vec::with_capacity(cells);
        Self {
            kernel: numbers(),
            smoothed: numbers(),
            depths: numbers(),
            middles: numbers(),
            rows: Vec::with_capacity(cells),
            slopes: numbers(),
            at_knots: Vec::with_capacity(knots),
            knots: Vec::with_capacity(knots),
        }
    }
}
