"""The native part: places are FMI references, rows are C-contiguous arrays that are filled."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any, final

import numpy as np
import numpy.typing as npt

__all__ = [
    "Places",
    "SteppedWheel",
    "SurfaceLoad",
    "TransientContact",
    "Wheel",
    "Wheelset",
    "__version__",
    "adjoint_of",
    "adjoint_parameters",
    "contacts_of",
    "displaced",
    "equivalent_conicity",
    "loads_of",
    "pack",
    "planar_fields",
    "planar_load",
    "planar_solve",
    "points_of",
    "profile_points",
    "rolling_radii",
    "variables",
]

__version__: str

_Floats = npt.NDArray[np.float64]
_States = npt.NDArray[np.uint8]
_Columns = Sequence[tuple[int, _Floats]]
_Settings = Sequence[tuple[str, Any]]
_Told = list[tuple[str, str, str, list[int]]]
_Found = tuple[dict[int, str], _Told]

@final
class Places: ...

@final
class Wheel:
    def __new__(cls, settings: _Settings, folders: Sequence[str]) -> Wheel: ...
    @property
    def nominal_z(self) -> float: ...
    def remarks(self) -> list[tuple[str, str]]: ...
    def without_effect(self, names: Sequence[str]) -> list[tuple[str, str, str]]: ...
    def evaluate(
        self,
        inputs: _Columns,
        outputs: Sequence[int],
        out: _Floats,
        states: _States,
        threads: int,
        tolerant: bool,
    ) -> _Found: ...
    @staticmethod
    def places(inputs: Sequence[int], outputs: Sequence[int]) -> Places: ...
    def evaluate_one(
        self, places: Places, inputs: tuple[Any, ...], tolerant: bool
    ) -> tuple[_Floats, int, str | None, _Told] | None: ...
    def jacobian(
        self,
        inputs: _Columns,
        outputs: Sequence[int],
        by: Sequence[int],
        out: _Floats,
        states: _States,
        threads: int,
        tolerant: bool,
    ) -> _Found: ...
    def touching_heights(
        self, inputs: _Columns, out: _Floats, states: _States, threads: int
    ) -> None: ...

@final
class Wheelset:
    def __new__(cls, settings: _Settings, folders: Sequence[str]) -> Wheelset: ...
    @property
    def nominal_z(self) -> float: ...
    def remarks(self) -> list[tuple[str, str]]: ...
    def without_effect(self, names: Sequence[str]) -> list[tuple[str, str, str]]: ...
    def evaluate(
        self,
        inputs: _Columns,
        outputs: Sequence[int],
        out: _Floats,
        states: _States,
        threads: int,
        tolerant: bool,
    ) -> _Found: ...
    @staticmethod
    def places(inputs: Sequence[int], outputs: Sequence[int]) -> Places: ...
    def evaluate_one(
        self, places: Places, inputs: tuple[Any, ...], tolerant: bool
    ) -> tuple[_Floats, int, str | None, _Told] | None: ...
    def jacobian(
        self,
        inputs: _Columns,
        outputs: Sequence[int],
        by: Sequence[int],
        out: _Floats,
        states: _States,
        threads: int,
        tolerant: bool,
    ) -> _Found: ...
    def touching_heights(
        self, inputs: _Columns, out: _Floats, states: _States, threads: int
    ) -> None: ...

@final
class SteppedWheel:
    def __new__(cls, settings: _Settings, folders: Sequence[str]) -> SteppedWheel: ...
    def advance(
        self, inputs: _Columns, durations: _Floats, outputs: Sequence[int], out: _Floats
    ) -> None: ...
    @property
    def history(self) -> _Floats: ...
    def set_history(self, numbers: _Floats) -> None: ...
    def fields(self, inputs: Sequence[tuple[int, float]]) -> list[dict[str, Any]]: ...
    def profile(self, body: int, count: int) -> _Floats: ...
    def depth(self, body: int) -> _Floats: ...

def adjoint_of(
    wheel: Wheel,
    inputs: _Columns,
    outputs: Sequence[int],
    weights: _Floats,
    by: Sequence[int],
    out: _Floats,
    points: Sequence[_Floats],
    states: _States,
    threads: int,
    tolerant: bool,
) -> _Found: ...
def adjoint_parameters() -> list[str]: ...
def points_of(wheel: Wheel, body: int) -> _Floats: ...
def displaced(wheel: Wheel, ways: Sequence[Sequence[float]], folders: Sequence[str]) -> Wheel: ...
def variables(unit: str) -> list[dict[str, Any]]: ...
def contacts_of(wheel: Wheel, inputs: Sequence[tuple[int, float]]) -> list[dict[str, Any]]: ...
def profile_points(
    name: str, body: str, smoothing: float, folders: Sequence[str], count: int
) -> _Floats: ...
def pack(
    source: Path,
    target: Path,
    profiles: Sequence[str | None],
    settings: Sequence[tuple[str, str]],
    name: str,
    description: str,
    dummy_state: bool,
) -> None: ...
def planar_solve(
    wheel: Wheel,
    separation: _Floats,
    cases: _Floats,
    by_load: bool,
    out: _Floats,
    states: _States,
    threads: int,
    tolerant: bool,
) -> dict[int, str]: ...
def planar_fields(
    wheel: Wheel, separation: _Floats, given: _Floats, by_load: bool
) -> list[dict[str, Any]]: ...
@final
class TransientContact:
    def __new__(cls, size: tuple[float, float] | None) -> TransientContact: ...
    def step(
        self,
        wheel: Wheel,
        separation: _Floats,
        given: _Floats,
        by_load: bool,
        rolled: float,
        shift: tuple[float, float, float],
        force: tuple[float | None, float | None],
    ) -> list[float]: ...
    def field(self) -> dict[str, Any] | None: ...
    @property
    def history(self) -> _Floats: ...
    def set_history(self, numbers: _Floats) -> None: ...

@final
class SurfaceLoad:
    def __new__(
        cls,
        fields: Sequence[tuple[tuple[float, float, float, float], _Floats, _Floats, _Floats]],
        is_wheel: bool,
        young_modulus: float,
        poisson_ratio: float,
        blunt: bool,
    ) -> SurfaceLoad: ...
    @property
    def constants(self) -> list[float]: ...
    @property
    def extent(self) -> list[list[float]] | None: ...
    def states(self, points: _Floats, out: _Floats, states: _States, threads: int) -> None: ...
    def dang_van(
        self, points: _Floats, out: _Floats, states: _States, strength: tuple[float, float], threads: int
    ) -> None: ...
    def greatest(self, measure: int) -> tuple[float, list[float], list[float]] | None: ...

def loads_of(
    wheel: Wheel, inputs: Sequence[tuple[int, float]], is_wheel: bool
) -> list[SurfaceLoad]: ...
def planar_load(
    wheel: Wheel, separation: _Floats, given: _Floats, by_load: bool, is_wheel: bool
) -> SurfaceLoad: ...
def rolling_radii(
    wheel: Wheel, running_circles: float, range: float, step: float, folders: Sequence[str]
) -> _Floats: ...
def equivalent_conicity(y: _Floats, difference: _Floats, amplitudes: _Floats) -> _Floats: ...
