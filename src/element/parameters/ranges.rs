//! Whether the numbers among the parameters are in the ranges that
//! `modelDescription/variables.toml` declares.
//!
//! The ranges hold everything that wheels, rails and laws of wear are made of, and models of them
//! in other materials and scales, with decades to spare; within them no product of parameters and
//! inputs leaves the range of numbers. Young's moduli go from rubber to a thousand times diamond
//! (1e6 to 1e15 Pa), damping to where it stops a vehicle within a micrometre (1e9 N s/m), speeds of
//! reference from the creep of a parked vehicle to walking pace (1e-6 to 10 m/s).

use crate::element::parameters::Parameters;
use crate::error::ContactError;

include!(concat!(env!("OUT_DIR"), "/ranges.rs"));

/// Checks all numbers.
///
/// # Errors
/// The first one out of its range, by its FMU name.
pub(in crate::element) fn check(parameters: &Parameters) -> Result<(), ContactError> {
    for (name, value, [least, most], allowed) in ranges(parameters) {
        // Nothing compares with what is not a number, and infinity is beyond every bound.
        if !(value >= least && value <= most) {
            return Err(ContactError::bad_value(name, value, allowed));
        }
    }
    Ok(())
}
