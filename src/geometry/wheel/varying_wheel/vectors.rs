//! Vectors in coordinates along the axle, forward and down.

/// Shares of the vectors `a` and `b` in the part of `e` that lies in their plane.
pub fn in_plane(e: [f64; 3], a: [f64; 3], b: [f64; 3]) -> [f64; 2] {
    let [aa, ab, bb] = [dot(a, a), dot(a, b), dot(b, b)];
    let [ea, eb] = [a, b].map(|d| dot(e, d));
    let inverse = 1.0 / (aa * bb - ab * ab);
    [(ea * bb - eb * ab) * inverse, (eb * aa - ea * ab) * inverse]
}

/// The scalar product.
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The vector product.
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
