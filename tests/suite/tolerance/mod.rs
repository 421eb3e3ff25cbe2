//! Every tolerance of the integration tests: what it bounds, against what, and why it is as large as
//! it is. No tolerance is written elsewhere.
//!
//! A tolerance is its target, or it is wider and says the target; what is wider is listed in
//! docs/validation.md. An error that is the model's own is kept from growing. All of
//! them, with their reasons, are in target/reports/tolerances.csv after
//! `cargo test --test suite tolerance::`.

mod boundary_element;
mod entry;
mod normal;
mod search;
mod smoothness;
mod subsurface;
mod tangential;
mod vehicle;
mod wheel;

pub use boundary_element::*;
pub use entry::{Target, Tolerance};
pub use normal::*;
pub use search::*;
pub use smoothness::*;
pub use subsurface::*;
pub use tangential::*;
pub use vehicle::*;
pub use wheel::*;

use crate::common::write_report;

/// All of them.
pub fn all() -> impl Iterator<Item = &'static Tolerance> {
    let tables = [
        search::TABLE,
        normal::TABLE,
        tangential::TABLE,
        boundary_element::TABLE,
        smoothness::TABLE,
        subsurface::TABLE,
        wheel::TABLE,
        vehicle::TABLE,
    ];
    tables.into_iter().flatten()
}

/// The numbers of the target of the constant `name`.
pub fn targets(name: &str) -> Vec<f64> {
    let own = all().find(|own| own.name == name).expect("a tolerance");
    numbers(if let Target::Less(target) = own.target { target } else { own.bound })
}

/// Creep force over friction times normal force at most: one and rounding where the patch is flat;
/// 1/cos α where loads act along their own normals within an angle α of the resultant. That is 30
/// degrees at depths up to a millimetre, many times those of heavy loads, and 60 degrees, from the
/// flank of a flange to half way to the tread, beyond.
pub fn most_friction(is_flat: bool, penetration: f64) -> f64 {
    if is_flat {
        return 1.0 + 1e-9;
    }
    let angle = if penetration < 1e-3 { 30.0_f64 } else { 60.0 };
    1.0 / angle.to_radians().cos()
}

/// The numbers of an expression in the order in which they are written.
fn numbers(text: &str) -> Vec<f64> {
    let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || ".-".contains(c)));
    words.filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn every_tolerance_has_a_reason_and_none_is_below_its_target() {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record(["name", "quantity", "bound", "target", "reason"]).unwrap();
    for tolerance in all() {
        let Tolerance { name, bound, target, .. } = tolerance;
        assert!(
            !tolerance.reason().is_empty(),
            "{name}: quantity and reason, with a colon between"
        );
        let target = match target {
            Target::Bound => bound,
            Target::Less(target) => {
                let (bounds, targets) = (numbers(bound), numbers(target));
                let pairs = || bounds.iter().zip(targets.iter().cycle());
                assert!(!targets.is_empty() && bounds.len() % targets.len() == 0, "{name}");
                assert!(pairs().all(|(bound, target)| target <= bound), "{name}");
                assert!(pairs().any(|(bound, target)| target < bound), "{name}: {bound} is met");
                target
            }
            Target::None => "none: of the model",
        };
        let row = [name, tolerance.quantity(), bound, target, tolerance.reason()];
        table.write_record(row).unwrap();
    }
    write_report("tolerances.csv", &String::from_utf8(table.into_inner().unwrap()).unwrap());
}
