"""The variables of both units: the same that the FMUs have."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

from . import _native
from .errors import BadValueError, UnknownVariableError

__all__ = ["Unit", "Variable", "variables"]

Unit = Literal["WheelRail", "WheelSet"]


@dataclass(frozen=True)
class Variable:
    """What is known about a variable.

    Attributes
    ----------
    name : str
        FMI name, such as ``wheel.force.z``.
    keyword : str
        The same as a Python keyword: ``wheel_force_z``; of inputs the short form, ``y`` for ``wheel.y``.
    description : str
        The quantity, its frame and its sign.
    unit : str
        SI unit; empty for pure numbers and what is no number.
    kind : {"real", "integer", "boolean", "text", "enumeration"}
        Type.
    causality : {"input", "parameter", "calculated", "output"}
        Who sets it.
    start : float, int, bool, str or None
        Start value of inputs and parameters.
    min, max : float or None
        Admitted range.
    items : tuple of str
        Choices of an enumeration.
    reference : int
        FMI value reference.
    """

    name: str
    keyword: str
    description: str
    unit: str
    kind: str
    causality: str
    start: float | int | bool | str | None
    min: float | None
    max: float | None
    items: tuple[str, ...]
    reference: int
    on_request: bool


#: What is left out of the names of inputs.
_OWN = {"WheelRail": "wheel_", "WheelSet": "wheelset_"}


def _long(name: str) -> str:
    return name.replace(".", "_").replace("[", "").replace("]", "")


def _short(unit: str, name: str) -> str:
    keyword = _long(name)
    return keyword.removeprefix(_OWN[unit]).replace("friction_coefficient", "friction")


def variables(unit: Unit = "WheelRail") -> tuple[Variable, ...]:
    """All variables of a unit, in the order of their FMI value references.

    Parameters
    ----------
    unit : {"WheelRail", "WheelSet"}
        One wheel, or two on an axle.
    """
    if unit not in _OWN:
        raise BadValueError(
            f'unit = "{unit}" is not admitted: WheelRail or WheelSet', variable="unit"
        )
    return _all(unit)


@lru_cache
def _all(unit: Unit) -> tuple[Variable, ...]:
    found = []
    for reference, row in enumerate(_native.variables(unit)):
        name = row["name"]
        keyword = _short(unit, name) if row["causality"] == "input" else _long(name)
        items = tuple(row.pop("items") or ())
        found.append(Variable(keyword=keyword, items=items, reference=reference, **row))
    return tuple(found)


def by_name(unit: Unit) -> dict[str, Variable]:
    """Variables by every name they can be called: FMI name, keyword, and the long keyword of inputs."""
    return _names(unit)


@lru_cache
def _names(unit: Unit) -> dict[str, Variable]:
    names: dict[str, Variable] = {}
    for variable in variables(unit):
        for name in (variable.name, variable.keyword, _long(variable.name)):
            names[name] = variable
    return names


@lru_cache
def fmi_names(unit: Unit) -> dict[str, str]:
    """FMI names by every name that variables can be called."""
    return {name: variable.name for name, variable in by_name(unit).items()}


def find(unit: Unit, name: str) -> Variable:
    """The variable of that name; an error with the nearest name if there is none."""
    variable = by_name(unit).get(name)
    if variable is not None:
        return variable
    import difflib

    near = difflib.get_close_matches(name.lower(), by_name(unit), n=1, cutoff=0.0)
    raise UnknownVariableError(
        f'there is no variable "{name}"; the nearest name is {near[0]}', variable=name
    )


def is_evaluated(variable: Variable) -> bool:
    """Whether an evaluation gives it: not what belongs to steps in time, or is worn off in them."""
    return (
        variable.causality == "output"
        and not variable.on_request
        and not re.match(r"((right|left)\.)?(wear|contact|coupling)\.", variable.name)
    )


def select(
    unit: Unit, wanted: Sequence[str] | str | None, default: Callable[[], Iterable[str]]
) -> list[Variable]:
    """Outputs by names, in which ``*`` stands for anything; those of `default` if none are named."""
    if wanted is None:
        wanted = tuple(default())
    elif isinstance(wanted, str):
        wanted = (wanted,)
    found: dict[str, Variable] = {}
    for name in wanted:
        if "*" in name:
            pattern = re.compile(".*".join(map(re.escape, name.split("*"))))
            matching = [v for v in variables(unit) if pattern.fullmatch(v.name) and is_evaluated(v)]
            if not matching:
                raise UnknownVariableError(f'no output fits "{name}"', variable=name)
            found.update((v.name, v) for v in matching)
        else:
            variable = find(unit, name)
            if not is_evaluated(variable):
                why = (
                    "it is not an output"
                    if variable.causality != "output"
                    else "the FMU has it, over its steps; see wheelrail.WearRun for wear"
                )
                raise BadValueError(
                    f'outputs: "{name}" cannot be evaluated: {why}', variable=variable.name
                )
            found[variable.name] = variable
    return list(found.values())
