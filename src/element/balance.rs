//! What is left at a pose of the balance of one wheel under a given load.
//!
//! Normal models tell at a pose how far down the wheel has to go from there for a vertical force of
//! the normal loads, with the geometry as it is, and which forces go with that. Unknowns are the
//! height of the marker over the rails z, that normal force N, and, of rails without mass, their
//! lateral deflection y. It is wanted that
//!
//! ```text
//! Δz(z, N, y) = 0          no way is left from the pose to where its forces are
//! F_z = load
//! F_y = k_y y              where there are such rails, which sink by load/k_z
//! ```
//!
//! Forces are taken as their power 2/3, in which the first two are nearly straight. What one step
//! takes off the residuals is known well enough from the stiffness of the contacts and the angle of
//! the heaviest one for [`Broyden`](crate::math::broyden::Broyden)'s method to end in a few poses:
//! the geometry of a pose is wrong by a few thousandths of the way, and the share of creep forces
//! changes a little with all unknowns. Two poses, each with the force before its way, tell at which
//! height a force is to second order in the step from one to the other, and two of all forces what
//! they become where a little more load is carried.

use crate::normal::{Pose, way_between};

/// Share of the load that may be missing, and that forces may be off because of the geometry.
const MISSING: f64 = 1e-10;
const MISPLACED: f64 = 5e-10;
/// What may be left at the last pose but one, where an evaluation by itself follows: the step to it
/// leaves a thousandth of that, less than [`MISSING`].
const NEARLY: f64 = 1e-8;
/// Most poses that are tried.
pub(crate) const MOST_POSES: usize = 12;
/// Longest step from one pose to the next over load and depth: farther off, poses have not told
/// what is there. A wheel is off its rail at 1.5.
pub(crate) const LONGEST: f64 = 0.5;
/// Share of a way that all forces are wrong by, as the geometry is that of its beginning: at least
/// that, beside the step from another pose and half of what that geometry was wrong by for the way
/// itself; and where there is no other pose. These and the next ones are chosen so that forces of
/// random loads are within 1e-9 of the load of those at the height found.
const WRONG: [f64; 2] = [1e-3, 0.05];
/// The same that normals turn by on the way, over the square of the slope across of the contact.
const TURNING: f64 = 0.1;
/// Share that forces are wrong by of what two poses tell that more load and more way change, beside
/// how far they are apart: as cells begin to slip between them, and as nodes of strips move or an axle
/// turns.
const BENT: [f64; 2] = [1e-3, 5e-3];
/// Most of the way between two poses that forces go on beyond the last one: where the poses are about
/// as far from the load, their forces differ by other things, of which as much would go on.
const MOST_FURTHER: f64 = 0.05;

/// A pose, and what its geometry led to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placed {
    /// Height of the marker, and the way down from it [m].
    pub z: f64,
    pub way: f64,
    /// Vertical force of the normal loads before it, and after it [N].
    pub resting: f64,
    pub normal: f64,
    /// Vertical force of all forces as they were found, and after the way [N].
    pub vertical: f64,
    pub carried: f64,
    /// Whether they were found after the way.
    pub is_lowered: bool,
    /// Lateral force on the wheel over the vertical one [-].
    pub aside: f64,
    /// Derivative of the normal one by the way [N/m].
    pub stiffness: f64,
    /// Slope across of the heaviest contact [-].
    pub slope: f64,
    /// Contacts and zones that found no room.
    pub left_out: u64,
}

impl Placed {
    /// Vertical force of the normal loads that the forces were found with [N].
    pub fn pressed(&self) -> f64 {
        if self.is_lowered { self.normal } else { self.resting }
    }
}

/// What is known of how a load is carried: height of the marker [m], vertical force of the normal
/// loads there [N], its derivative by the height [N/m], and the lateral deflection of rails without
/// mass [m].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Carried {
    pub z: f64,
    pub normal: f64,
    pub stiffness: f64,
    pub aside: f64,
}

/// What is known of how the load of an evaluation is carried.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Expected {
    /// About how it is, and what its pose has to do with that of the last problem.
    About(Carried, Pose),
    /// How it is: the output that is handed over has the forces.
    Found(Carried),
}

/// What holds a wheel and its rails.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Held {
    /// Load on the wheel [N].
    pub load: f64,
    /// Lateral stiffness of what the rails rest on; none where they do not yield [N/m].
    pub lateral_stiffness: Option<f64>,
}

/// One wheel's part of the balance: unknowns and residuals are over the load and its depth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Balance {
    held: Held,
    depth: f64,
    last: Placed,
    /// Deflection of the last pose [m].
    y: f64,
    left: [f64; 3],
    course: Option<Course>,
}

/// How the force of the normal loads grew from one pose to the last one.
#[derive(Clone, Copy, Debug)]
struct Course {
    /// Way down over the change of the power of the force [m].
    per_power: f64,
    /// That way over the depth of the load, without sign [-].
    step: f64,
}

impl Balance {
    /// From the first pose with the deflection `y`.
    pub fn at(first: &Placed, held: Held, y: f64) -> Self {
        let depth = held.load / first.stiffness * (first.normal / held.load).cbrt();
        let mut balance = Self { held, depth, last: *first, y, left: [0.0; 3], course: None };
        balance.left = balance.residuals(first, y);
        balance
    }

    /// The last pose.
    pub fn last(&self) -> Placed {
        self.last
    }

    /// The unknowns at a height over the rails, with a normal force and a deflection.
    pub fn unknowns(&self, about: &Carried) -> [f64; 3] {
        [about.z / self.depth, self.power(about.normal), about.aside / self.depth]
    }

    /// What unknowns stand for.
    pub fn carried(&self, unknowns: [f64; 3]) -> Carried {
        let [z, normal, aside] = unknowns;
        let normal = self.held.load * (normal / 1.5).max(0.0).powf(1.5);
        Carried {
            z: z * self.depth,
            normal,
            stiffness: self.last.stiffness,
            aside: aside * self.depth,
        }
    }

    fn power(&self, force: f64) -> f64 {
        1.5 * (force / self.held.load).cbrt().powi(2)
    }

    /// Way, load and deflection left at a pose with the deflection `y`.
    fn residuals(&self, at: &Placed, y: f64) -> [f64; 3] {
        let aside = self.held.lateral_stiffness.map_or(0.0, |k| at.aside * at.carried / k - y);
        [at.way / self.depth, 1.5 - self.power(at.carried), aside / self.depth]
    }

    /// What a step of the unknowns takes off the residuals, as the first pose tells.
    pub fn matrix(&self) -> [[f64; 3]; 3] {
        let at = &self.last;
        let ratio = at.carried / at.normal;
        let growth = self.held.load * (at.normal / self.held.load).cbrt() / self.depth;
        let aside = self.held.lateral_stiffness.map_or(0.0, |k| -at.aside * ratio * growth / k);
        [[1.0, -1.0, at.slope], [0.0, ratio.cbrt().powi(2), 0.0], [0.0, aside, 1.0]]
    }

    /// Residuals at another pose, or with other forces, with the deflection `y`.
    pub fn take(&mut self, here: &Placed, y: f64) -> [f64; 3] {
        let Self { last, depth, .. } = *self;
        let step = here.z - last.z + here.slope * (y - self.y);
        // Other forces of the same pose do not tell of another one.
        let is_same = step.abs() <= 0.0;
        let resting = if is_same { last.resting } else { here.resting };
        if !is_same {
            let per_power = step / (self.power(resting) - self.power(last.resting));
            let is_known = per_power > 0.0 && per_power.is_finite();
            self.course = is_known.then_some(Course { per_power, step: step.abs() / depth });
        }
        (self.last, self.y) = (Placed { resting, ..*here }, y);
        self.left = self.residuals(here, y);
        self.left
    }

    /// The height at which normal loads of a pose beside the last one have the vertical force
    /// `normal` [m].
    pub fn height_of(&self, normal: f64) -> f64 {
        let Self { last, course, .. } = self;
        if let Some(Course { per_power, .. }) = course {
            return last.z + per_power * (self.power(normal) - self.power(last.resting));
        }
        let height = if last.is_lowered { last.z + last.way } else { last.z };
        height + way_between(last.pressed(), last.stiffness, normal)
    }

    /// Residuals at the last pose.
    pub fn left(&self) -> [f64; 3] {
        self.left
    }

    /// Lateral force that is left, over the load [-].
    fn lateral(&self) -> f64 {
        let Held { load, lateral_stiffness } = self.held;
        lateral_stiffness.map_or(0.0, |k| self.left[2] * self.depth * k / load)
    }

    /// Whether the next pose may be an evaluation by itself.
    pub fn is_nearly_met(&self) -> bool {
        let [way, missing, _] = self.left;
        way.abs().max(missing.abs()).max(self.lateral().abs()) <= NEARLY
    }

    /// Forces of the last pose that are wrong because of the geometry, over the load [-]. Load that
    /// is missing makes the way longer.
    fn misplaced(&self) -> f64 {
        let Self { last, left: [way, missing, _], course, .. } = self;
        let wrong = course.map_or(WRONG[1], |course| {
            let taken_off = self.height_of(last.normal) - last.z - last.way;
            course.step + (0.5 * (taken_off / last.way).abs()).max(WRONG[0])
        });
        let wrong = wrong + TURNING * last.slope * last.slope;
        wrong * (way.abs() + missing.abs()) * self.steep()
    }

    /// About the greatest of a contact's forces, over the load [-].
    fn steep(&self) -> f64 {
        1.0 + self.last.slope.abs()
    }

    /// Whether the last pose is where the wheel is carried but for its way down.
    pub fn is_placed(&self) -> bool {
        let Self { held: Held { load, .. }, last, .. } = self;
        let is_placed = if last.is_lowered {
            self.misplaced() <= MISPLACED
        } else {
            (load - last.vertical).abs() <= MISSING * load
        };
        is_placed && self.lateral().abs() <= MISPLACED
    }

    /// How far all forces have to go on beyond the last pose, over what changed from the one `before`
    /// to it, for the load to be carried, where only height and load moved, or an axle `turns` with
    /// them; nothing where that is too far to be told by both, or where rails yield, which these do
    /// not tell of.
    pub fn further(&self, before: &Placed, turns: bool) -> Option<f64> {
        let Self { held: Held { load, lateral_stiffness }, last, depth, .. } = self;
        let missing = load - last.vertical;
        let part = missing / (last.vertical - before.vertical);
        let apart = (last.z - before.z).abs() / depth;
        let further = (missing / load).abs() + part.abs() * apart;
        let bent = BENT[usize::from(last.is_lowered || turns)];
        let bent = (bent + apart) * further * self.steep();
        let misplaced = if last.is_lowered { self.misplaced() } else { 0.0 };
        let is_told = part.abs() <= MOST_FURTHER && misplaced.max(bent) <= MISPLACED;
        (is_told && lateral_stiffness.is_none()).then_some(part)
    }

    /// Whether no load is missing there.
    pub fn is_carried(&self) -> bool {
        let [_, missing, _] = self.left;
        missing.abs() <= MISSING
    }
}
