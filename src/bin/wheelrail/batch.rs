//! Many cases at once on several threads, their results in order.

use std::collections::BTreeMap;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;

use anyhow::Result;

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
/// order of the cases.
///
/// Cases are taken one by one as threads become free; results wait for those before them. Each
/// thread has something of its own that `keep` makes and that it uses for all of its cases. After an
/// error, the first in the order of the cases, the results before it have been handed over.
pub fn in_order<C, R: Send, K>(
    cases: impl Iterator<Item = Result<C>> + Send,
    threads: usize,
    keep: impl Fn() -> K + Sync,
    work: impl Fn(&mut K, C) -> Result<R> + Sync,
    done: impl FnMut(R) -> Result<()> + Send,
) -> Result<()> {
    let desk = Desk {
        room: AHEAD * threads,
        has_moved: Condvar::new(),
        pile: Mutex::new(Pile {
            cases,
            taken: 0,
            waiting: BTreeMap::new(),
            handed_over: 0,
            done,
            outcome: Ok(()),
            closed: false,
        }),
    };
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                let _closing = CloseOnPanic(&desk);
                let mut kept = keep();
                while let Some((number, case)) = desk.take() {
                    desk.hand_in(number, case.and_then(|case| work(&mut kept, case)));
                }
            });
        }
    });
    let pile = desk.pile.into_inner();
    pile.unwrap_or_else(PoisonError::into_inner).outcome
}

/// What the threads share.
struct Desk<I, R, D> {
    /// Cases that may be taken beyond those handed over.
    room: usize,
    has_moved: Condvar,
    pile: Mutex<Pile<I, R, D>>,
}

struct Pile<I, R, D> {
    cases: I,
    /// Cases taken so far.
    taken: usize,
    /// Results by the numbers of their cases, until those before them are there.
    waiting: BTreeMap<usize, Result<R>>,
    /// Results handed over so far.
    handed_over: usize,
    done: D,
    outcome: Result<()>,
    /// Whether no more cases are taken and no more results handed over.
    closed: bool,
}

impl<C, I: Iterator<Item = Result<C>>, R, D: FnMut(R) -> Result<()>> Desk<I, R, D> {
    /// The next case and its number, once there is room for its result.
    fn take(&self) -> Option<(usize, Result<C>)> {
        let is_full =
            |pile: &mut Pile<I, R, D>| !pile.closed && pile.taken >= pile.handed_over + self.room;
        let pile = self.has_moved.wait_while(self.pile(), is_full);
        let mut pile = pile.unwrap_or_else(PoisonError::into_inner);
        if pile.closed {
            return None;
        }
        let case = pile.cases.next()?;
        pile.taken += 1;
        Some((pile.taken - 1, case))
    }

    /// Takes the result of case `number` and hands over all whose turn has come.
    fn hand_in(&self, number: usize, result: Result<R>) {
        let mut pile = self.pile();
        pile.waiting.insert(number, result);
        while !pile.closed {
            let next = pile.handed_over;
            let Some(result) = pile.waiting.remove(&next) else { break };
            pile.handed_over += 1;
            if let Err(error) = result.and_then(|result| (pile.done)(result)) {
                pile.outcome = Err(error);
                pile.closed = true;
            }
        }
        drop(pile);
        self.has_moved.notify_all();
    }
}

impl<I, R, D> Desk<I, R, D> {
    fn pile(&self) -> MutexGuard<'_, Pile<I, R, D>> {
        self.pile.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Ends the work of the other threads when one of them panics: its result would be waited for
/// without end.
struct CloseOnPanic<'a, I, R, D>(&'a Desk<I, R, D>);

impl<I, R, D> Drop for CloseOnPanic<'_, I, R, D> {
    fn drop(&mut self) {
        if thread::panicking() {
            self.0.pile().closed = true;
            self.0.has_moved.notify_all();
        }
    }
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
        in_order((0..100).map(Ok), 3, keep, |_, _: i32| Ok(()), Ok).unwrap();
        assert_eq!(made.load(Ordering::Relaxed), 3);
    }

    #[test]
    fn a_panic_ends_all() {
        let panics = || {
            in_order(
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
