//! Strips along rolling with their pressure, in loaded zones: what normal models fill and
//! tangential models see.

use std::ops::Range;

use super::element_pressure::ElementPressure;
use crate::friction::StripFriction;
use crate::math::fixed_vec::FixedVec;
use crate::math::numbers::{Numbers, numbers};
use crate::math::real::Real;

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
    /// Length of the longest strip [m]; strips of a yawed wheel are shifted against each other
    /// besides.
    pub length: T,
    /// Extent across [m].
    pub width: T,
    /// How far its edges are beyond its outermost strips; nothing where the model does not know [m].
    pub beyond: [T; 2],
    /// Area [m²].
    pub area: T,
    /// Centroid of the load along the track, from the wheel marker [m].
    pub x: T,
    /// How far that is ahead of the mean place of greatest overlap of its strips: the middle line of
    /// a turned ellipse is another one than the line of greatest overlap [m].
    pub off: T,
    /// Centroid of the load across, in the contact frame from the contact point [m].
    pub y: T,
    /// Parameter of the contact line at the centroid of the load [m].
    pub u: T,
}

numbers!(
    Zone: load, max_pressure, length, width, beyond, area, x, off, y, u; kept first, count
);

impl<T> Zone<T> {
    /// The indices of its strips.
    #[inline]
    pub fn range(&self) -> Range<usize> {
        self.first..self.first + self.count
    }
}

/// What is in the columns of [`Strips`] for one of them.
#[derive(Clone, Copy, Debug, Default)]
#[allow(missing_docs)]
pub struct LoadedStrip<T = f64> {
    pub y: T,
    pub width: T,
    pub x: T,
    pub half_length: T,
    pub pressure: T,
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
    /// Coefficient of friction, where strips have their own: filled in once the strips are there;
    /// empty for one coefficient.
    pub friction: FixedVec<StripFriction<T>>,
    /// The elements that the strips were made from, if the normal model has them.
    pub elements: Option<Box<ElementPressure>>,
}

numbers!(
    Strips: zones, y, width, x, half_length, pressure, u, friction; ..Strips::default()
);

impl<T: Real> Strips<T> {
    /// Room for `zones` zones of `strips` strips together; nothing is allocated later.
    pub fn with_capacity(zones: usize, strips: usize) -> Self {
        let column = || FixedVec::new(strips);
        Self {
            zones: FixedVec::new(zones),
            y: column(),
            width: column(),
            x: column(),
            half_length: column(),
            pressure: column(),
            u: column(),
            friction: FixedVec::new(strips),
            elements: None,
        }
    }

    /// The same in other numbers; without the elements.
    pub fn in_other_numbers<O: Real>(&self) -> Strips<O>
    where
        T: Into<O>,
    {
        self.each(&mut Into::into)
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

    /// Adds a strip.
    #[inline]
    pub fn push(&mut self, strip: LoadedStrip<T>) {
        self.y.push(strip.y);
        self.width.push(strip.width);
        self.x.push(strip.x);
        self.half_length.push(strip.half_length);
        self.pressure.push(strip.pressure);
        self.u.push(strip.u);
    }

    /// Strip `j`.
    #[inline]
    pub fn strip(&self, j: usize) -> LoadedStrip<T> {
        LoadedStrip {
            y: self.y[j],
            width: self.width[j],
            x: self.x[j],
            half_length: self.half_length[j],
            pressure: self.pressure[j],
            u: self.u[j],
        }
    }

    /// Left and right edge of `zone` across, in the contact frame [m].
    ///
    /// Where its model does not say how far they are beyond the outermost strips, these are as wide as
    /// a rule of quadrature has it: their mean place is the middle of the zone.
    pub fn edges(&self, zone: &Zone<T>) -> [T; 2] {
        let range = zone.range();
        let [before, behind] = zone.beyond;
        if before.value() + behind.value() > 0.0 {
            return [self.y[range.start] - before, self.y[range.end - 1] + behind];
        }
        let (mut width, mut middle) = (T::from(0.0), T::from(0.0));
        for j in range {
            width += self.width[j];
            middle += self.width[j] * self.y[j];
        }
        let (half, middle) = (width * 0.5, middle / width);
        [middle - half, middle + half]
    }

    /// Load of strip `j` over π/2 [N].
    #[inline]
    pub fn weight(&self, j: usize) -> T {
        self.half_length[j] * self.width[j] * self.pressure[j]
    }

    /// Whether another zone of `strips` strips fits.
    pub fn has_room_for(&self, strips: usize) -> bool {
        self.zones.len() < self.zones.capacity() && self.y.len() + strips <= self.y.capacity()
    }

    /// Normal force of all zones, without damping [N].
    pub fn load(&self) -> T {
        self.zones.iter().map(|zone| zone.load).sum()
    }

    /// Fills load, area and centroid of `zone` from its strips.
    pub(crate) fn summarise(&self, zone: &mut Zone<T>) {
        let (mut load, mut area) = (T::from(0.0), T::from(0.0));
        let (mut x, mut y, mut u) = (T::from(0.0), T::from(0.0), T::from(0.0));
        for j in zone.range() {
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
