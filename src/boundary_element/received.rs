//! What every element receives from the tractions of all others: direct sums, laid out for vector instructions.
//!
//! Gauss-Seidel needs the sum for one element after the other, each with the newest tractions, which transforms cannot give.

use multiversion::multiversion;

use super::grid::Grid;
use super::influence::{Influence, TangentialInfluence};

/// Rows of tractions are summed in groups of this many; they end with zeros up to the next whole group.
const GROUP: usize = 4;

/// Tangential influence by the offset of the source from the receiver.
#[derive(Clone, Debug)]
pub struct Received {
    along: usize,
    across: usize,
    /// Numbers in a row of offsets.
    stride: usize,
    /// For xx, xy and yy: rows of sources from across - 1 to the left of the receiver; in each the sources from along - 1 ahead of
    /// it, then zeros.
    tables: [Vec<f64>; 3],
}

/// Tractions in rows that end with zeros, and the stretch of each row that is in contact.
#[derive(Clone, Debug)]
pub struct TractionRows {
    /// Numbers in a row.
    pub stride: usize,
    /// First column in contact, and whole groups of columns from it to the last.
    stretches: Vec<(usize, usize)>,
    /// Longitudinal tractions [Pa].
    pub x: Vec<f64>,
    /// Lateral tractions [Pa].
    pub y: Vec<f64>,
}

impl TractionRows {
    /// Room for the elements of `grid` with `bound` > 0, no traction.
    #[must_use]
    pub fn new(grid: &Grid, bound: &[f64]) -> Self {
        let stride = grid.along.next_multiple_of(GROUP) + GROUP;
        let stretches = bound.chunks_exact(grid.along).map(|row| {
            let first = row.iter().position(|&g| g > 0.0);
            let last = row.iter().rposition(|&g| g > 0.0);
            first
                .zip(last)
                .map_or((0, 0), |(first, last)| (first, (last + 1 - first).div_ceil(GROUP)))
        });
        let zeros = vec![0.0; stride * grid.across];
        Self { stride, stretches: stretches.collect(), x: zeros.clone(), y: zeros }
    }
}

impl Received {
    /// Lays out `influence`.
    #[must_use]
    pub fn new(influence: &TangentialInfluence) -> Self {
        let [along, across] = influence.xx.extent();
        // A last group may begin at the last source and reach beyond it.
        let stride = 2 * along - 1 + GROUP;
        let lay_out = |influence: &Influence| {
            let mut table = vec![0.0; stride * (2 * across - 1)];
            for (k, row) in table.chunks_exact_mut(stride).enumerate() {
                // The source to the left has the receiver to its right; the source ahead has it behind.
                let offset = across as isize - 1 - k as isize;
                for (to, from) in row.iter_mut().zip(influence.row(offset).iter().rev()) {
                    *to = *from;
                }
            }
            table
        };
        let tables = [&influence.xx, &influence.xy, &influence.yy].map(lay_out);
        Self { along, across, stride, tables }
    }

    /// What element (i, j) receives from all `tractions`.
    #[must_use]
    pub fn at(&self, i: usize, j: usize, tractions: &TractionRows) -> [f64; 2] {
        let [xx, xy, yy] = &self.tables;
        let layout = [self.along - 1 - i, self.across - 1 - j, self.stride];
        sum(layout, [xx, xy, yy], tractions)
    }
}

/// `layout`: the offsets along and across of the first source, and the numbers in a row of the tables.
#[multiversion(targets("x86_64+avx2+fma", "aarch64+neon"))]
fn sum(layout: [usize; 3], tables: [&[f64]; 3], tractions: &TractionRows) -> [f64; 2] {
    let [along, across, stride] = layout;
    let mut sums = [[0.0; GROUP]; 4];
    for (row, &(first, groups)) in tractions.stretches.iter().enumerate() {
        let count = groups * GROUP;
        let from = (across + row) * stride + along + first;
        let source = row * tractions.stride + first;
        let [xx, xy, yy] = tables.map(|table| table[from..from + count].as_chunks::<GROUP>().0);
        let px = tractions.x[source..source + count].as_chunks::<GROUP>().0;
        let py = tractions.y[source..source + count].as_chunks::<GROUP>().0;
        let groups = xx.iter().zip(xy).zip(yy).zip(px.iter().zip(py));
        for (((xx, xy), yy), (px, py)) in groups {
            for l in 0..GROUP {
                sums[0][l] += xx[l] * px[l];
                sums[1][l] += xy[l] * py[l];
                sums[2][l] += xy[l] * px[l];
                sums[3][l] += yy[l] * py[l];
            }
        }
    }
    let total = |k: usize| sums[k].iter().sum::<f64>();
    [total(0) + total(1), total(2) + total(3)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::{Material, MaterialPair};
    use approx::assert_relative_eq;

    #[test]
    fn sums_are_those_of_the_full_matrix() {
        let steel = Material { young_modulus: 2.0, poisson_ratio: 0.3 };
        for (along, across) in [(1, 1), (1, 3), (5, 1), (11, 4)] {
            let grid = Grid::over([0.0, 3.0], [0.0, 2.0], along, across);
            let influence =
                TangentialInfluence::rolling_slip(&grid, &MaterialPair::new(steel, steel));
            let received = Received::new(&influence);
            let bound: Vec<f64> =
                (0..grid.len()).map(|k| f64::from(u8::from(k % 7 != 2))).collect();
            let mut rows = TractionRows::new(&grid, &bound);
            let traction = |k: usize| {
                if bound[k] > 0.0 {
                    [((3 * k) % 5) as f64 - 1.5, ((7 * k) % 11) as f64 - 5.0]
                } else {
                    [0.0; 2]
                }
            };
            for k in 0..grid.len() {
                let at = k / along * rows.stride + k % along;
                [rows.x[at], rows.y[at]] = traction(k);
            }
            for k in 0..grid.len() {
                let mut expected = [0.0; 2];
                for source in 0..grid.len() {
                    let offset = |n: usize, m: usize| n as isize - m as isize;
                    let (i, j) =
                        (offset(k % along, source % along), offset(k / along, source / along));
                    let p = traction(source);
                    expected[0] += influence.xx.at(i, j) * p[0] + influence.xy.at(i, j) * p[1];
                    expected[1] += influence.xy.at(i, j) * p[0] + influence.yy.at(i, j) * p[1];
                }
                let found = received.at(k % along, k / along, &rows);
                for c in 0..2 {
                    assert_relative_eq!(
                        found[c],
                        expected[c],
                        epsilon = 1e-11,
                        max_relative = 1e-11
                    );
                }
            }
        }
    }
}
