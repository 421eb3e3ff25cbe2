"""Contacts per second by cores and models, and what an array call adds to the crate's own loop.

    cargo build --release --example crate_loop && python benchmarks/throughput.py

Writes a table in Markdown to standard output; docs/python.md has it.
"""

from __future__ import annotations

import os
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
import wheelrail

HERE = Path(__file__).parent.parent
MODELS = (
    ("hertz", "fastsim", 100_000),
    ("piotrowski_kik", "fastsim", 100_000),
    ("piotrowski_kik", "tables", 100_000),
    ("strips", "tables", 20_000),
    ("strips", "fastsim_corrected", 20_000),
)
REPEATS = 5


def main() -> None:
    loop = HERE / "target/release/examples/crate_loop"
    start = wheelrail.Element().parameters
    default = start["normal.model"], start["tangential.model"]
    cores = len(os.sched_getaffinity(0))
    print(f"| models | crate's loop [1/s] | array call, one thread [1/s] | overhead | {cores} threads [1/s] | speed-up |")
    print("|---|---|---|---|---|---|")
    for normal, tangential, rows in MODELS:
        wheel = wheelrail.Element(
            normal_model=normal, tangential_model=tangential, vx=20.0, pitch_rate=-20.0 / 0.46
        )
        random = np.random.default_rng(7)
        y, yaw = 0.75 + random.uniform(-5e-3, 5e-3, rows), random.normal(0.0, 2e-3, rows)
        inputs = {"y": y, "yaw": yaw, "z": wheel.touching_height(y=y, yaw=yaw) + 6e-5}
        times = {"loop": [], 1: [], cores: []}
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "cases"
            np.stack(list(inputs.values()), axis=1).tofile(path)
            for _ in range(REPEATS):
                # In turns: what else the machine does strikes all alike.
                command = [str(loop), str(path), normal, tangential]
                if loop.is_file():
                    times["loop"].append(float(subprocess.run(command, check=True, capture_output=True).stdout))
                for threads in (1, cores):
                    best = []
                    for _ in range(3):
                        begin = time.perf_counter()
                        wheel.evaluate(**inputs, outputs="wheel.force.*", threads=threads)
                        best.append(time.perf_counter() - begin)
                    times[threads].append(min(best))
        best = {name: min(found) if found else np.nan for name, found in times.items()}
        mark = " (as it starts)" if (normal, tangential) == default else ""
        rates = [rows / best[name] for name in ("loop", 1, cores)]
        print(
            f"| `{normal}` + `{tangential}`{mark} | {rates[0]:,.0f} | {rates[1]:,.0f} | "
            f"{100 * (best[1] / best['loop'] - 1):.1f} % | {rates[2]:,.0f} | {best[1] / best[cores]:.2f} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
