//! `wheelrail transient`.

use super::*;

#[test]
fn transient_follows_its_states_to_the_steady_answer() {
    let table = example("transient_states.csv");
    let size = ["--element-length", "0.6", "--element-width", "0.6"];
    let rows = success(&[&["transient", table.as_str()], &size[..]].concat());
    assert_eq!(rows.len(), 1 + 50 + 25 + 1);
    let mut before = f64::INFINITY;
    for (n, row) in rows.iter().enumerate() {
        assert_eq!(row["converged"], "1");
        assert!(number(row, "friction_work_j") >= 0.0);
        let force = number(row, "fx_n").hypot(number(row, "fy_n"));
        assert!(force <= 0.3 * number(row, "normal_force_n") * (1.0 + 1e-9));
        assert!((number(row, "normal_force_n") - 80e3).abs() < 5.0);
        if (1..51).contains(&n) {
            assert_eq!(row["row"], "2");
            assert!((number(row, "distance_mm") - 0.4 * n as f64).abs() < 1e-9);
            // From a push forward to a pull back.
            assert!(number(row, "fx_n") < before);
            before = number(row, "fx_n");
        }
        if (51..76).contains(&n) {
            assert!((number(row, "fx_n") + 12e3).abs() < 0.1);
        }
    }
    assert!(number(&rows[0], "fx_n") > 0.0 && rows[0]["substeps"] == "1");
    assert_eq!(rows[76]["substeps"], "0");
    // The same as patch with boundary elements, of other elements.
    let (folder, path) = written(
        "separation,radius_mm,load_n,creepage_longitudinal,spin_per_mm,normal_model,tangential_model\n\
         f.csv,460,80000,0.001,0.0001,boundary_element,boundary_element\n",
    );
    std::fs::copy(example("separation_300_80.csv"), folder.path().join("f.csv")).unwrap();
    let steady = success(&["patch", &path]);
    for name in ["fx_n", "fy_n"] {
        let error = number(&rows[76], name) - number(&steady[0], name);
        assert!(error.abs() < 0.005 * 24e3, "{name}: {error}");
    }
}

#[test]
fn transient_complains_with_row_and_variable() {
    let message = |text: &str| {
        let (folder, path) = written(text);
        let parabola = lines(-10..=10, ",", |y| y * y / 600.0);
        std::fs::write(folder.path().join("f.csv"), format!("y_mm,f_mm\n{parabola}")).unwrap();
        failure(&["transient", &path])
    };
    let unknown = message("separation,radius_mm,load_n,roled_mm\nf.csv,460,1e4,1\n");
    assert!(unknown.contains("column \"roled_mm\": unknown"), "{unknown}");
    let far = message("separation,radius_mm,load_n,rolled_mm\nf.csv,460,1e4,-1e12\n");
    assert!(far.contains("row 1 (line 2)") && far.contains("rolled = -1000000000"), "{far}");
    let force = message("separation,radius_mm,load_n,force_lateral_n\nf.csv,460,1e4,4e3\n");
    assert!(force.contains("force_lateral = 4000"), "{force}");
    let steps = message("separation,radius_mm,load_n,steps\nf.csv,460,1e4,0.5\n");
    assert!(steps.contains("column \"steps\": 0.5"), "{steps}");
    let model = message("separation,radius_mm,load_n,normal_model\nf.csv,460,1e4,hertz\n");
    assert!(model.contains("normal_model = \"Hertz\""), "{model}");
}
