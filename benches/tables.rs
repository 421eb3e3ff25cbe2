//! Time of one look-up of a creep force: Kalker's coefficients, angles, table; without and with
//! derivatives.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use wheelrail::tangential::tables::CreepForceTable;
use wheelrail::tangential::tables::scales::Scales;

/// ln(a/b) and creepages of states in different places of the table, so that nothing but the next
/// few lines is in the nearest cache.
const STATES: [(f64, [f64; 3]); 8] = [
    (0.1, [0.05, 0.02, 0.1]),
    (-0.9, [0.3, -0.1, 0.2]),
    (0.7, [-0.2, 0.3, -0.4]),
    (1.6, [0.0, 0.1, 0.05]),
    (-2.1, [0.6, 0.6, 0.3]),
    (0.4, [-0.4, -0.02, 1.0]),
    (2.4, [0.02, 0.03, -0.02]),
    (-0.2, [2.0, 1.0, 0.5]),
];

fn look_up(c: &mut Criterion) {
    let table = CreepForceTable::shared();
    let mut group = c.benchmark_group("tables");
    group.bench_function("look_up", |b| {
        let mut k = 0;
        b.iter(|| {
            k = (k + 1) % STATES.len();
            let (log_ratio, v) = black_box(STATES[k]);
            table.force(&Scales::of(log_ratio, 0.28), v)
        });
    });
    group.bench_function("look_up_with_derivatives", |b| {
        let mut k = 0;
        b.iter(|| {
            k = (k + 1) % STATES.len();
            let (log_ratio, v) = black_box(STATES[k]);
            table.force_and_slopes(&Scales::of(log_ratio, 0.28), v)
        });
    });
    group.bench_function("coefficients_alone", |b| {
        b.iter(|| Scales::of(black_box(0.3), 0.28));
    });
    group.finish();
}

criterion_group!(benches, look_up);
criterion_main!(benches);
