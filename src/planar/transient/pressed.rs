//! The normal solution of a state on the elements of the lattice.

use crate::boundary_element::steps::{Lattice, Window};
use crate::error::ContactError;
use crate::material::MaterialPair;
use crate::math::quadrature::GaussLegendre;
use crate::normal::boundary_element::{GridPressure, fill_rows, solve_on_grid};
use crate::normal::{ElementPressure, NormalProblem, Strips, strips_of_rule};
use crate::planar::line::PlanarLine;
use crate::planar::{
    ELEMENT_APPROACH, Indentation, MAX_ZONES, PlanarCase, approach_for, press_together,
};

/// Most elements along or across a contact.
const MAX_ELEMENTS: usize = 1000;

/// The normal solution of a state.
pub struct Pressed {
    /// Its strips.
    pub strips: Strips,
    /// y that those of strips and elements are counted from [m].
    pub contact_y: f64,
    /// Pressure on the elements.
    pub field: ElementPressure,
    /// The elements.
    pub window: Window,
    /// Zones that found no room among the strips.
    pub left_out: usize,
}

/// Elements over the extent of the first state.
pub fn first_lattice(case: &PlanarCase) -> Result<Option<Lattice>, ContactError> {
    let crate::planar::Pressed { strips, contact_y, .. } = press_together(case)?;
    Ok(strips.elements.map(|field| Lattice::through(&field.grid, contact_y)))
}

/// The normal solution of `case` on elements of `lattice`; nothing without contact.
pub fn press_on(lattice: &Lattice, case: &PlanarCase) -> Result<Option<Pressed>, ContactError> {
    let mut line = PlanarLine::new(case.separation);
    let (least, contact_y) = (line.least, line.contact);
    let rule = GaussLegendre::new(strips_of_rule(case.strips));
    let material = MaterialPair::new(case.wheel_material, case.rail_material);
    let probes = std::mem::take(&mut line.probes);
    let mut refused = None;
    let mut found = None;
    // `approach` counts from first touch.
    let mut press = |approach: f64| {
        found = None;
        if approach <= 0.0 || refused.is_some() {
            return 0.0;
        }
        let problem = NormalProblem {
            approach,
            radius: case.radius,
            contact_modulus: material.contact_modulus,
            contact_u: line.contact,
            lateral_curvature: line.curve.at(line.contact).second[1],
            rule: &rule,
            elements: case.elements,
        };
        let mut window = Window::default();
        let grid = |[x, y]: [[f64; 2]; 2]| {
            window = lattice.over([x, y.map(|y| y + contact_y)]);
            for axis in 0..2 {
                if window.count[axis] > MAX_ELEMENTS {
                    let name = ["element_length", "element_width"][axis];
                    let allowed = "a size with at most 1000 elements over the contact";
                    refused = Some(ContactError::bad_value(name, lattice.size[axis], allowed));
                    return None;
                }
            }
            Some(lattice.grid(&window, contact_y))
        };
        let across = case.elements[1];
        match solve_on_grid(&problem, across, &mut line, &probes, grid) {
            GridPressure::None => 0.0,
            GridPressure::Lost => {
                let allowed = "an approach whose pressure is found";
                refused.get_or_insert(ContactError::bad_value("approach", approach, allowed));
                0.0
            }
            GridPressure::Found(field, u) => {
                let load = field.pressure.iter().sum::<f64>() * field.grid.element_area();
                found = Some((field, u, window));
                load
            }
        }
    };
    match case.indentation {
        Indentation::Approach(approach) => {
            press(approach - least);
        }
        Indentation::Load(load) if load > 0.0 => {
            let approach = approach_for(load, ELEMENT_APPROACH, &mut press);
            if let Ok(approach) = approach {
                press(approach);
            }
            if refused.is_none() {
                approach?;
            }
        }
        Indentation::Load(_) => {}
    }
    if let Some(error) = refused {
        return Err(error);
    }
    let Some((field, u, window)) = found else { return Ok(None) };
    let mut strips = Strips::with_capacity(MAX_ZONES, 0);
    let left_out = fill_rows(&mut strips, field.clone(), &u);
    Ok(Some(Pressed { strips, contact_y, field, window, left_out }))
}
