//! Tolerances of continuity, derivatives and energy.

super::entry::tolerances! {
    /// Greatest change of a force when the step is a quarter, over that before: a continuous one
    /// changes by a quarter, or by half where it has a root.
    SHRINKING: f64 = 0.35;

    /// Greatest jumps of the normal force of Piotrowski-Kik, over the force, in a sweep of a S1002
    /// wheel over a 60E1 rail, 30 to 150 µm deep: the model has one contact point for each
    /// penetrated interval, and at a swap of two minima, between tread and flange root or at the
    /// centred position, the whole load is computed anew from the other one.
    JUMP_PIOTROWSKI_KIK: f64 = 0.35, kept;

    /// The same of Hertz: the ellipse has the curvatures of one point alone, 300 or 80 mm of the
    /// rail.
    JUMP_HERTZ: f64 = 0.65, kept;

    /// Jump of the normal force of strips over steps of 0.1 µm at swaps of the deepest place, over
    /// the force: the target of walks.
    STRIPS_JUMP: f64 = 1e-4;

    /// Second differences in fine steps of the sweeps of a new and a worn S1002 on 60E1, curved
    /// creepage, vertical and lateral force over the load, longitudinal force and moment about the
    /// vertical (times 10 mm) over the friction limit: two zones that become one get one contact
    /// frame, along whose normal they carry less.
    STRIPS_SWEEP_JUMPS: [f64; 4] = [3e-4, 5.5e-4, 2.4e-3, 4e-3], target [1e-4, 1e-4, 1e-3, 1e-3];

    /// Second differences of the vertical force in fine steps of sweeps in other places, without
    /// creep forces, over the load: two zones that become one get one contact frame.
    STRIPS_SWEEP_ELSEWHERE: f64 = 0.048, target 1e-4;

    /// Jump of the creep force of tables where two zones of strips join, 20 strips, over the
    /// friction limit: ellipses of the same moments of load do not jump.
    JOINING_ZONES: f64 = 1e-5;

    /// The same of marches: ellipses of the same moments of the outline do not jump.
    JOINING_ZONES_MARCHED: f64 = 5e-5;

    /// Jumps along random walks, of the force over the load without creep forces, and over the
    /// friction limit with them: what the steps of an integrator do not see.
    WALK_JUMPS: [f64; 2] = [1e-4, 1e-3];

    /// Largest change of the stiffness from step to step of 0.1 µm in a line of 0.1 mm of a random
    /// walk, over the stiffness of the contact, below which 95 % of the lines stay: what Newton's
    /// method of a host gets along with.
    WALK_KINKS: f64 = 0.05;

    /// Second differences of the force over steps of 1 nm and 1 nrad less the curvature of the
    /// force, over the force: kinks of a strip of FASTSIM that begins to slip all over (single
    /// steps of the lateral force, with one of nine strips), and of the curvature of a profile
    /// under a contact point. A stiff integrator's Newton differences stand on these.
    ROUGHNESS: f64 = 6e-8, target 1e-9;

    /// The same for strips with the table: the stiffness bends by at most 5 % where a node begins to
    /// carry load (WALK_KINKS), over load and stiffness of an overlap of a tenth of a millimetre,
    /// 70 µm. They have no other kink.
    ROUGHNESS_STRIPS: f64 = 7e-7, target 1e-9;

    /// The same of creep forces of marches, over the friction limit, at 95 %: the rest is for cells
    /// that begin to slip or to adhere.
    MARCHES_ROUGHNESS: f64 = 1e-9;

    /// Second differences of the height under a given load over lateral steps of 1 µm [m]: what the
    /// curvature of the profiles leaves.
    HEIGHT_ROUGHNESS: f64 = 1e-11;

    /// Derivatives of outputs by inputs against central differences, over the greatest one of its
    /// unit and input, random poses, by model: rounding of the differences.
    DERIVATIVES: f64 = 1e-6;

    /// Derivatives backwards by the inputs against those forwards, both of a weighted sum of all
    /// outputs, over the greatest that any input does over a usual range: rounding of some 1e5
    /// operations.
    BACKWARDS: f64 = 1e-9;

    /// Derivatives backwards by parameters and by displacements of the profiles against central
    /// differences, over the greatest that any of them does: rounding of the differences.
    BACKWARDS_DIFFERENCES: f64 = 1e-6;

    /// The same by the nominal radius on rails of slices, which are laid for a wheel of the radius that
    /// it has: the cause is not known.
    BACKWARDS_ON_SLICES: f64 = 3e-6, target 1e-6;

    /// Work around a frictionless closed loop as wide as a patch is long over the energy stored,
    /// median and worst: the nodes of strips stand otherwise in every place.
    LOOP_WORK: [f64; 2] = [1e-4, 1.5e-2], target [1e-4, 1e-4];

    /// Work around loops ten times as wide, over the energy stored, median and worst: they run over
    /// as many more places of the nodes. On a worn wheel, whose normals turn by 15 degrees within a
    /// patch, a lateral force that is a thousandth of the load off over 0.4 mm to and fro does a
    /// fiftieth of the work that is stored at 50 µm.
    WIDE_LOOP_WORK: [f64; 2] = [1e-3, 2e-2], target [1e-4, 1e-4];

    /// Energy that a bounce without damping and friction gains or loses, median and worst: ten of
    /// them change the height by a hundredth. On the root of the flange, where a wheel slides up by
    /// a tenth of a millimetre, one alone may.
    BOUNCE: [f64; 2] = [1e-3, 1e-2], target [1e-3, 1e-3];

    /// Sum of the energy residuals of undamped bounces over what the mass and the contact have
    /// gained: the rule of the trapezoid between the ends of a step, up to an eighth of a period
    /// long. A kink of the stiffness by 5 %, as much as strips may have, in the middle of a step is
    /// a twelfth of that.
    ENERGY_RESIDUAL: f64 = 5e-3;

    /// Approach velocity against differences of the penetration over 0.2 µs [m/s]: speeds are up to
    /// 0.5 m/s.
    CLOSING_SPEED: f64 = 1e-6;
}
