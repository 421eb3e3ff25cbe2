"""A system structure (SSP) of the wheelset and a mass unit of the tests: it is valid, loads, and the wheelset comes to rest under its load.

The mass is compiled with `cc`. WHEELRAIL_WHEELSET names the archive."""

import os
import subprocess
import tempfile
import unittest
import zipfile
from pathlib import Path

import fmpy
import fmpy.ssp
from fmpy.ssp.simulation import simulate_ssp
from lxml import etree

PARTS = Path(__file__).with_name("structure")
STEP = 1e-5
LOAD = 160e3


def mass(folder):
    """The archive of the mass unit."""
    library = folder / "Mass.so"
    subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", library, PARTS / "mass.c"], check=True)
    archive = folder / "Mass.fmu"
    with zipfile.ZipFile(archive, "w") as units:
        units.write(PARTS / "mass.xml", "modelDescription.xml")
        units.write(library, f"binaries/{fmpy.platform}/Mass.so")
    return archive


def structure(folder):
    """The archive of the system."""
    archive = folder / "wheelset.ssp"
    with zipfile.ZipFile(archive, "w") as parts:
        parts.write(PARTS / "SystemStructure.ssd", "SystemStructure.ssd")
        parts.write(os.environ["WHEELRAIL_WHEELSET"], "resources/WheelSet.fmu")
        parts.write(mass(folder), "resources/Mass.fmu")
    return archive


class Structure(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.archive = structure(Path(self.folder.name))

    def tearDown(self):
        self.folder.cleanup()

    def test_it_follows_the_schema_of_the_standard(self):
        schema = Path(fmpy.ssp.__file__).with_name("schema") / "SystemStructureDescription.xsd"
        schema = etree.XMLSchema(etree.parse(str(schema)))
        schema.assertValid(etree.parse(str(PARTS / "SystemStructure.ssd")))

    def test_the_wheelset_comes_to_rest_under_its_load(self):
        result = simulate_ssp(str(self.archive), stop_time=0.05, step_size=STEP)
        (name,) = (name for name in result.dtype.names if name.endswith("wheelset.force.z"))
        force = -result[name]
        # FMPy sets all connectors to zero before the first step: there the force is not that of the start values.
        self.assertLess(abs(force[-1] - LOAD), 0.01 * LOAD)
        self.assertLess(max(force[2:]), 2.0 * LOAD)


if __name__ == "__main__":
    unittest.main()
