//! Figures of the documents, each with the numbers behind it: `cargo run --release
//! --no-default-features --example figures -- NAME FILE.svg > NAME.csv`; without a name it lists
//! them.

#[path = "../../src/bin/wheelrail/figures/canvas.rs"]
mod canvas;
mod chart;
mod corrugated_rail;
mod coupling_stability;
mod crossing;
mod curved_patches;
mod driven_wheelset;
mod free_wheelset;
mod outlines;
mod tractions;
mod wear_distribution;
mod wear_two_load_cases;
mod wheel_flat;
mod yawed_wheel;

use std::error::Error;

/// Draws a figure from the arguments behind its name: where it goes, and what else it is told.
type Figure = fn(&[String]) -> Result<(), Box<dyn Error>>;

/// Name, arguments and question of each.
const FIGURES: [(&str, &str, &str, Figure); 10] = [
    ("corrugated_rail", "FILE.svg", "creep force over the waves of a rail", corrugated_rail::draw),
    (
        "coupling_stability",
        "FILE.svg",
        "how long may a communication step be?",
        coupling_stability::draw,
    ),
    ("crossing", "FOLDER", "how hard does a wheel strike a crossing?", crossing::draw),
    (
        "curved_patches",
        "FILE.svg DISTANCE_M",
        "does it matter that patches are curved?",
        curved_patches::draw,
    ),
    ("outlines", "FILE.svg", "outlines of patches beside those of CONTACT", outlines::draw),
    ("tractions", "FILE.svg", "where do ten contacts stick and slip?", tractions::draw),
    ("wear_distribution", "FILE.svg", "does summing up wear dig holes?", wear_distribution::draw),
    (
        "wear_two_load_cases",
        "FILE.svg UPDATES",
        "profiles after 253 thousand kilometres",
        wear_two_load_cases::draw,
    ),
    ("wheel_flat", "FILE.svg", "how hard does a flat strike at each speed?", wheel_flat::draw),
    ("yawed_wheel", "FILE.svg", "where does a yawed wheel touch?", yawed_wheel::draw),
];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let named = arguments.split_first();
    let figure = named.and_then(|(name, rest)| {
        FIGURES.iter().find(|figure| figure.0 == name).map(|figure| (figure.3, rest))
    });
    if let Some((draw, rest)) = figure {
        return draw(rest);
    }
    for (name, arguments, question, _) in FIGURES {
        eprintln!("  {:<40} {question}", format!("{name} {arguments}"));
    }
    Err("give one of these names, and where the figure goes".into())
}
