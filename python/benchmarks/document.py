"""Tables of the benchmarks in docs/python.md."""

from __future__ import annotations

from pathlib import Path

DOCUMENT = Path(__file__).parent.parent.parent / "docs/python.md"


def write_table(mark: str, lines: list[str]) -> None:
    """Puts the lines between the marks of that name."""
    begin, end = f"<!-- {mark} -->\n", f"<!-- end of {mark} -->"
    head, rest = DOCUMENT.read_text(encoding="utf-8").split(begin)
    tail = rest[rest.index(end) :]
    DOCUMENT.write_text(head + begin + "\n".join(lines) + "\n" + tail, encoding="utf-8")
