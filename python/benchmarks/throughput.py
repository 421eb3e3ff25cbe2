"""Contacts per second by cores and models, and what an array call adds to the crate's own loop.

    cargo build --release --example crate_loop && python benchmarks/throughput.py

Prints a table in Markdown; with --write it goes into docs/python.md. Everything is measured by the wall clock in short runs that take
turns, and the best of each counts: a moment in which the machine does nothing else is enough for a figure.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
import wheelrail
from document import write_table

PYTHON = Path(__file__).parent.parent
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", PYTHON / "target"))
#: Normal, creepage and tangential model, and rows that take some tenths of a second, shared evenly among threads.
MODELS = (
    ("hertz", "flat", "fastsim", 20_000),
    ("piotrowski_kik", "flat", "fastsim", 20_000),
    ("piotrowski_kik", "flat", "tables", 20_000),
    ("strips", "curved", "tables", 2_000),
    ("strips", "curved", "marches", 2_000),
    ("boundary_element", "curved", "boundary_element", 64),
)
#: Elements of the boundary element solution along and across, as in the scoreboard.
ELEMENTS = 40
#: How often a round goes through the rows, with the crate's loop and with each number of threads.
PASSES = 3


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=10, help="times that all take their turns")
    parser.add_argument("--write", action="store_true", help="write the table into docs/python.md")
    arguments = parser.parse_args()
    start = wheelrail.Element().parameters
    default = [start[f"{what}.model"] for what in ("normal", "creepage", "tangential")]
    cores = len(os.sched_getaffinity(0))
    lines = [
        f"| models | crate's loop [1/s] | array call, 1 thread [1/s] | overhead | a million [s] | {cores} threads [1/s] | speed-up |",
        "|---|---|---|---|---|---|---|",
    ]
    print(*lines, sep="\n")
    for *models, rows in MODELS:
        best = times(models, rows, cores, arguments.rounds)
        mark = " (by default)" if models == default else ""
        rates = [f"{rows / best[name]:,.0f}" for name in ("loop", 1, cores)]
        overhead = f"{100 * (best[1] / best['loop'] - 1):.1f} %"
        normal, creepage, tangential = models
        lines.append(
            f"| `{normal}`, {creepage} + `{tangential}`{mark} | {rates[0]} | {rates[1]} | {overhead} "
            f"| {1e6 * best[1] / rows:,.0f} | {rates[2]} | {best[1] / best[cores]:.2f} |"
        )
        print(lines[-1], flush=True)
    if arguments.write:
        write_table("throughput", lines)


def times(models: list[str], rows: int, cores: int, rounds: int) -> dict[str | int, float]:
    """Least time of the crate's loop, and of an array call by its threads [s]."""
    settings = dict(zip(("normal.model", "creepage.model", "tangential.model"), models))
    settings |= {"normal.elements_along": ELEMENTS, "normal.elements_across": ELEMENTS}
    settings |= {"wheel.vx": 20.0, "wheel.pitch_rate": -20.0 / 0.46}
    wheel = wheelrail.Element(settings)
    random = np.random.default_rng(7)
    y, yaw = 0.75 + random.uniform(-4e-3, 4e-3, rows), random.normal(0.0, 2e-3, rows)
    inputs = {"y": y, "yaw": yaw, "z": wheel.touching_height(y=y, yaw=yaw) + 6e-5}
    best: dict[str | int, float] = {"loop": np.inf, 1: np.inf, cores: np.inf}
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "cases"
        np.stack(list(inputs.values()), axis=1).tofile(path)
        for _ in range(rounds):
            command = [TARGET / "release/examples/crate_loop", path, str(PASSES)]
            command += [f"{name}={value}" for name, value in settings.items()]
            found = subprocess.run(command, check=True, capture_output=True, text=True)
            best["loop"] = min(best["loop"], float(found.stdout))
            for threads in (1, cores):
                for _ in range(PASSES):
                    begin = time.perf_counter()
                    wheel.evaluate(**inputs, outputs="wheel.force.*", threads=threads)
                    best[threads] = min(best[threads], time.perf_counter() - begin)
    return best


if __name__ == "__main__":
    main()
