//! What comments of a profile file, of whatever format, state about it; then nothing is guessed.
//!
//! | comment | meaning |
//! | --- | --- |
//! | `# smoothing_mm 0.5` | wavelength at which this file is to be smoothed, whatever `profile.smoothing` says |
//! | `# unit m` | unit of the columns: `m`, `mm` or `in` |
//! | `# mirror_y 1` | the sign of y, as the format has it, is to be changed (1) or not (0) |
//! | `# mirror_z 0` | the same for z: with 0 a groove is no head that stands upside down |
//! | `# shift_y_mm 57.9` | is added to y, after mirroring; of a wheel y is then 0 on the running circle |
//! | `# shift_z_mm 0` | is added to z |

use crate::geometry::profiles::profile::ProfileError;
use crate::geometry::profiles::profile_points::ProfilePoints;
use crate::io::point_lines::comment_of;
use crate::io::table::{Line, lines, number};

const MM: f64 = 1e-3;
/// Farthest that a profile is shifted [mm]: a file in the frame of the track needs 750.
const FARTHEST: f64 = 2000.0;

pub(crate) const SMOOTHING: &str = "smoothing_mm";
pub(crate) const MIRROR_Z: &str = "mirror_z";

/// What the comments of a file state.
#[derive(Debug, Default)]
pub(crate) struct Stated {
    /// [m]
    smoothing: Option<f64>,
    /// [m]
    pub unit: Option<f64>,
    mirror: [Option<bool>; 2],
    /// [m]
    shift: [Option<f64>; 2],
}

impl Stated {
    /// Reads all comments of a file.
    pub(crate) fn of(file: &str, content: &str) -> Result<Self, ProfileError> {
        let mut found = Self::default();
        for line in lines(content) {
            if let Some(comment) = comment_of(line.text) {
                found.read(file, line, comment)?;
            }
        }
        Ok(found)
    }

    /// Reads a comment; other text than the entries is a comment.
    fn read(&mut self, file: &str, line: Line, comment: &str) -> Result<(), ProfileError> {
        let mut words = comment.split_whitespace();
        let (Some(key), Some(value), None) = (words.next(), words.next(), words.next()) else {
            return Ok(());
        };
        let refused = |allowed| line.refused(file, allowed);
        let flag = || match value {
            "0" => Ok(Some(false)),
            "1" => Ok(Some(true)),
            _ => Err(refused("mirror_y and mirror_z are 0 (no) or 1 (yes)")),
        };
        let shift = || {
            let mm = number(value).filter(|mm| mm.abs() <= FARTHEST);
            let allowed = "shift_y_mm and shift_z_mm are distances of up to 2000 mm";
            mm.map(|mm| Some(MM * mm)).ok_or_else(|| refused(allowed))
        };
        match key {
            SMOOTHING => {
                let wavelength = number(value).map(|mm| MM * mm);
                let admitted = wavelength.filter(|w| (0.0..=0.05).contains(w));
                let allowed = "smoothing_mm is a wavelength from 0 (no smoothing) to 50 mm";
                self.smoothing = Some(admitted.ok_or_else(|| refused(allowed))?);
            }
            "unit" => {
                let unit = match value {
                    "m" => 1.0,
                    "mm" => MM,
                    "in" => 0.0254,
                    _ => return Err(refused("the unit is m, mm or in")),
                };
                self.unit = Some(unit);
            }
            "mirror_y" => self.mirror[0] = flag()?,
            MIRROR_Z => self.mirror[1] = flag()?,
            "shift_y_mm" => self.shift[0] = shift()?,
            "shift_z_mm" => self.shift[1] = shift()?,
            _ => {}
        }
        Ok(())
    }

    /// The points as the comments have them.
    pub(crate) fn apply(&self, mut points: ProfilePoints) -> ProfilePoints {
        let sign = self.mirror.map(|mirror| if mirror == Some(true) { -1.0 } else { 1.0 });
        let shift = self.shift.map(|shift| shift.unwrap_or(0.0));
        for p in &mut points.points {
            p.point = [0, 1].map(|i| sign[i] * p.point[i] + shift[i]);
        }
        points.unit_is_stated |= self.unit.is_some();
        points.direction_is_stated |= self.mirror[1].is_some();
        points.side_is_stated |= self.mirror[0].is_some();
        points.origin_is_stated |= self.shift.iter().any(Option::is_some);
        points.smoothing = self.smoothing.or(points.smoothing);
        points
    }
}
