//! Planar cases with Hertzian bodies, as several tests use them.

use std::collections::BTreeMap;

use wheelrail::element::parameters::{
    FlashTemperature, Flexibilities, FrictionLaw, NormalModel, ShapeFit, TangentialModel,
};
use wheelrail::material::{Material, MaterialPair};
use wheelrail::normal::hertz;
use wheelrail::planar::{Indentation, PlanarCase};
use wheelrail::tangential::fastsim::TractionBound;

/// G = 82 GPa, ν = 0.28.
pub const STEEL: Material = Material { young_modulus: 2.0992e11, poisson_ratio: 0.28 };

/// One row of tests/data/hertz/ellipses.csv, in SI.
#[derive(Clone, Copy, Debug)]
pub struct HertzRow {
    pub axis_ratio: f64,
    pub approach: f64,
    /// Undeformed distance along x² + across y² [1/m].
    pub along: f64,
    pub across: f64,
    pub semi_axes: [f64; 2],
    pub load: f64,
    pub max_pressure: f64,
    pub area: f64,
}

impl HertzRow {
    /// All rows of the file.
    pub fn all() -> Vec<Self> {
        let table = super::read_table("hertz/ellipses.csv");
        let rows = table.rows.iter().map(|row| {
            let v = |name: &str| super::value(&table, row, name);
            Self {
                axis_ratio: v("a_over_b"),
                approach: 1e-3 * v("approach_mm"),
                along: 1e3 * v("along_per_mm"),
                across: 1e3 * v("across_per_mm"),
                semi_axes: [1e-3 * v("a_mm"), 1e-3 * v("b_mm")],
                load: v("normal_force_n"),
                max_pressure: 1e6 * v("max_pressure_mpa"),
                area: 1e-6 * v("area_mm2"),
            }
        });
        rows.collect()
    }

    /// The first row with the axis ratio a/b `ratio`.
    pub fn with_ratio(ratio: f64) -> Self {
        let found = Self::all().into_iter().find(|row| (row.axis_ratio - ratio).abs() < 1e-9);
        found.unwrap_or_else(|| panic!("no row with a/b = {ratio}"))
    }

    /// Points of its separation out to one and a half semi-axes.
    pub fn separation(&self) -> Vec<[f64; 2]> {
        parabola(self.across, self.semi_axes[1])
    }
}

/// Points of f(y) = `across` y² out to 1.5 `semi_axis`.
pub fn parabola(across: f64, semi_axis: f64) -> Vec<[f64; 2]> {
    (-50..=50).map(|i| 0.03 * f64::from(i) * semi_axis).map(|y| [y, across * y * y]).collect()
}

/// A case of steel bodies without creepage: Hertz, FASTSIM 20x20 with the elliptic bound.
pub fn steel_case(separation: &[[f64; 2]], radius: f64, approach: f64) -> PlanarCase<'_> {
    PlanarCase {
        separation,
        radius,
        indentation: Indentation::Approach(approach),
        creepage: [0.0; 3],
        friction: 0.3,
        friction_across: &[],
        wheel_material: STEEL,
        rail_material: STEEL,
        normal_model: NormalModel::Hertz,
        virtual_penetration: 0.55,
        shape_fit: ShapeFit::Hertz,
        tangential_model: TangentialModel::Fastsim,
        strips: 20,
        elements_along: 20,
        elements: [20, 20],
        bound: TractionBound::Elliptic,
        flexibilities: Flexibilities::Three,
        friction_law: FrictionLaw::default(),
        gauge_face_law: FrictionLaw::default(),
        flash_temperature: FlashTemperature::default(),
        speed: 0.0,
    }
}

/// Wheel radius and separation whose Hertzian ellipse under `load` [N] has the semi-axes a and b
/// [m].
pub fn hertzian_bodies(a: f64, b: f64, load: f64) -> (f64, Vec<[f64; 2]>) {
    // The shape depends on the ratio of curvatures alone: find it by bisection in logarithms, then
    // scale the size.
    let (mut low, mut high) = (1e-6f64, 1e6f64);
    for _ in 0..200 {
        let ratio = (low * high).sqrt();
        let e = hertz::ellipse(1.0, ratio, 1e-4, 1e11);
        if e.semi_axis_along / e.semi_axis_across < a / b { low = ratio } else { high = ratio }
    }
    let ratio = (low * high).sqrt();
    let modulus = STEEL.young_modulus / (1.0 - STEEL.poisson_ratio.powi(2)) / 2.0;
    let unit = hertz::ellipse(1.0, ratio, 1e-4, modulus);
    // N ~ δ^1.5/A^0.5 and a ~ (δ/A)^0.5 at fixed ratio: N/a³ ~ A.
    let along = (load / a.powi(3)) / (unit.load / unit.semi_axis_along.powi(3));
    let across = ratio * along;
    let separation =
        (-50..=50).map(|i| 0.04 * f64::from(i) * b).map(|y| [y, across * y * y]).collect();
    (0.5 / along, separation)
}

/// Contact modulus of steel on steel [Pa].
pub fn steel_modulus() -> f64 {
    MaterialPair::new(STEEL, STEEL).contact_modulus
}

/// Separations of CONTACT's planar cases by name, points (y, f) [m].
pub fn separations() -> BTreeMap<String, Vec<[f64; 2]>> {
    let cases = super::read_table("contact_25_1/planar_normal.csv");
    let read = |row: &csv::StringRecord| {
        let table = super::read_table(&format!("contact_25_1/planar/{}.csv", &row[0]));
        let points = table
            .rows
            .iter()
            .map(|point| ["y_mm", "f_mm"].map(|name| 1e-3 * super::value(&table, point, name)));
        (row[0].to_owned(), points.collect())
    };
    cases.rows.iter().map(read).collect()
}

/// Creepage of a row of CONTACT's rolling cases, spin in 1/m.
pub fn creepage_of(v: &dyn Fn(&str) -> f64) -> [f64; 3] {
    [v("creepage_longitudinal"), v("creepage_lateral"), 1e3 * v("spin_per_mm")]
}
