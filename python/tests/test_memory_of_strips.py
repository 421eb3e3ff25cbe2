"""What tractions on strips would remember: full adhesion on a circle that rolls with a creepage that oscillates.

docs/theory.md, contact with memory. Displacements are in the direction of rolling, by tractions in it; a creepage w
displaces the particles that enter by w until they leave: u(x, t) - u(x + h, t - h/V) is the w of the way h.
"""

from typing import Any

import numpy as np
import numpy.typing as npt
from wheelrail import frequency

Array = npt.NDArray[Any]
POISSON = 0.28
#: Elements along and across.
COUNT = 20


def influence(x: Array, y: Array, size: float) -> Array:
    """Displacement at (x, y) of a square element, but for a factor (Cerruti)."""
    found = np.zeros(np.broadcast(x, y).shape)
    for sign_x in (1, -1):
        for sign_y in (1, -1):
            # Beside the corners, on which logarithms have no value.
            at_x, at_y = x + 0.5 * sign_x * size + 1e-12, y + 0.5 * sign_y * size + 1e-12
            r = np.hypot(at_x, at_y)
            corner = (1 - POISSON) * at_x * np.log(at_y + r) + at_y * np.log(at_x + r)
            found += sign_x * sign_y * corner
    return found


class Circle:
    """Elements within a circle of diameter 1, strip by strip, the leading one of each first."""

    def __init__(self) -> None:
        self.size = 1.0 / COUNT
        centres = (np.arange(COUNT) + 0.5) * self.size - 0.5
        strips = [centres[centres**2 + y**2 < 0.25][::-1] for y in centres]
        self.x = np.concatenate(strips)
        self.strip = np.repeat(np.arange(COUNT), [len(strip) for strip in strips])
        self.y = centres[self.strip]
        leads = np.r_[True, self.strip[1:] != self.strip[:-1]]
        # What displaces elements, and the places ahead of the strips, from which particles come.
        places = np.r_[self.x, self.x[leads] + self.size], np.r_[self.y, self.y[leads]]
        self.placed = np.r_[self.strip, self.strip[leads]]
        self.places = places
        self.half_space = influence(places[0][:, None] - self.x, places[1][:, None] - self.y, self.size)
        count = len(self.x)
        ahead = count + np.cumsum(leads) - 1
        self.before = np.where(leads, ahead, np.arange(count) - 1)

    def tractions(self, influence: Array, ratio: float) -> Array:
        """Tractions under the creepage exp(i omega t), diameter over wave length `ratio`."""
        rate = 2j * np.pi * ratio
        late = np.exp(-rate * self.size)
        way = (1.0 - late) / rate if ratio else self.size
        count = len(self.x)
        return np.linalg.solve(influence[:count] - late * influence[self.before], np.full(count, way + 0j))

    def with_flexibilities(self, others: Array) -> Array:
        """Influence `others`, with flexibilities of the points such that steady tractions are the half-space's."""
        steady = self.tractions(self.half_space, 0.0).real
        left = (self.half_space - others) @ steady
        # Particles that enter carry nothing.
        ahead = self.before[np.searchsorted(self.strip, self.strip)]
        flexibility = (left[: len(self.x)] - left[ahead]) / steady
        found = others.copy()
        found[np.arange(len(self.x)), np.arange(len(self.x))] += flexibility
        return found

    def delay(self, influence: Array) -> float:
        """Mean delay of the force, over the diameter."""
        slow = 0.002
        forces = [self.tractions(influence, ratio).sum() for ratio in (slow, 0.0)]
        return float(-np.angle(forces[0] / forces[1]) / (2 * np.pi * slow))

    def response(self, influence: Array, ratio: float) -> complex:
        return complex(self.tractions(influence, ratio).sum() / self.tractions(influence, 0.0).sum())


def test_flexibilities_of_points_lag_by_half_as_much_as_the_half_space():
    circle = Circle()
    none = np.zeros_like(circle.half_space)
    own = circle.placed[:, None] == circle.strip
    # What strips do to each other as the half-space has it.
    between = np.where(own, 0.0, circle.half_space)
    # The same less what tractions as its own beside a strip would do to it: that is in flexibilities of marches.
    beyond = between.copy()
    centres = np.unique(circle.y)
    for y in centres:
        beside = influence(
            circle.places[0][:, None] - circle.x, circle.places[1][:, None] - y + 0.0 * circle.x, circle.size
        )
        beyond -= np.where(own & (circle.places[1] != y)[:, None], beside, 0.0)
    delays = {
        "half-space": circle.delay(circle.half_space),
        "points": circle.delay(circle.with_flexibilities(none)),
        "marches": circle.delay(circle.with_flexibilities(beyond)),
        "between": circle.delay(circle.with_flexibilities(between)),
    }
    print(delays)
    assert abs(delays["half-space"] - 0.74) < 0.01
    assert abs(delays["points"] - 0.32) < 0.01
    assert abs(delays["marches"] - 0.29) < 0.01
    assert abs(delays["between"] - 0.71) < 0.01
    # The elements are those of the package.
    y = np.linspace(-0.012, 0.012, 161)
    found = frequency.response(
        y, y**2 / 0.92, [0.1, 0.5], radius=0.46, load=6e4, normal_elements_along=20, normal_elements_across=20
    )  # fmt: skip
    for ratio, own_ratio in zip((0.1, 0.5), found.ratio("fx")):
        theirs = own_ratio.conjugate() if own_ratio.imag > 0 else own_ratio
        assert abs(circle.response(circle.half_space, ratio) - theirs) < 0.03


def test_no_flexibility_of_points_delays_by_more_than_half_the_length():
    # s from the leading edge, in strips of length 1: force int u/L ds, u = int_0^s w.
    s = (np.arange(4000) + 0.5) / 4000
    for weight, delay in [(1.0 + 0.0 * s, 1 / 3), (1.0 / np.sqrt(s * (1.0 - s)), 3 / 8), (s**40, 0.5)]:
        found = 0.5 * (s**2 * weight).sum() / (s * weight).sum()
        assert abs(found - delay) < 0.02 and found < 0.5
    # Over the strips of a circle with one flexibility.
    lengths = np.sqrt(1.0 - (2.0 * s - 1.0) ** 2)
    assert abs((lengths**3).sum() / 6 / ((lengths**2).sum() / 2) - 0.2945) < 1e-3
