"""More than one machine: processes of a Dask cluster, of which one is killed."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import creepage
import numpy as np
import pandas as pd
import pytest
from conftest import ROOT
from pandas.testing import assert_frame_equal

distributed = pytest.importorskip("distributed")

# 48 chains of a tenth of a second or so: time to kill somebody.
SWEEP: dict[str, dict[str, Any]] = {
    "contact": {"a_over_b": 0.5, "poisson": 0.28},
    "creepage": {
        "chi": [2.0, 1.0, 0.5, 0.2],
        "alpha": {"from": -55, "step": 10, "to": 55},
        "upsilon": [2.5, 2.0, 1.7, 1.4, 1.2, 1.0],
    },
    "solve": {"degree": 5},
}
EXACT = creepage.exact(1.3, 0.28, resolution="fast")
CASES = pd.DataFrame(
    np.random.default_rng(1967).uniform(-2.0, 2.0, (1500, 3)), columns=["xi", "eta", "chi"]
).assign(wheel=np.arange(1500))


@pytest.fixture
def client() -> Iterator[Any]:
    """Two workers, a process each, which are started anew when they die."""
    cluster = distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    )
    with cluster, distributed.Client(cluster) as client:
        client.wait_for_workers(2, timeout=60)
        yield client


class Killer(threading.Thread):
    """Kills a worker that has finished some work and has more to do."""

    def __init__(self, client: Any) -> None:
        super().__init__(daemon=True)
        self.client = client
        self.pids = client.run(os.getpid)
        self.killed: int | None = None
        self.lost = 0

    def run(self) -> None:
        deadline = time.monotonic() + 60.0
        while time.monotonic() < deadline:
            holds, works = self.client.has_what(), self.client.processing()
            for worker, pid in self.pids.items():
                if len(holds.get(worker, ())) >= 2 and len(works.get(worker, ())) >= 2:
                    os.kill(pid, signal.SIGKILL)
                    self.killed, self.lost = pid, len(holds[worker])
                    return
            time.sleep(0.002)


def test_a_sweep_loses_nothing_with_a_worker(client: Any) -> None:
    alone = creepage.sweep(SWEEP)
    killer = Killer(client)
    killer.start()
    together = creepage.sweep(SWEEP, client=client, parts=48)
    killer.join()
    assert killer.killed is not None
    assert killer.lost >= 2
    assert_frame_equal(together, alone, check_exact=True)
    assert killer.killed not in client.run(os.getpid).values()


def test_cases_to_files_lose_nothing_with_a_worker(client: Any, tmp_path: Path) -> None:
    killer = Killer(client)
    killer.start()
    folder = creepage.batch(EXACT, CASES, client=client, parts=60, out=tmp_path / "cases")
    killer.join()
    assert killer.killed is not None
    assert [path.name for path in sorted(folder.glob("*.parquet"))] == [
        f"part-{k:05}.parquet" for k in range(60)
    ]
    found = pd.read_parquet(folder)
    force = EXACT.force(CASES.xi, CASES.eta, CASES.chi).to_dict()
    names = [*CASES.columns, "fx", "fy", "mz", "fx_error", "fy_error", "mz_error", "status"]
    assert_frame_equal(
        found.drop(columns="message"), CASES.assign(**force)[names], check_exact=True
    )


def test_parts_without_a_client(tmp_path: Path) -> None:
    small = {**SWEEP, "creepage": {"chi": [2.0, 1.0], "alpha": [0.0, 30.0], "upsilon": [2.0, 1.5]}}
    table = creepage.sweep(small)
    folder = creepage.sweep(small, out=tmp_path / "sweep", parts=3)
    assert len(list(folder.glob("*.parquet"))) == 3
    assert_frame_equal(pd.read_parquet(folder), table, check_exact=True)
    plain = creepage.batch(EXACT, {"xi": [0.1, 0.2], "chi": [0.0, 0.5]})
    assert plain.fx.tolist() == EXACT.force([0.1, 0.2], 0.0, [0.0, 0.5]).fx.tolist()
    assert plain.status.tolist() == ["solved", "solved"]


SMALL = {**SWEEP, "creepage": {"chi": [2.0, 1.0], "alpha": [0.0, 30.0, 60.0], "upsilon": [2.0]}}


def written(folder: Path) -> dict[str, int]:
    """When each part was written."""
    return {path.name: path.stat().st_mtime_ns for path in folder.glob("*.parquet")}


def test_a_sweep_goes_on_with_the_parts_that_are_missing(tmp_path: Path) -> None:
    folder = creepage.sweep(SMALL, out=tmp_path / "sweep", parts=6)
    first, whole = written(folder), pd.read_parquet(folder)
    assert creepage.sweep(SMALL, out=folder, parts=6) == folder
    assert written(folder) == first
    gone = {"part-00001.parquet", "part-00004.parquet"}
    for name in gone:
        (folder / name).unlink()
    (folder / ".creepage-part-00001.parquet-0.partial").touch()  # left by a worker that died
    creepage.sweep(SMALL, out=folder, parts=6)
    again = written(folder)
    assert {name for name in again if again[name] != first[name]} == gone
    assert not list(folder.glob(".*.partial"))
    assert_frame_equal(pd.read_parquet(folder), whole, check_exact=True)


def test_parts_of_two_runs_do_not_mix(tmp_path: Path) -> None:
    sweep = creepage.sweep(SMALL, out=tmp_path / "sweep", parts=2)
    (sweep / "part-00001.parquet").unlink()
    other = {**SMALL, "contact": {"a_over_b": 0.4, "poisson": 0.28}}
    for source, parts in ((other, 2), (SMALL, 3)):
        with pytest.raises(FileExistsError, match="another run"):
            creepage.sweep(source, out=sweep, parts=parts)
    cases: dict[str, Any] = {"xi": [0.1, 0.2, 0.3], "name": ["a", "b", "c"]}
    folder = creepage.batch(EXACT, cases, out=tmp_path / "cases", parts=2)
    (folder / "part-00000.parquet").unlink()
    fine = creepage.exact(1.3, 0.28)
    changes: list[tuple[creepage.Theory, dict[str, Any]]] = [
        (EXACT, {"xi": [0.1, 0.2, 0.4]}),
        (EXACT, {"name": ["a", "b", "d"]}),
        (fine, {}),
    ]
    for theory, change in changes:
        with pytest.raises(FileExistsError, match="another run"):
            creepage.batch(theory, {**cases, **change}, out=folder, parts=2)
    creepage.batch(EXACT, cases, out=folder, parts=2)
    assert pd.read_parquet(folder).name.tolist() == ["a", "b", "c"]
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "notes.txt").touch()
    with pytest.raises(FileExistsError, match="not empty"):
        creepage.sweep(SMALL, out=tmp_path / "mine")


def test_a_sweep_that_was_killed_goes_on(tmp_path: Path) -> None:
    folder = tmp_path / "sweep"
    script = (
        "import sys, json, creepage\n"
        "creepage.sweep(json.loads(sys.argv[1]), out=sys.argv[2], parts=48)"
    )
    run = subprocess.Popen([sys.executable, "-c", script, json.dumps(SWEEP), str(folder)])
    deadline = time.monotonic() + 60.0
    while len(written(folder)) < 3 and run.poll() is None and time.monotonic() < deadline:
        time.sleep(0.002)
    run.kill()
    assert run.wait() == -signal.SIGKILL  # before it was done
    first = written(folder)
    assert 3 <= len(first) < 48
    creepage.sweep(SWEEP, out=folder, parts=48)
    again = written(folder)
    assert len(again) == 48
    assert {name: again[name] for name in first} == first
    assert_frame_equal(pd.read_parquet(folder), creepage.sweep(SWEEP), check_exact=True)


def test_the_page_of_the_guide_runs(tmp_path: Path) -> None:
    page = (ROOT / "book" / "pages" / "how-to" / "many-machines.md").read_text()
    script = tmp_path / "here.py"
    script.write_text(re.findall(r"^```python\n(.*?)^```", page, re.M | re.S)[0])
    done = subprocess.run(
        [sys.executable, "-W", "error", str(script)],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert len(pd.read_parquet(tmp_path / "forces")) == 20_000


def test_errors(client: Any) -> None:
    with pytest.raises(creepage.CaseError, match="a_over_b"):
        creepage.sweep({**SWEEP, "contact": {"a_over_b": -1.0, "poisson": 0.28}}, client=client)
    rows = creepage.batch(EXACT, {"xi": [0.1, np.nan]}, client=client)
    assert rows.status.tolist() == ["solved", "invalid"]
    with pytest.raises(ValueError, match="none of the columns"):
        creepage.batch(EXACT, {"x": [1.0]})
    with pytest.raises(ValueError, match="parts"):
        creepage.batch(EXACT, {"xi": [1.0]}, parts=0)
    assert creepage.batch(EXACT, {"xi": []}).empty
