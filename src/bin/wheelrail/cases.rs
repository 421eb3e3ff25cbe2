//! Tables of cases: read whole, and every complaint with its row and column.

use std::path::{Display, Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail};
use csv::{ReaderBuilder, StringRecord, Trim};

/// A table of cases with a header. Lines that begin with `#` are comments.
#[derive(Debug)]
pub struct Cases {
    path: PathBuf,
    header: StringRecord,
    rows: Vec<StringRecord>,
    /// Lines on which the rows begin, from 1.
    lines: Vec<usize>,
}

/// One row of a table.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a> {
    cases: &'a Cases,
    index: usize,
}

impl Cases {
    /// Reads the file `path`.
    ///
    /// # Errors
    /// If the file cannot be read, has no rows, a row is of another length than the header, or a column
    /// occurs twice.
    pub fn read(path: &Path) -> Result<Self> {
        let shown = path.display();
        let text = std::fs::read_to_string(path).with_context(|| format!("cannot read {shown}"))?;
        let mut reader =
            ReaderBuilder::new().trim(Trim::All).comment(Some(b'#')).from_reader(text.as_bytes());
        let header = reader.headers().with_context(|| format!("cannot read {shown}"))?.clone();
        for (index, name) in header.iter().enumerate() {
            if name.is_empty() {
                bail!("{shown}: column {} has no name", index + 1);
            }
            if header.iter().take(index).any(|other| other == name) {
                bail!("{shown}: column \"{name}\" occurs twice");
            }
        }
        if header.len() == 1 && header[0].contains([';', '\t']) {
            bail!("{shown}: part columns by commas, with decimal points in the numbers");
        }
        let rows: Vec<StringRecord> =
            reader.records().collect::<Result<_, _>>().map_err(|error| unread(error, &shown))?;
        if rows.is_empty() {
            bail!("{shown} has no rows: write a header and one row for each case");
        }
        let lines = rows.iter().map(|row| line_of(row, &text)).collect();
        Ok(Self { path: path.into(), header, rows, lines })
    }

    /// Names of the columns.
    pub fn columns(&self) -> impl Iterator<Item = &str> {
        self.header.iter()
    }

    /// Number of the column called `name`, from 0.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.columns().position(|column| column == name)
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// The rows in order.
    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        (0..self.rows.len()).map(|index| Row { cases: self, index })
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
}

impl<'a> Row<'a> {
    /// The cell in `column`; `None` if it is empty, which is as if the column were left out.
    pub fn cell(&self, column: usize) -> Option<&'a str> {
        self.cases.rows[self.index].get(column).filter(|cell| !cell.is_empty())
    }

    /// Names and values of the cells that are not empty, with the numbers of their columns.
    pub fn cells(&self) -> impl Iterator<Item = (usize, &'a str, &'a str)> {
        let row = *self;
        let columns = row.cases.header.iter().enumerate();
        columns.filter_map(move |(column, name)| Some((column, name, row.cell(column)?)))
    }

    /// File, row (from 1, the header not counted) and line, for complaints.
    pub fn place(&self) -> String {
        let line = self.cases.lines[self.index];
        format!("{}, row {} (line {line})", self.cases.path.display(), self.index + 1)
    }

    /// The same with the name of the column.
    pub fn cell_place(&self, column: usize) -> String {
        format!("{}, column \"{}\"", self.place(), &self.cases.header[column])
    }
}

/// What a row is refused for.
fn unread(error: csv::Error, shown: &Display<'_>) -> anyhow::Error {
    let csv::ErrorKind::UnequalLengths { pos: Some(place), expected_len, len } = error.kind()
    else {
        return anyhow::Error::new(error).context(format!("cannot read {shown}"));
    };
    let (row, line) = (place.record(), place.line());
    anyhow!(
        "{shown}, row {row} (line {line}): it has {len} of {expected_len} cells: write one for each column, empty where the start \
         value does"
    )
}

/// Line of `text`, from 1, on which `row` begins. The position of a record is where its reading began: empty lines
/// and comments before it are still to be passed.
fn line_of(row: &StringRecord, text: &str) -> usize {
    let first = row.position().map_or(1, |position| position.line() as usize);
    let skipped = text
        .lines()
        .skip(first - 1)
        .take_while(|line| line.is_empty() || line.starts_with('#'))
        .count();
    first + skipped
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Cases> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cases.csv");
        std::fs::write(&path, text).unwrap();
        Cases::read(&path)
    }

    #[test]
    fn cells_know_where_they_stand() {
        let cases = read("# made by hand\n a , b\n1,2\n\n3, \n").unwrap();
        assert_eq!(cases.columns().collect::<Vec<_>>(), ["a", "b"]);
        let rows: Vec<Row<'_>> = cases.rows().collect();
        assert_eq!(rows[0].cells().collect::<Vec<_>>(), [(0, "a", "1"), (1, "b", "2")]);
        assert_eq!(rows[1].cell(1), None);
        assert!(rows[1].cell_place(1).ends_with("cases.csv, row 2 (line 5), column \"b\""));
    }

    #[test]
    fn tables_that_are_none_are_refused() {
        let message = |text| format!("{:#}", read(text).unwrap_err());
        assert!(message("a,b\n").contains("has no rows"));
        assert!(message("a,a\n1,2\n").contains("column \"a\" occurs twice"));
        assert!(message("a,,b\n1,2,3\n").contains("column 2 has no name"));
        assert!(message("a,b\n1,2\n3\n").contains("row 2 (line 3): it has 1 of 2 cells"));
        assert!(message("a;b\n1;2\n").contains("part columns by commas"));
    }
}
