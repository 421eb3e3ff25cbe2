"""Planar contact problems: a separation of two bodies instead of a placed wheel and rail.

The undeformed distance is f(y) + x²/(2R). Forces are those on the upper body, the wheel; x forward, y to
the right; creepages are those at the origin of the separation.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from . import _native
from ._contact import Field
from ._element import Element
from ._given import numbers
from ._result import Column, Columns, Layout, Result
from ._slices import in_slices, is_tolerant, thread_count
from .errors import BadValueError

__all__ = ["Transient", "TransientField", "TransientResult", "fields", "solve"]

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
    count, tolerant = thread_count(threads), is_tolerant(errors)
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


@dataclass(frozen=True, eq=False, repr=False)
class TransientField(Field):
    """Pressure and tractions at the end of a step of `Transient`, and what happened in it.

    Attributes
    ----------
    slip_x, slip_y : ndarray, shape (across, along), or None
        Mean slip over the distance rolled [-]; None in a shift.
    slip_distance_x, slip_distance_y : ndarray, shape (across, along)
        Slip of wheel against rail in the step [m].
    friction_work : ndarray, shape (across, along)
        Work that friction took up in the step [J].
    """

    slip_distance_x: npt.NDArray[np.float64]
    slip_distance_y: npt.NDArray[np.float64]
    friction_work: npt.NDArray[np.float64]


@dataclass(frozen=True)
class TransientResult:
    """What a step of `Transient` leads to; forces on the wheel.

    Attributes
    ----------
    normal_force, max_pressure, area, length, width, fx, fy, mz, patches
        As those of `solve`.
    displacement_x, displacement_y, turn : float
        Rigid displacement of the wheel against the rail in the step [m] and turn [rad]: as given,
        or as found for given forces.
    friction_work : float
        Work that friction took up [J].
    substeps, sweeps : int
        Steps that it was divided into, 0 where it was solved as steady rolling, and sweeps of the
        solver.
    converged : bool
        Whether the tractions of all of them settled.
    """

    normal_force: float
    max_pressure: float
    area: float
    length: float
    width: float
    fx: float
    fy: float
    mz: float
    patches: int
    displacement_x: float
    displacement_y: float
    turn: float
    friction_work: float
    substeps: int
    sweeps: int
    converged: bool


# The numbers of a step, in the order of the native part.
_STEP = tuple(field.name for field in dataclasses.fields(TransientResult))


class Transient:
    """A planar contact problem with memory, by boundary elements.

    Each step has a state, as for `solve`, the distance rolled since the state before, and a shift.
    Tractions follow from those of the step before: shifts, rolling from rest, oscillating creepage or
    load, contacts that split, merge, begin and end. A step of any length is allowed; one of many
    lengths of the contact ends in steady rolling.

    Parameters
    ----------
    element_size : (float, float), optional
        Length and width of an element [m]; otherwise those of the first state with contact, of which
        ``normal_elements_along`` by ``normal_elements_across`` cover the contact.
    **parameters
        Materials and numbers of elements as for `wheelrail.Element`. The models are boundary elements.
    """

    def __init__(self, *, element_size: tuple[float, float] | None = None, **parameters: Any) -> None:
        models = {"normal_model": "boundary_element", "tangential_model": "boundary_element"}
        self._parameters = {**models, **parameters}
        self._wheel = Element(**self._parameters)
        size = None if element_size is None else (float(element_size[0]), float(element_size[1]))
        self._native = _native.TransientContact(size)

    def step(
        self,
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
        rolled: float = 0.0,
        shift_x: float = 0.0,
        shift_y: float = 0.0,
        turn: float = 0.0,
        force_longitudinal: float | None = None,
        force_lateral: float | None = None,
    ) -> TransientResult:
        """Goes one step on. A step that is refused leaves the history as it was.

        Parameters
        ----------
        y, f, radius, approach, load, creepage_longitudinal, creepage_lateral, spin, friction
            The state, as for `solve`, one number each.
        rolled : float
            Distance rolled in the step, negative backward [m].
        shift_x, shift_y, turn : float
            Displacement of the wheel against the rail [m] and turn about the normal through the
            origin [rad], on top of creepage times the distance rolled, which counts
            positive there.
        force_longitudinal, force_lateral : float, optional
            Creep force on the wheel [N]: that component of the displacement is found.
        """
        separation, case, by_load = _one_state(
            y, f, radius, approach, load, (creepage_longitudinal, creepage_lateral, spin, friction, 0.0)
        )
        found = self._native.step(
            self._wheel._native,
            separation,
            case,
            by_load,
            float(rolled),
            (float(shift_x), float(shift_y), float(turn)),
            (
                None if force_longitudinal is None else float(force_longitudinal),
                None if force_lateral is None else float(force_lateral),
            ),
        )
        given: dict[str, Any] = dict(zip(_STEP, found))
        counts = {name: int(given.pop(name)) for name in ("patches", "substeps", "sweeps")}
        return TransientResult(converged=given.pop("converged") > 0.0, **counts, **given)

    def field(self) -> TransientField | None:
        """Pressure, tractions and slip of the last step; None before it and without contact."""
        found = self._native.field()
        return None if found is None else TransientField(**found)

    @property
    def history(self) -> npt.NDArray[np.float64]:
        """All that the next step depends on; set it to go back, or on from another place."""
        return self._native.history

    @history.setter
    def history(self, numbers_: npt.ArrayLike) -> None:
        self._native.set_history(np.ascontiguousarray(numbers_, dtype=np.float64).ravel())


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


def _one_state(
    y: npt.ArrayLike,
    f: npt.ArrayLike,
    radius: npt.ArrayLike,
    approach: npt.ArrayLike | None,
    load: npt.ArrayLike | None,
    others: tuple[npt.ArrayLike, ...],
) -> tuple[Any, npt.NDArray[np.float64], bool]:
    separation, cases, _, by_load, _ = _given(y, f, radius, approach, load, others)
    if len(cases) != 1:
        raise BadValueError(f"a step takes one state, not {len(cases)}")
    return separation, cases[0], by_load


def _cases(
    y: npt.ArrayLike,
    f: npt.ArrayLike,
    radius: npt.ArrayLike,
    approach: npt.ArrayLike | None,
    load: npt.ArrayLike | None,
    others: tuple[npt.ArrayLike, ...],
    parameters: dict[str, Any],
) -> tuple[Any, npt.NDArray[np.float64], tuple[int, ...], bool, dict[str, Any], Element]:
    wheel = Element(**parameters)
    if wheel._settings.get("tangential.history", "steady") not in ("steady", 1):
        raise BadValueError(
            'tangential.history = "transient" is not admitted: each problem rolls steadily; planar.Transient is '
            "followed through steps",
            variable="tangential.history",
        )
    return (*_given(y, f, radius, approach, load, others), wheel)


def _given(
    y: npt.ArrayLike,
    f: npt.ArrayLike,
    radius: npt.ArrayLike,
    approach: npt.ArrayLike | None,
    load: npt.ArrayLike | None,
    others: tuple[npt.ArrayLike, ...],
) -> tuple[Any, npt.NDArray[np.float64], tuple[int, ...], bool, dict[str, Any]]:
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
    return separation, cases, columns[0].shape, by_load, given
