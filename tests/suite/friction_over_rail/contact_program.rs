//! Friction over the rail against CONTACT and against boundary elements.

use super::*;

/// Force on the rail within the plane of the reference [N].
fn in_plane(output: &Output, angle: f64) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    let [x, y, z] = output.rails[0].force;
    [x, y * cosine + z * sine]
}

/// An element of the reference's bodies and of `base` with each of its tables.
fn with_reference_tables(folder: &TempDir, base: &Parameters) -> Vec<Element> {
    let elements = FRICTION_TABLES.iter().enumerate().map(|(i, text)| {
        let file = folder.path().join(format!("{i}.csv"));
        std::fs::write(&file, text).unwrap();
        benchmark(with_table(file.to_str().unwrap(), base.clone()))
    });
    elements.collect()
}

#[test]
fn friction_by_inclination_is_that_of_the_contact_program() {
    let table = read_table("contact_25_1/friction_by_inclination.csv");
    let folder = TempDir::new().unwrap();
    let base = Parameters {
        vertical_mode: VerticalMode::Load,
        // One plane for each contact, as the reference has it.
        creepage_model: CreepageModel::Flat,
        ..Parameters::default()
    };
    let mut even = benchmark(base.clone());
    let mut own = with_reference_tables(&folder, &base);
    let mut report = String::from("id,angle_deg,error_constant,error_table,friction_off\n");
    // Errors over the friction limit with one coefficient and with the table, and by how much the
    // mean over the load of the table differs from the one coefficient, which is that of the
    // inclination of the plane.
    let mut found: Vec<[f64; 3]> = Vec::new();
    for row in &table.rows {
        let v = |name: &str| value(&table, row, name);
        let input = Input { friction: v("p1_friction"), ..of_wheelset(&v) };
        let angle = v("p1_angle_rad");
        let (sine, cosine) = angle.sin_cos();
        let expected = [v("fx_rail_N"), v("fy_rail_N") * cosine + v("fz_rail_total_N") * sine];
        let limit = v("p1_friction") * v("p1_N_N");
        let missed = |output: &Output| {
            let found = in_plane(output, angle);
            (found[0] - expected[0]).hypot(found[1] - expected[1]) / limit
        };
        let constant = missed(&evaluate(&mut even, &input));
        let output = evaluate(&mut own[v("friction_table") as usize - 1], &input);
        let varying = missed(&output);
        let load: f64 = output.patches.iter().map(|patch| patch.normal_force).sum();
        let left = output.patches.iter().map(|p| p.friction_coefficient * p.normal_force);
        let off = (left.sum::<f64>() / load / v("p1_friction") - 1.0).abs();
        let degrees = angle.to_degrees();
        writeln!(report, "{},{degrees:.2},{constant:.4},{varying:.4},{off:.4}", &row[0]).unwrap();
        found.push([constant, varying, off]);
    }
    write_report("friction_by_inclination.csv", &report);
    let column = |k: usize| found.iter().map(|own| own[k]).collect::<Vec<f64>>();
    let benchmark_states = found.len() - 2..found.len();
    let percent = |errors: &[f64]| errors.iter().map(|error| 100.0 * error).collect::<Vec<f64>>();
    let mut summary = Summary::new("friction_by_inclination");
    for (name, k, aim) in [
        ("force, one coefficient for each patch [% of the friction limit]", 0, ""),
        ("force, a coefficient for each strip", 1, "one coefficient"),
        ("mean coefficient of the strips against that of the plane [%]", 2, ""),
    ] {
        summary.add(name, percent(&column(k)), aim);
    }
    for (name, k) in [("one coefficient for each patch", 0), ("a coefficient for each strip", 1)] {
        let own = percent(&column(k)[benchmark_states.clone()]);
        summary.add(&format!("force, Manchester benchmark A-2.2, {name}"), own, "");
    }
    summary.write();
    // No worse than with one coefficient but for what the coefficients themselves differ by, within
    // what the models are off by in the median.
    let [median, _] = median_and_worst(column(0));
    for ([constant, varying, off], row) in found.iter().zip(&table.rows) {
        assert!(*varying <= constant + off + median, "{}: {varying} {constant} {off}", &row[0]);
    }
    let [own_median, _] = median_and_worst(column(1));
    let with_off = found.iter().map(|[constant, _, off]| constant + off);
    let [allowed, _] = median_and_worst(with_off.collect());
    assert!(own_median <= allowed, "{own_median} {allowed}\n{report}");
}

#[test]
fn friction_of_strips_is_as_close_to_boundary_elements_as_one_coefficient() {
    let table = read_table("contact_25_1/friction_by_inclination.csv");
    let folder = TempDir::new().unwrap();
    let strips = Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() };
    let elements = Parameters {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: TangentialModel::BoundaryElement,
        normal_elements: [24, 24],
        ..strips.clone()
    };
    let [mut even, mut exact_even] = [benchmark(strips.clone()), benchmark(elements.clone())];
    let [mut own, mut exact] = [strips, elements].map(|base| with_reference_tables(&folder, &base));
    let mut found: Vec<[f64; 2]> = Vec::new();
    // Between the kinks of the tables, where friction changes over the patch.
    for id in ["f05", "f12", "f20", "f26", "f34", "m4"] {
        let row = table.rows.iter().find(|row| &row[0] == id).unwrap();
        let v = |name: &str| value(&table, row, name);
        let mut input = of_wheelset(&v);
        input.friction = v("p1_friction");
        // Half way to where it slides.
        input.wheel.velocity[1] *= 0.3;
        input.wheel.yaw *= 0.3;
        let k = v("friction_table") as usize - 1;
        let errors =
            [(&mut even, &mut exact_even), (&mut own[k], &mut exact[k])].map(|(strips, exact)| {
                let exact = evaluate(exact, &input);
                let strips = evaluate(strips, &input);
                let angle = exact.patches[0].contact_angle;
                let [a, b] = [&exact, &strips].map(|output| in_plane(output, angle));
                let normal: f64 = exact.patches.iter().map(|patch| patch.normal_force).sum();
                (a[0] - b[0]).hypot(a[1] - b[1]) / (v("p1_friction") * normal)
            });
        found.push(errors);
    }
    let column = |k: usize| found.iter().map(|own| own[k]).collect::<Vec<f64>>();
    let mut summary = Summary::new("friction_of_strips");
    for (name, k, aim) in
        [("one coefficient", 0, ""), ("a coefficient for each strip", 1, "one coefficient")]
    {
        let own = column(k).into_iter().map(|error| 100.0 * error);
        summary.add(&format!("creep force, {name} [% of the friction limit]"), own, aim);
    }
    summary.write();
    let [constant, varying] = [0, 1].map(|k| median_and_worst(column(k)));
    for (constant_error, varying_error) in constant.into_iter().zip(varying) {
        assert!(varying_error <= constant_error + constant[0], "{found:?}");
    }
}
