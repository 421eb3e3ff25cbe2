//! Outlines of contact patches of the model `strips` beside those of CONTACT: tread, two regions,
//! slender flange. Prints distances of the leading edges.

use std::error::Error;
use std::path::Path;

use super::chart::{self, Chart, Corner, Series};
use csv::{Reader, ReaderBuilder, StringRecord};
use wheelrail::material::Material;
use wheelrail::planar::{
    FlashTemperature, Flexibilities, FrictionLaw, Indentation, NormalModel, PlanarCase, ShapeFit,
    TangentialModel, TractionBound, fields,
};

/// G = 82 GPa, ν = 0.28, as the reference has it.
const STEEL: Material = Material { young_modulus: 2.0992e11, poisson_ratio: 0.28 };
/// Strips across each region, elements along each of them.
const STRIPS: usize = 31;
const ALONG: usize = 200;

/// Cases of the reference: separation, approach and wheel radius [mm], what they are.
const CASES: [(&str, f64, f64, &str); 3] = [
    ("y0", 0.0752, 459.9589, "Tread, 100 kN: the rail's curvature jumps inside the patch"),
    ("y5", 0.0567, 464.4403, "Tread and flange root, 50 kN: two regions"),
    ("y7", 0.1155, 1381.6153, "Slender flange contact, 100 kN: scales of the axes differ"),
];

/// Ends of the contact on one row [mm]: y, least and greatest x.
type Ends = [f64; 3];
/// Rows of one region, in growing y.
type Region = Vec<Ends>;

pub fn draw(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    let outlines = read("planar_outlines.csv", ["y_mm", "x_min_mm", "x_max_mm"])?;
    let mut charts = Vec::new();
    println!("case,model,regions,regions_of_contact,rows,median_mm,greatest_mm");
    for (case, approach, radius, title) in CASES {
        let rows: Vec<Ends> =
            outlines.iter().filter(|(name, _)| name == case).map(|(_, ends)| *ends).collect();
        let reference = regions(&rows);
        let points: Vec<[f64; 2]> = read(&format!("planar/{case}.csv"), ["y_mm", "f_mm"])?
            .iter()
            .map(|(_, p)| p.map(|value| 1e-3 * value))
            .collect();
        let solved = |model, across| patch(&points, approach, radius, model, across);
        let (strips, kik) =
            (solved(NormalModel::Strips, 40)?, solved(NormalModel::PiotrowskiKik, 100)?);
        for (model, rows) in [("strips", &strips), ("piotrowski_kik", &kik)] {
            let (count, [median, most]) = distance(rows, &reference);
            let (regions, of_contact) = (rows.len(), reference.len());
            println!("{case},{model},{regions},{of_contact},{count},{median:.3},{most:.3}");
        }
        charts.push(Chart {
            title,
            x: "y, across [mm]",
            y: "x, in the direction of rolling [mm]",
            downwards: false,
            height: 300,
            legend: Corner::UpperRight,
            legend_room: 0.16,
            series: vec![
                Series::line("CONTACT", closed(&reference)),
                Series::dots(
                    "strips",
                    strips.iter().flatten().flat_map(|e| [[e[0], e[1]], [e[0], e[2]]]).collect(),
                ),
                Series::line("piotrowski_kik", closed(&kik)),
            ],
        });
    }
    arguments.first().map_or(Ok(()), |path| chart::save(path, &charts))
}

/// Names and numbers.
type Rows<const N: usize> = Vec<(String, [f64; N])>;

/// First column and `columns` of a table of the reference.
fn read<const N: usize>(name: &str, columns: [&str; N]) -> Result<Rows<N>, Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/contact_25_1");
    let mut table: Reader<_> =
        ReaderBuilder::new().comment(Some(b'#')).from_path(folder.join(name))?;
    let headings = table.headers()?.clone();
    let mut rows = Vec::new();
    for record in table.records() {
        let record: StringRecord = record?;
        let mut values = [0.0; N];
        for (value, column) in values.iter_mut().zip(columns) {
            let k = headings.iter().position(|heading| heading == column).ok_or(column)?;
            *value = record[k].parse()?;
        }
        rows.push((record[0].to_string(), values));
    }
    Ok(rows)
}

/// Ends of the loaded elements on `across` rows of each region.
fn patch(
    separation: &[[f64; 2]],
    approach: f64,
    radius: f64,
    normal_model: NormalModel,
    across: usize,
) -> Result<Vec<Region>, Box<dyn Error>> {
    let case = PlanarCase {
        separation,
        radius: 1e-3 * radius,
        indentation: Indentation::Approach(1e-3 * approach),
        creepage: [0.0; 3],
        friction: 0.3,
        friction_across: &[],
        wheel_material: STEEL,
        rail_material: STEEL,
        normal_model,
        virtual_penetration: 0.55,
        shape_fit: ShapeFit::Hertz,
        tangential_model: TangentialModel::None,
        strips: STRIPS,
        elements_along: ALONG,
        elements: [ALONG, across],
        bound: TractionBound::Elliptic,
        flexibilities: Flexibilities::Three,
        friction_law: FrictionLaw::default(),
        gauge_face_law: FrictionLaw::default(),
        flash_temperature: FlashTemperature::default(),
        speed: 0.0,
    };
    let mut regions = Vec::new();
    for field in fields(&case)? {
        let grid = &field.grid;
        let mut rows = Vec::new();
        for row in 0..grid.across {
            let loaded = (0..grid.along).filter(|i| field.pressure[row * grid.along + i] > 0.0);
            let x: Vec<f64> = loaded.map(|i| grid.x(i)).collect();
            if let (Some(first), Some(last)) = (x.first(), x.last()) {
                let [least, most] = [last - 0.5 * grid.dx, first + 0.5 * grid.dx];
                rows.push([grid.y(row), least, most].map(|value| 1e3 * value));
            }
        }
        regions.push(rows);
    }
    Ok(regions)
}

/// The rows of the reference by region: where two are further apart than the others, another
/// begins.
fn regions(rows: &[Ends]) -> Vec<Region> {
    let step = |pair: &[Ends]| pair[1][0] - pair[0][0];
    let least = rows.windows(2).map(step).fold(f64::MAX, f64::min);
    rows.chunk_by(|a, b| b[0] - a[0] < 1.5 * least).map(<[Ends]>::to_vec).collect()
}

/// Closed outlines of all regions, parted by a point that is none.
fn closed(regions: &[Region]) -> Vec<[f64; 2]> {
    let mut points = Vec::new();
    for region in regions {
        points.extend(region.iter().map(|e| [e[0], e[2]]));
        points.extend(region.iter().rev().map(|e| [e[0], e[1]]));
        points.extend(region.first().map(|e| [e[0], e[2]]));
        points.push([f64::NAN; 2]);
    }
    points
}

/// Leading ends against those of `reference`: number of rows between its rows, median and greatest
/// distance along x [mm].
fn distance(found: &[Region], reference: &[Region]) -> (usize, [f64; 2]) {
    let mut distances = Vec::new();
    for pair in reference.iter().flat_map(|region| region.windows(2)) {
        for row in found.iter().flatten().filter(|e| (pair[0][0]..pair[1][0]).contains(&e[0])) {
            let share = (row[0] - pair[0][0]) / (pair[1][0] - pair[0][0]);
            let front = pair[0][2] + share * (pair[1][2] - pair[0][2]);
            distances.push((row[2] - front).abs());
        }
    }
    distances.sort_by(f64::total_cmp);
    let at = |share: usize| distances.get((distances.len() * share / 2).saturating_sub(1));
    (distances.len(), [at(1), at(2)].map(|d| d.copied().unwrap_or(f64::NAN)))
}
