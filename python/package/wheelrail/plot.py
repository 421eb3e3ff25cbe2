"""Figures by matplotlib: `pip install wheelrail[plot]`. Lengths are drawn in mm, angles in degrees, pressures in MPa."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ._contact import Contact, Field
from ._result import Result
from ._variables import variables
from .frequency import FrequencyResponse

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["conicity", "contacts", "frequency_response", "patch", "sweep"]

#: Blue, orange and purple that colour-blind readers tell apart.
_RIGHT, _LEFT, _OVERLAP = "#0b6e99", "#c2571a", "#6a3d9a"
#: How deep the enlarged overlap is drawn at most, over the width and over the height of the picture.
_LENS = (0.06, 0.3)


def _axes(axes: Axes | None, **options: Any) -> Axes:
    if axes is not None:
        return axes
    import matplotlib.pyplot as plt

    made: Axes = plt.subplots(layout="constrained", **options)[1]
    return made


def contacts(found: Sequence[Contact], axes: Axes | None = None) -> Axes:
    """Outlines of wheel and rail where they touch, seen from behind.

    The outlines are those of the bodies before they deform, so that the wheel lies in the rail by some
    hundredths of a millimetre: that overlap is shaded, enlarged as the legend says.

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
    enlarged = _enlargement(found)
    for contact in found:
        lens = _lens(contact, enlarged)
        label = f"overlap, {enlarged:g} times" if contact is found[0] else None
        axes.fill(1e3 * lens[:, 0], 1e3 * lens[:, 1], color=_OVERLAP, alpha=0.6, lw=0, label=label)
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
        _legend_above(axes)
    return axes


def _legend_above(axes: Axes) -> None:
    """The legend in a row above the picture, where no line is."""
    axes.legend(frameon=False, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=3, fontsize="small")


def _enlargement(found: Sequence[Contact]) -> float:
    """How many times the overlap is drawn: 1, 2 or 5 times a power of ten."""
    deepest = max((contact.penetration for contact in found), default=0.0)
    if deepest <= 0.0:
        return 1.0
    points = np.concatenate([line for c in found for line in (c.wheel, c.rail_head)])
    wanted = max(float((np.ptp(points, axis=0) * _LENS).min()) / deepest, 1.0)
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(power * max(step for step in (1.0, 2.0, 5.0) if step * power <= wanted))


def _lens(contact: Contact, enlarged: float) -> np.ndarray[Any, Any]:
    """Outline of the overlap in the track frame: along the contact plane and, enlarged, into the rail."""
    y, f = contact.separation.T
    overlap = contact.penetration - f
    y, overlap = y[overlap > 0.0], enlarged * overlap[overlap > 0.0]
    along = np.array([np.cos(contact.contact_angle), np.sin(contact.contact_angle)])
    into = np.array([-along[1], along[0]])
    plane = contact.position + y[:, np.newaxis] * along
    return np.concatenate([plane, (plane + overlap[:, np.newaxis] * into)[::-1]])


def patch(field: Field, axes: Axes | None = None, *, arrows: int = 20) -> Axes:
    """Pressure of a zone, its tractions on the wheel as arrows, and the border between adhesion and slip.

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
        longest = float(np.hypot(tx, ty).max())
        scale = longest / (1.5 * gap)
        drawn = axes.quiver(
            at_y[loaded], at_x[loaded], ty[loaded], tx[loaded],
            angles="xy", scale_units="xy", scale=scale, width=0.007, color="#222222",
        )  # fmt: skip
        shown = float(f"{longest:.1g}")
        axes.quiverkey(
            drawn, 0.0, 1.06, shown, f"traction on the wheel, {1e-6 * shown:g} MPa", labelpos="E"
        )
    if (field.adherence == 1).any() and (field.adherence == 2).any():
        axes.contour(y, x, (field.adherence == 1).T.astype(float), levels=[0.5], colors=_RIGHT, linewidths=2)
        axes.plot([], [], color=_RIGHT, lw=2, label="adhesion ends")
        # A patch leaves the corners free.
        axes.legend(frameon=False, loc="lower right", fontsize="x-small")
    # A margin around the loaded elements, the same on all sides.
    across, along = (field.pressure > 0.0).any(axis=1), (field.pressure > 0.0).any(axis=0)
    if across.any():
        margin = 0.1 * max(np.ptp(y[across]), np.ptp(x[along])) + 1e3 * max(field.dx, field.dy)
        axes.set_xlim(y[across].min() - margin, y[across].max() + margin)
        axes.set_ylim(x[along].min() - margin, x[along].max() + margin)
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
    units = {result.units[name] for name in names}
    for name in names:
        unit = result.units[name]
        label = f"{name} [{unit}]" if len(units) > 1 and unit else name
        axes.plot(np.ravel(result.inputs[over]), np.ravel(result[name]), label=label)
    along = next((v.unit for v in (*variables(), *variables("WheelSet")) if v.name == over), "")
    # One name is that of the axis.
    what = names[0] if len(names) == 1 else ""
    unit = units.pop() if len(units) == 1 else ""
    axes.set(xlabel=_with_unit(over, along), ylabel=_with_unit(what, unit))
    axes.grid(alpha=0.3)
    if len(names) > 1:
        _legend_above(axes)
    return axes


def _with_unit(name: str, unit: str) -> str:
    return f"{name} [{unit}]".lstrip() if unit else name


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
    axes[1].set(xlabel="amplitude [mm]", ylabel="equivalent conicity [-]")
    axes[1].set_xlim(left=0.0)
    axes[1].set_ylim(bottom=0.0)
    for one in axes:
        one.grid(alpha=0.3)
    return axes


def frequency_response(
    found: FrequencyResponse | Mapping[str, FrequencyResponse],
    force: Literal["fx", "fy"] = "fx",
    axes: Sequence[Axes] | None = None,
) -> Sequence[Axes]:
    """Amplitude and lag of a creep force over those of slow oscillation.

    Parameters
    ----------
    found : FrequencyResponse or mapping of str to FrequencyResponse
        As `wheelrail.frequency.response` gives it; several by their names.
    force : {"fx", "fy"}
        Which force.
    axes : two of matplotlib.axes.Axes, optional
        Where to draw amplitude and phase; without them a new figure.
    """
    if axes is None:
        import matplotlib.pyplot as plt

        axes = list(plt.subplots(2, 1, sharex=True, layout="constrained", figsize=(6.4, 5.2))[1])
    amplitude, phase = axes
    lines = {"": found} if isinstance(found, FrequencyResponse) else dict(found)
    for (name, own), mark in zip(lines.items(), itertools.cycle("osd^v")):
        ratio = own.ratio(force)
        style: dict[str, Any] = {"marker": mark, "markersize": 4, "label": name or None}
        amplitude.plot(own.length_over_wave, np.abs(ratio), **style)
        phase.plot(own.length_over_wave, np.degrees(np.unwrap(np.angle(ratio))), **style)
    name = {"fx": "longitudinal", "fy": "lateral"}[force]
    amplitude.set(ylabel=f"{name} force\nover that of slow oscillation", ylim=(0, None))
    phase.set(ylabel="phase [deg]", xlabel="length of the contact over the way of a period")
    for own_axes in axes:
        own_axes.grid(alpha=0.3)
        own_axes.set_xscale("log")
    if any(lines):
        amplitude.legend()
    return axes
