//! What do wheels and rails look like after 253 thousand kilometres? Two load cases in one run, and
//! profiles that wear while it goes on (Piotrowski and Kik 2008, section 6): a wheelset that
//! flanges on the left rail at an angle of attack of 25 mrad, and the same one swaying along
//! straight track, both driven by 6 kN m. Then the same one run after the other, a new profile
//! after each. Arguments: figure, updates of the profiles.

use std::error::Error;
use std::time::Instant;

use super::chart::{self, Chart, Corner, Series};
use super::driven_wheelset::{DrivenWheelset, Guidance};
use wheelrail::element::parameters::WearModel;
use wheelrail::element::{Parameters, WornBody};
use wheelrail::geometry::profile::Profile;

/// Time that is simulated and step of the integration [s].
const TIME: f64 = 10.0;
const STEP: f64 = 5e-4;
/// Mileage that the run stands for [m], share of it spent flanging, and axles of 20 t that pass
/// each site: 1.8 Mt.
const MILEAGE: f64 = 253e6;
const FLANGING: f64 = 0.002;
const PASSAGES: f64 = 9e4;
/// Mass worn off per frictional work in either load case: in a dry curve and on damp straight track
/// [kg/J].
const WEAR: [f64; 2] = [2e-9, 2e-10];
/// Runs one after the other that are really made; the time of 1000 follows.
const SEQUENTIAL_RUNS: usize = 3;

pub fn draw(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let figure = arguments.first();
    let updates: usize = arguments.get(1).map_or(Ok(1000), |text| text.parse())?;
    let cases = || -> Result<[DrivenWheelset; 2], Box<dyn Error>> {
        let sway = Guidance::Sway { amplitude: 2.5e-3, wavelength: 20.0 };
        let mut cases = [
            DrivenWheelset::new(&parameters(FLANGING, WEAR[0]), Guidance::Free { yaw: -0.025 })?,
            DrivenWheelset::new(&parameters(1.0 - FLANGING, WEAR[1]), sway)?,
        ];
        cases.iter_mut().try_for_each(|case| case.settle(STEP))?;
        Ok(cases)
    };
    let mut parallel = cases()?;
    let start = Instant::now();
    run(&mut parallel, updates, 1.0)?;
    let parallel_time = start.elapsed().as_secs_f64();

    let mut without = cases()?;
    let start = Instant::now();
    run(&mut without, 0, 0.0)?;
    let dynamics = start.elapsed().as_secs_f64();

    let mut sequential = cases()?;
    let start = Instant::now();
    for _ in 0..SEQUENTIAL_RUNS {
        sequential.iter_mut().try_for_each(|case| case.settle(STEP))?;
        // As little wear in each as there is for one of so many profiles.
        run(&mut sequential, 1, 1.0 / updates as f64)?;
    }
    let sequential_time = start.elapsed().as_secs_f64() / SEQUENTIAL_RUNS as f64;
    eprintln!(
        "{updates} profiles in one run {parallel_time:.2} s, {:.2} times the run without wear; a profile by a run of its own \
         {sequential_time:.2} s, {updates} of them {:.0} times as long as the one run",
        parallel_time / dynamics,
        updates as f64 * sequential_time / parallel_time
    );
    println!("case,body,worn_area_mm2,worn_volume_mm3,depth_mm");
    for (number, case) in (1..).zip(&parallel) {
        for (side, output) in ["left", "right"].into_iter().zip(&case.outputs) {
            for (body, wear) in [("wheel", output.wheel_wear), ("rail", output.rail_wear[0])] {
                let [area, volume, depth] = [1e6 * wear.area, 1e9 * wear.volume, 1e3 * wear.depth];
                println!("{number},{side} {body},{area:.3},{volume:.0},{depth:.4}");
            }
        }
    }
    figure.map_or(Ok(()), |path| chart::save(path, &charts(&parallel)?))
}

/// Parameters of a load case that has a `share` of the mileage and this coefficient of wear [kg/J].
fn parameters(share: f64, wear: f64) -> Parameters {
    let mut parameters = Parameters::default();
    let run = 20.0 * TIME;
    parameters.wear.model = WearModel::FrictionalWork;
    for law in [&mut parameters.wear.wheel, &mut parameters.wear.rail] {
        law.frictional_work.coefficient = wear;
    }
    parameters.wear.acceleration_factor = share * MILEAGE / run;
    // A site is passed so often in all: what wears off in one run stands for so much of the mileage
    // over the passages.
    parameters.wear.rail_distance = share * MILEAGE / PASSAGES;
    parameters
}

/// Runs both load cases side by side with `updates` updates; what wears is multiplied by `share`.
fn run(cases: &mut [DrivenWheelset; 2], updates: usize, share: f64) -> Result<(), Box<dyn Error>> {
    let steps = (TIME / STEP).round() as usize;
    for step in 1..=steps {
        cases.iter_mut().try_for_each(|case| case.step(STEP, share * STEP))?;
        if updates > 0 && step % (steps / updates) == 0 {
            update(cases);
        }
    }
    // What the outputs say is that of the last step.
    cases.iter_mut().try_for_each(|case| case.step(STEP, 0.0))
}

/// New profiles; the wheels of both load cases are the same ones.
fn update(cases: &mut [DrivenWheelset; 2]) {
    let [first, second] = cases;
    for (a, b) in first.wheels.iter_mut().zip(&mut second.wheels) {
        if let (Some(of_a), Some(of_b)) = (a.wear_state(), b.wear_state()) {
            a.share_wheel_wear(&of_b);
            b.share_wheel_wear(&of_a);
        }
        a.update_profiles();
        b.update_profiles();
    }
}

/// Points of a profile over a range of y [mm].
fn points(profile: &Profile, range: std::ops::Range<f64>) -> Vec<[f64; 2]> {
    let curve = &profile.curve;
    let length = curve.end() - curve.start();
    let at = |i: usize| curve.at(curve.start() + length * i as f64 / 1500.0).point;
    (0..=1500)
        .map(at)
        .map(|[y, z]| [1e3 * y, 1e3 * z])
        .filter(|p| range.contains(&p[0]) && p[1] < 20.0)
        .collect()
}

fn charts(cases: &[DrivenWheelset; 2]) -> Result<Vec<Chart>, Box<dyn Error>> {
    let unworn = DrivenWheelset::new(&Parameters::default(), Guidance::Free { yaw: 0.0 })?;
    let wheel = |case: &DrivenWheelset, side: usize| case.wheels[side].worn_wheel();
    let rail = |case: &DrivenWheelset, side: usize| case.wheels[side].worn_rail(0);
    let line = |name: &str, profile: Option<Profile>, range: std::ops::Range<f64>| {
        Series::line(name, profile.map(|profile| points(&profile, range)).unwrap_or_default())
    };
    let (tread, gauge_side) = (-45.0..30.0, -38.0..-10.0);
    let depth = |name: &str, case: usize, side: usize, body: WornBody| {
        let depth = cases[case].wheels[side].wear_depth(body);
        Series::line(
            name,
            depth
                .iter()
                .map(|p| p.map(|x| 1e3 * x))
                .filter(|p| p[0] > -45.0 && p[0] < 35.0)
                .collect(),
        )
    };
    let rail_depth = WornBody::Rail(0);
    let chart = |title, y, downwards, height, series| Chart {
        title,
        x: "y on the profile, to the field side [mm]",
        y,
        downwards,
        height,
        legend: if downwards { Corner::LowerRight } else { Corner::UpperRight },
        legend_room: 0.0,
        series,
    };
    Ok(vec![
        chart(
            "Wheels",
            "z, down [mm]",
            true,
            300,
            vec![
                line("S1002", wheel(&unworn, 0), tread.clone()),
                line("left, worn", wheel(&cases[0], 0), tread.clone()),
                line("right, worn", wheel(&cases[0], 1), tread),
            ],
        ),
        chart(
            "Gauge side of the left rail of the flanging wheelset",
            "z, down [mm]",
            true,
            300,
            vec![
                line("60E1", rail(&unworn, 0), gauge_side.clone()),
                line("worn", rail(&cases[0], 0), gauge_side),
            ],
        ),
        chart(
            "Wear depth of the wheels",
            "wear depth [mm]",
            false,
            260,
            vec![depth("left", 0, 0, WornBody::Wheel), depth("right", 0, 1, WornBody::Wheel)],
        ),
        chart(
            "Wear depth of the rails of the flanging wheelset",
            "wear depth [mm]",
            false,
            260,
            vec![depth("left", 0, 0, rail_depth), depth("right", 0, 1, rail_depth)],
        ),
        chart(
            "Wear depth of the rails of the swaying wheelset",
            "wear depth [mm]",
            false,
            260,
            vec![depth("left", 1, 0, rail_depth), depth("right", 1, 1, rail_depth)],
        ),
    ])
}
