//! What a reader has found in the file of a profile.

use crate::geometry::profiles::profile_remark::ProfileRemark;
use crate::math::real::Real;

/// A point of a file and the line it stands on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FilePoint {
    /// y, z in the profile frame [m].
    pub point: [f64; 2],
    /// Line in the file, from 1.
    pub line: usize,
}

/// Advice in the terms of a file format.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Remedies {
    /// How to state the unit of length.
    pub units: &'static str,
    /// How to mirror y.
    pub mirror_y: &'static str,
    /// How to mirror z.
    pub mirror_z: &'static str,
}

/// What a reader has found in a file: y to the field side, z down [m].
// Each is a fact by itself: what the file states is not guessed.
#[allow(clippy::struct_excessive_bools)]
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ProfilePoints {
    /// The file, for messages.
    pub file: String,
    /// The points in the order of the file.
    pub points: Vec<FilePoint>,
    /// Distance of two numbers that differ in their last digit [m]; 0 where there are too many
    /// digits to tell.
    pub last_digit: f64,
    /// Whether the file says in which unit it is.
    pub unit_is_stated: bool,
    /// Whether the format or the file says which way z points.
    pub direction_is_stated: bool,
    /// Whether the file says on which side the flange, or the gauge, is.
    pub side_is_stated: bool,
    /// Whether the format or the file says where y = 0 is.
    pub origin_is_stated: bool,
    /// Whether a rail is as an instrument sees it: its gauge side the one that goes deeper, its
    /// origin to be at its highest point.
    pub is_measured_rail: bool,
    /// Wavelength of the smoothing that the file itself asks for [m].
    pub smoothing: Option<f64>,
    /// Advice in the terms of the format.
    pub remedies: Remedies,
    /// What the reader has mended.
    pub remarks: Vec<ProfileRemark>,
}

/// Least and greatest coordinate along an axis [m].
pub(crate) fn range(points: &[FilePoint], axis: usize) -> [f64; 2] {
    points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| {
        [low.min(p.point[axis]), high.max(p.point[axis])]
    })
}

/// Diagonal of the smallest rectangle that holds the points [m].
pub(crate) fn extent(points: &[FilePoint]) -> f64 {
    let [y, z] = [0, 1].map(|i| range(points, i));
    (y[1] - y[0]).hypotenuse(z[1] - z[0])
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::geometry::profiles::profile::ProfileKind;
    use crate::geometry::profiles::standard_profiles::built_in;

    pub(crate) const REMEDIES: Remedies =
        Remedies { units: "do units", mirror_y: "do mirror y", mirror_z: "do mirror z" };

    pub(crate) fn points_of(points: &[[f64; 2]]) -> ProfilePoints {
        ProfilePoints {
            file: "file.txt".into(),
            points: (1..).zip(points).map(|(line, &point)| FilePoint { point, line }).collect(),
            remedies: REMEDIES,
            ..ProfilePoints::default()
        }
    }

    /// Points moved across and along by nearly normal noise of a standard deviation [m].
    pub(crate) fn with_noise(points: &[[f64; 2]], size: f64, seed: u64) -> Vec<[f64; 2]> {
        let mut state = seed;
        let mut even = || {
            // Knuth's linear congruential generator (MMIX), its upper half.
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 32) as f64 / f64::from(u32::MAX) - 0.5
        };
        // Twelve even numbers have the variance 1.
        points.iter().map(|p| p.map(|x| x + size * (0..12).map(|_| even()).sum::<f64>())).collect()
    }

    /// Points of a built-in profile, `distance` apart [m].
    pub(crate) fn sampled(name: &str, kind: ProfileKind, distance: f64) -> Vec<[f64; 2]> {
        let curve = built_in(name, kind).unwrap().unwrap().curve;
        let count = ((curve.end() - curve.start()) / distance).round();
        (0..=count as usize)
            .map(|i| curve.start() + (curve.end() - curve.start()) * i as f64 / count)
            .map(|s| curve.at(s).point)
            .collect()
    }
}
