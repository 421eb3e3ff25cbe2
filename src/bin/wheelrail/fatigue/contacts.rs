//! The contacts of a row and what they do to a body.

use std::path::Path;

use anyhow::Result;
use wheelrail::fatigue::{ContactFatigue, Strength};
use wheelrail::planar::PlanarCase;
use wheelrail::subsurface::{Body, SurfaceLoad};
use wheelrail::variables::Values;

use crate::{output, plot};

/// One contact.
pub struct Found {
    /// Row of the table and number of the contact in it, from 1.
    pub row: usize,
    contact: usize,
    /// Number of the rail, from 1; 0 for a planar problem.
    pub rail: i32,
    /// Places along the profiles of wheel and rail [m].
    arcs: [f64; 2],
    pub fatigue: ContactFatigue,
    pub load: SurfaceLoad,
}

impl Found {
    /// Where the contact lies along the profile of `body` [m].
    pub fn arc(&self, body: Body) -> f64 {
        match body {
            Body::Wheel => self.arcs[0],
            Body::Rail => self.arcs[1],
        }
    }
}

/// What the contact of a planar problem does.
pub fn of_planar(
    row: usize,
    case: &PlanarCase<'_>,
    body: Body,
    strength: &Strength,
) -> Result<Option<Found>> {
    let found = ContactFatigue::of(case, body, strength)?;
    Ok(found.map(|(fatigue, load)| {
        let (contact, rail, arcs) = (1, 0, [0.0; 2]);
        Found { row, contact, rail, arcs, fatigue, load }
    }))
}

/// What the contacts of a wheel on rails do, the deepest first; files lie in `folder`.
pub fn at_wheel(
    row: usize,
    values: &Values,
    body: Body,
    strength: &Strength,
    folder: &Path,
) -> Result<Vec<Found>> {
    let Values { parameters, input, .. } = values;
    let mut contacts = plot::all_contacts(values, folder)?;
    contacts.sort_by(|a, b| b.penetration.total_cmp(&a.penetration));
    let speed = input.wheel.velocity[0].abs();
    let mut all = Vec::new();
    for (index, flat) in contacts.iter().enumerate() {
        let case = parameters.flat_case(flat, speed)?;
        let Some((fatigue, load)) = ContactFatigue::of(&case, body, strength)? else { continue };
        let (contact, rail, arcs) = (index + 1, flat.rail, flat.profile_arcs);
        all.push(Found { row, contact, rail, arcs, fatigue, load });
    }
    Ok(all)
}

/// Writes a row for each contact to standard output.
pub fn write(all: &[Found]) -> Result<()> {
    let table = output::table(None)?;
    for Found { row, contact, rail, fatigue, .. } in all {
        let number = |value: f64| format!("{value:.5}");
        let [y, depth] = fatigue.dang_van.place;
        table.write_named(&[
            ("row", row.to_string()),
            ("rail", rail.to_string()),
            ("contact", contact.to_string()),
            ("p0_mpa", format!("{:.3}", 1e-6 * fatigue.max_pressure)),
            ("p0_over_k", number(fatigue.load_factor)),
            ("used_friction", number(fatigue.used_friction)),
            ("elastic_limit", number(fatigue.elastic_limit)),
            ("shakedown_limit", number(fatigue.shakedown_limit)),
            ("response", fatigue.response.name().to_owned()),
            ("surface_index", number(fatigue.surface_index)),
            ("subsurface_index_mpa", format!("{:.3}", 1e-6 * fatigue.subsurface_index)),
            ("dang_van_mpa", format!("{:.3}", 1e-6 * fatigue.dang_van.value)),
            ("dang_van_y_mm", format!("{:.4}", 1e3 * y)),
            ("dang_van_depth_mm", format!("{:.4}", 1e3 * depth)),
        ])?;
    }
    table.finish()
}
