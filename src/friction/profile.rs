//! Tables of friction over the surface of a rail, at stations along the track.

use super::table::Table;
use crate::math::real::Real;

/// What tells a place across a rail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    /// Inclination of its surface, negative towards its gauge face [rad].
    Inclination,
    /// Arc from its highest point, negative towards its gauge face [m].
    Place,
}

/// Friction across a rail at one station: linear between the points, constant beyond the outermost
/// ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Station along the track [m].
    pub station: f64,
    /// Place across the rail [rad or m] and coefficient [-], in growing places; at least one.
    pub points: Vec<[f64; 2]>,
}

/// Friction over the surface of a rail: linear between its stations, constant beyond the first and
/// the last.
#[derive(Clone, Debug, PartialEq)]
pub struct FrictionProfile {
    /// What tells a place across the rail.
    pub across: Across,
    /// Tables in growing stations; at least one.
    pub sections: Vec<Section>,
}

/// A profile of friction as it is looked up.
#[derive(Clone, Debug)]
pub struct FrictionTables {
    /// Stations along the track [m] and the tables there.
    sections: Vec<(f64, Table)>,
}

impl FrictionProfile {
    /// As it is looked up; its arguments across the rail are places, or directions of tangents
    /// where the profile is one of inclinations.
    pub fn tables(&self) -> FrictionTables {
        let table = match self.across {
            Across::Inclination => Table::over_inclination,
            Across::Place => Table::over_place,
        };
        let sections = self.sections.iter().map(|own| (own.station, table(&own.points)));
        FrictionTables { sections: sections.collect() }
    }
}

impl FrictionTables {
    /// Coefficient of friction at the argument `across` the rail and `station` along the track
    /// [m, -]; `last` as in [`Table::at`].
    #[inline(always)]
    pub fn at<T: Real>(&self, across: T, station: T, last: &mut usize) -> T {
        if let [(_, everywhere)] = self.sections.as_slice() {
            return everywhere.at(across, last);
        }
        self.between(across, station, last)
    }

    fn between<T: Real>(&self, across: T, station: T, last: &mut usize) -> T {
        let next = self.sections.partition_point(|section| section.0 <= station.value());
        let Some((end, after)) = self.sections.get(next) else {
            return self.sections[self.sections.len() - 1].1.at(across, last);
        };
        let Some((start, before)) = next.checked_sub(1).map(|k| &self.sections[k]) else {
            return after.at(across, last);
        };
        let from = before.at(across, last);
        let share = (station - *start) / (end - start);
        // Between tables alike it is theirs to the last bit.
        from + share * (after.at(across, last) - from)
    }

    /// Whether friction changes along the track.
    pub fn has_stations(&self) -> bool {
        self.sections.len() > 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::direction;
    use crate::friction::table::OFF;
    use crate::math::dual::Dual;
    use approx::assert_relative_eq;

    fn tables(across: Across) -> FrictionTables {
        let section = |station, points: &[[f64; 2]]| Section { station, points: points.to_vec() };
        let sections =
            vec![section(10.0, &[[-0.4, 0.2], [-0.2, 0.3]]), section(30.0, &[[0.0, 0.5]])];
        FrictionProfile { across, sections }.tables()
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
            let found: f64 = tables(Across::Place).at(place, station, &mut 0);
            assert_relative_eq!(found, expected, epsilon = 1e-15);
            let tangent = [f64::cos(place), f64::sin(place)];
            let found: f64 = tables(Across::Inclination).at(direction(tangent), station, &mut 0);
            assert_relative_eq!(found, expected, epsilon = 0.5 * OFF);
        }
    }

    #[test]
    fn its_derivatives_are_the_slopes_of_the_table() {
        let number = |value, slopes| Dual::<2> { value, slopes };
        let place = number(-0.3, [1.0, 0.0]);
        let found = tables(Across::Place).at(place, number(15.0, [0.0, 1.0]), &mut 0);
        assert_relative_eq!(found.slopes[0], 0.75 * 0.5, max_relative = 1e-12);
        assert_relative_eq!(found.slopes[1], (0.5 - 0.25) / 20.0, max_relative = 1e-12);
    }
}
