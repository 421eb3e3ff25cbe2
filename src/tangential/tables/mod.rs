//! Creep forces of Hertzian ellipses in steady rolling from a table of boundary element solutions.
//!
//! Source of the idea: Kalker's book of tables (USETAB, 1996). Everything is in the units of the
//! ellipse: t = ln(a/b), lengths over c = sqrt(a b), forces over μ N, moments over μ N c, and
//! creepages v = G c² (ξ, η, c φ)/(μ N). With Kalker's coefficients, the scales ([`scales`]) and s
//!
//! ```text
//! X = (c11 v1, c22 v2, ζ v3),  ρ = |X|,  s = ρ/(ρ + 3/2),  ζ = c23 + 0.3 c11 sqrt(b/a)
//! F = (1 - s)² F_linear(v, t) + s² (F_sliding(v, t) + (1 - s) K(s, X/ρ, t))
//! F_linear = -(c11 v1, c22 v2 + c23 v3, -c23 v2 + c33 v3)
//! ```
//!
//! so that the linear law is met for small and full sliding for great creepages whatever K is. K is
//! what was tabulated: 13 ellipses of a/b 0.05 to 20, 11 saturations, 241 directions (`direction`),
//! ν = 0.28, interpolated by cubic splines; F_sliding is exact at the nodes of its own table and
//! without spin ([`sliding`]). Poisson's ratio enters through the coefficients alone. The forces
//! have continuous derivatives everywhere. Beyond a/b 0.05 to 20 the linear law goes on, K and
//! F_sliding come to rest within a tenth.

mod bound;
pub(crate) mod coefficients;
pub(crate) mod direction;
mod ellipse_force;
pub(crate) mod exact;
pub mod generate;
pub(crate) mod interpolated;
pub mod nodes;
pub mod scales;
pub mod sliding;
pub(crate) mod splines;
mod table;
pub(crate) mod tabulated;

pub use ellipse_force::{EllipseForce, ForceSlopes};
pub use table::CreepForceTable;
