"""Inputs of a call: their names are looked up once for an element, their values broadcast at each call."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, TypeVar

import numpy as np
import numpy.typing as npt

from ._result import Layout
from ._variables import Unit, Variable, find
from .errors import BadValueError

__all__ = ["Given", "Inputs", "Kept", "input_of", "inputs_of", "named", "numbers"]

#: Sets of names that are kept: more than a program has in its calls.
_MOST = 256

_Key = TypeVar("_Key")
_Value = TypeVar("_Value")


class Kept(dict[_Key, _Value]):
    """What was looked up for sets of names; begins anew when there are too many of them."""

    def keep(self, key: _Key, found: _Value) -> _Value:
        """Keeps what was looked up, and returns it."""
        if len(self) >= _MOST:
            self.clear()
        self[key] = found
        return found


class Inputs(NamedTuple):
    """Inputs that a call gives, whatever their values."""

    #: FMI names.
    names: tuple[str, ...]
    #: FMI references.
    references: tuple[int, ...]
    #: What is to be said of those that have no effect.
    idle: tuple[str, ...]


def named(
    table: Mapping[str, Any] | None, inputs: Mapping[str, Any]
) -> tuple[tuple[str, ...], tuple[Any, ...]]:
    """Names as they are given, and the values in their order: those of the table in front."""
    if table is None:
        return tuple(inputs), tuple(inputs.values())
    if not hasattr(table, "keys"):
        raise BadValueError(
            f"table is a {type(table).__name__}: it takes a mapping or a DataFrame; arrays are "
            "keywords, such as y=",
            variable="table",
        )
    columns = tuple(table)
    return (*columns, *inputs), (*(table[name] for name in columns), *inputs.values())


def inputs_of(unit: Unit, names: tuple[str, ...]) -> dict[str, int]:
    """FMI names and references of the inputs of these names."""
    found: dict[str, int] = {}
    for name in names:
        variable = input_of(unit, str(name))
        if variable.name in found:
            raise BadValueError(f"{variable.name} is given twice", variable=variable.name)
        found[variable.name] = variable.reference
    return found


def input_of(unit: Unit, name: str) -> Variable:
    """The input of that name."""
    variable = find(unit, name)
    if variable.causality != "input":
        what = "a parameter: give it to the element" if variable.causality == "parameter" else "computed"
        raise BadValueError(f'"{name}" is no input, it is {what}', variable=variable.name)
    return variable


class Given:
    """Inputs of a call, broadcast."""

    def __init__(self, inputs: Inputs, values: Sequence[Any], table: Any = None) -> None:
        if all(isinstance(value, (float, int)) for value in values):
            row = np.array(values, dtype=np.float64)
            self.layout = Layout((), dict(zip(inputs.names, values)))
            self.rows = 1
            self._columns = [(r, row[k : k + 1]) for k, r in enumerate(inputs.references)]
            return
        given: dict[str, Any] = dict(zip(inputs.names, values))
        dims: tuple[str, ...] | None = None
        coords: dict[str, Any] | None = None
        if any(hasattr(value, "dims") and hasattr(value, "coords") for value in values):
            given, dims, coords = _aligned(given)
        arrays = {name: numbers(name, value) for name, value in given.items()}
        try:
            shape = np.broadcast_shapes(*(a.shape for a in arrays.values()))
        except ValueError:
            shapes = ", ".join(f"{name} {a.shape}" for name, a in arrays.items())
            raise BadValueError(f"inputs do not broadcast together: {shapes}") from None
        index = getattr(table, "index", None)
        self.layout = Layout(shape, arrays, dims, coords, index if len(shape) == 1 else None)
        self.rows = int(np.prod(shape, dtype=np.int64))
        self._columns = [
            # One number stands for a column without taking the room of one.
            (r, np.broadcast_to(a, shape).ravel() if a.size != 1 else a.reshape(1))
            for r, a in zip(inputs.references, arrays.values())
        ]

    def repeat(self, rows: int) -> None:
        """Takes the one row there is for as many."""
        self.layout = Layout((rows,), self.layout.inputs)
        self.rows = rows

    def columns(self, rows: slice) -> list[tuple[int, npt.NDArray[np.float64]]]:
        """The columns of some rows."""
        count = rows.stop - rows.start
        if count == self.rows == 1:
            return self._columns
        return [
            (r, np.full(count, column[0]) if column.size == 1 else column[rows])
            for r, column in self._columns
        ]


def numbers(name: str, value: Any) -> npt.NDArray[np.float64]:
    """The value as an array of numbers."""
    if np.ma.is_masked(value):
        raise BadValueError(
            f"{name} has masked elements: leave these rows out, or fill them", variable=name
        )
    try:
        array = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise BadValueError(f"{name} is no array of numbers: {error}", variable=name) from None
    return array


def _aligned(
    given: Mapping[str, Any],
) -> tuple[dict[str, Any], tuple[str, ...], dict[str, Any]]:
    """DataArrays broadcast by the names of their dimensions."""
    import xarray

    labelled = {n: v for n, v in given.items() if isinstance(v, xarray.DataArray)}
    for name, value in given.items():
        if name not in labelled and np.ndim(value) > 0:
            raise BadValueError(
                f"{name} is an array without names of dimensions beside DataArrays: make it one",
                variable=name,
            )
    together = xarray.broadcast(*labelled.values())
    first = together[0]
    dims = tuple(str(d) for d in first.dims)
    coords = {str(d): first.coords[d] for d in first.dims if d in first.coords}
    values = dict(given)
    values.update((n, v.values) for n, v in zip(labelled, together))
    return values, dims, coords
