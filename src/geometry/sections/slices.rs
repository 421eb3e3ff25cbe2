//! A rail whose section varies along the track, or a wheel whose section varies around, as slices:
//! what files hold.
//!
//! Rows run along the rail through points of equal shares of the slices, from feature to feature
//! where there are features: paths that do not cross an edge. Along each row the point, and how it
//! changes across, are cubic splines over the places of the slices.

mod approximating_spline;

use std::f64::consts::TAU;
use std::mem::discriminant;

use crate::geometry::profiles::profile::{Profile, ProfileRemark};
use crate::math::real::Real;
use crate::math::spline::{SplineEnd, interpolating_slopes};
use approximating_spline::near;

/// One section and where it is.
#[derive(Clone, Debug)]
pub struct Slice {
    /// Station [m]; of a wheel the angle [rad].
    pub place: f64,
    /// The section.
    pub profile: Profile,
    /// Lengths from its beginning to its features [m]; nothing for a feature that is not there.
    /// Empty where there are none at all.
    pub features: Vec<Option<f64>>,
}

/// The slices of a rail or a wheel, in growing places.
#[derive(Clone, Debug)]
pub struct Slices {
    /// The file, for messages.
    pub name: String,
    /// Two or more of them.
    all: Vec<Slice>,
    /// Whether the surface passes near the slices and not through them.
    passes_near: bool,
}

/// A point of a row and how it changes across, per unit of the row parameter.
pub(in crate::geometry) type RowValue = [f64; 4];

/// Value of a row at a slice and its derivative along the body.
#[derive(Clone, Copy, Debug)]
pub(in crate::geometry) struct RowKnot {
    pub value: RowValue,
    pub slope: RowValue,
}

/// Rows along a body.
#[derive(Clone, Debug)]
pub(in crate::geometry) struct Rows {
    /// Places of the slices.
    pub places: Vec<f64>,
    /// Row parameter of each row: arc of the section with the most points [m].
    pub parameter: Vec<f64>,
    /// Point and derivative of that section at each row.
    pub pattern: Vec<RowValue>,
    /// Part to which each row belongs; one at a feature belongs to the part before.
    pub parts: Vec<usize>,
    /// By slices, and rows within each: first and last slice of the run of slices over which the
    /// row is there without a break; nothing where it is not.
    pub runs: Vec<Option<[u32; 2]>>,
    /// By slices, and rows within each slice.
    pub knots: Vec<RowKnot>,
}

impl Rows {
    /// Whether they are the same at all slices.
    pub fn are_straight(&self) -> bool {
        let count = self.parameter.len();
        let same = |j: usize, knot: &RowKnot| {
            let pairs = self.knots[j].value.iter().zip(&knot.value);
            pairs.chain(knot.slope.iter().zip(&[0.0; 4])).all(|(a, b)| (a - b).abs() <= 0.0)
        };
        self.knots
            .chunks(count)
            .all(|slice| slice.iter().enumerate().all(|(j, knot)| same(j, knot)))
    }
}

/// A part between two features: rows between them, and over which slices it is there.
struct Part {
    span: [usize; 2],
    /// The slice with the most points on it.
    pattern: usize,
}

impl Slices {
    /// Slices in growing places.
    ///
    /// # Errors
    /// In words what cannot be made a surface.
    pub fn new(name: &str, slices: Vec<Slice>, passes_near: bool) -> Result<Self, String> {
        let found = Self { name: name.into(), all: slices, passes_near };
        found.parts()?;
        Ok(found)
    }

    /// The same `profile` at two places [m].
    pub fn even(profile: &Profile, places: [f64; 2]) -> Self {
        let all =
            places.map(|place| Slice { place, profile: profile.clone(), features: Vec::new() });
        Self { name: profile.name.clone(), all: all.into(), passes_near: false }
    }

    /// The slices.
    pub fn slices(&self) -> &[Slice] {
        &self.all
    }

    /// The first profile, which the body stands by, with what was found wrong and mended in any of
    /// them.
    pub fn first_profile(&self) -> Profile {
        let mut profile = self.all[0].profile.clone();
        let rest = profile.remarks.iter().filter(|remark| !remark.is_warning()).cloned();
        let mut remarks: Vec<ProfileRemark> = rest.collect();
        let mut found: Vec<&ProfileRemark> = Vec::new();
        for remark in self.all.iter().flat_map(|slice| &slice.profile.remarks) {
            if remark.is_warning() && !found.contains(&remark) {
                found.push(remark);
            }
        }
        // One line for each kind, however many sections have it.
        while let Some(&first) = found.first() {
            let before = found.len();
            found.retain(|other| discriminant(*other) != discriminant(first));
            remarks.push(match before - found.len() - 1 {
                0 => first.clone(),
                others => ProfileRemark::Repeated { first: Box::new(first.clone()), others },
            });
        }
        profile.remarks = remarks;
        profile
    }

    /// First and last place.
    pub fn range(&self) -> [f64; 2] {
        [self.all[0].place, self.all[self.all.len() - 1].place]
    }

    /// The slices of a wheel over the angle [rad], with those that follow beyond either end if they
    /// go all around.
    pub(in crate::geometry) fn around(&self) -> Self {
        let [first, last] = self.range();
        let widest = self.all.windows(2).map(|pair| pair[1].place - pair[0].place);
        let widest = widest.fold(0.0, f64::max);
        let is_broken = |slice: &Slice| slice.features.iter().any(Option::is_none);
        if first + TAU - last > CLOSED * widest || self.all.iter().any(is_broken) {
            return self.clone();
        }
        let moved = |slice: &Slice, by: f64| Slice { place: slice.place + by, ..slice.clone() };
        let before = self.all.iter().map(|slice| moved(slice, -TAU));
        let mut before: Vec<Slice> = before.filter(|s| s.place < first - OVERLAP).collect();
        let behind = self.all.iter().map(|slice| moved(slice, TAU));
        let behind = behind.filter(|s| s.place > last + OVERLAP).take(FOLLOWING);
        before.drain(..before.len().saturating_sub(FOLLOWING));
        let all = before.into_iter().chain(self.all.iter().cloned()).chain(behind).collect();
        Self { all, ..self.clone() }
    }

    /// The same with places `scale` times as large.
    #[must_use]
    pub(in crate::geometry) fn over_places(mut self, scale: f64) -> Self {
        self.all.iter_mut().for_each(|slice| slice.place *= scale);
        self
    }

    /// Lengths of the features of a slice as parameters of its curve; its ends where it has none.
    fn features(slice: &Slice) -> Vec<Option<f64>> {
        let (start, end) = (slice.profile.curve.start(), slice.profile.curve.end());
        if slice.features.is_empty() {
            return vec![Some(start), Some(end)];
        }
        slice.features.iter().map(|f| f.map(|length| (start + length).min(end))).collect()
    }

    fn parts(&self) -> Result<Vec<Part>, String> {
        let features: Vec<Vec<Option<f64>>> = self.all.iter().map(Self::features).collect();
        let count = features[0].len();
        let mut parts = Vec::new();
        for f in 0..count - 1 {
            let is_there = |i: usize| features[i][f].is_some() && features[i][f + 1].is_some();
            let own: Vec<usize> = (0..features.len()).filter(|&i| is_there(i)).collect();
            let (Some(&first), Some(&last)) = (own.first(), own.last()) else {
                return Err(format!(
                    "no slice has both features {} and {}; leave one out",
                    f + 1,
                    f + 2
                ));
            };
            if last - first + 1 != own.len() {
                return Err(format!(
                    "the part between features {} and {} ends and begins again; give it features of its own behind the gap",
                    f + 1,
                    f + 2
                ));
            }
            if first == last {
                return Err(format!(
                    "the part between features {} and {} is on one slice only; give it two slices or more",
                    f + 1,
                    f + 2
                ));
            }
            let mut pattern = (0, first);
            for &i in &own {
                let [from, to] = [f, f + 1].map(|f| features[i][f].unwrap_or_default());
                if to - from <= 0.0 {
                    return Err(format!(
                        "feature {} of the slice at {} lies beyond its end; give lengths along the slice in mm",
                        f + 1,
                        self.all[i].place
                    ));
                }
                let knots = self.all[i].profile.curve.knots();
                let knots = knots.filter(|s| *s > from && *s < to).count();
                if knots > pattern.0 {
                    pattern = (knots, i);
                }
            }
            parts.push(Part { span: [first, last], pattern: pattern.1 });
        }
        Ok(parts)
    }

    /// The rows, after `point` and `direction` have put each point and each direction where the
    /// body stands.
    pub(in crate::geometry) fn rows(
        &self,
        point: impl Fn([f64; 2]) -> [f64; 2],
        direction: impl Fn([f64; 2]) -> [f64; 2],
    ) -> Rows {
        let features: Vec<Vec<Option<f64>>> = self.all.iter().map(Self::features).collect();
        // Checked when the slices were made.
        let parts = self.parts().unwrap_or_default();
        let places: Vec<f64> = self.all.iter().map(|slice| slice.place).collect();
        let mut rows = Rows {
            places,
            parameter: Vec::new(),
            pattern: Vec::new(),
            parts: Vec::new(),
            runs: Vec::new(),
            knots: Vec::new(),
        };
        // By rows, and slices within each.
        let mut values: Vec<([usize; 2], Vec<RowValue>)> = Vec::new();
        for (f, Part { span, pattern }) in parts.iter().enumerate() {
            let ends = |i: usize| [f, f + 1].map(|f| features[i][f].unwrap_or_default());
            let [from, to] = ends(*pattern);
            let curve = &self.all[*pattern].profile.curve;
            let inner = curve.knots().filter(|s| *s > from && *s < to);
            let knots: Vec<f64> = std::iter::once(from).chain(inner).chain([to]).collect();
            let begin = rows.parameter.last().map_or(from, |last| *last);
            // The row at the pattern's parameter `s` on all slices.
            let row_at = |s: f64| -> Vec<RowValue> {
                let share = (s - from) / (to - from);
                let on_slice = |i: usize| {
                    let [own_from, own_to] = ends(i);
                    // The pattern's own parameter, not a rounded one, also where the part is as long
                    // as there.
                    let is_alike =
                        [own_from, own_to].map(f64::to_bits) == [from, to].map(f64::to_bits);
                    let own = if is_alike { s } else { own_from + share * (own_to - own_from) };
                    let p = self.all[i].profile.curve.at(own);
                    let ([y, z], [dy, dz]) = (point(p.point), direction(p.first));
                    let stretch = (own_to - own_from) / (to - from);
                    [y, z, stretch * dy, stretch * dz]
                };
                (span[0]..=span[1]).map(on_slice).collect()
            };
            let mut between = vec![from];
            for pair in knots.windows(2) {
                divide([pair[0], pair[1]], &row_at, &mut between);
            }
            for (i, s) in between.into_iter().enumerate() {
                let is_seam = f > 0 && i == 0;
                let row = row_at(s);
                let of_pattern = row[pattern - span[0]];
                // Parts that are there together share the row between them.
                let shared = is_seam && parts[f - 1].span == *span;
                if shared {
                    continue;
                }
                let parameter = if f == 0 { s } else { begin + (s - from) };
                rows.parameter.push(if is_seam { parameter + SEAM } else { parameter });
                rows.pattern.push(of_pattern);
                rows.parts.push(f);
                values.push((*span, row));
            }
        }
        let count = values.len();
        let none = RowKnot { value: [f64::NAN; 4], slope: [0.0; 4] };
        rows.knots = vec![none; count * rows.places.len()];
        rows.runs = vec![None; rows.knots.len()];
        let broken: Vec<Vec<bool>> =
            (0..parts.len()).map(|part| breaks(&rows, part, &values)).collect();
        for (j, ([first, _], row)) in values.iter().enumerate() {
            let mut begin = 0;
            while begin < row.len() {
                let is_broken = |i: &usize| broken[rows.parts[j]][first + i];
                let end = (begin..row.len() - 1).find(is_broken).unwrap_or(row.len() - 1);
                // Between two breaks a slice alone has no length; at an end of the body it goes on.
                let is_at_end = first + begin == 0 || first + end + 1 == rows.places.len();
                let run = [first + begin, first + end].map(|i| i as u32);
                let run = Some(run).filter(|[begin, end]| begin < end || is_at_end);
                let places = &rows.places[first + begin..=first + end];
                for c in 0..4 {
                    let mut own: Vec<f64> = row[begin..=end].iter().map(|value| value[c]).collect();
                    if self.passes_near {
                        own = near(places, &own);
                    }
                    let slopes = if own.len() < 2 {
                        vec![0.0]
                    } else {
                        interpolating_slopes(places, &own, [SplineEnd::Natural; 2])
                    };
                    for (i, (value, slope)) in own.into_iter().zip(slopes).enumerate() {
                        let at = (first + begin + i) * count + j;
                        (rows.knots[at].value[c], rows.knots[at].slope[c]) = (value, slope);
                        rows.runs[at] = run;
                    }
                }
                begin = end + 1;
            }
        }
        rows
    }
}

/// Adds the rows from one parameter to another one, but for the first, so that cubics between them
/// follow the sections, on which the rows are `at` their parameters.
fn divide([from, to]: [f64; 2], at: &impl Fn(f64) -> Vec<RowValue>, rows: &mut Vec<f64>) {
    let length = to - from;
    let is_followed = || {
        let (ends, places) = ([at(from), at(to)], [0.25, 0.5, 0.75]);
        let turns_little = ends[0].iter().zip(&ends[1]).all(|(a, b)| {
            let sizes = a[2].hypotenuse(a[3]) * b[2].hypotenuse(b[3]);
            (a[2] * b[3] - a[3] * b[2]).abs() <= STRAIGHT * sizes
        });
        turns_little
            && places.into_iter().all(|t| {
                let between = at(from + t * length);
                between.iter().zip(ends[0].iter().zip(&ends[1])).all(|(own, (a, b))| {
                    let away = [0, 1].map(|c| {
                        let (m, n) = (length * a[c + 2], length * b[c + 2]);
                        let rise = b[c] - a[c];
                        let bend = 3.0 * rise - 2.0 * m - n + t * (m + n - 2.0 * rise);
                        own[c] - (a[c] + t * (m + t * bend))
                    });
                    away[0].hypotenuse(away[1]) <= FOLLOWED
                })
            })
    };
    if length > WIDEST_ROWS || (length > CLOSEST_ROWS && !is_followed()) {
        let middle = from + 0.5 * length;
        divide([from, middle], at, rows);
        divide([middle, to], at, rows);
    } else {
        rows.push(to);
    }
}

/// Whether the surface of a part is broken between each slice and the next, by the rows that run
/// too steeply there.
fn breaks(rows: &Rows, part: usize, values: &[([usize; 2], Vec<RowValue>)]) -> Vec<bool> {
    let count = rows.places.len();
    let (mut all, mut steep) = (vec![0_usize; count], vec![0_usize; count]);
    let own = values.iter().zip(&rows.parts).filter(|(_, of)| **of == part);
    for (([first, _], row), _) in own {
        for (i, pair) in row.windows(2).enumerate() {
            let apart = rows.places[first + i + 1] - rows.places[first + i];
            let [a, b] = [pair[0], pair[1]];
            all[first + i] += 1;
            steep[first + i] +=
                usize::from((b[0] - a[0]).hypotenuse(b[1] - a[1]) > STEEPEST * apart);
        }
    }
    (all.iter().zip(&steep)).map(|(all, steep)| *steep as f64 > STEEP_SHARE * *all as f64).collect()
}

impl Rows {
    /// The rows of the same body mirrored left to right: their points are, and their order is
    /// turned, so that they still go to the field side.
    pub fn turned(mut self) -> Self {
        let count = self.parameter.len();
        self.parameter.reverse();
        self.parameter.iter_mut().for_each(|s| *s = -*s);
        self.pattern.reverse();
        self.pattern.iter_mut().for_each(turn_direction);
        self.parts.reverse();
        self.runs.chunks_mut(count).for_each(<[_]>::reverse);
        for slice in self.knots.chunks_mut(count) {
            slice.reverse();
            for RowKnot { value, slope } in slice {
                turn_direction(value);
                turn_direction(slope);
            }
        }
        self
    }
}

fn turn_direction(value: &mut RowValue) {
    (value[2], value[3]) = (-value[2], -value[3]);
}

/// Greatest distance of two rows; and the least one to which they are halved where a section turns
/// by more than that from one to the next, or cubics between them are farther from it than that is
/// to be followed: curvature that jumps by 1/13 mm, as on rail heads, leaves a quarter of a
/// micrometre there [m, m, -, m].
const WIDEST_ROWS: f64 = 3e-3;
const CLOSEST_ROWS: f64 = 4e-4;
const STRAIGHT: f64 = 0.06;
const FOLLOWED: f64 = 1e-8;
/// Steepest row along the track, as a slope against it, and share of the rows of a part from which
/// on the part is broken where so many are steeper: the two slices are not of the same shape, as
/// where a nose begins.
const STEEPEST: f64 = 0.5;
const STEEP_SHARE: f64 = 0.1;
/// Gap around a wheel up to which its slices go all around, over their greatest distance; distance
/// up to which two of them are the same one [rad], and how many follow beyond either end: each
/// leaves a quarter of the effect of an end.
const CLOSED: f64 = 1.5;
const OVERLAP: f64 = 1e-6;
const FOLLOWING: usize = 20;
/// Distance of two rows of parts that are not there together [m].
const SEAM: f64 = 1e-6;
