//! Tolerances of the boundary elements.

super::entry::tolerances! {
    /// Boundary elements 60x60 against Hertz, load, greatest pressure, area: a third of the target
    /// of 0.3 % against CONTACT; the area is that of whole elements.
    BOUNDARY_HERTZ: [f64; 3] = [1e-3, 1e-3, 0.01];

    /// Boundary elements 60x60 against CONTACT on its finest grids, worst of one-region profiles,
    /// load, greatest pressure, area: one pressure has its peak at the rail's jump of curvature,
    /// narrower than an element.
    BOUNDARY_NORMAL_ONE_REGION: [f64; 3] = [0.003, 0.0035, 0.012], target [0.003, 0.003, 0.012];

    /// The same with two regions on one plane: the smaller region has few of the elements.
    BOUNDARY_NORMAL_TWO_REGIONS: [f64; 3] = [0.015, 0.015, 0.015];

    /// Boundary elements 22x22 and finer against extrapolated results of CONTACT on 300 ellipses,
    /// share of the friction limit, mean and worst: the reference is known to 0.003 in the mean.
    BOUNDARY_ELLIPSES: [f64; 2] = [0.003, 0.01];

    /// Boundary elements 40x40 against CONTACT with 40 elements across on real profiles, share of
    /// the friction limit, mean and worst: the target in the mean; the reference is known to 0.002
    /// in the mean, 0.011 at worst.
    BOUNDARY_PROFILES: [f64; 2] = [0.005, 0.016];

    /// The same against 80 elements across: without the error of the coarser reference.
    BOUNDARY_PROFILES_FINE: [f64; 2] = [0.002, 0.008];

    /// 24x24 against 80 across: fewer elements, for debug builds.
    BOUNDARY_PROFILES_COARSE: [f64; 2] = [0.006, 0.015];

    /// Kalker's coefficients by full adhesion, extrapolated from two grids: the outline of an
    /// ellipse in squares is not smooth.
    BOUNDARY_KALKER: f64 = 0.01;

    /// Carter's force at 128 elements along, share of the friction limit: of first order in the
    /// length of an element.
    BOUNDARY_CARTER: f64 = 0.002;

    /// Least observed order of Carter's force: one, but for the edge of adhesion that passes from
    /// element to element.
    BOUNDARY_CARTER_ORDER: f64 = 0.8;

    /// Cattaneo's force at 32x32 elements, share of the friction limit: of first order in the size
    /// of an element.
    BOUNDARY_CATTANEO: f64 = 0.003;

    /// Least observed order of Cattaneo's force: one, but for the edge of adhesion that passes from
    /// element to element.
    BOUNDARY_CATTANEO_ORDER: f64 = 0.8;

    /// Boundary elements on the pressure of Hertz spread over a grid against those on their own
    /// pressure, share of the friction limit: half an element at the edge.
    BOUNDARY_SPREAD: f64 = 0.01;

    /// Load of a tread patch by Piotrowski-Kik against 14x14 boundary elements at the same height:
    /// the error of virtual penetration.
    BOUNDARY_ELEMENT_LOAD: f64 = 0.1, kept;

    /// Creep force of the same, share of the friction limit, twice that for FASTSIM: the error of
    /// the simplified theory.
    BOUNDARY_ELEMENT_CREEP: f64 = 0.05, kept;

    /// Running backwards with boundary elements: the contact search passes through other roundings,
    /// and sweeps end within 1e-4 of the tractions.
    BOUNDARY_BACKWARDS: f64 = 1e-3;

    /// Boundary elements on curved contacts against the conformal mode of CONTACT, median, 95 % and
    /// worst, greatest pressure and force in the contact's plane over the friction limit: a sharp
    /// contact of CONTACT has five elements across, where its own pressure is 1.6 % off. Its
    /// normals are means over places at equal arcs of wheel and rail, half a degree off on sharp
    /// flanks, where its own force is no derivative of an energy (4 %).
    BOUNDARY_CONFORMAL: [[f64; 3]; 2] =
        [[0.005, 0.02, 0.04], [0.003, 0.04, 0.04]],
        target [[0.005, 0.02, 0.04], [0.003, 0.015, 0.04]];

    /// Distance left in the contact over the overlap: a hundredth of what grids leave.
    BOUNDARY_GAP: f64 = 1e-5;

    /// Slip that contradicts friction over the largest rigid slip: a hundredth of what grids leave.
    BOUNDARY_SLIP: f64 = 0.01;

    /// Asymmetry of the stiffness, and work of a closed loop over the stored energy, without
    /// friction: an element more or less in the patch.
    BOUNDARY_CONSERVATIVE: f64 = 1e-3;

    /// Two contacts of one rail by boundary elements and by strips: the target for loads.
    BOUNDARY_TWO_ZONES: f64 = 0.01;

    /// Forces of bodies whose moduli differ by a millionth against those of like ones, over the limit:
    /// another grid, and sweeps that end earlier.
    UNLIKE_NEARLY: f64 = 2e-3;

    /// Forces on a wheel of unlike materials against those of the planar problem of its contact, over
    /// the limit, beyond what the two differ by with like ones: sizes of elements differ, in which such
    /// forces are of first order.
    UNLIKE_FRAMES: f64 = 5e-3;

    /// Distance left in the contact of a wheel of unlike materials over the overlap: the last of the
    /// turns.
    BOUNDARY_UNLIKE_GAP: f64 = 1e-5;

    /// Power that such a wheel gives less that which friction loses, over friction limit times speed, at
    /// 24 elements: of first order in their size.
    UNLIKE_POWER: f64 = 1e-4;
}
