//! The version of the standard through which a host talks to an instance, where messages have to
//! know it.

use std::fmt::{self, Display, Formatter};
use std::path::PathBuf;

use super::location;
use crate::variables::{Kind, Variable};

/// A version of the standard; shown as what the names of its functions begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interface {
    /// FMI 2.0.
    V2,
    /// FMI 3.0.
    V3,
}

impl Display for Interface {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::V2 => "fmi2",
            Self::V3 => "fmi3",
        })
    }
}

impl Interface {
    /// Its number.
    pub fn version(self) -> &'static str {
        match self {
            Self::V2 => "2.0",
            Self::V3 => "3.0",
        }
    }

    /// The name of a type of variables.
    pub fn type_name(self, kind: Kind) -> &'static str {
        match (self, kind) {
            (Self::V2, Kind::Real) => "Real",
            (Self::V2, Kind::Integer) => "Integer",
            (Self::V2, Kind::Enumeration(_)) => "Enumeration (set and read as Integer)",
            (Self::V3, Kind::Real) => "Float64",
            (Self::V3, Kind::Integer) => "Int32",
            (Self::V3, Kind::Enumeration(_)) => "Enumeration (set and read as Int64)",
            (_, Kind::Boolean) => "Boolean",
            (_, Kind::Text) => "String",
        }
    }

    /// The name of a variable, or of the array in which it is here.
    pub fn name(self, variable: &Variable) -> &'static str {
        variable.array.filter(|_| self == Self::V3).unwrap_or(variable.name)
    }

    /// What identifies the description that the host has read.
    pub fn identity(self) -> &'static str {
        match self {
            Self::V2 => "GUID",
            Self::V3 => "instantiation token",
        }
    }

    /// The argument that says where the resources lie, and what is admitted of it.
    pub fn location_argument(self) -> (&'static str, &'static str) {
        match self {
            Self::V2 => ("fmuResourceLocation", "a file: URI"),
            Self::V3 => ("resourcePath", "an absolute path"),
        }
    }

    /// The folder of resources that this argument names; `None` for what is not admitted. Hosts
    /// that know FMI 2.0 give a URI through FMI 3.0 too.
    pub fn resources(self, location: &str) -> Option<PathBuf> {
        match self {
            Self::V2 => location::of_uri(location),
            Self::V3 if location::is_uri(location) => location::of_uri(location),
            Self::V3 => location::of_path(location),
        }
    }
}
