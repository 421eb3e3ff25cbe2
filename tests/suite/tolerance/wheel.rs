//! Tolerances of a wheel on its rails.

super::entry::tolerances! {
    /// Prescribed vertical load of the Manchester benchmark: the search ends there.
    PRESCRIBED_LOAD: f64 = 1e-10;

    /// Vertical force on the rails against the given load, as a share of it and [N]: the last digit
    /// of the height times the stiffness; on flanges more, by as much as they are stiffer.
    CARRIED_LOAD: [f64; 2] = [1e-10, 1e-6];

    /// Forces at a given load against those at the height found for it, as a share of the load times
    /// the square of the force over the load, and [N]: the accuracy that heights are asked for; a
    /// lateral force, the load times the tangent of the contact angle, grows with the angle so.
    LOAD_AND_HEIGHT: [f64; 2] = [1e-9, 1e-6];

    /// Difference from the given load that counts as not carried, as the element tells it: share of
    /// the load and force [N].
    MISSED_LOAD: [f64; 2] = [1e-6, 1e-3];

    /// Contact position of the Manchester benchmark by Piotrowski-Kik and FASTSIM against
    /// CONTACT, median, and all of 42 contacts but the listed ones [mm]: CONTACT reports a weighted
    /// centre of the patch.
    MANCHESTER_POSITION_MM: f64 = 0.3, kept;

    /// The same, contact angle [degrees]: that of the weighted centre.
    MANCHESTER_ANGLE_DEG: f64 = 0.3, kept;

    /// The same, longitudinal and lateral creepage: what half a degree of contact angle and a
    /// millimetre of place turn them by.
    MANCHESTER_CREEPAGE: f64 = 0.02, kept;

    /// Creepage that need not be closer: a hundredth of one at which a wheel slides.
    MANCHESTER_CREEPAGE_FLOOR: f64 = 5e-5, kept;

    /// The same, spin, median and worst: on the flat contacts of the left wheel, 0.5 to 1.2
    /// degrees, the contact angle is 0.03 to 0.08 degrees off.
    MANCHESTER_SPIN: [f64; 2] = [0.02, 0.065], kept;

    /// The same, longitudinal creep force over the friction limit, median and worst: the simplified
    /// theory, and the place of a patch that straddles the rail's jump of curvature.
    MANCHESTER_FX: [f64; 2] = [0.003, 0.14], kept;

    /// The same, lateral: the simplified theory, and that place.
    MANCHESTER_FY: [f64; 2] = [0.001, 0.06], kept;

    /// The same, normal force at given vertical load: contact angle and creep force decide it.
    MANCHESTER_NORMAL_FORCE: [f64; 2] = [3e-4, 2.5e-3], kept;

    /// The same, greatest pressure: Piotrowski-Kik is 23 % off in the median of non-Hertzian
    /// patches, less on these.
    MANCHESTER_PRESSURE: [f64; 2] = [0.085, 0.29], kept;

    /// Longitudinal creep force of these contacts by strips with tables, with corrected FASTSIM and
    /// with marches, over the friction limit, median and worst: a tenth of the target for the mean,
    /// and the target for the worst of an element by default. Marches are further off on a patch of
    /// 16 mm with two lobes that is about to slide, where spin turns the slip from lobe to lobe.
    MANCHESTER_TABLES_FX: [f64; 2] = [0.001, 0.05], target [0.001, 0.04];

    /// The same, lateral: the same targets.
    MANCHESTER_TABLES_FY: [f64; 2] = [0.001, 0.04];

    /// Normal force of wheels of simple shapes on rollers against CONTACT: the target for loads.
    ROLLER_FORCE: f64 = 0.01;

    /// The same, greatest pressure: half of the target for the worst of planar problems.
    ROLLER_PRESSURE: f64 = 0.03;

    /// The same, contact angle [rad]: a degree's twentieth.
    ROLLER_ANGLE: f64 = 1e-3;

    /// Height of a wheel on a rail that varies along the track against CONTACT, median [m]: the
    /// target.
    VARYING_HEIGHT: f64 = 1e-6;

    /// The same, contact position [m]: the width of an element of the reference.
    VARYING_PLACE: f64 = 2e-4;

    /// The same, greatest pressure: corners of these rails step in curvature, patches are 1.5 mm
    /// wide on elements of 0.2 mm, and strips are to be 5 % off at 95 %.
    VARYING_PRESSURE: f64 = 0.05, target 0.03;

    /// The same, creep force over the friction limit: the target of 95 %, by the median; the 95 %
    /// themselves are in the scoreboard.
    VARYING_FORCE: f64 = 0.03;

    /// The same on rows that drift: particles pass CONTACT's contact along the track and not along
    /// the rows, by which boundary elements are 3.1 % from it; marches add their own 0.4 %.
    PASSED_ALONG_TRACK: f64 = 0.035, target 0.03;

    /// Change of the vertical force along a track that bends against that of the longitudinal one
    /// with the height: the target for loads.
    VARYING_ENERGY: f64 = 1e-2;

    /// Force and moment [m] of a wheel that turns beside its middle, of sections every 5 degrees,
    /// against the round wheel there, over the greatest force, median and worst: splines between
    /// sections and points leave a nanometre of heights, over depths of some 0.05 mm and down to 2
    /// µm.
    ECCENTRIC: [[f64; 2]; 2] = [[1e-5, 1e-3]; 2];

    /// The same by boundary elements, whose lattice counts from the marker, half a millimetre
    /// elsewhere: the target for loads.
    ECCENTRIC_ELEMENTS: [[f64; 2]; 2] = [[1e-2; 2]; 2];

    /// Force and moment over a metre of a wheel on sections that are all the same against those on
    /// one profile, over the force: the target.
    EQUAL_SECTIONS: f64 = 1e-9;

    /// The same under a given load, and heights [m]: each of both is found to 1e-9 of the load.
    EQUAL_SECTIONS_LOADED: f64 = 2e-9, target 1e-9;

    /// Forces and moments over half a metre on sections that drift or rise evenly against those on the
    /// even rail at an angle that they are, over the force: the target.
    EVENLY_DRIFTING: f64 = 1e-6;

    /// The same by one ellipse over 1100 poses: it has the curvature of one point, which jumps where arcs of a rail
    /// meet, and the two rails have these a little elsewhere.
    EVENLY_DRIFTING_ELLIPSES: f64 = 3e-5, target 1e-6;

    /// The same by boundary elements: their lattices count from other places on both.
    EVENLY_DRIFTING_ELEMENTS: f64 = 3e-4, target 1e-6;

    /// Forces and moments of a wheel of equal sections around on a rail that varies against those of
    /// the round wheel, worst, over the greatest force: splines go through rows of the one and
    /// through points of the other, and models of one ellipse see the curvature of a place.
    EQUAL_SECTIONS_AROUND: f64 = 1e-5, target 1e-6;

    /// A wheel that varies around on a rail of equal slices against that on one profile, worst, over
    /// the greatest force: rows are met within 1e-10 m of their place.
    EQUAL_SLICES: f64 = 1e-8, target 1e-9;

    /// The same by boundary elements, on slices or under sections that are all the same: their rows
    /// are found to a nanometre, over depths of some 0.05 mm.
    EQUAL_SLICES_ELEMENTS: f64 = 2e-5, target 1e-9;

    /// First touch of a wheel of rough sections against a scan of its surface, worst [m]: rows 3 mm
    /// apart are met at places whose heights change across by slopes of 2e-3, and an outline is
    /// straight from one to the other where the farthest place changes between them.
    ROUGH_TOUCH: f64 = 2e-6;

    /// Height of a wheel with waves by sections against the same as a wheel that is out of round
    /// [m]: a tenth of the target for heights.
    BRIDGED_HEIGHT: f64 = 1e-7;

    /// The same, greatest pressure: a third of the target for pressures.
    BRIDGED_PRESSURE: f64 = 0.01;

    /// Angle from the middle of the flat of the tests beyond which the edge of its hollow is flat
    /// enough for elements of 0.2 mm [rad]: nearer to the middle the pressure has a peak along it
    /// that grows with their number.
    FLAT_WITHOUT_EDGE: f64 = 0.08;

    /// Forces of two rails in one place, one of them placed by its gauge face: a root to 1e-15 m,
    /// over a penetration of 60 µm.
    SAME_PLACE: f64 = 1e-9;

    /// Change of the lateral force and of the yaw moment on a wheel that a check rail holds with 20
    /// kN, per microradian of yaw [N, N m]: half a chord of 60 mm at a contact stiffness of 1e9 N/m
    /// is 60 N, a point that moves 0.3 mm under 20 kN is 6 N m.
    CHECK_RAIL_STEP: [f64; 2] = [120.0, 20.0];

    /// Normal force of strips within 2 mrad of the middle of a flat of 50 mm against boundary
    /// elements: one ellipse stands for an even stretch between two corners, or for two patches.
    ON_FLAT: f64 = 0.08, target 0.05;

    /// The same elsewhere on either of them: the target for bodies that vary.
    BESIDE_FLAT: f64 = 0.03;

    /// Deviations of 1e-13 m against none: quadrature along strips, and an edge found to 1e-7 m.
    VANISHING_DEVIATIONS: f64 = 1e-6;

    /// Depth of contact of uneven bodies against a scan of their surfaces [m]: cubics between rows
    /// follow the section to that.
    UNEVEN_DEPTH: f64 = 1e-8;

    /// Crest and trough of a wave of 0.5 m against wheels of that curvature: the wave is no
    /// parabola over 15 mm.
    LONG_WAVE: f64 = 5e-3;

    /// Moment about the axle of a round wheel on a corrugated rail over its normal force [m]:
    /// rounding, and the parabola for the circle.
    FREE_TORQUE: f64 = 5e-6;

    /// Normal force with damping on uneven bodies against that of the rate of their depth, over the
    /// force: differences of the depth.
    CLOSING_RATE: f64 = 2e-3;

    /// Height of a wheel on a fresh flat against that on sharp corners: they are rounded over a
    /// tenth of its length [m].
    FLAT_HEIGHT: f64 = 1e-4;

    /// Jumps of the normal force over itself, rolling over corrugations and flats in steps of 12
    /// µm: a step is a thousandth of a patch.
    UNEVEN_JUMP: f64 = 1e-3;

    /// The same of the creep force: a step is a thousandth of a patch.
    UNEVEN_CREEP_JUMP: f64 = 1e-3;

    /// Waves from files of points, every 0.5 mm and half degree, against the waves themselves:
    /// splines between the points.
    DEVIATION_FILES: f64 = 1e-3;

    /// Axle moment against longitudinal force times rolling radius: the radius is that of one point
    /// of the patch.
    AXLE_MOMENT: f64 = 0.01;

    /// Two directions of running at 20 m/s with 25 mm/s of slip: creepages refer to mean speeds
    /// that differ by a thousandth.
    REFERENCE_SPEED: f64 = 2e-3;

    /// CONTACT's row of docs/frames.md, relative: a check of signs; the other rail (60E1 instead of
    /// the benchmark's) moves spin by some per cent.
    FRAMES_SHARE: f64 = 0.15;

    /// Worn volume against the sum of the law over the steps, and against the volume between the
    /// profiles: material is neither made nor lost.
    WORN_VOLUME: f64 = 1e-6;

    /// Change of the worn profile from an update interval of 0.03 s to one of 0.015 s, root mean
    /// square over the greatest depth, of a wheel that sways by 2.5 mm at 1.7 Hz and loses 0.1 mm
    /// in 0.6 s: laws of wear are known to far less than a hundredth.
    WEAR_UPDATE_INTERVAL: f64 = 0.01;

    /// The same from a step of 0.015 s to one of 7.5 ms: laws of wear are known to far less.
    WEAR_STEP: f64 = 0.01;

    /// Change of the normal force at an update over the greatest depth that went and the Hertzian
    /// stiffness of the patch: the height stays, so that at most that depth is missing.
    WEAR_FORCE_CHANGE: f64 = 1.0;
}
