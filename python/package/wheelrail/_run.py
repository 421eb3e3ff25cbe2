"""A wheel that is followed through steps in time."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _native
from ._element import Element, Outputs, columns_of
from ._files import folders
from ._given import Given, named, numbers
from ._result import Result
from ._variables import Variable, select, variables
from .errors import BadValueError

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import ElementInputs, ElementParameters


class Run:
    """Rows are steps in time, one after the other, of a wheel that has a state."""

    def __init__(
        self,
        parameters: Mapping[str, Any] | None = None,
        /,
        **keywords: Unpack[ElementParameters],
    ) -> None:
        self._element = Element(parameters, **keywords)
        self._check()
        settings: Any = list(self._element._settings.items())
        self._native = _native.SteppedWheel(settings, folders())

    def _check(self) -> None:
        """Whether there is anything that a step changes."""

    def _besides(self, variable: Variable) -> bool:
        """Whether an output that belongs to steps comes with those that are asked for."""
        return False

    def __repr__(self) -> str:
        return repr(self._element).replace("Element(", f"{type(self).__name__}(", 1)

    def advance(
        self,
        table: Mapping[str, Any] | None = None,
        /,
        *,
        duration: npt.ArrayLike,
        outputs: Outputs = None,
        **inputs: Unpack[ElementInputs],
    ) -> Result:
        """Evaluates row after row, each as a step of its duration, after which the next one follows.

        Parameters
        ----------
        duration : array_like
            Time that each row stands for, one number or one for each row [s].
        outputs : sequence of str, optional
            As in `wheelrail.Element.evaluate`.
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
        wanted += [v for v in variables("WheelRail") if self._besides(v)]
        data = np.empty((rows, len(wanted)))
        self._native.advance(
            given.columns(slice(0, rows)),
            np.ascontiguousarray(np.broadcast_to(times.ravel(), (rows,))),
            [v.reference for v in wanted],
            data,
        )
        return Result(columns_of(wanted), data, np.zeros(rows, np.uint8), {}, given.layout)
