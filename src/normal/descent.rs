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
    /// Vertical force of the normal loads at first: but for a pose that stays those before the way,
    /// whose geometry is their own [N].
    pub resting: f64,
    /// Vertical force of the normal loads there [N], and its derivative by the way, 0 before they
    /// are known [N/m].
    pub reached: f64,
    pub stiffness: f64,
    /// That force over the one of the loads as they are left [-].
    pub growth: f64,
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
            resting: 0.0,
            reached: 0.0,
            stiffness: 0.0,
            growth: 1.0,
            rails: 0,
        }
    }

    /// The same at a `pose`.
    #[must_use]
    pub fn at(self, pose: Pose) -> Self {
        let way = if let Pose::Same(way) = pose { way } else { self.way };
        Self { pose, way, ..self }
    }

    /// Share of the way down by which the overlap at a place with so much unit `tangent` grows.
    pub fn cosine(&self, tangent: [f64; 2]) -> f64 {
        tangent[0] * self.down[1] - tangent[1] * self.down[0]
    }

    /// Looks down from where the vertical force is `reached` [N] and its derivative `stiffness`
    /// [N/m] to where the force that is sought would be: `look` is told the way [m], lets loads grow
    /// by it as their derivatives tell, and gives their vertical force [N].
    pub fn look_down(&mut self, [reached, stiffness]: [f64; 2], look: impl FnOnce(f64) -> f64) {
        self.resting = reached;
        self.way = way_between(reached, stiffness, self.wanted);
        self.stiffness = stiffness * (self.wanted / reached).cbrt();
        self.reached = self.wanted;
        self.growth = self.wanted / look(self.way);
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
            if trial == 1 {
                self.resting = reached;
            }
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
            step = way_between(reached, self.stiffness, self.wanted);
            let is_lost = !(self.stiffness > 0.0 && step.is_finite());
            if is_last || is_lost || missing.abs() <= ROUNDING || trial == MOST_STEPS {
                break;
            }
            last = Some([self.way, missing]);
            self.way += step;
        }
    }
}

/// The way from where the normal loads have the vertical force `from`, and so much `stiffness`, to
/// where it is `to`: it grows with the power 3/2 of a depth [m].
pub fn way_between(from: f64, stiffness: f64, to: f64) -> f64 {
    1.5 * from / stiffness * ((to / from).powf(2.0 / 3.0) - 1.0)
}

/// What a pose has to do with that of the last problem.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pose {
    /// Nothing that is to be used. It is too far from where the force is for more than a look down.
    New,
    /// It is so near that the last solution is a start.
    Near,
    /// It is the same, so far above where the last loads are [m].
    Same(f64),
}

impl Pose {
    /// Whether geometry and loads of the last problem still hold.
    pub fn is_same(self) -> bool {
        matches!(self, Self::Same(_))
    }
}

/// What is known of how a force grows on the way down.
#[derive(Clone, Copy, Debug)]
pub enum Slope {
    /// Its derivative [N/m].
    Known(f64),
    /// The depth that it is from [m].
    Depth(f64),
}
