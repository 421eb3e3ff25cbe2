//! Sums of what is worn off, smoothed by a positive kernel that keeps them.

/// Standard deviation of the kernel that halves a wave, over the length of the wave: sqrt(ln
/// 2/2)/π.
const DEVIATION: f64 = 0.187_390_6;
/// Half length of the kernel in standard deviations: beyond lie 6e-7 of it, which go to the rest.
const KERNEL_REACH: f64 = 5.0;

/// Puts the sums `total` of cells of length `cell` [m] under a Gaussian kernel that halves waves of
/// `wavelength` [m] into `smoothed`; at the ends they go on mirrored, so that nothing is lost.
/// `kernel` is scratch of at most as many numbers.
pub(super) fn smooth(
    total: &[f64],
    cell: f64,
    wavelength: f64,
    kernel: &mut Vec<f64>,
    smoothed: &mut Vec<f64>,
) {
    smoothed.clear();
    let deviation = DEVIATION * wavelength / cell;
    let reach = ((KERNEL_REACH * deviation).ceil() as usize).min(total.len() - 1);
    if reach == 0 {
        smoothed.extend_from_slice(total);
        return;
    }
    kernel.clear();
    kernel.extend((0..=reach).map(|i| (-0.5 * (i as f64 / deviation).powi(2)).exp()));
    let sum = 2.0 * kernel.iter().sum::<f64>() - kernel[0];
    for weight in &mut *kernel {
        *weight /= sum;
    }
    let last = total.len() as isize - 1;
    smoothed.resize(total.len(), 0.0);
    for (i, value) in total.iter().enumerate().filter(|(_, value)| **value > 0.0) {
        for (offset, weight) in kernel.iter().enumerate() {
            let ends = if offset == 0 { 1 } else { 2 };
            for sign in [-1, 1].into_iter().take(ends) {
                let at = i as isize + sign * offset as isize;
                let at = if at < 0 { -1 - at } else { at };
                let at = if at > last { 2 * last + 1 - at } else { at };
                smoothed[at as usize] += weight * value;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn smoothing_halves_the_stated_wave_and_keeps_the_sum() {
        let (n, cell) = (800, 2.5e-4);
        let wave = |i: usize| 1.0 + (std::f64::consts::TAU * i as f64 * cell / 4e-3).cos();
        let total: Vec<f64> = (0..n).map(wave).collect();
        let (mut kernel, mut smoothed) = (Vec::new(), Vec::new());
        smooth(&total, cell, 4e-3, &mut kernel, &mut smoothed);
        assert_relative_eq!(
            smoothed.iter().sum::<f64>(),
            total.iter().sum::<f64>(),
            max_relative = 1e-12
        );
        let inner = &smoothed[n / 3..n / 2];
        let [low, high] =
            inner.iter().fold([f64::MAX, f64::MIN], |[low, high], &v| [low.min(v), high.max(v)]);
        assert_relative_eq!(0.5 * (high - low), 0.5, epsilon = 0.01);
    }
}
