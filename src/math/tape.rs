//! Numbers that write down how they were found, for derivatives backwards: those of one number by
//! all that it depends on, for the price of a few evaluations however many these are.
//!
//! A [`Taped`] number is a value and a place on the tape. Each operation enters what the result is
//! by its operands; constants leave no trace. [`Tape::sweep`] then goes back from the end: with ā
//! the derivative by number a,
//!
//! ```text
//! ā += r̄ ∂r/∂a   for each result r and its operands a
//! ```
//!
//! The tape of a thread is empty but while an evaluation is recorded ([`Tape::record`]), which lends
//! it the memory of its caller.

mod taped;

use std::cell::RefCell;
use std::mem::ManuallyDrop;

use super::real::Leaf;
pub use taped::Taped;

/// What a result is by one of its operands.
#[derive(Clone, Copy, Debug)]
struct Operand {
    place: u32,
    slope: f64,
}

/// A number by at most two operands, which most are; of others the first place is [`MANY`] and the
/// second one that of their operands among all of those.
#[derive(Clone, Copy, Debug)]
struct Entry {
    places: [u32; 2],
    slopes: [f64; 2],
}

/// In the place of the first operand: there are more than two.
const MANY: u32 = u32::MAX;

const LEAF: Entry = Entry { places: [0; 2], slopes: [0.0; 2] };

/// A look at a curve: the places of (y, z), of their first and of their second derivatives begin at
/// `first`.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Address of the piece of the curve.
    pub piece: usize,
    /// Distance from its start [m].
    pub distance: f64,
    first: u32,
}

/// Unknowns x of linear equations H x = -g, of which H does not count as moving.
#[derive(Clone, Copy, Debug)]
struct System {
    /// Place of the first unknown.
    first: u32,
    /// The places of g in `rights`.
    rights: [usize; 2],
}

/// What was recorded.
#[derive(Clone, Debug, Default)]
pub struct Tape {
    entries: Vec<Entry>,
    /// Operands of those that have many, and from where to where each of these has its own.
    operands: Vec<Operand>,
    ranges: Vec<[usize; 2]>,
    looks: Vec<Look>,
    systems: Vec<System>,
    rights: Vec<u32>,
    /// Derivatives by all numbers, of the last sweep.
    slopes: Vec<f64>,
}

thread_local! {
    /// Never dropped: a thread that outlives a library is not to call back into it. It holds no
    /// memory but while something is recorded.
    static TAPE: RefCell<ManuallyDrop<Tape>> = const { RefCell::new(ManuallyDrop::new(Tape::new())) };
}

/// Gives the tape of the thread back what it held before, also where recording panics.
struct Lent<'a>(&'a mut Tape);

impl Drop for Lent<'_> {
    fn drop(&mut self) {
        TAPE.with_borrow_mut(|tape| std::mem::swap(&mut **tape, self.0));
    }
}

impl Tape {
    const fn new() -> Self {
        Self {
            entries: Vec::new(),
            operands: Vec::new(),
            ranges: Vec::new(),
            looks: Vec::new(),
            systems: Vec::new(),
            rights: Vec::new(),
            slopes: Vec::new(),
        }
    }

    /// Records what `work` does with [`Taped`] numbers of this thread, in the memory that there is
    /// from before and maybe more. Numbers 0 to `leaves` are there for [`Taped::leaf`].
    pub fn record<R>(&mut self, leaves: usize, work: impl FnOnce() -> R) -> R {
        let Self { entries, operands, ranges, looks, systems, rights, .. } = self;
        entries.clear();
        // Place 0 is that of constants.
        entries.resize(leaves + 1, LEAF);
        operands.clear();
        ranges.clear();
        looks.clear();
        systems.clear();
        rights.clear();
        let lent = Lent(self);
        TAPE.with_borrow_mut(|tape| std::mem::swap(&mut **tape, lent.0));
        work()
    }

    /// Goes back from the sum of the numbers `seeds`, each times its weight. `solve` turns a right
    /// side into the solution of the transposed equations of system number `n`, in the order of
    /// [`unknowns`].
    pub fn sweep(
        &mut self,
        seeds: impl Iterator<Item = (Taped, f64)>,
        mut solve: impl FnMut(usize, &mut [f64]),
    ) {
        let Self { entries, operands, ranges, looks, systems, rights, slopes } = self;
        if slopes.is_empty() {
            // Room for evaluations up to twice as long as the first one.
            slopes.reserve(2 * entries.len());
            entries.reserve(entries.len());
            operands.reserve(operands.len());
            ranges.reserve(ranges.len());
            looks.reserve(looks.len());
            systems.reserve(systems.len());
            rights.reserve(rights.len());
        }
        if slopes.len() < entries.len() {
            slopes.resize(entries.len(), 0.0);
        }
        slopes[..entries.len()].fill(0.0);
        for (number, weight) in seeds {
            slopes[number.place as usize] += weight;
        }
        slopes[0] = 0.0;
        let mut end = entries.len();
        for n in (0..=systems.len()).rev() {
            let begin = n.checked_sub(1).map_or(1, |n| systems[n].first as usize);
            for (place, &Entry { places: [a, b], slopes: [by_a, by_b] }) in
                (begin..end).zip(&entries[begin..end]).rev()
            {
                let slope = slopes[place];
                if slope == 0.0 {
                    continue;
                }
                if a == MANY {
                    let [from, to] = ranges[b as usize];
                    for operand in &operands[from..to] {
                        slopes[operand.place as usize] += slope * operand.slope;
                    }
                } else {
                    slopes[a as usize] += slope * by_a;
                    slopes[b as usize] += slope * by_b;
                }
            }
            // Numbers by one operand have none for another one.
            slopes[0] = 0.0;
            if let Some(System { rights: [from, to], .. }) = n.checked_sub(1).map(|n| systems[n]) {
                let (before, unknowns) = slopes.split_at_mut(begin);
                let unknowns = &mut unknowns[..to - from];
                if unknowns.iter().any(|slope| *slope != 0.0) {
                    solve(n - 1, unknowns);
                    for (&place, slope) in rights[from..to].iter().zip(unknowns) {
                        before[place as usize] -= *slope;
                    }
                }
                before[0] = 0.0;
            }
            end = begin;
        }
    }

    /// The same by a leaf.
    pub fn slope_of(&self, leaf: Leaf) -> f64 {
        self.slopes[leaf.0 as usize]
    }

    /// All looks at curves with the derivatives by what they saw: (y, z), their first and their
    /// second derivatives.
    pub fn looks(&self) -> impl Iterator<Item = (&Look, [[f64; 2]; 3])> {
        self.looks.iter().map(|look| {
            let slopes = &self.slopes[look.first as usize..];
            (look, [[slopes[0], slopes[1]], [slopes[2], slopes[3]], [slopes[4], slopes[5]]])
        })
    }

    /// Enters a number; returns its place.
    #[inline]
    fn enter(&mut self, entry: Entry) -> u32 {
        let place = self.entries.len() as u32;
        self.entries.push(entry);
        place
    }

    /// Enters a number by any number of operands; 0 where it is a constant.
    fn enter_many<'a>(&mut self, all: impl Iterator<Item = (&'a Taped, f64)>) -> u32 {
        let from = self.operands.len();
        let moving = all.filter(|(operand, slope)| operand.place != 0 && *slope != 0.0);
        self.operands
            .extend(moving.map(|(operand, slope)| Operand { place: operand.place, slope }));
        let to = self.operands.len();
        if to == from {
            return 0;
        }
        self.ranges.push([from, to]);
        let number = (self.ranges.len() - 1) as u32;
        self.enter(Entry { places: [MANY, number], slopes: [0.0; 2] })
    }
}

/// An unknown of linear equations on the tape.
pub struct Unknown {
    place: u32,
}

impl Unknown {
    /// Makes `number` this unknown, with the value that it has.
    pub fn enter(self, number: &mut Taped) {
        number.place = self.place;
    }
}

/// Enters the `count` unknowns x of linear equations H x = -g, of which `rights` are the g; `each`
/// gets them in their order.
pub fn unknowns(
    rights: impl Iterator<Item = Taped>,
    count: usize,
    mut each: impl FnMut(usize, Unknown),
) {
    TAPE.with_borrow_mut(|tape| {
        let from = tape.rights.len();
        tape.rights.extend(rights.map(|right| right.place));
        let to = tape.rights.len();
        debug_assert_eq!(to - from, count);
        let first = tape.entries.len() as u32;
        for n in 0..count {
            each(n, Unknown { place: tape.enter(LEAF) });
        }
        tape.systems.push(System { first, rights: [from, to] });
    });
}
