//! The profile that a map runs along.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use wheelrail::element::{Element, Parameters};
use wheelrail::geometry::curve::Curve;
use wheelrail::variables::Values;

/// Profile of the wheel or of one rail, which all rows share.
pub struct BodyProfile {
    pub curve: Curve,
    /// Parameter of the place with y = 0, or the first one without [m].
    pub origin: f64,
    /// Which body, in words, and the name of its profile.
    pub body: String,
    pub name: String,
    rail: Option<i32>,
    smoothing: f64,
}

/// Steps in which the place with y = 0 is looked for.
const STEPS: usize = 4000;

impl BodyProfile {
    /// That of rail number `rail`, from 1, or of the wheel; files lie in `folder`.
    pub fn of(values: &Values, rail: Option<i32>, folder: &Path) -> Result<Self> {
        let folders = [PathBuf::from(folder)];
        let element = Element::new(&values.parameters, &values.input, &folders)?;
        let (body, profile) = match rail {
            None => ("the wheel".to_owned(), element.worn_wheel()),
            Some(rail) => {
                let index = usize::try_from(rail - 1).ok();
                (format!("rail {rail}"), index.and_then(|k| element.worn_rail(k)))
            }
        };
        let profile = profile
            .with_context(|| format!("--rail {}: there is none", rail.unwrap_or_default()))?;
        let curve = profile.curve;
        let (start, length) = (curve.start(), curve.end() - curve.start());
        let places = (0..=STEPS).map(|k| start + length * k as f64 / STEPS as f64);
        let nearest = places
            .map(|s| (s, curve.at(s).point[0].abs()))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .filter(|(_, y)| *y <= length / STEPS as f64);
        let origin = nearest.map_or(start, |(s, _)| s);
        let (name, smoothing) = named(&values.parameters, rail);
        Ok(Self { curve, origin, body, name: name.to_owned(), rail, smoothing })
    }

    /// Whether another row has the same profile.
    pub fn check(&self, parameters: &Parameters) -> Result<()> {
        let (name, smoothing) = named(parameters, self.rail);
        if name != self.name || smoothing.to_bits() != self.smoothing.to_bits() {
            bail!("the map is over one profile: {} here, {} in the first row", name, self.name);
        }
        Ok(())
    }

    /// Places along the profile in steps of about `step`, the origin among them [m].
    pub fn arcs(&self, step: f64, most: f64) -> Result<Vec<f64>> {
        let [first, last] =
            [self.curve.start(), self.curve.end()].map(|s| ((s - self.origin) / step).trunc());
        if last - first > most {
            bail!("--step {}: {most} places along the profile at most", 1e3 * step);
        }
        let count = (last - first) as usize;
        Ok((0..=count).map(|k| self.origin + (first + k as f64) * step).collect())
    }
}

/// Name and smoothing of the profile of a rail, or of the wheel.
fn named(parameters: &Parameters, rail: Option<i32>) -> (&str, f64) {
    let of_rail = rail.and_then(|rail| parameters.rails.get(usize::try_from(rail - 1).ok()?));
    let name = of_rail.map_or(&parameters.wheel.profile, |rail| &rail.profile);
    (name, parameters.profile_smoothing)
}
