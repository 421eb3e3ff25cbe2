//! The tables: docs/benchmarks.md between its marks, and a CSV file with everything.

use std::fmt::Write;

use wheelrail::element::parameters::TangentialModel;

use crate::common::write_report;
use crate::page::{self, microseconds};
use crate::rows::{EllipseRow, NormalRow, Row};
use crate::wheel::TREAD;
use crate::{figure, wheel};

/// Writes both.
pub fn write(normals: &[NormalRow], rows: &[Row], ellipses: &[EllipseRow], sizes: [usize; 2]) {
    write_report("error_over_time.csv", &everything(rows));
    let text =
        normal_table(normals) + &rolling_table(rows, sizes[0]) + &ellipse_table(ellipses, sizes[1]);
    page::write("error_over_time", text.trim_end());
}

fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    match percent {
        p if p < 0.095 => format!("{p:.2}"),
        p if p < 9.95 => format!("{p:.1}"),
        p => format!("{p:.0}"),
    }
}

fn normal_table(rows: &[NormalRow]) -> String {
    let mut text = format!(
        "**Normal contact**, errors in %. CONTACT: 32 planar cases, approach given; median, worst of the 28 with one region, then worst of \
         the 4 with two. Wheel: {} contacts of a wheel laid flat, approach given, against boundary elements, {n}x{n}; median, worst. Time: without \
         creep force, tread, height given and load given [µs].\n\n\
         | model | CONTACT: N | p_max | area | fallbacks | wheel: N | p_max | area | height given | load given |\n\
         |---|---|---|---|---|---|---|---|---|---|\n",
        wheel::COUNT,
        n = wheel::REFERENCE,
    );
    for row in rows {
        let contact = row.contact.map(|e| e.map(percent).join(", "));
        let wheel = row.wheel.map(|e| e.map(percent).join(", "));
        writeln!(
            text,
            "| `{}` | {} | {} | {} | {} | {} |",
            row.normal.name(),
            contact.join(" | "),
            row.fallbacks,
            wheel.join(" | "),
            microseconds(row.times[TREAD]),
            microseconds(row.load_time),
        )
        .expect("writing to a string cannot fail");
    }
    text + "\n"
}

fn rolling_table(rows: &[Row], count: usize) -> String {
    let mut text = format!(
        "**Creep force**, error in % of the friction limit; mean, 95 %, worst. CONTACT: {count} states of eight real patches, approach given, the \
         error of the load included; moment: mean, in % of friction times load times the radius of a circle as large as the patch. Wheel: as \
         above, each force over the friction limit of its own load. Time of one evaluation with search, the least of many: tread, height given; the slowest of \
         five places; tread, load given [µs]. Instructions: tread, height given and load given, in thousands, by callgrind with AVX2. Best for \
         its time or less by the mean against CONTACT: bold. What the element starts with, but for creepage that is one plane's: default.\n\n\
         | models | CONTACT | moment | wheel | height given | slowest | load given | instructions |\n|---|---|---|---|---|---|---|---|\n"
    );
    let front = figure::front(rows);
    for (i, row) in rows.iter().enumerate() {
        let name = format!("`{}` + `{}`", row.choice.normal.name(), row.choice.rolling.name());
        let name = if row.choice.is_default() { name + ", default" } else { name };
        let name = if front.contains(&i) { format!("**{name}**") } else { name };
        let slowest = row.times.iter().copied().fold(0.0, f64::max);
        writeln!(
            text,
            "| {name} | {} | {} | {} | {} | {} | {} | {} |",
            row.contact.map(percent).join(", "),
            percent(row.moment),
            row.wheel.map(percent).join(", "),
            microseconds(row.times[TREAD]),
            microseconds(slowest),
            microseconds(row.load_time),
            row.instructions
                .map(|n| n.map_or_else(String::new, |n| format!("{:.0}", n / 1e3)))
                .join(" "),
        )
        .expect("writing to a string cannot fail");
    }
    text + "\n"
}

fn ellipse_table(rows: &[EllipseRow], count: usize) -> String {
    let mut text = format!(
        "**Creep force on {count} Hertzian ellipses** against CONTACT, load given, as many strips as elements along, error in % of the \
         friction limit.\n\n| model | mean | 95 % | worst |\n|---|---|---|---|\n"
    );
    for row in rows.iter().filter(|row| row.rolling.model != TangentialModel::Linear) {
        writeln!(text, "| `{}` | {} |", row.rolling.name(), row.errors.map(percent).join(" | "))
            .expect("writing to a string cannot fail");
    }
    text + "\n"
}

fn everything(rows: &[Row]) -> String {
    let mut text = String::from(
        "normal,tangential,contact_mean,contact_p95,contact_worst,moment_mean,wheel_mean,wheel_p95,wheel_worst",
    );
    for (name, ..) in wheel::PLACES {
        text += &format!(",{}_us", name.replace(' ', "_"));
    }
    text += ",tread_load_us,instructions,instructions_load\n";
    for row in rows {
        let numbers = row.contact.iter().chain([&row.moment]).chain(&row.wheel);
        let numbers: Vec<String> = numbers.map(|e| format!("{e:.5}")).collect();
        let times: Vec<String> = row.times.iter().map(|t| format!("{:.3}", 1e6 * t)).collect();
        text += &format!(
            "\"{}\",\"{}\",{},{},{:.3},{}\n",
            row.choice.normal.name(),
            row.choice.rolling.name(),
            numbers.join(","),
            times.join(","),
            1e6 * row.load_time,
            row.instructions.map(|n| n.map_or_else(String::new, |n| format!("{n:.0}"))).join(","),
        );
    }
    text
}
