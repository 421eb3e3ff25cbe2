"""Tables of cases: inputs and parameters in columns."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ._element import Element, Errors, Outputs, WheelSet, _Unit
from ._variables import Unit, find
from .errors import BadValueError

if TYPE_CHECKING:
    import pandas

__all__ = ["evaluate"]

def evaluate(
    table: pandas.DataFrame,
    *,
    unit: Unit = "WheelRail",
    outputs: Outputs = None,
    threads: int | None = None,
    errors: Errors = "raise",
    **parameters: Any,
) -> pandas.DataFrame:
    """A table of cases in, a table of outputs out; needs pandas.

    Columns may be parameters too, other ones in every row: profiles, radii, models. The rows that share
    them are evaluated together.

    Parameters
    ----------
    table : DataFrame
        One row for each case; columns are inputs and parameters by FMI name or keyword. What is left out
        keeps its start value.
    unit : {"WheelRail", "WheelSet"}
        One wheel, or two on an axle.
    outputs, threads, errors
        As in `Element.evaluate`.
    **parameters
        Values that hold for all rows.

    Returns
    -------
    DataFrame
        The outputs, with the index of `table`. With ``errors="nan"`` and rows that are refused, a boolean
        column ``valid`` says which are not.
    """
    import pandas

    found = {name: find(unit, str(name)) for name in table.columns}
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
    parts: list[pandas.DataFrame] = []
    places: list[Any] = []
    for key, members in groups:
        settings = {**parameters, **dict(zip(of_parameters, key))}
        element = _element(unit, settings)
        inputs = {name: table[name].to_numpy()[members] for name in of_inputs}
        try:
            result = element._evaluate(inputs, outputs, threads, errors, None, {})
        except Exception as error:
            raise _placed(error, members) from None
        part = result.to_pandas(inputs=False)
        if not of_inputs:
            part = part.loc[part.index.repeat(len(members))]
        if errors == "nan":
            part["valid"] = np.broadcast_to(result.valid, (len(members),))
        parts.append(part)
        places.append(members)
    if not parts:
        return pandas.DataFrame(index=table.index)
    whole = pandas.concat(parts, ignore_index=True)
    order = np.empty(len(table), dtype=np.intp)
    order[np.concatenate(places)] = np.arange(len(table))
    whole = whole.iloc[order]
    whole.index = table.index
    return whole


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
