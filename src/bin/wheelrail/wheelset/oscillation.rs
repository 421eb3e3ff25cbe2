//! Wavelength and decay of an oscillation about zero, from samples over distance.

/// What is seen of an oscillation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillation {
    /// Distance of crossings of zero in the same direction, mean over the samples [m].
    pub wavelength: f64,
    /// Amplitude one wavelength later over amplitude, mean over the samples [-].
    pub decay: f64,
}

/// The oscillation in `samples` of (distance, deviation), by at least three crossings of zero;
/// `None` with fewer. Samples before the first and after the last crossing are not used.
pub fn oscillation(samples: &[(f64, f64)]) -> Option<Oscillation> {
    let mut crossings: Vec<f64> = Vec::new();
    let mut peaks: Vec<f64> = Vec::new();
    let mut peak = 0.0_f64;
    for pair in samples.windows(2) {
        let ((s0, y0), (s1, y1)) = (pair[0], pair[1]);
        peak = peak.max(y0.abs());
        if y0 * y1 < 0.0 || (y1 == 0.0 && y0 != 0.0) {
            if !crossings.is_empty() {
                peaks.push(peak);
            }
            crossings.push(s0 + (s1 - s0) * y0 / (y0 - y1));
            peak = 0.0;
        }
    }
    if crossings.len() < 3 {
        return None;
    }
    let half_waves = (crossings.len() - 1) as f64;
    let wavelength = 2.0 * (crossings[crossings.len() - 1] - crossings[0]) / half_waves;
    let between_peaks = (peaks.len() - 1) as f64;
    let decay = (peaks[peaks.len() - 1] / peaks[0]).powf(2.0 / between_peaks);
    Some(Oscillation { wavelength, decay })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decaying_wave_is_measured() {
        let wave = |s: f64| (-0.1 * s).exp() * (2.0 * std::f64::consts::PI * s / 7.0).sin();
        let samples: Vec<(f64, f64)> =
            (0..3000).map(|i| 0.01 * f64::from(i) + 0.5).map(|s| (s, wave(s))).collect();
        let found = oscillation(&samples).unwrap();
        approx::assert_relative_eq!(found.wavelength, 7.0, max_relative = 1e-4);
        approx::assert_relative_eq!(found.decay, (-0.7f64).exp(), max_relative = 1e-3);
    }

    #[test]
    fn a_deviation_that_only_dies_out_is_no_oscillation() {
        let samples: Vec<(f64, f64)> =
            (0..100).map(|i| (f64::from(i), (-0.1 * f64::from(i)).exp())).collect();
        assert_eq!(oscillation(&samples), None);
    }
}
