//! Tables of friction over the surface of a rail, at stations along the track.

use crate::math::real::Real;

/// What tells a place across a rail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    /// Inclination of its surface, negative towards its gauge face [rad].
    Inclination,
    /// Arc from its highest point, negative towards its gauge face [m].
    Place,
}

/// Friction across a rail at one station: linear between the points, constant beyond the outermost ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Station along the track [m].
    pub station: f64,
    /// Place across the rail [rad or m] and coefficient [-], in growing places; at least one.
    pub points: Vec<[f64; 2]>,
}

/// Friction over the surface of a rail: linear between its stations, constant beyond the first and the last.
#[derive(Clone, Debug, PartialEq)]
pub struct FrictionProfile {
    /// What tells a place across the rail.
    pub across: Across,
    /// Tables in growing stations; at least one.
    pub sections: Vec<Section>,
}

impl Section {
    /// Coefficient of friction at `place` [-].
    #[inline]
    #[must_use]
    pub fn coefficient<T: Real>(&self, place: T) -> T {
        interpolated(&self.points, place, |point| point[0], |point| T::from(point[1]))
    }
}

impl FrictionProfile {
    /// Coefficient of friction at `place` across the rail and `station` along the track [-].
    #[inline]
    #[must_use]
    pub fn coefficient<T: Real>(&self, place: T, station: T) -> T {
        if let [everywhere] = self.sections.as_slice() {
            return everywhere.coefficient(place);
        }
        interpolated(&self.sections, station, |s| s.station, |s| s.coefficient(place))
    }

    /// Whether friction changes along the track.
    #[must_use]
    pub fn has_stations(&self) -> bool {
        self.sections.len() > 1
    }
}

/// `value` at `x` between the nodes of a table, of which there is at least one and whose abscissae grow; that of the outermost node beyond.
/// Between nodes alike it is theirs to the last bit.
fn interpolated<T: Real, N>(
    nodes: &[N],
    x: T,
    abscissa: impl Fn(&N) -> f64,
    value: impl Fn(&N) -> T,
) -> T {
    let next = nodes.partition_point(|node| abscissa(node) <= x.value());
    let Some(after) = nodes.get(next) else { return value(&nodes[nodes.len() - 1]) };
    let Some(before) = next.checked_sub(1).map(|k| &nodes[k]) else { return value(after) };
    let (from, start) = (value(before), abscissa(before));
    let share = (x - start) / (abscissa(after) - start);
    from + share * (value(after) - from)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dual::Dual;
    use approx::assert_relative_eq;

    fn profile() -> FrictionProfile {
        let section = |station, points: &[[f64; 2]]| Section { station, points: points.to_vec() };
        FrictionProfile {
            across: Across::Inclination,
            sections: vec![
                section(10.0, &[[-0.4, 0.2], [-0.2, 0.3]]),
                section(30.0, &[[0.0, 0.5]]),
            ],
        }
    }

    #[test]
    fn friction_is_linear_between_points_and_stations_and_constant_beyond() {
        for (place, station, expected) in [
            (-1.0, 0.0, 0.2),
            (-0.3, 10.0, 0.25),
            (-0.2, 0.0, 0.3),
            (1.0, 0.0, 0.3),
            (-0.3, 20.0, 0.375),
            (-0.3, 30.0, 0.5),
            (-0.3, 1e6, 0.5),
        ] {
            assert_relative_eq!(profile().coefficient(place, station), expected, epsilon = 1e-15);
        }
    }

    #[test]
    fn its_derivatives_are_the_slopes_of_the_table() {
        let number = |value, slopes| Dual::<2> { value, slopes };
        let found = profile().coefficient(number(-0.3, [1.0, 0.0]), number(15.0, [0.0, 1.0]));
        assert_relative_eq!(found.slopes[0], 0.75 * 0.5, max_relative = 1e-12);
        assert_relative_eq!(found.slopes[1], (0.5 - 0.25) / 20.0, max_relative = 1e-12);
    }

    #[test]
    fn a_constant_table_is_constant_to_the_last_bit() {
        let constant = 1.0 / 3.0;
        let points: Vec<[f64; 2]> = [-0.7, -0.31, 0.02].map(|x| [x, constant]).to_vec();
        let sections = [0.0, 7.3].map(|station| Section { station, points: points.clone() });
        let profile = FrictionProfile { across: Across::Place, sections: sections.to_vec() };
        for i in 0..100 {
            let x = -1.0 + 0.017 * f64::from(i);
            assert_eq!(profile.coefficient(x, 8.0 * x).to_bits(), constant.to_bits());
        }
    }
}
