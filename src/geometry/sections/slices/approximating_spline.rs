//! Surfaces that pass near their slices and not through them: splines with the slices as control
//! points.

/// Values at the places of the cubic B-spline that has these as knots and `values` as control
/// points, as CONTACT's approximating surfaces; both ends stay.
///
/// On even places (v₋ + 4 v + v₊)/6.
pub(super) fn near(places: &[f64], values: &[f64]) -> Vec<f64> {
    let mut smooth = values.to_vec();
    let last = values.len().saturating_sub(1);
    for i in 1..last {
        let [a, b, c] = [i - 1, i, i + 1].map(|k| places[k]);
        // Beyond the ends places go on evenly.
        let before = if i > 1 { places[i - 2] } else { 2.0 * a - b };
        let behind = if i + 1 < last { places[i + 2] } else { 2.0 * c - b };
        let first = (c - b).powi(2) / ((c - a) * (c - before));
        let next = (b - a).powi(2) / ((c - a) * (behind - a));
        smooth[i] += first * (values[i - 1] - values[i]) + next * (values[i + 1] - values[i]);
    }
    smooth
}

#[cfg(test)]
mod tests {
    use super::near;
    use approx::assert_relative_eq;

    #[test]
    fn control_points_at_means_of_three_uneven_places_are_a_straight_line() {
        let places = [0.0, 1.0, 1.5, 3.0, 3.2, 3.4, 5.0, 9.0];
        let mut means = places.to_vec();
        for i in 1..places.len() - 1 {
            means[i] = (places[i - 1] + places[i] + places[i + 1]) / 3.0;
        }
        for (found, place) in near(&places, &means).iter().zip(places).skip(2).take(4) {
            assert_relative_eq!(*found, place, epsilon = 1e-12);
        }
    }
}
