"""What a first session meets: modules on demand, small tables, short texts, labels of rows."""

import numpy as np
import pytest
import wheelrail

QUICK = {"normal_model": "piotrowski_kik", "tangential_model": "fastsim"}


def test_modules_are_found_without_importing_them():
    pytest.importorskip("pandas")
    assert wheelrail.bulk.evaluate and "bulk" in dir(wheelrail)
    with pytest.raises(AttributeError, match="no attribute 'blk'"):
        wheelrail.blk


def test_a_result_shows_a_small_table_and_completes_its_names():
    result = wheelrail.Element(**QUICK).evaluate(y=0.75 + 1e-5 * np.arange(100))
    shown = result._repr_html_()
    assert shown.count("<tr>") == 9 and "wheel.y" in shown and "wheel.force.x [N]" in shown
    assert len(shown) < 4000
    assert "wheel.force.z" in result._ipython_key_completions_()
    assert wheelrail.Element(**QUICK).evaluate()._repr_html_().count("<tr>") == 2


def test_contacts_print_short():
    wheel = wheelrail.Element(vertical_mode="load", **QUICK)
    z = float(wheel.evaluate(load=8e4)["vertical.wheel_z"])
    contact, *_ = wheelrail.Element(**QUICK).contacts(z=z)
    assert len(repr(contact)) < 160 and "rail[1] at y" in repr(contact)
    assert len(repr(contact.fields[0])) < 100 and "MPa" in repr(contact.fields[0])


def test_columns_of_a_table_and_its_labels_pass_through(tmp_path):
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame({"id": ["a", "b"], "y": [0.75, 0.751]})
    told = []
    found = wheelrail.evaluate(
        table, outputs="wheel.force.z", progress=lambda done, rows: told.append((done, rows)), **QUICK
    )
    assert list(found) == ["id", "y", "wheel.force.z"] and found["id"].tolist() == ["a", "b"]
    assert told[-1] == (2, 2)
    assert list(wheelrail.evaluate(table, outputs="wheel.force.z", inputs=False, **QUICK)) == ["wheel.force.z"]
    wheelrail.bulk.evaluate(table, tmp_path / "found.csv", outputs="wheel.force.z", **QUICK)
    assert pandas.read_csv(tmp_path / "found.csv")["id"].tolist() == ["a", "b"]


def test_a_table_with_semicolons_is_written_with_semicolons(tmp_path):
    pandas = pytest.importorskip("pandas")
    source, target = tmp_path / "cases.csv", tmp_path / "found.csv"
    source.write_text("# from a spreadsheet\nid;y;z\na;0,75;-0,4597\nb;0,751;-0,4597\n", encoding="utf-8")
    wheelrail.bulk.evaluate(source, target, outputs=["wheel.force.z"], **QUICK)
    assert target.read_text(encoding="utf-8").startswith("id;y;z;wheel.force.z\na;0.75;-0.4597;-")
    found = pandas.read_csv(target, sep=";")
    same = wheelrail.Element(**QUICK).evaluate(y=[0.75, 0.751], z=-0.4597)
    np.testing.assert_allclose(found["wheel.force.z"], same["wheel.force.z"], rtol=1e-12)


def test_help_names_the_keywords():
    for unit, names in (
        (wheelrail.Element, ("pitch_rate", "vertical_mode", "rail1_profile")),
        (wheelrail.WheelSet, ("right_rail1_y", "right_wheel_profile")),
    ):
        assert all(name in unit.__doc__ for name in names)
