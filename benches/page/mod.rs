//! Sections of docs/benchmarks.md that benchmarks write.
#![allow(dead_code)] // each benchmark uses its own part

use std::process::Command;
use std::time::SystemTime;
use std::{env, fs};

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/benchmarks.md");

/// Writes `text` between the marks of the benchmark `name`, under a line that says where and when
/// it was measured.
pub fn write(name: &str, text: &str) {
    let page = fs::read_to_string(PAGE).expect("docs/benchmarks.md");
    let marks =
        [format!("<!-- {name}: written by the benchmark -->"), format!("<!-- {name}: end -->")];
    let places = [0, 1].map(|i| page.find(&marks[i]).expect("both marks in docs/benchmarks.md"));
    let (before, after) = (&page[..places[0]], &page[places[1]..]);
    let page = format!("{before}{}\n\n{}\n\n{text}\n{after}", marks[0], circumstances());
    fs::write(PAGE, page).expect("docs/benchmarks.md can be written");
}

/// Machine, compiler, date, commit and load.
fn circumstances() -> String {
    let output = |program: &str, arguments: &[&str]| {
        let found = Command::new(program).args(arguments).output().ok();
        found.map_or_else(String::new, |o| String::from_utf8_lossy(&o.stdout).trim().to_owned())
    };
    let processors = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let processor = processors
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(':'))
        .map_or("a processor without a name", |(_, name)| name.trim());
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let load = fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let load = load.split(' ').next().unwrap_or("unknown");
    let date = humantime::format_rfc3339_seconds(SystemTime::now()).to_string();
    let compiler = output("rustc", &["--version"]);
    let compiler = compiler.split(" (").next().unwrap_or_default();
    format!(
        "{processor}, {cores} cores; {compiler}; {}; commit {}; load average {load}.",
        &date[..10],
        output("git", &["describe", "--always", "--dirty"]),
    )
}

/// A time [s] in microseconds.
pub fn microseconds(time: f64) -> String {
    let time = 1e6 * time;
    if time < 9.95 { format!("{time:.1}") } else { format!("{time:.0}") }
}
