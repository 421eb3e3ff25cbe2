"""What the clients beside have in common: positions in, forces out.

Each client takes three arguments, the archive, the table of positions and the file for its answers, one
row of outputs for each row of inputs. Numbers are written with all their digits.
"""

import csv
import sys
import zipfile
from xml.etree import ElementTree

OUTPUTS = (
    "wheel.force.x", "wheel.force.y", "wheel.force.z", "wheel.moment.x", "wheel.moment.y",
    "wheel.moment.z", "rail[1].force.y", "patch[1].max_pressure", "patch[1].creepage.spin", "wear_number",
)  # fmt: skip
STEP = 1e-3


def arguments():
    """Archive, names of the inputs, rows of their values, file for the answers."""
    archive, positions, answers = sys.argv[1:]
    with open(positions, newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(line for line in file if not line.startswith("#"))
    return archive, names, [[float(value) for value in row] for row in rows], answers


def references(archive):
    """Value references by name, for clients that do not hand them out."""
    with zipfile.ZipFile(archive) as unit:
        root = ElementTree.fromstring(unit.read("modelDescription.xml"))
    variables = root.find("ModelVariables")
    return {v.get("name"): int(v.get("valueReference")) for v in variables}


def write(answers, rows):
    with open(answers, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(OUTPUTS)
        writer.writerows([repr(float(value)) for value in row] for row in rows)
