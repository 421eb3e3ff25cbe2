"""Names, types and documents that could go stale."""

import importlib
import inspect
import os
import pkgutil
import re
import runpy
import subprocess
import sys
from pathlib import Path

import pytest
import wheelrail

HERE = Path(__file__).parent.parent


def public():
    """Everything that a user can name."""
    seen = [("wheelrail", wheelrail)]
    for module in pkgutil.iter_modules(wheelrail.__path__):
        if module.name.startswith("_"):
            continue
        try:
            loaded = importlib.import_module(f"wheelrail.{module.name}")
        except ImportError:
            # Of an extra that is not installed.
            continue
        seen.append((loaded.__name__, loaded))
        seen += [(f"{loaded.__name__}.{name}", getattr(loaded, name)) for name in loaded.__all__]
    seen += [(f"wheelrail.{name}", getattr(wheelrail, name)) for name in wheelrail.__all__]
    for name, thing in list(seen):
        if inspect.isclass(thing):
            seen += [
                (f"{name}.{member}", found)
                for member, found in vars(thing).items()
                if not member.startswith("_") and (callable(found) or isinstance(found, property))
            ]
    return [(name, thing) for name, thing in seen if name != "wheelrail.__version__"]


def test_everything_public_has_a_docstring():
    assert [name for name, thing in public() if not inspect.getdoc(thing)] == []


def test_parameters_of_functions_are_documented():
    missing = []
    for name, thing in public():
        if not inspect.isfunction(thing):
            continue
        doc = thing.__doc__ or ""
        for parameter in inspect.signature(thing).parameters.values():
            if parameter.name != "self" and parameter.name not in doc:
                missing.append(f"{name}: {parameter.name}")
    assert missing == []


def test_keywords_are_those_of_the_variables():
    made = runpy.run_path(str(HERE / "make_keywords.py"))["main"]()
    path = HERE / "package/wheelrail/_keywords.py"
    assert path.read_text(encoding="utf-8") == made, "run python make_keywords.py"


def test_every_keyword_is_of_one_variable():
    for unit in ("WheelRail", "WheelSet"):
        settable = [v for v in wheelrail.variables(unit) if v.causality in ("input", "parameter")]
        keywords = [v.keyword for v in settable]
        assert len(set(keywords)) == len(keywords)
        assert all(keyword.isidentifier() for keyword in keywords)


def test_stubs_are_those_of_the_module(tmp_path):
    pytest.importorskip("mypy")
    command = [sys.executable, "-m", "mypy.stubtest", "wheelrail._native"]
    command += ["--mypy-config-file", str(HERE / "pyproject.toml")]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


def test_types_are_strict(tmp_path):
    pytest.importorskip("mypy")
    user = tmp_path / "user.py"
    user.write_text(
        "import wheelrail\n"
        "wheel = wheelrail.Element(normal_model='hertz', vx=20.0)\n"
        "force = wheel.evaluate(y=[0.75], z=-0.4597)['wheel.force.z']\n"
        "wheelrail.Element(normal_model='herz')\n"
        "wheel.evaluate(yy=1.0)\n"
        "print(wheel.evaluate().wheel_force_z, wheel.evaluate()['patch_count'])\n"
        "wheel.evaluate().wheel_force_zz\n"
        "wheelrail.WheelSet().evaluate().wheelset_force_y + 1.0\n"
    )
    command = [sys.executable, "-m", "mypy", "--strict", str(user), "--cache-dir", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    lines = [line for line in done.stdout.splitlines() if "error" in line and "user.py" in line]
    places = ["user.py:4", "user.py:5", "user.py:7"]
    assert len(lines) == 3 and all(at in line for at, line in zip(places, lines)), done.stdout


@pytest.mark.parametrize("document", ["README.md", "python/README.md"])
def test_the_ten_lines_of_the_readme_print_what_it_says(document):
    path = HERE.parent / document
    text = path.read_text(encoding="utf-8")
    found = re.search(r"```python\n(.*?)```\n\n```text\n(.*?)```", text, re.DOTALL)
    done = subprocess.run(
        [sys.executable, "-c", found[1]], capture_output=True, text=True, check=True, cwd=HERE.parent.anchor
    )
    if os.environ.get("UPDATE_DOCS"):
        path.write_text(text.replace(found[2], done.stdout), encoding="utf-8")
    else:
        stale = f"{document} says\n{found[2]}but it prints\n{done.stdout}: run UPDATE_DOCS=1 pytest"
        assert prints_the_same(done.stdout, found[2]), stale


NUMBER = r"-?\d+(?:\.(\d*))?"


def prints_the_same(printed, written):
    """The same words, and numbers that are at most one apart in the last digit of their line.

    A small change of a result can turn the rounding of what is printed.
    """

    def words(text):
        return [re.sub(NUMBER, " # ", line).split() for line in text.splitlines()]

    if words(printed) != words(written):
        return False
    for lines in zip(printed.splitlines(), written.splitlines()):
        found, said = (list(re.finditer(NUMBER, line)) for line in lines)
        digits = max((len(number[1] or "") for number in found + said), default=0)
        # Half a digit more than one: 0.3 - 0.2 is not quite 0.1.
        if any(abs(float(f[0]) - float(s[0])) >= 1.5 * 10.0**-digits for f, s in zip(found, said)):
            return False
    return True


def test_printed_numbers_may_be_one_apart_in_their_last_digit():
    said = "count 3\nforce [kN]  [ 17.  -9.9]"
    assert prints_the_same("count 3\nforce [kN]  [ 17.1 -10. ]", said)
    assert not prints_the_same("count 3\nforce [kN]  [ 18.  -9.9]", said)
    assert not prints_the_same("count 3\nforce [kN]  [ 17.  -9.7]", said)
    assert not prints_the_same("count 5\nforce [kN]  [ 17.  -9.9]", said)
    assert not prints_the_same("count 3\nforce  [N]  [ 17.  -9.9]", said)
    assert not prints_the_same("count 3\nforce [kN]  [ 17.]", said)
    assert not prints_the_same(said + "\nmore", said)


def test_the_fmu_of_the_readme_runs(tmp_path):
    pytest.importorskip("fmpy")
    text = (HERE.parent / "README.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    code = next(block for block in blocks if "fmpy" in block)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=tmp_path)
    assert "(0.1 ," in done.stdout or "(0.1," in done.stdout


def test_links_of_the_documents_lead_somewhere():
    root = HERE.parent
    for document in [root / "README.md", *(root / "docs").glob("*.md")]:
        for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", document.read_text(encoding="utf-8")):
            if "://" not in target:
                assert (document.parent / target).exists(), f"{document.name}: {target}"


def test_the_examples_of_docstrings_run():
    import doctest

    for name in ("_element",):
        module = importlib.import_module(f"wheelrail.{name}")
        found = doctest.testmod(module)
        assert found.attempted and not found.failed
