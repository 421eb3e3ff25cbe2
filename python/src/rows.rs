//! Rows of a table shared out among threads.
//!
//! Threads live as long as a call: a pool that outlives it would hang in processes forked from this one.

use std::panic::resume_unwind;
use std::sync::{Mutex, PoisonError};
use std::thread;

/// Rows that a thread takes at once: enough to forget the lock, few enough to share out rows that take long.
const PIECE: usize = 32;

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
    let Target { numbers, width, states } = target;
    // Rows without numbers have states still.
    let mut numbers = numbers.chunks_mut((PIECE * width).max(1));
    let pieces =
        states.chunks_mut(PIECE).map(move |states| (numbers.next().unwrap_or_default(), states));
    let pieces = Mutex::new(pieces.enumerate());
    let failed: Mutex<Option<(usize, E)>> = Mutex::new(None);
    let is_failed = || failed.lock().unwrap_or_else(PoisonError::into_inner).is_some();
    let share = |kept: &mut K| {
        while !is_failed() {
            let next = pieces.lock().unwrap_or_else(PoisonError::into_inner).next();
            let Some((number, (numbers, states))) = next else { return };
            for (i, state) in states.iter_mut().enumerate() {
                let row = number * PIECE + i;
                if let Err(error) = work(kept, row, &mut numbers[i * width..(i + 1) * width], state)
                {
                    let mut first = failed.lock().unwrap_or_else(PoisonError::into_inner);
                    // Pieces are taken in order: of those before this one none is left out.
                    if first.as_ref().is_none_or(|(other, _)| row < *other) {
                        *first = Some((row, error));
                    }
                    return;
                }
            }
        }
    };
    match kept {
        [own] => share(own),
        _ => thread::scope(|scope| {
            let threads: Vec<_> = kept.iter_mut().map(|own| scope.spawn(|| share(own))).collect();
            for thread in threads {
                if let Err(panic) = thread.join() {
                    resume_unwind(panic);
                }
            }
        }),
    }
    match failed.into_inner().unwrap_or_else(PoisonError::into_inner) {
        Some(failed) => Err(failed),
        None => Ok(()),
    }
}

/// How many threads `rows` rows are worth, of those asked for.
pub fn threads_for(rows: usize, asked: usize) -> usize {
    asked.min(rows.div_ceil(PIECE)).max(1)
}
