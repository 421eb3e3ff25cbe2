//! A wheel whose contact is an instance of the FMU.

use anyhow::{Context, Result};
use wheelrail::element::output::{REPORTED_PATCHES, Wrench};
use wheelrail::variables::find;

use crate::importer::{Fmu, Instance, references};
use crate::options::Pair;
use crate::wheelset::record::Patch;
use crate::wheelset::{Moment, Wheel, WheelInput};

const INPUTS: [&str; 14] = [
    "wheel.x",
    "wheel.y",
    "wheel.z",
    "wheel.roll",
    "wheel.yaw",
    "wheel.pitch",
    "wheel.vx",
    "wheel.vy",
    "wheel.vz",
    "wheel.roll_rate",
    "wheel.yaw_rate",
    "wheel.pitch_rate",
    "rail[1].y",
    "track.s",
];

/// Lateral places of rails in the track frame.
const PLACES: [&str; 2] = ["rail[1].position.y", "rail[2].position.y"];

const WRENCH: [&str; 6] = [
    "wheel.force.x",
    "wheel.force.y",
    "wheel.force.z",
    "wheel.moment.x",
    "wheel.moment.y",
    "wheel.moment.z",
];

/// What is read of each patch, in the order of the fields of [`Patch`].
const PATCH: [&str; 8] = [
    "normal_force",
    "contact_angle",
    "rail_y",
    "wheel_y",
    "width",
    "position.y",
    "rolling_radius",
    "max_pressure",
];

/// Whether a run gives the variable `name` its values.
pub fn is_driven(name: &str) -> bool {
    name == "side" || INPUTS.contains(&name)
}

/// A wheel on its rail, computed by the FMU.
pub struct FmuWheel<'fmu> {
    instance: Instance<'fmu>,
    inputs: Vec<u32>,
    wrench: Vec<u32>,
    patch_count: u32,
    patches: Vec<u32>,
    patch_rails: Vec<u32>,
    /// Sets of inputs answered.
    pub evaluations: u64,
    /// Station at which the run starts [m].
    station: f64,
}

impl<'fmu> FmuWheel<'fmu> {
    /// An instance for `side` ("right" or "left"), set up by `settings`, in initialization mode,
    /// for a run that starts at `station` [m].
    pub fn new(
        fmu: &'fmu Fmu,
        side: &str,
        settings: &[(String, String)],
        station: f64,
    ) -> Result<Self> {
        let mut instance = Instance::new(fmu, &format!("{side} wheel"))?;
        instance.set_text("side", side)?;
        for (name, value) in settings {
            // A name with a slip in it gets the nearest one, which the unit's description does not.
            find(name).with_context(|| format!("--set {name}"))?;
            // Rails are placed for the right wheel; the left one is its mirror image.
            match value.parse::<f64>() {
                Ok(y) if side == "left" && PLACES.contains(&name.as_str()) => {
                    instance.set_text(name, &(-y).to_string())?;
                }
                _ => instance.set_text(name, value)?,
            }
        }
        let patch_names: Vec<String> = (1..=REPORTED_PATCHES)
            .flat_map(|k| PATCH.map(|name| format!("patch[{k}].{name}")))
            .collect();
        let rail_names: Vec<String> =
            (1..=REPORTED_PATCHES).map(|k| format!("patch[{k}].rail")).collect();
        let mut wheel = Self {
            inputs: references(&INPUTS)?,
            wrench: references(&WRENCH)?,
            patch_count: references(&["patch_count"])?[0],
            patches: references(&patch_names)?,
            patch_rails: references(&rail_names)?,
            instance,
            evaluations: 0,
            station,
        };
        wheel.instance.set_reals(&references(&["track.s"])?, &[station])?;
        // The starting position belongs to the side; the unit starts as a right wheel.
        if side == "left" {
            wheel.instance.set_reals(&references(&["wheel.y"])?, &[-0.75])?;
        }
        wheel.instance.initialize()?;
        Ok(wheel)
    }

    /// The pair that touches.
    pub fn pair(&mut self) -> Result<Pair> {
        let mut inclination = [0.0];
        self.instance.get_reals(&references(&["rail[1].inclination"])?, &mut inclination)?;
        let mut text = |name| self.instance.get_string(references(&[name])?[0]);
        Ok(Pair {
            wheel_profile: text("wheel.profile")?,
            rail_profile: text("rail[1].profile")?,
            inclination: inclination[0],
        })
    }

    /// Height of the wheel marker at which the wheel touches, at the start position [m].
    pub fn touching_z(&mut self) -> Result<f64> {
        let mut value = [0.0];
        self.instance.get_reals(&references(&["nominal.wheel_z"])?, &mut value)?;
        Ok(value[0])
    }

    /// Leaves initialization; steps follow.
    pub fn start(&mut self) -> Result<()> {
        self.instance.start()
    }

    /// The patches of the last evaluation, heaviest first.
    pub fn patches(&mut self) -> Result<Vec<Patch>> {
        let count = self.instance.get_integer(self.patch_count)?;
        let count =
            usize::try_from(count).context("patch_count is negative")?.min(REPORTED_PATCHES);
        let mut values = vec![0.0; count * PATCH.len()];
        self.instance.get_reals(&self.patches[..values.len()], &mut values)?;
        let rails = self.patch_rails[..count].iter().map(|rail| self.instance.get_integer(*rail));
        let rails = rails.collect::<Result<Vec<i32>>>()?;
        Ok(values
            .chunks_exact(PATCH.len())
            .zip(rails)
            .map(|(v, rail)| Patch {
                rail,
                normal_force: v[0],
                contact_angle: v[1],
                rail_y: v[2],
                wheel_y: v[3],
                width: v[4],
                position_y: v[5],
                rolling_radius: v[6],
                max_pressure: v[7],
            })
            .collect())
    }

    /// Hands out what the unit had to say since the last time.
    pub fn take_messages(&self) -> Vec<String> {
        self.instance.take_messages()
    }

    /// Ends the run.
    pub fn finish(&mut self) -> Result<()> {
        self.instance.terminate()
    }
}

impl Wheel for FmuWheel<'_> {
    fn wrench(&mut self, input: &WheelInput, moment: Moment) -> Result<Wrench> {
        let wheel = &input.wheel;
        let ([x, y, z], [vx, vy, vz]) = (wheel.position, wheel.velocity);
        let values = [
            x,
            y,
            z,
            wheel.roll,
            wheel.yaw,
            wheel.pitch,
            vx,
            vy,
            vz,
            wheel.roll_rate,
            wheel.yaw_rate,
            wheel.pitch_rate,
            input.rail.y,
            self.station + input.station,
        ];
        self.instance.set_reals(&self.inputs, &values)?;
        if let Moment::Step { time, step } = moment {
            self.instance.do_step(time, step)?;
        }
        let mut values = [0.0; WRENCH.len()];
        self.instance.get_reals(&self.wrench, &mut values)?;
        self.evaluations += 1;
        let [fx, fy, fz, mx, my, mz] = values;
        Ok(Wrench { force: [fx, fy, fz], moment: [mx, my, mz] })
    }
}
