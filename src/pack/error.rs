//! Why a unit is not packed.

use crate::error::ContactError;
use crate::variables::{StartFileError, UnknownVariable};

/// Why a unit is not packed; nothing is written then.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PackError {
    /// An archive that cannot be read.
    #[error("{file} cannot be read as a unit: {reason}")]
    Source {
        /// The archive.
        file: String,
        /// Why.
        reason: String,
    },
    /// A unit of other software, or of another build of this one.
    #[error(
        "{file} is of the unit \"{found}\", this program packs \"{wheel}\" (WheelRail) and \"{wheelset}\" (WheelSet): take the unit that was built with it"
    )]
    Foreign {
        /// The archive.
        file: String,
        /// GUID or instantiation token in it.
        found: String,
        /// That of the wheel unit.
        wheel: &'static str,
        /// That of the wheelset unit.
        wheelset: &'static str,
    },
    /// A source that was packed and is damaged.
    #[error("{file}, resources/start_values.txt, {problem}")]
    StartFile {
        /// The archive.
        file: String,
        /// What is wrong.
        problem: Box<StartFileError>,
    },
    /// A name that no variable has.
    #[error(transparent)]
    Unknown(Box<UnknownVariable>),
    /// A value or a profile that is not admitted.
    #[error(transparent)]
    Contact(Box<ContactError>),
    /// A value of several lines.
    #[error("{name}: a value of several lines is not admitted")]
    Lines {
        /// The variable.
        name: &'static str,
    },
    /// A name that is none.
    #[error("the model name \"{name}\" is not admitted: at least a letter, without line breaks")]
    BadName {
        /// What was given.
        name: String,
    },
    /// A file that is not there.
    #[error("{name} = \"{value}\": there is no such file (looked for {looked_for})")]
    NoFile {
        /// The variable.
        name: &'static str,
        /// What it was set to.
        value: String,
        /// Where it could have been.
        looked_for: String,
    },
    /// A file that cannot be read.
    #[error("{name} = \"{value}\": {reason}")]
    Unreadable {
        /// The variable.
        name: &'static str,
        /// What it was set to.
        value: String,
        /// Why.
        reason: String,
    },
    /// A variable that the description of the source leaves out.
    #[error(
        "{name} is no variable of this unit, whose description is a shorter one: take the unit with all variables"
    )]
    NotDescribed {
        /// The variable.
        name: &'static str,
    },
    /// An archive that does not hold what it is to hold, which is a fault of this library.
    #[error("the packed unit is not sound: {reason}")]
    Unsound {
        /// What is wrong.
        reason: String,
    },
    /// A file that cannot be written.
    #[error("{file} cannot be written: {reason}")]
    Write {
        /// The file.
        file: String,
        /// Why.
        reason: String,
    },
}

impl From<ContactError> for PackError {
    fn from(error: ContactError) -> Self {
        Self::Contact(Box::new(error))
    }
}
