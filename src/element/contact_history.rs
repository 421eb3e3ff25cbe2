//! What the contacts of an element remember between steps, and a step under way.

use super::parameters::RAILS;
use crate::boundary_element::steps::Kept;
use crate::error::ContactError;
use crate::tangential::field::ContactField;

/// What the contacts of an element remember: all that a next step depends on. Tractions are those at
/// the end of the last step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactHistory {
    has_begun: bool,
    rails: [RailHistory; RAILS],
}

/// What the contacts with one rail remember.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::element) struct RailHistory {
    /// Length and width of elements, whose borders lie at whole multiples of them from the wheel
    /// marker along the track and from where the arc of the rail begins; 0 without contact [m].
    pub size: [f64; 2],
    /// The tractions.
    pub kept: Kept,
}

/// Elements for each of those asked for, along or across, beyond which and below which they are
/// doubled and halved [-]: a contact that grows and shrinks again keeps those it has.
const MOST: f64 = 1.7;
const LEAST: f64 = 0.6;

/// Least and greatest size of an element [m].
const SIZES: [f64; 2] = [1e-9, 1.0];

impl ContactHistory {
    /// A wheel that has not rolled on: its contacts begin without tractions. That of a new element
    /// begins with the steady rolling of its first inputs.
    pub fn without_tractions() -> Self {
        Self { has_begun: true, ..Self::default() }
    }

    /// Whether there was a step.
    pub fn has_begun(&self) -> bool {
        self.has_begun
    }

    /// Copies `other` over it, without allocating where there is room.
    pub fn copy_from(&mut self, other: &Self) {
        self.has_begun = other.has_begun;
        for (own, other) in self.rails.iter_mut().zip(&other.rails) {
            own.copy_from(other);
        }
    }

    /// All of it as numbers, to store: [`Self::from_numbers`] gives the same to the bit.
    pub fn to_numbers(&self) -> Vec<f64> {
        let mut numbers = vec![f64::from(u8::from(self.has_begun))];
        for rail in &self.rails {
            numbers.extend(rail.size);
            rail.kept.append_to(&mut numbers);
        }
        numbers
    }

    /// From what [`Self::to_numbers`] gave.
    ///
    /// # Errors
    /// Numbers that are none of a history.
    pub fn from_numbers(numbers: &[f64]) -> Result<Self, ContactError> {
        let found = Self::read(numbers);
        found.ok_or_else(|| {
            let count = numbers.len() as f64;
            ContactError::bad_value("numbers of a history", count, "those that to_numbers gave")
        })
    }

    fn read(numbers: &[f64]) -> Option<Self> {
        let (begun, mut rest) = numbers.split_first()?;
        let mut history = Self { has_begun: *begun > 0.0, ..Self::default() };
        for rail in &mut history.rails {
            let (size, after) = rest.split_first_chunk::<2>()?;
            (rail.kept, rest) = Kept::from_numbers(after)?;
            // Comparisons with what is not a number are false.
            let fits = size.iter().all(|size| (SIZES[0]..=SIZES[1]).contains(size));
            let is_empty = size.iter().all(|size| *size == 0.0) && rail.kept.tractions.is_empty();
            if !(fits || is_empty) {
                return None;
            }
            rail.size = *size;
        }
        let flag = [0.0, 1.0].contains(begun);
        (flag && rest.is_empty()).then_some(history)
    }
}

impl RailHistory {
    /// Nothing acts.
    pub fn clear(&mut self) {
        self.size = [0.0; 2];
        self.kept.clear();
    }

    pub fn copy_from(&mut self, other: &Self) {
        self.size = other.size;
        self.kept.copy_from(&other.kept);
    }

    /// The size of elements where without a history it would be `wanted`: that there is, halved or
    /// doubled where contacts have become much smaller or larger [m].
    pub fn size_for(&self, wanted: [f64; 2]) -> [f64; 2] {
        let mut size = self.size;
        if size.iter().any(|size| *size <= 0.0) {
            return wanted;
        }
        for (size, wanted) in size.iter_mut().zip(wanted) {
            while *size > MOST * wanted && *size > SIZES[0] {
                *size *= 0.5;
            }
            while *size < LEAST * wanted {
                *size *= 2.0;
            }
        }
        size
    }

    /// The tractions, and the size of the elements that they are on [m]: at least the size `size`,
    /// which is that of [`Self::size_for`].
    pub fn on_elements(&self, size: [f64; 2]) -> (Kept, [f64; 2]) {
        let (mut kept, mut own) = (self.kept.clone(), self.size);
        if kept.tractions.is_empty() {
            return (kept, size);
        }
        for axis in 0..2 {
            while own[axis] < size[axis] {
                (kept, own[axis]) = (kept.doubled(axis), 2.0 * own[axis]);
            }
        }
        (kept, own)
    }
}

/// The history of an element, and what is under way.
#[derive(Clone, Debug, Default)]
pub(in crate::element) struct Remembering {
    /// At the end of the last step.
    pub history: ContactHistory,
    /// Length of the step to the evaluation under way; 0 where it belongs to none [s].
    pub duration: f64,
    /// What such a step leaves behind.
    found: [RailHistory; RAILS],
    /// Whether pressures and tractions are wanted, and those of each rail.
    pub is_shown: bool,
    shown: [Option<ContactField>; RAILS],
}

impl Remembering {
    /// Whether forces are those of steady rolling yet, with which the first step begins.
    pub fn is_new(&self) -> bool {
        !self.history.has_begun
    }

    /// Of rail number `k` at the end of the last step.
    pub fn before(&self, k: usize) -> &RailHistory {
        &self.history.rails[k]
    }

    /// Takes it that nothing presses on any rail, until something does.
    pub fn begin(&mut self) {
        self.found.iter_mut().for_each(RailHistory::clear);
        self.shown.fill(None);
    }

    /// Takes over what acts on rail number `k`.
    pub fn leave(&mut self, k: usize, left: RailHistory) {
        self.found[k] = left;
    }

    /// Takes over the pressure and the tractions on rail number `k`.
    pub fn show(&mut self, k: usize, field: ContactField) {
        self.shown[k] = Some(field);
    }

    /// Hands the pressure and the tractions of all rails out.
    pub fn take_shown(&mut self) -> impl Iterator<Item = ContactField> {
        std::mem::take(&mut self.shown).into_iter().flatten()
    }

    /// Takes it that rail number `k` keeps what it had.
    pub fn stay(&mut self, k: usize) {
        self.found[k].copy_from(&self.history.rails[k]);
    }

    /// Makes what the evaluation has left the history.
    pub fn commit(&mut self) {
        self.history.has_begun = true;
        for (own, found) in self.history.rails.iter_mut().zip(&mut self.found) {
            std::mem::swap(own, found);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boundary_element::steps::Window;

    fn history() -> ContactHistory {
        let mut history = ContactHistory::without_tractions();
        let window = Window { first: [-2, 700], count: [3, 2] };
        let tractions =
            vec![[1e8, -2.5], [0.1, 0.2], [0.3, 1e-300], [0.0; 2], [-4.0, 5.0], [6.0; 2]];
        history.rails[1] = RailHistory { size: [2e-4, 3e-4], kept: Kept { window, tractions } };
        history
    }

    #[test]
    fn numbers_give_the_same_and_broken_ones_are_refused() {
        for history in [ContactHistory::default(), history()] {
            let numbers = history.to_numbers();
            assert_eq!(ContactHistory::from_numbers(&numbers).unwrap(), history);
            for cut in 0..numbers.len() {
                assert!(ContactHistory::from_numbers(&numbers[..cut]).is_err(), "{cut}");
            }
            assert!(ContactHistory::from_numbers(&[numbers, vec![0.0]].concat()).is_err());
        }
        let numbers = history().to_numbers();
        for at in 0..numbers.len() {
            for bad in [f64::NAN, f64::INFINITY, -1e300] {
                let mut numbers = numbers.clone();
                numbers[at] = bad;
                // A traction may be any number.
                let is_traction = bad.is_finite() && at >= 13;
                assert_eq!(
                    ContactHistory::from_numbers(&numbers).is_ok(),
                    is_traction,
                    "{at} {bad}"
                );
            }
        }
    }

    #[test]
    fn sizes_stay_until_contacts_are_much_smaller_or_larger() {
        let bits = |size: [f64; 2]| size.map(f64::to_bits);
        let rail = &history().rails[1];
        assert_eq!(bits(rail.size_for([1.3e-4, 4.5e-4])), bits(rail.size));
        let size = rail.size_for([5e-5, 9e-4]);
        assert_eq!(bits(size), bits([0.25 * 2e-4, 2.0 * 3e-4]));
        let (kept, own) = rail.on_elements(size);
        // Those that are to be halved stay.
        assert_eq!(bits(own), bits([2e-4, 2.0 * 3e-4]));
        let moved = RailHistory { size, kept: Kept::default() };
        assert_eq!(bits(moved.size_for([5e-5, 9e-4])), bits(size));
        let force = |kept: &Kept, size: [f64; 2]| {
            kept.tractions.iter().map(|p| p[1]).sum::<f64>() * size[0] * size[1]
        };
        assert!((force(&kept, own) / force(&rail.kept, rail.size) - 1.0).abs() < 1e-12);
        assert_eq!(bits(RailHistory::default().size_for([1e-4, 2e-4])), bits([1e-4, 2e-4]));
    }
}
