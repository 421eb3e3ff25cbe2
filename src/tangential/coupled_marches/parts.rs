//! The parts of zones: what the marches lack on the ellipse of each, and how parts feel each other.
//!
//! A part is a zone, or one of the lobes of one with a neck. What its marches lack is that of its
//! ellipse, with the creepage as it is felt there: the gradients that others cause are creepage too.
//! And what they lack is felt by the others in turn. In that each part is taken as one strip, with
//! the moments of the tractions of its own.

use super::functions::Four;
use super::influence::{Influence, Ratio};
use super::state::{Moments, State, Strip, receive};
use crate::kinematics::creepage::Creepage;
use crate::math::fixed_vec::FixedVec;
use crate::math::real::Real;
use crate::tangential::equivalent_ellipse::LoadedPart;
use crate::tangential::tables::tabulated::{ForceTable, Tabulated};

/// A zone and its parts, of strips that are taken one after the other.
#[derive(Clone, Copy, Debug)]
pub struct ZoneParts<T = f64> {
    /// Number of its strips.
    pub count: usize,
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
    strip: Strip<T>,
    moments: [Moments<T>; 2],
    /// What its marches lack: forces on the body that creeps and the moment about the centroid of
    /// the load, with its share in the force of the zone [N, N m].
    lacks: [T; 3],
}

/// Zones with their parts as strips, lobes where there are any.
#[derive(Clone, Debug)]
pub(super) struct Zones<T> {
    zones: FixedVec<Zone<T>>,
}

#[derive(Clone, Debug)]
struct Zone<T> {
    given: ZoneParts<T>,
    whole: Part<T>,
    lobes: Option<[Part<T>; 2]>,
}

/// Zones for which there is room; further ones allocate.
const ROOM: usize = 16;

/// How much of a strip is in the whole zone, in the left lobe and in the right one.
fn membership<T: Real>(left: T) -> [T; PARTS] {
    [T::from(1.0), left, -left + 1.0]
}

impl<T: Real> Part<T> {
    /// The part `n` of a zone of these strips, which carry load.
    fn of(strips: &[State<T>], n: usize) -> Self {
        let zero = T::from(0.0);
        let [mut load, mut y, mut square, mut limit] = [zero; 4];
        let mut sums = [[zero; 3]; 2];
        for state in strips {
            let strip = &state.strip;
            let member = membership(strip.left)[n];
            let own = member * strip.load;
            load += own;
            y += own * strip.y;
            square += own * strip.half_length * strip.half_length;
            limit += member * strip.limit * strip.width;
            for (sums, moments) in sums.iter_mut().zip(&state.moments) {
                for (sum, moment) in sums.iter_mut().zip(moments.each()) {
                    *sum += member * moment;
                }
            }
        }
        // A part that carries nothing is nowhere.
        let per_load = if load > 0.0 { T::from(1.0) / load } else { zero };
        let strip = Strip {
            y: y * per_load,
            half_length: (square * per_load).sqrt(),
            limit,
            load,
            ..strips[0].strip
        };
        Self { strip, moments: sums.map(Moments::of), lacks: [zero; 3] }
    }

    /// Adds the gradients that `moments` of another one cause here.
    fn receive(
        &self,
        gradients: &mut [Four<T>; 2],
        other: &Self,
        moments: &[Moments<T>; 2],
        ratio: &Ratio,
    ) {
        let [own, other] = [&self.strip, &other.strip];
        let distance = (own.y - other.y).abs();
        if distance <= 0.0 || own.load <= 0.0 || other.load <= 0.0 {
            return;
        }
        let square =
            (own.half_length * own.half_length + other.half_length * other.half_length) * 0.5;
        let pair = Influence::shared().narrow::<false, T>(distance, square, ratio);
        if other.y < own.y {
            receive::<false, true, T>(gradients, &pair, moments);
        } else {
            receive::<false, false, T>(gradients, &pair, moments);
        }
    }

    /// Moments of what its marches lack, as a semi-ellipse along it, of the sign of tractions.
    fn lacking(&self) -> [Moments<T>; 2] {
        let a = self.strip.half_length;
        let [x, y, _] = self.lacks;
        [x, y].map(|force| Moments::of([-force, T::from(0.0), -(force * a * a * 0.25)]))
    }
}

impl<T: Real> Zones<T> {
    pub fn new() -> Self {
        Self { zones: FixedVec::new(ROOM) }
    }

    pub fn clear(&mut self) {
        self.zones.clear();
    }
}

impl<T: Real> Zone<T> {
    /// Part number `n`, if there is one: the whole, the left lobe, the right one.
    fn part(&self, n: usize) -> Option<&Part<T>> {
        n.checked_sub(1)
            .map_or(Some(&self.whole), |lobe| self.lobes.as_ref().map(|lobes| &lobes[lobe]))
    }

    fn part_mut(&mut self, n: usize) -> Option<&mut Part<T>> {
        match n.checked_sub(1) {
            None => Some(&mut self.whole),
            Some(lobe) => self.lobes.as_mut().map(|lobes| &mut lobes[lobe]),
        }
    }

    /// All parts.
    fn all_parts(&self) -> impl Iterator<Item = &Part<T>> {
        (0..PARTS).filter_map(|n| self.part(n))
    }

    /// Share of part `n` in the force.
    fn share(&self, n: usize) -> T {
        if n == 0 { -self.given.apart + 1.0 } else { self.given.apart }
    }

    /// The parts that have a share, with their numbers.
    fn loaded_parts(&self) -> impl Iterator<Item = (usize, &LoadedPart<T>, &Part<T>)> {
        let parts = self.given.parts.iter().enumerate();
        parts.filter_map(|(n, loaded)| Some((n, loaded.as_ref()?, self.part(n)?)))
    }
}

impl<T: Tabulated> Zones<T> {
    /// Takes `zones` whose strips are `states`, in their order.
    pub fn take(&mut self, states: &[State<T>], zones: impl Iterator<Item = ZoneParts<T>>) {
        self.zones.clear();
        let mut further = states;
        for given in zones {
            let (own, others) = further.split_at(given.count);
            further = others;
            if own.is_empty() {
                continue;
            }
            let lobes = (given.apart > 0.0).then(|| [Part::of(own, 1), Part::of(own, 2)]);
            self.zones.push(Zone { given, whole: Part::of(own, 0), lobes });
        }
    }

    /// Finds what the marches lack in the creepages that are felt, by the `table`, and gives the
    /// strips the gradients that this causes in other parts.
    pub fn feel(
        &mut self,
        states: &mut [State<T>],
        ratio: &Ratio,
        poisson_ratio: f64,
        table: &impl ForceTable,
    ) {
        for z in 0..self.zones.len() {
            for n in 0..PARTS {
                let zone = &self.zones[z];
                let (Some(loaded), Some(own)) = (&zone.given.parts[n], zone.part(n)) else {
                    continue;
                };
                let mut gradients = [[T::from(0.0); 4]; 2];
                for Zone { whole, .. } in self.beside(z) {
                    own.receive(&mut gradients, whole, &whole.moments, ratio);
                }
                if let Some(other) = opposite(n).and_then(|other| zone.part(other)) {
                    own.receive(&mut gradients, other, &other.moments, ratio);
                }
                let creepage = add(&loaded.creepage, &own.strip.felt(&gradients));
                let limit = zone.given.limit * loaded.share * loaded.friction;
                let modulus = own.strip.shear_modulus;
                let lacks =
                    loaded.ellipse.tabulated(table, poisson_ratio, modulus, &creepage, limit);
                let share = zone.share(n);
                if let Some(part) = self.zones[z].part_mut(n) {
                    part.lacks = lacks.force.map(|force| share * force);
                }
            }
        }
        let mut further = states;
        for (z, zone) in self.zones.iter().enumerate() {
            let (own, others) = further.split_at_mut(zone.given.count);
            further = others;
            for n in 0..PARTS {
                let Some(part) = zone.part(n) else { continue };
                let mut gradients = [[T::from(0.0); 4]; 2];
                let mut feel = |other: &Part<T>| {
                    part.receive(&mut gradients, other, &other.lacking(), ratio);
                };
                match opposite(n) {
                    Some(other) => zone.part(other).map_or((), &mut feel),
                    None if self.zones.len() < 2 => continue,
                    None => self.beside(z).flat_map(Zone::all_parts).for_each(feel),
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

    /// The zones beside number `z`.
    fn beside(&self, z: usize) -> impl Iterator<Item = &Zone<T>> {
        let others = self.zones.iter().enumerate().filter(move |(other, _)| *other != z);
        others.map(|(_, zone)| zone)
    }

    /// Adds what the marches lack to the tractions of the strips, in proportion to their loads and
    /// within what friction holds of each part.
    pub fn spread(&self, states: &mut [State<T>]) {
        let mut further = states;
        for zone in self.zones.iter() {
            let (own, others) = further.split_at_mut(zone.given.count);
            further = others;
            for (n, loaded, part) in zone.loaded_parts() {
                // Friction may act on other strips alone.
                if part.strip.load <= 0.0 {
                    continue;
                }
                let share = zone.share(n);
                let limit = zone.given.limit * loaded.share * loaded.friction * share;
                let [mut x, mut y] = [T::from(0.0); 2];
                for state in own.iter() {
                    let member = share * membership(state.strip.left)[n];
                    let [[along, _], [across, _]] = state.marched();
                    (x, y) = (x - member * along, y - member * across);
                }
                let [mut lacks_x, mut lacks_y, moment] = part.lacks;
                let whole = [x + lacks_x, y + lacks_y];
                let magnitude = whole[0].hypot(whole[1]);
                if magnitude > limit {
                    let ratio = limit / magnitude;
                    (lacks_x, lacks_y) = (ratio * whole[0] - x, ratio * whole[1] - y);
                }
                let per_load = T::from(1.0) / part.strip.load;
                for state in own.iter_mut() {
                    let of_part = membership(state.strip.left)[n] * state.strip.load * per_load;
                    let [[along, _], [across, turning]] = &mut state.resultant.moments;
                    *along -= of_part * lacks_x;
                    *across -= of_part * lacks_y;
                    *turning -= of_part * moment;
                }
            }
        }
    }
}

/// The other lobe.
fn opposite(n: usize) -> Option<usize> {
    (n > 0).then(|| PARTS - n)
}

/// Sum of two creepages.
fn add<T: Real>(first: &Creepage<T>, second: &Creepage<T>) -> Creepage<T> {
    Creepage {
        longitudinal: first.longitudinal + second.longitudinal,
        lateral: first.lateral + second.lateral,
        spin: first.spin + second.spin,
    }
}
