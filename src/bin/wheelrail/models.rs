//! The models of a case: their names and whether they take long.

use wheelrail::element::parameters::{NormalModel, TangentialModel};

/// Whether a solution takes milliseconds.
pub fn is_slow(normal: NormalModel, tangential: TangentialModel) -> bool {
    normal == NormalModel::BoundaryElement || tangential == TangentialModel::BoundaryElement
}

/// Names of a normal and a tangential model, for titles.
pub fn names(normal: NormalModel, tangential: TangentialModel) -> String {
    format!("{} + {}", name(&normal), name(&tangential))
}

/// The name of a model as variables have it: `PiotrowskiKik` is `piotrowski_kik`.
fn name(model: &impl std::fmt::Debug) -> String {
    let mut name = String::new();
    for letter in format!("{model:?}").chars() {
        if letter.is_uppercase() && !name.is_empty() {
            name.push('_');
        }
        name.extend(letter.to_lowercase());
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn models_have_the_names_of_their_variables() {
        let named = names(NormalModel::PiotrowskiKik, TangentialModel::BoundaryElement);
        assert_eq!(named, "piotrowski_kik + boundary_element");
    }
}
