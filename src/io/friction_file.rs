//! Friction over the surface of rails and along the track, as a table in text.
//!
//! The first line names the columns, of which only those that are needed are there: `rail` (1 or 2;
//! without it the table is that of both), `station_m`, `inclination_deg` of the surface or
//! `place_mm`, the arc from the highest point of the head, both negative towards the gauge face,
//! and `friction`. The rows of a rail stand in growing stations, those of a station in growing
//! places. Columns are separated by blanks, tabs, commas or semicolons; what follows `#` or `!` is
//! a comment.

use std::path::PathBuf;

use crate::error::ContactError;
use crate::friction::{Across, FrictionProfile, MAX_FRICTION, Section};
use crate::io::named_file::parsed;
use crate::io::table::{Line, columns, numbers, rows};

/// Greatest inclination [deg] and place [mm], both ways.
const MAX_INCLINATION: f64 = 180.0;
const MAX_PLACE: f64 = 1000.0;

/// Friction of rail number `rail`, from 1, in the file that the parameter `parameter` names: an
/// absolute path or one that is looked for in `folders`.
///
/// # Errors
/// The parameter, the file and what is wrong with it, with its line.
pub fn load_friction(
    parameter: &str,
    name: &str,
    rail: usize,
    folders: &[PathBuf],
) -> Result<FrictionProfile, ContactError> {
    parsed(parameter, name, folders, |content| profile(content, rail))
}

/// Places of the columns in a line.
#[derive(Debug)]
struct Columns {
    count: usize,
    rail: Option<usize>,
    station: Option<usize>,
    place: Option<usize>,
    across: Across,
    friction: usize,
}

const NAMES: [&str; 5] = ["rail", "station_m", "inclination_deg", "place_mm", "friction"];

impl Columns {
    fn of(text: &str) -> Result<Self, String> {
        let names = columns(text);
        let known = "a first line that names the columns: friction and, where they are needed, rail, station_m, inclination_deg or place_mm";
        if let Some(unknown) = names.iter().find(|name| !NAMES.contains(&name.as_str())) {
            return Err(format!("{known}; \"{unknown}\" is none of them"));
        }
        let [rail, station, inclination, place, friction] =
            NAMES.map(|name| names.iter().position(|own| own == name));
        if let Some(twice) =
            NAMES.iter().find(|name| names.iter().filter(|n| n == name).count() > 1)
        {
            return Err(format!("each column once; {twice} is there twice"));
        }
        if inclination.is_some() && place.is_some() {
            return Err("one of the columns inclination_deg and place_mm, not both".into());
        }
        let friction = friction.ok_or("a column friction")?;
        if inclination.or(place).or(station).is_none() {
            return Err("a column inclination_deg, place_mm or station_m beside friction".into());
        }
        let across = if place.is_some() { Across::Place } else { Across::Inclination };
        let place = inclination.or(place);
        Ok(Self { count: names.len(), rail, station, place, across, friction })
    }

    /// Name of the column of places and its greatest number.
    fn place_and_most(&self) -> (&'static str, f64) {
        match self.across {
            Across::Inclination => ("inclination_deg", MAX_INCLINATION),
            Across::Place => ("place_mm", MAX_PLACE),
        }
    }
}

/// The friction of rail number `rail` in the text of a file.
fn profile(content: &str, rail: usize) -> Result<FrictionProfile, String> {
    let mut head: Option<Columns> = None;
    let mut sections: Vec<Section> = Vec::new();
    for Line { number, text } in rows(content) {
        let at = |what: String| format!("{what} (line {number})");
        let Some(columns) = &head else {
            head = Some(Columns::of(text).map_err(at)?);
            continue;
        };
        let row = numbers(text)
            .filter(|row| row.len() == columns.count && row.iter().all(|value| value.is_finite()));
        let row = row.ok_or_else(|| at(format!("{} finite numbers in a row", columns.count)))?;
        if let Some(column) = columns.rail {
            let is = |number: usize| row[column].total_cmp(&(number as f64)).is_eq();
            if !is(1) && !is(2) {
                return Err(at("1 or 2 in the column rail".into()));
            }
            if !is(rail) {
                continue;
            }
        }
        let friction = row[columns.friction];
        if !(0.0..=MAX_FRICTION).contains(&friction) {
            return Err(at(format!("friction from 0 to {MAX_FRICTION}")));
        }
        let station = columns.station.map_or(0.0, |column| row[column]);
        let place = columns.place.map_or(0.0, |column| row[column]);
        let (name, most) = columns.place_and_most();
        if place.abs() > most {
            return Err(at(format!("{name} from -{most} to {most}")));
        }
        let scale = match columns.across {
            Across::Inclination => 1f64.to_radians(),
            Across::Place => 1e-3,
        };
        let point = [scale * place, friction];
        match sections.last_mut() {
            Some(last) if station < last.station => {
                return Err(at("a station_m that does not fall from row to row".into()));
            }
            Some(last) if station <= last.station => {
                let grows = last.points.last().is_none_or(|before| point[0] > before[0]);
                if columns.place.is_none() {
                    return Err(at("a station_m that grows from row to row".into()));
                }
                if !grows {
                    return Err(at(format!("a {name} that grows from row to row of a station")));
                }
                last.points.push(point);
            }
            _ => sections.push(Section { station, points: vec![point] }),
        }
    }
    let across = head.as_ref().map_or(Across::Inclination, |columns| columns.across);
    if sections.is_empty() {
        return Err(format!("rows for rail {rail}"));
    }
    Ok(FrictionProfile { across, sections })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::direction;
    use approx::assert_relative_eq;

    fn coefficient(profile: &FrictionProfile, across: f64, station: f64) -> f64 {
        let across = match profile.across {
            Across::Inclination => direction([across.cos(), across.sin()]),
            Across::Place => across,
        };
        profile.tables().at(across, station, &mut 0)
    }

    #[test]
    fn a_table_by_inclination_is_that_of_both_rails() {
        let text = "# gauge face greased\ninclination_deg friction\n-20 0.2\n-10 0.3 # tread\n";
        for rail in [1, 2] {
            let found = profile(text, rail).unwrap();
            assert_eq!(found.across, Across::Inclination);
            assert_eq!(found.sections.len(), 1);
            let at = |angle: f64| coefficient(&found, angle.to_radians(), 7.0);
            for (angle, expected) in [(-60.0, 0.2), (-15.0, 0.25), (0.0, 0.3)] {
                // Cubics over the direction of the tangent are the line within 3e-7 rad.
                assert_relative_eq!(at(angle), expected, epsilon = 3e-7 * 0.1 / 10f64.to_radians());
            }
        }
    }

    #[test]
    fn each_rail_has_its_stations_and_places() {
        let text =
            "rail;station_m;place_mm;friction\n1;0;-10;0,1\n1;0;10;0,5\n2;0;0;0,2\n1;50;0;0,4\n";
        let found = profile(text, 1).unwrap();
        assert_eq!((found.across, found.sections.len()), (Across::Place, 2));
        assert_relative_eq!(coefficient(&found, 0.0, 0.0), 0.3, max_relative = 1e-12);
        assert_relative_eq!(coefficient(&found, 0.0, 25.0), 0.35, max_relative = 1e-12);
        assert_relative_eq!(coefficient(&profile(text, 2).unwrap(), 0.3, 9.0), 0.2);
    }

    #[test]
    fn friction_along_the_track_alone_is_a_table_of_stations() {
        let found = profile("station_m,friction\n0,0.3\n10,0.3\n11,0.05\n", 1).unwrap();
        assert_eq!(found.sections.len(), 3);
        assert_relative_eq!(coefficient(&found, -1.0, 10.5), 0.175, max_relative = 1e-12);
    }
}
