//! Course of the track: straight, with one lateral ramp.

/// Shape of the ramp.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum RampShape {
    /// Constant slope: the rails' lateral velocity jumps at both ends.
    #[default]
    Linear,
    /// Half a cosine wave: without a kink.
    Cosine,
}

/// A track that is straight but for one lateral ramp of both rails.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Track {
    /// Where the ramp begins [m].
    pub ramp_start: f64,
    /// Length of the ramp, > 0 [m].
    pub ramp_length: f64,
    /// Lateral displacement of the track by the ramp, to the right [m].
    pub ramp: f64,
    /// Shape of the ramp.
    pub shape: RampShape,
}

/// Lateral position of the track's centre line and its slope.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lateral {
    /// Position, to the right [m].
    pub position: f64,
    /// Derivative along the track [-].
    pub slope: f64,
}

impl Track {
    /// The centre line at `distance` [m].
    pub fn lateral(&self, distance: f64) -> Lateral {
        let u = (distance - self.ramp_start) / self.ramp_length;
        if u <= 0.0 {
            return Lateral::default();
        }
        if u >= 1.0 {
            return Lateral { position: self.ramp, slope: 0.0 };
        }
        let (share, slope) = match self.shape {
            RampShape::Linear => (u, 1.0),
            RampShape::Cosine => {
                let (sin, cos) = (std::f64::consts::PI * u).sin_cos();
                (0.5 * (1.0 - cos), 0.5 * std::f64::consts::PI * sin)
            }
        };
        Lateral { position: self.ramp * share, slope: self.ramp * slope / self.ramp_length }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_derivatives_and_the_ramp_is_reached() {
        for shape in [RampShape::Linear, RampShape::Cosine] {
            let track = Track { ramp_start: 5.0, ramp_length: 1.0, ramp: 0.005, shape };
            assert_eq!(track.lateral(4.9), Lateral::default());
            assert_eq!(track.lateral(6.1), Lateral { position: 0.005, slope: 0.0 });
            for s in [5.1, 5.5, 5.8] {
                let rise = track.lateral(s + 1e-6).position - track.lateral(s - 1e-6).position;
                approx::assert_relative_eq!(track.lateral(s).slope, rise / 2e-6, epsilon = 1e-8);
            }
        }
    }
}
