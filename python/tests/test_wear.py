"""Wear over a distance from Python: the command's numbers, arrays, going on, errors."""

from __future__ import annotations

import pickle
import warnings
from pathlib import Path
from typing import Any

import creepage
import numpy as np
import pytest
from conftest import ROOT
from creepage import CaseError, Wheelset

Y = np.array([-2e-3, 0.0, 2e-3])


def wheelset(**more: Any) -> Wheelset:
    options = {"axle_load": 160e3, "theory": "fastsim", "grid": [20, 20], **more}
    return Wheelset(wheel="S1002", rail="UIC60", cant=0.02499479, **options)


def worn(**more: Any) -> creepage.Wear:
    options = {"law": "usfd", "sides": "mean", "distance": 1e7, "stops": 2, **more}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        return creepage.wear(wheelset(), situations={"share": [1, 2, 1], "y": Y}, **options)


def test_profiles_and_measures_over_distance(tmp_path: Path) -> None:
    heard: list[float] = []
    wear = worn(progress=heard.append)
    assert wear.is_solved and sorted(wear.bodies) == ["wheel_left", "wheel_right"]
    assert wear.distance.tolist() == [0.0, 5e6, 1e7] and heard[0] == 0.0 and heard == sorted(heard)
    wheel = wear.bodies["wheel_right"]
    assert wheel.depth[0].max() == 0.0 and wheel.depth[2].max() == wheel.greatest_depth[2] > 0.0
    assert wheel.points[2].shape == (wheel.depth[2].size, 2)
    # S1002 when new: Sh 28, Sd 32.5, qR 10.794 mm; a worn tread makes the flange look higher.
    assert wheel.flange_height[0] == pytest.approx(28e-3, abs=1e-5)
    assert wheel.flange_thickness[0] == pytest.approx(32.5e-3, abs=1e-5)
    assert wheel.flange_height[2] > wheel.flange_height[0]
    # The area between the polygons, by the trapezoid rule on both; points run to the flange, z is down.
    new, old = (
        0.5 * np.sum((p[1:, 1] + p[:-1, 1]) * (p[:-1, 0] - p[1:, 0]))
        for p in (wheel.points[0], wheel.points[2])
    )
    assert new - old == pytest.approx(wheel.area[2], rel=1e-6)
    written = wear.save(tmp_path / "out")
    assert tmp_path / "out" / "wear.csv" in written
    assert wear.to_dict()["rows"][-1]["depth_m"] == wear.bodies["wheel_right"].greatest_depth[2]
    picture = wear.svg("wheel")
    assert picture is not None and picture.startswith("<svg") and wear.svg("rail") is None
    assert "wheel_right" in str(wear) and "wheel_right" in repr(wear)
    again = pickle.loads(pickle.dumps(wear))
    assert again == wear and again.text() == wear.text() and again.bodies["wheel_right"] == wheel
    assert [path.name for path in again.save(tmp_path / "again")] == [path.name for path in written]


def test_a_stopped_run_goes_on_to_the_same_bits(tmp_path: Path) -> None:
    class Stop(Exception):
        pass

    calls = 0

    def second(_: float) -> None:
        nonlocal calls
        calls += 1
        if calls == 2:
            raise Stop

    state = tmp_path / "run.state"
    with pytest.raises(Stop):
        worn(state=state, progress=second)
    assert state.exists()
    again, whole = worn(state=state), worn()
    for name, wheel in whole.bodies.items():
        assert np.array_equal(again.bodies[name].points[-1], wheel.points[-1])
    with pytest.raises(CaseError, match="another case"):
        worn(state=state, distance=2e7)


def test_the_files_own_section_is_the_command(tmp_path: Path) -> None:
    text = (ROOT / "examples" / "wear" / "s1002.toml").read_text()
    text = text.replace("distance = 30e6", "distance = 2e6").replace("stops = 3", "stops = 1")
    file = Wheelset.from_toml(text, ROOT / "examples" / "wear")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        wear = creepage.wear(file)
    assert wear.bodies["wheel_left"].greatest_depth[1] > 0.0


def test_what_is_wrong_is_named() -> None:
    with pytest.raises(CaseError, match="distance"):
        creepage.wear(wheelset(), law="usfd")
    with pytest.raises(CaseError, match="wear"):
        creepage.wear(wheelset())
    with pytest.raises(CaseError, match="did you mean `step_depth`"):
        creepage.wear(wheelset(), distance=1e6, step_depht=1e-4)
    with pytest.raises(CaseError, match="share"):
        creepage.wear(wheelset(), distance=1e6, situations={"share": [-1.0]})
    with pytest.raises(ValueError, match="one length|broadcast"):
        creepage.wear(wheelset(), distance=1e6, situations={"share": [1, 1], "y": Y})


def test_a_run_ends_at_a_limit() -> None:
    full = worn()
    wheel = full.bodies["wheel_right"]
    assert full.ended is None
    limit = 0.5 * (wheel.flange_height[0] + wheel.flange_height[2])
    ended = worn(limits={"flange_height": limit})
    assert ended.ended is not None and "flange height of wheel_" in ended.ended
    assert ended.distance[-1] < 1e7
    # Between two steps the measure is taken as linear: a step takes off 1e-4 m at most.
    assert ended.bodies["wheel_right"].flange_height[-1] == pytest.approx(limit, abs=1e-5)
    with pytest.raises(CaseError, match="flange_thickness"):
        worn(limits={"flange_thickness": 0.034})
