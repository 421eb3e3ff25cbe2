"""What is odd is told, and what is not meant is refused."""

import numpy as np
import pytest
import wheelrail

QUICK = {"normal_model": "piotrowski_kik", "tangential_model": "fastsim"}


@pytest.fixture(scope="module")
def wheel():
    return wheelrail.Element(**QUICK)


@pytest.mark.parametrize(
    ("parameters", "inputs", "title", "words"),
    [
        ({"side": "left"}, {}, "beside the rails", "set wheel.y"),
        ({"wheel_nominal_radius": 0.425}, {}, "in the air", "34.9 mm above"),
        ({"vertical_mode": "load"}, {"y": 0.3}, "load not carried", "the rails carry 0 N"),
        ({"vertical_mode": "load"}, {"load": 1e9}, "load not carried", "wheel.load = 1000000000 N"),
        ({}, {"vx": 30.0, "pitch_rate": 0.0}, "sliding, not rolling", "slip of 100 %; it rolls freely at wheel.pitch_rate = -65.2"),
        ({"vertical_mode": "load"}, {"z": -0.45}, None, "wheel.z has no effect with vertical.mode = load"),
    ],
)  # fmt: skip
def test_what_is_odd_is_told_once_a_kind_and_call_with_its_rows(parameters, inputs, title, words):
    wheel = wheelrail.Element(**parameters, **QUICK)
    with pytest.warns(wheelrail.ContactWarning, match=words) as told:
        result = wheel.evaluate(**inputs)
    assert told[0].filename == __file__
    if title is None:
        return
    assert title in [remark.title for remark in result.remarks]
    # The second of three rows is fine.
    odd, fine = next(iter(inputs.items()), ("y", 0.75)), {"y": 0.75, "load": 8e4, "vx": 20.0}
    if not inputs:
        return
    column = [odd[1], fine[odd[0]], odd[1]]
    with pytest.warns(wheelrail.ContactWarning, match=r"in 2 of 3 rows \(0, 2\)") as told:
        result = wheel.evaluate(**{**inputs, odd[0]: column, **({"pitch_rate": [0.0, -20 / 0.46, 0.0]} if "vx" in inputs else {})})
    assert len([w for w in told if title in ("load not carried",) and "wheel.load" in str(w.message)]) <= 1
    remark = next(r for r in result.remarks if r.title == title)
    assert remark.rows.tolist() == [0, 2]


def test_attributes_that_there_are_not_cannot_be_set(wheel):
    with pytest.raises(AttributeError, match="no attribute vx to set"):
        wheel.vx = 30.0
    with pytest.raises(AttributeError):
        wheel.vx


def test_masked_arrays_are_refused(wheel):
    with pytest.raises(wheelrail.BadValueError, match="masked") as caught:
        wheel.evaluate(y=np.ma.masked_array([0.75, 0.76], mask=[False, True]))
    assert caught.value.variable == "wheel.y"
    wheel.evaluate(y=np.ma.masked_array([0.75, 0.7501]))


def test_a_wheel_that_rolls_needs_no_rate():
    rolling = wheelrail.Element(motion="rolling", vx=30.0)
    given = wheelrail.Element(vx=30.0, pitch_rate=-30.0 / 0.46)
    names = ["wheel.force.x", "patch[1].creepage.longitudinal"]
    found, same = (wheel.evaluate(z=-0.4597, outputs=names) for wheel in (rolling, given))
    assert dict(found) == dict(same) and not found.remarks
    axles = [wheelrail.WheelSet(motion="rolling", vx=30.0), wheelrail.WheelSet(vx=30.0, pitch_rate=-30.0 / 0.46)]
    found, same = (axle.evaluate(y=1e-3, outputs="wheelset.force.x") for axle in axles)
    assert dict(found) == dict(same)
    with pytest.warns(wheelrail.ContactWarning, match="pitch_rate has no effect with motion = rolling"):
        rolling.evaluate(pitch_rate=-40.0)
