//! Pressures and tractions element by element, and contacts laid flat, as dicts of arrays.

use numpy::{PyArray1, PyArrayMethods, ToPyArray};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use wheelrail::element::{Element, FlatContact};
use wheelrail::error::ContactError;
use wheelrail::planar::{Adherence, ContactField, fields};
use wheelrail::variables::Values;

use crate::profile::pairs;

/// A contact with the fields of its zones.
pub struct ContactWithFields {
    contact: FlatContact,
    fields: Vec<ContactField>,
}

/// The contacts of a wheel, deepest first, and its speed over the rail.
///
/// # Errors
/// The input at fault, by its name.
pub fn flat_contacts(
    element: &mut Element,
    values: &mut Values,
) -> Result<(Vec<FlatContact>, f64), ContactError> {
    let Values { input, output, .. } = values;
    element.evaluate(input, output)?;
    input.wheel.position[2] = output.wheel_z;
    let mut contacts = element.flat_contacts(input)?;
    contacts.sort_by(|a, b| b.penetration.total_cmp(&a.penetration));
    Ok((contacts, input.wheel.velocity[0].abs()))
}

/// The same with pressures and tractions.
///
/// # Errors
/// The input at fault, by its name.
pub fn contacts(
    element: &mut Element,
    values: &mut Values,
) -> Result<Vec<ContactWithFields>, ContactError> {
    let (contacts, speed) = flat_contacts(element, values)?;
    contacts
        .into_iter()
        .map(|contact| {
            let fields = fields(&values.parameters.flat_case(&contact, speed)?)?;
            Ok(ContactWithFields { contact, fields })
        })
        .collect()
}

impl ContactWithFields {
    pub fn dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let contact = &self.contact;
        let dict = PyDict::new(py);
        dict.set_item("rail", contact.rail)?;
        dict.set_item("contact_angle", contact.contact_angle)?;
        dict.set_item("position", contact.position.to_pyarray(py))?;
        dict.set_item("radius", contact.radius)?;
        dict.set_item("penetration", contact.penetration)?;
        dict.set_item("creepage", contact.creepage.to_pyarray(py))?;
        dict.set_item("separation", pairs(py, &contact.separation)?)?;
        dict.set_item("wheel", pairs(py, &contact.wheel)?)?;
        dict.set_item("rail_head", pairs(py, &contact.rail_head)?)?;
        let fields: PyResult<Vec<_>> =
            self.fields.iter().map(|field| field_dict(py, field)).collect();
        dict.set_item("fields", fields?)?;
        Ok(dict)
    }
}

/// A field: x and y of the elements, arrays of shape (across, along).
pub fn field_dict<'py>(py: Python<'py>, field: &ContactField) -> PyResult<Bound<'py, PyDict>> {
    let grid = &field.grid;
    let shape = [grid.across, grid.along];
    let dict = PyDict::new(py);
    dict.set_item("x", PyArray1::from_iter(py, (0..grid.along).map(|i| grid.x(i))))?;
    dict.set_item("y", PyArray1::from_iter(py, (0..grid.across).map(|j| grid.y(j))))?;
    dict.set_item("dx", grid.dx)?;
    dict.set_item("dy", grid.dy)?;
    let plane = |values: Vec<f64>| PyArray1::from_vec(py, values).reshape(shape);
    dict.set_item("pressure", plane(field.pressure.clone())?)?;
    for (c, name) in ["traction_x", "traction_y"].into_iter().enumerate() {
        dict.set_item(name, plane(field.traction.iter().map(|t| t[c]).collect())?)?;
    }
    for (c, name) in ["slip_x", "slip_y"].into_iter().enumerate() {
        let slip = field.slip.as_ref().map(|slip| plane(slip.iter().map(|s| s[c]).collect()));
        dict.set_item(name, slip.transpose()?)?;
    }
    let state = |adherence: &Adherence| match adherence {
        Adherence::None => 0u8,
        Adherence::Adhesion => 1,
        Adherence::Slip => 2,
    };
    let states = field.adherence.iter().map(state);
    dict.set_item("adherence", PyArray1::from_iter(py, states).reshape(shape)?)?;
    Ok(dict)
}
