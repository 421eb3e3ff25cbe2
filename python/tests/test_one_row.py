"""Calls of numbers, as a loop in time makes them: numbers back, and the bits of a row in an array."""

import pickle
import re
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
import wheelrail

ROLLING = {"vx": 20.0, "pitch_rate": -20.0 / 0.46}
QUICK = {"normal_model": "piotrowski_kik", "tangential_model": "fastsim", **ROLLING}
LOADED = {"vertical_mode": "load", **QUICK}


@pytest.fixture(scope="module")
def wheel():
    return wheelrail.Element(**QUICK)


def random_rows(kind, mode, count, seed=5):
    """Places of a wheel or a wheelset, heights or loads given."""
    random = np.random.default_rng(seed)
    middle = 0.75 if kind is wheelrail.Element else 0.0
    rows = {"y": middle + random.uniform(-6e-3, 6e-3, count), "yaw": random.uniform(-5e-3, 5e-3, count)}
    rows |= {"vy": random.normal(0.0, 0.02, count)}
    if mode == "penetration":
        rows["z"] = kind(**QUICK).touching_height(y=rows["y"], yaw=rows["yaw"]) + 6e-5
    else:
        for name in ("load",) if kind is wheelrail.Element else ("right_wheel_load", "left_wheel_load"):
            rows[name] = random.uniform(4e4, 9e4, count)
    return rows


def one_of(rows, k):
    return {name: float(column[k]) for name, column in rows.items()}


def bits(value):
    return np.float64(value).tobytes()


@pytest.mark.parametrize("kind", [wheelrail.Element, wheelrail.WheelSet])
@pytest.mark.parametrize("mode", ["penetration", "load"])
@pytest.mark.parametrize("models", [QUICK, ROLLING], ids=["quick", "as it starts"])
def test_a_call_of_numbers_has_the_bits_of_a_row(kind, mode, models):
    wheel = kind(vertical_mode=mode, **models)
    rows = random_rows(kind, mode, 6)
    together = wheel.evaluate(**rows)
    # The order of calls makes no difference either.
    for k in (3, 0, 5, 3):
        alone = wheel.evaluate(**one_of(rows, k))
        assert list(alone) == list(together)
        for name in together:
            assert bits(alone[name]) == bits(together[name][k]), name
        by_fmi_names = wheel.evaluate({n: v[k] for n, v in together.inputs.items()})
        assert by_fmi_names.to_numpy().tobytes() == alone.to_numpy().tobytes()


def test_a_call_of_numbers_gives_numbers(wheel):
    found = wheel.evaluate(y=0.75, z=wheel.nominal_z + 6e-5, friction=1)
    assert found.shape == ()
    for name, value in found.items():
        assert type(value) is (int if name.endswith(("count", "rail", "fallbacks")) else float), name
    assert type(found.wheel_force_z) is float and type(found.patch_count) is int
    assert found.inputs == {"wheel.y": 0.75, "wheel.z": wheel.nominal_z + 6e-5, "friction.coefficient": 1.0}
    assert {type(value) for value in found.inputs.values()} == {float}
    # Masks are of NumPy, so that ~ turns them.
    assert found.valid and not ~found.valid and not found.sunk
    assert type(wheel.touching_height(y=0.75)) is float
    slope = wheel.jacobian(y=0.75, z=wheel.nominal_z + 6e-5, outputs="wheel.force.z", by="z")
    assert type(slope["wheel.force.z", "z"]) is float and slope.values.shape == (1, 1)
    refused = wheel.evaluate(y=float("nan"), errors="nan")
    assert type(refused["wheel.force.z"]) is float and np.isnan(refused["wheel.force.z"])
    assert refused["patch_count"] == -1 and not refused.valid and "wheel.y" in refused.refusals[0]


@pytest.mark.parametrize(
    ("value", "shape"),
    [
        (0.75, ()), (1, ()), (np.float64(0.75), ()), (np.float32(0.75), ()), (np.int64(1), ()), (np.array(0.75), ()),
        ([0.75], (1,)), (np.array([0.75]), (1,)), (np.array([[0.75]]), (1, 1)), ((0.75, 0.751), (2,)),
    ],
)  # fmt: skip
def test_the_shape_is_that_of_what_is_given(wheel, value, shape):
    at = {"z": wheel.nominal_z + 6e-5, "outputs": "wheel.force.z"}
    found = wheel.evaluate(pitch=value, **at)["wheel.force.z"]
    assert np.shape(found) == shape and isinstance(found, np.ndarray) == (shape != ())
    row = wheel.evaluate(pitch=[np.ravel(value)[0]], **at)["wheel.force.z"]
    assert bits(np.ravel(found)[0]) == bits(row[0])


def test_numbers_become_tables_too(wheel):
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    found = wheel.evaluate(y=0.75, z=wheel.nominal_z + 6e-5, outputs=["wheel.force.z", "patch_count"])
    table = found.to_pandas()
    assert table.shape == (1, 4) and table["patch_count"].dtype == np.int64
    assert table["wheel.force.z"].iloc[0] == found["wheel.force.z"] and table["wheel.y"].iloc[0] == 0.75
    dataset = found.to_xarray()
    assert dict(dataset.sizes) == {} and float(dataset["wheel.y"]) == 0.75
    assert float(dataset["wheel.force.z"]) == found["wheel.force.z"]
    assert "wheel.force.z" in found._repr_html_() and found.to_numpy().shape == ()


def test_names_are_looked_up_once_and_again_when_they_are_others(wheel):
    wheel = pickle.loads(pickle.dumps(wheel))
    outputs = ["wheel.force.y"]
    for k in range(5):
        assert list(wheel.evaluate(y=0.75 + 1e-4 * k, outputs=outputs)) == ["wheel.force.y"]
    assert len(wheel._evaluations) == 1
    # A list that has changed since is another one.
    outputs.append("patch_count")
    assert list(wheel.evaluate(y=0.75, outputs=outputs)) == ["wheel.force.y", "patch_count"]
    # The same values under other names.
    z = wheel.nominal_z + 6e-5
    by_y, by_yaw = wheel.evaluate(y=1e-3 + 0.75, z=z), wheel.evaluate(yaw=1e-3, z=z)
    assert list(by_y.inputs) == ["wheel.y", "wheel.z"] and list(by_yaw.inputs) == ["wheel.yaw", "wheel.z"]
    assert by_y["wheel.force.y"] != by_yaw["wheel.force.y"]
    # Another order is another set, with the same result.
    assert wheel.evaluate(z=z, y=1e-3 + 0.75)["wheel.force.y"] == by_y["wheel.force.y"]
    for kept in (wheel._evaluations, wheel._inputs_by_names):
        assert len(kept) < 10


def test_what_is_kept_has_a_bound():
    from wheelrail import _given

    kept = _given.Kept()
    for k in range(3 * _given._MOST):
        assert kept.keep(k, -k) == -k
        assert kept[k] == -k and len(kept) <= _given._MOST


def test_elements_with_other_parameters_look_names_up_for_themselves():
    by_height = wheelrail.Element(**QUICK)
    with pytest.warns(wheelrail.ContactWarning, match="wheel.load has no effect"):
        by_height.evaluate(load=8e4)
    by_load = wheelrail.Element(**LOADED)
    # Raises if it warns of what the other one has.
    assert by_load.evaluate(load=8e4)["wheel.force.z"] == pytest.approx(-8e4, rel=1e-6)
    with pytest.warns(wheelrail.ContactWarning, match="wheel.z has no effect"):
        by_load.evaluate(z=-0.46)
    assert by_height.evaluate(z=by_height.nominal_z + 6e-5)["patch_count"] == 1
    with_two = wheelrail.Element(rail2_enabled=True, rail2_profile="60E1", **QUICK)
    names = [name for name in with_two.evaluate(z=by_height.nominal_z + 6e-5) if name.startswith("rail[2].")]
    assert names and not [name for name in by_height.evaluate(z=by_height.nominal_z + 6e-5) if name in names]
    # Parameters given anew make the element anew, and what names stand for with it.
    by_height.__init__(**LOADED)
    assert by_height.evaluate(load=8e4)["wheel.force.z"] == by_load.evaluate(load=8e4)["wheel.force.z"]


@pytest.mark.parametrize(
    ("call", "variable", "row", "words"),
    [
        ({"y": float("nan")}, "wheel.y", 0, "row 0: wheel.y = NaN"),
        ({"friction": -0.1}, "friction.coefficient", 0, "-0.1"),
        ({"yay": 1.0}, "yay", None, "nearest name is yaw"),
        ({"wheel.force.z": 1.0}, "wheel.force.z", None, "computed"),
        ({"y": "left"}, "wheel.y", None, "no array of numbers"),
        ({"y": None, "z": [0.1, 0.2]}, "wheel.y", 0, "NaN"),
        ({"y": 0.75, "wheel.y": 0.75}, "wheel.y", None, "given twice"),
        ({"outputs": "wheel.forze.z"}, "wheel.forze.z", None, "wheel.force.z"),
        ({"errors": "ignore"}, "errors", None, "raise or nan"),
        ({"threads": 0}, "threads", None, "at least 1"),
    ],
)
def test_refusals_are_the_same_each_time_and_leave_nothing_behind(wheel, call, variable, row, words):
    good = {"y": 0.75, "z": wheel.nominal_z + 6e-5}
    before = wheel.evaluate(**good).to_numpy().tobytes()
    for _ in range(2):
        with pytest.raises(wheelrail.ContactError) as caught:
            wheel.evaluate(**{**good, **call})
        assert (caught.value.variable, caught.value.row) == (variable, row)
        assert words in str(caught.value), str(caught.value)
        assert wheel.evaluate(**good).to_numpy().tobytes() == before


def test_threads_of_the_environment_are_checked(wheel, monkeypatch):
    monkeypatch.setenv("WHEELRAIL_NUM_THREADS", "two")
    with pytest.raises(wheelrail.BadValueError, match="WHEELRAIL_NUM_THREADS"):
        wheel.evaluate(y=0.75)
    monkeypatch.setenv("WHEELRAIL_NUM_THREADS", "2")
    wheel.evaluate(y=0.75)


def test_what_is_odd_is_told_at_each_call(wheel):
    at = {"y": 0.75, "z": wheel.nominal_z + 0.2}
    with pytest.warns(wheelrail.ContactWarning) as of_array:
        array = wheel.evaluate(**{name: [value] for name, value in at.items()})
    for _ in range(2):
        with pytest.warns(wheelrail.ContactWarning) as told:
            found = wheel.evaluate(**at)
        assert [str(w.message) for w in told] == [str(w.message) for w in of_array]
        assert told[0].filename == __file__
        assert [r.title for r in found.remarks] == [r.title for r in array.remarks]
        assert found.remarks[0].rows.tolist() == [0]
    assert found.sunk and array.sunk.tolist() == [True]
    assert not wheel.evaluate(y=0.75, z=wheel.nominal_z + 6e-5).remarks


def test_progress_of_one_row_is_told(wheel):
    told = []
    found = wheel.evaluate(y=0.75, progress=lambda done, rows: told.append((done, rows)))
    assert told == [(1, 1)] and type(found["wheel.force.z"]) is float


def test_threads_of_python_can_share_an_element(wheel):
    rows = random_rows(wheelrail.Element, "penetration", 200)
    expected = wheel.evaluate(**rows)["wheel.force.y"]
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda k: wheel.evaluate(**one_of(rows, k))["wheel.force.y"], range(200)))
    assert np.array(found).tobytes() == expected.tobytes()


def test_the_loop_in_time_of_the_documents_comes_to_rest():
    """And its forces are those of an array of its steps."""
    text = (Path(__file__).parent.parent.parent / "docs/python.md").read_text(encoding="utf-8")
    code = next(block for block in re.findall(r"```python\n(.*?)```", text, re.DOTALL) if "for " in block)
    steps, forces = [], []

    class Recording(wheelrail.Element):
        def evaluate(self, *table, **call):
            found = super().evaluate(*table, **call)
            steps.append({name: value for name, value in call.items() if name != "outputs"})
            forces.append(found["wheel.force.z"])
            return found

    names = {"wheelrail": type("Recorded", (), {"Element": Recording})}
    exec(code, names)
    assert len(steps) == 1000 and abs(forces[-1] + 80e3) < 80.0
    wheel = wheelrail.Element(**ROLLING)
    rows = {name: [step[name] for step in steps] for name in steps[0]}
    assert wheel.evaluate(**rows)["wheel.force.z"].tobytes() == np.array(forces).tobytes()
