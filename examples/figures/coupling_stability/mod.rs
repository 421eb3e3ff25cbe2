//! How long may a communication step be? Half of a wheelset bounces on the contact of the wheel
//! unit under masters of five kinds: largest stable step and error of the energy of each, as a
//! table and, where a file is named, as a figure.

mod figure;
mod scheme;
mod unit;

use std::error::Error;

use figure::Curve;
use scheme::{LOAD, MASS, SCHEMES, Scheme};
use unit::Unit;

/// Length of the runs whose energy is looked at [s].
const DURATION: f64 = 0.02;
/// Where they start, above the equilibrium [m]: the force swings between about a third and twice
/// the load.
const START: f64 = -2e-5;
/// Longest step that is tried [s].
const LONGEST: f64 = 0.02;
/// Growth in a step that counts as none: of forces held over 1.3 µs without damping.
const RESOLUTION: f64 = 1e-6;
/// Shortest step that is tried [s].
const SHORTEST: f64 = 5e-6;
/// Communication step of the errors in the table [s].
const TABLE_STEP: f64 = 1e-4;

/// The contact at rest: where it carries the load, and the energy of mass and contact.
struct Rest {
    balanced: f64,
    /// Elastic energy less the work of the load, from the equilibrium on, at steps of `SPACING`
    /// about it [J].
    potential: Vec<f64>,
}

const SPACING: f64 = 2e-8;
const HALF_TABLE: usize = 7500;

impl Rest {
    fn new() -> Result<Self, Box<dyn Error>> {
        let mut unit = Unit::new(0.0)?;
        let mut lack = |z: f64| {
            unit.place([z, 0.0])?;
            Ok::<f64, Box<dyn Error>>(unit.force()? + LOAD)
        };
        let (mut low, mut high) = (-0.4599, -0.4594);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if lack(middle)? > 0.0 { low = middle } else { high = middle }
        }
        let balanced = high;
        let mut potential = vec![0.0; 2 * HALF_TABLE + 1];
        for side in [1.0, -1.0] {
            for i in 0..HALF_TABLE {
                let at = |share: f64| balanced + side * SPACING * (i as f64 + share);
                let mean = (lack(at(0.0))? + 4.0 * lack(at(0.5))? + lack(at(1.0))?) / 6.0;
                let place = |i: usize| HALF_TABLE.wrapping_add_signed(side as isize * i as isize);
                potential[place(i + 1)] = potential[place(i)] - side * SPACING * mean;
            }
        }
        Ok(Self { balanced, potential })
    }

    /// Energy above that of the equilibrium [J].
    fn energy(&self, [z, v]: [f64; 2]) -> f64 {
        let place = (z - self.balanced) / SPACING + HALF_TABLE as f64;
        let last = self.potential.len() - 2;
        let i = (place.max(0.0) as usize).min(last);
        let (share, ends) = (place - i as f64, [self.potential[i], self.potential[i + 1]]);
        0.5 * MASS * v * v + ends[0] + share * (ends[1] - ends[0])
    }

    /// Energy at the end of a run in steps of `h` [s] over that at its start.
    fn left(&self, scheme: Scheme, damping: f64, steps: u32) -> Result<f64, Box<dyn Error>> {
        let mut unit = Unit::new(damping)?;
        let mut motion = [self.balanced + START, 0.0];
        let start = self.energy(motion);
        let h = DURATION / f64::from(steps);
        for _ in 0..steps {
            motion = scheme.step(&mut unit, motion, h)?;
        }
        Ok(self.energy(motion) / start)
    }

    /// Whether small swings grow: a step takes height and velocity to new ones by a matrix whose
    /// greatest eigenvalue tells it.
    fn grows(&self, scheme: Scheme, damping: f64, h: f64) -> Result<bool, Box<dyn Error>> {
        let mut unit = Unit::new(damping)?;
        let swing = [2e-8, 2e-5];
        let mut map = [[0.0; 2]; 2];
        for j in 0..2 {
            for sign in [1.0, -1.0] {
                let mut motion = [self.balanced, 0.0];
                motion[j] += sign * swing[j];
                let next = scheme.step(&mut unit, motion, h)?;
                for i in 0..2 {
                    let from_rest = next[i] - [self.balanced, 0.0][i];
                    map[i][j] += sign * from_rest / (2.0 * swing[i]);
                }
            }
        }
        let half_trace = 0.5 * (map[0][0] + map[1][1]);
        let determinant = map[0][0] * map[1][1] - map[0][1] * map[1][0];
        let rest = half_trace * half_trace - determinant;
        let greatest =
            if rest > 0.0 { half_trace.abs() + rest.sqrt() } else { determinant.max(0.0).sqrt() };
        Ok(greatest > 1.0 + RESOLUTION)
    }

    /// The longest step with which small swings do not grow, 0 if that is below `SHORTEST`; nothing
    /// if there is none up to `LONGEST` [s].
    fn longest(&self, scheme: Scheme, damping: f64) -> Result<Option<f64>, Box<dyn Error>> {
        let (mut stable, mut growing) = (SHORTEST, LONGEST);
        if !self.grows(scheme, damping, growing)? {
            return Ok(None);
        }
        if self.grows(scheme, damping, stable)? {
            return Ok(Some(0.0));
        }
        while growing / stable > 1.001 {
            let middle = f64::sqrt(stable * growing);
            if self.grows(scheme, damping, middle)? { growing = middle } else { stable = middle }
        }
        Ok(Some(stable))
    }
}

pub fn draw(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let rest = Rest::new()?;
    println!(
        "scheme,longest_step_ms,longest_step_without_damping_ms,energy_error_percent,\
         energy_error_without_damping_percent,forces_per_step,derivatives_per_step"
    );
    let file = arguments.first();
    let damped = rest.left(Scheme::Iterated, 1e5, 10_000)?;
    let mut panels = [Vec::new(), Vec::new()];
    for scheme in SCHEMES {
        let mut limits = [None; 2];
        let mut errors = [0.0; 2];
        for (i, (damping, wanted)) in [(1e5, damped), (0.0, 1.0)].into_iter().enumerate() {
            limits[i] = rest.longest(scheme, damping)?;
            let error =
                |steps: u32| Ok::<f64, Box<dyn Error>>(rest.left(scheme, damping, steps)? - wanted);
            errors[i] = error((DURATION / TABLE_STEP) as u32)?;
            let mut points = Vec::new();
            // 1 µs to 2.4 ms, for a figure.
            for k in (0..=27).filter(|_| file.is_some()) {
                let steps = (DURATION / 10f64.powf(-6.0 + f64::from(k) / 8.0)).round();
                points.push([DURATION / steps, error(steps as u32)?.abs()]);
            }
            panels[i].push(Curve { scheme, points, limit: limits[i] });
        }
        let mut unit = Unit::new(1e5)?;
        let mut motion = [rest.balanced + START, 0.0];
        for _ in 0..100 {
            motion = scheme.step(&mut unit, motion, TABLE_STEP)?;
        }
        let limit = |limit: Option<f64>| match limit {
            Some(h) => format!("{:.3}", 1e3 * h),
            None => "any".into(),
        };
        println!(
            "{},{},{},{:.3},{:.3},{:.1},{:.1}",
            scheme.name(),
            limit(limits[0]),
            limit(limits[1]),
            1e2 * errors[0],
            1e2 * errors[1],
            f64::from(unit.evaluations) / 100.0,
            f64::from(unit.derivatives) / 100.0,
        );
    }
    file.map_or(Ok(()), |file| figure::save(file, &panels))
}
