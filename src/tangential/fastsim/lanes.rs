//! The steps of FASTSIM along many strips at once, so that the processor takes several of them in
//! one instruction, and with derivatives.

use multiversion::multiversion;

use crate::math::dual::Dual;
use crate::math::real::Real;
use crate::math::tape::Taped;

/// Strips that are marched through together, that is integrated along from their leading edges.
pub const LANES: usize = 32;
pub type Lanes<T> = [T; LANES];

/// What the march of up to `LANES` strips needs: traction increments per element and the bounds μ
/// p_n at the centres of the strips [Pa].
#[derive(Clone, Copy, Debug, Default)]
pub struct LaneInput<T> {
    pub step_x: Lanes<T>,
    pub step_y: Lanes<T>,
    pub step_y_per_abscissa: Lanes<T>,
    pub bound: Lanes<T>,
}

/// Sums over the elements of each strip.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums<T> {
    pub x: Lanes<T>,
    pub y: Lanes<T>,
    pub y_abscissa: Lanes<T>,
    pub slipping: Lanes<f64>,
}

/// Numbers with which strips are marched.
pub trait Marching: Real {
    /// Marches the strips of the first `lanes` lanes at once.
    fn march(
        input: &LaneInput<Self>,
        lanes: usize,
        profile: &[f64],
        abscissae: &[[f64; 2]],
    ) -> Sums<Self>;
}

impl Marching for f64 {
    #[inline]
    fn march(
        input: &LaneInput<f64>,
        lanes: usize,
        profile: &[f64],
        abscissae: &[[f64; 2]],
    ) -> Sums<f64> {
        march_strips(input, lanes, profile, abscissae)
    }
}

impl<const N: usize> Marching for Dual<N> {
    fn march(
        input: &LaneInput<Self>,
        lanes: usize,
        profile: &[f64],
        abscissae: &[[f64; 2]],
    ) -> Sums<Self> {
        march_as_whole(input, lanes, profile, abscissae)
    }
}

impl Marching for Taped {
    fn march(
        input: &LaneInput<Self>,
        lanes: usize,
        profile: &[f64],
        abscissae: &[[f64; 2]],
    ) -> Sums<Self> {
        march_as_whole(input, lanes, profile, abscissae)
    }
}

/// The march of numbers with derivatives: all that a strip depends on are four numbers, so that four
/// derivatives do for any number of directions. Lanes behind the last one are idle.
fn march_as_whole<T: Real>(
    input: &LaneInput<T>,
    lanes: usize,
    profile: &[f64],
    abscissae: &[[f64; 2]],
) -> Sums<T> {
    let value = |lanes: &Lanes<T>| lanes.map(T::value);
    let values = LaneInput {
        step_x: value(&input.step_x),
        step_y: value(&input.step_y),
        step_y_per_abscissa: value(&input.step_y_per_abscissa),
        bound: value(&input.bound),
    };
    let (sums, slopes) = march_with_slopes(&values, profile, abscissae);
    let moving = |sum: f64, slopes: &[Lanes<f64>; 4], lane: usize| {
        if lane >= lanes {
            return T::from(sum);
        }
        let own = [
            &input.step_x[lane],
            &input.step_y[lane],
            &input.step_y_per_abscissa[lane],
            &input.bound[lane],
        ];
        T::combined(sum, own.into_iter().zip(slopes.iter().map(|slopes| slopes[lane])))
    };
    Sums {
        x: std::array::from_fn(|lane| moving(sums.x[lane], &slopes[0], lane)),
        y: std::array::from_fn(|lane| moving(sums.y[lane], &slopes[1], lane)),
        y_abscissa: std::array::from_fn(|lane| moving(sums.y_abscissa[lane], &slopes[2], lane)),
        slipping: sums.slipping,
    }
}

/// Marches the strips of the first `lanes` lanes at once.
///
/// Compiled for several instruction sets, the widest one chosen at run time. No operation is fused
/// or reordered, so that all of them give the same bits.
#[multiversion(targets("x86_64+avx512f", "x86_64+avx2", "aarch64+neon"))]
fn march_strips(
    input: &LaneInput<f64>,
    lanes: usize,
    profile: &[f64],
    abscissae: &[[f64; 2]],
) -> Sums<f64> {
    let mut sums = Sums::default();
    match lanes {
        0..=8 => march_lanes::<8>(input, profile, abscissae, &mut sums),
        9..=16 => march_lanes::<16>(input, profile, abscissae, &mut sums),
        _ => march_lanes::<LANES>(input, profile, abscissae, &mut sums),
    }
    sums
}

/// Marches the first `N` lanes and adds to their `sums`.
// Inside each instruction set or not at all: a call would not be vectorised.
#[inline(always)]
fn march_lanes<const N: usize>(
    input: &LaneInput<f64>,
    profile: &[f64],
    abscissae: &[[f64; 2]],
    sums: &mut Sums<f64>,
) {
    let (mut px, mut py) = ([0.0; N], [0.0; N]);
    // The first element's middle is half a step behind the leading edge.
    let mut length = 0.5;
    for (bound, [abscissa, step_abscissa]) in profile.iter().zip(abscissae) {
        for lane in 0..N {
            let trial_x = px[lane] + length * input.step_x[lane];
            let trial_y = py[lane]
                + length * (input.step_y[lane] + step_abscissa * input.step_y_per_abscissa[lane]);
            let magnitude = (trial_x * trial_x + trial_y * trial_y).sqrt();
            let ratio = input.bound[lane] * bound / magnitude;
            // 0/0 of an idle lane is not a number, and `min` then takes the one.
            let scale = ratio.min(1.0);
            px[lane] = trial_x * scale;
            py[lane] = trial_y * scale;
            sums.x[lane] += px[lane];
            sums.y[lane] += py[lane];
            sums.y_abscissa[lane] += abscissa * py[lane];
            sums.slipping[lane] += if scale < 1.0 { 1.0 } else { 0.0 };
        }
        length = 1.0;
    }
}

/// As [`march_strips`], with the derivatives of the sums x, y and y times abscissa by the four
/// numbers of each lane, in their order.
#[multiversion(targets("x86_64+avx512f", "x86_64+avx2", "aarch64+neon"))]
fn march_with_slopes(
    input: &LaneInput<f64>,
    profile: &[f64],
    abscissae: &[[f64; 2]],
) -> (Sums<f64>, [[Lanes<f64>; 4]; 3]) {
    let mut sums = Sums::default();
    let mut slopes = [[[0.0; LANES]; 4]; 3];
    let (mut px, mut py) = ([0.0; LANES], [0.0; LANES]);
    let (mut px_by, mut py_by) = ([[0.0; LANES]; 4], [[0.0; LANES]; 4]);
    let mut length = 0.5;
    for (bound, [abscissa, step_abscissa]) in profile.iter().zip(abscissae) {
        // Of the trial tractions, and of the bound.
        let x_by = [length, 0.0, 0.0, 0.0];
        let y_by = [0.0, length, length * step_abscissa, 0.0];
        let bound_by = [0.0, 0.0, 0.0, *bound];
        let (mut scales, mut per_square, mut per_size) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        let (mut tx, mut ty) = ([0.0; LANES], [0.0; LANES]);
        for lane in 0..LANES {
            let trial_x = px[lane] + length * input.step_x[lane];
            let trial_y = py[lane]
                + length * (input.step_y[lane] + step_abscissa * input.step_y_per_abscissa[lane]);
            let square = trial_x * trial_x + trial_y * trial_y;
            let magnitude = square.sqrt();
            let ratio = input.bound[lane] * bound / magnitude;
            let scale = ratio.min(1.0);
            let slips = if scale < 1.0 { 1.0 } else { 0.0 };
            (tx[lane], ty[lane], scales[lane]) = (trial_x, trial_y, scale);
            // Of the scale by bound and by the square of the magnitude; nothing where the element
            // adheres.
            per_size[lane] = if scale < 1.0 { 1.0 / magnitude } else { 0.0 };
            per_square[lane] = if scale < 1.0 { -ratio / square } else { 0.0 };
            px[lane] = trial_x * scale;
            py[lane] = trial_y * scale;
            sums.x[lane] += px[lane];
            sums.y[lane] += py[lane];
            sums.y_abscissa[lane] += abscissa * py[lane];
            sums.slipping[lane] += slips;
        }
        for k in 0..4 {
            let (px_by, py_by) = (&mut px_by[k], &mut py_by[k]);
            for lane in 0..LANES {
                let (dx, dy) = (px_by[lane] + x_by[k], py_by[lane] + y_by[k]);
                let scale_by = bound_by[k] * per_size[lane]
                    + per_square[lane] * (tx[lane] * dx + ty[lane] * dy);
                px_by[lane] = dx * scales[lane] + tx[lane] * scale_by;
                py_by[lane] = dy * scales[lane] + ty[lane] * scale_by;
                slopes[0][k][lane] += px_by[lane];
                slopes[1][k][lane] += py_by[lane];
                slopes[2][k][lane] += abscissa * py_by[lane];
            }
        }
        length = 1.0;
    }
    (sums, slopes)
}
