"""Contact geometry of a wheelset over its lateral displacement, and equivalent conicity (EN 15302)."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native
from ._element import Element, WheelSet
from ._files import folders
from ._given import numbers
from ._result import Column, Columns, Layout, Result
from .errors import BadValueError

__all__ = ["contact_geometry", "equivalent", "table"]

_COLUMNS = Columns(
    Column("difference", "m", "Rolling radius difference, right less left"),
    Column("right.rolling_radius", "m", "Rolling radius of the right wheel"),
    Column("left.rolling_radius", "m", "Rolling radius of the left wheel"),
    Column("right.wheel_y", "m", "Contact point on the right wheel's profile, to the field side"),
    Column("left.wheel_y", "m", "Contact point on the left wheel's profile, to the field side"),
    Column("right.rail_y", "m", "Contact point on the right rail's profile, to the field side"),
    Column("left.rail_y", "m", "Contact point on the left rail's profile, to the field side"),
    Column("conicity", "", "Equivalent conicity of a motion of the amplitude y; NaN for y ≤ 0"),
)


class ConicityResult(Result):
    """What `table` gives."""

    difference: Any
    right_rolling_radius: Any
    left_rolling_radius: Any
    right_wheel_y: Any
    left_wheel_y: Any
    right_rail_y: Any
    left_rail_y: Any
    conicity: Any


class GeometryResult(ConicityResult):
    """What `contact_geometry` gives."""

    roll: Any
    z: Any
    right_contact_angle: Any
    left_contact_angle: Any


def table(
    *,
    range: float = 0.008,
    step: float = 1e-4,
    running_circles: float = 1.5,
    **parameters: Any,
) -> ConicityResult:
    """Rolling radii and equivalent conicity by EN 15302: rigid bodies, the wheelset does not roll about x.

    Parameters
    ----------
    range : float
        Greatest displacement to either side [m].
    step : float
        Step of the displacement [m].
    running_circles : float
        Distance of the nominal rolling circles [m].
    **parameters
        Of both wheels, as for `wheelrail.Element`: ``wheel_profile="S1002"``, ``rail1_inclination=0.05``.

    Returns
    -------
    Result
        Over the input ``y``, as far as both wheels stand on their rails: difference,
        right and left rolling_radius, wheel_y and rail_y, conicity.
    """
    for name, value in (("range", range), ("step", step)):
        if not (np.isfinite(value) and value > 0.0):
            raise BadValueError(f"{name} = {value} is not admitted: a finite number above 0", variable=name)
    if not 1.0 <= range / step <= 1e6:
        raise BadValueError(f"step = {step} is not admitted: range must hold 1 to 1e6", variable="step")
    wheel = Element(**parameters)
    radii = _native.rolling_radii(wheel._native, running_circles, range, step, folders())
    if len(radii) < 2:
        raise BadValueError("the wheels stand beside the rails: check track_gauge and running_circles")
    y, difference = radii[:, 0].copy(), radii[:, 1] - radii[:, 2]
    conicity = np.full(len(y), np.nan)
    swings = y > 0.5 * step
    conicity[swings] = equivalent(y, difference, y[swings])
    data = np.column_stack([difference, radii[:, 1:], conicity])
    return ConicityResult(_COLUMNS, data, np.zeros(len(y), np.uint8), {}, Layout(y.shape, {"y": y}))


def equivalent(
    y: npt.ArrayLike, difference: npt.ArrayLike, amplitude: npt.ArrayLike
) -> npt.NDArray[np.float64]:
    """Equivalent conicity tan γ of motions about the equilibrium nearest to y = 0.

    Parameters
    ----------
    y, difference : array_like, shape (n,)
        Rolling radius difference, right less left, over the displacement to the right, y growing [m].
    amplitude : array_like
        Amplitudes above 0 [m].

    Returns
    -------
    ndarray
        Of the shape of `amplitude` [-]: 0 where the wheelset does not swing, NaN where a turning point lies
        beyond the points or there is no equilibrium.
    """
    points = [np.ascontiguousarray(numbers(n, v).ravel()) for n, v in (("y", y), ("difference", difference))]
    amplitudes = numbers("amplitude", amplitude)
    found = _native.equivalent_conicity(points[0], points[1], np.ascontiguousarray(amplitudes.ravel()))
    return found.reshape(amplitudes.shape)


_GEOMETRY = Columns(
    Column("difference", "m", "Rolling radius difference, right less left"),
    Column("roll", "rad", "Roll of the axle"),
    Column("z", "m", "Height of the centre"),
    *(
        Column(f"{side}.{name}", unit, description)
        for side in ("right", "left")
        for name, unit, description in (
            ("rolling_radius", "m", "Rolling radius at the heaviest contact"),
            ("contact_angle", "rad", "Contact angle, in the track frame"),
            ("wheel_y", "m", "Contact point on the wheel's profile, to the field side"),
            ("rail_y", "m", "Contact point on the rail's profile, to the field side"),
        )
    ),
    Column("conicity", "", "Equivalent conicity of a motion of the amplitude y; NaN for y ≤ 0"),
)


def contact_geometry(
    y: npt.ArrayLike, *, yaw: float = 0.0, load: float = 1.0, **parameters: Any
) -> GeometryResult:
    """Contact geometry of a wheelset that stands on both rails, roll included.

    Parameters
    ----------
    y : array_like, shape (n,)
        Lateral displacement to the right, growing [m].
    yaw : float
        Yaw angle [rad].
    load : float
        Vertical load of each wheel [N]: at 1 N the bodies are as good as rigid.
    **parameters
        As for `wheelrail.WheelSet`.

    Returns
    -------
    Result
        Over the input ``wheelset.y``: difference, roll, z, of each side rolling_radius, contact_angle,
        wheel_y and rail_y, and conicity; NaN where a wheel stands beside its rail.
    """
    places = numbers("y", y).ravel()
    names = ("rolling_radius", "contact_angle", "wheel_y", "rail_y")
    heaviest = [f"{side}.patch[1].{name}" for side in ("right", "left") for name in names]
    axle = WheelSet({"vertical.mode": "load", **parameters})
    given: Any = {"right.wheel.load": load, "left.wheel.load": load}
    counts = ["right.patch_count", "left.patch_count"]
    # What stands beside its rails is NaN, and no remark.
    outputs = ["vertical.roll", "vertical.wheelset_z", *counts, *heaviest]
    found = axle._evaluate(given, outputs, None, "raise", None, {"y": places, "yaw": yaw}, tell=False)
    columns = [found[name] for name in heaviest]
    difference = columns[0] - columns[len(names)]
    conicity = np.full(places.shape, np.nan)
    stands = (found["right.patch_count"] > 0) & (found["left.patch_count"] > 0)
    if np.count_nonzero(stands) >= 2:
        swings = stands & (places > 0.0)
        conicity[swings] = equivalent(places[stands], difference[stands], places[swings])
    data = np.column_stack(
        [difference, found["vertical.roll"], found["vertical.wheelset_z"], *columns, conicity]
    )
    data[~stands] = np.nan
    states = np.zeros(places.size, np.uint8)
    return GeometryResult(_GEOMETRY, data, states, {}, Layout(places.shape, {"wheelset.y": places}))
