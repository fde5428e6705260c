"""One handle, many threads, processes and interrupts."""

from __future__ import annotations

import multiprocessing
import signal
import sys
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from types import FrameType

import creepage
import numpy as np
import pytest
from conftest import ROOT

EXACT = creepage.exact(1.3, 0.28, resolution="fast")
FASTSIM = creepage.fastsim(1.3, 0.28, grid=(20, 20))
CASE = creepage.Case.from_toml(ROOT / "examples" / "wheel-on-rail.toml")
XI, ETA, CHI = np.random.default_rng(1967).uniform(-2.0, 2.0, (3, 400))


def test_threads_share_a_handle() -> None:
    expected = FASTSIM.force(XI, ETA, CHI)
    exact = EXACT.force(XI[:8], ETA[:8], CHI[:8])

    def ask(k: int) -> bool:
        if k % 2:
            one = EXACT.force(*(float(part[k % 8]) for part in (XI, ETA, CHI)))
            return bool(one.fx == exact.fx[k % 8])
        return bool((FASTSIM.force(XI, ETA, CHI).fy == expected.fy).all())

    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(ask, range(64)))


def test_others_run_while_an_array_is_solved() -> None:
    done = threading.Event()

    def solve() -> None:
        EXACT.force(XI, ETA, CHI)
        done.set()

    worker = threading.Thread(target=solve)
    worker.start()
    turns = 0
    while not done.is_set():
        time.sleep(0.001)
        turns += 1
    worker.join()
    # 400 cases of half a millisecond over some cores: with the GIL held there would be none.
    assert turns > 5


def in_child(seed: int) -> float:
    return float(FASTSIM.force(seed * XI, ETA, CHI).fx.sum())


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no fork")
@pytest.mark.filterwarnings("ignore:.*multi-threaded.*fork:DeprecationWarning")
@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_children_of_a_process_that_used_its_threads(method: str) -> None:
    here = [in_child(seed) for seed in (1, 2, 3)]
    with multiprocessing.get_context(method).Pool(2) as pool:
        assert pool.map_async(in_child, (1, 2, 3)).get(timeout=120) == here


class Alarm(Exception):
    pass


def long_array() -> None:
    EXACT.force(np.linspace(0.1, 1.0, 200_000), 0.3, 0.2)


def long_chain() -> None:
    creepage.sweep(
        {
            "contact": {"a_over_b": 1.0, "poisson": 0.28},
            "creepage": {"upsilon": {"from": 1.0, "step": 1e-6, "to": 2.0}},
        }
    )


def long_case() -> None:
    CASE.solve(resolution=(80, 80))


def wheelset() -> creepage.Wheelset:
    return creepage.Wheelset(
        wheel="S1002", rail="UIC60", cant=0.025, axle_load=9e4, theory="fastsim"
    )


def gap(resolution: str = "fast") -> creepage.GapCase:
    steel = creepage.Body(shear_modulus=80e9, poisson=0.28)
    return creepage.GapCase(
        gap=creepage.Gap.polynomial([(2, 0, 1.2), (0, 4, 4e4)]),
        upper=steel,
        lower=steel,
        friction=0.3,
        normal_force=3e4,
        longitudinal=1e-3,
        resolution=resolution,
    )



def long_table() -> None:
    wheelset().table(y=np.linspace(0.0, 6e-3, 3000), yaw=np.linspace(0.0, 2e-3, 4))


def long_gaps() -> None:
    creepage.GapCase.solve_all([gap("fine")] * 400)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no alarms")
@pytest.mark.parametrize("minutes", [long_array, long_chain, long_case, long_table, long_gaps])
def test_an_interrupt_ends_long_work(minutes: Callable[[], None]) -> None:
    def ring(_number: int, _frame: FrameType | None) -> None:
        raise Alarm

    before = signal.signal(signal.SIGALRM, ring)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        start = time.monotonic()
        with pytest.raises(Alarm):
            minutes()
        # A group takes a tenth of a second; a busy machine makes it more.
        assert time.monotonic() - start < 10.0
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)


def in_forked_child(what: str) -> float:
    if what == "wheelset":
        solved = wheelset().solve().left
        assert solved is not None
        return float(solved["force"]["vertical_n"])
    return float(gap().solve().force.longitudinal)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no fork")
@pytest.mark.filterwarnings("ignore:.*multi-threaded.*fork:DeprecationWarning")
def test_a_child_after_a_fork_works() -> None:
    """The threads of the parent are not in the child: it has its own."""
    here = [in_forked_child(what) for what in ("wheelset", "gap")]
    with multiprocessing.get_context("fork").Pool(1) as pool:
        there = pool.map_async(in_forked_child, ["wheelset", "gap"])
        assert there.get(60) == here
