//! Rail heads with kinks, as grinding, milling and ballast leave them: a crown of 300 mm with rounded
//! corners of 13 mm and flanks, as text of points [mm].

use std::fmt::Write as _;

/// Radius of the crown, and where it ends [mm].
const CROWN: f64 = 300.0;
const EDGE: f64 = 24.0;
/// Radius of the corners [mm], and inclination of the flanks [rad].
const CORNER: f64 = 13.0;
const FLANK: f64 = 1.45;
/// Distance of the points of the crown [mm].
const STEP: f64 = 0.25;

/// Height of the crown, down [mm].
fn crown(y: f64) -> f64 {
    CROWN - (CROWN * CROWN - y * y).sqrt()
}

/// The head whose crown is changed to `height`.
fn head(height: impl Fn(f64) -> f64) -> String {
    let start = f64::asin(EDGE / CROWN);
    let corner = (1..=40).map(|i| {
        let angle = start + (FLANK - start) * f64::from(i) / 40.0;
        let across = CORNER * (angle.sin() - start.sin());
        [EDGE + across, crown(EDGE) + CORNER * (start.cos() - angle.cos())]
    });
    let mut corner: Vec<[f64; 2]> = corner.collect();
    let [across, down] = corner[corner.len() - 1];
    corner.extend((1..=25).map(f64::from).map(|d| [across + d / FLANK.tan(), down + d]));
    let steps = (EDGE / STEP) as i32;
    let middle = (-steps..=steps).map(|i| STEP * f64::from(i)).map(|y| [y, height(y)]);
    let left = corner.iter().rev().map(|[y, z]| [-y, *z]);
    let mut text = String::new();
    for [y, z] in left.chain(middle).chain(corner.iter().copied()) {
        writeln!(text, "{y:.7},{z:.7}").unwrap();
    }
    text
}

/// With grooves 3 mm wide and 30 µm deep.
pub fn milled() -> String {
    head(|y| {
        let place = (y / 3.0).rem_euclid(1.0);
        crown(y) + 0.03 * 4.0 * place * (1.0 - place)
    })
}

/// With facets 4 mm wide, whose edges lie on the crown.
pub fn ground() -> String {
    const WIDTH: f64 = 4.0;
    head(|y| {
        let left = (y / WIDTH).floor() * WIDTH;
        let [from, to] = [left, left + WIDTH].map(crown);
        from + (to - from) * (y - left) / WIDTH
    })
}

/// With four dents, 2 to 6 mm wide and 20 to 50 µm deep.
pub fn dented() -> String {
    const DENTS: [[f64; 3]; 4] =
        [[-13.0, 3.0, 0.05], [-4.5, 1.0, 0.02], [2.0, 2.0, 0.04], [9.0, 1.5, 0.03]];
    head(|y| {
        let dents = DENTS.map(|[middle, half, depth]| {
            let place = (y - middle) / half;
            depth * (1.0 - place * place).max(0.0)
        });
        crown(y) + dents.iter().sum::<f64>()
    })
}
