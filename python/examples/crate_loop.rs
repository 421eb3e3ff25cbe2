//! The loop that an array call is measured against: the crate by itself, one thread, the same cases.
//!
//! `crate_loop FILE NORMAL CREEPAGE TANGENTIAL`: rows of y, yaw and z as little-endian doubles, and the models; prints seconds for all rows.
//! `benchmarks/throughput.py` runs it.

use std::hint::black_box;
use std::time::Instant;

use wheelrail::element::{Element, Input, Output};
use wheelrail::variables::{Values, find};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let mut values = Values::default();
    let models = ["normal.model", "creepage.model", "tangential.model"];
    for (name, item) in models.iter().zip(&arguments[2..]) {
        values.set_from_text(find(name)?, item)?;
    }
    let bytes = std::fs::read(&arguments[1])?;
    let numbers: Vec<f64> =
        bytes.as_chunks::<8>().0.iter().map(|b| f64::from_le_bytes(*b)).collect();
    let mut input = Input::default();
    input.wheel.velocity[0] = 20.0;
    input.wheel.pitch_rate = -20.0 / 0.46;
    let mut element = Element::new(&values.parameters, &input, &[])?;
    let mut output = Output::default();
    let mut forces = vec![[0.0; 3]; numbers.len() / 3];
    let mut best = f64::INFINITY;
    for _ in 0..3 {
        let begin = Instant::now();
        for (row, force) in numbers.as_chunks::<3>().0.iter().zip(&mut forces) {
            let [y, yaw, z] = *row;
            (input.wheel.position[1], input.wheel.yaw, input.wheel.position[2]) = (y, yaw, z);
            element.evaluate(&input, &mut output)?;
            *force = output.wheel.force;
        }
        best = best.min(begin.elapsed().as_secs_f64());
        black_box(&forces);
    }
    println!("{best}");
    Ok(())
}
