//! Time of the boundary element solution of one contact, S1002 on UIC60 under 100 kN, by the number
//! of elements in contact.
//!
//! Beside it the times of CONTACT v25.1 on the same contact with the same numbers of elements; they
//! were measured elsewhere (a two-core virtual machine, gfortran -O2, one thread, tolerance 1e-3),
//! so they are an indication.

use std::hint::black_box;
use std::time::Instant;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use plotters::prelude::*;
use wheelrail::boundary_element::grid::Grid;
use wheelrail::boundary_element::pressure::PressureSolver;
use wheelrail::boundary_element::rolling::steady_rolling;
use wheelrail::material::{Material, MaterialPair};
use wheelrail::math::spline::{SplineEnd, interpolating_slopes};

/// Elements along and across the grid, elements in contact, and medians of CONTACT [ms]: normal
/// alone, normal and tangential.
const CONTACT: [([usize; 2], usize, [f64; 2]); 3] = [
    ([21, 18], 114, [0.345, 1.03]),
    ([29, 29], 301, [0.917, 4.59]),
    ([53, 57], 1200, [4.63, 58.2]),
];
/// More grids for the growth.
const GROWTH: [usize; 8] = [10, 20, 40, 60, 80, 120, 200, 356];

const APPROACH: f64 = 1.003e-4;
const RADIUS: f64 = 0.459_73;

/// Points of the separation with wheelset shifted -4 mm: a file of the tests.
fn separation() -> (Vec<f64>, Vec<f64>) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/contact_25_1/planar/y-4.csv");
    let text = std::fs::read_to_string(path).unwrap();
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|line| {
        let (y, f) = line.split_once(',').unwrap();
        (1e-3 * y.parse::<f64>().unwrap(), 1e-3 * f.parse::<f64>().unwrap())
    })
    .unzip()
}

/// Undeformed distance at the elements of a grid.
fn distance(grid: &Grid) -> Vec<f64> {
    let (y, f) = separation();
    let slopes = interpolating_slopes(&y, &f, [SplineEnd::Natural; 2]);
    grid.sample(|x, at| {
        let i = y.partition_point(|&knot| knot <= at).clamp(1, y.len() - 1) - 1;
        let (h, t) = (y[i + 1] - y[i], (at - y[i]) / (y[i + 1] - y[i]));
        let (a, b) = (t * t * (3.0 - 2.0 * t), t * (1.0 - t));
        f[i] + a * (f[i + 1] - f[i])
            + h * b * ((1.0 - t) * slopes[i] - t * slopes[i + 1])
            + x * x / (2.0 * RADIUS)
    })
}

/// A grid with `elements` of such a size that about `in_contact` of them are loaded.
fn grid(elements: [usize; 2], in_contact: usize) -> Grid {
    // The area is 136.8 mm², 13.7 mm long and 12.8 mm wide.
    let size = (136.8e-6 / in_contact as f64).sqrt();
    let (dx, dy) = (1.035 * size, size / 1.035);
    let (a, b) = (0.5 * elements[0] as f64 * dx, 0.5 * elements[1] as f64 * dy);
    Grid::over([-a, a], [-2.7e-4 - b, -2.7e-4 + b], elements[0], elements[1])
}

fn steel() -> MaterialPair {
    let steel = Material { young_modulus: 2.0992e11, poisson_ratio: 0.28 };
    MaterialPair::new(steel, steel)
}

/// Creepages from small to saturated, with and without spin.
const CREEPAGES: [[f64; 3]; 8] = [
    [1e-4, 0.0, 0.0],
    [1e-3, 0.0, 0.0],
    [0.0, 2e-3, 0.0],
    [3e-4, -3e-4, 0.1],
    [1e-3, 1e-3, -0.3],
    [0.0, 0.0, 0.5],
    [4e-3, 2e-3, 0.8],
    [1e-2, -1e-2, 1.0],
];

fn rigid_slip(grid: &Grid, [longitudinal, lateral, spin]: [f64; 3]) -> Vec<[f64; 2]> {
    let place = |k: usize| (grid.x(k % grid.along), grid.y(k / grid.along));
    (0..grid.len())
        .map(|k| (longitudinal - spin * place(k).1, lateral + spin * place(k).0))
        .map(|(x, y)| [x, y])
        .collect()
}

fn normal(grid: Grid, distance: &[f64]) -> Vec<f64> {
    let mut solver = PressureSolver::new(grid, steel().contact_modulus);
    solver.at_approach(distance, APPROACH, None).pressure
}

/// Means over the creepages of the time of the tangential problem [s] and of its sweeps.
fn tangential(grid: &Grid, pressure: &[f64]) -> (f64, f64) {
    let bound: Vec<f64> = pressure.iter().map(|p| 0.3 * p).collect();
    let (mut time, mut sweeps) = (0.0, 0.0);
    for creepage in CREEPAGES {
        let rigid = rigid_slip(grid, creepage);
        let once = || {
            let begin = Instant::now();
            let found = black_box(steady_rolling(grid, &steel(), &bound, &rigid));
            (begin.elapsed().as_secs_f64(), found.sweeps)
        };
        let best = (0..3).map(|_| once()).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
        time += best.0 / CREEPAGES.len() as f64;
        sweeps += best.1 as f64 / CREEPAGES.len() as f64;
    }
    (time, sweeps)
}

/// Table of times by size and the exponent with which they grow.
fn growth() {
    println!("elements in contact, normal [ms], normal + tangential [ms], sweeps");
    let mut rows: Vec<[f64; 3]> = Vec::new();
    let line = |elements: [usize; 2], in_contact: usize| {
        let grid = grid(elements, in_contact);
        let distance = distance(&grid);
        let mut best = f64::INFINITY;
        for _ in 0..5 {
            let begin = Instant::now();
            black_box(normal(grid, &distance));
            best = best.min(begin.elapsed().as_secs_f64());
        }
        let pressure = normal(grid, &distance);
        let loaded = pressure.iter().filter(|&&p| p > 0.0).count();
        let (time, sweeps) = tangential(&grid, &pressure);
        println!("{loaded:6} {:9.3} {:9.3} {sweeps:6.1}", 1e3 * best, 1e3 * (best + time));
        [loaded as f64, best, best + time]
    };
    for (elements, in_contact, [n, both]) in CONTACT {
        line(elements, in_contact);
        println!("{in_contact:6} {n:9.3} {both:9.3}  CONTACT v25.1, measured elsewhere");
    }
    for across in GROWTH {
        // As in the element: a margin of one on all sides.
        let in_contact = (0.79 * (across * across) as f64) as usize;
        rows.push(line([across + 2, across + 2], in_contact));
    }
    draw(&rows);
    for pair in rows.windows(2) {
        let exponent = |c: usize| (pair[1][c] / pair[0][c]).ln() / (pair[1][0] / pair[0][0]).ln();
        println!(
            "{:6} to {:6}: normal n^{:.2}, both n^{:.2}",
            pair[0][0],
            pair[1][0],
            exponent(1),
            exponent(2)
        );
    }
}

/// Draws times [s] over elements in contact, beside those of CONTACT.
fn draw(rows: &[[f64; 3]]) {
    const PATH: &str =
        concat!(env!("CARGO_MANIFEST_DIR"), "/docs/figures/boundary_element_time.svg");
    let area = SVGBackend::new(PATH, (760, 460)).into_drawing_area();
    let series =
        [("normal", 1, RGBColor(0, 114, 178)), ("normal and rolling", 2, RGBColor(213, 94, 0))];
    area.fill(&WHITE).expect("drawing");
    let mut chart = ChartBuilder::on(&area)
        .margin(12)
        .x_label_area_size(46)
        .y_label_area_size(64)
        .build_cartesian_2d((50.0..2e5f64).log_scale(), (1e-5..1e3f64).log_scale())
        .expect("drawing");
    chart
        .configure_mesh()
        .x_desc("elements in contact")
        .y_desc("time [s]")
        .light_line_style(WHITE)
        .bold_line_style(RGBColor(225, 225, 225))
        .label_style(("Helvetica, Arial, sans-serif", 14))
        .x_label_formatter(&|x| format!("{x:.0}"))
        .y_label_formatter(&|y| format!("{y:.0e}"))
        .draw()
        .expect("drawing");
    for (name, column, colour) in series {
        let line = rows.iter().map(|row| (row[0], row[column]));
        let drawn = chart.draw_series(LineSeries::new(line, colour.stroke_width(2)));
        drawn.expect("drawing").label(name).legend(move |(x, y)| {
            PathElement::new(vec![(x, y), (x + 18, y)], colour.stroke_width(2))
        });
        let program =
            CONTACT.map(|(_, in_contact, times)| (in_contact as f64, 1e-3 * times[column - 1]));
        let marks = program.into_iter().map(|at| Circle::new(at, 4, colour.stroke_width(2)));
        let drawn = chart.draw_series(marks).expect("drawing");
        drawn
            .label(format!("{name}: CONTACT v25.1, measured elsewhere"))
            .legend(move |(x, y)| Circle::new((x + 9, y), 4, colour.stroke_width(2)));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .label_font(("Helvetica, Arial, sans-serif", 14))
        .border_style(RGBColor(200, 200, 200))
        .background_style(WHITE)
        .draw()
        .expect("drawing");
    area.present().expect("the figure can be written");
}

fn benches(criterion: &mut Criterion) {
    growth();
    let mut group = criterion.benchmark_group("boundary_element");
    for (elements, in_contact, _) in CONTACT {
        let grid = grid(elements, in_contact);
        let distance = distance(&grid);
        group.bench_with_input(BenchmarkId::new("normal", in_contact), &grid, |b, grid| {
            b.iter(|| normal(*grid, black_box(&distance)));
        });
        let bound: Vec<f64> = normal(grid, &distance).iter().map(|p| 0.3 * p).collect();
        let rigid = rigid_slip(&grid, CREEPAGES[4]);
        group.bench_with_input(BenchmarkId::new("rolling", in_contact), &grid, |b, grid| {
            b.iter(|| steady_rolling(grid, &steel(), black_box(&bound), &rigid));
        });
    }
    group.finish();
}

criterion_group!(boundary_element, benches);
criterion_main!(boundary_element);
