"""Contacts per second by cores and models, and what an array call adds to the crate's own loop.

    cargo build --release --example crate_loop && python benchmarks/throughput.py

Writes a table in Markdown to standard output; docs/python.md has it.
"""

from __future__ import annotations

import os
import resource
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
import wheelrail

HERE = Path(__file__).parent.parent
MODELS = (
    ("hertz", "flat", "fastsim", 50_000),
    ("piotrowski_kik", "flat", "fastsim", 50_000),
    ("piotrowski_kik", "flat", "tables", 50_000),
    ("strips", "curved", "tables", 10_000),
    ("strips", "curved", "fastsim_corrected", 10_000),
)
REPEATS = 5


def main() -> None:
    loop = HERE / "target/release/examples/crate_loop"
    start = wheelrail.Element().parameters
    default = tuple(start[f"{what}.model"] for what in ("normal", "creepage", "tangential"))
    cores = len(os.sched_getaffinity(0))
    print(f"| models | crate's loop [1/s] | array call, one thread [1/s] | overhead | {cores} threads [1/s] | speed-up | more processor time |")
    print("|---|---|---|---|---|---|---|")
    for normal, creepage, tangential, rows in MODELS:
        models = {"normal_model": normal, "creepage_model": creepage, "tangential_model": tangential}
        wheel = wheelrail.Element(**models, vx=20.0, pitch_rate=-20.0 / 0.46)
        random = np.random.default_rng(7)
        y, yaw = 0.75 + random.uniform(-5e-3, 5e-3, rows), random.normal(0.0, 2e-3, rows)
        inputs = {"y": y, "yaw": yaw, "z": wheel.touching_height(y=y, yaw=yaw) + 6e-5}
        # Processor time: what else the machine does counts little. The wall clock tells what threads gain.
        busy = {"loop": [], 1: [], cores: []}
        elapsed = {1: [], cores: []}
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "cases"
            np.stack(list(inputs.values()), axis=1).tofile(path)
            for _ in range(REPEATS):
                # In turns, so that slow minutes strike all alike.
                command = [str(loop), str(path), *models.values()]
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                subprocess.run(command, check=True, capture_output=True)
                taken = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
                # It goes through them three times.
                busy["loop"].append(taken / 3)
                for threads in (1, cores):
                    begin, start_busy = time.perf_counter(), time.process_time()
                    wheel.evaluate(**inputs, outputs="wheel.force.*", threads=threads)
                    busy[threads].append(time.process_time() - start_busy)
                    elapsed[threads].append(time.perf_counter() - begin)
        best = {name: min(found) for name, found in busy.items()}
        gain = min(elapsed[1]) / min(elapsed[cores])
        mark = " (as it starts)" if tuple(models.values()) == default else ""
        rates = [rows / best[name] for name in ("loop", 1)] + [rows / min(elapsed[cores])]
        print(
            f"| `{normal}`, {creepage} + `{tangential}`{mark} | {rates[0]:,.0f} | {rates[1]:,.0f} | "
            f"{100 * (best[1] / best['loop'] - 1):.1f} % | {rates[2]:,.0f} | {gain:.2f} | {100 * (best[cores] / best[1] - 1):.1f} % |",
            flush=True,
        )


if __name__ == "__main__":
    main()
