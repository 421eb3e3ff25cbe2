//! Tables of cases: every complaint with its row and column.

use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use anyhow::{Context, Result, bail};
use csv::{ReaderBuilder, StringRecord, Trim};
use wheelrail::io::number;

/// Names of columns beyond are none, nor are any with control characters.
const LONGEST_NAME: usize = 100;
/// Lines beyond are none of a table [bytes].
const LONGEST_LINE: usize = 1 << 20;

/// The header of a table of cases.
#[derive(Debug)]
pub struct Header {
    path: PathBuf,
    columns: StringRecord,
    /// What parts the columns: a comma, a semicolon or a tab.
    delimiter: u8,
}

/// One row of a table.
#[derive(Clone, Debug)]
pub struct Row {
    header: Arc<Header>,
    cells: StringRecord,
    /// Its number, from 0, the header not counted.
    index: usize,
    /// Its line, from 1.
    line: usize,
}

/// A table that is read row by row.
///
/// Columns are parted by commas, or as the header has it by semicolons or tabs; with these a
/// decimal comma is read too. Lines that begin with `#` are comments.
pub struct CaseReader {
    header: Arc<Header>,
    lines: Lines,
    rows: usize,
}

/// A table as a whole.
#[derive(Debug)]
pub struct Cases {
    header: Arc<Header>,
    rows: Vec<Row>,
}

impl Header {
    fn read(path: &Path, line: &str) -> Result<Self> {
        let shown = path.display();
        let delimiter =
            *[b'\t', b';'].iter().find(|d| line.as_bytes().contains(d)).unwrap_or(&b',');
        let columns = cells(line, delimiter).with_context(|| format!("cannot read {shown}"))?;
        for (index, name) in columns.iter().enumerate() {
            if name.chars().count() > LONGEST_NAME || name.chars().any(char::is_control) {
                let begin: String = name.escape_debug().take(40).collect();
                bail!("{shown}: column {} is called \"{begin}...\": this is no table", index + 1);
            }
            if name.is_empty() {
                bail!("{shown}: column {} has no name", index + 1);
            }
            if columns.iter().take(index).any(|other| other == name) {
                bail!("{shown}: column \"{name}\" occurs twice");
            }
        }
        Ok(Self { path: path.into(), columns, delimiter })
    }

    /// Names of the columns.
    pub fn columns(&self) -> impl Iterator<Item = &str> {
        self.columns.iter()
    }

    /// What parts the columns.
    pub fn delimiter(&self) -> char {
        self.delimiter.into()
    }

    /// Number of the column called `name`, from 0.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.columns().position(|column| column == name)
    }

    /// Folder of the file, to which file names in it are relative.
    pub fn folder(&self) -> PathBuf {
        match self.path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder.into(),
            _ => ".".into(),
        }
    }

    /// The file and the column called `name`, for complaints about a column as a whole.
    pub fn column_place(&self, name: &str) -> String {
        format!("{}, column \"{name}\"", self.path.display())
    }

    fn row_place(&self, index: usize, line: usize) -> String {
        format!("{}, row {} (line {line})", self.path.display(), index + 1)
    }
}

impl CaseReader {
    /// Opens the file `path` and reads its header.
    pub fn open(path: &Path) -> Result<Self> {
        let context = || format!("cannot read {}", path.display());
        let file = File::open(path).with_context(context)?;
        let mut lines = Lines {
            reader: BufReader::with_capacity(1 << 16, file),
            number: 0,
            after_return: false,
        };
        let first = lines.next().with_context(context)?;
        let Some(first) = first else { return Err(no_rows(path)) };
        let header = Arc::new(Header::read(path, &first)?);
        Ok(Self { header, lines, rows: 0 })
    }

    /// The header.
    pub fn header(&self) -> &Arc<Header> {
        &self.header
    }

    fn row(&mut self) -> Result<Option<Row>> {
        let (index, header) = (self.rows, &self.header);
        let next = self.lines.next();
        let place = || header.row_place(index, self.lines.number);
        let Some(text) = next.with_context(place)? else {
            return if index > 0 { Ok(None) } else { Err(no_rows(&header.path)) };
        };
        self.rows += 1;
        let cells = cells(&text, header.delimiter).with_context(place)?;
        let (found, expected) = (cells.len(), header.columns.len());
        if found > expected && header.delimiter == b',' {
            bail!(
                "{}: it has {found} of {expected} cells: write one for each column, with decimal points; for decimal commas part \
                 columns by semicolons or tabs",
                place()
            );
        }
        if found != expected {
            bail!(
                "{}: it has {found} of {expected} cells: write one for each column, empty where the start value does",
                place()
            );
        }
        Ok(Some(Row { cells, index, line: self.lines.number, header: header.clone() }))
    }
}

impl Iterator for CaseReader {
    type Item = Result<Row>;

    fn next(&mut self) -> Option<Result<Row>> {
        self.row().transpose()
    }
}

fn no_rows(path: &Path) -> anyhow::Error {
    anyhow::anyhow!("{} has no rows: write a header and one row for each case", path.display())
}

impl Cases {
    /// Reads the file `path`.
    pub fn read(path: &Path) -> Result<Self> {
        let reader = CaseReader::open(path)?;
        Ok(Self { header: reader.header.clone(), rows: reader.collect::<Result<_>>()? })
    }

    /// Reads the file `path`, which has to have a row number `row`, from 1.
    pub fn with_row(path: &Path, row: usize) -> Result<Self> {
        let cases = Self::read(path)?;
        if row == 0 || row > cases.rows.len() {
            bail!("--row {row}: {} has rows 1 to {}", path.display(), cases.rows.len());
        }
        Ok(cases)
    }

    /// The header.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// Number of the column called `name`, from 0.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.header.column(name)
    }

    /// The rows in order.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }
}

impl Row {
    /// The cell in `column`; `None` if it is empty, which is as if the column were left out.
    pub fn cell(&self, column: usize) -> Option<&str> {
        self.cells.get(column).filter(|cell| !cell.is_empty())
    }

    /// The finite number in `column`.
    pub fn number(&self, column: usize) -> Result<f64> {
        let text = self.cell(column).unwrap_or_default();
        number(text).filter(|value| value.is_finite()).with_context(|| {
            format!("{}: \"{text}\" is not a finite number", self.cell_place(column))
        })
    }

    /// The finite number in the column called `name`, if it has one.
    pub fn number_named(&self, name: &str) -> Result<Option<f64>> {
        let column = self.header.column(name).filter(|&column| self.cell(column).is_some());
        column.map(|column| self.number(column)).transpose()
    }

    /// All cells as they stand.
    pub fn all_cells(&self) -> impl Iterator<Item = &str> {
        self.cells.iter()
    }

    /// Names and values of the cells that are not empty, with the numbers of their columns.
    pub fn cells(&self) -> impl Iterator<Item = (usize, &str, &str)> {
        let columns = self.header.columns.iter().enumerate();
        columns.filter_map(|(column, name)| Some((column, name, self.cell(column)?)))
    }

    /// File, row (from 1, the header not counted) and line, for complaints.
    pub fn place(&self) -> String {
        self.header.row_place(self.index, self.line)
    }

    /// The same with the name of the column.
    pub fn cell_place(&self, column: usize) -> String {
        format!("{}, column \"{}\"", self.place(), &self.header.columns[column])
    }
}

/// The lines of a file that are neither empty nor comments, whatever ends them.
struct Lines {
    reader: BufReader<File>,
    /// Number of the line read last, from 1.
    number: usize,
    /// Whether that one ended with a carriage return, to which a line feed may belong.
    after_return: bool,
}

impl Lines {
    fn next(&mut self) -> Result<Option<String>> {
        loop {
            let Some(line) = self.any()? else { return Ok(None) };
            let line = String::from_utf8(line)
                .ok()
                .with_context(|| format!("line {} is not UTF-8: save the table so", self.number))?;
            // Spreadsheets begin files with a byte order mark.
            let text = if self.number == 1 { line.trim_start_matches('\u{feff}') } else { &line };
            if text.starts_with('#') || text.trim().is_empty() {
                continue;
            }
            return Ok(Some(text.to_owned()));
        }
    }

    /// The next line, even if it is empty.
    fn any(&mut self) -> Result<Option<Vec<u8>>> {
        let mut line = Vec::new();
        loop {
            let read = match self.reader.fill_buf() {
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                read => read?,
            };
            if read.is_empty() {
                self.number += usize::from(!line.is_empty());
                return Ok(Some(line).filter(|line| !line.is_empty()));
            }
            if std::mem::take(&mut self.after_return) && read[0] == b'\n' {
                self.reader.consume(1);
                continue;
            }
            let end = read.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
            line.extend(&read[..end.unwrap_or(read.len())]);
            if line.len() > LONGEST_LINE {
                bail!("line {} is longer than a megabyte: this is no table", self.number + 1);
            }
            if let Some(end) = end {
                self.after_return = read[end] == b'\r';
                self.number += 1;
                self.reader.consume(end + 1);
                return Ok(Some(line));
            }
            let count = read.len();
            self.reader.consume(count);
        }
    }
}

/// The cells of one line. Where commas do not part them, numbers with a decimal comma get a point.
fn cells(line: &str, delimiter: u8) -> Result<StringRecord> {
    let cells = match line.matches('"').count() {
        // A reader for each line would take longer than what is computed for it.
        0 => line.split(char::from(delimiter)).map(str::trim).collect(),
        marks if marks % 2 == 1 => bail!("a quotation mark is not closed"),
        _ => quoted_cells(line, delimiter)?,
    };
    if delimiter == b',' || !line.contains(',') {
        return Ok(cells);
    }
    let with_point = |cell: &str| {
        let point = cell.replacen(',', ".", 1);
        if number(&point).is_some() { point } else { cell.into() }
    };
    Ok(cells.iter().map(with_point).collect())
}

/// The cells of one line of which some stand between quotation marks.
fn quoted_cells(line: &str, delimiter: u8) -> Result<StringRecord> {
    let mut builder = ReaderBuilder::new();
    builder.has_headers(false).delimiter(delimiter).trim(Trim::All).buffer_capacity(line.len());
    let mut cells = StringRecord::new();
    builder.from_reader(line.as_bytes()).read_record(&mut cells)?;
    Ok(cells)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: impl AsRef<[u8]>) -> Result<Cases> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cases.csv");
        std::fs::write(&path, text).unwrap();
        Cases::read(&path)
    }

    #[test]
    fn cells_know_where_they_stand() {
        for end in ["\n", "\r\n", "\r"] {
            let text = "\u{feff}# made by hand\n a , b\n1,2\n \n# more\n3, ".replace('\n', end);
            let cases = read(text).unwrap();
            assert_eq!(cases.header().columns().collect::<Vec<_>>(), ["a", "b"]);
            let rows = cases.rows();
            assert_eq!(rows[0].cells().collect::<Vec<_>>(), [(0, "a", "1"), (1, "b", "2")]);
            assert_eq!(rows[1].cell(1), None);
            assert!(rows[1].cell_place(1).ends_with("cases.csv, row 2 (line 6), column \"b\""));
        }
    }

    #[test]
    fn semicolons_and_tabs_admit_decimal_commas() {
        for delimiter in [";", "\t"] {
            let text = ["a;b;c", "0,5;-1,5E-3;\"x;y, z\"", "1.5;;1,5,5"].join("\n");
            let cases = read(text.replace(';', delimiter)).unwrap();
            let values = |row: usize| (0..3).map(|c| cases.rows()[row].cell(c)).collect::<Vec<_>>();
            let quoted = "x;y, z".replace(';', delimiter);
            assert_eq!(values(0), [Some("0.5"), Some("-1.5E-3"), Some(quoted.as_str())]);
            assert_eq!(values(1), [Some("1.5"), None, Some("1,5,5")]);
        }
    }

    #[test]
    fn tables_that_are_none_are_refused() {
        let message = |text: &str| format!("{:#}", read(text).unwrap_err());
        assert!(message("a,b\n").contains("has no rows"));
        assert!(message("# nothing\n").contains("has no rows"));
        assert!(message("a,,b\n1,2,3\n").contains("column 2 has no name"));
        let latin = format!("{:#}", read(b"a\n\xe4\n").unwrap_err());
        assert!(latin.contains("line 2 is not UTF-8"), "{latin}");
        let endless = "a\n".to_owned() + &"1".repeat(LONGEST_LINE + 1);
        assert!(message(&endless).contains("line 2 is longer than a megabyte"));
    }
}
