"""Units with the files and values of their user inside."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Literal

from . import _native
from ._files import fmu

__all__ = ["pack"]


def pack(
    output: str | os.PathLike[str],
    *,
    wheel: str | os.PathLike[str] | None = None,
    rail: str | os.PathLike[str] | None = None,
    values: Mapping[str, float | int | bool | str | os.PathLike[str]] | None = None,
    unit: Literal["WheelRail", "WheelSet", "WheelRail3", "WheelSet3"] = "WheelRail",
    source: str | os.PathLike[str] | None = None,
    name: str | None = None,
    description: str = "Contact of railway wheel and rail",
    dummy_state: bool = False,
) -> Path:
    """Pack an FMU with your profiles and values inside, to be mailed as one file.

    Profiles, waves, friction tables and sections go into its resources, values become its start values;
    the libraries of all platforms stay. No compiler is needed. The same input gives the same bytes.

    Parameters
    ----------
    output : str or path
        The packed unit, overwritten if it is there.
    wheel, rail : str or path, optional
        Profile of the wheel and of the rail, of a wheelset of both: built-in name or file.
    values : mapping of str, optional
        Start values by FMI name, inputs and parameters, files too; choices by the names of their items.
    unit : {"WheelRail", "WheelSet", "WheelRail3", "WheelSet3"}
        Which unit that comes with the package.
    source : str or path, optional
        A unit as a file in the place of ``unit``; it may be packed already.
    name, description : str, optional
        Of the model; without a name it is that of the file.
    dummy_state : bool
        Whether model exchange has a state, der(x) = 0, for importers that cannot integrate without.

    Returns
    -------
    Path
        The packed unit.

    Raises
    ------
    UnknownVariableError, BadValueError, ProfileError
        By name what there is not, or what is not admitted; nothing is written then.
    """
    target = Path(output)
    path = Path(source) if source is not None else fmu(unit)
    profiles = [None if profile is None else os.fspath(profile) for profile in (wheel, rail)]
    settings = [(variable, _text(value)) for variable, value in (values or {}).items()]
    title = target.stem if name is None else name
    _native.pack(path, target, profiles, settings, title, description, dummy_state)
    return target


def _text(value: float | int | bool | str | os.PathLike[str]) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    return str(value) if isinstance(value, int) else repr(float(value))
