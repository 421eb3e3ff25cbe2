//! The columns of planar cases.

use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use wheelrail::element::Parameters;
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::planar::{Indentation, PlanarCase};
use wheelrail::variables::{Values, find};

use crate::cases::{Cases, Row};
use crate::models::is_slow;

/// Columns that set a variable of the element: name, variable, SI per unit of the column (0: not a
/// number).
const VARIABLE_COLUMNS: [(&str, &str, f64); 18] = [
    ("friction", "friction.coefficient", 1.0),
    ("young_modulus_mpa", "wheel.young_modulus", 1e6),
    ("poisson_ratio", "wheel.poisson_ratio", 1.0),
    ("rail_young_modulus_mpa", "rail.young_modulus", 1e6),
    ("rail_poisson_ratio", "rail.poisson_ratio", 1.0),
    ("normal_model", "normal.model", 0.0),
    ("tangential_model", "tangential.model", 0.0),
    ("shape_fit", "normal.shape_fit", 0.0),
    ("strips", "normal.strips", 0.0),
    ("elements_along", "tangential.elements_along", 0.0),
    ("elements_across", "normal.elements_across", 0.0),
    ("bound", "tangential.bound", 0.0),
    ("flexibilities", "tangential.flexibilities", 0.0),
    ("falling_share", "friction.falling.share", 1.0),
    ("falling_decay_s_per_m", "friction.falling.decay", 1.0),
    ("reduction_initial", "friction.reduction.initial", 1.0),
    ("reduction_share", "friction.reduction.share", 1.0),
    ("reduction_decay", "friction.reduction.decay", 1.0),
];

const OTHER_COLUMNS: [&str; 8] = [
    "separation",
    "radius_mm",
    "approach_mm",
    "load_n",
    "creepage_longitudinal",
    "creepage_lateral",
    "spin_per_mm",
    "speed_m_s",
];

/// One planar case.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// File of the separation.
    pub separation: PathBuf,
    /// Column that names it.
    pub separation_column: usize,
    /// File, row and line, for complaints.
    pub place: String,
    radius: f64,
    indentation: Indentation,
    creepage: [f64; 3],
    friction: f64,
    speed: f64,
    parameters: Parameters,
}

/// Checks that all columns are known, `others` among them, and those needed are there.
pub fn check(cases: &Cases, others: &[&str]) -> Result<()> {
    let variables = VARIABLE_COLUMNS.iter().map(|c| c.0);
    let known: Vec<&str> =
        OTHER_COLUMNS.into_iter().chain(variables).chain(others.iter().copied()).collect();
    if let Some(name) = cases.header().columns().find(|name| !known.contains(name)) {
        if find(name).is_ok() && cases.column("separation").is_none() {
            bail!(
                "{}: a table of variables is one for evaluate",
                cases.header().column_place(name)
            );
        }
        bail!(
            "{}: unknown; known columns are {}",
            cases.header().column_place(name),
            known.join(", ")
        );
    }
    for name in ["separation", "radius_mm"] {
        if cases.column(name).is_none() {
            bail!("{}: missing", cases.header().column_place(name));
        }
    }
    Ok(())
}

impl Case {
    /// Reads the case in `row`.
    pub fn read(cases: &Cases, row: &Row) -> Result<Self> {
        let value = |name: &str| row.number_named(name);
        let positive = |name: &str| -> Result<Option<f64>> {
            match value(name)? {
                Some(number) if number <= 0.0 => {
                    bail!("{}, column \"{name}\": {number} is not admitted: above 0", row.place())
                }
                value => Ok(value),
            }
        };
        let needed = |name: &str| format!("{}, column \"{name}\": empty", row.place());
        let separation_column = cases.column("separation").with_context(|| needed("separation"))?;
        let file = row.cell(separation_column).with_context(|| needed("separation"))?;
        let radius = positive("radius_mm")?.with_context(|| needed("radius_mm"))?;
        let indentation = match (positive("approach_mm")?, positive("load_n")?) {
            (Some(approach), None) => Indentation::Approach(1e-3 * approach),
            (None, Some(load)) => Indentation::Load(load),
            (None, None) => bail!("{}: give approach_mm or load_n", row.place()),
            (Some(_), Some(_)) => bail!("{}: give approach_mm or load_n, not both", row.place()),
        };
        let creepage = [
            value("creepage_longitudinal")?.unwrap_or(0.0),
            value("creepage_lateral")?.unwrap_or(0.0),
            1e3 * value("spin_per_mm")?.unwrap_or(0.0),
        ];
        let values = variables(cases, row)?;
        Ok(Self {
            separation: cases.header().folder().join(file),
            separation_column,
            place: row.place(),
            radius: 1e-3 * radius,
            indentation,
            creepage,
            friction: values.input.friction,
            speed: value("speed_m_s")?.unwrap_or(0.0),
            parameters: values.parameters,
        })
    }

    /// Takes boundary elements as normal and as tangential model.
    pub fn solve_by_boundary_elements(&mut self, normal: bool, tangential: bool) {
        if normal {
            self.parameters.normal_model = NormalModel::BoundaryElement;
        }
        if tangential {
            self.parameters.tangential_model = TangentialModel::BoundaryElement;
        }
    }

    /// Whether it takes milliseconds.
    pub fn is_slow(&self) -> bool {
        is_slow(self.parameters.normal_model, self.parameters.tangential_model)
    }

    /// The case with the points of its separation file.
    pub fn planar<'a>(&self, separation: &'a [[f64; 2]]) -> PlanarCase<'a> {
        let Self { radius, indentation, creepage, friction, speed, .. } = *self;
        let case = self.parameters.planar_case(separation, radius, indentation, creepage, friction);
        PlanarCase { speed, ..case }
    }
}

/// The element's variables as the row sets them; the range of each is checked there.
fn variables(cases: &Cases, row: &Row) -> Result<Values> {
    let mut values = Values::default();
    for (name, variable, scale) in VARIABLE_COLUMNS {
        // Without columns of its own the rail is of the material of the wheel.
        let own = cases.column(name).filter(|&column| row.cell(column).is_some());
        let shared = name.strip_prefix("rail_").and_then(|name| cases.column(name));
        let Some((column, text)) =
            own.or(shared).and_then(|column| Some((column, row.cell(column)?)))
        else {
            continue;
        };
        let text = if scale > 0.0 {
            format!("{:?}", scale * row.number(column)?)
        } else {
            text.to_string()
        };
        let variable = find(variable)?;
        values.set_from_text(variable, &text).with_context(|| row.cell_place(column))?;
    }
    // One column for both: elements along a strip, or boundary elements along the contact.
    if cases.column("elements_along").is_some_and(|column| row.cell(column).is_some()) {
        values.parameters.normal_elements[0] = values.parameters.elements_along;
    }
    Ok(values)
}
