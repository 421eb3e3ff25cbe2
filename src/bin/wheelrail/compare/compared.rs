//! A case by its own models and by boundary elements, and the errors between them.

/// What one solution of a case gives.
#[derive(Clone, Copy, Debug, Default)]
pub struct Solved {
    /// Normal force of all patches [N].
    pub normal_force: f64,
    /// Greatest pressure [Pa].
    pub max_pressure: f64,
    /// Area of all patches [m²].
    pub area: f64,
    /// Creep force of all patches; in planar cases z is 0 [N].
    pub creep_force: [f64; 3],
    /// Moment of the tractions about the normal through the origin or the centroid of load [N m].
    pub spin_moment: f64,
    /// Number of patches.
    pub patches: usize,
    /// Whether a solver fell back to a simpler model.
    pub fallback: bool,
    /// Time it took [s].
    pub time: f64,
}

/// A case by both kinds of models.
#[derive(Clone, Copy, Debug)]
pub struct Compared {
    /// By the models of the row.
    pub own: Solved,
    /// By boundary elements.
    pub reference: Solved,
    /// By boundary elements, half as many along and across.
    pub coarse: Solved,
    /// Angle between the outermost normals of one rail's contact in the reference, where it tells
    /// [rad].
    pub turn: Option<f64>,
    /// What the equations of the reference are left with, where it tells: distance over overlap,
    /// slip over rigid slip.
    pub residuals: Option<[f64; 2]>,
    /// Coefficient of friction.
    pub friction: f64,
}

impl Compared {
    /// Errors of normal force, pressure, area, creep force and spin moment [%]; nothing where the
    /// reference has none to refer to.
    pub fn errors(&self) -> [Option<f64>; 5] {
        self.differences(&self.own)
    }

    /// By how much the reference with half as many elements differs, as an estimate of the
    /// reference's own errors [%].
    pub fn uncertainties(&self) -> [Option<f64>; 5] {
        self.differences(&self.coarse).map(|error| error.map(f64::abs))
    }

    fn differences(&self, own: &Solved) -> [Option<f64>; 5] {
        let Self { reference, friction, .. } = self;
        let relative = |own: f64, exact: f64| (exact > 0.0).then(|| 100.0 * (own / exact - 1.0));
        let limit = friction * reference.normal_force;
        let missed = (0..3)
            .map(|c| (own.creep_force[c] - reference.creep_force[c]).powi(2))
            .sum::<f64>()
            .sqrt();
        let arm = (reference.area / std::f64::consts::PI).sqrt();
        let turned = own.spin_moment - reference.spin_moment;
        [
            relative(own.normal_force, reference.normal_force),
            relative(own.max_pressure, reference.max_pressure),
            relative(own.area, reference.area),
            (limit > 0.0).then(|| 100.0 * missed / limit),
            (limit * arm > 0.0).then(|| 100.0 * turned / (limit * arm)),
        ]
    }

    /// The cells of the result with the names of their columns.
    pub fn cells(&self) -> [(&'static str, String); 30] {
        let number = |value: f64| format!("{value:?}");
        let error = |value: Option<f64>| value.map_or_else(String::new, |v| format!("{v:.4}"));
        let [n, p, a, f, m] = self.errors().map(error);
        let (own, reference) = (&self.own, &self.reference);
        let [fx, fy, fz] = own.creep_force.map(number);
        let [rx, ry, rz] = reference.creep_force.map(number);
        let [un, up, ua, uf, _] = self.uncertainties().map(error);
        let turn = self.turn.map_or_else(String::new, |turn| format!("{:.3}", turn.to_degrees()));
        let [gap, slip] = self.residuals.map_or([const { String::new() }; 2], |residuals| {
            residuals.map(|residual| format!("{residual:.1e}"))
        });
        [
            ("normal_force_n", number(own.normal_force)),
            ("reference_normal_force_n", number(reference.normal_force)),
            ("normal_force_error_percent", n),
            ("max_pressure_mpa", number(1e-6 * own.max_pressure)),
            ("reference_max_pressure_mpa", number(1e-6 * reference.max_pressure)),
            ("max_pressure_error_percent", p),
            ("area_mm2", number(1e6 * own.area)),
            ("reference_area_mm2", number(1e6 * reference.area)),
            ("area_error_percent", a),
            ("fx_n", fx),
            ("fy_n", fy),
            ("fz_n", fz),
            ("reference_fx_n", rx),
            ("reference_fy_n", ry),
            ("reference_fz_n", rz),
            ("creep_force_error_percent", f),
            ("spin_moment_error_percent", m),
            ("patches", own.patches.to_string()),
            ("reference_patches", reference.patches.to_string()),
            ("fallback", u8::from(own.fallback).to_string()),
            ("reference_fallback", u8::from(reference.fallback).to_string()),
            ("time_us", format!("{:.2}", 1e6 * own.time)),
            ("reference_time_us", format!("{:.2}", 1e6 * reference.time)),
            ("reference_normal_force_uncertainty_percent", un),
            ("reference_max_pressure_uncertainty_percent", up),
            ("reference_area_uncertainty_percent", ua),
            ("reference_creep_force_uncertainty_percent", uf),
            ("reference_normals_turn_deg", turn),
            ("reference_normal_residual", gap),
            ("reference_tangential_residual", slip),
        ]
    }
}
