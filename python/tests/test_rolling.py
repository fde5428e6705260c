"""Unsteady rolling from Python: the command's numbers, states that come back, errors."""

from __future__ import annotations

import copy
import csv
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import creepage
import numpy as np
import pandas as pd
import pytest
from conftest import ROOT
from creepage import Rolling, Status

EXAMPLES = ROOT / "examples" / "roll"
PULLS = EXAMPLES / "wheel-pulls.toml"


def wheel(theory: str = "exact") -> creepage.Case:
    options: dict[str, Any] = {"resolution": [8, 8]} if theory == "exact" else {}
    steel = {"shear_modulus": 82e9, "poisson": 0.28}
    return creepage.Case(
        upper=creepage.Body(**steel, radius_rolling=0.46),
        lower=creepage.Body(**steel, radius_lateral=0.30),
        normal_force=80e3,
        friction=0.3,
        longitudinal=-1e-3,
        theory=theory,
        **options,
    )


def command(case: Path, history: Path) -> dict[str, list[str]]:
    words = [sys.executable, "-m", "creepage", "roll", str(case), "--history", str(history)]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    rows = list(csv.DictReader(done.stdout.splitlines()))
    return {name: [row[name] for row in rows] for name in rows[0]}


@pytest.mark.parametrize("name", ["wheel-pulls pulls", "cylinders cylinders"])
def test_a_history_has_the_numbers_of_the_command_to_the_last_bit(name: str) -> None:
    case, history = (EXAMPLES / f for f in (f"{name.split()[0]}.toml", f"{name.split()[1]}.csv"))
    frame = pd.read_csv(history, comment="#", skipinitialspace=True)
    found = creepage.roll(case, frame)
    printed = command(case, history)
    assert list(found) == list(printed)
    assert found["status"].tolist() == printed.pop("status")
    for column, texts in printed.items():
        assert found[column].tolist() == [float(text) for text in texts], column


def test_steps_are_the_rows_of_a_history() -> None:
    case = wheel()
    given = {"distance": [0.5e-3, 1.5e-3, 3.5e-3], "longitudinal": [-1e-3, -1e-3, -5e-4]}
    table = creepage.roll(case, given)
    rolling = Rolling(case)
    steps = [
        rolling.step(length, longitudinal=creep)
        for length, creep in zip([0.5e-3, 1e-3, 2e-3], given["longitudinal"], strict=True)
    ]
    # The differences of the distances are rounded.
    forces = [step.force.longitudinal for step in steps]
    np.testing.assert_allclose(forces, table["longitudinal_n"], rtol=0, atol=1e-9 * 24e3)
    distances = [step.distance for step in steps]
    np.testing.assert_allclose(distances, given["distance"], rtol=1e-12)
    assert all(step.status is Status.SOLVED for step in steps)
    assert steps[-1].creepage.longitudinal == pytest.approx(-5e-4, rel=1e-14)
    assert 0.0 < steps[0].adhesion_share <= 1.0
    with pytest.raises(AttributeError):
        steps[0].distance = 1.0  # type: ignore[misc]


def test_a_rejected_step_leaves_no_trace() -> None:
    rolling = Rolling(wheel())
    for _ in range(2):
        before = rolling.save()
        first = rolling.step(1e-3, lateral=1e-3, normal_force=70e3)
        after = rolling.save()
        rolling.restore(before)
        rolling.step(5e-3, spin=0.3)
        rolling.restore(before)
        assert rolling.save() == before
        assert rolling.step(1e-3, lateral=1e-3, normal_force=70e3) == first
        assert rolling.save() == after


def test_it_is_pickled_and_copied_with_its_memory() -> None:
    rolling = Rolling(PULLS)
    rolling.step(2e-3, longitudinal_force=-12e3)
    others = [pickle.loads(pickle.dumps(rolling)), copy.deepcopy(rolling)]
    ends = [one.step(3e-3, longitudinal_force=-12e3) for one in (rolling, *others)]
    assert ends[0] == ends[1] == ends[2]
    assert ends[0].creepage.longitudinal < 0.0
    assert ends[0].force.longitudinal == pytest.approx(-12e3, abs=1.0)


def test_starts_differ() -> None:
    case = wheel()
    steady = Rolling(case, start="steady").step(1e-5, longitudinal=-1e-3)
    none = Rolling(case, start="none").step(1e-5, longitudinal=-1e-3)
    shifted = Rolling(case, start=(12e3, 0.0)).step(1e-5)
    end = case.solve().force
    # The grids are not the same: the error bars of few elements.
    assert steady.force.longitudinal == pytest.approx(end.longitudinal, abs=0.02 * 24e3)
    assert abs(none.force.longitudinal) < 0.01 * 24e3
    assert shifted.force.longitudinal == pytest.approx(12e3, abs=0.01 * 24e3)


def test_errors_name_what_is_wrong() -> None:
    rolling = Rolling(wheel())
    state = rolling.save()
    for wrong, words in (
        ({"distance": -1.0}, "distance"),
        ({"distance": 1e-3, "longitudinal": float("nan")}, "longitudinal"),
        ({"distance": 1e-3, "longitudinal": 0.0, "longitudinal_force": 0.0}, "exclude"),
        ({"distance": 1e-3, "lateral_force": 25e3}, "24000"),
        ({"distance": 1e-3, "normal_force": -1.0}, "normal_force"),
    ):
        with pytest.raises((ValueError, creepage.InvalidValue), match=words):
            rolling.step(**wrong)
    assert rolling.save() == state
    masked = np.ma.array([1e-3, 5e-3], mask=[False, True])
    with pytest.raises(TypeError, match="column longitudinal must not have masked"):
        creepage.roll(wheel(), {"distance": [0.01, 0.02], "longitudinal": masked})
    with pytest.raises(TypeError, match="column distance must be real numbers"):
        creepage.roll(wheel(), {"distance": ["0.01"]})
    with pytest.warns(UserWarning, match="row 1: the longitudinal creepage of 1.5"):
        creepage.roll(wheel(), {"distance": [1e-3], "longitudinal": [1.5]})
    with pytest.warns(UserWarning, match="longitudinal creepage of 1.5"):
        rolling.step(1e-3, longitudinal=1.5)
    with pytest.raises(ValueError, match="no state"):
        rolling.restore(state[:-1])
    with pytest.raises(ValueError, match="another contact"):
        rolling.restore(Rolling(wheel(), start="steady").save())
    with pytest.raises(creepage.CaseError, match="polach"):
        Rolling(wheel("polach"))
    with pytest.raises(ValueError, match="start"):
        Rolling(wheel(), start="some")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="latteral"):
        creepage.roll(PULLS, {"distance": [1e-3], "latteral": [0.0]})
    with pytest.raises(ValueError, match="length"):
        creepage.roll(PULLS, {"distance": [1e-3], "lateral": [0.0, 1.0]})
    with pytest.raises(creepage.InvalidValue, match="row 1: xi"):
        creepage.roll(PULLS, {"distance": [1e-3], "xi": [float("nan")]})
    with pytest.raises(ValueError, match="row 2: distance"):
        creepage.roll(PULLS, {"distance": [1e-3, 1e-3]})


def test_a_layer_rolls_on() -> None:
    clay = Rolling(EXAMPLES / "wheel-on-clay.toml")
    state = clay.save()
    first = clay.step(2e-3, longitudinal=-10e-3).force.longitudinal
    clay.restore(state)
    assert clay.step(2e-3, longitudinal=-10e-3).force.longitudinal == first
    with pytest.raises(ValueError, match=r"\[layer\]"):
        clay.step(2e-3, longitudinal=-10e-3, normal_force=70e3)


def test_chapter_5_rolls_with_a_memory() -> None:
    own, full = Rolling(wheel("variational")), Rolling(wheel())
    for _ in range(3):
        forces = [one.step(2e-3, longitudinal=-1.5e-3).force.longitudinal for one in (own, full)]
        # Degree 3 on the way to steady rolling, in parts of mu N.
        assert forces[0] == pytest.approx(forces[1], abs=0.09 * 24e3)
    again = pickle.loads(pickle.dumps(own))
    assert again.step(1e-3) == own.step(1e-3)
    with pytest.raises(creepage.CaseError, match="constant load"):
        own.step(1e-3, normal_force=70e3)
    with pytest.raises(creepage.CaseError, match="degree = 60"):
        Rolling(
            creepage.Case(
                upper=creepage.Body(shear_modulus=82e9, poisson=0.28, radius_rolling=0.46),
                lower=creepage.Body(shear_modulus=82e9, poisson=0.28, radius_lateral=0.30),
                normal_force=80e3,
                friction=0.3,
                theory="variational",
                degree=60,
            )
        )
