//! Cases on profiles that may not be passed on: they run where WHEELRAIL_PROFILES names a folder
//! that has them.

use std::env;
use std::f64::consts::TAU;
use std::path::PathBuf;

use wheelrail::element::parameters::{CreepageModel, Placement, TangentialModel, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};

use crate::common::planar::STEEL;
use crate::common::wheel::evaluate;
use crate::common::{Table, column, read_table, value};
use crate::family::{Case, Family, none};
use crate::setting::Setting;

/// Names the folder.
pub const FOLDER: &str = "WHEELRAIL_PROFILES";
const CROSSING: [&str; 5] = [
    "height of the wheel [um]",
    "p_max [%]",
    "centre of load [mm]",
    "share of the load [% of all]",
    "creep force [% of the limit]",
];
const WHEEL: &str = "MBench_S1002_v3.prw";
/// Speed of wheels with flats [m/s].
const SPEED: f64 = 20.0;

/// All families on such profiles.
pub const FAMILIES: [Family; 5] = [
    Family {
        title: "Crossing of an artificial nose between wing rails",
        source: "`tests/data/contact_25_1/crossings.csv`, cross+wing",
        text: "Wing and nose in one file of slices, on which a wheel at three lateral places rolls past; given load. CONTACT's planes lean to the side alone; s+c_cw_interrupt 2 stands on the abrupt beginning of the nose, \
               where the reference has a peak.",
        quantities: &CROSSING,
        is_random: false,
        needs_folder: true,
        solve: |setting, _| crossings(setting, &["cross+wing"]),
        others: none,
    },
    Family {
        title: "UK crossing 56E1-R245-1:9.25",
        source: "`tests/data/contact_25_1/crossings.csv`, uk_crossing and uk_interrupt",
        text: "A crossing of the switches-and-crossings benchmark along the track and, at one place, over lateral places, under 60 and 10 kN; some states with contacts on wing and nose. Share: that of \
               the heaviest contact, where there are two.",
        quantities: &CROSSING,
        is_random: false,
        needs_folder: true,
        solve: |setting, _| crossings(setting, &["uk_"]),
        others: none,
    },
    Family {
        title: "Worn wheel on a worn rail, normal results of transient cases",
        source: "`tests/data/contact_25_1/worn_wheel.csv`",
        text: "CONTACT's own tests of steady, shifted and transient rolling with two and three contacts, of which the normal results have no history; the same load. The reference solves each \
               contact by itself and joins those that come near into one plane; in the element contacts press one another down, by 5 µm for 60 kN at 30 mm.",
        quantities: &["height of the wheel [um]", "p_max [%]", "centre of load [mm]"],
        is_random: false,
        needs_folder: true,
        solve: |setting, _| worn_wheel(setting),
        others: none,
    },
    Family {
        title: "Crown in a groove of nearly its radius",
        source: "`tests/data/contact_25_1/groove.csv`",
        text: "10 mm in 10.1 and 10.02 mm, by CONTACT's conformal mode; 10 kN. The reference is printed to 0.1 µm and has two solutions of each groove, up to 0.5 µm and 3 % apart.",
        quantities: &["height of the wheel [um]", "area [%]"],
        is_random: false,
        needs_folder: true,
        solve: |setting, _| groove(setting),
        others: none,
    },
    Family {
        title: "Wheels with flats, sections around the wheel",
        source: "`tests/data/contact_25_1/wheel_slices.csv`",
        text: "A rounded flat 0.9 mm deep on a round crown (d09) and S1002 with a measured flat, each \
               turned over its flat; given load. The reference is flat, and so is the creepage here. The edges of the rounded \
               flat multiply p_max on fine elements, of 0.2 mm in the reference. \
               Strips bridge what is short along the track, as on uneven wheels.",
        quantities: &[
            "height of the wheel [um]",
            "place along the rail [mm]",
            "p_max [%]",
            "area [%]",
            "creep force [% of the limit]",
        ],
        is_random: false,
        needs_folder: true,
        solve: |setting, _| wheel_slices(setting),
        others: none,
    },
];

/// The folder and that of CONTACT's tests in it.
fn folders() -> Option<[PathBuf; 2]> {
    let folder = PathBuf::from(env::var_os(FOLDER)?);
    Some([folder.join("testbank"), folder])
}

/// Both bodies of the reference's steel, profiles as they are.
fn steel(setting: &Setting) -> Parameters {
    let mut parameters = Parameters { profile_smoothing: 0.0, ..setting.parameters() };
    (parameters.wheel.young_modulus, parameters.rail_young_modulus) =
        (STEEL.young_modulus, STEEL.young_modulus);
    parameters
}

/// Greatest pressure, lateral centre of the normal forces, and these with their places.
fn loads(output: &Output) -> (f64, f64, Vec<[f64; 2]>) {
    let pressure = output.patches().map(|p| p.max_pressure).fold(0.0, f64::max);
    let loads: Vec<[f64; 2]> = output.patches().map(|p| [p.normal_force, p.position[1]]).collect();
    (pressure, centre(&loads), loads)
}

fn centre(loads: &[[f64; 2]]) -> f64 {
    loads.iter().map(|[load, y]| load * y).sum::<f64>()
        / loads.iter().map(|[load, _]| load).sum::<f64>()
}

/// What the sum of the creep forces on the wheel and of those `on_rail`, each with the angle of its
/// plane, is off balance [N].
fn missed_creep(output: &Output, on_rail: impl IntoIterator<Item = ([f64; 2], f64)>) -> f64 {
    let own = output.patches().map(|p| (p.creep_force, p.contact_angle));
    let mut missed = [0.0_f64; 3];
    for ([x, across], angle) in own.chain(on_rail) {
        let (sine, cosine) = angle.sin_cos();
        for (sum, part) in missed.iter_mut().zip([x, across * cosine, across * sine]) {
            *sum += part;
        }
    }
    missed.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn crossings(setting: &Setting, rails: &[&str]) -> Option<Vec<Case>> {
    let folders = folders()?;
    let table = read_table("contact_25_1/crossings.csv");
    let rail = column(&table, "rail");
    let mut cases = Vec::new();
    let mut known: Option<(String, Element)> = None;
    for row in &table.rows {
        let name = &row[rail];
        if !rails.iter().any(|begin| name.starts_with(begin)) {
            continue;
        }
        if known.as_ref().is_none_or(|(other, _)| other != name) {
            let mut parameters = Parameters { vertical_mode: VerticalMode::Load, ..steel(setting) };
            parameters.wheel.profile = WHEEL.into();
            let rail = &mut parameters.rails[0];
            rail.profile = name.into();
            (rail.placement, rail.position, rail.inclination) =
                (Placement::Origin, [0.75, 0.0], 0.0);
            let element = Element::new(&parameters, &Input::default(), &folders)
                .expect("profiles in the folder");
            known = Some((name.to_owned(), element));
        }
        let Some((_, element)) = &mut known else { continue };
        cases.push(on_crossing(element, &table, row));
    }
    Some(cases)
}

fn on_crossing(element: &mut Element, table: &Table, row: &csv::StringRecord) -> Case {
    let v = |name: &str| value(table, row, name);
    let patches: Vec<usize> = [1, 2]
        .into_iter()
        .filter(|k| !row[column(table, &format!("p{k}_N_N"))].is_empty())
        .collect();
    let of = |k: usize, name: &str| v(&format!("p{k}_{name}"));
    let mut input =
        Input { track_s: 1e-3 * v("s_mm"), wheel_load: v("load_n"), ..Input::default() };
    let (sine, cosine) = v("yaw_rad").sin_cos();
    let wheel = &mut input.wheel;
    (wheel.yaw, wheel.pitch_rate) = (v("yaw_rad"), v("pitch_rate_rad_s"));
    wheel.velocity[0] = v("speed_m_s");
    (wheel.position[0], wheel.position[1]) = (-0.75 * sine, 0.75 * cosine + 1e-3 * v("y_ws_mm"));
    let output = evaluate(element, &input);
    let (pressure, middle, own) = loads(&output);
    let expected: Vec<[f64; 2]> =
        patches.iter().map(|&k| [of(k, "N_N"), 1e-3 * of(k, "y_mm")]).collect();
    let most = patches.iter().map(|&k| of(k, "pmax_MPa")).fold(0.0, f64::max);
    let share = |loads: &[[f64; 2]]| {
        let [[_, first], [_, second]] = expected.as_slice() else { return f64::NAN };
        let near = |y: f64| (y - first).abs() < (y - second).abs();
        let all: f64 = loads.iter().map(|[load, _]| load).sum();
        loads.iter().filter(|[_, y]| near(*y)).map(|[load, _]| load).sum::<f64>() / all
    };
    // The reference's are those on the rail.
    let on_rail = patches.iter().map(|&k| ([of(k, "Fx_N"), of(k, "Fs_N")], of(k, "angle_rad")));
    let missed = missed_creep(&output, on_rail);
    let limit: f64 = patches.iter().map(|&k| 0.3 * of(k, "N_N")).sum();
    let errors = vec![
        1e6 * (output.wheel_z + 0.46 - 1e-3 * v("z_ws_mm")),
        100.0 * (1e-6 * pressure / most - 1.0),
        1e3 * (middle - centre(&expected)),
        100.0 * (share(&own) - share(&expected)),
        100.0 * missed / limit,
    ];
    Case { name: row[0].to_owned(), errors }
}

/// Where the nominal rolling circle of the worn wheel is: from the centre of the wheelset, and
/// below its axle [m].
const WORN_WHEEL: [f64; 2] = [0.743_70, 0.444];

fn worn_wheel(setting: &Setting) -> Option<Vec<Case>> {
    let folders = folders()?;
    let mut parameters = Parameters {
        vertical_mode: VerticalMode::Load,
        tangential_model: TangentialModel::None,
        gauge: 1.4351,
        gauge_depth: 15.875e-3,
        ..steel(setting)
    };
    let [arm, radius] = WORN_WHEEL;
    parameters.wheel.profile = "worn_high_mileage.prw".into();
    parameters.wheel.nominal_radius = radius;
    (parameters.rails[0].profile, parameters.rails[0].inclination) = ("site_b_hr.prr".into(), 0.0);
    let mut element =
        Element::new(&parameters, &Input::default(), &folders).expect("profiles in the folder");
    let table = read_table("contact_25_1/worn_wheel.csv");
    let of = |rows: &[csv::StringRecord]| {
        let v = |name: &str| value(&table, &rows[0], name);
        let (roll, yaw) = (v("roll_rad"), v("yaw_rad"));
        let mut input = Input::default();
        (input.wheel.roll, input.wheel.yaw) = (roll, yaw);
        input.wheel.position =
            [-arm * yaw.sin(), 1e-3 * v("y_ws_mm") + arm * yaw.cos() * roll.cos(), -radius];
        let of = |row: &csv::StringRecord, name: &str| value(&table, row, name);
        // Without friction.
        input.wheel_load = rows.iter().map(|row| of(row, "N_N") * of(row, "angle_rad").cos()).sum();
        let output = evaluate(&mut element, &input);
        let (pressure, middle, _) = loads(&output);
        let most = rows.iter().map(|row| of(row, "pmax_MPa")).fold(0.0, f64::max);
        let expected: Vec<[f64; 2]> =
            rows.iter().map(|row| [of(row, "N_N"), 1e-3 * of(row, "y_mm")]).collect();
        // The height of the wheel is that of the wheelset and what its roll adds.
        let height = 1e-3 * v("z_ws_mm") - radius + arm * yaw.cos() * roll.sin();
        let errors = vec![
            1e6 * (output.wheel_z - height),
            100.0 * (1e-6 * pressure / most - 1.0),
            1e3 * (middle - centre(&expected)),
        ];
        Case { name: rows[0][0].to_owned(), errors }
    };
    Some(table.rows.chunk_by(|a, b| a[0] == b[0]).map(of).collect())
}

fn groove(setting: &Setting) -> Option<Vec<Case>> {
    let folders = folders()?;
    let table = read_table("contact_25_1/groove.csv");
    let rail = column(&table, "rail");
    let of = |row: &csv::StringRecord| {
        let v = |name: &str| value(&table, row, name);
        let mut parameters = Parameters {
            vertical_mode: VerticalMode::Load,
            tangential_model: TangentialModel::None,
            ..steel(setting)
        };
        // G = 80 GPa.
        let young_modulus = 160e9 * (1.0 + STEEL.poisson_ratio);
        parameters.rail_young_modulus = young_modulus;
        let wheel = &mut parameters.wheel;
        (wheel.profile, wheel.young_modulus) = ("circ_r10.prw".into(), young_modulus);
        wheel.nominal_radius = 0.42;
        let place = &mut parameters.rails[0];
        place.profile = row[rail].into();
        (place.placement, place.position, place.inclination) = (Placement::Origin, [0.0; 2], 0.0);
        let mut input = Input { wheel_load: v("load_n"), ..Input::default() };
        input.wheel.position = [0.0, 0.0, -0.42];
        let mut element =
            Element::new(&parameters, &input, &folders).expect("profiles in the folder");
        let output = evaluate(&mut element, &input);
        let area: f64 = output.patches().map(|p| p.area).sum();
        let errors = vec![
            1e6 * (output.wheel_z + 0.42 - 1e-3 * v("z_ws_mm")),
            100.0 * (1e6 * area / v("area_mm2") - 1.0),
        ];
        Case { name: row[0].to_owned(), errors }
    };
    Some(table.rows.iter().map(of).collect())
}

/// How wheels with sections around them stand: nominal radius and lateral place, the rail's
/// inclination and smoothing of both [m, m, rad, m].
struct Stand {
    radius: f64,
    y: f64,
    placement: Placement,
    inclination: f64,
    smoothing: f64,
}

fn stand(wheel: &str) -> Stand {
    if wheel == "S1002_flat.slcw" {
        // λ = 5 against a sum over points 1 mm apart leaves half of waves of 2π λ^(1/4) mm.
        let (radius, smoothing) = (0.49, 1e-3 * TAU * 5_f64.powf(0.25));
        Stand { radius, y: 0.75, placement: Placement::Gauge, inclination: 0.02, smoothing }
    } else {
        let (radius, smoothing) = (0.45, 0.0);
        Stand { radius, y: 0.0, placement: Placement::Origin, inclination: 0.0, smoothing }
    }
}

fn wheel_slices(setting: &Setting) -> Option<Vec<Case>> {
    let folders = folders()?;
    let table = read_table("contact_25_1/wheel_slices.csv");
    let [rail, wheel] = ["rail", "wheel"].map(|name| column(&table, name));
    let of = |rows: &[csv::StringRecord]| {
        let stand = stand(&rows[0][wheel]);
        let mut parameters = Parameters { vertical_mode: VerticalMode::Load, ..steel(setting) };
        parameters.creepage_model = CreepageModel::Flat;
        parameters.profile_smoothing = stand.smoothing;
        parameters.wheel.profile = rows[0][wheel].into();
        parameters.wheel.nominal_radius = stand.radius;
        let place = &mut parameters.rails[0];
        place.profile = rows[0][rail].into();
        (place.placement, place.position) = (stand.placement, [0.0; 2]);
        place.inclination = stand.inclination;
        let mut input = Input::default();
        input.wheel.position = [0.0, stand.y, -stand.radius];
        let mut element =
            Element::new(&parameters, &input, &folders).expect("profiles in the folder");
        let case = |row: &csv::StringRecord| {
            on_flat(&mut element, &input, stand.radius, |name| value(&table, row, name), &row[0])
        };
        rows.iter().map(case).collect::<Vec<_>>()
    };
    Some(table.rows.chunk_by(|a, b| a[wheel] == b[wheel]).flat_map(of).collect())
}

fn on_flat(
    element: &mut Element,
    input: &Input,
    radius: f64,
    v: impl Fn(&str) -> f64,
    name: &str,
) -> Case {
    let mut input = Input { wheel_load: v("load_n"), ..*input };
    (input.wheel.pitch, input.wheel.pitch_rate) = (v("pitch_rad"), v("pitch_rate_rad_s"));
    input.wheel.velocity[0] = SPEED;
    let output = evaluate(element, &input);
    let (pressure, ..) = loads(&output);
    let load: f64 = output.patches().map(|p| p.normal_force).sum();
    let along: f64 = output.patches().map(|p| p.normal_force * p.position[0]).sum();
    let area: f64 = output.patches().map(|p| p.area).sum();
    let on_rail = ([v("Fx_N"), v("Fs_N")], v("angle_rad"));
    let missed = missed_creep(&output, [on_rail]);
    let errors = vec![
        1e6 * (output.wheel_z + radius - 1e-3 * v("z_ws_mm")),
        1e3 * along / load - v("x_mm"),
        100.0 * (1e-6 * pressure / v("pmax_MPa") - 1.0),
        100.0 * (1e6 * area / v("area_mm2") - 1.0),
        100.0 * missed / (0.3 * v("N_N")),
    ];
    Case { name: name.to_owned(), errors }
}
