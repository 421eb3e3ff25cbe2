"""Tables of cases: inputs and parameters in columns."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ._element import Element, Errors, Outputs, Remarks, WheelSet, _Unit
from ._slices import Progress, teller
from ._variables import Unit, Variable, find, is_evaluated, select, variables
from .errors import BadValueError, ContactWarning

if TYPE_CHECKING:
    import pandas

__all__ = ["evaluate"]

#: Name of the column that says which rows were not refused.
VALID = "valid"
#: Name of the column that is no variable: it says which row is which.
LABEL = "id"


def is_label(name: Any) -> bool:
    """Whether a column only says which row is which."""
    return str(name).lower() == LABEL


def outputs_of(
    unit: Unit, outputs: Outputs, columns: Iterable[str], parameters: Mapping[str, Any]
) -> list[Variable]:
    """The outputs of a table, the same for all of its rows."""
    default = [v.name for v in variables(unit) if is_evaluated(v)]
    given = {find(unit, str(name)).name for name in (*columns, *parameters)}
    # Where any row may have a second rail, all tell of it.
    second = any(name.endswith("rail[2].enabled") for name in given)
    skipped = tuple(f"patch[{k}]." for k in range(3, 9)) + (() if second else ("rail[2].",))
    shown = [n for n in default if not any(part in n for part in skipped)]
    return select(unit, outputs, lambda: shown)


def evaluate(
    table: pandas.DataFrame,
    *,
    unit: Unit = "WheelRail",
    outputs: Outputs = None,
    inputs: bool = True,
    threads: int | None = None,
    errors: Errors = "raise",
    progress: Progress = None,
    **parameters: Any,
) -> pandas.DataFrame:
    """A table of cases in, the same table with the outputs behind its columns out; needs pandas.

    Columns may be parameters too, other ones in every row: profiles, radii, models. The rows that share
    them are evaluated together.

    Parameters
    ----------
    table : DataFrame
        One row for each case; columns are inputs and parameters by FMI name or keyword. What is left out
        keeps its start value. A column ``id`` is passed on.
    unit : {"WheelRail", "WheelSet"}
        One wheel, or two on an axle.
    inputs : bool
        Whether the columns of `table` stand in front.
    outputs, threads, errors, progress
        As in `Element.evaluate`.
    **parameters
        Values that hold for all rows.

    Returns
    -------
    DataFrame
        With the index of `table`. With ``errors="nan"`` a boolean column ``valid`` says which
        rows were not refused.
    """
    import pandas

    tell, close = teller(progress, len(table))
    try:
        found = outputs_for(
            table, unit=unit, outputs=outputs, threads=threads, errors=errors, tell=tell, **parameters
        )
    finally:
        close()
    return pandas.concat([table, found], axis=1) if inputs else found


def outputs_for(
    table: pandas.DataFrame,
    *,
    unit: Unit,
    outputs: Outputs,
    threads: int | None,
    errors: Errors,
    tell: Callable[[int], object] = lambda done: None,
    **parameters: Any,
) -> pandas.DataFrame:
    """The outputs for a table of cases; `tell` gets how many rows are done."""
    import pandas

    if not isinstance(table, pandas.DataFrame):
        raise BadValueError(
            f"table is a {type(table).__name__}: it takes a DataFrame", variable="table"
        )
    found = {name: find(unit, str(name)) for name in table.columns if not is_label(name)}
    of_parameters = [name for name, v in found.items() if v.causality == "parameter"]
    of_inputs = [name for name, v in found.items() if v.causality == "input"]
    for name, v in found.items():
        if v.causality not in ("parameter", "input"):
            raise BadValueError(f'column "{name}" is computed: leave it out', variable=v.name)
    if of_parameters:
        kinds: dict[tuple[Any, ...], list[int]] = {}
        for row, key in enumerate(zip(*(table[name].tolist() for name in of_parameters))):
            # Nothing equals NaN, which stands for an empty cell.
            kinds.setdefault(tuple(None if v != v else v for v in key), []).append(row)
        groups = [(key, np.array(members)) for key, members in kinds.items()]
    else:
        groups = [((), np.arange(len(table)))]
    wanted = [v.name for v in outputs_of(unit, outputs, found, parameters)]
    remarks = Remarks()
    parts: list[pandas.DataFrame] = []
    places: list[Any] = []
    done = 0
    for key, members in groups:
        settings = {**parameters, **dict(zip(of_parameters, key))}
        element = _element(unit, settings)
        inputs = {name: table[name].to_numpy()[members] for name in of_inputs}
        try:
            result = element._evaluate(
                inputs, wanted, threads, errors, lambda rows, _: tell(done + rows), {}, tell=False
            )
        except Exception as error:
            raise _placed(error, members) from None
        of_all = list(range(len(members)))
        remarks.add([(*idle, of_all) for idle in element._idle(inputs)], 0, members)
        remarks.add(
            [(r.title, r.about, r.message, r.rows.tolist()) for r in result.remarks], 0, members
        )
        part = result.to_pandas(inputs=False)
        if not of_inputs:
            part = part.loc[part.index.repeat(len(members))]
        if errors == "nan":
            part[VALID] = np.broadcast_to(result.valid, (len(members),))
        parts.append(part)
        places.append(members)
        done += len(members)
        tell(done)
    for remark in remarks.found():
        warnings.warn(remark.text(len(table)), ContactWarning, stacklevel=3)
    if not parts:
        return empty(unit, outputs, found, parameters, errors).set_index(table.index)
    whole = pandas.concat(parts, ignore_index=True)
    order = np.empty(len(table), dtype=np.intp)
    order[np.concatenate(places)] = np.arange(len(table))
    whole = whole.iloc[order]
    whole.index = table.index
    return whole


def empty(
    unit: Unit,
    outputs: Outputs,
    columns: Iterable[str],
    parameters: Mapping[str, Any],
    errors: Errors,
) -> pandas.DataFrame:
    """The table of results of a table without rows."""
    import pandas

    wanted = outputs_of(unit, outputs, columns, parameters)
    made = {v.name: np.empty(0, np.int64 if v.kind == "integer" else np.float64) for v in wanted}
    return pandas.DataFrame({**made, **({VALID: np.empty(0, np.bool_)} if errors == "nan" else {})})


def _element(unit: Unit, settings: dict[str, Any]) -> _Unit:
    # An empty cell keeps the start value.
    given = {n: _plain(v) for n, v in settings.items() if not (v is None or v != v)}
    return Element(given) if unit == "WheelRail" else WheelSet(given)


def _plain(value: Any) -> Any:
    """A number of numpy as one of Python."""
    return value.item() if isinstance(value, np.generic) else value


def _placed(error: Exception, members: Any) -> Exception:
    row = getattr(error, "row", None)
    if row is None:
        return error
    kind: Any = type(error)
    placed: Exception = kind(error._message, variable=error.variable, row=int(members[row]))  # type: ignore[attr-defined]
    return placed
