//! What derivatives are found by backwards: inputs and constants, each under a number of its own.

use crate::math::real::Leaf;

/// Before the inputs, in their order.
const BEFORE_INPUTS: u32 = 1;
/// Room for inputs.
pub const INPUTS: u32 = 31;
const BEFORE_CONSTANTS: u32 = BEFORE_INPUTS + INPUTS;

/// Contact modulus of the material pair.
pub const CONTACT_MODULUS: Leaf = Leaf(BEFORE_CONSTANTS);
/// Its shear modulus.
pub const SHEAR_MODULUS: Leaf = Leaf(BEFORE_CONSTANTS + 1);
/// Its Poisson's ratio.
pub const POISSON_RATIO: Leaf = Leaf(BEFORE_CONSTANTS + 2);
/// Contact damping.
pub const DAMPING: Leaf = Leaf(BEFORE_CONSTANTS + 3);
/// Virtual over true penetration.
pub const VIRTUAL_PENETRATION: Leaf = Leaf(BEFORE_CONSTANTS + 4);
/// Floor of the speed of reference.
pub const MINIMUM_SPEED: Leaf = Leaf(BEFORE_CONSTANTS + 5);
const BEFORE_LAWS: u32 = BEFORE_CONSTANTS + 6;
/// Numbers of a law of friction.
pub const LAW_NUMBERS: u32 = 5;
const BEFORE_RAILS: u32 = BEFORE_LAWS + 2 * LAW_NUMBERS;
/// How many there are.
pub const COUNT: usize = (BEFORE_RAILS + 2 * 4) as usize;

/// Input number `i`, from 0.
pub fn input(i: usize) -> Leaf {
    Leaf(BEFORE_INPUTS + i as u32)
}

/// Number `n` of the law of the tread (0) or of the gauge face (1).
pub fn of_law(which: usize, n: u32) -> Leaf {
    Leaf(BEFORE_LAWS + which as u32 * LAW_NUMBERS + n)
}

/// How rail number `k`, from 0, is placed: sine and cosine of its inclination, and (y, z) of its
/// highest point then.
pub fn of_rail(k: u32) -> [Leaf; 4] {
    [0, 1, 2, 3].map(|n| Leaf(BEFORE_RAILS + 4 * k + n))
}
