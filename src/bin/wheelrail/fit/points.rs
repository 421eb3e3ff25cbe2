//! Measured points of creep curves and the contacts that they were measured on.

use anyhow::{Context, Result, bail, ensure};
use wheelrail::planar::{Indentation, PressedContact};
use wheelrail::variables::Values;

use crate::cases::Cases;

/// One measured point.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Longitudinal, lateral [-], spin [1/m]; without sign.
    pub creepage: [f64; 3],
    /// Force over normal force [-].
    pub adhesion: f64,
    /// [N].
    pub load: f64,
    /// [m/s].
    pub speed: f64,
    /// Which of the contacts.
    pub contact: usize,
}

/// All points, and a contact for each load.
#[derive(Debug)]
pub struct Points {
    pub all: Vec<Point>,
    pub contacts: Vec<PressedContact>,
}

const NEEDED: [&str; 4] = ["creepage_longitudinal", "adhesion", "load_n", "speed_m_s"];
const OTHERS: [&str; 2] = ["creepage_lateral", "spin_per_mm"];
/// Most adhesion: no dry metal has more, and numbers in per cent do [-].
const MOST_ADHESION: f64 = 2.0;
/// Half the width over which the separation is given, over the radius across.
const REACH: f64 = 0.3;
/// Points of the separation to either side.
const STEPS: i32 = 100;

impl Points {
    /// Reads `cases`; the bodies have `values` and relative `radii` along and across [m].
    pub fn read(cases: &Cases, values: &Values, radii: [f64; 2]) -> Result<Self> {
        let header = cases.header();
        let known = NEEDED.iter().chain(&OTHERS);
        for name in header.columns() {
            if !known.clone().any(|own| *own == name) {
                let all: Vec<&str> = known.copied().collect();
                bail!(
                    "{}: unknown; known columns are {}",
                    header.column_place(name),
                    all.join(", ")
                );
            }
        }
        let [along, across] = radii;
        let separation: Vec<[f64; 2]> = (-STEPS..=STEPS)
            .map(|i| REACH * across * f64::from(i) / f64::from(STEPS))
            .map(|y| [y, y * y / (2.0 * across)])
            .collect();
        let mut points = Self { all: Vec::new(), contacts: Vec::new() };
        let mut loads: Vec<f64> = Vec::new();
        for row in cases.rows() {
            let cell = |name: &str| row.number_named(name);
            let needed = |name: &str| {
                cell(name)?.with_context(|| format!("{}: {name} is missing", row.place()))
            };
            let [longitudinal, adhesion, load, speed] =
                [needed(NEEDED[0])?, needed(NEEDED[1])?, needed(NEEDED[2])?, needed(NEEDED[3])?];
            ensure!(load > 0.0, "{}: load_n = {load} has to be above 0", row.place());
            ensure!(speed >= 0.0, "{}: speed_m_s = {speed} has to be at least 0", row.place());
            ensure!(
                adhesion.abs() <= MOST_ADHESION,
                "{}: adhesion = {adhesion} is more than {MOST_ADHESION}: it is the force over the normal force, 0.35 and not 35 per cent",
                row.place()
            );
            ensure!(
                longitudinal * adhesion >= 0.0,
                "{}: creepage_longitudinal and adhesion have to have the same sign",
                row.place()
            );
            let [lateral, spin] =
                [cell(OTHERS[0])?, cell(OTHERS[1])?].map(|own| own.unwrap_or(0.0));
            let contact = loads.iter().position(|own| own.to_bits() == load.to_bits());
            let contact = if let Some(contact) = contact {
                contact
            } else {
                let indentation = Indentation::Load(load);
                let case =
                    values.parameters.planar_case(&separation, along, indentation, [0.0; 3], 0.3);
                points.contacts.push(PressedContact::new(&case).with_context(|| row.place())?);
                loads.push(load);
                loads.len() - 1
            };
            points.all.push(Point {
                creepage: [longitudinal.abs(), lateral, 1e3 * spin],
                adhesion: adhesion.abs(),
                load,
                speed,
                contact,
            });
        }
        Ok(points)
    }

    /// Greatest slip velocity of all points [m/s].
    pub fn fastest(&self) -> f64 {
        let slides = |point: &Point| {
            let [longitudinal, lateral, _] = point.creepage;
            point.speed * longitudinal.hypot(lateral)
        };
        self.all.iter().map(slides).fold(0.0, f64::max)
    }

    /// Greatest adhesion of all points.
    pub fn greatest(&self) -> f64 {
        self.all.iter().map(|point| point.adhesion).fold(0.0, f64::max)
    }
}
