"""Wheel and wheelset: arrays in, arrays out."""

from __future__ import annotations

import os
import time
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Union

import numpy as np
import numpy.typing as npt

from . import _native
from ._contact import Contact, contact_of
from ._files import folders
from ._result import REFUSED, Column, Jacobian, Layout, Remark, Result
from ._variables import Unit, Variable, by_name, find, is_evaluated, select, variables
from .errors import BadValueError, ContactWarning, admitted_count

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import ElementInputs, ElementParameters, WheelSetInputs, WheelSetParameters

__all__ = ["Element", "WheelSet"]

Errors = Literal["raise", "nan"]
Progress = Union[bool, Callable[[int, int], object], None]
Outputs = Union[Sequence[str], str, None]

#: Time that a call of the native part should take: between calls progress is told and Ctrl-C heard [s].
_SLICE = 0.2
#: Rows of each thread in the first of these calls: a second at most of boundary elements.
_FIRST_SLICE = 32


class _Unit:
    """What wheel and wheelset have in common."""

    _unit: ClassVar[Unit]

    def __init__(self, parameters: Mapping[str, Any] | None, keywords: Mapping[str, Any]) -> None:
        settings: dict[str, Any] = {}
        for name, value in [*(parameters or {}).items(), *keywords.items()]:
            variable = find(self._unit, name)
            if variable.causality not in ("input", "parameter"):
                raise BadValueError(
                    f'"{name}" is computed and cannot be set: see evaluate', variable=variable.name
                )
            if variable.name in settings:
                raise BadValueError(f"{variable.name} is given twice", variable=variable.name)
            settings[variable.name] = value
        self._settings = settings
        made = [(name, value) for name, value in settings.items()]
        self._native: Any = self._class()(made, folders())
        for name, remark in self._native.remarks():
            warnings.warn(f"{name}: {remark}", ContactWarning, stacklevel=3)
        self._tell_idle(settings)

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_"):
            raise AttributeError(
                f"{type(self).__name__} has no attribute {name} to set: inputs go to evaluate, parameters to "
                "a new element"
            )
        super().__setattr__(name, value)

    @classmethod
    def _class(cls) -> Any:
        return _native.Wheel if cls._unit == "WheelRail" else _native.Wheelset

    def __reduce__(self) -> tuple[Any, ...]:
        # Made anew where it arrives: profiles are named, not copied.
        return type(self), (self._settings,)

    def __repr__(self) -> str:
        shown = ", ".join(f"{find(self._unit, n).keyword}={v!r}" for n, v in self._settings.items())
        return f"wheelrail.{type(self).__name__}({shown})"

    @property
    def parameters(self) -> dict[str, Any]:
        """All parameters and starting inputs by FMI name: those given, and the start values of the others."""
        settable = (v for v in variables(self._unit) if v.causality in ("input", "parameter"))
        return {v.name: self._settings.get(v.name, v.start) for v in settable}

    @property
    def nominal_z(self) -> float:
        """Height of the marker at which it just touches at its starting y, roll and yaw [m]."""
        height: float = self._native.nominal_z
        return height

    def _default_outputs(self) -> list[str]:
        enabled = self.parameters
        second = any(enabled[name] for name in enabled if name.endswith("rail[2].enabled"))
        skipped = tuple(f"patch[{k}]." for k in range(3, 9)) + (() if second else ("rail[2].",))
        return [
            v.name
            for v in variables(self._unit)
            if is_evaluated(v) and not any(part in v.name for part in skipped)
        ]

    def _evaluate(
        self,
        table: Mapping[str, Any] | None,
        outputs: Outputs,
        threads: int | None,
        errors: Errors,
        progress: Progress,
        inputs: Mapping[str, Any],
        tell: bool = True,
    ) -> Result:
        given = _Given(self._unit, table, inputs)
        if tell:
            self._tell_idle(given.layout.inputs)
        wanted = select(self._unit, outputs, self._default_outputs())
        references = [v.reference for v in wanted]
        data = np.empty((given.rows, len(wanted)))
        states = np.zeros(given.rows, dtype=np.uint8)
        count, tolerant = _threads(threads), _is_tolerant(errors)
        refusals: dict[int, str] = {}
        remarks = Remarks()

        def work(rows: slice) -> None:
            found, told = self._native.evaluate(
                given.columns(rows), references, data[rows], states[rows], count, tolerant
            )
            refusals.update((rows.start + row, text) for row, text in sorted(found.items()))
            remarks.add(told, rows.start)

        in_slices(given.rows, work, count, progress)
        if tell:
            for remark in remarks.found():
                warnings.warn(remark.text(given.rows), ContactWarning, stacklevel=3)
        columns = [Column(v.name, v.unit, v.description, v.kind == "integer") for v in wanted]
        return Result(columns, data, states, refusals, given.layout, remarks.found())

    def _jacobian(
        self,
        table: Mapping[str, Any] | None,
        outputs: Outputs,
        by: Sequence[str] | str | None,
        threads: int | None,
        errors: Errors,
        progress: Progress,
        inputs: Mapping[str, Any],
    ) -> Jacobian:
        given = _Given(self._unit, table, inputs)
        self._tell_idle(given.layout.inputs)
        own = "wheel" if self._unit == "WheelRail" else "wheelset"
        wanted = select(self._unit, outputs, [f"{own}.force.*", f"{own}.moment.*"])
        for v in wanted:
            if v.kind != "real":
                raise BadValueError(
                    f"outputs: {v.name} is a count and has no derivatives", variable=v.name
                )
        if by is None:
            motions = "x y z roll yaw pitch vx vy vz roll_rate yaw_rate pitch_rate"
            by = [f"{own}.{motion}" for motion in motions.split()]
        directions = [_input(self._unit, n) for n in ([by] if isinstance(by, str) else by)]
        if not directions:
            raise BadValueError("by names no input", variable="by")
        shape = (len(wanted), len(directions))
        data = np.empty((given.rows, shape[0] * shape[1]))
        states = np.zeros(given.rows, dtype=np.uint8)
        count, tolerant = _threads(threads), _is_tolerant(errors)
        refusals: dict[int, str] = {}
        references = [v.reference for v in wanted], [v.reference for v in directions]

        def work(rows: slice) -> None:
            found, _ = self._native.jacobian(
                given.columns(rows), *references, data[rows], states[rows], count, tolerant
            )
            refusals.update((rows.start + row, text) for row, text in sorted(found.items()))

        in_slices(given.rows, work, count, progress)
        return Jacobian(
            data.reshape(*given.layout.shape, *shape),
            tuple(v.name for v in wanted),
            tuple(v.name for v in directions),
            (states != REFUSED).reshape(given.layout.shape),
            refusals,
            {name: v.name for name, v in by_name(self._unit).items()},
        )

    def _touching_height(self, threads: int | None, inputs: Mapping[str, Any]) -> Any:
        given = _Given(self._unit, None, inputs)
        data = np.empty((given.rows, 1))
        states = np.zeros(given.rows, dtype=np.uint8)
        count = _threads(threads)
        in_slices(
            given.rows,
            lambda rows: self._native.touching_heights(
                given.columns(rows), data[rows], states[rows], count
            ),
            count,
        )
        return data.reshape(given.layout.shape)[()]

    def _tell_idle(self, given: Iterable[str]) -> None:
        """Warns of inputs that have no effect with the parameters as they are."""
        for _, _, message in self._idle(given):
            warnings.warn(message, ContactWarning, stacklevel=4)

    def _idle(self, given: Iterable[str]) -> list[tuple[str, str, str]]:
        """Title, name and message for each of the inputs by name that has no effect."""
        found: list[tuple[str, str, str]] = self._native.without_effect(
            [find(self._unit, name).name for name in given]
        )
        return found


class Element(_Unit):
    """Contact of one wheel with the rails under it.

    Parameters
    ----------
    parameters : mapping, optional
        Values by FMI name, such as ``{"wheel.nominal_radius": 0.42}``.
    **keywords
        The same as keywords, dots as underscores and without brackets: ``wheel_nominal_radius=0.42``,
        ``rail1_profile="60E2"``, ``normal_model="strips"``. Inputs given here (``vx=20``,
        ``friction=0.4``) stay as they are where `evaluate` gives no others.
        :func:`wheelrail.variables` lists all with unit, range and start value.

    Raises
    ------
    ContactError
        The variable at fault, its value and what is admitted.

    Notes
    -----
    Track frame: x forward, y to the right, z down; SI and radians. Forces are those on the body they are
    named after. A wheel that rolls forward has a negative pitch rate, ``-vx / radius``.

    Examples
    --------
    >>> import wheelrail
    >>> wheel = wheelrail.Element(vertical_mode="load", vx=20.0, pitch_rate=-20.0 / 0.46)
    >>> result = wheel.evaluate(y=[0.748, 0.750], load=80e3)
    >>> result.shape
    (2,)
    """

    _unit = "WheelRail"

    def __init__(
        self,
        parameters: Mapping[str, Any] | None = None,
        /,
        **keywords: Unpack[ElementParameters],
    ) -> None:
        super().__init__(parameters, keywords)

    def evaluate(
        self,
        table: Mapping[str, Any] | None = None,
        /,
        *,
        outputs: Outputs = None,
        threads: int | None = None,
        errors: Errors = "raise",
        progress: Progress = None,
        **inputs: Unpack[ElementInputs],
    ) -> Result:
        """Forces and patches for arrays of inputs, on all cores and without the interpreter's lock.

        Parameters
        ----------
        table : mapping or DataFrame, optional
            Columns of inputs by FMI name or keyword.
        outputs : sequence of str, optional
            What to evaluate, by FMI name; ``*`` stands for anything: ``["wheel.force.*", "patch[1].*"]``.
            Without it everything but patches 3 to 8 and a second rail that is not there. For millions of
            rows name what is needed: a row takes 8 bytes for each.
        threads : int, optional
            Threads; all cores, or what the environment variable ``WHEELRAIL_NUM_THREADS`` says. The bits
            of the result do not depend on it.
        errors : {"raise", "nan"}
            What a row that is refused does: an error for the first one, or NaN, ``result.valid`` false and
            ``result.refusals`` with the reason.
        progress : bool or callable, optional
            Called as ``progress(rows_done, rows)``; True shows a bar by tqdm.
        **inputs : array_like
            Arrays that broadcast, ``float64`` in SI units: ``x, y, z, roll, yaw, pitch, vx, vy, vz,
            roll_rate, yaw_rate, pitch_rate`` of the wheel, ``rail1_y, rail1_z, …``, ``track_s, friction,
            load``. Those left out keep the value of the element.

        Returns
        -------
        Result
            Arrays of the shape that the inputs broadcast to.

        Raises
        ------
        ContactError
            The first row at fault with its variable and value.
        """
        return self._evaluate(table, outputs, threads, errors, progress, inputs)

    def jacobian(
        self,
        table: Mapping[str, Any] | None = None,
        /,
        *,
        outputs: Outputs = None,
        by: Sequence[str] | str | None = None,
        threads: int | None = None,
        errors: Errors = "raise",
        progress: Progress = None,
        **inputs: Unpack[ElementInputs],
    ) -> Jacobian:
        """Derivatives of outputs by inputs, exact but for rounding.

        Parameters
        ----------
        outputs : sequence of str, optional
            What is differentiated; without it force and moment on the wheel.
        by : sequence of str, optional
            By which inputs; without it the twelve of the wheel's motion.
        table, threads, errors, progress, **inputs
            As in `evaluate`.

        Returns
        -------
        Jacobian
            ``values`` of shape (..., outputs, inputs).

        Raises
        ------
        NoDerivativeError
            With models or at inputs without derivatives.
        """
        return self._jacobian(table, outputs, by, threads, errors, progress, inputs)

    def touching_height(
        self, *, threads: int | None = None, **inputs: Unpack[ElementInputs]
    ) -> Any:
        """Height z of the wheel marker at which the wheel, coming from above, just touches [m].

        Parameters
        ----------
        threads : int, optional
            As in `evaluate`.
        **inputs : array_like
            ``y``, ``roll``, ``yaw`` and the places of the rails; others have no effect.

        Returns
        -------
        ndarray
            Of the shape that the inputs broadcast to; NaN where the wheel stands beside its rails.
        """
        return self._touching_height(threads, inputs)

    def contacts(self, **inputs: Unpack[ElementInputs]) -> list[Contact]:
        """The contacts of one position, deepest first, with pressures and tractions element by element.

        Each contact is laid flat, without the shift of the contact line that yaw brings, as
        ``wheelrail plot`` of the command line does it.

        Parameters
        ----------
        **inputs : float
            As in `evaluate`, one number each.
        """
        given = _Given(self._unit, None, inputs)
        if given.rows != 1:
            raise BadValueError(f"contacts takes one position, not {given.rows}: see evaluate")
        one = [(reference, float(column[0])) for reference, column in given.columns(slice(0, 1))]
        return [contact_of(found) for found in _native.contacts_of(self._native, one)]


class WheelSet(_Unit):
    """Two wheels on one axle: motion of the centre in, forces on it and on both rails out.

    Parameters
    ----------
    parameters : mapping, optional
        Values by FMI name of ``WheelSet.fmu``, such as ``{"right.wheel.profile": "S1002"}``.
    **keywords
        The same as keywords: ``right_wheel_profile="S1002"``, ``normal_model="strips"``; see `Element`.

    Examples
    --------
    >>> import wheelrail
    >>> axle = wheelrail.WheelSet(vx=20.0, pitch_rate=-20.0 / 0.46)
    >>> result = axle.evaluate(z=axle.nominal_z + 1e-4, y=0.0)
    >>> abs(float(result["wheelset.force.y"])) < 1.0
    True
    """

    _unit = "WheelSet"

    def __init__(
        self,
        parameters: Mapping[str, Any] | None = None,
        /,
        **keywords: Unpack[WheelSetParameters],
    ) -> None:
        super().__init__(parameters, keywords)

    def evaluate(
        self,
        table: Mapping[str, Any] | None = None,
        /,
        *,
        outputs: Outputs = None,
        threads: int | None = None,
        errors: Errors = "raise",
        progress: Progress = None,
        **inputs: Unpack[WheelSetInputs],
    ) -> Result:
        """Forces and patches of both sides for arrays of inputs; all as in `Element.evaluate`.

        Parameters
        ----------
        **inputs : array_like
            ``x, y, z, roll, yaw, …`` of the centre, ``right_rail1_y``, ``left_friction``,
            ``right_wheel_load``, ``track_s`` and so on.
        table, outputs, threads, errors, progress
            As in `Element.evaluate`.
        """
        return self._evaluate(table, outputs, threads, errors, progress, inputs)

    def jacobian(
        self,
        table: Mapping[str, Any] | None = None,
        /,
        *,
        outputs: Outputs = None,
        by: Sequence[str] | str | None = None,
        threads: int | None = None,
        errors: Errors = "raise",
        progress: Progress = None,
        **inputs: Unpack[WheelSetInputs],
    ) -> Jacobian:
        """Derivatives of outputs by inputs.

        Parameters
        ----------
        table, outputs, by, threads, errors, progress, **inputs
            As in `Element.jacobian`; without them force and moment on the wheelset by the motion of its centre.
        """
        return self._jacobian(table, outputs, by, threads, errors, progress, inputs)

    def touching_height(
        self, *, threads: int | None = None, **inputs: Unpack[WheelSetInputs]
    ) -> Any:
        """Height z of the centre at which the first of the wheels touches [m].

        Parameters
        ----------
        threads, **inputs
            As in `Element.touching_height`, for the centre.
        """
        return self._touching_height(threads, inputs)


def _name_keywords(unit: type[_Unit]) -> None:
    """Lists the keywords of a class in its help, which cannot see them."""
    import textwrap

    all_of = variables(unit._unit)
    lines = [unit.__doc__ or "", "    Keywords", "    --------"]
    for title, causality in (("Inputs", "input"), ("Parameters", "parameter")):
        names = ", ".join(v.keyword for v in all_of if v.causality == causality)
        lines += [f"    {title}:", *textwrap.wrap(names, 88, initial_indent=" " * 8, subsequent_indent=" " * 8)]
    unit.__doc__ = "\n".join(lines) + "\n"


for _unit in (Element, WheelSet):
    _name_keywords(_unit)


class Remarks:
    """What is odd about the rows of a call, by kind."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, str], tuple[str, list[int]]] = {}

    def add(
        self,
        told: Iterable[tuple[str, str, str, list[int]]],
        start: int,
        members: npt.NDArray[np.intp] | None = None,
    ) -> None:
        """Takes what was found, by title and side or input, in the rows from `start` on; `members` are their numbers in the table."""
        for title, about, message, rows in told:
            _, all_rows = self._found.setdefault((title, about), (message, []))
            all_rows.extend(start + row if members is None else int(members[row]) for row in rows)

    def found(self) -> tuple[Remark, ...]:
        """All of it, in the order in which it was found."""
        return tuple(
            Remark(title, about, message, np.sort(np.array(rows, dtype=np.intp)))
            for (title, about), (message, rows) in self._found.items()
        )


class _Given:
    """Inputs of a call, broadcast."""

    def __init__(
        self, unit: Unit, table: Mapping[str, Any] | None, inputs: Mapping[str, Any]
    ) -> None:
        given: dict[str, Any] = {}
        references: list[int] = []
        if not (table is None or hasattr(table, "keys")):
            raise BadValueError(
                f"table is a {type(table).__name__}: it takes a mapping or a DataFrame; arrays are "
                "keywords, such as y=",
                variable="table",
            )
        pairs = [(str(name), table[name]) for name in table] if table is not None else []
        for name, value in [*pairs, *inputs.items()]:
            variable = _input(unit, name)
            if variable.name in given:
                raise BadValueError(f"{variable.name} is given twice", variable=variable.name)
            given[variable.name] = value
            references.append(variable.reference)
        dims: tuple[str, ...] | None = None
        coords: dict[str, Any] | None = None
        if any(hasattr(value, "dims") and hasattr(value, "coords") for value in given.values()):
            given, dims, coords = _aligned(given)
        arrays = {name: _numbers(name, value) for name, value in given.items()}
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
            for r, a in zip(references, arrays.values())
        ]

    def repeat(self, rows: int) -> None:
        """Takes the one row there is for as many."""
        self.layout = Layout((rows,), self.layout.inputs)
        self.rows = rows

    def columns(self, rows: slice) -> list[tuple[int, npt.NDArray[np.float64]]]:
        """The columns of some rows."""
        count = rows.stop - rows.start
        return [
            (r, np.full(count, column[0]) if column.size == 1 else column[rows])
            for r, column in self._columns
        ]


def in_slices(
    rows: int, work: Callable[[slice], None], threads: int, progress: Progress = None
) -> None:
    """Does the work slice by slice, each of about the same time."""
    tell, close = _teller(progress, rows)
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


def _teller(progress: Progress, rows: int) -> tuple[Callable[[int], object], Callable[[], object]]:
    """What tells how many rows are done, and what ends it."""
    if progress is None or progress is False:
        return (lambda done: None), (lambda: None)
    if progress is True:
        from tqdm.auto import tqdm

        bar = tqdm(total=rows or None, unit="contact", unit_scale=True)
        return (lambda done: bar.update(done - bar.n)), bar.close
    told = progress
    return (lambda done: told(done, rows)), (lambda: None)


def _input(unit: Unit, name: str) -> Variable:
    variable = find(unit, name)
    if variable.causality != "input":
        what = "a parameter: give it to the element" if variable.causality == "parameter" else "computed"
        raise BadValueError(f'"{name}" is no input, it is {what}', variable=variable.name)
    return variable


def _numbers(name: str, value: Any) -> npt.NDArray[np.float64]:
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


def _threads(threads: int | None) -> int:
    if threads is None:
        text = os.environ.get("WHEELRAIL_NUM_THREADS")
        if text is None:
            affinity = getattr(os, "sched_getaffinity", None)
            return len(affinity(0)) if affinity else os.cpu_count() or 1
        return admitted_count("WHEELRAIL_NUM_THREADS", int(text) if text.isdecimal() else text, 1)
    return admitted_count("threads", threads, 1)


def _is_tolerant(errors: str) -> bool:
    if errors not in ("raise", "nan"):
        raise BadValueError(f'errors = "{errors}" is not admitted: raise or nan', variable="errors")
    return errors == "nan"
