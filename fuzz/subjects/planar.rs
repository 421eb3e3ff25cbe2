//! Planar contact problems of any size and shape.

use arbitrary::{Result, Unstructured};
use wheelrail::element::parameters::{
    FlashTemperature, Flexibilities, FrictionLaw, NormalModel, ShapeFit, TangentialModel,
};
use wheelrail::material::Material;
use wheelrail::planar::{Indentation, PlanarCase, TractionBound, solve};

use super::values::{any, within};

/// The bytes are one case.
pub fn check(data: &[u8]) {
    let mut u = Unstructured::new(data);
    // Bytes that have run out end the run.
    let _ = run(&mut u);
}

fn run(u: &mut Unstructured) -> Result<()> {
    let mut separation = Vec::new();
    let mut y = -0.02;
    for _ in 0..u.int_in_range(3..=60u8)? {
        y += within(u, 2e-3)?.abs();
        separation.push([y, within(u, 1e-3)? + 5.0 * y * y]);
    }
    if u.ratio(1, 8)? {
        let place = u.choose_index(separation.len())?;
        separation[place][u.choose_index(2)?] = any(u)?;
    }
    let size = |u: &mut Unstructured, usual: f64| -> Result<f64> {
        if u.ratio(1, 8)? { any(u) } else { Ok(usual * 10f64.powf(within(u, 1.0)?)) }
    };
    let given = size(u, 1.0)?;
    let material = |u: &mut Unstructured| -> Result<Material> {
        Ok(Material { young_modulus: size(u, 2e11)?, poisson_ratio: within(u, 0.6)?.abs() })
    };
    let case = PlanarCase {
        separation: &separation,
        radius: size(u, 0.46)?,
        indentation: if u.arbitrary()? {
            Indentation::Approach(1e-4 * given)
        } else {
            Indentation::Load(8e4 * given)
        },
        creepage: [size(u, 1e-3)?, size(u, 1e-3)?, size(u, 0.3)?],
        friction: within(u, 2.0)?,
        friction_across: &[],
        wheel_material: material(u)?,
        rail_material: material(u)?,
        normal_model: *u.choose(&[
            NormalModel::Hertz,
            NormalModel::PiotrowskiKik,
            NormalModel::PiotrowskiKikCorrected,
            NormalModel::Strips,
        ])?,
        virtual_penetration: within(u, 1.2)?.abs(),
        shape_fit: *u.choose(&[ShapeFit::Hertz, ShapeFit::Paper])?,
        tangential_model: *u.choose(&[
            TangentialModel::None,
            TangentialModel::Linear,
            TangentialModel::Fastsim,
            TangentialModel::Fastrip,
            TangentialModel::Tables,
            TangentialModel::FastsimCorrected,
            TangentialModel::Marches,
        ])?,
        strips: u.int_in_range(3..=12)?,
        elements_along: u.int_in_range(2..=40)?,
        elements: [8, 8],
        bound: *u.choose(&[TractionBound::Elliptic, TractionBound::Parabolic])?,
        flexibilities: *u.choose(&[Flexibilities::Three, Flexibilities::Blended])?,
        friction_law: FrictionLaw::default(),
        gauge_face_law: FrictionLaw::default(),
        flash_temperature: FlashTemperature::default(),
        speed: 0.0,
    };
    if let Ok(found) = solve(&case) {
        let numbers =
            [found.normal_force, found.max_pressure, found.area, found.fx, found.fy, found.mz];
        assert!(numbers.iter().all(|n| n.is_finite()), "{case:?} gives {found:?}");
        assert!(found.normal_force >= 0.0 && found.area >= 0.0, "{case:?} gives {found:?}");
        if case.tangential_model != TangentialModel::Linear {
            let limit = case.friction * found.normal_force;
            assert!(found.fx.hypot(found.fy) <= limit * (1.0 + 1e-9), "{case:?} gives {found:?}");
        }
    }
    Ok(())
}
