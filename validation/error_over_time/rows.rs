//! What is known of the models that are compared.

use crate::choices::{Choice, Normal, Rolling};

/// What is known of a normal model.
pub struct NormalRow {
    /// The model.
    pub normal: Normal,
    /// Median and worst of load, pressure and area against CONTACT, one region; worst of two
    /// regions.
    pub contact: [[f64; 3]; 3],
    /// Mean error of the greatest pressure against CONTACT, all 32.
    pub mean_pressure: f64,
    /// Median and worst of the same against boundary elements on a wheel.
    pub wheel: [[f64; 2]; 3],
    /// Planar cases that fell back.
    pub fallbacks: usize,
    /// Time without creep force at each place, height given [s].
    pub times: Vec<f64>,
    /// The same on the tread, load given [s].
    pub load_time: f64,
}

/// What is known of a combination.
pub struct Row {
    /// Its models.
    pub choice: Choice,
    /// Mean, 95 % and worst of the creep force against CONTACT on real patches.
    pub contact: [f64; 3],
    /// Mean of the moment.
    pub moment: f64,
    /// Mean, 95 % and worst of the creep force against boundary elements on a wheel.
    pub wheel: [f64; 3],
    /// Time at each place, height given [s].
    pub times: Vec<f64>,
    /// Time on the tread, load given [s].
    pub load_time: f64,
    /// Instructions on the tread, height given and load given.
    pub instructions: [Option<f64>; 2],
}

/// What is known of a tangential model by itself.
pub struct EllipseRow {
    /// The model.
    pub rolling: Rolling,
    /// Mean, 95 % and worst of the creep force against CONTACT on 300 ellipses.
    pub errors: [f64; 3],
}
