//! Rounding to whole numbers without a call of the C library.

/// 3/2 of 2^52, beside which digits behind the point find no room.
const ROOM: f64 = 6_755_399_441_055_744.0;

/// The whole number nearest to `x`, of two as near the even one; for magnitudes up to 2^51.
#[inline]
pub fn nearest_whole(x: f64) -> f64 {
    (x + ROOM) - ROOM
}

#[cfg(test)]
mod tests {
    use super::nearest_whole;

    #[test]
    fn it_is_that_of_the_library() {
        for x in [0.0, 0.5, 0.500_000_1, -0.5, -1.5, 2.5, -3.499_999, 1e6 + 0.7, -2e15 + 0.75] {
            assert_eq!(nearest_whole(x).to_bits(), (x.round_ties_even() + 0.0).to_bits(), "{x}");
        }
    }
}
