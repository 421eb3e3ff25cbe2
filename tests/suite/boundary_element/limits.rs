//! Closed forms and exact coefficients: Hertz, Kalker, Carter, Cattaneo.

use super::*;

#[test]
fn hertz_is_met_from_slender_to_wide_ellipses() {
    let rows = HertzRow::all();
    let mut report = String::from("axis_ratio,load,max_pressure,area\n");
    for row in rows.iter().step_by(5) {
        let separation = row.separation();
        let case = boundary_case(&separation, 0.5 / row.along, row.approach, 60);
        let found = solve(&case).unwrap();
        let errors = [
            found.normal_force / row.load - 1.0,
            found.max_pressure / row.max_pressure - 1.0,
            found.area / row.area - 1.0,
        ];
        writeln!(report, "{},{:.5},{:.5},{:.5}", row.axis_ratio, errors[0], errors[1], errors[2])
            .unwrap();
        for (error, bound) in errors.into_iter().zip(tolerance::BOUNDARY_HERTZ) {
            assert!(error.abs() <= bound, "{report}");
        }
        assert!(!found.fallback);
    }
    common::write_report("boundary_hertz.csv", &report);
}

/// Kalker's c11, c22 and c23 = -c32 by full adhesion: the straight line through the results of
/// several grids of about `counts` elements along and across, continued to elements without size.
fn kalker_coefficients(a_over_b: f64, counts: &[usize]) -> [f64; 3] {
    let (a, b) = (5e-3 * a_over_b.sqrt(), 5e-3 / a_over_b.sqrt());
    let material = Material { young_modulus: 2.5, poisson_ratio: 0.25 };
    let pair = MaterialPair::new(material, material);
    let shear = pair.shear_modulus;
    let at = |count: usize| {
        // Elements less slender than the ellipse.
        let stretch = a_over_b.powf(0.25);
        let elements = [count as f64 * stretch, count as f64 / stretch].map(|n| n.round() as usize);
        let grid = Grid::over([-a, a], [-b, b], elements[0], elements[1]);
        // Friction beyond all bounds.
        let bound = grid.sample(|x, y| {
            let inside = (x / a).powi(2) + (y / b).powi(2) < 1.0;
            if inside { 100.0 } else { 0.0 }
        });
        // Squares have another area than the ellipse: the coefficients are those of one with
        // theirs.
        let count = bound.iter().filter(|&&g| g > 0.0).count();
        let area = count as f64 * grid.element_area() / PI;
        let spin = 1.0 / area.sqrt();
        let solve = |creepage| {
            let found = steady_rolling(&grid, &pair, &bound, &rigid_slip(&grid, creepage));
            assert!(found.converged);
            force(&grid, &found).map(|f| -f / (shear * area))
        };
        [solve([1.0, 0.0, 0.0])[0], solve([0.0, 1.0, 0.0])[1], solve([0.0, 0.0, spin])[1]]
    };
    let sizes: Vec<f64> = counts.iter().map(|&count| 1.0 / count as f64).collect();
    let found: Vec<[f64; 3]> = counts.iter().map(|&count| at(count)).collect();
    let mean = |values: &mut dyn Iterator<Item = f64>| values.sum::<f64>() / counts.len() as f64;
    let size = mean(&mut sizes.iter().copied());
    let spread = mean(&mut sizes.iter().map(|h| (h - size).powi(2)));
    [0, 1, 2].map(|c| {
        let value = mean(&mut found.iter().map(|f| f[c]));
        let moment = mean(&mut sizes.iter().zip(&found).map(|(h, f)| (h - size) * (f[c] - value)));
        value - moment / spread * size
    })
}

fn check_kalker(ratios: &[f64], counts: &[usize], name: &str) {
    let table = read_table("kalker_coefficients.csv");
    let mut report = String::from("a_over_b,c11,c22,c23\n");
    let mut worst = 0.0f64;
    for &ratio in ratios {
        let found = kalker_coefficients(ratio, counts);
        let row = table.rows.iter().find(|row| {
            (value(&table, row, "a_over_b") / ratio - 1.0).abs() < 1e-6
                && (value(&table, row, "poisson_ratio") - 0.25).abs() < 1e-9
        });
        let row = row.unwrap_or_else(|| panic!("no row a/b = {ratio}"));
        let errors =
            [0, 1, 2].map(|c| found[c] / value(&table, row, ["c11", "c22", "c23"][c]) - 1.0);
        writeln!(report, "{ratio},{:.4},{:.4},{:.4}", errors[0], errors[1], errors[2]).unwrap();
        worst = errors.iter().fold(worst, |worst, e| worst.max(e.abs()));
    }
    assert!(worst <= tolerance::BOUNDARY_KALKER, "{report}");
    common::write_report(name, &report);
}

#[test]
fn small_creepages_give_kalkers_coefficients() {
    check_kalker(&[1.0], &[12, 14, 16, 18, 20, 22, 24], "boundary_kalker_round.csv");
}

#[test]
#[ignore = "the whole set: a minute in release builds"]
fn small_creepages_give_kalkers_coefficients_from_slender_to_wide() {
    let counts = [24, 27, 30, 34, 38, 42, 46, 50, 54, 60];
    check_kalker(&[0.2, 0.5, 1.0, 2.0, 5.0], &counts, "boundary_kalker.csv");
}

/// Carter: an endless cylinder of half width `a` = 1 with Hertzian pressure; share of the friction
/// limit at creepage `share` of that of full sliding, by `count` elements along a row as wide as
/// long cylinders are.
fn carter_force(share: f64, count: usize) -> f64 {
    let material = Material { young_modulus: 2.6, poisson_ratio: 0.3 };
    let pair = MaterialPair::new(material, material);
    let (a, p0, friction) = (1.0, 1e-3, 0.3);
    // Elements fill the contact exactly: their bound is its mean over each.
    let grid = Grid::over([-a, a], [-5e4, 5e4], count, 1);
    let integral = |t: f64| 0.5 * (t * (1.0 - t * t).max(0.0).sqrt() + t.asin());
    let bound = grid.sample(|x, _| {
        let half = 0.5 * grid.dx;
        friction * p0 * (integral((x + half).min(1.0)) - integral((x - half).max(-1.0))) / grid.dx
    });
    // Full sliding begins at ξ = μ a/R with p0 = E* a/(2 R).
    let sliding = friction * 2.0 * p0 / pair.contact_modulus;
    let rigid = vec![[share * sliding, 0.0]; count];
    let found = steady_rolling(&grid, &pair, &bound, &rigid);
    assert!(found.converged);
    -found.x.iter().sum::<f64>() / bound.iter().sum::<f64>()
}

#[test]
fn carter_is_approached_with_an_order() {
    let mut report = String::from("creepage_share,elements,error\n");
    for share in [0.2f64, 0.5, 0.8] {
        // F/(μN) = 1 - (1 - ξ/ξ_s)².
        let exact = 1.0 - (1.0 - share).powi(2);
        let errors = [16, 32, 64, 128].map(|count| {
            let error = (carter_force(share, count) - exact).abs();
            writeln!(report, "{share},{count},{error:.6}").unwrap();
            error
        });
        assert!(errors[3] <= tolerance::BOUNDARY_CARTER, "{report}");
        let order = (errors[0] / errors[3]).log2() / 3.0;
        assert!(order >= tolerance::BOUNDARY_CARTER_ORDER, "order {order}\n{report}");
    }
    common::write_report("boundary_carter.csv", &report);
}

#[test]
fn cattaneo_is_approached_with_an_order() {
    // ν = 0 leaves no lateral displacement, as the closed form does.
    let material = Material { young_modulus: 2.0, poisson_ratio: 0.0 };
    let pair = MaterialPair::new(material, material);
    let (a, friction) = (1.0, 0.3);
    let p0 = 1e-3;
    let load = 2.0 / 3.0 * PI * p0 * a * a;
    let share: f64 = 0.6;
    // Johnson (7.42): δ = 3 μ P (2 - ν)/(16 a G) (1 - (1 - Q/(μ P))^(2/3)) for each body; Q = share
    // μ P.
    let shift_by = 3.0 * friction * load / (16.0 * a * pair.shear_modulus)
        * 4.0
        * (1.0 - (1.0 - share).powf(2.0 / 3.0));
    let mut report = String::from("elements,force,stick_radius\n");
    let mut errors = Vec::new();
    for count in [8, 16, 32] {
        let grid = Grid::over([-a, a], [-a, a], count, count);
        let bound = grid.sample(|x, y| friction * p0 * (1.0 - x * x - y * y).max(0.0).sqrt());
        let scale = friction * load / (bound.iter().sum::<f64>() * grid.element_area());
        let bound: Vec<f64> = bound.iter().map(|g| g * scale).collect();
        let found = shift(&grid, &pair, &bound, [shift_by, 0.0], None);
        assert!(found.converged);
        let force = -force(&grid, &found)[0] / (friction * load);
        let sticking = (0..grid.len()).filter(|&k| bound[k] > 0.0 && !found.slips[k]).count();
        let radius = (sticking as f64 * grid.element_area() / PI).sqrt();
        writeln!(report, "{count},{force:.5},{radius:.4}").unwrap();
        errors.push((force - share).abs());
        let exact = (1.0 - share).cbrt();
        assert!((radius - exact).abs() <= 2.0 * grid.dx, "{exact}\n{report}");
    }
    common::write_report("boundary_cattaneo.csv", &report);
    assert!(errors[2] <= tolerance::BOUNDARY_CATTANEO, "{report}");
    let order = (errors[0] / errors[2]).log2() / 2.0;
    assert!(order >= tolerance::BOUNDARY_CATTANEO_ORDER, "order {order}\n{report}");
}
