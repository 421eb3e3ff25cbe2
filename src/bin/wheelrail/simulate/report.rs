//! What `wheelrail simulate` prints.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use wheelrail::element::StepLimit;

use super::arguments::Arguments;
use super::integration::Run;
use crate::options::Pair;
use crate::wheelset::body::State;
use crate::wheelset::oscillation::oscillation;
use crate::wheelset::record::{Patch, Record, SIDES};

/// Messages of the unit that are shown.
const SHOWN_MESSAGES: usize = 5;
/// Deviation below which an oscillation is not told from rounding and recording [m].
const SMALLEST_OSCILLATION: f64 = 2e-6;

/// Writes lines of a label and a text, the texts from the column `width` on.
fn write_lines(out: &mut impl Write, width: usize, lines: &[(&str, String)]) -> io::Result<()> {
    lines.iter().try_for_each(|(label, text)| writeln!(out, "{label:<width$}{text}"))
}

/// Wheelset, suspension, track and contact.
pub fn situation(
    out: &mut impl Write,
    arguments: &Arguments,
    pair: &Pair,
    unit: &Path,
) -> io::Result<()> {
    let Arguments { contact, wheelset, length, speed, ramp_start, .. } = arguments;
    let suspension = wheelset.suspension();
    let set =
        contact.settings.iter().fold(String::new(), |all, (n, v)| all + &format!(", {n} = {v}"));
    let contact = format!(
        "wheel {} on rail {}, inclination {}{set}",
        pair.wheel_profile, pair.rail_profile, pair.inclination
    );
    let body = format!(
        "{} kg, inertia {} kg m² (roll, yaw) and {} kg m² (axle), {} kN on the track, circles {} m apart",
        wheelset.mass,
        wheelset.inertia,
        wheelset.axle_inertia,
        1e-3 * wheelset.axle_load,
        wheelset.running_circles
    );
    let springs = format!(
        "each axle box {} kN/m, {} kN s/m (x, y, z); boxes {} m apart; static force {:.1} kN;",
        list(suspension.stiffness),
        list(suspension.damping),
        wheelset.axle_boxes,
        1e-3 * suspension.load
    );
    let frame = "against a frame that runs straight ahead on the track's centre line";
    let run = format!(
        "{length} m at {speed} m/s, {} ramp of {} mm from {ramp_start} m to {} m",
        format!("{:?}", arguments.ramp_shape).to_lowercase(),
        1e3 * arguments.ramp(),
        ramp_start + arguments.ramp_length
    );
    let lines = [
        ("Unit", unit.display().to_string()),
        ("Contact", contact),
        ("Wheelset", body),
        ("Suspension", springs),
        ("", frame.into()),
        ("Run", run),
    ];
    write_lines(out, 12, &lines)
}

fn list(values: [f64; 3]) -> String {
    values.map(|value| (1e-3 * value).to_string()).join("/")
}

/// Where the run starts and how long a step is.
pub fn step(out: &mut impl Write, start: &State, limit: &StepLimit, step: f64) -> io::Result<()> {
    let (height, turn) = (-1e3 * start.z, start.pitch_rate);
    let stability = format!(
        "one contact: k = {:.3e} N/m, c = {:.3e} N s/m, so h ≤ 2c/k = {:.3e} s; creep forces: h ≤ {:.3e} s",
        limit.stiffness,
        limit.damping,
        limit.normal(),
        limit.creep()
    );
    let longest = limit.longest();
    let steps = longest / step;
    let above = "The step is above the limit: wheels that bounce and creep forces that chatter may be artefacts.";
    let lines = [
        (
            "Start",
            format!("rolling freely: centre {height:.4} mm above the rails, {turn:.3} rad/s"),
        ),
        ("Stability", stability),
        ("Step", format!("{step:.3e} s, semi-implicit Euler; the limit is {steps:.1} steps long")),
        ("", above.into()),
    ];
    write_lines(out, 12, if step > longest { &lines } else { &lines[..3] })
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
    let displacement = format!(
        "{:+.2} mm at {:.2} m; largest yaw {:+.2} mrad at {:.2} m",
        1e3 * offset(farthest),
        farthest.state.distance,
        1e3 * yawed.state.yaw,
        yawed.state.distance
    );
    let heaviest = largest(records, |r| wheel_maximum(r, |p| p.normal_force));
    let steepest = largest(records, |r| wheel_maximum(r, |p| p.contact_angle.abs()));
    let patch = format!(
        "{:.1} kN at {:.2} m; steepest contact angle {:.1}° at {:.2} m",
        1e-3 * wheel_maximum(heaviest, |p| p.normal_force),
        heaviest.state.distance,
        wheel_maximum(steepest, |p| p.contact_angle.abs()).to_degrees(),
        steepest.state.distance
    );
    let sideways = largest(records, |r| side_maximum(r).abs());
    let lateral =
        format!("{:+.1} kN at {:.2} m", 1e-3 * side_maximum(sideways), sideways.state.distance);
    let end = arguments.ramp_start + arguments.ramp_length;
    let behind = records.iter().filter(|r| r.state.distance >= end);
    let samples: Vec<(f64, f64)> = behind.map(|r| (r.state.distance, offset(r))).collect();
    // Once it has died out, what is left crosses zero by rounding alone.
    let alive =
        samples.iter().rposition(|(_, y)| y.abs() > SMALLEST_OSCILLATION).map_or(0, |i| i + 1);
    let none = || "fewer than three crossings of the centre line".to_owned();
    let wave = oscillation(&samples[..alive]).map_or_else(none, |wave| {
        format!(
            "wavelength {:.2} m; each wave has {:.0} % of the amplitude of the one before",
            wave.wavelength,
            100.0 * wave.decay
        )
    });
    let (seconds, count) = (run.duration.as_secs_f64(), run.evaluations as f64);
    let cost = format!(
        "{} evaluations in {seconds:.2} s: {:.0} a second, {:.2} µs each, one step of everything included",
        run.evaluations,
        count / seconds,
        1e6 * seconds / count
    );
    let names: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
    let mut lines = vec![
        ("Largest displacement against the track", displacement),
        ("Heaviest patch", patch),
        ("Largest lateral force of a wheel", lateral),
        ("Oscillation behind the ramp", wave),
    ];
    lines.extend(
        records
            .last()
            .map(|last| ("At the end", format!("{:+.3} mm against the track", 1e3 * offset(last)))),
    );
    lines.extend([("Cost", cost), ("Written", names.join(", "))]);
    writeln!(out)?;
    write_lines(out, 40, &lines)
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
