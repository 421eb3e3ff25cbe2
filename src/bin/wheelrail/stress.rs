//! `wheelrail stress`: stresses below the surface of wheel or rail in one contact.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use clap::Args;
use wheelrail::planar::PlanarCase;
use wheelrail::subsurface::{Measure, SurfaceLoad};

use crate::cases::Cases;
use crate::element_rows::{placed, read_values};
use crate::figures::stress::{Figure, Section};
use crate::options::Of;
use crate::planar_cases::PlanarCases;
use crate::{models, output, plot};

/// Stresses below the surface of the rail or the wheel in the contact of one case, with a figure
///
/// CASES is a table as for patch (with a column separation) or as for evaluate; --row says which of
/// its rows, --contact which contact of a wheel. Its problem is laid flat, as for plot, and the body
/// is a half-space under the pressure and the tractions of the models of the row. Wheels roll
/// forward and steadily: rows with a history are refused.
///
/// Written to standard output: the greatest von Mises, Tresca, hydrostatic and orthogonal shear
/// stress, over the greatest pressure p0 too, and where they are. x is along rolling and y to the
/// right from the contact point, the depth counts from the surface into the body. Tension is
/// positive; Tresca is twice the greatest shear stress, the hydrostatic stress is the one of
/// greatest size, orthogonal shear acts on planes parallel to the surface.
///
/// The figure shows sections along and across rolling through the greatest von Mises stress, the
/// stresses on the vertical through it, and in the first section the orthogonal shear over x at the
/// depth where it is greatest along rolling. Linear theory, FaStrip and no tangential model have no tractions to show, and
/// stresses of the pressure alone; tables have the tractions of FASTSIM.
#[derive(Args, Debug)]
#[command(verbatim_doc_comment)]
pub struct Arguments {
    /// Table of cases, CSV
    #[arg(value_name = "CASES.csv")]
    cases: PathBuf,
    /// Row of the table, from 1
    #[arg(long, default_value_t = 1, value_name = "N")]
    row: usize,
    /// Contact of a wheel, from 1, the most loaded one first
    #[arg(long, default_value_t = 1, value_name = "N")]
    contact: usize,
    /// Which body
    #[arg(long, value_enum, default_value_t = Of::Rail)]
    body: Of,
    /// Figure, SVG
    #[arg(long, short, value_name = "FILE.svg", default_value = "stress.svg")]
    output: PathBuf,
    /// Table of displacements and stresses at the points of both sections, CSV
    #[arg(long, value_name = "FILE.csv")]
    points: Option<PathBuf>,
}

/// Writes the greatest stresses and draws them.
pub fn run(arguments: &Arguments) -> Result<()> {
    let Arguments { cases: path, row, output: figure, points, .. } = arguments;
    output::check_figure(figure)?;
    let outputs = [Some(figure.as_path()), points.as_deref()];
    output::check_names([path.as_path()], outputs)?;
    let cases = Cases::with_row(path, *row)?;
    if cases.column("separation").is_some() {
        let planar = PlanarCases::read(&cases, &outputs)?;
        let (case, title) = planar.row(*row);
        stresses(arguments, &case, &title)
    } else {
        let all = read_values(&cases, &[], &outputs)?;
        let (place, values) = &all[row - 1];
        let folder = cases.header().folder();
        let (contacts, index) =
            plot::contacts(values, &folder, arguments.contact).with_context(|| place.place())?;
        let (contact, parameters) = (&contacts[index], &values.parameters);
        let profiles =
            [&parameters.wheel.profile, &parameters.rails[contact.rail as usize - 1].profile];
        let title = format!("{} on {}", profiles[0], profiles[1]);
        let speed = values.input.wheel.velocity[0].abs();
        let case =
            parameters.flat_case(contact, speed).map_err(|refused| placed(refused, place))?;
        stresses(arguments, &case, &title)
    }
}

fn stresses(arguments: &Arguments, case: &PlanarCase<'_>, contact: &str) -> Result<()> {
    let name = if arguments.body == Of::Rail { "rail" } else { "wheel" };
    let load = SurfaceLoad::below(case, arguments.body.body())?;
    let title = format!(
        "Stresses below the surface of the {name}: {contact}, {}",
        models::names(case.normal_model, case.tangential_model)
    );
    let Some(figure) = Figure::new(title, &load)? else {
        bail!("no contact: the bodies do not touch");
    };
    if let Some(path) = &arguments.points {
        write_points(path, &figure.sections)?;
    }
    figure.draw(&arguments.output)?;
    let table = output::table(None)?;
    table.write_record(["stress", "value_mpa", "over_p0", "x_mm", "y_mm", "depth_mm"])?;
    for (measure, found) in Measure::ALL.iter().zip(&figure.greatest) {
        let mut row = vec![measure.name().to_owned(), format!("{:.3}", 1e-6 * found.value)];
        row.push(format!("{:.5}", found.value / load.max_pressure()));
        row.extend(found.point.iter().map(|x| format!("{:.4}", 1e3 * x)));
        table.write_record(row)?;
    }
    table.finish()
}

fn write_points(path: &Path, sections: &[Section; 2]) -> Result<()> {
    let table = output::table(Some(path))?;
    table.write_record([
        "section",
        "x_mm",
        "y_mm",
        "depth_mm",
        "ux_um",
        "uy_um",
        "uz_um",
        "sigma_xx_mpa",
        "sigma_yy_mpa",
        "sigma_zz_mpa",
        "sigma_xy_mpa",
        "sigma_yz_mpa",
        "sigma_xz_mpa",
        "von_mises_mpa",
        "tresca_mpa",
        "hydrostatic_mpa",
        "orthogonal_shear_mpa",
    ])?;
    for (section, name) in sections.iter().zip(["along", "across"]) {
        for (point, state) in section.points.iter().zip(&section.states) {
            let mut row = vec![name.to_owned()];
            row.extend(point.iter().map(|x| format!("{:.4}", 1e3 * x)));
            row.extend(state.displacement.iter().map(|u| format!("{:.4}", 1e6 * u)));
            row.extend(state.stress.components().iter().map(|s| format!("{:.4}", 1e-6 * s)));
            let values =
                Measure::ALL.map(|measure| format!("{:.4}", 1e-6 * measure.of(&state.stress)));
            row.extend(values);
            table.write_record(row)?;
        }
    }
    table.finish()
}
