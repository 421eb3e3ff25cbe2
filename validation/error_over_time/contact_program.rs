//! Errors against stored results of the boundary element program CONTACT on planar cases; see the
//! heads of the files under tests/data.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use wheelrail::element::parameters::NormalModel;
use wheelrail::planar::{Indentation, PlanarCase, PlanarResult, solve};

use crate::choices::{Choice, Normal, Rolling, WITHOUT};
use crate::common::planar::{creepage_of, hertzian_bodies, separations, steel_case};
use crate::common::{Table, column, read_table, value};

/// Coefficient of friction of all sets.
const FRICTION: f64 = 0.3;
/// Elements across of the reference that the errors refer to.
const REFERENCE_ELEMENTS: &str = "40";

/// The stored sets.
pub struct Sets {
    separations: BTreeMap<String, Vec<[f64; 2]>>,
    normal: Table,
    rolling: Table,
    /// Patch area of the rolling cases by case and approach [m²].
    areas: BTreeMap<(String, String), f64>,
    ellipses: Table,
}

/// Share of the friction limit by which creep forces are missed, and of friction times load times
/// patch size by which moments are.
#[derive(Clone, Copy)]
pub struct RollingError {
    pub force: f64,
    pub moment: f64,
}

/// Relative errors of load, greatest pressure and area, and whether the patch has one region.
#[derive(Clone, Copy)]
pub struct NormalError {
    pub load: f64,
    pub pressure: f64,
    pub area: f64,
    pub one_region: bool,
}

impl Sets {
    /// Reads all of them.
    pub fn read() -> Self {
        let normal = read_table("contact_25_1/planar_normal.csv");
        let mut rolling = read_table("contact_25_1/planar_tangential.csv");
        let elements = column(&rolling, "elements");
        rolling.rows.retain(|row| &row[elements] == REFERENCE_ELEMENTS);
        let areas = normal
            .rows
            .iter()
            .map(|row| {
                let key = (row[0].to_owned(), row[1].to_owned());
                (key, 1e-6 * value(&normal, row, "area_mm2"))
            })
            .collect();
        Self {
            separations: separations(),
            areas,
            ellipses: read_table("contact_25_1/hertz_tangential.csv"),
            normal,
            rolling,
        }
    }

    /// Number of rolling cases and of ellipses.
    pub fn sizes(&self) -> [usize; 2] {
        [self.rolling.rows.len(), self.ellipses.rows.len()]
    }

    fn solve(
        &self,
        choice: Choice,
        table: &Table,
        row: &csv::StringRecord,
        creepage: [f64; 3],
    ) -> PlanarResult {
        let v = |name: &str| value(table, row, name);
        let separation = &self.separations[&row[0]];
        let case = PlanarCase {
            creepage,
            ..steel_case(separation, 1e-3 * v("radius_mm"), 1e-3 * v("approach_mm"))
        };
        solve(&choice.of_case(&case)).expect("a good case")
    }

    /// Errors of the normal model on the 32 planar cases, approach given; how often it fell back.
    pub fn normal(&self, normal: Normal) -> (Vec<NormalError>, usize) {
        let mut fallbacks = 0;
        let errors = self.normal.rows.iter().map(|row| {
            let choice = Choice { normal, rolling: WITHOUT };
            let found = self.solve(choice, &self.normal, row, [0.0; 3]);
            fallbacks += usize::from(found.fallback);
            let miss =
                |found: f64, name: &str| (found / value(&self.normal, row, name) - 1.0).abs();
            NormalError {
                load: miss(found.normal_force, "normal_force_n"),
                pressure: miss(1e-6 * found.max_pressure, "max_pressure_mpa"),
                area: miss(1e6 * found.area, "area_mm2"),
                one_region: &row[column(&self.normal, "regions")] == "1",
            }
        });
        (errors.collect(), fallbacks)
    }

    /// Errors on the rolling cases: eight real patches, 82 creepages each, approach given.
    pub fn rolling(&self, choice: Choice) -> Vec<RollingError> {
        let errors = self.rolling.rows.iter().map(|row| {
            let v = |name: &str| value(&self.rolling, row, name);
            let creepage = creepage_of(&v);
            let found = self.solve(choice, &self.rolling, row, creepage);
            let limit = FRICTION * v("normal_force_n");
            let size = (self.areas[&(row[0].to_owned(), row[1].to_owned())] / PI).sqrt();
            RollingError {
                force: (found.fx - v("fx_n")).hypot(found.fy - v("fy_n")) / limit,
                moment: (found.mz - 1e-3 * v("mz_nmm")).abs() / (limit * size),
            }
        });
        errors.collect()
    }

    /// Errors of the creep force on 300 Hertzian ellipses, load given, normal contact by Hertz with
    /// as many strips as there are elements along.
    pub fn ellipses(&self, rolling: Rolling) -> Vec<f64> {
        let normal = Normal { model: NormalModel::Hertz, count: rolling.count };
        let choice = Choice { normal, rolling };
        let errors = self.ellipses.rows.iter().map(|row| {
            let v = |name: &str| value(&self.ellipses, row, name);
            let load = v("normal_force_n");
            let (radius, separation) = hertzian_bodies(1e-3 * v("a_mm"), 1e-3 * v("b_mm"), load);
            let case = PlanarCase {
                indentation: Indentation::Load(load),
                creepage: creepage_of(&v),
                ..steel_case(&separation, radius, 0.0)
            };
            let found = solve(&choice.of_case(&case)).expect("a good case");
            let limit = FRICTION * load;
            (found.fx / limit - v("fx_over_mu_n")).hypot(found.fy / limit - v("fy_over_mu_n"))
        });
        errors.collect()
    }
}
