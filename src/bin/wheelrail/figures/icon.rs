//! The icon of a packed unit: wheel and rail as they touch, and the pressure of the heaviest patch.

use anyhow::{Context, Result};
use tiny_skia::{Color, FillRule, Paint, PathBuilder, Pixmap, Rect, Stroke, Transform};

use super::contact::Figure;

/// Width and height [px].
const SIZE: [f32; 2] = [320.0, 240.0];
/// Height of the part with the profiles [px].
const PROFILES: f32 = 140.0;
const MARGIN: f32 = 10.0;

/// A mapping of a rectangle of the drawing [m] into one of the picture, with equal scales.
struct Scale {
    factor: f32,
    middle: [f64; 2],
    centre: [f32; 2],
}

impl Scale {
    fn of(points: impl Iterator<Item = [f64; 2]>, area: [f32; 4]) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            for k in 0..2 {
                low[k] = low[k].min(point[k]);
                high[k] = high[k].max(point[k]);
            }
        }
        let extent = |k: usize| (high[k] - low[k]).max(1e-6) as f32;
        let [x, y, width, height] = area;
        let factor = ((width - 2.0 * MARGIN) / extent(0)).min((height - 2.0 * MARGIN) / extent(1));
        Self {
            factor,
            middle: [0, 1].map(|k| 0.5 * (low[k] + high[k])),
            centre: [x + 0.5 * width, y + 0.5 * height],
        }
    }

    fn place(&self, point: [f64; 2]) -> [f32; 2] {
        [0, 1].map(|k| self.centre[k] + self.factor * (point[k] - self.middle[k]) as f32)
    }
}

/// The icon as PNG.
pub fn png(figure: &Figure) -> Result<Vec<u8>> {
    let mut picture =
        Pixmap::new(SIZE[0] as u32, SIZE[1] as u32).context("no icon can be drawn")?;
    picture.fill(Color::WHITE);
    let outlines = || figure.contacts.iter().flat_map(|c| [(&c.rail_head, GREY), (&c.wheel, BLUE)]);
    let points = outlines().flat_map(|(outline, _)| outline.iter().map(|p| [p[0], p[1]]));
    let scale = Scale::of(points, [0.0, 0.0, SIZE[0], PROFILES]);
    for (outline, colour) in outlines() {
        line(&mut picture, outline.iter().map(|p| scale.place([p[0], p[1]])), colour);
    }
    for contact in &figure.contacts {
        let [x, y] = scale.place(contact.position);
        let mark = Rect::from_xywh(x - 3.0, y - 3.0, 6.0, 6.0);
        fill(&mut picture, mark, [213, 94, 0]);
    }
    pressure(&mut picture, figure);
    picture.encode_png().context("the icon cannot be encoded")
}

const GREY: [u8; 3] = [110, 110, 110];
const BLUE: [u8; 3] = [0, 114, 178];

/// The pressure of the models of the unit, x along the track to the right.
fn pressure(picture: &mut Pixmap, figure: &Figure) {
    let fields = || figure.sides[0].fields.iter();
    let loaded = || {
        fields().flat_map(|field| {
            let elements = (0..field.grid.len()).filter(|&k| field.pressure[k] > 0.0);
            elements.map(move |k| (field, k))
        })
    };
    let greatest = loaded().map(|(field, k)| field.pressure[k]).fold(1.0, f64::max);
    let corners = loaded().flat_map(|(field, k)| {
        let grid = &field.grid;
        let [x, y] = [grid.x(k % grid.along), grid.y(k / grid.along)];
        [[x - 0.5 * grid.dx, y - 0.5 * grid.dy], [x + 0.5 * grid.dx, y + 0.5 * grid.dy]]
    });
    let scale = Scale::of(corners, [0.0, PROFILES, SIZE[0], SIZE[1] - PROFILES]);
    for (field, k) in loaded() {
        let grid = &field.grid;
        let [x, y] = scale.place([grid.x(k % grid.along), grid.y(k / grid.along)]);
        let [width, height] = [grid.dx, grid.dy].map(|size| scale.factor * size as f32);
        let share = (field.pressure[k] / greatest) as f32;
        let shade = |pale: f32, full: f32| (pale + share * (full - pale)) as u8;
        let colour = [shade(225.0, 190.0), shade(235.0, 40.0), shade(245.0, 30.0)];
        let element = Rect::from_xywh(x - 0.5 * width, y - 0.5 * height, width, height);
        fill(picture, element, colour);
    }
}

fn paint([red, green, blue]: [u8; 3]) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, 255);
    paint
}

fn fill(picture: &mut Pixmap, area: Option<Rect>, colour: [u8; 3]) {
    // A rectangle without extent is not drawn.
    let Some(area) = area else { return };
    let path = PathBuilder::from_rect(area);
    let (paint, rule) = (paint(colour), FillRule::Winding);
    picture.fill_path(&path, &paint, rule, Transform::identity(), None);
}

fn line(picture: &mut Pixmap, points: impl Iterator<Item = [f32; 2]>, colour: [u8; 3]) {
    let mut builder = PathBuilder::new();
    for (index, [x, y]) in points.enumerate() {
        if index == 0 {
            builder.move_to(x, y);
        } else {
            builder.line_to(x, y);
        }
    }
    // A line of less than two points is not drawn.
    let Some(path) = builder.finish() else { return };
    let stroke = Stroke { width: 2.0, ..Stroke::default() };
    picture.stroke_path(&path, &paint(colour), &stroke, Transform::identity(), None);
}
