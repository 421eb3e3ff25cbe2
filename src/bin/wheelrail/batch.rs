//! Many cases at once on several threads, their results in order.

use std::sync::mpsc::{self, Receiver};
use std::sync::{Mutex, PoisonError};
use std::thread;

use anyhow::Result;
use indicatif::ProgressBar;

/// Cases that one thread may be ahead of the result that is handed over next. It bounds the memory,
/// and lets the other threads go on while one of them is at a case that takes a thousand times
/// longer.
const AHEAD: usize = 256;

/// Threads for work that is not timed: one for each core, or what the environment variable
/// `RAYON_NUM_THREADS` says.
pub fn all_cores() -> usize {
    rayon::current_num_threads()
}

/// Computes `work` for each of `cases` on `threads` threads and hands the results to `done` in the
/// order of the cases, each of them a step of the `progress`, which is cleared at the end.
///
/// Cases are taken one by one as threads become free; results wait for those before them. Each
/// thread has something of its own that `keep` makes and that it uses for all of its cases. After an
/// error, the first in the order of the cases, the results before it have been handed over.
pub fn in_order<C, R: Send, K>(
    progress: &ProgressBar,
    cases: impl Iterator<Item = Result<C>> + Send,
    threads: usize,
    keep: impl Fn() -> K + Sync,
    work: impl Fn(&mut K, C) -> Result<R> + Sync,
    mut done: impl FnMut(R) -> Result<()>,
) -> Result<()> {
    // One place to wait at for each result, in the order of the cases; two more are in the hands of
    // who sends and who receives.
    let (line, results) = mpsc::sync_channel::<Receiver<Result<R>>>(AHEAD * threads - 2);
    let source = Mutex::new((cases, Some(line)));
    // The next case and where its result goes; none after the last one, or where nobody waits for
    // results any more.
    let take = || {
        let mut source = source.lock().unwrap_or_else(PoisonError::into_inner);
        let (cases, line) = &mut *source;
        let Some(case) = cases.next() else {
            *line = None;
            return None;
        };
        let (answer, result) = mpsc::channel();
        line.as_ref()?.send(result).ok()?;
        Some((case, answer))
    };
    let outcome = thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                let mut kept = keep();
                while let Some((case, answer)) = take() {
                    // Nobody waits for what comes after an error.
                    let _ = answer.send(case.and_then(|case| work(&mut kept, case)));
                }
            });
        }
        for result in results {
            // None comes from a thread that panics, which the end of the scope passes on.
            let Ok(result) = result.recv() else { break };
            result.and_then(&mut done)?;
            progress.inc(1);
        }
        Ok(())
    });
    progress.finish_and_clear();
    outcome
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::time::Duration;

    use super::*;

    #[test]
    fn results_come_in_order_and_end_at_the_first_error() {
        for threads in [1, 2, 7] {
            let mut seen = Vec::new();
            let result = in_order(
                &ProgressBar::hidden(),
                (0..5000).map(Ok),
                threads,
                || (),
                |(), case| if case == 3337 { anyhow::bail!("no") } else { Ok(2 * case) },
                |double| {
                    seen.push(double);
                    Ok(())
                },
            );
            assert!(result.is_err());
            assert_eq!(seen, (0..3337).map(|case| 2 * case).collect::<Vec<_>>());
        }
    }

    #[test]
    fn an_error_of_a_case_comes_after_the_results_before_it() {
        let cases = (0..9).map(|case| if case < 5 { Ok(case) } else { anyhow::bail!("no") });
        let mut count = 0;
        let result = in_order(
            &ProgressBar::hidden(),
            cases,
            3,
            || (),
            |(), case| Ok(case),
            |_| {
                count += 1;
                Ok(())
            },
        );
        assert!(result.is_err());
        assert_eq!(count, 5);
    }

    #[test]
    fn cases_are_not_taken_far_ahead_of_a_slow_one() {
        let taken = AtomicUsize::new(0);
        let cases = (0..10_000).map(|case| {
            taken.fetch_add(1, Ordering::Relaxed);
            Ok(case)
        });
        in_order(
            &ProgressBar::hidden(),
            cases,
            2,
            || (),
            |(), case| {
                if case == 0 {
                    thread::sleep(Duration::from_millis(200));
                    assert!(taken.load(Ordering::Relaxed) <= 2 * AHEAD);
                }
                Ok(())
            },
            Ok,
        )
        .unwrap();
        assert_eq!(taken.load(Ordering::Relaxed), 10_000);
    }

    #[test]
    fn what_a_thread_keeps_is_made_once() {
        let made = AtomicUsize::new(0);
        let keep = || made.fetch_add(1, Ordering::Relaxed);
        in_order(&ProgressBar::hidden(), (0..100).map(Ok), 3, keep, |_, _: i32| Ok(()), Ok)
            .unwrap();
        assert_eq!(made.load(Ordering::Relaxed), 3);
    }

    #[test]
    fn a_panic_ends_all() {
        let panics = || {
            in_order(
                &ProgressBar::hidden(),
                (0..10_000).map(Ok),
                2,
                || (),
                |(), case| {
                    assert!(case != 10, "as it should");
                    Ok(())
                },
                Ok,
            )
        };
        assert!(std::panic::catch_unwind(panics).is_err());
    }
}
