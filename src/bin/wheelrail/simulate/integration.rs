//! The run: steps along the track and what is kept of them.

use std::time::{Duration, Instant};

use anyhow::{Result, bail};
use indicatif::{ProgressBar, ProgressStyle};

use super::arguments::Arguments;
use super::fmu_wheel::FmuWheel;
use crate::wheelset::Wheelset;
use crate::wheelset::body::State;
use crate::wheelset::record::Record;

/// Steps between two looks at the progress bar.
const STEPS_A_TICK: u64 = 2000;
/// Rows of the history at most: a gigabyte of them.
const MAX_ROWS: u64 = 2_000_000;
/// Beyond this lateral position against the track the wheelset has left the rails [m].
const DERAILED: f64 = 0.06;

/// A finished run.
pub struct Run {
    /// Moments of it, in order; at least one.
    pub records: Vec<Record>,
    /// Sets of inputs that the units answered.
    pub evaluations: u64,
    /// Time it took.
    pub duration: Duration,
}

/// Runs `wheelset` from `start` in steps of `step` [s] as far as the `arguments` say.
pub fn integrate(
    wheelset: &mut Wheelset<FmuWheel<'_>>,
    start: State,
    step: f64,
    arguments: &Arguments,
) -> Result<Run> {
    let steps = (arguments.length / (arguments.speed * step)).ceil() as u64;
    let steps_a_record =
        (arguments.record_every / (arguments.speed * step)).round().max(1.0) as u64;
    let rows = steps / steps_a_record + 1;
    if rows > MAX_ROWS {
        bail!(
            "--record-every {}: {rows} rows of history.csv, and at most {MAX_ROWS} are kept",
            arguments.record_every
        );
    }
    let progress = ProgressBar::new(steps).with_style(ProgressStyle::with_template(
        "{bar:40.blue} {percent:>3} % of {msg}, {elapsed} elapsed, {eta} to go",
    )?);
    progress.set_message(format!("{} m", arguments.length));

    let before: u64 = wheelset.wheels.iter().map(|wheel| wheel.evaluations).sum();
    let begin = Instant::now();
    let mut records = Vec::with_capacity(rows as usize);
    let mut state = start;
    for index in 0..steps {
        // Multiples of the step, not a sum, so that rounding does not add up.
        let time = index as f64 * step;
        let at_start_of_step = state;
        wheelset.advance(&mut state, time, step)?;
        if index % steps_a_record == 0 {
            records.push(record(wheelset, at_start_of_step, time)?);
        }
        if index % STEPS_A_TICK == 0 {
            progress.set_position(index);
            let offset = state.y - wheelset.track.lateral(state.distance).position;
            if offset.is_nan() || offset.abs() > DERAILED {
                progress.abandon();
                bail!(
                    "derailed at {:.2} m: the wheelset is {:.0} mm off the track's centre line; run it slower, stiffen \
                     the suspension or shorten --step",
                    state.distance,
                    1e3 * offset
                );
            }
        }
    }
    progress.finish_and_clear();
    let after: u64 = wheelset.wheels.iter().map(|wheel| wheel.evaluations).sum();
    Ok(Run { records, evaluations: after - before, duration: begin.elapsed() })
}

fn record(wheelset: &mut Wheelset<FmuWheel<'_>>, state: State, time: f64) -> Result<Record> {
    let [right, left] = &mut wheelset.wheels;
    Ok(Record {
        time,
        track_y: wheelset.track.lateral(state.distance).position,
        state,
        wrenches: wheelset.wrenches,
        patches: [right.patches()?, left.patches()?],
    })
}
