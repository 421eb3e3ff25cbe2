//! The bytes that fuzzing kept, and changes of them, on any compiler: what they do must hold (see
//! `fuzz/subjects`).

#[path = "../../fuzz/subjects/mod.rs"]
mod subjects;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

use crate::common::random::Random;
use crate::common::report_path;

/// Names and bytes of the corpus `name`.
fn corpus(name: &str) -> Vec<(String, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(name);
    let mut files: Vec<_> = fs::read_dir(&folder)
        .unwrap_or_else(|e| panic!("{}: {e}", folder.display()))
        .map(|entry| entry.expect("a file").path())
        .collect();
    files.sort();
    assert!(!files.is_empty(), "{} is empty", folder.display());
    let read = |file: &Path| (file.display().to_string(), fs::read(file).expect("a file"));
    files.iter().map(|file| read(file)).collect()
}

#[test]
fn what_fuzzing_kept_is_still_good() {
    for (name, check) in subjects::ALL {
        for (file, bytes) in corpus(name) {
            // Seen where one of them fails.
            println!("{file}");
            check(&bytes);
        }
    }
}

/// A few changes of one of `all`, as a fuzzer makes them, only without looking at what they reach.
fn changed(all: &[(String, Vec<u8>)], random: &mut Random) -> Vec<u8> {
    let below = |random: &mut Random, n: usize| {
        (random.within(0.0, n as f64) as usize).min(n.saturating_sub(1))
    };
    let mut bytes = all[below(random, all.len())].1.clone();
    for _ in 0..=below(random, 6) {
        let place = below(random, bytes.len());
        let byte = random.within(0.0, 256.0) as u8;
        match below(random, 6) {
            0 => bytes.insert(place, byte),
            _ if bytes.is_empty() => bytes.push(byte),
            1 => {
                bytes.remove(place);
            }
            2 => bytes[place] = byte,
            3 => bytes[place] ^= 1 << below(random, 8),
            4 => {
                // A stretch of another one.
                let other = &all[below(random, all.len())].1;
                let from = below(random, other.len());
                let to = (from + 1 + below(random, 16)).min(other.len());
                bytes.splice(place..place, other[from.min(to)..to].iter().copied());
            }
            _ => bytes.truncate(place + 1),
        }
    }
    bytes
}

#[test]
#[ignore = "minutes: WHEELRAIL_FUZZ_SECONDS for each subject, 5 without it; WHEELRAIL_FUZZ_SEED"]
fn what_comes_of_changes_is_good_too() {
    let number = |name: &str| std::env::var(name).ok().map(|n| n.parse().expect("a whole number"));
    let seconds = number("WHEELRAIL_FUZZ_SECONDS").unwrap_or(5);
    let seed = number("WHEELRAIL_FUZZ_SEED").unwrap_or(1);
    for (name, check) in subjects::ALL {
        let all = corpus(name);
        let mut random = Random::new(seed);
        let (begin, mut runs) = (Instant::now(), 0);
        while begin.elapsed() < Duration::from_secs(seconds) {
            let bytes = changed(&all, &mut random);
            if catch_unwind(AssertUnwindSafe(|| check(&bytes))).is_err() {
                let kept = report_path(&format!("fuzz_{name}"));
                fs::write(&kept, bytes).expect("target/reports can be written");
                panic!(
                    "{name}: run {runs} of seed {seed} fails; its bytes are in {}",
                    kept.display()
                );
            }
            runs += 1;
        }
        println!("{name}: {runs} runs of seed {seed}");
    }
}
