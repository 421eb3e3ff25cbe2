//! A bound that tells a lifted wheel without a contact search.
//!
//! For every lateral position of a straight, upright wheel the table holds a height of the wheel marker down to which it cannot
//! touch the rail. Roll and yaw enter by how far they can move points of the wheel sideways and down.

use crate::geometry::curve::Curve;

/// Lateral spacing of the table [m].
const CELL: f64 = 2.5e-4;
/// Spacing of the samples of both bodies along their curves [m].
const SAMPLE: f64 = 1e-4;
/// What a body may reach beyond its samples: bulges of radius 1 mm between them, and rounding [m].
const MARGIN: f64 = 5e-6;

/// Heights of a wheel marker above which the wheel is clear of one rail.
#[derive(Clone, Debug)]
pub struct Clearance {
    /// Lateral position of the first cell [m].
    start: f64,
    /// Least marker z at which something of a wheel in this cell or its neighbours touches [m].
    heights: Vec<f64>,
    nominal_radius: f64,
    /// Greatest |y| and |z| of the wheel profile [m].
    wheel_extent: [f64; 2],
    /// Half length of the part of the wheel's outer circle that can be as low as the rail [m].
    chord: f64,
}

impl Clearance {
    /// The table for a wheel profile and a rail curve in the frame of its marker.
    #[must_use]
    pub fn new(wheel: &Curve, nominal_radius: f64, rail: &Curve) -> Self {
        let (wheel, rail) = (samples(wheel), samples(rail));
        let extent = |points: &[[f64; 2]], i: usize| {
            points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| {
                [low.min(p[i]), high.max(p[i])]
            })
        };
        let [[wheel_left, wheel_right], [wheel_top, wheel_low]] =
            [extent(&wheel, 0), extent(&wheel, 1)];
        let [[rail_left, rail_right], [rail_top, rail_low]] = [extent(&rail, 0), extent(&rail, 1)];
        // Height of the rail over a grid, the least of each cell and its neighbours.
        let cells = ((rail_right - rail_left) / CELL) as usize + 1;
        let top = spread(&bin_minimum(&rail, rail_left, cells, |p| p[1]));
        // Lowest wheel point of each cell.
        let wheel_cells = ((wheel_right - wheel_left) / CELL) as usize + 1;
        let low = bin_minimum(&wheel, wheel_left, wheel_cells, |p| -p[1]);
        let start = rail_left - wheel_right - CELL;
        let count = ((rail_right - wheel_left - start) / CELL) as usize + 2;
        let mut heights = vec![f64::INFINITY; count];
        for (k, height) in heights.iter_mut().enumerate() {
            let offset = start + k as f64 * CELL;
            for (i, &negative_low) in low.iter().enumerate() {
                let y = offset + wheel_left + (i as f64 + 0.5) * CELL - rail_left;
                if y > -CELL && y < (cells + 1) as f64 * CELL {
                    let cell = ((y / CELL).max(0.0) as usize).min(cells - 1);
                    *height = height.min(top[cell] + negative_low);
                }
            }
        }
        let heights = spread(&heights).iter().map(|h| h - nominal_radius - MARGIN).collect();
        let reach = (rail_low - rail_top) + (wheel_low - wheel_top);
        Self {
            start,
            heights,
            nominal_radius,
            wheel_extent: [
                wheel_left.abs().max(wheel_right.abs()),
                wheel_top.abs().max(wheel_low.abs()),
            ],
            chord: (2.0 * (nominal_radius + wheel_low) * reach).sqrt(),
        }
    }

    /// Whether a wheel at (y, z) [m] of the rail's frame with these angles [rad] surely does not touch.
    #[must_use]
    pub fn is_lifted(&self, marker: [f64; 2], roll: f64, yaw: f64) -> bool {
        marker[1] < self.clear_height(marker[0], roll, yaw)
    }

    /// Marker z above which (smaller z) a wheel at `y` [m] of the rail's frame with these angles [rad] surely does not touch;
    /// infinite where it stands beside the rail [m].
    #[must_use]
    pub fn clear_height(&self, y: f64, roll: f64, yaw: f64) -> f64 {
        let [extent_y, extent_z] = self.wheel_extent;
        let sideways =
            self.chord * yaw.abs() + extent_y * (yaw * yaw + roll * roll) + extent_z * roll.abs();
        let down = extent_y * roll.abs();
        let y = y - self.nominal_radius * roll.sin();
        self.touching_height(y, sideways) - down
    }

    /// Least marker z at which a straight, upright wheel within `sideways` of `y` may touch; infinite beside the rail [m].
    fn touching_height(&self, y: f64, sideways: f64) -> f64 {
        let cell = |y: f64| ((y - self.start) / CELL).round();
        let (first, last) = (cell(y - sideways), cell(y + sideways));
        let most = self.heights.len() as f64 - 1.0;
        if last < 0.0 || first > most {
            return f64::INFINITY;
        }
        let range = first.max(0.0) as usize..=last.min(most) as usize;
        self.heights[range].iter().copied().fold(f64::INFINITY, f64::min)
    }
}

fn samples(curve: &Curve) -> Vec<[f64; 2]> {
    let length = curve.end() - curve.start();
    let count = (length / SAMPLE).ceil() as usize;
    (0..=count).map(|i| curve.at(curve.start() + length * i as f64 / count as f64).point).collect()
}

/// Least value of the points in each cell of a lateral grid.
fn bin_minimum(
    points: &[[f64; 2]],
    left: f64,
    cells: usize,
    value: impl Fn(&[f64; 2]) -> f64,
) -> Vec<f64> {
    let mut least = vec![f64::INFINITY; cells];
    for p in points {
        let cell = (((p[0] - left) / CELL) as usize).min(cells - 1);
        least[cell] = least[cell].min(value(p));
    }
    least
}

/// Least of each value and its two neighbours.
fn spread(values: &[f64]) -> Vec<f64> {
    (0..values.len())
        .map(|i| {
            let range = i.saturating_sub(1)..(i + 2).min(values.len());
            values[range].iter().copied().fold(f64::INFINITY, f64::min)
        })
        .collect()
}
