"""Derivatives backwards: of a weighted sum of outputs by inputs, parameters and points of the profiles."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final, Literal

import numpy as np
import numpy.typing as npt

from . import _native
from .errors import UnknownVariableError

#: Bodies whose profiles have points, in the order of the native part.
BODIES: Final[tuple[Literal["wheel"], Literal["rail1"], Literal["rail2"]]] = ("wheel", "rail1", "rail2")

#: FMI names of the parameters that derivatives are found by.
PARAMETERS: tuple[str, ...] = tuple(_native.adjoint_parameters())


class Adjoint:
    """Derivatives of a weighted sum of outputs by all that it depends on.

    ``adjoint["wheel.y"]`` and ``adjoint["track.gauge"]`` are arrays of the shape that the inputs broadcast
    to, a ``float`` where every input is one number; keywords do as well as FMI names.

    Attributes
    ----------
    values : ndarray, shape (..., inputs and parameters)
        Derivatives of each row's own sum, each in its unit over the SI unit of what it is by.
    names : tuple of str
        FMI names along the last dimension: the inputs asked for, then the parameters.
    wheel_points, rail1_points, rail2_points : ndarray
        Derivatives of the sum of all rows by the displacement of each point of a profile along the normal
        of its surface, out of the body (wear is negative) [1/m]; empty for a profile that varies or is not
        there. The points are those of ``element.points(...)``.
    valid : ndarray of bool
        Where there are derivatives; with ``errors="raise"`` everywhere.
    refusals : dict
        Why there are none, by row in C order.
    """

    def __init__(
        self,
        values: npt.NDArray[np.float64],
        names: tuple[str, ...],
        points: tuple[npt.NDArray[np.float64], ...],
        valid: Any,
        refusals: Mapping[int, str],
        keywords: Mapping[str, str],
    ) -> None:
        self.values = values
        self.names = names
        self.wheel_points, self.rail1_points, self.rail2_points = points
        self.valid = valid
        self.refusals = dict(refusals)
        self._keywords = keywords

    def __getitem__(self, name: str) -> Any:
        fmi_name = self._keywords.get(name, name)
        if fmi_name not in self.names:
            raise UnknownVariableError(
                f'there is no derivative by "{fmi_name}": by= says which inputs there are, and '
                f"parameters are {', '.join(PARAMETERS)}",
                variable=fmi_name,
            )
        found = self.values[..., self.names.index(fmi_name)]
        return found if found.ndim else found.item()

    def __repr__(self) -> str:
        return f"<wheelrail.Adjoint: by {len(self.names)} inputs and parameters, shape {self.values.shape}>"
