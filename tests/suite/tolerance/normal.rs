//! Tolerances of the normal models.

super::entry::tolerances! {
    /// Hertz model against the closed form: the model is the closed form, its quadrature is not.
    HERTZ: f64 = 1e-6;

    /// Piotrowski-Kik on a sphere against its closed form sqrt(2 ε) Hertz: quadrature across the
    /// zone, polynomials of the elliptic integrals.
    PIOTROWSKI_KIK_SPHERE: f64 = 1e-4;

    /// Piotrowski-Kik on an ellipse of a/b = 5 against Hertz at the same approach: the published
    /// differences are given to a tenth of a per cent.
    PIOTROWSKI_KIK_SLENDER: f64 = 1e-3;

    /// Normal problem in table 1 of Piotrowski and Kik: printed to three or four digits.
    PAPER_TABLE_1: f64 = 5e-3;

    /// Ratio of length to width of the corrected area of a Hertzian pair: the width is that of a
    /// quadrature.
    CORRECTED_RATIO: f64 = 1e-3;

    /// Greatest pressure of the corrected area against Hertz at the same approach, a/b 0.1 to 10:
    /// the correction halves the error, which is 0.195 without.
    CORRECTED_PRESSURE: f64 = 0.105, kept;

    /// Normal force of the same: what the correction pays with, 0.049 without.
    CORRECTED_FORCE: f64 = 0.116, kept;

    /// Strips against CONTACT on all planar cases, of one region and of two, by their number for a
    /// parabola: median and worst of normal force, greatest pressure and area [%]: what a user of the
    /// result does not see in the force, and a narrow lobe with few nodes in the worst.
    PLANAR_15: [[f64; 2]; 3] = [[0.05, 0.5], [0.5, 7.0], [0.5, 4.0]];

    /// The same with forty: errors of interpolation fall to a quarter, those of the pressure by less.
    PLANAR_40: [[f64; 2]; 3] = [[0.02, 0.1], [0.5, 3.0], [0.5, 2.0]],
        target [[0.02, 0.1], [0.1, 3.0], [0.5, 2.0]];

    /// Strips against boundary elements where a wheel stands on five narrow ridges of a ground rail,
    /// vertical force at one height [-]: what is asked of kinked outlines.
    KINKED_FORCE: f64 = 0.015;

    /// Fall of the force of strips on that rail as the wheel comes down by a quarter of a micrometre,
    /// over the force [-]: nodes move over the kinks; the force of forty does not fall.
    KINKED_FALL: f64 = 1e-3, target 0.0;

    /// Stiffness of forty strips on that ground rail, over each quarter of a micrometre, over that of
    /// boundary elements [-]: nodes move over the kinks as the wheel comes down.
    KINKED_SLOPE: f64 = 0.25, target 0.1;

    /// Most Newton steps of strips in any planar case: a third of what the solver allows.
    PLANAR_STEPS: u64 = 14;

    /// Bend of the load of strips over its rise, per step of 0.1 µm, where two overlaps join across a
    /// sharp valley: a jump would be of the order of one.
    JOINING_BEND: f64 = 0.2;

    /// Strips under a wheel at given load against CONTACT, normal force, greatest pressure, area [-]
    /// and place along the profile [mm], median and worst: targets are those of planar problems. Up
    /// to contact angles of 60 degrees: steeper, N at a given load is decided by an angle that one
    /// plane does not have. Small patches are five elements of the reference wide; its areas are
    /// counts of elements, from which boundary elements differ by 1.0 % in the median, and strips
    /// by 0.5 % from these. Place is worst on two zones that the reference takes as one.
    ELEMENT_NORMAL_STRIPS: [[f64; 2]; 4] =
        [[1.2e-4, 0.02], [5e-3, 0.07], [0.015, 0.04], [0.14, 1.65]],
        target [[1.2e-4, 0.008], [5e-3, 0.07], [5e-3, 0.04], [0.14, 1.65]];

    /// The same of piotrowski_kik, piotrowski_kik_corrected and hertz: the errors of these models.
    ELEMENT_NORMAL_OTHERS: [[[f64; 2]; 4]; 3] = [
        [[7e-4, 0.165], [0.19, 0.60], [0.10, 0.55], [0.12, 1.85]],
        [[7e-4, 0.165], [0.16, 0.60], [0.10, 0.37], [0.13, 2.0]],
        [[7e-4, 0.165], [0.02, 0.50], [0.05, 0.51], [0.3, 5.0]],
    ], kept;

    /// Most Newton steps of the strips wherever a wheel may stand: what bounds the time of an
    /// evaluation, half of what the solver allows.
    STRIP_STEPS: u64 = 20;

    /// Distance or overlap left at the nodes of strips before the last Newton step, over the
    /// greatest overlap: that step changes loads by a millionth of the greatest, displacements by
    /// some times that.
    STRIPS_GAP: f64 = 1e-5;

    /// Share of a patch's area in strips that carry next to nothing: one of some twenty, and short.
    UNLOADED_SHARE: f64 = 5e-3;

    /// Share of the evaluations of a wheel on a hard profile, 0.1 µm to 0.1 mm deep, in which
    /// strips fall back: noise of 20 µm that is left unsmoothed is no profile that anybody runs on.
    HARD_FALLBACKS: f64 = 0.01, target 0.0;

    /// The default 12 strips and 20 elements against 120 of both, Piotrowski-Kik and FASTSIM, 500
    /// random poses: normal force, area, greatest pressure and force on the wheel, 95 % and worst.
    /// The models themselves are off by 3, 20, 20 and 4 %.
    DEFAULT_COUNTS: [[f64; 2]; 4] = [[5e-4, 4e-3], [6e-4, 3e-3], [5e-4, 5e-3], [4e-3, 6e-3]];
}
