"""What an importer sees of the unit, whatever the mechanics say: WHEELRAIL_FMU names the archive."""

import math
import os
import shutil
import tempfile
import unittest
import zipfile

import fmpy
import numpy as np
from fmpy.fmi1 import FMICallException
from fmpy.validation import validate_fmu

from unit import Unit

ARCHIVE = os.environ["WHEELRAIL_FMU"]
MOVED = {"wheel.z": -0.4597, "wheel.y": 0.751, "wheel.vx": 20.0, "wheel.pitch_rate": -43.4}


class Description(unittest.TestCase):
    def setUp(self):
        self.model = fmpy.read_model_description(ARCHIVE)

    def test_fmpy_finds_nothing_to_complain_about(self):
        self.assertEqual(validate_fmu(ARCHIVE), [])

    def test_start_values_lie_within_their_limits(self):
        for v in self.model.modelVariables:
            low = float(v.min) if v.min is not None else -math.inf
            high = float(v.max) if v.max is not None else math.inf
            self.assertLessEqual(low, high, v.name)
            if v.type in ("Real", "Integer") and v.start is not None:
                self.assertTrue(low <= float(v.start) <= high, v.name)
            if v.type == "Enumeration" and v.start is not None:
                items = [item.value for item in v.declaredType.items]
                self.assertIn(v.start, [str(i) for i in items], v.name)
                self.assertEqual(len(items), len(set(items)), v.name)

    def test_only_capabilities_that_the_library_has_are_claimed(self):
        exchange = self.model.modelExchange
        self.assertTrue(exchange.canGetAndSetFMUstate)
        self.assertTrue(exchange.canSerializeFMUstate)
        self.assertTrue(exchange.providesDirectionalDerivative)
        self.assertFalse(exchange.needsExecutionTool)
        claims = self.model.coSimulation
        self.assertTrue(claims.canHandleVariableCommunicationStepSize)
        self.assertTrue(claims.canNotUseMemoryManagementFunctions)
        self.assertTrue(claims.canGetAndSetFMUstate)
        self.assertTrue(claims.canSerializeFMUstate)
        self.assertTrue(claims.providesDirectionalDerivative)
        self.assertTrue(claims.canInterpolateInputs)
        self.assertFalse(claims.maxOutputDerivativeOrder)
        self.assertFalse(claims.needsExecutionTool)
        self.assertFalse(claims.canBeInstantiatedOnlyOncePerProcess)

    def test_every_variable_says_what_it_is(self):
        for v in self.model.modelVariables:
            self.assertTrue(v.description, v.name)
        units = {v.name: v.unit for v in self.model.modelVariables}
        self.assertEqual(units["wheel.force.z"], "N")
        self.assertEqual(units["patch[8].creepage.spin"], "1/m")
        shown = {v.name: v.displayUnit for v in self.model.modelVariables}
        self.assertEqual([shown[n] for n in ("wheel.z", "wheel.yaw", "wheel.force.z")], ["mm", "deg", "kN"])
        self.assertEqual((shown["patch[1].max_pressure"], shown["wheel.x"]), ("MPa", None))
        sizes = {v.name: (v.quantity, float(v.nominal)) for v in self.model.modelVariables if v.nominal is not None}
        self.assertEqual(sizes["wheel.z"], ("Length", 1e-4))
        self.assertEqual(sizes["wheel.force.z"], ("Force", 1e5))
        self.assertEqual(sizes["patch[1].max_pressure"], ("Pressure", 1e9))
        # Display units that are there are those of their unit.
        for v in self.model.modelVariables:
            if v.displayUnit is not None:
                unit = next(u for u in self.model.unitDefinitions if u.name == v.unit)
                self.assertIn(v.displayUnit, [d.name for d in unit.displayUnits], v.name)

    def test_the_description_says_who_made_it_when_and_how_it_is_run(self):
        model = self.model
        self.assertEqual(model.author, "The wheelrail authors")
        self.assertIn("2026", model.copyright)
        self.assertRegex(model.generationDateAndTime, r"^\d{4}-\d\d-\d\dT00:00:00Z$")
        self.assertEqual(float(model.defaultExperiment.tolerance), 1e-4)

    def test_the_plain_description_is_the_same_unit(self):
        for archive, most in ((ARCHIVE, 300), (os.environ["WHEELRAIL_WHEELSET"], 560)):
            plain = archive.replace(".fmu", "Plain.fmu")
            self.assertEqual(validate_fmu(plain), [])
            full, short = (
                {v.name: v for v in fmpy.read_model_description(a).modelVariables} for a in (archive, plain)
            )
            self.assertLess(len(short), most)
            self.assertTrue(set(short) < set(full))
            for name, v in short.items():
                self.assertEqual(v.valueReference, full[name].valueReference)
                self.assertNotEqual(v.type, "Enumeration")
                if full[name].type == "Enumeration":
                    self.assertEqual((v.type, v.start), ("Integer", full[name].start))
                    for item in full[name].declaredType.items:
                        self.assertIn(f"{item.value} {item.name}", v.description)
            patches = {n.split("]")[0] for n in short if "patch[" in n}
            self.assertEqual(len(patches), 4 if archive == ARCHIVE else 8)
        left = {"side": 2, "wheel.y": -0.75, "normal.model": 1}
        outputs = ["wheel.force.y", "wheel.force.z", "patch[1].area"]
        runs = [
            fmpy.simulate_fmu(a, start_values=left, stop_time=0.01, output=outputs)
            for a in (ARCHIVE, ARCHIVE.replace(".fmu", "Plain.fmu"))
        ]
        self.assertEqual(runs[0].tobytes(), runs[1].tobytes())
        self.assertLess(runs[0]["wheel.force.z"][0], -5e4)

    def test_the_archive_holds_what_it_should(self):
        with zipfile.ZipFile(ARCHIVE) as archive:
            names = archive.namelist()
            dates = {entry.date_time for entry in archive.infolist()}
        self.assertEqual(names, sorted(names))
        self.assertEqual(dates, {(1980, 1, 1, 0, 0, 0)})
        for name in (
            "model.png",
            "modelDescription.xml",
            "documentation/index.html",
            "documentation/licenses/LICENSE-MIT",
            "resources/profiles/S1002_worn.txt",
        ):
            self.assertIn(name, names)


class Simulation(unittest.TestCase):
    def test_an_integrator_stops_where_a_contact_begins(self):
        low, high, end = -0.461, -0.4596, 0.1
        signals = np.array([(0.0, low), (end, high)], dtype=[("time", float), ("wheel.z", float)])
        result = fmpy.simulate_fmu(
            ARCHIVE,
            fmi_type="ModelExchange",
            solver="CVode",
            stop_time=end,
            output_interval=end / 10,
            input=signals,
            record_events=True,
            output=["patch_count", "nominal.wheel_z"],
        )
        # Before and after each event at one time, between two outputs; within a nanometre of first touch there may be several patches.
        changes = np.flatnonzero(np.diff(result["patch_count"]))
        np.testing.assert_array_equal(result["time"][changes], result["time"][changes + 1])
        touching = end * (result["nominal.wheel_z"][0] - low) / (high - low)
        self.assertLess(abs(result["time"][changes[0]] - touching), 1e-6)
        self.assertEqual((result["patch_count"][0], result["patch_count"][-1]), (0, 1))

    def test_inputs_from_a_table_arrive(self):
        signals = np.array(
            [(0.0, 0.75, 20.0), (0.01, 0.76, 20.0)],
            dtype=[("time", float), ("wheel.y", float), ("wheel.vx", float)],
        )
        result = fmpy.simulate_fmu(
            ARCHIVE,
            stop_time=0.01,
            step_size=1e-3,
            output_interval=1e-3,
            input=signals,
            start_values={"side": 1, "normal.model": 1, "wheel.profile": "S1002"},
            output=["wheel.y", "wheel.force.z", "patch_count", "nominal.wheel_z"],
        )
        self.assertEqual(len(result), 11)
        self.assertAlmostEqual(result["time"][-1], 0.01)
        # FMPy sets inputs at the start of a step and records at its end.
        self.assertTrue(np.all(np.diff(result["wheel.y"])[1:] > 0))
        self.assertAlmostEqual(result["wheel.y"][-1], 0.759)
        for name in result.dtype.names:
            self.assertTrue(np.all(np.isfinite(result[name])), name)

    def test_model_exchange_with_cvode_gives_the_forces_of_co_simulation(self):
        signals = np.array(
            [(0.0, 0.75, 20.0), (0.01, 0.754, 20.0), (0.02, 0.758, 20.0)],
            dtype=[("time", float), ("wheel.y", float), ("wheel.vx", float)],
        )

        def run(fmi_type, stop_time):
            return fmpy.simulate_fmu(
                ARCHIVE,
                fmi_type=fmi_type,
                solver="CVode",
                stop_time=stop_time,
                step_size=1e-3,
                output_interval=1e-3,
                start_values=MOVED,
                input=signals,
                output=["wheel.y", "wheel.force.y", "wheel.force.z"],
            )

        exchanged, stepped = run("ModelExchange", 0.01), run("CoSimulation", 0.012)
        self.assertTrue(np.all(exchanged["wheel.force.z"] < 0.0))
        # In co-simulation inputs are those of the start of a step; the forces belong to the inputs.
        wanted = np.interp(exchanged["wheel.y"], stepped["wheel.y"], stepped["wheel.force.z"])
        np.testing.assert_allclose(exchanged["wheel.force.z"], wanted, rtol=1e-3)

    def test_a_repeated_run_gives_the_same_bits(self):
        def run():
            return fmpy.simulate_fmu(
                ARCHIVE,
                stop_time=0.01,
                start_values=MOVED,
                output=["wheel.force.y", "wheel.force.z", "patch[1].position.y"],
            )

        self.assertTrue(np.all(run()["wheel.force.z"] < 0.0))
        self.assertEqual(run().tobytes(), run().tobytes())


class Instances(unittest.TestCase):
    def unit(self, start=None, name="wheel"):
        unit = Unit(ARCHIVE, start, name)
        self.addCleanup(unit.close)
        return unit

    def refused(self, call):
        with self.assertRaises(FMICallException) as caught:
            call()
        self.assertEqual(caught.exception.status, 3)

    def run_steps(self, unit, sideways):
        seen = []
        unit.set(MOVED)
        for i in range(20):
            unit.set({"wheel.y": 0.75 + sideways * i})
            unit.step(1e-3 * i, 1e-3)
            seen.append(np.array(unit.outputs()).tobytes())
        return seen

    def test_instances_do_not_mix(self):
        alone = [self.run_steps(self.unit().ready(), s) for s in (1e-4, -1e-4)]
        first, second = self.unit(name="first").ready(), self.unit(name="second").ready()
        first.set(MOVED)
        second.set(MOVED)
        together = [[], []]
        for i in range(20):
            for unit, sideways, seen in zip((first, second), (1e-4, -1e-4), together):
                unit.set({"wheel.y": 0.75 + sideways * i})
                unit.step(1e-3 * i, 1e-3)
                seen.append(np.array(unit.outputs()).tobytes())
        self.assertEqual(together, alone)

    def test_reset_and_repeat_gives_the_same_bits(self):
        unit = self.unit().ready()
        first = self.run_steps(unit, 2e-4)
        unit.slave.reset()
        unit.start({})
        unit.ready()
        self.assertEqual(unit.get("wheel.z"), -0.45975)
        self.assertEqual(self.run_steps(unit, 2e-4), first)

    def test_steps_taken_back_are_repeated_bit_for_bit(self):
        unit = self.unit().ready()
        self.run_steps(unit, 1e-4)
        state = unit.slave.getFMUstate()
        first = self.run_steps(unit, 2e-4)
        unit.slave.setFMUstate(state)
        self.assertEqual(unit.get("wheel.y"), 0.75 + 1e-4 * 19)
        self.assertEqual(self.run_steps(unit, 2e-4), first)
        written = unit.slave.serializeFMUstate(state)
        unit.slave.freeFMUstate(state)
        other = self.unit(name="other").ready()
        other.slave.setFMUstate(other.slave.deSerializeFMUstate(written))
        self.assertEqual(self.run_steps(other, 2e-4), first)

    def test_wrong_use_is_an_error_with_a_message(self):
        unit = self.unit(name="front left")
        self.refused(lambda: unit.step(0.0, 1e-3))
        self.assertIn("call fmi2ExitInitializationMode first", unit.last())
        unit.ready()
        for values, words in (
            ({"wheel.y": math.nan}, "wheel.y = NaN is not admitted"),
            ({"friction.coefficient": -0.1}, "friction.coefficient = -0.1"),
            ({"wheel.force.z": 1.0}, "cannot be set"),
            ({"track.gauge": 1.5}, "track.gauge is fixed after initialization"),
        ):
            self.refused(lambda values=values: unit.set(values))
            self.assertIn(words, unit.last())
        self.refused(lambda: unit.step(0.0, -1e-3))
        self.assertIn("communicationStepSize = -0.001", unit.last())
        self.refused(lambda: unit.slave.getReal([99999]))
        self.assertIn("value reference 99999 does not exist", unit.last())
        name, status, category, _ = unit.messages[-1]
        self.assertEqual((name, status, category), ("front left", 3, "logStatusError"))
        self.assertEqual(unit.get("wheel.y"), 0.75)
        unit.step(0.0, 1e-3)

    def test_a_unit_in_a_folder_with_spaces_and_umlauts_works(self):
        with tempfile.TemporaryDirectory(prefix="wheel räil ") as folder:
            copy = shutil.copy(ARCHIVE, folder)
            result = fmpy.simulate_fmu(copy, stop_time=1e-3, output=["wheel.force.z"])
            self.assertTrue(np.all(np.isfinite(result["wheel.force.z"])))


if __name__ == "__main__":
    unittest.main()
