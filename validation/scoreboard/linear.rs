//! Linear creep coefficients: forces of small creepages on ellipses.

use wheelrail::material::Material;
use wheelrail::planar::{Indentation, PlanarCase, solve};

use crate::common::planar::{STEEL, hertzian_bodies, steel_case};
use crate::common::{read_table, value};
use crate::family::{Case, Family, none};
use crate::setting::Setting;

/// Ellipses of five Poisson's ratios.
pub const FAMILY: Family = Family {
    title: "Linear creep coefficients",
    source: "`tests/data/kalker_coefficients.csv`",
    text: "Ratios of the semi-axes from 0.03 to 33, Poisson's ratios from 0 to 0.5; forces of a hundredth of the limit, of which the first slip takes a third of a percent. Of a spin \
           force and moment are compared, both over the greater of c23 and c33, which are up to 600 times apart. The reference is uncertain by 0.1 %, in c33 by 0.4 %; boundary elements are \
           solved to 1 % of such forces.",
    quantities: &["c11 [%]", "c22 [%]", "c23 [% of c23 or c33]", "c33 [% of c23 or c33]"],
    is_random: false,
    needs_folder: false,
    solve: |setting, _| Some(coefficients(setting)),
    others: none,
};

/// Force of a small creepage over the friction limit.
const SMALL: f64 = 1e-2;
const FRICTION: f64 = 0.3;
/// Mean semi-axis of all ellipses [m], and a load that gives some 1 GPa on it [N].
const SIZE: f64 = 5e-3;
const LOAD: f64 = 5e4;

fn coefficients(setting: &Setting) -> Vec<Case> {
    let table = read_table("kalker_coefficients.csv");
    let of = |row: &csv::StringRecord| {
        let v = |name: &str| value(&table, row, name);
        let (ratio, poisson_ratio) = (v("a_over_b"), v("poisson_ratio"));
        let [a, b] = [SIZE * ratio.sqrt(), SIZE / ratio.sqrt()];
        let (radius, separation) = hertzian_bodies(a, b, LOAD);
        // As stiff against pressure as steel, by which the ellipse is the same.
        let stiffness = STEEL.young_modulus / (1.0 - STEEL.poisson_ratio.powi(2));
        let young_modulus = stiffness * (1.0 - poisson_ratio * poisson_ratio);
        let material = Material { young_modulus, poisson_ratio };
        let unit = young_modulus / (2.0 * (1.0 + poisson_ratio)) * SIZE * SIZE;
        let force = |creepage: [f64; 3]| {
            let case = setting.of_case(&PlanarCase {
                indentation: Indentation::Load(LOAD),
                creepage,
                wheel_material: material,
                rail_material: material,
                ..steel_case(&separation, radius, 0.0)
            });
            let found = solve(&case).expect("a good case");
            [found.fx, found.fy, found.mz].map(|force| -force / unit)
        };
        let small = |coefficient: f64| SMALL * FRICTION * LOAD / (unit * coefficient);
        let [c11, c22, c23, c33] = ["c11", "c22", "c23", "c33"].map(v);
        let [longitudinal, lateral, spin] = [c11, c22, c23.max(c33)].map(small);
        let [x, ..] = force([longitudinal, 0.0, 0.0]);
        let [_, y, _] = force([0.0, lateral, 0.0]);
        let [_, by_spin, moment] = force([0.0, 0.0, spin / SIZE]);
        let found = [x / longitudinal, y / lateral, by_spin / spin, moment / (SIZE * spin)];
        let most = c23.max(c33);
        let exact = [(c11, c11), (c22, c22), (c23, most), (c33, most)];
        let errors = found.into_iter().zip(exact);
        Case {
            name: format!("a/b = {ratio}, Poisson's ratio {poisson_ratio}"),
            errors: errors.map(|(found, (exact, unit))| 100.0 * (found - exact) / unit).collect(),
        }
    };
    table.rows.iter().map(of).collect()
}
