//! What holds between the contact and a master that steps: the energy residual, and how long a step
//! may be.
#![allow(unsafe_code)]
// The box fixes the address that the logger gets.
#![allow(clippy::unnecessary_box_returns)]

use crate::tolerance;
use std::ffi::c_char;
use std::ptr::null_mut;

use crate::host::{Arguments, Host};
use nalgebra::{Matrix3, Vector3};
use wheelrail::fmi::v2::types::Status;
use wheelrail::fmi::v2::*;
use wheelrail::variables::{Unit, WHEEL, WHEELSET};

/// Half of a wheelset [kg], and what rests on it together with its weight [N].
const MASS: f64 = 700.0;
const LOAD: f64 = 5e4;

/// A rolling wheel with normal damping, in initialization mode left.
fn rolling(unit: &Unit, damping: f64, monitor: bool) -> Box<Host> {
    let host = Host::initializing_with(&Arguments::of(unit));
    assert_eq!(host.set_reals(&[("normal.damping", damping)]), Status::Ok);
    // Without creep forces it is the normal contact alone.
    assert_eq!(host.set_integer("tangential.model", 1), Status::Ok);
    assert_eq!(host.set_boolean("coupling.monitor", monitor), Status::Ok, "{}", host.last());
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    let body = if unit.guid == WHEEL.guid { "wheel" } else { "wheelset" };
    let names = [format!("{body}.vx"), format!("{body}.pitch_rate")];
    assert_eq!(host.set_reals(&[(&names[0], 20.0), (&names[1], -43.5)]), Status::Ok);
    host
}

/// Vertical force of the rail on the wheel, upwards.
fn carried(host: &Host, z: f64, vz: f64) -> f64 {
    assert_eq!(host.set_reals(&[("wheel.z", z), ("wheel.vz", vz)]), Status::Ok);
    -host.get_real("wheel.force.z")
}

/// The height at which the rail carries the load.
fn equilibrium(host: &Host) -> f64 {
    let (mut low, mut high) = (-0.4599, -0.4594);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if carried(host, middle, 0.0) < LOAD { low = middle } else { high = middle }
    }
    high
}

/// Height, velocity and the energy residuals so far of a mass on the contact with forces held over
/// steps of `h` [s].
fn held(host: &Host, start: [f64; 2], h: f64, steps: u32) -> ([f64; 2], f64) {
    let ([mut z, mut vz], mut residual) = (start, 0.0);
    for i in 0..=steps {
        let acceleration = (LOAD - carried(host, z, vz)) / MASS;
        assert_eq!(host.step(h * f64::from(i), h), Status::Ok);
        residual += host.get_real("coupling.energy_residual");
        if i < steps {
            z += h * (vz + 0.5 * h * acceleration);
            vz += h * acceleration;
        }
    }
    ([z, vz], residual)
}

#[test]
fn residuals_add_up_to_the_energy_that_held_forces_bring_in() {
    let host = rolling(&WHEEL, 0.0, true);
    let balanced = equilibrium(&host);
    let start = [balanced + 1e-5, 0.0];
    for h in [1e-5, 2e-5, 4e-5] {
        let ([z, vz], residual) = held(&host, start, h, 400);
        // What the spring of the contact and the load hold, by the rule of Simpson.
        let panels = 2000;
        let width = (z - start[0]) / f64::from(panels);
        let stored: f64 = (0..panels)
            .map(|i| {
                let at = |share: f64| {
                    carried(&host, start[0] + width * (f64::from(i) + share), 0.0) - LOAD
                };
                width / 6.0 * (at(0.0) + 4.0 * at(0.5) + at(1.0))
            })
            .sum();
        let gained = 0.5 * MASS * vz * vz + stored;
        println!("h {h:e}: gained {gained:.6} J, residuals {residual:.6} J");
        assert!(gained > 0.0);
        assert!(
            (residual / gained - 1.0).abs() < tolerance::ENERGY_RESIDUAL,
            "{residual} {gained}"
        );
    }
}

#[test]
fn without_the_monitor_there_is_no_residual_and_no_evaluation_for_it() {
    for (unit, z) in [(&WHEEL, "wheel.z"), (&WHEELSET, "wheelset.z")] {
        let host = rolling(unit, 1e5, false);
        for i in 0..5 {
            let height = -0.4597 + 1e-5 * f64::from(i);
            assert_eq!(host.set_reals(&[(z, height)]), Status::Ok);
            assert_eq!(host.step(1e-4 * f64::from(i), 1e-4), Status::Ok);
        }
        assert_eq!(host.get_real("coupling.energy_residual").to_bits(), 0);
    }
}

/// Residuals of a wheelset that sways.
fn residuals(host: &Host, steps: std::ops::Range<u32>) -> Vec<u64> {
    let one = |i: u32| {
        let t = 1e-4 * f64::from(i);
        let inputs = [
            ("wheelset.z", -0.4597 + 1e-5 * (300.0 * t).sin()),
            ("wheelset.vz", 3e-3 * (300.0 * t).cos()),
            ("left.rail[1].vz", 1e-3),
        ];
        assert_eq!(host.set_reals(&inputs), Status::Ok, "{}", host.last());
        assert_eq!(host.step(t, 1e-4), Status::Ok, "{}", host.last());
        host.get_real("coupling.energy_residual").to_bits()
    };
    steps.map(one).collect()
}

#[test]
fn the_residual_is_part_of_the_state() {
    let host = rolling(&WHEELSET, 1e5, true);
    assert_eq!(residuals(&host, 0..1), [0]);
    residuals(&host, 1..5);
    let (mut state, mut size) = (null_mut(), 0);
    // SAFETY: FMI 2.0, 2.1.8: pointers to one state pointer and one size, an array of `size` bytes.
    let bytes = unsafe {
        assert_eq!(fmi2GetFMUstate(host.component, &raw mut state), Status::Ok);
        assert_eq!(fmi2SerializedFMUstateSize(host.component, state, &raw mut size), Status::Ok);
        let mut bytes: Vec<c_char> = vec![0; size];
        let written = fmi2SerializeFMUstate(host.component, state, bytes.as_mut_ptr(), size);
        assert_eq!(written, Status::Ok);
        bytes
    };
    let first = residuals(&host, 5..10);
    assert!(first.iter().all(|&bits| bits != 0));
    assert_eq!(fmi2SetFMUstate(host.component, state), Status::Ok);
    assert_eq!(residuals(&host, 5..10), first);
    let other = Host::stepping_of(&WHEELSET);
    let mut copy = null_mut();
    // SAFETY: FMI 2.0, 2.1.8: an array of `size` bytes, a pointer to one state pointer.
    let read =
        unsafe { fmi2DeSerializeFMUstate(other.component, bytes.as_ptr(), size, &raw mut copy) };
    assert_eq!(read, Status::Ok, "{}", other.last());
    assert_eq!(fmi2SetFMUstate(other.component, copy), Status::Ok, "{}", other.last());
    assert_eq!(residuals(&other, 5..10), first);
}

#[test]
fn stiffness_and_damping_are_the_slopes_of_the_force_when_the_monitor_is_on() {
    let host = rolling(&WHEEL, 1e5, true);
    let z = equilibrium(&host);
    let slope = |dz: f64, dv: f64| {
        (carried(&host, z + dz, dv) - carried(&host, z - dz, -dv)) / (2.0 * dz.max(dv))
    };
    let wanted = [slope(1e-8, 0.0), slope(0.0, 1e-4)];
    carried(&host, z, 0.0);
    let found = host.get_reals(&["contact.stiffness", "contact.damping"]).unwrap();
    println!("{found:?}");
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found / wanted - 1.0).abs() < tolerance::DERIVATIVES, "{found} {wanted}");
    }
    // They follow the inputs, and are those of each side of a wheelset.
    carried(&host, z - 2e-5, 0.0);
    assert!(host.get_real("contact.stiffness") < 0.95 * found[0]);
    let set = rolling(&WHEELSET, 1e5, true);
    let inputs = [("wheelset.z", z), ("left.rail[1].z", 2e-5)];
    assert_eq!(set.set_reals(&inputs), Status::Ok, "{}", set.last());
    let sides = set.get_reals(&["right.contact.stiffness", "left.contact.stiffness"]).unwrap();
    assert!((sides[0] / found[0] - 1.0).abs() < 1e-9, "{sides:?}");
    assert!((sides[1] / host.get_real("contact.stiffness") - 1.0).abs() < 1e-6, "{sides:?}");
    // Nothing of it without the monitor, or in the air.
    assert_eq!(set.set_reals(&[("wheelset.z", -0.5)]), Status::Ok);
    assert_eq!(set.get_real("right.contact.stiffness").abs().to_bits(), 0);
    let off = rolling(&WHEEL, 1e5, false);
    carried(&off, z, 0.0);
    assert_eq!(off.get_real("contact.stiffness").to_bits(), 0);
}

/// The three limits of a step.
const LIMITS: [&str; 3] =
    ["coupling.longest_step", "coupling.normal_limit", "coupling.creep_limit"];

/// A wheelset that rolls, off the middle of the track and yawed, with `masses`.
fn rolling_wheelset(unit: &Unit, monitor: bool, masses: &[(&str, f64)]) -> Box<Host> {
    let host = Host::initializing_with(&Arguments::of(unit));
    assert_eq!(host.set_boolean("coupling.monitor", monitor), Status::Ok, "{}", host.last());
    assert_eq!(host.set_reals(masses), Status::Ok, "{}", host.last());
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    host
}

#[test]
fn the_longest_steps_of_a_wheelset_follow_from_its_forces() {
    let [mass, inertia, axle_inertia] = [1200.0, 700.0, 150.0];
    let masses = [
        ("coupling.mass", mass),
        ("coupling.inertia", inertia),
        ("coupling.axle_inertia", axle_inertia),
    ];
    let host = rolling_wheelset(&WHEELSET, true, &masses);
    let at = [
        ("wheelset.y", 1e-3),
        ("wheelset.z", -0.45972),
        ("wheelset.yaw", 1e-3),
        ("wheelset.vx", 20.0),
        ("wheelset.pitch_rate", -43.48),
    ];
    assert_eq!(host.set_reals(&at), Status::Ok, "{}", host.last());
    let [longest, normal, creep] = host.get_reals(&LIMITS).unwrap().try_into().unwrap();
    let names = ["stiffness", "damping"]
        .map(|name| ["right", "left"].map(|side| host.get_real(&format!("{side}.contact.{name}"))));
    // Of the output by the velocity, with its value put back.
    let slope = |output: &str, input: &str, step: f64| {
        let own = host.get_real(input);
        let beside = |way: f64| {
            assert_eq!(host.set_reals(&[(input, own + way)]), Status::Ok);
            host.get_real(output)
        };
        let found = (beside(step) - beside(-step)) / (2.0 * step);
        beside(0.0);
        -found
    };
    let rates = [
        slope("wheelset.force.y", "wheelset.vy", 2e-5) / mass,
        // The axle is turned by a milliradian: its moment is that about the vertical axis to 1e-6.
        slope("wheelset.moment.z", "wheelset.yaw_rate", 2e-5) / inertia,
        slope("wheelset.moment.y", "wheelset.pitch_rate", 2e-5) / axle_inertia,
    ];
    let fastest = rates.iter().copied().fold(0.0, f64::max);
    println!("{longest:e} {normal:e} {creep:e}, {rates:?}, {names:?}");
    assert!((creep * fastest / 2.0 - 1.0).abs() < tolerance::LIMIT_BY_DIFFERENCES, "{rates:?}");
    let [stiffness, damping] = names;
    let shorter = (2.0 * damping[0] / stiffness[0]).min(2.0 * damping[1] / stiffness[1]);
    assert!(
        (normal / shorter - 1.0).abs() < 1e-12 && longest.to_bits() == normal.min(creep).to_bits()
    );
    // They follow the inputs, are finite without contact and 0 without the monitor.
    assert_eq!(
        host.set_reals(&[("wheelset.vx", 0.5), ("wheelset.pitch_rate", -1.087)]),
        Status::Ok
    );
    let slow = host.get_reals(&LIMITS).unwrap();
    assert!(slow[2] < 0.1 * creep && slow[0].to_bits() == slow[2].to_bits(), "{slow:?}");
    assert_eq!(host.set_reals(&[("wheelset.z", -0.5)]), Status::Ok);
    assert_eq!(host.get_reals(&LIMITS).unwrap(), [1e6; 3]);
    let off = rolling_wheelset(&WHEELSET, false, &[]);
    assert_eq!(off.get_reals(&LIMITS).unwrap(), [0.0; 3]);
}

/// On the middle of the track both wheels of a wheelset do the same.
#[test]
fn a_wheel_alone_has_the_longest_steps_of_its_wheelset() {
    let (wheel, set) =
        (rolling_wheelset(&WHEEL, true, &[]), rolling_wheelset(&WHEELSET, true, &[]));
    let [wheel, set] = [wheel, set].map(|host| host.get_reals(&LIMITS).unwrap());
    println!("{wheel:?} {set:?}");
    for (wheel, set) in wheel.iter().zip(&set) {
        assert!((wheel / set - 1.0).abs() < 1e-9, "{wheel} {set}");
    }
}

/// A height that follows a load is not the host's to integrate: creep forces alone limit the step.
#[test]
fn a_given_load_leaves_the_limit_by_creep_forces() {
    let host = Host::initializing_with(&Arguments::of(&WHEEL));
    assert_eq!(host.set_boolean("coupling.monitor", true), Status::Ok);
    assert_eq!(host.set_integer("vertical.mode", 2), Status::Ok);
    assert_eq!(fmi2ExitInitializationMode(host.component), Status::Ok, "{}", host.last());
    let [longest, normal, creep] = host.get_reals(&LIMITS).unwrap().try_into().unwrap();
    let bits = [normal, longest].map(f64::to_bits);
    assert!(bits == [1e6, creep].map(f64::to_bits) && creep < 0.1, "{longest} {normal} {creep}");
}

/// How a master carries the motion of a mass on a spring and a damper over a step.
#[derive(Clone, Copy, Debug)]
enum Scheme {
    /// Force of the step's beginning, held; the mass moves as it does under a constant force.
    Held,
    /// The same, by the method of Euler.
    Euler,
    /// The same; the new velocity moves the mass.
    VelocityFirst,
    /// Force of the beginning of the step before.
    OneStepLate,
    /// Force of the height that the velocity leads to, held.
    CarriedOn,
    /// Force with its derivatives, by the rule of the trapezoid.
    Linearised,
}

/// A mass [kg] on a spring [N/m] and a damper [N s/m].
#[derive(Clone, Copy, Debug)]
struct Oscillator {
    k: f64,
    c: f64,
    m: f64,
}

impl Oscillator {
    /// One step of `h` [s] on (height, velocity, force of the step before).
    fn step(self, scheme: Scheme, h: f64, [z, v, before]: [f64; 3]) -> [f64; 3] {
        let Self { k, c, m } = self;
        let force = -k * z - c * v;
        let moved = |force: f64| [z + h * (v + 0.5 * h * force / m), v + h * force / m, force];
        match scheme {
            Scheme::Held => moved(force),
            Scheme::Euler => [z + h * v, v + h * force / m, 0.0],
            Scheme::VelocityFirst => {
                let v = v + h * force / m;
                [z + h * v, v, 0.0]
            }
            Scheme::OneStepLate => {
                let [z, v, _] = moved(before);
                [z, v, force]
            }
            Scheme::CarriedOn => moved(-k * (z + h * v) - c * v),
            Scheme::Linearised => {
                // v+ - v = h/m (F - k Δz/2 - c Δv/2), Δz = h (v + v+)/2.
                let change = h * (force - 0.5 * k * h * v) / (m + 0.5 * c * h + 0.25 * k * h * h);
                [z + h * (v + 0.5 * change), v + change, 0.0]
            }
        }
    }

    /// Growth of the motion in one step, in the long run: the greatest size of an eigenvalue,
    /// less 1.
    fn growth(self, scheme: Scheme, h: f64) -> f64 {
        // In units in which height, velocity and force are of the same size.
        let rate = (self.k / self.m).sqrt();
        let units = [1.0, rate, self.k];
        let column = |j: usize| {
            let mut state = [0.0; 3];
            state[j] = units[j];
            let next = self.step(scheme, h, state);
            Vector3::from_fn(|i, _| next[i] / units[i])
        };
        let map = Matrix3::from_columns(&[column(0), column(1), column(2)]);
        map.complex_eigenvalues().iter().map(|value| value.norm()).fold(0.0, f64::max) - 1.0
    }

    /// The longest step with which the motion does not grow [s].
    fn longest(self, scheme: Scheme) -> f64 {
        let (mut stable, mut growing) = (1e-7, 1e-1);
        while growing / stable > 1.0 + 1e-5 {
            let middle = f64::sqrt(stable * growing);
            if self.growth(scheme, middle) <= 0.0 { stable = middle } else { growing = middle }
        }
        stable
    }
}

/// The formulas of docs/fmi.md.
fn formula(scheme: Scheme, Oscillator { k, c, m }: Oscillator) -> f64 {
    match scheme {
        Scheme::Held => (2.0 * c / k).min(2.0 * m / c),
        Scheme::Euler => c / k,
        Scheme::VelocityFirst => ((c * c + 4.0 * k * m).sqrt() - c) / k,
        Scheme::OneStepLate => 2.0 * c / (3.0 * k),
        Scheme::CarriedOn => ((c * c + 8.0 * k * m).sqrt() - c) / (2.0 * k),
        Scheme::Linearised => f64::INFINITY,
    }
}

#[test]
fn the_longest_stable_steps_are_those_of_the_documents() {
    for (k, c) in [(1e9, 3e4), (1e9, 1e5), (1e9, 3e5), (6e8, 5e4), (1.4e9, 1.6e5)] {
        let oscillator = Oscillator { k, c, m: MASS };
        for scheme in [
            Scheme::Held,
            Scheme::Euler,
            Scheme::VelocityFirst,
            Scheme::OneStepLate,
            Scheme::CarriedOn,
        ] {
            let (found, wanted) = (oscillator.longest(scheme), formula(scheme, oscillator));
            // Exact, but for the delay: that formula is the one for light damping.
            let bound = match scheme {
                Scheme::OneStepLate => tolerance::DELAYED_STEP,
                _ => tolerance::LONGEST_STEP,
            };
            println!("{scheme:?} k {k:e} c {c:e}: {found:.4e} s, formula {wanted:.4e} s");
            assert!((found / wanted - 1.0).abs() < bound, "{scheme:?} {found} {wanted}");
        }
        for h in [1e-6, 1e-4, 1e-2, 1.0] {
            assert!(oscillator.growth(Scheme::Linearised, h) <= 1e-12);
        }
    }
    // Creep forces: a damper alone, dv/dt = -λ v; where it stands is all the same to it.
    let damper = Oscillator { k: 1e-9, c: MASS * 1e4, m: MASS };
    assert!(damper.growth(Scheme::Held, 1.99e-4) < 1e-9);
    assert!(damper.growth(Scheme::Held, 2.01e-4) > 5e-3);
}

#[test]
fn without_damping_held_forces_make_every_motion_grow_and_carried_on_ones_do_not() {
    let undamped = Oscillator { k: 1e9, c: 0.0, m: MASS };
    for h in [1e-6, 1e-5, 1e-4] {
        assert!(undamped.growth(Scheme::Held, h) > 0.0);
        assert!(undamped.growth(Scheme::CarriedOn, h) < 0.0);
    }
}

/// Swings about the equilibrium of a mass on the contact: the greatest distance in the last quarter
/// of the run over the first.
fn swing(host: &Host, balanced: f64, h: f64, carried_on: bool) -> f64 {
    let (mut z, mut vz) = (balanced + 1e-10, 0.0);
    let steps = 200;
    let mut greatest = [0.0_f64; 4];
    for i in 0..steps {
        let height = if carried_on { z + h * vz } else { z };
        let acceleration = (LOAD - carried(host, height, vz)) / MASS;
        z += h * (vz + 0.5 * h * acceleration);
        vz += h * acceleration;
        let quarter = &mut greatest[4 * i / steps];
        *quarter = quarter.max((z - balanced).abs());
    }
    greatest[3] / greatest[0]
}

#[test]
fn the_real_contact_keeps_to_the_formulas() {
    for damping in [3e4, 1e5] {
        let host = rolling(&WHEEL, damping, false);
        let balanced = equilibrium(&host);
        let slope = |dz: f64, dv: f64| {
            (carried(&host, balanced + dz, dv) - carried(&host, balanced - dz, -dv)) / 2.0
        };
        let contact =
            Oscillator { k: slope(1e-8, 0.0) / 1e-8, c: slope(0.0, 1e-4) / 1e-4, m: MASS };
        println!("{contact:?}");
        for (scheme, carried_on) in [(Scheme::Held, false), (Scheme::CarriedOn, true)] {
            let limit = formula(scheme, contact);
            let (below, above) = (
                swing(&host, balanced, 0.97 * limit, carried_on),
                swing(&host, balanced, 1.03 * limit, carried_on),
            );
            println!("{scheme:?}: limit {limit:.3e} s, {below:.3} below, {above:.3} above");
            assert!(below < 1.0 && above > 1.0);
        }
    }
}
