//! Friction of the strips of a zone that each have their own.

use crate::friction::StripFriction;
use crate::math::real::Real;
use crate::normal::{Strips, Zone};

/// Mean over the load of `zone` of what its strips have; nothing where the strips have no friction
/// of their own. What is the same in all strips is the mean to the last bit.
pub fn mean<T: Real>(
    zone: &Zone<T>,
    strips: &Strips<T>,
    of: impl Fn(&StripFriction<T>) -> T,
) -> Option<T> {
    let own = strips.friction.get(zone.range())?;
    let first = of(own.first()?);
    let (mut load, mut excess) = (T::from(0.0), T::from(0.0));
    for (own, j) in own.iter().zip(zone.range()) {
        let weight = strips.weight(j);
        load += weight;
        excess += weight * (of(own) - first);
    }
    Some(if load > 0.0 { first + excess / load } else { first })
}

/// What strips with a friction of their own are marched with.
#[derive(Clone, Copy, Debug)]
pub struct OwnFriction<'a, T = f64> {
    /// Of all strips; empty where they have none of their own.
    pub strips: &'a [StripFriction<T>],
    /// By what slip changes the coefficients of tread and gauge face [-].
    pub factors: [T; 2],
}

impl<T: Real> OwnFriction<'_, T> {
    /// Strips that have none.
    pub fn none() -> Self {
        Self { strips: &[], factors: [T::from(1.0); 2] }
    }

    /// Coefficient of strip `j`, if it has one of its own [-].
    #[inline]
    pub fn coefficient(&self, j: usize) -> Option<T> {
        self.strips.get(j).map(|own| own.under(&self.factors))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal::LoadedStrip;
    use approx::assert_relative_eq;

    fn strips(friction: &[StripFriction]) -> (Zone, Strips) {
        let mut strips = Strips::with_capacity(1, friction.len());
        for (j, own) in friction.iter().enumerate() {
            let half_length = 1e-3 * (1.0 + j as f64);
            let strip = LoadedStrip { width: 1e-3, half_length, pressure: 1e9, ..<_>::default() };
            strips.push(strip);
            strips.friction.push(*own);
        }
        (Zone { count: friction.len(), ..Zone::default() }, strips)
    }

    #[test]
    fn strips_alike_have_their_mean_to_the_last_bit() {
        for coefficient in [0.1 + 0.2, 1.0 / 3.0, 0.0] {
            let (zone, strips) = strips(&[StripFriction::of(coefficient); 7]);
            let found = mean(&zone, &strips, |own| own.under(&[0.7, 0.7])).unwrap();
            assert_eq!(found.to_bits(), (coefficient * 0.7_f64).to_bits());
        }
    }

    #[test]
    fn the_mean_is_that_of_the_load() {
        let (zone, strips) = strips(&[StripFriction::of(0.1), StripFriction::of(0.4)]);
        let found = mean(&zone, &strips, |own| own.under(&[1.0, 1.0])).unwrap();
        assert_relative_eq!(found, (0.1 + 2.0 * 0.4) / 3.0, max_relative = 1e-15);
        assert!(mean(&zone, &Strips::with_capacity(1, 1), |own| own.tread).is_none());
    }
}
