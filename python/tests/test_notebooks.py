"""Notebooks run from top to bottom, and figures are drawn."""

import os
import re
from pathlib import Path

import numpy as np
import pytest
import wheelrail

NOTEBOOKS = sorted((Path(__file__).parent.parent / "notebooks").glob("*.ipynb"))


def without_place(text):
    """Warnings without the file in which the cell stood when it ran."""
    return re.sub(r"^\S*ipykernel\S*:\d+: ", "", text, flags=re.MULTILINE)


def texts(notebook):
    """What the cells show in words and numbers; times are those of the machine."""
    shown = []
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            shown.append(output.get("text") or output.get("data", {}).get("text/plain", ""))
    return without_place("\n".join(shown))


def kinds(notebook):
    """What kinds of output each cell has."""
    return [
        sorted({kind for output in cell.get("outputs", []) for kind in output.get("data", {"text": ""})})
        for cell in notebook.cells
    ]


@pytest.mark.long
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_shows_what_it_gives(path, tmp_path):
    """Run anew it shows the outputs that it is kept with; UPDATE_DOCS=1 keeps the new ones."""
    nbformat = pytest.importorskip("nbformat")
    client = pytest.importorskip("nbclient").NotebookClient
    kept, notebook = (nbformat.read(path, as_version=4) for _ in range(2))
    client(notebook, timeout=900, resources={"metadata": {"path": str(tmp_path)}}).execute()
    if os.environ.get("UPDATE_DOCS"):
        for cell in notebook.cells:
            # When a cell ran is of no use to a reader.
            cell.metadata.pop("execution", None)
            for output in cell.get("outputs", []):
                if "text" in output:
                    output["text"] = without_place(output["text"])
        notebook.metadata.pop("language_info", None)
        nbformat.write(notebook, path)
        return
    assert any(kinds(kept)), "it is kept without outputs: UPDATE_DOCS=1 pytest -m long"
    assert kinds(notebook) == kinds(kept), "UPDATE_DOCS=1 pytest -m long"
    assert words(texts(notebook)) == words(texts(kept)), "UPDATE_DOCS=1 pytest -m long"


def words(text):
    """The words between the numbers: these may be one apart in their last digit, or times."""
    return re.sub(r"-?\d[\d.e+-]*|0x[0-9a-f]+", "#", text).split()


def test_every_figure_is_drawn():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from wheelrail import conicity, planar, plot

    wheel = wheelrail.Element(
        normal_model="piotrowski_kik", tangential_model="fastsim", vertical_mode="load",
        vx=20.0, pitch_rate=-20.0 / 0.46,
    )  # fmt: skip
    contacts = wheel.contacts(y=0.748, yaw=2e-3, load=8e4)
    outlines = plot.contacts(contacts)
    assert len(outlines.lines) == 3 * len(contacts) and len(outlines.patches) == len(contacts)
    # The legend stands above the picture; the overlap is drawn as deep as it says, in mm.
    says = outlines.get_legend().get_texts()[-1].get_text()
    times = float(says.removeprefix("overlap, ").removesuffix(" times"))
    drawn = np.ptp(outlines.patches[0].get_xy()[:, 1])
    assert 1e3 * contacts[0].penetration * times <= 1.2 * drawn < 3.0
    assert plot.contacts([]) is not None
    axes = plot.patch(contacts[0].fields[0])
    # Pressure, arrows and the border of the adhesion area.
    assert len(axes.collections) == 3
    loaded = 1e3 * contacts[0].fields[0].y[(contacts[0].fields[0].pressure > 0.0).any(axis=1)]
    assert axes.get_xlim()[0] < loaded.min() - 0.3 and axes.get_xlim()[1] > loaded.max() + 0.3
    y = np.linspace(-0.01, 0.01, 101)
    unslipped = planar.fields(y, y**2 / 0.6, radius=0.3, load=1e4, tangential_model="none")
    assert len(plot.patch(unslipped[0]).collections) == 1
    result = wheel.evaluate(y=0.75 + np.linspace(-3e-3, 3e-3, 7), load=8e4)
    axes = plot.sweep(result, "wheel.y", ["wheel.force.x", "wheel.force.y"])
    assert len(axes.lines) == 2 and axes.get_xlabel() == "wheel.y [m]" and axes.get_ylabel() == "[N]"
    assert plot.sweep(result, "wheel.y", ["wear_number"]).get_ylabel() == "wear_number [J/m]"
    assert len(plot.conicity(conicity.table(step=1e-3))) == 2
