//! The archive that is rewritten.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{Cursor, Read, Write};
use std::path::Path;

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipArchive, ZipWriter};

use super::description;
use super::error::PackError;
use super::files::FOLDER;
use crate::variables::{Unit, WHEEL, WHEELSET, unit_of};

/// A unit of this crate as an archive.
pub struct Source {
    /// Where it lies.
    pub path: String,
    /// Whose variables it has.
    pub unit: &'static Unit,
    /// `modelDescription.xml`.
    pub description: String,
    /// Whether it is with a dummy state.
    pub has_state: bool,
    /// `modelName`.
    pub model_name: String,
    bytes: Vec<u8>,
    /// All but the libraries, by their names.
    entries: BTreeMap<String, Vec<u8>>,
}

/// Contents of an archive but for its libraries, and the names of these.
type Contents = (BTreeMap<String, Vec<u8>>, BTreeSet<String>);

/// Reads an archive as a whole: checksums are checked on the way.
pub fn contents(bytes: &[u8]) -> Result<Contents, String> {
    let failed = |e: zip::result::ZipError| e.to_string();
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(failed)?;
    let (mut entries, mut libraries) = (BTreeMap::new(), BTreeSet::new());
    for index in 0..archive.len() {
        let mut entry = archive.by_index(index).map_err(failed)?;
        let name = entry.name().map_err(failed)?.into_owned();
        if entry.is_dir() {
            continue;
        }
        if name.starts_with("binaries/") {
            libraries.insert(name);
            continue;
        }
        let mut content = Vec::new();
        entry.read_to_end(&mut content).map_err(|e| format!("{name}: {e}"))?;
        entries.insert(name, content);
    }
    Ok((entries, libraries))
}

impl Source {
    /// Reads the archive `path`.
    pub fn read(path: &Path) -> Result<Self, PackError> {
        let file = path.display().to_string();
        let failed = |reason: String| PackError::Source { file: file.clone(), reason };
        let bytes = std::fs::read(path).map_err(|e| failed(e.to_string()))?;
        let (entries, _) = contents(&bytes).map_err(failed)?;
        let xml = entries.get("modelDescription.xml");
        let xml = xml.ok_or_else(|| failed("it has no modelDescription.xml".into()))?;
        let xml = String::from_utf8(xml.clone()).map_err(|e| failed(e.to_string()))?;
        let identity = description::identity(&xml).map_err(failed)?;
        let known = unit_of(&identity.token, &[&WHEEL, &WHEELSET]);
        let Some((unit, has_state)) = known else {
            let found = identity.token;
            let (wheel, wheelset) = (WHEEL.guid, WHEELSET.guid);
            return Err(PackError::Foreign { file, found, wheel, wheelset });
        };
        let model_name = identity.model_name;
        Ok(Self { path: file, unit, has_state, description: xml, model_name, bytes, entries })
    }

    /// An entry that is a text.
    pub fn text(&self, name: &str) -> Option<String> {
        self.entries.get(name).map(|bytes| String::from_utf8_lossy(bytes).into_owned())
    }

    /// The files beside its libraries.
    pub fn profiles(&self) -> BTreeMap<String, Vec<u8>> {
        let within = |name: &str| name.strip_prefix(FOLDER).map(str::to_owned);
        self.entries.iter().filter_map(|(name, c)| Some((within(name)?, c.clone()))).collect()
    }

    /// Where the icon is: FMI 3.0 has a folder for it.
    pub fn icon(&self) -> &'static str {
        let of_fmi_3 = "terminalsAndIcons/icon.png";
        if self.entries.contains_key(of_fmi_3) { of_fmi_3 } else { "model.png" }
    }

    /// The archive with these entries in the place of its own, sorted and without a date: the same
    /// entries give the same bytes.
    pub fn rewritten(&self, entries: &BTreeMap<String, Vec<u8>>) -> Result<Vec<u8>, PackError> {
        self.zip(entries)
            .map_err(|e| PackError::Source { file: self.path.clone(), reason: e.to_string() })
    }

    fn zip(&self, entries: &BTreeMap<String, Vec<u8>>) -> zip::result::ZipResult<Vec<u8>> {
        let mut archive = ZipArchive::new(Cursor::new(&self.bytes))?;
        let mut own = BTreeMap::new();
        for index in 0..archive.len() {
            own.insert(archive.by_index_raw(index)?.name()?.into_owned(), index);
        }
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .last_modified_time(DateTime::DEFAULT)
            .unix_permissions(0o644);
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        let names: BTreeSet<&String> = own.keys().chain(entries.keys()).collect();
        for name in names {
            if let Some(content) = entries.get(name) {
                writer.start_file(name.as_str(), options)?;
                writer.write_all(content)?;
            } else {
                writer.raw_copy_file(archive.by_index_raw(own[name])?)?;
            }
        }
        Ok(writer.finish()?.into_inner())
    }
}
