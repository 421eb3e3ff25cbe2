//! Bounds that tell which stretches of a wheel can touch a rail, without a contact search.
//!
//! Both bodies are kept as tables over lateral cells: the height of the rail's top and the lowest
//! points of a straight, upright wheel. Roll and yaw enter by how far they can move points of the
//! wheel sideways and down: a point of the wheel low enough to meet the rail lies within a chord of
//! the axle's vertical plane, so that yaw moves it sideways by at most chord · yaw.

mod cells;

use std::ops::Range;

use crate::geometry::curves::curve::Curve;
use crate::geometry::wheel::contact_line::WheelPose;
use cells::{CELL, SAMPLE, cell_count, extent, put_least_within, samples};

/// What a body may reach beyond its samples: bulges of radius 1 mm between them, and rounding [m].
const MARGIN: f64 = 5e-6;
/// What a body that varies may reach beyond the corners of a face between two slices and two rows
/// [m].
const BULGE: f64 = 5e-4;
/// Heights of the rail are kept as the least over 2^level cells to either side, for levels below
/// this one: 128 mm.
const LEVELS: usize = 9;
/// Cells of the wheel that are looked at together before any of them is looked at alone.
const BLOCK: usize = 16;
/// How wide the rail has to be to either side of a place of a wheel that counts as inside, and the
/// spacing of such places, in places and cells: 8 mm in all.
const SURROUNDING: isize = 2;
const SPACING: isize = 4;
/// Cells beyond either end of the rail that any level can reach.
const PADDING: usize = 1 << (LEVELS - 1);

/// Where a wheel with one profile can touch one rail.
#[derive(Clone, Debug)]
pub struct Clearance {
    /// Height (z) of the rail's top over its cells and the padding [m].
    top: Vec<f64>,
    /// For each level the least of it over the cells within reach [m].
    tops: [Vec<f64>; LEVELS],
    /// Lateral position of the first cell of `tops` in the rail's frame [m].
    rail_start: f64,
    /// Greatest z of the wheel profile over each of its cells [m].
    lows: Vec<f64>,
    /// The same over each block of cells [m].
    block_lows: Vec<f64>,
    /// First and last parameter of the profile over each of its cells [m].
    spans: Vec<[f64; 2]>,
    /// Lateral position of the first cell of the wheel on its profile [m].
    wheel_start: f64,
    /// How far the rail's curve reaches down from its top [m].
    rail_depth: f64,
    /// Least height of the rail and greatest z of the wheel [m].
    rail_top: f64,
    wheel_low: f64,
    nominal_radius: f64,
    /// Greatest |y| and |z| of the wheel profile [m].
    wheel_extent: [f64; 2],
    /// Half length of the part of the wheel's outer circle that can be as low as the rail [m].
    chord: f64,
}

/// The cells of a wheel in some pose that lie opposite to a rail.
struct OppositeCells<'a> {
    /// Cells of the wheel; empty beside the rail.
    cells: Range<usize>,
    /// What the number of a cell of the rail is above that of the cell of the wheel over it.
    offset: isize,
    /// Highest place of the rail that each cell of the wheel can reach, by cells of the rail [m].
    tops: &'a [f64],
    /// The same for a whole block of cells, by that in its middle; empty where the angles are too
    /// large [m].
    block_tops: &'a [f64],
}

impl OppositeCells<'_> {
    /// Highest place of the rail that a cell of the wheel can reach [m].
    #[inline]
    fn top(&self, cell: usize) -> f64 {
        self.tops[(cell as isize + self.offset) as usize]
    }
}

impl Clearance {
    /// The tables for a wheel profile and a rail curve in the frame of its marker.
    pub fn new(wheel: &Curve, nominal_radius: f64, rail: &Curve) -> Self {
        let mut tables = Self {
            top: Vec::new(),
            tops: [const { Vec::new() }; LEVELS],
            rail_start: 0.0,
            lows: Vec::new(),
            block_lows: Vec::new(),
            spans: Vec::new(),
            wheel_start: 0.0,
            rail_depth: 0.0,
            rail_top: 0.0,
            wheel_low: 0.0,
            nominal_radius,
            wheel_extent: [0.0; 2],
            chord: 0.0,
        };
        tables.put_curves(wheel, rail);
        tables
    }

    /// Makes the tables anew for other curves; allocates nothing within the room that they have.
    pub fn put_curves(&mut self, wheel: &Curve, rail: &Curve) {
        let [[rail_left, rail_right], [rail_top, rail_low]] = extent(rail);
        let count = cell_count(rail_left, rail_right);
        let top = &mut self.top;
        top.clear();
        top.resize(count + 2 * PADDING, f64::INFINITY);
        for ([y, z], _) in samples(rail) {
            let cell = &mut top[PADDING + ((y - rail_left) / CELL) as usize];
            *cell = cell.min(z);
        }
        self.rail_start = rail_left - PADDING as f64 * CELL;
        (self.rail_top, self.rail_depth) = (rail_top, rail_low - rail_top);
        self.put_levels();
        self.put_wheel(wheel);
    }

    /// Makes those of the wheel anew for another profile; allocates nothing within the room that
    /// they have.
    pub fn put_wheel(&mut self, wheel: &Curve) {
        let [[wheel_left, wheel_right], [wheel_top, wheel_low]] = extent(wheel);
        let cells = cell_count(wheel_left, wheel_right);
        let Self { lows, block_lows, spans, .. } = self;
        lows.clear();
        lows.resize(cells, f64::NEG_INFINITY);
        spans.clear();
        spans.resize(cells, [f64::MAX, f64::MIN]);
        for ([y, z], s) in samples(wheel) {
            let cell = ((y - wheel_left) / CELL) as usize;
            lows[cell] = lows[cell].max(z);
            spans[cell] = [spans[cell][0].min(s - SAMPLE), spans[cell][1].max(s + SAMPLE)];
        }
        block_lows.clear();
        let lowest = |block: &[f64]| block.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        block_lows.extend(lows.chunks(BLOCK).map(lowest));
        let reach = self.rail_depth + (wheel_low - wheel_top);
        self.wheel_start = wheel_left;
        self.wheel_low = wheel_low;
        self.wheel_extent =
            [wheel_left.abs().max(wheel_right.abs()), wheel_top.abs().max(wheel_low.abs())];
        self.chord = (2.0 * (self.nominal_radius + wheel_low) * reach).sqrt();
    }

    /// Puts the `faces` of a rail that varies along the track, by the corners (y, z) of each, in the
    /// place of the rail, if there are any: no wheel above them touches it anywhere. Returns how far
    /// it then reaches beyond the sides that it had [m].
    pub fn raise(&mut self, faces: impl Iterator<Item = [[f64; 2]; 4]> + Clone) -> f64 {
        let across = |face: &[[f64; 2]; 4]| {
            let y = face.map(|corner| corner[0]);
            [y.iter().copied().fold(f64::MAX, f64::min), y.iter().copied().fold(f64::MIN, f64::max)]
        };
        let first = self.rail_start + PADDING as f64 * CELL;
        let last = first + (self.top.len() - 2 * PADDING) as f64 * CELL;
        let [left, right] = faces
            .clone()
            .map(|face| across(&face))
            .fold([first, last], |[a, b], [c, d]| [a.min(c), b.max(d)]);
        let more = |by: f64| (by / CELL).ceil() as usize;
        let (before, after) = (more(first - left), more(right - last) + 1);
        self.top.splice(0..0, std::iter::repeat_n(f64::INFINITY, before));
        self.top.resize(self.top.len() + after, f64::INFINITY);
        self.rail_start -= before as f64 * CELL;
        let start = first - before as f64 * CELL;
        let own = self.rail_top;
        let mut lowest = own;
        if faces.clone().next().is_some() {
            self.top.fill(f64::INFINITY);
            self.rail_top = f64::INFINITY;
        }
        for face in faces {
            let [left, right] = across(&face).map(|y| PADDING + ((y - start) / CELL) as usize);
            let top = face.iter().map(|corner| corner[1]).fold(f64::INFINITY, f64::min) - BULGE;
            for cell in &mut self.top[left..=right] {
                *cell = cell.min(top);
            }
            self.rail_top = self.rail_top.min(top);
            lowest = face.iter().map(|corner| corner[1]).fold(lowest, f64::max);
        }
        let more = (own - self.rail_top) + (lowest - own);
        let circle = 2.0 * (self.nominal_radius + self.wheel_low);
        self.chord = (self.chord * self.chord + circle * more).sqrt();
        self.put_levels();
        (before + after) as f64 * CELL
    }

    /// Lowers the wheel to all of the `sides` of outlines of one that varies around, by the ends
    /// (y, z) of each: no rail below them is touched at any angle. Returns how far it then reaches
    /// beyond the sides that it had [m].
    pub fn lower(&mut self, sides: impl Iterator<Item = [[f64; 2]; 2]> + Clone) -> f64 {
        let across = |[a, b]: [[f64; 2]; 2]| [a[0].min(b[0]), a[0].max(b[0])];
        let first = self.wheel_start;
        let last = first + self.lows.len() as f64 * CELL;
        let [left, right] =
            sides.clone().map(across).fold([first, last], |[a, b], [c, d]| [a.min(c), b.max(d)]);
        let more = |by: f64| (by / CELL).ceil() as usize;
        let (before, after) = (more(first - left), more(right - last) + 1);
        let nothing = f64::NEG_INFINITY;
        self.lows.splice(0..0, std::iter::repeat_n(nothing, before));
        self.lows.resize(self.lows.len() + after, nothing);
        self.wheel_start -= before as f64 * CELL;
        for side in sides {
            let [left, right] = across(side).map(|y| ((y - self.wheel_start) / CELL) as usize);
            let low = side[0][1].max(side[1][1]) + BULGE;
            for cell in &mut self.lows[left..=right] {
                *cell = cell.max(low);
            }
            let [extent_y, extent_z] = &mut self.wheel_extent;
            for [y, z] in side {
                (*extent_y, *extent_z) = (extent_y.max(y.abs()), extent_z.max(z.abs()));
            }
            self.wheel_low = self.wheel_low.max(low);
        }
        // What is above the first outline lies no lower than the rail either.
        let reach = self.rail_depth + 2.0 * self.wheel_extent[1];
        self.chord = (2.0 * (self.nominal_radius + self.wheel_low) * reach).sqrt();
        (before + after) as f64 * CELL
    }

    /// Level 0 is the least over one cell to either side, each further level doubles the reach.
    fn put_levels(&mut self) {
        let Self { top, tops, .. } = self;
        put_least_within(top, 1, &mut tops[0]);
        for level in 1..LEVELS {
            let (known, further) = tops.split_at_mut(level);
            put_least_within(&known[level - 1], 1 << (level - 1), &mut further[0]);
        }
    }

    /// Makes room for curves that reach `further` [m] to either side.
    pub fn reserve(&mut self, further: f64) {
        let cells = (2.0 * further / CELL).ceil() as usize;
        self.top.reserve(cells);
        self.tops.iter_mut().for_each(|top| top.reserve(cells));
        self.lows.reserve(cells);
        self.spans.reserve(cells);
        self.block_lows.reserve(cells.div_ceil(BLOCK));
    }

    /// Marker z above which (smaller z) no wheel with this roll [rad] touches, wherever it stands
    /// [m].
    pub fn clear_height(&self, roll: f64) -> f64 {
        self.rail_top - self.wheel_low - self.nominal_radius - self.drop(roll)
    }

    /// Marker z above which no cell of the wheel touches at the place and attitude of `pose`, whose
    /// own z counts only where the rail rolls; infinite beside the rail [m].
    pub fn height_near_touch(&self, pose: &WheelPose) -> f64 {
        let Some(opposite) = self.opposite_cells(pose) else {
            return self.clear_height(pose.roll);
        };
        let least = (opposite.cells.clone())
            .map(|cell| opposite.top(cell) - self.lows[cell])
            .fold(f64::INFINITY, f64::min);
        least - self.nominal_radius - self.drop(pose.roll)
    }

    /// Fills `ranges` with the stretches of the contact line, as ranges of its parameter, that may
    /// touch the rail when the wheel stands at `pose`: none for a lifted wheel, everything where
    /// the angles are too large for a bound.
    pub fn ranges(&self, pose: &WheelPose, ranges: &mut Vec<[f64; 2]>) {
        ranges.clear();
        let Some(opposite) = self.opposite_cells(pose) else {
            ranges.push([f64::MIN, f64::MAX]);
            return;
        };
        let low = pose.marker[2] + self.nominal_radius + self.drop(pose.roll);
        let mut open: Option<[f64; 2]> = None;
        let mut next = opposite.cells.start;
        while next < opposite.cells.end {
            let block = next / BLOCK;
            let cells = next..((block + 1) * BLOCK).min(opposite.cells.end);
            next = cells.end;
            if self.block_is_clear(block, low, &opposite) {
                continue;
            }
            let tops = &opposite.tops[(cells.start as isize + opposite.offset) as usize..];
            let tops = &tops[..cells.len()];
            let own = self.lows[cells.clone()].iter().zip(&self.spans[cells]);
            for ((lowest, span), top) in own.zip(tops) {
                if lowest + low < *top {
                    continue;
                }
                match &mut open {
                    Some(range) if span[0] <= range[1] => {
                        if span[1] > range[1] {
                            range[1] = span[1];
                        }
                    }
                    // No room for another stretch: the last one grows over the gap.
                    Some(range) if ranges.len() + 1 == ranges.capacity() => range[1] = span[1],
                    _ => ranges.extend(open.replace(*span)),
                }
            }
        }
        ranges.extend(open);
    }

    /// How deep the wheel at `pose` lies below the top of the rail where the rail is wide around
    /// it, whatever the outlines look like below [m]; nothing where it does not. Roll and yaw count
    /// as none: it is a measure of wheels that are inside.
    pub fn sunk(&self, pose: &WheelPose) -> Option<f64> {
        let y = pose.marker[1] - self.nominal_radius * pose.roll.sin();
        let offset = ((y + self.wheel_start - self.rail_start) / CELL).floor();
        if offset.abs() > 1e6 {
            return None;
        }
        let low = pose.marker[2] + self.nominal_radius;
        let tops = &self.tops[0];
        let depth = |cell: usize| {
            let middle = cell as isize + offset as isize;
            // Beside the rail there is no top: a flange beside the gauge face is not inside.
            let top = (-SURROUNDING..=SURROUNDING)
                .map(|k| usize::try_from(middle + k * SPACING).ok().and_then(|i| tops.get(i)))
                .try_fold(f64::NEG_INFINITY, |lowest, top| Some(lowest.max(*top?)))?;
            let depth = low + self.lows[cell] - top;
            (depth > 0.0).then_some(depth)
        };
        (0..self.lows.len()).step_by(SPACING as usize).filter_map(depth).max_by(f64::total_cmp)
    }

    /// Whether no cell of a block of the wheel can touch, by the lowest of them and the highest
    /// place of the rail that any can reach.
    #[inline]
    fn block_is_clear(&self, block: usize, low: f64, opposite: &OppositeCells) -> bool {
        let middle = (block * BLOCK + BLOCK / 2) as isize + opposite.offset;
        let top = opposite.block_tops.get(middle as usize);
        top.is_some_and(|top| self.block_lows[block] + low < *top)
    }

    /// The cells of the wheel that the rail reaches at `pose`, and the tops of the rail opposite to
    /// them as far as roll and yaw can move points sideways; nothing where the angles are too large
    /// for a bound.
    fn opposite_cells(&self, pose: &WheelPose) -> Option<OppositeCells<'_>> {
        let WheelPose { marker, roll, yaw } = *pose;
        let [extent_y, extent_z] = self.wheel_extent;
        let sideways =
            self.chord * yaw.abs() + extent_y * (yaw * yaw + roll * roll) + extent_z * roll.abs();
        // One cell more, because the two grids do not meet.
        let level = level_within(sideways / CELL + 1.0)?;
        let top = &self.tops[level];
        let y = marker[1] - self.nominal_radius * roll.sin();
        let offset = ((y + self.wheel_start - self.rail_start) / CELL).floor();
        // Far beside the rail; this also keeps the conversion below exact.
        if offset.abs() > 1e6 {
            return Some(OppositeCells { cells: 0..0, offset: 0, tops: &[], block_tops: &[] });
        }
        let offset = offset as isize;
        // The cells of `top` that the rail reaches at this level.
        let rail = [PADDING - (1 << level), top.len() - PADDING + (1 << level)];
        let within = |cell: usize| (cell as isize - offset).clamp(0, self.lows.len() as isize);
        let [first, last] = rail.map(|cell| within(cell) as usize);
        let block_level = level_within(f64::from(1 << level) + (BLOCK / 2) as f64);
        let block_tops = block_level.map_or(&[][..], |level| &self.tops[level]);
        Some(OppositeCells { cells: first..last, offset, tops: top, block_tops })
    }

    /// How far roll and what the tables leave open can lower a point of the wheel [m].
    fn drop(&self, roll: f64) -> f64 {
        self.wheel_extent[0] * roll.abs() + MARGIN
    }
}

/// Least level whose reach is at least `cells`.
fn level_within(cells: f64) -> Option<usize> {
    (0..LEVELS).find(|&level| f64::from(1 << level) >= cells)
}
