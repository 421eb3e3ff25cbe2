//! Many cases at once on all cores, their results in order.

use anyhow::Result;
use rayon::prelude::*;

/// Cases taken by one core before results are written.
const SHARE: usize = 4;

/// Computes `work(case)` for all `cases`, several at once if `parallel`, and hands the results to `done` in order.
///
/// # Errors
/// The first error of a case or of `done`; the results before it have been handed over.
pub fn in_order<T: Sync, R: Send>(
    cases: &[T],
    parallel: bool,
    work: impl Fn(&T) -> Result<R> + Sync,
    mut done: impl FnMut(&T, R) -> Result<()>,
) -> Result<()> {
    if !parallel {
        return cases.iter().try_for_each(|case| done(case, work(case)?));
    }
    for batch in cases.chunks(SHARE * rayon::current_num_threads()) {
        let results: Vec<Result<R>> = batch.par_iter().map(&work).collect();
        for (case, result) in batch.iter().zip(results) {
            done(case, result?)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_order_and_end_at_the_first_error() {
        let cases: Vec<i32> = (0..500).collect();
        for parallel in [false, true] {
            let mut seen = Vec::new();
            let result = in_order(
                &cases,
                parallel,
                |case| if *case == 337 { anyhow::bail!("no") } else { Ok(2 * case) },
                |_, double| {
                    seen.push(double);
                    Ok(())
                },
            );
            assert!(result.is_err());
            assert_eq!(seen, (0..337).map(|case| 2 * case).collect::<Vec<_>>());
        }
    }
}
