"""Units that `wheelrail pack` (WHEELRAIL_PROGRAM) makes of those named by WHEELRAIL_FMU and WHEELRAIL_WHEELSET, in an importer."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import fmpy
import numpy as np
from fmpy.validation import validate_fmu

PROGRAM = os.environ["WHEELRAIL_PROGRAM"]
SOURCES = [os.environ["WHEELRAIL_FMU"], os.environ["WHEELRAIL_WHEELSET"]]
SOURCES += [source.replace(".fmu", "3.fmu") for source in SOURCES]
WORN = pathlib.Path(__file__).parents[2] / "fmu/resources/profiles/S1002_worn.txt"


class Packed(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="mailed ")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.profile = pathlib.Path(shutil.copy(WORN, self.folder / "own.txt"))

    def pack(self, source, *options):
        target = str(self.folder / f"Own{pathlib.Path(source).name}")
        subprocess.run([PROGRAM, "pack", "--source", source, "-o", target, *options], check=True, capture_output=True)
        return target

    def test_a_unit_brings_its_profile_and_values_along(self):
        for source in SOURCES:
            is_set = "WheelSet" in source
            y, force = ("wheelset.y", "wheelset.force.y") if is_set else ("wheel.y", "wheel.force.y")
            place = 0.002 if is_set else 0.752
            sides = ["right.", "left."] if is_set else [""]
            given = {y: place} | {f"{side}wheel.profile": str(self.profile) for side in sides}
            wanted = fmpy.simulate_fmu(source, start_values=given, stop_time=1e-3, output=[force])
            packed = self.pack(source, "--wheel", str(self.profile), "--set", f"{y}={place}", "--description", "My own")
            self.assertEqual(validate_fmu(packed), [])
            description = fmpy.read_model_description(packed)
            self.assertEqual((description.modelName, description.description), (pathlib.Path(packed).stem, "My own"))
            starts = {v.name: v.start for v in description.modelVariables}
            self.assertEqual([starts[f"{side}wheel.profile"] for side in sides], ["own.txt"] * len(sides))
            self.assertEqual(float(starts[y]), place)
            hidden = self.profile.rename(self.folder / "hidden")
            found = fmpy.simulate_fmu(packed, stop_time=1e-3, output=[force])
            hidden.rename(self.profile)
            np.testing.assert_array_equal(found[force], wanted[force])
            self.assertNotEqual(found[force][0], fmpy.simulate_fmu(source, stop_time=1e-3, output=[force])[force][0])

    def test_with_a_dummy_state_integrators_have_something_to_integrate(self):
        for source in SOURCES:
            is_set = "WheelSet" in source
            body = "wheelset" if is_set else "wheel"
            height = fmpy.read_model_description(source)
            height = float(next(v for v in height.modelVariables if v.name == f"{body}.z").start)
            # Lifted off and put down again: an event each.
            places = [(0.0, height), (0.01, height - 2e-4), (0.02, height)]
            signals = np.array(places, dtype=[("time", float), (f"{body}.z", float)])
            wanted = [f"{body}.force.z", "patch_count"]
            packed = self.pack(source, "--dummy-state")
            self.assertEqual(validate_fmu(packed), [])
            description = fmpy.read_model_description(packed)
            self.assertEqual(description.numberOfContinuousStates, 1)
            if description.fmiVersion == "3.0":
                wanted.append("event_indicator")

            def run(unit, kind, **more):
                return fmpy.simulate_fmu(
                    unit, fmi_type=kind, stop_time=0.02, output_interval=1e-3, input=signals, **more
                )

            with_state = run(packed, "ModelExchange", solver="CVode", output=wanted + ["dummy_state", "der(dummy_state)"])
            without = run(source, "ModelExchange", solver="Euler", output=wanted)
            self.assertTrue(np.all(with_state["dummy_state"] == 0) and np.all(with_state["der(dummy_state)"] == 0))
            for time, count in ((0.0, 2 if is_set else 1), (0.01, 0), (0.02, 2 if is_set else 1)):
                rows = [run["time"] == run["time"][np.argmin(abs(run["time"] - time))] for run in (with_state, without)]
                forces = [run[wanted[0]][row][-1] for run, row in zip((with_state, without), rows)]
                self.assertEqual(forces[0], forces[1])
                self.assertEqual(with_state["patch_count"][rows[0]][-1], count)
            stepped = run(packed, "CoSimulation", output=wanted[:1])
            np.testing.assert_array_equal(stepped[wanted[0]], run(source, "CoSimulation", output=wanted[:1])[wanted[0]])


if __name__ == "__main__":
    unittest.main()
