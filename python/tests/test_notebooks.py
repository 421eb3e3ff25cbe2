"""Notebooks run from top to bottom, and figures are drawn."""

from pathlib import Path

import numpy as np
import pytest
import wheelrail

NOTEBOOKS = sorted((Path(__file__).parent.parent / "notebooks").glob("*.ipynb"))


@pytest.mark.long
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(path, tmp_path):
    nbformat = pytest.importorskip("nbformat")
    client = pytest.importorskip("nbclient").NotebookClient
    notebook = nbformat.read(path, as_version=4)
    assert all(not cell.get("outputs") for cell in notebook.cells), "notebooks are kept without outputs"
    client(notebook, timeout=900, resources={"metadata": {"path": str(tmp_path)}}).execute()


def test_every_figure_is_drawn():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from wheelrail import conicity, planar, plot

    wheel = wheelrail.Element(
        normal_model="piotrowski_kik", tangential_model="fastsim", vertical_mode="load",
        vx=20.0, pitch_rate=-20.0 / 0.46,
    )  # fmt: skip
    contacts = wheel.contacts(y=0.748, yaw=2e-3, load=8e4)
    assert len(plot.contacts(contacts).lines) == 3 * len(contacts)
    assert plot.contacts([]) is not None
    axes = plot.patch(contacts[0].fields[0])
    # Pressure, arrows and the border of the adhesion area.
    assert len(axes.collections) == 3
    y = np.linspace(-0.01, 0.01, 101)
    unslipped = planar.fields(y, y**2 / 0.6, radius=0.3, load=1e4, tangential_model="none")
    assert len(plot.patch(unslipped[0]).collections) == 1
    result = wheel.evaluate(y=0.75 + np.linspace(-3e-3, 3e-3, 7), load=8e4)
    assert len(plot.sweep(result, "wheel.y", ["wheel.force.x", "wheel.force.y"]).lines) == 2
    assert len(plot.conicity(conicity.table(step=1e-3))) == 2
