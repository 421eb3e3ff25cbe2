//! Both interfaces give the same bits over a run.

use wheelrail::fmi::v2::types::Status;
use wheelrail::variables::{Causality, Kind, Unit, WHEEL, WHEELSET};

use crate::host::Host;
use crate::host3::Host3;

/// A body that rolls, swings sideways to the flange and hops.
fn pose(body: &str, centre: f64, i: usize) -> Vec<(String, f64)> {
    let t = 1e-3 * i as f64;
    [
        ("y", centre + 7e-3 * (9.0 * t).sin()),
        ("z", -0.4598 + 2e-4 * (31.0 * t).sin()),
        ("yaw", 5e-3 * (9.0 * t).cos()),
        ("vy", 0.06 * (9.0 * t).cos()),
        ("vz", 6e-3 * (31.0 * t).cos()),
    ]
    .map(|(name, value)| (format!("{body}.{name}"), value))
    .into()
}

fn runs_alike(unit: &'static Unit, body: &str, centre: f64) {
    let (old, new) = (Host::stepping_of(unit), Host3::stepping(unit));
    let outputs = |kind| {
        let all = unit.variables.iter().filter(move |v| v.causality == Causality::Output);
        all.filter(move |v| v.kind == kind)
    };
    // Arrays element by element, in the order of FMI 3.0.
    let elements = |kind| -> Vec<&str> {
        let places = outputs(kind).flat_map(|v| v.elements);
        places.map(|place| unit.variables[*place as usize].name).collect()
    };
    let names = |kind| -> Vec<&str> {
        let all = outputs(kind).filter(|v| !v.elements.is_empty());
        all.map(|v| v.array.unwrap_or(v.name)).collect()
    };
    let (reals, integers) = (elements(Kind::Real), elements(Kind::Integer));
    let mut touching = 0;
    for i in 0..400 {
        let pose = pose(body, centre, i);
        let pose: Vec<(&str, f64)> = pose.iter().map(|(name, value)| (&**name, *value)).collect();
        assert_eq!((old.set_reals(&pose), new.set_reals(&pose)), (Status::Ok, Status::Ok));
        let time = 1e-3 * i as f64;
        assert_eq!(old.step(time, 1e-3), new.step(time, 1e-3));
        let wanted = old.get_reals(&reals).unwrap();
        let given = new.get_reals(&names(Kind::Real), reals.len()).unwrap();
        for ((name, wanted), given) in reals.iter().zip(wanted).zip(given) {
            assert_eq!(wanted.to_bits(), given.to_bits(), "{name} after step {i}");
        }
        let wanted: Vec<i32> = integers.iter().map(|name| old.get_integer(name)).collect();
        assert_eq!(new.get_integers(&names(Kind::Integer), integers.len()), Ok(wanted));
        touching += usize::from(new.get_integers(&["patch_count"], 1).unwrap()[0] > 0);
    }
    assert!(touching > 200, "{touching} steps with a contact");
}

#[test]
fn a_wheel_gets_the_same_bits() {
    runs_alike(&WHEEL, "wheel", 0.75);
}

#[test]
fn a_wheelset_gets_the_same_bits() {
    runs_alike(&WHEELSET, "wheelset", 0.0);
}
