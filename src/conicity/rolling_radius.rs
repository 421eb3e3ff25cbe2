//! Rolling radii of a wheelset that stands displaced on its track.

use super::RollingRadiusDifference;
use crate::element::parameters::{Side, TangentialModel, VerticalMode};
use crate::element::{Element, Input, Output, Parameters};
use crate::error::ContactError;
use crate::geometry::profiles::profile::ProfileRemark;
use std::path::PathBuf;

/// Depth below first touch at which the contact is looked at: deep enough to be found, too little
/// to move it [m].
const TOUCH: f64 = 1e-10;

/// Two wheels on two rails, rigid: each wheel touches its rail at one point.
///
/// As in EN 15302 the wheelset does not roll when it is displaced: both profiles are shifted as
/// they are.
#[derive(Clone, Debug)]
pub struct TrackedWheelset {
    /// Right and left.
    wheels: [Element; 2],
    half_distance: f64,
}

/// Rolling radii at one displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct RollingRadii {
    /// Lateral displacement of the wheelset, to the right [m].
    pub displacement: f64,
    /// Rolling radius at the contact point of the right and of the left wheel [m].
    pub radius: [f64; 2],
    /// Place of the contact point on the profiles of the right and of the left wheel, positive to
    /// the field side [m].
    pub wheel_y: [f64; 2],
    /// Place on the profiles of the right and of the left rail, positive to the field side [m].
    pub rail_y: [f64; 2],
}

impl RollingRadii {
    /// Δr = r_right - r_left [m].
    pub fn difference(&self) -> f64 {
        self.radius[0] - self.radius[1]
    }
}

impl TrackedWheelset {
    /// A wheelset of two wheels of `parameters`, whose nominal rolling circles are
    /// `running_circles` apart [m]; profiles are looked for in the folders as in [`Element::new`].
    ///
    /// # Errors
    /// The parameter or profile at fault, by its FMU name.
    pub fn new(
        parameters: &Parameters,
        running_circles: f64,
        profile_folders: &[PathBuf],
    ) -> Result<Self, ContactError> {
        if !(running_circles.is_finite() && running_circles > 0.0) {
            let allowed = "a finite number of metres above 0";
            return Err(ContactError::bad_value("running_circles", running_circles, allowed));
        }
        let half_distance = 0.5 * running_circles;
        let wheel = |side: Side| {
            let parameters = Parameters {
                vertical_mode: VerticalMode::Penetration,
                tangential_model: TangentialModel::None,
                ..parameters.on_side(side)
            };
            Element::new(&parameters, &standing(side, half_distance, 0.0), profile_folders)
        };
        Ok(Self { wheels: [wheel(Side::Right)?, wheel(Side::Left)?], half_distance })
    }

    /// What was found and mended in the files of the profiles, which both wheels share, with the
    /// parameter that names each file.
    pub fn profile_remarks(&self) -> &[(String, ProfileRemark)] {
        self.wheels[0].profile_remarks()
    }

    /// The rolling radii when the wheelset is displaced to the right by `displacement` [m]; nothing
    /// where a wheel stands beside its rail.
    pub fn rolling_radii(&mut self, displacement: f64) -> Option<RollingRadii> {
        let mut radii =
            RollingRadii { displacement, radius: [0.0; 2], wheel_y: [0.0; 2], rail_y: [0.0; 2] };
        let mut output = Output::default();
        for (k, side) in [Side::Right, Side::Left].into_iter().enumerate() {
            let element = &mut self.wheels[k];
            let mut input = standing(side, self.half_distance, displacement);
            input.wheel.position[2] = element.touching_height(&input) + TOUCH;
            // The displacement is a finite number or the result is: none.
            element.evaluate(&input, &mut output).ok()?;
            let patch = output.patches[0];
            if patch.rail == 0 {
                return None;
            }
            radii.radius[k] = patch.rolling_radius;
            radii.wheel_y[k] = patch.wheel_y;
            radii.rail_y[k] = patch.rail_y;
        }
        Some(radii)
    }

    /// Rolling radii at steps of `step` from `-range` to `range`, or as far as both wheels stand on
    /// their rails [m].
    pub fn sweep(&mut self, range: f64, step: f64) -> Vec<RollingRadii> {
        let count = (range / step).round() as i32;
        let all = (-count..=count).map(|i| self.rolling_radii(f64::from(i) * step));
        let all: Vec<Option<RollingRadii>> = all.collect();
        // The stretch about the middle without gaps.
        let middle = all.len() / 2;
        let left = all[..middle].iter().rev().take_while(|r| r.is_some()).count();
        all.into_iter().skip(middle - left).map_while(|radii| radii).collect()
    }
}

impl RollingRadiusDifference {
    /// From at least two positions of a wheelset; nothing with fewer.
    pub fn of(radii: &[RollingRadii]) -> Option<Self> {
        let points = radii.iter().map(|r| [r.displacement, r.difference()]).collect();
        (radii.len() >= 2).then(|| Self::new(points))
    }
}

/// A wheel that stands still, its wheelset displaced to the right.
fn standing(side: Side, half_distance: f64, displacement: f64) -> Input {
    let sign = if side == Side::Left { -1.0 } else { 1.0 };
    let mut input = Input::default();
    input.wheel.position[1] = sign * half_distance + displacement;
    input
}
