//! `wheelrail compare`: how far the models of each row are from the boundary element solution.

mod summary;
mod wheel;

use std::path::PathBuf;

use anyhow::{Context, Result};
use clap::Args;
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::io::number;
use wheelrail::planar::PlanarCase;
use wheelrail::variables::find;

use crate::args::TableFiles;
use crate::cases::{Cases, Header};
use crate::figures::errors::{self, Line};
use crate::patch::{PlanarCases, timed};
use crate::remarks::{Found, Remarks};
use crate::{batch, evaluate, figures, output};

use summary::Summary;

/// Compare the models of each row of a table with the boundary element solution
///
/// CASES is a table as for patch (planar problems; it has a column separation) or as for evaluate (a wheel on rails, its
/// height by wheel.z or with vertical.mode load by wheel.load). Each row is solved by its own models and by boundary elements;
/// where the row asks for no creep forces neither computes any. normal.elements_along and _across (elements_along and
/// elements_across in planar tables) set the grid of the boundary elements, 40 by 40 to begin with.
///
/// On wheels the boundary elements lie on the curved surface of the rail, all contacts of a rail in one problem. A second solution with half
/// as many elements each way tells their own error: by how much the two differ. Patches in one problem tell where contacts are separate,
/// the angle between their outermost normals how far a contact turns. The largest distance left in the contact (over the
/// overlap) and the largest slip that contradicts friction (over the rigid slip) tell how well the equations are solved.
///
/// The result has one row for each case: both solutions, the errors of the row's models, and the time each took. Errors
/// of normal force, greatest pressure and area are in percent of the boundary element solution, that of the creep force in percent
/// of the friction limit, that of the spin moment in percent of friction limit times sqrt(area/pi). Median, 95 % and worst
/// of the errors go to standard output if the result goes to a file, else to standard error.
// The text is shown as it stands by --help.
#[allow(clippy::doc_markdown)]
#[derive(Args, Debug)]
#[command(verbatim_doc_comment)]
pub struct Arguments {
    /// Where the cases come from and the results go.
    #[command(flatten)]
    pub files: TableFiles,
    /// File for median, 95 % and worst of the errors, CSV
    #[arg(long, value_name = "FILE")]
    pub summary: Option<PathBuf>,
    /// Figure of the errors over the first column of CASES, a line for each value of the second, SVG
    #[arg(long, value_name = "FILE.svg")]
    pub figure: Option<PathBuf>,
}

/// What one solution of a case gives.
#[derive(Clone, Copy, Debug, Default)]
pub struct Solved {
    /// Normal force of all patches [N].
    pub normal_force: f64,
    /// Greatest pressure [Pa].
    pub max_pressure: f64,
    /// Area of all patches [m²].
    pub area: f64,
    /// Creep force of all patches; in planar cases z is 0 [N].
    pub creep_force: [f64; 3],
    /// Moment of the tractions about the normal through the origin or the centroid of load [N m].
    pub spin_moment: f64,
    /// Number of patches.
    pub patches: usize,
    /// Whether a solver fell back to a simpler model.
    pub fallback: bool,
    /// Time it took [s].
    pub time: f64,
}

/// A case by both kinds of models.
#[derive(Clone, Copy, Debug)]
pub struct Compared {
    /// By the models of the row.
    pub own: Solved,
    /// By boundary elements.
    pub reference: Solved,
    /// By boundary elements, half as many along and across.
    pub coarse: Solved,
    /// Angle between the outermost normals of one rail's contact in the reference, where it tells [rad].
    pub turn: Option<f64>,
    /// What the equations of the reference are left with, where it tells: distance over overlap, slip over rigid slip.
    pub residuals: Option<[f64; 2]>,
    /// Coefficient of friction.
    pub friction: f64,
}

/// The columns of the result.
const COLUMNS: [&str; 30] = [
    "normal_force_n",
    "reference_normal_force_n",
    "normal_force_error_percent",
    "max_pressure_mpa",
    "reference_max_pressure_mpa",
    "max_pressure_error_percent",
    "area_mm2",
    "reference_area_mm2",
    "area_error_percent",
    "fx_n",
    "fy_n",
    "fz_n",
    "reference_fx_n",
    "reference_fy_n",
    "reference_fz_n",
    "creep_force_error_percent",
    "spin_moment_error_percent",
    "patches",
    "reference_patches",
    "fallback",
    "reference_fallback",
    "time_us",
    "reference_time_us",
    "reference_normal_force_uncertainty_percent",
    "reference_max_pressure_uncertainty_percent",
    "reference_area_uncertainty_percent",
    "reference_creep_force_uncertainty_percent",
    "reference_normals_turn_deg",
    "reference_normal_residual",
    "reference_tangential_residual",
];

impl Compared {
    /// Errors of normal force, pressure, area, creep force and spin moment [%]; nothing where the reference has none to refer to.
    pub fn errors(&self) -> [Option<f64>; 5] {
        self.differences(&self.own)
    }

    /// By how much the reference with half as many elements differs, as an estimate of the reference's own errors [%].
    pub fn uncertainties(&self) -> [Option<f64>; 5] {
        self.differences(&self.coarse).map(|error| error.map(f64::abs))
    }

    fn differences(&self, own: &Solved) -> [Option<f64>; 5] {
        let Self { reference, friction, .. } = self;
        let relative = |own: f64, exact: f64| (exact > 0.0).then(|| 100.0 * (own / exact - 1.0));
        let limit = friction * reference.normal_force;
        let missed = (0..3)
            .map(|c| (own.creep_force[c] - reference.creep_force[c]).powi(2))
            .sum::<f64>()
            .sqrt();
        let arm = (reference.area / std::f64::consts::PI).sqrt();
        let turned = own.spin_moment - reference.spin_moment;
        [
            relative(own.normal_force, reference.normal_force),
            relative(own.max_pressure, reference.max_pressure),
            relative(own.area, reference.area),
            (limit > 0.0).then(|| 100.0 * missed / limit),
            (limit * arm > 0.0).then(|| 100.0 * turned / (limit * arm)),
        ]
    }

    fn cells(&self) -> [String; COLUMNS.len()] {
        let number = |value: f64| format!("{value:?}");
        let error = |value: Option<f64>| value.map_or_else(String::new, |v| format!("{v:.4}"));
        let [n, p, a, f, m] = self.errors().map(error);
        let (own, reference) = (&self.own, &self.reference);
        let [fx, fy, fz] = own.creep_force.map(number);
        let [rx, ry, rz] = reference.creep_force.map(number);
        let [un, up, ua, uf, _] = self.uncertainties().map(error);
        let turn = self.turn.map_or_else(String::new, |turn| format!("{:.3}", turn.to_degrees()));
        let [gap, slip] = self.residuals.map_or([const { String::new() }; 2], |residuals| {
            residuals.map(|residual| format!("{residual:.1e}"))
        });
        [
            number(own.normal_force),
            number(reference.normal_force),
            n,
            number(1e-6 * own.max_pressure),
            number(1e-6 * reference.max_pressure),
            p,
            number(1e6 * own.area),
            number(1e6 * reference.area),
            a,
            fx,
            fy,
            fz,
            rx,
            ry,
            rz,
            f,
            m,
            own.patches.to_string(),
            reference.patches.to_string(),
            u8::from(own.fallback).to_string(),
            u8::from(reference.fallback).to_string(),
            format!("{:.2}", 1e6 * own.time),
            format!("{:.2}", 1e6 * reference.time),
            un,
            up,
            ua,
            uf,
            turn,
            gap,
            slip,
        ]
    }
}

/// Compares all rows.
///
/// # Errors
/// With row and column: what is unknown, missing or refused. Rows before it are written.
pub fn run(arguments: &Arguments) -> Result<()> {
    let path = arguments.files.output.as_deref();
    let outputs = [path, arguments.summary.as_deref(), arguments.figure.as_deref()];
    output::check_names([arguments.files.cases.as_path()], outputs)?;
    let cases = Cases::read(&arguments.files.cases)?;
    let table = output::table(path)?;
    let progress = output::progress(Some(cases.rows().len()), path)?;
    let header = cases.header();
    let mut summary = Summary::default();
    // The columns of the table come first, so that a row says what it is.
    let inputs: Vec<Vec<String>> = (cases.rows().iter())
        .map(|row| {
            (0..header.columns().count()).map(|c| row.cell(c).unwrap_or("").into()).collect()
        })
        .collect();
    let mut written = 0;
    let mut lines: Vec<Line> = Vec::new();
    let mut remarks = Remarks::default();
    let mut done = |(compared, found): (Compared, Found)| -> Result<()> {
        progress.suspend(|| remarks.tell(&found));
        if written == 0 {
            table.write_record(header.columns().chain(COLUMNS))?;
        }
        let cells = compared.cells();
        table.write_record(inputs[written].iter().chain(&cells))?;
        add_to_lines(&mut lines, header, &inputs[written], &compared);
        written += 1;
        summary.add(&compared);
        progress.inc(1);
        Ok(())
    };
    let mut models: Vec<String>;
    let cores = batch::all_cores();
    let result = if cases.column("separation").is_some() {
        let planar = PlanarCases::read(&cases)?;
        output::check_names(planar.separation_files(), outputs)?;
        let all = planar.cases.iter().map(|case| planar.planar(case));
        models = all.map(|c| figures::models(c.normal_model, c.tangential_model)).collect();
        batch::in_order(
            planar.cases.iter().map(Ok),
            cores,
            || (),
            |(), case| {
                let compared = compare_planar(&planar.planar(case));
                Ok((compared.with_context(|| case.place.clone())?, Found::default()))
            },
            &mut done,
        )
    } else {
        let all = evaluate::read_values(&cases, &outputs)?;
        let parameters = all.iter().map(|(_, values)| &values.parameters);
        models = parameters.map(|p| figures::models(p.normal_model, p.tangential_model)).collect();
        let folder = header.folder();
        batch::in_order(
            all.iter().map(Ok),
            cores,
            || (),
            |(), (row, values)| {
                let compared = wheel::compare(values, &folder);
                let (compared, found) = compared.map_err(|error| evaluate::placed(error, row))?;
                Ok((compared, found.at(|| row.place())))
            },
            &mut done,
        )
    };
    progress.finish_and_clear();
    table.complete(result)?;
    if let Some(path) = &arguments.summary {
        summary.write(output::table(Some(path))?)?;
    }
    if let Some(path) = &arguments.figure {
        models.sort_unstable();
        models.dedup();
        let models = if let [one] = models.as_slice() { one } else { "fast models" };
        let first = header.columns().next().unwrap_or_default();
        let abscissa = match unit(first) {
            "" => first.to_owned(),
            unit => format!("{first} [{unit}]"),
        };
        errors::draw(path, models, &abscissa, &lines)?;
    }
    let text = summary.text();
    if path.is_some() {
        return output::say(&text);
    }
    eprint!("{text}");
    Ok(())
}

/// The unit of the variable of a column; those of planar tables have it in their names.
fn unit(column: &str) -> &'static str {
    find(column).map_or("", |variable| variable.unit)
}

/// Adds a case to the line of its second column, at the value of its first.
fn add_to_lines(lines: &mut Vec<Line>, header: &Header, inputs: &[String], compared: &Compared) {
    let Some(at) = inputs.first().and_then(|text| number(text)) else { return };
    let name = match (header.columns().nth(1), inputs.get(1)) {
        (Some(column), Some(value)) => {
            format!("{column} {value} {}", unit(column)).trim_end().into()
        }
        _ => String::new(),
    };
    let [n, p, a, f, _] = compared.errors();
    let point = (at, [n, p, a, f]);
    match lines.iter_mut().find(|line| line.name == name) {
        Some(line) => line.points.push(point),
        None => lines.push(Line { name, points: vec![point] }),
    }
}

/// Both solutions of a planar case.
fn compare_planar(case: &PlanarCase<'_>) -> Result<Compared> {
    let reference_case = PlanarCase {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: reference_tangential(case.tangential_model),
        ..*case
    };
    let solve = |case: &PlanarCase<'_>, slow: bool| -> Result<Solved> {
        let (result, time) = timed(case, slow)?;
        Ok(Solved {
            normal_force: result.normal_force,
            max_pressure: result.max_pressure,
            area: result.area,
            creep_force: [result.fx, result.fy, 0.0],
            spin_moment: result.mz,
            patches: result.patches,
            fallback: result.fallback,
            time,
        })
    };
    let slow = case.normal_model == NormalModel::BoundaryElement
        || case.tangential_model == TangentialModel::BoundaryElement;
    let coarse_case = PlanarCase { elements: half(reference_case.elements), ..reference_case };
    Ok(Compared {
        own: solve(case, slow)?,
        reference: solve(&reference_case, true)?,
        coarse: solve(&coarse_case, true)?,
        turn: None,
        residuals: None,
        friction: case.friction,
    })
}

/// Half as many elements along and across.
fn half(elements: [usize; 2]) -> [usize; 2] {
    elements.map(|count| count.div_ceil(2))
}

/// Boundary elements, if there is anything to compare.
fn reference_tangential(own: TangentialModel) -> TangentialModel {
    if own == TangentialModel::None { own } else { TangentialModel::BoundaryElement }
}
