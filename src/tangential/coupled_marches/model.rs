//! The coupled marches as a tangential model.

use std::f64::consts::FRAC_PI_2;
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::differences::Differences;
use super::solver::{DIRECTIONS, Solver};
use super::state::{Resultant, Strip};
use crate::kinematics::creepage::Creepage;
use crate::math::dual::Dual;
use crate::math::real::Real;
use crate::math::tape::Taped;
use crate::tangential::boundary_element::LoadedElements;
use crate::tangential::convergence::Convergence;
use crate::tangential::creep_number::CreepNumber;
use crate::tangential::ellipse_force::{part_force, spread_parts};
use crate::tangential::equivalent_ellipse::LoadedPart;
use crate::tangential::field::ContactField;
use crate::tangential::forces::{CreepForce, StripForce};
use crate::tangential::loaded_zone::LoadedZone;
use crate::tangential::neck::Lobes;
use crate::tangential::rigid_slip::RigidSlip;
use crate::tangential::rolling::Rolling;
use crate::tangential::zone_model::{RollingZone, ZoneModel};

/// Solvers in plain numbers and with derivatives.
#[derive(Clone, Debug)]
pub struct Memory {
    pub(super) plain: Solver,
    pub(super) moving: Solver<Dual<DIRECTIONS>>,
    /// For derivatives backwards, once they have been asked for.
    taped: Option<Box<Solver<Taped>>>,
}

/// The model, with memory that one contact at a time has; another one that comes while it is in use
/// waits.
#[derive(Debug)]
pub struct CoupledMarches {
    memory: Mutex<Box<Memory>>,
    /// What is missing on ellipses.
    differences: &'static Differences,
}

impl Clone for CoupledMarches {
    fn clone(&self) -> Self {
        Self { memory: Mutex::new(self.lend().clone()), differences: self.differences }
    }
}

impl CoupledMarches {
    /// For zones of up to `strips` strips; larger ones allocate.
    #[must_use]
    pub fn new(strips: usize) -> Self {
        let memory =
            Memory { plain: Solver::new(strips), moving: Solver::new(strips), taped: None };
        Self { memory: Mutex::new(Box::new(memory)), differences: Differences::shared() }
    }

    /// The memory. One left in the middle of a solution counts as not solved.
    fn lend(&self) -> MutexGuard<'_, Box<Memory>> {
        self.memory.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Strips with which solutions are found.
pub trait MarchNumber: Real {
    /// Solves for `strips` and hands the number of each and its tractions to `each`, which adds them
    /// up: a strip may come twice.
    fn march_strips(
        memory: &mut Memory,
        strips: impl Iterator<Item = Strip<Self>> + Clone,
        poisson_ratio: f64,
        shear_modulus: Self,
        each: impl FnMut(usize, &Resultant<Self>),
    );
}

impl MarchNumber for f64 {
    fn march_strips(
        memory: &mut Memory,
        strips: impl Iterator<Item = Strip> + Clone,
        poisson_ratio: f64,
        shear_modulus: f64,
        mut each: impl FnMut(usize, &Resultant),
    ) {
        let solver = &mut memory.plain;
        if !solver.is_solved(strips.clone(), poisson_ratio, shear_modulus) {
            solver.take(strips);
            solver.solve(poisson_ratio, shear_modulus);
        }
        for (j, resultant) in memory.plain.resultants().enumerate() {
            each(j, resultant);
        }
    }
}

impl<const N: usize> MarchNumber for Dual<N> {
    fn march_strips(
        memory: &mut Memory,
        strips: impl Iterator<Item = Strip<Self>> + Clone,
        poisson_ratio: f64,
        shear_modulus: Self,
        mut each: impl FnMut(usize, &Resultant<Self>),
    ) {
        for start in (0..N).step_by(DIRECTIONS) {
            let count = (N - start).min(DIRECTIONS);
            let few = |x: Self| {
                let mut slopes = [0.0; DIRECTIONS];
                slopes[..count].copy_from_slice(&x.slopes[start..start + count]);
                Dual { value: x.value, slopes }
            };
            let back = |x: Dual<DIRECTIONS>| {
                let mut number = Self::from(if start == 0 { x.value } else { 0.0 });
                number.slopes[start..start + count].copy_from_slice(&x.slopes[..count]);
                number
            };
            memory.moving.take(strips.clone().map(|strip| strip.map(few)));
            memory.moving.solve(poisson_ratio, few(shear_modulus));
            for (j, resultant) in memory.moving.resultants().enumerate() {
                let slip_share = if start == 0 { resultant.slip_share } else { 0.0 };
                let moments = resultant.moments.map(|moments| moments.map(back));
                each(j, &Resultant { moments, slip_share });
            }
        }
    }
}

impl MarchNumber for Taped {
    fn march_strips(
        memory: &mut Memory,
        strips: impl Iterator<Item = Strip<Self>> + Clone,
        poisson_ratio: f64,
        shear_modulus: Self,
        mut each: impl FnMut(usize, &Resultant<Self>),
    ) {
        let most = memory.plain.most_strips();
        let solver = memory.taped.get_or_insert_with(|| Box::new(Solver::new(most)));
        solver.take(strips);
        solver.solve(poisson_ratio, shear_modulus);
        for (j, resultant) in solver.resultants().enumerate() {
            each(j, resultant);
        }
    }
}

impl<T: Real> Strip<T> {
    /// The same in other numbers.
    fn map<O: Real>(&self, to: impl Fn(T) -> O) -> Strip<O> {
        let Creepage { longitudinal, lateral, spin } = self.creepage;
        Strip {
            y: to(self.y),
            half_length: to(self.half_length),
            width: to(self.width),
            limit: to(self.limit),
            creepage: Creepage {
                longitudinal: to(longitudinal),
                lateral: to(lateral),
                spin: to(spin),
            },
        }
    }
}

impl<T: CreepNumber> ZoneModel<T> for CoupledMarches {
    fn strip_forces(
        &self,
        zone: &RollingZone<'_, impl RigidSlip<T>, T>,
        each: &mut dyn FnMut(usize, StripForce<T>),
    ) -> Convergence {
        let loaded = &zone.loaded;
        let (of, strips) = (loaded.zone, loaded.strips);
        let lobes = Lobes::of(loaded);
        let neck = lobes.map(|lobes| lobes.neck);
        let apart = neck.map_or(T::from(0.0), |neck| neck.share);
        let mut marched = [CreepForce::<T>::default(); 3];
        let members = members(loaded);
        for (rolling, share) in zone.directions() {
            let strip = |j| strip(loaded, rolling, j);
            let material = loaded.material;
            let mut next = members.clone();
            T::march_strips(
                &mut self.lend(),
                members.clone().map(strip),
                material.poisson_ratio,
                material.shear_modulus,
                |n, found| {
                    if n == 0 {
                        next = members.clone();
                    }
                    let Some(j) = next.next() else { return };
                    if !(of.first..of.first + of.count).contains(&j) {
                        return;
                    }
                    let area = strips.half_length[j] * strips.width[j];
                    let force = force(found, rolling, area).times(share);
                    if let Some(neck) = neck {
                        let left = neck.left(strips.y[j]);
                        let parts = [-apart + 1.0, apart * left, apart * (-left + 1.0)];
                        for (marched, part) in marched.iter_mut().zip(parts) {
                            marched.add(of, strips, j, &force.times(part));
                        }
                    } else {
                        marched[0].add(of, strips, j, &force);
                    }
                    each(j, force);
                },
            );
        }
        let correction = |n: usize, part: &LoadedPart<T>, weight: T| {
            let mut force = part_force(zone, part, weight, |ellipse, area| {
                ellipse.tabulated_force(self.differences, area)
            });
            force.keep_within(zone.limit * part.share * part.friction * weight, &marched[n]);
            force
        };
        spread_parts(zone, lobes.as_ref(), correction, each);
        Convergence::default()
    }
}

impl CoupledMarches {
    /// Enters the tractions of a zone that rolls forward into `field`, whose grid is that of
    /// `elements`: shares of the bound of a cell there, of that of the pressure here.
    pub(in super::super) fn draw(
        &self,
        RollingZone { loaded, .. }: &RollingZone<'_, impl RigidSlip>,
        elements: &LoadedElements,
        field: &mut ContactField,
    ) {
        let strips = loaded.strips;
        let mut memory = self.lend();
        let members = members(loaded);
        let strip = |j| strip(loaded, Rolling::Forward, j);
        memory.plain.take(members.clone().map(strip));
        let material = loaded.material;
        let cells = memory.plain.tractions(material.poisson_ratio, material.shear_modulus);
        let numbers: Vec<usize> = members.collect();
        for (row, strip) in elements.rows_of(loaded.zone) {
            let Some(marched) = numbers.iter().position(|&j| j == strip) else { continue };
            let own = &cells[marched];
            for i in 0..field.grid.along {
                let pressure = field.pressure[row * field.grid.along + i];
                let t = (strips.x[strip] - field.grid.x(i)) / strips.half_length[strip];
                let cell = (0.5 * (1.0 + t) * own.len() as f64).max(0.0) as usize;
                let (share, slips) = own[cell.min(own.len() - 1)];
                let bound = loaded.friction_coefficient(strip) * pressure;
                field.enter(row, i, share.map(|share| -share * bound), slips);
            }
        }
    }
}

/// The strips of all zones of the contact frame that take part, in growing y.
fn members<'a, T: Real>(
    loaded: &'a LoadedZone<'_, impl RigidSlip<T>, T>,
) -> impl Iterator<Item = usize> + Clone + 'a {
    let (own, all) = (loaded.zone, &loaded.strips.zones);
    let before = all.iter().filter(|other| other.first < own.first);
    let behind = all.iter().filter(|other| other.first > own.first);
    before.chain([own]).chain(behind).flat_map(|zone| {
        let numbers = zone.first..zone.first + zone.count;
        numbers.filter(|&j| is_loaded(loaded, j))
    })
}

/// Strip `j` as one that rolls forward.
fn strip<T: Real>(
    loaded: &LoadedZone<'_, impl RigidSlip<T>, T>,
    rolling: Rolling,
    j: usize,
) -> Strip<T> {
    let strips = loaded.strips;
    let own = loaded.slip.creepage(j);
    // Backwards the strip is the same seen in a mirror along x.
    let direction = rolling.direction();
    let load = strips.pressure[j] * strips.half_length[j] * FRAC_PI_2;
    Strip {
        y: strips.y[j],
        half_length: strips.half_length[j],
        width: strips.width[j],
        limit: loaded.friction_coefficient(j) * load,
        creepage: Creepage {
            longitudinal: own.longitudinal * direction,
            lateral: own.lateral,
            spin: own.spin * direction,
        },
    }
}

/// Whether strip `j` carries load that friction acts on.
fn is_loaded<T: Real>(loaded: &LoadedZone<'_, impl RigidSlip<T>, T>, j: usize) -> bool {
    let strips = loaded.strips;
    strips.half_length[j] > 0.0
        && strips.width[j] > 0.0
        && loaded.friction_coefficient(j) * strips.pressure[j] > 0.0
}

/// Force on the wheel of a strip of half length times width `area`.
fn force<T: Real>(found: &Resultant<T>, rolling: Rolling, area: T) -> StripForce<T> {
    let [[x, _], [y, moment]] = found.moments;
    let mirrored = -rolling.direction();
    StripForce {
        longitudinal: x * mirrored,
        lateral: -y,
        moment: moment * mirrored,
        slip_area: area * (2.0 * found.slip_share),
    }
}
