"""Many rows: arrays of a case in SI units, tables of cases; the command's numbers to the last bit."""

from __future__ import annotations

import copy
import io
import math
import pickle
import subprocess
import sys
import warnings
from pathlib import Path
from typing import Any

import creepage
import numpy as np
import pandas as pd
import polars as pl
import pytest
import xarray as xr
from conftest import ROOT
from creepage import Body, Case, Status

WHEEL_ON_RAIL = ROOT / "examples" / "wheel-on-rail.toml"
CASE = Case.from_toml(WHEEL_ON_RAIL)
ROWS = 1000
RANDOM = np.random.default_rng(1967)
HISTORY = {
    "longitudinal": RANDOM.uniform(-2e-3, 2e-3, ROWS),
    "lateral": RANDOM.uniform(-2e-3, 2e-3, ROWS),
    "spin": RANDOM.uniform(-0.2, 0.2, ROWS),
    "normal_force": RANDOM.uniform(50e3, 90e3, ROWS),
}


@pytest.fixture(scope="module")
def table() -> creepage.Table:
    return creepage.Table.build(
        "fastsim", (0.8, 2.0), 0.28, shapes=3, intervals=(8, 12, 12), places=50, grid=(20, 20)
    )


def command(arguments: list[str], place: Path) -> pd.DataFrame:
    """What the command appends."""
    done = subprocess.run(
        [sys.executable, "-m", "creepage", *arguments],
        cwd=place,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode in (0, 3), done.stderr
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # later versions round so by themselves, and say so
        return pd.read_csv(io.StringIO(done.stdout), float_precision="round_trip")


def test_an_array_is_the_case_row_by_row() -> None:
    force = CASE.force(**HISTORY, theory="fastsim", grid=(20, 20))
    assert (force.status == Status.SOLVED).all() and not force.messages
    for row in (0, 7, ROWS - 1):
        one = {name: float(column[row]) for name, column in HISTORY.items()}
        alone = CASE.force(**one, theory="fastsim", grid=(20, 20))
        assert isinstance(alone.longitudinal, float) and alone.status is Status.SOLVED
        assert tuple(alone) == tuple(column[row] for column in force)
    # What does not vary is the case's.
    same = CASE.force(longitudinal=np.array([CASE.creepage.longitudinal, 0.0]))
    assert same.longitudinal[0] == pytest.approx(CASE.solve().force.longitudinal, rel=1e-12)
    assert same.fx_error is not None and same.fx_error.shape == (2,)
    assert same.power is None and CASE.force(longitudinal=[1e-3], speed=20.0).power is not None


def test_arrays_broadcast_by_shape_and_by_dimension() -> None:
    grid = CASE.force(lateral=np.zeros((3, 1)), normal_force=[6e4, 7e4], theory="polach")
    assert grid.longitudinal.shape == (3, 2)
    time = xr.DataArray([0.0, 1e-3], dims="time")
    load = xr.DataArray([6e4, 7e4, 8e4], dims="load")
    assert CASE.force(lateral=time, normal_force=load, theory="polach").fx.shape == (2, 3)
    polach = creepage.theory("polach", a_over_b=1.2, poisson=0.28)
    by_name = polach.force(xi=1e3 * time, eta=1e-5 * load)
    assert (by_name.fx == polach.force([[0.0], [1.0]], [0.6, 0.7, 0.8]).fx).all()
    with pytest.raises(ValueError, match="broadcast"):
        CASE.force(lateral=[0.0, 1.0], normal_force=[1.0, 2.0, 3.0])
    with pytest.raises(TypeError, match="real numbers"):
        CASE.force(lateral=["much"])


def test_nan_in_is_nan_out_with_a_status() -> None:
    force = CASE.force(lateral=[1e-3, np.nan, 1e-3], normal_force=[8e4, 8e4, -1.0], theory="linear")
    assert force.status.tolist() == [Status.SOLVED, Status.INVALID, Status.INVALID]
    assert np.isfinite(force.lateral).tolist() == [True, False, False]
    assert "lateral = NaN" in force.messages[1] and "normal_force = -1" in force.messages[2]
    columns = pd.DataFrame(force.to_dict())
    assert columns.status.tolist() == ["solved", "invalid", "invalid"]
    assert list(columns.columns[:3]) == ["longitudinal_n", "lateral_n", "moment_n_m"]


@pytest.mark.parametrize("by_table", [False, True])
def test_the_numbers_are_the_commands(
    by_table: bool, table: creepage.Table, tmp_path: Path
) -> None:
    frame = pd.DataFrame(HISTORY)
    frame.to_csv(tmp_path / "history.csv", index=False)
    table.write(tmp_path / "t.nc")
    by = ["--table", "t.nc"] if by_table else ["--theory", "fastsim", "--option", "grid=[20,20]"]
    batch = ["batch", "--case", str(WHEEL_ON_RAIL), "--in", "history.csv", *by]
    printed = command(batch, tmp_path)
    options: dict[str, Any] = {} if by_table else {"grid": (20, 20)}
    theory = table if by_table else "fastsim"
    force = CASE.force(**HISTORY, theory=theory, **options)
    own = creepage.batch(frame, theory, case=CASE, **options)
    for name, column in force.to_dict().items():
        if name not in ("status", "message"):
            assert (printed[name].to_numpy() == column).all(), name
            assert (own[name].to_numpy() == column).all(), name


def test_a_batch_keeps_its_index_and_columns() -> None:
    frame = pd.DataFrame(
        {
            "wheel": ["a", "b", "c", "d"],
            "a_over_b": [1.0, 1.5, math.nan, 2.0],
            "poisson": 0.28,
            "xi": [0.1, 0.2, 0.3, None],
        },
        index=pd.Index([10, 20, 30, 40], name="time"),
    )
    kept = frame.copy()
    found = creepage.batch(frame, theory="fastsim")
    assert found.index.equals(frame.index)
    assert list(found.columns) == [*frame.columns, "fx", "fy", "mz", "status", "message"]
    assert found.status.tolist() == ["solved", "solved", "invalid", "invalid"]
    assert np.isnan(found.fx[30]) and "a_over_b = NaN" in found.message[30]
    assert found.fx[20] == creepage.fastsim(1.5, 0.28).force(0.2).fx
    frame["fx"] = found.fx
    assert frame.fx[10] == found.fx[10]
    with pytest.raises(ValueError, match="'fx' is there already"):
        creepage.batch(frame, theory="fastsim")
    pd.testing.assert_frame_equal(frame.drop(columns="fx"), kept)
    with pytest.raises(ValueError, match="'poisson' is missing"):
        creepage.batch(kept.drop(columns="poisson"), theory="fastsim")
    with pytest.raises(ValueError, match="prepared for one contact"):
        creepage.batch(creepage.fastsim(1.0, 0.28), kept)
    with pytest.raises(creepage.UnknownTheory):
        creepage.batch(kept, theory="fastsm")
    with pytest.raises(TypeError, match="must hold numbers"):
        creepage.batch(kept.assign(eta="much"), theory="fastsim")


def test_unlike_bodies_have_a_column() -> None:
    rows = {"a_over_b": [1.3, 1.3], "poisson": 0.28, "xi": 0.4, "kappa_over_mu": [0.0, 0.3]}
    exact = creepage.batch(rows, "exact", resolution="fast")
    handle = creepage.exact(1.3, 0.28, resolution="fast", kappa_over_mu=0.3)
    assert exact.fx[1] == handle.force(0.4).fx != exact.fx[0]
    assert (exact.message == "").all()
    polach = creepage.batch(rows, "polach")
    assert polach.message[0] == "" and "kappa/mu = 0.300" in polach.message[1]


def test_polars_frames_stay_polars() -> None:
    frame = pl.DataFrame(
        {"a_over_b": [1.0, 2.0], "poisson": [0.28, 0.28], "xi": [0.1, None], "id": ["x", "y"]}
    )
    found = creepage.batch(frame, theory="polach")
    assert isinstance(found, pl.DataFrame)
    assert found.columns == [*frame.columns, "fx", "fy", "mz", "status", "message"]
    assert found["status"].to_list() == ["solved", "invalid"]
    assert found["fx"][0] == creepage.polach(1.0, 0.28).force(0.1).fx


def test_a_table_answers_a_batch(table: creepage.Table) -> None:
    found = creepage.batch({"a_over_b": [1.0, 3.0], "xi": [0.5, 0.5]}, table)
    assert found.fx[0] == table.force(0.5, a_over_b=1.0).fx
    assert found.status.tolist() == ["solved", "invalid"] and "a_over_b = 3" in found.message[1]


def pickled(thing: Any) -> Any:
    return pickle.loads(pickle.dumps(thing))


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy, pickled])
def test_cases_solutions_and_tables_are_copied_and_compared(
    duplicate: Any, table: creepage.Table
) -> None:
    solution, force = CASE.solve("polach"), creepage.polach(1.0, 0.28).force([0.1])
    for thing in (CASE, solution, table, force):
        assert duplicate(thing) == thing and not duplicate(thing) != thing
        assert thing != "else"
    assert {CASE, duplicate(CASE)} == {CASE} and hash(duplicate(table)) == hash(table)
    other = Case.from_toml(CASE.to_toml().replace("80e3", "81e3"))
    assert other != CASE and other.solve("polach") != solution != CASE.solve("fastsim")
    assert Case.from_toml(CASE.to_toml() + "\n# a comment\n") == CASE


def test_a_force_unpacks() -> None:
    fx, fy, mz = creepage.polach(1.0, 0.28).force(0.5, 0.1, 0.2)
    along, across, moment = CASE.solve("polach").force
    assert (abs(fx) <= 1.0, abs(fy) <= 1.0, abs(mz) < 1.0) == (True, True, True)
    assert along < 0.0 and abs(across) < abs(along) and abs(moment) < 1e3


def test_the_field_in_si_units_carries_load_and_force() -> None:
    solution = CASE.solve("saturated")
    field = solution.si_field(points=200)
    a, b = field.semi_axes
    cell = 4.0 * a * b / 200**2
    # The integral over cells of a box; the pressure falls to zero like a root at the edge: 0.1 %.
    assert field.pressure.sum() * cell == pytest.approx(80e3, rel=1e-3)
    assert field.traction[..., 0].sum() * cell == pytest.approx(solution.force.longitudinal, rel=1e-3)
    assert field.pressure.max() <= solution.contact.peak_pressure
    assert set(pd.DataFrame(field.to_dict())) >= {"x_m", "pressure_pa", "traction_y_pa", "region"}


def test_joblib_takes_cases_apart() -> None:
    joblib = pytest.importorskip("joblib")
    cases = [Case.from_toml(CASE.to_toml().replace("80e3", f"{load}")) for load in (6e4, 7e4)]
    jobs = [joblib.delayed(case.solve)("polach") for case in cases]
    solutions = joblib.Parallel(n_jobs=2)(jobs)
    assert [s.force for s in solutions] == [case.solve("polach").force for case in cases]
    assert solutions == [case.solve("polach") for case in cases]


STEEL: dict[str, Any] = {"shear_modulus": 82e9, "poisson": 0.28}


def test_numbers_in_other_units_are_warned_of() -> None:
    flat, ball = Body(**STEEL), Body(**STEEL, radius_rolling=6e-3, radius_lateral=6e-3)
    soft = Body(shear_modulus=82e3, poisson=0.28, radius_rolling=6e-3, radius_lateral=6e-3)
    assert creepage.hertz(ball, flat, 500.0).approach < 1e-4
    with pytest.warns(creepage.UnitsWarning, match=r"smallest radius, 0.006 m.*check the units"):
        creepage.hertz(soft, flat, 500.0)
    case = Case(upper=ball, lower=flat, normal_force=500.0, friction=0.3, lateral=2.0)
    with pytest.warns(creepage.UnitsWarning, match="lateral creepage of 2 is above") as caught:
        solution = case.solve("polach")
    assert caught[0].filename == __file__
    assert solution.caution is not None and "above 0.3" in solution.caution
    assert solution.status is Status.SOLVED


def test_wrong_arguments_are_told_in_pythons_words() -> None:
    with pytest.raises(TypeError):
        Body(210e9, 0.28, 0.46)  # type: ignore[call-arg]
    with pytest.raises(creepage.CaseError, match="poisson = 82000000000") as caught:
        Body(poisson=82e9, shear_modulus=0.28)
    assert caught.value.key == "poisson"
    with pytest.raises(TypeError, match=r"longitudinal must be one number.*Case.force"):
        Case(
            upper=Body(**STEEL, radius_rolling=0.46),
            lower=Body(**STEEL, radius_lateral=0.3),
            normal_force=8e4,
            friction=0.3,
            longitudinal=np.zeros(3),  # type: ignore[arg-type]
        )
    with pytest.raises(ValueError, match="vary = 'lat' is not valid"):
        CASE.curve("lat")  # type: ignore[arg-type]


def test_a_field_that_does_not_fit_into_memory_raises(tmp_path: Path) -> None:
    code = """
import resource
import creepage
resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
try:
    creepage.polach(1.0, 0.28).field(0.1, points=10_000)
except MemoryError:
    print("no room")
"""
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout) == (0, "no room\n"), done.stderr


def test_pip_brings_the_command(tmp_path: Path) -> None:
    program = Path(sys.executable).with_name("creepage")
    done = subprocess.run(
        [program, "solve", WHEEL_ON_RAIL, "--theory", "polach"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout == str(CASE.solve("polach"))
    wrong = subprocess.run([program, "solve", "no.toml"], capture_output=True, check=False)
    assert wrong.returncode == 2 and wrong.stderr.startswith(b"error: cannot read no.toml")
