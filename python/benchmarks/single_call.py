"""What a call for one row costs beside a row of an array, by models and by what is given.

    python benchmarks/single_call.py

Prints a table in Markdown; with --write it goes into docs/python.md. A call is one of numbers, for a step in time: it evaluates the
forces and reads one. The row is one of many equal ones in an array, on one thread. Both take turns in short runs, by the time that the
thread has a core, and the least time of each counts.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable

import numpy as np
import wheelrail
from document import write_table

ROLLING = {"vx": 20.0, "pitch_rate": -20.0 / 0.46}
DEPTH, LOAD = 6e-5, 8e4
#: Normal and tangential model; without them those that the element starts with.
MODELS = (
    {"normal_model": "piotrowski_kik", "creepage_model": "flat", "tangential_model": "fastsim"},
    {},
)
#: Time that a run should take [s].
RUN = 0.02


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=40, help="runs of each kind")
    parser.add_argument("--write", action="store_true", help="write the table into docs/python.md")
    arguments = parser.parse_args()
    lines = [
        "| | models | given | row of an array [µs] | single call [µs] | more [µs] | ratio |",
        "|---|---|---|---|---|---|---|",
    ]
    print(*lines, sep="\n")
    for models in MODELS:
        for kind in (wheelrail.Element, wheelrail.WheelSet):
            for mode in ("height", "load"):
                lines.append(measured(kind, models, mode, arguments.rounds))
                print(lines[-1], flush=True)
    if arguments.write:
        write_table("single calls", lines)


def measured(kind: type, models: dict[str, str], mode: str, rounds: int) -> str:
    """The row of the table for a wheel or a wheelset, height given or load given."""
    wheel = kind(**models, **ROLLING, vertical_mode="load" if mode == "load" else "penetration")
    is_wheel = kind is wheelrail.Element
    inputs = {"y": 0.751 if is_wheel else 1e-3, "yaw": 1e-3}
    if mode == "height":
        inputs["z"] = wheel.nominal_z + DEPTH
    elif is_wheel:
        inputs["load"] = LOAD
    else:
        inputs |= {"right_wheel_load": LOAD, "left_wheel_load": LOAD}
    force = "wheel.force.y" if is_wheel else "wheelset.force.y"

    def call() -> float:
        return wheel.evaluate(**inputs, outputs=force)[force]

    call()
    count = max(3, int(RUN / duration(call, 3)))
    rows = {name: np.full(count, value) for name, value in inputs.items()}

    def array() -> None:
        wheel.evaluate(**rows, outputs=force, threads=1)

    row = single = np.inf
    for _ in range(rounds):
        row = min(row, duration(array, 1) / count)
        single = min(single, duration(call, count))
    names = "as it starts" if not models else " + ".join(f"`{models[f'{m}_model']}`" for m in ("normal", "tangential"))
    more = 1e6 * (single - row)
    return f"| `{kind.__name__}` | {names} | {mode} | {1e6 * row:.1f} | {1e6 * single:.1f} | {more:.1f} | {single / row:.2f} |"


def duration(work: Callable[[], object], times: int) -> float:
    """Time on the core of each of some repetitions [s]."""
    begin = time.thread_time()
    for _ in range(times):
        work()
    return (time.thread_time() - begin) / times


if __name__ == "__main__":
    main()
