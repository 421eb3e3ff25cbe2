//! A crossing of narrow rails.

use super::*;

/// Half the width of the crowns of wing and nose [mm].
const HALF: f64 = 12.0;

/// Points of a crown of radius 300 mm, [`HALF`] to either side of `y`, at height `z` [mm].
fn narrow([y, z]: [f64; 2]) -> Vec<[f64; 2]> {
    let angles = (-24..=24).map(|i| HALF / 24.0 * f64::from(i) / 300.0);
    angles.map(|a: f64| [300.0 * a.sin() + y, 300.0 * (1.0 - a.cos()) + z]).collect()
}

fn text(points: &[[f64; 2]]) -> String {
    // A section with a groove does not tell by its shape how it stands.
    points
        .iter()
        .fold(String::from("# mirror_z 0\n"), |text, [y, z]| text + &format!("{y:.9} {z:.9}\n"))
}

/// A wing that runs off to the track side beside a nose that rises and begins at -50 mm: in files
/// of their own, and as one rail with three parts, the groove between them among them.
pub fn crossing() -> TempDir {
    let folder = TempDir::new().unwrap();
    let wing_at = |s: f64| [-16.0 - 0.03 * s, 0.3 + 1e-3 * s];
    let nose_at = |s: f64| [18.0, 0.3 - 6e-3 * s];
    let places: Vec<f64> = (-15..=15).map(|i| 10.0 * f64::from(i)).collect();
    let (mut wing, mut nose, mut one, mut features) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let arc = |points: &[[f64; 2]]| {
        points.windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).sum::<f64>()
    };
    let write = |name: &str, points: &[[f64; 2]]| {
        fs::write(folder.path().join(name), text(points)).unwrap();
    };
    for (i, s) in places.iter().enumerate() {
        let (a, b) = (narrow(wing_at(*s)), narrow(nose_at(*s)));
        write(&format!("wing{i}.txt"), &a);
        wing.push(format!("{s} 'wing{i}.txt'"));
        if *s < -50.0 {
            one.push(format!("{s} 'wing{i}.txt'"));
            features.push(format!("{s} 0 {:.6} -1 -1", arc(&a)));
            continue;
        }
        write(&format!("nose{i}.txt"), &b);
        nose.push(format!("{s} 'nose{i}.txt'"));
        // A groove 20 mm deep between them.
        let (from, to) = (a[a.len() - 1], b[0]);
        let groove: Vec<[f64; 2]> = (1..40)
            .map(|k| {
                let share = f64::from(k) / 40.0;
                let [y, z] = [0, 1].map(|c| from[c] + share * (to[c] - from[c]));
                [y, z + 20.0 * (std::f64::consts::PI * share).sin()]
            })
            .collect();
        let all = [a.clone(), groove, b.clone()].concat();
        write(&format!("both{i}.txt"), &all);
        one.push(format!("{s} 'both{i}.txt'"));
        let whole = arc(&all);
        let ends = [0.0, arc(&a), whole - arc(&b), whole].map(|length| format!("{length:.6}"));
        features.push(format!("{s} {}", ends.join(" ")));
    }
    let list = |name: &str, slices: &[String], features: &[String], count: usize| {
        let parts = [slices, features].concat().join("\n");
        let text = format!("0 1\n{}\n{count} 0 0\n1\n{parts}\n", slices.len());
        fs::write(folder.path().join(name), text).unwrap();
    };
    list("wing.slcs", &wing, &[], 0);
    list("nose.slcs", &nose, &[], 0);
    list("rail.slcs", &one, &features, 4);
    folder
}
