//! The probes of one interval of penetration: where it is split into contacts, and where each of
//! them is.

use super::sample::Sample;

/// Patches are split where neighbouring normals differ by more [rad].
const MAX_ANGLE: f64 = std::f64::consts::FRAC_PI_6;

/// A probe of an interval and what it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct IntervalProbe {
    pub sample: Sample,
    pub kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Step,
    Minimum,
    Maximum,
}

/// The probe at which the contact that starts at probe `first` ends: the last one or a ridge to
/// split at.
pub(super) fn last_of_group(interval: &[IntervalProbe], first: usize) -> usize {
    let mut minimum: Option<usize> = None;
    let mut ridge = first;
    for i in first + 1..interval.len() {
        let probe = &interval[i];
        if probe.sample.distance >= interval[ridge].sample.distance || minimum.is_none() {
            ridge = i;
        }
        if probe.kind == Kind::Minimum {
            if let Some(before) = minimum {
                let [a, b] = [before, i].map(|k| interval[k].sample.rail_tangent);
                let cosine = a[0] * b[0] + a[1] * b[1];
                if cosine < MAX_ANGLE.cos() && ridge > first && ridge < i {
                    return ridge;
                }
            }
            minimum = Some(i);
            ridge = i;
        }
    }
    interval.len() - 1
}

/// The place of the contact with these probes.
pub(super) fn deepest(group: &[IntervalProbe]) -> Sample {
    // Where a body ends inside the interval there may be no minimum: the deepest probe then stands
    // for it.
    let (mut deepest, mut lowest) = (&group[0].sample, None::<&Sample>);
    for IntervalProbe { sample, kind } in group {
        if sample.distance < deepest.distance {
            deepest = sample;
        }
        let is_lower = lowest.is_none_or(|lowest| sample.distance < lowest.distance);
        if *kind == Kind::Minimum && is_lower {
            lowest = Some(sample);
        }
    }
    match lowest {
        Some(lowest) if lowest.distance <= 0.5 * deepest.distance => *lowest,
        _ => *deepest,
    }
}
