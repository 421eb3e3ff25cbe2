"""Planar contact with memory."""

import numpy as np
import pytest

import wheelrail
from wheelrail import planar

Y = np.linspace(-0.02, 0.02, 201)
SPHERE = 0.3 - np.sqrt(0.09 - Y**2)
STATE = {"radius": 0.46, "approach": 1e-4, "friction": 0.3}
CREEPAGE = {"creepage_longitudinal": 0.001, "spin": 0.1}


def test_a_metre_is_steady_rolling_and_small_steps_go_there():
    models = {"normal_model": "boundary_element", "tangential_model": "boundary_element"}
    size = {"normal_elements_along": 20, "normal_elements_across": 20}
    steady = planar.solve(Y, SPHERE, **STATE, **CREEPAGE, **models, **size)
    limit = 0.3 * steady.normal_force
    at_once = planar.Transient(**size).step(Y, SPHERE, **STATE, **CREEPAGE, rolled=1.0)
    assert at_once.substeps == 0 and at_once.converged
    assert abs(at_once.fx - steady.fx) < 1e-6 * limit and abs(at_once.fy - steady.fy) < 1e-6 * limit
    contact = planar.Transient(**size)
    forces = [contact.step(Y, SPHERE, **STATE, **CREEPAGE, rolled=0.5 * steady.length).fx for _ in range(12)]
    assert all(np.diff(forces) < 1e-6 * limit)
    assert abs(forces[-1] - steady.fx) < 1e-3 * limit < abs(forces[0] - steady.fx)


def test_shift_force_history_and_field():
    contact = planar.Transient(element_size=(4e-4, 4e-4))
    assert contact.field() is None
    shifted = contact.step(Y, SPHERE, **STATE, shift_x=-4e-6)
    assert shifted.fx > 0.0 and shifted.displacement_x == -4e-6
    history = contact.history
    field = contact.field()
    assert field is not None and field.slip_x is None and repr(field)
    area = field.dx * field.dy
    assert field.traction_x.sum() * area == pytest.approx(shifted.fx)
    assert (field.friction_work >= 0.0).all()
    power = field.slip_distance_x * field.traction_x + field.slip_distance_y * field.traction_y
    assert (power <= 0.0).all() and field.friction_work.sum() == pytest.approx(shifted.friction_work)
    pulled = contact.step(Y, SPHERE, **STATE, rolled=2e-4, force_longitudinal=-5e3)
    assert pulled.fx == pytest.approx(-5e3, abs=0.1) and pulled.displacement_x > 0.0
    after = contact.history
    contact.history = history
    assert contact.step(Y, SPHERE, **STATE, rolled=2e-4, force_longitudinal=-5e3) == pulled
    assert (contact.history == after).all()


def test_refusals_name_what_is_wrong():
    contact = planar.Transient()
    with pytest.raises(wheelrail.errors.BadValueError, match="rolled = 100000000") as refusal:
        contact.step(Y, SPHERE, **STATE, rolled=1e8)
    assert refusal.value.variable == "rolled"
    with pytest.raises(wheelrail.errors.BadValueError, match="one state"):
        contact.step(Y, SPHERE, radius=[0.4, 0.5], load=1e4)
    with pytest.raises(wheelrail.errors.BadValueError, match="either approach or load"):
        contact.step(Y, SPHERE, radius=0.4)
    with pytest.raises(wheelrail.errors.BadValueError, match="element_width"):
        planar.Transient(element_size=(1e-3, 0.0))
    with pytest.raises(wheelrail.errors.BadValueError, match="history"):
        contact.history = [1.0, 2.0]


def test_a_wheel_remembers_the_way_it_has_rolled():
    models = {
        "normal_model": "boundary_element",
        "tangential_model": "boundary_element",
        "normal_elements_along": 8,
        "normal_elements_across": 8,
    }
    steady = wheelrail.Element(**models)
    run = wheelrail.TransientRun(tangential_history="transient", **models)
    assert repr(run).startswith("wheelrail.TransientRun(")
    z = steady.nominal_z + 1e-4
    # Rolling as it begins, then a yaw angle whose force builds up.
    first = run.advance(z=z, duration=1e-4, outputs=["wheel.force.y"])
    assert first["wheel.force.y"] == steady.evaluate(z=z)["wheel.force.y"]
    before = run.history
    found = run.advance(z=z, yaw=[3e-3] * 4 + [0.0], duration=[5e-5, 5e-5, 5e-5, 0.1, 0.1])
    force = found["wheel.force.y"]
    end = steady.evaluate(z=z, yaw=3e-3)["wheel.force.y"]
    assert first["wheel.force.y"] < force[0] < force[1] < force[2] < force[3]
    assert abs(force[3] - end) < 1e-4 * abs(end) and (found["frictional_power"] >= 0.0).all()
    run.history = before
    np.testing.assert_array_equal(run.advance(z=z, yaw=3e-3, duration=[5e-5] * 3)["wheel.force.y"], force[:3])
    with pytest.raises(wheelrail.BadValueError, match="numbers of a history"):
        run.history = [0.5]
    with pytest.raises(wheelrail.BadValueError, match=r"tangential\.history"):
        wheelrail.TransientRun(**models)
    with pytest.raises(wheelrail.BadValueError, match=r"tangential\.model boundary_element"):
        wheelrail.TransientRun(tangential_history="transient")


def test_stresses_are_those_of_the_tractions_that_are_remembered():
    models = {
        "normal_model": "boundary_element",
        "tangential_model": "boundary_element",
        "normal_elements_along": 12,
        "normal_elements_across": 12,
        "motion": "rolling",
        "vx": 20.0,
        "wheel_profile": "conical:0.05",
        "rail1_profile": "arc:0.3",
    }
    # A wheel that stands at first: its contact begins without tractions.
    run = wheelrail.TransientRun(tangential_history="transient", **models)
    z = wheelrail.Element(**models).nominal_z + 1e-4
    run.advance(z=z, vx=0.0, duration=1e-3)
    rested = run.history
    turned = {"z": z, "yaw": 3e-3}
    shear, force = [], []
    for duration in (0.0, 5e-5, 1e-4, 0.05):
        found = run.advance(**turned, duration=duration)
        (field,) = run.fields(**turned)
        area = field.dx * field.dy
        assert field.normal_force == pytest.approx(found["patch[1].normal_force"], rel=1e-3)
        limit = 0.3 * field.normal_force
        assert abs(field.traction_y.sum() * area - found["patch[1].creep_force.y"]) < 0.01 * limit
        (load,) = run.loads(**turned)
        shear.append(load.greatest("orthogonal_shear").value)
        force.append(abs(found["patch[1].creep_force.y"]))
    assert force[0] == 0.0 and (np.diff(force) > 0.0).all() and (np.diff(shear) > 0.0).all()
    # The end is steady rolling, which has elements of its own on the contact laid flat.
    steady = wheelrail.Element(**models).loads(**turned)[0].greatest("orthogonal_shear").value
    assert shear[-1] == pytest.approx(steady, rel=0.005) and shear[1] < 0.97 * steady
    # Loads follow a history that is set; the wheel has the other tractions.
    run.history = rested
    (load,) = run.loads(**turned)
    assert load.greatest("orthogonal_shear").value == shear[0]
    rail, wheel = (run.loads(**turned, body=body)[0].max_pressure for body in ("rail", "wheel"))
    assert rail == wheel and run.loads(z=z - 0.01) == []
    with pytest.raises(wheelrail.BadValueError, match='body = "sleeper"'):
        run.loads(**turned, body="sleeper")
    # What knows steady rolling alone says so.
    wheel = wheelrail.Element(tangential_history="transient", **models)
    for of in (wheel.loads, wheel.contacts):
        with pytest.raises(wheelrail.BadValueError, match='tangential.history = "transient" is not admitted: steady'):
            of(**turned)
    with pytest.raises(wheelrail.BadValueError, match=r"planar\.Transient"):
        planar.solve(Y, SPHERE, **STATE, tangential_history="transient", normal_model="boundary_element",
                     tangential_model="boundary_element")  # fmt: skip
