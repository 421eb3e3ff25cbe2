//! How far a wheel has to go down for the normal loads on one rail to have a given vertical force.
//!
//! The geometry stays that of the pose it was found at: overlaps grow by the way down times the
//! cosine of the contact angle, place by place. That is right to second order in the way.

/// A vertical force that is sought, and the way down at which it is there.
#[derive(Clone, Copy, Debug)]
pub struct Descent {
    /// Unit vector (y, z) down in the frame of the rail's section, which the rail fills in.
    pub down: [f64; 2],
    /// Vertical force of the normal loads that is sought, > 0 [N].
    pub wanted: f64,
    /// What the pose has to do with that of the last problem.
    pub pose: Pose,
    /// Way down from the pose [m].
    pub way: f64,
    /// Vertical force of the normal loads there [N], and its derivative by the way, 0 before they
    /// are known [N/m].
    pub reached: f64,
    pub stiffness: f64,
    /// Rails whose loads were asked for the force: there is an answer where it was one.
    pub rails: usize,
}

/// Share of a missing force that may be left: the geometry of the pose tells no more.
const LEFT: f64 = 1e-2;
/// Missing force that is rounding.
const ROUNDING: f64 = 1e-13;
/// Most steps down.
const MOST_STEPS: usize = 8;

impl Descent {
    /// A descent to the vertical force `wanted`, > 0 [N], at a new pose.
    pub fn to(wanted: f64) -> Self {
        Self {
            down: [0.0, 1.0],
            wanted,
            pose: Pose::New,
            way: 0.0,
            reached: 0.0,
            stiffness: 0.0,
            rails: 0,
        }
    }

    /// The same at a `pose`.
    #[must_use]
    pub fn at(self, pose: Pose) -> Self {
        Self { pose, ..self }
    }

    /// Share of the way down by which the overlap at a place with so much unit `tangent` grows.
    pub fn cosine(&self, tangent: [f64; 2]) -> f64 {
        tangent[0] * self.down[1] - tangent[1] * self.down[0]
    }

    /// Goes down step by step: `carried` brings the wheel down by what it is told [m] and gives the
    /// vertical force there [N] and its derivative by the way [N/m], where it knows that, or the
    /// depth that the force is from [m].
    pub fn run(&mut self, mut carried: impl FnMut(&Self, f64) -> (f64, Slope)) {
        let mut step = 0.0;
        // What was missing at first, and the way before the last step with what was missing there.
        let (mut first, mut last) = (None, None::<[f64; 2]>);
        for trial in 1..=MOST_STEPS {
            let (reached, slope) = carried(self, step);
            self.reached = reached;
            // Forces grow with the power 3/2 of a depth: what is missing of its 2/3 is straight.
            let missing = (self.wanted / reached).powf(2.0 / 3.0) - 1.0;
            let secant = last.map(|[way, before]| {
                let growth = (1.0 + before) / (1.0 + missing);
                1.5 * reached * (1.0 - 1.0 / growth) / (self.way - way)
            });
            self.stiffness = match slope {
                Slope::Known(stiffness) => stiffness,
                Slope::Depth(depth) => secant.unwrap_or(1.5 * reached / depth),
            };
            let is_close = |first: f64| missing.abs() <= (LEFT * first.abs()).max(ROUNDING);
            let is_last = first.is_some_and(is_close);
            first = first.or(Some(missing));
            step = missing * 1.5 * reached / self.stiffness;
            let is_lost = !(self.stiffness > 0.0 && step.is_finite());
            if is_last || is_lost || missing.abs() <= ROUNDING || trial == MOST_STEPS {
                break;
            }
            last = Some([self.way, missing]);
            self.way += step;
        }
    }
}

/// What a pose has to do with that of the last problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pose {
    /// Nothing that is to be used.
    New,
    /// It is so near that the last solution is a start.
    Near,
}

/// What is known of how a force grows on the way down.
#[derive(Clone, Copy, Debug)]
pub enum Slope {
    /// Its derivative [N/m].
    Known(f64),
    /// The depth that it is from [m].
    Depth(f64),
}
