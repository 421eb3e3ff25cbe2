//! `wheelrail transient`: a planar contact problem followed through the rows of a table.

use anyhow::{Context, Result, bail};
use clap::Args;
use wheelrail::planar::{StepMotion, TransientContact, TransientResult};

use crate::cases::{Cases, Row};
use crate::options::TableFiles;
use crate::output;
use crate::planar_cases::{PlanarCases, contact_cells};

/// Columns of the motion, besides those of planar cases.
const MOTION: [&str; 7] = [
    "rolled_mm",
    "shift_x_mm",
    "shift_y_mm",
    "turn_rad",
    "force_longitudinal_n",
    "force_lateral_n",
    "steps",
];

/// Most steps of one row.
const MAX_STEPS: f64 = 1e6;

/// Follow a planar contact problem with memory through the rows of a table
///
/// Each row is a state of the contact, of which the tractions of the row before are the history:
/// first loading, shifts, rolling from rest, oscillating creepage or load, contacts that split,
/// merge, end and begin. Boundary elements. Forces and moment act on the upper body, the wheel;
/// x is forward, y to the right; the moment is about the origin of the separation file.
///
/// Columns of STATES: those of `wheelrail patch` (models are boundary elements), and
///   rolled_mm                 distance rolled since the state before (0: a shift; negative: backward)
///   shift_x_mm, shift_y_mm, turn_rad    displacement of the wheel against the rail and turn about
///                             the normal, on top of creepage times the distance rolled (0)
///   force_longitudinal_n, force_lateral_n   creep force on the wheel, where it is given: that
///                             component of the displacement is found
///   steps                     how many times the row is gone through (1), each time a row of the
///                             result
///
/// An empty cell is as if the column were left out. The result has a row for each step: the row of
/// STATES, the distance rolled from the first on, forces, contact, the displacement of the step, the
/// work that friction took up in it, and how it was solved.
#[derive(Args, Debug)]
#[command(verbatim_doc_comment)]
pub struct Arguments {
    /// Where the states come from and the results go.
    #[command(flatten)]
    pub files: TableFiles,
    /// Length of an element along rolling in mm; without it `elements_along` of the first state
    #[arg(long, requires = "element_width")]
    pub element_length: Option<f64>,
    /// Width of an element in mm; without it `elements_across` of the first state
    #[arg(long, requires = "element_length")]
    pub element_width: Option<f64>,
}

/// Goes through all rows.
pub fn run(arguments: &Arguments) -> Result<()> {
    let table = Cases::read(&arguments.files.cases)?;
    let path = arguments.files.output.as_deref();
    output::check_names([arguments.files.cases.as_path()], [path])?;
    let states = PlanarCases::of_boundary_elements(&table, &MOTION, &[path])?;
    let motions = table.rows().iter().map(motion).collect::<Result<Vec<_>>>()?;
    let mut contact = match (arguments.element_length, arguments.element_width) {
        (Some(length), Some(width)) => {
            TransientContact::with_element_size([1e-3 * length, 1e-3 * width])?
        }
        _ => TransientContact::new(),
    };
    let out = output::table(path)?;
    let total: usize = motions.iter().map(|(_, steps)| steps).sum();
    let progress = output::progress(Some(total), path)?;
    let mut go = || -> Result<()> {
        let mut distance = 0.0;
        for (n, (case, (motion, steps))) in states.cases.iter().zip(&motions).enumerate() {
            let planar = states.planar(case);
            for _ in 0..*steps {
                let found = contact.step(&planar, motion).with_context(|| case.place.clone())?;
                distance += motion.rolled;
                out.write_named(&cells(n + 1, distance, &found))?;
                progress.inc(1);
            }
        }
        Ok(())
    };
    let result = go();
    progress.finish_and_clear();
    out.complete(result)
}

/// The motion of a row, and how many times.
fn motion(row: &Row) -> Result<(StepMotion, usize)> {
    let value = |name: &str| row.number_named(name);
    let or_zero = |name: &str| value(name).map(|value| value.unwrap_or(0.0));
    let steps = value("steps")?.unwrap_or(1.0);
    if !(1.0..=MAX_STEPS).contains(&steps) || steps.fract() > 0.0 {
        bail!(
            "{}, column \"steps\": {steps} is not admitted: a whole number, 1 to 1000000",
            row.place()
        );
    }
    let motion = StepMotion {
        rolled: 1e-3 * or_zero("rolled_mm")?,
        shift: [1e-3 * or_zero("shift_x_mm")?, 1e-3 * or_zero("shift_y_mm")?, or_zero("turn_rad")?],
        force: [value("force_longitudinal_n")?, value("force_lateral_n")?],
        ..StepMotion::default()
    };
    Ok((motion, steps as usize))
}

fn cells(row: usize, distance: f64, found: &TransientResult) -> Vec<(&'static str, String)> {
    let number = |value: f64| format!("{value:?}");
    let [x, y, turn] = found.displacement;
    let place = [("row", row.to_string()), ("distance_mm", number(1e3 * distance))];
    let step = [
        ("displacement_x_mm", number(1e3 * x)),
        ("displacement_y_mm", number(1e3 * y)),
        ("turn_rad", number(turn)),
        ("friction_work_j", number(found.work)),
        ("substeps", found.substeps.to_string()),
        ("sweeps", found.sweeps.to_string()),
        ("converged", u8::from(found.converged).to_string()),
    ];
    place.into_iter().chain(contact_cells(&found.contact)).chain(step).collect()
}
