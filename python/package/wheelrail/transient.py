"""Wheels whose contacts remember the steps before."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

import numpy as np
import numpy.typing as npt

from ._contact import Field
from ._load import Load, is_wheel
from ._run import Run
from .errors import BadValueError

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import ElementInputs

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

    def fields(self, **inputs: Unpack[ElementInputs]) -> list[Field]:
        """Pressure and the tractions that are remembered, one field for each rail that the wheel touches.

        The most loaded rail is first; a field has all contacts with it, as they lie on the arc of the rail, from
        the centre of the most loaded one. A left wheel is seen as a right one.

        Parameters
        ----------
        **inputs : float
            As in `wheelrail.Element.evaluate`, one number each: those of the last step, for what it has left. At
            others nothing slips on the way, and tractions are those of before as far as the pressure bears them.
        """
        one = self._element._one_position("fields", inputs)
        return [Field(**found) for found in self._native.fields(one)]

    def loads(
        self, *, body: Literal["rail", "wheel"] = "rail", **inputs: Unpack[ElementInputs]
    ) -> list[Load]:
        """What the `fields` load the rail or the wheel with: see `wheelrail.subsurface`.

        Parameters
        ----------
        body : {"rail", "wheel"}
            The body below whose surface stresses are asked for.
        **inputs : float
            As for `fields`.
        """
        material = "wheel" if is_wheel(body) else "rail"
        given = self._element.parameters
        return [
            Load(
                field,
                body=body,
                young_modulus=given[f"{material}.young_modulus"],
                poisson_ratio=given[f"{material}.poisson_ratio"],
            )
            for field in self.fields(**inputs)
        ]

    @property
    def history(self) -> npt.NDArray[np.float64]:
        """What the next step depends on, as numbers to store; set it to go back, to the bit."""
        return self._native.history

    @history.setter
    def history(self, numbers_: npt.ArrayLike) -> None:
        self._native.set_history(np.ascontiguousarray(numbers_, dtype=np.float64).ravel())
