use wheelrail::planar::*;
use wheelrail::material::{Material, MaterialPair};
use wheelrail::normal::hertz;
use wheelrail::tangential::TangentialModel as M;
use wheelrail::tangential::flash_temperature::FlashTemperature;
use wheelrail::tangential::kalker_coefficients::kalker_coefficients;
fn main() {
    const STEEL: Material = Material { young_modulus: 2.0992e11, poisson_ratio: 0.28 };
    let modulus = MaterialPair::new(STEEL, STEEL).contact_modulus;
    for ratio in [0.1, 0.3, 1.0, 3.0, 10.0] {
        let c: f64 = 5e-3; let (a, b) = (c * f64::sqrt(ratio), c / f64::sqrt(ratio)); let load = 8e4;
        let (mut low, mut high) = (1e-6f64, 1e6f64);
        for _ in 0..200 { let r = (low * high).sqrt(); let e = hertz::ellipse(1.0, r, 1e-4, 1e11); if e.semi_axis_along / e.semi_axis_across < a / b { low = r } else { high = r } }
        let r = (low * high).sqrt(); let unit = hertz::ellipse(1.0, r, 1e-4, modulus);
        let along = (load / a.powi(3)) / (unit.load / unit.semi_axis_along.powi(3)); let across = r * along;
        let sep: Vec<[f64; 2]> = (-50..=50).map(|i| 0.04 * f64::from(i) * b).map(|y| [y, across * y * y]).collect();
        for (m, n) in [(M::Marches, 20), (M::Marches, 24), (M::Marches, 40), (M::Tables, 20), (M::Strips, 20)] {
            let run = |creepage| { let case = PlanarCase { separation: &sep, radius: 0.5 / along, indentation: Indentation::Load(load),
                creepage, friction: 0.3, friction_across: &[], wheel_material: STEEL, rail_material: STEEL,
                normal_model: NormalModel::Strips, virtual_penetration: 0.55, shape_fit: ShapeFit::Hertz, tangential_model: m,
                strips: n, elements_along: 20, points: 15, elements: [20, 20], bound: TractionBound::Elliptic,
                flexibilities: Flexibilities::Blended, friction_law: FrictionLaw::default(), gauge_face_law: FrictionLaw::default(),
                flash_temperature: FlashTemperature::default(), speed: 0.0 }; solve(&case).unwrap() };
            let s = 1e-9; let k = kalker_coefficients(ratio, 0.28); let sc = -82e9 * c * c * s;
            let (x, y, p) = (run([s, 0.0, 0.0]), run([0.0, s, 0.0]), run([0.0, 0.0, s / c]));
            println!("{ratio} {m:?} {n}: {:.4} {:.4} {:.4} {:.4}   area {:.4} length {:.4} width {:.4}", x.fx / sc / k.c11, y.fy / sc / k.c22, p.fy / sc / k.c23, p.mz / (sc * c) / k.c33, x.area / (3.14159265 * a * b), x.length / 2.0 / a, x.width / 2.0 / b);
        }
    }
}
