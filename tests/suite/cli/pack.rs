//! `wheelrail pack`: units with the user's own files and values in them.

use std::fs::{self, File};

use super::*;
use crate::host::{Arguments, Host};
use crate::packaged;
use wheelrail::element::{Element, Output as Forces};
use wheelrail::fmi::v2::types::Status;
use wheelrail::fmi::v2::{
    fmi2EnterInitializationMode, fmi2ExitInitializationMode, fmi2Reset, fmi2SetupExperiment,
};
use wheelrail::pack::{Pack, PackError};
use wheelrail::variables::{Values, WHEELSET, find};

/// A folder with profiles of a user: a wheel, a rail, and a rail whose section varies.
fn own_files() -> TempDir {
    let folder = TempDir::new().unwrap();
    let worn = Path::new(env!("CARGO_MANIFEST_DIR")).join("fmu/resources/profiles/S1002_worn.txt");
    fs::copy(worn, folder.path().join("own wheel.txt")).unwrap();
    for (name, built_in) in [("own.csv", "54E1"), ("sections/end.csv", "60E1")] {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        let rail = wheelrail::io::load_profile("rail", built_in, ProfileKind::Rail, 0.0, &[]);
        wheelrail::io::save_profile("rail", &path, &rail.unwrap()).unwrap();
    }
    let list = "station_m,profile\n0,60E1\n10,sections/end.csv\n20,../else.csv\n";
    fs::create_dir(folder.path().join("varying")).unwrap();
    fs::rename(folder.path().join("sections"), folder.path().join("varying/sections")).unwrap();
    fs::copy(folder.path().join("varying/sections/end.csv"), folder.path().join("else.csv"))
        .unwrap();
    fs::write(folder.path().join("varying/crossing.txt"), list).unwrap();
    folder
}

fn text_of(path: &Path) -> String {
    path.to_str().unwrap().into()
}

fn entry(archive: &Path, name: &str) -> Vec<u8> {
    let mut archive = zip::ZipArchive::new(File::open(archive).unwrap()).unwrap();
    let mut bytes = Vec::new();
    let mut entry = archive.by_name(name).unwrap_or_else(|e| panic!("{name}: {e}"));
    std::io::Read::read_to_end(&mut entry, &mut bytes).unwrap();
    bytes
}

fn pack(unit: &str, target: &Path, more: &[&str]) -> Output {
    let source = text_of(&packaged::fmu().with_file_name(format!("{unit}.fmu")));
    let target = text_of(target);
    let fixed = ["pack", "--source", &source, "-o", &target];
    wheelrail(&fixed.iter().chain(more).copied().collect::<Vec<_>>())
}

/// A host with an instance of a packed unit, whose files lie in `folder`.
#[allow(clippy::unnecessary_box_returns, reason = "the logger has its address")]
fn host_of(archive: &Path, folder: &Path, guid: &str) -> Box<Host> {
    zip::ZipArchive::new(File::open(archive).unwrap()).unwrap().extract(folder).unwrap();
    let location = format!("file://{}/resources", folder.display());
    let arguments = Arguments {
        location: Some(std::ffi::CString::new(location).unwrap()),
        ..Arguments::default()
    };
    let arguments = Arguments { guid: Some(std::ffi::CString::new(guid).unwrap()), ..arguments };
    let host = Host::instantiate(&arguments);
    assert!(!host.component.is_null(), "{:?}", host.messages.lock().unwrap());
    host
}

fn initialized(host: &Host) {
    assert_eq!(fmi2SetupExperiment(host.component, 0, 0.0, 0.0, 0, 0.0), Status::Ok);
    assert_eq!(fmi2EnterInitializationMode(host.component), Status::Ok);
    assert!(fmi2ExitInitializationMode(host.component) <= Status::Warning, "{}", host.last());
}

#[test]
fn a_packed_unit_starts_with_the_files_and_values_of_its_user() {
    let (own, out) = (own_files(), TempDir::new().unwrap());
    let [wheel, rail] = ["own wheel.txt", "own.csv"].map(|name| text_of(&own.path().join(name)));
    let target = out.path().join("Own & mine.fmu");
    let set =
        ["--set", "wheel.y=0.7515", "--set", "normal.model=hertz", "--set", "wheel.z=-0.4593"];
    let options = [&["--wheel", &wheel, "--rail", &rail][..], &set].concat();
    let done = pack("WheelRail", &target, &options);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));

    let mut values = Values::default();
    for (name, value) in [
        ("wheel.profile", &*wheel),
        ("rail[1].profile", &rail),
        ("wheel.y", "0.7515"),
        ("wheel.z", "-0.4593"),
        ("normal.model", "hertz"),
    ] {
        values.set_from_text(find(name).unwrap(), value).unwrap();
    }
    let mut element = Element::new(&values.parameters, &values.input, &[]).unwrap();
    let mut forces = Forces::default();
    element.evaluate(&values.input, &mut forces).unwrap();
    assert!(forces.wheel.force[2] < -1e3);

    // The user's files are gone, as on another machine.
    drop(own);
    let folder = out.path().join("unpacked");
    let host = host_of(&target, &folder, wheelrail::variables::GUID);
    for _ in 0..2 {
        initialized(&host);
        let names = ["wheel.y", "wheel.force.y", "wheel.force.z"];
        let found = host.get_reals(&names).unwrap();
        let wanted = [0.7515, forces.wheel.force[1], forces.wheel.force[2]];
        assert_eq!(found, wanted);
        assert_eq!(host.get_integer("normal.model"), 1);
        // Starts with them again.
        assert_eq!(fmi2Reset(host.component), Status::Ok);
    }

    let xml = String::from_utf8(entry(&target, "modelDescription.xml")).unwrap();
    assert!(xml.contains("modelName=\"Own &amp; mine\""), "{}", &xml[..800]);
    assert!(xml.contains("wheel own wheel.txt, rail own.csv, wheel.y = 0.7515"));
    assert!(xml.contains("<String start=\"own wheel.txt\"/>"));
    assert!(!xml.contains(&*wheel) && !xml.contains(&out.path().display().to_string()));
    let page = String::from_utf8(entry(&target, "documentation/index.html")).unwrap();
    assert!(page.contains("<h1>Own &amp; mine</h1>") && page.contains("wheel.y</code>"));
    assert!(entry(&target, "documentation/contact.svg").starts_with(b"<svg"));
    let icon = entry(&target, "model.png");
    assert!(icon.starts_with(b"\x89PNG") && icon != entry(&packaged::fmu(), "model.png"));
}

#[test]
fn two_packs_of_the_same_input_are_the_same_bytes() {
    let (own, out) = (own_files(), TempDir::new().unwrap());
    let list = text_of(&own.path().join("varying/crossing.txt"));
    let twice = ["one", "other"].map(|folder| {
        let folder = out.path().join(folder);
        fs::create_dir(&folder).unwrap();
        let target = folder.join("Crossing.fmu");
        let done = pack("WheelRail3", &target, &["--rail", &list]);
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        fs::read(target).unwrap()
    });
    assert!(twice[0] == twice[1]);
    // A list has its sections with it, whatever folder they came from.
    let target = out.path().join("one/Crossing.fmu");
    let table = String::from_utf8(entry(&target, "resources/profiles/crossing/crossing.txt"));
    assert_eq!(table.unwrap(), "station_m,profile\n0,60E1\n10,sections/end.csv\n20,else.csv\n");
    for name in ["sections/end.csv", "else.csv"] {
        assert!(!entry(&target, &format!("resources/profiles/crossing/{name}")).is_empty());
    }
    let xml = String::from_utf8(entry(&target, "modelDescription.xml")).unwrap();
    assert!(xml.contains("<Start value=\"crossing/crossing.txt\"/>"));
    assert!(entry(&target, "terminalsAndIcons/icon.png").starts_with(b"\x89PNG"));
}

#[test]
fn a_packed_wheelset_can_be_packed_again() {
    let (own, out) = (own_files(), TempDir::new().unwrap());
    let wheel = text_of(&own.path().join("own wheel.txt"));
    let (first, second) = (out.path().join("Set.fmu"), out.path().join("Again.fmu"));
    let done = pack("WheelSet", &first, &["--wheel", &wheel, "--set", "wheelset.y=0.003"]);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    drop(own);
    let options = ["pack", "--source", &text_of(&first), "-o", &text_of(&second)];
    let again =
        ["--set", "wheelset.y=0.002", "--set", "left.rail[1].profile=54E1", "--name", "Set"];
    let done = wheelrail(&options.into_iter().chain(again).collect::<Vec<_>>());
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let host = host_of(&second, &out.path().join("unpacked"), WHEELSET.guid);
    initialized(&host);
    assert_eq!(host.get_reals(&["wheelset.y"]), Ok(vec![0.002]));
    assert!(host.get_real("wheelset.force.z") < -1e3);
    let page = String::from_utf8(entry(&second, "documentation/index.html")).unwrap();
    assert_eq!(page.matches("<!-- packed -->").count(), 1);
    let starts = String::from_utf8(entry(&second, "resources/start_values.txt")).unwrap();
    for line in ["left.wheel.profile = own wheel.txt", "left.rail[1].profile = 54E1"] {
        assert!(starts.lines().any(|found| found == line), "{starts}");
    }
}

#[test]
fn what_cannot_be_packed_is_refused_by_name_and_nothing_is_written() {
    let (own, out) = (own_files(), TempDir::new().unwrap());
    let target = out.path().join("Own.fmu");
    let broken = own.path().join("broken.txt");
    fs::write(&broken, "station_m,profile\n0,60E1\n10,nowhere.csv\n").unwrap();
    let broken = text_of(&broken);
    let folder = text_of(own.path());
    for (options, words) in [
        (["--wheel", "nowhere.prw"], "wheel.profile = \"nowhere.prw\": there is no such file"),
        (["--wheel", "60E1"], "profile of the other body"),
        (["--wheel", &folder], "it is not a file"),
        (["--rail", &broken], "nowhere.csv"),
        (["--set", "wheel.q=1"], "there is no variable \"wheel.q\""),
        (["--set", "wheel.y=wide"], "wheel.y = \"wide\""),
        (["--set", "track.gauge=9"], "track.gauge = 9"),
        (["--set", "wheel.force.z=1"], "cannot be set"),
        (["--set", "friction.profile=nowhere.csv"], "friction.profile = \"nowhere.csv\""),
        (["--name", " "], "the model name \" \" is not admitted"),
    ] {
        let done = pack("WheelRail", &target, &options);
        let said = String::from_utf8_lossy(&done.stderr).into_owned();
        assert!(!done.status.success() && said.contains(words), "{options:?}: {said}");
        assert!(!target.exists());
    }
    let plain = pack("WheelRailPlain", &target, &["--set", "track.foundation.model=massless"]);
    let said = String::from_utf8_lossy(&plain.stderr).into_owned();
    assert!(said.contains("track.foundation.model is no variable of this unit"), "{said}");
    let named = pack("WheelRail", &out.path().join("Own.zip"), &[]);
    assert!(String::from_utf8_lossy(&named.stderr).contains("ends in .fmu"));
    assert!(matches!(Pack::open(&own.path().join("own.csv")), Err(PackError::Source { .. })));
}

#[test]
fn a_start_file_that_is_damaged_is_explained() {
    let out = TempDir::new().unwrap();
    fs::create_dir(out.path().join("resources")).unwrap();
    fs::write(out.path().join("resources/start_values.txt"), "wheel.y = 0.75\nwheel.q = 1\n")
        .unwrap();
    let location = format!("file://{}/resources", out.path().display());
    let arguments = Arguments {
        location: Some(std::ffi::CString::new(location).unwrap()),
        ..Arguments::default()
    };
    let host = Host::instantiate(&arguments);
    assert!(host.component.is_null());
    let said = host.last();
    assert!(said.contains("start_values.txt, line 2: there is no variable \"wheel.q\""), "{said}");
}
