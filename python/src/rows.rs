//! Rows of a table shared out among threads.
//!
//! Threads live as long as a call: a pool that outlives it would hang in processes forked from this one.

use std::panic::resume_unwind;
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// Most rows that a thread takes at once: enough to forget the lock.
const MOST_AT_ONCE: usize = 32;
/// Shares for each thread at least, so that those with rows that take long do not keep the others waiting.
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

/// Fills all rows by `work(kept, row, numbers, state)` on as many threads as there are things `kept`; each thread has one for its own.
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
    let piece = (states.len() / (SHARES * kept.len())).clamp(1, MOST_AT_ONCE);
    // Rows without numbers have states still.
    let mut numbers = numbers.chunks_mut((piece * width).max(1));
    let pieces =
        states.chunks_mut(piece).map(move |states| (numbers.next().unwrap_or_default(), states));
    let pieces = Mutex::new(pieces.enumerate());
    let failed: Mutex<Option<(usize, E)>> = Mutex::new(None);
    let is_failed = || failed.lock().unwrap_or_else(PoisonError::into_inner).is_some();
    let share = |kept: &mut K| {
        while !is_failed() {
            let next = pieces.lock().unwrap_or_else(PoisonError::into_inner).next();
            let Some((number, (numbers, states))) = next else { return };
            for (i, state) in states.iter_mut().enumerate() {
                let row = first + number * piece + i;
                if let Err(error) = work(kept, row, &mut numbers[i * width..(i + 1) * width], state)
                {
                    let mut earliest = failed.lock().unwrap_or_else(PoisonError::into_inner);
                    // Pieces are taken in order: of those before this one none is left out.
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
