//! The `fmi` crate: a co-simulation with a fixed step. Arguments and answers as in `client.py`
//! beside.

use std::error::Error;
use std::{env, fs};

use fmi::fmi2::import::Fmi2Import;
use fmi::fmi2::instance::{CoSimulation, Common};
use fmi::traits::FmiImport;

const STEP: f64 = 1e-3;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [archive, positions, answers, outputs] = arguments.as_slice() else {
        return Err("arguments: archive, positions, file for the answers, names of outputs".into());
    };
    let unit: Fmi2Import = fmi::import::from_path(archive)?;
    let reference = |name: &str| {
        let variables = &unit.model_description().model_variables.variables;
        let found = variables.iter().find(|variable| variable.name == name);
        found.map(|variable| variable.value_reference).ok_or(format!("no variable {name}"))
    };
    let text = fs::read_to_string(positions)?;
    let mut rows = text.lines().filter(|line| !line.starts_with('#'));
    let names = rows.next().ok_or("no names")?.split(',');
    let inputs = names.map(reference).collect::<Result<Vec<_>, _>>()?;
    let wanted = outputs.split(',').map(reference).collect::<Result<Vec<_>, _>>()?;

    let mut instance = unit.instantiate_cs("wheel", false, false)?;
    instance.setup_experiment(None, 0.0, None)?;
    instance.enter_initialization_mode()?;
    instance.exit_initialization_mode()?;
    let mut lines = outputs.clone();
    let mut values = vec![0.0; wanted.len()];
    for (step, row) in rows.enumerate() {
        let position = row.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        instance.set_real(&inputs, &position)?;
        instance.do_step(step as f64 * STEP, STEP, true)?;
        instance.get_real(&wanted, &mut values)?;
        let values: Vec<String> = values.iter().map(f64::to_string).collect();
        lines.push_str(&format!("\n{}", values.join(",")));
    }
    instance.terminate()?;
    Ok(fs::write(answers, lines)?)
}
