//! Places of the line from which the nearest point of the rail is hard to find.

use super::ContactSearch;
use crate::geometry::profiles::profile::ProfileKind;
use crate::geometry::profiles::standard_profiles::built_in;
use crate::geometry::rail::placed_rail::PlacedRail;
use crate::geometry::rail::varying_rail::WheelAbove;
use crate::geometry::sections::slices::{Slice, Slices};
use crate::geometry::uneven::waviness::Waviness;
use crate::geometry::wheel::contact_line::{ContactLine, WheelPose};

#[test]
fn the_rim_of_a_flange_far_above_the_side_of_a_rail_does_not_touch_it() {
    let wheel = built_in("S1002", ProfileKind::Wheel).unwrap().unwrap();
    let profile = built_in("60E1", ProfileKind::Rail).unwrap().unwrap();
    let slice = |place: f64| Slice { place, profile: profile.clone(), features: vec![] };
    let slices = [-1.0, -0.5, 0.0, 0.5, 1.0].map(slice).to_vec();
    let slices = Slices::new("equal", slices, false).unwrap();
    let above = WheelAbove {
        profile: &wheel.curve,
        nominal_radius: 0.46,
        waves: Waviness::new(None),
        around: None,
    };
    let rail = PlacedRail::by_gauge(&profile.curve, 0.025, 1.435, 0.014, false).unwrap();
    let [y, z] = rail.marker;
    let mut rail = rail.varying(&slices, Waviness::new(None), &above);
    let mut search = ContactSearch::new(&wheel.curve);
    // Lateral place, height, roll, yaw; first touch is 20 to 27 mm below. The line runs from the
    // back of the flange to its rim within a step, over a hand's breadth.
    for [across, down, roll, yaw] in [
        [0.745_505_0, -0.486_815, -8.356_199e-3, -0.046_372_131],
        [0.748_725_18, -0.482_795_8, 1.396_697e-3, -0.047_381_231],
        [0.750_097_82, -0.480_849_8, 7.938_803e-3, 0.046_661_815],
        [0.748_284_78, -0.478_850_4, -4.070_715e-3, -0.046_377_202],
        [0.746_922_73, -0.491_749_5, -0.019_846_78, -0.057_595_426],
    ] {
        let pose = WheelPose { marker: [0.0, across - y, down - z], roll, yaw };
        let line = ContactLine::new(&wheel.curve, 0.46, &pose);
        assert!(rail.pass(&line, &pose, [0.0; 2], 0.0));
        search.search(&line, &rail, &[line.range()]);
        assert!(search.contacts.is_empty(), "{:?}", search.contacts[0]);
    }
}
