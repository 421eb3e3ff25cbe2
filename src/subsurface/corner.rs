//! What the corner of a loaded rectangle does in the half-space under it, in closed form.
//!
//! Constant traction (q_x, q_y, p) on a rectangle of the surface z = 0, z into the body, p pressing
//! on it. Boussinesq and Cerruti give the displacements by potentials, integrals over the loaded
//! area (Johnson, Contact Mechanics, 1985, eqs 3.2 to 3.7); ρ from the place of the load to the
//! point:
//!
//! ```text
//! K = ∬ ln(ρ + z)     V = ∂K/∂z = ∬ 1/ρ     Φ = ∬ (z ln(ρ + z) - ρ), ∂Φ/∂z = K
//!
//! 4πG u_x = p (-(1-2ν) K_x - z V_x) + q_x (2V + 2ν Φ_xx - z K_xx) + q_y (2ν Φ_xy - z K_xy)
//! 4πG u_z = p (2(1-ν) V - z V_z) + q_x ((1-2ν) K_x - z V_x) + q_y ((1-2ν) K_y - z V_y)
//! ```
//!
//! and Hooke's law the stresses (of pressure: Love 1929; of tractions: Kalker 1990, chapter 4):
//!
//! ```text
//! 2π σ_x  = p (2ν V_z - z V_xx - (1-2ν) K_xx) + q_x (2V_x + 2ν Φ_xxx - z K_xxx + 2ν V_x)
//!                                             + q_y (2ν V_y + 2ν Φ_xxy - z K_xxy)
//! 2π σ_z  = p (V_z - z V_zz) - q_x z V_xz - q_y z V_yz
//! 2π τ_xy = p (-(1-2ν) K_xy - z V_xy) + q_x (V_y + 2ν Φ_xxy - z K_xxy) + q_y (V_x + 2ν Φ_xyy - z K_xyy)
//! 2π τ_xz = -p z V_xz + q_x (V_z - z V_xx) - q_y z V_xy
//! ```
//!
//! u_y, σ_y and τ_yz likewise, x and y exchanged. The integral over a rectangle is the sum over its
//! corners, with the signs + - + - around it, of the indefinite one, x, y and z counted from the
//! corner and r their distance:
//!
//! ```text
//! V_x = ln(r + y)    V_y = ln(r + x)    K_xy = ln(r + z)    V_z = -arctan(x y/(z r))
//! K_xx = arctan(y/x) - arctan(y z/(x r)) = arctan(x y (x² + y²)/((x² r + y² z)(r + z)))
//! K_xx + K_yy + V_z = 0   Φ_xy = z ln(r + z) - r   Φ_xx = z K_xx - x V_x
//! V = x V_x + y V_y + z V_z   K_x = y K_xy + z V_x + x K_xx
//! ```
//!
//! The arc tangents are those of a quotient with a denominator that is never negative: there are no
//! branches to tell apart, on the surface, over the edges or along lines through corners.
//!
//! On the surface the logarithms have no bound where tractions jump from one element to the next,
//! which is the grid's doing. With blunt edges they are those of a depth √(z² + ε²): on an edge that
//! of a jump spread over an element of width h, whose mean is ln(h/2) - 1, so that ε = h/(2e).

use super::state::State;
use crate::math::arctangent::arctangent;
use crate::math::logarithm::ln;
use crate::math::vectors::with_vectors;

/// Corners taken at once.
pub const LANES: usize = 8;

/// Some corners of loaded rectangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corners {
    /// Their places [m].
    pub x: [f64; LANES],
    pub y: [f64; LANES],
    /// Sums of the tractions of the rectangles that meet there, along x, along y and into the body,
    /// each with the sign of the corner [Pa].
    pub traction: [[f64; LANES]; 3],
}

impl Corners {
    /// Room for corners: none of them loaded.
    pub const NONE: Self = Self { x: [0.0; LANES], y: [0.0; LANES], traction: [[0.0; LANES]; 3] };
}

/// Components in the order in which they are summed: stresses x, y, z, xy, yz, xz, displacements x,
/// y, z.
const COMPONENTS: usize = 9;

/// Displacement, times the shear modulus, and stress at `point`, whose depth is more than 0, under
/// all `corners`, in a body with Poisson's ratio `nu`; `blunt` is ε² [m²].
#[allow(clippy::needless_range_loop)] // All lists at once: what compiles to vectors.
pub fn state_under(corners: &[Corners], point: [f64; 3], nu: f64, blunt: f64) -> State {
    with_vectors(
        #[inline(always)]
        || {
            let mut sums = [[0.0; LANES]; COMPONENTS];
            for corners in corners {
                let Corners { x, y, traction: [qx, qy, p] } = corners;
                for l in 0..LANES {
                    let place = [point[0] - x[l], point[1] - y[l], point[2]];
                    let of = corner(place, nu, blunt, [qx[l], qy[l], p[l]]);
                    for (lanes, own) in sums.iter_mut().zip(of) {
                        lanes[l] += own;
                    }
                }
            }
            let total = sums.map(|lanes| lanes.iter().sum::<f64>() / (2.0 * std::f64::consts::PI));
            let [x, y, z, xy, yz, xz, ux, uy, uz] = total;
            State {
                displacement: [ux, uy, uz].map(|u| 0.5 * u),
                stress: [x, y, z, xy, yz, xz].into(),
            }
        },
    )
}

/// The components that one corner contributes, times 2π, the displacements times 4πG.
#[inline(always)]
fn corner([x, y, z]: [f64; 3], nu: f64, blunt: f64, [qx, qy, p]: [f64; 3]) -> [f64; COMPONENTS] {
    let (xx, yy, zz) = (x * x, y * y, z * z);
    let r = (xx + yy + zz).sqrt();
    let (r_x, r_y, r_z) = (sum(x, r, yy + zz), sum(y, r, xx + zz), r + z);
    let deeper = zz + blunt;
    let blunt_r = (xx + yy + deeper).sqrt();
    let v_x = ln(sum(y, blunt_r, xx + deeper));
    let v_y = ln(sum(x, blunt_r, yy + deeper));
    let k_xy = ln(blunt_r + z);
    let v_z = -arctangent(x * y, z * r);
    let k_xx = arctangent(x * y * (xx + yy), (xx * r + yy * z) * r_z);
    let k_yy = -k_xx - v_z;
    // Second derivatives of V, each times z.
    let z_r = z / r;
    let (z_v_xx, z_v_yy) = (z_r * x / r_y, z_r * y / r_x);
    let (z_v_xz, z_v_yz) = (z_r * z / r_y, z_r * z / r_x);
    let z_v_zz = -z_v_xx - z_v_yy;
    // -(2ν Φ_xxy - z K_xxy) and -(2ν Φ_xyy - z K_xyy).
    let of_shear = (2.0 * nu + z_r) / r_z;
    let (along_x, along_y) = (of_shear * x, of_shear * y);
    let compressible = 1.0 - 2.0 * nu;
    let sigma_x = p * (2.0 * nu * v_z - z_v_xx - compressible * k_xx)
        + qx * (2.0 * v_x + along_y + z_v_xz)
        + qy * (2.0 * nu * v_y - along_x);
    let sigma_y = p * (2.0 * nu * v_z - z_v_yy - compressible * k_yy)
        + qy * (2.0 * v_y + along_x + z_v_yz)
        + qx * (2.0 * nu * v_x - along_y);
    let sigma_z = p * (v_z - z_v_zz) - qx * z_v_xz - qy * z_v_yz;
    let tau_xy = qx * (v_y - along_x) + qy * (v_x - along_y) - p * (compressible * k_xy + z_r);
    let tau_yz = qy * (v_z - z_v_yy) - qx * z_r - p * z_v_yz;
    let tau_xz = qx * (v_z - z_v_xx) - qy * z_r - p * z_v_xz;
    let v = x * v_x + y * v_y + z * v_z;
    let (k_x, k_y) = (y * k_xy + z * v_x + x * k_xx, x * k_xy + z * v_y + y * k_yy);
    let (z_k_xx, z_k_yy, z_k_xy) = (z * k_xx, z * k_yy, z * k_xy);
    let sideways = 2.0 * nu * (z_k_xy - r) - z_k_xy;
    let u_x = qx * (2.0 * v + 2.0 * nu * (z_k_xx - x * v_x) - z_k_xx) + qy * sideways
        - p * (compressible * k_x + z * v_x);
    let u_y = qy * (2.0 * v + 2.0 * nu * (z_k_yy - y * v_y) - z_k_yy) + qx * sideways
        - p * (compressible * k_y + z * v_y);
    let u_z = p * (2.0 * (1.0 - nu) * v - z * v_z)
        + qx * (compressible * k_x - z * v_x)
        + qy * (compressible * k_y - z * v_y);
    [sigma_x, sigma_y, sigma_z, tau_xy, tau_yz, tau_xz, u_x, u_y, u_z]
}

/// r + x without cancellation; `others` is r² - x².
#[inline(always)]
fn sum(x: f64, r: f64, others: f64) -> f64 {
    let larger = r + x.abs();
    if x < 0.0 { others / larger } else { larger }
}
