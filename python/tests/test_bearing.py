"""Ball bearings by their files."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest

import creepage

TEXT = (Path(__file__).parents[2] / "examples" / "bearing" / "angular-contact-7208.toml").read_text()


def test_a_bearing_is_in_balance() -> None:
    solved = creepage.bearing(TEXT + '\n[solve]\nresolution = "fast"\n')
    assert solved.status == "solved"
    # Loads are met to a millionth.
    assert solved.load == pytest.approx((2e3, 0.0), rel=1e-5, abs=1e-6)
    # Heat from slip, moment from tractions: one grid of the full theory.
    assert solved.friction_moment * 628.31853 == pytest.approx(solved.heat, rel=0.02)
    assert sum(solved.race_heat) == pytest.approx(solved.heat)
    ball = solved.balls[0]
    assert solved.alike == 12 and ball.inner is not None and ball.outer is not None
    assert ball.inner.contact_angle > ball.outer.contact_angle
    assert ball.inner.spin is not None and ball.outer.spin is not None
    assert ball.inner.heat > 0.0 and ball.outer.heat > 0.0


def test_solutions_go_through_pickle_and_files(tmp_path: Path) -> None:
    solved = creepage.bearing(TEXT + '\n[solve]\ntheory = "fastsim"\n')
    again = pickle.loads(pickle.dumps(solved))
    assert again.balls == solved.balls
    names = sorted(path.name for path in solved.save(tmp_path))
    assert "report.json" in names and "inner.svg" in names and "outer.vtk" in names
    assert solved.svg().startswith("<svg")


def test_what_is_wrong_is_named() -> None:
    with pytest.raises(creepage.CaseError, match="osculation"):
        creepage.bearing(TEXT.replace("osculation = 0.52", "osculation = 0.5", 1))
    with pytest.raises(creepage.CaseError, match="axial_load"):
        creepage.bearing(TEXT.replace("axial_load", "axial_lod"))
