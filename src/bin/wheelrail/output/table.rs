//! A table under way: whole lines only, and what is done of it stays when it is stopped.

use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, Once, PoisonError, Weak};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, anyhow};

use wheelrail::io::Draft;

/// Lines are held back until there are that many bytes of them …
const MAX_BUFFERED: usize = 1 << 16;
/// … or for that time.
const LONGEST_HELD_BACK: Duration = Duration::from_millis(200);
/// What a shell reports of a program that an interrupt has ended.
const INTERRUPTED: i32 = 130;

/// A table under way, with a header. A file gets its name when the table is finished; on standard
/// output, or to a pipe, whole lines are written soon after they come.
#[derive(Debug)]
pub struct Table(Arc<Mutex<Lines>>);

#[derive(Debug)]
struct Lines {
    /// The file; nothing is standard output.
    draft: Option<Draft>,
    held_back: Vec<u8>,
    /// How many lines these are, and how many were written before, with the header.
    held_back_count: usize,
    written_count: usize,
    last_write: Instant,
}

/// The tables in files that are not finished.
static UNDER_WAY: Mutex<Vec<Weak<Mutex<Lines>>>> = Mutex::new(Vec::new());
/// Whether interrupts are waited for.
static HANDLER: Once = Once::new();

impl Table {
    /// A table in the file `path`, or on standard output without one.
    pub fn new(path: Option<&Path>) -> Result<Self> {
        let new = |path: &Path| Draft::new(path).with_context(|| cannot_write(path));
        let draft = path.map(new).transpose()?;
        let is_kept = draft.as_ref().is_some_and(Draft::can_be_kept);
        let lines = Arc::new(Mutex::new(Lines {
            draft,
            held_back: Vec::new(),
            held_back_count: 0,
            written_count: 0,
            last_write: Instant::now(),
        }));
        if is_kept {
            under_way().push(Arc::downgrade(&lines));
            // Where the interrupt is ignored, as under nohup, it stays so. Without a handler the
            // file stays too, only nothing is said.
            HANDLER.call_once(|| drop(ctrlc::try_set_handler(leave)));
        }
        Ok(Self(lines))
    }

    fn lines(&self) -> MutexGuard<'_, Lines> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Appends a line of cells.
    pub fn write_record(&self, cells: impl IntoIterator<Item = impl AsRef<[u8]>>) -> Result<()> {
        self.write_line(&line(cells)?)
    }

    /// Appends a line of cells, each with the name of its column; the names come before the first
    /// line, so that a table of which there is none leaves nothing but its error.
    pub fn write_named(&self, cells: &[(impl AsRef<[u8]>, impl AsRef<[u8]>)]) -> Result<()> {
        let is_first = {
            let lines = self.lines();
            lines.held_back_count + lines.written_count == 0
        };
        if is_first {
            self.write_record(cells.iter().map(|(name, _)| name))?;
        }
        self.write_record(cells.iter().map(|(_, cell)| cell))
    }

    /// Appends a line that has its end.
    pub fn write_line(&self, line: &[u8]) -> Result<()> {
        let mut lines = self.lines();
        lines.held_back.extend(line);
        lines.held_back_count += 1;
        if lines.held_back.len() < MAX_BUFFERED && lines.last_write.elapsed() < LONGEST_HELD_BACK {
            return Ok(());
        }
        lines.flush()
    }

    /// Writes what is left and gives the file its name.
    pub fn finish(self) -> Result<()> {
        // An interrupt comes before or after, not in between.
        let _under_way = under_way();
        let mut lines = self.lines();
        lines.flush()?;
        let Some(draft) = lines.draft.take() else { return Ok(()) };
        let path = draft.path().to_owned();
        draft.finish().with_context(|| cannot_write(&path))
    }

    /// Finishes the table if its rows were written without an error. Else the rows before the error
    /// are kept.
    pub fn complete(self, result: Result<()>) -> Result<()> {
        let Err(error) = result else { return self.finish() };
        let _under_way = under_way();
        let kept = self.lines().keep();
        match kept {
            Some(kept) => Err(anyhow!("{error:#}; {kept}")),
            None => Err(error),
        }
    }
}

impl Lines {
    fn flush(&mut self) -> Result<()> {
        if let Some(draft) = &mut self.draft {
            draft.write(&self.held_back).with_context(|| cannot_write(draft.path()))?;
        } else {
            let mut out = io::stdout().lock();
            let written = out.write_all(&self.held_back).and_then(|()| out.flush());
            written.context("cannot write standard output")?;
        }
        self.held_back.clear();
        self.written_count += std::mem::take(&mut self.held_back_count);
        self.last_write = Instant::now();
        Ok(())
    }

    /// Keeps the rows of an unfinished file if there are any, and says where.
    fn keep(&mut self) -> Option<String> {
        // Where the disk is full, those before are there all the same.
        let _ = self.flush();
        let rows = self.written_count.saturating_sub(1);
        let draft = self.draft.take().filter(|draft| rows > 0 && draft.can_be_kept())?;
        let those = if rows == 1 { "row is".into() } else { format!("{rows} rows are") };
        let kept = draft.keep().ok()?;
        Some(format!("the first {those} in {}", kept.display()))
    }
}

fn under_way() -> MutexGuard<'static, Vec<Weak<Mutex<Lines>>>> {
    UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What is said of a file that cannot be written.
pub fn cannot_write(path: &Path) -> String {
    format!("cannot write {}", path.display())
}

/// Ends the program at an interrupt.
fn leave() {
    // Held until the end: nobody finishes a table that is being kept.
    let under_way = under_way();
    let mut messages = io::stderr();
    // After a progress bar.
    let start = if messages.is_terminal() { "\n" } else { "" };
    for table in under_way.iter().filter_map(Weak::upgrade) {
        let mut lines = table.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(kept) = lines.keep() {
            // Nobody may be there to read it.
            let _ = writeln!(messages, "{start}stopped: {kept}");
        }
    }
    std::process::exit(INTERRUPTED);
}

/// A line of a table with its end.
fn line(cells: impl IntoIterator<Item = impl AsRef<[u8]>>) -> Result<Vec<u8>> {
    let mut writer = csv::WriterBuilder::new().buffer_capacity(1 << 10).from_writer(Vec::new());
    writer.write_record(cells)?;
    Ok(writer.into_inner().map_err(csv::IntoInnerError::into_error)?)
}
