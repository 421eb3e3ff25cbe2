//! Solution of a planar problem and the time it takes.

use std::time::Instant;

use anyhow::Result;
use wheelrail::planar::{PlanarCase, PlanarResult, solve};

/// Times a case is solved; the median is reported.
const REPEATS: usize = 5;

/// The solution and the time it took [s]: the median of five, that of the first where the models
/// are `slow`.
pub fn timed(case: &PlanarCase<'_>, slow: bool) -> Result<(PlanarResult, f64)> {
    let once = || -> Result<(PlanarResult, f64)> {
        let begin = Instant::now();
        let result = std::hint::black_box(solve(std::hint::black_box(case))?);
        Ok((result, begin.elapsed().as_secs_f64()))
    };
    let first = once()?;
    if slow {
        return Ok(first);
    }
    let mut times = [0.0; REPEATS];
    for time in &mut times {
        *time = once()?.1;
    }
    times.sort_by(f64::total_cmp);
    Ok((first.0, times[REPEATS / 2]))
}
