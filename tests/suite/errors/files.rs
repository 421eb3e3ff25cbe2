//! Files of profiles and of deviations.

use super::*;
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::load_profile;

/// Points of a standard profile [mm].
fn points(name: &str, kind: ProfileKind) -> Vec<[f64; 2]> {
    let curve = load_profile("profile", name, kind, 0.0, &[]).unwrap().curve;
    let at = |i: i32| curve.start() + f64::from(i) / 300.0 * (curve.end() - curve.start());
    (0..=300).map(|i| curve.at(at(i)).point.map(|x| 1e3 * x)).collect()
}

/// A file by the words that describe it.
fn described(words: &str) -> String {
    let (rail, wheel) = (points("60E1", ProfileKind::Rail), points("S1002", ProfileKind::Wheel));
    let changed = |points: &[[f64; 2]], change: fn([f64; 2]) -> [f64; 2]| -> Vec<[f64; 2]> {
        points.iter().map(|p| change(*p)).collect()
    };
    let points = match words {
        "60E1 in inches" => changed(&rail, |p| p.map(|x| x / 25.4)),
        "S1002 a metre off its nominal rolling circle" => changed(&wheel, |[y, z]| [y - 1000.0, z]),
        "60E1 without its sides" => rail.into_iter().filter(|[_, z]| *z < 8.0).collect(),
        "60E1 sorted by y" => {
            let mut points = rail;
            points.sort_by(|a, b| a[0].total_cmp(&b[0]));
            points
        }
        "S1002 with a loop" => {
            let mut points = wheel;
            let [y, z] = points[200];
            let ring = (0..24).map(|i| {
                let angle = 0.25 * f64::from(i);
                [y + 4.0 * angle.sin(), z + 4.0 - 4.0 * angle.cos()]
            });
            points.splice(201..=201, ring);
            points
        }
        _ => panic!("{words}: unknown"),
    };
    points.iter().fold(String::new(), |text, [y, z]| text + &format!("{y:.5} {z:.5}\n"))
}

/// The content of a file from its cell: code, lines parted by slashes, or words that describe it.
fn content(cell: &str) -> String {
    code(cell).first().map_or_else(
        || described(cell),
        |code| code.replace(" / ", "\n").replace("\n/ ", "\n\n") + "\n",
    )
}

fn files(heading: &str) {
    let folder = TempDir::new().unwrap();
    // Profiles are looked for there.
    let profiles = folder.path().join("profiles");
    fs::create_dir(&profiles).unwrap();
    let said = rows(heading).into_iter().map(|row| {
        let settings = code(&row[0]);
        let (parameter, name) = settings[0].split_once(" = ").unwrap();
        fs::write(profiles.join(name), content(&row[1])).unwrap();
        let message = refused_settings(&settings, Some(folder.path()));
        assert!(message.contains(parameter) && message.contains(name), "{message}");
        (row, as_cell(&message, &profiles))
    });
    compare(heading, &said.collect::<Vec<_>>());
}

#[test]
fn profile_files() {
    files("Profile files");
}

#[test]
fn files_of_slices() {
    files("Files of slices");
}

#[test]
fn files_of_friction() {
    files("Files of friction");
}

#[test]
fn files_of_deviations() {
    files("Files of deviations");
}
