//! The boundary elements of a rail at which the wheel overlaps it.

use crate::normal::rail_elements::{RailElements, Row};

/// An element at which the bodies overlap.
#[derive(Clone, Copy, Debug)]
pub(super) struct Overlapping<'a> {
    /// Its number.
    pub k: usize,
    /// The number of its row.
    pub j: usize,
    pub row: &'a Row,
    /// Place along the track [m].
    pub x: f64,
    /// Point (y, z) of the wheel opposite to it [m].
    pub point: [f64; 2],
    pub overlap: f64,
    pub growth: [f64; 3],
    /// [N].
    pub load: f64,
}

/// Hands the elements `asked` for by the numbers of their rows and their own to `each`, those at
/// which the bodies overlap.
pub(super) fn for_each_element<'a>(
    elements: &'a RailElements,
    asked: impl Fn(usize, usize) -> bool,
    mut each: impl FnMut(Overlapping<'a>),
) {
    let (grid, area) = (&elements.grid, elements.grid.element_area());
    for (j, row) in elements.rows.iter().enumerate() {
        let Some(row) = row else { continue };
        let normal = row.normal();
        for i in 0..grid.along {
            let k = j * grid.along + i;
            let Some(opposite) = elements.opposite[k].as_ref().filter(|_| asked(j, k)) else {
                continue;
            };
            each(Overlapping {
                k,
                j,
                row,
                x: grid.x(i),
                point: [0, 1].map(|c| row.point[c] + opposite.overlap * normal[c]),
                overlap: opposite.overlap,
                growth: opposite.growth,
                load: area * elements.pressure[k],
            });
        }
    }
}
