"""Work on rows slice by slice, in threads, with progress and Ctrl-C between slices."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from typing import Any, Union

from .errors import BadValueError, admitted_count

Progress = Union[bool, Callable[[int, int], object], None]

#: Time that a call of the native part should take: between calls progress is told and Ctrl-C heard [s].
_SLICE = 0.2
#: Rows of each thread in the first of these calls: a second at most of boundary elements.
_FIRST_SLICE = 32
#: The variable of the environment that says how many threads there are.
NUM_THREADS = "WHEELRAIL_NUM_THREADS"


def in_slices(
    rows: int, work: Callable[[slice], None], threads: int, progress: Progress = None
) -> None:
    """Does the work slice by slice, each of about the same time."""
    tell, close = teller(progress, rows)
    size, start = _FIRST_SLICE * threads, 0
    try:
        while start < rows:
            stop = min(start + size, rows)
            begin = time.perf_counter()
            try:
                work(slice(start, stop))
            except Exception as error:
                raise _moved(error, start) from None
            taken = time.perf_counter() - begin
            size = int(min(max(size * min(_SLICE / max(taken, 1e-9), 8.0), threads), 1 << 20))
            start = stop
            tell(start)
    finally:
        close()


def _moved(error: Exception, start: int) -> Exception:
    """The error with its row counted from the first slice."""
    row = getattr(error, "row", None)
    if row is None:
        return error
    kind: Any = type(error)
    moved: Exception = kind(error._message, variable=error.variable, row=row + start)  # type: ignore[attr-defined]
    return moved


def teller(progress: Progress, rows: int) -> tuple[Callable[[int], object], Callable[[], object]]:
    """What tells how many rows are done, and what ends it."""
    if progress is None or progress is False:
        return (lambda done: None), (lambda: None)
    if progress is True:
        from tqdm.auto import tqdm

        bar = tqdm(total=rows or None, unit="contact", unit_scale=True)
        return (lambda done: bar.update(done - bar.n)), bar.close
    told = progress
    return (lambda done: told(done, rows)), (lambda: None)


def thread_count(threads: int | None) -> int:
    """How many threads there are to be: those asked for, or what the environment says, or all cores."""
    if threads is None:
        text = os.environ.get(NUM_THREADS)
        if text is None:
            affinity = getattr(os, "sched_getaffinity", None)
            return len(affinity(0)) if affinity else os.cpu_count() or 1
        return admitted_count(NUM_THREADS, int(text) if text.isdecimal() else text, 1)
    return admitted_count("threads", threads, 1)


def is_tolerant(errors: str) -> bool:
    """Whether rows at fault become NaN and the others go on."""
    if errors not in ("raise", "nan"):
        raise BadValueError(f'errors = "{errors}" is not admitted: raise or nan', variable="errors")
    return errors == "nan"
