"""Writes package/wheelrail/_keywords.py: the variables of both units as keywords that type checkers know.

Run: python make_keywords.py, with the package installed.
"""

from pathlib import Path

from wheelrail import Column, variables
from wheelrail._variables import is_evaluated

TYPES = {"real": "float", "integer": "int", "boolean": "bool", "text": "str | os.PathLike[str]"}


def main() -> str:
    lines = [
        '"""Inputs and parameters as keywords, outputs as attributes. Made by make_keywords.py: do not change it by hand."""',
        "",
        "from __future__ import annotations",
        "",
        "import os",
        "from typing import Any, Literal, TypedDict",
        "",
        "import numpy.typing as npt",
        "",
        "from ._result import Result",
        "",
        "__all__ = [",
        '    "ElementInputs",',
        '    "ElementParameters",',
        '    "ElementResult",',
        '    "WheelSetInputs",',
        '    "WheelSetParameters",',
        '    "WheelSetResult",',
        "]",
    ]
    for unit, name in (("WheelRail", "Element"), ("WheelSet", "WheelSet")):
        inputs = [v for v in variables(unit) if v.causality == "input"]
        parameters = [v for v in variables(unit) if v.causality == "parameter"]
        lines += ["", "", f"class {name}Inputs(TypedDict, total=False):"]
        lines += [f'    """Inputs of `wheelrail.{name}.evaluate`, arrays that broadcast."""', ""]
        for v in inputs:
            lines += [f"    {v.keyword}: npt.ArrayLike", *described(v)]
        lines += ["", "", f"class {name}Parameters(TypedDict, total=False):"]
        lines += [f'    """Parameters and starting inputs of `wheelrail.{name}`."""', ""]
        for v in parameters:
            items = ", ".join(f'"{item}"' for item in v.items)
            kind = f"Literal[{items}]" if items else TYPES[v.kind]
            lines += [f"    {v.keyword}: {kind}", *described(v)]
        for v in inputs:
            lines += [f"    {v.keyword}: float", *described(v)]
        # Arrays, or numbers where every input is one: which of them depends on the values.
        lines += ["", "", f"class {name}Result(Result):"]
        lines += [f'    """What `wheelrail.{name}.evaluate` gives, for type checkers."""', ""]
        for v in variables(unit):
            if is_evaluated(v):
                lines += [f"    {attribute(v)}: Any", *described(v)]
    return "\n".join(lines) + "\n"


def attribute(variable):
    """The name of an output as an attribute of results."""
    return Column(variable.name, variable.unit).keyword


def described(variable):
    unit = f" [{variable.unit or '-'}]" if variable.kind == "real" else ""
    return [f'    """{variable.description}{unit}."""']


if __name__ == "__main__":
    path = Path(__file__).parent / "package/wheelrail/_keywords.py"
    path.write_text(main(), encoding="utf-8")
