//! Tolerances of the stresses below the surface.

super::entry::tolerances! {
    /// Stresses and displacements below a square against CONTACT, over the greatest: the six digits
    /// of the reference.
    SUBSURFACE_SQUARE: f64 = 1e-5;

    /// A rectangle in parts against the whole, over the pressure: rounding of the places of corners,
    /// over the depth at which the surface is taken.
    SUBSURFACE_PARTS: f64 = 1e-6;

    /// Stresses with blunt edges, 20x20 elements, over the greatest pressure, on an edge against the
    /// mean of the centres beside it, and two elements deep against sharp edges: the target for
    /// strips, and a tenth of that of elements.
    SUBSURFACE_BLUNT: [f64; 2] = [0.02, 5e-4];

    /// Stresses of mirrored loads, over the pressure: rounding.
    SUBSURFACE_MIRROR: f64 = 1e-12;

    /// Greatest equivalent and shear stresses of lines, circles and ellipses on 40 elements against
    /// closed forms, value and place: the target.
    SUBSURFACE_HERTZ: [f64; 2] = [0.005, 0.005];

    /// Stresses in the middle of the surface of a circle, 40x40 elements: the target for maxima.
    SUBSURFACE_MIDDLE: f64 = 0.005;

    /// Tension beside the edge of a circle, a fiftieth of its radius outside, 40x40 elements: squares
    /// of half that size make its edge.
    SUBSURFACE_EDGE: f64 = 0.05;

    /// Stresses along the axis of ellipses against closed forms, over the pressure, 40x40 elements:
    /// the target for maxima.
    SUBSURFACE_AXIS: f64 = 0.005;

    /// Least observed order of the greatest equivalent stress in the size of an element: two, but for
    /// the edge of the patch in squares.
    SUBSURFACE_ORDER: f64 = 1.5;

    /// Divergence of the stresses times a length of one, and stresses by Hooke's law, by differences,
    /// over the pressure: those of fourth order over a hundredth of the
    /// depth.
    SUBSURFACE_BALANCE: f64 = 1e-5;

    /// Force on a plane against the load: 400 by 400 points, the rest of the plane beyond 900.
    SUBSURFACE_PLANE: f64 = 0.003;

    /// Stresses and displacements far away against those of a point force: the size of the load over
    /// the distance.
    SUBSURFACE_FAR: f64 = 0.05;

    /// Greatest equivalent stresses of 20 strips on 20x20 elements against Hertz, value and depth:
    /// the target.
    SUBSURFACE_STRIPS: f64 = 0.02;

    /// Greatest equivalent stress of other normal models under the same load against boundary
    /// elements on a contact of Hertz: shape of the patch by Piotrowski and Kik.
    SUBSURFACE_MODELS: f64 = 0.1, kept;

    /// Stresses of sliding patches against those of friction times Hertz's pressure, over the
    /// greatest pressure: the target for strips.
    SUBSURFACE_TRACTIONS: f64 = 0.02;

    /// Limits of yield and shakedown of lines against closed forms, 40 elements: the target.
    FATIGUE_LIMIT: f64 = 0.005;

    /// Limits of lines and circles against figures of text books: these are known to two digits.
    FATIGUE_KNOWN: f64 = 0.02;

    /// Equivalent stress of Dang Van against the estimate of Ekberg, Kabo and Andersson, over it:
    /// theirs is one formula for all ellipses.
    FATIGUE_ESTIMATE: f64 = 0.1;
}
