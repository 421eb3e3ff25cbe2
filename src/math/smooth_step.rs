//! From 0 to 1 without a kink: the weight with which one description goes over into another.

use super::real::Real;

/// x² (3 - 2 x), level at 0 and 1, between which x is.
// Inside each instruction set or not at all: a call would not be vectorised.
#[inline(always)]
pub fn smooth_step<T: Real>(x: T) -> T {
    x * x * (-(x * 2.0) + 3.0)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn it_is_level_at_both_ends_and_odd_about_the_middle() {
        assert_relative_eq!(smooth_step(0.0), 0.0);
        assert_relative_eq!(smooth_step(1.0), 1.0);
        for x in [0.1, 0.3, 0.5, 0.9] {
            assert_relative_eq!(smooth_step(x) + smooth_step(1.0 - x), 1.0, epsilon = 1e-15);
        }
        let x = 1e-4;
        assert!(smooth_step(x) < 4.0 * x * x && 1.0 - smooth_step(1.0 - x) < 4.0 * x * x);
    }
}
