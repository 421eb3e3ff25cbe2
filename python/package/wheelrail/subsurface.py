"""Displacements and stresses below the surface of a wheel or a rail in contact.

The body is a half-space under the pressure and the tractions of a contact: x along rolling, y to the
right, both from the contact point (of planar problems from the origin of the separation), the depth
from the surface into the body asked for, on the wheel upwards. Tension is positive; tractions act on this body.
`Load` is the load on one body: `wheelrail.Element.loads` gives those of the contacts of a wheel,
`below` that of a planar problem; it is made of fields of your own as well.
"""

from __future__ import annotations

from typing import Any

import numpy.typing as npt

from . import _native
from ._load import Body, Greatest, Load, States, is_wheel
from .planar import one_case

__all__ = ["Greatest", "Load", "States", "below"]


def below(
    y: npt.ArrayLike,
    f: npt.ArrayLike,
    *,
    radius: float,
    body: Body = "rail",
    approach: float | None = None,
    load: float | None = None,
    creepage_longitudinal: float = 0.0,
    creepage_lateral: float = 0.0,
    spin: float = 0.0,
    friction: float = 0.3,
    speed: float = 0.0,
    **parameters: Any,
) -> Load:
    """The load on one body in a planar problem, with the body's material.

    With strips the elements are as many across as there are strips and as many along as
    ``tangential_elements_along`` says; with boundary elements they are these.

    Parameters
    ----------
    y, f, radius, approach, load, creepage_longitudinal, creepage_lateral, spin, friction, speed, **parameters
        As in `wheelrail.planar.solve`, one number each.
    body : {"rail", "wheel"}
        The body below whose surface stresses are asked for.
    """
    separation, case, by_load, wheel = one_case(
        "below", y, f, radius, approach, load,
        (creepage_longitudinal, creepage_lateral, spin, friction, speed), parameters,
    )  # fmt: skip
    return Load._of(_native.planar_load(wheel._native, separation, case, by_load, is_wheel(body)))
