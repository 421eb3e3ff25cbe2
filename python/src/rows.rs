//! Rows of a table shared out among threads.
//!
//! Threads live as long as a call: a pool that outlives it would hang in processes forked from this
//! one.

use std::mem::take;
use std::panic::resume_unwind;
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// Most rows that a thread takes at once: enough to forget the lock.
const MAX_AT_ONCE: usize = 32;
/// Shares of each thread in the rows that are left when it takes some: fewer and fewer rows, so
/// that none waits long for the others at the end.
const SHARES: usize = 4;
/// Time after which other threads help: some times what it takes to start one.
const ALONE: Duration = Duration::from_micros(200);

/// What is filled for the rows: `width` numbers and one state for each.
pub struct Target<'a> {
    /// Numbers, row after row.
    pub numbers: &'a mut [f64],
    /// Numbers of a row.
    pub width: usize,
    /// States of the rows.
    pub states: &'a mut [u8],
}

/// Rows that no thread has taken.
struct Rows<'a> {
    numbers: &'a mut [f64],
    states: &'a mut [u8],
    first: usize,
}

impl<'a> Rows<'a> {
    /// The next rows, one of `shares` of those that are left.
    fn take(&mut self, width: usize, shares: usize) -> Rows<'a> {
        let count = (self.states.len() / shares).clamp(1, MAX_AT_ONCE).min(self.states.len());
        let (numbers, other_numbers) = take(&mut self.numbers).split_at_mut(count * width);
        let (states, other_states) = take(&mut self.states).split_at_mut(count);
        let first = self.first;
        *self = Rows { numbers: other_numbers, states: other_states, first: first + count };
        Rows { numbers, states, first }
    }
}

/// Fills all rows by `work(kept, row, numbers, state)` on as many threads as there are things
/// `kept`; each thread has one for its own.
///
/// # Errors
/// The one of the first row that fails; rows after it may be left out.
pub fn fill<K: Send, E: Send>(
    target: Target<'_>,
    kept: &mut [K],
    work: impl Fn(&mut K, usize, &mut [f64], &mut u8) -> Result<(), E> + Sync,
) -> Result<(), (usize, E)> {
    let Target { mut numbers, width, mut states } = target;
    let begin = Instant::now();
    let mut first = 0;
    while !states.is_empty() && (kept.len() == 1 || begin.elapsed() < ALONE) {
        let (own_numbers, other_numbers) = numbers.split_at_mut(width);
        let (state, other_states) = states.split_first_mut().expect("there is a row");
        work(&mut kept[0], first, own_numbers, state).map_err(|error| (first, error))?;
        (numbers, states, first) = (other_numbers, other_states, first + 1);
    }
    if states.is_empty() {
        return Ok(());
    }
    let most = SHARES * kept.len();
    let left = Mutex::new(Rows { numbers, states, first });
    let failed: Mutex<Option<(usize, E)>> = Mutex::new(None);
    let is_failed = || failed.lock().unwrap_or_else(PoisonError::into_inner).is_some();
    let share = |kept: &mut K| {
        while !is_failed() {
            let rows = left.lock().unwrap_or_else(PoisonError::into_inner).take(width, most);
            if rows.states.is_empty() {
                return;
            }
            for (i, state) in rows.states.iter_mut().enumerate() {
                let row = rows.first + i;
                let numbers = &mut rows.numbers[i * width..(i + 1) * width];
                if let Err(error) = work(kept, row, numbers, state) {
                    let mut earliest = failed.lock().unwrap_or_else(PoisonError::into_inner);
                    // Rows are taken in order: of those before these none is left out.
                    if earliest.as_ref().is_none_or(|(other, _)| row < *other) {
                        *earliest = Some((row, error));
                    }
                    return;
                }
            }
        }
    };
    thread::scope(|scope| {
        let share = &share;
        let (own, others) = kept.split_first_mut().expect("there is a thread");
        let threads: Vec<_> =
            others.iter_mut().map(|other| scope.spawn(move || share(other))).collect();
        share(own);
        for thread in threads {
            if let Err(panic) = thread.join() {
                resume_unwind(panic);
            }
        }
    });
    match failed.into_inner().unwrap_or_else(PoisonError::into_inner) {
        Some(failed) => Err(failed),
        None => Ok(()),
    }
}

/// How many threads `rows` rows can have, of those asked for.
pub fn threads_for(rows: usize, asked: usize) -> usize {
    asked.min(rows).max(1)
}
