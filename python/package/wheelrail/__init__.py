"""Wheel-rail contact: arrays in, arrays out, on every core.

`Element` is one wheel with the rails under it, `WheelSet` two on an axle; :mod:`wheelrail.planar` contact
problems given by a separation, :mod:`wheelrail.frequency` how creep forces follow oscillations,
:mod:`wheelrail.subsurface` stresses below the surface,
:mod:`wheelrail.conicity` the contact geometry of a wheelset, `WearRun` profiles that wear, `TransientRun` contacts
that remember. :mod:`wheelrail.bulk` evaluates tables larger than memory, :mod:`wheelrail.dask` on several machines, :mod:`wheelrail.plot`
draws. `fmu` gives the path of the FMUs that come with it, `pack` one with your profiles inside.

Track frame: x forward, y to the right, z down; SI and radians.
"""

from importlib import import_module
from types import ModuleType

from . import conicity, frequency, planar, subsurface
from ._adjoint import Adjoint
from ._contact import Contact, Field
from ._element import Element, WheelSet
from ._files import fmu, profile, profile_folder
from ._native import __version__
from ._pack import pack
from ._result import Column, Jacobian, Remark, Result
from ._table import evaluate
from ._variables import Variable, variables
from .errors import (
    BadValueError,
    ContactError,
    ContactWarning,
    NoDerivativeError,
    ProfileError,
    UnknownVariableError,
)
from .transient import TransientRun
from .wear import WearRun

#: Modules that are imported when they are first asked for: they need pandas, matplotlib or Dask.
_ON_DEMAND = ("bulk", "dask", "plot")


def __getattr__(name: str) -> ModuleType:
    if name in _ON_DEMAND:
        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *_ON_DEMAND})


__all__ = [
    "Adjoint",
    "BadValueError",
    "Column",
    "Contact",
    "ContactError",
    "ContactWarning",
    "Element",
    "Field",
    "Jacobian",
    "NoDerivativeError",
    "ProfileError",
    "Remark",
    "Result",
    "TransientRun",
    "UnknownVariableError",
    "Variable",
    "WearRun",
    "WheelSet",
    "__version__",
    "conicity",
    "evaluate",
    "fmu",
    "frequency",
    "pack",
    "planar",
    "profile",
    "profile_folder",
    "subsurface",
    "variables",
]
