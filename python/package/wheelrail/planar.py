"""Planar contact problems: a separation of two bodies instead of a placed wheel and rail.

The undeformed distance is f(y) + x²/(2R). Forces are those on the upper body, the wheel; x forward, y to
the right; creepages are those at the origin of the separation.
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from . import _native
from ._contact import Field
from ._element import Element, _is_tolerant, _threads, in_slices
from ._given import numbers
from ._result import Column, Columns, Layout, Result
from .errors import BadValueError

__all__ = ["fields", "solve"]

_COLUMNS = Columns(
    Column("normal_force", "N", "Normal force"),
    Column("max_pressure", "Pa", "Greatest pressure"),
    Column("area", "m2", "Area of all zones"),
    Column("length", "m", "Greatest length of a zone along x"),
    Column("width", "m", "Distance from the leftmost to the rightmost edge"),
    Column("fx", "N", "Longitudinal creep force"),
    Column("fy", "N", "Lateral creep force"),
    Column("mz", "N.m", "Moment about the normal through the origin of the separation"),
    Column("patches", "", "Number of separate zones", True),
    Column("fallback", "", "Whether a solver fell back to a simpler model", True),
)


class PlanarResult(Result):
    """What `solve` gives."""

    normal_force: Any
    max_pressure: Any
    area: Any
    length: Any
    width: Any
    fx: Any
    fy: Any
    mz: Any
    patches: Any
    fallback: Any


def solve(
    y: npt.ArrayLike,
    f: npt.ArrayLike,
    *,
    radius: npt.ArrayLike,
    approach: npt.ArrayLike | None = None,
    load: npt.ArrayLike | None = None,
    creepage_longitudinal: npt.ArrayLike = 0.0,
    creepage_lateral: npt.ArrayLike = 0.0,
    spin: npt.ArrayLike = 0.0,
    friction: npt.ArrayLike = 0.3,
    speed: npt.ArrayLike = 0.0,
    threads: int | None = None,
    errors: Literal["raise", "nan"] = "raise",
    **parameters: Any,
) -> PlanarResult:
    """Solves planar problems of one separation for arrays of all else, which broadcast.

    Parameters
    ----------
    y, f : array_like, shape (n,)
        Points of the separation, at least four, y growing [m].
    radius : array_like
        Radius of the normal section along x [m].
    approach, load : array_like
        One of them: approach from f = 0 [m], or normal force [N].
    creepage_longitudinal, creepage_lateral, spin : array_like
        Creepages at the origin [-, -, 1/m].
    friction : array_like
        Coefficient of friction [-].
    speed : array_like
        Rolling speed, for falling friction alone [m/s].
    threads, errors
        As in `wheelrail.Element.evaluate`.
    **parameters
        Models, resolutions and materials as for `wheelrail.Element`: ``normal_model="strips"``, …

    Returns
    -------
    Result
        normal_force, max_pressure, area, length, width, fx, fy, mz, patches, fallback.
    """
    separation, cases, shape, by_load, given, wheel = _cases(
        y, f, radius, approach, load,
        (creepage_longitudinal, creepage_lateral, spin, friction, speed), parameters,
    )  # fmt: skip
    data = np.empty((len(cases), len(_COLUMNS)))
    states = np.zeros(len(cases), dtype=np.uint8)
    count, tolerant = _threads(threads), _is_tolerant(errors)
    refusals: dict[int, str] = {}

    def work(rows: slice) -> None:
        found = _native.planar_solve(
            wheel._native, separation, cases[rows], by_load, data[rows], states[rows], count, tolerant
        )
        refusals.update((rows.start + row, text) for row, text in sorted(found.items()))

    in_slices(len(cases), work, count)
    return PlanarResult(_COLUMNS, data, states, refusals, Layout(shape, given))


def fields(
    y: npt.ArrayLike,
    f: npt.ArrayLike,
    *,
    radius: float,
    approach: float | None = None,
    load: float | None = None,
    creepage_longitudinal: float = 0.0,
    creepage_lateral: float = 0.0,
    spin: float = 0.0,
    friction: float = 0.3,
    speed: float = 0.0,
    **parameters: Any,
) -> list[Field]:
    """Pressure and tractions of one planar problem element by element, one field for each zone.

    Parameters
    ----------
    y, f, radius, approach, load, creepage_longitudinal, creepage_lateral, spin, friction, speed, **parameters
        As in `solve`, one number each.
    """
    separation, case, by_load, wheel = one_case(
        "fields", y, f, radius, approach, load,
        (creepage_longitudinal, creepage_lateral, spin, friction, speed), parameters,
    )  # fmt: skip
    return [Field(**one) for one in _native.planar_fields(wheel._native, separation, case, by_load)]


def one_case(
    caller: str,
    y: npt.ArrayLike,
    f: npt.ArrayLike,
    radius: npt.ArrayLike,
    approach: npt.ArrayLike | None,
    load: npt.ArrayLike | None,
    others: tuple[npt.ArrayLike, ...],
    parameters: dict[str, Any],
) -> tuple[Any, npt.NDArray[np.float64], bool, Element]:
    """Separation, numbers, whether the load is given, and element of the one case of a function."""
    separation, cases, _, by_load, _, wheel = _cases(y, f, radius, approach, load, others, parameters)
    if len(cases) != 1:
        raise BadValueError(f"{caller} takes one case, not {len(cases)}: see solve")
    return separation, cases[0], by_load, wheel


def _cases(
    y: npt.ArrayLike,
    f: npt.ArrayLike,
    radius: npt.ArrayLike,
    approach: npt.ArrayLike | None,
    load: npt.ArrayLike | None,
    others: tuple[npt.ArrayLike, ...],
    parameters: dict[str, Any],
) -> tuple[Any, npt.NDArray[np.float64], tuple[int, ...], bool, dict[str, Any], Element]:
    if (approach is None) == (load is None):
        raise BadValueError("give either approach or load", variable="approach")
    by_load = approach is None
    names = ["radius", "load" if by_load else "approach"]
    names += ["creepage_longitudinal", "creepage_lateral", "spin", "friction", "speed"]
    values = (radius, load if by_load else approach, *others)
    given = {name: numbers(name, value) for name, value in zip(names, values)}
    columns = np.broadcast_arrays(*given.values())
    cases = np.ascontiguousarray(np.stack([c.ravel() for c in columns], axis=1))
    points = [numbers("separation y", y).ravel(), numbers("separation f", f).ravel()]
    if points[0].size != points[1].size:
        raise BadValueError(
            f"y has {points[0].size} points and f {points[1].size}: one f for each y", variable="f"
        )
    separation = np.ascontiguousarray(np.stack(points, axis=1))
    return separation, cases, columns[0].shape, by_load, given, Element(**parameters)
