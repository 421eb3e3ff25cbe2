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
//! the geometry of a pose is wrong by a thousandth of the way or so, and the share of creep forces
//! changes a little with all unknowns.

use super::input::Input;
use super::output::{Output, Patch, heaviest};
use super::wheel_on_rails::Element;
use crate::normal::{Descent, Pose, way_between};

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
/// Share of a way that the geometry is wrong by at least, whatever poses tell, and where there is
/// one pose alone.
const WRONG: [f64; 2] = [1e-3, 0.05];
/// Lateral force that is wrong then over the load, the way and the slope across of the contact: on
/// flanges normals turn on the way.
const TURNING: f64 = 0.1;

/// A pose, and what its geometry led to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placed {
    /// Height of the marker, and the way down from it [m].
    pub z: f64,
    pub way: f64,
    /// Vertical force of the normal loads after that, and of all forces [N].
    pub normal: f64,
    pub carried: f64,
    /// Lateral force on the wheel over the vertical one [-].
    pub aside: f64,
    /// Derivative of the normal one by the way [N/m].
    pub stiffness: f64,
    /// Slope across of the heaviest contact [-].
    pub slope: f64,
    /// The vertical force before the way, where the other numbers are told from there [N].
    pub before: Option<f64>,
    /// Contacts and zones that found no room.
    pub left_out: u64,
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
    left: [f64; 3],
}

impl Balance {
    /// From the first pose with the deflection `y`.
    pub fn at(first: &Placed, held: Held, y: f64) -> Self {
        let depth = held.load / first.stiffness * (first.normal / held.load).cbrt();
        let (last, left) = (*first, [0.0; 3]);
        let mut balance = Self { held, depth, last, left };
        balance.left = balance.residuals(first, y);
        balance
    }

    /// Depth of the load about [m].
    pub fn depth(&self) -> f64 {
        self.depth
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
        (self.last, self.left) = (*here, self.residuals(here, y));
        self.left
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

    /// Whether the last pose is where the wheel is carried but for its way down, where a way is
    /// `believed` to take so much off itself, if more than one pose tells that. Load that is missing
    /// makes it longer.
    pub fn is_placed(&self, believed: Option<f64>) -> bool {
        let Self { held: Held { load, .. }, last, left: [way, missing, _], .. } = *self;
        let wrong = believed.map_or(WRONG[1], |share| (share - 1.0).abs().max(WRONG[0]));
        let is_placed = match last.before {
            // The vertical force is the load, the lateral one the load times `aside`.
            None => {
                let wrong = wrong + TURNING * last.slope.abs();
                wrong * (way.abs() + missing.abs()) <= MISPLACED
            }
            Some(before) => (load - before).abs() <= MISSING * load,
        };
        is_placed && self.lateral().abs() <= MISPLACED
    }

    /// Whether no load is missing there.
    pub fn is_carried(&self) -> bool {
        let [_, missing, _] = self.left;
        missing.abs() <= MISSING
    }
}

/// Vertical force of the normal forces of `patches` [N].
pub(super) fn normal_force_down(patches: &[Patch]) -> f64 {
    patches.iter().map(|patch| patch.normal_force * patch.contact_angle.cos()).sum()
}

impl Element {
    /// Forces at the height of `input` (right side), whose load is sought, or, by the normal model,
    /// after the way down to the normal force of what is known `about` them; nothing where it is not
    /// one rail that presses, or not the deeper the more.
    pub(super) fn press(
        &mut self,
        about: &Carried,
        pose: Pose,
        input: &Input,
        output: &mut Output,
    ) -> Option<Placed> {
        let by_strips = self.models.strip_solver.is_some();
        self.models.descent = by_strips.then(|| Descent::to(about.normal).at(pose));
        let left_out = self.forces(input, output);
        let descent = self.models.descent.take();
        let [_, lateral, vertical] = output.wheel.force;
        let patches = &self.models.patches;
        let heaviest = heaviest(patches)?;
        let (z, slope) = (input.wheel.position[2], heaviest.contact_angle.tan());
        let (carried, aside) = (-vertical, lateral / vertical);
        if carried.is_nan() || carried <= 0.0 {
            return None;
        }
        if let Some(Descent { way, reached: normal, stiffness, growth, rails, .. }) = descent {
            let carried = carried * growth;
            let placed =
                Placed { z, way, normal, carried, aside, stiffness, slope, before: None, left_out };
            return (rails == 1 && stiffness > 0.0).then_some(placed);
        }
        let load = input.wheel_load;
        let here = normal_force_down(patches);
        let normal = here * load / carried;
        let stiffness = about.stiffness * (here / about.normal).cbrt();
        let way = way_between(here, stiffness, normal);
        let before = Some(carried);
        (!by_strips && here > 0.0 && normal > 0.0).then_some(Placed {
            z,
            way,
            normal,
            carried: load,
            aside,
            stiffness: about.stiffness * (normal / about.normal).cbrt(),
            slope,
            before,
            left_out,
        })
    }
}
