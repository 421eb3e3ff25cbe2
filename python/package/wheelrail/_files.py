"""Files that the package carries."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Literal

import numpy as np
import numpy.typing as npt

from . import _native
from .errors import BadValueError, admitted_count

__all__ = ["fmu", "profile", "profile_folder"]

#: How many points of a profile can be asked for.
POINTS = (2, 1_000_000)

_HERE = Path(__file__).parent

_UNITS = ("WheelRail", "WheelSet", "WheelRail3", "WheelSet3")


def fmu(
    name: Literal["WheelRail", "WheelSet", "WheelRail3", "WheelSet3"] = "WheelRail",
) -> Path:
    """Path of an FMU (co-simulation and model exchange), as FMPy and other importers take it.

    Parameters
    ----------
    name : {"WheelRail", "WheelSet", "WheelRail3", "WheelSet3"}
        One wheel, or two on an axle; of FMI 2.0, or with a 3 of FMI 3.0.
    """
    path = _HERE / "units" / f"{name}.fmu"
    if name not in _UNITS:
        raise BadValueError(
            f'name = "{name}" is not admitted: one of {", ".join(_UNITS)}', variable="name"
        )
    if not path.is_file():
        raise FileNotFoundError(
            f"{path} is not there: this wheelrail was built without its FMUs; build it with maturin"
        )
    return path


def profile_folder() -> Path:
    """The folder with the profiles that the package carries, beside those that are built in."""
    return _HERE / "profiles"


def folders() -> list[str]:
    """Where profiles with relative names are looked for."""
    return [str(profile_folder()), os.getcwd()]


def profile(
    name: str | os.PathLike[str],
    body: Literal["wheel", "rail"] = "wheel",
    *,
    points: int = 1000,
    smoothing: float = -1.0,
) -> npt.NDArray[np.float64]:
    """Points of a profile, evenly along its arc.

    Parameters
    ----------
    name : str or path
        Built-in name (S1002, conical:0.05, …; 60E1, 60E2, 54E1, …) or a file.
    body : {"wheel", "rail"}
        Of which body.
    points : int
        How many, from 2 to 1e6.
    smoothing : float
        As the parameter ``profile.smoothing`` [m]; -1 leaves it to the noise of the file's points.

    Returns
    -------
    ndarray, shape (points, 2)
        y to the field side and z down [m]; of a wheel from the nominal rolling circle.
    """
    count = admitted_count("points", points, *POINTS)
    return _native.profile_points(os.fspath(name), body, smoothing, folders(), count)
