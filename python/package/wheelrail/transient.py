"""Wheels whose contacts remember the steps before."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from ._run import Run
from .errors import BadValueError

__all__ = ["TransientRun"]


class TransientRun(Run):
    """A wheel whose creep forces build up over the way it rolls: rows are steps in time, one after the other.

    Parameters
    ----------
    parameters, **keywords
        As for `wheelrail.Element`, with ``tangential_history="transient"``, and ``normal_model`` and
        ``tangential_model`` = ``"boundary_element"``.

    Notes
    -----
    The first step is steady rolling with its inputs; of a wheel that stands or is in the air it is the beginning of
    a contact without tractions. docs/theory.md, section 12.
    """

    def _check(self) -> None:
        if self._element.parameters["tangential.history"] != "transient":
            raise BadValueError(
                "tangential.history = steady remembers nothing: choose transient",
                variable="tangential.history",
            )

    @property
    def history(self) -> npt.NDArray[np.float64]:
        """What the next step depends on, as numbers to store; set it to go back, to the bit."""
        return self._native.history

    @history.setter
    def history(self, numbers_: npt.ArrayLike) -> None:
        self._native.set_history(np.ascontiguousarray(numbers_, dtype=np.float64).ravel())
