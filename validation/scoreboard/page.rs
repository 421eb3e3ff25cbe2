//! The page docs/scoreboard.md with the table docs/scoreboard.csv, and their comparison with those
//! that are committed.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;

use crate::common::summary::rounded;
use crate::common::write_report;
use crate::family::{Case, Family, Spread};
use crate::random::{JUMPS, Walk};

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/scoreboard.md");
const FAMILIES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/families.csv");
const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/scoreboard.csv");

/// Results of a family: name of a setting or of another program, and its cases.
pub struct Results<'a> {
    pub family: &'a Family,
    pub rows: Vec<(String, Vec<Case>)>,
}

/// Public cases that are in no family, and why.
const LEFT_OUT: [(&str, &str); 15] = [
    (
        "Wheels with flats and out of round: wheelflat, oor_*",
        "the same two wheels as in the family of wheels with flats, on coarser grids and to four digits",
    ),
    (
        "Tangential results of transient cases of wheel and rail: trans_t1_*, trans_t3_*, site_b",
        "the reference turns the planes of contacts that come near to each other and gives each plane one friction, 0.35 above 20 degrees and 0.2 beyond 30, so that the gauge corner has 0.35 \
         there: 9 % of the limit in site_b; states between the printed ones are not known, and site_b's contacts apart all slide. Friction is printed with the contact after the one that has it. \
         Their normal results are in the family of the worn wheel; trans_m1_* are a family of planar problems, but for their normal results, one ellipse of Hertz over and over",
    ),
    (
        "Roller rig with measured profiles: dry_10mph_13750lbs",
        "creep forces through a layer of 0.05 mm between the bodies, which the element does not have; the wheels stand on a bent axle",
    ),
    (
        "Ball and cylinder on rollers with creepage: conformal_test-rollers3",
        "its creep forces are half of Kalker's for the printed creepages and elasticity, by a setting that is not printed",
    ),
    (
        "Yielding of a layer between the bodies: plast_mbench_a22_left",
        "the element has no such layer; one state is printed",
    ),
    (
        "Friction falling with the temperature of the flash: temp_*",
        "compared in `cargo test --test suite friction_law::`, with the whole table of that program's cases",
    ),
    (
        "contact_mbench, mbench_a22_left, _right, _kpec, s+c_cross_*, s+c_wing_*, s+c_mbench_brute",
        "the same states as in other tables: Manchester A-2.2, nose and wing rail, the UK crossing by another search",
    ),
    (
        "mbench_a22_varfric",
        "three states of Manchester A-2.2 with the first table of those in Friction by inclination",
    ),
    (
        "conformal_mbench_conf, trans_t3_*_conformal",
        "conformal contacts, of each of which neither force nor pressure is printed",
    ),
    (
        "conformal_test-rollers2, cases 2 and 4",
        "a ball on a plane, which is one of the ellipses of Hertz",
    ),
    (
        "Single cases of CONTACT's test bank: guard rail, os_l, iter288, avg_wheel",
        "profiles that are not in the folder, or one state of a wheel whose place on its axle is not printed",
    ),
    (
        "element_normal with regions kept apart",
        "the states of Wheel on rail at given load, each contact by itself",
    ),
    (
        "Measured creep curves of locomotives",
        "the law of friction is fitted to them; compared in `cargo test --test suite published_curves`",
    ),
    (
        "Outlines of planar contacts",
        "three of the planar problems above; drawn beside the models by `cargo run --no-default-features --example figures -- outlines`",
    ),
    (
        "EN 15302",
        "equivalent conicity has no contact model in it; compared in `cargo test --test suite conicity::`",
    ),
];

/// Said of families on profiles that may not be passed on.
const NEEDS_FOLDER: &str = " Needs the folder of profiles.";

const HEAD: &str = "# Scoreboard

*For whoever wants to know how far the models are off, case by case.*

Every public case that the element can represent, by the default models and by those that users choose between: here those of most users, all rows with the case that is worst in
[scoreboard.csv](scoreboard.csv), what the families are and which public cases are in none of them in [families.csv](families.csv). All three are written by

```sh
cargo bench --no-default-features --bench scoreboard
```

which takes some minutes. Errors are absolute values: half of the cases are below the median, one in twenty is above the 95 %. Each case with its errors stands in
`target/reports/scoreboard.csv` after a run. A word behind the command, `-- roller`, runs the families alone that have it in their titles.

Some families need profiles that may not be passed on, those of CONTACT's test bank and examples. They run where `WHEELRAIL_PROFILES` names a folder that has them, in itself or in
`testbank` in it; without it their rows stay as they are. With `WHEELRAIL_SCOREBOARD=check` nothing is written: the command fails where a figure is worse than here;
with `WHEELRAIL_SCOREBOARD=page` this page is made anew from the CSV.

";

/// The models of the summary, as the rows of the CSV name them, with the heading of their column.
const SHOWN: [(&str, &str); 3] = [
    ("by default", "by default"),
    ("`piotrowski_kik` + `fastsim`, flat", "`piotrowski_kik` + `fastsim`, flat"),
    ("`boundary_element` 40 x 40", "`boundary_element` 40 x 40"),
];

/// A row of the CSV, as it is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    family: String,
    quantity: String,
    by: String,
    cases: String,
    /// Median, 95 % and worst.
    figures: [String; 3],
    which: String,
}

const COLUMNS: [&str; 8] =
    ["family", "quantity", "by", "cases", "median", "95 %", "worst", "which"];

/// The rows of the CSV that is committed; none if there is no such file.
pub fn known() -> Vec<Row> {
    let Ok(mut reader) = csv::Reader::from_path(TABLE) else { return Vec::new() };
    let cells = reader.records().map(|record| record.expect("docs/scoreboard.csv is a table"));
    cells
        .map(|record| {
            let cell = |k: usize| record[k].to_owned();
            Row {
                family: cell(0),
                quantity: cell(1),
                by: cell(2),
                cases: cell(3),
                figures: [4, 5, 6].map(cell),
                which: cell(7),
            }
        })
        .collect()
}

/// The rows of families. Those of one whose folder is not given stay as they are in the CSV.
pub fn rows(results: &[Results]) -> Vec<Row> {
    let before = known();
    let mut all = Vec::new();
    for Results { family, rows } in results {
        if rows.is_empty() {
            all.extend(before.iter().filter(|row| row.family == family.title).cloned());
        }
        for (k, quantity) in family.quantities.iter().enumerate() {
            for (name, cases) in rows {
                let Some(spread) = Spread::of(cases, k) else { continue };
                all.push(Row {
                    family: family.title.to_owned(),
                    quantity: (*quantity).to_owned(),
                    by: name.clone(),
                    cases: spread.count.to_string(),
                    figures: spread.sizes.map(rounded),
                    which: spread.worst.to_owned(),
                });
            }
        }
    }
    all
}

/// All columns of rows, as a table to look at.
pub fn table(rows: &[Row]) -> String {
    let mut text = format!("| {} |\n|{}\n", COLUMNS.join(" | "), "---|".repeat(COLUMNS.len()));
    for row in rows {
        let Row { family, quantity, by, cases, which, .. } = row;
        let figures = row.figures.join(" | ");
        writeln!(text, "| {family} | {quantity} | {by} | {cases} | {figures} | {which} |")
            .expect("a text");
    }
    text
}

/// What the families are, and what is in none of them.
pub fn write_families(families: &[&Family]) {
    let mut writer = csv::Writer::from_path(FAMILIES).expect("docs/families.csv can be written");
    let heading = ["family", "what", "reference"];
    let all = families.iter().map(|family| {
        let folder = if family.needs_folder { NEEDS_FOLDER } else { "" };
        [family.title.to_owned(), format!("{}{folder}", family.text), family.source.to_owned()]
    });
    let left_out = LEFT_OUT
        .map(|(cases, reason)| [format!("left out: {cases}"), reason.to_owned(), String::new()]);
    for row in [heading.map(str::to_owned)].into_iter().chain(all).chain(left_out) {
        writer.write_record(row).expect("docs/families.csv can be written");
    }
    writer.flush().expect("docs/families.csv can be written");
}

/// The rows of the families by the models of [`SHOWN`].
fn summary(families: &[&Family], rows: &[Row]) -> String {
    let mut page =
        String::from("## Errors\n\nMedian, 95 % and worst.\n\n| family | quantity | cases |");
    for (_, heading) in SHOWN {
        write!(page, " {heading} |").expect("a text");
    }
    page += "\n|---|---|---:|---|---|---|\n";
    for family in families {
        // The title stands once.
        let mut title = family.title;
        for quantity in family.quantities {
            let of = |by: &str| {
                rows.iter().find(|row| {
                    row.family == family.title && row.quantity == *quantity && row.by == by
                })
            };
            let Some(first) = SHOWN.iter().find_map(|(by, _)| of(by)) else { continue };
            write!(page, "| {title} | {quantity} | {} |", first.cases).expect("a text");
            title = "";
            for (by, _) in SHOWN {
                let figures = of(by).map_or_else(String::new, |row| row.figures.join(", "));
                write!(page, " {figures} |").expect("a text");
            }
            page.push('\n');
        }
    }
    page.push('\n');
    page
}

/// What stands under a heading of a page, with it.
fn section<'a>(page: &'a str, title: &str) -> &'a str {
    let Some(start) = page.find(&format!("## {title}\n")) else { return "" };
    let rest = &page[start..];
    &rest[..rest[1..].find("\n## ").map_or(rest.len(), |end| end + 2)]
}

/// The page of the CSV and the rest of the page that is committed.
pub fn again(families: &[&Family]) -> String {
    let page = fs::read_to_string(PAGE).unwrap_or_default();
    let rest = ["Jumps", "Times"].map(|title| section(&page, title)).concat();
    String::from(HEAD) + &summary(families, &known()) + &rest
}

/// The page, from which a later run takes what to compare with.
pub fn text(results: &[Results], walk: &Walk, times: &[(String, Vec<Case>)], seed: u64) -> String {
    let families: Vec<&Family> = results.iter().map(|results| results.family).collect();
    let mut page = String::from(HEAD) + &summary(&families, &rows(results));
    writeln!(
        page,
        "## Jumps\n\nStraight lines of 0.1 mm in steps of 0.1 µm through random poses of new and worn wheels, with the default models (`tests/suite/walk.rs` has the long \
         walk): {:.0} mm, {} jumps beyond {:e} of the load or {:e} of the friction limit, {:.0} in a metre; the greatest {} of the load without creep forces, {} of the limit with them.\n",
        1e3 * walk.way,
        walk.beyond,
        JUMPS[0],
        JUMPS[1],
        walk.beyond as f64 / walk.way,
        rounded(walk.jumps[0]),
        rounded(walk.jumps[1]),
    )
    .expect("a text");
    page += "## Times\n\nOne evaluation in random poses, the least of five, over the median of the fastest in the same run; and the greatest over the median. Slow models are timed in one pose of twenty.\n\n";
    page += &times_table(times);
    writeln!(
        page,
        "\nRandom cases of this run: seed {seed} (`WHEELRAIL_SEED`; another one in every run without it). From seed to seed the medians of random cases change by up to a \
         fifth, their 95 %, above which a hundred of 2000 lie, by up to a half and their worst by any factor; the other tables do not change."
    )
    .expect("a text");
    page
}

/// What an evaluation takes, as a table: medians over the least of them.
pub fn times_table(times: &[(String, Vec<Case>)]) -> String {
    let mut table = String::from(
        "| by | poses | median | greatest over median | which |\n|---|---:|---:|---:|---|\n",
    );
    let median = |cases: &[Case]| Spread::of(cases, 0).map_or(f64::NAN, |spread| spread.sizes[0]);
    let unit = times.iter().map(|(_, cases)| median(cases)).fold(f64::INFINITY, f64::min);
    for (name, cases) in times {
        let Some(spread) = Spread::of(cases, 0) else { continue };
        let [middle, _, worst] = spread.sizes;
        let (over, most) = (rounded(middle / unit), rounded(worst / middle));
        writeln!(table, "| {name} | {} | {over} | {most} | {} |", spread.count, spread.worst)
            .expect("a text");
    }
    table
}

/// All cases.
pub fn report(results: &[Results]) {
    let mut rows = csv::Writer::from_writer(Vec::new());
    rows.write_record(["family", "quantity", "by", "case", "error"]).expect("memory");
    for Results { family, rows: settings } in results {
        for (name, cases) in settings {
            for case in cases {
                for (quantity, error) in family.quantities.iter().zip(&case.errors) {
                    let error = format!("{error:.4e}");
                    rows.write_record([family.title, quantity, name, &case.name, &error])
                        .expect("memory");
                }
            }
        }
    }
    let text = String::from_utf8(rows.into_inner().expect("memory")).expect("UTF-8");
    write_report("scoreboard.csv", &text);
}

/// Writes the page.
pub fn write(text: &str) {
    fs::write(PAGE, text).expect("docs/scoreboard.md can be written");
}

/// Writes the CSV beside it.
pub fn write_table(rows: &[Row]) {
    let mut writer = csv::Writer::from_path(TABLE).expect("docs/scoreboard.csv can be written");
    writer.write_record(COLUMNS).expect("docs/scoreboard.csv can be written");
    for Row { family, quantity, by, cases, figures: [median, most, worst], which } in rows {
        writer
            .write_record([family, quantity, by, cases, median, most, worst, which])
            .expect("docs/scoreboard.csv can be written");
    }
    writer.flush().expect("docs/scoreboard.csv can be written");
}

/// By how much a figure of cases that stay the same may grow: other libraries of elementary
/// functions, and two digits.
const NOISE: f64 = 0.06;
/// The same of random cases: median and 95 %. Their worst says nothing. The committed page is of
/// seed 1; no 95 % of seeds 2 and 3 is half as much again as its own, some are a third of it.
const RANDOM_NOISE: [f64; 2] = [1.0 / 3.0, 0.5];

/// What has become worse than on the committed page by more than the noise.
pub fn worse(results: &[Results], walk: &Walk) -> Vec<String> {
    let known = figures(&known());
    let mut worse = Vec::new();
    for Results { family, rows } in results {
        for (k, quantity) in family.quantities.iter().enumerate() {
            for (name, cases) in rows {
                let key = format!("{}; {quantity}; {name}", family.title);
                let Some(spread) = Spread::of(cases, k) else { continue };
                let Some(before) = known.get(&key) else {
                    worse.push(format!("{key}: not in docs/scoreboard.csv"));
                    continue;
                };
                for (i, what) in ["median", "95 %", "worst"].into_iter().enumerate() {
                    let noise = match (family.is_random, RANDOM_NOISE.get(i)) {
                        (false, _) => NOISE,
                        (true, Some(&noise)) => noise,
                        (true, None) => continue,
                    };
                    if spread.sizes[i] > before[i] * (1.0 + noise) {
                        let (now, before) = (rounded(spread.sizes[i]), rounded(before[i]));
                        worse.push(format!("{key}: {what} {now}, was {before}"));
                    }
                }
            }
        }
    }
    if walk.beyond > 0 {
        worse.push(format!("{} jumps in {:.0} mm", walk.beyond, 1e3 * walk.way));
    }
    worse
}

/// Median, 95 % and worst of all rows by "family; quantity; by".
fn figures(rows: &[Row]) -> BTreeMap<String, [f64; 3]> {
    let numbers = |row: &Row| {
        let [median, most, worst] = row.figures.each_ref().map(|cell| cell.parse().ok());
        Some([median?, most?, worst?])
    };
    let key = |row: &Row| format!("{}; {}; {}", row.family, row.quantity, row.by);
    rows.iter().filter_map(|row| Some((key(row), numbers(row)?))).collect()
}
