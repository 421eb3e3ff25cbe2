//! Rails of several parts, and sections that do not go together.

use super::*;

#[test]
fn a_rail_with_parts_is_two_rails() {
    let folder = crossing();
    let mut parameters = parameters();
    parameters.wheel.profile = "cylindrical".into();
    let mut one = element(&parameters, &folder);
    parameters.rails[0].profile = "wing.slcs".into();
    parameters.rails[1].enabled = true;
    let [wing, nose] = &mut parameters.rails;
    (nose.profile, nose.placement) = ("nose.slcs".into(), Placement::Origin);
    (nose.position, nose.inclination, nose.mirrored) = (wing.position, 0.0, false);
    let mut two = element(&parameters, &folder);
    let (mut on_wing, mut on_nose) = (0, 0);
    for i in 0..60 {
        let mut input = rolling(0.0, 10.0);
        input.track_s = 1e-3 * (-110.0 + 3.5 * f64::from(i));
        let [first, other] = [&mut one, &mut two].map(|e| e.touching_height(&input));
        assert_relative_eq!(first, other, epsilon = 2e-9);
        input.wheel.position[2] = first + 5e-5;
        let (first, other) = (evaluate(&mut one, &input), evaluate(&mut two, &input));
        // Where both carry, patches of one rail press each other down and those of two do not.
        if first.patch_count.max(other.patch_count) > 1 {
            continue;
        }
        let counted = if other.patches[0].rail == 1 { &mut on_wing } else { &mut on_nose };
        *counted += 1;
        let scale = 1e-4 * other.wheel.force[2].abs();
        for k in 0..3 {
            assert_relative_eq!(first.wheel.force[k], other.wheel.force[k], epsilon = scale);
        }
    }
    assert!(on_wing > 10 && on_nose > 10, "{on_wing} {on_nose}");
}

#[test]
fn sections_that_are_turned_over_differently_are_refused() {
    let folder = crossing();
    for name in ["wing0.txt", "both20.txt"] {
        let path = folder.path().join(name);
        let plain = fs::read_to_string(&path).unwrap().replace("# mirror_z 0\n", "");
        fs::write(&path, plain).unwrap();
    }
    let list = "0 1\n2\n0 0 0\n1\n0 'wing0.txt'\n10 'both20.txt'\n";
    fs::write(folder.path().join("rail.slcs"), list).unwrap();
    let made = Element::new(&parameters(), &Input::default(), &[folder.path().to_path_buf()]);
    let message = made.unwrap_err().to_string();
    for part in ["rail.slcs:6", "both20.txt", "wing0.txt", "mirror_z"] {
        assert!(message.contains(part), "{message}");
    }
}
