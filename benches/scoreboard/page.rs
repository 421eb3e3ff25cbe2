//! The page docs/scoreboard.md, and its comparison with the one that is committed.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;

use crate::common::summary::rounded;
use crate::common::write_report;
use crate::family::{Case, Family, Spread};
use crate::random::{JUMPS, Walk};

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/scoreboard.md");

/// Results of a family: name of a setting or of another program, and its cases.
pub struct Results<'a> {
    pub family: &'a Family,
    pub rows: Vec<(String, Vec<Case>)>,
}

/// Families of public cases that are not in the table, and why.
const LEFT_OUT: [(&str, &str); 7] = [
    ("Crossings of wing and nose together, the UK crossing", "profiles that may not be passed on"),
    (
        "Wheels with flats and out of round",
        "the element has flats and waves by formulas, the references measured sections around the wheel",
    ),
    (
        "Roller rigs",
        "four cases of simple shapes are compared in `cargo test --test roller`; the measured profiles may not be passed on",
    ),
    ("CONTACT's own tests: crossings, grooves, discs", "profiles that may not be passed on"),
    ("Transient rolling", "the element has no history"),
    (
        "Linear creep coefficients",
        "compared in `cargo test --test tables` and `--test analytic`, to the digits of the reference",
    ),
    (
        "EN 15302",
        "equivalent conicity has no contact model in it; compared in `cargo test --test conicity`",
    ),
];

const HEAD: &str = "# Scoreboard

Every public case that the element can represent, by the models as they start and by those that users choose between. Written by

```sh
cargo bench --no-default-features --bench scoreboard
```

which takes some minutes; nothing in the tables is written by hand. Errors are absolute values: half of the cases are below the median, one in twenty is above the
column 95 %, and the last two columns say how large the greatest one is and which case it is. All cases, each with its errors, stand in
`target/reports/scoreboard.csv` after a run; a file of references begins with its source, units and signs.

";

/// The tables, from which a later run takes what to compare with.
pub fn text(results: &[Results], walk: &Walk, times: &[(String, Vec<Case>)], seed: u64) -> String {
    let mut page = String::from(HEAD);
    for Results { family, rows } in results {
        writeln!(page, "## {}\n\n{} Reference: {}.\n", family.title, family.text, family.source)
            .expect("a text");
        page += "| quantity | by | cases | median | 95 % | worst | which |\n|---|---|---:|---:|---:|---:|---|\n";
        for (k, quantity) in family.quantities.iter().enumerate() {
            for (name, cases) in rows {
                let Some(spread) = Spread::of(cases, k) else { continue };
                let [median, most, worst] = spread.sizes.map(rounded);
                writeln!(
                    page,
                    "| {quantity} | {name} | {} | {median} | {most} | {worst} | {} |",
                    spread.count, spread.worst
                )
                .expect("a text");
            }
        }
        page.push('\n');
    }
    writeln!(
        page,
        "## Jumps\n\nStraight lines of 0.1 mm in steps of 0.1 µm through random poses of new and worn wheels, with the models as they start (`tests/walk.rs` has the long \
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
    page += "## Times\n\nOne evaluation in random poses, the least of five, over the median of `piotrowski_kik` + `fastsim` in the same run; and the greatest over the median.\n\n\
             | by | poses | median | greatest over median | which |\n|---|---:|---:|---:|---|\n";
    let median = |cases: &[Case]| Spread::of(cases, 0).map_or(f64::NAN, |spread| spread.sizes[0]);
    let unit = times.last().map_or(f64::NAN, |(_, cases)| median(cases));
    for (name, cases) in times {
        let Some(spread) = Spread::of(cases, 0) else { continue };
        let [middle, _, worst] = spread.sizes;
        let (over, most) = (rounded(middle / unit), rounded(worst / middle));
        writeln!(page, "| {name} | {} | {over} | {most} | {} |", spread.count, spread.worst)
            .expect("a text");
    }
    page += "\n## Left out\n\n| cases | reason |\n|---|---|\n";
    for (cases, reason) in LEFT_OUT {
        writeln!(page, "| {cases} | {reason} |").expect("a text");
    }
    writeln!(
        page,
        "\nRandom cases of this run: seed {seed} (`WHEELRAIL_SEED`; another one in every run without it). From seed to seed the medians of random cases change by up to a \
         third, their 95 % by up to a half and their worst by any factor; the other tables do not change."
    )
    .expect("a text");
    page
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

/// By how much a figure of cases that stay the same may grow: other libraries of elementary functions, and two digits.
const NOISE: f64 = 0.06;
/// The same of random cases: median and 95 %. Their worst says nothing.
const RANDOM_NOISE: [f64; 2] = [1.0 / 3.0, 0.5];

/// What has become worse than on the committed page by more than the noise.
pub fn worse(results: &[Results], walk: &Walk) -> Vec<String> {
    let page = fs::read_to_string(PAGE).unwrap_or_default();
    let known = figures(&page);
    let mut worse = Vec::new();
    for Results { family, rows } in results {
        for (k, quantity) in family.quantities.iter().enumerate() {
            for (name, cases) in rows {
                let key = format!("{}; {quantity}; {name}", family.title);
                let Some(spread) = Spread::of(cases, k) else { continue };
                let Some(before) = known.get(&key) else {
                    worse.push(format!("{key}: not on the committed page"));
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

/// Median, 95 % and worst of all rows of a page by "family; quantity; by".
fn figures(page: &str) -> BTreeMap<String, [f64; 3]> {
    let mut title = "";
    let mut known = BTreeMap::new();
    for line in page.lines() {
        if let Some(heading) = line.strip_prefix("## ") {
            title = heading;
        }
        let cells: Vec<&str> = line.trim_matches('|').split(" | ").map(str::trim).collect();
        if let [quantity, name, _, median, most, worst, _] = cells.as_slice() {
            let numbers = [median, most, worst].map(|cell| cell.parse().ok());
            if let [Some(median), Some(most), Some(worst)] = numbers {
                known.insert(format!("{title}; {quantity}; {name}"), [median, most, worst]);
            }
        }
    }
    known
}
