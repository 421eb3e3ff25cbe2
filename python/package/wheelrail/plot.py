"""Figures by matplotlib: `pip install wheelrail[plot]`. Lengths are drawn in mm, angles in degrees, pressures in MPa."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._contact import Contact, Field
from ._result import Result

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["conicity", "contacts", "patch", "sweep"]

_RIGHT, _LEFT = "#0b6e99", "#c2571a"


def _axes(axes: Axes | None, **options: Any) -> Axes:
    if axes is not None:
        return axes
    import matplotlib.pyplot as plt

    made: Axes = plt.subplots(layout="constrained", **options)[1]
    return made


def contacts(found: Sequence[Contact], axes: Axes | None = None) -> Axes:
    """Outlines of wheel and rail where they touch, seen from behind.

    Parameters
    ----------
    found : sequence of Contact
        As `wheelrail.Element.contacts` gives them.
    axes : matplotlib.axes.Axes, optional
        Where to draw; without it a new figure.
    """
    axes = _axes(axes, figsize=(6.4, 3.6))
    for contact in found:
        first = contact is found[0]
        for line, colour, name in (
            (contact.wheel, _RIGHT, "wheel"),
            (contact.rail_head, _LEFT, "rail"),
        ):
            axes.plot(1e3 * line[:, 0], 1e3 * line[:, 1], color=colour, label=name if first else None)
    for number, contact in enumerate(found, 1):
        y, z = 1e3 * contact.position
        axes.plot(y, z, "o", color="black", markersize=4)
        axes.annotate(
            f"{number}: {np.degrees(contact.contact_angle):.1f}°",
            (y, z), (-6, 8), textcoords="offset points", ha="right",
        )  # fmt: skip
    axes.set(xlabel="y to the right [mm]", ylabel="z down [mm]")
    if found:
        width, height = np.abs(np.subtract(*axes.get_xlim())), np.abs(np.subtract(*axes.get_ylim()))
        # A tread drawn to scale is a line.
        if height > 0.25 * width:
            axes.set_aspect("equal")
        else:
            axes.set_ylabel("z down, stretched [mm]")
        axes.invert_yaxis()
        axes.legend(frameon=False)
    return axes


def patch(field: Field, axes: Axes | None = None, *, arrows: int = 20) -> Axes:
    """Pressure of a zone, its tractions as arrows, and the border between adhesion and slip.

    Parameters
    ----------
    field : Field
        As `wheelrail.Element.contacts` and `wheelrail.planar.fields` have them.
    axes : matplotlib.axes.Axes, optional
        Where to draw; without it a new figure.
    arrows : int
        Arrows along the longer side at most.
    """
    axes = _axes(axes, figsize=(5.2, 4.4))
    x, y = 1e3 * field.x, 1e3 * field.y
    pressure = np.ma.masked_less_equal(1e-6 * field.pressure, 0.0)
    image = axes.pcolormesh(y, x, pressure.T, shading="nearest", cmap="YlOrRd")
    axes.figure.colorbar(image, ax=axes, label="pressure [MPa]")
    every = max(1, int(np.ceil(max(len(x), len(y)) / arrows)))
    tx, ty = field.traction_x[::every, ::every], field.traction_y[::every, ::every]
    loaded = np.hypot(tx, ty) > 0.0
    if loaded.any():
        at_y, at_x = np.meshgrid(y[::every], x[::every], indexing="ij")
        # The longest arrow spans one and a half of the gaps between them.
        gap = every * 1e3 * max(field.dx, field.dy)
        scale = float(np.hypot(tx, ty).max()) / (1.5 * gap)
        axes.quiver(
            at_y[loaded], at_x[loaded], ty[loaded], tx[loaded],
            angles="xy", scale_units="xy", scale=scale, width=0.006, color="#222222",
        )  # fmt: skip
    if (field.adherence == 1).any() and (field.adherence == 2).any():
        axes.contour(y, x, (field.adherence == 1).T.astype(float), levels=[0.5], colors=_RIGHT)
    axes.set(xlabel="y to the right [mm]", ylabel="x, rolling forward is up [mm]", aspect="equal")
    return axes


def sweep(result: Result, over: str, names: Sequence[str], axes: Axes | None = None) -> Axes:
    """Quantities of a result over one of its inputs.

    Parameters
    ----------
    result : Result
        Of an evaluation along one dimension.
    over : str
        Input along the axis, by FMI name.
    names : sequence of str
        Quantities, of one unit.
    axes : matplotlib.axes.Axes, optional
        Where to draw; without it a new figure.
    """
    axes = _axes(axes, figsize=(6.4, 3.6))
    for name in names:
        axes.plot(np.ravel(result.inputs[over]), np.ravel(result[name]), label=name)
    unit = result.units[names[0]]
    axes.set(xlabel=over, ylabel=f"[{unit}]" if unit else "")
    axes.grid(alpha=0.3)
    axes.legend(frameon=False)
    return axes


def conicity(table: Result, axes: Sequence[Axes] | None = None) -> Sequence[Axes]:
    """Rolling radius difference and equivalent conicity.

    Parameters
    ----------
    table : Result
        As `wheelrail.conicity.table` and `wheelrail.conicity.contact_geometry` give it.
    axes : two matplotlib.axes.Axes, optional
        Where to draw; without them a new figure.
    """
    if axes is None:
        import matplotlib.pyplot as plt

        axes = plt.subplots(1, 2, figsize=(8.4, 3.4), layout="constrained")[1]
    y = 1e3 * next(iter(table.inputs.values()))
    axes[0].plot(y, 1e3 * table["difference"], color=_RIGHT)
    axes[0].set(xlabel="lateral displacement [mm]", ylabel="rolling radius difference [mm]")
    axes[1].plot(y, table["conicity"], color=_RIGHT)
    axes[1].set(xlabel="amplitude [mm]", ylabel="equivalent conicity")
    axes[1].set_xlim(left=0.0)
    axes[1].set_ylim(bottom=0.0)
    for one in axes:
        one.grid(alpha=0.3)
    return axes
