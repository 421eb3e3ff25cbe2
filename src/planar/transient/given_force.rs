//! The rigid displacement of a step at which the contact carries given creep forces.
//!
//! Force falls with displacement, strictly as long as an element sticks: Newton's method with
//! slopes from differences, shortened until the force comes nearer. Where all slides force has no
//! slope; the displacement is halved then until some sticks.

/// What a displacement leads to.
pub trait Forces {
    /// Solution at one displacement.
    type Found;

    /// Solution for the rigid displacement (x, y) of a step [m] and its forces [N]; `near` is that
    /// of one close by.
    fn at(&mut self, displacement: [f64; 2], near: Option<&Self::Found>)
    -> (Self::Found, [f64; 2]);
}

/// Errors of the force, over the friction limit, at which a displacement is accepted [-].
const FOUND: f64 = 1e-6;

/// Change of the force by which its slopes are found, over the friction limit [-].
const PROBE: f64 = 1e-3;

/// Newton steps, and halvings of each.
const MAX_STEPS: usize = 60;
const MAX_HALVINGS: usize = 6;

/// The displacement and solution at which the components of the force that are `given` are met,
/// from the displacement `start`; components that are not given stay. Nothing where none is found.
///
/// `limit` is the friction limit [N], `compliance` about the displacement over the force of a step
/// without slip [m/N].
pub fn displacement_for<F: Forces>(
    forces: &mut F,
    given: [Option<f64>; 2],
    start: [f64; 2],
    limit: f64,
    compliance: f64,
) -> Option<([f64; 2], F::Found)> {
    let unknown: Vec<usize> = (0..2).filter(|&c| given[c].is_some()).collect();
    let missing = |force: [f64; 2]| {
        let mut missing = [0.0; 2];
        for &c in &unknown {
            missing[c] = given[c].unwrap_or(0.0) - force[c];
        }
        missing
    };
    let size = |missing: [f64; 2]| missing[0].hypot(missing[1]);
    let mut at = start;
    let (mut found, mut force) = forces.at(at, None);
    let mut compliances = [compliance; 2];
    for _ in 0..MAX_STEPS {
        let rest = missing(force);
        if size(rest) <= FOUND * limit {
            return Some((at, found));
        }
        // Slopes of the force (row) by displacement (column), the identity for those not sought.
        let mut slopes = [[-1.0, 0.0], [0.0, -1.0]];
        let mut slides = true;
        for &c in &unknown {
            // Towards the force that is sought.
            let probe = -PROBE * limit * compliances[c] * rest[c].signum();
            let mut moved = at;
            moved[c] += probe;
            let (_, other) = forces.at(moved, Some(&found));
            for &row in &unknown {
                slopes[row][c] = (other[row] - force[row]) / probe;
            }
            let change = (other[c] - force[c]).abs() / (PROBE * limit);
            slides &= change < SLIDING;
            compliances[c] *= (1.0 / change).clamp(0.1, 10.0);
        }
        let determinant = slopes[0][0] * slopes[1][1] - slopes[0][1] * slopes[1][0];
        let mut step = [
            (rest[0] * slopes[1][1] - slopes[0][1] * rest[1]) / determinant,
            (slopes[0][0] * rest[1] - slopes[1][0] * rest[0]) / determinant,
        ];
        let fits = step.iter().all(|s| s.is_finite()) && determinant > 0.0 && !slides;
        // Slopes of a contact that all but slides say nothing of far away.
        let most = 2.0 * (at[0].hypot(at[1]) + limit * compliance);
        let long = (step[0].hypot(step[1]) / most).max(1.0);
        step = step.map(|s| s / long);
        let mut nearer = None;
        for _ in 0..if fits { MAX_HALVINGS } else { 0 } {
            let trial = [at[0] + step[0], at[1] + step[1]];
            let (solution, force) = forces.at(trial, Some(&found));
            if size(missing(force)) < size(rest) {
                nearer = Some((trial, solution, force));
                break;
            }
            step = step.map(|s| 0.5 * s);
        }
        (at, found, force) = nearer.unwrap_or_else(|| {
            for &c in &unknown {
                at[c] *= 0.5;
            }
            compliances = [compliance; 2];
            let (found, force) = forces.at(at, Some(&found));
            (at, found, force)
        });
    }
    None
}

/// Change of the force in a probe, over that without slip, below which all slides [-].
const SLIDING: f64 = 1e-4;

#[cfg(test)]
mod tests {
    use super::*;

    /// Force that saturates at 1 N.
    struct Saturating(usize);

    impl Forces for Saturating {
        type Found = ();

        fn at(&mut self, displacement: [f64; 2], _: Option<&()>) -> ((), [f64; 2]) {
            self.0 += 1;
            let size = displacement[0].hypot(displacement[1]);
            let share = if size > 1.0 { 1.0 / size } else { 1.5 - 0.5 * size * size };
            ((), displacement.map(|d| -share * d))
        }
    }

    #[test]
    fn forces_up_to_the_limit_are_met_from_anywhere() {
        for start in [[0.0; 2], [0.4, -0.2], [50.0, 3.0], [-9.0, 9.0]] {
            for given in [
                [Some(0.999), None],
                [None, Some(-0.4)],
                [Some(-0.6), Some(0.79)],
                [Some(0.0), Some(0.0)],
            ] {
                let mut forces = Saturating(0);
                let found = displacement_for(&mut forces, given, start, 1.0, 1.0);
                let (found, ()) = found.unwrap_or_else(|| panic!("{start:?} {given:?}"));
                let ((), force) = forces.at(found, None);
                for c in 0..2 {
                    match given[c] {
                        Some(given) => assert!((force[c] - given).abs() < 2e-6, "{force:?}"),
                        None => assert!((found[c] - start[c]).abs() < 1e-15),
                    }
                }
                assert!(forces.0 <= 61, "{start:?} {given:?}: {}", forces.0);
            }
        }
        let given = [Some(1.1), None];
        assert!(displacement_for(&mut Saturating(0), given, [0.1; 2], 1.0, 1.0).is_none());
    }
}
