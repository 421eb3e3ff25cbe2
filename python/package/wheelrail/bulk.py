"""Tables larger than memory: read, evaluated and written piece by piece. Needs pandas, and pyarrow for Parquet."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from ._element import Errors, Outputs
from ._slices import Progress, teller
from ._table import outputs_for
from ._variables import Unit
from .errors import BadValueError, ContactError, admitted_count

if TYPE_CHECKING:
    import pandas

__all__ = ["evaluate"]


def evaluate(
    source: str | os.PathLike[str] | pandas.DataFrame | Iterable[pandas.DataFrame],
    target: str | os.PathLike[str],
    *,
    unit: Unit = "WheelRail",
    outputs: Outputs = None,
    inputs: bool = True,
    rows_at_once: int = 100_000,
    threads: int | None = None,
    errors: Errors = "raise",
    progress: Progress = None,
    **parameters: Any,
) -> int:
    """Evaluates a table of cases into a file, some rows at a time, so that memory stays bounded.

    Parameters
    ----------
    source : path, DataFrame or iterable of DataFrames
        CSV (lines that begin with ``#`` are comments; parted by commas, or by semicolons or tabs and then
        with decimal commas if they have them) or Parquet, columns as for `wheelrail.evaluate`; or tables
        at hand, or made one after the other.
    target : path
        ``.csv``, parted as the source is, with decimal points, or ``.parquet``; it gets its name when it is complete, until then it is ``TARGET.partial``.
    unit : {"WheelRail", "WheelSet"}
        One wheel, or two on an axle.
    outputs : sequence of str, optional
        As in `wheelrail.Element.evaluate`.
    inputs : bool
        Whether the columns of the source stand in front.
    rows_at_once : int
        Rows that are in memory at a time.
    threads, errors, progress
        As in `wheelrail.Element.evaluate`; the number of rows that progress is told is 0 where it is not
        known before.
    **parameters
        Values that hold for all rows.

    Returns
    -------
    int
        How many rows were evaluated.
    """
    import pandas

    rows_at_once = admitted_count("rows_at_once", rows_at_once, 1)
    path = Path(target)
    if isinstance(source, (str, os.PathLike)) and path.exists() and path.samefile(source):
        raise BadValueError(f"{path}: the result would take the place of its source", variable="target")
    partial = path.with_name(path.name + ".partial")
    style = _CsvStyle.of(source)
    writer = _writer(path, partial, style)
    pieces, count = _pieces(source, rows_at_once, style)
    tell, close = teller(progress, count)
    done = 0
    try:
        for piece in pieces:
            try:
                found = outputs_for(
                    piece, unit=unit, outputs=outputs, threads=threads, errors=errors, **parameters
                )
            except ContactError as error:
                if error.row is None:
                    raise
                row = done + error.row
                raise type(error)(error._message, variable=error.variable, row=row) from None
            writer.write(pandas.concat([piece, found], axis=1) if inputs else found)
            done += len(piece)
            tell(done)
    finally:
        close()
        writer.close()
    if not partial.exists():
        raise BadValueError("the source has no rows", variable="source")
    os.replace(partial, path)
    return done


class _CsvStyle(NamedTuple):
    """How a table is read: what parts its columns, and its decimal mark."""

    sep: str = ","
    decimal: str = "."

    @classmethod
    def of(cls, source: Any) -> _CsvStyle:
        """That of a file, as the command line reads it; that of the standard for all else."""
        if not isinstance(source, (str, os.PathLike)) or Path(source).suffix != ".csv":
            return cls()
        with open(source, encoding="utf-8-sig") as file:
            lines = (line for line in file if line.strip() and not line.startswith("#"))
            head, row = next(lines, ""), next(lines, "")
        sep = next((mark for mark in ";\t" if mark in head), ",")
        has_commas = sep != "," and re.search(r"\d,\d", row) is not None
        return cls(sep, "," if has_commas else ".")


def _pieces(source: Any, rows: int, style: _CsvStyle) -> tuple[Iterator[pandas.DataFrame], int]:
    """The tables to evaluate one after the other, and how many rows they have, 0 if that is not known."""
    import pandas

    if isinstance(source, pandas.DataFrame):
        return (source.iloc[k : k + rows] for k in range(0, len(source), rows)), len(source)
    if not isinstance(source, (str, os.PathLike)):
        return iter(source), 0
    path = Path(source)
    if path.suffix == ".parquet":
        import pyarrow.parquet

        file = pyarrow.parquet.ParquetFile(path)
        batches = file.iter_batches(batch_size=rows)
        return (batch.to_pandas() for batch in batches), file.metadata.num_rows
    if path.suffix == ".csv":
        options = {"comment": "#", "skipinitialspace": True, **style._asdict()}
        return iter(pandas.read_csv(path, chunksize=rows, **options)), 0
    raise BadValueError(f"{path}: a table is .csv or .parquet", variable="source")


class _CsvWriter:
    def __init__(self, path: Path, style: _CsvStyle) -> None:
        self._path = path
        self._style = style
        path.unlink(missing_ok=True)

    def write(self, table: pandas.DataFrame) -> None:
        is_new = not self._path.exists()
        table.to_csv(self._path, mode="a", header=is_new, index=False, sep=self._style.sep)

    def close(self) -> None:
        """Every piece is written when it comes."""


class _ParquetWriter:
    def __init__(self, path: Path) -> None:
        self._path = path
        self._writer: Any = None
        path.unlink(missing_ok=True)

    def write(self, table: pandas.DataFrame) -> None:
        import pyarrow
        import pyarrow.parquet

        piece = pyarrow.Table.from_pandas(table, preserve_index=False)
        if self._writer is None:
            self._writer = pyarrow.parquet.ParquetWriter(self._path, piece.schema)
        self._writer.write_table(piece)

    def close(self) -> None:
        if self._writer is not None:
            self._writer.close()


def _writer(path: Path, partial: Path, style: _CsvStyle) -> _CsvWriter | _ParquetWriter:
    if path.suffix == ".csv":
        return _CsvWriter(partial, style)
    if path.suffix == ".parquet":
        return _ParquetWriter(partial)
    raise BadValueError(f"{path}: a result is .csv or .parquet", variable="target")
