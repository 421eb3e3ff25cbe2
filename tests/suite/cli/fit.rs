//! `wheelrail fit`: laws that synthetic curves were made with come back, and what data leave open
//! is said.

use super::*;
use crate::common::summary::Summary;
use wheelrail::element::Parameters;
use wheelrail::element::parameters::{FallingLaw, FrictionLaw, NormalModel, TangentialModel};
use wheelrail::planar::{Indentation, PressedContact};

/// The example of Spiryagin, Polach and Cole (2013) with friction of Polach (2005).
const LAW: FrictionLaw = FrictionLaw {
    falling_law: FallingLaw::Exponential,
    falling_share: 0.38,
    falling_decay: 0.7,
    reduction: 0.54,
    reduction_share: 0.02,
    reduction_decay: 0.64,
};
const FRICTION: f64 = 0.36;

/// Points of curves under `law` at these creepages, loads and speeds, with errors of `noise` to
/// either side.
fn curves(law: &FrictionLaw, creepages: &[f64], speeds: &[f64], noise: f64) -> String {
    let parameters = Parameters {
        normal_model: NormalModel::Hertz,
        tangential_model: TangentialModel::Tables,
        ..Parameters::default()
    };
    let separation: Vec<[f64; 2]> =
        (-100..=100).map(|i| 9e-4 * f64::from(i)).map(|y| [y, y * y / 0.6]).collect();
    let mut text = String::from("# made\ncreepage_longitudinal,adhesion,load_n,speed_m_s\n");
    for load in [4e4, 8e4] {
        let load_given = Indentation::Load(load);
        let case = parameters.planar_case(&separation, 0.46, load_given, [0.0; 3], 0.3);
        let contact = PressedContact::new(&case).unwrap();
        for speed in speeds {
            for (i, creepage) in creepages.iter().enumerate() {
                let (adhesion, _) = contact.adhesion([*creepage, 0.0, 0.0], *speed, FRICTION, law);
                let error = if i % 2 == 0 { noise } else { -noise };
                text += &format!("{creepage},{},{load},{speed}\n", adhesion + error);
            }
        }
    }
    text
}

const WIDE: [f64; 14] =
    [3e-4, 7e-4, 1.2e-3, 2e-3, 3e-3, 4.5e-3, 7e-3, 0.01, 0.015, 0.025, 0.04, 0.07, 0.12, 0.2];

fn said(arguments: &[&str]) -> String {
    let tables = ["--set", "tangential.model=tables"];
    let output = wheelrail(&[&["fit"], arguments, &tables].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// Value and standard error of a parameter, and what else is said of it.
fn found(text: &str, name: &str) -> ([f64; 2], String) {
    let line = text.lines().find(|line| line.starts_with(&format!("{name}="))).unwrap();
    let (value, rest) = line[name.len() + 1..].split_once(" +- ").unwrap();
    let (error, rest) = rest.split_once(',').unwrap_or((rest, ""));
    ([value.parse().unwrap(), error.parse().unwrap()], rest.trim().into())
}

#[test]
fn a_law_comes_back_from_its_curves() {
    for (falling_law, name) in [
        (FallingLaw::Exponential, "exponential"),
        (FallingLaw::Rational, "rational"),
        (FallingLaw::Linear, "linear"),
    ] {
        let law = FrictionLaw { falling_law, ..LAW };
        let (_folder, path) = written(&curves(&law, &WIDE, &[5.0, 15.0], 0.0));
        let setting = format!("friction.falling.law={name}");
        let text = said(&[&path, "--set", &setting]);
        for (parameter, expected) in [
            ("friction.coefficient", FRICTION),
            ("friction.falling.share", 0.38),
            ("friction.falling.decay", 0.7),
            ("friction.reduction.initial", 0.54),
            ("friction.reduction.share", 0.02),
            ("friction.reduction.decay", 0.64),
        ] {
            let ([value, _], rest) = found(&text, parameter);
            assert!((value / expected - 1.0).abs() < 1e-3, "{name}\n{text}");
            assert_eq!(rest, "", "{text}");
        }
    }
}

/// The bodies of the published curves.
const EUROSPRINTER: [&str; 8] = [
    "--radius-along",
    "0.625",
    "--radius-across",
    "1.777",
    "--set",
    "wheel.young_modulus=2.0992e11",
    "--set",
    "rail.young_modulus=2.0992e11",
];

/// What is said of the fit to a published curve, and by how much it misses each point.
fn fitted(name: &str, settings: &[&str]) -> (String, Vec<f64>) {
    let points = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/creep_curves").join(name);
    let folder = TempDir::new().unwrap();
    let result = folder.path().join("fit.csv");
    let [points, result] = [&points, &result].map(|path| path.to_str().unwrap());
    let arguments = [&["fit", points, "-o", result], &EUROSPRINTER[..], settings].concat();
    let output = wheelrail(&arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let rows = table(&std::fs::read(result).unwrap());
    let misfits = rows.iter().map(|row| number(row, "misfit")).collect();
    (String::from_utf8(output.stdout).unwrap(), misfits)
}

#[test]
fn published_curves_give_their_parameters() {
    let mut summary = Summary::new("creep_curves");
    let friction = [
        ("friction.coefficient", 0.36),
        ("friction.falling.share", 0.38),
        ("friction.falling.decay", 0.7),
    ];
    let reduction = [
        ("friction.reduction.initial", 0.54),
        ("friction.reduction.share", 0.02),
        ("friction.reduction.decay", 0.64),
    ];
    // As the source has it: simplified theory with a parabolic bound, on enough elements.
    let simplified: Vec<&str> = [
        "tangential.model=fastsim",
        "tangential.bound=parabolic",
        "tangential.flexibilities=three",
        "tangential.elements_along=100",
        "normal.strips=60",
    ]
    .into_iter()
    .flat_map(|setting| ["--set", setting])
    .collect();
    let off = |text: &str, (name, published): (&str, f64)| found(text, name).0[0] / published - 1.0;
    let percent = |errors: &[f64]| errors.iter().map(|error| 100.0 * error).collect::<Vec<_>>();
    let (text, _) = fitted("spiryagin_2013.csv", &simplified);
    let own: Vec<f64> = friction.iter().chain(&reduction).map(|own| off(&text, *own)).collect();
    summary.add("Spiryagin, all six parameters, models of the source [%]", percent(&own), "0.1");
    assert!(own.iter().all(|error| error.abs() <= 1e-3), "{text}");
    // With better models the slope is another one.
    let (text, misfits) = fitted("spiryagin_2013.csv", &[]);
    let own = friction.map(|own| off(&text, own));
    summary.add("the same, friction and its fall, default models [%]", percent(&own), "");
    summary.add("the same, adhesion [% of the load]", percent(&misfits), "1 (rms)");
    for (name, friction) in [("dry", [0.55, 0.4, 0.6]), ("wet", [0.3, 0.4, 0.2])] {
        let (text, misfits) = fitted(&format!("polach_2005_{name}.csv"), &[]);
        summary.add(
            &format!("Polach, {name}, adhesion [% of the load]"),
            percent(&misfits),
            "1 (rms)",
        );
        let squares: f64 = misfits.iter().map(|misfit| misfit * misfit).sum();
        // Adhesion on rails is hardly measured within a hundredth of the load.
        assert!((squares / misfits.len() as f64).sqrt() <= 0.01, "{text}");
        let names = ["friction.coefficient", "friction.falling.share", "friction.falling.decay"];
        for (name, published) in names.into_iter().zip(friction) {
            let ([value, error], _) = found(&text, name);
            assert!((value - published).abs() <= 3.0 * error, "{name} {published}\n{text}");
        }
    }
    summary.write();
}

#[test]
fn what_the_data_do_not_determine_is_said() {
    // Errors of 1 % of the normal force; nothing that slides.
    let (_folder, path) = written(&curves(&LAW, &WIDE[..6], &[5.0], 0.003));
    let text = said(&[&path]);
    let open = |name: &str| found(&text, name).1.contains("not determined by the data");
    assert!(open("friction.falling.share") && open("friction.falling.decay"), "{text}");
    // With what is known from elsewhere the rest is.
    let fixed = ["--set", "friction.falling.share=0.38", "--set", "friction.falling.decay=0.7"];
    let more = ["--set", "friction.reduction.share=0.02", "--set", "friction.reduction.decay=0.64"];
    let names = ["--parameters", "friction.coefficient,friction.reduction.initial"];
    let text = said(&[&[path.as_str()], &fixed[..], &more[..], &names[..]].concat());
    for (parameter, expected) in
        [("friction.coefficient", FRICTION), ("friction.reduction.initial", 0.54)]
    {
        let ([value, error], rest) = found(&text, parameter);
        assert!(rest.is_empty() && (value - expected).abs() < 3.0 * error + 0.01, "{text}");
    }
}

#[test]
fn table_and_figure_hold_points_and_fit() {
    let (folder, path) = written(&curves(&LAW, &WIDE, &[10.0], 0.002));
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (fit, figure) = (file("fit.csv"), file("fit.svg"));
    said(&[&path, "-o", &fit, "--figure", &figure]);
    let rows = table(&std::fs::read(&fit).unwrap());
    assert_eq!(rows.len(), 2 * WIDE.len());
    for row in &rows {
        let misfit = number(row, "fitted") - number(row, "adhesion");
        assert!(misfit.abs() < 5e-3 && (misfit - number(row, "misfit")).abs() < 1e-12);
    }
    let figure = std::fs::read_to_string(&figure).unwrap();
    assert!(figure.contains("80.0 kN, 10.0 m/s") && figure.contains("Creepage"));
}

#[test]
fn tables_and_options_that_say_nothing_are_refused() {
    for (text, words) in [
        ("creepage,adhesion\n0.1,0.2\n", "column \"creepage\": unknown; known columns are"),
        ("creepage_longitudinal,adhesion,load_n\n0.1,0.2,1\n", "speed_m_s is missing"),
        (
            "creepage_longitudinal,adhesion,load_n,speed_m_s\n0.1,x,1e4,5\n",
            "column \"adhesion\": \"x\" is not a finite number",
        ),
        (
            "creepage_longitudinal,adhesion,load_n,speed_m_s\n0.1,-0.2,1e4,5\n",
            "have to have the same sign",
        ),
        (
            "creepage_longitudinal,adhesion,load_n,speed_m_s\n0.1,0.2,0,5\n",
            "load_n = 0 has to be above 0",
        ),
        (
            "creepage_longitudinal,adhesion,load_n,speed_m_s\n0.1,0.2,1e4,5\n",
            "1 points do not determine 6 parameters; name fewer in --parameters",
        ),
    ] {
        let (_folder, path) = written(text);
        let message = failure(&["fit", &path]);
        assert!(message.contains(words), "{message}");
    }
    let (_folder, path) =
        written("creepage_longitudinal,adhesion,load_n,speed_m_s\n0.1,0.2,1e4,5\n");
    for (options, words) in [
        (["--parameters", "friction"], "it has to be one of friction.coefficient"),
        (["--radius-across", "0"], "a radius from 0.001 to 1000 m"),
        (["--set", "friction.fall=1"], "there is no variable \"friction.fall\""),
        (["--set", "tangential.model=boundary_element"], "no derivatives with tangential.model"),
    ] {
        let message = failure(&["fit", &path, options[0], options[1]]);
        assert!(message.contains(words), "{message}");
    }
}
