"""Wheel and wheelset: arrays in, arrays out."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, NamedTuple, Union, cast

import numpy as np
import numpy.typing as npt

from . import _native
from ._adjoint import BODIES, PARAMETERS, Adjoint
from ._contact import Contact, contact_of
from ._files import folders
from ._given import Given, Inputs, Kept, input_of, inputs_of, named
from ._load import Load, is_wheel
from ._result import REFUSED, Column, Columns, Jacobian, Layout, Remark, Result
from ._slices import NUM_THREADS, Progress, in_slices, is_tolerant, thread_count
from ._variables import Unit, Variable, find, fmi_names, is_evaluated, select, variables
from .errors import BadValueError, ContactWarning

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import (
        ElementInputs,
        ElementParameters,
        ElementResult,
        WheelSetInputs,
        WheelSetParameters,
        WheelSetResult,
    )

__all__ = ["Element", "WheelSet"]

Errors = Literal["raise", "nan"]
Outputs = Union[Sequence[str], str, None]

#: The motion of a wheel or wheelset, as keywords.
_MOTIONS = tuple("x y z roll yaw pitch vx vy vz roll_rate yaw_rate pitch_rate".split())
#: States of a result of one row, by the state of the row.
_STATE_OF_ONE = [np.array([state], dtype=np.uint8) for state in range(3)]
#: Names of outputs or directions as they are asked for, which a dictionary can hold.
Chosen = Union[tuple[str, ...], str, None]


class _Evaluation(NamedTuple):
    """Names of inputs and outputs of an evaluation, looked up."""

    inputs: Inputs
    #: FMI references of the outputs.
    references: list[int]
    columns: Columns
    #: The same for the native part.
    places: Any


class _Differentiation(NamedTuple):
    """Names of inputs, outputs and directions of a jacobian, looked up."""

    inputs: Inputs
    outputs: tuple[str, ...]
    by: tuple[str, ...]
    references: tuple[list[int], list[int]]


class _Unit:
    """What wheel and wheelset have in common."""

    _unit: ClassVar[Unit]

    def __init__(self, parameters: Mapping[str, Any] | None, keywords: Mapping[str, Any]) -> None:
        settings: dict[str, Any] = {}
        if not isinstance(parameters, Mapping | None):
            raise BadValueError(
                f"parameters = {parameters!r}: parameters are given by name, such as wheel_profile='S1002', or as a mapping"
            )
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
        # Parameters never change, and with them what names stand for.
        self._inputs_by_names: Kept[tuple[str, ...], Inputs] = Kept()
        self._evaluations: Kept[tuple[tuple[str, ...], Chosen], _Evaluation] = Kept()
        self._jacobians: Kept[tuple[tuple[str, ...], Chosen, Chosen], _Differentiation] = Kept()
        made = [(name, value) for name, value in settings.items()]
        self._native: Any = self._class()(made, folders())
        for name, remark in self._native.remarks():
            warnings.warn(f"{name}: {remark}", ContactWarning, stacklevel=3)
        for _, _, message in self._idle(settings):
            warnings.warn(message, ContactWarning, stacklevel=3)

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
        names, values = named(table, inputs)
        wanted = _chosen(outputs)
        call = self._evaluations.get((names, wanted)) or self._evaluation(names, wanted)
        if tell:
            for message in call.inputs.idle:
                warnings.warn(message, ContactWarning, stacklevel=3)
        tolerant = is_tolerant(errors)
        if progress is None or progress is False:
            if threads is not None or NUM_THREADS in os.environ:
                thread_count(threads)
            one = self._native.evaluate_one(call.places, values, tolerant)
            if one is not None:
                return _one_row(call, values, one, tell)
        given = Given(call.inputs, values, table)
        data = np.empty((given.rows, len(call.references)))
        states = np.zeros(given.rows, dtype=np.uint8)
        count = thread_count(threads)
        refusals: dict[int, str] = {}
        remarks = Remarks()

        def work(rows: slice) -> None:
            found, told = self._native.evaluate(
                given.columns(rows), call.references, data[rows], states[rows], count, tolerant
            )
            refusals.update((rows.start + row, text) for row, text in sorted(found.items()))
            remarks.add(told, rows.start)

        in_slices(given.rows, work, count, progress)
        if tell:
            for remark in remarks.found():
                warnings.warn(remark.text(given.rows), ContactWarning, stacklevel=3)
        return Result(call.columns, data, states, refusals, given.layout, remarks.found())

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
        names, values = named(table, inputs)
        wanted, directions = _chosen(outputs), _chosen(by)
        key = (names, wanted, directions)
        call = self._jacobians.get(key) or self._differentiation(*key)
        for message in call.inputs.idle:
            warnings.warn(message, ContactWarning, stacklevel=3)
        given = Given(call.inputs, values, table)
        shape = (len(call.outputs), len(call.by))
        data = np.empty((given.rows, shape[0] * shape[1]))
        states = np.zeros(given.rows, dtype=np.uint8)
        count, tolerant = thread_count(threads), is_tolerant(errors)
        refusals: dict[int, str] = {}

        def work(rows: slice) -> None:
            found, _ = self._native.jacobian(
                given.columns(rows), *call.references, data[rows], states[rows], count, tolerant
            )
            refusals.update((rows.start + row, text) for row, text in sorted(found.items()))

        in_slices(given.rows, work, count, progress)
        return Jacobian(
            data.reshape(*given.layout.shape, *shape),
            call.outputs,
            call.by,
            (states != REFUSED).reshape(given.layout.shape)[()],
            refusals,
            fmi_names(self._unit),
        )

    def _touching_height(self, threads: int | None, inputs: Mapping[str, Any]) -> Any:
        names, values = named(None, inputs)
        given = Given(self._inputs(names), values)
        data = np.empty((given.rows, 1))
        states = np.zeros(given.rows, dtype=np.uint8)
        count = thread_count(threads)
        in_slices(
            given.rows,
            lambda rows: self._native.touching_heights(
                given.columns(rows), data[rows], states[rows], count
            ),
            count,
        )
        return data.reshape(given.layout.shape) if given.layout.shape else data.item()

    def _inputs(self, names: tuple[str, ...]) -> Inputs:
        """The inputs of these names."""
        kept = self._inputs_by_names.get(names)
        if kept is None:
            found = inputs_of(self._unit, names)
            idle = tuple(message for _, _, message in self._idle(found))
            kept = Inputs(tuple(found), tuple(found.values()), idle)
            self._inputs_by_names.keep(names, kept)
        return kept

    def _evaluation(self, names: tuple[str, ...], outputs: Chosen) -> _Evaluation:
        inputs = self._inputs(names)
        wanted = select(self._unit, outputs, self._default_outputs)
        references = [v.reference for v in wanted]
        columns = columns_of(wanted)
        places = self._native.places(list(inputs.references), references)
        found = _Evaluation(inputs, references, columns, places)
        return self._evaluations.keep((names, outputs), found)

    def _differentiation(
        self, names: tuple[str, ...], outputs: Chosen, by: Chosen
    ) -> _Differentiation:
        inputs = self._inputs(names)
        own = "wheel" if self._unit == "WheelRail" else "wheelset"
        wanted = select(self._unit, outputs, lambda: [f"{own}.force.*", f"{own}.moment.*"])
        for v in wanted:
            if v.kind != "real":
                raise BadValueError(
                    f"outputs: {v.name} is a count and has no derivatives", variable=v.name
                )
        if by is None:
            directions: Iterable[str] = [f"{own}.{motion}" for motion in _MOTIONS]
        else:
            directions = [by] if isinstance(by, str) else by
        along = [input_of(self._unit, name) for name in directions]
        if not along:
            raise BadValueError("by names no input", variable="by")
        found = _Differentiation(
            inputs,
            tuple(v.name for v in wanted),
            tuple(v.name for v in along),
            ([v.reference for v in wanted], [v.reference for v in along]),
        )
        return self._jacobians.keep((names, outputs, by), found)

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
    #: Displacements of the points of all profiles, if there are any.
    _ways: list[list[float]] | None = None

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
    ) -> ElementResult:
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
            Arrays of the shape that the inputs broadcast to; numbers where every input is one.

        Raises
        ------
        ContactError
            The first row at fault with its variable and value.
        """
        found = self._evaluate(table, outputs, threads, errors, progress, inputs)
        # A name for type checkers: its quantities are those that were asked for.
        return cast("ElementResult", found)

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

    def adjoint(
        self,
        weights: npt.ArrayLike,
        table: Mapping[str, Any] | None = None,
        /,
        *,
        outputs: Outputs = None,
        by: Sequence[str] | str | None = None,
        threads: int | None = None,
        errors: Errors = "raise",
        progress: Progress = None,
        **inputs: Unpack[ElementInputs],
    ) -> Adjoint:
        """Derivatives of Σ weight · output by inputs, parameters and points of the profiles, all at once.

        What is called vector-Jacobian product or reverse mode: a row takes as long as some evaluations,
        however many derivatives there are.

        Parameters
        ----------
        weights : array_like, shape (..., outputs)
            Derivatives of what is wanted by the outputs; they broadcast against the rows.
        outputs : sequence of str, optional
            The outputs that the weights are of; without it force and moment on the wheel.
        by : sequence of str, optional
            By which inputs; without it the twelve of the wheel's motion and the friction.
        table, threads, errors, progress, **inputs
            As in `evaluate`.

        Returns
        -------
        Adjoint
            By inputs and parameters for each row, by points summed over all rows.

        Raises
        ------
        NoDerivativeError
            With models or at inputs without derivatives, as in `jacobian`.
        """
        names, values = named(table, inputs)
        along = [*_MOTIONS, "friction"] if by is None else [by] if isinstance(by, str) else list(by)
        call = self._differentiation(names, _chosen(outputs), tuple(along))
        given = Given(call.inputs, values, table)
        shape = (*given.layout.shape, len(call.outputs))
        weights = np.asarray(weights, dtype=np.float64)
        try:
            fits = weights.shape[-1:] == shape[-1:] and np.broadcast_shapes(weights.shape, shape) == shape
        except ValueError:
            fits = False
        if not fits:
            raise BadValueError(
                f"weights of shape {weights.shape}: one for each of {len(call.outputs)} outputs in the last axis, "
                f"and of shape {shape} or one that broadcasts to it"
            )
        weighted = np.ascontiguousarray(np.broadcast_to(weights, shape)).reshape(
            given.rows, len(call.outputs)
        )
        data = np.empty((given.rows, len(call.by) + len(PARAMETERS)))
        states = np.zeros(given.rows, dtype=np.uint8)
        points = tuple(np.zeros(len(self.points(body))) for body in BODIES)
        count, tolerant = thread_count(threads), is_tolerant(errors)
        refusals: dict[int, str] = {}

        def work(rows: slice) -> None:
            references, directions = call.references
            found, _ = _native.adjoint_of(
                self._native,
                given.columns(rows),
                references,
                weighted[rows],
                directions,
                data[rows],
                points,
                states[rows],
                count,
                tolerant,
            )
            refusals.update((rows.start + row, text) for row, text in sorted(found.items()))

        in_slices(given.rows, work, count, progress)
        return Adjoint(
            data.reshape(*given.layout.shape, data.shape[1]),
            (*call.by, *PARAMETERS),
            points,
            (states != REFUSED).reshape(given.layout.shape)[()],
            refusals,
            fmi_names(self._unit),
        )

    def points(self, body: Literal["wheel", "rail1", "rail2"]) -> npt.NDArray[np.float64]:
        """Points (y, z) of a profile, by which its surface can be displaced [m].

        Parameters
        ----------
        body : {"wheel", "rail1", "rail2"}
            Whose profile.

        Returns
        -------
        ndarray, shape (points, 2)
            Those of the file but for what was mended and smoothed; none of a profile that varies or is not
            there.
        """
        if body not in BODIES:
            raise BadValueError(f'body = "{body}" is not admitted: {", ".join(BODIES)}')
        found: npt.NDArray[np.float64] = _native.points_of(self._native, BODIES.index(body))
        return found

    def displaced(
        self,
        wheel: npt.ArrayLike | None = None,
        rail1: npt.ArrayLike | None = None,
        rail2: npt.ArrayLike | None = None,
    ) -> Element:
        """The element with the surfaces of its profiles displaced along their normals.

        Parameters
        ----------
        wheel, rail1, rail2 : array_like, optional
            Displacement of each of the `points`, out of the body (wear is negative) [m]; in between they
            are natural cubic splines.

        Returns
        -------
        Element
            Of the same parameters; displacements are those of the profiles as the parameters name them,
            and take the place of those that this element may have.
        """
        ways = [
            [] if way is None else np.asarray(way, dtype=np.float64).ravel().tolist()
            for way in (wheel, rail1, rail2)
        ]
        return _displaced(self._settings, ways)

    def __reduce__(self) -> tuple[Any, ...]:
        if self._ways is None:
            return super().__reduce__()
        return _displaced, (self._settings, self._ways)

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
        ndarray or float
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
        one = self._one_position("contacts", inputs)
        return [contact_of(found) for found in _native.contacts_of(self._native, one)]

    def loads(
        self, *, body: Literal["rail", "wheel"] = "rail", **inputs: Unpack[ElementInputs]
    ) -> list[Load]:
        """What the contacts of one position load the rail or the wheel with, deepest first: see `wheelrail.subsurface`.

        Each contact is laid flat, as by `contacts`; the material is that of the body. With a history tractions
        are those of steps: `wheelrail.TransientRun.loads`.

        Parameters
        ----------
        body : {"rail", "wheel"}
            The body below whose surface stresses are asked for.
        **inputs : float
            As in `evaluate`, one number each.
        """
        one = self._one_position("loads", inputs)
        return [Load._of(own) for own in _native.loads_of(self._native, one, is_wheel(body))]

    def _one_position(self, caller: str, inputs: Mapping[str, Any]) -> list[tuple[int, float]]:
        """References and values of inputs that are one number each."""
        names, values = named(None, inputs)
        given = Given(self._inputs(names), values)
        if given.rows != 1:
            raise BadValueError(f"{caller} takes one position, not {given.rows}: see evaluate")
        return [(reference, float(column[0])) for reference, column in given.columns(slice(0, 1))]


def _displaced(settings: Mapping[str, Any], ways: list[list[float]]) -> Element:
    """An element of these settings with displaced surfaces."""
    element = Element(settings)
    element._native = _native.displaced(element._native, ways, folders())
    element._ways = ways
    return element


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
    ) -> WheelSetResult:
        """Forces and patches of both sides for arrays of inputs; all as in `Element.evaluate`.

        Parameters
        ----------
        **inputs : array_like
            ``x, y, z, roll, yaw, …`` of the centre, ``right_rail1_y``, ``left_friction``,
            ``right_wheel_load``, ``track_s`` and so on.
        table, outputs, threads, errors, progress
            As in `Element.evaluate`.
        """
        found = self._evaluate(table, outputs, threads, errors, progress, inputs)
        return cast("WheelSetResult", found)

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


def _one_row(
    call: _Evaluation,
    values: tuple[Any, ...],
    one: tuple[npt.NDArray[np.float64], int, str | None, list[tuple[str, str, str, list[int]]]],
    tell: bool,
) -> Result:
    """The result of one row, from what the native part gives."""
    data, state, refusal, told = one
    remarks = Remarks()
    remarks.add(told, 0)
    found = remarks.found()
    if tell:
        for remark in found:
            warnings.warn(remark.text(1), ContactWarning, stacklevel=4)
    layout = Layout((), dict(zip(call.inputs.names, values)))
    refusals = {} if refusal is None else {0: refusal}
    return Result(call.columns, data, _STATE_OF_ONE[state], refusals, layout, found)


def columns_of(outputs: Iterable[Variable]) -> Columns:
    """The columns of these outputs."""
    return Columns(*(Column(v.name, v.unit, v.description, v.kind == "integer") for v in outputs))


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


def _chosen(names: Sequence[str] | str | None) -> Chosen:
    return names if names is None or isinstance(names, str) else tuple(names)
