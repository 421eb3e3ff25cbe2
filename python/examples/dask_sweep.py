"""A million contacts by Dask, on the cores of this machine or on a cluster.

    python dask_sweep.py sweep.parquet                          # a cluster of processes on this machine
    python dask_sweep.py sweep.parquet --rows 100000000 --scheduler tcp://10.0.0.7:8786

Needs pip install "wheelrail[dask]", on the workers too. Memory stays bounded: each partition is made, evaluated and
written by itself. A worker that is lost costs the partitions it was at: others compute them anew.
"""

from __future__ import annotations

import argparse

import dask.dataframe
import numpy as np
import pandas
import wheelrail.dask
from dask.distributed import Client, LocalCluster, progress

ROWS_AT_ONCE = 20_000
#: Quick models: a million contacts in minutes on one machine.
WHEEL = {
    "normal_model": "piotrowski_kik",
    "creepage_model": "flat",
    "tangential_model": "fastsim",
    "vertical_mode": "load",
    "vx": 20.0,
    "pitch_rate": -20.0 / 0.46,
}


def cases(number: int, rows: int) -> pandas.DataFrame:
    """Random places of a rolling wheel under load: the same ones for the same number, wherever it is made."""
    random = np.random.default_rng([20, number])
    return pandas.DataFrame(
        {
            "wheel.y": 0.75 + random.uniform(-6e-3, 6e-3, rows),
            "wheel.yaw": random.normal(0.0, 2e-3, rows),
            "wheel.vy": random.normal(0.0, 0.02, rows),
            "wheel.load": random.uniform(40e3, 120e3, rows),
            "friction.coefficient": random.uniform(0.15, 0.5, rows),
        }
    )


def table(rows: int) -> dask.dataframe.DataFrame:
    """The cases, made where they are evaluated."""
    sizes = [min(ROWS_AT_ONCE, rows - start) for start in range(0, rows, ROWS_AT_ONCE)]
    return dask.dataframe.from_map(cases, range(len(sizes)), sizes, meta=cases(0, 1).iloc[:0])


def results(rows: int) -> dask.dataframe.DataFrame:
    """What is evaluated of them; nothing is computed yet."""
    return wheelrail.dask.evaluate(
        table(rows), outputs=["wheel.force.*", "patch[1].max_pressure", "wear_number"], **WHEEL
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("target", help="folder for the results, Parquet")
    parser.add_argument("--rows", type=int, default=1_000_000)
    parser.add_argument("--scheduler", help="address of a cluster; without it one of processes here")
    arguments = parser.parse_args()
    cluster = arguments.scheduler or LocalCluster(threads_per_worker=1)
    with Client(cluster) as client:
        written = results(arguments.rows).to_parquet(arguments.target, compute=False)
        done = client.compute(written)
        progress(done)
        done.result()
    print(f"\n{arguments.rows} contacts in {arguments.target}")


if __name__ == "__main__":
    main()
