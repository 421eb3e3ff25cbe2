//! By points of the profiles, against elements whose surfaces are displaced.

use super::*;
use wheelrail::geometry::profile::{Profile, ProfileKind};
use wheelrail::io::load_profile;

/// The profiles of an element with these parameters.
fn profiles(parameters: &Parameters) -> [Profile; 2] {
    let load = |name: &str, parameter: &str, kind| load_profile(parameter, name, kind, 0.0, &[]);
    let wheel = load(&parameters.wheel.profile, "wheel.profile", ProfileKind::Wheel).unwrap();
    let rail = load(&parameters.rails[0].profile, "rail[1].profile", ProfileKind::Rail).unwrap();
    [wheel, rail]
}

/// Compares the derivatives by fields of displacement: bumps of some millimetres over all of what is
/// touched, and single points there where these are far enough apart for differences.
fn compare(name: &str, parameters: &Parameters, has_singles: bool) {
    let bodies = profiles(parameters);
    let input = pose(parameters, &mut Random::new(43));
    let made = |ways: [&[f64]; 2]| {
        let [wheel, rail] = [0, 1].map(|body| {
            if ways[body].is_empty() {
                bodies[body].clone()
            } else {
                bodies[body].displaced(ways[body])
            }
        });
        let rails = [Some(rail), None];
        Element::with_profiles(parameters, &Input::default(), &wheel, &rails).unwrap()
    };
    let mut own = made([&[], &[]]);
    let about = evaluate(&mut own, &input);
    let weights = weights(&mut Random::new(5), &about);
    let mut gradient = Gradient::default();
    own.adjoint_derivative(&input, &weights, &mut gradient).unwrap();
    let mut worst = 0.0_f64;
    for (body, by) in [&gradient.wheel_points, &gradient.rail_points[0]].into_iter().enumerate() {
        let points = bodies[body].points();
        assert_eq!(by.len(), points.len());
        assert!(by.iter().any(|by| *by != 0.0));
        let mut fields: Vec<Vec<f64>> = Vec::new();
        for n in [0, 1, 2] {
            let place = points[at_share(by, 0.2 + 0.3 * f64::from(n))];
            for width in [4e-3, 1.5e-3_f64] {
                fields.push(
                    points
                        .iter()
                        .map(|p| {
                            let away = (p[0] - place[0]).hypot(p[1] - place[1]) / width;
                            (-away * away).exp()
                        })
                        .collect(),
                );
            }
            let single =
                |i: usize| f64::from(u8::from(i == at_share(by, 0.2 + 0.3 * f64::from(n))));
            if has_singles {
                fields.push((0..points.len()).map(single).collect());
            }
        }
        let product = |field: &[f64]| -> f64 { field.iter().zip(by).map(|(f, by)| f * by).sum() };
        let most = fields.iter().map(|field| product(field).abs()).fold(0.0, f64::max);
        for (n, field) in fields.iter().enumerate() {
            // Of a single point the curvature is some 1e7 times the displacement.
            let step = if has_singles && n % 3 == 2 { 1e-9 } else { 2e-8 };
            let both = difference(step, |way| {
                let ways: Vec<f64> = field.iter().map(|f| f * way).collect();
                let ways: [&[f64]; 2] = if body == 0 { [&ways, &[]] } else { [&[], &ways] };
                sum_of(&mut made(ways), &input, &weights)
            });
            let errors = both.map(|difference| (difference - product(field)).abs() / most);
            println!("{name} body {body} field {n}: {:e}, off by {errors:?}", product(field));
            worst = worst.max(errors[0].min(errors[1]));
        }
    }
    assert!(worst < tolerance::BACKWARDS_DIFFERENCES, "{name}: {worst:e}");
}

/// The point up to which this share of all magnitudes is.
fn at_share(by: &[f64], share: f64) -> usize {
    let all: f64 = by.iter().map(|by| by.abs()).sum();
    let mut sum = 0.0;
    let found = by.iter().position(|by| {
        sum += by.abs();
        sum >= share * all
    });
    found.unwrap_or(0)
}

#[test]
fn of_built_in_profiles() {
    let tangential_model = TangentialModel::Tables;
    for normal_model in [NormalModel::Strips, NormalModel::PiotrowskiKik] {
        let parameters = Parameters { tangential_model, normal_model, ..Parameters::default() };
        compare(&format!("{normal_model:?}"), &parameters, false);
        compare(&format!("{normal_model:?}, left"), &parameters.on_side(Side::Left), false);
    }
    let vertical_mode = VerticalMode::Load;
    let normal_model = NormalModel::PiotrowskiKik;
    compare("load", &Parameters { vertical_mode, normal_model, ..Parameters::default() }, false);
    let mut mirrored = Parameters { tangential_model, normal_model, ..Parameters::default() };
    mirrored.rails[0].mirrored = true;
    mirrored.wheel.profile = "S1002".into();
    compare("mirrored", &mirrored, false);
}

#[test]
fn of_profiles_from_files() {
    let folder = tempfile::TempDir::new().unwrap();
    let mut parameters = Parameters {
        tangential_model: TangentialModel::Tables,
        normal_model: NormalModel::PiotrowskiKik,
        profile_smoothing: 0.0,
        ..Parameters::default()
    };
    let names = [("S1002", ProfileKind::Wheel), ("60E1", ProfileKind::Rail)];
    for (n, (name, kind)) in names.into_iter().enumerate() {
        let curve = load_profile("profile", name, kind, 0.0, &[]).unwrap().curve;
        let rows: Vec<String> = (0..=300)
            .map(|i| {
                let share = f64::from(i) / 300.0;
                let [y, z] = curve.at(curve.start() + share * (curve.end() - curve.start())).point;
                format!("{} {}", 1e3 * y, 1e3 * z)
            })
            .collect();
        let path = folder.path().join(format!("{name}.txt"));
        std::fs::write(&path, rows.join("\n")).unwrap();
        let path = path.to_str().unwrap().to_owned();
        if n == 0 {
            parameters.wheel.profile = path;
        } else {
            parameters.rails[0].profile = path;
        }
    }
    compare("files", &parameters, true);
}

#[test]
fn an_element_is_made_with_displaced_points_and_refuses_other_numbers() {
    let parameters = Parameters::default();
    let start = Input::default();
    let [wheel, rail] = profiles(&parameters);
    let ways = vec![1e-5; wheel.points().len()];
    let made = |wheel: &[f64], rail: &[f64]| {
        Element::displaced(&parameters, &start, &[], wheel, &[rail, &[]])
    };
    let lower = made(&ways, &[]).unwrap().nominal_wheel_z();
    let plain = made(&[], &[]).unwrap().nominal_wheel_z();
    // A wheel that is thicker all around stands higher.
    approx::assert_abs_diff_eq!(plain - lower, 1e-5, epsilon = 1e-8);
    let ways = vec![-1e-5; rail.points().len()];
    let worn = made(&[], &ways).unwrap();
    // The rail is placed anew by its top, and by its gauge face, which is a little elsewhere.
    approx::assert_abs_diff_eq!(worn.nominal_wheel_z(), plain, epsilon = 1e-6);
    let refusal = made(&[0.0], &[]).unwrap_err().to_string();
    assert!(refusal.contains("displacements of wheel.profile = 1"), "{refusal}");
    let refusal = made(&[], &[&ways[1..], &[f64::NAN]].concat()).unwrap_err().to_string();
    assert!(refusal.contains("a displacement = NaN"), "{refusal}");
}
