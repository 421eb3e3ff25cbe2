//! `wheelrail conicity`: rolling radius difference and equivalent conicity of a wheelset.

use std::path::PathBuf;

use anyhow::{Result, bail};
use clap::Args;
use wheelrail::conicity::{RollingRadii, RollingRadiusDifference, TrackedWheelset};

use crate::options::{ContactOptions, Pair, check_positive};
use crate::remarks::{Found, Remarks};
use crate::{figures, output};

/// Rolling radius difference and equivalent conicity of a profile pair, by EN 15302
///
/// The wheelset is shifted sideways on its track, rigid and without rolling about x, until each
/// wheel touches its rail at one point. The table has one row for each lateral displacement y,
/// positive to the right: the difference of the rolling radii, right less left, radii and contact
/// points of both sides (on the profiles, positive to the field side), and for y > 0 the equivalent
/// conicity of a motion of the amplitude y. A conicity of 0 says that the wheelset does not swing
/// at that amplitude, an empty cell that one of the turning points lies beyond the range.
#[derive(Args, Debug)]
#[command(verbatim_doc_comment, allow_negative_numbers = true)]
pub struct Arguments {
    /// File for the table, CSV; without it standard output
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// File for a figure of both functions, SVG
    #[arg(long, value_name = "FILE")]
    pub figure: Option<PathBuf>,
    /// Profiles and what else is set.
    #[command(flatten)]
    pub contact: ContactOptions,
    /// Distance of the nominal rolling circles [m]
    #[arg(long, value_name = "M", default_value_t = 1.5, help_heading = "Contact")]
    pub running_circles: f64,
    /// Greatest displacement to either side, and greatest amplitude [m]
    #[arg(long, value_name = "M", default_value_t = 0.008, help_heading = "Table")]
    pub range: f64,
    /// Step of the displacement [m]
    #[arg(long, value_name = "M", default_value_t = 1e-4, help_heading = "Table")]
    pub step: f64,
}

/// Rows at most.
const MAX_ROWS: f64 = 1e5;
/// Amplitude at which conicities are compared [m].
const REFERENCE_AMPLITUDE: f64 = 3e-3;

/// Computes the table and, if asked for, draws the figure.
pub fn run(arguments: &Arguments) -> Result<()> {
    check(arguments)?;
    let values = arguments.contact.shared_values()?;
    let pair = Pair::of(&values.parameters);
    let outputs = [arguments.output.as_deref(), arguments.figure.as_deref()];
    output::check_names(pair.profiles(), outputs)?;
    let here = [PathBuf::from(".")];
    let mut wheelset = TrackedWheelset::new(&values.parameters, arguments.running_circles, &here)?;
    Remarks::default().tell(&Found::default().with_profiles(wheelset.profile_remarks().to_vec()));
    let radii = wheelset.sweep(arguments.range, arguments.step);
    let Some(difference) = RollingRadiusDifference::of(&radii) else {
        bail!("the wheels stand beside the rails: check track.gauge and --running-circles");
    };
    let conicity = |amplitude: f64| {
        (amplitude > 0.5 * arguments.step).then(|| difference.equivalent_conicity(amplitude))?
    };
    let table = output::table(arguments.output.as_deref())?;
    for one in &radii {
        table.write_named(&cells(one, conicity(one.displacement)))?;
    }
    table.finish()?;
    if let Some(path) = &arguments.figure {
        let curve: Vec<[f64; 2]> = radii
            .iter()
            .filter_map(|one| Some([one.displacement, conicity(one.displacement)?]))
            .collect();
        let title = format!("{pair}, inclination {}", pair.inclination);
        figures::conicity::draw(path, &title, difference.points(), &curve)?;
    }
    if arguments.output.is_some() {
        let found = difference.equivalent_conicity(REFERENCE_AMPLITUDE);
        let found = found.map_or("beyond the range".into(), |found| format!("{found:.4}"));
        output::say(&format!("Equivalent conicity at 3 mm: {found}\n"))?;
    }
    Ok(())
}

fn check(arguments: &Arguments) -> Result<()> {
    check_positive(&[
        ("running-circles", arguments.running_circles),
        ("range", arguments.range),
        ("step", arguments.step),
    ])?;
    if arguments.range / arguments.step > 0.5 * MAX_ROWS || arguments.range < arguments.step {
        bail!(
            "--step {} is not admitted: --range {} must hold 1 to {} of them",
            arguments.step,
            arguments.range,
            0.5 * MAX_ROWS
        );
    }
    Ok(())
}

fn cells(radii: &RollingRadii, conicity: Option<f64>) -> [(&'static str, String); 9] {
    // Rounded to 0.1 nm, which is what a contact point is known to.
    let mm = |value: f64| format!("{:.7}", 1e3 * value + 0.0);
    [
        ("y_mm", mm(radii.displacement)),
        ("difference_mm", mm(radii.difference())),
        ("radius_right_mm", mm(radii.radius[0])),
        ("radius_left_mm", mm(radii.radius[1])),
        ("wheel_y_right_mm", mm(radii.wheel_y[0])),
        ("wheel_y_left_mm", mm(radii.wheel_y[1])),
        ("rail_y_right_mm", mm(radii.rail_y[0])),
        ("rail_y_left_mm", mm(radii.rail_y[1])),
        ("conicity", conicity.map_or(String::new(), |value| format!("{value:.6}"))),
    ]
}
