//! What was found in the file of a profile, and what was mended.

use std::fmt;

use crate::geometry::profiles::point_noise::CURVATURE_NOISE;

/// Something that whoever gave the file should know. Coordinates in messages are in millimetres, as
/// in the files.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
// Fields are what the text says of them.
#[allow(missing_docs)]
pub enum ProfileRemark {
    /// Noise that was found in the points, and the smoothing chosen for it.
    Smoothing {
        file: String,
        /// Standard deviation of the points [m].
        noise: f64,
        /// Wavelength that keeps half its amplitude; 0 where the curve goes through the points [m].
        wavelength: f64,
        /// Whether the noise would need a longer wavelength than is chosen.
        is_too_noisy: bool,
    },
    /// A line before the first point that is none.
    LinePassedOver { file: String, line: usize, text: String },
    /// Points in another unit than the format or its header says.
    Unit {
        file: String,
        unit: &'static str,
        /// How the file would say so.
        remedy: &'static str,
    },
    /// A profile that stood on its head and was turned up.
    MirroredZ { file: String, line: usize, what: &'static str, remedy: &'static str },
    /// A wheel with its flange on the field side, turned left to right.
    MirroredY { file: String, line: usize, remedy: &'static str },
    /// A rail whose middle is lower than its sides, taken as it stands.
    Groove { file: String, line: usize, remedy: &'static str },
    /// A profile of unlikely width or with an unlikely running circle, taken as it stands.
    Unlikely { file: String, what: String, remedy: &'static str },
    /// The same of many sections of a body that varies.
    Repeated { first: Box<ProfileRemark>, others: usize },
    /// Points at which the profile doubles back, left out.
    PointsLeftOut { file: String, lines: Vec<usize> },
}

impl ProfileRemark {
    /// Whether something was mended or is suspect, so that the file should be looked at.
    pub fn is_warning(&self) -> bool {
        match self {
            Self::Smoothing { is_too_noisy, .. } => *is_too_noisy,
            Self::Repeated { first, .. } => first.is_warning(),
            _ => true,
        }
    }
}

impl fmt::Display for ProfileRemark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Smoothing { file, noise, wavelength, is_too_noisy } => {
                let (size, unit) =
                    if *noise < 1e-7 { (1e9 * noise, "nm") } else { (1e6 * noise, "um") };
                if *wavelength > 0.0 {
                    let mm = 1e3 * wavelength;
                    write!(
                        f,
                        "{file}: noise of {size:.2} {unit} found, smoothed with a wavelength of {mm:.2} mm"
                    )?;
                } else {
                    write!(f, "{file}: noise of {size:.2} {unit} found, no smoothing needed")?;
                }
                if *is_too_noisy {
                    write!(
                        f,
                        "; that leaves more than {CURVATURE_NOISE} 1/m in the curvature: measure the profile again, or set profile.smoothing"
                    )?;
                }
                Ok(())
            }
            Self::LinePassedOver { file, line, text } => {
                write!(f, "{file}:{line}: \"{text}\" is no point and was passed over")
            }
            Self::Unit { file, unit, remedy } => {
                write!(f, "{file}: read in {unit}, in which it has the size of a profile; {remedy}")
            }
            Self::MirroredZ { file, line, what, remedy } => {
                write!(f, "{file}:{line}: mirrored in z, since {what}; in the file: {remedy}")
            }
            Self::MirroredY { file, line, remedy } => write!(
                f,
                "{file}:{line}: mirrored in y, since the flange is at positive y, the field side; in the file: {remedy}"
            ),
            Self::Groove { file, line, remedy } => write!(
                f,
                "{file}:{line}: the rail lies lower in its middle than at its sides and is taken as it stands; if it is a head, mirror it: \
                 {remedy}"
            ),
            Self::Unlikely { file, what, remedy } => {
                write!(
                    f,
                    "{file}: {what}; taken as it stands: check the file, its origin and its unit ({remedy})"
                )
            }
            Self::Repeated { first, others } => {
                write!(f, "{first}; and the same in {others} other sections")
            }
            Self::PointsLeftOut { file, lines } => {
                let lines: Vec<String> = lines.iter().map(ToString::to_string).collect();
                write!(
                    f,
                    "{file}: the profile doubles back at {} of its points, which were left out: lines {}",
                    lines.len(),
                    lines.join(", ")
                )
            }
        }
    }
}
