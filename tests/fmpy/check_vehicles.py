"""The bogie, the climbing flange and the coach of the examples with the packed wheelset: WHEELRAIL_WHEELSET names its archive."""

import os
import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2] / "examples"))

import cooperrider_bogie as bogie  # noqa: E402
import flange_climb as climb  # noqa: E402
import vehicle  # noqa: E402

LINEAR = {"normal.model": "hertz", "tangential.model": "linear", "creepage.model": "flat"}


class Bogie(unittest.TestCase):
    def unit(self, **models):
        unit = bogie.unit_of(os.environ["WHEELRAIL_WHEELSET"], **models)
        self.addCleanup(unit.close)
        return unit

    def test_with_the_published_law_it_hunts_from_the_published_speed_on(self):
        speed, _ = bogie.critical_speed(bogie.published_contact)
        self.assertLess(abs(speed / bogie.PUBLISHED - 1), 0.01)

    def test_a_large_swing_goes_on_at_70_and_dies_out_at_60_as_published(self):
        for speed, goes_on in ((70.0, True), (60.0, False)):
            state = np.zeros(14)
            state[0] = 0.01
            _, swing = bogie.swing(bogie.published_forces(speed), state)
            self.assertEqual(swing > bogie.DEAD, goes_on, swing)

    def test_swings_on_the_unit_go_on_above_its_critical_speed_alone(self):
        models = {"normal.model": "hertz", "tangential.model": "fastsim", "creepage.model": "flat"}
        friction = {f"{side}.friction.coefficient": bogie.LIMIT / bogie.LOAD for side in ("right", "left")}
        unit = self.unit(**models, **friction)
        critical, _ = bogie.critical_speed(bogie.contact_of(unit))
        state = np.zeros(14)
        state[0] = 1e-4
        # A small one, for two seconds.
        for speed, grows in ((0.9 * critical, False), (1.15 * critical, True)):
            _, swing = bogie.swing(bogie.forces_of(unit)(speed), state, 2.0)
            self.assertEqual(swing > 1e-4, grows, swing)

    def test_the_unit_has_the_ellipse_of_the_published_one(self):
        unit = self.unit(**LINEAR)
        bogie.contact_of(unit)(60.0)
        for name, axis in zip(("length", "width"), bogie.ELLIPSE):
            self.assertLess(abs(0.5 * unit.get(f"right.patch[1].{name}") / axis - 1), 0.005, name)

    def test_what_a_yawed_wheelset_gets_is_what_one_gets_that_drifts(self):
        speed = 60.0
        by_place, by_rate = bogie.contact_of(self.unit(**LINEAR))(speed)
        # Lateral creepage is vy/v - yaw; the yawed axle steers by its weight too.
        self.assertLess(abs(by_place[0, 1] / (-speed * by_rate[0, 0]) - 1), 0.02)
        # A cone steers towards the middle.
        self.assertLess(by_place[1, 0], 0)

    def test_it_hunts_on_the_unit_as_well(self):
        for models in (LINEAR, {}):
            unit = self.unit(**models)
            contact = bogie.contact_of(unit)
            speed, frequency = bogie.critical_speed(contact)
            self.assertLess(bogie.growth(contact, 0.9 * speed)[0], 0)
            self.assertGreater(bogie.growth(contact, 1.1 * speed)[0], 0)
            self.assertGreater(frequency, 1.0)
            # Kalker's slopes are within some 15 % of Vermeulen and Johnson's; the speed goes with their root.
            self.assertLess(abs(speed / bogie.PUBLISHED - 1), 0.15)


class FlangeClimb(unittest.TestCase):
    def test_a_free_wheel_at_a_large_angle_of_attack_climbs_at_nadals_limit(self):
        unit = climb.unit_of(os.environ["WHEELRAIL_WHEELSET"])
        self.addCleanup(unit.close)
        friction = 0.3
        free, angle = climb.limit(unit, 0.02, friction, True)
        solid, _ = climb.limit(unit, 0.02, friction, False)
        straight, _ = climb.limit(unit, 0.0, friction, True)
        # Nothing but friction across is left; what else is there holds more.
        self.assertLess(abs(free / climb.nadal(angle, friction) - 1), 0.005)
        self.assertGreater(solid, free)
        self.assertGreater(straight, free)


class Coach(unittest.TestCase):
    def test_in_a_curve_its_wheelsets_hold_what_cant_leaves(self):
        rows, _, _ = vehicle.run(os.environ["WHEELRAIL_WHEELSET"], 2e-3, vehicle.MODELS["piotrowski_kik + fastsim"])
        right, left = rows[-1, 9::2], rows[-1, 10::2]
        # Guiding forces are positive outwards.
        held = sum(left) - sum(right)
        across = vehicle.SPEED**2 * vehicle.CURVATURE - vehicle.GRAVITY * vehicle.CANT
        # The body still sways by some thousandths of its weight.
        self.assertLess(abs(held / (8 * vehicle.Vehicle().load / vehicle.GRAVITY * across) - 1), 0.01)
        # The outer wheel of the leading wheelset guides.
        self.assertEqual(left.argmax(), 0)


if __name__ == "__main__":
    unittest.main()
