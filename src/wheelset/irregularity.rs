//! Irregularities of the rails over the station, from a file.

use std::path::PathBuf;

use super::input::Input;
use super::track::RailLine;
use crate::error::ContactError;
use crate::geometry::uneven::waviness::Waviness;
use crate::io::load_irregularities;

/// Name of the parameter.
const PARAMETER: &str = "track.irregularity.file";

/// Lines of the rails of both sides, right first: lateral and vertical deviations over the station,
/// twice differentiable; rails go on level beyond the ends.
#[derive(Clone, Debug)]
pub struct Irregularities([[Waviness; 2]; 2]);

impl Irregularities {
    /// Of the file `name`; none without a name.
    ///
    /// # Errors
    /// A file that cannot be used.
    pub fn load(name: &str, folders: &[PathBuf]) -> Result<Option<Self>, ContactError> {
        if name.is_empty() {
            return Ok(None);
        }
        let columns = load_irregularities(PARAMETER, name, folders)?;
        let [right_y, right_z, left_y, left_z] = columns.map(|points| {
            let mut line = Waviness::new(None);
            line.set_table(&points);
            line
        });
        Ok(Some(Self([[right_y, right_z], [left_y, left_z]])))
    }

    /// Adds them to the lines of the rails in `input`, at its station.
    pub fn add(&self, input: &mut Input) {
        let station = input.track_s + input.wheelset.position[0];
        for (side, [y, z]) in input.sides.iter_mut().zip(&self.0) {
            let ([y, y_slope, _], [z, z_slope, _]) = (y.at(station), z.at(station));
            side.line += RailLine { y, z, y_slope, z_slope };
        }
    }

    /// Adds the rates that they have at `input` in the direction `direction` to that.
    pub fn add_rates(&self, input: &Input, direction: &mut Input) {
        let station = input.track_s + input.wheelset.position[0];
        let rate = direction.track_s + direction.wheelset.position[0];
        for (side, [y, z]) in direction.sides.iter_mut().zip(&self.0) {
            let ([_, y, y_slope], [_, z, z_slope]) = (y.at(station), z.at(station));
            let [y, z, y_slope, z_slope] = [y, z, y_slope, z_slope].map(|slope| rate * slope);
            side.line += RailLine { y, z, y_slope, z_slope };
        }
    }
}
