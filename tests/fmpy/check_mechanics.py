"""What the unit says about a wheel on a rail, through FMPy: WHEELRAIL_FMU names the archive."""

import os
import unittest

from fmpy.fmi1 import FMICallException

from unit import Unit

ARCHIVE = os.environ["WHEELRAIL_FMU"]
RADIUS = 0.46
SPEED = 20.0


class Wheel(unittest.TestCase):
    def unit(self, start=None):
        unit = Unit(ARCHIVE, start)
        self.addCleanup(unit.close)
        return unit

    def pressed(self, start=None, inputs=None):
        """A rolling wheel pressed 0.1 mm below the height at which it just touches."""
        unit = self.unit(start)
        z = unit.get("nominal.wheel_z") + 1e-4
        unit.set({"wheel.z": z, "wheel.vx": SPEED, "wheel.pitch_rate": -SPEED / RADIUS})
        unit.set(inputs or {})
        return unit.ready()

    def test_the_nominal_height_is_where_contact_begins(self):
        unit = self.unit()
        z = unit.get("nominal.wheel_z")
        self.assertAlmostEqual(z, -RADIUS, delta=1e-3)
        unit.ready()
        unit.set({"wheel.z": z - 1e-6})
        self.assertEqual((unit.get("patch_count"), unit.get("wheel.force.z")), (0, 0.0))
        unit.set({"wheel.z": z + 1e-6})
        self.assertEqual(unit.get("patch_count"), 1)
        self.assertLess(unit.get("wheel.force.z"), 0.0)

    def test_a_wheel_pressed_by_a_tenth_of_a_millimetre_carries_a_wheel_load(self):
        unit = self.pressed()
        self.assertTrue(3e4 < -unit.get("wheel.force.z") < 2e5, unit.get("wheel.force.z"))
        self.assertAlmostEqual(unit.get("rail[1].force.z"), -unit.get("wheel.force.z"), delta=1e-6)
        self.assertAlmostEqual(unit.get("patch[1].penetration"), 1e-4, delta=2e-6)
        self.assertTrue(0.005 < unit.get("patch[1].length") < 0.03)

    def test_left_and_right_are_mirror_images(self):
        motion = {"wheel.yaw": 3e-3, "wheel.roll": 1e-3, "wheel.vy": 0.05, "rail[1].y": 5e-4}
        mirrored = {name: -value for name, value in motion.items()}
        right = self.pressed({"wheel.y": 0.752}, motion)
        left = self.pressed({"side": 2, "wheel.y": -0.752}, mirrored)
        self.assertEqual(right.get("patch_count"), left.get("patch_count"))
        signs = {
            "wheel.force.x": 1, "wheel.force.y": -1, "wheel.force.z": 1,
            "wheel.moment.x": -1, "wheel.moment.y": 1, "wheel.moment.z": -1,
            "rail[1].force.y": -1, "rail[1].moment.x": -1,
            "patch[1].position.y": -1, "patch[1].contact_angle": -1, "patch[1].normal_force": 1,
            "patch[1].creepage.longitudinal": 1, "patch[1].creepage.lateral": -1,
            "patch[1].creepage.spin": -1, "patch[1].spin_moment": -1,
        }  # fmt: skip
        for name, sign in signs.items():
            self.assertAlmostEqual(
                right.get(name), sign * left.get(name), delta=1e-9 * (1 + abs(right.get(name))), msg=name
            )

    def test_a_braked_wheel_is_pulled_back_within_the_friction_limit(self):
        braked = self.pressed(inputs={"wheel.pitch_rate": -0.98 * SPEED / RADIUS})
        driven = self.pressed(inputs={"wheel.pitch_rate": -1.02 * SPEED / RADIUS})
        self.assertGreater(braked.get("patch[1].creepage.longitudinal"), 0.0)
        self.assertLess(braked.get("wheel.force.x"), 0.0)
        self.assertGreater(driven.get("wheel.force.x"), 0.0)
        limit = 0.3 * braked.get("patch[1].normal_force")
        # Friction acts along the track on pressures that point to both sides: those of a patch whose
        # normals turn by 40 mrad add up to 1e-3 more than the normal force at most.
        self.assertLessEqual(-braked.get("wheel.force.x"), limit * (1 + 1e-3))
        self.assertGreater(braked.get("frictional_power"), 0.0)

    def test_directional_derivatives_are_those_of_differences(self):
        unit = self.pressed(inputs={"wheel.yaw": 2e-3, "wheel.vy": 0.02})
        outputs = ["wheel.force.y", "wheel.force.z", "wheel.moment.x", "rail[1].force.y"]
        for name, step in {"wheel.z": 1e-8, "wheel.y": 1e-7, "wheel.vy": 1e-6}.items():
            at = unit.get(name)
            sides = []
            for shift in (-step, step):
                unit.set({name: at + shift})
                sides.append([unit.get(output) for output in outputs])
            unit.set({name: at})
            found = unit.slave.getDirectionalDerivative(
                [unit.variables[output].valueReference for output in outputs],
                [unit.variables[name].valueReference],
                [1.0],
            )
            scale = max(abs(rate) for rate in found)
            self.assertGreater(scale, 0.0)
            for output, rate, before, after in zip(outputs, found, *sides):
                difference = (after - before) / (2.0 * step)
                self.assertAlmostEqual(rate, difference, delta=1e-5 * scale, msg=f"{output} by {name}")

    def test_a_step_changes_nothing_that_inputs_do_not(self):
        unit = self.pressed()
        before = unit.outputs()
        unit.step(0.0, 1e-3)
        self.assertEqual(unit.outputs(), before)


class Profiles(unittest.TestCase):
    def unit(self, start):
        unit = Unit(ARCHIVE, start)
        self.addCleanup(unit.close)
        return unit

    def test_a_wrong_profile_path_is_refused_by_name(self):
        unit = self.unit({"wheel.profile": "no_such_wheel.prw"})
        with self.assertRaises(FMICallException) as caught:
            unit.ready()
        self.assertEqual(caught.exception.status, 3)
        self.assertIn("wheel.profile", unit.last())
        self.assertIn("no_such_wheel.prw", unit.last())
        # What was refused can be put right.
        unit.set({"wheel.profile": "S1002"})
        unit.ready()

    def test_a_relative_name_is_found_in_the_resources(self):
        worn = self.unit({"wheel.profile": "S1002_worn.txt"})
        new = self.unit({"wheel.profile": "S1002"})
        self.assertNotEqual(worn.get("nominal.wheel_z"), new.get("nominal.wheel_z"))
        self.assertAlmostEqual(worn.get("nominal.wheel_z"), new.get("nominal.wheel_z"), delta=1e-3)
        worn.ready()


if __name__ == "__main__":
    unittest.main()
