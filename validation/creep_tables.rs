//! Makes the tables of creep forces anew that are built in, or measures them against the solutions
//! they interpolate: `cargo bench --bench creep_tables -- --help`.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};
use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use wheelrail::io::write_whole;
use wheelrail::tangential::coupled_marches::differences;
use wheelrail::tangential::tables::CreepForceTable;
use wheelrail::tangential::tables::generate::{ELEMENTS, EllipseNodes, POISSON_RATIO};
use wheelrail::tangential::tables::nodes::{
    CREEP_NODES, HALF, LOG_RATIO, Nodes, RATIOS, RING, SATURATIONS, SLIDING_RING,
};
use wheelrail::tangential::tables::scales::Scales;

/// Make the table of creep forces of tangential.model = tables, or measure it
///
/// Some 34000 boundary element solutions on each of two grids, on all cores: about a quarter of an
/// hour of two. A build of the library then takes the new file. With --check the table that is
/// built in is compared with solutions at states between its nodes.
#[derive(Debug, Parser)]
#[command(verbatim_doc_comment)]
struct Arguments {
    /// What cargo adds
    #[arg(long, hide = true)]
    bench: bool,
    /// File of the table; src/tangential/tables/creep_forces.table is the one a build takes
    #[arg(long, short, value_name = "FILE", required_unless_present = "check")]
    output: Option<PathBuf>,
    /// Make the table of tangential.model = marches instead, from the one of creep forces that is
    /// built in; src/tangential/coupled_marches/differences.table is the one a build takes
    #[arg(long, conflicts_with = "check")]
    marches: bool,
    /// Date for the head of the file
    #[arg(long, default_value = "not given")]
    date: String,
    /// Compare the built-in table with this many solutions at random states, and make none
    #[arg(long, value_name = "STATES", conflicts_with = "output")]
    check: Option<usize>,
    /// Poisson's ratio of the comparison
    #[arg(long, default_value_t = POISSON_RATIO)]
    poisson_ratio: f64,
    /// Elements along and across on the two grids
    #[arg(long, value_delimiter = ',', num_args = 1, default_values_t = ELEMENTS)]
    elements: Vec<usize>,
    /// Greatest a/b, and inverse of the least, in the comparison
    #[arg(long, default_value_t = 20.0)]
    axis_ratio: f64,
}

fn main() -> Result<()> {
    let arguments = &Arguments::parse();
    let &[coarse, fine] = &arguments.elements[..] else {
        bail!("--elements: write two numbers, as 16,24");
    };
    ensure!(
        (4..=200).contains(&coarse) && (coarse + 1..=200).contains(&fine),
        "--elements: two numbers from 4 to 200, the second greater than the first"
    );
    let elements = [coarse, fine];
    match (&arguments.output, arguments.check) {
        (Some(path), _) if arguments.marches => {
            let exact = CreepForceTable::committed_nodes().context("no table is built in")?;
            let head = head_of_differences(&arguments.date);
            write(path, &differences::nodes(&exact).to_bytes(&head))
        }
        (Some(path), _) => {
            let nodes = generate(elements)?;
            write(path, &nodes.to_bytes(&head(&nodes, elements, &arguments.date)))
        }
        (None, Some(states)) => check(arguments, elements, states),
        (None, None) => Ok(()),
    }
}

fn write(path: &Path, content: &[u8]) -> Result<()> {
    write_whole(path, content).with_context(|| format!("cannot write {}", path.display()))
}

fn progress(count: usize) -> Result<ProgressBar> {
    let template = "{bar:40.blue} {pos} of {len} cases, {elapsed} elapsed, {eta} to go";
    Ok(ProgressBar::new(count as u64).with_style(ProgressStyle::with_template(template)?))
}

fn head(nodes: &Nodes, [coarse, fine]: [usize; 2], date: &str) -> String {
    let mut errors = nodes.error.clone();
    errors.sort_by(f64::total_cmp);
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    let at = |share: f64| errors[(share * (errors.len() - 1) as f64) as usize];
    format!(
        "Creep forces of Hertzian ellipses in steady rolling, boundary elements, for tangential.model = tables.\n\
         Made by: cargo bench --bench creep_tables -- -o creep_forces.table --elements {coarse},{fine}, version {}, {date}.\n\
         Elements {coarse} and {fine} along and across, extrapolated with the power 3/2 of their size; Poisson's ratio {POISSON_RATIO}.\n\
         a/b 0.05 to 20 in {RATIOS} steps of equal ratio, {SATURATIONS} saturations, {RING} directions: {CREEP_NODES} nodes.\n\
         Estimated error of the force over friction limit: mean {mean:.4}, 95 % {:.4}, greatest {:.4}.\n\
         What stands where: src/tangential/tables/nodes.rs. Binary from the empty line on.",
        env!("CARGO_PKG_VERSION"),
        at(0.95),
        at(1.0),
    )
}

fn head_of_differences(date: &str) -> String {
    format!(
        "Creep forces of Hertzian ellipses less those of their marches, for tangential.model = marches.\n\
         Made by: cargo bench --bench creep_tables -- --marches -o differences.table, version {}, {date}.\n\
         Nodes and error estimates are those of creep_forces.table, from which this is made.\n\
         What stands where: src/tangential/tables/nodes.rs. Binary from the empty line on.",
        env!("CARGO_PKG_VERSION"),
    )
}

fn generate(elements: [usize; 2]) -> Result<Nodes> {
    let ellipses: Vec<EllipseNodes> =
        (0..RATIOS).map(|i| EllipseNodes::number(i, elements)).collect();
    let bar = progress(CREEP_NODES)?;
    let creep = (0..CREEP_NODES).into_par_iter().map(|n| {
        let (i, j, k) = (n / (SATURATIONS * RING), n / RING % SATURATIONS + 1, n % RING);
        let node = ellipses[i].creep_node(j, k);
        bar.inc(1);
        node.with_context(|| format!("ellipse {i}, saturation {j}, direction {k} did not converge"))
    });
    let creep: Vec<([f64; 4], f64)> = creep.collect::<Result<_>>()?;
    bar.finish();
    let sliding = ellipses.iter().flat_map(|e| (0..SLIDING_RING).map(|k| e.sliding_node(k)));
    Ok(Nodes {
        sliding: sliding.collect(),
        error: creep.iter().map(|node| node.1).collect(),
        creep: creep.into_iter().map(|node| node.0).collect(),
    })
}

/// Numbers evenly in 0 to 1 (Weyl sequences): the same ones every time.
fn even(state: usize, dimension: usize) -> f64 {
    const STEPS: [f64; 4] = [
        0.819_172_513_396_164_4,
        0.671_043_606_703_789_4,
        0.549_700_477_901_970_2,
        0.450_299_522_098_029_8,
    ];
    (0.5 + STEPS[dimension] * (state + 1) as f64).fract()
}

/// Most states of a check: some hours.
const MOST_STATES: usize = 100_000;

fn check(arguments: &Arguments, elements: [usize; 2], states: usize) -> Result<()> {
    ensure!(arguments.axis_ratio >= 1.0, "--axis-ratio: at least 1");
    ensure!(
        (1..=MOST_STATES).contains(&states),
        "--check {states} is not admitted: 1 to {MOST_STATES} states"
    );
    ensure!((0.0..=0.5).contains(&arguments.poisson_ratio), "--poisson-ratio: 0 to 0.5");
    let bar = progress(states)?;
    let errors = (0..states).into_par_iter().map(|state| {
        let greatest = arguments.axis_ratio.ln().min(LOG_RATIO);
        let log_ratio = greatest * (2.0 * even(state, 0) - 1.0);
        let ellipse = EllipseNodes::new(log_ratio, arguments.poisson_ratio, elements);
        let z = 2.0 * even(state, 1) - 1.0;
        let turn = std::f64::consts::TAU * even(state, 2);
        let across = (1.0 - z * z).sqrt();
        let direction = [across * turn.cos(), across * turn.sin(), z];
        // Scaled creepages from 0.1 to 10, as many in each decade.
        let length = 0.1 * 100f64.powf(even(state, 3));
        let v = ellipse.creepage(direction, length / (length + HALF));
        let exact = ellipse.force(v).with_context(|| format!("state {state} did not converge"))?;
        let scales = Scales::of(log_ratio, arguments.poisson_ratio);
        let found = CreepForceTable::shared().force(&scales, v);
        bar.inc(1);
        let [x, y, m] = [0, 1, 2].map(|k| found.force[k] - exact.force[k]);
        Ok([x.hypot(y), m.abs(), (found.slip_share - exact.slip_share).abs(), exact.error])
    });
    let errors: Vec<[f64; 4]> = errors.collect::<Result<_>>()?;
    bar.finish();
    println!("quantity,mean,percentile_95,worst");
    let names = ["force_over_limit", "moment_over_limit_c", "slip_share", "solution_itself"];
    for (k, name) in names.iter().enumerate() {
        let mut column: Vec<f64> = errors.iter().map(|e| e[k]).collect();
        column.sort_by(f64::total_cmp);
        let mean = column.iter().sum::<f64>() / states as f64;
        let at = |share: f64| column[(share * (states - 1) as f64) as usize];
        println!("{name},{mean:.5},{:.5},{:.5}", at(0.95), at(1.0));
    }
    Ok(())
}
