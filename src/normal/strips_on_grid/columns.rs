//! Columns of numbers, one row for each node, in blocks that become vector instructions. What is
//! beyond the last node counts for nothing.

/// Rows of a block: one register of AVX2, so that few numbers have to leave the registers and the
/// nodes of an element by default fill all rows.
pub(super) const LANES: usize = 4;

/// Where rows without a node are across, away from all cells [m]: what has no distance from a cell
/// has no influence either.
pub(super) const BEYOND: f64 = 1.0;

/// Rows that are taken together.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
pub(super) struct Block(pub [f64; LANES]);

impl Block {
    pub const ZERO: Self = Self([0.0; LANES]);

    // Inside each instruction set or not at all: a call would not be vectorised. So with all that
    // follows.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn of(row: impl Fn(usize) -> f64) -> Self {
        let mut rows = [0.0; LANES];
        for (i, out) in rows.iter_mut().enumerate() {
            *out = row(i);
        }
        Self(rows)
    }

    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn times(&self, factor: f64) -> Self {
        Self::of(|i| factor * self.0[i])
    }

    /// Adds the product of two blocks.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    pub fn add(&mut self, one: &Self, other: &Self) {
        *self = Self::of(|i| self.0[i] + one.0[i] * other.0[i]);
    }
}

/// Row number `row` of some blocks.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn row(blocks: &mut [Block], row: usize) -> &mut f64 {
    &mut blocks[row / LANES].0[row % LANES]
}

/// Adds a multiple of `column` to `sums`.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn add(factor: f64, column: &[Block], sums: &mut [Block]) {
    for (sum, rows) in sums.iter_mut().zip(column) {
        *sum = Block::of(|i| sum.0[i] + factor * rows.0[i]);
    }
}

/// Drops of displacement at nodes, taken to the knots by the `shares` that these have in each of
/// them, one block of knots after the other.
#[allow(clippy::inline_always)]
#[inline(always)]
pub(super) fn project(drops: &[Block], shares: &[Block], knots: &mut [Block]) {
    let shares = shares.chunks_exact(drops.len() * LANES);
    for (knots, shares) in knots.iter_mut().zip(shares) {
        let mut sum = Block::ZERO;
        for (Block(drops), shares) in drops.iter().zip(shares.as_chunks::<LANES>().0) {
            for i in 0..LANES {
                sum = Block::of(|lane| sum.0[lane] + drops[i] * shares[i].0[lane]);
            }
        }
        *knots = sum;
    }
}

/// The nodes by rows.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    /// Places along and across and unit tangents (y, z).
    pub places: [Vec<Block>; 4],
    /// Half lengths and loads per width.
    pub lengths: Vec<Block>,
    pub loads: Vec<Block>,
    /// Derivatives of the logarithms of half lengths by loads per width, and drops that the
    /// wheel requires.
    pub length_by_load: Vec<Block>,
    pub required_drop: Vec<Block>,
    /// Derivatives of the logarithms of loaded widths by z of the node and of those on both sides.
    pub widths: [Vec<Block>; 3],
}

impl Rows {
    /// For `count` blocks.
    pub fn new(count: usize) -> Self {
        let blocks = || vec![Block::ZERO; count];
        Self {
            places: [blocks(), vec![Block([BEYOND; LANES]); count], blocks(), blocks()],
            lengths: blocks(),
            loads: blocks(),
            length_by_load: blocks(),
            required_drop: blocks(),
            widths: [blocks(), blocks(), blocks()],
        }
    }

    /// No nodes.
    pub fn clear(&mut self) {
        let Self { places: [x, y, a, b], lengths, loads, length_by_load, required_drop, widths } =
            self;
        let columns = [x, a, b, lengths, loads, length_by_load, required_drop];
        for column in columns.into_iter().chain(widths) {
            column.fill(Block::ZERO);
        }
        y.fill(Block([BEYOND; LANES]));
    }
}

/// Displacements of all nodes and behind them their drops, by all sources, and the derivatives of
/// drops by the logarithms of the half lengths of the nodes.
#[derive(Clone, Debug)]
pub(super) struct Sums {
    pub values: Vec<Block>,
    pub drop_by_node: Vec<Block>,
}

impl Sums {
    /// For `count` blocks of nodes.
    pub fn new(count: usize) -> Self {
        let blocks = |count| vec![Block::ZERO; count];
        Self { values: blocks(2 * count), drop_by_node: blocks(count) }
    }

    pub fn clear(&mut self) {
        self.values.fill(Block::ZERO);
        self.drop_by_node.fill(Block::ZERO);
    }
}
