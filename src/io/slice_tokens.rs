//! A file of slices as numbers and names, one after the other.

use super::table::{lines, number};
use crate::geometry::profiles::profile::ProfileError;

/// What begins a comment.
pub(super) const COMMENT: [char; 3] = ['%', '!', '#'];

/// A number or a name of a file, and its line.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    Number(f64),
    Name(String),
}

/// The numbers and names of a file, one after the other.
pub(super) struct Tokens<'a> {
    file: &'a str,
    pub all: Vec<(Token, usize)>,
    pub next: usize,
    last_line: usize,
}

impl<'a> Tokens<'a> {
    pub fn new(file: &'a str, text: &str) -> Self {
        let mut all = Vec::new();
        let mut last_line = 1;
        for line in lines(text) {
            let mut rest = line.text;
            last_line = line.number;
            while let Some((token, after)) = token(rest) {
                all.push((token, line.number));
                rest = after;
            }
        }
        Self { file, all, next: 0, last_line }
    }

    pub fn bad<T>(&self, line: usize, what: String) -> Result<T, ProfileError> {
        Err(ProfileError::BadSlices { file: self.file.into(), line, what })
    }

    fn take(&mut self, wanted: &str) -> Result<(Token, usize), ProfileError> {
        let Some(found) = self.all.get(self.next).cloned() else {
            return self.bad(self.last_line, format!("the file ends before {wanted}; complete it"));
        };
        self.next += 1;
        Ok(found)
    }

    pub fn number(&mut self, wanted: &str) -> Result<(f64, usize), ProfileError> {
        match self.take(wanted)? {
            (Token::Number(x), line) if x.is_finite() => Ok((x, line)),
            (Token::Number(x), line) => {
                self.bad(line, format!("{wanted} is {x}; give a finite number"))
            }
            (Token::Name(name), line) => {
                self.bad(line, format!("'{name}' stands in the place of {wanted}; give a number"))
            }
        }
    }

    pub fn count(&mut self, wanted: &str, most: usize) -> Result<usize, ProfileError> {
        let (x, line) = self.number(wanted)?;
        if x.fract() != 0.0 || !(0.0..=most as f64).contains(&x) {
            return self
                .bad(line, format!("{wanted} is {x}; give a whole number from 0 to {most}"));
        }
        Ok(x as usize)
    }

    pub fn name(&mut self, wanted: &str) -> Result<(String, usize), ProfileError> {
        match self.take(wanted)? {
            (Token::Name(name), line) => Ok((name, line)),
            (Token::Number(x), line) => self
                .bad(line, format!("{x} stands in the place of {wanted}; give it between quotes")),
        }
    }

    /// Passes over what is left of the line of the last token.
    pub fn end_line(&mut self) {
        let line = self.all[self.next - 1].1;
        while self.all.get(self.next).is_some_and(|(_, own)| *own == line) {
            self.next += 1;
        }
    }
}

/// The first token of a line and what is behind it; nothing at a comment, or at a word, from which
/// on there are words.
fn token(text: &str) -> Option<(Token, &str)> {
    let text = text.trim_start_matches(|c: char| c.is_whitespace() || c == ',');
    let first = text.chars().next()?;
    if COMMENT.contains(&first) {
        return None;
    }
    if first == '\'' || first == '"' {
        let (name, rest) = text[1..].split_once(first)?;
        return Some((Token::Name(name.trim().into()), rest));
    }
    let end = text.find(|c: char| {
        c.is_whitespace() || c == ',' || c == '\'' || c == '"' || COMMENT.contains(&c)
    });
    let (word, rest) = text.split_at(end.unwrap_or(text.len()));
    Some((Token::Number(number(word)?), rest))
}
