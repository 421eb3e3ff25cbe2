"""Stresses below the surface: shapes, names, closed forms and what is refused."""

import numpy as np
import pytest
import wheelrail
from wheelrail import planar, subsurface


def hertz(**more):
    y = np.linspace(-8e-3, 8e-3, 101)
    # Two equal radii of curvature: a circle.
    given = {"radius": 0.3, "load": 2e4, "wheel_poisson_ratio": 0.3, "rail_poisson_ratio": 0.3}
    return (y, y**2 / 0.6), given | more


def test_a_circle_has_the_stresses_of_hertz():
    points, given = hertz(tangential_model="none")
    load = subsurface.below(*points, **given)
    p0 = load.max_pressure
    found = load.greatest("von_mises")
    assert found.value / p0 == pytest.approx(0.620, rel=0.02)
    (x0, x1), _ = load.extent
    a = 0.5 * (x1 - x0)
    assert found.depth / a == pytest.approx(0.48, rel=0.05)
    line = load.states(0.0, 0.0, np.linspace(0.0, 3 * a, 31))
    assert line.shape == (31,)
    assert np.all(np.diff(np.abs(line.sigma_zz)) < 0)
    assert line.stress.shape == (31, 3, 3)
    assert np.allclose(np.trace(line.stress, axis1=1, axis2=2) / 3, line.hydrostatic)
    eigenvalues = np.linalg.eigvalsh(line.stress)
    assert np.allclose(eigenvalues[:, 2] - eigenvalues[:, 0], line.tresca, atol=1e-6 * p0)
    assert line.displacement.shape == (31, 3)
    one = load.states(0.0, 0.0, a)
    assert isinstance(one.von_mises, float) and one.stress.shape == (3, 3)


def test_a_grid_has_the_names_of_its_axes():
    points, given = hertz()
    load = subsurface.below(*points, **given)
    x, y, depth = np.linspace(-3e-3, 3e-3, 7), np.linspace(-2e-3, 2e-3, 5), np.array([0.0, 1e-3])
    grid = load.grid(x, y, depth, threads=2)
    assert grid.shape == (7, 5, 2)
    assert grid["von_mises"][3, 2, 1] == load.states(x[3], y[2], depth[1]).von_mises
    xarray = pytest.importorskip("xarray")
    data = grid.to_xarray()
    assert isinstance(data, xarray.Dataset)
    assert data.von_mises.dims == ("x", "y", "depth") and data.von_mises.attrs["units"] == "Pa"
    assert data.von_mises.sel(x=x[3], depth=1e-3).shape == (5,)


def test_a_passage_has_the_stress_of_dang_van():
    points, given = hertz(tangential_model="none")
    load = subsurface.below(*points, **given)
    p0, depth = load.max_pressure, np.linspace(0.2e-3, 3e-3, 15)
    found = load.dang_van(0.0, depth)
    assert found.shape == (15,)
    # A sixth of p0 is the estimate for ellipses.
    assert found.max() / p0 == pytest.approx(1 / 6, rel=0.15)
    assert isinstance(load.dang_van(0.0, 1e-3), float)
    pressed = load.dang_van(0.0, depth, residual=-3e8)
    assert np.allclose(found - pressed, 1e8)
    with pytest.raises(wheelrail.BadValueError, match="dang_van = -1"):
        load.dang_van(0.0, 1e-3, weight=-1.0)
    with pytest.raises(wheelrail.BadValueError, match="depth = -0.001"):
        load.dang_van(0.0, -1e-3)


def test_the_bodies_have_opposite_tractions():
    points, given = hertz(creepage_longitudinal=0.02, normal_strips=20)
    rail, wheel = (subsurface.below(*points, **given, body=body) for body in ("rail", "wheel"))
    at = (0.0, 0.0, 0.0)
    # The wheel is faster: the rail is drawn backwards under it, the wheel forwards over the rail.
    assert wheel.states(*at).sigma_xz > 0.0
    assert rail.states(*at).sigma_xz == pytest.approx(-wheel.states(*at).sigma_xz, rel=1e-9)
    own = subsurface.Load(
        planar.fields(*points, **given, normal_elements_along=20, normal_elements_across=20),
        body="rail",
        poisson_ratio=0.3,
    )
    assert own.states(*at).von_mises == pytest.approx(rail.states(*at).von_mises, rel=1e-6)


def test_an_element_loads_its_bodies():
    wheel = wheelrail.Element(motion="rolling", vx=20.0, rail_poisson_ratio=0.35)
    z = wheel.nominal_z + 1e-4
    loads = wheel.loads(z=z, y=0.75)
    assert len(loads) == len(wheel.contacts(z=z, y=0.75))
    assert loads[0].poisson_ratio == 0.35
    assert wheel.loads(z=z, y=0.75, body="wheel")[0].poisson_ratio == 0.28
    found = {m: loads[0].greatest(m) for m in ("von_mises", "tresca", "hydrostatic", "orthogonal_shear")}
    assert found["hydrostatic"].value < 0.0 < found["orthogonal_shear"].value < found["tresca"].value
    assert wheel.loads(z=z - 0.01, y=0.75) == []


def test_what_is_wrong_is_named():
    points, given = hertz()
    load = subsurface.below(*points, **given)
    with pytest.raises(wheelrail.BadValueError, match="row 1: depth = -0.001 is not admitted"):
        load.states(0.0, 0.0, [0.0, -1e-3])
    with pytest.raises(wheelrail.BadValueError, match='body = "sleeper"'):
        subsurface.below(*points, **given, body="sleeper")
    with pytest.raises(wheelrail.BadValueError, match='measure = "shear"'):
        load.greatest("shear")
    with pytest.raises(wheelrail.BadValueError, match="poisson_ratio = 0.7"):
        subsurface.Load([], poisson_ratio=0.7)
    assert subsurface.Load([]).greatest() is None and subsurface.Load([]).extent is None
    with pytest.raises(wheelrail.BadValueError, match="takes one case"):
        subsurface.below(*points, **given | {"load": [1e4, 2e4]})
