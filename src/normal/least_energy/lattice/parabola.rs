//! The parabola with the moments of an overlap, and the load of the ellipse that it touches in.

use super::super::line::OverlapLine;
use super::super::scales;
use super::Lattice;
use super::lobes::PLACES;
use super::station::{Station, for_pairs};
use crate::math::parabola::{DEPTH_OVER_MEAN, HALF_WIDTH_OVER_INTEGRAL};
use crate::math::real::Real;
use crate::normal::Descent;

/// The parabola with the same integrals of the square and the cube of the overlap.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parabola<T> {
    /// Depth, and half the width [m].
    pub depth: T,
    pub half_width: T,
    /// Place across of the middle of the square of the overlap [m].
    pub y: T,
}

impl<T: Real> Parabola<T> {
    /// That of the overlap at `stations`, which where it is negative is none; nothing where there is
    /// none.
    pub fn of(stations: &[Station<T>]) -> Option<Self> {
        let zero = T::from(0.0);
        let (mut square, mut cube, mut place) = (zero, zero, zero);
        for_pairs(stations, |a, b| {
            let h = (b.y - a.y) * 0.5;
            for station in [a, b] {
                let overlap = station.overlap.at_least(0.0);
                let weight = h * overlap * overlap;
                square += weight;
                cube += weight * overlap;
                place += weight * station.y;
            }
        });
        if !(square.value().is_normal() && cube.value().is_normal()) {
            return None;
        }
        let depth = cube / square * DEPTH_OVER_MEAN;
        let half_width = square / (depth * depth) * HALF_WIDTH_OVER_INTEGRAL;
        Some(Self { depth, half_width, y: place / square })
    }
}

impl Lattice {
    /// Lets the overlap that was taken grow as the wheel goes a `step` down [m]; the force over E*
    /// on the way of `descent` that ellipses in the places of its intervals would have then [m²],
    /// and its derivative by the way [m].
    pub fn lower(&mut self, line: &mut impl OverlapLine, descent: &Descent, step: f64) -> [f64; 2] {
        for station in self.stations.iter_mut() {
            station.overlap += step * descent.cosine(self.samples[station.sample].at.tangent);
        }
        let (mut force, mut stiffness) = (0.0, 0.0);
        for stations in self.stations.chunks_exact(PLACES) {
            let Some(Parabola { depth, half_width, y }) = Parabola::of(stations) else { continue };
            let middle = self.at(y).at;
            let cosine = descent.cosine(middle.tangent);
            let load = scales::load(depth, half_width, line.section(&middle).radius.abs());
            force += load * cosine;
            stiffness += 1.5 * load / depth * cosine * cosine;
        }
        [force, stiffness]
    }
}
