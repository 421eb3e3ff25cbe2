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

/// The columns of the result.
pub const COLUMNS: [&str; 30] = [
    "normal_force_n",
    "reference_normal_force_n",
    "normal_force_error_percent",
    "max_pressure_mpa",
    "reference_max_pressure_mpa",
    "max_pressure_error_percent",
    "area_mm2",
    "reference_area_mm2",
    "area_error_percent",
    "fx_n",
    "fy_n",
    "fz_n",
    "reference_fx_n",
    "reference_fy_n",
    "reference_fz_n",
    "creep_force_error_percent",
    "spin_moment_error_percent",
    "patches",
    "reference_patches",
    "fallback",
    "reference_fallback",
    "time_us",
    "reference_time_us",
    "reference_normal_force_uncertainty_percent",
    "reference_max_pressure_uncertainty_percent",
    "reference_area_uncertainty_percent",
    "reference_creep_force_uncertainty_percent",
    "reference_normals_turn_deg",
    "reference_normal_residual",
    "reference_tangential_residual",
];

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

    /// The cells of the result, in the order of [`COLUMNS`].
    pub fn cells(&self) -> [String; COLUMNS.len()] {
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
            number(own.normal_force),
            number(reference.normal_force),
            n,
            number(1e-6 * own.max_pressure),
            number(1e-6 * reference.max_pressure),
            p,
            number(1e6 * own.area),
            number(1e6 * reference.area),
            a,
            fx,
            fy,
            fz,
            rx,
            ry,
            rz,
            f,
            m,
            own.patches.to_string(),
            reference.patches.to_string(),
            u8::from(own.fallback).to_string(),
            u8::from(reference.fallback).to_string(),
            format!("{:.2}", 1e6 * own.time),
            format!("{:.2}", 1e6 * reference.time),
            un,
            up,
            ua,
            uf,
            turn,
            gap,
            slip,
        ]
    }
}
