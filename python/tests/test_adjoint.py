"""Derivatives backwards: against those forwards, against displaced profiles, and in an optimiser's hands."""

import pickle

import numpy as np
import pytest
import wheelrail

ROLLING = {"vx": 20.0, "pitch_rate": -20.0 / 0.46}
#: Smooth models, so that differences have no kinks.
SMOOTH = {"normal_model": "piotrowski_kik", "tangential_model": "tables", **ROLLING}
OUTPUTS = ["wheel.force.x", "wheel.force.y", "wheel.force.z"]


@pytest.fixture(scope="module")
def wheel():
    return wheelrail.Element(**SMOOTH)


def places(wheel, count, seed=1):
    """Random places of a wheel in contact."""
    random = np.random.default_rng(seed)
    y = 0.75 + random.uniform(-6e-3, 6e-3, count)
    yaw = random.uniform(-5e-3, 5e-3, count)
    return {"y": y, "yaw": yaw, "z": wheel.touching_height(y=y, yaw=yaw) + 6e-5}


def test_by_inputs_it_is_the_transposed_jacobian(wheel):
    rows = places(wheel, 20)
    weights = np.random.default_rng(2).normal(size=(20, 3))
    by = ["z", "wheel.vy", "yaw", "friction"]
    jacobian = wheel.jacobian(**rows, outputs=OUTPUTS, by=by)
    found = wheel.adjoint(weights, **rows, outputs=OUTPUTS, by=by)
    wanted = np.einsum("no,noi->ni", weights, jacobian.values)
    scale = np.einsum("no,noi->ni", abs(weights), abs(jacobian.values))
    for k, name in enumerate(by):
        # Rounding of as many operations as there are.
        assert (abs(found[name] - wanted[:, k]) <= 1e-9 * scale[:, k]).all(), name
    one = wheel.adjoint(weights[3], **{name: column[3] for name, column in rows.items()}, outputs=OUTPUTS, by=by)
    assert isinstance(one["z"], float)
    assert one["z"] == found["z"][3]
    assert one["track.gauge"] == found["track.gauge"][3]
    threads = wheel.adjoint(weights, **rows, outputs=OUTPUTS, by=by, threads=1)
    assert threads.rail1_points.tobytes() == found.rail1_points.tobytes()


def test_by_points_it_is_what_displaced_profiles_differ_by(wheel):
    rows = places(wheel, 5)
    weights = np.array([0.3, 1.0, -0.2])
    found = wheel.adjoint(weights, **rows, outputs=OUTPUTS)
    for body, by in (("wheel", found.wheel_points), ("rail1", found.rail1_points)):
        points = wheel.points(body)
        assert by.shape == (len(points),)
        middle = points[np.argmax(abs(by))]
        bump = np.exp(-np.sum((points - middle) ** 2, axis=1) / 4e-3**2)

        def total(way, body=body, bump=bump):
            other = wheel.displaced(**{body: way * bump})
            forces = other.evaluate(**rows, outputs=OUTPUTS)
            return sum(w * forces[name].sum() for w, name in zip(weights, OUTPUTS))

        difference = (total(1e-8) - total(-1e-8)) / 2e-8
        # What central differences leave at this step.
        np.testing.assert_allclose(by @ bump, difference, rtol=1e-5)
    assert wheel.points("rail2").shape == (0, 2)


def test_a_displaced_element_is_copied_as_it_is(wheel):
    ways = -1e-5 * np.exp(-((wheel.points("rail1")[:, 0] / 5e-3) ** 2))
    worn = wheel.displaced(rail1=ways)
    rows = places(wheel, 3)
    again = pickle.loads(pickle.dumps(worn))
    assert again.evaluate(**rows).to_numpy().tobytes() == worn.evaluate(**rows).to_numpy().tobytes()
    assert worn.evaluate(**rows)["wheel.force.z"][0] != wheel.evaluate(**rows)["wheel.force.z"][0]
    with pytest.raises(wheelrail.BadValueError, match=r"displacements of rail\[1\].profile"):
        wheel.displaced(rail1=[0.0])


def test_what_has_none_says_so():
    rough = wheelrail.Element(normal_model="boundary_element", **ROLLING)
    with pytest.raises(wheelrail.NoDerivativeError, match="boundary_element"):
        rough.adjoint(np.ones(6), y=0.75)
    found = rough.adjoint(np.ones(6), y=[0.75, 0.751], errors="nan")
    assert not found.valid.any()
    assert np.isnan(found["wheel.y"]).all()
    assert (found.rail1_points == 0.0).all()
    assert len(found.refusals) == 2
    fine = wheelrail.Element(**SMOOTH)
    with pytest.raises(wheelrail.UnknownVariableError, match="track.foundation.mass"):
        fine.adjoint(np.ones(6), y=0.75)["track.foundation.mass"]
    with pytest.raises(ValueError, match="broadcast"):
        fine.adjoint(np.ones(5), y=0.75)


def test_weights_are_one_for_each_output(wheel):
    chosen = {"y": 0.75, "outputs": ["wheel.force.x", "wheel.force.y"]}
    for wrong in ([1.0], [1.0, 2.0, 3.0], 1.0, np.ones((3, 2))):
        with pytest.raises(wheelrail.ContactError, match="weights of shape"):
            wheel.adjoint(wrong, **chosen)


@pytest.mark.long
def test_as_a_custom_function_of_jax(wheel):
    """Friction that a network or anything else gives is fitted through the contact."""
    jax = pytest.importorskip("jax", reason="the extra jax is not installed")
    jnp = jax.numpy
    jax.config.update("jax_enable_x64", True)
    rows = places(wheel, 50)
    names = ("y", "friction")

    @jax.custom_vjp
    def forces(y, friction):
        def own(y, friction):
            found = wheel.evaluate(**{**rows, "y": y, "friction": friction}, outputs=OUTPUTS)
            return np.stack([found[name] for name in OUTPUTS], axis=-1)

        return jax.pure_callback(own, jax.ShapeDtypeStruct((50, 3), jnp.float64), y, friction)

    def forwards(y, friction):
        return forces(y, friction), (y, friction)

    def backwards(kept, by_forces):
        def own(y, friction, weights):
            given = {**rows, "y": y, "friction": friction}
            found = wheel.adjoint(np.asarray(weights), **given, outputs=OUTPUTS, by=names)
            return tuple(found[name] for name in names)

        shape = jax.ShapeDtypeStruct((50,), jnp.float64)
        return jax.pure_callback(own, (shape, shape), *kept, by_forces)

    forces.defvjp(forwards, backwards)
    measured = forces(rows["y"], 0.1 + 0.3 * (rows["y"] - 0.744) / 0.012)

    def misfit(line):
        friction = line[0] + line[1] * (rows["y"] - 0.744) / 0.012
        return jnp.mean(((forces(rows["y"], friction) - measured) / 1e3) ** 2)

    line = jnp.array([0.3, 0.0])
    slope = jax.jit(jax.grad(misfit))
    step = 1e-5
    for k in range(2):
        ways = step * np.eye(2)[k]
        difference = (misfit(line + ways) - misfit(line - ways)) / (2 * step)
        # What central differences leave at this step.
        np.testing.assert_allclose(slope(line)[k], difference, rtol=1e-5)
