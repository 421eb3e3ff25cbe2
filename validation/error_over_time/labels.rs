//! Names beside the marks of a figure, none over another one or over a mark.

use std::ops::Range;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::canvas::{Area, GREY, px, text};

/// Height of the letters, and mean width of one over it.
const SIZE: u32 = 11;
const WIDTH: f64 = 0.56;
/// Distances of a name from its mark that are tried; from the second on with a line to it.
const DISTANCES: [u32; 5] = [10, 22, 36, 54, 76];
/// Directions that are tried, in this order.
const DIRECTIONS: [(f64, f64); 12] = [
    (1.0, 0.0),
    (-1.0, 0.0),
    (0.0, -1.0),
    (0.0, 1.0),
    (0.8, -0.6),
    (0.8, 0.6),
    (-0.8, -0.6),
    (-0.8, 0.6),
    (0.5, -0.9),
    (0.5, 0.9),
    (-0.5, -0.9),
    (-0.5, 0.9),
];

/// Where names may be, in coordinates of the area.
pub struct Frame {
    pub across: Range<i32>,
    pub down: Range<i32>,
}

/// A rectangle: left, right, top and bottom.
type Bounds = [i32; 4];

/// The places that are taken.
pub struct Labels {
    frame: Frame,
    taken: Vec<Bounds>,
}

impl Labels {
    pub fn new(frame: Frame) -> Self {
        Self { frame, taken: Vec::new() }
    }

    /// Keeps names off a mark of this radius.
    pub fn keep_clear(&mut self, (x, y): (i32, i32), radius: i32) {
        self.taken.push([x - radius, x + radius, y - radius, y + radius]);
    }

    /// Keeps names off a line across between two marks.
    pub fn keep_clear_between(&mut self, from: (i32, i32), to: (i32, i32)) {
        let half = px(1) as i32;
        self.taken.push([from.0, to.0, from.1 - half, from.1 + half]);
    }

    /// Writes `name` beside the mark at `(x, y)`; where there is no room nowhere.
    pub fn put(&mut self, area: &Area<'_>, (x, y): (i32, i32), name: &str) {
        let height = px(SIZE) as i32;
        let width = (WIDTH * f64::from(px(SIZE)) * name.chars().count() as f64) as i32;
        let places = DISTANCES
            .iter()
            .flat_map(|&distance| DIRECTIONS.iter().map(move |&direction| (distance, direction)));
        for (distance, (right, down)) in places {
            let away = f64::from(px(distance));
            let (end_x, end_y) = (x + (right * away) as i32, y + (down * away) as i32);
            // The name goes on from there.
            let left = match right {
                r if r > 0.2 => end_x,
                r if r < -0.2 => end_x - width,
                _ => end_x - width / 2,
            };
            let bounds = [left, left + width, end_y - height / 2, end_y + height / 2];
            if !self.is_free(bounds) {
                continue;
            }
            self.taken.push(bounds);
            if distance > DISTANCES[0] {
                let line =
                    PathElement::new(vec![(x, y), (end_x, end_y)], GREY.stroke_width(px(1) / 2));
                area.draw(&line).expect("drawing");
            }
            let style = text(SIZE).pos(Pos::new(HPos::Left, VPos::Center));
            area.draw(&Text::new(name.to_owned(), (left, end_y), style)).expect("drawing");
            return;
        }
    }

    fn is_free(&self, [left, right, top, bottom]: Bounds) -> bool {
        let Frame { across, down } = &self.frame;
        let is_inside =
            left >= across.start && right <= across.end && top >= down.start && bottom <= down.end;
        let meets = |other: &Bounds| {
            let [l, r, t, b] = *other;
            left < r && right > l && top < b && bottom > t
        };
        is_inside && !self.taken.iter().any(meets)
    }
}
