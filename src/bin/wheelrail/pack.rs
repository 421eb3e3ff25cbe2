//! `wheelrail pack`: a unit with the user's profiles and values inside.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use clap::Args;
use wheelrail::pack::{Pack, Pictures};

use crate::figures::icon;
use crate::importer::{Fmu, Instance};
use crate::options::assignment;
use crate::{output, plot};

/// Pack a unit with your profiles and values inside, to be mailed as one file
///
/// The archive of a unit is rewritten, no compiler is needed. Profiles, waves, friction tables and
/// sections go into its resources, values become its start values; the libraries of all platforms
/// stay. It is checked as an importer reads it, and run where it has a library of FMI 2.0 for this
/// machine. The same input gives the same bytes.
#[derive(Args, Debug)]
#[command(verbatim_doc_comment, allow_negative_numbers = true)]
pub struct Arguments {
    /// Profile of the wheel, of a wheelset of both: built-in name or file
    #[arg(long, value_name = "PROFILE")]
    wheel: Option<String>,
    /// Profile of the rail, of a wheelset of both: built-in name or file
    #[arg(long, value_name = "PROFILE")]
    rail: Option<String>,
    /// Set any start value, inputs and parameters, files too; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = assignment)]
    settings: Vec<(String, String)>,
    /// Which unit beside this program: WheelRail, WheelSet; for FMI 3.0 WheelRail3, WheelSet3
    #[arg(long, value_name = "UNIT", default_value = "WheelRail")]
    unit: String,
    /// The unit as a file, in the place of --unit
    #[arg(long, value_name = "FILE.fmu", conflicts_with = "unit")]
    source: Option<PathBuf>,
    /// Name of the model; without it that of the output file
    #[arg(long, value_name = "NAME")]
    name: Option<String>,
    /// Description of the model; without it profiles and what is set
    #[arg(long, value_name = "TEXT")]
    description: Option<String>,
    /// Give model exchange a dummy state, der(x) = 0, for importers that cannot integrate a unit
    /// without states
    #[arg(long)]
    dummy_state: bool,
    /// The packed unit
    #[arg(long, short, value_name = "FILE.fmu")]
    output: PathBuf,
}

/// Packs the unit.
pub fn run(arguments: &Arguments) -> Result<()> {
    let path = &arguments.output;
    if path.extension().is_none_or(|end| !end.eq_ignore_ascii_case("fmu")) {
        bail!("{}: a unit has a name that ends in .fmu", path.display());
    }
    let source = source(arguments)?;
    output::check_names([source.as_path()], [Some(path.as_path())])?;
    let mut pack = Pack::open(&source)?;
    if let Some(profile) = &arguments.wheel {
        pack.set_wheel(profile).context("--wheel")?;
    }
    if let Some(profile) = &arguments.rail {
        pack.set_rail(profile).context("--rail")?;
    }
    for (name, value) in &arguments.settings {
        pack.set(name, value).with_context(|| format!("--set {name}"))?;
    }
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    pack.set_name(arguments.name.as_deref().or(stem.as_deref()).unwrap_or_default())?;
    pack.set_description(&description(arguments));
    if arguments.dummy_state {
        pack.add_dummy_state();
    }
    match pictures(&pack) {
        Ok(pictures) => pack.set_pictures(pictures),
        // What is at fault with the values is told below; a wheel in the air is no fault.
        Err(reason) => eprintln!("note: no picture of the contact at the start values: {reason:#}"),
    }
    pack.write(path)?;
    if let Err(error) = try_out(path) {
        // Not to be mailed.
        let _ = std::fs::remove_file(path);
        return Err(error.context("the packed unit does not run"));
    }
    output::say(&format!("{}\n", path.display()))
}

fn source(arguments: &Arguments) -> Result<PathBuf> {
    if let Some(path) = &arguments.source {
        return Ok(path.clone());
    }
    let program = std::env::current_exe().context("cannot find where this program lies")?;
    let path = program.with_file_name(format!("{}.fmu", arguments.unit));
    if !path.is_file() {
        bail!(
            "--unit {}: {} does not exist: `cargo build --release` packs units beside the release binary; or name one with --source FILE",
            arguments.unit,
            path.display()
        );
    }
    Ok(path)
}

fn description(arguments: &Arguments) -> String {
    if let Some(text) = &arguments.description {
        return text.clone();
    }
    let named = [("wheel", &arguments.wheel), ("rail", &arguments.rail)];
    let named = named.into_iter().filter_map(|(body, value)| Some((body, value.as_ref()?)));
    // Where a file lay is nobody's affair.
    let short = |value: &str| {
        Path::new(value).file_name().map_or(value.into(), |n| n.to_string_lossy().into_owned())
    };
    let mut parts: Vec<String> =
        named.map(|(body, value)| format!("{body} {}", short(value))).collect();
    parts.extend(
        arguments.settings.iter().map(|(name, value)| format!("{name} = {}", short(value))),
    );
    let what = "Contact of railway wheel and rail";
    if parts.is_empty() { what.into() } else { format!("{what}: {}", parts.join(", ")) }
}

/// The contact at the start values, drawn.
fn pictures(pack: &Pack) -> Result<Pictures> {
    let (parameters, input, folder) = pack.first_wheel()?;
    let figure = plot::of_wheel(&parameters, &input, folder.path())?;
    let file = folder.path().join("contact.svg");
    figure.draw(&file)?;
    Ok(Pictures { figure: std::fs::read(&file)?, icon: icon::png(&figure)? })
}

/// Runs the unit where this program can: of FMI 2.0 and with a library for this machine.
fn try_out(path: &Path) -> Result<()> {
    // What cannot be run here is for other machines.
    let Ok(fmu) = Fmu::open(path) else { return Ok(()) };
    let mut instance = Instance::new(&fmu, "packed")?;
    instance.initialize()?;
    instance.start()
}
