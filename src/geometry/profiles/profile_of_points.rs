//! From the points of a file to a profile: mended, placed, checked, smoothed.
//!
//! What is mended stands in the profile's remarks.
//!
//! **Unit.** Points that have the size of a profile only if they are metres instead of millimetres,
//! or the other way round, are read so.
//!
//! **Order and side.** Points are reversed if they run from the field side to the flange (gauge)
//! side. A wheel whose flange goes up or is on the field side is mirrored, and so is a rail whose
//! head lies below its sides, unless its format says which way z points. Of a `MiniProf` rail the
//! gauge side is the one that goes deeper. Points at which the profile doubles back are left out if
//! they are few.
//!
//! **Origin.** A wheel whose points all have y > -5 mm is measured from its flange back, as
//! `MiniProf` does and some SIMPACK files do: its nominal rolling circle is 70 mm from y = 0, and z
//! is counted from the profile there. Any other wheel is taken as it stands, with the nominal
//! rolling circle at y = 0 and the nominal radius at z = 0. A rail is taken as it stands; a
//! `MiniProf` rail gets its origin at its highest point.
//!
//! **Likelihood.** A wheel or rail too narrow for one, and a running circle at the edge or in the
//! flange, are told. A wheel with positive y alone whose flange is at the far end is refused.
//!
//! **Smoothing.** y and z are smoothed as splines over the arc length, so that flanks and vertical
//! faces fare as well as the tread. The strength is a wavelength L: a wave of that length along the
//! profile keeps half its amplitude, one of 2 L 94 %, one of L/2 6 %, whatever the spacing of the
//! points. L = 0 passes through every point. Lines and arcs stay where they are; a step Δκ of the
//! curvature is spread over about L and the profile moves there by 0.16 Δκ (L/2π)². With L = 2 mm
//! that is 1.3 µm on S1002 (flank to flange root, Δκ = 77 1/m), 1.0 µm at the gauge corner of 60E1
//! (from 80 to 13 mm) and 6 µm at the 3 mm fillet under its head. Unless it is given, L follows
//! from the noise of the points ([`point_noise`](crate::geometry::profiles::point_noise)), bounded by
//! what it may do to the surface: 3 µm besides the noise, so that kinks and dents stay.

use crate::geometry::curves::curve::{Curve, Knot};
use crate::geometry::profiles::point_noise::{LONGEST_CHOSEN, chosen_wavelength, noise};
use crate::geometry::profiles::profile::{Profile, ProfileError, ProfileKind, ProfileRemark};
use crate::geometry::profiles::profile_checks::{self, Mirror};
use crate::geometry::profiles::profile_error::rounded_mm;
use crate::geometry::profiles::profile_order;
use crate::geometry::profiles::profile_points::{ProfilePoints, range};
use crate::geometry::profiles::smoothing::{bounded, smooth};
use crate::math::real::Real;

/// Points closer than this to the one before are dropped [m]: no measurement resolves them.
const MERGE_DISTANCE: f64 = 1e-6;
/// The same as a share of the wavelength, which bounds the condition of the smoothing equations.
const MERGE_SHARE: f64 = 1e-3;
/// Distance of the nominal rolling circle from the flange back [m] (EN 13715).
const RUNNING_CIRCLE: f64 = 0.070;
/// A wheel with all points at larger y than this is measured from its flange back [m].
const FLANGE_BACK_TOLERANCE: f64 = -0.005;

impl ProfilePoints {
    /// The profile through the points, smoothed at `wavelength` [m], or as their noise asks if that
    /// is negative.
    pub(crate) fn into_profile(
        mut self,
        kind: ProfileKind,
        wavelength: f64,
    ) -> Result<Profile, ProfileError> {
        let wavelength = self.smoothing.unwrap_or(wavelength);
        profile_checks::enough(&self)?;
        self.mend_unit()?;
        self.run_from_flange();
        // Where the format says that y = 0 is the running circle, it holds for points that reach it.
        let least = if self.origin_is_stated { 0.0 } else { FLANGE_BACK_TOLERANCE };
        let from_flange_back =
            kind == ProfileKind::Wheel && self.points.iter().all(|p| p.point[0] > least);
        if from_flange_back {
            self.check_flange_back()?;
            self.points.iter_mut().for_each(|p| p.point[0] -= RUNNING_CIRCLE);
        }
        self.mend_orientation(kind)?;
        let is_placed = kind == ProfileKind::Rail || from_flange_back;
        let off_circle = || profile_checks::off_circle(&self).filter(|_| !is_placed);
        if let Some(what) = profile_checks::unlikely(&self, kind).or_else(off_circle) {
            let (file, remedy) = (self.file.clone(), self.remedies.units);
            self.remarks.push(ProfileRemark::Unlikely { file, what, remedy });
        }
        self.merge(MERGE_DISTANCE);
        profile_checks::enough(&self)?;
        let is_chosen = wavelength < 0.0;
        let wavelength = if is_chosen { self.choose_wavelength() } else { wavelength };
        self.merge(MERGE_DISTANCE.max(MERGE_SHARE * wavelength));
        self.leave_out_strays(wavelength);
        profile_checks::enough(&self)?;
        let wavelength = if is_chosen { self.bound_wavelength(wavelength) } else { wavelength };
        profile_order::order(&self, wavelength)?;

        let points = self.places();
        let mut knots = smooth(&points, wavelength);
        let profile = |knots: &[Knot]| Profile {
            name: self.file.clone(),
            kind,
            curve: Curve::through(knots),
            remarks: self.remarks.clone(),
        };
        let raw = profile(&knots);
        let origin = if from_flange_back {
            [0.0, height_at_rolling_circle(&raw.curve)]
        } else if kind == ProfileKind::Rail && self.is_measured_rail {
            raw.curve.at(raw.highest()).point
        } else {
            return Ok(raw);
        };
        for knot in &mut knots {
            knot.point = [knot.point[0] - origin[0], knot.point[1] - origin[1]];
        }
        Ok(profile(&knots))
    }

    fn places(&self) -> Vec<[f64; 2]> {
        self.points.iter().map(|p| p.point).collect()
    }

    /// Reads the points in the unit in which they have the size of a profile.
    fn mend_unit(&mut self) -> Result<(), ProfileError> {
        if profile_checks::size(self).is_ok() || self.unit_is_stated {
            return profile_checks::size(self);
        }
        let guess = [("metres", 1e3), ("millimetres", 1e-3)]
            .into_iter()
            .find(|&(_, factor)| profile_checks::is_likely(self, factor));
        if let Some((unit, factor)) = guess {
            self.points.iter_mut().for_each(|p| p.point = p.point.map(|x| x * factor));
            self.last_digit *= factor;
            let (file, remedy) = (self.file.clone(), self.remedies.units);
            self.remarks.push(ProfileRemark::Unit { file, unit, remedy });
        }
        profile_checks::size(self)
    }

    /// Turns points in z, then in y, until they lie as a profile does.
    fn mend_orientation(&mut self, kind: ProfileKind) -> Result<(), ProfileError> {
        if let Some(Mirror { line, what, .. }) =
            profile_checks::orientation(self, kind)?.filter(|mirror| mirror.axis == 1)
        {
            let (file, remedy) = (self.file.clone(), self.remedies.mirror_z);
            if self.direction_is_stated {
                if kind == ProfileKind::Rail {
                    self.remarks.push(ProfileRemark::Groove { file, line, remedy });
                }
            } else {
                self.points.iter_mut().for_each(|p| p.point[1] = -p.point[1]);
                self.remarks.push(ProfileRemark::MirroredZ { file, line, what, remedy });
            }
        }
        let mirrored = profile_checks::orientation(self, kind)?.filter(|mirror| mirror.axis == 0);
        if let Some(Mirror { line, .. }) = mirrored {
            let (file, remedy) = (self.file.clone(), self.remedies.mirror_y);
            self.remarks.push(ProfileRemark::MirroredY { file, line, remedy });
        }
        let other_side = kind == ProfileKind::Rail
            && self.is_measured_rail
            && !self.side_is_stated
            && profile_checks::gauge_side_is_positive(self);
        if mirrored.is_some() || other_side {
            self.points.iter_mut().for_each(|p| p.point[0] = -p.point[0]);
            self.run_from_flange();
        }
        Ok(())
    }

    /// Reverses points that run from the field side to the flange (gauge) side.
    fn run_from_flange(&mut self) {
        let last = self.points.len() - 1;
        if self.points[0].point[0] > self.points[last].point[0] {
            self.points.reverse();
        }
    }

    /// The wavelength that the noise of the points asks for [m].
    fn choose_wavelength(&mut self) -> f64 {
        let points = self.places();
        let noise = noise(&points, self.last_digit);
        let spacing = points.windows(2).map(|p| (p[1][0] - p[0][0]).hypotenuse(p[1][1] - p[0][1]));
        let needed = chosen_wavelength(spacing, noise);
        let wavelength = needed.min(LONGEST_CHOSEN);
        let (file, is_too_noisy) = (self.file.clone(), needed > wavelength);
        self.remarks.push(ProfileRemark::Smoothing { file, noise, wavelength, is_too_noisy });
        wavelength
    }

    /// The longest wavelength up to `wavelength` that leaves the surface where it is: noise is taken
    /// off, kinks and dents stay [m].
    fn bound_wavelength(&mut self, wavelength: f64) -> f64 {
        let points = self.places();
        let remark = self.remarks.iter_mut().rev();
        let found = remark.filter_map(|remark| match remark {
            ProfileRemark::Smoothing { noise, wavelength, .. } => Some((*noise, wavelength)),
            _ => None,
        });
        let Some((noise, told)) = found.into_iter().next() else { return wavelength };
        let bounded = bounded(&points, wavelength, noise);
        *told = bounded;
        bounded
    }

    /// Refuses a wheel that is counted from its flange back and is not there, in the numbers of the
    /// file.
    fn check_flange_back(&self) -> Result<(), ProfileError> {
        let [from, to] = range(&self.points, 0);
        let [from_mm, to_mm] = [from, to].map(rounded_mm);
        let file = self.file.clone();
        if let Some(line) = profile_checks::flange_is_far(self) {
            let remedy = self.remedies.mirror_y;
            return Err(ProfileError::FlangeFar { file, line, from_mm, to_mm, remedy });
        }
        if from < RUNNING_CIRCLE && to > RUNNING_CIRCLE {
            return Ok(());
        }
        let line = self.points[0].line.min(self.points[self.points.len() - 1].line);
        Err(ProfileError::OffRunningCircle { file, line, from_mm, to_mm })
    }

    /// Leaves out points at which the profile doubles back, if few of them set it right.
    fn leave_out_strays(&mut self, wavelength: f64) {
        let strays = profile_order::strays(&self.points, wavelength);
        if !strays.is_empty() {
            self.points.retain(|p| !strays.contains(&p.line));
            let file = self.file.clone();
            self.remarks.push(ProfileRemark::PointsLeftOut { file, lines: strays });
        }
    }

    /// Drops points closer than `distance` to the one kept before.
    fn merge(&mut self, distance: f64) {
        let mut kept: Option<[f64; 2]> = None;
        self.points.retain(|p| {
            let far =
                kept.is_none_or(|k| (p.point[0] - k[0]).hypotenuse(p.point[1] - k[1]) > distance);
            if far {
                kept = Some(p.point);
            }
            far
        });
    }
}

/// z where the curve passes the nominal rolling circle, y = 0, nearest to its field end [m].
fn height_at_rolling_circle(curve: &Curve) -> f64 {
    let knots: Vec<f64> = curve.knots().collect();
    let y = |s: f64| curve.at(s).point[0];
    let Some(pair) = knots.windows(2).rev().find(|p| y(p[0]) <= 0.0 && y(p[1]) > 0.0) else {
        // The points reach over y = 0; smoothing can take that back only at an end.
        return curve.at(curve.end()).point[1];
    };
    let (mut low, mut high) = (pair[0], pair[1]);
    // Bisection to the last digit; this runs once for a file.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if y(middle) <= 0.0 { low = middle } else { high = middle }
    }
    curve.at(low).point[1]
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::geometry::profiles::profile_points::tests::{points_of, sampled};
    use crate::geometry::profiles::standard_profiles::built_in;

    /// Largest distance of the points from the curve [m].
    fn farthest(points: &[[f64; 2]], curve: &Curve) -> f64 {
        let samples: Vec<f64> = (0..=4000)
            .map(|i| curve.start() + (curve.end() - curve.start()) * f64::from(i) / 4e3)
            .collect();
        let distance = |p: &[f64; 2]| {
            let from = |s: f64| {
                let c = curve.at(s).point;
                (p[0] - c[0]).hypotenuse(p[1] - c[1])
            };
            let mut s = *samples.iter().min_by(|a, b| from(**a).total_cmp(&from(**b))).unwrap();
            for _ in 0..4 {
                let c = curve.at(s);
                let along = (p[0] - c.point[0]) * c.first[0] + (p[1] - c.point[1]) * c.first[1];
                s = (s + along).clamp(curve.start(), curve.end());
            }
            from(s)
        };
        points.iter().map(distance).fold(0.0, f64::max)
    }

    #[test]
    fn points_of_a_standard_profile_give_it_back_flanks_and_vertical_sides_included() {
        // Largest step of curvature [1/m]: from the flank to an arc of 13 mm, into a fillet of 3
        // mm.
        let cases =
            [("S1002", ProfileKind::Wheel, 1.0 / 0.013), ("60E1", ProfileKind::Rail, 1.0 / 0.003)];
        for (name, kind, step) in cases {
            let points = sampled(name, kind, 3e-4);
            for wavelength in [0.0, 2e-3] {
                let profile = points_of(&points).into_profile(kind, wavelength).unwrap();
                let moved = farthest(&points, &profile.curve);
                let bound = 0.17 * step * (wavelength / std::f64::consts::TAU).powi(2) + 1e-15;
                assert!(moved < bound, "{name} {moved}");
                let reversed: Vec<_> = points.iter().rev().copied().collect();
                let again = points_of(&reversed).into_profile(kind, wavelength).unwrap();
                assert_eq!(again.curve.start().to_bits(), profile.curve.start().to_bits());
                let s = 0.4 * profile.curve.end();
                assert_relative_eq!(
                    again.curve.at(s).point[0],
                    profile.curve.at(s).point[0],
                    epsilon = 1e-14
                );
            }
        }
    }

    #[test]
    fn dense_noise_and_uneven_spacing_leave_a_parameter_close_to_arc_length() {
        // Twenty thousand points 10 µm apart with 4 µm of noise, seen as steps in both directions.
        let noisy: Vec<[f64; 2]> = sampled("60E1", ProfileKind::Rail, 1e-5)
            .iter()
            .enumerate()
            .map(|(i, p)| {
                let noise = |k: f64| 4e-6 * (k * (i as f64 + 1.0).powi(2)).sin();
                [p[0] + noise(1.3), p[1] + noise(2.7)]
            })
            .filter(|p| p[0] < 0.0 || p[0] > 0.003)
            .collect();
        let profile = points_of(&noisy).into_profile(ProfileKind::Rail, 2e-3).unwrap();
        let exact = built_in("60E1", ProfileKind::Rail).unwrap().unwrap();
        assert_relative_eq!(profile.curve.end(), exact.curve.end(), max_relative = 5e-3);
        for i in 1..2000 {
            let p = profile.curve.at(profile.curve.end() * f64::from(i) / 2000.0);
            assert_relative_eq!(p.first[0].hypotenuse(p.first[1]), 1.0, epsilon = 0.02);
        }
    }

    #[test]
    fn smoothing_takes_the_steps_of_a_coarse_reading_out_of_the_curvature() {
        let rounded: Vec<[f64; 2]> = sampled("60E1", ProfileKind::Rail, 2.5e-4)
            .iter()
            .map(|p| p.map(|x| (x / 1e-5).round() * 1e-5))
            .collect();
        let noise = |wavelength: f64| {
            let profile = points_of(&rounded).into_profile(ProfileKind::Rail, wavelength).unwrap();
            let top: Vec<f64> = (0..=400)
                .map(|i| profile.curve.end() * (0.5 + 5e-5 * f64::from(i - 200)))
                .map(|s| profile.curve.at(s))
                .map(|p| p.first[0] * p.second[1] - p.first[1] * p.second[0] - 1.0 / 0.3)
                .collect();
            (top.iter().map(|c| c * c).sum::<f64>() / top.len() as f64).sqrt()
        };
        let (before, after, more) = (noise(0.0), noise(2e-3), noise(6e-3));
        assert!(after < before / 5.0 && more < after / 20.0, "{before} {after} {more}");
    }

    #[test]
    fn repeated_points_are_merged() {
        let points = sampled("S1002", ProfileKind::Wheel, 5e-4);
        let twice: Vec<[f64; 2]> = points.iter().flat_map(|&p| [p, p]).collect();
        let once = points_of(&points).into_profile(ProfileKind::Wheel, 0.0).unwrap();
        let merged = points_of(&twice).into_profile(ProfileKind::Wheel, 0.0).unwrap();
        assert_eq!(once.curve.knots().count(), merged.curve.knots().count());
    }

    #[test]
    fn twenty_points_are_enough_and_seven_are_not() {
        let points = sampled("arc:0.3", ProfileKind::Rail, 6.5e-3);
        assert!(points.len() <= 21);
        assert!(points_of(&points).into_profile(ProfileKind::Rail, 2e-3).is_ok());
        let error = points_of(&points[..7]).into_profile(ProfileKind::Rail, 0.0).unwrap_err();
        assert!(matches!(error, ProfileError::TooFewPoints { line: 7, found: 7, .. }), "{error}");
    }

    #[test]
    fn a_wheel_measured_from_its_flange_back_is_moved_to_its_nominal_rolling_circle() {
        let points = sampled("S1002", ProfileKind::Wheel, 3e-4);
        let shifted: Vec<_> = points.iter().map(|p| [p[0] + 0.070, p[1] + 0.001]).collect();
        let wheel = points_of(&shifted).into_profile(ProfileKind::Wheel, 0.0).unwrap();
        // Where the flange back bends into an arc, the spline swings over by 1e-8 m.
        assert_relative_eq!(wheel.bounds().y[0], -0.070, epsilon = 2e-8);
        assert_relative_eq!(wheel.bounds().z[1], 0.028, epsilon = 1e-7);
    }

    #[test]
    fn a_rail_gets_its_origin_on_top_if_asked() {
        let points = sampled("60E1", ProfileKind::Rail, 3e-4);
        let shifted: Vec<_> = points.iter().map(|p| [p[0] + 0.01, p[1] + 0.02]).collect();
        let as_it_stands = points_of(&shifted).into_profile(ProfileKind::Rail, 0.0).unwrap();
        assert_relative_eq!(as_it_stands.bounds().z[0], 0.02, epsilon = 1e-9);
        let mut asked = points_of(&shifted);
        asked.is_measured_rail = true;
        let moved = asked.into_profile(ProfileKind::Rail, 0.0).unwrap();
        assert_relative_eq!(moved.bounds().z[0], 0.0, epsilon = 1e-12);
        assert_relative_eq!(moved.bounds().y[1], 0.037_052_3, epsilon = 1e-4);
    }
}
