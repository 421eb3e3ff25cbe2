//! Numbers of one line of a profile file.

use crate::geometry::profiles::profile::ProfileError;

/// A line and its number, from 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line<'a> {
    pub number: usize,
    pub text: &'a str,
}

/// Lines of a file, whatever ends them.
pub(crate) fn lines(content: &str) -> impl Iterator<Item = Line<'_>> {
    // A lone carriage return ends a line in files of old systems.
    let separator = if content.contains('\n') { '\n' } else { '\r' };
    (1..).zip(content.split(separator)).map(|(number, text)| Line { number, text: text.trim() })
}

/// Lines that hold more than a comment, without it; comments begin with `#` or `!`.
pub(crate) fn rows(content: &str) -> impl Iterator<Item = Line<'_>> {
    lines(content)
        .map(|Line { number, text }| Line {
            number,
            text: text.split(['#', '!']).next().unwrap_or_default().trim(),
        })
        .filter(|line| !line.text.is_empty())
}

/// The columns of a line, separated by blanks, tabs, semicolons or commas.
///
/// With semicolons a comma is a decimal point.
pub(crate) fn columns(text: &str) -> Vec<String> {
    let decimal_comma = text.contains(';');
    text.split(|c: char| c.is_whitespace() || c == ';' || (c == ',' && !decimal_comma))
        .filter(|column| !column.is_empty())
        .map(|column| column.replace(',', "."))
        .collect()
}

/// All columns as numbers, or nothing if one of them is none. Infinite ones and NaN are numbers
/// here.
pub(crate) fn numbers(text: &str) -> Option<Vec<f64>> {
    let numbers: Option<Vec<f64>> = columns(text).iter().map(|column| number(column)).collect();
    numbers.filter(|numbers| !numbers.is_empty())
}

/// The number that a text is, with the exponents of Fortran admitted too: 1.5D-3 is 1.5e-3.
pub fn number(text: &str) -> Option<f64> {
    text.parse().or_else(|_| text.replace(['d', 'D'], "e").parse()).ok()
}

impl Line<'_> {
    /// Why this line of `file` is refused: what is `allowed` instead.
    pub(crate) fn refused(&self, file: &str, allowed: &'static str) -> ProfileError {
        ProfileError::BadHeader {
            file: file.into(),
            line: self.number,
            text: self.shown(),
            allowed,
        }
    }

    /// The numbers of columns `pick` of this line, all of them finite.
    pub(crate) fn point(
        &self,
        file: &str,
        pick: [usize; 2],
        admitted_columns: std::ops::RangeInclusive<usize>,
        expected: &'static str,
    ) -> Result<[f64; 2], ProfileError> {
        let found = numbers(self.text).filter(|n| admitted_columns.contains(&n.len()));
        let pair = found.and_then(|n| Some([*n.get(pick[0])?, *n.get(pick[1])?]));
        let pair = pair.ok_or_else(|| ProfileError::BadLine {
            file: file.into(),
            line: self.number,
            text: self.shown(),
            expected,
        })?;
        if pair.iter().any(|n| !n.is_finite()) {
            let text = self.shown();
            return Err(ProfileError::NotFinite { file: file.into(), line: self.number, text });
        }
        Ok(pair)
    }

    /// The text, shortened for a message.
    pub(crate) fn shown(&self) -> String {
        let longest = 60;
        if self.text.chars().count() <= longest {
            return self.text.into();
        }
        self.text.chars().take(longest).chain("...".chars()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_separated_by_blanks_tabs_commas_and_semicolons() {
        for text in
            ["1.5 -2", "1.5,-2", "1.5, -2.0", "1.5\t-2", "1.5;-2", "1,5; -2,0", "1.5D0 -2d+0"]
        {
            assert_eq!(numbers(text), Some(vec![1.5, -2.0]), "{text}");
        }
        assert_eq!(numbers("y_mm z_mm"), None);
        assert_eq!(numbers(""), None);
        assert_eq!(numbers("1 2x"), None);
    }

    #[test]
    fn lines_count_from_one_whatever_ends_them() {
        for text in ["a\nb\nc", "a\r\nb\r\nc", "a\rb\rc"] {
            let found: Vec<_> = lines(text).map(|l| (l.number, l.text)).collect();
            assert_eq!(found, [(1, "a"), (2, "b"), (3, "c")]);
        }
    }
}
