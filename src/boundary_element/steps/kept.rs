//! What is left of the steps before.

use super::lattice::Window;

/// Tractions at the end of a step and the elements that they act on. Displacements follow from
/// them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Kept {
    /// The elements.
    pub window: Window,
    /// Traction (x, y) on the wheel of each, the leading column of each row first [Pa].
    pub tractions: Vec<[f64; 2]>,
}

/// Numbers before the tractions.
const HEAD: usize = 4;
/// Farthest number of an element, and most of them in a row or a column.
const MOST: f64 = 1e9;

impl Kept {
    /// Nothing acts.
    pub fn clear(&mut self) {
        self.window = Window::default();
        self.tractions.clear();
    }

    /// Copies `other` over it, without allocating where there is room.
    pub fn copy_from(&mut self, other: &Self) {
        self.window = other.window;
        self.tractions.clone_from(&other.tractions);
    }

    /// Adds all of it to `numbers`.
    pub fn append_to(&self, numbers: &mut Vec<f64>) {
        numbers.extend(self.window.first.map(|n| n as f64));
        numbers.extend(self.window.count.map(|n| n as f64));
        numbers.extend(self.tractions.iter().flatten());
    }

    /// How many numbers [`append_to`](Self::append_to) adds.
    pub fn numbers(&self) -> usize {
        HEAD + 2 * self.tractions.len()
    }

    /// From what [`append_to`](Self::append_to) added, and what is left of the numbers; nothing
    /// where they are none.
    pub fn from_numbers(numbers: &[f64]) -> Option<(Self, &[f64])> {
        let (head, rest) = numbers.split_first_chunk::<HEAD>()?;
        // Comparisons with what is not a number are false.
        if !head.iter().all(|n| n.abs() <= MOST && n.fract() == 0.0)
            || head[2] < 0.0
            || head[3] < 0.0
        {
            return None;
        }
        let count = [head[2], head[3]].map(|n| n as usize);
        let (tractions, rest) =
            rest.split_at_checked(count[0].checked_mul(count[1])?.checked_mul(2)?)?;
        let (tractions, _) = tractions.as_chunks::<2>();
        if !tractions.iter().flatten().all(|p| p.is_finite()) {
            return None;
        }
        let window = Window { first: [head[0], head[1]].map(|n| n as i64), count };
        Some((Self { window, tractions: tractions.to_vec() }, rest))
    }

    /// The same on elements of twice the size along `axis` (0: x, 1: y), where elements of both sizes
    /// share their borders from coordinate 0 on: forces stay.
    pub fn doubled(&self, axis: usize) -> Self {
        let mut window = self.window;
        let (first, count) = (window.first[axis], window.count[axis] as i64);
        window.first[axis] = first.div_euclid(2);
        let end = (first + count + 1).div_euclid(2);
        window.count[axis] = usize::try_from(end - window.first[axis]).unwrap_or(0);
        let mut tractions = vec![[0.0; 2]; window.count[0] * window.count[1]];
        for (k, p) in self.tractions.iter().enumerate() {
            let mut at = self.window.element(k);
            at[axis] = at[axis].div_euclid(2);
            if let Some(sum) = window.place(at).and_then(|place| tractions.get_mut(place)) {
                *sum = [sum[0] + 0.5 * p[0], sum[1] + 0.5 * p[1]];
            }
        }
        Self { window, tractions }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kept() -> Kept {
        let window = Window { first: [-3, 4], count: [5, 3] };
        let tractions = (0..15).map(|k| [f64::from(k), -0.5 * f64::from(k * k)]).collect();
        Kept { window, tractions }
    }

    #[test]
    fn numbers_give_the_same_and_others_are_refused() {
        let kept = kept();
        let mut numbers = Vec::new();
        kept.append_to(&mut numbers);
        numbers.push(7.0);
        assert_eq!(numbers.len(), kept.numbers() + 1);
        assert_eq!(Kept::from_numbers(&numbers), Some((kept, &[7.0][..])));
        for (at, bad) in [(0, 0.5), (1, 1e300), (2, -1.0), (2, 6.0), (3, f64::NAN), (9, f64::NAN)] {
            let mut numbers = numbers[..numbers.len() - 1].to_vec();
            numbers[at] = bad;
            assert_eq!(Kept::from_numbers(&numbers), None, "{at} {bad}");
        }
    }

    #[test]
    fn doubled_elements_keep_the_force_of_each_pair() {
        let kept = kept();
        for axis in 0..2 {
            let coarse = kept.doubled(axis);
            for (k, p) in coarse.tractions.iter().enumerate() {
                let own = coarse.window.element(k);
                let pair = [0, 1].map(|second| {
                    let mut at = own;
                    at[axis] = 2 * own[axis] + second;
                    kept.window.place(at).map_or([0.0; 2], |place| kept.tractions[place])
                });
                for c in 0..2 {
                    assert!((2.0 * p[c] - pair[0][c] - pair[1][c]).abs() < 1e-12);
                }
            }
            let sum = |kept: &Kept| kept.tractions.iter().map(|p| p[1]).sum::<f64>();
            assert!((2.0 * sum(&coarse) / sum(&kept) - 1.0).abs() < 1e-12);
        }
    }
}
