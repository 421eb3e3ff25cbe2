//! Piotrowski and Kik's model where wheel or rail are not even along the track: corrugation,
//! out-of-round wheels, flats.
//!
//! Source: Piotrowski and Kik (2008), section 7, which applies the model of section 2 to a
//! corrugated rail without further equations; these are theirs with the overlap g(x, y) of the real
//! surfaces instead of g(y) - x²/(2R). With Q(x) of
//! [`wavy_section`](crate::geometry::uneven::wavy_section), f(y) the separation where the bodies are
//! nearest along the track, and c the cosine of the contact angle
//!
//! ```text
//! g(x, y) = δ0 - f(y) - c (Q(x) - min Q),   p(x, y) = (p0 / sqrt(δ0)) sqrt(g(x, y)) where g > 0
//! N = π E* δ I1 / I2,   I1 = ∬ sqrt(2 R g) dx dy,   I2 = ∬ sqrt(2 R g) / |(x, y) - (x_0, 0)| dx dy
//! ```
//!
//! with x_0 the place of first touch. Where the bodies are even this is the model of
//! [`piotrowski_kik`](super::piotrowski_kik). Where g > 0 on several stretches of a strip, each is
//! a strip of its own, semi-elliptical with the load that the root of g gives it. Strips whose
//! stretches meet along x form a zone.

use std::f64::consts::PI;

use super::piotrowski_kik::{MIN_DISTANCE, logarithm_error};
use super::zones::for_each_zone;
use super::{LoadedStrip, NormalProblem, Strips, Zone};
use crate::geometry::contacts::line_separation::LineSeparation;
use crate::geometry::contacts::separation::{Probe, Separation};
use crate::geometry::contacts::waves_along::WavesAlong;
use crate::geometry::uneven::stretches::{SampledWaves, WaveSamples};
use crate::math::elliptic::first_minus_second_split;
use crate::math::fixed_vec::FixedVec;
use crate::math::quadrature::GaussLegendre;
use crate::math::real::Real;

/// Most stretches of a strip.
const MAX_STRETCHES: usize = 16;
/// Points of the quadrature along a stretch, or to either side of the place of first touch.
const POINTS: usize = 7;

/// A stretch of a strip on which the bodies overlap.
#[derive(Clone, Copy, Debug, Default)]
struct Stretch {
    /// Number of its strip within the zone of neighbouring strips.
    strip: usize,
    /// Both ends [m].
    ends: [f64; 2],
    /// ∫ sqrt(2 R g) dx [m²].
    load: f64,
    /// Greatest sqrt(2 R g) at the points of the quadrature [m].
    peak: f64,
    y: f64,
    width: f64,
    u: f64,
    /// Number of the zone it belongs to.
    group: usize,
}

/// Scratch memory and the quadrature along strips.
#[derive(Clone, Debug)]
pub struct UnevenStrips {
    samples: WaveSamples,
    stretches: Stretches,
}

/// Stretches of one zone, and the quadrature along them.
#[derive(Clone, Debug)]
struct Stretches {
    list: FixedVec<Stretch>,
    /// Nodes sin θ and weights cos θ dθ over a quarter turn, for functions that end like a root.
    quarter: [[f64; 2]; POINTS],
}

impl UnevenStrips {
    /// Room for zones of `strips` strips.
    pub fn new(strips: usize) -> Self {
        let rule = GaussLegendre::new(POINTS);
        let mut quarter = [[0.0; 2]; POINTS];
        for (i, node) in quarter.iter_mut().enumerate() {
            let angle = 0.25 * PI * (1.0 + rule.nodes[i]);
            *node = [angle.sin(), 0.25 * PI * rule.weights[i] * angle.cos()];
        }
        let list = FixedVec::new(strips * MAX_STRETCHES);
        Self { samples: WaveSamples::new(), stretches: Stretches { list, quarter } }
    }

    /// Fills the empty `strips` with the loaded zones of one contact frame; as
    /// [`piotrowski_kik::solve`](super::piotrowski_kik::solve), with `waves` along the track.
    ///
    /// Returns with the number of zones that found no room by how much the waves of rail and wheel are
    /// steeper in the mean of the pressure than where the bodies are nearest [-].
    pub fn solve(
        &mut self,
        problem: &NormalProblem,
        virtual_penetration: f64,
        separation: &mut LineSeparation,
        waves: &WavesAlong,
        probes: &[Probe],
        strips: &mut Strips,
    ) -> (usize, [f64; 2]) {
        let depth = virtual_penetration * problem.approach;
        let longest = (2.0 * waves.radius / waves.share * depth).sqrt();
        // From the place of the contact line; that of a yawed wheel is another one for every strip,
        // for which it is made up as in the model of even bodies.
        let contact = separation.at(problem.contact_u);
        let Self { samples, stretches } = self;
        let WavesAlong { section, radius, share, ahead, .. } = *waves;
        let centre = separation.centre(problem.contact_u) + ahead;
        let samples = &samples.take(section, centre, section.overlapping(radius, depth / share));
        let overlap = |separation: &LineSeparation, u: f64, depth: f64| {
            Overlap::new(samples, [separation.centre(u) + ahead, radius], depth / share)
        };
        let deepest = overlap(separation, problem.contact_u, depth);
        let first_touch = deepest.deepest - deepest.centre;
        let mut left_out = 0;
        // Sums over all zones: of sqrt(2 R g), and of the same over the distance from first touch.
        let mut sums = Sums::default();
        for_each_zone(separation, probes, depth, |separation, edge| {
            let count = problem.rule.nodes.len();
            stretches.list.clear();
            let (middle, half) = (0.5 * (edge.left + edge.right), 0.5 * (edge.right - edge.left));
            let mut ends = [0.0; 2];
            for (strip, (node, weight)) in
                problem.rule.nodes.iter().zip(&problem.rule.weights).enumerate()
            {
                let u = middle + half * node;
                let at = separation.at(u);
                let width = half * weight * at.dy;
                // From the outermost strips, a few micrometres away, the edges are reached along
                // the tangent.
                if strip == 0 {
                    ends[0] = at.y + (edge.left - u) * at.dy;
                }
                if strip + 1 == count {
                    ends[1] = at.y + (edge.right - u) * at.dy;
                }
                let across = Across { strip, y: at.y, width, u };
                let own = overlap(separation, u, depth - at.f);
                left_out += stretches.add_strip(&across, &own, own.centre + first_touch, &mut sums);
            }
            let nearest = longest * MIN_DISTANCE / contact.dy;
            sums.displacement += longest
                * contact.dy
                * logarithm_error(problem.rule, &edge, problem.contact_u, nearest);
            let deepest = probes
                .iter()
                .filter(|p| p.u > edge.left && p.u < edge.right)
                .min_by(|a, b| a.f.total_cmp(&b.f));
            let peak = deepest.map(|probe| {
                let at = separation.at(probe.u);
                overlap(separation, probe.u, depth - at.f)
            });
            left_out += stretches.add_zones(ends, count, peak.as_ref(), strips);
        });
        let displacement = sums.displacement.max(sums.least);
        let scale = if displacement > 0.0 && sums.load > 0.0 {
            PI * problem.contact_modulus * problem.approach / displacement
        } else {
            left_out += strips.zones.len();
            0.0
        };
        // By parts the root of the overlap has as much slope of circles as of waves: known better,
        // as circles have no corners.
        let rail = if waves.section.is_round() { sums.rise } else { sums.rail_slope };
        let slopes = [rail, sums.rise - rail];
        let steeper = [0, 1].map(|body| {
            if sums.load > 0.0 { slopes[body] / sums.load - waves.slopes[body] } else { 0.0 }
        });
        for pressure in strips.pressure.iter_mut() {
            *pressure *= scale;
        }
        for i in 0..strips.zones.len() {
            let mut zone = strips.zones[i];
            zone.max_pressure *= scale;
            strips.summarise(&mut zone);
            strips.zones[i] = zone;
        }
        (left_out, steeper)
    }
}

impl Stretches {
    /// Adds all stretches of one strip; returns how many found no room.
    fn add_strip(
        &mut self,
        across: &Across,
        overlap: &Overlap,
        first_touch: f64,
        sums: &mut Sums,
    ) -> usize {
        let (mut left_out, mut count) = (0, 0);
        let Self { list: stretches, quarter } = self;
        overlap.stretches(|start, end| {
            // Steep circles of the flange back may overlap over less than the last digit of x: no
            // load.
            if end <= start {
                return;
            }
            count += 1;
            if count > MAX_STRETCHES || stretches.len() == stretches.capacity() {
                left_out += 1;
                return;
            }
            let ends = [start, end];
            let mut stretch = Stretch {
                strip: across.strip,
                ends,
                y: across.y,
                width: across.width,
                u: across.u,
                ..Stretch::default()
            };
            let inside = first_touch > start && first_touch < end;
            let pivot = if inside { first_touch } else { 0.5 * (start + end) };
            let (middle, _) = overlap.root(pivot);
            let y_squared = across.y * across.y;
            let mut influence = 0.0;
            for end in ends {
                let side = (end - pivot).abs();
                for [sine, weight] in *quarter {
                    let x = pivot + sine * (end - pivot);
                    let (root, slope) = overlap.root(x);
                    let part = weight * side * root;
                    stretch.load += part;
                    sums.rail_slope += across.width * part * slope;
                    sums.rise += across.width * part * overlap.rise(x);
                    stretch.peak = stretch.peak.max(root);
                    let along = x - first_touch;
                    let distance = (along * along + y_squared).sqrt();
                    // Near the place of first touch the half ellipse of the same height is taken
                    // out and added in closed form.
                    let cosine = (1.0 - sine * sine).max(0.0).sqrt();
                    let ellipse = if inside { middle * cosine } else { 0.0 };
                    influence += weight * side * (root - ellipse) / distance.max(1e-12);
                }
                if inside && side > 0.0 {
                    influence += 0.5 * middle / side * ellipse_influence(side, across.y);
                }
            }
            sums.load += across.width * stretch.load;
            sums.displacement += across.width * influence;
            let furthest = ends.map(|end| (end - first_touch).abs());
            let furthest = furthest[0].max(furthest[1]).hypotenuse(across.y);
            sums.least += across.width * stretch.load / furthest;
            stretches.push(stretch);
        });
        left_out
    }

    /// Turns the stretches of neighbouring strips into zones: those that meet along x belong
    /// together.
    fn add_zones(
        &mut self,
        ends: [f64; 2],
        count: usize,
        peak: Option<&Overlap>,
        strips: &mut Strips,
    ) -> usize {
        let stretches = &mut self.list;
        for i in 0..stretches.len() {
            stretches[i].group = i;
            for j in (0..i).rev() {
                if stretches[j].strip + 1 < stretches[i].strip {
                    break;
                }
                let ([a, b], [c, d]) = (stretches[i].ends, stretches[j].ends);
                let meet = stretches[j].strip != stretches[i].strip && a < d && c < b;
                let (own, other) = (stretches[i].group, stretches[j].group);
                if meet && own != other {
                    let (from, to) = (own.max(other), own.min(other));
                    for stretch in stretches.iter_mut().take(i + 1).filter(|s| s.group == from) {
                        stretch.group = to;
                    }
                }
            }
        }
        let mut left_out = 0;
        for group in 0..stretches.len() {
            let members = || stretches.iter().filter(move |s| s.group == group);
            let number = members().count();
            if number == 0 {
                continue;
            }
            if !strips.has_room_for(number) {
                left_out += 1;
                continue;
            }
            let mut zone: Zone = Zone { first: strips.y.len(), count: number, ..Zone::default() };
            let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
            for s in members() {
                let half_length = 0.5 * (s.ends[1] - s.ends[0]);
                let pressure = s.load / (0.5 * PI * half_length);
                let (x, width) = (0.5 * (s.ends[0] + s.ends[1]), s.width);
                strips.push(LoadedStrip { y: s.y, width, x, half_length, pressure, u: s.u });
                zone.length = zone.length.max(2.0 * half_length);
                zone.max_pressure = zone.max_pressure.max(s.peak);
                left = left.min(if s.strip == 0 { ends[0] } else { s.y - 0.5 * s.width });
                right = right.max(if s.strip + 1 == count { ends[1] } else { s.y + 0.5 * s.width });
            }
            zone.width = right - left;
            // The strips straddle the deepest place, which is known.
            if let Some(overlap) = peak {
                let at = overlap.deepest;
                overlap.stretches(|start, end| {
                    let meets = members().any(|s| s.ends[0] < end && start < s.ends[1]);
                    if meets {
                        zone.length = zone.length.max(end - start);
                        if (start..=end).contains(&at) {
                            zone.max_pressure = zone.max_pressure.max(overlap.root(at).0);
                        }
                    }
                });
            }
            strips.zones.push(zone);
        }
        left_out
    }
}

/// Place and width of a strip.
struct Across {
    strip: usize,
    y: f64,
    width: f64,
    u: f64,
}

/// Sums over the strips of a contact.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    load: f64,
    displacement: f64,
    /// The least that the displacement can be: of the same over the greatest distance from first
    /// touch.
    least: f64,
    /// Of the slopes of the rail, weighted as the load, and of those of the circle.
    rail_slope: f64,
    rise: f64,
}

/// The overlap g along one strip.
struct Overlap<'a> {
    waves: &'a SampledWaves<'a>,
    /// Middle and radius of the circle, and value of Q up to which the bodies overlap [m].
    centre: f64,
    radius: f64,
    level: f64,
    /// Where the overlap is greatest [m].
    deepest: f64,
}

impl<'a> Overlap<'a> {
    /// The overlap with greatest value `depth` along the height of a circle about `centre` of the
    /// radius `radius`.
    fn new(waves: &'a SampledWaves<'a>, [centre, radius]: [f64; 2], depth: f64) -> Self {
        let deepest = waves.lowest(centre, radius);
        let level = depth.max(0.0) + waves.distance(centre, radius, deepest);
        Self { waves, centre, radius, level, deepest }
    }

    fn stretches(&self, found: impl FnMut(f64, f64)) {
        self.waves.stretches(self.centre, self.radius, self.level, found);
    }

    /// Slope of the circle at `x` [-].
    fn rise(&self, x: f64) -> f64 {
        (x - self.centre) / self.radius
    }

    /// sqrt(2 R g) at `x`: R = r/c, and the overlap along the normal is c times that of the
    /// circles; and the slope of the rail.
    fn root(&self, x: f64) -> (f64, f64) {
        self.waves.depth_root(self.centre, self.radius, self.level, x)
    }
}

/// ∫ sqrt(a² - t²)/sqrt(t² + y²) dt from -a to a = 2 s (K - E), s² = a² + y² [m].
fn ellipse_influence(half_length: f64, y: f64) -> f64 {
    let y_squared = (y * y).max((MIN_DISTANCE * half_length).powi(2));
    let sum = half_length * half_length + y_squared;
    let complement = y_squared / sum;
    let (regular, logarithmic) = first_minus_second_split(complement);
    2.0 * sum.sqrt() * (regular - complement.ln() * logarithmic)
}
