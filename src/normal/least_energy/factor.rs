//! A symmetric matrix in factors L D Lᵀ, and what it takes to solve with it.

use super::lanes::{FEW, Four, LANES, Lanes, Plain, Simd, by_blocks, first, first_mut, stride};
use crate::math::fixed_vec::FixedVec;

/// Least pivot over the diagonal: less is not taken for positive definite.
const LEAST_PIVOT: f64 = 1e-6;
/// What is added to the diagonal of an unknown that is held, over itself.
const HOLD: f64 = 1e10;
/// Fours of a long column that are worked on together.
const PANEL: usize = 4;

/// A symmetric matrix and its factors, by columns of which only what is below the diagonal counts.
/// Rows come by fours; there are two kinds of unknowns, each of which begins with a four.
#[derive(Clone, Debug)]
pub(super) struct Factor {
    /// Fours of the first kind, and of a column.
    pub first: usize,
    blocks: usize,
    /// Unknowns before each four, and all of them.
    starts: FixedVec<usize>,
    columns: Vec<Lanes>,
    /// 1 for unknowns that are free, 0 for those that are held, and what is added to the diagonal.
    pub free: Vec<Lanes>,
    pub shift: Vec<Lanes>,
    /// D L and then L, column after column of those that are there.
    parts: Vec<Lanes>,
    inverse: Vec<f64>,
    solved: Vec<f64>,
}

impl Factor {
    /// Room for so many unknowns.
    pub fn new(most: usize) -> Self {
        let blocks = (most.div_ceil(LANES) + 1).max(FEW);
        let size = blocks * LANES;
        Self {
            first: 0,
            blocks: 0,
            starts: FixedVec::new(blocks + 1),
            columns: vec![[0.0; LANES]; blocks * size],
            free: vec![[0.0; LANES]; blocks],
            shift: vec![[0.0; LANES]; blocks],
            parts: vec![[0.0; LANES]; 2 * blocks * size],
            inverse: vec![0.0; size],
            solved: vec![0.0; size],
        }
    }

    /// Becomes a matrix for unknowns of two kinds, whose columns are to be filled in; those of the
    /// first kind are free.
    #[inline(always)]
    pub fn resize(&mut self, counts: [usize; 2]) {
        self.starts.clear();
        self.starts.extend((0..counts[0]).step_by(LANES));
        self.first = self.starts.len();
        self.starts.extend((counts[0]..counts[0] + counts[1]).step_by(LANES));
        self.blocks = self.starts.len();
        self.starts.push(counts[0] + counts[1]);
        self.free[..self.first].fill([1.0; LANES]);
    }

    /// The column of row `row`; the numbers above its diagonal do not count, but are to be finite.
    #[inline(always)]
    pub fn column(&mut self, row: usize) -> &mut [Lanes] {
        let stride = stride::<0>(self.blocks);
        &mut self.columns[row * stride..row * stride + self.blocks]
    }

    /// Number of the first unknown in four number `block` among all, and how many there are.
    #[inline(always)]
    fn unknowns(&self, block: usize) -> (usize, usize) {
        let before = self.starts[block];
        (before, (self.starts[block + 1] - before).min(LANES))
    }

    /// Factorises the matrix with `raise` of the diagonal added to itself, those held at rest; false
    /// where it is not positive definite.
    #[inline(always)]
    pub fn factorise<S: Simd>(&mut self, simd: S, raise: f64) -> bool {
        for block in 0..self.blocks {
            let is_positive = by_blocks!(self.blocks - block, self.blocks => R, {
                self.eliminate::<S, R>(simd, block, raise)
            });
            if !is_positive {
                return false;
            }
        }
        true
    }

    /// Columns of four number `block`, with `R` fours from there on.
    #[inline(always)]
    fn eliminate<S: Simd, const R: usize>(&mut self, simd: S, block: usize, raise: f64) -> bool {
        let (stride, rest) = (stride::<R>(self.blocks), self.blocks - block);
        let (before, count) = self.unknowns(block);
        for lane in 0..count {
            let k = before + lane;
            let (done, own) = self.parts.split_at_mut(2 * k * stride);
            let (scaled, unit) = own[..2 * stride].split_at_mut(stride);
            let scaled = first_mut::<R, _>(&mut scaled[block..], rest);
            let unit = first_mut::<R, _>(&mut unit[block..], rest);
            let from = (block * LANES + lane) * stride + block;
            let column = first::<R, _>(&self.columns[from..], rest);
            let done = done.chunks_exact(2 * stride);
            let done = done.map(|part| (part[block][lane], &part[stride + block..]));
            if R > 0 {
                take_off::<S, R>(simd, column, done, scaled);
            } else {
                let (columns, last) = column.as_chunks::<PANEL>();
                let whole = columns.len() * PANEL;
                for (panel, column) in columns.iter().enumerate() {
                    let from = panel * PANEL;
                    let done = done.clone().map(|(factor, unit)| (factor, &unit[from..]));
                    take_off::<S, PANEL>(simd, column, done, &mut scaled[from..]);
                }
                for from in whole..whole + last.len() {
                    let done = done.clone().map(|(factor, unit)| (factor, &unit[from..]));
                    take_off::<S, 1>(simd, &column[from..], done, &mut scaled[from..]);
                }
            }
            let diagonal = column[0][lane];
            let hold = HOLD - HOLD * self.free[block][lane];
            let shift = (raise + hold) * diagonal.abs();
            self.shift[block][lane] = shift;
            let pivot = scaled[0][lane] + shift;
            // Not a number compares false as well.
            if !(pivot > LEAST_PIVOT * (diagonal + shift).abs() && pivot < f64::INFINITY) {
                return false;
            }
            let inverse = 1.0 / pivot;
            self.inverse[k] = inverse;
            for (unit, scaled) in unit.iter_mut().zip(&*scaled) {
                *unit = (simd.four(scaled) * inverse).lanes();
            }
        }
        true
    }

    /// Becomes the factors of `other`, which has the same room.
    fn copy_from(&mut self, other: &Self) {
        (self.first, self.blocks) = (other.first, other.blocks);
        self.starts.clear();
        self.starts.extend_from_slice(&other.starts);
        let unknowns = self.starts.last().copied().unwrap_or(0);
        let parts = 2 * unknowns * stride::<0>(self.blocks);
        self.parts[..parts].copy_from_slice(&other.parts[..parts]);
        self.inverse[..unknowns].copy_from_slice(&other.inverse[..unknowns]);
    }

    /// Solves for one right side, in place.
    #[inline(always)]
    pub fn solve<S: Simd>(&mut self, simd: S, right: &mut [Lanes]) {
        let blocks = self.blocks;
        for block in 0..blocks {
            let right = &mut right[block..];
            by_blocks!(blocks - block, blocks => R, self.substitute::<S, R>(simd, block, right));
        }
        right[..blocks].fill([0.0; LANES]);
        for block in (0..blocks).rev() {
            let right = &mut right[block..];
            by_blocks!(blocks - block, blocks => R, {
                self.substitute_back::<S, R>(simd, block, right);
            });
        }
    }

    /// Takes the columns of four number `block` off the `R` fours of `right` from there on.
    #[inline(always)]
    fn substitute<S: Simd, const R: usize>(&mut self, simd: S, block: usize, right: &mut [Lanes]) {
        let (stride, rest) = (stride::<R>(self.blocks), self.blocks - block);
        let (before, count) = self.unknowns(block);
        let right = first_mut::<R, _>(right, rest);
        let parts = self.parts[2 * before * stride..].chunks_exact(2 * stride);
        let known = self.solved[before..before + count].iter_mut().zip(&self.inverse[before..]);
        for (lane, (part, (solved, inverse))) in parts.zip(known).enumerate() {
            let unit = first::<R, _>(&part[stride + block..], rest);
            let value = right[0][lane % LANES];
            *solved = value * inverse;
            for (right, unit) in right.iter_mut().zip(unit) {
                *right = simd.four(right).sub_product(simd.splat(value), simd.four(unit)).lanes();
            }
        }
    }

    /// Finds the unknowns of four number `block` from those behind them in `right`.
    #[inline(always)]
    fn substitute_back<S: Simd, const R: usize>(&self, simd: S, block: usize, right: &mut [Lanes]) {
        let (stride, rest) = (stride::<R>(self.blocks), self.blocks - block);
        let (before, count) = self.unknowns(block);
        let right = first_mut::<R, _>(right, rest);
        let parts = &self.parts[2 * before * stride..2 * (before + count) * stride];
        let solved = &self.solved[before..before + count];
        for lane in (0..count).rev() {
            let unit = &parts[(2 * lane + 1) * stride + block..];
            let mut sum = simd.splat(0.0);
            for (right, unit) in right.iter().zip(first::<R, _>(unit, rest)) {
                sum = sum.add_product(simd.four(right), simd.four(unit));
            }
            right[0][lane % LANES] = solved[lane] - sum.sum();
        }
    }
}

/// A factor of a solution that others have come after.
#[derive(Clone, Debug)]
pub(super) struct KeptFactor {
    factor: Factor,
    right: Vec<Lanes>,
    /// Unknowns of the first kind, and the numbers of what those of the second kind that are free
    /// stand for, with their rows.
    first: usize,
    free: FixedVec<usize>,
    rows: FixedVec<usize>,
}

impl KeptFactor {
    /// Room for the factors that `like` has room for.
    pub fn like(like: &Factor) -> Self {
        let most = like.inverse.len();
        Self {
            factor: like.clone(),
            right: vec![[0.0; LANES]; like.free.len()],
            first: 0,
            free: FixedVec::new(most),
            rows: FixedVec::new(most),
        }
    }

    /// Keeps `factor`, which has `first` unknowns of the first kind; `second` are what the others
    /// stand for, and whether they are free.
    pub fn keep(
        &mut self,
        factor: &Factor,
        first: usize,
        second: impl Iterator<Item = (usize, bool)>,
    ) {
        self.factor.copy_from(factor);
        self.first = first;
        self.free.clear();
        self.rows.clear();
        for (k, (stands_for, _)) in second.enumerate().filter(|(_, (_, is_free))| *is_free) {
            self.free.push(stands_for);
            self.rows.push(factor.first * LANES + k);
        }
    }

    /// What the free unknowns of the second kind stand for, and how many there are of the first.
    pub fn unknowns(&self) -> (&[usize], usize) {
        (&self.free, self.first)
    }

    /// Solves for one right side, in place: free unknowns of the second kind, then those of the
    /// first.
    pub fn solve(&mut self, right: &mut [f64]) {
        let Self { factor, right: own, first, rows, .. } = self;
        own.fill([0.0; LANES]);
        let order = || rows.iter().copied().chain(0..*first);
        let flat = own.as_flattened_mut();
        order().zip(&*right).for_each(|(row, value)| flat[row] = *value);
        factor.solve(Plain, own);
        let flat = own.as_flattened();
        order().zip(right).for_each(|(row, value)| *value = flat[row]);
    }
}

/// `column` without the columns before, each of which comes with its factor.
#[inline(always)]
fn take_off<'a, S: Simd, const B: usize>(
    simd: S,
    column: &[Lanes],
    done: impl Iterator<Item = (f64, &'a [Lanes])>,
    left: &mut [Lanes],
) {
    let mut sums: [Four<S>; B] = [simd.splat(0.0); B];
    for (sum, column) in sums.iter_mut().zip(&column[..B]) {
        *sum = simd.four(column);
    }
    for (factor, unit) in done {
        let factor = simd.splat(factor);
        for (sum, unit) in sums.iter_mut().zip(&unit[..B]) {
            *sum = sum.sub_product(factor, simd.four(unit));
        }
    }
    for (left, sum) in left[..B].iter_mut().zip(sums) {
        *left = sum.lanes();
    }
}

#[cfg(test)]
mod tests {
    use super::super::lanes::Plain;
    use super::*;

    #[test]
    fn a_symmetric_system_is_solved() {
        let matrix = [[4.0, 1.0, -2.0], [1.0, 3.0, 0.5], [-2.0, 0.5, 7.0]];
        let x = [0.5, -1.0, 2.0];
        // The first unknown is of another kind and stands in the first four.
        let rows = [0, 4, 5];
        let mut factor = Factor::new(7);
        factor.resize([1, 2]);
        factor.free[1] = [1.0; LANES];
        let mut right = [[0.0; LANES]; 2];
        for (&row, column) in rows.iter().zip(&matrix) {
            for (&other, value) in rows.iter().zip(column) {
                factor.column(row)[other / LANES][other % LANES] = *value;
            }
            right[row / LANES][row % LANES] = column.iter().zip(x).map(|(a, x)| a * x).sum();
        }
        assert!(factor.factorise(Plain, 0.0));
        factor.solve(Plain, &mut right);
        for (row, wanted) in rows.into_iter().zip(x) {
            let found = right[row / LANES][row % LANES];
            approx::assert_relative_eq!(found, wanted, max_relative = 1e-14);
        }
        factor.column(4)[1][0] = -1.0;
        assert!(!factor.factorise(Plain, 0.0));
        assert!(factor.factorise(Plain, 3.0));
    }
}
