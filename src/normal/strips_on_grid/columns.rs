//! What sources do to all nodes, by columns: the part of a Newton step that takes the time, as loops that become vector instructions.
//!
//! The rows of a column are the nodes; what is beyond the last one counts for nothing.

use super::equations::{Displacement, Fall, Pair, Strip, far_pair};
use super::grid::Cell;
use super::influence::{centred_at, shifted_at};

/// Numbers taken together: columns are as long as whole vectors of them, so that no loop has a rest.
pub(super) const LANES: usize = 8;

/// Where rows without a node are across, away from all cells [m]: what has no distance from a cell has no influence either.
const BEYOND: f64 = 1.0;

/// The nodes by rows.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    /// Places along and across and unit tangents (y, z).
    pub places: [Vec<f64>; 4],
    /// Half lengths, loads per width and 1/c.
    pub lengths: Vec<f64>,
    pub loads: Vec<f64>,
    pub slenderness: Vec<f64>,
}

/// Sources: where they are from the nodes, and what they do to them per load per width.
#[derive(Clone, Debug)]
pub(super) struct Sources {
    along: Vec<f64>,
    across: Vec<f64>,
    factors: Vec<f64>,
    /// Displacements, and their derivatives by the logarithm of the half length of the source.
    value: Vec<f64>,
    by_source: Vec<f64>,
    /// Falls, and their derivatives by the logarithms of the half lengths of the source and of the node.
    fall: Vec<f64>,
    fall_by_source: Vec<f64>,
    fall_by_node: Vec<f64>,
    inverses: Vec<f64>,
    column: usize,
}

/// Displacements and falls, with their derivatives by the logarithms of the half lengths of the nodes.
#[derive(Clone, Debug)]
pub(super) struct Sums {
    pub displacement: Vec<f64>,
    pub fall: Vec<f64>,
    pub fall_by_node: Vec<f64>,
}

/// Derivatives of displacements by a load per width and by χ of a node, and of falls by both.
pub(super) type Slopes<T> = [T; 4];

/// What the sources in both cells beside each node do to it.
#[derive(Clone, Debug)]
pub(super) struct Beside {
    /// Loads per width and 1/c at the other ends of the cell under way.
    pub other_loads: Vec<f64>,
    pub other_slenderness: Vec<f64>,
    /// Load per width of the source under way, that times the derivative of the logarithm of the half length by it, and the share of the other end in 1/c.
    loads: Vec<f64>,
    shares: Vec<f64>,
    parts: Vec<f64>,
    /// Derivatives by the load per width and χ of the node.
    pub own: Slopes<Vec<f64>>,
    /// Derivatives by those at both other ends.
    pub others: [Slopes<Vec<f64>>; 2],
}

impl Rows {
    pub fn new(column: usize) -> Self {
        let numbers = || vec![0.0; column];
        Self {
            places: [numbers(), vec![BEYOND; column], numbers(), numbers()],
            lengths: numbers(),
            loads: numbers(),
            slenderness: numbers(),
        }
    }
}

impl Sums {
    pub fn new(column: usize) -> Self {
        let numbers = || vec![0.0; column];
        Self { displacement: numbers(), fall: numbers(), fall_by_node: numbers() }
    }

    pub fn clear(&mut self) {
        for sums in [&mut self.displacement, &mut self.fall, &mut self.fall_by_node] {
            sums.fill(0.0);
        }
    }
}

impl Sources {
    /// Room for `count` sources with columns of `column` rows.
    pub fn new(count: usize, column: usize) -> Self {
        let numbers = |value: f64| vec![value; count * column];
        Self {
            along: numbers(0.0),
            across: numbers(1.0),
            factors: numbers(0.0),
            value: numbers(0.0),
            by_source: numbers(0.0),
            fall: numbers(0.0),
            fall_by_source: numbers(0.0),
            fall_by_node: numbers(0.0),
            inverses: vec![0.0; column],
            column,
        }
    }

    /// Puts source number `c` at `pair` from the node of a row.
    pub fn put(&mut self, c: usize, row: usize, pair: &Pair) {
        let at = c * self.column + row;
        (self.along[at], self.across[at], self.factors[at]) =
            (pair.along, pair.across, pair.factor);
    }

    /// Puts source number `c` in the place of a `cell`, for all rows; its moments, with the half length `length`, into `moments`.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn put_cell(
        &mut self,
        c: usize,
        cell: &Cell,
        length: f64,
        rows: &Rows,
        moments: &mut [f64],
    ) {
        let range = c * self.column..(c + 1) * self.column;
        let out = [
            &mut self.along[range.clone()],
            &mut self.across[range.clone()],
            &mut self.factors[range],
            moments,
        ];
        pairs(cell, length, rows.places.each_ref().map(Vec::as_slice), out);
    }

    /// What source number `c` does with the half length of `strip`, added to `sums`; nothing where it has no load.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn act(&mut self, c: usize, strip: &Strip, rows: &Rows, is_skewed: bool, sums: &mut Sums) {
        let range = c * self.column..(c + 1) * self.column;
        if strip.load > 0.0 {
            self.inverses.fill(1.0 / strip.half_length);
            self.influence(c, rows, is_skewed);
            add(strip.load, &self.value[range.clone()], &mut sums.displacement);
            add(strip.load, &self.fall[range.clone()], &mut sums.fall);
            add(strip.load, &self.fall_by_node[range], &mut sums.fall_by_node);
        } else {
            for columns in
                [&mut self.value, &mut self.by_source, &mut self.fall, &mut self.fall_by_source]
            {
                columns[range.clone()].fill(0.0);
            }
        }
    }

    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn influence(&mut self, c: usize, rows: &Rows, is_skewed: bool) {
        let range = c * self.column..(c + 1) * self.column;
        let along = if is_skewed { &self.along[range.clone()] } else { &[][..] };
        influences(
            [
                along,
                &self.across[range.clone()],
                &self.factors[range.clone()],
                &self.inverses,
                &rows.lengths,
            ],
            [&mut self.value[range.clone()], &mut self.by_source[range.clone()]],
            [
                &mut self.fall[range.clone()],
                &mut self.fall_by_source[range.clone()],
                &mut self.fall_by_node[range],
            ],
        );
    }

    /// Derivatives by the load per width and χ of a node from those by the cells number `first` and the next one on both sides of it, whose half
    /// lengths have the derivatives `shares` by both; `moments` are those of the displacement by the moments of cells.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn gather(
        &self,
        first: usize,
        shares: [[f64; 2]; 2],
        moments: &[f64],
        [by_load, by_shape, fall_by_load, fall_by_shape]: Slopes<&mut [f64]>,
    ) {
        let pair = |c: usize| c * self.column..(c + 1) * self.column;
        let (a, b) = (pair(first), pair(first + 1));
        combine(
            [&self.value[a.clone()], &self.by_source[a.clone()]],
            [&self.value[b.clone()], &self.by_source[b.clone()]],
            shares,
            [by_load, by_shape],
        );
        add(1.0, moments, by_load);
        combine(
            [&self.fall[a.clone()], &self.fall_by_source[a]],
            [&self.fall[b.clone()], &self.fall_by_source[b]],
            shares,
            [fall_by_load, fall_by_shape],
        );
    }
}

impl Beside {
    pub fn new(column: usize) -> Self {
        let numbers = || vec![0.0; column];
        let four = || [numbers(), numbers(), numbers(), numbers()];
        Self {
            other_loads: numbers(),
            other_slenderness: numbers(),
            loads: numbers(),
            shares: numbers(),
            parts: numbers(),
            own: four(),
            others: [four(), four()],
        }
    }

    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn clear(&mut self) {
        for column in self.own.iter_mut().chain(self.others.as_flattened_mut()) {
            column.fill(0.0);
        }
    }

    /// What source number `c` of `sources` does, which is at a share `t` of the way through the cell on a `side`.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn act(
        &mut self,
        sources: &mut Sources,
        [c, side]: [usize; 2],
        [t, least_square]: [f64; 2],
        rows: &Rows,
        is_skewed: bool,
        sums: &mut Sums,
    ) {
        let Self { other_loads, other_slenderness, loads, shares, parts, own, others } = self;
        strips(
            [&rows.loads, &rows.slenderness, other_loads, other_slenderness],
            [t, least_square],
            [loads, shares, parts, &mut sources.inverses],
        );
        sources.influence(c, rows, is_skewed);
        let range = c * sources.column..(c + 1) * sources.column;
        let [own_load, own_shape, own_fall, own_fall_shape] = own;
        let [by_load, by_shape, by_fall, by_fall_shape] = &mut others[side];
        let strips = [loads.as_slice(), shares, parts];
        split(
            [&sources.value[range.clone()], &sources.by_source[range.clone()]],
            strips,
            t,
            [&mut sums.displacement, own_load, own_shape, by_load, by_shape],
        );
        split(
            [&sources.fall[range.clone()], &sources.fall_by_source[range.clone()]],
            strips,
            t,
            [&mut sums.fall, own_fall, own_fall_shape, by_fall, by_fall_shape],
        );
        add_each(loads, &sources.fall_by_node[range], &mut sums.fall_by_node);
    }
}

/// A cell from all nodes, without regard to whether they are beside it, and its moments.
#[allow(clippy::inline_always)]
#[inline(always)]
fn pairs(
    cell: &Cell,
    length: f64,
    [x, y, a, b]: [&[f64]; 4],
    [along, across, factors, moments]: [&mut [f64]; 4],
) {
    let n = along.len();
    let (x, y, a, b) = (&x[..n], &y[..n], &a[..n], &b[..n]);
    let (across, factors, moments) = (&mut across[..n], &mut factors[..n], &mut moments[..n]);
    for i in 0..n {
        let (pair, moment) = far_pair([x[i], y[i], a[i], b[i]], cell, length);
        (along[i], across[i], factors[i]) = (pair.along, pair.across, pair.factor);
        moments[i] = moment;
    }
}

/// Displacements by sources at distances `along`, unless that is empty, and `across`, times `factors`, and their derivatives; and their falls at
/// nodes of the half lengths `lengths`.
#[allow(clippy::inline_always)]
#[inline(always)]
fn influences(
    [along, across, factors, inverses, lengths]: [&[f64]; 5],
    displacements: [&mut [f64]; 2],
    falls: [&mut [f64]; 3],
) {
    let [along, across, factors, inverses, lengths] =
        [along, across, factors, inverses, lengths].map(blocks);
    let [value, by_source] = displacements.map(blocks_mut);
    let [fall, fall_by_source, fall_by_node] = falls.map(blocks_mut);
    for (b, (value, by_source)) in value.iter_mut().zip(by_source).enumerate() {
        // Copies, so that nothing is read again after something has been written.
        let (across, factors, inverses) = (across[b], factors[b], inverses[b]);
        let along = along.get(b).copied();
        let (mut d, mut slope) = ([0.0; LANES], [0.0; LANES]);
        if let Some(along) = along {
            for i in 0..LANES {
                let at = shifted_at(along[i] * inverses[i], across[i] * inverses[i]);
                (d[i], slope[i]) = (at.d, at.slope);
            }
        } else {
            for i in 0..LANES {
                let at = centred_at(across[i] * inverses[i]);
                (d[i], slope[i]) = (at.d, at.slope);
            }
        }
        let mut out = [[0.0; LANES]; 2];
        for i in 0..LANES {
            let own = Displacement::of([d[i], slope[i]], inverses[i]);
            (out[0][i], out[1][i]) = (factors[i] * own.value, factors[i] * own.by_source);
        }
        [*value, *by_source] = out;
        let lengths = lengths[b];
        let mut out = [[0.0; LANES]; 3];
        if let Some(along) = along {
            for i in 0..LANES {
                let centre = [d[i], slope[i]];
                let at = Fall::shifted(centre, along[i], across[i], inverses[i], lengths[i]);
                out[0][i] = factors[i] * at.value;
                out[1][i] = factors[i] * at.by_source;
                out[2][i] = factors[i] * at.by_node;
            }
        } else {
            for i in 0..LANES {
                let centre = [d[i], slope[i]];
                let at = Fall::straight(centre, across[i], inverses[i], lengths[i]);
                out[0][i] = factors[i] * at.value;
                out[1][i] = factors[i] * at.by_source;
                out[2][i] = factors[i] * at.by_node;
            }
        }
        [fall[b], fall_by_source[b], fall_by_node[b]] = out;
    }
}

/// Whole vectors of a column.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn blocks(column: &[f64]) -> &[[f64; LANES]] {
    column.as_chunks().0
}

#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn blocks_mut(column: &mut [f64]) -> &mut [[f64; LANES]] {
    column.as_chunks_mut().0
}

/// Half of what two cells do, as derivatives by the load per width and by χ of the node between them.
#[allow(clippy::inline_always)]
#[inline(always)]
fn combine(
    [value_a, source_a]: [&[f64]; 2],
    [value_b, source_b]: [&[f64]; 2],
    [[load_a, shape_a], [load_b, shape_b]]: [[f64; 2]; 2],
    [by_load, by_shape]: [&mut [f64]; 2],
) {
    let [value_a, source_a, value_b, source_b] = [value_a, source_a, value_b, source_b].map(blocks);
    let [by_load, by_shape] = [by_load, by_shape].map(blocks_mut);
    for b in 0..value_a.len() {
        let (values, sources) = ([value_a[b], value_b[b]], [source_a[b], source_b[b]]);
        let mut out = [[0.0; LANES]; 2];
        for i in 0..LANES {
            let (one, other) = (sources[0][i], sources[1][i]);
            out[0][i] = 0.5 * (values[0][i] + values[1][i]) + load_a * one + load_b * other;
            out[1][i] = shape_a * one + shape_b * other;
        }
        [by_load[b], by_shape[b]] = out;
    }
}

/// Strips at a share `t` of the way from the nodes to the other ends of their cells, and what their half lengths change by.
#[allow(clippy::inline_always)]
#[inline(always)]
fn strips(
    ends: [&[f64]; 4],
    [t, least_square]: [f64; 2],
    [load, share, part, inverse]: [&mut [f64]; 4],
) {
    let [loads, slenderness, other_loads, other_slenderness] = ends.map(blocks);
    let [load, share, part, inverse] = [load, share, part, inverse].map(blocks_mut);
    for b in 0..loads.len() {
        let (loads, slenderness) = (loads[b], slenderness[b]);
        let (other_loads, other_slenderness) = (other_loads[b], other_slenderness[b]);
        let mut out = [[0.0; LANES]; 4];
        for i in 0..LANES {
            let between = loads[i] + (other_loads[i] - loads[i]) * t;
            let [own, other] = [(1.0 - t) * slenderness[i], t * other_slenderness[i]];
            let strip = Strip::new(between, own + other, least_square);
            out[0][i] = strip.load;
            out[1][i] = strip.load * strip.length_by_load;
            out[2][i] = other / (own + other);
            out[3][i] = 1.0 / strip.half_length;
        }
        [load[b], share[b], part[b], inverse[b]] = out;
    }
}

/// Adds what sources with `value` and `by_source` do to its sum, and to its derivatives by the load per width and χ of both ends of their cells.
#[allow(clippy::inline_always)]
#[inline(always)]
fn split(influences: [&[f64]; 2], strips: [&[f64]; 3], t: f64, sums: [&mut [f64]; 5]) {
    let [value, by_source] = influences.map(blocks);
    let [loads, shares, parts] = strips.map(blocks);
    let [sum, own_load, own_shape, by_load, by_shape] = sums.map(blocks_mut);
    for b in 0..value.len() {
        let (value, by_source) = (value[b], by_source[b]);
        let (loads, shares, parts) = (loads[b], shares[b], parts[b]);
        let mut out = [sum[b], own_load[b], own_shape[b], by_load[b], by_shape[b]];
        for i in 0..LANES {
            let pull = shares[i] * by_source[i];
            let (slope, by_other) = (value[i] + pull, loads[i] * pull * parts[i]);
            out[0][i] += loads[i] * value[i];
            out[1][i] += (1.0 - t) * slope;
            out[2][i] -= loads[i] * pull - by_other;
            out[3][i] += t * slope;
            out[4][i] -= by_other;
        }
        [sum[b], own_load[b], own_shape[b], by_load[b], by_shape[b]] = out;
    }
}

/// Adds a multiple of `column` to `sums`.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn add(factor: f64, column: &[f64], sums: &mut [f64]) {
    let (column, sums) = (blocks(column), blocks_mut(sums));
    for b in 0..column.len() {
        let (column, mut out) = (column[b], sums[b]);
        for i in 0..LANES {
            out[i] += factor * column[i];
        }
        sums[b] = out;
    }
}

/// Adds the products of two columns to `sums`.
#[allow(clippy::inline_always)]
#[inline(always)]
fn add_each(factors: &[f64], column: &[f64], sums: &mut [f64]) {
    let ([factors, column], sums) = ([factors, column].map(blocks), blocks_mut(sums));
    for b in 0..column.len() {
        let (factors, column, mut out) = (factors[b], column[b], sums[b]);
        for i in 0..LANES {
            out[i] += factors[i] * column[i];
        }
        sums[b] = out;
    }
}

/// Multiplies a column.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn scale(factor: f64, column: &mut [f64]) {
    for block in blocks_mut(column) {
        *block = block.map(|value| factor * value);
    }
}
