//! Profiles as their makers meant them: grooved rails, headers with numbers, origins, kinks; what is
//! unlikely is told or refused in the numbers of the file.

use std::fmt::Write;
use std::fs;

use crate::common::wheel::{evaluate, plain_parameters, pressed, rolling};
use tempfile::TempDir;
use wheelrail::element::Element;
use wheelrail::element::parameters::{AUTOMATIC_SMOOTHING, NormalModel, TangentialModel};
use wheelrail::geometry::profile::{Profile, ProfileKind};
use wheelrail::geometry::rail::placed_rail::PlacedRail;
use wheelrail::io::load_profile;

const WHEEL: ProfileKind = ProfileKind::Wheel;
const RAIL: ProfileKind = ProfileKind::Rail;

/// Points along the corners of an outline, `spacing` apart [mm].
fn along(corners: &[[f64; 2]], spacing: f64) -> Vec<[f64; 2]> {
    let mut points = vec![corners[0]];
    for pair in corners.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let steps = ((to[0] - from[0]).hypot(to[1] - from[1]) / spacing).ceil().max(1.0);
        points.extend((1..=steps as usize).map(|i| {
            let share = i as f64 / steps;
            [0, 1].map(|c| from[c] + share * (to[c] - from[c]))
        }));
    }
    points
}

/// Corners on an arc about `centre` from one angle to the other, counted from -z to +y [mm, rad].
fn arc(centre: [f64; 2], radius: f64, angles: [f64; 2]) -> Vec<[f64; 2]> {
    (0..=40)
        .map(|i| angles[0] + (angles[1] - angles[0]) * f64::from(i) / 40.0)
        .map(|a| [centre[0] + radius * a.sin(), centre[1] - radius * a.cos()])
        .collect()
}

/// A grooved rail as of a right wheel: guard from y = -90 to -42 mm with its top `guard` below that
/// of the head, groove 45 mm deep, gauge face at y = 0, head beyond it.
fn grooved(guard: f64) -> Vec<[f64; 2]> {
    let mut corners = vec![[-90.0, guard + 3.0]];
    corners.extend(arc([-50.0, guard + 8.0], 8.0, [-0.2, 1.4]));
    corners.extend([[-40.0, 40.0], [-30.0, 45.0], [-10.0, 45.0], [-1.0, 35.0], [0.0, 14.0]]);
    corners.extend(arc([13.0, 13.0], 13.0, [-1.5, 0.0]));
    corners.extend([[30.0, 1.0], [55.0, 12.0]]);
    along(&corners, 0.25)
}

fn highest(points: &[[f64; 2]]) -> [f64; 2] {
    *points.iter().min_by(|a, b| a[1].total_cmp(&b[1])).unwrap()
}

/// A wheel with a cone of 1:20 and a flange from y = -64 mm, its running circle at y = 0 [mm].
fn wheel() -> Vec<[f64; 2]> {
    along(
        &[[-64.0, 12.0], [-58.0, 27.0], [-50.0, 27.0], [-38.0, 2.0], [-30.0, 1.5], [58.0, -2.9]],
        0.25,
    )
}

fn text(points: impl IntoIterator<Item = [f64; 2]>, decimals: usize) -> String {
    points.into_iter().fold(String::new(), |mut text, [y, z]| {
        writeln!(text, "{y:.decimals$} {z:.decimals$}").unwrap();
        text
    })
}

/// The profile in a file, or why there is none.
fn try_read(file: &str, content: &str, kind: ProfileKind) -> Result<Profile, String> {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(file), content).unwrap();
    let folders = [folder.path().to_path_buf()];
    load_profile("profile", file, kind, AUTOMATIC_SMOOTHING, &folders).map_err(|e| e.to_string())
}

fn read(file: &str, content: &str, kind: ProfileKind) -> Profile {
    try_read(file, content, kind).unwrap_or_else(|error| panic!("{file}: {error}"))
}

fn warnings(profile: &Profile) -> Vec<String> {
    profile.remarks.iter().filter(|r| r.is_warning()).map(ToString::to_string).collect()
}

#[test]
fn grooved_rails_stand_as_their_format_says_and_by_their_running_head() {
    for guard in [2.0, -1.0] {
        let rail = grooved(guard);
        let files = [
            ("a.txt", text(rail.iter().copied(), 4)),
            ("b.txt", format!("# mirror_z 0\n{}", text(rail.iter().rev().copied(), 4))),
            ("c.ban", format!("ColumnDef=X,Y\n\n{}", text(rail.iter().map(|p| p.map(|x| -x)), 4))),
            (
                "d.ban",
                format!(
                    "ColumnDef=X,Y\n\n# mirror_y 1\n# mirror_z 1\n{}",
                    text(rail.iter().copied(), 4)
                ),
            ),
        ];
        for (file, content) in files {
            let profile = read(file, &content, RAIL);
            assert!(
                !warnings(&profile).iter().any(|w| w.contains("mirrored")),
                "{file}: {:?}",
                warnings(&profile)
            );
            let bounds = profile.bounds();
            assert!((bounds.z[1] - bounds.z[0]) > 0.043, "{file}: a groove, not a ridge");
            // The face of the head at y = 0 of its own frame, not the wall of the guard.
            let placed = PlacedRail::by_gauge(&profile.curve, 0.0, 1.435, 0.014, false).unwrap();
            let [face, top] = placed.placed_point([0.0, 0.0]);
            let origin = if file.ends_with("ban") { highest(&rail) } else { [0.0; 2] };
            let at = [
                placed.marker[0] + face - 1e-3 * origin[0],
                placed.marker[1] + top - 1e-3 * origin[1],
            ];
            assert!((at[0] - 0.7175).abs() < 1e-4, "{file}: the face at {} m", at[0]);
            assert!(at[1].abs() < 1e-4, "{file}: the top of the head at {} m", at[1]);
        }
    }
}

#[test]
fn headers_and_comments_are_no_points() {
    let from_back: Vec<[f64; 2]> = wheel().iter().map(|p| [p[0] + 70.0, p[1]]).collect();
    let body = text(from_back.iter().copied(), 4);
    let expected = read("a.whl", &format!("MINIPROF\n\n{body}"), WHEEL).bounds();
    let commented = body.replacen('\n', "\n#", 4);
    let count = from_back.len();
    for header in [
        "#MINIWHEELPROF\nown.whl\nMINIPROF 2020\nStock.......:\n30.10 28.20 9.90\n(Sd/Sh/qR)\n",
        "MINIPROF 101 1994\n30.1 28.2 9.9\n\nmeasured at 12 30\n",
        "XYPoints=9\nSd=30.1 28.2\n",
    ] {
        let profile = read("b.whl", &format!("{header}\n{body}"), WHEEL);
        assert!((profile.bounds().z[1] - expected.z[1]).abs() < 1e-6, "{header}");
        assert!((profile.bounds().y[0] - expected.y[0]).abs() < 1e-6, "{header}");
    }
    let profile = read("c.whl", &format!("XYPoints={count}\n\n{commented}"), WHEEL);
    assert!((profile.bounds().y[1] - expected.y[1]).abs() < 1e-6);
}

#[test]
fn origins_are_those_of_the_format_or_the_wheel_is_refused_in_its_own_numbers() {
    let prw = |points: Vec<[f64; 2]>| {
        format!(
            "header.begin\n type = 1\nheader.end\nspline.begin\n units.len.f = 1000.\n point.begin\n{} point.end\nspline.end\n",
            text(points, 4)
        )
    };
    // Of SIMPACK the running circle is the origin where the points reach it, else the flange back.
    let from_back: Vec<[f64; 2]> = wheel().iter().map(|p| [p[0] + 70.0, p[1]]).collect();
    let [found, expected] = [from_back, wheel()].map(|p| read("a.prw", &prw(p), WHEEL).bounds());
    for (found, expected) in [(found.y, expected.y), (found.z, expected.z)] {
        // The last digit in the file.
        let off = (0..2).map(|end| (found[end] - expected[end]).abs()).fold(0.0, f64::max);
        assert!(off <= 1e-7, "{off:e}: {found:?} for {expected:?}");
    }
    let part: Vec<[f64; 2]> = wheel().into_iter().filter(|p| p[0] >= 0.0).collect();
    let error = try_read("a.prw", &prw(part), WHEEL).unwrap_err();
    assert!(error.contains("to 58 mm"), "{error}");
    let disc: Vec<[f64; 2]> = (0..80).map(|i| [0.2 * f64::from(i), 0.0]).collect();
    let error = try_read("b.txt", &text(disc, 4), WHEEL).unwrap_err();
    assert!(error.contains("0 to 15.8 mm"), "{error}");
    // From the field side, with the flange at the far end.
    let from_field: Vec<[f64; 2]> = wheel().iter().map(|p| [58.0 - p[0], p[1]]).collect();
    let error = try_read("c.txt", &text(from_field.iter().copied(), 4), WHEEL).unwrap_err();
    assert!(error.contains("0 to 122 mm") && error.contains("which circle"), "{error}");
    let mended = format!("# mirror_y 1\n# shift_y_mm 58\n{}", text(from_field, 4));
    let (mended, expected) =
        (read("d.txt", &mended, WHEEL).bounds(), read("e.txt", &text(wheel(), 4), WHEEL).bounds());
    assert!(
        (mended.y[0] - expected.y[0]).abs() < 1e-6 && (mended.z[1] - expected.z[1]).abs() < 1e-6
    );
}

#[test]
fn what_is_unlikely_is_told_with_its_numbers() {
    let told = |file: &str, points: Vec<[f64; 2]>, kind: ProfileKind| match try_read(
        file,
        &text(points, 4),
        kind,
    ) {
        Ok(profile) => warnings(&profile).join("; "),
        Err(error) => error,
    };
    let shifted = |by: f64| wheel().into_iter().map(|p| [p[0] + by, p[1]]).collect::<Vec<_>>();
    let narrow: Vec<[f64; 2]> = shifted(0.0).into_iter().filter(|p| p[0].abs() < 6.0).collect();
    assert!(told("a.txt", narrow, WHEEL).contains("mm wide"));
    assert!(told("b.txt", shifted(-54.0), WHEEL).contains("at the edge of the wheel"));
    assert!(told("c.txt", shifted(44.0), WHEEL).contains("in the flange"));
    let lower = wheel().into_iter().map(|p| [p[0], p[1] + 30.0]).collect();
    assert!(told("g.txt", lower, WHEEL).contains("z = 30.0 mm at y = 0"));
    let centimetres = wheel().into_iter().map(|p| p.map(|x| 0.1 * x)).collect();
    assert!(told("d.txt", centimetres, WHEEL).contains("12.2 mm wide"));
    let line = (0..60).map(|i| [0.0, 0.5 * f64::from(i)]).collect();
    assert!(told("e.txt", line, RAIL).contains("0.0 mm wide"));
    assert_eq!(told("f.txt", wheel(), WHEEL), "");
}

#[test]
fn fewer_decimals_leave_kinks_of_a_ground_head_where_they_are() {
    // Facets 4 mm wide on a circle of 80 mm, with kinks of 3 degrees.
    let mut facets: Vec<[f64; 2]> =
        (-9..=9).map(|i| 4.0 * f64::from(i)).map(|y| [y, 80.0 - (6400.0 - y * y).sqrt()]).collect();
    facets.insert(0, [-38.0, 30.0]);
    facets.push([38.0, 30.0]);
    let force = |decimals: usize| {
        let folder = TempDir::new().unwrap();
        let content = text(along(&facets, 0.25), decimals);
        fs::write(folder.path().join("ground.txt"), format!("# mirror_z 0\n{content}")).unwrap();
        let mut parameters = plain_parameters("cylindrical", "ground.txt");
        parameters.normal_model = NormalModel::PiotrowskiKik;
        parameters.tangential_model = TangentialModel::None;
        let input = rolling(0.0, 20.0);
        let folders = [folder.path().to_path_buf()];
        let mut element = Element::new(&parameters, &input, &folders).unwrap();
        let input = pressed(&mut element, &input, 6e-5);
        -evaluate(&mut element, &input).wheel.force[2]
    };
    let (exact, rounded) = (force(6), force(3));
    assert!((rounded / exact - 1.0).abs() < 0.05, "{exact} N, with three decimals {rounded} N");
}
