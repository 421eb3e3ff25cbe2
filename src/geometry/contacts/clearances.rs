//! Bounds of where a wheel can touch a rail that varies along the track, piece by piece of it.

use super::clearance::Clearance;
use crate::geometry::curves::curve::Curve;
use crate::geometry::rail::varying_rail::VaryingRail;

/// Length of a piece [m], and most pieces: of a longer rail they are longer.
const LENGTH: f64 = 0.25;
const MOST: f64 = 32.0;

/// A bound for each piece of a rail; one for an even rail.
#[derive(Clone, Debug)]
pub struct Clearances {
    pieces: Vec<Clearance>,
    /// Station of the first one, and the length of each [m].
    start: f64,
    length: f64,
}

impl Clearances {
    /// Those of an even rail.
    pub fn even(own: Clearance) -> Self {
        Self { pieces: vec![own], start: 0.0, length: LENGTH }
    }

    /// Those of a rail that varies, whose bound as an even one is `own`, and how far a piece of it
    /// reaches beyond the sides of that at most [m].
    pub fn along(own: &Clearance, rail: &VaryingRail) -> (Self, f64) {
        let [start, end] = rail.stations();
        let length = ((end - start) / MOST).max(LENGTH);
        let count = ((end - start) / length).ceil() as usize;
        let mut wider = 0.0_f64;
        let pieces = (0..count.max(1)).map(|k| {
            let start = start + length * k as f64;
            let mut piece = own.clone();
            wider = wider.max(piece.raise(rail.faces_near([start, start + length])));
            piece
        });
        (Self { pieces: pieces.collect(), start, length }, wider)
    }

    /// That of a wheel above `station` [m].
    pub fn at(&self, station: f64) -> &Clearance {
        &self.pieces[self.piece(station)]
    }

    /// The same, to be changed.
    pub fn at_mut(&mut self, station: f64) -> &mut Clearance {
        let piece = self.piece(station);
        &mut self.pieces[piece]
    }

    fn piece(&self, station: f64) -> usize {
        // Before the start it is the first one.
        (((station - self.start) / self.length) as usize).min(self.pieces.len() - 1)
    }

    /// As [`Clearance::put_curves`].
    pub fn put_curves(&mut self, wheel: &Curve, rail: &Curve) {
        self.pieces.iter_mut().for_each(|piece| piece.put_curves(wheel, rail));
    }

    /// As [`Clearance::reserve`].
    pub fn reserve(&mut self, further: f64) {
        self.pieces.iter_mut().for_each(|piece| piece.reserve(further));
    }

    /// As [`Clearance::lower`]; how far any piece then reaches beyond its sides at most [m].
    pub fn lower(&mut self, sides: &(impl Iterator<Item = [[f64; 2]; 2]> + Clone)) -> f64 {
        let wider = self.pieces.iter_mut().map(|piece| piece.lower(sides.clone()));
        wider.fold(0.0, f64::max)
    }
}
