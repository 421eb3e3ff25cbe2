"""How creep forces follow creepages and loads that oscillate.

Particles take what the contact did to them along, so that the force falls and lags where the way of a
period is not long against the contact: at corrugation, squeal, and where a wheel hunts fast on long
patches.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from ._given import numbers
from .errors import BadValueError
from .planar import Transient

__all__ = ["FrequencyResponse", "response"]

_Oscillating = Literal["longitudinal", "lateral", "spin", "load"]

_CREEPAGES = {
    "longitudinal": "creepage_longitudinal",
    "lateral": "creepage_lateral",
    "spin": "spin",
}
#: Lengths of the contact in which the beginning of an oscillation is forgotten [-].
_SETTLED = 3.0
#: A way after which any contact rolls steadily [m].
_FAR = 1e3
#: Least number of periods before the one that is looked at.
_PERIODS = 1
#: Least number of steps in a length of the contact: a step's input is its mean and the force that at its end, so
#: that a force that follows at once lags by half a step.
_STEPS_IN_LENGTH = 16


@dataclass(frozen=True)
class FrequencyResponse:
    """Amplitude and phase of the creep force on the wheel.

    Attributes
    ----------
    oscillating : str
        What oscillates.
    length_over_wave : ndarray, shape (n,)
        Length of the contact over the way rolled in a period, L/lambda [-].
    length : float
        Length of the contact, L [m].
    fx, fy : ndarray, shape (n,), complex
        Amplitude of the longitudinal and of the lateral force over that of the input, which goes as
        exp(i omega t): of a creepage [N], of spin [N m], of a load over the load [N].
    steady_fx, steady_fy : float
        The same for slow oscillation: derivatives of the steady force.
    """

    oscillating: str
    length_over_wave: npt.NDArray[np.float64]
    length: float
    fx: npt.NDArray[np.complex128]
    fy: npt.NDArray[np.complex128]
    steady_fx: float
    steady_fy: float

    def ratio(self, force: Literal["fx", "fy"]) -> npt.NDArray[np.complex128]:
        """The force over that of slow oscillation: its amplitude, and with a negative phase its lag [-]."""
        if force not in ("fx", "fy"):
            raise BadValueError(f'force = "{force}" is not admitted: fx or fy', variable="force")
        found: npt.NDArray[np.complex128] = getattr(self, force) / getattr(self, f"steady_{force}")
        return found


def response(
    y: npt.ArrayLike,
    f: npt.ArrayLike,
    length_over_wave: npt.ArrayLike,
    *,
    oscillating: _Oscillating = "longitudinal",
    amplitude: float | None = None,
    radius: float,
    load: float,
    creepage_longitudinal: float = 0.0,
    creepage_lateral: float = 0.0,
    spin: float = 0.0,
    friction: float = 0.3,
    samples: int = 32,
    **parameters: Any,
) -> FrequencyResponse:
    """Rolls a contact with one input that oscillates about its mean, for each wave length.

    The steps are those of `wheelrail.planar.Transient`. With a small amplitude about zero creepage the
    answer is that of full adhesion; about a creepage with slip it is that of the areas of slip and adhesion
    as they move.

    Parameters
    ----------
    y, f, radius, load, creepage_longitudinal, creepage_lateral, spin, friction
        The mean state, as for `wheelrail.planar.solve`.
    length_over_wave : array_like
        L/lambda of each oscillation, 0.01 to 10 [-].
    oscillating : {"longitudinal", "lateral", "spin", "load"}
        What oscillates.
    amplitude : float, optional
        Of a creepage [-], of spin [1/m] or of the load over the load [-]; otherwise small: 1e-5, 1e-5 over
        the contact's length, and 0.01.
    samples : int
        Least number of steps in a period, 8 or more; a length of the contact has 16.
    **parameters
        Materials and numbers of elements, as for `wheelrail.planar.Transient`.
    """
    if oscillating not in (*_CREEPAGES, "load"):
        allowed = "longitudinal, lateral, spin or load"
        raise BadValueError(f'oscillating = "{oscillating}" is not admitted: {allowed}', variable="oscillating")
    if not 8 <= samples <= 4096:
        raise BadValueError(f"samples = {samples} is not admitted: 8 to 4096", variable="samples")
    ratios = np.atleast_1d(numbers("length_over_wave", length_over_wave)).ravel()
    if not ((ratios >= 0.01) & (ratios <= 10.0)).all():
        worst = ratios[~((ratios >= 0.01) & (ratios <= 10.0))][0]
        raise BadValueError(
            f"length_over_wave = {worst} is not admitted: 0.01 to 10", variable="length_over_wave"
        )
    state = {
        "radius": float(radius),
        "load": float(load),
        "creepage_longitudinal": float(creepage_longitudinal),
        "creepage_lateral": float(creepage_lateral),
        "spin": float(spin),
        "friction": float(friction),
    }
    contact = Transient(**parameters)
    at_first = contact.step(y, f, **state, rolled=_FAR)
    length = at_first.length
    if length <= 0.0:
        raise BadValueError(f"load = {load} is not admitted: the bodies have to touch", variable="load")
    if amplitude is None:
        amplitude = {"spin": 1e-5 / length, "load": 1e-2}.get(oscillating, 1e-5)
    if not (math.isfinite(amplitude) and amplitude > 0.0):
        raise BadValueError(f"amplitude = {amplitude} is not admitted: greater than 0", variable="amplitude")

    def moved(by: float) -> dict[str, float]:
        if oscillating == "load":
            return {**state, "load": state["load"] * (1.0 + by)}
        name = _CREEPAGES[oscillating]
        return {**state, name: state[name] + by}

    ends = []
    for sign in (-1.0, 1.0):
        found = contact.step(y, f, **moved(sign * amplitude), rolled=_FAR)
        ends.append(np.array([found.fx, found.fy]))
    steady = (ends[1] - ends[0]) / (2.0 * amplitude)
    contact.step(y, f, **state, rolled=_FAR)
    rested = contact.history
    amplitudes = np.empty((len(ratios), 2), dtype=complex)
    for n, ratio in enumerate(ratios):
        contact.history = rested
        way = length / ratio
        before = max(_PERIODS, math.ceil(_SETTLED * ratio))
        count = max(samples, math.ceil(_STEPS_IN_LENGTH / ratio))
        phases = 2.0 * np.pi * np.arange(1, count + 1) / count
        forces = np.empty((count, 2))
        # A creepage acts over a step by its mean, a load is that at the end.
        step = 2.0 * np.pi / count
        means = (np.sin(phases) - np.sin(phases - step)) / step
        inputs = np.cos(phases) if oscillating == "load" else means
        for _ in range(before + 1):
            for k, by in enumerate(inputs):
                found = contact.step(y, f, **moved(amplitude * float(by)), rolled=way / count)
                forces[k] = found.fx, found.fy
        amplitudes[n] = 2.0 / count * (np.exp(-1j * phases) @ forces) / amplitude
    return FrequencyResponse(
        oscillating=oscillating,
        length_over_wave=ratios,
        length=length,
        fx=amplitudes[:, 0],
        fy=amplitudes[:, 1],
        steady_fx=float(steady[0]),
        steady_fy=float(steady[1]),
    )
