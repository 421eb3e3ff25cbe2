//! Rails of slices whose section varies along the track, as CONTACT's table of them has them.

use std::f64::consts::PI;
use std::fmt::Write;
use std::fs;

use tempfile::TempDir;
use wheelrail::element::parameters::{CreepageModel, Placement, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};

use super::planar::STEEL;
use super::wheel::{evaluate, rolling, the_patch};
use super::{read_table, value};

/// A rail with a flat top 10 mm wide, corners of the radius `corner` and sides at 80 degrees, whose
/// top begins at `left` at station 0 and drifts to the side and rises along the track [mm].
pub struct Head {
    left: f64,
    drift: f64,
    rise: f64,
    corner: f64,
}

/// Width of the top [mm] and angle of the sides [deg].
const TOP: f64 = 10.0;
const SIDE: f64 = 80.0;

impl Head {
    /// That of a name in CONTACT's table: a wing rail that runs off by 1:10, a nose that rises by
    /// 1:10.
    pub fn of(name: &str) -> Self {
        match name {
            "wing" => Self { left: 20.0, drift: 0.1, rise: 0.0, corner: 10.0 },
            "nose" => Self { left: 5.0, drift: 0.0, rise: 0.1, corner: 5.0 },
            _ => panic!("no rail {name}"),
        }
    }

    /// Height z at `station` and `y` from the middle of the profile [m].
    pub fn height(&self, station: f64, y: f64) -> f64 {
        let Self { left, drift, rise, corner } = *self;
        let (station, y) = (1e3 * station, 1e3 * y - left - 1e3 * station * drift);
        let (sine, cosine) = SIDE.to_radians().sin_cos();
        let beside = (-y).max(y - TOP).max(0.0);
        let round = beside.min(corner * sine);
        let below = corner - (corner * corner - round * round).sqrt();
        1e-3 * (below + (beside - round) * sine / cosine - rise * station)
    }

    /// Its section at `station` [mm], points every 0.2 mm.
    fn section(&self, station: f64) -> String {
        let Self { corner, .. } = *self;
        let (left, z) = (self.left + self.drift * station, -self.rise * station);
        let steep = SIDE.to_radians();
        let mut points = Vec::new();
        let side = 30.0;
        let [sine, cosine] = [steep.sin(), steep.cos()];
        for i in (1..=60).rev() {
            let along = side * f64::from(i) / 60.0;
            let edge = [left - corner * sine, z + corner * (1.0 - cosine)];
            points.push([edge[0] - along * cosine, edge[1] + along * sine]);
        }
        let steps = (corner * steep / 0.2).ceil() as i32;
        for i in 0..=steps {
            let angle = steep * (1.0 - f64::from(i) / f64::from(steps));
            points.push([left - corner * angle.sin(), z + corner * (1.0 - angle.cos())]);
        }
        points.extend((1..50).map(|i| [left + 0.2 * f64::from(i), z]));
        let right = left + TOP;
        let mirrored: Vec<_> = points.iter().take(61 + steps as usize).rev().copied().collect();
        points.extend(mirrored.into_iter().map(|[y, z]| [right + left - y, z]));
        points.iter().fold(String::new(), |text, [y, z]| text + &format!("{y:.7} {z:.7}\n"))
    }
}

/// A crown of radius 300 mm, narrow enough that no flange touches its ends, stretched across by
/// `stretch` and moved by (`y`, `z`) [mm].
pub fn crown(stretch: f64, [y, z]: [f64; 2]) -> String {
    (-40..=40).fold(String::new(), |text, i| {
        let angle = 0.5 * f64::from(i) / 300.0;
        let point = [stretch * 300.0 * angle.sin() + y, 300.0 * (1.0 - angle.cos()) + z];
        text + &format!("{:.9} {:.9}\n", point[0], point[1])
    })
}

/// A head of arcs of radius 300, 80 and 13 mm with steep sides, moved by (`y`, `z`) [mm].
pub fn head([y, z]: [f64; 2]) -> String {
    let arcs = [(300.0, 0.05), (80.0, 0.3), (13.0, 1.4)];
    let (mut side, mut from) = (vec![[0.0, 0.0]], 0.0);
    for (radius, to) in arcs {
        let [start_y, start_z] = side[side.len() - 1];
        let count = (radius * (to - from) / 0.3_f64).ceil();
        side.extend((1..=count as usize).map(|i| {
            let angle: f64 = from + (to - from) * i as f64 / count;
            let across = angle.sin() - from.sin();
            [start_y + radius * across, start_z + radius * (from.cos() - angle.cos())]
        }));
        from = to;
    }
    let [end_y, end_z] = side[side.len() - 1];
    side.extend((1..=60).map(|i| {
        let along = 0.3 * f64::from(i);
        [end_y + along * from.cos(), end_z + along * from.sin()]
    }));
    let other: Vec<_> = side[1..].iter().rev().map(|[y, z]| [-y, *z]).collect();
    let points = other.iter().chain(&side);
    points
        .fold(String::new(), |text, own| text + &format!("{:.12} {:.12}\n", own[0] + y, own[1] + z))
}

/// A rail that bends to the side and up and down along the track [mm].
pub fn bent(place: f64) -> [f64; 2] {
    let wave = place / 80.0;
    [0.8 * wave.sin(), 0.5 * (1.3 * wave).cos()]
}

/// A folder with slices `section(place)` at the `places` [mm], and their file `rail.slcs`.
pub fn slices(places: impl Iterator<Item = f64>, section: impl Fn(f64) -> String) -> TempDir {
    let folder = TempDir::new().unwrap();
    let (mut listed, mut count) = (String::new(), 0);
    for (i, place) in places.enumerate() {
        fs::write(folder.path().join(format!("{i}.txt")), section(place)).unwrap();
        writeln!(listed, "{place} '{i}.txt'").unwrap();
        count += 1;
    }
    let text = format!("0 1\n{count}\n0 0 0\n1\n{listed}");
    fs::write(folder.path().join("rail.slcs"), text).unwrap();
    folder
}

/// `parameters` with a rail of slices in its own frame at y = 0.75 m.
pub fn of_slices(parameters: Parameters) -> Parameters {
    let mut parameters = Parameters { profile_smoothing: 0.0, ..parameters };
    let rail = &mut parameters.rails[0];
    rail.profile = "rail.slcs".into();
    (rail.placement, rail.position, rail.inclination) = (Placement::Origin, [0.75, 0.0], 0.0);
    parameters
}

/// The rail of a name in CONTACT's table.
pub fn rail_of(name: &str) -> TempDir {
    let (head, first) = (Head::of(name), if name == "nose" { -100.0 } else { 0.0 });
    slices((0..=20).map(|i| first + 10.0 * f64::from(i)), |station| head.section(station))
}

/// Outputs of the models of `parameters` in all rows of CONTACT's table of the rail `name`.
pub fn outputs_of(name: &str, parameters: &Parameters) -> Vec<Output> {
    let folder = rail_of(name);
    let mut parameters = of_slices(parameters.clone());
    parameters.vertical_mode = VerticalMode::Load;
    (parameters.wheel.young_modulus, parameters.rail_young_modulus) =
        (STEEL.young_modulus, STEEL.young_modulus);
    let folders = [folder.path().to_path_buf()];
    let mut element = Element::new(&parameters, &Input::default(), &folders).unwrap();
    let table = read_table("contact_25_1/variable_profiles.csv");
    let mut outputs = Vec::new();
    for row in table.rows.iter().filter(|row| row.iter().any(|cell| cell == name)) {
        let of = |name: &str| value(&table, row, name);
        let yaw = of("yaw_rad");
        let mut input = rolling(0.0, 20.0);
        input.track_s = 1e-3 * of("s_mm");
        // The wheelset turns about its centre.
        (input.wheel.yaw, input.wheel.pitch_rate) = (yaw, of("pitch_rate_rad_s"));
        input.wheel.position[0] = -0.75 * yaw.sin();
        input.wheel.position[1] = 0.75 * yaw.cos() + 1e-3 * of("y_ws_mm");
        if name == "nose" {
            // The velocity at which the slip along the slope is the one that CONTACT has along the
            // track.
            input.wheel.velocity[0] *= 1.01;
        }
        let mut output = Output::default();
        // CONTACT's normal force leans to the side alone: the same normal force, not the same load.
        input.wheel_load = of("N_N");
        for _ in 0..4 {
            element.evaluate(&input, &mut output).unwrap();
            input.wheel_load *= of("N_N") / the_patch(&output).normal_force;
        }
        outputs.push(output);
    }
    outputs
}

/// Errors of the models of `parameters` in all rows of CONTACT's table of the rail `name`: height
/// of the wheel [m], pressure, place [m] and creep force, over the friction limit; with the name of
/// the row.
pub fn errors_against_contact(name: &str, parameters: &Parameters) -> Vec<(String, [f64; 4])> {
    let table = read_table("contact_25_1/variable_profiles.csv");
    let rows = table.rows.iter().filter(|row| row.iter().any(|cell| cell == name));
    let of = |(row, output): (&csv::StringRecord, Output)| {
        let of = |name: &str| value(&table, row, name);
        let patch = the_patch(&output);
        let height = (output.wheel_z + 0.46 - 1e-3 * of("z_ws_mm")).abs();
        let pressure = (patch.max_pressure / (1e6 * of("pmax_MPa")) - 1.0).abs();
        let place = [("x_mm", 0), ("y_mm", 1)].map(|(name, c)| patch.position[c] - 1e-3 * of(name));
        let [fx, fy] = patch.creep_force;
        let force = (fx + of("Fx_N")).hypot(fy + of("Fs_N")) / (0.3 * of("N_N"));
        (row[0].to_owned(), [height, pressure, place[0].hypot(place[1]), force])
    };
    rows.zip(outputs_of(name, parameters)).map(of).collect()
}

/// A folder with `wheel.slcw`, a cylinder of radius 450 mm with a rounded flat of the given `depth`
/// [mm], 100 mm long and across as hollow as a crown of radius 300 mm; with 0.9 mm the one of
/// CONTACT's table.
pub fn wheel_with_flat(depth: f64) -> TempDir {
    let folder = TempDir::new().unwrap();
    let mut listed = String::new();
    for k in -28..=28_i32 {
        let share = f64::from(k.abs().min(25)) / 25.0;
        let middle = 0.5 * depth * (1.0 + (PI * share).cos());
        let mut section = String::from("# mirror_z 0\n# mirror_y 0\n");
        for i in -65..=65_i32 {
            let y = 30.20927 * f64::from(i) / 65.0;
            let crown = 300.0 - (90_000.0 - y * y).sqrt();
            writeln!(section, "{y:.7} {:.7}", -(middle - crown).max(0.0)).unwrap();
        }
        let file = format!("{}.txt", k + 28);
        fs::write(folder.path().join(&file), section).unwrap();
        writeln!(listed, "{:.7} '{file}'", 4.4525e-3 * f64::from(k)).unwrap();
    }
    let text = format!("0 1\n57\n0 0 0\n2\n{listed}");
    fs::write(folder.path().join("wheel.slcw"), text).unwrap();
    folder
}

/// An element by the models of `parameters` with the wheel of [`wheel_with_flat`] on a crown of
/// radius 300 mm, under a given load, and a start for its inputs.
pub fn on_crown(parameters: &Parameters, folder: &TempDir) -> (Element, Input) {
    // As in CONTACT, whose contact is flat.
    let creepage_model = CreepageModel::Flat;
    let mut parameters =
        Parameters { profile_smoothing: 0.0, damping: 0.0, creepage_model, ..parameters.clone() };
    parameters.vertical_mode = VerticalMode::Load;
    (parameters.wheel.young_modulus, parameters.rail_young_modulus) =
        (STEEL.young_modulus, STEEL.young_modulus);
    (parameters.wheel.profile, parameters.wheel.nominal_radius) = ("wheel.slcw".into(), 0.45);
    let rail = &mut parameters.rails[0];
    rail.profile = "arc:0.3".into();
    (rail.placement, rail.position, rail.inclination) = (Placement::Origin, [0.0; 2], 0.0);
    let mut input = rolling(0.0, 20.0);
    input.wheel.position = [0.0, 0.0, -0.45];
    input.wheel.pitch_rate = -20.0 / 0.45;
    (Element::new(&parameters, &input, &[folder.path().to_path_buf()]).unwrap(), input)
}

/// How models miss CONTACT on the wheel with a flat.
pub struct OnFlat {
    pub name: String,
    /// Angle by which the wheel has turned from the middle of its flat [rad].
    pub pitch: f64,
    /// Height of the wheel [m], greatest pressure [-], place along the rail [m] and creep force,
    /// over the friction limit.
    pub errors: [f64; 4],
}

/// Errors of the models of `parameters` in every `step`-th row of CONTACT's table of the wheel with
/// a flat.
pub fn errors_on_flat(parameters: &Parameters, step: usize) -> Vec<OnFlat> {
    let folder = wheel_with_flat(0.9);
    let (mut element, mut input) = on_crown(parameters, &folder);
    let table = read_table("contact_25_1/wheel_slices.csv");
    let rows = table.rows.iter().filter(|row| row[0].starts_with("d09"));
    let of = |row: &csv::StringRecord| {
        let v = |name: &str| value(&table, row, name);
        input.wheel_load = v("load_n");
        (input.wheel.pitch, input.wheel.pitch_rate) = (v("pitch_rad"), v("pitch_rate_rad_s"));
        let output = evaluate(&mut element, &input);
        let patches = &output.patches[..output.patch_count as usize];
        let mean = |of: &dyn Fn(usize) -> f64| {
            (0..patches.len()).map(|k| patches[k].normal_force * of(k)).sum::<f64>() / v("N_N")
        };
        let pressure = patches.iter().map(|p| p.max_pressure).fold(0.0, f64::max);
        let [fx, fy] = [0, 1].map(|c| patches.iter().map(|p| p.creep_force[c]).sum::<f64>());
        let errors = [
            (output.wheel_z + 0.45 - 1e-3 * v("z_ws_mm")).abs(),
            (pressure / (1e6 * v("pmax_MPa")) - 1.0).abs(),
            (mean(&|k| patches[k].position[0]) - 1e-3 * v("x_mm")).abs(),
            (fx + v("Fx_N")).hypot(fy + v("Fs_N")) / (0.3 * v("N_N")),
        ];
        OnFlat { name: row[0].to_owned(), pitch: input.wheel.pitch, errors }
    };
    rows.step_by(step).map(of).collect()
}
