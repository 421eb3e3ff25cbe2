//! Tolerances of the tangential models.

super::entry::tolerances! {
    /// Linear limit of FASTSIM against Kalker's coefficients at 20 elements: middle rule along the
    /// strips.
    FASTSIM_LINEAR: f64 = 5e-3;

    /// Linear theory against FASTSIM with friction 1e9 and 200 elements along: middle rule, 1/(2
    /// n²).
    LINEAR_LIMIT: f64 = 1e-4;

    /// Full sliding against friction times normal force: nobody knows friction to a hundredth.
    FULL_SLIDING: f64 = 1e-3;

    /// Direction of the creep force of a wheel that slides, share of the friction limit: spin turns
    /// it a little.
    SLIDING_DIRECTION: f64 = 0.02;

    /// Fits of Kalker's coefficients against the exact ones inside a/b 0.05 to 20, for c11, c22,
    /// c23: what polynomials of the logarithm leave.
    KALKER_FIT: [f64; 3] = [2.1e-3, 1.4e-3, 5.0e-3], kept;

    /// The same for a/b 0.03 to 0.05 and 20 to 33: the fits go over into asymptotes that are
    /// themselves a few per cent off.
    KALKER_ENDS: [f64; 3] = [2.2e-2, 1.6e-2, 2.1e-2], kept;

    /// FASTSIM (elliptic bound, blended flexibilities, 20x20) against CONTACT on 300 ellipses,
    /// force over the friction limit, mean and 95 %: the error of the simplified theory.
    FASTSIM_ELLIPSES: [f64; 2] = [0.022, 0.055], kept;

    /// FaStrip on these ellipses, 20x20, blended, mean, 95 % and worst: the error of the theory;
    /// CONTACT's own FaStrip on 22x22 has 0.017, 0.048, 0.067.
    FASTRIP_ELLIPSES: [f64; 3] = [0.0125, 0.04, 0.062], kept;

    /// Nodes of the table of creep forces, errors estimated from two grids, over the friction
    /// limit, mean and worst: less than half of the target of all sets.
    TABLE_NODES: [f64; 2] = [1.5e-3, 0.012];

    /// Full sliding with spin, interpolated between exact values, a/b 0.055 to 18, mean and worst,
    /// force over μ N and moment over μ N c: the worst are ellipses of a/b near 18 that turn about
    /// a point beside their longer axis.
    TABLE_SLIDING: [[f64; 2]; 2] = [[5e-4, 6e-3], [5e-4, 1.6e-2]], kept;

    /// Derivatives of the table against central differences over 1e-6 of the creepage: the third
    /// derivative times the square of the step.
    TABLE_SLOPES: f64 = 1e-7;

    /// The table against boundary elements of 12 and 18 across between its nodes, over the friction
    /// limit, mean and worst: the error of the coarse grids.
    TABLE_BETWEEN: [f64; 2] = [2e-3, 1e-2];

    /// The same for ν = 0 and 0.5: the linear coefficients alone know of it.
    TABLE_POISSON: [f64; 2] = [1e-2, 6e-2], kept;

    /// The table against CONTACT on 300 ellipses, over the friction limit, mean, 95 %, worst: the
    /// reference itself is uncertain by 0.003 in the mean, 0.014 at worst.
    TABLE_ELLIPSES: [f64; 3] = [0.0032, 0.0065, 0.03];

    /// Strips with tables against CONTACT on 656 states of 8 real patches, force over the friction
    /// limit, mean, 95 %, worst: an ellipse stands for each patch.
    TABLE_PROFILES: [f64; 3] = [0.010, 0.030, 0.055];

    /// The same, mean of the spin moment over the limit times c: an ellipse stands for each patch.
    TABLE_PROFILES_MOMENT: f64 = 0.008;

    /// Strips with corrected FASTSIM against CONTACT on 656 states of 8 real patches, force over
    /// the friction limit, mean, 95 %, worst: to be no worse than tables; the target is that of an
    /// element by default.
    CORRECTED_PROFILES: [f64; 3] = [0.010, 0.030, 0.055], target [0.007, 0.022, 0.04];

    /// The same, spin moment: to be no worse than tables.
    CORRECTED_PROFILES_MOMENT: f64 = 0.008;

    /// Marches against boundary elements on 656 states of 8 real patches, force over the friction
    /// limit, mean, 95 %, worst: the target of all sets.
    MARCHES_DENSE: [f64; 3] = [0.0045, 0.012, 0.04];

    /// The same on 192 states of other patches: fifteen strips are few for lobes of unlike width.
    MARCHES_HELD_OUT: [f64; 3] = [0.0045, 0.013, 0.04], target [0.0045, 0.012, 0.04];

    /// Marches on these states, mean of the spin moment over the limit times c: the target.
    MARCHES_MOMENT: f64 = 0.005;

    /// Marches against CONTACT on 300 ellipses, force over the friction limit, mean, 95 %, worst:
    /// the target of all sets.
    MARCHES_ELLIPSES: [f64; 3] = [0.0045, 0.012, 0.04];

    /// Marches against Kalker's linear theory for a/b from 0.1 to 10, c11, c22, c23 and c33 at 95 %:
    /// the table of differences is a mean over places of the edge between nodes, and c33 goes with
    /// the fourth power of lengths.
    MARCHES_KALKER: [f64; 4] = [0.01, 0.01, 0.01, 0.02], target 0.01;

    /// Marches against boundary elements on 2 mm ridges beside each other, small creepages, over the
    /// greater force: each ridge has few strips, and feels others as if each were one.
    MARCHES_RIDGES: f64 = 0.2, target 0.1;

    /// Marches against boundary elements on a rail with grooves of 3 mm, all zones together, over the
    /// friction limit: zones share fifteen strips, few each.
    MARCHES_MILLED_RAIL: f64 = 0.05, target 0.02;

    /// Third differences of the creep force along a depth at which lobes grow together, in 6000
    /// steps, over the friction limit: the target of jumps.
    MARCHES_STEPS: f64 = 1e-3;

    /// Marches against boundary elements on the same pressure, over the positions of a wheel on its
    /// rail, force over the friction limit, mean, 95 %, worst: the target of all sets.
    MARCHES_POSITIONS: [f64; 3] = [0.0045, 0.012, 0.04];

    /// The same, spin moment over the limit times c, mean, and frictional power over itself at 95 %:
    /// a fifth of the states are of one position with two lobes of unlike width, where fifteen strips
    /// are too long and spin has too much power.
    MARCHES_POSITIONS_OTHERS: [f64; 2] = [0.005, 0.025], target [0.005, 0.015];

    /// Marches against boundary elements all over three pairs of profiles, force over the friction
    /// limit, mean, 95 %, worst: slivers on the flange wall, 24 times as long as wide and with spin,
    /// are 1 to 3 % off, and patches that carry a twentieth of the load more.
    MARCHES_ALL_POSITIONS: [f64; 3] = [0.0045, 0.015, 0.25], target [0.0045, 0.012, 0.04];

    /// Wear across a patch by the dissipation of marches against that of boundary elements, absolute
    /// differences over the whole, at 95 %: ten strips, one to two millimetres wide, blur it.
    MARCHES_WEAR_ACROSS: f64 = 0.07, target 0.06;

    /// Forces and moments of a cone with flat and with curved creepage, over the force: the same
    /// sums in another order.
    CONE_FLAT_AND_CURVED: f64 = 1e-9;

    /// Frictional power against the power of the tractions on both bodies, over force times speed:
    /// sums in another order.
    POWER_BALANCE: f64 = 1e-12;

    /// Power that tractions feed into the bodies, over what friction could turn into heat: friction
    /// feeds none.
    POWER_FED: f64 = 0.0;
}
