//! A wheel whose section varies around, as a rail that is the same all along sees it.
//!
//! Seen along the rail, in the direction e, the wheel S(v, ψ) has the outline of those places at
//! which e is tangent to its surface:
//!
//! ```text
//! (S_v × S_ψ) · e = 0
//! ```
//!
//! with v a row around the wheel and ψ the angle from straight below the axle, forward. A round
//! wheel with the right section has the same outline, point by point with the same normal n: where
//! n meets the axle lies the plane in which it goes through the point, and its slope is that of n
//! against the axle. That wheel takes the place of the varying one at this pitch, roll and yaw.
//! What is left is how far ahead of its contact line the varying wheel is met, and what the
//! curvature along the rail is more than that of the round one,
//!
//! ```text
//! κ = -n · (a² S_vv + 2 a b S_vψ + b² S_ψψ),   e = a S_v + b S_ψ
//! ```
//!
//! Whoever needs all of the surface, and not the outline alone, finds it by
//! [`VaryingWheel::surface_along`]: where a straight line meets it.
//!
//! The section at angle θ around the wheel, counted forward from where it faces the rail at pitch
//! 0, is straight below at the pitch -θ.

mod surface;
mod vectors;

use self::vectors::{dot, in_plane};
use std::f64::consts::{PI, TAU};

use crate::geometry::curves::curve::{Curve, Knot};
use crate::geometry::sections::rows::along::Along;
use crate::geometry::sections::rows::envelope::Envelope;
use crate::geometry::sections::rows::met::Met;
use crate::geometry::sections::rows::plane::cross;
use crate::geometry::sections::rows::surface::{RowPoint, Surface};
use crate::geometry::sections::slices::{RowKnot, Rows, Slices};
use crate::geometry::uneven::waviness::Waviness;
use crate::geometry::wheel::wheel_pose::WheelPose;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;

/// Least share of a row's way across the outline: where the wheel stands more upright nothing is
/// looked for.
const MIN_RATE: f64 = 0.1;
/// Spacing at which rows are looked through, along the nominal rolling circle [m].
const SCAN: f64 = 2e-3;
/// Steps to the place on a row, of which halving what samples leave takes 26, and the last of them
/// [rad].
const MAX_STEPS: usize = 40;
const LAST_STEP: f64 = 1e-10;
/// Least bend of a row towards its lowest place, over that of a round wheel.
const MIN_BEND: f64 = 0.1;
/// Sine of the angle from straight below up to which a round wheel is met.
const MAX_SINE: f64 = 0.9;

/// What a round wheel in the place of a varying one leaves out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BesideRound {
    /// How far ahead of the contact line the wheel is met [m].
    pub ahead: f64,
    /// Curvature along the rail beyond that of the round wheel, but for what follows [1/m].
    pub curvature: f64,
    /// Share of the curvature across in the curvature along the rail beyond that of the round wheel
    /// [-].
    pub share_across: f64,
}

/// A wheel whose section varies around.
#[derive(Clone, Debug)]
pub struct VaryingWheel {
    surface: Surface,
    radius: f64,
    /// How it stood to the rail when it was laid last.
    stand: Stand,
    /// Middle of the angles that the slices cover [rad].
    middle: f64,
    /// How far to either side a row may be met because it is not round [rad].
    reach: f64,
    /// Least distance of sections along the nominal rolling circle [m].
    spacing: f64,
    envelope: Envelope,
    met: FixedVec<Met>,
    knots: FixedVec<Knot>,
}

/// The wheel as it stands to the rail.
#[derive(Clone, Copy, Debug, Default)]
struct Stand {
    /// Component of e along the axle, and across it.
    along_axle: f64,
    across_axle: f64,
    /// Angle around the wheel straight below the axle, and the slice before it.
    angle: f64,
    slice: usize,
}

impl Stand {
    /// Across the outline and down.
    fn seen(&self, v: [f64; 3]) -> [f64; 2] {
        [self.across_axle * v[0] - self.along_axle * v[1], v[2]]
    }

    /// Angle at which a round wheel of this `slope` is met [rad].
    fn round(&self, slope: f64) -> f64 {
        (slope * self.along_axle / self.across_axle).clamp(-MAX_SINE, MAX_SINE).asin()
    }
}

/// A place of a row, in coordinates along the axle, forward and down.
#[derive(Clone, Copy)]
struct Place {
    point: [f64; 3],
    /// Derivatives by row and angle.
    across: [f64; 3],
    around: [f64; 3],
    twist: [f64; 3],
    bend: [f64; 3],
    /// Distance from the axle, and slope of the section.
    radius: f64,
    slope: f64,
}

impl VaryingWheel {
    /// The wheel of `slices` over the angle [rad], of a nominal rolling circle with the radius
    /// `radius` [m].
    pub fn new(slices: &Slices, radius: f64) -> Self {
        let [first, last] = slices.range();
        // Upside down it is as a rail: rows go to the field side over a top.
        let turned = |[y, z]: [f64; 2]| [y, -z];
        let rows = slices.around().over_places(radius).rows(turned, turned);
        let corrugation = Waviness::new(None);
        let surface = Surface { rows, roller: None, corrugation };
        let count = surface.count();
        let steps = surface.rows.places.windows(2).map(|pair| pair[1] - pair[0]);
        let spacing = steps.fold(f64::INFINITY, f64::min);
        Self {
            radius,
            stand: Stand::default(),
            middle: 0.5 * (first + last),
            reach: (2.0 * spread(&surface) / radius).sqrt(),
            spacing,
            envelope: Envelope::new(count),
            met: FixedVec::new(count),
            knots: FixedVec::new(count),
            surface,
        }
    }

    /// Least distance of its sections along the nominal rolling circle [m].
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Most knots of the section of the round wheel.
    pub fn most_knots(&self) -> usize {
        self.surface.count()
    }

    /// Sides of outlines of which none of the wheel lies outside, by the ends (y, z) of each on the
    /// profile [m].
    pub fn sides(&self) -> impl Iterator<Item = [[f64; 2]; 2]> + Clone + '_ {
        let (rows, count) = (&self.surface.rows, self.surface.count());
        let outlines = (0..rows.places.len()).flat_map(|i| hull(rows, i).map(|way| (i, way)));
        outlines.flat_map(move |(i, way)| {
            let point = move |knot: &RowKnot| {
                [knot.value[0] + way * knot.slope[0], -knot.value[1] - way * knot.slope[1]]
            };
            let knots = &rows.knots[i * count..(i + 1) * count];
            let sides = knots.windows(2).map(move |pair| [point(&pair[0]), point(&pair[1])]);
            sides.filter(|side| side.iter().flatten().all(|x| x.is_finite()))
        })
    }

    /// What its outline may be longer than its first section [m].
    pub fn longer(&self) -> f64 {
        let (rows, count) = (&self.surface.rows, self.surface.count());
        let length = |knots: &[RowKnot]| -> f64 {
            let pairs = knots.windows(2).map(|pair| {
                let [a, b] = [pair[0].value, pair[1].value];
                (b[0] - a[0]).hypotenuse(b[1] - a[1])
            });
            pairs.filter(|length| length.is_finite()).sum()
        };
        let first = length(&rows.knots[..count]);
        rows.knots.chunks(count).map(|knots| length(knots) - first).fold(0.0, f64::max)
    }

    /// Lays the section of the round wheel that takes the place of this one at `pose` and `pitch`
    /// [rad] into `curve`; allocates nothing within the room that it has. False where there is
    /// none.
    pub fn pass(&mut self, pose: &WheelPose, pitch: f64, curve: &mut Curve) -> bool {
        let (sine, cosine) = pose.yaw.sin_cos();
        let angle = self.middle + (-pitch - self.middle + PI).rem_euclid(TAU) - PI;
        let slice = self.surface.within(self.radius * angle).slice;
        // An axle along the track sees no outline: kept away from zero, the result stays finite.
        let stand = Stand { along_axle: -sine, across_axle: cosine.max(1e-9), angle, slice };
        self.stand = stand;
        self.met.clear();
        for j in 0..self.surface.count() {
            if let Some(here) = self.meet(&stand, j) {
                self.met.push(here);
            }
        }
        if !self.envelope.lay(&self.surface, &self.met) {
            return false;
        }
        self.knots.clear();
        self.knots.extend(self.envelope.knots().iter().map(|knot| {
            let turned = |[y, z]: [f64; 2]| [y, -z];
            Knot { s: knot.s, point: turned(knot.point), tangent: turned(knot.tangent) }
        }));
        curve.put_through(&self.knots);
        true
    }

    /// What the round wheel that was laid last leaves out at parameter `s` of its section.
    pub fn beside_round(&self, s: f64) -> BesideRound {
        let Along { ahead, curvature, drift, .. } = self.envelope.along(s);
        BesideRound { ahead, curvature, share_across: drift }
    }

    /// Row `j` as the rail sees it; nothing where the row is not there.
    fn meet(&self, stand: &Stand, j: usize) -> Option<Met> {
        let run = self.surface.run(j, self.radius * stand.angle, stand.slice)?;
        let below = self.place(stand, j, run, 0.0);
        let round = stand.round(below.slope);
        let here = self.place(stand, j, run, round);
        let [v, _] = stand.seen(here.across);
        if v < MIN_RATE * stand.seen(here.across)[1].abs().max(v.abs()) {
            return Some(self.upright(j, &below));
        }
        let (mut psi, [mut from, mut to]) = self.lowest(stand, j, run, round, &here);
        let mut here = self.place(stand, j, run, psi);
        for _ in 0..MAX_STEPS {
            let [v, p] = [here.across, here.around].map(|d| stand.seen(d));
            let [vp, pp] = [here.twist, here.bend].map(|d| stand.seen(d));
            // Falls where the outline is farthest out.
            let rate = cross(v, p);
            if rate > 0.0 {
                from = psi;
            } else {
                to = psi;
            }
            let least = -MIN_BEND * here.radius * v[0];
            let slope = (cross(vp, p) + cross(v, pp)).min(least);
            let newton = psi - rate / slope;
            // The farthest place lies next to the sample farthest out, wherever a step would go.
            let next = if newton > from && newton < to { newton } else { 0.5 * (from + to) };
            let step = next - psi;
            psi = next;
            here = self.place(stand, j, run, psi);
            if step.abs() < LAST_STEP {
                break;
            }
        }
        Some(self.round_wheel(stand, j, &here))
    }

    /// The row `j` where it stands upright and nothing touches: as it is straight below.
    fn upright(&self, j: usize, below: &Place) -> Met {
        Met {
            row: j,
            point: [below.point[0], self.radius - below.radius],
            direction: [below.across[0], -below.across[2]],
            ..Met::default()
        }
    }

    /// The angle at which row `j` lies lowest, seen along the normal of the place `here` near the
    /// angle `round`, of samples, and those on either side of it [rad].
    fn lowest(
        &self,
        stand: &Stand,
        j: usize,
        run: [usize; 2],
        round: f64,
        here: &Place,
    ) -> (f64, [f64; 2]) {
        let [ty, tz] = stand.seen(here.across);
        let count = (self.reach * self.radius / SCAN).ceil().max(1.0) as i32;
        let apart = self.reach / f64::from(count);
        let mut best = (f64::NEG_INFINITY, round);
        for i in -count..=count {
            let psi = round + apart * f64::from(i);
            let [y, z] = stand.seen(self.place(stand, j, run, psi).point);
            let depth = z * ty - y * tz;
            if depth > best.0 {
                best = (depth, psi);
            }
        }
        (best.1, [-1.0, 1.0].map(|way| best.1 + way * apart))
    }

    /// The row `j` of the round wheel that is seen as the place `here`.
    fn round_wheel(&self, stand: &Stand, j: usize, here: &Place) -> Met {
        let Stand { along_axle: m, across_axle: c, .. } = *stand;
        let [ty, tz] = stand.seen(here.across);
        let size = ty.hypotenuse(tz);
        let [out, down] = [-tz / size, ty / size];
        let normal = [c * out, -m * out, down];
        let radial = normal[1].hypotenuse(normal[2]);
        let [sine, cosine] = [normal[1] / radial, normal[2] / radial];
        let radius = here.point[2] / cosine;
        let ahead = (here.point[1] - radius * sine) / c;
        // e by the tangents of row and circle.
        let [a, b] = in_plane([m, c, 0.0], here.across, here.around);
        let vv = dot(here.across, here.across);
        let curvature = -(2.0 * a * b * dot(normal, here.twist) + b * b * dot(normal, here.bend));
        let around_round = radial / radius * (c * cosine) * (c * cosine);
        let along = Along {
            ahead,
            curvature: curvature - around_round,
            lean: 0.0,
            drift: a * a * vv - (m / radial) * (m / radial),
            ..Along::default()
        };
        Met {
            row: j,
            point: [here.point[0] - ahead * m, self.radius - radius],
            direction: [radial, normal[0]],
            x: ahead,
            along,
            ..Met::default()
        }
    }

    /// Row `j` at the angle `psi` [rad] from straight below, on a `run` of slices.
    fn place(&self, stand: &Stand, j: usize, run: [usize; 2], psi: f64) -> Place {
        let p = self.surface.at(j, run, self.radius * (stand.angle + psi), stand.slice);
        self.turned(&p, psi)
    }

    /// The point `p` of the surface, at the angle `psi` [rad] from straight below.
    fn turned(&self, p: &RowPoint, psi: f64) -> Place {
        let r = self.radius;
        let (sine, cosine) = psi.sin_cos();
        let radius = r - p.value[1];
        let (by_row, by_angle) = (-p.value[3], -r * p.first[1]);
        let (twist, bend) = (-r * p.first[3], -r * r * p.second[1]);
        Place {
            point: [p.value[0], radius * sine, radius * cosine],
            across: [p.value[2], by_row * sine, by_row * cosine],
            around: [
                r * p.first[0],
                by_angle * sine + radius * cosine,
                by_angle * cosine - radius * sine,
            ],
            twist: [r * p.first[2], twist * sine + by_row * cosine, twist * cosine - by_row * sine],
            bend: [
                r * r * p.second[0],
                (bend - radius) * sine + 2.0 * by_angle * cosine,
                (bend - radius) * cosine - 2.0 * by_angle * sine,
            ],
            radius,
            slope: by_row / p.value[2].max(MIN_RATE * by_row.abs()),
        }
    }
}

/// Places and neighbours of a row between slices, as the control points of its splines: no spline
/// leaves their hull.
fn hull(rows: &Rows, i: usize) -> [f64; 3] {
    let last = rows.places.len() - 1;
    let span = |i: usize| rows.places[i.min(last)] - rows.places[i.max(1) - 1];
    [0.0, -span(i) / 3.0, span(i + 1) / 3.0]
}

/// Greatest difference of the heights of one row [m].
fn spread(surface: &Surface) -> f64 {
    let (rows, count) = (&surface.rows, surface.count());
    let mut spread = 0.0_f64;
    for j in 0..count {
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        for i in 0..rows.places.len() {
            let knot = &rows.knots[i * count + j];
            for way in hull(rows, i).into_iter().filter(|_| knot.value[0].is_finite()) {
                let height = knot.value[1] + way * knot.slope[1];
                (least, greatest) = (least.min(height), greatest.max(height));
            }
        }
        spread = spread.max(greatest - least);
    }
    spread
}
