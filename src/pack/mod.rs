//! A unit rewritten as the user's own: his profiles, waves and friction tables in its resources, his
//! values as its start values, his name and picture on it. No compiler is needed, and the libraries
//! of all platforms stay.
//!
//! ```text
//! error        why a unit is not packed
//! source       the archive that is rewritten
//! files        files that go into the resources, and what they are called there
//! description  modelDescription.xml with other start values
//! dummy_state  what a description with a dummy state has besides
//! page         what documentation/index.html says of the user's unit
//! check        whether an archive holds what it is to hold
//! ```

mod check;
mod description;
mod dummy_state;
mod error;
mod files;
mod page;
mod source;

use std::path::{Path, PathBuf};

use crate::element::subject::Subject;
use crate::element::{Element, Input, Parameters};
use crate::io::write_whole;
use crate::variables::{START_FILE, Unit, Values, Variable, WheelsetValues};
use crate::wheelset::Wheelset;
use description::Changes;
pub use error::PackError;
use files::Files;
use source::Source;

/// A unit under way.
pub struct Pack {
    source: Source,
    values: UnitValues,
    files: Files,
    name: Option<String>,
    description: Option<String>,
    pictures: Option<Pictures>,
    has_dummy_state: bool,
}

/// Pictures of the contact.
#[derive(Clone, Debug)]
pub struct Pictures {
    /// For the documentation, SVG.
    pub figure: Vec<u8>,
    /// The icon of the unit, PNG.
    pub icon: Vec<u8>,
}

/// The values of a unit, whichever it is.
enum UnitValues {
    Wheel(Box<Values>),
    Wheelset(Box<WheelsetValues>),
}

/// The same lines for the values of any unit.
macro_rules! on_values {
    ($any:expr, |$values:ident| $body:expr) => {
        match $any {
            UnitValues::Wheel($values) => $body,
            UnitValues::Wheelset($values) => $body,
        }
    };
}

impl Pack {
    /// Begins with a unit of this crate, which may be packed already.
    ///
    /// # Errors
    /// If it cannot be read or is no unit of this crate.
    pub fn open(source: &Path) -> Result<Self, PackError> {
        let source = Source::read(source)?;
        let text = source.text(&format!("resources/{START_FILE}")).unwrap_or_default();
        let broken = |problem| {
            let (file, problem) = (source.path.clone(), Box::new(problem));
            PackError::StartFile { file, problem }
        };
        let values = if source.unit.guid == crate::variables::WHEELSET.guid {
            UnitValues::Wheelset(Box::new(WheelsetValues::from_start_file(&text).map_err(broken)?))
        } else {
            UnitValues::Wheel(Box::new(Values::from_start_file(&text).map_err(broken)?))
        };
        let files = Files::new(source.profiles());
        Ok(Self {
            source,
            values,
            files,
            name: None,
            description: None,
            pictures: None,
            has_dummy_state: false,
        })
    }

    /// Whose variables it has.
    pub fn unit(&self) -> &'static Unit {
        self.source.unit
    }

    /// Sets a start value. A file goes into the resources; a relative one is looked for in the
    /// working directory, then among those that the unit has.
    ///
    /// # Errors
    /// Variable and value: a name that no variable has, a value that is not admitted, a file that is
    /// not there.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), PackError> {
        let variable =
            self.unit().find(name).map_err(|unknown| PackError::Unknown(Box::new(unknown)))?;
        if value.contains(['\n', '\r']) {
            return Err(PackError::Lines { name: variable.name });
        }
        let value = self.files.take(variable, value.trim())?;
        on_values!(&mut self.values, |values| values.set_from_text(variable, &value))?;
        Ok(())
    }

    /// Sets the profile of the wheel, of a wheelset of both.
    ///
    /// # Errors
    /// As [`set`](Self::set).
    pub fn set_wheel(&mut self, profile: &str) -> Result<(), PackError> {
        self.set_on_sides("wheel.profile", profile)
    }

    /// Sets the profile of the rail, of a wheelset of both.
    ///
    /// # Errors
    /// As [`set`](Self::set).
    pub fn set_rail(&mut self, profile: &str) -> Result<(), PackError> {
        self.set_on_sides("rail[1].profile", profile)
    }

    fn set_on_sides(&mut self, name: &str, value: &str) -> Result<(), PackError> {
        let prefixes = on_values!(&self.values, |values| prefixes(values));
        prefixes.iter().try_for_each(|prefix| self.set(&format!("{prefix}{name}"), value))
    }

    /// Names the model.
    ///
    /// # Errors
    /// If there is nothing in it.
    pub fn set_name(&mut self, name: &str) -> Result<(), PackError> {
        if name.trim().is_empty() || name.contains(char::is_control) {
            return Err(PackError::BadName { name: name.into() });
        }
        self.name = Some(name.trim().into());
        Ok(())
    }

    /// Describes the model.
    pub fn set_description(&mut self, description: &str) {
        let words: Vec<&str> = description.split_whitespace().collect();
        self.description = Some(words.join(" "));
    }

    /// Gives model exchange a dummy state, der(x) = 0, for importers that cannot integrate a unit
    /// without states; a unit that has it keeps it.
    pub fn add_dummy_state(&mut self) {
        self.has_dummy_state = true;
    }

    /// Takes over pictures of the contact.
    pub fn set_pictures(&mut self, pictures: Pictures) {
        self.pictures = Some(pictures);
    }

    /// Parameters and starting input of the wheel, of a wheelset of its right one, and the folders in
    /// which its files lie while it is packed.
    ///
    /// # Errors
    /// What is at fault with a parameter, a profile or the input.
    pub fn first_wheel(&self) -> Result<(Parameters, Input, tempfile::TempDir), PackError> {
        let folder = self.unpacked_files()?;
        let folders = [folder.path().to_path_buf()];
        let (parameters, input) = match &self.values {
            UnitValues::Wheel(values) => {
                let (_, input) = evaluated::<Element>(values, &folders)?;
                (values.parameters.clone(), input)
            }
            UnitValues::Wheelset(values) => {
                let (_, input) = evaluated::<Wheelset>(values, &folders)?;
                (Wheelset::parameters_of_elements(&values.parameters)[0].clone(), input)
            }
        };
        Ok((parameters, input, folder))
    }

    /// The files of the resources in a folder of their own, as an importer unpacks them.
    fn unpacked_files(&self) -> Result<tempfile::TempDir, PackError> {
        self.files.unpacked().map_err(|e| PackError::Write {
            file: std::env::temp_dir().display().to_string(),
            reason: e.to_string(),
        })
    }

    /// Writes the archive `path`, once it is found to hold what it is to hold.
    ///
    /// # Errors
    /// What is at fault; nothing is written then.
    pub fn write(&self, path: &Path) -> Result<(), PackError> {
        let name = self.name.as_deref();
        let start = |v: &Variable| on_values!(&self.values, |values| description::start(values, v));
        let changes = Changes {
            name,
            description: self.description.as_deref(),
            unit: self.unit(),
            start: &start,
            adds_state: self.has_dummy_state && !self.source.has_state,
        };
        let mut entries = self.files.entries();
        let xml = description::rewritten(&self.source.description, &changes)?;
        entries.insert("modelDescription.xml".into(), xml.into_bytes());
        let starts = on_values!(&self.values, |values| values.start_file());
        let about = page::About {
            name: name.unwrap_or(&self.source.model_name),
            description: self.description.as_deref().unwrap_or_default(),
            starts: &starts,
            files: self.files.taken(),
            has_figure: self.pictures.is_some(),
        };
        let index = "documentation/index.html";
        let page = page::with(&self.source.text(index).unwrap_or_default(), &about);
        entries.insert(index.into(), page.into_bytes());
        entries.insert(format!("resources/{START_FILE}"), starts.into_bytes());
        if let Some(pictures) = &self.pictures {
            entries.insert("documentation/contact.svg".into(), pictures.figure.clone());
            entries.insert(self.source.icon().into(), pictures.icon.clone());
        }
        let bytes = self.source.rewritten(&entries)?;
        on_values!(&self.values, |values| check::archive(&bytes, values))?;
        let failed = |reason: String| PackError::Write { file: path.display().to_string(), reason };
        write_whole(path, &bytes).map_err(|e| failed(e.to_string()))?;
        match std::fs::read(path) {
            Ok(written) if written == bytes => Ok(()),
            Ok(_) => Err(failed("what was read back is not what was written".into())),
            Err(e) => Err(failed(e.to_string())),
        }
    }
}

fn prefixes<S: Subject>(_: &crate::variables::ValuesOf<S>) -> &'static [&'static str] {
    S::PREFIXES
}

/// The subject of the values, and the input of its first element where it was evaluated.
fn evaluated<S: crate::variables::Described>(
    values: &crate::variables::ValuesOf<S>,
    folders: &[PathBuf],
) -> Result<(S, Input), PackError> {
    let mut subject = S::prepare(&values.parameters, &values.input, folders)?;
    let mut output = S::Output::default();
    subject.evaluate_all(&values.input, &mut output)?;
    let input = subject.input_of_element(0, &values.input, &output);
    Ok((subject, input))
}
