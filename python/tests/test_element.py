"""Wheel and wheelset: what an array call promises."""

import os
import pickle
import subprocess
import sys

import numpy as np
import pytest
import wheelrail

ROLLING = {"vx": 20.0, "pitch_rate": -20.0 / 0.46}
#: Quick models, so that what is checked here does not hang on the choice of default.
QUICK = {"normal_model": "piotrowski_kik", "tangential_model": "fastsim", **ROLLING}


@pytest.fixture(scope="module")
def wheel():
    return wheelrail.Element(**QUICK)


def places(wheel, count, seed=1):
    """Random places of a wheel in contact."""
    random = np.random.default_rng(seed)
    y = 0.75 + random.uniform(-6e-3, 6e-3, count)
    yaw = random.uniform(-5e-3, 5e-3, count)
    return {"y": y, "yaw": yaw, "z": wheel.touching_height(y=y, yaw=yaw) + 6e-5}


def test_one_row_is_the_same_alone_and_among_others(wheel):
    rows = places(wheel, 50)
    together = wheel.evaluate(**rows)
    for k in (0, 17, 49):
        alone = wheel.evaluate(**{name: value[k] for name, value in rows.items()})
        assert alone.shape == ()
        for name in together:
            assert together[name][k] == alone[name], name


def test_bits_do_not_depend_on_threads(wheel):
    rows = places(wheel, 3000)
    one = wheel.evaluate(**rows, threads=1).to_numpy()
    for threads in (2, 3, 8):
        assert one.tobytes() == wheel.evaluate(**rows, threads=threads).to_numpy().tobytes()


def test_few_rows_that_take_long_are_shared_out():
    wheel = wheelrail.Element(
        normal_model="boundary_element", tangential_model="boundary_element",
        normal_elements_along=10, normal_elements_across=10, vertical_mode="load", **ROLLING,
    )  # fmt: skip
    y = 0.75 + np.linspace(-4e-3, 4e-3, 5)
    one = wheel.evaluate(y=y, load=8e4, threads=1).to_numpy()
    assert one.tobytes() == wheel.evaluate(y=y, load=8e4, threads=4).to_numpy().tobytes()


def test_the_first_refusal_is_told_whatever_the_threads(wheel):
    rows = places(wheel, 3000)
    rows["y"][[1700, 1710, 2900]] = np.nan
    for threads in (1, 2, 7):
        with pytest.raises(wheelrail.BadValueError) as caught:
            wheel.evaluate(**rows, threads=threads)
        assert caught.value.row == 1700
        masked = wheel.evaluate(**rows, threads=threads, errors="nan")
        assert list(masked.refusals) == np.flatnonzero(~masked.valid).tolist() == [1700, 1710, 2900]


def test_inputs_broadcast(wheel):
    y = 0.75 + np.linspace(-2e-3, 2e-3, 4)[:, np.newaxis]
    depth = np.array([2e-5, 5e-5, 1e-4])
    result = wheel.evaluate(y=y, z=wheel.touching_height(y=y) + depth, friction=0.4)
    assert result.shape == (4, 3)
    # A right wheel's force grows with its depth.
    assert (np.diff(-result["wheel.force.z"], axis=1) > 0).all()
    assert result.inputs["friction.coefficient"].shape == (4, 3)
    np.testing.assert_array_equal(result.wheel_force_z, result["wheel.force.z"])


def test_no_rows_are_no_error(wheel):
    result = wheel.evaluate(y=np.empty(0))
    assert result.shape == (0,) and result["wheel.force.z"].shape == (0,)


def test_a_table_and_names_of_the_fmu_do_as_well_as_keywords(wheel):
    pandas = pytest.importorskip("pandas")
    rows = places(wheel, 10)
    table = pandas.DataFrame({f"wheel.{name}": value for name, value in rows.items()}, index=range(5, 15))
    found = wheel.evaluate(table).to_pandas()
    assert list(found.index) == list(table.index)
    np.testing.assert_array_equal(found["wheel.force.z"], wheel.evaluate(**rows)["wheel.force.z"])
    by_fmi_name = wheelrail.Element({"normal.model": "piotrowski_kik", "tangential.model": "fastsim"}, **ROLLING)
    np.testing.assert_array_equal(by_fmi_name.evaluate(table)["wheel.force.z"], found["wheel.force.z"])


def test_outputs_can_be_chosen(wheel):
    result = wheel.evaluate(outputs=["patch[1].creep_force.*", "wheel_force_z"])
    assert list(result) == ["patch[1].creep_force.x", "patch[1].creep_force.y", "wheel.force.z"]
    assert wheel.evaluate(y=[0.75], outputs="patch_count")["patch_count"].dtype == np.int64
    assert "patch[8].area" in wheel.evaluate(outputs="*")


@pytest.mark.parametrize(
    ("call", "kind", "variable", "row", "words"),
    [
        ({"y": [0.75, np.nan]}, wheelrail.BadValueError, "wheel.y", 1, "wheel.y = NaN"),
        ({"friction": [0.3, 0.3, -0.1]}, wheelrail.BadValueError, "friction.coefficient", 2, "-0.1"),
        ({"yay": 1.0}, wheelrail.UnknownVariableError, "yay", None, "nearest name is yaw"),
        ({"wheel_profile": "S1002"}, wheelrail.BadValueError, "wheel.profile", None, "no input"),
        ({"wheel.force.z": 1.0}, wheelrail.BadValueError, "wheel.force.z", None, "computed"),
        ({"y": [0.7, 0.8], "z": [1.0, 2.0, 3.0]}, wheelrail.BadValueError, None, None, "wheel.z (3,)"),
        ({"y": "left"}, wheelrail.BadValueError, "wheel.y", None, "no array of numbers"),
        ({"y": 0.75, "wheel.y": 0.75}, wheelrail.BadValueError, "wheel.y", None, "given twice"),
        ({"outputs": "wheel.forze.z"}, wheelrail.UnknownVariableError, "wheel.forze.z", None, "wheel.force.z"),
        ({"outputs": "wear.wheel.area"}, wheelrail.BadValueError, "wear.wheel.area", None, "WearRun"),
        ({"outputs": "nothing.*"}, wheelrail.UnknownVariableError, "nothing.*", None, "no output fits"),
        ({"errors": "ignore"}, wheelrail.BadValueError, "errors", None, "raise or nan"),
        ({"threads": 0}, wheelrail.BadValueError, "threads", None, "at least 1"),
        ({"threads": "2"}, wheelrail.BadValueError, "threads", None, "threads = '2'"),
        ({"threads": 1.5}, wheelrail.BadValueError, "threads", None, "a whole number"),
    ],
)
def test_refusals_name_variable_and_row(wheel, call, kind, variable, row, words):
    with pytest.raises(kind) as caught:
        wheel.evaluate(**call)
    assert (caught.value.variable, caught.value.row) == (variable, row)
    assert words in str(caught.value), str(caught.value)
    assert isinstance(caught.value, ValueError)


@pytest.mark.parametrize(
    ("parameters", "variable", "words"),
    [
        ({"wheel_nominal_radius": -0.46}, "wheel.nominal_radius", "-0.46"),
        ({"wheel_profile": "no_such_wheel"}, "wheel.profile", "no_such_wheel"),
        ({"normal_model": "spheres"}, "normal.model", "piotrowski_kik (2)"),
        ({"normal_strips": 3.5}, "normal.strips", "an integer"),
        ({"rail1_enabled": "perhaps"}, "rail[1].enabled", "true or false"),
        ({"patch_count": 1}, "patch_count", "cannot be set"),
        ({"nominal_radius": 0.4}, "nominal_radius", "nearest name"),
    ],
)
def test_refused_parameters_are_named(parameters, variable, words):
    with pytest.raises(wheelrail.ContactError) as caught:
        wheelrail.Element(**parameters)
    assert caught.value.variable == variable and words in str(caught.value), str(caught.value)


def test_the_first_bad_row_is_told_whatever_the_threads(wheel):
    y = np.full(200_000, 0.75)
    y[[123_456, 150_000, 199_999]] = np.inf
    for threads in (1, 4):
        with pytest.raises(wheelrail.BadValueError) as caught:
            wheel.evaluate(y=y, threads=threads)
        assert caught.value.row == 123_456


def test_bad_rows_can_be_masked(wheel):
    rows = places(wheel, 100)
    good = wheel.evaluate(**rows)
    rows["y"][[3, 50]] = np.nan
    result = wheel.evaluate(**rows, errors="nan")
    assert np.flatnonzero(~result.valid).tolist() == [3, 50] == sorted(result.refusals)
    assert "wheel.y" in result.refusals[3]
    assert np.isnan(result["wheel.force.z"][[3, 50]]).all() and (result["patch_count"][[3, 50]] == -1).all()
    np.testing.assert_array_equal(result["wheel.force.z"][result.valid], good["wheel.force.z"][result.valid])


def test_a_wheel_sunk_in_its_rail_is_no_lifted_wheel(wheel):
    with pytest.warns(wheelrail.ContactWarning, match="below the top of its rail"):
        result = wheel.evaluate(y=0.75, z=[wheel.nominal_z - 1e-3, wheel.nominal_z + 0.2])
    assert result.sunk.tolist() == [False, True] and result["patch_count"].tolist() == [0, 0]


def test_heights_of_first_touch_are_those_at_which_the_force_begins(wheel):
    rows = places(wheel, 200)
    touching = wheel.touching_height(y=rows["y"], yaw=rows["yaw"])
    for depth, patches in ((-1e-9, False), (1e-9, True)):
        found = wheel.evaluate(y=rows["y"], yaw=rows["yaw"], z=touching + depth)["patch_count"]
        assert ((found > 0) == patches).all()
    assert np.isnan(wheel.touching_height(y=5.0))
    axle = wheelrail.WheelSet(**QUICK)
    assert axle.touching_height(y=0.0) == axle.nominal_z


def test_derivatives_are_those_of_differences(wheel):
    rows = places(wheel, 20, seed=4)
    jacobian = wheel.jacobian(**rows, by=["z", "wheel.vy", "yaw"])
    assert jacobian.values.shape == (20, 6, 3)
    step = 1e-9
    differences = [
        wheel.evaluate(**{**rows, "z": rows["z"] + sign * step}, outputs="wheel.force.z")["wheel.force.z"]
        for sign in (1, -1)
    ]
    slope = (differences[0] - differences[1]) / (2 * step)
    np.testing.assert_allclose(jacobian["wheel.force.z", "z"], slope, rtol=1e-4)
    # One direction at a time goes another way through the crate.
    alone = wheel.jacobian(**rows, outputs="wheel.force.y", by="vy")
    np.testing.assert_allclose(alone["wheel.force.y", "vy"], jacobian["wheel.force.y", "wheel.vy"], rtol=1e-12)
    with pytest.raises(wheelrail.UnknownVariableError, match="by="):
        jacobian["wheel.force.z", "vx"]


def test_a_table_without_names_is_refused(wheel):
    for table in ([0.75, 0.751], np.zeros((2, 3)), "cases.csv"):
        with pytest.raises(wheelrail.BadValueError, match="a mapping or a DataFrame") as caught:
            wheel.evaluate(table)
        assert caught.value.variable == "table"


@pytest.mark.parametrize(
    ("parameters", "inputs", "words"),
    [
        ({}, {"load": 8e4}, 'wheel.load has no effect with vertical.mode = penetration: it has with "load"'),
        ({}, {"friction_tread_coefficient": 0.2}, "friction.tread.coefficient has no effect"),
        ({"friction_distribution": "regions"}, {"friction": 0.2}, "friction.coefficient has no effect"),
    ],
)
def test_inputs_without_effect_are_told(parameters, inputs, words):
    wheel = wheelrail.Element(**parameters, **QUICK)
    for call in (wheel.evaluate, wheel.jacobian):
        with pytest.warns(wheelrail.ContactWarning, match=words) as told:
            call(y=[0.75, 0.751], **inputs)
        assert len(told) == 1 and told[0].filename == __file__
    with pytest.warns(wheelrail.ContactWarning, match=words) as told:
        wheelrail.Element(**parameters, **QUICK, **inputs)
    assert told[0].filename == __file__
    name, value = next(iter(inputs.items()))
    with pytest.warns(wheelrail.ContactWarning, match=f"left.{words}"):
        wheelrail.WheelSet(**parameters, **QUICK, **{f"left_{name if name != 'load' else 'wheel_load'}": value})


def section_table(path, heading, rows):
    path.write_text("\n".join([heading, *(f"{place},{profile}" for place, profile in rows)]) + "\n")
    return path


def test_profiles_vary_along_the_track_and_around_the_wheel(tmp_path):
    rail = section_table(tmp_path / "rail.csv", "station_m,profile", [(0, "60E1"), (3, "60E2")])
    hollow = wheelrail.profile("S1002")
    hollow[:, 1] += 1e-4 * np.exp(-((hollow[:, 0] / 10e-3) ** 2))
    np.savetxt(tmp_path / "hollow.txt", 1e3 * hollow[::-1])
    around = section_table(tmp_path / "wheel.csv", "angle_deg,profile", [(0, "S1002"), (180, "hollow.txt")])
    under_load = {"vertical_mode": "load", **QUICK}
    y = 0.75 + np.linspace(-4e-3, 4e-3, 5)
    varying = wheelrail.Element(rail1_profile=rail, **under_load)
    along = varying.evaluate(y=y, track_s=np.array([[-1.0], [-0.5], [1.5], [3.0]]), load=8e4)
    # The rail goes on before its first section as it is there, and is another one where the sections are.
    for name in ("wheel.force.y", "vertical.wheel_z"):
        np.testing.assert_allclose(along[name][0], along[name][1], rtol=1e-6)
        assert (np.abs(along[name][3] - along[name][0]) > 1e-6 * np.abs(along[name][0])).any()
    slope = varying.jacobian(y=y, track_s=1.5, load=8e4, outputs="wheel.force.y", by="track_s")
    step = 1e-5
    moved = [varying.evaluate(y=y, track_s=1.5 + d, load=8e4, outputs="wheel.force.y") for d in (-step, step)]
    differences = (moved[1]["wheel.force.y"] - moved[0]["wheel.force.y"]) / (2 * step)
    exact = slope["wheel.force.y", "track_s"]
    np.testing.assert_allclose(exact, differences, rtol=1e-4, atol=1e-4 * np.abs(exact).max())
    turned = wheelrail.Element(wheel_profile=around, **under_load)
    found = turned.evaluate(y=y, pitch=np.array([[0.0], [-np.pi], [-2 * np.pi]]), load=8e4)["wheel.force.y"]
    np.testing.assert_allclose(found[0], found[2], rtol=1e-6)
    assert (np.abs(found[1] - found[0]) > 1e-3 * np.abs(found[0])).any()
    with pytest.raises(wheelrail.NoDerivativeError, match=r"wheel\.profile"):
        turned.jacobian(y=y, load=8e4)
    # Both together: before its first section the rail is that of one profile. Sections of rails are followed
    # to 10 nm, which is 1e-4 of the penetration.
    both = wheelrail.Element(wheel_profile=around, rail1_profile=rail, **under_load)
    pitch = np.array([[0.0], [-np.pi]])
    beside = both.evaluate(y=y, pitch=pitch, track_s=-1.0, load=8e4)["wheel.force.y"]
    np.testing.assert_allclose(beside, found[:2], rtol=0, atol=1e-4 * 8e4)
    section_table(rail, "station_m,profile", [(0, "60E1"), (1, "nowhere.txt")])
    with pytest.raises(wheelrail.ProfileError, match=r"rail\.csv:3: .*nowhere\.txt") as caught:
        wheelrail.Element(rail1_profile=rail)
    assert caught.value.variable == "rail[1].profile"


def test_a_roller_turns_under_the_wheel():
    radius, speed = 0.5, 20.0
    under_load = {"vertical_mode": "load", **QUICK}
    wheel = wheelrail.Element(rail1_roller_radius=radius, **under_load)
    names = ["patch[1].creepage.longitudinal", "patch[1].length", "patch[1].width"]
    turning = speed / radius * np.array([1.0, 1.001])
    found = wheel.evaluate(vx=0.0, rail1_pitch_rate=turning, load=8e4, outputs=names)
    # The patch lies within 0.5 mm below the top of the roller, which is a creepage of 1e-3.
    assert abs(found[names[0]][0]) < 1e-3
    # A thousandth more of the roller's speed is as much more of creepage.
    np.testing.assert_allclose(np.diff(found[names[0]])[0], 1e-3, rtol=0.01)
    # Curvatures along x add up, so that the patch is shorter and wider in proportion than on a rail.
    straight = wheelrail.Element(**under_load).evaluate(load=8e4, outputs=names)
    assert found[names[1]][0] / found[names[2]][0] < 0.9 * straight[names[1]] / straight[names[2]]


def test_friction_comes_from_a_table(tmp_path):
    path = tmp_path / "friction.csv"
    path.write_text("station_m,friction\n0,0.1\n10,0.4\n")
    sliding = {"vertical_mode": "load", "vy": 2.0, **QUICK}
    wheel = wheelrail.Element(friction_distribution="profile", friction_profile=path, **sliding)
    found = wheel.evaluate(track_s=[0.0, 5.0, 10.0], load=8e4)["wheel.force.y"]
    same = wheelrail.Element(**sliding).evaluate(friction=[0.1, 0.25, 0.4], load=8e4)["wheel.force.y"]
    np.testing.assert_allclose(found, same, rtol=1e-6)
    path.write_text("station_m,friction\n0,0.1\n10,-0.4\n")
    with pytest.raises(wheelrail.ContactError, match=r"friction\.csv") as caught:
        wheelrail.Element(friction_distribution="profile", friction_profile=path)
    assert caught.value.variable == "friction.profile"


def test_models_without_derivatives_say_so():
    wheel = wheelrail.Element(tangential_model="boundary_element", **ROLLING)
    with pytest.raises(wheelrail.NoDerivativeError, match="tangential.model = boundary_element"):
        wheel.jacobian(y=0.75)


def test_a_wheelset_is_two_wheels():
    axle = wheelrail.WheelSet(**QUICK)
    result = axle.evaluate(y=[0.0, 3e-3], z=axle.nominal_z + 1e-4, right_friction=0.3)
    for name in ("wheelset.force.z",):
        sides = result["right.wheel.force.z"] + result["left.wheel.force.z"]
        np.testing.assert_allclose(result[name], sides, rtol=1e-12)
    assert abs(result["wheelset.force.y"][0]) < 1e-6
    jacobian = axle.jacobian(y=3e-3, z=axle.nominal_z + 1e-4, by=["y", "vy"])
    assert jacobian.values.shape == (6, 2) and np.isfinite(jacobian.values).all()


def test_elements_go_through_pickle(wheel):
    copy = pickle.loads(pickle.dumps(wheel))
    rows = places(wheel, 10)
    assert copy.parameters == wheel.parameters
    np.testing.assert_array_equal(copy.evaluate(**rows).wheel_force_z, wheel.evaluate(**rows).wheel_force_z)
    error = pickle.loads(pickle.dumps(wheelrail.BadValueError("no", variable="wheel.y", row=3)))
    assert (str(error), error.variable, error.row) == ("row 3: no", "wheel.y", 3)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are not forked here")
def test_a_forked_process_goes_on():
    code = """
import os, wheelrail, numpy as np
wheel = wheelrail.Element()
wheel.evaluate(y=np.full(500, 0.75), threads=2)
child = os.fork()
if child == 0:
    wheel.evaluate(y=np.full(500, 0.75), threads=2)
    os._exit(7)
assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7
"""
    subprocess.run([sys.executable, "-W", "ignore", "-c", code], check=True, timeout=60)


def test_other_threads_run_meanwhile(wheel):
    import threading

    stop, count = threading.Event(), [0]

    def counting():
        while not stop.is_set():
            count[0] += 1

    thread = threading.Thread(target=counting)
    rows = places(wheel, 20_000)
    thread.start()
    before = count[0]
    wheel._native.evaluate(
        [(1, rows["y"]), (2, rows["z"])], [0], np.empty((20_000, 1)), np.zeros(20_000, np.uint8), 1, True
    )
    after = count[0]
    stop.set()
    thread.join()
    # With the lock held all the while there would be none.
    assert after - before > 1000


def test_progress_is_told(wheel):
    told = []
    wheel.evaluate(y=np.full(5000, 0.75), threads=1, progress=lambda done, rows: told.append((done, rows)))
    assert told[-1] == (5000, 5000) and [t[0] for t in told] == sorted(t[0] for t in told)


def test_results_become_tables(wheel):
    xarray = pytest.importorskip("xarray")
    y = xarray.DataArray(0.75 + np.linspace(-1e-3, 1e-3, 3), dims="place", coords={"place": [10, 20, 30]})
    depth = xarray.DataArray([1e-5, 1e-4], dims="depth")
    dataset = wheel.evaluate(y=y, z=wheel.nominal_z + depth).to_xarray()
    assert dict(dataset.sizes) == {"place": 3, "depth": 2}
    assert dataset["wheel.force.z"].attrs["units"] == "N"
    assert dataset["place"].values.tolist() == [10, 20, 30]
    plain = wheel.evaluate(y=np.linspace(0.749, 0.751, 4)[:, None], z=wheel.nominal_z + np.array([0, 1e-4]))
    assert dict(plain.to_xarray().sizes) == {"wheel.y": 4, "wheel.z": 2}
    assert len(plain.to_pandas()) == 8


def test_contacts_carry_the_force_of_the_evaluation(wheel):
    for y in (0.75, 0.7554):
        at = {"y": y, "z": float(wheel.touching_height(y=y)) + 8e-5}
        found = wheel.contacts(**at)
        result = wheel.evaluate(**at)
        fields = [field for contact in found for field in contact.fields]
        forces = sorted(field.normal_force for field in fields)
        patches = sorted(float(result[f"patch[{k}].normal_force"]) for k in (1, 2) if result.patch_count >= k)
        # Elements at the edge hold a part of their area.
        np.testing.assert_allclose(forces, patches, rtol=0.02)
        assert fields[0].pressure.shape == (len(fields[0].y), len(fields[0].x))
    with pytest.raises(wheelrail.BadValueError, match="one position"):
        wheel.contacts(y=[0.75, 0.751])
