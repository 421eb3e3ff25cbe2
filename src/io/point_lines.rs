//! Lines of points as they are found in files: comments, headings, and the points themselves.

use crate::geometry::profiles::profile::{ProfileError, ProfileRemark};
use crate::geometry::profiles::profile_points::FilePoint;
use crate::io::table::{Line, numbers};

/// What begins a comment, at the beginning of a line or behind data.
const COMMENT: [char; 4] = ['#', '!', '%', '"'];
/// Most lines before the first point that are passed over.
const MAX_HEADINGS: usize = 20;

/// A line and its comment, which begins with one of `#`, `!`, `%` and `"`.
pub(crate) fn parted(text: &str) -> (&str, &str) {
    let (data, comment) = text.split_at(text.find(COMMENT).unwrap_or(text.len()));
    (data.trim(), comment.trim_start_matches(COMMENT).trim())
}

/// The comment that a line consists of, if it is one.
pub(crate) fn comment_of(text: &str) -> Option<&str> {
    let (data, comment) = parted(text);
    (data.is_empty() && !comment.is_empty()).then_some(comment)
}

/// The points of a file as its lines are read.
#[derive(Debug)]
pub(crate) struct PointLines<'a> {
    pub file: &'a str,
    /// Columns of y and z, from 0.
    pub pick: [usize; 2],
    /// Admitted numbers of columns.
    pub columns: std::ops::RangeInclusive<usize>,
    /// What a line should say, for messages.
    pub expected: &'static str,
    /// The points so far, in the unit of the file.
    pub points: Vec<FilePoint>,
    /// Lines before the first point that are none.
    pub passed_over: Vec<Line<'a>>,
    /// Points that are commented out.
    pub left_out: usize,
}

impl<'a> PointLines<'a> {
    pub(crate) fn new(
        file: &'a str,
        pick: [usize; 2],
        columns: std::ops::RangeInclusive<usize>,
        expected: &'static str,
    ) -> Self {
        Self {
            file,
            pick,
            columns,
            expected,
            points: Vec::new(),
            passed_over: Vec::new(),
            left_out: 0,
        }
    }

    /// Takes a line: a point, a comment, nothing, or before the first point a line of words or of a
    /// single number.
    pub(crate) fn read(&mut self, line: Line<'a>) -> Result<(), ProfileError> {
        let (data, comment) = parted(line.text);
        let is_left_out = data.is_empty() && numbers(comment).is_some_and(|n| n.len() >= 2);
        self.left_out += usize::from(is_left_out);
        let line = Line { text: data, ..line };
        if line.text.is_empty() {
            return Ok(());
        }
        if self.points.is_empty() && is_no_point(line.text) && self.passed_over.len() < MAX_HEADINGS
        {
            self.passed_over.push(line);
            return Ok(());
        }
        let point = line.point(self.file, self.pick, self.columns.clone(), self.expected)?;
        self.points.push(FilePoint { point, line: line.number });
        Ok(())
    }

    /// Remarks on the lines passed over after the first `expected` ones.
    pub(crate) fn remarks(&self, expected: usize) -> Vec<ProfileRemark> {
        let remark = |line: &Line| ProfileRemark::LinePassedOver {
            file: self.file.into(),
            line: line.number,
            text: line.shown(),
        };
        self.passed_over.iter().skip(expected).map(remark).collect()
    }

    /// All coordinates, in the unit of the file.
    pub(crate) fn coordinates(&self) -> Vec<f64> {
        self.points.iter().flat_map(|p| p.point).collect()
    }
}

/// Words, or a count: a line with a number in its first column and more behind it is a point, good
/// or bad.
fn is_no_point(text: &str) -> bool {
    let first = text.split([' ', '\t', ',', ';']).find(|c| !c.is_empty());
    match numbers(text) {
        Some(numbers) => numbers.len() == 1,
        None => first.is_none_or(|column| numbers(column).is_none()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::table::lines;

    fn read(content: &str) -> Result<PointLines<'_>, ProfileError> {
        let mut found = PointLines::new("a.txt", [0, 1], 2..=2, "give two numbers");
        for line in lines(content) {
            found.read(line)?;
        }
        Ok(found)
    }

    #[test]
    fn comments_of_all_kinds_are_passed_over() {
        let content =
            "% 9 9\n# 9 9\n\"9 9\n!9 9\n1 2 % first\n3 4 \"second\n5 6 # third\n7 8! last\n";
        let found = read(content).unwrap();
        let lines: Vec<usize> = found.points.iter().map(|p| p.line).collect();
        assert_eq!(lines, [5, 6, 7, 8]);
        assert!(found.remarks(0).is_empty());
    }

    #[test]
    fn lines_before_the_first_point_that_are_none_are_told() {
        let found = read("a wheel\n   2\ny z\n1 2\n3 4\n").unwrap();
        assert_eq!(found.points.len(), 2);
        let remarks = found.remarks(1);
        assert_eq!(remarks.len(), 2);
        assert_eq!(remarks[0].to_string(), "a.txt:2: \"2\" is no point and was passed over");
        assert!(remarks[0].is_warning());
        // A spoilt point is no heading, nor is anything after the first point.
        for (content, at) in [("1 2x\n3 4\n", 1), ("1 2\nwords\n", 2), ("1 2\n3\n", 2)] {
            let error = read(content).unwrap_err();
            assert!(matches!(error, ProfileError::BadLine { line, .. } if line == at), "{error}");
        }
        assert!(read(&"words\n".repeat(30)).is_err());
    }
}
