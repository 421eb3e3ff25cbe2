use std::collections::BTreeMap;
use wheelrail::planar::*;
use wheelrail::material::Material;
use wheelrail::tangential::TangentialModel as M;
use wheelrail::tangential::flash_temperature::FlashTemperature;
fn main() {
    let file = std::env::args().nth(1).unwrap();
    let models = std::env::args().nth(2).unwrap_or("marches".into());
    let read = |p: &str| std::fs::read_to_string(p).unwrap();
    let mut seps: BTreeMap<String, Vec<[f64; 2]>> = BTreeMap::new();
    const STEEL: Material = Material { young_modulus: 2.0992e11, poisson_ratio: 0.28 };
    for m in models.split(',') {
        let model = match m { "marches" => M::Marches, "strips" => M::Strips, "corrected" => M::FastsimCorrected, "tables" => M::Tables, _ => panic!() };
        let mut errs = vec![]; let mut moms = vec![]; let mut by: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        for line in read(&file).lines().skip(1) {
            let c: Vec<&str> = line.split(',').collect();
            let v: Vec<f64> = c[1..].iter().map(|x| x.parse().unwrap()).collect();
            let sep = seps.entry(c[0].into()).or_insert_with(|| {
                read(&format!("tests/data/contact_25_1/planar/{}.csv", c[0])).lines().filter(|l| !l.starts_with('#')).skip(1)
                    .map(|l| { let p: Vec<f64> = l.split(',').map(|x| x.parse().unwrap()).collect(); [1e-3 * p[0], 1e-3 * p[1]] }).collect()
            });
            let n = std::env::var("N").ok().map_or(20, |n| n.parse().unwrap());
            let case = PlanarCase { separation: sep, radius: 1e-3 * v[1], indentation: Indentation::Approach(1e-3 * v[0]),
                creepage: [v[2], v[3], 1e3 * v[4]], friction: 0.3, friction_across: &[], wheel_material: STEEL, rail_material: STEEL,
                normal_model: NormalModel::Strips, virtual_penetration: 0.55, shape_fit: ShapeFit::Hertz, tangential_model: model,
                strips: n, elements_along: 20, points: 15, elements: [20, 20], bound: TractionBound::Elliptic,
                flexibilities: Flexibilities::Blended, friction_law: FrictionLaw::default(), gauge_face_law: FrictionLaw::default(),
                flash_temperature: FlashTemperature::default(), speed: 0.0 };
            let r = solve(&case).unwrap();
            let limit = 0.3 * v[8];
            let c2 = (r.area / 3.14159f64).sqrt();
            let e = 100.0 * (r.fx - v[5]).hypot(r.fy - v[6]) / limit;
            errs.push(e);
            if e > 2.5 && std::env::var("W").is_ok() { println!("{} {} xi {:.5} eta {:.5} phi {:.5}/mm: be {:.4} {:.4}  found {:.4} {:.4} patches {} N {:.0}/{:.0}", c[0], v[0], v[2], v[3], v[4], v[5]/limit, v[6]/limit, r.fx/limit, r.fy/limit, r.patches, r.normal_force, v[8]); }
            moms.push(100.0 * (r.mz - 1e-3 * v[7]).abs() / (limit * c2));
            by.entry(format!("{} {}", c[0], c[1])).or_default().push(e);
        }
        let q = |e: &Vec<f64>| { let mut e = e.clone(); e.sort_by(f64::total_cmp); let n = e.len(); format!("{:.3} / {:.2} / {:.2}", e.iter().sum::<f64>() / n as f64, e[(0.95 * (n - 1) as f64) as usize], e[n - 1]) };
        println!("{m}: F {}   Mz {}  of {}", q(&errs), q(&moms), errs.len());
        if std::env::var("V").is_ok() { for (k, e) in by { println!("   {k}: {}", q(&e)); } }
    }
}
