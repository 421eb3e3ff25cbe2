//! What a contact remembers between steps.

use crate::boundary_element::steps::{Kept, Lattice};
use crate::error::ContactError;
use crate::material::Material;

/// Tractions at the end of a step and the elements that they act on: all that the next step depends
/// on. Displacements follow from them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    /// Elements of all steps; none before the first contact without given sizes.
    pub(super) lattice: Option<Lattice>,
    /// Materials of wheel and rail, from the first step on.
    pub(super) materials: Option<[Material; 2]>,
    /// The tractions.
    pub(super) kept: Kept,
}

/// Numbers before those of the tractions.
const HEAD: usize = 10;

impl History {
    /// All of it as numbers, to store: [`Self::from_numbers`] gives the same to the bit.
    pub fn to_numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::with_capacity(HEAD + self.kept.numbers());
        numbers.push(f64::from(u8::from(self.lattice.is_some())));
        let Lattice { size, origin } =
            self.lattice.unwrap_or(Lattice { size: [0.0; 2], origin: [0.0; 2] });
        numbers.extend([size[0], size[1], origin[0], origin[1]]);
        numbers.push(f64::from(u8::from(self.materials.is_some())));
        let none = Material { young_modulus: 0.0, poisson_ratio: 0.0 };
        for material in self.materials.unwrap_or([none; 2]) {
            numbers.extend([material.young_modulus, material.poisson_ratio]);
        }
        self.kept.append_to(&mut numbers);
        numbers
    }

    /// From what [`Self::to_numbers`] gave.
    ///
    /// # Errors
    /// Numbers that are none of a history.
    pub fn from_numbers(numbers: &[f64]) -> Result<Self, ContactError> {
        let refused =
            |value: f64| ContactError::bad_value("history", value, "numbers of a history");
        if let Some(value) = numbers.iter().find(|value| !value.is_finite()) {
            return Err(refused(*value));
        }
        let (Some(head), Some(rest)) = (numbers.get(..HEAD), numbers.get(HEAD..)) else {
            return Err(refused(numbers.len() as f64));
        };
        let Some((kept, [])) = Kept::from_numbers(rest) else {
            return Err(refused(numbers.len() as f64));
        };
        let lattice = Lattice { size: [head[1], head[2]], origin: [head[3], head[4]] };
        let has_lattice = head[0] > 0.0;
        if has_lattice && !(lattice.size[0] > 0.0 && lattice.size[1] > 0.0) {
            return Err(refused(lattice.size[0].min(lattice.size[1])));
        }
        let material =
            |at: usize| Material { young_modulus: head[at], poisson_ratio: head[at + 1] };
        Ok(Self {
            lattice: has_lattice.then_some(lattice),
            materials: (head[5] > 0.0).then(|| [material(6), material(8)]),
            kept,
        })
    }
}
