//! The parts of zones: what the marches lack on the ellipse of each, and how parts feel each other.
//!
//! A part is a zone, or one of the lobes of one with a neck. What its marches lack is that of its
//! ellipse, with the creepage as it is felt there: the gradients that others cause are creepage too.
//! And what they lack is felt by the others in turn. In that each part is taken as one strip, with
//! the moments of the tractions of its own.

use super::functions::Four;
use super::influence::{Influence, Ratio, inverse_square};
use super::state::{Moments, State, Strip, felt, receive};
use crate::kinematics::creepage::Creepage;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;
use crate::tangential::equivalent_ellipse::LoadedPart;
use crate::tangential::tables::tabulated::ForceTable;

/// A zone and its parts, as ellipses.
#[derive(Clone, Copy, Debug)]
pub struct ZoneParts<T = f64> {
    /// Its friction limit [N].
    pub limit: T,
    /// Share of the lobes in the force, 0 to 1.
    pub apart: T,
    /// The whole, the left and the right lobe, as far as they have a share.
    pub parts: [Option<LoadedPart<T>>; PARTS],
}

/// Parts of a zone.
const PARTS: usize = 3;

/// A part as one strip.
#[derive(Clone, Copy, Debug)]
struct Part<T> {
    /// Where its load is [m], its mean half length [m] and its load [N].
    y: T,
    half_length: T,
    load: T,
    shear_modulus: T,
    /// Of the tractions of its marches.
    moments: [Moments<T>; 2],
    /// What its marches lack: forces on the body that creeps and the moment about the centroid of
    /// the load, with its share in the force of the zone [N, N m].
    lacks: [T; 3],
}

/// Zones with their parts as strips.
#[derive(Clone, Debug)]
pub(super) struct Zones<T> {
    zones: FixedVec<Zone<T>>,
}

#[derive(Clone, Debug)]
struct Zone<T> {
    given: ZoneParts<T>,
    /// Number of its strips.
    count: usize,
    /// The whole, and the lobes where there are any.
    parts: [Option<Part<T>>; PARTS],
}

/// Square of the half length of a strip over that of its part at which it has half as much per width
/// of what the marches lack as long strips: one that comes in without length brings nothing with it.
/// What they lack lies at the edges above all.
const LITTLE: f64 = 0.05;

/// Zones for which there is room; further ones allocate.
const ROOM: usize = 16;

/// How much of a strip is in the whole zone, in the left lobe and in the right one.
fn membership<T: Real>(left: T) -> [T; PARTS] {
    [T::from(1.0), left, -left + 1.0]
}

/// The other lobe.
fn opposite(n: usize) -> Option<usize> {
    (n > 0).then(|| PARTS - n)
}

impl<T: Real> Part<T> {
    /// The part `n` of a zone of these strips, which carry load.
    fn of(strips: &[State<T>], n: usize) -> Self {
        let zero = T::from(0.0);
        let [mut load, mut y, mut square] = [zero; 3];
        let mut sums = [[zero; 3]; 2];
        for state in strips {
            let strip = &state.strip;
            let member = membership(strip.left)[n];
            let own = member * strip.load;
            load += own;
            y += own * strip.y;
            square += own * strip.half_length * strip.half_length;
            for (sums, moments) in sums.iter_mut().zip(&state.moments) {
                for (sum, moment) in sums.iter_mut().zip(moments.each()) {
                    *sum += member * moment;
                }
            }
        }
        // A part that carries nothing is nowhere.
        let per_load = if load > 0.0 { T::from(1.0) / load } else { zero };
        Self {
            y: y * per_load,
            half_length: (square * per_load).sqrt(),
            load,
            shear_modulus: strips[0].strip.shear_modulus,
            moments: sums.map(Moments::of),
            lacks: [zero; 3],
        }
    }

    /// Adds the gradients that `moments` of another one cause here.
    fn receive(
        &self,
        gradients: &mut [Four<T>; 2],
        other: &Self,
        moments: &[Moments<T>; 2],
        ratio: &Ratio<T>,
    ) {
        let distance = (self.y - other.y).abs();
        if distance <= 0.0 || self.load <= 0.0 || other.load <= 0.0 {
            return;
        }
        let inverse = inverse_square(self.half_length, other.half_length);
        let pair = Influence::shared().narrow::<false, T>(distance, inverse, ratio);
        if other.y < self.y {
            receive::<false, true, T>(gradients, &pair, moments);
        } else {
            receive::<false, false, T>(gradients, &pair, moments);
        }
    }

    /// Adds what its marches lack to the tractions of the strips of its zone, of which it is number
    /// `n`: so much that the force with its `share` in that of the zone is not above `limit`. Where
    /// all adheres it lies evenly over the width but for strips that are short, where all slides as
    /// the load does, as no strip has more than its load holds; the square of the force over the
    /// limit leads from one to the other.
    fn spread(&self, strips: &mut [State<T>], n: usize, share: T, limit: T) {
        let little = self.half_length * self.half_length * LITTLE;
        let weight = |strip: &Strip<T>| {
            let square = strip.half_length * strip.half_length;
            membership(strip.left)[n] * strip.width * square / (square + little)
        };
        let [mut x, mut y, mut weights] = [T::from(0.0); 3];
        for state in strips.iter() {
            let member = share * membership(state.strip.left)[n];
            let [along, across] = state.marched();
            (x, y) = (x - member * along, y - member * across);
            weights += weight(&state.strip);
        }
        let [mut lacks_x, mut lacks_y, moment] = self.lacks;
        let whole = [x + lacks_x, y + lacks_y];
        let magnitude = whole[0].hypotenuse(whole[1]);
        let mut slides = T::from(1.0);
        if magnitude < limit {
            slides = (magnitude / limit).powi(2);
        } else if magnitude > limit {
            let ratio = limit / magnitude;
            (lacks_x, lacks_y) = (ratio * whole[0] - x, ratio * whole[1] - y);
        }
        let (per_weight, per_load) = ((-slides + 1.0) / weights, slides / self.load);
        for state in strips {
            let member = membership(state.strip.left)[n];
            let of_part = weight(&state.strip) * per_weight + member * state.strip.load * per_load;
            let [[along, _], [across, turning]] = &mut state.resultant.moments;
            *along -= of_part * lacks_x;
            *across -= of_part * lacks_y;
            *turning -= of_part * moment;
        }
    }

    /// Moments of what its marches lack, as a semi-ellipse along it, of the sign of tractions.
    fn lacking(&self) -> [Moments<T>; 2] {
        let a = self.half_length;
        let [x, y, _] = self.lacks;
        [x, y].map(|force| Moments::of([-force, T::from(0.0), -(force * a * a * 0.25)]))
    }
}

impl<T: Real> Zone<T> {
    /// Share of part `n` in the force.
    fn share(&self, n: usize) -> T {
        if n == 0 { -self.given.apart + 1.0 } else { self.given.apart }
    }
}

impl<T: Real> Zones<T> {
    pub fn new() -> Self {
        Self { zones: FixedVec::new(ROOM) }
    }

    pub fn clear(&mut self) {
        self.zones.clear();
    }

    /// Adds a zone with so many strips, which come after those of the zones before it.
    pub fn push(&mut self, given: ZoneParts<T>, count: usize) {
        if count > 0 {
            self.zones.push(Zone { given, count, parts: [None; PARTS] });
        }
    }

    /// Gathers the parts from the strips, which are `states`.
    pub fn gather(&mut self, states: &[State<T>]) {
        let mut further = states;
        for zone in self.zones.iter_mut() {
            let (own, others) = further.split_at(zone.count);
            further = others;
            let lobe = |n: usize| (zone.given.apart > 0.0).then(|| Part::of(own, n));
            zone.parts = [Some(Part::of(own, 0)), lobe(1), lobe(2)];
        }
    }

    /// The zones beside number `z`.
    fn beside(&self, z: usize) -> impl Iterator<Item = &Zone<T>> {
        let others = self.zones.iter().enumerate().filter(move |(other, _)| *other != z);
        others.map(|(_, zone)| zone)
    }

    /// Gives the strips, which are `states`, the gradients that what the marches of other parts lack
    /// causes: in all of a zone that of other zones, in a lobe that of the other one.
    pub fn hand_on(&self, states: &mut [State<T>], ratio: &Ratio<T>) {
        let mut further = states;
        for (z, zone) in self.zones.iter().enumerate() {
            let (own, others) = further.split_at_mut(zone.count);
            further = others;
            for (n, part) in zone.parts.iter().enumerate() {
                let Some(part) = part else { continue };
                let mut gradients = [[T::from(0.0); 4]; 2];
                let feel = |other: &Part<T>| {
                    part.receive(&mut gradients, other, &other.lacking(), ratio);
                };
                match opposite(n) {
                    Some(other) => zone.parts[other].iter().for_each(feel),
                    None if self.zones.len() < 2 => continue,
                    None => self.beside(z).flat_map(|zone| &zone.parts).flatten().for_each(feel),
                }
                for state in own.iter_mut() {
                    let member = membership(state.strip.left)[n];
                    for (given, gradient) in state.given.iter_mut().zip(&gradients) {
                        for (given, gradient) in given.iter_mut().zip(gradient) {
                            *given += member * *gradient;
                        }
                    }
                }
            }
        }
    }

    /// Adds what the marches lack to the tractions of the strips, within what friction holds of each
    /// part.
    pub fn spread(&self, states: &mut [State<T>]) {
        let mut further = states;
        for zone in self.zones.iter() {
            let (own, others) = further.split_at_mut(zone.count);
            further = others;
            for (n, (loaded, part)) in zone.given.parts.iter().zip(&zone.parts).enumerate() {
                let (Some(loaded), Some(part)) = (loaded, part) else { continue };
                // Friction may act on other strips alone.
                if part.load > 0.0 {
                    let share = zone.share(n);
                    let limit = zone.given.limit * loaded.share * loaded.friction * share;
                    part.spread(own, n, share, limit);
                }
            }
        }
    }
}

impl<T: Real> Zones<T> {
    /// Finds what the marches lack in the creepages that are felt, by the `table`.
    pub fn look_up(&mut self, ratio: &Ratio<T>, poisson_ratio: T, table: &impl ForceTable) {
        for z in 0..self.zones.len() {
            let zone = &self.zones[z];
            let mut lacks = [None; PARTS];
            for (n, (loaded, part)) in zone.given.parts.iter().zip(&zone.parts).enumerate() {
                let (Some(loaded), Some(part)) = (loaded, part) else { continue };
                let mut gradients = [[T::from(0.0); 4]; 2];
                let other_lobe = opposite(n).and_then(|other| zone.parts[other].as_ref());
                let wholes = self.beside(z).filter_map(|zone| zone.parts[0].as_ref());
                for other in wholes.chain(other_lobe) {
                    part.receive(&mut gradients, other, &other.moments, ratio);
                }
                let caused = felt(part.half_length, part.shear_modulus, &gradients);
                let creepage = add(&loaded.creepage, &caused);
                let limit = zone.given.limit * loaded.share * loaded.friction;
                let modulus = part.shear_modulus;
                let found =
                    loaded.ellipse.tabulated(table, poisson_ratio, modulus, &creepage, limit);
                let share = zone.share(n);
                lacks[n] = Some(found.force.map(|force| share * force));
            }
            for (part, lacks) in self.zones[z].parts.iter_mut().zip(lacks) {
                if let (Some(part), Some(lacks)) = (part, lacks) {
                    part.lacks = lacks;
                }
            }
        }
    }
}

/// Sum of two creepages.
fn add<T: Real>(first: &Creepage<T>, second: &Creepage<T>) -> Creepage<T> {
    Creepage {
        longitudinal: first.longitudinal + second.longitudinal,
        lateral: first.lateral + second.lateral,
        spin: first.spin + second.spin,
    }
}
