//! Tractions and slip of ten contacts from tread to flange, from hardly to fully sliding, by marches
//! and by boundary elements on the pressure of the same strips.

use std::error::Error;

use plotters::prelude::*;
use wheelrail::element::parameters::{TangentialModel, VerticalMode};
use wheelrail::element::{Element, FlatContact, Input, Output, Parameters};
use wheelrail::planar::{Adherence, ContactField, Indentation, fields, solve};

use crate::canvas::{Area, BLUE, INK, VERMILION, heading, px, svg, text};

const SPEED: f64 = 20.0;
const FRICTION: f64 = 0.3;
/// Lateral shift [m], yaw [rad] and load [N] of a wheel, and longitudinal and lateral creepage and
/// the factor of the spin of its contact angle.
const CONTACTS: [([f64; 3], [f64; 3]); 10] = [
    ([-3e-3, 1e-3, 6e4], [3e-4, 0.0, 1.0]),
    ([-3e-3, 1e-3, 1.2e5], [1e-3, -5e-4, 1.0]),
    ([0.0, 1e-3, 6e4], [0.0, 5e-4, 1.0]),
    ([0.0, 1e-3, 1e5], [-4e-4, 1e-3, 1.0]),
    ([0.0, 1e-3, 2e4], [5e-3, 2e-3, 1.0]),
    ([2e-3, 2e-3, 6e4], [2e-4, 2e-4, 1.0]),
    ([5.35e-3, 1e-3, 6e4], [0.0, 1e-3, 1.0]),
    ([6.5e-3, 3e-3, 6e4], [1e-3, 1e-3, 1.0]),
    ([8e-3, 5e-3, 6e4], [0.0, 0.0, 1.0]),
    ([8e-3, 5e-3, 2e4], [-2e-3, 3e-3, 1.0]),
];
const MODELS: [(&str, TangentialModel); 2] = [
    ("marches", TangentialModel::Marches),
    ("boundary elements", TangentialModel::BoundaryElement),
];

/// Contacts beside each other, and the size of a panel [pixels].
const COLUMNS: usize = 2;
const PANEL: [u32; 2] = [230, 190];
/// Room for the words above [pixels].
const HEAD: u32 = 48;
/// Elements along and across, and every how many there is a line.
const ELEMENTS: usize = 28;
/// Shades that are told apart.
const SHADES: f64 = 5.0;
const EVERY: usize = 4;

pub fn draw(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let rows = CONTACTS.len().div_ceil(COLUMNS) as u32;
    let size = [COLUMNS as u32 * 2 * PANEL[0], rows * PANEL[1]];
    println!("contact,model,fx_over_limit,fy_over_limit");
    let drawing = svg((size[0], size[1] + HEAD), |area| {
        let (top, panels) = area.split_vertically(px(HEAD));
        let words = "Tractions: blue adheres, orange slips, dark where they are large. Rolling upwards, field side on the left. Numbers: contact; Fx and Fy over the friction limit.";
        top.draw(&Text::new(words, (px(10) as i32, px(8) as i32), text(13)))?;
        for (k, name) in MODELS.iter().map(|(name, _)| name).cycle().take(2 * COLUMNS).enumerate() {
            let left = px(PANEL[0]) * k as u32 + px(24);
            top.draw(&Text::new(*name, (left as i32, px(27) as i32), heading(13)))?;
        }
        let panels = panels.split_evenly((rows as usize, 2 * COLUMNS));
        for (k, contact) in CONTACTS.iter().enumerate() {
            let flat = heaviest(contact.0)?;
            let both = MODELS.map(|(_, model)| solved(&flat, contact.1, model));
            for ((panel, found), (name, _)) in panels[2 * k..].iter().zip(both).zip(MODELS) {
                let (fields, [x, y]) = found?;
                println!("{},{name},{x:.4},{y:.4}", k + 1);
                let title = format!("{}: {x:.3}, {y:.3}", k + 1);
                patch(panel, &title, &fields)?;
            }
        }
        Ok(())
    })?;
    if let Some(path) = arguments.first() {
        std::fs::write(path, drawing)?;
    }
    Ok(())
}

/// The contact of a wheel that carries most.
fn heaviest([shift, yaw, load]: [f64; 3]) -> anyhow::Result<FlatContact> {
    let parameters = Parameters {
        damping: 0.0,
        vertical_mode: VerticalMode::Load,
        tangential_model: TangentialModel::None,
        ..Parameters::default()
    };
    let mut input = Input::default();
    input.wheel.position[1] += shift;
    input.wheel.yaw = yaw;
    input.wheel.velocity[0] = SPEED;
    input.wheel.pitch_rate = -SPEED / parameters.wheel.nominal_radius;
    input.wheel_load = load;
    let mut element = Element::new(&parameters, &input, &[])?;
    let mut output = Output::default();
    element.evaluate(&input, &mut output)?;
    input.wheel.position[2] = output.wheel_z;
    let contacts = element.flat_contacts(&input)?;
    let deepest = contacts.into_iter().max_by(|a, b| a.penetration.total_cmp(&b.penetration));
    deepest.ok_or_else(|| anyhow::anyhow!("a loaded wheel touches"))
}

/// Tractions, and the force over the friction limit.
fn solved(
    contact: &FlatContact,
    [longitudinal, lateral, spin]: [f64; 3],
    tangential_model: TangentialModel,
) -> anyhow::Result<(Vec<ContactField>, [f64; 2])> {
    let parameters =
        Parameters { tangential_model, normal_elements: [ELEMENTS; 2], ..Parameters::default() };
    let creepage = [longitudinal, lateral, spin * contact.creepage[2]];
    let indentation = Indentation::Approach(contact.penetration);
    let case = parameters.planar_case(
        &contact.separation,
        contact.radius,
        indentation,
        creepage,
        FRICTION,
    );
    let result = solve(&case)?;
    let limit = FRICTION * result.normal_force;
    Ok((fields(&case)?, [result.fx / limit, result.fy / limit]))
}

/// Draws the zones of a contact to scale.
fn patch(area: &Area<'_>, title: &str, fields: &[ContactField]) -> anyhow::Result<()> {
    let area = area.margin(px(20), px(4), px(12), px(12));
    let (mut xs, mut ys) = ([f64::MAX, f64::MIN], [f64::MAX, f64::MIN]);
    let mut bound = 0.0_f64;
    for field in fields {
        let grid = &field.grid;
        for k in (0..grid.len()).filter(|&k| field.pressure[k] > 0.0) {
            let (x, y) = (grid.x(k % grid.along), grid.y(k / grid.along));
            xs = [xs[0].min(x - grid.dx), xs[1].max(x + grid.dx)];
            ys = [ys[0].min(y - grid.dy), ys[1].max(y + grid.dy)];
            bound = bound.max(FRICTION * field.pressure[k]);
        }
    }
    let (width, height) = area.dim_in_pixel();
    let scale = f64::min(f64::from(width) / (ys[1] - ys[0]), f64::from(height) / (xs[1] - xs[0]));
    let middle = [xs, ys].map(|[low, high]| 0.5 * (low + high));
    let at = |x: f64, y: f64| {
        let across = 0.5 * f64::from(width) + scale * (y - middle[1]);
        let down = 0.5 * f64::from(height) - scale * (x - middle[0]);
        (across.round() as i32, down.round() as i32)
    };
    for field in fields {
        let grid = &field.grid;
        for j in 0..grid.across {
            let shade = |i: usize| {
                let k = j * grid.along + i;
                (field.pressure[k] > 0.0).then(|| {
                    let [x, y] = field.traction[k];
                    let share = (x.hypot(y) / bound).min(1.0);
                    (field.adherence[k] == Adherence::Slip, (SHADES * share).ceil())
                })
            };
            let mut first = 0;
            while first < grid.along {
                let own = shade(first);
                // Elements of one shade are one rectangle.
                let last = (first..grid.along).take_while(|&i| shade(i) == own).last();
                let last = last.unwrap_or(first);
                if let Some((slips, level)) = own {
                    let colour = if slips { VERMILION } else { BLUE };
                    let corners = [
                        at(grid.x(first) + 0.5 * grid.dx, grid.y(j) - 0.5 * grid.dy),
                        at(grid.x(last) - 0.5 * grid.dx, grid.y(j) + 0.5 * grid.dy),
                    ];
                    let colour = colour.mix((10.0 + 80.0 * level / SHADES).round() / 100.0);
                    area.draw(&Rectangle::new(corners, colour.filled()))?;
                }
                first = last + 1;
            }
        }
        let reach = EVERY as f64 * grid.dx.min(grid.dy);
        for k in (0..grid.len()).filter(|&k| field.pressure[k] > 0.0) {
            let (i, j) = (k % grid.along, k / grid.along);
            if i % EVERY != EVERY / 2 || j % EVERY != EVERY / 2 {
                continue;
            }
            let [x, y] = field.traction[k].map(|traction| 1.2 * reach * traction / bound);
            let (from, to) = (at(grid.x(i), grid.y(j)), at(grid.x(i) + x, grid.y(j) + y));
            area.draw(&PathElement::new(vec![from, to], INK.stroke_width(px(1))))?;
            area.draw(&Circle::new(from, px(1), INK.filled()))?;
        }
    }
    area.draw(&Text::new(title.to_owned(), (0, -(px(14) as i32)), text(12)))?;
    Ok(())
}
