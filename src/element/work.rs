//! Counts of the work that evaluations take.

/// Work done and skipped since the element was made; tests assert it and benchmarks show what it
/// saves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Work {
    /// Evaluations asked for.
    pub evaluations: u64,
    /// Rails for which a bound showed that the wheel is lifted.
    pub lifted: u64,
    /// Contact searches.
    pub searches: u64,
    /// Points of a contact line whose distance from a rail was computed.
    pub distances: u64,
    /// Loaded zones with pressure.
    pub zones: u64,
    /// Zones marched through by the tangential model.
    pub marches: u64,
    /// Newton steps of the strip model.
    pub strip_steps: u64,
    /// The most of them for one rail in one evaluation.
    pub most_strip_steps: u64,
}
