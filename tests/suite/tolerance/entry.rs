//! One tolerance, and how tolerances are written.

/// What a test holds a quantity to; numbers as they are written.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance {
    /// Name of the constant.
    pub name: &'static str,
    /// Quantity and what it is compared with, then a colon and the reason.
    pub text: &'static str,
    /// What the test allows.
    pub bound: &'static str,
    /// What is aimed at.
    pub target: Target,
}

/// What is aimed at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// What the test allows.
    Bound,
    /// Less than that.
    Less(&'static str),
    /// Nothing: the error is that of the model, and is kept from growing.
    None,
}

/// The constants, and `TABLE` of them. `target` says what is aimed at where that is less than the
/// bound, `kept` that the error is the model's own and is kept from growing.
macro_rules! tolerances {
    (@target) => { super::entry::Target::Bound };
    (@target target $target:expr) => { super::entry::Target::Less(stringify!($target)) };
    (@target kept) => { super::entry::Target::None };
    ($($(#[doc = $text:literal])* $name:ident: $type:ty = $bound:expr
        $(, $word:ident $($target:expr)?)?;)*) => {
        $($(#[doc = $text])* pub const $name: $type = $bound;)*

        pub const TABLE: &[super::entry::Tolerance] = &[$(super::entry::Tolerance {
            name: stringify!($name),
            text: concat!($($text),*),
            bound: stringify!($bound),
            target: super::entry::tolerances!(@target $($word $($target)?)?),
        }),*];
    };
}
pub(super) use tolerances;

impl Tolerance {
    /// The quantity and what it is compared with.
    pub fn quantity(&self) -> &str {
        self.text.split_once(": ").map_or(self.text, |(quantity, _)| quantity).trim()
    }

    /// Why it is as large as it is.
    pub fn reason(&self) -> &str {
        self.text.split_once(": ").map_or("", |(_, reason)| reason).trim()
    }
}
