//! The strip model on a wheel and a rail: all places where they overlap are one problem.
//!
//! The overlap is taken along the local normal, the distance of the contact line from the nearest
//! point of the rail, and the coordinate across is the arc along the rail. No contact frame is
//! chosen beforehand, so that nothing changes over when another place becomes the deepest, or when
//! overlaps join or part. Each loaded zone then gets its frame from its own load.

use super::local_line::{LocalLine, whole_strip};
use super::local_place::LocalPlace;
use super::strip_damping::StripDamping;
use super::taken_zone::{TakenZone, deepest_within, of_last_zone, zone_in_frame};
use crate::element::contact::contact_setup::{ContactSetup, Damped, rail_speeds};
use crate::element::contact::models::Models;
use crate::element::output::Output;
use crate::element::work::Work;
use crate::geometry::contacts::contact::Contact;
use crate::geometry::contacts::contact_search::ContactSearch;
use crate::geometry::contacts::line_separation::LineSeparation;
use crate::geometry::contacts::separation::Probe;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::rail_outline::RailOutline;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::normal::Descent;

/// Depth up to which strips are pressed [m]: beyond, at a hundred times the load of a wheel,
/// normals of a gauge corner have crossed, and the strips of a virtual penetration carry on.
pub(in crate::element) const MAX_STRIP_DEPTH: f64 = 1e-2;

/// Solves for all zones of one rail into `models.rail_strips`; returns how many found no room.
pub fn solve(
    line: &ContactLine,
    rail: &PlacedRail,
    search: &ContactSearch,
    probes: &mut Vec<Probe>,
    models: &mut Models,
) -> usize {
    take_probes(search, probes);
    let Models { strip_solver, rail_strips, material, descent, .. } = models;
    rail_strips.clear();
    let mut local = LocalLine::of(line, rail, search);
    let modulus = material.contact_modulus;
    strip_solver.as_mut().map_or(0, |solver| {
        solver.solve(&mut local, probes, 0.0, modulus, descent.as_mut(), rail_strips)
    })
}

/// Takes `descent` about to where the strips of one rail would have its force.
pub fn guess(
    line: &ContactLine,
    rail: &PlacedRail,
    search: &ContactSearch,
    probes: &mut Vec<Probe>,
    models: &mut Models,
    descent: &mut Descent,
) {
    take_probes(search, probes);
    let mut local = LocalLine::of(line, rail, search);
    if let Some(solver) = &mut models.strip_solver {
        solver.guess(&mut local, probes, models.material.contact_modulus, descent);
    }
}

/// Puts the distances that the `search` has found along the contacts of a rail into `probes`.
fn take_probes(search: &ContactSearch, probes: &mut Vec<Probe>) {
    probes.clear();
    for contact in search.contacts.iter() {
        let own = &search.probes[contact.probes[0]..contact.probes[1]];
        for probe in own {
            // Contacts that were split at a ridge share it.
            let known = probes.last().is_some_and(|last| last.u >= probe.u);
            if !known && probes.len() < probes.capacity() {
                probes.push(Probe { u: probe.u, f: probe.f - contact.penetration });
            }
        }
    }
}

/// Adds the forces of all zones of one rail to `output`, each as a contact of `forces`; returns how
/// many zones found no room or fell back to a simpler model.
pub fn add<'a>(
    search: &ContactSearch,
    probes: &mut Vec<Probe>,
    forces: &impl Fn(Contact, Damped<f64>) -> ContactSetup<'a>,
    models: &mut Models,
    output: &mut Output,
    work: &mut Work,
) -> u64 {
    let Some(&first) = search.contacts.first() else { return 0 };
    let of_rail = forces(first, Damped::Alone);
    let ContactSetup { input, line, rail, frame, .. } = &of_rail;
    let placed = rail.rail;
    if let Some(descent) = &mut models.descent {
        descent.down = frame.down();
        descent.rails += 1;
    }
    let mut left_out = solve(line, placed, search, probes, models) as u64;
    output.normal_residual = output.normal_residual.max(models.normal_residual());
    let damping = StripDamping {
        motion: &of_rail.motion(),
        frame,
        whole: whole(models, search),
        speeds: rail_speeds(input, of_rail.k, placed, frame),
        around: Some(line).filter(|line| line.varies_around()),
    };
    // Strips of all zones feel each other.
    models.strips.clear();
    models.rolling.clear();
    let setup = |TakenZone { contact, load_factor, resultant_share, ahead }| ContactSetup {
        resultant_share,
        ahead: Some(ahead),
        ..forces(contact, Damped::By(load_factor))
    };
    for zone in 0..models.rail_strips.zones.len() {
        let taken = take_zone(line, placed, search, zone, &damping, models);
        let separation = LineSeparation::new(line, placed, taken.contact);
        setup(taken).lay(&separation, models, zone);
    }
    left_out += models.roll(output, work);
    for n in 0..models.rolling.zones.len() {
        let taken = TakenZone::of(&models.rolling.zones[n]);
        let mut separation = LineSeparation::new(line, placed, taken.contact);
        setup(taken).add_laid(n..n + 1, &mut separation, models, output);
    }
    left_out
}

/// Load of all zones and deepest penetration of all contacts [N, m].
fn whole(models: &Models, search: &ContactSearch) -> [f64; 2] {
    let deepest = search.contacts.iter().map(|c| c.penetration).fold(0.0, f64::max);
    [models.rail_strips.load(), deepest]
}

/// Adds zone number `index` of the rail to `models.strips`, with its `damping`, in a frame of its
/// own: through the centroid of its load, its normal along the resultant.
fn take_zone(
    line: &ContactLine,
    rail: &PlacedRail,
    search: &ContactSearch,
    index: usize,
    damping: &StripDamping,
    models: &mut Models,
) -> TakenZone {
    let (local, outline) = (LocalLine::of(line, rail, search), RailOutline::at_rest(rail));
    let place = |[u, y]: [f64; 2]| {
        let at = line.at(u);
        let strip = local.on_rail(whole_strip(at, &outline, [u, y]));
        let own = LocalPlace::of(&at, &strip, local.over_waves(&strip).as_ref(), outline.along(y));
        // Of a round wheel.
        LocalPlace { ahead: own.ahead + line.ahead_of_round(u), ..own }
    };
    let taken = zone_in_frame(index, damping, models, place);
    let deepest = deepest_within(search, of_last_zone(&models.strips));
    let deepest = deepest.map_or(0.0, |contact| contact.penetration);
    let penetration = taken.contact.penetration.max(deepest);
    TakenZone { contact: Contact { penetration, ..taken.contact }, ..taken }
}
