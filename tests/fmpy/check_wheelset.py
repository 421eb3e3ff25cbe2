"""The wheelset unit in an importer: WHEELRAIL_WHEELSET names its archive, WHEELRAIL_FMU that of the wheel."""

import math
import os
import unittest
import zipfile

import fmpy
import numpy as np
from fmpy.validation import validate_fmu

from unit import Unit

ARCHIVE = os.environ["WHEELRAIL_WHEELSET"]
WHEEL = os.environ["WHEELRAIL_FMU"]
MOVED = {
    "wheelset.z": -0.4597,
    "wheelset.y": 0.001,
    "wheelset.yaw": 2e-3,
    "wheelset.roll": 5e-5,
    "wheelset.vx": 20.0,
    "wheelset.vy": 0.02,
    "wheelset.yaw_rate": 0.03,
    "wheelset.pitch_rate": -43.4,
}


class Description(unittest.TestCase):
    def setUp(self):
        self.model = fmpy.read_model_description(ARCHIVE)

    def test_fmpy_finds_nothing_to_complain_about(self):
        self.assertEqual(validate_fmu(ARCHIVE), [])

    def test_it_has_a_name_and_an_identity_of_its_own(self):
        wheel = fmpy.read_model_description(WHEEL)
        self.assertNotEqual(self.model.guid, wheel.guid)
        self.assertEqual(self.model.coSimulation.modelIdentifier, "WheelSet")
        self.assertEqual(self.model.modelExchange.modelIdentifier, "WheelSet")
        with zipfile.ZipFile(ARCHIVE) as archive:
            libraries = [n for n in archive.namelist() if n.startswith("binaries/")]
        self.assertTrue(libraries)
        for library in libraries:
            self.assertTrue(os.path.basename(library).startswith("WheelSet."), library)

    def test_it_claims_what_the_wheel_claims(self):
        wheel = fmpy.read_model_description(WHEEL)
        for ours, theirs in (
            (self.model.coSimulation, wheel.coSimulation),
            (self.model.modelExchange, wheel.modelExchange),
        ):
            claims = [c for c in dir(theirs) if c.startswith(("can", "provides", "needs", "complete"))]
            self.assertGreater(len(claims), 5)
            for claim in claims:
                self.assertEqual(getattr(ours, claim), getattr(theirs, claim), claim)

    def test_start_values_lie_within_their_limits_and_everything_is_described(self):
        for v in self.model.modelVariables:
            self.assertTrue(v.description, v.name)
            low = float(v.min) if v.min is not None else -math.inf
            high = float(v.max) if v.max is not None else math.inf
            if v.type in ("Real", "Integer") and v.start is not None:
                self.assertTrue(low <= float(v.start) <= high, v.name)


class Mechanics(unittest.TestCase):
    def wheelset(self):
        unit = Unit(ARCHIVE, name="wheelset")
        self.addCleanup(unit.close)
        return unit.ready()

    def test_its_sides_are_two_wheel_units_on_one_axle(self):
        wheelset = self.wheelset()
        wheelset.set(MOVED)
        wheelset.step(0.0, 1e-4)
        roll, yaw = MOVED["wheelset.roll"], MOVED["wheelset.yaw"]
        axle = np.array(
            [-math.sin(yaw), math.cos(roll) * math.cos(yaw), math.sin(roll) * math.cos(yaw)]
        )
        turning = MOVED["wheelset.yaw_rate"] * np.array([0.0, -math.sin(roll), math.cos(roll)])
        centre = np.array([0.0, MOVED["wheelset.y"], MOVED["wheelset.z"]])
        velocity = np.array([MOVED["wheelset.vx"], MOVED["wheelset.vy"], 0.0])
        force, moment = np.zeros(3), np.zeros(3)
        for number, (side, sign) in enumerate((("right", 1), ("left", -1)), start=1):
            wheel = Unit(WHEEL, {"side": number, "wheel.y": 0.75 * sign}, side)
            self.addCleanup(wheel.close)
            arm = 0.75 * sign * axle
            place, speed = centre + arm, velocity + np.cross(turning, arm)
            wheel.ready().set(
                {
                    **{f"wheel.{c}": place[i] for i, c in enumerate("xyz")},
                    **{f"wheel.v{c}": speed[i] for i, c in enumerate("xyz")},
                    "wheel.roll": roll,
                    "wheel.yaw": yaw,
                    "wheel.yaw_rate": MOVED["wheelset.yaw_rate"],
                    "wheel.pitch_rate": MOVED["wheelset.pitch_rate"],
                }
            )
            own = [np.array([wheel.get(f"wheel.{q}.{c}") for c in "xyz"]) for q in ("force", "moment")]
            self.assertLess(own[0][2], -1e4)
            for quantity, wanted in zip(("force", "moment"), own):
                got = [wheelset.get(f"{side}.wheel.{quantity}.{c}") for c in "xyz"]
                np.testing.assert_allclose(got, wanted, rtol=0, atol=1e-11 * abs(own[0][2]))
            force += own[0]
            moment += own[1] + np.cross(arm, own[0])
        for quantity, wanted in (("force", force), ("moment", moment)):
            got = [wheelset.get(f"wheelset.{quantity}.{c}") for c in "xyz"]
            np.testing.assert_allclose(got, wanted, rtol=0, atol=1e-11 * abs(force[2]))

    def test_it_runs_in_both_kinds_of_simulation(self):
        signals = np.array(
            [(0.0, 0.0), (0.02, 0.004)], dtype=[("time", float), ("wheelset.y", float)]
        )
        start = {k: v for k, v in MOVED.items() if k != "wheelset.y"}
        start["left.wheel.profile"] = "S1002"
        start["normal.model"] = 2

        def run(fmi_type, stop_time):
            return fmpy.simulate_fmu(
                ARCHIVE,
                fmi_type=fmi_type,
                solver="CVode",
                stop_time=stop_time,
                step_size=1e-3,
                output_interval=1e-3,
                start_values=start,
                input=signals,
                output=["wheelset.y", "wheelset.force.z", "left.patch_count", "nominal.wheelset_z"],
            )

        exchanged, stepped = run("ModelExchange", 0.01), run("CoSimulation", 0.012)
        self.assertTrue(np.all(stepped["wheelset.force.z"] < -1e4))
        self.assertTrue(np.all(stepped["left.patch_count"] > 0))
        wanted = np.interp(exchanged["wheelset.y"], stepped["wheelset.y"], stepped["wheelset.force.z"])
        np.testing.assert_allclose(exchanged["wheelset.force.z"], wanted, rtol=1e-3)
        self.assertEqual(run("CoSimulation", 0.012).tobytes(), stepped.tobytes())

    def test_steps_taken_back_are_repeated_bit_for_bit(self):
        unit = self.wheelset()
        unit.set(MOVED)
        state = unit.slave.getFMUstate()
        seen = []
        for _ in range(2):
            for i in range(5):
                unit.set({"wheelset.y": 1e-4 * i})
                unit.step(1e-3 * i, 1e-3)
            seen.append(unit.outputs())
            unit.slave.setFMUstate(state)
        self.assertEqual(*seen)
        other = Unit(WHEEL)
        self.addCleanup(other.close)
        with self.assertRaises(Exception):
            other.slave.deSerializeFMUstate(unit.slave.serializeFMUstate(state))
        self.assertIn("is of WheelSet, this unit is WheelRail", other.last())


if __name__ == "__main__":
    unittest.main()
