//! The loop that an array call is measured against: the crate by itself, one thread, the same cases.
//!
//! `crate_loop FILE PASSES NAME=VALUE …`: rows of y, yaw and z as little-endian doubles, how often to go through them, parameters and
//! inputs; prints the least time of a pass in seconds. `benchmarks/throughput.py` runs it.

use std::hint::black_box;
use std::time::Instant;

use wheelrail::element::{Element, Output};
use wheelrail::variables::{Values, find};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, file, passes, settings @ ..] = &arguments[..] else {
        return Err("crate_loop FILE PASSES NAME=VALUE …".into());
    };
    let mut values = Values::default();
    for setting in settings {
        let (name, value) = setting.split_once('=').ok_or("a setting is NAME=VALUE")?;
        values.set_from_text(find(name)?, value)?;
    }
    let bytes = std::fs::read(file)?;
    let numbers: Vec<f64> =
        bytes.as_chunks::<8>().0.iter().map(|b| f64::from_le_bytes(*b)).collect();
    let mut input = values.input;
    let mut element = Element::new(&values.parameters, &input, &[])?;
    let mut output = Output::default();
    let mut forces = vec![[0.0; 3]; numbers.len() / 3];
    let mut best = f64::INFINITY;
    for _ in 0..passes.parse()? {
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
