"""Tables of creep force."""

from __future__ import annotations

import errno
import pickle
import signal
import sys
import time
from pathlib import Path
from types import FrameType

import creepage
import numpy as np
import pytest
import xarray as xr

RANDOM = np.random.default_rng(1967)
XI, ETA, CHI = RANDOM.uniform(-3.0, 3.0, (3, 200))


@pytest.fixture(scope="module")
def fastsim() -> creepage.Table:
    return creepage.Table.build("fastsim", 1.3, 0.28, places=200)


@pytest.fixture(scope="module")
def polach() -> creepage.Table:
    """Over ranges of the shape and Poisson's ratio."""
    return creepage.Table.build("polach", (0.5, 2.0), (0.2, 0.4), shapes=5, materials=3, places=200)


def test_a_table_is_as_near_its_theory_as_it_says(fastsim: creepage.Table) -> None:
    median, _, _, worst = fastsim.force_error
    assert 0.0 < median < worst < 0.02
    theory, force = creepage.fastsim(1.3, 0.28).force(XI, ETA, CHI), fastsim.force(XI, ETA, CHI)
    error = np.hypot(force.fx - theory.fx, force.fy - theory.fy)
    # Twice the worst of as many other places.
    assert error.max() < 2.0 * worst
    assert np.abs(force.mz - theory.mz).max() < 2.0 * fastsim.moment_error[3]


def test_floats_and_arrays_say_the_same(polach: creepage.Table) -> None:
    shapes = RANDOM.uniform(0.5, 2.0, 200)
    many = polach.force(XI, ETA, CHI, a_over_b=shapes, poisson=0.3)
    one = polach.force(XI[7], ETA[7], CHI[7], a_over_b=shapes[7], poisson=0.3)
    assert (one.fx, one.fy, one.mz) == (many.fx[7], many.fy[7], many.mz[7])
    assert one.status == creepage.Status.SOLVED
    assert polach.force(XI[:, None], ETA, 0.0, a_over_b=1.0, poisson=0.3).fx.shape == (200, 200)


def test_the_derivative_is_that_of_the_force(fastsim: creepage.Table) -> None:
    step = 1e-5
    ahead, behind = fastsim.force(XI + step, ETA, CHI), fastsim.force(XI - step, ETA, CHI)
    slope = fastsim.derivative(XI, ETA, CHI)[..., 0, 0]
    # Piecewise cubic: a difference over a joint of two pieces is exact to its curvature only.
    np.testing.assert_allclose((ahead.fx - behind.fx) / (2.0 * step), slope, atol=1e-3)
    assert fastsim.derivative(0.1).shape == (3, 3)


def test_a_file_keeps_every_bit(polach: creepage.Table, tmp_path: Path) -> None:
    path = tmp_path / "polach.nc"
    polach.write(path)
    assert [file.name for file in tmp_path.iterdir()] == ["polach.nc"]
    again = creepage.Table.read(path)
    assert repr(again) == repr(polach)
    assert (again.theory, again.a_over_b, again.poisson) == ("polach", (0.5, 2.0), (0.2, 0.4))
    assert repr(pickle.loads(pickle.dumps(polach))) == repr(polach)
    shape = {"a_over_b": 1.1, "poisson": 0.25}
    assert (again.force(XI, ETA, CHI, **shape).fx == polach.force(XI, ETA, CHI, **shape).fx).all()
    with xr.open_dataset(path, engine="scipy") as cube:
        assert cube.fx.dims == ("poisson", "a_over_b", "theta", "phi", "t")


def test_errors(polach: creepage.Table, tmp_path: Path) -> None:
    with pytest.raises(creepage.InvalidValue, match="a_over_b"):
        polach.force(0.1, a_over_b=3.0, poisson=0.3)
    with pytest.raises(creepage.InvalidValue, match="a_over_b"):
        polach.force(0.1)
    with pytest.raises(creepage.InvalidValue) as caught:
        polach.force([0.1, np.nan], a_over_b=1.0, poisson=0.3)
    assert caught.value.index == (1,)
    with pytest.raises(creepage.TableError, match="infinite"):
        creepage.Table.build("linear", 1.0, 0.28)
    with pytest.raises(creepage.UnknownTheory):
        creepage.Table.build("fast", 1.0, 0.28)
    with pytest.raises(TypeError, match="mesh"):
        creepage.Table.build("fastsim", 1.0, 0.28, mesh=(3, 3))
    with pytest.raises(creepage.InvalidValue, match="theta"):
        creepage.Table.build("polach", 1.0, 0.28, intervals=(1, 16, 20))
    with pytest.raises(OSError) as missing:
        creepage.Table.read(tmp_path / "none.nc")
    assert missing.value.errno == errno.ENOENT
    damaged = tmp_path / "damaged.nc"
    damaged.write_bytes(b"CDF\x02 and so on")
    with pytest.raises(creepage.TableError, match="damaged"):
        creepage.Table.read(damaged)


class Alarm(Exception):
    pass


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no alarms")
def test_an_interrupt_ends_the_building() -> None:
    def ring(_number: int, _frame: FrameType | None) -> None:
        raise Alarm

    before = signal.signal(signal.SIGALRM, ring)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.5)
        start = time.monotonic()
        with pytest.raises(Alarm):
            creepage.Table.build("exact", 1.0, 0.28, resolution="fine")  # minutes
        # What is being solved is finished; a busy machine takes longer.
        assert time.monotonic() - start < 20.0
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
