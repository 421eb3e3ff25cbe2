//! Corrugation on rails that vary.

use super::*;

#[test]
fn corrugation_of_slices_that_are_all_the_same_is_that_of_one_profile() {
    let folder = TempDir::new().unwrap();
    let table = "station_m,profile\n-1,60E1\n-0.02,60E1\n0.03,60E1\n2,60E1\n";
    fs::write(folder.path().join("rail.csv"), table).unwrap();
    // The last one is hollow for the wheel, which stands on two of its crests at times.
    for (amplitude, wavelength) in [(2e-5, 0.1), (1e-5, 0.033), (5e-5, 0.033), (1e-4, 0.033)] {
        let mut even = Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() };
        let wave = &mut even.rails[0].corrugation;
        (wave.amplitude, wave.wavelength, wave.phase) = (amplitude, wavelength, 0.4);
        let mut varying = even.clone();
        varying.rails[0].profile = "rail.csv".into();
        let (mut even, mut varying) = (element(&even, &folder), element(&varying, &folder));
        let mut worst = [0.0_f64; 4];
        for i in 0..60 {
            let mut input = rolling(3e-3 * f64::from(i % 5 - 2), 20.0);
            input.track_s = 0.0031 * f64::from(i);
            input.wheel_load = 8e4;
            let (one, other) = (evaluate(&mut even, &input), evaluate(&mut varying, &input));
            let apart = [0, 1].map(|axis| one.wheel.force[axis] - other.wheel.force[axis]);
            let limit = input.friction * input.wheel_load;
            let [a, b] = [&one, &other].map(|output| &output.patches[0]);
            let errors = [
                one.wheel_z - other.wheel_z,
                a.position[0] - b.position[0],
                a.max_pressure / b.max_pressure - 1.0,
                apart[0].hypot(apart[1]) / limit,
            ];
            worst = [0, 1, 2, 3].map(|k| worst[k].max(errors[k].abs()));
        }
        let [height, place, pressure, force] = worst;
        println!("{amplitude} {wavelength}: {height:.1e} {place:.1e} {pressure:.1e} {force:.1e}");
        assert!(height <= tolerance::VARYING_HEIGHT, "{amplitude} {wavelength}: {height:e}");
        assert!(place <= tolerance::VARYING_PLACE, "{amplitude} {wavelength}: {place:e}");
        assert!(pressure <= tolerance::VARYING_PRESSURE, "{amplitude} {wavelength}: {pressure:e}");
        // An even rail's patches lie level, so that creepage is another one by the square of the
        // slope: a twentieth of the limit at a slope of 1:100.
        if TAU * amplitude / wavelength < 5e-3 {
            assert!(force <= tolerance::VARYING_FORCE, "{amplitude} {wavelength}: {force:e}");
        }
    }
}
