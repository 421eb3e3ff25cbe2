"""Results: arrays by the names of the quantities."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from .errors import UnknownVariableError

if TYPE_CHECKING:
    import pandas
    import xarray

__all__ = ["Column", "Jacobian", "Remark", "Result"]

Array = npt.NDArray[Any]

#: States of rows in the native part.
FINE, REFUSED, SUNK = 0, 1, 2


@dataclass(frozen=True)
class Column:
    """A quantity of a result: its name, SI unit, and whether it is a whole number."""

    name: str
    unit: str
    description: str = ""
    is_integer: bool = False

    @property
    def keyword(self) -> str:
        """The name as an attribute of results."""
        return self.name.replace(".", "_").replace("[", "").replace("]", "")


class Columns:
    """The quantities of a result by their names, the same object for all results that have them."""

    def __init__(self, *columns: Column) -> None:
        placed = [(k, column) for k, column in enumerate(columns)]
        self.by_name = {column.name: (k, column) for k, column in placed}
        #: By names as attributes too.
        self.by_any_name = {column.keyword: (k, column) for k, column in placed} | self.by_name
        self.keywords = tuple(column.keyword for column in columns)

    def __len__(self) -> int:
        return len(self.by_name)


#: Rows and columns that a notebook shows of a result.
_SHOWN = (8, 8)
#: Row numbers that a warning names; the others are in `Remark.rows`.
_NAMED_ROWS = 4


@dataclass(frozen=True)
class Remark:
    """Something odd about rows of a result, the same that the FMU logs and the command line tells.

    Attributes
    ----------
    title : str
        The kind in a few words.
    about : str
        The side of a wheelset with a point behind, or the input without effect.
    message : str
        Cause, place and remedy, with the numbers of the first row.
    rows : ndarray of int
        The rows that have it, in C order.
    """

    title: str
    about: str
    message: str
    rows: npt.NDArray[np.intp]

    def text(self, count: int) -> str:
        """The message with its rows, of `count` rows in all."""
        if count == 1:
            return self.message
        named = ", ".join(str(row) for row in self.rows[:_NAMED_ROWS])
        more = ", …" if len(self.rows) > _NAMED_ROWS else ""
        return f"in {len(self.rows)} of {count} rows ({named}{more}): {self.message}"


class Layout(NamedTuple):
    """What the rows of a result stand for."""

    shape: tuple[int, ...]
    #: By FMI name arrays, or numbers where the result is of one.
    inputs: Mapping[str, Any]
    #: Names of the dimensions and coordinates along them, if the inputs had any.
    dims: tuple[str, ...] | None = None
    coords: Mapping[str, Any] | None = None
    #: Row labels of the table that was evaluated.
    index: Any = None


class Result(Mapping[str, Any]):
    """What an evaluation gives: a mapping from names to arrays of the shape that the inputs broadcast to.

    ``result["wheel.force.z"]`` and ``result.wheel_force_z`` are the same. Whole numbers are ``int64``, all
    else ``float64`` in SI units. Where every input is one number the shape is ``()``, and what is named is
    no array but a ``float``, or an ``int``. Where a row was refused (``errors="nan"``) numbers are NaN and
    whole numbers -1.
    """

    def __init__(
        self,
        columns: Columns,
        data: npt.NDArray[np.float64],
        states: npt.NDArray[np.uint8],
        refusals: Mapping[int, str],
        layout: Layout,
        remarks: tuple[Remark, ...] = (),
    ) -> None:
        self._remarks = remarks
        self._columns = columns
        self._data = data
        self._states = states
        self._layout = layout
        self._refusals = refusals

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of every array."""
        return self._layout.shape

    @property
    def inputs(self) -> Mapping[str, Any]:
        """The inputs that were given, by FMI name, broadcast to `shape`."""
        shape = self._layout.shape
        if not shape:
            return {name: float(v) for name, v in self._layout.inputs.items()}
        return {name: np.broadcast_to(v, shape) for name, v in self._layout.inputs.items()}

    @property
    def valid(self) -> Any:
        """Where the row was evaluated and not refused."""
        return np.asarray(self._states != REFUSED).reshape(self.shape)[()]

    @property
    def sunk(self) -> Any:
        """Where a wheel is so deep below the top of its rail that there is no force: no lifted wheel."""
        return np.asarray(self._states == SUNK).reshape(self.shape)[()]

    @property
    def refusals(self) -> Mapping[int, str]:
        """Why rows were refused, by their number in C order."""
        return self._refusals

    @property
    def remarks(self) -> tuple[Remark, ...]:
        """What is odd about rows, of each kind once: what the warnings of the call say."""
        return self._remarks

    @property
    def units(self) -> Mapping[str, str]:
        """SI unit of every quantity."""
        return {name: column.unit for name, (_, column) in self._columns.by_name.items()}

    def __getitem__(self, name: str) -> Any:
        found = self._columns.by_any_name.get(name)
        if found is None:
            import difflib

            near = difflib.get_close_matches(name, self._columns.by_name, n=1, cutoff=0.0)
            raise UnknownVariableError(
                f'the result has no "{name}"; the nearest name is {near[0] if near else "none"}; '
                "outputs= says what is evaluated",
                variable=name,
            )
        k, column = found
        if not self._layout.shape:
            number: float = self._data.item(0, k)
            if column.is_integer:
                return -1 if number != number else int(number)
            return number
        values = self._data[:, k]
        if column.is_integer:
            values = np.where(np.isnan(values), -1.0, values).astype(np.int64)
        return values.reshape(self.shape)

    if not TYPE_CHECKING:
        # Type checkers know the names of the classes below, and tell one that is none of them.
        def __getattr__(self, name: str) -> Any:
            # Called only for what is no attribute; names with a bar in front are Python's own.
            if name.startswith("_"):
                raise AttributeError(name)
            try:
                return self[name]
            except UnknownVariableError as error:
                raise AttributeError(str(error)) from None

    def __contains__(self, name: object) -> bool:
        return name in self._columns.by_any_name

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns.by_name)

    def __len__(self) -> int:
        return len(self._columns)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._columns.keywords})

    def __repr__(self) -> str:
        refused = int(np.count_nonzero(self._states == REFUSED))
        also = f", {refused} rows refused" if refused else ""
        return f"<wheelrail.Result: {len(self)} quantities of shape {self.shape}{also}>"

    def _repr_html_(self) -> str:
        """A small table for notebooks: the first rows and quantities, with units."""
        from html import escape

        rows = range(min(self._data.shape[0], _SHOWN[0]))
        given = [(name, "", np.ravel(values)) for name, values in self.inputs.items()]
        found = [(name, c.unit, self._data[:, k]) for name, (k, c) in self._columns.by_name.items()]
        shown = (given + found)[: _SHOWN[1]]
        head = "".join(f"<th>{escape(n)}{f' [{escape(u)}]' if u else ''}</th>" for n, u, _ in shown)
        body = "".join(
            f"<tr><th>{row}</th>{''.join(f'<td>{values[row]:.6g}</td>' for _, _, values in shown)}</tr>"
            for row in rows
        )
        return f"<table><tr><th></th>{head}</tr>{body}</table><p>{escape(repr(self)[1:-1])}</p>"

    def _ipython_key_completions_(self) -> list[str]:
        return list(self)

    def to_pandas(self, *, inputs: bool = True) -> pandas.DataFrame:
        """One row for each case, one column for each quantity; needs pandas.

        Parameters
        ----------
        inputs : bool
            Whether the inputs that were given stand in front.
        """
        import pandas

        columns: dict[str, Array] = {}
        if inputs:
            columns.update((name, np.ravel(v)) for name, v in self.inputs.items())
        columns.update((name, np.ravel(self[name])) for name in self)
        return pandas.DataFrame(columns, index=self._layout.index)

    def to_xarray(self) -> xarray.Dataset:
        """A dataset with the inputs that were given as coordinates; needs xarray.

        Dimensions are those of the inputs if any was a ``DataArray``; else an input that varies along
        one dimension alone gives its name to it, and others are ``dim_0``, ``dim_1``, …
        """
        import xarray

        dims, coords = self._layout.dims, dict(self._layout.coords or {})
        if dims is None:
            names = [f"dim_{k}" for k in range(len(self.shape))]
            for name, given in self._layout.inputs.items():
                values = np.asarray(given)
                along = [k - values.ndim for k, n in enumerate(values.shape) if n > 1]
                if len(along) == 1 and names[along[0]].startswith("dim_"):
                    names[along[0]] = name
                    coords[name] = (name, values.ravel())
            dims = tuple(names)
        for name, values in self.inputs.items():
            if name not in coords:
                is_one = np.size(self._layout.inputs[name]) == 1 and np.size(values)
                coords[name] = np.ravel(values)[0] if is_one else (dims, values)
        data = {
            name: (dims, np.asarray(self[name]), {"units": c.unit, "long_name": c.description})
            for name, (_, c) in self._columns.by_name.items()
        }
        return xarray.Dataset(data, coords=coords)

    def to_numpy(self) -> npt.NDArray[Any]:
        """A structured array of the shape of the result, one field for each quantity."""
        fields = [(n, np.int64 if c.is_integer else np.float64) for n, (_, c) in self._columns.by_name.items()]
        array = np.empty(self.shape, dtype=fields)
        for name in self:
            array[name] = self[name]
        return array


class Jacobian:
    """Derivatives of outputs by inputs.

    ``jacobian["wheel.force.y", "wheel.vy"]`` is an array of the shape that the inputs broadcast to, a
    ``float`` where every input is one number; keywords do as well as FMI names.

    Attributes
    ----------
    values : ndarray, shape (..., outputs, inputs)
        All derivatives, in the SI unit of the output over that of the input.
    outputs, inputs : tuple of str
        FMI names along the last two dimensions.
    valid : ndarray of bool
        Where there are derivatives; with ``errors="raise"`` everywhere.
    refusals : dict
        Why there are none, by row in C order.
    """

    def __init__(
        self,
        values: npt.NDArray[np.float64],
        outputs: tuple[str, ...],
        inputs: tuple[str, ...],
        valid: Any,
        refusals: Mapping[int, str],
        keywords: Mapping[str, str],
    ) -> None:
        self.values = values
        self.outputs = outputs
        self.inputs = inputs
        self.valid = valid
        self.refusals = dict(refusals)
        self._keywords = keywords

    def __getitem__(self, names: tuple[str, str]) -> Any:
        output, by = (self._keywords.get(name, name) for name in names)
        for name, known, what in ((output, self.outputs, "outputs"), (by, self.inputs, "by")):
            if name not in known:
                raise UnknownVariableError(
                    f'the jacobian has no "{name}": {what}= says what is in it', variable=name
                )
        found = self.values[..., self.outputs.index(output), self.inputs.index(by)]
        return found if found.ndim else found.item()

    def __repr__(self) -> str:
        return f"<wheelrail.Jacobian: {len(self.outputs)} outputs by {len(self.inputs)} inputs, shape {self.values.shape}>"
