//! `wheelrail fatigue`: rolling contact fatigue by the contacts of a table.

mod body_profile;
pub mod contacts;

use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use clap::Args;
use wheelrail::fatigue::{FatigueMap, Strength};

use crate::cases::{Cases, Row};
use crate::element_rows::{placed, read_values};
use crate::figures::fatigue::{Figure, Mapped};
use crate::options::Of;
use crate::planar_cases::PlanarCases;
use crate::{batch, output};
use body_profile::BodyProfile;
use contacts::{Found, at_wheel, of_planar};

/// Rolling contact fatigue of the rail or the wheel by the contacts of a table
///
/// CASES is a table as for patch (with a column separation) or as for evaluate. A column passages
/// says how many equal passages a row stands for (1). Contacts are laid flat, as for plot, and each
/// body is an elastic half-space under the pressure and the tractions of the models of the row.
///
/// Written to standard output, a row for each contact: greatest pressure p0, over the yield stress in
/// shear k too; used friction; p0/k at which the material yields first, and up to which it shakes
/// down, by the stresses of this contact; the response (elastic, shakedown, plastic); the surface and
/// subsurface index of Ekberg, Kabo and Andersson; the greatest equivalent stress of Dang Van over
/// the passage, and where. A surface index above 0 and the response plastic mean ratchetting.
///
/// The figure shows the contacts on the shakedown map, and of a wheel on rails the greatest
/// equivalent stress of Dang Van of all rows over the arc of the profile (0 at its y = 0) and the
/// depth; --map writes the same as a table, with the passages beyond --endurance and beyond k. All
/// rows then need the same profile. Strengths are yours: start values are those of ordinary rail
/// steel, there is none for the endurance.
#[derive(Args, Debug)]
#[command(verbatim_doc_comment)]
pub struct Arguments {
    /// Table of cases, CSV
    #[arg(value_name = "CASES.csv")]
    cases: PathBuf,
    /// Which body
    #[arg(long, value_enum, default_value_t = Of::Rail)]
    body: Of,
    /// Which rail is mapped, from 1; contacts of a wheel with all rails
    #[arg(long, default_value_t = 1, value_name = "N")]
    rail: i32,
    /// Figure, SVG
    #[arg(long, short, value_name = "FILE.svg", default_value = "fatigue.svg")]
    output: PathBuf,
    /// Table of the map, CSV
    #[arg(long, value_name = "FILE.csv")]
    map: Option<PathBuf>,
    /// Depth of the map [mm]
    #[arg(long, value_name = "MM", default_value_t = 6.0)]
    depth: f64,
    /// Step of the map along the profile and down [mm]
    #[arg(long, value_name = "MM", default_value_t = 0.5)]
    step: f64,
    /// Yield stress in shear k [MPa]
    #[arg(long, value_name = "MPA", default_value_t = 300.0, help_heading = "Strength")]
    shear_yield: f64,
    /// Weight of the hydrostatic stress in that of Dang Van
    #[arg(long, value_name = "C", default_value_t = 1.0 / 3.0, help_heading = "Strength")]
    dang_van: f64,
    /// Residual hydrostatic stress, tension positive [MPa]
    #[arg(
        long,
        value_name = "MPA",
        default_value_t = 0.0,
        allow_negative_numbers = true,
        help_heading = "Strength"
    )]
    residual: f64,
    /// Equivalent stress of Dang Van that is endured for ever [MPa]
    #[arg(long, value_name = "MPA", help_heading = "Strength")]
    endurance: Option<f64>,
}

/// Yield stresses in shear that a body may have; beyond them it is another unit [MPa].
const YIELD_STRESSES: RangeInclusive<f64> = 1.0..=1e6;
/// Most places of a map along either axis.
const MOST_PLACES: f64 = 2000.0;

impl Arguments {
    fn strength(&self) -> Result<Strength> {
        if !YIELD_STRESSES.contains(&self.shear_yield) {
            bail!(
                "--shear-yield {} is not admitted: a stress in MPa, {} to {}",
                self.shear_yield,
                YIELD_STRESSES.start(),
                YIELD_STRESSES.end()
            );
        }
        let mut strength = Strength::default();
        strength.shear_yield = 1e6 * self.shear_yield;
        strength.dang_van = self.dang_van;
        strength.residual = 1e6 * self.residual;
        strength.endurance = self.endurance.map(|stress| 1e6 * stress);
        strength.check().context("--shear-yield, --dang-van, --residual, --endurance")?;
        Ok(strength)
    }

    fn check(&self) -> Result<()> {
        output::check_figure(&self.output)?;
        if !(self.step > 0.0 && self.depth >= self.step && self.depth <= 100.0) {
            bail!(
                "--depth {} --step {}: a depth up to 100 mm, in steps that are not longer",
                self.depth,
                self.step
            );
        }
        if self.depth / self.step > MOST_PLACES {
            bail!("--step {}: {MOST_PLACES} places along the depth at most", self.step);
        }
        Ok(())
    }
}

/// Judges all contacts and draws them.
pub fn run(arguments: &Arguments) -> Result<()> {
    arguments.check()?;
    let strength = arguments.strength()?;
    let outputs = [Some(arguments.output.as_path()), arguments.map.as_deref()];
    output::check_names([arguments.cases.as_path()], outputs)?;
    let cases = Cases::read(&arguments.cases)?;
    let is_planar = cases.column("separation").is_some();
    if is_planar && arguments.map.is_some() {
        bail!("--map: planar problems have no profile; give wheels on rails");
    }
    let (found, map) = if is_planar {
        (planar(arguments, &cases, &strength)?, None)
    } else {
        on_rails(arguments, &cases, &strength, outputs)?
    };
    if found.is_empty() {
        bail!("{}: no row has a contact", arguments.cases.display());
    }
    let mapped = map.as_ref().map(|(map, profile)| Mapped {
        map,
        origin: profile.origin,
        of: format!("{}, {}", profile.body, profile.name),
    });
    if let (Some(path), Some((map, profile))) = (&arguments.map, &map) {
        write_map(path, map, profile)?;
    }
    Figure { contacts: &found, mapped }.draw(&arguments.output)?;
    contacts::write(&found)
}

fn planar(arguments: &Arguments, cases: &Cases, strength: &Strength) -> Result<Vec<Found>> {
    let problems = PlanarCases::read(cases, &[Some(arguments.output.as_path())])?;
    let progress = output::progress(Some(problems.cases.len()), None)?;
    let mut found = Vec::new();
    let result = batch::in_order(
        &progress,
        problems.cases.iter().enumerate().map(Ok),
        batch::all_cores(),
        || (),
        |(), (row, case)| {
            of_planar(row + 1, &problems.planar(case), arguments.body.body(), strength)
                .context(case.place.clone())
        },
        |own| {
            found.extend(own);
            Ok(())
        },
    );
    result.map(|()| found)
}

/// Contacts of wheels on rails, and the map over the profile of the body.
type OnRails = (Vec<Found>, Option<(FatigueMap, BodyProfile)>);

fn on_rails(
    arguments: &Arguments,
    cases: &Cases,
    strength: &Strength,
    outputs: [Option<&Path>; 2],
) -> Result<OnRails> {
    let all = read_values(cases, &["passages"], &outputs)?;
    let counts: Vec<f64> =
        all.iter().map(|(row, _)| passages(cases, row)).collect::<Result<_>>()?;
    let folder = cases.header().folder();
    let [(first, values), ..] = &all[..] else { bail!("the table has no rows") };
    let rail = (arguments.body == Of::Rail).then_some(arguments.rail);
    let profile = BodyProfile::of(values, rail, &folder).with_context(|| first.place())?;
    for (row, other) in &all {
        profile.check(&other.parameters).with_context(|| row.place())?;
    }
    let step = 1e-3 * arguments.step;
    let places = (1e-3 * arguments.depth / step).round() as usize;
    let depths = (1..=places).map(|k| k as f64 * step).collect();
    let mut map = FatigueMap::new(profile.arcs(step, MOST_PLACES)?, depths, *strength)?;
    let empty = map.clone();
    let progress = output::progress(Some(all.len()), None)?;
    let mut found = Vec::new();
    let result = batch::in_order(
        &progress,
        all.iter().enumerate().map(Ok),
        batch::all_cores(),
        || (),
        |(), (number, (row, values))| {
            let own = at_wheel(number + 1, values, arguments.body.body(), strength, &folder)
                .map_err(|error| match error.downcast() {
                    Ok(refused) => placed(refused, row),
                    Err(other) => other.context(row.place()),
                })?;
            let mapped = own.iter().filter(|own| rail.is_none_or(|rail| own.rail == rail));
            let passed: Vec<_> = mapped
                .map(|own| empty.passage(&own.load, own.arc(arguments.body.body())))
                .collect();
            Ok((number, own, passed))
        },
        |(number, own, passed)| {
            for passage in &passed {
                map.add(passage, counts[number])?;
            }
            found.extend(own);
            Ok(())
        },
    );
    result.map(|()| (found, Some((map, profile))))
}

/// How many passages a row stands for.
fn passages(cases: &Cases, row: &Row) -> Result<f64> {
    let Some(column) = cases.column("passages") else { return Ok(1.0) };
    let Some(text) = row.cell(column) else { return Ok(1.0) };
    match text.parse::<f64>() {
        Ok(count) if count.is_finite() && count >= 0.0 => Ok(count),
        _ => bail!("{}: {text} is no number of passages, 0 or greater", row.cell_place(column)),
    }
}

fn write_map(path: &Path, map: &FatigueMap, profile: &BodyProfile) -> Result<()> {
    let table = output::table(Some(path))?;
    let depths = map.depths();
    for (k, cell) in map.cells().iter().enumerate() {
        let (arc, depth) = (map.arcs()[k / depths.len()], depths[k % depths.len()]);
        let [y, z] = profile.curve.at(arc).point;
        let length = |x: f64| format!("{:.4}", 1e3 * x);
        let stress = |s: f64| format!("{:.3}", 1e-6 * s);
        table.write_named(&[
            ("arc_mm", length(arc - profile.origin)),
            ("y_mm", length(y)),
            ("z_mm", length(z)),
            ("depth_mm", length(depth)),
            ("dang_van_mpa", stress(cell.dang_van)),
            ("orthogonal_shear_mpa", stress(cell.shear)),
            ("passages_beyond_endurance", cell.beyond_endurance.to_string()),
            ("passages_plastic", cell.plastic.to_string()),
        ])?;
    }
    table.finish()
}
