//! The coupled marches as a tangential model.

use std::f64::consts::FRAC_PI_2;

use super::parts::ZoneParts;
use super::solvers::CoupledMarches;
use super::state::{Resultant, Strip};
use crate::kinematics::creepage::Creepage;
use crate::math::real::Real;
use crate::tangential::boundary_element::LoadedElements;
use crate::tangential::convergence::Convergence;
use crate::tangential::creep_number::CreepNumber;
use crate::tangential::equivalent_ellipse::LoadedPart;
use crate::tangential::field::ContactField;
use crate::tangential::forces::StripForce;
use crate::tangential::loaded_zone::LoadedZone;
use crate::tangential::lobes::Lobes;
use crate::tangential::neck::Neck;
use crate::tangential::rolling::Rolling;
use crate::tangential::zone_model::RollingZone;

impl CoupledMarches {
    /// Hands the force on the wheel of each strip of `zones`, which come with their numbers in the
    /// order of their places across, to `each`, which adds them up: with the number of the zone and
    /// that of the strip, which may come twice. Allocates nothing.
    pub fn roll<'a, T: CreepNumber>(
        &mut self,
        zones: &(impl Iterator<Item = (usize, RollingZone<'a, T>)> + Clone),
        mut each: impl FnMut(usize, usize, StripForce<T>),
    ) -> Convergence {
        let Some((_, any)) = zones.clone().next() else { return Convergence::default() };
        let poisson_ratio = any.loaded.material.poisson_ratio;
        for rolling in [Rolling::Forward, Rolling::Backward] {
            if zones.clone().all(|(_, zone)| zone.share(rolling) <= 0.0) {
                continue;
            }
            let with_strips = zones.clone().map(|(_, zone)| {
                let lobes = Lobes::of(&zone.loaded);
                let neck = lobes.map(|lobes| lobes.neck);
                let strips = members(zone.loaded);
                let strips = strips.map(move |j| strip(&zone, neck.as_ref(), rolling, j));
                (parts(&zone, lobes.as_ref(), rolling), strips)
            });
            T::march_strips(self, with_strips, poisson_ratio, |found| {
                for (n, zone) in zones.clone() {
                    let (loaded, share) = (&zone.loaded, zone.share(rolling));
                    for (j, resultant) in members(*loaded).zip(&mut *found) {
                        let area = loaded.strips.half_length[j] * loaded.strips.width[j];
                        each(n, j, force(&resultant, rolling, area).times(share));
                    }
                }
            });
        }
        Convergence::default()
    }

    /// Enters the tractions of a zone that rolls forward into `field`, whose grid is that of
    /// `elements`: shares of the bound of a cell there, of that of the pressure here.
    pub(in super::super) fn draw(
        &mut self,
        zone: &RollingZone<'_>,
        elements: &LoadedElements,
        field: &mut ContactField,
    ) {
        let loaded = &zone.loaded;
        let strips = loaded.strips;
        self.plain.take(members(*loaded).map(|j| strip(zone, None, Rolling::Forward, j)));
        let cells = self.plain.tractions(loaded.material.poisson_ratio);
        let numbers: Vec<usize> = members(*loaded).collect();
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

/// The strips of a zone that carry load on which friction acts.
fn members<T: Real>(loaded: LoadedZone<'_, T>) -> impl Iterator<Item = usize> + Clone + '_ {
    let zone = loaded.zone;
    zone.range().filter(move |&j| {
        let strips = loaded.strips;
        strips.half_length[j] > 0.0
            && strips.width[j] > 0.0
            && loaded.friction_coefficient(j) * strips.pressure[j] > 0.0
    })
}

/// Strip `j` of a zone with this `neck` as one that rolls forward.
fn strip<T: Real>(
    RollingZone { loaded, origin, .. }: &RollingZone<'_, T>,
    neck: Option<&Neck<T>>,
    rolling: Rolling,
    j: usize,
) -> Strip<T> {
    let strips = loaded.strips;
    let load = strips.pressure[j] * strips.half_length[j] * FRAC_PI_2;
    Strip {
        y: *origin + strips.y[j],
        half_length: strips.half_length[j],
        width: strips.width[j],
        limit: loaded.friction_coefficient(j) * load,
        shear_modulus: loaded.material.shear_modulus,
        creepage: forward(&loaded.slip.creepage(j), rolling),
        load: load * strips.width[j],
        left: neck.map_or(T::from(1.0), |neck| neck.left(strips.y[j])),
    }
}

/// The parts of a zone with these `lobes` as one that rolls forward.
fn parts<T: Real>(
    zone: &RollingZone<'_, T>,
    lobes: Option<&Lobes<T>>,
    rolling: Rolling,
) -> ZoneParts<T> {
    let loaded = &zone.loaded;
    let apart = lobes.map_or(T::from(0.0), |lobes| lobes.neck.share);
    let [left, right] = lobes.map_or([None; 2], |lobes| lobes.parts);
    let whole =
        (apart < 1.0).then(|| LoadedPart::whole(loaded.zone, loaded.strips, zone.state.creepage));
    let forward =
        |part: LoadedPart<T>| LoadedPart { creepage: forward(&part.creepage, rolling), ..part };
    ZoneParts {
        limit: zone.limit,
        apart,
        parts: [whole, left, right].map(|part| part.map(forward)),
    }
}

/// A creepage as one that rolls forward: backwards the strip is the same seen in a mirror along x.
fn forward<T: Real>(creepage: &Creepage<T>, rolling: Rolling) -> Creepage<T> {
    let direction = rolling.direction();
    Creepage {
        longitudinal: creepage.longitudinal * direction,
        lateral: creepage.lateral,
        spin: creepage.spin * direction,
    }
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
