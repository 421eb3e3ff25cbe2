//! Worn profiles against those they were.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use wheelrail::geometry::profile::{Profile, ProfileKind};
use wheelrail::io::load_profile;
use wheelrail::wear::depth::{DepthPoint, wear_depth};

use crate::figures::wear::{self, WornBody};
use crate::output;
use crate::remarks::{Found, Remarks};

/// The worn profiles asked for, and what they are compared with.
pub struct Request<'a> {
    pub wheel: Option<&'a str>,
    pub rail: Option<&'a str>,
    pub unworn_wheel: &'a str,
    pub unworn_rail: &'a str,
    pub smoothing: f64,
    pub figure: &'a Path,
    pub fields: Option<&'a Path>,
}

/// Draws the profiles and depths.
pub fn draw(request: &Request<'_>) -> Result<()> {
    let folders = [PathBuf::from(".")];
    let mut bodies = Vec::new();
    let mut tables = Vec::new();
    let mut remarks = Remarks::default();
    for (worn, unworn, kind, option) in [
        (request.wheel, request.unworn_wheel, ProfileKind::Wheel, "worn-wheel"),
        (request.rail, request.unworn_rail, ProfileKind::Rail, "worn-rail"),
    ] {
        let Some(worn_name) = worn else { continue };
        let mut load = |option: &str, name: &str| -> Result<Profile> {
            let option = format!("--{option}");
            let profile = load_profile(&option, name, kind, request.smoothing, &folders)?;
            let named = profile.remarks.iter().map(|remark| (option.clone(), remark.clone()));
            remarks.tell(&Found::default().with_profiles(named.collect()));
            Ok(profile)
        };
        let before = load(&option.replacen("worn", "unworn", 1), unworn)?;
        let after = load(option, worn_name)?;
        let depth = wear_depth(&before, &after);
        if depth.is_empty() {
            bail!(
                "--{option} {worn_name}: it has no point near {unworn}; is it of the same frame?"
            );
        }
        let deepest = depth.iter().max_by(|a, b| a.depth.total_cmp(&b.depth));
        let area: f64 = depth.iter().map(|p| p.depth * p.length).sum();
        let more = if area < 0.0 {
            format!(
                "; that is more material than {unworn} has: is it the same body in the same frame?"
            )
        } else {
            String::new()
        };
        if let Some(deepest) = deepest {
            output::say(&format!(
                "{kind}: worn area {:.4} mm2, greatest depth {:.4} mm at y = {:.2} mm{more}\n",
                1e6 * area,
                1e3 * deepest.depth,
                1e3 * deepest.point[0]
            ))?;
        }
        bodies.push(body(kind, [unworn, worn_name], [&before, &after], &depth));
        tables.push((kind, depth));
    }
    if let Some(path) = request.fields {
        write(path, &tables)?;
    }
    wear::draw(request.figure, &bodies)?;
    std::iter::once(request.figure)
        .chain(request.fields)
        .try_for_each(|path| output::say(&format!("{}\n", path.display())))
}

fn body(
    kind: ProfileKind,
    names: [&str; 2],
    profiles: [&Profile; 2],
    depth: &[DepthPoint],
) -> WornBody {
    let file_name = |name: &str| {
        Path::new(name).file_name().map_or_else(|| name.into(), |n| n.to_string_lossy().into())
    };
    WornBody {
        title: format!("Worn {kind}"),
        names: names.map(file_name),
        profiles: profiles.map(points),
        depth: depth.iter().map(|p| (1e3 * p.point[0], 1e3 * p.depth)).collect(),
    }
}

/// Points of a profile in millimetres.
fn points(profile: &Profile) -> Vec<(f64, f64)> {
    let (start, end) = (profile.curve.start(), profile.curve.end());
    (0..=2000)
        .map(|i| profile.curve.at(start + (end - start) * f64::from(i) / 2000.0).point)
        .map(|[y, z]| (1e3 * y, 1e3 * z))
        .collect()
}

fn write(path: &Path, tables: &[(ProfileKind, Vec<DepthPoint>)]) -> Result<()> {
    let table = output::table(Some(path))?;
    table.write_record(["body", "y_mm", "z_mm", "depth_mm"])?;
    for (kind, depth) in tables {
        for DepthPoint { point: [y, z], depth, .. } in depth {
            let number = |value: f64| format!("{:.7}", 1e3 * value);
            table.write_record([kind.to_string(), number(*y), number(*z), number(*depth)])?;
        }
    }
    table.finish()
}
