"""Profiles that wear while a wheel runs."""

from __future__ import annotations

from typing import Literal

import numpy as np
import numpy.typing as npt

from ._files import POINTS
from ._run import Run
from ._variables import Variable
from .errors import BadValueError, admitted_count

__all__ = ["WearRun"]

Body = Literal["wheel", "rail[1]", "rail[2]"]
_BODIES = ("wheel", "rail[1]", "rail[2]")


class WearRun(Run):
    """A wheel whose profiles wear: rows are steps in time, one after the other, and what is worn stays worn.

    Parameters
    ----------
    parameters, **keywords
        As for `wheelrail.Element`, with a wear law: ``wear_model="frictional_work"`` and so on.

    Notes
    -----
    What is worn so far, ``wear.*``, comes with the outputs of `advance`. Wear laws and their coefficients are experimental: see docs/wear.md.
    """

    def _check(self) -> None:
        if self._element.parameters["wear.model"] == "off":
            raise BadValueError(
                "wear.model = off wears nothing: choose a law, such as frictional_work",
                variable="wear.model",
            )

    def _besides(self, variable: Variable) -> bool:
        # What is worn so far.
        return variable.causality == "output" and variable.name.startswith("wear.")

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
