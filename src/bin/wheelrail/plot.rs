//! `wheelrail plot`: one case as a figure and its fields as a table.

mod worn;

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use clap::Args;
use wheelrail::element::parameters::{
    NormalModel, TangentialHistory, TangentialModel, VerticalMode,
};
use wheelrail::element::{Element, FlatContact, Input, Output, Parameters};
use wheelrail::planar::{Adherence, ContactField, Indentation, PlanarCase, fields};
use wheelrail::variables::Values;

use crate::cases::Cases;
use crate::element_rows::read_values;
use crate::figures::contact::Figure;
use crate::figures::patch_panel::Side;
use crate::planar_cases::PlanarCases;
use crate::remarks::{Found, Remarks};
use crate::{models, output};

/// Draw the contact of one case: pressure, tractions, adhesion and slip by its own models and by
/// boundary elements
///
/// CASES is a table as for patch (with a column separation) or as for evaluate; --row says which of
/// its rows. For a wheel on rails the profiles and the places where they touch are drawn too, and
/// the patch is that of the contact --contact, 1 for the most loaded one; its problem is laid flat,
/// without the shift of the contact line that yaw brings. Wheels roll forward.
///
/// The left half of the figure shows the models of the row, the right half boundary elements.
/// Models that march along the strips and boundary elements have tractions to show; of tables only
/// the pressure is drawn. Creepage is that of the tangent plane of the contact, whatever
/// creepage.model is.
///
/// With --worn-wheel or --worn-rail instead of CASES the worn profiles, as a run of the FMU with
/// wear.wheel.file or wear.rail[1].file leaves them, are drawn on those they were, and the wear
/// depth along the normal of those over y.
#[derive(Args, Debug)]
#[command(verbatim_doc_comment)]
pub struct Arguments {
    /// Table of cases, CSV
    #[arg(value_name = "CASES.csv", required_unless_present_any = ["worn_wheel", "worn_rail"], conflicts_with_all = ["worn_wheel", "worn_rail"])]
    cases: Option<PathBuf>,
    /// Row of the table, from 1
    #[arg(long, default_value_t = 1, value_name = "N")]
    row: usize,
    /// Contact of a wheel, from 1, the most loaded one first
    #[arg(long, default_value_t = 1, value_name = "N")]
    contact: usize,
    /// Figure, SVG
    #[arg(long, short, value_name = "FILE.svg", default_value = "contact.svg")]
    output: PathBuf,
    /// Table of the fields of both solutions, one row for each element, or of the wear depth, CSV
    #[arg(long, value_name = "FILE.csv")]
    fields: Option<PathBuf>,
    /// Worn profile of a wheel
    #[arg(long, value_name = "PROFILE", help_heading = "Wear")]
    worn_wheel: Option<String>,
    /// Worn profile of a rail
    #[arg(long, value_name = "PROFILE", help_heading = "Wear")]
    worn_rail: Option<String>,
    /// Profile that the wheel had
    #[arg(long, value_name = "PROFILE", default_value = "S1002", help_heading = "Wear")]
    unworn_wheel: String,
    /// Profile that the rail had
    #[arg(long, value_name = "PROFILE", default_value = "60E1", help_heading = "Wear")]
    unworn_rail: String,
    /// Smoothing of profiles from files that do not state one: wavelength [m]
    #[arg(long, value_name = "M", default_value_t = 0.0, help_heading = "Wear")]
    smoothing: f64,
}

/// Draws the case.
pub fn run(arguments: &Arguments) -> Result<()> {
    output::check_figure(&arguments.output)?;
    let read = [&arguments.worn_wheel, &arguments.worn_rail].into_iter().flatten().map(Path::new);
    let read = read.chain([&arguments.unworn_wheel, &arguments.unworn_rail].map(Path::new));
    let read = read.chain(arguments.cases.as_deref());
    let outputs = [Some(arguments.output.as_path()), arguments.fields.as_deref()];
    output::check_names(read, outputs)?;
    let Some(path) = &arguments.cases else {
        return worn::draw(&worn::Request {
            wheel: arguments.worn_wheel.as_deref(),
            rail: arguments.worn_rail.as_deref(),
            unworn_wheel: &arguments.unworn_wheel,
            unworn_rail: &arguments.unworn_rail,
            smoothing: arguments.smoothing,
            figure: &arguments.output,
            fields: arguments.fields.as_deref(),
        });
    };
    let cases = Cases::with_row(path, arguments.row)?;
    if cases.column("separation").is_some() {
        let planar = PlanarCases::read(&cases, &outputs)?;
        let (case, title) = planar.row(arguments.row);
        draw(arguments, &figure(&case, title, Vec::new(), 0, false)?)
    } else {
        let all = read_values(&cases, &[], &outputs)?;
        let (row, values) = &all[arguments.row - 1];
        let (contacts, index) = contacts(values, &cases.header().folder(), arguments.contact)
            .with_context(|| row.place())?;
        let load_given = values.parameters.vertical_mode == VerticalMode::Load;
        let figure = wheel_figure(values, &contacts, index, load_given);
        draw(arguments, &figure.with_context(|| row.place())?)
    }
}

/// The contacts of a wheel and the index of the one asked for, 1 for the most loaded one; its files
/// lie in `folder`.
pub fn contacts(
    values: &Values,
    folder: &Path,
    number: usize,
) -> Result<(Vec<FlatContact>, usize)> {
    let contacts = all_contacts(values, folder)?;
    let mut order: Vec<usize> = (0..contacts.len()).collect();
    order.sort_by(|&a, &b| contacts[b].penetration.total_cmp(&contacts[a].penetration));
    match order.get(number.wrapping_sub(1)) {
        Some(&index) => Ok((contacts, index)),
        None if contacts.is_empty() => bail!("the wheel touches no rail: nothing to draw"),
        None => bail!("--contact {number}: the wheel has contacts 1 to {}", contacts.len()),
    }
}

/// The contacts of a wheel, after its remarks are told; its files lie in `folder`.
pub fn all_contacts(values: &Values, folder: &Path) -> Result<Vec<FlatContact>> {
    let Values { parameters, input, .. } = values;
    let mut element = Element::new(parameters, input, &[folder.into()])?;
    let mut output = Output::default();
    element.evaluate(input, &mut output)?;
    let found = Found::evaluated(&element, parameters, input, &output).with_start(&element);
    Remarks::default().tell(&found.with_profiles(element.profile_remarks().to_vec()));
    let mut at = *input;
    at.wheel.position[2] = output.wheel_z;
    Ok(element.flat_contacts(&at)?)
}

/// The heaviest contact of a wheel that rolls steadily as a figure; its files lie in `folder`.
pub fn of_wheel(parameters: &Parameters, input: &Input, folder: &Path) -> Result<Figure> {
    let mut values = Values { parameters: parameters.clone(), input: *input, ..Values::default() };
    // Steady rolling is what contacts that remember begin with.
    values.parameters.tangential_history = TangentialHistory::Steady;
    let (contacts, index) = contacts(&values, folder, 1)?;
    let load_given = parameters.vertical_mode == VerticalMode::Load;
    wheel_figure(&values, &contacts, index, load_given)
}

/// One contact of a wheel as a figure.
fn wheel_figure(
    values: &Values,
    contacts: &[FlatContact],
    index: usize,
    load_given: bool,
) -> Result<Figure> {
    let contact = &contacts[index];
    let title = format!(
        "{} on {}, contact angle {:.2} degrees",
        values.parameters.wheel.profile,
        values.parameters.rails[contact.rail as usize - 1].profile,
        contact.contact_angle.to_degrees()
    );
    let speed = values.input.wheel.velocity[0].abs();
    let case = values.parameters.flat_case(contact, speed)?;
    figure(&case, title, contacts.to_vec(), index, load_given)
}

fn draw(arguments: &Arguments, figure: &Figure) -> Result<()> {
    if let Some(path) = &arguments.fields {
        write_fields(path, &figure.sides)?;
    }
    figure.draw(&arguments.output)?;
    std::iter::once(&arguments.output)
        .chain(&arguments.fields)
        .try_for_each(|path| output::say(&format!("{}\n", path.display())))
}

fn figure(
    case: &PlanarCase<'_>,
    title: String,
    contacts: Vec<FlatContact>,
    drawn: usize,
    same_load: bool,
) -> Result<Figure> {
    // At the height that carries the load by the models of the row, boundary elements carry another
    // one.
    let indentation = if same_load {
        Indentation::Load(wheelrail::planar::solve(case)?.normal_force)
    } else {
        case.indentation
    };
    let reference = PlanarCase {
        indentation,
        normal_model: NormalModel::BoundaryElement,
        tangential_model: if case.tangential_model == TangentialModel::None {
            TangentialModel::None
        } else {
            TangentialModel::BoundaryElement
        },
        ..*case
    };
    let side = |case: &PlanarCase<'_>| -> Result<Side> {
        let result = wheelrail::planar::solve(case)?;
        Ok(Side {
            name: models::names(case.normal_model, case.tangential_model),
            fields: fields(case)?,
            result,
        })
    };
    let sides = [side(case)?, side(&reference)?];
    if sides.iter().any(|side| side.fields.is_empty()) {
        bail!("no contact to draw: the bodies do not touch");
    }
    Ok(Figure { title, contacts, drawn, sides })
}

fn write_fields(path: &Path, sides: &[Side; 2]) -> Result<()> {
    let table = output::table(Some(path))?;
    for side in sides {
        for (zone, field) in side.fields.iter().enumerate() {
            for (k, &pressure) in field.pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
                table.write_named(&field_row(&side.name, zone, field, k, pressure))?;
            }
        }
    }
    table.finish()
}

fn field_row(
    models: &str,
    zone: usize,
    field: &ContactField,
    k: usize,
    pressure: f64,
) -> [(&'static str, String); 10] {
    let (grid, [px, py]) = (&field.grid, field.traction[k]);
    let number = |value: f64| format!("{value:.6}");
    let slip = |c: usize| {
        field.slip.as_ref().map_or_else(String::new, |slip| format!("{:.6e}", slip[k][c]))
    };
    [
        ("models", models.into()),
        ("zone", (zone + 1).to_string()),
        ("x_mm", number(1e3 * grid.x(k % grid.along))),
        ("y_mm", number(1e3 * grid.y(k / grid.along))),
        ("pressure_mpa", number(1e-6 * pressure)),
        ("traction_x_mpa", number(1e-6 * px)),
        ("traction_y_mpa", number(1e-6 * py)),
        ("slip_x", slip(0)),
        ("slip_y", slip(1)),
        (
            "state",
            match field.adherence[k] {
                Adherence::None => "none",
                Adherence::Adhesion => "adhesion",
                Adherence::Slip => "slip",
            }
            .into(),
        ),
    ]
}
