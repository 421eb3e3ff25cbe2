//! Tolerances of profiles, contact lines, the contact search and conicity.

super::entry::tolerances! {
    /// Deepest penetration of the contact search against a scan at steps of 20 µm [m]: a thousandth
    /// of what a wheel load has.
    DEEPEST_PENETRATION: f64 = 1e-7;

    /// Penetration that no search may miss [m]: it carries some newtons.
    MISSED_PENETRATION: f64 = 1e-7;

    /// Height of the contact line against the lowest of all rolling circles [m]: chords of 20 µm on
    /// radii of 12 mm.
    OUTLINE_HEIGHT: f64 = 2e-8;

    /// Place along x of the contact line against that of the lowest of all rolling circles [m]: the
    /// lowest is flat there.
    OUTLINE_AHEAD: f64 = 1e-6;

    /// Derivatives of curves with radii of millimetres against central differences over 1 µm: the
    /// third derivative times the square of the step.
    DERIVATIVE: f64 = 1e-5;

    /// Place of a flange contact along x against r tan(contact angle) sin(yaw): the formula is of
    /// first order in the angles.
    FLANGE_AHEAD: f64 = 0.01;

    /// Contact angle of a cone [rad]: minima are pinned down to 1e-9 m.
    CONE_ANGLE: f64 = 1e-6;

    /// Place of the contact of a cone on an arc [m]: minima are pinned down to 1e-9 m, arcs are
    /// cubic pieces.
    CONE_PLACE: f64 = 1e-6;

    /// Height of first touch of bodies of known size [m]: bisection to rounding, arcs are cubic
    /// pieces.
    TOUCHING_HEIGHT: f64 = 1e-9;

    /// Place of a contact on bodies of known size [m]: it is the error of the arm of a moment.
    CONTACT_PLACE: f64 = 1e-6;

    /// Place along x of the rim of a flange back against the innermost points of the turned wheel
    /// [m]: the rim is flat there.
    RIM_AHEAD: f64 = 1e-3;

    /// The same across, at yaw of 2 mrad and more [m]: up to 12 µm inside at 0.2 mrad, where the
    /// line changes smoothly from one end of the chord to the other.
    RIM_LATERAL: f64 = 2e-6;

    /// Depth of wheels at 3 and 6 degrees against brute force [m]: both are minima to rounding.
    YAWED_DEPTH: f64 = 1e-12;

    /// Place along x of the load's centroid of these wheels against the deepest point [m]: a patch
    /// is lopsided by a hundredth of its length.
    YAWED_PLACE: f64 = 1e-4;

    /// Load of strips on the flange of wheels yawed by up to 0.07 rad against boundary elements: the
    /// target for the worst greatest pressure, as loads have none there.
    YAWED_FLANGE: f64 = 0.05;

    /// Curvature along the rail of a yawed wheel against that of its surface: brute force by
    /// differences.
    SECTION_CURVATURE: f64 = 4e-3;

    /// A profile that was written and read back, distance from itself [m]: a spline through points
    /// 0.1 mm apart at the jumps of curvature.
    PROFILE_READ_BACK: f64 = 1e-7;

    /// Greatest pressure on profiles read from exact points over that on the profiles themselves
    /// [%]: the target for the worst case of the strip model, 6 %, is not to be spent on reading.
    EXACT_POINTS_PRESSURE: f64 = 2.0;

    /// Rolling radius differences of cones and arcs against closed forms [m]: contact points are
    /// looked at 0.1 nm deep.
    ROLLING_RADIUS: f64 = 1e-8;

    /// Conicity of a cone at 3 mm: rolling radii to 10 nm.
    CONE_CONICITY: f64 = 1e-5;

    /// Conicity of arcs at 3 mm against the formula for small amplitudes: the square of the
    /// amplitude over the radii.
    ARC_CONICITY: f64 = 0.01;

    /// Equivalent conicity of the reference cases of EN 15302, share of that standard's tolerance:
    /// the third digit of the expected figures, of which E5 (920 and 918 mm) misses the last by an
    /// eighth of the tolerance.
    EN_15302: f64 = 0.13;
}
