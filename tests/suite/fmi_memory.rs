//! Instances come and go without leaving anything behind.

use crate::allocations;
use crate::host::Host;
use wheelrail::fmi::v2::types::Status;

/// Life of one instance: made, run, its state saved, freed.
fn live() {
    let host = Host::stepping();
    let z = host.get_real("nominal.wheel_z") + 1e-4;
    assert_eq!(host.set_reals(&[("wheel.z", z), ("wheel.vx", 20.0)]), Status::Ok);
    assert_eq!(host.step(0.0, 1e-3), Status::Ok);
    assert!(host.get_real("wheel.force.z") < -1e4);
}

#[test]
fn memory_is_the_same_after_a_thousand_instances_as_after_ten() {
    for _ in 0..10 {
        live();
    }
    let before = allocations::live_bytes();
    for _ in 0..1000 {
        live();
    }
    let grown = allocations::live_bytes() - before;
    assert!(grown.abs() < 4096, "{grown} bytes more than before");
}
