//! `wheelrail simulate`: a wheelset runs over a lateral ramp, or what lies in its right rail, on
//! two instances of the FMU.

mod arguments;
mod fmu_wheel;
mod history;
mod integration;
mod report;

use std::io::{Write, stdout};
use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use wheelrail::element::output::Wrench;

pub use arguments::Arguments;
use fmu_wheel::FmuWheel;
use integration::integrate;

use crate::figures;
use crate::importer::Fmu;
use crate::wheelset::record::Record;
use crate::wheelset::{Moment, Wheelset};

/// Steps below are not proposed: a second would take millions of them [s].
const SHORTEST_STEP: f64 = 1e-6;

/// Runs the simulation, writes the files and prints what there is to know.
pub fn run(arguments: &Arguments) -> Result<()> {
    arguments.check()?;
    let path = arguments.fmu.clone().map_or_else(packaged_unit, Ok)?;
    let fmu = Fmu::open(&path)?;
    let settings = arguments.contact.all_settings();
    let mut left = FmuWheel::new(&fmu, "left", &settings, arguments.station)?;
    let settings = [settings, arguments.right_settings()].concat();
    let mut right = FmuWheel::new(&fmu, "right", &settings, arguments.station)?;
    let touching = [right.touching_z()?, left.touching_z()?];
    let mut out = stdout().lock();
    let pair = left.pair()?;
    report::situation(&mut out, arguments, &pair, &path)?;
    let mut wheelset = Wheelset {
        body: arguments.wheelset.body(),
        suspension: arguments.wheelset.suspension(),
        track: arguments.track(),
        speed: arguments.speed,
        wheels: [right, left],
        wrenches: [Wrench::default(); 2],
    };
    let start = wheelset.find_equilibrium(touching)?;
    let limit = wheelset.step_limit(&start)?;
    let step = arguments.step.unwrap_or_else(|| limit.proposal());
    if arguments.step.is_none() && step < SHORTEST_STEP {
        bail!(
            "the limit of stability is {:.1e} s, too short to run: with k = {:.2e} N/m and c = {:.2e} N s/m the contact lacks \
             damping: add --set normal.damping=1e5, or take a chance with --step",
            limit.longest(),
            limit.stiffness,
            limit.damping
        );
    }
    report::step(&mut out, &start, &limit, step)?;
    // Leave no trace of the differences taken around the start.
    wheelset.force(&start, Moment::Initialization)?;
    for wheel in &mut wheelset.wheels {
        wheel.start()?;
    }
    out.flush()?;
    report::messages(&report::of_both(&wheelset.wheels.each_ref().map(FmuWheel::take_messages)));

    let run = integrate(&mut wheelset, start, step, arguments);
    // Of a run that fails, too: they may say why.
    report::messages(&report::of_both(&wheelset.wheels.each_ref().map(FmuWheel::take_messages)));
    let run = run?;
    for wheel in &mut wheelset.wheels {
        wheel.finish()?;
    }
    let messages = wheelset.wheels.each_ref().map(FmuWheel::take_messages);
    let files = write_files(arguments, &arguments.profiles(&pair), &run.records)?;
    report::messages(&report::of_both(&messages));
    report::summary(&mut out, arguments, &run, &files)?;
    Ok(out.flush()?)
}

fn packaged_unit() -> Result<PathBuf> {
    let program = std::env::current_exe().context("cannot find where this program lies")?;
    let path = program.with_file_name("WheelRail.fmu");
    if !path.is_file() {
        bail!(
            "{} does not exist: `cargo build --release` packs it beside the release binary; or name one with --fmu FILE",
            path.display()
        );
    }
    Ok(path)
}

fn write_files(arguments: &Arguments, profiles: &str, records: &[Record]) -> Result<Vec<PathBuf>> {
    let folder = &arguments.output;
    std::fs::create_dir_all(folder)
        .with_context(|| format!("cannot make the folder {}", folder.display()))?;
    let mut files: Vec<PathBuf> =
        ["history.csv", "motion.svg", "patches.svg"].map(|name| folder.join(name)).into();
    history::write(&files[0], records)?;
    let title =
        format!("{profiles}, {} mm ramp at {} m/s", 1e3 * arguments.ramp(), arguments.speed);
    let track = arguments.track();
    figures::motion::draw(&files[1], &title, &track, records)?;
    figures::patches::draw(&files[2], &title, &track, records)?;
    if arguments.rail.is_some() {
        let title = format!("{profiles} at {} m/s", arguments.speed);
        files.push(folder.join("along_rail.svg"));
        let places = [arguments.station, 0.5 * arguments.wheelset.running_circles];
        figures::along_rail::draw(&files[3], &title, places, records)?;
    }
    Ok(files)
}
