"""Planar problems, conicity, wear, tables, bulk and what the package carries."""

import os

import numpy as np
import pytest
import wheelrail
from wheelrail import conicity, planar

ROLLING = {"vx": 20.0, "pitch_rate": -20.0 / 0.46}
QUICK = {"normal_model": "piotrowski_kik", "tangential_model": "fastsim", **ROLLING}


def sphere(radius=0.3):
    y = np.linspace(-0.01, 0.01, 401)
    return y, y**2 / (2 * radius)


def test_a_sphere_is_that_of_hertz():
    y, f = sphere()
    approach = np.array([1e-5, 2e-5])
    found = planar.solve(y, f, radius=0.3, approach=approach, normal_model="hertz", tangential_model="none")
    modulus = 2.1e11 / (2 * (1 - 0.28**2))
    # N = 4/3 E* sqrt(R) δ^(3/2), two equal bodies.
    np.testing.assert_allclose(found["normal_force"], 4 / 3 * modulus * 0.3**0.5 * approach**1.5, rtol=1e-5)


def test_planar_problems_broadcast_and_loads_are_carried():
    y, f = sphere()
    found = planar.solve(y, f, radius=0.3, load=[[1e4], [5e4]], spin=[0.0, 0.1, 0.2], **_models())
    assert found.shape == (2, 3)
    np.testing.assert_allclose(found["normal_force"], [[1e4] * 3, [5e4] * 3], rtol=1e-9)
    fields = planar.fields(y, f, radius=0.3, load=5e4, spin=0.2, **_models())
    np.testing.assert_allclose(sum(field.normal_force for field in fields), 5e4, rtol=0.02)


def _models():
    return {name: value for name, value in QUICK.items() if name.endswith("model")}


def test_planar_refusals_are_named():
    y, f = sphere()
    with pytest.raises(wheelrail.BadValueError, match="either approach or load"):
        planar.solve(y, f, radius=0.3)
    with pytest.raises(wheelrail.BadValueError, match="radius = -1") as caught:
        planar.solve(y, f, radius=[0.3, -1.0], approach=1e-5)
    assert caught.value.row == 1
    masked = planar.solve(y, f, radius=[0.3, -1.0], approach=1e-5, errors="nan")
    assert masked.valid.tolist() == [True, False] and np.isnan(masked["normal_force"][1])
    assert list(masked.refusals) == [1] and "radius = -1" in masked.refusals[1]
    with pytest.raises(wheelrail.BadValueError, match="one f for each y"):
        planar.solve(y, f[1:], radius=0.3, approach=1e-5)


def test_a_cone_has_the_conicity_of_its_tangent():
    table = conicity.table(wheel_profile="conical:0.05", step=5e-4)
    swings = table.inputs["y"] > 1e-3
    found = table["conicity"][swings]
    np.testing.assert_allclose(found[np.isfinite(found)], 0.05, rtol=2e-2)
    y = np.linspace(-5e-3, 5e-3, 11)
    np.testing.assert_allclose(conicity.equivalent(y, 2 * 0.1 * y, [1e-3, 4e-3]), 0.1, rtol=1e-9)
    with pytest.raises(wheelrail.BadValueError, match="y has to grow"):
        conicity.equivalent(y[::-1], y, 1e-3)


def test_contact_geometry_is_symmetric_and_agrees_with_the_rigid_table_without_roll():
    y = np.linspace(-4e-3, 4e-3, 9)
    found = conicity.contact_geometry(y, **_models())
    np.testing.assert_allclose(found["difference"], -found["difference"][::-1], atol=1e-9)
    np.testing.assert_allclose(found["roll"], -found["roll"][::-1], atol=1e-9)
    rigid = conicity.table(range=4e-3, step=1e-3)
    # Roll is of the order of 1e-4 and moves the contact a little.
    np.testing.assert_allclose(found["difference"], rigid["difference"], atol=0.1e-3)


def test_contact_geometry_has_no_numbers_beside_the_rail():
    found = conicity.contact_geometry([0.0, 1e-3, 0.5], **_models())
    assert np.isfinite(found["difference"][:2]).all()
    assert all(np.isnan(found[name][2]) for name in found)


def test_wear_takes_material_off_and_stays():
    run = wheelrail.WearRun(wear_model="frictional_work", wear_acceleration_factor=1e6, vy=0.05, **QUICK)
    z = wheelrail.Element(**QUICK).nominal_z + 6e-5
    first = run.advance(y=[0.75, 0.7505, 0.751], z=z, duration=0.01)
    area = first["wear.wheel.area"]
    assert (np.diff(area) > 0).all()
    again = run.advance(y=0.75, z=z, duration=[0.01, 0.01])
    assert again["wear.wheel.area"][0] > area[-1]
    assert run.depth("wheel")[:, 1].max() > 0 and run.profile("rail[1]").shape == (1000, 2)
    with pytest.raises(wheelrail.BadValueError, match="frictional_work"):
        wheelrail.WearRun()
    for points in (1, -3, 10.5):
        with pytest.raises(wheelrail.BadValueError, match="points = .* 2 to 1000000"):
            run.profile(points=points)
    with pytest.raises(wheelrail.BadValueError, match="duration"):
        run.advance(y=0.75, duration=-1.0)


def test_rows_of_a_table_can_have_their_own_parameters():
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(
        {
            "wheel.y": [0.75, 0.751, 0.75, 0.752],
            "wheel.z": -0.4597,
            "wheel.profile": ["S1002", "conical:0.05", "S1002", None],
            "rail1_inclination": [0.025, 0.025, 0.05, np.nan],
        },
        index=list("abcd"),
    )
    found = wheelrail.evaluate(table, inputs=False, **_models())
    assert list(found.index) == list("abcd")
    for row, own in enumerate([{}, {"wheel_profile": "conical:0.05"}, {"rail1_inclination": 0.05}, {}]):
        wheel = wheelrail.Element(**_models(), **own)
        alone = wheel.evaluate(y=table["wheel.y"].iloc[row], z=-0.4597)
        assert found["wheel.force.z"].iloc[row] == alone["wheel.force.z"]
    table.loc["c", "wheel.y"] = np.nan
    with pytest.raises(wheelrail.BadValueError) as caught:
        wheelrail.evaluate(table)
    assert caught.value.row == 2
    assert wheelrail.evaluate(table, errors="nan")["valid"].tolist() == [True, True, False, True]
    assert list(wheelrail.evaluate(table.iloc[:0], inputs=False)) == list(found)
    with pytest.raises(wheelrail.BadValueError, match="takes a DataFrame"):
        wheelrail.evaluate({"wheel.y": [0.75]})


@pytest.mark.parametrize("kind", ["csv", "parquet"])
def test_bulk_is_the_whole_piece_by_piece(tmp_path, kind):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    from wheelrail import bulk

    random = np.random.default_rng(2)
    table = pandas.DataFrame({"wheel.y": 0.75 + random.uniform(-5e-3, 5e-3, 1000), "wheel.z": -0.4597})
    source, target = tmp_path / f"cases.{kind}", tmp_path / f"found.{kind}"
    getattr(table, f"to_{kind}")(source, index=False)
    told = []
    count = bulk.evaluate(
        source, target, rows_at_once=300, outputs="wheel.force.*",
        progress=lambda done, rows: told.append(done), **_models(),
    )  # fmt: skip
    assert count == 1000 and told == [300, 600, 900, 1000]
    assert sorted(os.listdir(tmp_path)) == sorted([source.name, target.name])
    written = getattr(pandas, f"read_{kind}")(target)
    serial = wheelrail.evaluate(table, outputs="wheel.force.*", threads=1, **_models())
    np.testing.assert_array_equal(written["wheel.force.z"], serial["wheel.force.z"])
    np.testing.assert_array_equal(written["wheel.y"], table["wheel.y"])
    with pytest.raises(wheelrail.BadValueError, match="take the place of its source"):
        bulk.evaluate(source, source)
    table.loc[700, "wheel.y"] = np.nan
    with pytest.raises(wheelrail.BadValueError) as caught:
        bulk.evaluate(table, tmp_path / f"other.{kind}", rows_at_once=300)
    assert caught.value.row == 700
    assert not (tmp_path / f"other.{kind}").exists()


def test_profiles_are_points():
    wheel = wheelrail.profile("S1002", points=500)
    assert wheel.shape == (500, 2)
    # The nominal rolling circle is the origin.
    tread = wheel[np.abs(wheel[:, 0]) < 0.5e-3]
    assert np.abs(tread[:, 1]).max() < 1e-4
    assert wheelrail.profile("S1002_worn.txt").shape == (1000, 2)
    with pytest.raises(wheelrail.ProfileError) as caught:
        wheelrail.profile("60E1", "wheel")
    assert caught.value.variable == "wheel.profile"
    with pytest.raises(wheelrail.BadValueError, match="wheel or rail"):
        wheelrail.profile("S1002", "axle")
    with pytest.raises(wheelrail.BadValueError, match="points = 10.5"):
        wheelrail.profile("S1002", points=10.5)


def test_what_was_mended_in_a_profile_is_told(tmp_path):
    points = wheelrail.profile("S1002", points=400)
    path = tmp_path / "metres.txt"
    np.savetxt(path, points[::-1])
    with pytest.warns(wheelrail.ContactWarning, match="wheel.profile"):
        wheelrail.Element(wheel_profile=path)


@pytest.mark.parametrize("name", ["WheelRail", "WheelRail3"])
def test_the_fmus_of_the_package_give_the_same_forces(name):
    fmpy = pytest.importorskip("fmpy")
    wheel = wheelrail.Element(**ROLLING)
    z = wheel.nominal_z + 1e-4
    signals = np.array([(0.0, z), (1e-3, z)], dtype=[("time", float), ("wheel.z", float)])
    found = fmpy.simulate_fmu(
        str(wheelrail.fmu(name)),
        start_values={"wheel.vx": ROLLING["vx"], "wheel.pitch_rate": ROLLING["pitch_rate"]},
        input=signals, output=["wheel.force.z", "wheel.force.y"], stop_time=1e-3, output_interval=1e-3,
    )  # fmt: skip
    here = wheel.evaluate(z=z)
    for force in ("wheel.force.z", "wheel.force.y"):
        # Other builds of the same source differ in the last digits.
        np.testing.assert_allclose(found[force][-1], here[force], rtol=1e-9)
    assert wheelrail.fmu(name.replace("Rail", "Set")).is_file()
    with pytest.raises(wheelrail.BadValueError):
        wheelrail.fmu("Wheel")


@pytest.mark.parametrize("unit", ["WheelRail", "WheelSet3"])
def test_a_packed_unit_brings_its_profiles_along(unit, tmp_path):
    fmpy = pytest.importorskip("fmpy")
    side = "right." if "Set" in unit else ""
    own = tmp_path / "own.txt"
    own.write_bytes((wheelrail.profile_folder() / "S1002_worn.txt").read_bytes())
    values = {f"{side}friction.coefficient": 0.25, "normal.model": "hertz"}
    packed = wheelrail.pack(tmp_path / "Own.fmu", wheel=own, rail="54E1", values=values, unit=unit)
    first = packed.read_bytes()
    assert wheelrail.pack(packed, wheel=own, rail="54E1", values=values, unit=unit).read_bytes() == first
    own.unlink()
    description = fmpy.read_model_description(str(packed))
    starts = {v.name: v.start for v in description.modelVariables}
    assert description.modelName == "Own" and starts[f"{side}wheel.profile"] == "own.txt"
    assert float(starts[f"{side}friction.coefficient"]) == 0.25 and starts["normal.model"] == "1"
    force = "wheelset.force.z" if side else "wheel.force.z"
    assert fmpy.simulate_fmu(str(packed), output=[force], stop_time=1e-3)[force][0] < -1e3
    with pytest.raises(wheelrail.BadValueError, match="nowhere.prw"):
        wheelrail.pack(tmp_path / "None.fmu", wheel="nowhere.prw", unit=unit)
    with pytest.raises(wheelrail.UnknownVariableError):
        wheelrail.pack(tmp_path / "None.fmu", values={"wheel.q": 1.0}, unit=unit)
    assert not (tmp_path / "None.fmu").exists()


def test_licences_are_there():
    import importlib.metadata

    files = [str(file) for file in importlib.metadata.files("wheelrail") or []]
    for name in ("LICENSE-MIT", "LICENSE-APACHE", "third_party.txt"):
        assert any(file.endswith(name) for file in files), name
