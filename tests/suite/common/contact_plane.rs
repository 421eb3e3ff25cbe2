//! The wheel on a rail that varies as CONTACT sees it: one plane, rolled about the track alone,
//! boundary elements of its size on it, and its creepages.
//!
//! The surfaces are exact and not those of the element: heads of arcs and straight lines, and the
//! profile turned about the axle. What is left between this and CONTACT is how contacts are solved;
//! what is left between this and the element is the plane, the creepages and the direction of
//! rolling.

use wheelrail::boundary_element::grid::Grid;
use wheelrail::boundary_element::pressure::PressureSolver;
use wheelrail::boundary_element::rolling::steady_rolling;
use wheelrail::element::output::Patch;
use wheelrail::geometry::curve::Curve;
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::load_profile;
use wheelrail::material::MaterialPair;

use super::planar::STEEL;
use super::varying::Head;
use super::{read_table, value};

type Vector = nalgebra::Vector3<f64>;

const RADIUS: f64 = 0.46;
const FRICTION: f64 = 0.3;
/// Size of CONTACT's elements, half the square that is looked through for overlap, and the greatest
/// approach of 80 kN [m].
const SIZE: f64 = 2e-4;
const HALF: f64 = 9e-3;
const DEEPEST: f64 = 1.6e-4;

/// A wheel and a rail as they stand.
struct Bodies<'a> {
    wheel: &'a Curve,
    centre: Vector,
    yaw: f64,
    rail: Head,
    station: f64,
}

impl Bodies<'_> {
    /// How far a point is below the rail [m].
    fn below_rail(&self, p: Vector) -> f64 {
        p.z - self.rail.height(self.station + p.x, p.y - 0.75)
    }

    /// How far a point is outside the wheel [m].
    fn outside_wheel(&self, p: Vector) -> f64 {
        let (sine, cosine) = self.yaw.sin_cos();
        let d = p - self.centre;
        let (x, y) = (cosine * d.x + sine * d.y, cosine * d.y - sine * d.x - 0.75);
        // The parameter of a profile is close to its arc.
        let mut s = 0.5 * (self.wheel.start() + self.wheel.end());
        for _ in 0..20 {
            let at = self.wheel.at(s);
            s = self.wheel.within(s + (y - at.point[0]) / at.first[0].max(0.5));
        }
        x.hypot(d.z) - RADIUS - self.wheel.at(s).point[1]
    }
}

/// A plane: a point of it, the direction of rolling, its angle to the track, the direction across
/// and the normal into the rail.
struct Plane {
    origin: Vector,
    along: Vector,
    course: f64,
    across: Vector,
    normal: Vector,
}

impl Plane {
    /// That through `origin` which is rolled by `angle` about the track, on which the wheel rolls
    /// by `course` away from the track [rad].
    fn new(origin: Vector, angle: f64, course: f64) -> Self {
        let [sine, cosine] = [angle.sin(), angle.cos()];
        let (lateral, normal) = (Vector::new(0.0, cosine, sine), Vector::new(0.0, -sine, cosine));
        let along = Vector::x() * course.cos() + lateral * course.sin();
        let across = lateral * course.cos() - Vector::x() * course.sin();
        Self { origin, along, course, across, normal }
    }

    /// Distance of the bodies along the normal [m].
    fn gap(&self, bodies: &Bodies, x: f64, y: f64) -> f64 {
        let from = self.origin + self.along * x + self.across * y;
        let to = |depth: &dyn Fn(Vector) -> f64| {
            // Both depths grow nearly as the way along the normal does.
            (0..8).fold(0.0, |way, _| way - depth(from + self.normal * way))
        };
        to(&|p| bodies.below_rail(p)) - to(&|p| bodies.outside_wheel(p))
    }

    /// Greatest pressure [Pa] and force on the wheel along the track and across [N] under `load`
    /// [N], with creepages ξ, η, φ along the track and across, wheel minus rail.
    fn solve(&self, bodies: &Bodies, load: f64, creepage: [f64; 3]) -> (f64, [f64; 2]) {
        let count = (2.0 * HALF / SIZE) as usize;
        let all = Grid::over([-HALF, HALF], [-HALF, HALF], count, count);
        let gaps = all.sample(|x, y| self.gap(bodies, x, y));
        let least = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        let pair = MaterialPair::new(STEEL, STEEL);
        let mut solver = PressureSolver::new(all, pair.contact_modulus);
        let distance: Vec<f64> = gaps.iter().map(|gap| gap - least).collect();
        let (mut range, mut approach) = ([0.0, DEEPEST], 0.7 * DEEPEST);
        let mut pressure = Vec::new();
        for _ in 0..40 {
            pressure = solver.at_approach(&distance, approach, None).pressure;
            let carried = all.element_area() * pressure.iter().sum::<f64>();
            if (carried / load - 1.0).abs() < 1e-6 {
                break;
            }
            range[usize::from(carried > load)] = approach;
            let next = approach * (load / carried).powf(2.0 / 3.0);
            let is_inside = range[0] < next && next < range[1];
            approach = if is_inside { next } else { 0.5 * (range[0] + range[1]) };
        }
        // Loaded rows and columns alone.
        let loaded = |k: &usize| pressure[*k] > 0.0;
        let column = |k: usize| k % count;
        let ends = |of: &dyn Fn(usize) -> usize| {
            let places = (0..all.len()).filter(loaded).map(of);
            places.fold([count, 0], |[a, b], i| [a.min(i), b.max(i)])
        };
        let [[left, right], [first, last]] = [ends(&column), ends(&|k| k / count)];
        let grid = Grid {
            along: right - left + 1,
            across: last - first + 1,
            leading_x: all.x(left),
            left_y: all.y(first),
            ..all
        };
        let of_row = |j: usize| &pressure[j * count + left..=j * count + right];
        let bound: Vec<f64> =
            (first..=last).flat_map(|j| of_row(j).iter().map(|p| FRICTION * p)).collect();
        let [xi, eta, phi] = creepage;
        let [xi, eta] = turned([xi, eta], -self.course);
        let [x, y] = [grid.sample(|_, y| xi - phi * y), grid.sample(|x, _| eta + phi * x)];
        let rigid: Vec<[f64; 2]> = x.into_iter().zip(y).map(<[f64; 2]>::from).collect();
        let found = steady_rolling(&grid, &pair, &bound, &rigid);
        let sums = [&found.x, &found.y].map(|p| grid.element_area() * p.iter().sum::<f64>());
        let force = turned(sums, self.course);
        (pressure.into_iter().fold(0.0, f64::max), force)
    }
}

/// A vector of a plane, turned by `angle` [rad].
fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    [cosine * x - sine * y, sine * x + cosine * y]
}

/// Whose plane and creepages they are.
pub enum Whose<'a> {
    /// CONTACT's own.
    Contact,
    /// Those of the patches of an element, one for each row.
    Element(&'a [Patch]),
}

/// A contact on such a plane, and in CONTACT.
pub struct OnPlane {
    /// Its row in CONTACT's table.
    pub name: String,
    /// Friction limit [N].
    pub limit: f64,
    /// Greatest pressure, over that of CONTACT [-].
    pub pressure: f64,
    /// Force on the wheel along the track and across, on the plane and in CONTACT [N].
    pub force: [f64; 2],
    pub contact: [f64; 2],
}

/// Errors of boundary elements on such planes in rows of CONTACT's table of the rail `name`,
/// greatest pressure and creep force over the friction limit, with the name of the row; as
/// [`on_planes`].
pub fn errors_on_plane(
    name: &str,
    whose: &Whose,
    course: f64,
    within: f64,
) -> Vec<(String, [f64; 2])> {
    let found = on_planes(name, whose, course, within).into_iter();
    let errors = found.map(|OnPlane { name, limit, pressure, force, contact, .. }| {
        let missed = (force[0] - contact[0]).hypot(force[1] - contact[1]) / limit;
        (name, [pressure - 1.0, missed])
    });
    errors.collect()
}

/// Boundary elements on such planes in rows of CONTACT's table of the rail `name`. Particles pass
/// through the contact by `course` away from the track [rad]. Rows are left out of which the
/// contact is not `within` a place along the rail [m].
pub fn on_planes(name: &str, whose: &Whose, course: f64, within: f64) -> Vec<OnPlane> {
    let wheel = load_profile("wheel", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap();
    let table = read_table("contact_25_1/variable_profiles.csv");
    let rows = table.rows.iter().filter(|row| row.iter().any(|cell| cell == name)).enumerate();
    let mut found = Vec::new();
    for (k, row) in rows {
        let of = |name: &str| value(&table, row, name);
        if 1e-3 * (of("s_mm") + of("x_mm")) > within {
            continue;
        }
        let load = of("N_N");
        let bodies = Bodies {
            wheel: &wheel.curve,
            centre: Vector::new(0.0, 1e-3 * of("y_ws_mm"), 1e-3 * of("z_ws_mm") - RADIUS),
            yaw: of("yaw_rad"),
            rail: Head::of(name),
            station: 1e-3 * of("s_mm"),
        };
        let (origin, angle, creepage) = match whose {
            Whose::Contact => (
                ["x_mm", "y_ref_mm", "z_ref_mm"].map(|name| 1e-3 * of(name)),
                of("angle_rad"),
                [-of("cksi"), -of("ceta"), -1e3 * of("cphi_rad_mm")],
            ),
            Whose::Element(patches) => {
                (patches[k].position, patches[k].contact_angle, patches[k].creepage)
            }
        };
        let plane = Plane::new(origin.into(), angle, course);
        let (pressure, force) = plane.solve(&bodies, load, creepage);
        found.push(OnPlane {
            name: row[0].to_owned(),
            limit: FRICTION * load,
            pressure: pressure / (1e6 * of("pmax_MPa")),
            force,
            contact: [-of("Fx_N"), -of("Fs_N")],
        });
    }
    found
}
