//! What passages do to a body, place by place over its profile and down.

use super::dang_van::{DangVan, Undergone};
use super::strength::Strength;
use crate::error::ContactError;
use crate::subsurface::SurfaceLoad;

/// Sums over passages at places of a cross section, over the arc of the profile and the depth below
/// it: the section laid flat, as each contact is.
#[derive(Clone, Debug, PartialEq)]
pub struct FatigueMap {
    arcs: Vec<f64>,
    depths: Vec<f64>,
    strength: Strength,
    cells: Vec<Cell>,
}

/// What one place has gone through.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Cell {
    /// Greatest equivalent stress of Dang Van of a passage; 0 where none came near [Pa].
    pub dang_van: f64,
    /// Greatest shear stress on planes parallel to the surface [Pa].
    pub shear: f64,
    /// Passages whose equivalent stress was beyond that which is endured; 0 where it is not known.
    pub beyond_endurance: f64,
    /// Passages with shear beyond k, in which the material yields whatever residual stresses it has.
    pub plastic: f64,
}

/// What one passage does to the places near it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Passage {
    places: Vec<(usize, Undergone)>,
}

/// How far beyond a patch places count as near, over its greatest extent: stresses fall with the square
/// of the distance.
const REACH: f64 = 1.0;

impl FatigueMap {
    /// No passages so far, at `arcs` along the profile and `depths` ≥ 0 [m].
    ///
    /// # Errors
    /// A number or a strength that is not admitted.
    pub fn new(arcs: Vec<f64>, depths: Vec<f64>, strength: Strength) -> Result<Self, ContactError> {
        strength.check()?;
        if let Some(arc) = arcs.iter().find(|arc| !arc.is_finite()) {
            return Err(ContactError::bad_value("arc", *arc, "a length in metres"));
        }
        if let Some(depth) = depths.iter().find(|depth| !(0.0..=1.0).contains(*depth)) {
            return Err(ContactError::bad_value("depth", *depth, "a depth in metres, 0 to 1"));
        }
        let cells = vec![Cell::default(); arcs.len() * depths.len()];
        Ok(Self { arcs, depths, strength, cells })
    }

    /// Places along the profile [m].
    pub fn arcs(&self) -> &[f64] {
        &self.arcs
    }

    /// Depths below the profile [m].
    pub fn depths(&self) -> &[f64] {
        &self.depths
    }

    /// All places, the depth innermost.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// What a passage of `load` does, whose origin lies at the place `arc` of the profile [m].
    pub fn passage(&self, load: &SurfaceLoad, arc: f64) -> Passage {
        let (Some([x, y]), Some(judged)) = (load.extent(), DangVan::new(load, &self.strength))
        else {
            return Passage::default();
        };
        let reach = REACH * (x[1] - x[0]).max(y[1] - y[0]);
        let near = self.arcs.iter().enumerate().filter(|&(_, own)| {
            let across = own - arc;
            across > y[0] - reach && across < y[1] + reach
        });
        let places = near.flat_map(|(i, own)| {
            let judged = &judged;
            self.depths.iter().enumerate().map(move |(j, depth)| {
                (i * self.depths.len() + j, judged.undergone([own - arc, *depth]))
            })
        });
        Passage { places: places.collect() }
    }

    /// Adds so many equal passages, ≥ 0.
    ///
    /// # Errors
    /// A number of passages that is not admitted.
    pub fn add(&mut self, passage: &Passage, passages: f64) -> Result<(), ContactError> {
        if !(passages.is_finite() && passages >= 0.0) {
            return Err(ContactError::bad_value("passages", passages, "a number, 0 or greater"));
        }
        if passages == 0.0 {
            return Ok(());
        }
        let Strength { shear_yield, endurance, .. } = self.strength;
        for &(place, Undergone { equivalent, shear }) in &passage.places {
            let cell = &mut self.cells[place];
            cell.dang_van = cell.dang_van.max(equivalent);
            cell.shear = cell.shear.max(shear);
            if endurance.is_some_and(|endured| equivalent > endured) {
                cell.beyond_endurance += passages;
            }
            if shear > shear_yield {
                cell.plastic += passages;
            }
        }
        Ok(())
    }
}
