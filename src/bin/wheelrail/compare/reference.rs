//! How the reference is solved.

use wheelrail::element::parameters::TangentialModel;

/// Half as many elements along and across.
pub fn half(elements: [usize; 2]) -> [usize; 2] {
    elements.map(|count| count.div_ceil(2))
}

/// Boundary elements, if there is anything to compare.
pub fn reference_tangential(own: TangentialModel) -> TangentialModel {
    if own == TangentialModel::None { own } else { TangentialModel::BoundaryElement }
}
