//! Where does a wheel touch at angles of attack of 0, 3 and 6 degrees? Its contact lines, seen
//! along the rail and from above.

use std::error::Error;

use super::chart::{self, Chart, Corner, Series};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::geometry::contact_line::{ContactLine, LinePoint, WheelPose};
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::load_profile;

const DEGREES: [f64; 3] = [0.0, 3.0, 6.0];

pub fn draw(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let wheel = load_profile("wheel.profile", "S1002", ProfileKind::Wheel, 0.0, &[])?;
    let (mut seen, mut above, mut contacts) = (Vec::new(), Vec::new(), Vec::new());
    println!("yaw_deg,shift_mm,patch,wheel_y_mm,ahead_mm,angle_deg,penetration_um");
    for degrees in DEGREES {
        let yaw = f64::to_radians(degrees);
        let pose = WheelPose { marker: [0.0; 3], roll: 0.0, yaw };
        let line = ContactLine::new(&wheel.curve, 0.46, &pose);
        let [start, end] = line.range();
        let points: Vec<_> =
            (0..=3000).map(|i| line.at(start + (end - start) * f64::from(i) / 3000.0)).collect();
        // As far down as a rail can reach; in a flange root that folds the line only its lower
        // branches show.
        let tip = points.iter().map(|p| p.point[1]).fold(0.0, f64::max);
        let tip = points.iter().position(|p| p.point[1] >= tip).unwrap_or(0);
        let hidden = |i: usize| {
            let [y, z] = points[i].point;
            let covers = |pair: &[LinePoint]| {
                let [[y0, z0], [y1, z1]] = [pair[0].point, pair[1].point];
                let share = (y - y0) / (y1 - y0);
                (0.0..=1.0).contains(&share) && z0 + share * (z1 - z0) > z + 1e-6
            };
            i > tip && points[tip..].windows(2).any(covers)
        };
        let visible: Vec<LinePoint> = (0..points.len())
            .filter(|&i| points[i].point[1] > 0.452 && !hidden(i))
            .map(|i| points[i])
            .collect();
        let low = || visible.iter();
        let name = format!("{degrees}°");
        seen.push(Series::line(&name, low().map(|p| p.point.map(|c| 1e3 * c)).collect()));
        above.push(Series::line(&name, low().map(|p| [1e3 * p.point[0], 1e3 * p.x]).collect()));
        contacts.extend(touching(yaw)?);
    }
    above.push(Series::dots("patches on 60E1, wheel at -3, 2 and 6 mm", contacts));
    if let Some(path) = arguments.first() {
        let (y, x) = ("lateral coordinate from the wheel marker [mm]", "ahead of the axle [mm]");
        let z = "below the axle [mm]";
        let title = "S1002 turned about z: what the rail sees of it";
        let first = Chart {
            title,
            x: y,
            y: z,
            downwards: true,
            legend: Corner::LowerRight,
            legend_room: 0.0,
            height: 300,
            series: seen,
        };
        let title = "The same lines from above, and where patches lie";
        let second = Chart {
            title,
            x: y,
            y: x,
            downwards: false,
            legend: Corner::UpperRight,
            legend_room: 0.0,
            height: 320,
            series: above,
        };
        chart::save(path, &[first, second])?;
    }
    Ok(())
}

/// The patches of a wheel pressed 0.05 mm into the rail at three lateral positions: across and
/// along from its marker [mm].
fn touching(yaw: f64) -> Result<Vec<[f64; 2]>, Box<dyn Error>> {
    let (mut input, mut output, mut found) = (Input::default(), Output::default(), Vec::new());
    let mut element = Element::new(&Parameters::default(), &input, &[])?;
    for shift in [-3e-3, 2e-3, 6e-3] {
        input.wheel.position[1] = 0.75 + shift;
        input.wheel.yaw = yaw;
        input.wheel.position[2] = element.touching_height(&input) + 5e-5;
        element.evaluate(&input, &mut output)?;
        for (number, p) in output.patches.iter().enumerate().filter(|(_, p)| p.rail > 0) {
            let [x, y, _] = p.position;
            found.push([1e3 * (y - input.wheel.position[1]), 1e3 * x]);
            println!(
                "{},{},{},{:.3},{:.3},{:.3},{:.2}",
                yaw.to_degrees().round(),
                1e3 * shift,
                number + 1,
                1e3 * p.wheel_y,
                1e3 * x,
                p.contact_angle.to_degrees(),
                1e6 * p.penetration
            );
        }
    }
    Ok(found)
}
