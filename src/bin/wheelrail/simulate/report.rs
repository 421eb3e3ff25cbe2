//! What `wheelrail simulate` prints.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use wheelrail::element::StepLimit;

use super::arguments::Arguments;
use super::integration::Run;
use crate::wheelset::body::State;
use crate::wheelset::oscillation::oscillation;
use crate::wheelset::record::{Patch, Record, SIDES};

/// Messages of the unit that are shown.
const SHOWN_MESSAGES: usize = 5;
/// Deviation below which an oscillation is not told from rounding and recording [m].
const SMALLEST_OSCILLATION: f64 = 2e-6;

/// Wheelset, suspension, track and contact.
pub fn situation(out: &mut impl Write, arguments: &Arguments, unit: &Path) -> io::Result<()> {
    let (suspension, contact) = (arguments.wheelset.suspension(), &arguments.contact);
    writeln!(out, "Unit        {}", unit.display())?;
    writeln!(
        out,
        "Contact     wheel {} on rail {}, inclination {}{}",
        contact.wheel_profile,
        contact.rail_profile,
        contact.inclination,
        contact.settings.iter().fold(String::new(), |text, (n, v)| text + &format!(", {n} = {v}"))
    )?;
    writeln!(
        out,
        "Wheelset    {} kg, inertia {} kg m² (roll, yaw) and {} kg m² (axle), {} kN on the track, circles {} m apart",
        arguments.wheelset.mass,
        arguments.wheelset.inertia,
        arguments.wheelset.axle_inertia,
        1e-3 * arguments.wheelset.axle_load,
        arguments.wheelset.running_circles
    )?;
    writeln!(
        out,
        "Suspension  each axle box {} kN/m, {} kN s/m (x, y, z); boxes {} m apart; static force {:.1} kN;",
        list(suspension.stiffness),
        list(suspension.damping),
        arguments.wheelset.axle_boxes,
        1e-3 * suspension.load
    )?;
    writeln!(
        out,
        "            against a frame that runs straight ahead on the track's centre line"
    )?;
    writeln!(
        out,
        "Run         {} m at {} m/s, {} ramp of {} mm from {} m to {} m",
        arguments.length,
        arguments.speed,
        format!("{:?}", arguments.ramp_shape).to_lowercase(),
        1e3 * arguments.ramp(),
        arguments.ramp_start,
        arguments.ramp_start + arguments.ramp_length
    )
}

fn list(values: [f64; 3]) -> String {
    values.map(|value| (1e-3 * value).to_string()).join("/")
}

/// Where the run starts and how long a step is.
pub fn step(out: &mut impl Write, start: &State, limit: &StepLimit, step: f64) -> io::Result<()> {
    writeln!(
        out,
        "Start       rolling freely: centre {:.4} mm above the rails, {:.3} rad/s",
        -1e3 * start.z,
        start.pitch_rate
    )?;
    writeln!(
        out,
        "Stability   one contact: k = {:.3e} N/m, c = {:.3e} N s/m, so h ≤ 2c/k = {:.3e} s; creep forces: h ≤ {:.3e} s",
        limit.stiffness,
        limit.damping,
        limit.normal(),
        limit.creep()
    )?;
    writeln!(
        out,
        "Step        {step:.3e} s, semi-implicit Euler; the limit is {:.1} steps long",
        limit.longest() / step
    )?;
    if step > limit.longest() {
        writeln!(
            out,
            "            The step is above the limit: wheels that bounce and creep forces that chatter may be artefacts."
        )?;
    }
    Ok(())
}

/// The messages of both wheels: once what both say, as of a profile that both read, and else with
/// the side.
pub fn of_both(messages: &[Vec<String>; 2]) -> Vec<String> {
    let [right, left] = messages;
    let shared = right.iter().filter(|message| left.contains(message)).cloned();
    let sides = messages.iter().zip([left, right]).zip(SIDES);
    let own = sides.flat_map(|((of_side, of_other), side)| {
        let own = of_side.iter().filter(|message| !of_other.contains(message));
        own.map(move |message| format!("{side} wheel: {message}"))
    });
    shared.chain(own).collect()
}

/// The first messages of the unit, on standard error.
pub fn messages(messages: &[String]) {
    for message in messages.iter().take(SHOWN_MESSAGES) {
        eprintln!("{message}");
    }
    if messages.len() > SHOWN_MESSAGES {
        eprintln!("and {} more messages of the unit", messages.len() - SHOWN_MESSAGES);
    }
}

/// What came out and where it is.
pub fn summary(
    out: &mut impl Write,
    arguments: &Arguments,
    run: &Run,
    files: &[PathBuf],
) -> io::Result<()> {
    let records = &run.records;
    let offset = |r: &Record| r.state.y - r.track_y;
    let farthest = largest(records, |r| offset(r).abs());
    let yawed = largest(records, |r| r.state.yaw.abs());
    writeln!(out)?;
    writeln!(
        out,
        "Largest displacement against the track  {:+.2} mm at {:.2} m; largest yaw {:+.2} mrad at {:.2} m",
        1e3 * offset(farthest),
        farthest.state.distance,
        1e3 * yawed.state.yaw,
        yawed.state.distance
    )?;
    let heaviest = largest(records, |r| wheel_maximum(r, |p| p.normal_force));
    let steepest = largest(records, |r| wheel_maximum(r, |p| p.contact_angle.abs()));
    let sideways = largest(records, |r| side_maximum(r).abs());
    writeln!(
        out,
        "Heaviest patch                          {:.1} kN at {:.2} m; steepest contact angle {:.1}° at {:.2} m",
        1e-3 * wheel_maximum(heaviest, |p| p.normal_force),
        heaviest.state.distance,
        wheel_maximum(steepest, |p| p.contact_angle.abs()).to_degrees(),
        steepest.state.distance
    )?;
    writeln!(
        out,
        "Largest lateral force of a wheel        {:+.1} kN at {:.2} m",
        1e-3 * side_maximum(sideways),
        sideways.state.distance
    )?;
    let end = arguments.ramp_start + arguments.ramp_length;
    let samples: Vec<(f64, f64)> = records
        .iter()
        .filter(|r| r.state.distance >= end)
        .map(|r| (r.state.distance, offset(r)))
        .collect();
    // Once it has died out, what is left crosses zero by rounding alone.
    let alive =
        samples.iter().rposition(|(_, y)| y.abs() > SMALLEST_OSCILLATION).map_or(0, |i| i + 1);
    match oscillation(&samples[..alive]) {
        Some(wave) => writeln!(
            out,
            "Oscillation behind the ramp             wavelength {:.2} m; each wave has {:.0} % of the amplitude of the one before",
            wave.wavelength,
            100.0 * wave.decay
        )?,
        None => writeln!(
            out,
            "Oscillation behind the ramp             fewer than three crossings of the centre line"
        )?,
    }
    if let Some(last) = records.last() {
        writeln!(
            out,
            "At the end                              {:+.3} mm against the track",
            1e3 * offset(last)
        )?;
    }
    let seconds = run.duration.as_secs_f64();
    writeln!(
        out,
        "Cost                                    {} evaluations in {seconds:.2} s: {:.0} a second, {:.2} µs each, one step of everything included",
        run.evaluations,
        run.evaluations as f64 / seconds,
        1e6 * seconds / run.evaluations as f64
    )?;
    let names: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
    writeln!(out, "Written                                 {}", names.join(", "))
}

/// The record with the largest value of `quantity`; a run has at least one record.
fn largest(records: &[Record], quantity: impl Fn(&Record) -> f64) -> &Record {
    let first = &records[0];
    records.iter().fold(first, |best, r| if quantity(r) > quantity(best) { r } else { best })
}

fn wheel_maximum(record: &Record, quantity: impl Fn(&Patch) -> f64) -> f64 {
    record.patches.iter().flatten().map(quantity).fold(0.0, f64::max)
}

fn side_maximum(record: &Record) -> f64 {
    let [right, left] = record.wrenches.map(|wrench| wrench.force[1]);
    if right.abs() > left.abs() { right } else { left }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_both_wheels_say_is_told_once() {
        let said = |messages: &[&str]| messages.iter().map(ToString::to_string).collect();
        let messages = [said(&["warning: a", "warning: b"]), said(&["warning: c", "warning: a"])];
        let told = ["warning: a", "right wheel: warning: b", "left wheel: warning: c"];
        assert_eq!(of_both(&messages), told);
    }
}
