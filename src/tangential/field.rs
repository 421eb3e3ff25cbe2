//! Tractions of a zone element by element, for figures and tables.

use super::boundary_element::LoadedElements;
use super::march::MarchedPart;
use super::neck::{LobeSlip, Lobes};
use super::rigid_slip::FlatSlip;
use super::{LoadedZone, Rolling, RollingState, Tangential, TangentialModel};
use crate::boundary_element::grid::Grid;
use crate::material::MaterialPair;
use crate::normal::{Strips, Zone};

/// Whether the surfaces of an element adhere.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Adherence {
    /// Not in contact, or no tractions asked for.
    #[default]
    None,
    /// They adhere.
    Adhesion,
    /// They slip.
    Slip,
}

/// Pressure and tractions on the elements of a contact.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ContactField {
    /// The elements; y in the contact frame from the contact point.
    pub grid: Grid,
    /// Pressure of each element [Pa].
    pub pressure: Vec<f64>,
    /// Traction (x, y) on the wheel [Pa].
    pub traction: Vec<[f64; 2]>,
    /// Slip of wheel against rail over the rolling speed, if the model has it [-].
    pub slip: Option<Vec<[f64; 2]>>,
    /// Adhesion or slip.
    pub adherence: Vec<Adherence>,
}

impl Tangential {
    /// Pressure and tractions of a zone with one creepage that rolls forward; of all zones where
    /// the normal model has boundary elements. FASTSIM, strips and boundary elements have tractions
    /// to show, the tables and corrected FASTSIM those of FASTSIM without correction, other models
    /// pressure alone.
    #[must_use]
    pub fn field(
        &self,
        zone: &Zone,
        strips: &Strips,
        material: &MaterialPair,
        state: &RollingState,
    ) -> ContactField {
        let law = self.under_law(zone, strips, material, state);
        let state = law.state;
        let elements = LoadedElements::of(zone, strips, self.elements);
        let count = elements.grid.len();
        let mut field = ContactField {
            grid: elements.grid,
            pressure: elements.pressure.clone(),
            traction: vec![[0.0; 2]; count],
            slip: None,
            adherence: vec![Adherence::None; count],
        };
        let friction = state.friction * state.load_factor;
        if friction <= 0.0 || state.creepage.is_zero() {
            return field;
        }
        let slip = FlatSlip { zone, strips, creepage: state.creepage };
        let loaded = LoadedZone::new(zone, strips, &slip, &law);
        let adherence = |slips: bool| if slips { Adherence::Slip } else { Adherence::Adhesion };
        match self.model {
            TangentialModel::BoundaryElement => {
                let found = elements.tractions(&loaded, Rolling::Forward);
                let pairs = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| [*x, *y]).collect();
                field.traction = pairs(&found.x, &found.y);
                field.slip = Some(pairs(&found.slip_x, &found.slip_y));
                for k in (0..count).filter(|&k| field.pressure[k] > 0.0) {
                    field.adherence[k] = adherence(found.slips[k]);
                }
            }
            TangentialModel::Fastsim
            | TangentialModel::FastsimCorrected
            | TangentialModel::Tables => {
                let lobes = Lobes::of(&loaded);
                let limit = state.friction_limit(zone);
                let parts = self.marched_parts(&loaded, lobes.as_ref(), limit);
                for (j, strip) in elements.nearest_strips().enumerate() {
                    let Some(strip) = strip else { continue };
                    if strip < zone.first || strip >= zone.first + zone.count {
                        continue;
                    }
                    // Of a zone with a neck that description which has more weight in the force.
                    let weight = |part: &&MarchedPart<f64>| part.weight(strips.y[strip]);
                    let heavier = |a: &&MarchedPart<f64>, b: &&MarchedPart<f64>| {
                        weight(a).total_cmp(&weight(b))
                    };
                    let Some(part) = parts.iter().flatten().max_by(heavier) else { continue };
                    let slip = LobeSlip { zone: &slip, mean: part.mean };
                    let own = loaded.with_slip(&slip);
                    let marched = self.fastsim.tractions(&own, strip, &part.blended);
                    for i in 0..field.grid.along {
                        let k = j * field.grid.along + i;
                        let t = (strips.x[strip] - field.grid.x(i)) / strips.half_length[strip];
                        let step = 0.5 * (1.0 + t) * marched.len() as f64;
                        if field.pressure[k] > 0.0 {
                            let (traction, slips) =
                                marched[(step.max(0.0) as usize).min(marched.len() - 1)];
                            field.traction[k] = traction;
                            field.adherence[k] = adherence(slips);
                        }
                    }
                }
            }
            TangentialModel::Strips => {
                let Some(solver) = &self.traction_strips else { return field };
                let mut solver = solver.lend();
                let Some(tractions) = solver.tractions(&loaded) else { return field };
                for (j, strip) in elements.nearest_strips().enumerate() {
                    let own = |j: &usize| (zone.first..zone.first + zone.count).contains(j);
                    let Some(strip) = strip.filter(own) else { continue };
                    for i in 0..field.grid.along {
                        let k = j * field.grid.along + i;
                        let t = (field.grid.x(i) - strips.x[strip]) / strips.half_length[strip];
                        if field.pressure[k] > 0.0 {
                            let (share, slips) = tractions(strip - zone.first, t);
                            let bound = loaded.friction_coefficient(strip) * field.pressure[k];
                            field.traction[k] = share.map(|share| share * bound);
                            field.adherence[k] = adherence(slips);
                        }
                    }
                }
            }
            TangentialModel::None | TangentialModel::Linear | TangentialModel::Fastrip => {}
        }
        field
    }
}
