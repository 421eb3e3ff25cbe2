//! Least squares by Levenberg and Marquardt, with the derivatives of the contact, and what the data
//! leave open.
//!
//! Parameters are moved in coordinates without bounds: u = ln v of those above 0, u = ln (v/(1 -
//! v)) of shares. A step of one changes the parameter by a factor of e, so that errors of all of
//! them compare.

use anyhow::{Context, Result, bail};
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use nalgebra_0_34::{DMatrix, DVector, Dyn, Owned};
use wheelrail::planar::FrictionLaw;
use wheelrail::variables::Values;

use super::points::Points;

/// What can be fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameter {
    Friction,
    FallingShare,
    FallingDecay,
    Reduction,
    ReductionShare,
    ReductionDecay,
}

impl Parameter {
    /// In the order of the derivatives of a contact.
    const ALL: [Self; 6] = [
        Self::Friction,
        Self::FallingShare,
        Self::FallingDecay,
        Self::Reduction,
        Self::ReductionShare,
        Self::ReductionDecay,
    ];
    /// FMU names of [`ALL`](Self::ALL).
    pub const NAMES: [&'static str; 6] = [
        "friction.coefficient",
        "friction.falling.share",
        "friction.falling.decay",
        "friction.reduction.initial",
        "friction.reduction.share",
        "friction.reduction.decay",
    ];

    fn place(self) -> usize {
        self as usize
    }

    /// FMU name.
    pub fn name(self) -> &'static str {
        Self::NAMES[self.place()]
    }

    /// The parameter of that FMU name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|own| own.name() == name.trim())
    }

    fn is_share(self) -> bool {
        matches!(self, Self::FallingShare | Self::Reduction | Self::ReductionShare)
    }

    /// Value at the coordinate `u`, and its derivative.
    fn value(self, u: f64) -> (f64, f64) {
        if self.is_share() {
            let share = 1.0 / (1.0 + (-u).exp());
            (share, share * (1.0 - share))
        } else {
            (u.exp(), u.exp())
        }
    }

    fn coordinate(self, value: f64) -> f64 {
        if self.is_share() { (value / (1.0 - value)).ln() } else { value.ln() }
    }
}

/// A parameter as it was found.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    pub parameter: Parameter,
    pub value: f64,
    /// Standard error.
    pub error: f64,
    pub is_determined: bool,
    /// The end of its range, where it went there.
    pub at_bound: Option<f64>,
}

/// A law fitted to points.
#[derive(Clone, Debug)]
pub struct Fit {
    pub parameters: Vec<Found>,
    /// Pairs of which only a combination is known.
    pub together: Vec<(Parameter, Parameter)>,
    /// Fitted adhesion of each point.
    pub adhesion: Vec<f64>,
    /// Root mean square of the misfit.
    pub misfit: f64,
}

/// Standard error of a coordinate from which on the data say nothing: a factor of e either way is a
/// parameter that is not known.
const UNKNOWN: f64 = 0.5;
/// Correlation from which on two parameters are known together only.
const TOGETHER: f64 = 0.98;
/// Adhesion is not measured better than this: the noise of data without any.
const MIN_NOISE: f64 = 1e-5;
/// Distance from the end of its range at which a share is there.
const BOUND: f64 = 1e-3;
/// Coordinates stay within this, so that values stay within the range of the variables.
const FARTHEST: f64 = 12.0;

/// The residuals of a law at all points.
#[derive(Clone)]
struct Problem<'a> {
    points: &'a Points,
    fitted: &'a [Parameter],
    friction: f64,
    law: FrictionLaw,
    coordinates: DVector<f64>,
    residuals: DVector<f64>,
    jacobian: DMatrix<f64>,
}

impl Problem<'_> {
    fn evaluate(&mut self) {
        let mut slopes = [0.0; 6];
        for (parameter, &u) in self.fitted.iter().zip(&self.coordinates) {
            let (value, slope) = parameter.value(u.clamp(-FARTHEST, FARTHEST));
            slopes[parameter.place()] = slope;
            let FrictionLaw {
                falling_share,
                falling_decay,
                reduction,
                reduction_share,
                reduction_decay,
                ..
            } = &mut self.law;
            *match parameter {
                Parameter::Friction => &mut self.friction,
                Parameter::FallingShare => falling_share,
                Parameter::FallingDecay => falling_decay,
                Parameter::Reduction => reduction,
                Parameter::ReductionShare => reduction_share,
                Parameter::ReductionDecay => reduction_decay,
            } = value;
        }
        for (i, point) in self.points.all.iter().enumerate() {
            let contact = &self.points.contacts[point.contact];
            let (adhesion, by) =
                contact.adhesion(point.creepage, point.speed, self.friction, &self.law);
            self.residuals[i] = adhesion - point.adhesion;
            for (n, parameter) in self.fitted.iter().enumerate() {
                let place = parameter.place();
                self.jacobian[(i, n)] = by[place] * slopes[place];
            }
        }
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Problem<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, coordinates: &DVector<f64>) {
        self.coordinates.copy_from(coordinates);
        self.evaluate();
    }

    fn params(&self) -> DVector<f64> {
        self.coordinates.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(self.residuals.clone())
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        Some(self.jacobian.clone())
    }
}

/// Fits `parameters` to `points`; the others are those of `values`.
pub fn fit(points: &Points, values: &Values, parameters: &[Parameter]) -> Result<Fit> {
    let (n, count) = (points.all.len(), parameters.len());
    let blank = Problem {
        points,
        fitted: parameters,
        friction: values.input.friction,
        law: values.parameters.friction_law,
        coordinates: DVector::zeros(count),
        residuals: DVector::zeros(n),
        jacobian: DMatrix::zeros(n, count),
    };
    let mut best: Option<(f64, Problem)> = None;
    for start in starts(points) {
        let mut problem = blank.clone();
        let coordinates = parameters.iter().map(|own| own.coordinate(start[own.place()]));
        problem.coordinates = DVector::from_iterator(count, coordinates);
        problem.evaluate();
        let (problem, report) = LevenbergMarquardt::new().with_patience(PATIENCE).minimize(problem);
        let ended = report.termination.was_successful()
            || matches!(
                report.termination,
                TerminationReason::LostPatience | TerminationReason::NoImprovementPossible(_)
            );
        let sum = report.objective_function;
        if ended && sum.is_finite() && best.as_ref().is_none_or(|(least, _)| sum < *least) {
            best = Some((sum, problem));
        }
    }
    let Some((sum, problem)) = best else {
        bail!("no law fits the points: look for points that are not of a creep curve");
    };
    summary(&problem, 2.0 * sum).context("the points do not depend on the parameters")
}

/// Most steps over the number of parameters and one more.
const PATIENCE: usize = 30;

/// Values of all parameters from which on a fit is looked for.
fn starts(points: &Points) -> Vec<[f64; 6]> {
    let (friction, fastest) = (1.05 * points.greatest().max(1e-3), points.fastest().max(1e-6));
    let mut all = Vec::new();
    for fall in [1.0, 6.0] {
        for reduction in [0.4, 0.9] {
            for decay in [0.2, 2.0] {
                all.push([friction, 0.5, fall / fastest, reduction, 0.3, decay]);
            }
        }
    }
    all
}

fn summary(problem: &Problem, squares: f64) -> Option<Fit> {
    let (n, count) = (problem.points.all.len(), problem.fitted.len());
    let noise = (squares / (n - count) as f64).sqrt().max(MIN_NOISE);
    // What the data do not see has no inverse: a little of everything is added, far beyond what is
    // known.
    let floor = (noise / (20.0 * UNKNOWN)).powi(2);
    let normal = problem.jacobian.tr_mul(&problem.jacobian);
    let covariance = (normal + DMatrix::identity(count, count) * floor).try_inverse()?;
    let error = |i: usize| noise * covariance[(i, i)].sqrt();
    let parameters: Vec<Found> = (problem.fitted.iter().enumerate())
        .map(|(i, &parameter)| {
            let (value, slope) = parameter.value(problem.coordinates[i].clamp(-FARTHEST, FARTHEST));
            let bounds = if parameter.is_share() { &[0.0, 1.0][..] } else { &[0.0] };
            Found {
                parameter,
                value,
                error: slope * error(i),
                is_determined: error(i) <= UNKNOWN,
                at_bound: bounds.iter().copied().find(|bound| (value - bound).abs() < BOUND),
            }
        })
        .collect();
    let mut together = Vec::new();
    for i in 0..count {
        for j in i + 1..count {
            let correlation = covariance[(i, j)] / (covariance[(i, i)] * covariance[(j, j)]).sqrt();
            if correlation.abs() > TOGETHER
                && !(parameters[i].is_determined && parameters[j].is_determined)
            {
                together.push((problem.fitted[i], problem.fitted[j]));
            }
        }
    }
    let points = problem.points.all.iter();
    let adhesion = points.zip(&problem.residuals).map(|(p, misfit)| p.adhesion + misfit);
    Some(Fit {
        parameters,
        together,
        adhesion: adhesion.collect(),
        misfit: (squares / n as f64).sqrt(),
    })
}
