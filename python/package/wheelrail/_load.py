"""The load of a contact on a wheel or a rail, and displacements and stresses below it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from . import _native
from ._contact import Field
from ._given import numbers
from ._result import Column, Columns, Layout, Result
from ._slices import in_slices, thread_count
from .errors import BadValueError

Body = Literal["wheel", "rail"]
Measure = Literal["von_mises", "tresca", "hydrostatic", "orthogonal_shear"]

_COLUMNS = Columns(
    Column("ux", "m", "Displacement along x"),
    Column("uy", "m", "Displacement along y"),
    Column("uz", "m", "Displacement into the body"),
    Column("sigma_xx", "Pa", "Normal stress along x"),
    Column("sigma_yy", "Pa", "Normal stress along y"),
    Column("sigma_zz", "Pa", "Normal stress along the depth"),
    Column("sigma_xy", "Pa", "Shear stress of x and y"),
    Column("sigma_yz", "Pa", "Shear stress of y and the depth"),
    Column("sigma_xz", "Pa", "Shear stress of x and the depth"),
    Column("von_mises", "Pa", "Equivalent stress of von Mises"),
    Column("tresca", "Pa", "Greatest less least principal stress, twice the greatest shear stress"),
    Column("hydrostatic", "Pa", "Mean of the normal stresses"),
    Column("orthogonal_shear", "Pa", "Greatest shear stress on the plane parallel to the surface"),
)
_MEASURES = ("von_mises", "tresca", "hydrostatic", "orthogonal_shear")


class States(Result):
    """Displacements and stresses at points: what `Load.states` and `Load.grid` give."""

    ux: Any
    uy: Any
    uz: Any
    sigma_xx: Any
    sigma_yy: Any
    sigma_zz: Any
    sigma_xy: Any
    sigma_yz: Any
    sigma_xz: Any
    von_mises: Any
    tresca: Any
    hydrostatic: Any
    orthogonal_shear: Any

    @property
    def stress(self) -> npt.NDArray[np.float64]:
        """Stress tensors, shape (..., 3, 3), axes x, y, depth [Pa]."""
        xx, yy, zz, xy, yz, xz = (np.asarray(self._data[:, k]) for k in range(3, 9))
        rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
        return np.moveaxis(np.array(rows), 2, 0).reshape(*self.shape, 3, 3)

    @property
    def displacement(self) -> npt.NDArray[np.float64]:
        """Displacements along x, y and into the body, shape (..., 3) [m]."""
        return self._data[:, :3].reshape(*self.shape, 3)


@dataclass(frozen=True)
class Greatest:
    """A greatest value and its place.

    Attributes
    ----------
    measure : str
        Of what.
    value : float
        The value [Pa]; of the hydrostatic stress that of greatest size, of either sign.
    x, y, depth : float
        Where [m].
    """

    measure: str
    value: float
    x: float
    y: float
    depth: float


class Load:
    """Pressure and tractions on the surface of a wheel or a rail, uniform on each element.

    Parameters
    ----------
    fields : Field or sequence of Field
        Pressures and tractions on the wheel, as `wheelrail.planar.fields` gives them or your own.
    body : {"rail", "wheel"}
        The body below whose surface stresses are asked for; the rail has the opposite tractions.
    young_modulus : float
        Of this body; displacements alone depend on it [Pa].
    poisson_ratio : float
        Of this body, 0 to 0.5 [-].
    blunt : bool
        Whether jumps between elements are those of a grid over smooth tractions, and spread on the surface;
        otherwise they are meant, and stresses have no bounds there.
    """

    def __init__(
        self,
        fields: Field | Sequence[Field],
        *,
        body: Body = "rail",
        young_modulus: float = 2.1e11,
        poisson_ratio: float = 0.28,
        blunt: bool = True,
    ) -> None:
        given = [fields] if isinstance(fields, Field) else list(fields)
        if not (np.isfinite(young_modulus) and young_modulus > 0.0):
            raise BadValueError(
                f"young_modulus = {young_modulus} is not admitted: greater than 0", variable="young_modulus"
            )
        if not 0.0 <= poisson_ratio <= 0.5:
            raise BadValueError(
                f"poisson_ratio = {poisson_ratio} is not admitted: 0 to 0.5", variable="poisson_ratio"
            )
        self._native = _native.SurfaceLoad(
            [_plain(field) for field in given],
            is_wheel(body),
            float(young_modulus),
            float(poisson_ratio),
            blunt,
        )

    @classmethod
    def _of(cls, native: _native.SurfaceLoad) -> Load:
        load = cls.__new__(cls)
        load._native = native
        return load

    @property
    def max_pressure(self) -> float:
        """Greatest pressure of an element, 0 without load [Pa]."""
        return self._native.constants[0]

    @property
    def young_modulus(self) -> float:
        """Young's modulus of the body [Pa]."""
        return self._native.constants[1]

    @property
    def poisson_ratio(self) -> float:
        """Poisson's ratio of the body [-]."""
        return self._native.constants[2]

    @property
    def extent(self) -> tuple[tuple[float, float], tuple[float, float]] | None:
        """Least and greatest x and y of the loaded elements; None without load [m]."""
        found = self._native.extent
        if found is None:
            return None
        (x0, x1), (y0, y1) = found
        return (x0, x1), (y0, y1)

    def states(
        self, x: npt.ArrayLike, y: npt.ArrayLike, depth: npt.ArrayLike, *, threads: int | None = None
    ) -> States:
        """Displacements and stresses at points, whose coordinates broadcast.

        On the surface they are the limits from inside. A vertical line is one x, one y and an array of depths.

        Parameters
        ----------
        x, y : array_like
            Places along rolling and to the right [m].
        depth : array_like
            Depths below the surface, at least 0 [m].
        threads : int, optional
            As in `wheelrail.Element.evaluate`.
        """
        given = {name: numbers(name, value) for name, value in (("x", x), ("y", y), ("depth", depth))}
        columns = np.broadcast_arrays(*given.values())
        points = np.ascontiguousarray(np.stack([c.ravel() for c in columns], axis=1))
        data = np.empty((len(points), len(_COLUMNS)))
        states = np.zeros(len(points), dtype=np.uint8)
        count = thread_count(threads)

        def work(rows: slice) -> None:
            self._native.states(points[rows], data[rows], states[rows], count)

        in_slices(len(points), work, count)
        return States(_COLUMNS, data, states, {}, Layout(columns[0].shape, given))

    def grid(
        self, x: npt.ArrayLike, y: npt.ArrayLike, depth: npt.ArrayLike, *, threads: int | None = None
    ) -> States:
        """The same at all points of a grid, arrays of shape (x, y, depth); `to_xarray` names its dimensions.

        Parameters
        ----------
        x, y, depth : array_like
            Coordinates along each axis [m].
        threads : int, optional
            As in `wheelrail.Element.evaluate`.
        """
        axes = [np.ravel(numbers(name, own)) for name, own in (("x", x), ("y", y), ("depth", depth))]
        found = self.states(axes[0][:, None, None], axes[1][:, None], axes[2], threads=threads)
        layout = Layout(found.shape, found.inputs, ("x", "y", "depth"), dict(zip(("x", "y", "depth"), axes)))
        return States(_COLUMNS, found._data, found._states, {}, layout)

    def dang_van(
        self,
        y: npt.ArrayLike,
        depth: npt.ArrayLike,
        *,
        weight: float = 1 / 3,
        residual: float = 0.0,
        threads: int | None = None,
    ) -> Any:
        """Equivalent stress of Dang Van over a passage of the contact, at places whose coordinates broadcast [Pa].

        The greatest shear stress of what varies, with `weight` times the hydrostatic stress, at the worst
        instant (docs/fatigue.md). Where the orthogonal shear stress is beyond the yield stress in shear the
        material does not shake down, and this is no measure of its life.

        Parameters
        ----------
        y : array_like
            Places to the right [m].
        depth : array_like
            Depths below the surface, at least 0 [m].
        weight : float
            Of the hydrostatic stress, at least 0 [-].
        residual : float
            Residual hydrostatic stress, tension positive [Pa].
        threads : int, optional
            As in `wheelrail.Element.evaluate`.
        """
        columns = np.broadcast_arrays(numbers("y", y), numbers("depth", depth))
        points = np.ascontiguousarray(np.stack([c.ravel() for c in columns], axis=1))
        data = np.empty(len(points))
        states = np.zeros(len(points), dtype=np.uint8)
        count = thread_count(threads)
        strength = (float(weight), float(residual))

        def work(rows: slice) -> None:
            self._native.dang_van(points[rows], data[rows], states[rows], strength, count)

        in_slices(len(points), work, count)
        found = data.reshape(columns[0].shape)
        return float(found) if found.ndim == 0 else found

    def greatest(self, measure: Measure = "von_mises") -> Greatest | None:
        """The greatest value in the body and its place, searched in the volume; None without load.

        Parameters
        ----------
        measure : {"von_mises", "tresca", "hydrostatic", "orthogonal_shear"}
            Of what.
        """
        if measure not in _MEASURES:
            raise BadValueError(
                f'measure = "{measure}" is not admitted: {", ".join(_MEASURES)}', variable="measure"
            )
        found = self._native.greatest(_MEASURES.index(measure))
        if found is None:
            return None
        value, (x, y, depth), _ = found
        return Greatest(measure, value, x, y, depth)

    def __repr__(self) -> str:
        return f"<wheelrail.subsurface.Load: {1e-6 * self.max_pressure:.0f} MPa at most>"


def is_wheel(body: str) -> bool:
    """Whether a body is the wheel; others than wheel and rail are refused."""
    if body not in ("wheel", "rail"):
        raise BadValueError(f'body = "{body}" is not admitted: wheel or rail', variable="body")
    return body == "wheel"


def _plain(
    field: Field,
) -> tuple[
    tuple[float, float, float, float],
    npt.NDArray[np.float64],
    npt.NDArray[np.float64],
    npt.NDArray[np.float64],
]:
    """A field as the native part takes it."""
    shape = (np.size(field.y), np.size(field.x))
    tables = []
    for name in ("pressure", "traction_x", "traction_y"):
        table = np.ascontiguousarray(getattr(field, name), dtype=np.float64)
        if table.shape != shape or not np.isfinite(table).all():
            raise BadValueError(
                f"{name}: finite numbers of shape {shape}, those of y and x, not {table.shape}", variable=name
            )
        tables.append(table)
    for name in ("dx", "dy"):
        if not (np.isfinite(getattr(field, name)) and getattr(field, name) > 0.0):
            raise BadValueError(f"{name} = {getattr(field, name)} is not admitted: greater than 0", variable=name)
    place = (float(field.x[0]), float(field.y[0]), float(field.dx), float(field.dy))
    return place, tables[0], tables[1], tables[2]
