//! Normal contact: from the separation of wheel and rail to loaded zones of strips with their pressure.
//!
//! Every model fills the same [`Strips`]: strips along rolling, each with a semi-elliptical pressure, grouped in
//! separate loaded zones. Tangential models see nothing else.

pub mod boundary_element;
pub mod damping;
pub mod hertz;
pub mod piotrowski_kik;
pub mod rail_elements;
pub mod shape_correction;
pub mod strips_on_grid;
pub mod uneven;
mod zones;

pub use boundary_element::ElementPressure;
pub use shape_correction::ShapeFit;
pub use zones::Edge;

use crate::friction::StripFriction;
use crate::geometry::separation::{FrameSeparation, Probe, Separation};
use crate::math::fixed_vec::FixedVec;
use crate::math::quadrature::GaussLegendre;
use crate::math::real::Real;

/// Normal contact model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NormalModel {
    /// An ellipse at each contact point from the curvatures there.
    Hertz,
    /// Virtual penetration, semi-elliptical strips (Piotrowski and Kik 2008).
    PiotrowskiKik,
    /// The same with the ratio of length to width of the contact area corrected (section 2.4 there).
    PiotrowskiKikCorrected,
    /// The contact condition on every strip, coupled through the half-space, all overlaps of a rail in one problem: see [`strips_on_grid`].
    #[default]
    Strips,
    /// The half-space solution on rectangular elements: slow, for checking the others.
    BoundaryElement,
}

/// One loaded zone: a connected part of the contact area.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Zone<T = f64> {
    /// Index of its first strip.
    pub first: usize,
    /// Number of its strips.
    pub count: usize,
    /// Normal force without damping [N].
    pub load: T,
    /// Greatest pressure [Pa].
    pub max_pressure: T,
    /// Length of the longest strip [m]; strips of a yawed wheel are shifted against each other besides.
    pub length: T,
    /// Extent across [m].
    pub width: T,
    /// Area [m²].
    pub area: T,
    /// Centroid of the load along the track, from the wheel marker [m].
    pub x: T,
    /// Centroid of the load across, in the contact frame from the contact point [m].
    pub y: T,
    /// Parameter of the contact line at the centroid of the load [m].
    pub u: T,
}

/// The loaded zones of one contact frame and their strips, as columns of equal length.
///
/// Strip j carries p(x, y_j) = pressure_j sqrt(1 - ((x - x_j)/half_length_j)²).
#[derive(Clone, Debug, Default)]
pub struct Strips<T = f64> {
    /// The zones, in growing y.
    pub zones: FixedVec<Zone<T>>,
    /// Lateral coordinate of each strip in the contact frame [m].
    pub y: FixedVec<T>,
    /// Width [m].
    pub width: FixedVec<T>,
    /// Centre along the track, from the wheel marker [m].
    pub x: FixedVec<T>,
    /// Half length along x [m].
    pub half_length: FixedVec<T>,
    /// Pressure at the centre [Pa].
    pub pressure: FixedVec<T>,
    /// Parameter of the contact line [m].
    pub u: FixedVec<T>,
    /// Coefficient of friction, where strips have their own: filled in once the strips are there; empty for one coefficient.
    pub friction: FixedVec<StripFriction<T>>,
    /// The elements that the strips were made from, if the normal model has them.
    pub elements: Option<Box<ElementPressure>>,
}

impl<T: Real> Strips<T> {
    /// Room for `zones` zones of `strips` strips each; nothing is allocated later.
    #[must_use]
    pub fn with_capacity(zones: usize, strips: usize) -> Self {
        let column = || FixedVec::new(zones * strips);
        Self {
            zones: FixedVec::new(zones),
            y: column(),
            width: column(),
            x: column(),
            half_length: column(),
            pressure: column(),
            u: column(),
            friction: FixedVec::new(zones * strips),
            elements: None,
        }
    }

    /// The same in other numbers; without the elements.
    #[must_use]
    pub fn in_other_numbers<O: Real>(&self) -> Strips<O>
    where
        T: Into<O>,
    {
        let column = |own: &FixedVec<T>| {
            let mut other = FixedVec::new(own.len());
            other.extend(own.iter().map(|&value| value.into()));
            other
        };
        let mut zones = FixedVec::new(self.zones.len());
        zones.extend(self.zones.iter().map(|zone| Zone {
            first: zone.first,
            count: zone.count,
            load: zone.load.into(),
            max_pressure: zone.max_pressure.into(),
            length: zone.length.into(),
            width: zone.width.into(),
            area: zone.area.into(),
            x: zone.x.into(),
            y: zone.y.into(),
            u: zone.u.into(),
        }));
        let mut friction = FixedVec::new(self.friction.len());
        friction.extend(self.friction.iter().map(|own| StripFriction {
            tread: own.tread.into(),
            gauge_face: own.gauge_face.into(),
            gauge_face_share: own.gauge_face_share.into(),
        }));
        Strips {
            zones,
            y: column(&self.y),
            width: column(&self.width),
            x: column(&self.x),
            half_length: column(&self.half_length),
            pressure: column(&self.pressure),
            u: column(&self.u),
            friction,
            elements: None,
        }
    }

    /// Forgets all zones and strips, keeps the room.
    pub fn clear(&mut self) {
        self.elements = None;
        self.friction.clear();
        self.zones.clear();
        for column in [
            &mut self.y,
            &mut self.width,
            &mut self.x,
            &mut self.half_length,
            &mut self.pressure,
            &mut self.u,
        ] {
            column.clear();
        }
    }

    /// Whether another zone of `strips` strips fits.
    #[must_use]
    pub fn has_room_for(&self, strips: usize) -> bool {
        self.zones.len() < self.zones.capacity() && self.y.len() + strips <= self.y.capacity()
    }

    /// Normal force of all zones, without damping [N].
    #[must_use]
    pub fn load(&self) -> T {
        self.zones.iter().map(|zone| zone.load).sum()
    }

    /// Fills load, area and centroid of `zone` from its strips.
    pub(crate) fn summarise(&self, zone: &mut Zone<T>) {
        let strips = zone.first..zone.first + zone.count;
        let (mut load, mut area) = (T::from(0.0), T::from(0.0));
        let (mut x, mut y, mut u) = (T::from(0.0), T::from(0.0), T::from(0.0));
        for j in strips {
            let strip_area = self.half_length[j] * self.width[j];
            let strip_load = strip_area * self.pressure[j];
            area += strip_area;
            load += strip_load;
            x += strip_load * self.x[j];
            y += strip_load * self.y[j];
            u += strip_load * self.u[j];
        }
        zone.area = area * 2.0;
        zone.load = load * std::f64::consts::FRAC_PI_2;
        if load > 0.0 {
            (zone.x, zone.y, zone.u) = (x / load, y / load, u / load);
        }
    }
}

/// What all normal models are told about one contact frame.
#[derive(Clone, Copy, Debug)]
pub struct NormalProblem<'a, T = f64> {
    /// Approach: overlap of the undeformed bodies at the contact point, > 0 [m].
    pub approach: T,
    /// Radius of the normal section of the wheel along x, > 0 [m].
    pub radius: T,
    /// Contact modulus E* of the two bodies [Pa].
    pub contact_modulus: f64,
    /// Parameter of the contact line at the contact point [m].
    pub contact_u: T,
    /// Relative curvature of the two profiles at the contact point, f''(0) without yaw [1/m].
    pub lateral_curvature: T,
    /// Quadrature rule across a zone; its nodes are the strips.
    pub rule: &'a GaussLegendre,
    /// Elements along and across the contact, for the model with boundary elements.
    pub elements: [usize; 2],
}

/// Fills the empty `strips` with the loaded zones of `problem` by `model`; `virtual_penetration` is ε of Piotrowski and Kik,
/// `shape_fit` the ratio that their corrected contact area gets.
///
/// `probes` bracket the zones: see [`Probe`]. Returns the number of zones that found no room, or 1 where a solution did not converge and
/// the simpler model took its place.
pub fn solve(
    model: NormalModel,
    virtual_penetration: f64,
    shape_fit: ShapeFit,
    problem: &NormalProblem,
    separation: &mut impl Separation,
    probes: &[Probe],
    strips: &mut Strips,
) -> usize {
    if model != NormalModel::BoundaryElement {
        let epsilon = virtual_penetration;
        return solve_in_frame(model, epsilon, shape_fit, problem, separation, probes, strips);
    }
    boundary_element::solve(problem, problem.elements, separation, probes, strips).unwrap_or_else(
        || {
            let epsilon = virtual_penetration;
            1 + piotrowski_kik::solve(problem, epsilon, None, separation, probes, strips)
        },
    )
}

/// As [`solve`], with derivatives where the numbers have them, by Hertz or Piotrowski and Kik, to whom the others fall back.
pub fn solve_in_frame<T: piotrowski_kik::Influence>(
    model: NormalModel,
    virtual_penetration: f64,
    shape_fit: ShapeFit,
    problem: &NormalProblem<T>,
    separation: &mut impl FrameSeparation<T>,
    probes: &[Probe],
    strips: &mut Strips<T>,
) -> usize {
    if model == NormalModel::Hertz {
        hertz::solve(problem, separation, strips);
        return 0;
    }
    let shape = (model == NormalModel::PiotrowskiKikCorrected).then_some(shape_fit);
    piotrowski_kik::solve(problem, virtual_penetration, shape, separation, probes, strips)
}
