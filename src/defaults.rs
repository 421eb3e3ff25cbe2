//! Structs whose default values stand beside their fields.

/// A struct with fields of the form `field: Type = value`: the values are those of its `Default`,
/// and the documentation of each field tells its own, in the unit of the field.
macro_rules! with_defaults {
    (
        $(#[$about:meta])*
        pub struct $name:ident $(<$number:ident = $plain:ty>)? {
            $($(#[$meaning:meta])* pub $field:ident: $type:ty = $value:expr,)*
        }
    ) => {
        $(#[$about])*
        pub struct $name $(<$number = $plain>)? {
            $(
                $(#[$meaning])*
                #[doc = ""]
                #[doc = concat!("Default: `", stringify!($value), "`.")]
                pub $field: $type,
            )*
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $value,)* }
            }
        }
    };
}
pub(crate) use with_defaults;
