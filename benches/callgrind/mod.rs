//! Instructions of one evaluation, counted by Valgrind where it is installed.

use std::env;
use std::process::Command;

/// First argument of a counted run of a benchmark; the last one is the number of evaluations.
pub const COUNT: &str = "--evaluate";
/// Evaluations by which two counted runs differ.
const COUNTED: usize = 20;

/// Two runs of this program with `arguments` between [`COUNT`] and the number of evaluations, the
/// difference over the evaluations; none without Valgrind.
pub fn instructions(arguments: &[String]) -> Option<f64> {
    let run = |evaluations: usize| -> Option<f64> {
        let output = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(env::current_exe().ok()?)
            .arg(COUNT)
            .args(arguments)
            .arg(evaluations.to_string())
            .output()
            .ok()?;
        let text = String::from_utf8_lossy(&output.stderr);
        let line = text.lines().find(|line| line.contains("Collected :"))?;
        line.rsplit(':').next()?.trim().parse().ok()
    };
    Some((run(COUNTED)? - run(0)?) / COUNTED as f64)
}
