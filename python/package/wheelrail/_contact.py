"""Contacts and patches element by element."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["Contact", "Field"]

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class Field:
    """Pressure and tractions of a zone element by element, in the contact plane.

    Attributes
    ----------
    x : ndarray, shape (along,)
        Centres of the elements along rolling, the leading edge first [m].
    y : ndarray, shape (across,)
        Centres across, to the right [m].
    dx, dy : float
        Size of an element [m].
    pressure : ndarray, shape (across, along)
        Pressure [Pa].
    traction_x, traction_y : ndarray, shape (across, along)
        Traction on the wheel [Pa]; zero with models that have none to show.
    slip_x, slip_y : ndarray, shape (across, along), or None
        Slip of wheel against rail over the rolling speed, if the model has it [-].
    adherence : ndarray of uint8, shape (across, along)
        0 outside, 1 adhesion, 2 slip.
    """

    x: Array
    y: Array
    dx: float
    dy: float
    pressure: Array
    traction_x: Array
    traction_y: Array
    slip_x: Array | None
    slip_y: Array | None
    adherence: npt.NDArray[np.uint8]

    def __repr__(self) -> str:
        across, along = self.pressure.shape
        return (
            f"<wheelrail.Field: {along} x {across} elements, {1e-3 * self.normal_force:.1f} kN, "
            f"{1e-6 * float(self.pressure.max(initial=0.0)):.0f} MPa at most>"
        )

    @property
    def normal_force(self) -> float:
        """Sum of the pressure [N]."""
        return float(self.pressure.sum() * self.dx * self.dy)


@dataclass(frozen=True, eq=False, repr=False)
class Contact:
    """A contact of wheel and rail laid flat.

    Attributes
    ----------
    rail : int
        Number of the rail.
    contact_angle : float
        Roll of the contact frame about the track's x, negative on the right tread [rad].
    position : ndarray, shape (2,)
        Contact point in the track frame, y and z [m].
    radius : float
        Radius of the wheel's normal section along x [m].
    penetration : float
        Overlap of the undeformed bodies [m].
    creepage : ndarray, shape (3,)
        Longitudinal, lateral [-] and spin [1/m].
    separation : ndarray, shape (n, 2)
        Undeformed separation from the contact point: y, f [m].
    wheel, rail_head : ndarray, shape (n, 2)
        Outlines near the contact in the track frame: y, z [m].
    fields : list of Field
        One for each loaded zone, or one for all with boundary elements.
    """

    rail: int
    contact_angle: float
    position: Array
    radius: float
    penetration: float
    creepage: Array
    separation: Array
    wheel: Array
    rail_head: Array
    fields: list[Field] = field(default_factory=list)

    def __repr__(self) -> str:
        y, z = 1e3 * self.position
        return (
            f"<wheelrail.Contact: rail[{self.rail}] at y = {y:.1f}, z = {z:.2f} mm, "
            f"angle {np.degrees(self.contact_angle):.1f} deg, penetration {1e6 * self.penetration:.1f} um, "
            f"{len(self.fields)} zones>"
        )


def contact_of(found: dict[str, Any]) -> Contact:
    """A contact from what the native part gives."""
    fields = [Field(**one) for one in found.pop("fields")]
    return Contact(fields=fields, **found)
