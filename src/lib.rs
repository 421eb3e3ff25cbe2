//! Contact of a railway wheel with the rail under it: position and velocity in, contact forces out,
//! patch by patch.
//!
//! An [`Element`](element::Element) stands for one wheel and its rail. But for wear, if that is
//! asked for, it holds no history: an evaluation finds where the two profiles overlap, the pressure
//! there (strips of the least energy, Piotrowski and Kik, or Hertz), the creepages and the tractions
//! (marches along strips that feel each other, FASTSIM, tables), and sums them to forces and moments
//! on wheel and rail. Two of them on one axle are a [`wheelset`]. The same element is inside the FMI units
//! `WheelRail.fmu` and `WheelSet.fmu` ([`fmi`]) and the command line `wheelrail`. The equations and
//! their limits: `docs/theory.md`.
//!
//! ```
//! use wheelrail::element::{Element, Input, Output, Parameters};
//!
//! // S1002 on 60E1 at 1:40; the input to start with is that of a right wheel in the middle.
//! let mut input = Input::default();
//! let mut element = Element::new(&Parameters::default(), &input, &[])?;
//! // A tenth of a millimetre below first touch, rolling forward at 20 m/s.
//! input.wheel.position[2] = element.nominal_wheel_z() + 1e-4;
//! input.wheel.velocity[0] = 20.0;
//! input.wheel.pitch_rate = -20.0 / 0.46;
//! let mut output = Output::default();
//! element.evaluate(&input, &mut output)?;
//! // z points down: the rail pushes the wheel up.
//! assert!(output.wheel.force[2] < -3e4);
//! # Ok::<(), wheelrail::error::ContactError>(())
//! ```
//!
//! # Frames
//!
//! A right wheel on its rail, seen from behind, x away from the reader. The origin of the track
//! frame lies on the track centre line in the plane of the rail tops.
//!
//! ```text
//!   track centre line       plane of the nominal rolling circle
//!       .                        .
//!       .     axle ..............M.......          M  wheel marker: y about +0.75 m, z about -(nominal radius)
//!       .       |                .      |
//!       .       |     wheel      .      |          C  contact point, n normal of the contact frame, into the rail
//!       .       |                .      |
//!       O--> y..| |..............C______|.A..      A  rail marker: highest point of the inclined rail head
//!       |       | |\_____________|______           .. plane of the rail tops
//!       v       \_/   |          v n    |
//!       z             |   rail          |          x forward, y right, z down
//! ```
//!
//! - Angles are right-handed: R = `R_x`(roll) `R_z`(yaw) `R_y`(pitch). A wheel rolling forward has
//!   a negative pitch rate.
//! - The contact frame is the track frame rolled about x by the contact angle, negative on the
//!   right tread, so that x is along the track, the lateral axis lies in the contact plane and n
//!   points into the rail.
//! - Creepage is the velocity of the wheel's surface minus that of the rail's, over the reference
//!   speed; spin is the relative angular velocity about n over that speed.
//! - Forces and moments are those on the body they are named after; patch forces are those on the
//!   wheel.
//! - A left wheel is computed as the mirror image of a right one; in- and outputs are those of the
//!   real left wheel.
//! - Profiles are those of the right side: y to the field side, z down. Wheel: origin on the
//!   nominal rolling circle.
//!
//! # Units
//!
//! SI and radians everywhere but in profile files, on the command line and in figures, which say mm
//! and degrees.
//!
//! | quantity | unit |
//! |---|---|
//! | position, penetration, length | m |
//! | angle | rad |
//! | velocity; rate of an angle | m/s; rad/s |
//! | force; moment | N; N m |
//! | pressure, modulus | Pa |
//! | creepage, longitudinal and lateral; friction | 1 |
//! | spin creepage | 1/m |
//! | wear number | J/m = N |
//! | frictional power | W |
//! | damping | N s/m |
//!
//! # Modules
//!
//! A module imports only from those above it.
//!
//! ```text
//! math        elliptic integrals, quadrature, roots, splines, lists of fixed room: no railway words
//! geometry    profiles, placed wheel and rail, contact line, contact search, separation
//! material    elastic constants
//! boundary_element  pressure and tractions of the half-space on rectangular elements
//! error       why something is refused
//! friction    coefficients over the surface of a rail and along the track
//! io          profiles from files: SIMPACK, MiniProf, two columns; deviations; friction
//! kinematics  motion of wheel and rail to creepage
//! normal      hertz, piotrowski_kik, least_energy, damping: separation to loaded strips
//! tangential  Kalker's coefficients, flexibilities, fastsim, tables: strips and creepage to creep force
//! planar      contact problems given by a separation instead of two profiles, with and without
//!             memory
//! subsurface  displacements and stresses below the surface of a contact
//! wear        wear laws, sums along profiles, new profiles, fatigue numbers
//! fatigue     rolling contact fatigue from the stresses of a passage
//! element     one wheel: parameters, input, evaluation, output
//! wheelset    two of them on one axle
//! conicity    rolling radius difference and equivalent conicity of a wheelset
//! variables   everything above by name, from modelDescription/variables.toml
//! pack        a unit rewritten with the user's files and values (feature `pack`)
//! fmi         the C interfaces of FMI 2.0 and 3.0 for co-simulation and model exchange
//! ```
//!
//! # Features
//!
//! `cli` (the program `wheelrail`) and `package` (a release build packs `WheelRail.fmu`) are on by
//! default and bring most of the dependencies; `pack` (units rewritten with the user's files and
//! values) comes with `cli`. As a library: `default-features = false`.

pub mod conicity;
mod defaults;
pub mod element;
pub mod error;
pub mod fatigue;
pub mod fmi;
mod friction;
pub mod geometry;
pub mod io;
mod leaves;
pub mod material;
mod open;
#[cfg(feature = "pack")]
pub mod pack;
pub mod planar;
pub mod subsurface;
pub mod variables;
pub mod wear;
pub mod wheelset;

// Not part of the interface: for the tests and benchmarks of the crate.
#[doc(hidden)]
pub mod boundary_element;
#[doc(hidden)]
pub mod kinematics;
#[doc(hidden)]
pub mod math;
#[doc(hidden)]
pub mod normal;
#[doc(hidden)]
pub mod tangential;
