//! The models and materials of an element's parameters, for a planar problem.

use crate::element::parameters::{Parameters, TangentialHistory};
use crate::element::rail::flattened::FlatContact;
use crate::error::ContactError;
use crate::material::Material;
use crate::planar::{Indentation, PlanarCase};

impl Parameters {
    /// Elastic constants of wheel and rails.
    pub fn materials(&self) -> [Material; 2] {
        let wheel = Material {
            young_modulus: self.wheel.young_modulus,
            poisson_ratio: self.wheel.poisson_ratio,
        };
        let rail = Material {
            young_modulus: self.rail_young_modulus,
            poisson_ratio: self.rail_poisson_ratio,
        };
        [wheel, rail]
    }

    /// A planar problem with the models, resolutions and materials of these parameters; see
    /// [`PlanarCase`] for the rest.
    pub fn planar_case<'a>(
        &self,
        separation: &'a [[f64; 2]],
        radius: f64,
        indentation: Indentation,
        creepage: [f64; 3],
        friction: f64,
    ) -> PlanarCase<'a> {
        let [wheel_material, rail_material] = self.materials();
        PlanarCase {
            separation,
            radius,
            indentation,
            creepage,
            friction,
            friction_across: &[],
            wheel_material,
            rail_material,
            normal_model: self.normal_model,
            virtual_penetration: self.virtual_penetration,
            shape_fit: self.shape_fit,
            tangential_model: self.tangential_model,
            strips: self.strips,
            elements_along: self.elements_along,
            elements: self.normal_elements,
            bound: self.bound,
            flexibilities: self.flexibilities,
            friction_law: self.friction_law,
            gauge_face_law: self.gauge_face_law,
            flash_temperature: self.flash_temperature,
            speed: 0.0,
        }
    }

    /// The planar problem of a `contact` of this element, where it rolls at `speed`, ≥ 0 [m/s]. It
    /// rolls steadily.
    ///
    /// # Errors
    /// Contacts that remember have other tractions.
    pub fn flat_case<'a>(
        &self,
        contact: &'a FlatContact,
        speed: f64,
    ) -> Result<PlanarCase<'a>, ContactError> {
        if self.tangential_history != TangentialHistory::Steady {
            return Err(ContactError::BadText {
                name: "tangential.history".into(),
                value: "transient".into(),
                allowed: "steady, for contacts laid flat one by one; what a wheel has left behind \
                          after a step is shown by TransientRun.loads and .fields of the Python \
                          package"
                    .into(),
            });
        }
        let approach = Indentation::Approach(contact.penetration);
        let FlatContact { separation, radius, creepage, friction, .. } = contact;
        let case = self.planar_case(separation, *radius, approach, *creepage, *friction);
        Ok(PlanarCase { speed, friction_across: &contact.friction_across, ..case })
    }
}
