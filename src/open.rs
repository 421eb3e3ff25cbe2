//! What keeps the literals of a struct open.

/// A field that programs of others cannot name. Their literals of the struct end with
/// `..Default::default()`, so that one more field later breaks none of them; fields are read and
/// written as those of any struct. (`#[non_exhaustive]` would forbid such literals.)
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Open(());
