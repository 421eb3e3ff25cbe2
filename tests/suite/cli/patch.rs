//! `wheelrail patch` and `compare`.

use super::*;

#[test]
fn patch_gives_the_load_it_was_asked_for_and_the_approach_that_belongs_to_it() {
    let rows = success(&["patch", &example("planar_contacts.csv")]);
    assert_eq!(rows.len(), 4);
    for row in &rows {
        assert!(number(row, "normal_force_n") > 0.0 && number(row, "time_us") > 0.0);
        assert_eq!(row["fallback"], "0");
        // Friction bounds the creep force.
        let force = number(row, "fx_n").hypot(number(row, "fy_n"));
        assert!(force <= 0.3 * number(row, "normal_force_n") * (1.0 + 1e-9));
    }
    let loaded = number(&rows[1], "normal_force_n");
    assert!((loaded - 80e3).abs() < 1.0, "{loaded}");
    assert!(number(&rows[2], "fx_n") < 0.0, "a wheel that is too fast is held back");
    assert!(number(&rows[3], "fy_n") < 0.0);
}

#[test]
fn patch_meets_hertz_on_a_parabola() {
    // Radii 0.5 m along and across, steel: a = b, a³ = 3 N R/(4 E*), p0 = 3 N/(2 π a²).
    let separation = "y_mm,f_mm\n".to_owned() + &lines(-20..=20, ",", |y| y * y / 1000.0);
    let (folder, path) =
        written("separation,radius_mm,load_n,normal_model\nf.csv,500,50000,hertz\n");
    std::fs::write(folder.path().join("f.csv"), separation).unwrap();
    let rows = success(&["patch", &path]);
    let (load, radius): (f64, f64) = (50e3, 0.5);
    let modulus = 2.1e11 / (2.0 * (1.0 - 0.28 * 0.28));
    let a = (0.75 * load * radius / modulus).cbrt();
    let pressure = 1e-6 * 1.5 * load / (std::f64::consts::PI * a * a);
    let found = number(&rows[0], "max_pressure_mpa");
    assert!((found / pressure - 1.0).abs() < 1e-3, "{found} MPa instead of {pressure} MPa");
    assert!((number(&rows[0], "length_mm") / (2e3 * a) - 1.0).abs() < 1e-3);
    assert!((number(&rows[0], "normal_force_n") / load - 1.0).abs() < 1e-6);
}

#[test]
fn patch_complains_with_row_column_and_remedy() {
    let message = |text: &str| {
        let (folder, path) = written(text);
        let parabola = lines(-10..=10, ",", |y| y * y / 600.0);
        std::fs::write(folder.path().join("f.csv"), format!("y_mm,f_mm\n{parabola}")).unwrap();
        std::fs::write(folder.path().join("bad.csv"), "y_mm,f_mm\n0,0\n1,?\n").unwrap();
        failure(&["patch", &path])
    };
    let unknown = message("separation,radius_mm,aproach_mm\nf.csv,460,0.05\n");
    assert!(unknown.contains("column \"aproach_mm\": unknown"), "{unknown}");
    assert!(unknown.contains("approach_mm, load_n"), "{unknown}");
    let neither = message("separation,radius_mm\nf.csv,460\n");
    assert!(neither.contains("row 1 (line 2): give approach_mm or load_n"), "{neither}");
    let both = message("separation,radius_mm,approach_mm,load_n\nf.csv,460,0.05,1e4\n");
    assert!(both.contains("not both"), "{both}");
    let file = message("separation,radius_mm,load_n\nf.csv,460,1e4\nnone.csv,460,1e4\n");
    assert!(file.contains("row 2 (line 3), column \"separation\""), "{file}");
    assert!(file.contains("none.csv"), "{file}");
    let cell = message("separation,radius_mm,load_n\nbad.csv,460,1e4\n");
    assert!(cell.contains("bad.csv, row 2 (line 3), column \"f_mm\": \"?\""), "{cell}");
    let radius = message("separation,radius_mm,load_n\nf.csv,-460,1e4\n");
    assert!(radius.contains("column \"radius_mm\": -460 is not admitted"), "{radius}");
    let model = message("separation,radius_mm,load_n,normal_model\nf.csv,460,1e4,kik\n");
    assert!(
        model.contains("column \"normal_model\"") && model.contains("piotrowski_kik"),
        "{model}"
    );
}

#[test]
fn compare_measures_wheels_and_planar_contacts() {
    let (folder, path) = written(
        "wheel.y,wheel.load,vertical.mode,wheel.vx,wheel.pitch_rate,normal.model,tangential.model,normal.elements_along,normal.elements_across\n\
         0.747,50000,load,20,-43.4,piotrowski_kik,fastsim,12,12\n\
         0.747,50000,load,20,-43.4,boundary_element,boundary_element,12,12\n",
    );
    let figure = folder.path().join("errors.svg");
    let summary = folder.path().join("summary.csv");
    let rows = success(&[
        "compare",
        &path,
        "--figure",
        figure.to_str().unwrap(),
        "--summary",
        summary.to_str().unwrap(),
    ]);
    assert_eq!(rows.len(), 2);
    assert_eq!(rows[0]["wheel.y"], "0.747");
    for row in &rows {
        assert!((number(row, "reference_normal_force_n") / 5e4 - 1.0).abs() < 0.01);
        let turn = number(row, "reference_normals_turn_deg");
        assert!(turn > 0.1 && turn < 10.0, "a tread contact turns by a few degrees: {turn}");
    }
    assert!(number(&rows[0], "max_pressure_error_percent").abs() > 1.0);
    for quantity in ["normal_force", "max_pressure", "area", "creep_force", "spin_moment"] {
        let error = number(&rows[1], &format!("{quantity}_error_percent"));
        assert!(error.abs() < 0.5, "{quantity} {error}");
    }
    assert!(std::fs::read_to_string(figure).unwrap().contains("Creep force"));
    assert!(table(&std::fs::read(summary).unwrap()).len() >= 5);

    std::fs::write(folder.path().join("f.csv"), parabola()).unwrap();
    std::fs::write(
        &path,
        "separation,radius_mm,load_n,creepage_longitudinal,normal_model,elements_along,elements_across\n\
         f.csv,460,50000,0.001,hertz,12,12\n",
    )
    .unwrap();
    let rows = success(&["compare", &path]);
    assert!(number(&rows[0], "max_pressure_error_percent").abs() < 2.0);
    assert!(number(&rows[0], "reference_fx_n") < -1000.0);
}

#[test]
fn patch_takes_tables_and_falling_friction() {
    let (folder, _) = written("");
    let parabola = lines(-20..=20, ",", |y| y * y / 1000.0);
    std::fs::write(folder.path().join("f.csv"), format!("y_mm,f_mm\n{parabola}")).unwrap();
    let cases = folder.path().join("all.csv");
    let head = "separation,radius_mm,load_n,creepage_longitudinal,tangential_model,falling_share,falling_decay_s_per_m,speed_m_s";
    let text = format!(
        "{head}\nf.csv,460,80000,0.1,tables,1,0,10\nf.csv,460,80000,0.1,fastsim_corrected,0.4,0.7,10\n"
    );
    std::fs::write(&cases, text).unwrap();
    let rows = success(&["patch", cases.to_str().unwrap()]);
    let share = |k: usize| -number(&rows[k], "fx_n") / number(&rows[k], "normal_force_n");
    assert!((share(0) / 0.3 - 1.0).abs() < 1e-3, "{}", share(0));
    let falling = 0.3 * (0.4 + 0.6 * (-0.7_f64).exp());
    assert!((share(1) / falling - 1.0).abs() < 1e-3, "{} for {falling}", share(1));
}
