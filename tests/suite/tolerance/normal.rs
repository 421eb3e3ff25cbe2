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

    /// Strips on one grid against Hertz, a/b 0.1 to 10, by their number: normal force and greatest
    /// pressure, relative. What a user of the result does not see in the force, and at worst twice
    /// that in the pressure.
    GRID_HERTZ: [(usize, [f64; 2]); 2] = [(20, [5e-3, 1e-2]), (40, [2e-3, 5e-3])];

    /// Twenty strips on one grid, as many as an element starts with, against CONTACT on all planar
    /// cases, of one region and of two; median and worst of normal force, greatest pressure and area
    /// [%]: what a user of the result does not see in the force, and the narrow lobe of a patch in the
    /// worst.
    GRID_PLANAR_20: [[f64; 2]; 3] = [[0.1, 0.8], [0.5, 6.0], [0.5, 2.5]];

    /// Forty strips on one grid against CONTACT on these cases, median and worst of normal force,
    /// greatest pressure and area [%]: the narrow lobe of a patch has few of them.
    GRID_PLANAR_40: [[f64; 2]; 3] = [[0.03, 0.3], [0.1, 3.0], [0.5, 1.5]],
        target [[0.03, 0.3], [0.1, 1.0], [0.3, 1.0]];

    /// Most Newton steps of strips on one grid in any planar case: a third of what the solver
    /// allows.
    GRID_STEPS: u64 = 14;

    /// Twenty strips of least energy for a parabola against CONTACT on all planar cases: median and
    /// worst of normal force, greatest pressure and area [%]. Narrow lobes and saddles have few nodes.
    LEAST_ENERGY_PLANAR: [[f64; 2]; 3] = [[0.05, 0.5], [0.5, 9.0], [1.2, 7.0]],
        target [[0.05, 0.5], [0.5, 7.0], [0.5, 4.0]];

    /// Bend of the load of strips on one grid over its rise, per step of 0.1 µm, where two overlaps
    /// join across a sharp valley: a jump would be of the order of one.
    GRID_BEND: f64 = 0.2;

    /// Strips under a wheel at given load against CONTACT, normal force, greatest pressure, area [-]
    /// and place along the profile [mm], median and worst: targets are those of planar problems. Up
    /// to contact angles of 60 degrees: steeper, N at a given load is decided by an angle that one
    /// plane does not have. Small patches are five elements of the reference wide; place is worst on
    /// two zones that the reference takes as one.
    ELEMENT_NORMAL_STRIPS: [[f64; 2]; 4] =
        [[1.2e-4, 0.02], [5e-3, 0.06], [0.012, 0.04], [0.14, 1.65]],
        target [[1.2e-4, 0.008], [5e-3, 0.06], [5e-3, 0.025], [0.14, 1.65]];

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
