//! Planar contact problems: a separation of profiles and a wheel radius instead of a placed wheel and rail.
//!
//! The undeformed distance is f(y) + x²/(2R). Forces are those on the wheel, creepages those of the wheel against
//! the rail at the origin of the separation: w_x = ξ - φ y, w_y = η + φ x.

use crate::error::ContactError;
use crate::geometry::curve::{Curve, Knot};
use crate::geometry::separation::{Probe, Separation, SeparationPoint};
use crate::kinematics::creepage::bounded;
use crate::material::{Material, MaterialPair};
use crate::math::quadrature::GaussLegendre;
use crate::math::root::bracketed;
use crate::math::spline::{SplineEnd, interpolating_slopes};
use crate::normal::strips::{LEAST_STRIPS, StripSolver, solve_in_frame};
use crate::normal::{self, NormalModel, NormalProblem, ShapeFit, Strips};
use crate::tangential::fastsim::TractionBound;
use crate::tangential::field::ContactField;
use crate::tangential::friction_law::FrictionLaw;
use crate::tangential::{Creepage, Flexibilities, RollingState, Tangential, TangentialModel};

/// How deep the bodies are pressed together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Indentation {
    /// Given approach δ from f = 0 [m].
    Approach(f64),
    /// Given normal force, ≥ 0 [N].
    Load(f64),
}

/// A planar contact problem.
#[derive(Clone, Copy, Debug)]
pub struct PlanarCase<'a> {
    /// Points (y, f) of the separation, at least four, y growing, within 1 km [m].
    pub separation: &'a [[f64; 2]],
    /// Radius R of the wheel's normal section along x, 1e-4 to 1e6 [m].
    pub radius: f64,
    /// Approach or load.
    pub indentation: Indentation,
    /// Longitudinal, lateral [-] and spin [1/m] creepage at the origin of the separation; beyond 1e6 they count as 1e6.
    pub creepage: [f64; 3],
    /// Coefficient of friction, ≥ 0 [-].
    pub friction: f64,
    /// Material of the wheel.
    pub wheel_material: Material,
    /// Material of the rail.
    pub rail_material: Material,
    /// Normal contact model.
    pub normal_model: NormalModel,
    /// Virtual over true penetration, 0 to 1 [-].
    pub virtual_penetration: f64,
    /// Ratio of length to width that a corrected contact area gets.
    pub shape_fit: ShapeFit,
    /// Tangential contact model.
    pub tangential_model: TangentialModel,
    /// Strips across each zone.
    pub strips: usize,
    /// Elements along each strip.
    pub elements_along: usize,
    /// Boundary elements along and across the contact.
    pub elements: [usize; 2],
    /// Shape of the traction bound.
    pub bound: TractionBound,
    /// How the flexibilities enter.
    pub flexibilities: Flexibilities,
    /// How friction falls with sliding, and the initial slope on contaminated rails.
    pub friction_law: FrictionLaw,
    /// Rolling speed, ≥ 0: of falling friction alone [m/s].
    pub speed: f64,
}

/// Solution of a planar contact problem; forces on the wheel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlanarResult {
    /// Normal force [N].
    pub normal_force: f64,
    /// Greatest pressure [Pa].
    pub max_pressure: f64,
    /// Area of all zones [m²].
    pub area: f64,
    /// Greatest length of a zone along x [m].
    pub length: f64,
    /// Distance from the leftmost to the rightmost edge [m].
    pub width: f64,
    /// Longitudinal creep force [N].
    pub fx: f64,
    /// Lateral creep force [N].
    pub fy: f64,
    /// Moment about the normal through the origin of the separation [N m].
    pub mz: f64,
    /// Number of separate zones.
    pub patches: usize,
    /// Whether a solver fell back to a simpler model.
    pub fallback: bool,
}

/// Approaches beyond this are no contact of wheel and rail [m].
const MOST_APPROACH: f64 = 0.02;

/// Points of a separation beyond this are none of wheel and rail [m].
const MOST_DISTANCE: f64 = 1e3;
/// Least and greatest radius of a wheel's section [m].
const RADII: (f64, f64) = (1e-4, 1e6);
/// Least and greatest Young's modulus [Pa].
const MODULI: (f64, f64) = (1e3, 1e18);

/// Most zones of one problem.
const MOST_ZONES: usize = 64;

/// Solves a planar contact problem.
///
/// # Errors
/// A value of the case that is not admitted, or a load that no approach up to 20 mm carries.
pub fn solve(case: &PlanarCase) -> Result<PlanarResult, ContactError> {
    let pressed = press_together(case)?;
    let mut result = summarise(case, &pressed.material, &pressed.strips, pressed.contact_y);
    result.fallback |= pressed.left_out > 0;
    Ok(result)
}

/// Pressure and tractions element by element on the wheel, one field for each zone, or for all of them where the normal model has boundary
/// elements; y from the origin of the separation. See [`ContactField`].
///
/// # Errors
/// As [`solve`].
pub fn fields(case: &PlanarCase) -> Result<Vec<ContactField>, ContactError> {
    let Pressed { strips, material, contact_y, .. } = press_together(case)?;
    let tangential = tangential_of(case);
    let zones = if strips.elements.is_some() { 1 } else { strips.zones.len() };
    let fields = strips.zones.iter().take(zones).map(|zone| {
        let state = rolling_state(case, contact_y + zone.y);
        let mut field = tangential.field(zone, &strips, &material, &state);
        field.grid.left_y += contact_y;
        field
    });
    Ok(fields.collect())
}

/// The normal solution of a case.
struct Pressed {
    strips: Strips,
    material: MaterialPair,
    /// y of the contact point [m].
    contact_y: f64,
    /// Zones that found no room, or solutions that fell back.
    left_out: usize,
}

fn press_together(case: &PlanarCase) -> Result<Pressed, ContactError> {
    check(case)?;
    let mut line = PlanarLine::new(case.separation);
    let rule = GaussLegendre::new(case.strips);
    let material = MaterialPair::new(case.wheel_material, case.rail_material);
    let mut strips = Strips::with_capacity(MOST_ZONES, case.strips.max(LEAST_STRIPS));
    let mut solver =
        (case.normal_model == NormalModel::Strips).then(|| StripSolver::new(case.strips));
    let (least, mut left_out) = (line.least, 0);
    // `approach` counts from first touch.
    let mut press = |approach: f64| {
        strips.clear();
        if approach > 0.0 {
            let problem = NormalProblem {
                approach,
                radius: case.radius,
                contact_modulus: material.contact_modulus,
                contact_u: line.contact,
                lateral_curvature: line.curve.at(line.contact).second[1],
                rule: &rule,
                elements: case.elements,
            };
            let probes = std::mem::take(&mut line.probes);
            let (model, epsilon) = (case.normal_model, case.virtual_penetration);
            let fit = case.shape_fit;
            let solved = solver.as_mut().is_some_and(|solver| {
                solve_in_frame(solver, &problem, &mut line, &probes, &mut strips)
            });
            left_out = if solved {
                0
            } else {
                usize::from(solver.is_some())
                    + normal::solve(model, epsilon, fit, &problem, &mut line, &probes, &mut strips)
            };
            line.probes = probes;
        }
        strips.load()
    };
    match case.indentation {
        Indentation::Approach(approach) => {
            press(approach - least);
        }
        Indentation::Load(load) if load > 0.0 => {
            // Between elements the load is not smooth to rounding.
            let boundary = case.normal_model == NormalModel::BoundaryElement;
            let found = if boundary { ELEMENT_APPROACH } else { 1e-16 };
            let approach = approach_for(load, found, &mut press)?;
            press(approach);
        }
        Indentation::Load(_) => {}
    }
    Ok(Pressed { contact_y: line.contact, strips, material, left_out })
}

/// Bracket of the approach of boundary elements under a given load [m].
const ELEMENT_APPROACH: f64 = 1e-11;

/// The approach from first touch, to `found` [m], at which `press` gives `load`; where the load jumps past it, the place of the jump.
fn approach_for(
    load: f64,
    found: f64,
    press: &mut impl FnMut(f64) -> f64,
) -> Result<f64, ContactError> {
    let (mut low, mut low_load, mut high) = (0.0, 0.0, 1e-6);
    let mut high_load = press(high);
    while high_load < load {
        if high >= MOST_APPROACH {
            return Err(ContactError::bad_value(
                "load",
                load,
                "at most what the profiles carry 20 mm below first touch",
            ));
        }
        (low, low_load) = (high, high_load);
        high = (2.0 * high).min(MOST_APPROACH);
        high_load = press(high);
    }
    Ok(bracketed((low, low_load - load), (high, high_load - load), found, |a| press(a) - load))
}

fn summarise(
    case: &PlanarCase,
    material: &MaterialPair,
    strips: &Strips,
    contact_y: f64,
) -> PlanarResult {
    let mut result = PlanarResult { patches: strips.zones.len(), ..PlanarResult::default() };
    let tangential = tangential_of(case);
    let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
    for zone in strips.zones.iter() {
        result.normal_force += zone.load;
        result.max_pressure = result.max_pressure.max(zone.max_pressure);
        result.area += zone.area;
        result.length = result.length.max(zone.length);
        let edges = zone_edges(strips, zone.first, zone.count);
        left = left.min(edges[0]);
        right = right.max(edges[1]);
        let y = contact_y + zone.y;
        let state = rolling_state(case, y);
        let force = tangential.creep_force(zone, strips, material, &state).unwrap_or_default();
        result.fallback |= force.fell_back;
        result.fx += force.longitudinal;
        result.fy += force.lateral;
        result.mz += force.spin_moment - y * force.longitudinal;
    }
    result.width = (right - left).max(0.0);
    result
}

fn tangential_of(case: &PlanarCase) -> Tangential {
    Tangential::new(
        case.tangential_model,
        case.flexibilities,
        case.bound,
        case.elements_along,
        case.elements,
    )
    .with_law(case.friction_law)
}

/// How a zone with its centroid at `y` rolls.
fn rolling_state(case: &PlanarCase, y: f64) -> RollingState {
    let [longitudinal, lateral, spin] = case.creepage.map(bounded);
    RollingState {
        creepage: Creepage { longitudinal: bounded(longitudinal - spin * y), lateral, spin },
        forward_share: 1.0,
        friction: case.friction,
        load_factor: 1.0,
        speed: case.speed,
    }
}

/// Left and right edge of a zone from its strips: Gauss-Legendre weights sum to its width.
fn zone_edges(strips: &Strips, first: usize, count: usize) -> [f64; 2] {
    let range = first..first + count;
    let width: f64 = strips.width[range.clone()].iter().sum();
    let (a, b) = (strips.y[first], strips.y[first + count - 1]);
    let middle = 0.5 * (a + b);
    [middle - 0.5 * width, middle + 0.5 * width]
}

fn check(case: &PlanarCase) -> Result<(), ContactError> {
    let distance = "a distance in metres, -1000 to 1000";
    let require = |name: &str, value: f64, fits: bool, allowed: &'static str| {
        if value.is_finite() && fits {
            Ok(())
        } else {
            Err(ContactError::bad_value(name, value, allowed))
        }
    };
    let points = case.separation;
    require("separation", points.len() as f64, points.len() >= 4, "at least 4 points")?;
    for pair in points.windows(2) {
        require("separation f", pair[0][1], pair[0][1].abs() <= MOST_DISTANCE, distance)?;
        require("separation y", pair[0][0], pair[0][0].abs() <= MOST_DISTANCE, distance)?;
        require(
            "separation y",
            pair[1][0],
            pair[1][0] > pair[0][0],
            "greater than the y before it",
        )?;
    }
    for (name, value) in ["separation y", "separation f"].iter().zip(points[points.len() - 1]) {
        require(name, value, value.abs() <= MOST_DISTANCE, distance)?;
    }
    let (least, most) = RADII;
    let fits = (least..=most).contains(&case.radius);
    require("radius", case.radius, fits, "a radius in metres, 1e-4 to 1e6")?;
    match case.indentation {
        Indentation::Approach(a) => {
            require("approach", a, a <= MOST_APPROACH, "a finite number up to 20 mm")?;
        }
        Indentation::Load(n) => require("load", n, n >= 0.0, "a finite number, at least 0")?,
    }
    let names = ["creepage_longitudinal", "creepage_lateral", "spin"];
    for (name, value) in names.iter().zip(case.creepage) {
        require(name, value, true, "a finite number")?;
    }
    require("friction", case.friction, case.friction >= 0.0, "a finite number, at least 0")?;
    for (body, m) in [("wheel", case.wheel_material), ("rail", case.rail_material)] {
        require(
            &format!("{body} young_modulus"),
            m.young_modulus,
            (MODULI.0..=MODULI.1).contains(&m.young_modulus),
            "a modulus in Pa, 1e3 to 1e18",
        )?;
        let nu = m.poisson_ratio;
        require(&format!("{body} poisson_ratio"), nu, (0.0..=0.5).contains(&nu), "0 to 0.5")?;
    }
    require("speed", case.speed, case.speed >= 0.0, "a finite number, at least 0")?;
    let law = &case.friction_law;
    for (name, value) in
        [("falling share", law.falling_share), ("reduction share", law.reduction_share)]
    {
        require(name, value, (0.0..=1.0).contains(&value), "0 to 1")?;
    }
    for (name, value) in
        [("falling decay", law.falling_decay), ("reduction decay", law.reduction_decay)]
    {
        require(name, value, value >= 0.0, "a finite number, at least 0")?;
    }
    require("reduction", law.reduction, (1e-3..=1.0).contains(&law.reduction), "0.001 to 1")?;
    let epsilon = case.virtual_penetration;
    require("virtual_penetration", epsilon, epsilon > 0.0 && epsilon < 1.0, "between 0 and 1")?;
    let counts = 4..=200;
    require("strips", case.strips as f64, counts.contains(&case.strips), "4 to 200")?;
    require(
        "elements_along",
        case.elements_along as f64,
        counts.contains(&case.elements_along),
        "4 to 200",
    )?;
    for (name, count) in ["elements_along", "elements_across"].into_iter().zip(case.elements) {
        require(name, count as f64, counts.contains(&count), "4 to 200")?;
    }
    Ok(())
}

/// The separation as a cubic spline, with y as parameter.
struct PlanarLine {
    curve: Curve,
    /// y of the deepest place [m].
    contact: f64,
    /// f there [m].
    least: f64,
    probes: Vec<Probe>,
}

impl PlanarLine {
    fn new(points: &[[f64; 2]]) -> Self {
        let y: Vec<f64> = points.iter().map(|p| p[0]).collect();
        let f: Vec<f64> = points.iter().map(|p| p[1]).collect();
        let slopes = interpolating_slopes(&y, &f, [SplineEnd::Natural; 2]);
        let knots: Vec<Knot> = (0..y.len())
            .map(|i| Knot { s: y[i], point: [y[i], f[i]], tangent: [1.0, slopes[i]] })
            .collect();
        let curve = Curve::through(&knots);
        let mut probes = Vec::new();
        for pair in knots.windows(2) {
            probes.push(Probe { u: pair[0].s, f: pair[0].point[1] });
            let slope = |u: f64| curve.at(u).first[1];
            // The slope of a cubic piece is monotone on either side of its inflection.
            let (s0, s1) = (pair[0].s, pair[1].s);
            let (bend0, bend1) = (curve.at(s0).second[1], curve.at(s1.next_down()).second[1]);
            let inflection = s0 + (s1 - s0) * bend0 / (bend0 - bend1);
            let inner = if inflection > s0 && inflection < s1 { inflection } else { s1 };
            let ends = [(s0, pair[0].tangent[1]), (inner, slope(inner)), (s1, pair[1].tangent[1])];
            for end in ends.windows(2) {
                if end[0].1 * end[1].1 < 0.0 {
                    let u = bracketed(end[0], end[1], 1e-16, slope);
                    probes.push(Probe { u, f: curve.at(u).point[1] });
                }
            }
        }
        let last = &knots[knots.len() - 1];
        probes.push(Probe { u: last.s, f: last.point[1] });
        let deepest = probes.iter().copied().min_by(|a, b| a.f.total_cmp(&b.f));
        let Probe { u: contact, f: least } = deepest.unwrap_or(Probe { u: 0.0, f: 0.0 });
        for probe in &mut probes {
            probe.f -= least;
        }
        Self { curve, contact, least, probes }
    }
}

impl Separation for PlanarLine {
    fn at(&mut self, u: f64) -> SeparationPoint {
        let f = self.curve.at(u).point[1] - self.least;
        SeparationPoint { y: u - self.contact, dy: 1.0, f, x: 0.0 }
    }

    fn with_slope(&mut self, u: f64) -> (SeparationPoint, f64) {
        (self.at(u), self.curve.at(u).first[1])
    }
}
