//! Wear laws: volume of material that a strip or a patch loses per time.
//!
//! | law | of | equation |
//! |---|---|---|
//! | frictional work | strip | mass = `k_E` times the frictional work |
//! | USFD (Lewis and others; R8T wheel on 900A rail) | strip | rate(X) in µg/(m mm²), X = T-gamma per area in N/mm²: 5.3 X; 55.0 from 10.4; 55.0 + 61.9 (X - 77.2) from 77.2 on |
//! | British Rail Research | patch | worn area of the section in mm² per km, D in mm: 0.25 Tγ/D; 25/D from 100 N; (1.19 Tγ - 154)/D from 200 N on |
//! | Zobory | strip | mass flux = k times the frictional power density, k = 7e-10 kg/J below 4 W/mm² and 21e-10 above |
//! | Archard, KTH map (Jendel) | strip | volume = k N s/H where the surfaces slip; k by pressure and slip velocity |
//!
//! All are experimental: neither equations nor coefficients are checked against the papers they are
//! ascribed to (docs/wear.md). What is checked: their dimension, and whether their
//! branches meet. USFD: 5.3 · 10.4 = 55.1, and 55.0 at both ends of the plateau, up to 0.2 %.
//! British Rail: 25 at 100 N, but a jump from 25 to 84 at 200 N. Zobory and the KTH map jump by
//! construction. Jumps concern the wear rate alone; no force follows from it at once. Every
//! coefficient can be given.

use crate::defaults::with_defaults;

/// Wear law.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum WearModel {
    /// No wear.
    #[default]
    Off,
    /// Mass proportional to the frictional work.
    FrictionalWork,
    /// University of Sheffield: T-gamma per area.
    Usfd,
    /// British Rail Research: T-gamma of the patch and the wheel's diameter.
    BritishRail,
    /// Zobory: frictional power density.
    Zobory,
    /// Archard with the KTH map of coefficients.
    Archard,
}

impl WearModel {
    /// Its name as a value of `wear.model`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::FrictionalWork => "frictional_work",
            Self::Usfd => "usfd",
            Self::BritishRail => "british_rail",
            Self::Zobory => "zobory",
            Self::Archard => "archard",
        }
    }
}

/// Coefficients of the law of frictional work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionalWork {
    /// Mass per frictional work, ≥ 0 [kg/J].
    pub coefficient: f64,
}

/// Coefficients of the USFD law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Usfd {
    /// Mass per work in the mild regime, ≥ 0 [kg/J]; 1 µg/(m mm²) per N/mm² is 1e-9 kg/J.
    pub mild: f64,
    /// Mass per area and distance in the severe regime, ≥ 0 [kg/m³]; 1 µg/(m mm²) is 1e-3 kg/m³.
    pub severe: f64,
    /// Growth of that with T-gamma per area in the catastrophic regime, ≥ 0 [kg/J].
    pub catastrophic: f64,
    /// T-gamma per area at which the severe and the catastrophic regime begin, ≥ 0 and growing
    /// [N/m²].
    pub limits: [f64; 2],
}

/// Coefficients of the British Rail law; `area` is that of the wheel's cross section per distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BritishRail {
    /// Area times diameter per distance and T-gamma in the mild regime, ≥ 0 [m³/J]; 1 mm² mm/(km N)
    /// is 1e-12 m³/J.
    pub mild: f64,
    /// Area times diameter per distance on the plateau, ≥ 0 [m²]; 1 mm² mm/km is 1e-12 m².
    pub severe: f64,
    /// Growth with T-gamma beyond, ≥ 0 [m³/J].
    pub catastrophic: f64,
    /// What is taken off there, ≥ 0 [m²].
    pub offset: f64,
    /// T-gamma at which the plateau begins and ends, ≥ 0 and growing [N].
    pub limits: [f64; 2],
}

/// Coefficients of Zobory's law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zobory {
    /// Mass per work below the limit, ≥ 0 [kg/J].
    pub mild: f64,
    /// Mass per work above it, ≥ 0 [kg/J].
    pub severe: f64,
    /// Frictional power density that divides the regimes, ≥ 0 [W/m²].
    pub limit: f64,
}

/// Coefficients of Archard's law by the KTH map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Archard {
    /// Wear coefficient below the lower and above the upper slip velocity, ≥ 0 [-].
    pub mild: f64,
    /// Between the two, ≥ 0 [-].
    pub severe: f64,
    /// Where the pressure is beyond its limit, ≥ 0 [-].
    pub seizure: f64,
    /// Hardness H, > 0 [Pa].
    pub hardness: f64,
    /// Limit of the pressure over the hardness, > 0 [-].
    pub pressure_share: f64,
    /// Slip velocities between which wear is severe, ≥ 0 and growing [m/s].
    pub speeds: [f64; 2],
}

with_defaults! {
    /// Coefficients of all laws for one body.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct LawCoefficients {
        /// Density, > 0 [kg/m³].
        pub density: f64 = 7850.0,
        /// Of the law of frictional work.
        pub frictional_work: FrictionalWork = FrictionalWork { coefficient: 1e-9 },
        /// Of the USFD law.
        pub usfd: Usfd = Usfd {
            mild: 5.3e-9,
            severe: 55.0e-3,
            catastrophic: 61.9e-9,
            limits: [10.4e6, 77.2e6],
        },
        /// Of the British Rail law.
        pub british_rail: BritishRail = BritishRail {
            mild: 0.25e-12,
            severe: 25e-12,
            catastrophic: 1.19e-12,
            offset: 154e-12,
            limits: [100.0, 200.0],
        },
        /// Of Zobory's law.
        pub zobory: Zobory = Zobory { mild: 7e-10, severe: 21e-10, limit: 4e6 },
        // Dry, centres of the ranges of the map (1 to 10, 30 to 40 and 300 to 400, in 1e-4): 5.5 of
        // the first is rounded to 5.
        /// Of Archard's law.
        pub archard: Archard = Archard {
            mild: 5e-4,
            severe: 35e-4,
            seizure: 350e-4,
            hardness: 2.8e9,
            pressure_share: 0.8,
            speeds: [0.2, 0.7],
        },
    }
}

/// What happens in one strip of a patch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StripLoad {
    /// Power turned into heat, ≥ 0 [W].
    pub power: f64,
    /// Area, > 0 [m²].
    pub area: f64,
    /// Share of the area that slips, at its trailing end, 0 to 1 [-].
    pub slip_share: f64,
    /// Pressure at the strip's centre; it falls semi-elliptically along the strip [Pa].
    pub pressure: f64,
    /// Reference speed of the creepages, > 0 [m/s].
    pub speed: f64,
    /// Coefficient of friction, ≥ 0 [-].
    pub friction: f64,
}

impl LawCoefficients {
    /// Volume that one body loses in a strip per time [m³/s]; nothing for the British Rail law,
    /// which is one of whole patches.
    pub fn strip_rate(&self, model: WearModel, strip: &StripLoad) -> f64 {
        if strip.power <= 0.0 || strip.area <= 0.0 {
            return 0.0;
        }
        match model {
            WearModel::Off | WearModel::BritishRail => 0.0,
            WearModel::FrictionalWork => {
                self.frictional_work.coefficient * strip.power / self.density
            }
            WearModel::Usfd => {
                let intensity = strip.power / (strip.speed * strip.area);
                self.usfd.rate(intensity) * strip.speed * strip.area / self.density
            }
            WearModel::Zobory => {
                let Zobory { mild, severe, limit } = self.zobory;
                let coefficient = if strip.power < limit * strip.area { mild } else { severe };
                coefficient * strip.power / self.density
            }
            WearModel::Archard => self.archard.rate(strip),
        }
    }

    /// Volume that one body loses in a patch per time by the British Rail law [m³/s]; a rail loses
    /// by it as much as the wheel, for which alone it was found.
    ///
    /// `wear_number` is T-gamma [N], `speed` the reference speed [m/s]. The diameter cancels: what
    /// the section loses is spread over the circumference, volume per distance = area per distance
    /// · π D.
    pub fn british_rail_rate(&self, wear_number: f64, speed: f64) -> f64 {
        std::f64::consts::PI * self.british_rail.area_times_diameter(wear_number) * speed
    }
}

impl Usfd {
    /// Mass per area and distance at a T-gamma per area of `intensity` [N/m²] [kg/m³].
    pub fn rate(&self, intensity: f64) -> f64 {
        let [severe, catastrophic] = self.limits;
        if intensity < severe {
            self.mild * intensity
        } else {
            self.severe + self.catastrophic * (intensity - catastrophic).max(0.0)
        }
    }
}

impl BritishRail {
    /// Worn area of the section per distance, times the wheel's diameter [m²].
    pub fn area_times_diameter(&self, wear_number: f64) -> f64 {
        let [plateau, end] = self.limits;
        if wear_number < plateau {
            self.mild * wear_number.max(0.0)
        } else if wear_number < end {
            self.severe
        } else {
            (self.catastrophic * wear_number - self.offset).max(0.0)
        }
    }
}

impl Archard {
    /// Volume per time [m³/s]: (1/H) ∫ k p v over the part that slips.
    ///
    /// Where the surfaces slip the traction is friction times pressure, so that ∫ p v is the
    /// frictional power over the coefficient of friction; the speed is the mean one of the strip,
    /// weighted by pressure. The limit of the pressure is taken point by point along the
    /// semi-ellipse, so that the rate grows with the pressure without a jump.
    fn rate(&self, strip: &StripLoad) -> f64 {
        let end = 2.0 * strip.slip_share.clamp(0.0, 1.0) - 1.0;
        let load = std::f64::consts::FRAC_PI_4 * strip.pressure * strip.area;
        let share = load_share(end);
        if strip.friction <= 0.0 || load * share <= 0.0 {
            return 0.0;
        }
        let sliding = strip.power / strip.friction;
        let speed = sliding / (load * share);
        let is_severe = speed >= self.speeds[0] && speed < self.speeds[1];
        let coefficient = if is_severe { self.severe } else { self.mild };
        let limit = self.pressure_share * self.hardness / strip.pressure;
        let beyond = if limit < 1.0 {
            let edge = (1.0 - limit * limit).sqrt();
            (load_share(end.min(edge)) - load_share(-edge)).max(0.0) / share
        } else {
            0.0
        };
        (coefficient + (self.seizure - coefficient) * beyond) * sliding / self.hardness
    }
}

/// Share of the load of a semi-ellipse over -1 to 1 that lies below `t`.
fn load_share(t: f64) -> f64 {
    let t = t.clamp(-1.0, 1.0);
    0.5 + (t * (1.0 - t * t).sqrt() + t.asin()) / std::f64::consts::PI
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn strip() -> StripLoad {
        StripLoad {
            power: 30.0,
            area: 5e-6,
            slip_share: 0.6,
            pressure: 9e8,
            speed: 20.0,
            friction: 0.3,
        }
    }

    const LOCAL: [WearModel; 4] =
        [WearModel::FrictionalWork, WearModel::Usfd, WearModel::Zobory, WearModel::Archard];

    #[test]
    fn branches_meet_where_the_sources_say_so() {
        let laws = LawCoefficients::default();
        let usfd = laws.usfd;
        for limit in usfd.limits {
            let (below, above) = (usfd.rate(limit * (1.0 - 1e-12)), usfd.rate(limit));
            assert_relative_eq!(below, above, max_relative = 3e-3);
        }
        let british = laws.british_rail;
        let jump = |t: f64| {
            british.area_times_diameter(t) / british.area_times_diameter(t * (1.0 - 1e-12))
        };
        assert_relative_eq!(jump(100.0), 1.0, max_relative = 1e-9);
        // The printed numbers jump from 25 to 84.
        assert_relative_eq!(jump(200.0), 84.0 / 25.0, max_relative = 1e-9);
    }

    #[test]
    fn units_of_the_sources_carry_over() {
        let laws = LawCoefficients::default();
        // USFD: 5 N/mm² wear off 26.5 µg per m and mm²; 20 m/s on 5 mm².
        let load = StripLoad { power: 5e6 * 20.0 * 5e-6, ..strip() };
        let expected = 26.5e-9 * 20.0 * 5.0 / 7850.0;
        assert_relative_eq!(
            laws.strip_rate(WearModel::Usfd, &load),
            expected,
            max_relative = 1e-12
        );
        // British Rail: 80 N on a wheel of 920 mm take 20/920 mm² off its section in a kilometre.
        let area = 20.0 / 920.0 * 1e-6;
        let expected = area * std::f64::consts::PI * 0.92;
        assert_relative_eq!(laws.british_rail_rate(80.0, 1e3), expected, max_relative = 1e-12);
        // Zobory: 1 W/mm² for a second on 5 mm² takes 5 · 7e-10 kg.
        let load = StripLoad { power: 5.0, ..strip() };
        assert_relative_eq!(
            laws.strip_rate(WearModel::Zobory, &load),
            35e-10 / 7850.0,
            max_relative = 1e-12
        );
        // Archard in full slip at 1 m/s and low pressure: k N v/H.
        let load = std::f64::consts::FRAC_PI_4 * 9e8 * 5e-6;
        let slipping = StripLoad { power: 0.3 * load, slip_share: 1.0, ..strip() };
        assert_relative_eq!(
            laws.strip_rate(WearModel::Archard, &slipping),
            5e-4 * load / 2.8e9,
            max_relative = 1e-12
        );
    }

    #[test]
    fn energy_laws_scale_and_do_not_depend_on_how_a_patch_is_cut() {
        // Two halves of a strip wear as the whole does.
        let laws = LawCoefficients::default();
        let half = StripLoad { power: 15.0, area: 2.5e-6, ..strip() };
        for model in LOCAL {
            let (whole, part) = (laws.strip_rate(model, &strip()), laws.strip_rate(model, &half));
            assert!(whole > 0.0, "{model:?}");
            assert_relative_eq!(whole, 2.0 * part, max_relative = 1e-12);
        }
    }

    #[test]
    fn archard_grows_with_the_pressure_without_a_jump_and_ends_in_seizure() {
        let laws = LawCoefficients::default();
        let rate = |pressure: f64| {
            laws.strip_rate(WearModel::Archard, &StripLoad { pressure, slip_share: 1.0, ..strip() })
        };
        let limit = 0.8 * 2.8e9;
        let mild = rate(0.99 * limit);
        assert_relative_eq!(rate(limit * (1.0 + 1e-12)), rate(limit), max_relative = 1e-3);
        let hard = rate(50.0 * limit);
        assert_relative_eq!(hard / mild, 350.0 / 5.0, max_relative = 1e-3);
        let mut last = 0.0;
        for i in 0..200 {
            let at = rate(limit * (0.9 + 0.01 * f64::from(i)));
            assert!(at >= last * (1.0 - 1e-12));
            last = at;
        }
    }

    #[test]
    fn the_load_below_a_place_of_a_semi_ellipse_is_its_integral() {
        for t in [-1.0, -0.3, 0.2, 0.9, 1.0] {
            let n = 200_000;
            let h = (t + 1.0) / f64::from(n);
            let sum: f64 = (0..n)
                .map(|i| {
                    let x = -1.0 + h * (f64::from(i) + 0.5);
                    (1.0 - x * x).sqrt() * h
                })
                .sum();
            assert_relative_eq!(load_share(t), sum / std::f64::consts::FRAC_PI_2, epsilon = 1e-7);
        }
    }
}
