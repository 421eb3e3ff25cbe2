//! Vectors of three components.

/// a × b.
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a · b.
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// a + b.
pub fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] + b[i])
}

/// Fails where a component is further off than `allowed`.
pub fn assert_close(found: [f64; 3], expected: [f64; 3], allowed: f64, what: &str) {
    for i in 0..3 {
        let miss = (found[i] - expected[i]).abs();
        assert!(miss <= allowed, "{what}: {found:?}, expected {expected:?}");
    }
}
