//! A wheel on its rail under given load, by CONTACT and by the element.

use tempfile::TempDir;
use wheelrail::element::output::Patch;
use wheelrail::element::parameters::{
    CreepageModel, Foundation, FoundationModel, FrictionDistribution, Side, TangentialModel,
    VerticalMode,
};
use wheelrail::element::{Element, Output, Parameters};

use crate::common::contact_plane::{Whose, errors_on_plane};
use crate::common::roller;
use crate::common::varying::{errors_against_contact, outputs_of};
use crate::common::wheel::{FRICTION_TABLES, benchmark, evaluate, of_manchester, of_wheelset};
use crate::common::{Table, column, read_table, value};
use crate::family::{Case, Family, none};
use crate::setting::{Setting, reference};

/// Coefficient of friction of the rolling states.
const FRICTION: f64 = 0.3;
const ROLLING: [&str; 2] = ["p_max [%]", "force in the contact plane [% of the limit]"];

/// All families of wheels on rails.
pub const FAMILIES: [Family; 11] = [
    Family {
        title: "Wheel on rail at given load, frictionless",
        source: "`tests/data/contact_25_1/element_normal.csv`",
        text: "S1002 on UIC60, lateral places from -6 to 10 mm, loads from 5 to 150 kN; the reference has one plane for each contact, by which contacts on the flange differ.",
        quantities: &["normal force [%]", "p_max [%]", "area [%]", "place along the rail [mm]"],
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(frictionless(setting)),
        others: none,
    },
    Family {
        title: "Rolling wheel, CONTACT's conformal mode",
        source: "`tests/data/contact_25_1/conformal.csv`",
        text: "30 random states from tread to flange. Compared is all force within the reference's plane: pressures of a patch that wraps have a part in it.",
        quantities: &ROLLING,
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(rolling(setting, "contact_25_1/conformal.csv")),
        others: planar_mode,
    },
    Family {
        title: "Rolling wheel, CONTACT's planar mode",
        source: "`tests/data/contact_25_1/planar_states.csv`",
        text: "The same states on one plane each, which the element has with `creepage.model` = flat alone.",
        quantities: &ROLLING,
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(rolling(setting, "contact_25_1/planar_states.csv")),
        others: none,
    },
    Family {
        title: "Manchester contact benchmark A-1",
        source: "`tests/data/contact_25_1/manchester_a1.csv`",
        text: "Both wheels of a wheelset at 21 places without yaw, 10 kN each, no friction. The reference has one plane for each contact.",
        quantities: &[MANCHESTER[0], MANCHESTER[1]],
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(manchester(setting, "a1")),
        others: none,
    },
    Family {
        title: "Manchester contact benchmark A-2.1",
        source: "`tests/data/contact_25_1/manchester_a21.csv`",
        text: "The same with friction and both wheels turning at one rate.",
        quantities: &MANCHESTER,
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(manchester(setting, "a21")),
        others: none,
    },
    Family {
        title: "Manchester contact benchmark A-2.2",
        source: "`tests/data/contact_25_1/manchester_a22.csv`",
        text: "The same with a yaw that grows with the shift, up to 24 mrad.",
        quantities: &MANCHESTER,
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(manchester(setting, "a22")),
        others: fast_manchester,
    },
    Family {
        title: "Wheels of simple shapes on rollers",
        source: "`tests/data/contact_25_1/rollers.csv`",
        text: "Cylinder and ball on a crowned roller and on a conical one of 0.4 m, with yaw and with roll; approach and creepages of the reference.",
        quantities: &["N [%]", "p_max [%]", "place across [mm]", "creep force [% of the limit]"],
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(rollers(setting)),
        others: none,
    },
    Family {
        title: "Friction by inclination",
        source: "`tests/data/contact_25_1/friction_by_inclination.csv`",
        text: "Two tables of friction over the inclination of the rail. The reference takes one coefficient for each contact, that of its plane; the element one for each strip.",
        quantities: &["force in the contact plane [% of the limit]"],
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(friction_by_inclination(setting)),
        others: none,
    },
    Family {
        title: "Rail on springs without mass",
        source: "`tests/data/contact_25_1/massless_rail.csv`",
        text: "The rail sinks and yields under given load until springs and contact agree.",
        quantities: &["contact force [%]", "deflection [%]"],
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(massless(setting)),
        others: none,
    },
    Family {
        title: "Wing rail that runs off along the track",
        source: "`tests/data/contact_25_1/variable_profiles.csv`",
        text: "A section that moves to the side by 1:10 under a coned wheel, which touches it behind its centre; the same normal force. CONTACT lets particles pass along the track, the element along the rows of the rail, as the patch moves; and its plane leans by 0.097 where both bodies lean by 0.067 (theory.md, section 11). The last rows tell the two apart: boundary elements of its size on its plane and on that of the surfaces, along both.",
        quantities: &VARYING,
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(varying(setting, "wing")),
        others: wing_on_planes,
    },
    Family {
        title: "Nose of a crossing that rises along the track",
        source: "`tests/data/contact_25_1/variable_profiles.csv`",
        text: "A section that rises by 1:10, which the wheel touches ahead of its centre; normal and creep force each in its own frame, as the reference leans to the side alone. \
            Contacts lie where the flat top and a corner of 5 mm meet: there its surface is rounder than the sections. On one section held constant strips and `boundary_element` (80x80) have p_max 4980 and \
            4962 MPa where it has 4613, 4397 and 4342 where it has 3888 (`cargo test --test suite a_section_of -- --nocapture`). Beside nose_y-4_24 its slices end. The last row is boundary elements of its size on its plane, with its creepages.",
        quantities: &VARYING,
        is_random: false,
        needs_folder: false,
        solve: |setting, _| Some(varying(setting, "nose")),
        others: nose_on_plane,
    },
];

const MANCHESTER: [&str; 3] = ["normal force [%]", "p_max [%]", "creep force [% of the limit]"];
const VARYING: [&str; 4] =
    ["height of the wheel [um]", "p_max [%]", "place [mm]", "creep force [% of the limit]"];

fn varying(setting: &Setting, rail: &str) -> Vec<Case> {
    let scales = [1e6, 100.0, 1e3, 100.0];
    let of = |(name, errors): (String, [f64; 4])| {
        let errors = errors.into_iter().zip(scales).map(|(error, scale)| scale * error).collect();
        Case { name, errors }
    };
    errors_against_contact(rail, &setting.parameters()).into_iter().map(of).collect()
}

/// Boundary elements on planes: pressures and creep forces alone.
fn on_plane(rail: &str, whose: &Whose, course: f64) -> Vec<Case> {
    let of = |(name, [pressure, force]): (String, [f64; 2])| Case {
        name,
        errors: vec![f64::NAN, 100.0 * pressure, f64::NAN, 100.0 * force],
    };
    errors_on_plane(rail, whose, course, f64::INFINITY).into_iter().map(of).collect()
}

fn wing_on_planes() -> Vec<(String, Vec<Case>)> {
    let parameters = Parameters { creepage_model: CreepageModel::Flat, ..reference().parameters() };
    let patches: Vec<Patch> =
        outputs_of("wing", &parameters).iter().map(|output| output.patches[0]).collect();
    let own = Whose::Element(&patches);
    let rows = 0.1_f64.atan();
    vec![
        ("CONTACT's plane, along the track".into(), on_plane("wing", &Whose::Contact, 0.0)),
        ("CONTACT's plane, along the rows".into(), on_plane("wing", &Whose::Contact, rows)),
        ("plane of the surfaces, along the track".into(), on_plane("wing", &own, 0.0)),
        ("plane of the surfaces, along the rows".into(), on_plane("wing", &own, rows)),
    ]
}

fn nose_on_plane() -> Vec<(String, Vec<Case>)> {
    vec![("CONTACT's plane".into(), on_plane("nose", &Whose::Contact, 0.0))]
}

fn rollers(setting: &Setting) -> Vec<Case> {
    let of = |(name, e): (String, roller::Errors)| Case {
        name,
        errors: vec![100.0 * e.force, 100.0 * e.pressure, 1e3 * e.place, 100.0 * e.creep],
    };
    roller::errors_against_contact(&setting.parameters()).into_iter().map(of).collect()
}

fn under_load(setting: &Setting) -> Parameters {
    Parameters { vertical_mode: VerticalMode::Load, ..setting.parameters() }
}

/// All normal force, greatest pressure, area, and the mean over the load of the lateral place of
/// the patches.
fn sizes(output: &Output) -> [f64; 4] {
    let load: f64 = output.patches().map(|p| p.normal_force).sum();
    let pressure = output.patches().map(|p| p.max_pressure).fold(0.0, f64::max);
    let area = output.patches().map(|p| p.area).sum();
    let place: f64 = output.patches().map(|p| p.normal_force * p.position[1]).sum();
    [load, pressure, area, place / load]
}

fn frictionless(setting: &Setting) -> Vec<Case> {
    let table = read_table("contact_25_1/element_normal.csv");
    let mut element =
        benchmark(Parameters { tangential_model: TangentialModel::None, ..under_load(setting) });
    let of = |row: &csv::StringRecord| {
        let v = |name: &str| value(&table, row, name);
        let mut input = wheelrail::element::Input::default();
        input.wheel.position[1] += 1e-3 * v("y_ws_mm");
        input.wheel_load = v("load_n");
        let output = evaluate(&mut element, &input);
        let [_, pressure, area, place] = sizes(&output);
        let [_, fy, fz] = output.wheel.force;
        let percent = |found: f64, name: &str| 100.0 * (found / v(name) - 1.0);
        let errors = vec![
            // Without friction the force on the reference's plane is the resultant of all patches.
            percent(fy.hypot(fz), "normal_force_n"),
            percent(1e-6 * pressure, "max_pressure_mpa"),
            percent(1e6 * area, "area_mm2"),
            (1e3 * place - v("y_track_mm")) / v("delta_deg").to_radians().cos(),
        ];
        Case { name: format!("y {} mm, {} N", v("y_ws_mm"), v("load_n")), errors }
    };
    table.rows.iter().map(of).collect()
}

/// By what the force on the rail misses that of a row within the plane of its contact [N].
fn missed_in_plane(output: &Output, v: &dyn Fn(&str) -> f64) -> f64 {
    let (sine, cosine) = v("p1_angle_rad").sin_cos();
    let [x, y, z] = [("fx_rail_N", 0), ("fy_rail_N", 1), ("fz_rail_total_N", 2)]
        .map(|(name, c)| output.rails[0].force[c] - v(name));
    x.hypot(y * cosine + z * sine)
}

fn rolling(setting: &Setting, file: &str) -> Vec<Case> {
    let table = read_table(file);
    let mut element = benchmark(under_load(setting));
    let of = |row: &csv::StringRecord| {
        let v = |name: &str| value(&table, row, name);
        let output = evaluate(&mut element, &of_wheelset(&v));
        let [_, pressure, ..] = sizes(&output);
        let errors = vec![
            100.0 * (1e-6 * pressure / v("p1_pmax_MPa") - 1.0),
            100.0 * missed_in_plane(&output, &v) / (FRICTION * v("p1_N_N")),
        ];
        Case { name: row[0].to_owned(), errors }
    };
    table.rows.iter().map(of).collect()
}

/// CONTACT's planar mode beside its conformal one.
fn planar_mode() -> Vec<(String, Vec<Case>)> {
    let [exact, planar] =
        ["conformal", "planar_states"].map(|name| read_table(&format!("contact_25_1/{name}.csv")));
    let cases = exact.rows.iter().zip(&planar.rows).map(|(row, other)| {
        let v = |name: &str| value(&exact, row, name);
        let own = |name: &str| value(&planar, other, name);
        let (sine, cosine) = v("p1_angle_rad").sin_cos();
        let [x, y, z] =
            ["fx_rail_N", "fy_rail_N", "fz_rail_total_N"].map(|name| own(name) - v(name));
        let missed = x.hypot(y * cosine + z * sine) / (FRICTION * v("p1_N_N"));
        let pressure = own("p1_pmax_MPa") / v("p1_pmax_MPa") - 1.0;
        Case { name: row[0].to_owned(), errors: vec![100.0 * pressure, 100.0 * missed] }
    });
    vec![("CONTACT's planar mode".into(), cases.collect())]
}

fn manchester(setting: &Setting, case: &str) -> Vec<Case> {
    let table = read_table(&format!("contact_25_1/manchester_{case}.csv"));
    let mut parameters = under_load(setting);
    if case == "a1" {
        parameters.tangential_model = TangentialModel::None;
    }
    let mut elements =
        [Side::Left, Side::Right].map(|side| benchmark(Parameters { side, ..parameters.clone() }));
    let of = |row: &csv::StringRecord| {
        let v = |name: &str| value(&table, row, name);
        let name = &row[column(&table, "side")];
        let (side, k) = if name == "left" { (Side::Left, 0) } else { (Side::Right, 1) };
        let output = evaluate(&mut elements[k], &of_manchester(&v, side));
        let [_, pressure, ..] = sizes(&output);
        let mut errors = manchester_errors(&v, output.wheel.force, 1e-6 * pressure);
        if case == "a1" {
            errors.pop();
        }
        Case { name: format!("{name}, y {} mm", v("y_ws_mm")), errors }
    };
    table.rows.iter().map(of).collect()
}

/// Errors of a force on the wheel [N] and of the greatest pressure [MPa]; the reference has forces
/// on the rail along its plane and its normal.
fn manchester_errors(v: &dyn Fn(&str) -> f64, force: [f64; 3], pressure: f64) -> Vec<f64> {
    let (sine, cosine) = v("delta_deg").to_radians().sin_cos();
    let [fx, fy, fz] = force;
    let (lateral, normal) = (fy * cosine + fz * sine, fy * sine - fz * cosine);
    let missed = (fx + v("Fx_N")).hypot(lateral + v("Fs_N")) / (FRICTION * v("N_N"));
    vec![
        100.0 * (normal / v("N_N") - 1.0),
        100.0 * (pressure / v("pmax_MPa") - 1.0),
        100.0 * missed,
    ]
}

/// CONTACT's own simplified solutions.
fn fast_manchester() -> Vec<(String, Vec<Case>)> {
    let exact = read_table("contact_25_1/manchester_a22.csv");
    let fast = read_table("contact_25_1/manchester_a22_fast.csv");
    let key = |table: &Table, row: &csv::StringRecord| {
        ["y_ws_mm", "side"].map(|name| row[column(table, name)].to_owned())
    };
    let method = column(&fast, "method");
    let of = |wanted: &str| {
        let cases = fast.rows.iter().filter(|row| &row[method] == wanted).map(|row| {
            let [y, side] = key(&fast, row);
            let same = |other: &&csv::StringRecord| key(&exact, other) == key(&fast, row);
            let other = exact.rows.iter().find(same).expect("a state of manchester_a22.csv");
            let force = ["Fx_tr_N", "Fy_tr_N", "Fz_tr_N"].map(|name| -value(&fast, row, name));
            let errors = manchester_errors(
                &|name| value(&exact, other, name),
                force,
                value(&fast, row, "pmax_MPa"),
            );
            Case { name: format!("{side}, y {y} mm"), errors }
        });
        (format!("CONTACT's {wanted}"), cases.collect())
    };
    ["ANALYN+FASTSIM", "KPEC+FASTSIM"].map(of).into()
}

fn friction_by_inclination(setting: &Setting) -> Vec<Case> {
    let table = read_table("contact_25_1/friction_by_inclination.csv");
    let folder = TempDir::new().expect("a folder for a table");
    let mut elements: Vec<Element> = (FRICTION_TABLES.iter().enumerate())
        .map(|(k, text)| {
            let path = folder.path().join(format!("{k}.csv"));
            std::fs::write(&path, text).expect("a table");
            benchmark(Parameters {
                friction_distribution: FrictionDistribution::Profile,
                friction_profile: path.display().to_string(),
                ..under_load(setting)
            })
        })
        .collect();
    let of = |row: &csv::StringRecord| {
        let v = |name: &str| value(&table, row, name);
        let element = &mut elements[v("friction_table") as usize - 1];
        let output = evaluate(element, &of_wheelset(&v));
        let limit = v("p1_friction") * v("p1_N_N");
        Case { name: row[0].to_owned(), errors: vec![100.0 * missed_in_plane(&output, &v) / limit] }
    };
    table.rows.iter().map(of).collect()
}

/// Stiffness of a spring that does not give way [N/m].
const RIGID: f64 = 1e15;

fn massless(setting: &Setting) -> Vec<Case> {
    let table = read_table("contact_25_1/massless_rail.csv");
    table.rows.iter().map(|row| on_springs(setting, &table, row)).collect()
}

fn on_springs(setting: &Setting, table: &Table, row: &csv::StringRecord) -> Case {
    let v = |name: &str| value(table, row, name);
    let stiffness = ["ky_rail_N_mm", "kz_rail_N_mm"].map(|name| 1e3 * v(name));
    let stiffness = stiffness.map(|k| if k > 0.0 { k } else { RIGID });
    let foundation =
        Foundation { model: FoundationModel::Massless, stiffness, ..Foundation::default() };
    let mut element = benchmark(Parameters { foundation, ..under_load(setting) });
    let mut input = of_wheelset(&v);
    // What the outer force deflects it by.
    input.rails[0].y = v("fy_outer_N") / stiffness[0];
    let output = evaluate(&mut element, &input);
    let [y, z] = output.foundation.deflection;
    let expected = ["dy_defl_mm", "dz_defl_mm"].map(|name| 1e-3 * v(name));
    let deflection = [input.rails[0].y + y - expected[0], z - expected[1]];
    let force = ["fx_rail_N", "fy_rail_N", "fz_rail_total_N"].map(v);
    let size = |vector: &[f64]| vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    let missed: Vec<f64> = (0..3).map(|c| output.rails[0].force[c] - force[c]).collect();
    let errors =
        vec![100.0 * size(&missed) / size(&force), 100.0 * size(&deflection) / size(&expected)];
    Case { name: row[0].to_owned(), errors }
}
