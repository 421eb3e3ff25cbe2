use std::path::PathBuf;
use wheelrail::element::parameters::*;
use wheelrail::element::{Element, Input, Output, Parameters};

#[test]
fn compare() {
    let text = std::fs::read_to_string("/work/shared/reference/variable_profiles.csv").unwrap();
    let mut lines = text.lines();
    let heads: Vec<&str> = lines.next().unwrap().split(',').collect();
    let col = |n: &str| heads.iter().position(|h| *h == n).unwrap();
    let only = std::env::var("ONLY").unwrap_or_default();
    let mut element: Option<(String, Element)> = None;
    for line in lines {
        let v: Vec<&str> = line.split(',').collect();
        let num = |n: &str| v[col(n)].parse::<f64>().unwrap_or(f64::NAN);
        let rail = v[col("rail_profile")];
        if !rail.contains(&only) {
            continue;
        }
        let mut input = Input::default();
        input.wheel.position = [0.0, 0.75 + 1e-3 * num("y_ws_mm"), -0.46];
        input.track_s = 1e-3 * num("s_mm");
        input.wheel.roll = num("roll_ws_rad");
        input.wheel.yaw = num("yaw_ws_rad");
        // The wheelset turns about its centre.
        input.wheel.velocity =
            [1e-3 * num("v_s_mm_s"), 1e-3 * num("v_y_mm_s"), 1e-3 * num("v_z_mm_s")];
        input.wheel.pitch_rate = num("v_pitch_rad_s");
        if rail.contains("cross_nose") {
            input.wheel.velocity[0] *= 1.01;
        }
        let (yaw, roll) = (num("yaw_ws_rad"), num("roll_ws_rad"));
        input.wheel.position[0] = -0.75 * yaw.sin();
        input.wheel.position[1] = 0.75 * yaw.cos() * roll.cos() + 1e-3 * num("y_ws_mm");
        let dz = 0.75 * yaw.cos() * roll.sin();
        if element.as_ref().is_none_or(|e| e.0 != rail) {
            let mut p = Parameters::default();
            p.wheel.profile = std::env::var("WHEEL").unwrap_or("MBench_S1002_v3.prw".into());
            p.rails[0].profile = rail.into();
            p.rails[0].placement = Placement::Origin;
            p.rails[0].position = [0.75, 0.0];
            p.rails[0].inclination = 0.0;
            p.profile_smoothing = 0.0;
            p.vertical_mode = VerticalMode::Load;
            p.wheel.young_modulus = 2.0992e11;
            p.rail_young_modulus = 2.0992e11;
            let folders =
                ["/work/shared/profiles", "/work/shared/profiles/testbank"].map(PathBuf::from);
            let t = std::time::Instant::now();
            let e = Element::new(&p, &input, &folders).unwrap();
            println!("{rail} load {:?}", t.elapsed());
            element = Some((rail.to_string(), e));
        }
        let e = &mut element.as_mut().unwrap().1;
        let target: f64 =
            (1..=2).map(|k| num(&format!("p{k}_N_N"))).filter(|x| x.is_finite()).sum();
        let mut load = num("fz_set_N");
        let mut out = Output::default();
        for _ in 0..3 {
            input.wheel_load = load;
            e.evaluate(&input, &mut out).unwrap();
            let n: f64 =
                out.patches.iter().take(out.patch_count as usize).map(|p| p.normal_force).sum();
            if n <= 0.0 {
                println!(
                    "{} NO LOAD z {} fall {} sunk {:?} pc {}",
                    v[0],
                    out.wheel_z,
                    out.fallback_count,
                    e.sunk(),
                    out.patch_count
                );
                break;
            }
            load *= target / n;
        }
        let z = out.wheel_z + 0.46 - dz;
        let mut s = format!(
            "{:12} s {:7.2} y {:5.2} yaw {:6.3} dz {:8.3} um n {} {}",
            v[0],
            num("s_mm"),
            num("y_ws_mm"),
            num("yaw_ws_rad"),
            1e6 * (z - 1e-3 * num("z_ws_mm")),
            out.patch_count,
            num("n_patches")
        );
        let mut used = vec![];
        for k in 1..=num("n_patches") as usize {
            let f = |n: &str| num(&format!("p{k}_{n}"));
            let best = out
                .patches
                .iter()
                .take(out.patch_count as usize)
                .enumerate()
                .filter(|(i, _)| !used.contains(i))
                .min_by(|(_, a), (_, b)| {
                    (1e3 * a.position[1] - f("ypn_mm"))
                        .abs()
                        .total_cmp(&(1e3 * b.position[1] - f("ypn_mm")).abs())
                });
            let Some((i, p)) = best else { continue };
            used.push(i);
            let x = 1e3 * (p.position[0] - input.wheel.position[0]);
            s += &format!(
                " | N {:.4} pm {:.3} x {:.2} ({:.2}) y {:.3} fx {:.4} fs {:.4}",
                p.normal_force / f("N_N"),
                1e-6 * p.max_pressure / f("pmax_MPa"),
                1e3 * p.position[0] - f("x_mm"),
                x,
                1e3 * p.position[1] - f("ypn_mm"),
                (-p.creep_force[0] - f("Fx_N")) / (0.3 * f("N_N")),
                (-p.creep_force[1] - f("Fs_N")) / (0.3 * f("N_N"))
            );
        }
        println!("{s}");
    }
}
