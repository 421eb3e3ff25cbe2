"""The bogie and the climbing flange of the examples with the packed wheelset: WHEELRAIL_WHEELSET names its archive."""

import importlib.util
import os
import unittest
from pathlib import Path



def example(name):
    specification = importlib.util.spec_from_file_location(name, Path(__file__).parents[2] / "examples" / f"{name}.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


bogie = example("cooperrider_bogie")
climb = example("flange_climb")

LINEAR = {"normal.model": "hertz", "tangential.model": "linear", "creepage.model": "flat"}


class Bogie(unittest.TestCase):
    def unit(self, **models):
        unit = bogie.Unit(os.environ["WHEELRAIL_WHEELSET"], **models)
        self.addCleanup(unit.close)
        return unit

    def test_with_the_published_law_it_hunts_from_the_published_speed_on(self):
        speed, _ = bogie.critical_speed(bogie.published_contact)
        self.assertLess(abs(speed / bogie.PUBLISHED - 1), 0.01)

    def test_the_unit_has_the_ellipse_of_the_published_one(self):
        unit = self.unit(**LINEAR)
        unit.contact(60.0)
        for name, axis in zip(("length", "width"), bogie.ELLIPSE):
            self.assertLess(abs(0.5 * unit.get(f"right.patch[1].{name}") / axis - 1), 0.005, name)

    def test_what_a_yawed_wheelset_gets_is_what_one_gets_that_drifts(self):
        speed = 60.0
        by_place, by_rate = self.unit(**LINEAR).contact(speed)
        # Lateral creepage is vy/v - yaw; the yawed axle steers by its weight too.
        self.assertLess(abs(by_place[0, 1] / (-speed * by_rate[0, 0]) - 1), 0.02)
        # A cone steers towards the middle.
        self.assertLess(by_place[1, 0], 0)

    def test_it_hunts_on_the_unit_as_well(self):
        for models in (LINEAR, {}):
            unit = self.unit(**models)
            speed, frequency = bogie.critical_speed(unit.contact)
            self.assertLess(bogie.growth(unit.contact, 0.9 * speed)[0], 0)
            self.assertGreater(bogie.growth(unit.contact, 1.1 * speed)[0], 0)
            self.assertGreater(frequency, 1.0)
            # Kalker's slopes are within some 15 % of Vermeulen and Johnson's; the speed goes with their root.
            self.assertLess(abs(speed / bogie.PUBLISHED - 1), 0.15)


class FlangeClimb(unittest.TestCase):
    def test_a_free_wheel_at_a_large_angle_of_attack_climbs_at_nadals_limit(self):
        unit = climb.Unit(os.environ["WHEELRAIL_WHEELSET"])
        self.addCleanup(unit.close)
        friction = 0.3
        free, angle = climb.limit(unit, 0.02, friction, True)
        solid, _ = climb.limit(unit, 0.02, friction, False)
        straight, _ = climb.limit(unit, 0.0, friction, True)
        # Nothing but friction across is left; what else is there holds more.
        self.assertLess(abs(free / climb.nadal(angle, friction) - 1), 0.005)
        self.assertGreater(solid, free)
        self.assertGreater(straight, free)


if __name__ == "__main__":
    unittest.main()
