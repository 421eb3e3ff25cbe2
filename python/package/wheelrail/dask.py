"""Tables on many cores and machines by Dask: `pip install wheelrail[dask]`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._element import Errors, Outputs
from ._table import empty, outputs_for
from ._variables import Unit

if TYPE_CHECKING:
    import dask.dataframe

__all__ = ["evaluate"]


def evaluate(
    frame: dask.dataframe.DataFrame,
    *,
    unit: Unit = "WheelRail",
    outputs: Outputs = None,
    inputs: bool = True,
    threads: int = 1,
    errors: Errors = "raise",
    **parameters: Any,
) -> dask.dataframe.DataFrame:
    """Evaluates a Dask table of cases, partition by partition.

    Nothing is computed before Dask is asked to: ``.to_parquet(…)`` keeps memory bounded, ``.compute()``
    brings all to this machine. A partition whose worker is lost is computed anew by another; the bits are
    those of a serial run.

    Parameters
    ----------
    frame : dask.dataframe.DataFrame
        Columns as for `wheelrail.evaluate`.
    unit : {"WheelRail", "WheelSet"}
        One wheel, or two on an axle.
    outputs : sequence of str, optional
        As in `wheelrail.Element.evaluate`.
    inputs : bool
        Whether the columns of `frame` stand in front.
    threads : int
        Threads of each partition: workers of Dask are one for each core already.
    errors : {"raise", "nan"}
        As in `wheelrail.Element.evaluate`.
    **parameters
        Values that hold for all rows. Profiles from files have to lie where the workers run.

    Returns
    -------
    dask.dataframe.DataFrame
        With the partitions and the index of `frame`.
    """
    columns = [str(name) for name in frame.columns]
    meta: Any = empty(unit, outputs, columns, parameters, errors)
    if inputs:
        import pandas

        meta = pandas.concat([frame._meta, meta], axis=1)
    mapped: Any = frame.map_partitions
    found: dask.dataframe.DataFrame = mapped(
        _partition,
        meta=meta,
        keep=inputs,
        unit=unit,
        outputs=None if outputs is None else list([outputs] if isinstance(outputs, str) else outputs),
        threads=threads,
        errors=errors,
        **parameters,
    )
    return found


def _partition(table: Any, *, keep: bool, **options: Any) -> Any:
    import pandas

    found = outputs_for(table, **options)
    return pandas.concat([table, found], axis=1) if keep else found
