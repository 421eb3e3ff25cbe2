use std::hint::black_box;
use wheelrail::element::parameters::TangentialModel as M;
use wheelrail::element::{Element, Input, Output, Parameters};
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let model = match a[1].as_str() { "none" => M::None, "marches" => M::Marches, "corrected" => M::FastsimCorrected, _ => panic!() };
    let parameters = Parameters { tangential_model: model, ..Parameters::default() };
    let mut input = Input::default();
    input.wheel.position[1] -= a[3].parse::<f64>().unwrap();
    input.wheel.yaw = 1e-3;
    input.track_s = 0.4003;
    input.wheel.velocity = [20.0, 0.0, 0.0];
    input.wheel.pitch_rate = -20.0 / 0.46;
    let mut element = Element::new(&parameters, &input, &[]).unwrap();
    input.wheel.position[2] = element.nominal_wheel_z() + 6e-5;
    let (mut output, mut step) = (Output::default(), 1e-10);
    for _ in 0..=a[2].parse::<usize>().unwrap() {
        step = -step;
        input.wheel.position[2] += step;
        element.evaluate(black_box(&input), &mut output).unwrap();
        black_box(&output);
    }
    println!("{:?} patches {} N {}", output.patches[0].creep_force, output.patch_count, output.patches[0].normal_force);
}
