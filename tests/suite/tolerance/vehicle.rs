//! Tolerances of wheelsets, tracks and hosts, and of what is the same elsewhere.

super::entry::tolerances! {
    /// What is exact: within rounding of a few operations.
    ROUNDING: f64 = 1e-12;

    /// The same problem in other units, by the laws of similarity: roots of zone edges end at 1e-7
    /// m, so that a scaled problem is not solved bit for bit alike.
    SIMILARITY: f64 = 1e-9;

    /// A problem and its mirror image along x, or turned about it: the search runs through other
    /// roundings.
    MIRRORED: f64 = 1e-9;

    /// Force of a wheel that is picometres deep [N]: its depth is rounding.
    NO_FORCE: f64 = 1e-9;

    /// The same code built otherwise, optimized or for another platform, share of the value: sines,
    /// roots and logarithms of another C library differ in the last digit. Newton steps of strips
    /// end at a change of 1e-5, which leaves its square, 1e-10, times the curvature of the
    /// equations; where that last digit decides on one more step, answers differ by that much.
    OTHER_BUILD: f64 = 1e-9;

    /// The same on another processor with the same C library, whose sines, exponentials and logarithms
    /// are the same bits there: what is left is the order of sums.
    OTHER_PROCESSOR: f64 = 1e-12;

    /// Wheel markers of a wheelset against products of rotation matrices, position [m], velocity
    /// over 60 m/s: rounding.
    WHEELSET_MARKER: f64 = 1e-15;

    /// Forces of a wheelset against two wheels moved by hand, relative to the greatest component:
    /// the same sums in another order.
    WHEELSET_FORCE: f64 = 1e-12;

    /// A wheelset on cones in a curve against its linear equations: these leave out squares of the
    /// conicity (4e-4) and of its shift over the half distance of the contacts (1e-5), and take
    /// Kalker's coefficients, which the linear model meets by its fits
    /// ([`KALKER_FIT`](super::KALKER_FIT)) and the march along its strips
    /// ([`FASTSIM_LINEAR`](super::FASTSIM_LINEAR)).
    LINEAR_CURVING: f64 = 0.01;

    /// Motion under weight against the mechanism of rigid profiles: the overlap is that share of
    /// the radii.
    GRAVITY: f64 = 1e-4;

    /// The same with strips, whose nodes stand a little otherwise in every place: a hundredth of
    /// the frequency is less than what is known of a vehicle.
    GRAVITY_STRIPS: f64 = 1e-2;

    /// Critical speed of a wheelset in exudyn against `wheelrail simulate`: what the first-order
    /// integrator of the latter shifts at its step of 2e-5 s, about ω²h/2 = 0.013 1/s in the growth
    /// rate, which 0.22 (1/s)/(m/s) turns into 0.06 m/s of 75 m/s.
    HUNTING_SPEED: f64 = 1e-3;

    /// Lateral motion of the two over a run, share of its amplitude: that shift, grown over 1.2 s,
    /// is 0.013 1/s · 1.2 s = 1.6 % where the oscillation does not die out.
    HUNTING_MOTION: f64 = 0.02;

    /// Longest stable steps against their formulas: the search for them.
    LONGEST_STEP: f64 = 1e-4;

    /// Limits of the step put out by a unit against those printed or from differences of its forces: the
    /// four digits that are printed.
    LIMIT_BY_DIFFERENCES: f64 = 5e-4;

    /// The same for forces one step late: their formula is that for light damping.
    DELAYED_STEP: f64 = 0.05;

    /// Contact force and force of the springs under a rail against CONTACT, over the contact force,
    /// median and worst: the target for loads; twice that at the 13 mm corner of the rail, where
    /// the one plane of the contact of the reference is turned by 2 degrees.
    MASSLESS_RAIL: [f64; 2] = [0.01, 0.02];

    /// What springs and contacts leave of a force on rails at rest, over the normal force: forces
    /// are smooth to 1e-9 of it.
    RAIL_AT_REST: f64 = 1e-9;

    /// Poses of a hundred in which the Hertzian ellipse jumps where the rails would rest: from one
    /// contact point to another, see [`JUMP_HERTZ`](super::JUMP_HERTZ).
    RAILS_WITHOUT_REST: usize = 10, kept;

    /// Energy that rails with a mass, their contact and the wheel on it are short of, over the work
    /// of the wheel up and down: the target for closed loops of a contact.
    TRACK_ENERGY: f64 = 1e-4;

    /// Rails at rest, with a mass and without [m]: a millionth of what a wheel load presses on
    /// stiff contacts.
    RAIL_PLACE: f64 = 1e-10;

    /// Forces at heights and deflections that were found, and found again on rails that are put
    /// there: searches within searches, each to 1e-9 of the load.
    FOUND_AGAIN: f64 = 1e-8;
}
