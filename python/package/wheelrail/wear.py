"""Profiles that wear while a wheel runs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from . import _native
from ._element import Element, Outputs, columns_of
from ._files import POINTS, folders
from ._given import Given, named, numbers
from ._result import Result
from ._variables import Variable, select, variables
from .errors import BadValueError, admitted_count

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import ElementInputs, ElementParameters

__all__ = ["WearRun"]

Body = Literal["wheel", "rail[1]", "rail[2]"]
_BODIES = ("wheel", "rail[1]", "rail[2]")


class WearRun:
    """A wheel whose profiles wear: rows are steps in time, one after the other, and what is worn stays worn.

    Parameters
    ----------
    parameters, **keywords
        As for `wheelrail.Element`, with a wear law: ``wear_model="frictional_work"`` and so on.

    Notes
    -----
    Wear laws and their coefficients are experimental: see docs/wear.md.
    """

    def __init__(
        self,
        parameters: Mapping[str, Any] | None = None,
        /,
        **keywords: Unpack[ElementParameters],
    ) -> None:
        self._element = Element(parameters, **keywords)
        if self._element.parameters["wear.model"] == "off":
            raise BadValueError(
                "wear.model = off wears nothing: choose a law, such as frictional_work",
                variable="wear.model",
            )
        settings: Any = list(self._element._settings.items())
        self._native = _native.WearingWheel(settings, folders())

    def __repr__(self) -> str:
        return repr(self._element).replace("Element(", "WearRun(", 1)

    def advance(
        self,
        table: Mapping[str, Any] | None = None,
        /,
        *,
        duration: npt.ArrayLike,
        outputs: Outputs = None,
        **inputs: Unpack[ElementInputs],
    ) -> Result:
        """Evaluates row after row, each for its duration, and wears off what that wears off.

        Parameters
        ----------
        duration : array_like
            Time that each row stands for, one number or one for each row [s].
        outputs : sequence of str, optional
            As in `wheelrail.Element.evaluate`; what is worn so far, ``wear.*``, comes with them.
        table, **inputs
            As in `wheelrail.Element.evaluate`; at most one dimension.

        Returns
        -------
        Result
            One row for each step.
        """
        times = numbers("duration", duration)
        names, values = named(table, inputs)
        given = Given(self._element._inputs(names), values, table)
        if len(given.layout.shape) > 1 or times.ndim > 1:
            raise BadValueError("steps in time have one dimension", variable="duration")
        rows = max(given.rows, times.size)
        if min(given.rows, times.size) not in (1, rows):
            raise BadValueError(
                f"there are {given.rows} rows and {times.size} durations", variable="duration"
            )
        if given.rows != rows:
            given.repeat(rows)
        wanted = select("WheelRail", outputs, self._element._default_outputs)
        wanted += [v for v in variables("WheelRail") if _is_worn(v)]
        data = np.empty((rows, len(wanted)))
        self._native.advance(
            given.columns(slice(0, rows)),
            np.ascontiguousarray(np.broadcast_to(times.ravel(), (rows,))),
            [v.reference for v in wanted],
            data,
        )
        return Result(columns_of(wanted), data, np.zeros(rows, np.uint8), {}, given.layout)

    def profile(self, body: Body = "wheel", *, points: int = 1000) -> npt.NDArray[np.float64]:
        """Points of a profile with all wear so far, evenly along its arc.

        Parameters
        ----------
        body : {"wheel", "rail[1]", "rail[2]"}
            Which body.
        points : int
            How many, from 2 to 1e6.

        Returns
        -------
        ndarray, shape (points, 2)
            y to the field side and z down [m], in the frame of the profile.
        """
        return self._native.profile(_body(body), admitted_count("points", points, *POINTS))

    def depth(self, body: Body = "wheel") -> npt.NDArray[np.float64]:
        """Wear depth of a body over the lateral coordinate of its unworn profile, as the profile in use has it.

        Returns
        -------
        ndarray, shape (n, 2)
            y and depth [m].
        """
        return self._native.depth(_body(body))


def _body(body: str) -> int:
    if body not in _BODIES:
        raise BadValueError(f'body = "{body}" is not admitted: {", ".join(_BODIES)}', variable="body")
    return _BODIES.index(body)


def _is_worn(variable: Variable) -> bool:
    return variable.causality == "output" and variable.name.startswith("wear.")
