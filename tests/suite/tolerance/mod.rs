//! Every tolerance of the integration tests: what it bounds, against what, and why it is as large
//! as it is.

/// Exact within rounding of a few operations.
pub const ROUNDING: f64 = 1e-12;

/// Hertz model against the closed form: the model is the closed form, its quadrature is not.
pub const HERTZ: f64 = 1e-6;

/// Piotrowski-Kik on a sphere against its closed form sqrt(2 ε) Hertz: quadrature across the zone,
/// polynomials of the elliptic integrals.
pub const PIOTROWSKI_KIK_SPHERE: f64 = 1e-4;

/// Linear limit of FASTSIM against Kalker's coefficients at 20 elements: middle rule along the
/// strips.
pub const FASTSIM_LINEAR: f64 = 5e-3;

/// A wheel on a rail that varies along the track against CONTACT, medians: height of the wheel [m]
/// and contact position [m], greatest pressure, creep force over the friction limit. The corners of
/// these rails step in curvature, and their patches are 1.5 mm wide on elements of 0.2 mm.
pub const VARYING_HEIGHT: f64 = 1e-6;
pub const VARYING_PLACE: f64 = 2e-4;
pub const VARYING_PRESSURE: f64 = 0.03;
pub const VARYING_FORCE: f64 = 0.03;
/// Wheels of simple shapes on rollers against CONTACT: normal force and greatest pressure [-],
/// contact angle [rad]: the aims for loads and pressures, and a degree's twentieth.
pub const ROLLER_FORCE: f64 = 0.01;
pub const ROLLER_PRESSURE: f64 = 0.03;
pub const ROLLER_ANGLE: f64 = 1e-3;
/// Change of the vertical force along a track that bends against that of the longitudinal one with
/// the height: the aim for loads.
pub const VARYING_ENERGY: f64 = 1e-2;

/// Force and moment [m] of a wheel that turns beside its middle, of sections every 5 degrees,
/// against the round wheel there, over the greatest force, median and worst: splines between
/// sections and points leave a nanometre of heights, over depths of some 0.05 mm and down to 2 µm.
pub const ECCENTRIC: [[f64; 2]; 2] = [[1e-5, 1e-3]; 2];
/// The same by boundary elements, whose lattice counts from the marker, half a millimetre
/// elsewhere: the aim for loads.
pub const ECCENTRIC_ELEMENTS: [[f64; 2]; 2] = [[1e-2; 2]; 2];
/// Waves of a wheel by sections against the same as a wheel that is out of round, height [m] and
/// greatest pressure: a tenth of the aim for heights, and a third of that for pressures.
pub const BRIDGED_HEIGHT: f64 = 1e-7;
pub const BRIDGED_PRESSURE: f64 = 0.01;
/// Angle from the middle of the flat of the tests beyond which the edge of its hollow is flat
/// enough for elements of 0.2 mm [rad]: nearer to the middle the pressure has a peak along it that
/// grows with their number.
pub const FLAT_WITHOUT_EDGE: f64 = 0.08;

/// Creep force over friction times normal force at most: one and rounding where the patch is flat;
/// 1/cos α where loads act along their own normals within an angle α of the resultant. That is 30
/// degrees at depths up to a millimetre, many times those of heavy loads, and 60 degrees, from the
/// flank of a flange to half way to the tread, beyond.
#[must_use]
pub fn most_friction(is_flat: bool, penetration: f64) -> f64 {
    if is_flat {
        return 1.0 + 1e-9;
    }
    let angle = if penetration < 1e-3 { 30.0_f64 } else { 60.0 };
    1.0 / angle.to_radians().cos()
}

/// Full sliding against friction times normal force.
pub const FULL_SLIDING: f64 = 1e-3;

/// Share of the friction limit by which FASTSIM (elliptic bound, blended flexibilities, 20x20)
/// misses CONTACT on 300 ellipses, mean and 95 %: the error of the simplified theory itself.
pub const FASTSIM_ELLIPSES: [f64; 2] = [0.022, 0.055];

/// The fits of Kalker's coefficients against the exact ones inside a/b 0.05 to 20, for c11, c22,
/// c23.
pub const KALKER_FIT: [f64; 3] = [2.1e-3, 1.4e-3, 5.0e-3];

/// Piotrowski-Kik on an ellipse of a/b = 5 against Hertz at the same approach: the published
/// differences are given to a tenth of a per cent.
pub const PIOTROWSKI_KIK_SLENDER: f64 = 1e-3;

/// Laws of similarity: the same problem in other units. Roots of zone edges end at 1e-7 m, so that
/// a scaled problem is not solved bit for bit alike.
pub const SIMILARITY: f64 = 1e-9;

/// A force that is none, of a wheel that is picometres deep: its depth is rounding [N].
pub const NO_FORCE: f64 = 1e-9;

/// The same beyond, a/b 0.03 to 0.05 and 20 to 33, where the fits are carried into asymptotes that
/// are themselves a few per cent off.
pub const KALKER_ENDS: [f64; 3] = [2.2e-2, 1.6e-2, 2.1e-2];

/// Prescribed vertical load of the Manchester benchmark.
pub const PRESCRIBED_LOAD: f64 = 1e-10;

/// Manchester benchmark against CONTACT, 42 contacts: medians, and every contact but the
/// listed ones. Contact position [mm] and angle [degrees]: CONTACT reports a weighted centre of the
/// patch.
pub const MANCHESTER_POSITION_MM: f64 = 0.3;
pub const MANCHESTER_ANGLE_DEG: f64 = 0.3;

/// Creepages, relative; longitudinal and lateral creepage need not be closer than the floor.
pub const MANCHESTER_CREEPAGE: f64 = 0.02;
pub const MANCHESTER_CREEPAGE_FLOOR: f64 = 5e-5;

/// Spin, relative, median and worst: on the flat contacts of the left wheel, 0.5 to 1.2 degrees, it
/// is the contact angle that is 0.03 to 0.08 degrees off.
pub const MANCHESTER_SPIN: [f64; 2] = [0.02, 0.065];

/// Longitudinal and lateral creep force over the friction limit, median and worst: the error of the
/// simplified theory, and where the patch straddles the rail's jump of curvature that of its place.
pub const MANCHESTER_FX: [f64; 2] = [0.003, 0.14];
pub const MANCHESTER_FY: [f64; 2] = [0.001, 0.06];

/// Normal force at given vertical load, median and worst: the contact angle and the creep force
/// decide it.
pub const MANCHESTER_NORMAL_FORCE: [f64; 2] = [3e-4, 2.5e-3];

/// Greatest pressure, median and worst: Piotrowski-Kik is 23 % off in the median of non-Hertzian
/// patches, less on these.
pub const MANCHESTER_PRESSURE: [f64; 2] = [0.085, 0.29];

/// Greatest jumps of the normal force, over the force, in a sweep of a S1002 wheel over a 60E1
/// rail, 30 to 150 µm deep: both models have one contact point for each penetrated interval, and at
/// a swap of two minima 5 mm from the centred position, between tread and flange root, or at the
/// centred position itself, the whole load is computed anew from the other one. A model without a
/// preferred point is what removes them.
pub const JUMP_PIOTROWSKI_KIK: f64 = 0.35;

/// As above; the Hertzian ellipse has the curvatures of one point alone, 300 or 80 mm of the rail.
pub const JUMP_HERTZ: f64 = 0.65;

/// Deepest penetration of the contact search against a scan at steps of 20 µm [m].
pub const DEEPEST_PENETRATION: f64 = 1e-7;

/// Penetration that no search may miss [m].
pub const MISSED_PENETRATION: f64 = 1e-7;

/// Contact line against the lowest of all rolling circles: height, from chords of 20 µm on radii of
/// 12 mm, and place along x, where the lowest is flat [m].
pub const OUTLINE_HEIGHT: f64 = 2e-8;
pub const OUTLINE_AHEAD: f64 = 1e-6;

/// Central differences over 1 µm of curves with radii of millimetres.
pub const DERIVATIVE: f64 = 1e-5;

/// Place of a flange contact along x against r tan(contact angle) sin(yaw), of first order in the
/// angles.
pub const FLANGE_AHEAD: f64 = 0.01;

/// Contact angle of a cone [rad] and its place on an arc [m]: minima are pinned down to 1e-9 m,
/// arcs are cubic pieces.
pub const CONE_ANGLE: f64 = 1e-6;
pub const CONE_PLACE: f64 = 1e-6;

/// Height of first touch of bodies of known size [m]: bisection to rounding, arcs are cubic pieces.
pub const TOUCHING_HEIGHT: f64 = 1e-9;

/// Place of a contact on bodies of known size [m]: an error of the arm of a moment.
pub const CONTACT_PLACE: f64 = 1e-6;

/// Axle moment against longitudinal force times rolling radius.
pub const AXLE_MOMENT: f64 = 0.01;

/// A problem and its mirror image along x, or turned about it: the search runs through other
/// roundings.
pub const MIRRORED: f64 = 1e-9;

/// Two directions of running at 20 m/s with 25 mm/s of slip: creepages refer to mean speeds that
/// differ by a thousandth.
pub const REFERENCE_SPEED: f64 = 2e-3;

/// Direction of the creep force of a wheel that slides: spin turns it a little, share of the
/// friction limit.
pub const SLIDING_DIRECTION: f64 = 0.02;

/// Greatest change of a continuous force when the step is a quarter.
pub const SHRINKING: f64 = 0.35;

/// Second differences of the force over steps of 1 nm and 1 nrad less the curvature of the force,
/// over the force: a stiff integrator's Newton differences stand on these. What is seen are kinks:
/// of a strip of FASTSIM that begins to slip all over (5e-8 with one of nine, single steps of the
/// lateral force), of the curvature of a profile under a contact point.
pub const ROUGHNESS: f64 = 6e-8;

/// The same for strips with the table, which have neither: the aim. Worst is 8e-11.
pub const ROUGHNESS_STRIPS: f64 = 1e-9;

/// Approach velocity against differences of the penetration over 0.2 µs [m/s]: speeds are up to 0.5
/// m/s.
pub const CLOSING_SPEED: f64 = 1e-6;

/// CONTACT's row of docs/frames.md, relative: a check of signs; the other rail (60E1 instead of the
/// benchmark's) moves spin by some per cent.
pub const FRAMES_SHARE: f64 = 0.15;

/// Printed results of the normal problem in table 1 of Piotrowski and Kik, printed to three or four
/// digits.
pub const PAPER_TABLE_1: f64 = 5e-3;

/// Ratio of length to width of the corrected area of a Hertzian pair: the width is that of a
/// quadrature.
pub const CORRECTED_RATIO: f64 = 1e-3;

/// Greatest pressure and normal force of the corrected area against Hertz at the same approach, a/b
/// 0.1 to 10: the correction halves the error of the pressure (0.195 without) and pays with that of
/// the force (0.049 without).
pub const CORRECTED_PRESSURE: f64 = 0.105;
pub const CORRECTED_FORCE: f64 = 0.116;

/// Linear theory against FASTSIM with friction 1e9 and 200 elements along: middle rule, 1/(2 n²).
pub const LINEAR_LIMIT: f64 = 1e-4;

/// Forces and moments of a cone with flat and with curved creepage, over the force: the same sums
/// in another order.
pub const CONE_FLAT_AND_CURVED: f64 = 1e-9;

/// Frictional power against the power of the tractions on both bodies, over force times speed: sums
/// in another order.
pub const POWER_BALANCE: f64 = 1e-12;

/// Power that tractions may feed into the bodies, over what friction could turn into heat.
pub const POWER_FED: f64 = 0.0;

/// Vertical force on the rails against the given load, as a share of it, and the last digit of the
/// height times the stiffness [N].
pub const CARRIED_LOAD: [f64; 2] = [1e-10, 1e-6];

/// Difference from the given load that counts as not carried, as the element tells it: share of the
/// load and force [N].
pub const MISSED_LOAD: [f64; 2] = [1e-6, 1e-3];

/// Second differences of the height under a given load over lateral steps of 1 µm [m]: what the
/// curvature of the profiles leaves.
pub const HEIGHT_ROUGHNESS: f64 = 1e-11;

/// Rim of a flange back against the innermost points of the turned wheel: place along x, which is
/// flat there, and across, at yaw of 2 mrad and more: up to 12 µm inside at 0.2 mrad, where the
/// line changes smoothly from one end of the chord to the other [m].
pub const RIM_AHEAD: f64 = 1e-3;
pub const RIM_LATERAL: f64 = 2e-6;

/// Change of the lateral force and of the yaw moment on a wheel that a check rail holds with 20 kN,
/// per microradian of yaw: half a chord of 60 mm at a contact stiffness of 1e9 N/m is 60 N, a point
/// that moves 0.3 mm under 20 kN is 6 N m [N, N m].
pub const CHECK_RAIL_STEP: [f64; 2] = [120.0, 20.0];

/// Forces of two rails in one place, one of them placed by its gauge face: a root to 1e-15 m, over
/// a penetration of 60 µm.
pub const SAME_PLACE: f64 = 1e-9;

/// Wheels at 3 and 6 degrees against brute force: depth, and place along x of the load's centroid
/// against the deepest point [m].
pub const YAWED_DEPTH: f64 = 1e-12;
pub const YAWED_PLACE: f64 = 1e-4;

/// Curvature along the rail of a yawed wheel against its surface, relative.
pub const SECTION_CURVATURE: f64 = 4e-3;

/// A wheel at given load against CONTACT (tests/suite/element_normal.rs); rows strips,
/// piotrowski_kik, piotrowski_kik_corrected, hertz; columns normal force, greatest pressure, area
/// [-] and place along the profile [mm], median and worst. The greatest pressure of strips is held
/// to the aims of planar problems, 0.5 and 6 %. Strips are compared up to contact angles of 60
/// degrees: steeper, N at a given load is decided by an angle that one plane does not have. Small
/// patches are five elements of the reference wide; place is worst on two zones that the reference
/// takes as one.
pub const ELEMENT_NORMAL: [[[f64; 2]; 4]; 4] = [
    [[1.2e-4, 0.085], [5e-3, 0.06], [0.012, 0.15], [0.14, 1.65]],
    [[7e-4, 0.165], [0.19, 0.60], [0.10, 0.55], [0.12, 1.85]],
    [[7e-4, 0.165], [0.16, 0.60], [0.10, 0.37], [0.13, 2.0]],
    [[7e-4, 0.165], [0.02, 0.50], [0.05, 0.51], [0.3, 5.0]],
];

/// Most Newton steps of the strips wherever a wheel may stand: what bounds the time of an
/// evaluation, half of what the solver allows.
pub const STRIP_STEPS: u64 = 20;

/// Jump of the normal force over steps of 0.1 µm at swaps of the deepest place, over the force. The
/// aim.
pub const STRIPS_JUMP: f64 = 1e-4;

/// Second differences in fine steps of the sweeps of a new and a worn S1002 on 60E1, curved
/// creepage: vertical and lateral force over the load, longitudinal force and moment about the
/// vertical (times 10 mm) over the friction limit. The aim is none; two zones that become one get
/// one contact frame, along whose normal they carry less.
pub const STRIPS_SWEEP_JUMPS: [f64; 4] = [3e-4, 5.5e-4, 2.4e-3, 4e-3];

/// Second differences of the vertical force in fine steps of sweeps in other places, without creep
/// forces, over the load. The aim is none.
pub const STRIPS_SWEEP_ELSEWHERE: f64 = 0.048;

/// The same code built otherwise, optimized or for another platform, share of the value: sines,
/// roots and logarithms of another C library differ in the last digit. Newton steps of strips end
/// at a change of 1e-5, which leaves its square, 1e-10, times the curvature of the equations: where
/// that last digit decides on one more step, answers differ by that much.
pub const OTHER_BUILD: f64 = 1e-9;

/// Critical speed of a wheelset in exudyn against `wheelrail simulate`: what the first-order
/// integrator of the latter shifts at its step of 2e-5 s, about ω²h/2 = 0.013 1/s in the growth
/// rate, which 0.22 (1/s)/(m/s) turns into 0.06 m/s of 75 m/s.
pub const HUNTING_SPEED: f64 = 1e-3;

/// Lateral motion of the two over a run, share of its amplitude: the same, grown over 1.2 s, which
/// is 0.013 1/s · 1.2 s = 1.6 % where the oscillation does not die out.
pub const HUNTING_MOTION: f64 = 0.02;

/// FaStrip on the 300 ellipses, 20x20, blended: mean, 95 % and worst error over the friction limit.
/// CONTACT's own FaStrip on 22x22: 0.017, 0.048, 0.067.
pub const FASTRIP_ELLIPSES: [f64; 3] = [0.0125, 0.04, 0.062];

/// Boundary elements 60x60 against Hertz: load, greatest pressure, area. The greatest pressure is
/// that of an element.
pub const BOUNDARY_HERTZ: [f64; 3] = [1e-3, 1e-3, 0.01];

/// Boundary elements 60x60 against CONTACT on its finest grids, worst of one-region profiles: load,
/// greatest pressure, area. One pressure has its peak at the rail's jump of curvature, narrower
/// than an element: 0.31 %.
pub const BOUNDARY_NORMAL_ONE_REGION: [f64; 3] = [0.003, 0.0035, 0.012];
/// The same with two regions on one plane.
pub const BOUNDARY_NORMAL_TWO_REGIONS: [f64; 3] = [0.015, 0.015, 0.015];

/// Boundary elements 22x22 and finer against extrapolated results of CONTACT on 300 ellipses, mean
/// and worst, share of the friction limit: the reference is known to 0.003 in the mean.
pub const BOUNDARY_ELLIPSES: [f64; 2] = [0.003, 0.01];

/// Boundary elements 40x40 against CONTACT with 40 elements across on real profiles, mean and
/// worst, share of the friction limit. The reference is known to 0.002 in the mean, 0.011 at worst:
/// against 80 elements across the errors are less than half.
pub const BOUNDARY_PROFILES: [f64; 2] = [0.005, 0.016];
/// The same against 80 elements across.
pub const BOUNDARY_PROFILES_FINE: [f64; 2] = [0.002, 0.008];
/// 24x24 against 80 across, for debug builds.
pub const BOUNDARY_PROFILES_COARSE: [f64; 2] = [0.006, 0.015];

/// Kalker's coefficients by full adhesion, extrapolated from two grids: the outline of an ellipse
/// in squares is not smooth.
pub const BOUNDARY_KALKER: f64 = 0.01;

/// Carter's force at 128 elements along, share of the friction limit, and least observed order.
pub const BOUNDARY_CARTER: f64 = 0.002;
pub const BOUNDARY_CARTER_ORDER: f64 = 0.8;

/// Cattaneo's force at 32x32 elements, share of the friction limit, and least observed order.
pub const BOUNDARY_CATTANEO: f64 = 0.003;
pub const BOUNDARY_CATTANEO_ORDER: f64 = 0.8;

/// Boundary elements on the pressure of Hertz spread over a grid against those on their own
/// pressure, share of the friction limit.
pub const BOUNDARY_SPREAD: f64 = 0.01;

/// Equivalent conicity of the reference cases of EN 15302, share of that standard's tolerance:
/// 0.015 at worst, which is the third digit of the expected figures, but for E5 (920 and 918 mm),
/// where it is an eighth.
pub const EN_15302: f64 = 0.13;

/// Rolling radius differences of cones and arcs against closed forms [m]: contact points are looked
/// at 0.1 nm deep.
pub const ROLLING_RADIUS: f64 = 1e-8;

/// Conicity of a cone at 3 mm; conicity of arcs at 3 mm against the formula for small amplitudes.
pub const CONE_CONICITY: f64 = 1e-5;
pub const ARC_CONICITY: f64 = 0.01;
/// Deviations of 1e-13 m against none: quadrature along strips, and an edge found to 1e-7 m.
pub const VANISHING_DEVIATIONS: f64 = 3e-5;

/// Depth of contact of uneven bodies against a scan of their surfaces: the wheel's circle as a
/// parabola over 11 mm, and its angles as arcs of the nominal rolling circle also on a flange that
/// touches 10 mm ahead [m].
pub const UNEVEN_DEPTH: f64 = 4e-7;

/// Crest and trough of a wave of 0.5 m against wheels of that curvature: the wave is no parabola
/// over 15 mm.
pub const LONG_WAVE: f64 = 5e-3;

/// Moment about the axle of a round wheel on a corrugated rail over its normal force: rounding, and
/// the parabola for the circle [m].
pub const FREE_TORQUE: f64 = 5e-6;

/// Normal force with damping on uneven bodies against that of the rate of their depth, over the
/// force.
pub const CLOSING_RATE: f64 = 2e-3;

/// Height of a wheel on a fresh flat against that on sharp corners: they are rounded over a tenth
/// of its length [m].
pub const FLAT_HEIGHT: f64 = 1e-4;

/// Jumps of normal and creep force over the force, rolling over corrugations and flats in steps of
/// 12 µm.
pub const UNEVEN_JUMP: f64 = 5e-3;
pub const UNEVEN_CREEP_JUMP: f64 = 1e-3;

/// Waves from files of points, every 0.5 mm and half degree, against the waves themselves.
pub const DEVIATION_FILES: f64 = 1e-3;

/// A tread patch by Piotrowski-Kik and FASTSIM against 14x14 boundary elements at the same height:
/// load, and creep force as share of the friction limit (twice that for FASTSIM).
pub const BOUNDARY_ELEMENT_LOAD: f64 = 0.1;
pub const BOUNDARY_ELEMENT_CREEP: f64 = 0.05;

/// Running backwards with boundary elements: the contact search passes through other roundings, and
/// sweeps end within 1e-4 of the tractions.
pub const BOUNDARY_BACKWARDS: f64 = 1e-3;

/// Estimated errors of the nodes of the table of creep forces, over the friction limit: mean and
/// worst.
pub const TABLE_NODES: [f64; 2] = [1.5e-3, 0.012];

/// Full sliding with spin, interpolated between exact values, a/b 0.055 to 18, mean and worst:
/// force over μ N, moment over μ N c. The worst are ellipses of a/b near 18 that turn about a point
/// beside their longer axis.
pub const TABLE_SLIDING: [[f64; 2]; 2] = [[5e-4, 6e-3], [5e-4, 1.6e-2]];

/// Derivatives of the table against central differences over 1e-6 of the creepage.
pub const TABLE_SLOPES: f64 = 1e-7;

/// The table against boundary elements of 12 and 18 across between its nodes, over the friction
/// limit, mean and worst: the error of the coarse grids. And for ν = 0 and 0.5, where the linear
/// coefficients alone know it.
pub const TABLE_BETWEEN: [f64; 2] = [2e-3, 1e-2];
pub const TABLE_POISSON: [f64; 2] = [1e-2, 6e-2];

/// The table against CONTACT on 300 ellipses, over the friction limit: mean, 95 %, worst. The
/// reference itself is uncertain by 0.003 in the mean, 0.014 at worst.
pub const TABLE_ELLIPSES: [f64; 3] = [0.0032, 0.0065, 0.03];

/// Strips with tables, and with FASTSIM corrected by them, against CONTACT on 656 states of 8 real
/// patches: force over the friction limit, mean, 95 %, worst; mean of the spin moment over the
/// limit times c. The aims; corrected FASTSIM has the same.
pub const TABLE_PROFILES: [f64; 3] = [0.010, 0.030, 0.055];
pub const TABLE_PROFILES_MOMENT: f64 = 0.008;
pub const CORRECTED_PROFILES: [f64; 3] = TABLE_PROFILES;
pub const CORRECTED_PROFILES_MOMENT: f64 = TABLE_PROFILES_MOMENT;

/// The same for strips for both problems, which are to be no worse.
pub const STRIPS_PROFILES: [f64; 3] = TABLE_PROFILES;
pub const STRIPS_PROFILES_MOMENT: f64 = TABLE_PROFILES_MOMENT;

/// Strips against Kalker's linear theory for a/b from 0.2 to 2: c11, c22, c23 from the force, c33,
/// c23 from the moment. The aim is 0.01 for all of them: the tractions between ten strips are
/// linear, those of spin beyond the outer ones constant, and those of full adhesion have a
/// singularity at the trailing edge, which moments feel; nothing of it is left once anything slips.
pub const STRIPS_KALKER: [f64; 5] = [0.015, 0.02, 0.04, 0.05, 0.08];
/// Strips against CONTACT on 300 ellipses, force over the friction limit: mean, 95 %, worst. The
/// aims of all sets.
pub const STRIPS_ELLIPSES: [f64; 3] = [0.004, 0.012, 0.03];
/// Strips against boundary elements over the positions of a wheel on its rail: force over the
/// friction limit, mean, 95 %, worst. The aims.
pub const STRIPS_POSITIONS: [f64; 3] = [0.004, 0.012, 0.03];

/// Roughness of creep forces of strips in steps of 1 nm, over the friction limit, at 95 %: the aim;
/// the rest is for points that begin to slip or to adhere.
pub const STRIPS_ROUGHNESS: f64 = 1e-9;

/// The same for strips with tables and with corrected FASTSIM: as many strips as an element starts
/// with; the worst is that of tables on real patches.
pub const MANCHESTER_TABLES_FX: [f64; 2] = [0.0005, 0.04];
pub const MANCHESTER_TABLES_FY: [f64; 2] = [0.001, 0.04];

/// Jump of the creep force where two zones of strips join, 20 strips, over the friction limit:
/// ellipses of the same moments, of load for tables and of the outline for the flexibilities of
/// marches, do not jump.
pub const JOINING_ZONES: f64 = 1e-5;
pub const JOINING_ZONES_MARCHED: f64 = 5e-5;

/// The same for strips for the creep force too. The aim is that of a walk, 1e-3: zones that touch
/// feel each other through the half-space only once they are one.
pub const STRIPS_JOIN: f64 = 0.03;

/// Worn volume against the sum of the law over the steps, and against the volume between the
/// profiles: the target.
pub const WORN_VOLUME: f64 = 1e-6;

/// Change of the worn profile from an update interval of 0.03 s to one of 0.015 s, root mean square
/// over the greatest depth; from a step of 0.015 s to one of 7.5 ms. A wheel that sways by 2.5 mm
/// at 1.7 Hz and loses 0.1 mm in 0.6 s.
pub const WEAR_UPDATE_INTERVAL: f64 = 0.01;
pub const WEAR_STEP: f64 = 0.01;

/// Change of the normal force at an update over the greatest depth that went and the Hertzian
/// stiffness of the patch.
pub const WEAR_FORCE_CHANGE: f64 = 1.0;

/// A profile that was written and read back, distance from itself [m]: a spline through points 0.1
/// mm apart at the jumps of curvature.
pub const PROFILE_READ_BACK: f64 = 1e-7;

/// Wheel markers of a wheelset against products of rotation matrices: position [m], velocity over
/// 60 m/s.
pub const WHEELSET_MARKER: f64 = 1e-15;

/// Forces of a wheelset against two wheels moved by hand, relative to the greatest component.
pub const WHEELSET_FORCE: f64 = 1e-12;

/// Derivatives of outputs by inputs against central differences, over the greatest one of its unit
/// and input; random poses, by model: the target. Measured: 8e-7 at worst, with a given load, 3e-11
/// in the median; what is left is rounding of the differences.
pub const DERIVATIVES: f64 = 1e-6;

/// Sum of the energy residuals of undamped bounces over what the mass and the contact have gained:
/// the rule of the trapezoid between the ends of a step, up to an eighth of a period long. A kink
/// of the stiffness by 5 %, as much as strips may have, in the middle of a step is a twelfth of
/// that.
pub const ENERGY_RESIDUAL: f64 = 5e-3;

/// Longest stable steps against their formulas: the search for them.
pub const LONGEST_STEP: f64 = 1e-4;

/// The same for forces one step late, whose formula is that for light damping.
pub const DELAYED_STEP: f64 = 0.05;

/// Share of the evaluations of a wheel on a hard profile, 0.1 µm to 0.1 mm deep, in which strips
/// fall back: 3 of 510 on 20 µm of noise left unsmoothed, none elsewhere at every second place.
pub const HARD_FALLBACKS: f64 = 0.01;

/// The default 12 strips and 20 elements against 120 of both, Piotrowski-Kik and FASTSIM, 500
/// random poses: normal force, area, greatest pressure and force on the wheel, 95 % and worst. The
/// models themselves are off by 3, 20, 20 and 4 %.
pub const DEFAULT_COUNTS: [[f64; 2]; 4] = [[5e-4, 4e-3], [6e-4, 3e-3], [5e-4, 5e-3], [4e-3, 6e-3]];

/// Greatest pressure on profiles read from exact points over that on the profiles themselves [%]:
/// the target for the worst case of the strip model, 6 %, is not to be spent on reading.
pub const EXACT_POINTS_PRESSURE: f64 = 2.0;

/// Motion under weight against the mechanism of rigid profiles: the overlap is that share of the
/// radii.
pub const GRAVITY: f64 = 1e-4;

/// The same with strips, whose nodes stand a little otherwise in every place: a hundredth of the
/// frequency is less than what is known of a vehicle.
pub const GRAVITY_STRIPS: f64 = 1e-2;

/// Strips on one grid against Hertz, a/b 0.1 to 10, by their number: normal force and greatest
/// pressure, relative. What a user of the result does not see in the force, and at worst twice that
/// in the pressure.
pub const GRID_HERTZ: [(usize, [f64; 2]); 2] = [(20, [5e-3, 1e-2]), (40, [2e-3, 5e-3])];

/// The same against CONTACT on all planar cases, of one region and of two, by their number: median
/// and worst of normal force, greatest pressure and area [%]. The aims are 0.1 and 0.8, 0.5 and 6,
/// 0.5 and 2.5 for as many as an element starts with, 0.03 and 0.3, 0.1 and 1, 0.3 and 1 for 40;
/// what is wider here is open.
pub const GRID_PLANAR_PERCENT: [(usize, [[f64; 2]; 3]); 2] =
    [(20, [[0.1, 0.8], [0.5, 6.0], [0.5, 2.5]]), (40, [[0.03, 0.3], [0.1, 3.0], [0.5, 1.5]])];

/// Most Newton steps of strips on one grid in any planar case: a third of what the solver allows.
pub const GRID_STEPS: u64 = 14;

/// Bend of the load of strips on one grid over its rise, per step of 0.1 µm, where two overlaps
/// join across a sharp valley: a jump would be of the order of one.
pub const GRID_BEND: f64 = 0.2;

/// Jumps along random walks: of the force over the load without creep forces, and over the friction
/// limit with them. The aims.
pub const WALK_JUMPS: [f64; 2] = [1e-4, 1e-3];

/// Largest change of the stiffness from step to step of 0.1 µm in a line of 0.1 mm of a random
/// walk, over the stiffness of the contact, below which 95 % of the lines stay. The aim.
pub const WALK_KINKS: f64 = 0.05;

/// Share of a patch's area in strips that carry next to nothing: one of some twenty, and short.
pub const UNLOADED_SHARE: f64 = 5e-3;

/// Boundary elements on curved contacts against the conformal mode of CONTACT, median, 95 % and
/// worst: greatest pressure, which is held to 0.5 and 2 % (a sharp contact of CONTACT has five
/// elements across: its own error there is 1.6 %), and force in the contact's plane over the
/// friction limit, which is held to 0.3 and 4 %. Its 95 % is held to the worst: the program's
/// normals are means over places at equal arcs of wheel and rail, half a degree off on sharp
/// flanks, where its own force is no derivative of an energy (4 %).
pub const BOUNDARY_CONFORMAL: [[f64; 3]; 2] = [[0.005, 0.02, 0.04], [0.003, 0.04, 0.04]];

/// Distance left in the contact over the overlap, and slip that contradicts friction over the
/// largest rigid slip: a hundredth of what grids leave.
pub const BOUNDARY_GAP: f64 = 1e-5;
pub const BOUNDARY_SLIP: f64 = 0.01;

/// Asymmetry of the stiffness, and work of a closed loop over the stored energy, without friction.
pub const BOUNDARY_CONSERVATIVE: f64 = 1e-3;

/// Two contacts of one rail by boundary elements and by strips.
pub const BOUNDARY_TWO_ZONES: f64 = 0.01;

/// Work around a frictionless closed loop as wide as a patch is long over the energy stored, median
/// and worst. The median is the aim; at worst it is that of the strips before, whose nodes stand
/// otherwise in every place too.
pub const LOOP_WORK: [f64; 2] = [1e-4, 1.5e-2];
/// The same for loops ten times as wide, which run over as many more places of the nodes.
pub const WIDE_LOOP_WORK: [f64; 2] = [1e-3, 1.5e-2];
/// Energy that a bounce without damping and friction wins or loses, median and worst: the aim for
/// each.
pub const BOUNCE: [f64; 2] = [1e-3, 1e-3];

/// A wheelset on cones in a curve against its linear equations: these leave out squares of the
/// conicity (4e-4) and of its shift over the half distance of the contacts (1e-5), and take
/// Kalker's coefficients, which the linear model meets by its fits ([`KALKER_FIT`]) and the march
/// along its strips ([`FASTSIM_LINEAR`]).
pub const LINEAR_CURVING: f64 = 0.01;

/// Contact force and force of the springs under a rail against CONTACT, over the contact force: the
/// aim for the median; at worst twice that, at the 13 mm corner of the rail, where the one plane of
/// the contact of the reference is turned by 2 degrees.
pub const MASSLESS_RAIL: [f64; 2] = [0.01, 0.02];

/// What springs and contacts leave of a force on rails at rest, over the normal force: forces are
/// smooth to 1e-9 of it.
pub const RAIL_AT_REST: f64 = 1e-9;

/// Poses of a hundred in which the Hertzian ellipse jumps where the rails would rest: from one
/// contact point to another, see [`JUMP_HERTZ`].
pub const RAILS_WITHOUT_REST: usize = 10;

/// Energy that rails with a mass, their contact and the wheel on it are short of, over the work of
/// the wheel to and fro: the aim for closed loops of a contact.
pub const TRACK_ENERGY: f64 = 1e-4;

/// Rails at rest, with a mass and without [m]: 1e-6 of what a wheel load presses on stiff contacts.
pub const RAIL_PLACE: f64 = 1e-10;

/// Forces at heights and deflections that were found, and found again on rails that are put there:
/// searches within searches, each to 1e-9 of the load.
pub const FOUND_AGAIN: f64 = 1e-8;

/// Distance or overlap left at the nodes of strips before the last Newton step, over the greatest
/// overlap: that step changes loads by a millionth of the greatest, displacements by some times
/// that.
pub const STRIPS_GAP: f64 = 1e-5;
/// What tractions on strips are away from the law of friction, over their bound, where the
/// iteration ends.
pub const STRIPS_SLIP: f64 = 1e-10;
