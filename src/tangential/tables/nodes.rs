//! The tabulated numbers: where they stand and how they are kept in a file.
//!
//! The file has a head of text lines that begin with `#`, an empty line, and numbers with the least
//! significant byte first: the greatest magnitude of each of seven columns (four of the creep
//! forces, three of full sliding) as 32-bit floats, then each column as 16-bit integers in units of
//! that magnitude over 32767, last the error estimates, a byte each.

use super::direction::unit_vector;

/// ln(a/b) of the first and last ellipse: a/b = 0.05 and 20.
pub const LOG_RATIO: f64 = 2.995_732_273_553_991;
/// Intervals of ln(a/b).
pub const RATIO_CELLS: usize = 12;
/// Intervals of the saturation s = ρ/(ρ + [`HALF`]) from 0 to 1.
pub const SATURATION_CELLS: usize = 12;
/// Scaled creepage ρ at s = 1/2.
pub const HALF: f64 = 1.5;
/// Intervals of the elevation χ from 0 to π/2, for creep forces.
pub const ELEVATION_CELLS: usize = 10;
/// Intervals of the azimuth ψ from 0 to π, for creep forces.
pub const AZIMUTH_CELLS: usize = 24;
/// The same for full sliding.
pub const SLIDING_ELEVATION_CELLS: usize = 24;
/// The same for full sliding.
pub const SLIDING_AZIMUTH_CELLS: usize = 48;
/// Share of local longitudinal creepage in the scale of spin: see [`super::scales`].
pub const SPIN_BY_WIDTH: f64 = 0.3;

/// A node over two angles: rings of constant elevation from the equator on, the pole last.
pub fn ring_nodes(elevation_cells: usize, azimuth_cells: usize) -> usize {
    elevation_cells * azimuth_cells + 1
}

/// Unit vector of node `k` over two angles.
pub fn ring_direction(k: usize, elevation_cells: usize, azimuth_cells: usize) -> [f64; 3] {
    use std::f64::consts::{FRAC_PI_2, PI};
    let (ring, step) = (k / azimuth_cells, k % azimuth_cells);
    if ring == elevation_cells {
        return [1.0, 0.0, 0.0];
    }
    let elevation = FRAC_PI_2 * ring as f64 / elevation_cells as f64;
    unit_vector(elevation, PI * step as f64 / azimuth_cells as f64)
}

/// ln(a/b) of ellipse `i`.
pub fn log_ratio(i: usize) -> f64 {
    LOG_RATIO * (2.0 * i as f64 / RATIO_CELLS as f64 - 1.0)
}

/// Nodes of one ellipse and saturation.
pub const RING: usize = ELEVATION_CELLS * AZIMUTH_CELLS + 1;
/// Saturations between 0 and 1.
pub const SATURATIONS: usize = SATURATION_CELLS - 1;
/// Ellipses.
pub const RATIOS: usize = RATIO_CELLS + 1;
/// Nodes of one ellipse in full sliding.
pub const SLIDING_RING: usize = SLIDING_ELEVATION_CELLS * SLIDING_AZIMUTH_CELLS + 1;

/// All numbers of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes {
    /// Correction K of longitudinal and lateral force and moment, and share of the area that slips:
    /// [ellipse][saturation][ring].
    pub creep: Vec<[f64; 4]>,
    /// Estimated error of the force over μ N, of each of these.
    pub error: Vec<f64>,
    /// Full sliding less its closed form, longitudinal and lateral force and moment:
    /// [ellipse][ring].
    pub sliding: Vec<[f64; 3]>,
}

/// Unit of the error estimates.
const ERROR_UNIT: f64 = 1e-4;
/// Columns of 16-bit integers.
const COLUMNS: usize = 7;
/// Creep nodes.
pub const CREEP_NODES: usize = RATIOS * SATURATIONS * RING;
/// Sliding nodes.
pub const SLIDING_NODES: usize = RATIOS * SLIDING_RING;

impl Nodes {
    fn column(&self, c: usize) -> Vec<f64> {
        if c < 4 {
            self.creep.iter().map(|values| values[c]).collect()
        } else {
            self.sliding.iter().map(|values| values[c - 4]).collect()
        }
    }

    /// The file of these numbers; `head` is its text, lines without the sign at their beginning.
    pub fn to_bytes(&self, head: &str) -> Vec<u8> {
        let mut bytes = Vec::new();
        for line in head.lines() {
            bytes.extend(format!("# {line}\n").bytes());
        }
        bytes.push(b'\n');
        let greatest = |column: &[f64]| column.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        let columns: Vec<Vec<f64>> = (0..COLUMNS).map(|c| self.column(c)).collect();
        for column in &columns {
            bytes.extend((greatest(column) as f32).to_le_bytes());
        }
        for column in &columns {
            let unit = f64::from(greatest(column) as f32) / f64::from(i16::MAX);
            let unit = if unit > 0.0 { unit } else { 1.0 };
            bytes.extend(column.iter().flat_map(|v| ((v / unit).round() as i16).to_le_bytes()));
        }
        bytes.extend(self.error.iter().map(|e| (e / ERROR_UNIT).ceil().min(255.0) as u8));
        bytes
    }

    /// The numbers of a file; `None` where it is of another size.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let end = bytes.windows(2).position(|pair| pair == b"\n\n")? + 2;
        let (greatest, rest) = bytes[end..].split_at_checked(4 * COLUMNS)?;
        let greatest: Vec<f64> =
            greatest.as_chunks().0.iter().map(|b| f64::from(f32::from_le_bytes(*b))).collect();
        let integers = 2 * (4 * CREEP_NODES + 3 * SLIDING_NODES);
        let (integers, error) = rest.split_at_checked(integers)?;
        if error.len() != CREEP_NODES {
            return None;
        }
        let (integers, _) = integers.as_chunks();
        let mut numbers = integers.iter().map(|b| f64::from(i16::from_le_bytes(*b)));
        let mut nodes = Self {
            creep: vec![[0.0; 4]; CREEP_NODES],
            error: error.iter().map(|e| ERROR_UNIT * f64::from(*e)).collect(),
            sliding: vec![[0.0; 3]; SLIDING_NODES],
        };
        for (c, greatest) in greatest.iter().enumerate() {
            let unit = greatest / f64::from(i16::MAX);
            if c < 4 {
                nodes.creep.iter_mut().zip(&mut numbers).for_each(|(v, n)| v[c] = unit * n);
            } else {
                nodes.sliding.iter_mut().zip(&mut numbers).for_each(|(v, n)| v[c - 4] = unit * n);
            }
        }
        Some(nodes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    #[test]
    fn a_file_gives_the_numbers_back() {
        let value = |k: usize| ((7919 * k) % 1000) as f64 / 250.0 - 2.0;
        let nodes = Nodes {
            creep: (0..CREEP_NODES).map(|k| [0, 1, 2, 3].map(|c| value(k + c))).collect(),
            error: (0..CREEP_NODES).map(|k| 1e-4 * (k % 200) as f64).collect(),
            sliding: (0..SLIDING_NODES).map(|k| [0, 1, 2].map(|c| 0.1 * value(k + c))).collect(),
        };
        let read = Nodes::from_bytes(&nodes.to_bytes("first\nsecond")).unwrap();
        for (a, b) in read.creep.iter().zip(&nodes.creep) {
            assert_abs_diff_eq!(a[..], b[..], epsilon = 4e-5);
        }
        for (a, b) in read.sliding.iter().zip(&nodes.sliding) {
            assert_abs_diff_eq!(a[..], b[..], epsilon = 4e-6);
        }
        for (a, b) in read.error.iter().zip(&nodes.error) {
            assert!(*a > b - 1e-12 && *a < b + 1.01e-4);
        }
        assert_eq!(Nodes::from_bytes(b"# too short\n\n1234"), None);
    }
}
