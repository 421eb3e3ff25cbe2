//! `wheelrail compare`: how far the models of each row are from the boundary element solution.

mod compared;
mod planar;
mod reference;
mod summary;
mod wheel;

use std::path::PathBuf;

use anyhow::{Context, Result};
use clap::Args;
use wheelrail::io::number;
use wheelrail::variables::{Kind, find};

use crate::cases::{Cases, Header};
use crate::element_rows::{placed, read_values};
use crate::figures::errors::{self, Line};
use crate::options::TableFiles;
use crate::planar_cases::PlanarCases;
use crate::remarks::{Found, Remarks};
use crate::{batch, models, output};

use compared::Compared;
use summary::Summary;

/// Compare the models of each row of a table with the boundary element solution
///
/// CASES is a table as for patch (planar problems; it has a column separation) or as for evaluate
/// (a wheel on rails, its height by wheel.z or with vertical.mode load by wheel.load). Each row is
/// solved by its own models and by boundary elements; where the row asks for no creep forces
/// neither computes any. normal.elements_along and _across (elements_along and elements_across in
/// planar tables) set the grid of the boundary elements, 40 by 40 to begin with.
///
/// On wheels the boundary elements lie on the curved surface of the rail, all contacts of a rail in
/// one problem. A second solution with half as many elements each way tells their own error: by how
/// much the two differ. Patches in one problem tell where contacts are separate, the angle between
/// their outermost normals how far a contact turns. The largest distance left in the contact (over
/// the overlap) and the largest slip that contradicts friction (over the rigid slip) tell how well
/// the equations are solved.
///
/// The result has one row for each case: both solutions, the errors of the row's models, and the
/// time each took. Errors of normal force, greatest pressure and area are in percent of the
/// boundary element solution, that of the creep force in percent of the friction limit, that of the
/// spin moment in percent of friction limit times sqrt(area/pi). Median, 95 % and worst of the
/// errors go to standard output if the result goes to a file, else to standard error.
#[derive(Args, Debug)]
#[command(verbatim_doc_comment)]
pub struct Arguments {
    /// Where the cases come from and the results go.
    #[command(flatten)]
    pub files: TableFiles,
    /// File for median, 95 % and worst of the errors, CSV
    #[arg(long, value_name = "FILE")]
    pub summary: Option<PathBuf>,
    /// Figure of the errors over the first column of CASES, a line for each value of the second,
    /// SVG
    #[arg(long, value_name = "FILE.svg")]
    pub figure: Option<PathBuf>,
}

/// Compares all rows.
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
        let given = header.columns().zip(inputs[written].iter().cloned());
        table.write_named(&given.chain(compared.cells()).collect::<Vec<_>>())?;
        add_to_lines(&mut lines, header, &inputs, written, &compared);
        written += 1;
        summary.add(&compared);
        Ok(())
    };
    let mut own_models: Vec<String>;
    let cores = batch::all_cores();
    let result = if cases.column("separation").is_some() {
        let planar = PlanarCases::read(&cases, &outputs)?;
        let all = planar.cases.iter().map(|case| planar.planar(case));
        own_models = all.map(|c| models::names(c.normal_model, c.tangential_model)).collect();
        batch::in_order(
            &progress,
            planar.cases.iter().map(Ok),
            cores,
            || (),
            |(), case| {
                let compared = planar::compare(&planar.planar(case));
                Ok((compared.with_context(|| case.place.clone())?, Found::default()))
            },
            &mut done,
        )
    } else {
        let all = read_values(&cases, &[], &outputs)?;
        let parameters = all.iter().map(|(_, values)| &values.parameters);
        own_models =
            parameters.map(|p| models::names(p.normal_model, p.tangential_model)).collect();
        let folder = header.folder();
        batch::in_order(
            &progress,
            all.iter().map(Ok),
            cores,
            || (),
            |(), (row, values)| {
                let compared = wheel::compare(values, &folder);
                let (compared, found) = compared.map_err(|error| placed(error, row))?;
                let given = row.cells().map(|(_, name, _)| name);
                let found = found.with_inputs(&values.parameters, given);
                Ok((compared, found.at(|| row.place())))
            },
            &mut done,
        )
    };
    remarks.count();
    table.complete(result)?;
    if let Some(path) = &arguments.summary {
        summary.write(output::table(Some(path))?)?;
    }
    if let Some(path) = &arguments.figure {
        own_models.sort_unstable();
        own_models.dedup();
        let models = if let [one] = own_models.as_slice() { one } else { "fast models" };
        let first = header.columns().next().unwrap_or_default();
        let first = if is_drawn_over(header, &inputs) { first } else { "row" };
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

/// Whether errors can be drawn over the first column; over what is no number, such as the profile
/// 60E1, they are drawn row by row.
fn is_drawn_over(header: &Header, all: &[Vec<String>]) -> bool {
    let first = header.columns().next().and_then(|name| find(name).ok());
    let is_real = first.is_none_or(|variable| matches!(variable.kind, Kind::Real | Kind::Integer));
    is_real && all.iter().all(|row| row.first().is_some_and(|text| number(text).is_some()))
}

/// Adds a case to the line of its second column, at the value of its first.
fn add_to_lines(
    lines: &mut Vec<Line>,
    header: &Header,
    all: &[Vec<String>],
    row: usize,
    compared: &Compared,
) {
    let is_number = is_drawn_over(header, all);
    let given = all[row].first().and_then(|text| number(text)).filter(|_| is_number);
    let at = given.unwrap_or((row + 1) as f64);
    let name = match (header.columns().nth(1), all[row].get(1)) {
        (Some(column), Some(value)) if is_number => {
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
