"""The units of FMI 3.0 in an importer: WHEELRAIL_FMU and WHEELRAIL_WHEELSET name the archives of FMI 2.0 beside which they lie."""

import ctypes
import math
import os
import pathlib
import re
import shutil
import unittest
import zipfile

import fmpy
import numpy as np
from fmpy.fmi1 import FMICallException
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu
from lxml import etree

OLD = {"WheelRail": os.environ["WHEELRAIL_FMU"], "WheelSet": os.environ["WHEELRAIL_WHEELSET"]}
NEW = {name: archive.replace(".fmu", "3.fmu") for name, archive in OLD.items()}
PACKAGE = pathlib.Path(fmpy.__file__).parent
BODY = {"WheelRail": ("wheel", 0.75), "WheelSet": ("wheelset", 0.0)}


def described(archives):
    return {name: fmpy.read_model_description(archive) for name, archive in archives.items()}


def element(name):
    """Array and place of an element of an array, as FMI 2.0 names it; a name by itself for all else."""
    found = re.fullmatch(r"(.*patch)\[(\d)\](.*)", name)
    return (found[1] + found[3], int(found[2]) - 1) if found else (name, None)


class Description(unittest.TestCase):
    def test_fmpy_finds_nothing_to_complain_about(self):
        for archive in NEW.values():
            self.assertEqual(validate_fmu(archive), [])

    def test_both_files_are_valid_by_the_schemas_of_the_standard(self):
        for archive in NEW.values():
            with zipfile.ZipFile(archive) as unit:
                for schema, file in (
                    ("fmi3ModelDescription.xsd", "modelDescription.xml"),
                    ("fmi3TerminalsAndIcons.xsd", "terminalsAndIcons/terminalsAndIcons.xml"),
                ):
                    schema = etree.XMLSchema(file=str(PACKAGE / "schema" / "fmi3" / schema))
                    schema.assertValid(etree.fromstring(unit.read(file)))

    def test_all_functions_of_the_standard_are_exported(self):
        header = (PACKAGE / "c-code" / "fmi3FunctionTypes.h").read_text(encoding="utf-8")
        names = re.findall(r"(fmi3\w+)TYPE", header)
        self.assertGreater(len(names), 70)
        for archive in NEW.values():
            folder = fmpy.extract(archive)
            self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
            [path] = pathlib.Path(folder, "binaries", fmpy.platform_tuple).iterdir()
            library = ctypes.cdll.LoadLibrary(str(path))
            self.assertEqual([n for n in names if not hasattr(library, n)], [])

    def test_only_what_the_library_can_do_is_claimed(self):
        states = {"canGetAndSetFMUState": "true", "canSerializeFMUState": "true"}
        for name, archive in NEW.items():
            # FMPy does not read all flags.
            with zipfile.ZipFile(archive) as unit:
                root = etree.fromstring(unit.read("modelDescription.xml"))
            derivatives = ("providesDirectionalDerivatives", "providesAdjointDerivatives")
            claims = {"modelIdentifier": name, **states, **dict.fromkeys(derivatives, "true")}
            self.assertEqual(dict(root.find("ModelExchange").attrib), claims)
            claims["canHandleVariableCommunicationStepSize"] = "true"
            self.assertEqual(dict(root.find("CoSimulation").attrib), claims)
            self.assertIsNone(root.find("ScheduledExecution"))
            model = fmpy.read_model_description(archive)
            self.assertEqual((model.numberOfEventIndicators, model.numberOfContinuousStates), (1, 0))

    def test_variables_are_those_of_the_unit_of_fmi_2(self):
        types = {"Real": "Float64", "Integer": "Int32"}
        for name, model in described(NEW).items():
            old = fmpy.read_model_description(OLD[name])
            self.assertEqual(model.guid, old.guid)
            new = {v.name: v for v in model.modelVariables}
            wanted = set()
            for v in old.modelVariables:
                array, place = element(v.name)
                wanted.add(array)
                twin = new[array]
                self.assertEqual(twin.type, types.get(v.type, v.type), v.name)
                for quality in ("causality", "variability", "unit", "displayUnit", "min", "max", "nominal", "start"):
                    self.assertEqual(getattr(twin, quality), getattr(v, quality), f"{quality} of {v.name}")
                if place is None:
                    self.assertEqual(twin.valueReference, v.valueReference, v.name)
                    self.assertEqual(twin.description, v.description.replace("fmi2", "fmi3"))
                    self.assertFalse(twin.dimensions)
                else:
                    self.assertEqual([int(d.start) for d in twin.dimensions], [8], v.name)
                if place == 0:
                    self.assertEqual(twin.valueReference, v.valueReference, v.name)
            self.assertEqual(set(new) - wanted, {"time", "event_indicator"})
            text = zipfile.ZipFile(NEW[name]).read("modelDescription.xml").decode()
            self.assertNotIn("fmi2", text)

    def test_outputs_depend_on_what_they_depend_on_in_fmi_2(self):
        for name, model in described(NEW).items():
            old = fmpy.read_model_description(OLD[name])
            for ours, theirs in ((model.outputs, old.outputs), (model.initialUnknowns, old.initialUnknowns)):
                wanted = {}
                for unknown in theirs:
                    array, _ = element(unknown.variable.name)
                    wanted.setdefault(array, set()).update(d.name for d in unknown.dependencies)
                found = {u.variable.name: {d.name for d in u.dependencies} for u in ours}
                self.assertEqual(found, wanted)

    def test_terminals_connect_bodies(self):
        def bodies(element, prefix=""):
            for terminal in element.findall("Terminal"):
                name = prefix + terminal.get("name")
                members = terminal.findall("TerminalMemberVariable")
                yield name, {m.get("memberName"): m.get("variableName") for m in members}
                yield from bodies(terminal, name + ".")

        found = {}
        for name, archive in NEW.items():
            with zipfile.ZipFile(archive) as unit:
                root = etree.fromstring(unit.read("terminalsAndIcons/terminalsAndIcons.xml"))
            found[name] = dict(bodies(root.find("Terminals")))
            variables = {v.name for v in fmpy.read_model_description(archive).modelVariables}
            for body, members in found[name].items():
                for member, variable in members.items():
                    self.assertEqual(variable, f"{body}.{member}")
                    self.assertIn(variable, variables)
        self.assertEqual(set(found["WheelRail"]), {"wheel", "rail[1]", "rail[2]"})
        sides = {f"{side}{body}" for side in ("right", "left") for body in ("", ".wheel", ".rail[1]", ".rail[2]")}
        self.assertEqual(set(found["WheelSet"]), {"wheelset"} | sides)
        motion = {"x", "y", "z", "roll", "yaw", "pitch", "vx", "vy", "vz", "roll_rate", "yaw_rate", "pitch_rate"}
        forces = {f"{load}.{c}" for load in ("force", "moment") for c in "xyz"}
        self.assertEqual(set(found["WheelSet"]["wheelset"]), motion | forces)

    def test_the_archive_holds_what_it_should(self):
        for name, archive in NEW.items():
            with zipfile.ZipFile(archive) as unit:
                names = unit.namelist()
            self.assertEqual(names, sorted(names))
            libraries = [n for n in names if n.startswith("binaries/")]
            self.assertTrue(any(n.startswith(f"binaries/{fmpy.platform_tuple}/{name}.") for n in libraries))
            for file in ("terminalsAndIcons/icon.png", "documentation/index.html", "resources/profiles/S1002_worn.txt"):
                self.assertIn(file, names)
            self.assertNotIn("model.png", names)


class Simulation(unittest.TestCase):
    def run_both(self, name, outputs, **arguments):
        body, centre = BODY[name]
        times = np.linspace(0.0, 0.3, 301)
        signals = np.zeros(len(times), dtype=[("time", float)] + [(f"{body}.{c}", float) for c in "yz"])
        signals["time"] = times
        signals[f"{body}.y"] = centre + 6e-3 * np.sin(20.0 * times)
        signals[f"{body}.z"] = -0.4598 + 2e-4 * np.sin(70.0 * times)
        results = {}
        for version, archive in ((2, OLD[name]), (3, NEW[name])):
            wanted = outputs if version == 2 else list(dict.fromkeys(element(o)[0] for o in outputs))
            results[version] = fmpy.simulate_fmu(
                archive, stop_time=0.3, output_interval=1e-3, input=signals, output=wanted, **arguments
            )
        old, new = results[2], results[3]
        np.testing.assert_array_equal(old["time"], new["time"])
        for output in outputs:
            array, place = element(output)
            given = new[array] if place is None else new[array][:, place]
            self.assertEqual(np.ascontiguousarray(given).tobytes(), old[output].tobytes(), output)
        return new

    def outputs(self, name):
        model = fmpy.read_model_description(OLD[name])
        return [v.name for v in model.modelVariables if v.causality == "output" and v.type in ("Real", "Integer")]

    def test_a_wheel_gets_the_bits_of_fmi_2_in_co_simulation(self):
        start = {"side": 1, "normal.model": 2, "friction.coefficient": 0.25, "wheel.profile": "S1002"}
        result = self.run_both(
            "WheelRail", self.outputs("WheelRail"), fmi_type="CoSimulation", step_size=1e-3, start_values=start
        )
        self.assertLess(min(result["wheel.force.z"]), -1e5)
        self.assertEqual(result["patch.normal_force"].shape[1], 8)

    def test_a_wheelset_gets_the_bits_of_fmi_2_in_co_simulation(self):
        result = self.run_both("WheelSet", self.outputs("WheelSet"), fmi_type="CoSimulation", step_size=1e-3)
        self.assertLess(min(result["wheelset.force.z"]), -2e5)
        self.assertEqual(set(result["patch_count"]) & {0, 2}, {0, 2})

    def test_model_exchange_stops_at_the_same_events(self):
        outputs = ["wheel.force.y", "wheel.force.z", "patch_count", "patch[1].rail", "patch[1].max_pressure"]
        result = self.run_both(
            "WheelRail", outputs, fmi_type="ModelExchange", solver="CVode", record_events=True
        )
        changes = np.flatnonzero(np.diff(result["patch_count"]))
        self.assertGreater(len(changes), 3)
        np.testing.assert_array_equal(result["time"][changes], result["time"][changes + 1])


class Instances(unittest.TestCase):
    def setUp(self):
        self.messages = []
        archive = NEW["WheelRail"]
        model = fmpy.read_model_description(archive)
        self.references = {v.name: v.valueReference for v in model.modelVariables}
        folder = fmpy.extract(archive)
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        self.unit = FMU3Slave(
            guid=model.guid, unzipDirectory=folder, modelIdentifier="WheelRail", instanceName="wheel"
        )
        self.unit.instantiate(loggingOn=True, logMessage=self.log)
        self.addCleanup(self.unit.freeInstance)

    def log(self, environment, status, category, message):
        self.messages.append((status, category.decode(), message.decode()))

    def refused(self, call, words):
        with self.assertRaises(FMICallException) as caught:
            call()
        self.assertEqual(caught.exception.status, 3)
        status, category, message = self.messages[-1]
        self.assertEqual((status, category), (3, "logStatusError"))
        self.assertIn(words, message)

    def test_wrong_use_is_an_error_with_a_message(self):
        unit, r = self.unit, self.references
        self.refused(lambda: unit.doStep(0.0, 1e-3), "call fmi3EnterInitializationMode first")
        unit.enterInitializationMode()
        unit.exitInitializationMode()
        self.refused(lambda: unit.setFloat64([r["wheel.y"]], [math.nan]), "wheel.y = NaN is not admitted")
        self.refused(lambda: unit.setFloat64([r["track.gauge"]], [1.5]), "call fmi3Reset to change it")
        self.refused(lambda: unit.getFloat64([r["patch.area"]]), "nValues = 1, but the variables have 8 elements")
        self.refused(lambda: unit.setInt64([r["normal.model"]], [1]), "normal.model is fixed")
        self.assertEqual(unit.doStep(0.0, 1e-3), (False, False, False, 1e-3))

    def test_a_run_goes_on_from_bytes_bit_for_bit(self):
        unit, r = self.unit, self.references
        unit.enterInitializationMode()
        unit.exitInitializationMode()

        def run():
            forces = []
            for i in range(20):
                unit.setFloat64([r["wheel.y"], r["wheel.yaw"]], [0.75 + 2e-4 * i, 0.01])
                unit.doStep(1e-3 * i, 1e-3)
                forces.append(unit.getFloat64([r["wheel.force.y"], r["patch.position.y"]], 9))
            return np.array(forces).tobytes()

        written = unit.serializeFMUState(unit.getFMUState())
        first = run()
        unit.setFMUState(unit.deserializeFMUState(written))
        self.assertEqual(unit.getFloat64([r["time"]]), [0.0])
        self.assertEqual(run(), first)

    def test_derivatives_are_those_of_the_forces(self):
        unit, r = self.unit, self.references
        unit.enterInitializationMode()
        unit.exitInitializationMode()
        unknowns = [r["wheel.force.z"], r["patch.normal_force"]]
        found = unit.getDirectionalDerivative(unknowns, [r["wheel.z"]], [1.0], 9)
        step, forces = 1e-9, []
        for z in (-0.45975 - step, -0.45975 + step):
            unit.setFloat64([r["wheel.z"]], [z])
            forces.append(unit.getFloat64([r["wheel.force.z"], r["patch.normal_force"]], 9))
        slopes = (np.array(forces[1]) - forces[0]) / (2.0 * step)
        np.testing.assert_allclose(found, slopes, rtol=1e-4, atol=1e3)


if __name__ == "__main__":
    unittest.main()
