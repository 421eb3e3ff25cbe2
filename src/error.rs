//! Errors: why parameters, profiles, inputs and files are refused.
//!
//! No contact is a value, not an error; a broken invariant is a `debug_assert!`. Kernels over
//! strips and elements cannot fail: everything is validated where it enters.

use crate::geometry::profiles::profile::ProfileError;

/// Why a parameter, an input or a profile was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactError {
    /// A number outside its admitted range, not finite included.
    #[error("{name} = {value} is not admitted: {allowed}")]
    BadValue {
        /// FMU name of the variable, such as `wheel.nominal_radius`.
        name: String,
        /// The value that was refused.
        value: f64,
        /// What would be admitted, in words and with its unit.
        allowed: &'static str,
    },
    /// A text that names none of the admitted choices.
    #[error("{name} = \"{value}\" is not admitted: {allowed}")]
    BadText {
        /// FMU name of the variable.
        name: String,
        /// The text that was refused.
        value: String,
        /// What would be admitted.
        allowed: String,
    },
    /// A wheel or rail profile that cannot be had or used.
    #[error("{name}: {problem}")]
    Profile {
        /// FMU name of the parameter that named the profile, such as `wheel.profile`.
        name: String,
        /// What is wrong with it.
        problem: ProfileError,
    },
    /// Derivatives that there are none of: with these parameters, or at this input.
    #[error("no derivatives{}: {reason}", name.map(|name| format!(" with {name}")).unwrap_or_default())]
    NoDerivative {
        /// FMU name of the parameter with whose value there are none.
        name: Option<&'static str>,
        /// Why there are none.
        reason: &'static str,
    },
}

impl ContactError {
    /// A [`ContactError::BadValue`] from its parts.
    pub(crate) fn bad_value(name: impl Into<String>, value: f64, allowed: &'static str) -> Self {
        Self::BadValue { name: name.into(), value, allowed }
    }

    /// The same about a variable of another name.
    pub(crate) fn renamed(mut self, rename: impl Fn(&str) -> String) -> Self {
        match &mut self {
            Self::BadValue { name, .. }
            | Self::BadText { name, .. }
            | Self::Profile { name, .. } => *name = rename(name),
            // Says what it is about in words.
            Self::NoDerivative { .. } => {}
        }
        self
    }
}
