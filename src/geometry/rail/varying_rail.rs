//! A rail whose section varies along the track, as the wheel above it meets it: the outline of all
//! its sections.
//!
//! Each row is met where it is nearest to the wheel, at the place along the track at which the gap
//! between both, along the radius of the wheel, is least: see [`spot`]. That is the place of a search
//! in three dimensions. Seen along the rows, what the wheel can touch is the outline of the points at
//! which the rows are met, each as far from the contact line of the wheel as the row is from the
//! wheel in space. Where the surface is the same all along the track the outline is the section.
//! Strips of the contact lie along the rows: a rail whose edge runs off sideways turns its patch with
//! it.
//!
//! All of it is seen in axes along the mean course of the rows near the wheel, so that sections that
//! drift or rise evenly are an even rail: see [`mean_course`].
//!
//! A roller is such a rail: its rows go around an axle across the track. Corrugation is part of the
//! surface, so that the wheel meets its crests.

mod about_axle;
mod bounds;
mod bracket;
mod few;
mod mean_course;
mod meeting;
mod moving_outline;
mod on_waves;
mod over;
mod spot;
mod touch;
mod trend;
mod waves;
mod wheel_above;
mod wheel_table;

use self::bounds::{Bound, Bounds};
use self::few::Few;
use self::mean_course::Courses;
use self::meeting::Meeting;
pub use self::moving_outline::MovingOutline;
use self::over::Over;
use self::touch::Touch;
use self::waves::WheelWaves;
pub use self::wheel_above::WheelAbove;
use self::wheel_table::WheelTable;
use crate::geometry::curves::arc_length::ArcLength;
use crate::geometry::curves::curve::{Curve, Knot};
use crate::geometry::rail::course::Course;
pub use crate::geometry::sections::rows::along::Along;
use crate::geometry::sections::rows::envelope::Envelope;
use crate::geometry::sections::rows::met::Met;
use crate::geometry::sections::rows::roller::Roller;
use crate::geometry::sections::rows::surface::{MAX_SHARE_OF_ROLLER, REACH, REACH_ALONG, Surface};
use crate::geometry::sections::slices::Slices;
use crate::geometry::uneven::waviness::Waviness;
use crate::geometry::wheel::contact_line::ContactLine;
use crate::geometry::wheel::wheel_pose::WheelPose;
use crate::math::real::Real;

/// A rail whose section varies.
#[derive(Clone, Debug)]
pub struct VaryingRail {
    surface: Surface,
    bounds: Bounds,
    few: Few,
    wheel: WheelTable,
    /// Profile of the wheel; of one whose section varies around the first one.
    profile: Curve,
    courses: Courses,
    /// How the wheel that comes next stands against the rail, and the axes along the rows near it,
    /// where these drift or rise.
    level: Option<(WheelPose, Course)>,
    /// Deviations of the wheel over the arc of its nominal rolling circle, with a radius [m].
    waves: Waviness,
    nominal_radius: f64,
    envelope: Envelope,
    meeting: Meeting,
    /// Arc of the pattern at each row, from the first one [m], and the row at which it is highest.
    arcs: Vec<f64>,
    top: usize,
    /// Places at which rows begin or end, and whether any of them is within reach of the wheel that
    /// passed last.
    free_ends: Vec<f64>,
    is_near_end: bool,
    /// How that stood.
    stand: Stand,
    /// Whether the rows go straight on along the track but for a corrugation.
    is_straight: bool,
}

/// How a wheel stands above a rail that varies.
#[derive(Clone, Copy, Debug, Default)]
struct Stand<T = f64> {
    /// Station [m] and angle by which it is turned [rad].
    station: T,
    pitch: T,
    /// How it stands in the axes along the rows.
    pose: WheelPose<T>,
}

impl VaryingRail {
    /// The rail of `slices`, whose points and directions `point` and `direction` put where it
    /// stands, turned left to right if `turned`, under the `wheel`. With a `roller_radius` [m]
    /// above 0 the first of them goes around a roller whose axle is at station 0, and they end
    /// where a wheel leaves that. `corrugation` is the height of the rail over the station on top
    /// of that of the slices; of a roller over the arc of the marker's circle.
    pub fn new(
        slices: &Slices,
        point: impl Fn([f64; 2]) -> [f64; 2],
        direction: impl Fn([f64; 2]) -> [f64; 2],
        turned: bool,
        wheel: &WheelAbove,
        roller_radius: f64,
        corrugation: Waviness,
    ) -> Self {
        let rows = slices.rows(point, direction);
        let rows = if turned { rows.turned() } else { rows };
        let is_roller = roller_radius > 0.0;
        let roller = is_roller.then_some(Roller { radius: roller_radius, top: 0.0 });
        let surface = Surface { rows, roller, corrugation };
        let (arcs, top) = arcs_of_pattern(&surface);
        let few = Few::new(&surface.rows, wheel);
        Self {
            arcs,
            top,
            free_ends: surface.free_ends(),
            is_near_end: false,
            bounds: Bounds::new(&surface, wheel.nominal_radius, &wheel.waves),
            wheel: WheelTable::new(wheel.profile, wheel.sides()),
            profile: wheel.profile.clone(),
            courses: Courses::new(&surface, &few.rows, wheel.profile),
            few,
            level: None,
            waves: wheel.waves.clone(),
            nominal_radius: wheel.nominal_radius,
            envelope: Envelope::new(surface.count()),
            meeting: Meeting::new(surface.count()),
            is_straight: !is_roller && surface.rows.are_straight(),
            surface,
            stand: Stand::default(),
        }
    }

    /// Station of a wheel at `x` of a track whose origin is at `origin`; the axle of a roller is at
    /// station 0, and `origin` the arc that is on its top [m].
    pub fn station<T: Real>(&self, origin: T, x: T) -> T {
        if self.surface.roller.is_some() { x } else { origin + x }
    }

    /// Places along the track, from the axle of a roller of `radius` [m], between which a wheel may
    /// touch it [m].
    pub fn range_of_roller(radius: f64) -> [f64; 2] {
        [-MAX_SHARE_OF_ROLLER * radius, MAX_SHARE_OF_ROLLER * radius]
    }

    /// Distance of the rail marker from the axle of a roller; 0 for a rail [m].
    pub fn roller_radius(&self) -> f64 {
        self.surface.roller.map_or(0.0, |roller| roller.radius)
    }

    /// Most rows of the envelope.
    pub fn most_knots(&self) -> usize {
        self.surface.count()
    }

    /// Stations of the first and the last section [m].
    pub fn stations(&self) -> [f64; 2] {
        let places = &self.surface.rows.places;
        [places[0], places[places.len() - 1]]
    }

    /// Faces between neighbouring slices and rows that a wheel between two stations may touch [m],
    /// by their corners (y, z) [m].
    pub fn faces_near(
        &self,
        stations: [f64; 2],
    ) -> impl Iterator<Item = [[f64; 2]; 4]> + Clone + '_ {
        self.surface.faces_near(stations)
    }

    /// Takes axes along the rows near a wheel that stands at `pose`, `x` from the origin of a track
    /// that is at the station `origin` [m]: those in which it is seen to [`pass`](Self::pass).
    pub fn approach(&mut self, pose: &WheelPose, [origin, x]: [f64; 2]) {
        let station = self.station(origin, x);
        self.level = self.course_under(pose, station).map(|course| (*pose, course));
    }

    /// Axes along the rows near a wheel that stands at `pose` above `station` [m]; nothing where
    /// these do not drift or rise.
    pub fn course_under<T: Real>(&self, pose: &WheelPose<T>, station: T) -> Option<Course<T>> {
        let line = ContactLine::new(&self.profile, self.nominal_radius, pose);
        self.courses.near(&self.surface, &line, pose, station)
    }

    /// The axes along the rows near the wheel that was to pass last, where these drift or rise.
    pub fn course(&self) -> Option<&Course> {
        self.level.as_ref().map(|(_, course)| course)
    }

    /// Lays the envelope for the wheel of `line`, which stands at `pose` in the axes along the rows,
    /// `x` from the origin of a track that is at the station `origin` [m], turned by `pitch` [rad],
    /// into `curve`, after [`approach`](Self::approach); allocates nothing within the room that it
    /// has. False where there is no rail within reach.
    pub fn pass(
        &mut self,
        line: &ContactLine,
        pose: &WheelPose,
        [origin, x]: [f64; 2],
        pitch: f64,
        curve: &mut Curve,
    ) -> bool {
        if let Some(roller) = &mut self.surface.roller {
            roller.top = origin;
        }
        self.stand = Stand { station: self.station(origin, x), pitch, pose: *pose };
        let reach = if self.level.is_some() { REACH_ALONG } else { REACH };
        let near = |place: &f64| (place - self.stand.station).abs() < reach;
        self.is_near_end = self.free_ends.iter().any(near);
        if line.varies_around() {
            self.wheel.follow(line.profile());
        }
        self.meet_rows(line, pose);
        let is_there = self.envelope.lay(&self.surface, self.meeting.met());
        if is_there {
            curve.put_through(self.envelope.knots());
        }
        is_there
    }

    /// Lays the envelope that [`pass`](Self::pass) has laid last into `outline`, as it moves with
    /// the wheel of `line` at `pose` above `station` [m], turned by `pitch` [rad].
    pub fn move_with<T: Real>(
        &self,
        line: &ContactLine<T>,
        pose: &WheelPose<T>,
        [station, pitch]: [T; 2],
        outline: &mut MovingOutline<T>,
    ) {
        let Self { surface, bounds, wheel, meeting, .. } = self;
        let touch = Touch { surface, bounds, wheel };
        let within = surface.within(station.value());
        let waves = WheelWaves::of(&self.waves, self.nominal_radius, pitch);
        let over = Over::new(line, pose, station, within).with_waves(waves).along(outline.course);
        outline.met.clear();
        outline.met.extend(meeting.met().iter().map(|found| touch.moving(&over, found)));
        outline.envelope.lay(surface, &outline.met);
        outline.stand = Stand { station, pitch, pose: *pose };
    }

    /// Meets all rows that may touch, and a few of the others.
    fn meet_rows(&mut self, line: &ContactLine, pose: &WheelPose) {
        let Self { surface, bounds, few, wheel, meeting, waves, level, stand, .. } = self;
        let within = surface.within(stand.station);
        let waves = WheelWaves::of(waves, self.nominal_radius, stand.pitch);
        let course = level.as_ref().map(|(_, course)| *course);
        let over = &Over::new(line, pose, stand.station, within).with_waves(waves).along(course);
        let touch = Touch { surface, bounds, wheel };
        // In the axes of the track, in which the bounds are; farther aside along rows that drift.
        let (level, aside) = level.as_ref().map_or((pose, 0.0), |(level, course)| {
            let [along, ..] = course.axes;
            (level, (REACH_ALONG - REACH) * (along[1] / along[0]).abs())
        });
        let above = &Over::new(line, level, stand.station, within);
        let low = |j: usize| below(bounds.of(j, within.slice), wheel, above, aside);
        let lows = few.rows.iter().zip(&few.edges).map(|(&j, edge)| low(j) - edge);
        meeting.meet(&touch, few, over, lows);
    }

    /// Parameter of the outline that was laid last near the highest place of the pattern, and the
    /// arc of the pattern there: a place that stays on the rail, whichever rows the outline
    /// consists of [m].
    pub fn mark(&self) -> [f64; 2] {
        let rows = self.envelope.rows().enumerate();
        let nearest = rows.min_by_key(|(_, row)| row.abs_diff(self.top));
        nearest.map_or([0.0; 2], |(k, row)| [self.envelope.knots()[k].s, self.arcs[row]])
    }

    /// The row of the outline nearest to its parameter `s` [m], where it is met.
    pub(in crate::geometry) fn met_near(&self, s: f64) -> Option<&Met> {
        self.envelope.met_near(s)
    }

    /// Whether rows begin or end within reach of the wheel that passed last.
    pub fn is_near_end(&self) -> bool {
        self.is_near_end
    }

    /// From where to where the row at parameter `s` of the envelope is there: places in the frame of
    /// the rail, x from the marker of the wheel that passed last, without end where it goes on to
    /// the end of the rail or is broken [m]; nothing where no row ends within reach.
    pub fn ends(&self, s: f64) -> Option<[[f64; 3]; 2]> {
        if !self.is_near_end {
            return None;
        }
        let slice = self.surface.within(self.stand.station).slice;
        let row = self.envelope.met_near(s)?.row;
        let run = self.surface.run(row, self.stand.station, slice)?;
        let ends = self.surface.ends(row, run, self.stand.station);
        Some(ends.map(|x| {
            if self.level.is_none() || x.is_infinite() {
                return [x, 0.0, 0.0];
            }
            let p = self.surface.at(row, run, self.stand.station + x, slice);
            [x, p.value[0], p.value[1]]
        }))
    }

    /// How far ahead of the even contact line the wheel that passed last meets the rail at parameter
    /// `s` of the envelope [m].
    pub fn ahead(&self, s: f64) -> f64 {
        self.envelope.ahead(s)
    }

    /// Where the wheel that passed last meets the rail at parameter `s` of the envelope.
    pub fn along(&self, s: f64) -> Along {
        self.envelope.along(s)
    }
}

/// Arc of the pattern of `surface` at each row, from the first one [m], and the row at which it is
/// highest.
fn arcs_of_pattern(surface: &Surface) -> (Vec<f64>, usize) {
    let rows = &surface.rows;
    let knots = rows.parameter.iter().zip(&rows.pattern);
    let knots: Vec<Knot> =
        knots.map(|(&s, &[y, z, dy, dz])| Knot { s, point: [y, z], tangent: [dy, dz] }).collect();
    let mut arcs = vec![0.0];
    for pair in knots.windows(2) {
        // Rows of two parts may share their parameter.
        let is_piece = pair[1].s > pair[0].s;
        let length = if is_piece { ArcLength::new(&Curve::through(pair)).length() } else { 0.0 };
        arcs.push(arcs[arcs.len() - 1] + length);
    }
    let heights = rows.pattern.iter().enumerate();
    let top = heights.min_by(|(_, a), (_, b)| a[1].total_cmp(&b[1])).map_or(0, |(j, _)| j);
    (arcs, top)
}

/// How far a row is surely below the `wheel` by its `bound`, if it goes `aside` beyond that [m].
fn below(bound: &Bound, wheel: &WheelTable, over: &Over, aside: f64) -> f64 {
    let [right, down] = [over.right, over.down];
    let [y, z] = over.seen_from_marker([0.0, bound.top]);
    let (left, wide) = (bound.y[0] - aside + y, bound.y[1] - bound.y[0] + 2.0 * aside);
    let across = left * right[0] + z * right[1];
    let [beside, yawed] = over.margin;
    let lowest = wheel.lowest([across - beside, across + wide * right[0] + beside]);
    let highest = (left * down[0]).min((left + wide) * down[0]) + z * down[1];
    highest - lowest - over.nominal_radius() - yawed
}
