//! Every public case, one table: `cargo bench --no-default-features --bench scoreboard` writes
//! docs/scoreboard.csv and docs/families.csv, and docs/scoreboard.md from them.
//!
//! With WHEELRAIL_SCOREBOARD=check it writes nothing and fails where a figure is worse than in the
//! committed table by more than its noise; with WHEELRAIL_SCOREBOARD=page it makes the page anew
//! from that table. WHEELRAIL_SEED chooses the random cases, which are others
//! in every run without it; WHEELRAIL_PROFILES names the folder of profiles that may not be passed
//! on. A word behind `--` runs the families alone whose titles have it in them, and shows their
//! tables: `cargo bench --no-default-features --bench scoreboard -- roller`; the word `times` measures
//! times alone.

#[path = "../../tests/suite/common/mod.rs"]
mod common;
mod family;
mod linear;
mod measured;
mod page;
mod planar;
mod random;
mod setting;
mod times;
mod transient;
mod wheel_rail;

use std::env;
use std::process::ExitCode;
use std::time::SystemTime;

use family::{Case, Family};
use indicatif::{ProgressBar, ProgressStyle};
use page::Results;
use rayon::prelude::*;
use setting::{SETTINGS, Setting};

fn main() -> ExitCode {
    if !env::args().any(|argument| argument == "--bench") {
        println!("run by: cargo bench --no-default-features --bench scoreboard");
        return ExitCode::SUCCESS;
    }
    let seed = seed();
    println!("seed {seed}");
    let word = env::args().skip(1).find(|argument| !argument.starts_with("--"));
    let families: Vec<&Family> =
        (planar::FAMILIES.iter().chain([&linear::FAMILY, &transient::FAMILY]))
            .chain(&wheel_rail::FAMILIES)
            .chain(&measured::FAMILIES)
            .chain(&random::FAMILIES)
            .filter(|family| word.as_ref().is_none_or(|word| family.title.contains(word)))
            .collect();
    let wish = env::var("WHEELRAIL_SCOREBOARD").unwrap_or_default();
    if wish == "page" {
        page::write_families(&families);
        page::write(&page::again(&families));
        return ExitCode::SUCCESS;
    }
    if word.as_deref() == Some("times") {
        print!("{}", page::times_table(&measured_times(seed)));
        return ExitCode::SUCCESS;
    }
    let results = solve_all(&families, seed);
    page::report(&results);
    if word.is_some() {
        print!("{}", page::table(&page::rows(&results)));
        return ExitCode::SUCCESS;
    }
    println!("walks");
    let walk = random::walk(seed);
    if wish == "check" {
        for Results { family, .. } in results.iter().filter(|results| results.rows.is_empty()) {
            println!("not compared without {}: {}", measured::FOLDER, family.title);
        }
        let worse = page::worse(&results, &walk);
        for line in &worse {
            println!("worse: {line}");
        }
        println!("{} figures are worse than in docs/scoreboard.csv", worse.len());
        return if worse.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE };
    }
    println!("times");
    let text = page::text(&results, &walk, &measured_times(seed), seed);
    print!("{text}");
    page::write_table(&page::rows(&results));
    page::write_families(&families);
    page::write(&text);
    ExitCode::SUCCESS
}

/// What an evaluation takes by all settings.
fn measured_times(seed: u64) -> Vec<(String, Vec<Case>)> {
    let of = |setting: &Setting| (setting.name.to_owned(), times::times(setting, seed));
    SETTINGS.iter().map(of).collect()
}

/// That of the environment, or one of the clock.
fn seed() -> u64 {
    let clock = || {
        let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
        since.map_or(1, |time| time.as_secs() % 1_000_000)
    };
    env::var("WHEELRAIL_SEED")
        .map_or_else(|_| clock(), |text| text.parse().expect("WHEELRAIL_SEED is a whole number"))
}

/// All families by all settings, on all cores.
fn solve_all<'a>(families: &[&'a Family], seed: u64) -> Vec<Results<'a>> {
    let jobs: Vec<(usize, usize)> = (0..families.len())
        .flat_map(|family| (0..SETTINGS.len()).map(move |setting| (family, setting)))
        .collect();
    let style =
        ProgressStyle::with_template("{msg} {bar:30} {pos}/{len} {elapsed}").expect("a template");
    let bar = ProgressBar::new(jobs.len() as u64).with_style(style).with_message("families");
    let mut solved: Vec<Option<Vec<Case>>> = jobs
        .par_iter()
        .map(|&(family, setting)| {
            let cases = (families[family].solve)(&SETTINGS[setting], seed);
            bar.inc(1);
            cases
        })
        .collect();
    bar.finish();
    let mut results = Vec::new();
    for (family, solved) in families.iter().zip(solved.chunks_mut(SETTINGS.len())) {
        let names = SETTINGS.iter().map(|setting| setting.name.to_owned());
        let own = names.zip(solved.iter_mut().map(Option::take));
        let mut rows: Vec<(String, Vec<Case>)> =
            own.filter_map(|(name, cases)| Some((name, cases?))).collect();
        rows.extend((family.others)());
        results.push(Results { family, rows });
    }
    results
}
