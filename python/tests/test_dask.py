"""Tables by Dask, on a cluster of processes that loses a worker."""

import os
import runpy
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pandas
import pytest
import wheelrail

pytest.importorskip("distributed")
EXAMPLE = Path(__file__).parent.parent / "examples/dask_sweep.py"
WHEEL = runpy.run_path(str(EXAMPLE))["WHEEL"]


def test_partitions_give_the_bits_of_a_serial_run():
    import dask.dataframe
    import wheelrail.dask

    random = np.random.default_rng(3)
    table = pandas.DataFrame(
        {"wheel.y": 0.75 + random.uniform(-5e-3, 5e-3, 300), "wheel.load": 6e4}, index=range(100, 400)
    )
    frame = dask.dataframe.from_pandas(table, npartitions=7)
    for outputs in (None, "wheel.force.*"):
        found = wheelrail.dask.evaluate(frame, outputs=outputs, **WHEEL)
        serial = wheelrail.evaluate(table, outputs=outputs, **WHEEL)
        # Columns and their types are known before anything is computed.
        assert list(found.columns) == list(serial.columns)
        assert (found.dtypes == serial.dtypes).all()
        pandas.testing.assert_frame_equal(found.compute(scheduler="synchronous"), serial, check_exact=True)
    table.iloc[5, 0] = np.nan
    frame = dask.dataframe.from_pandas(table, npartitions=3)
    masked = wheelrail.dask.evaluate(frame, errors="nan", **WHEEL).compute(scheduler="synchronous")
    assert np.flatnonzero(~masked["valid"]).tolist() == [5]


# Of loads that are jumped over: among as many places there are some.
missed = pytest.mark.filterwarnings("ignore::wheelrail.ContactWarning")


@pytest.mark.long
@missed
def test_a_million_cases_survive_the_loss_of_a_worker(tmp_path):
    sweep_with_a_loss(1_000_000, tmp_path)


@missed
def test_cases_survive_the_loss_of_a_worker(tmp_path):
    sweep_with_a_loss(100_000, tmp_path)


def sweep_with_a_loss(rows, folder):
    from distributed import Client, LocalCluster

    example = runpy.run_path(str(EXAMPLE))
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        written = client.compute(example["results"](rows).to_parquet(folder / "found", compute=False))
        lost = threading.Event()

        def kill():
            deadline = time.monotonic() + 60
            # In the midst of it: some partitions are written, others not.
            while time.monotonic() < deadline and not list((folder / "found").glob("*.parquet")):
                time.sleep(0.01)
            if not written.done():
                victim = next(iter(cluster.workers.values()))
                os.kill(victim.process.pid, signal.SIGKILL)
                lost.set()

        killer = threading.Thread(target=kill)
        killer.start()
        written.result(timeout=600)
        killer.join()
    assert lost.is_set(), "nothing was left to do when the worker was to be killed"
    serial = example["cases"]
    sizes = [example["ROWS_AT_ONCE"]] * (rows // example["ROWS_AT_ONCE"])
    wheel = wheelrail.Element(**WHEEL)
    total = 0
    files = sorted((folder / "found").glob("part.*.parquet"), key=lambda f: int(f.name.split(".")[1]))
    assert len(files) == len(sizes)
    for number, (file, size) in enumerate(zip(files, sizes)):
        found = pandas.read_parquet(file)
        cases = serial(number, size)
        expected = wheel.evaluate(cases, outputs=["wheel.force.*", "patch[1].max_pressure", "wear_number"])
        pandas.testing.assert_frame_equal(
            found.reset_index(drop=True), expected.to_pandas().reset_index(drop=True), check_exact=True
        )
        total += len(found)
    assert total == rows
