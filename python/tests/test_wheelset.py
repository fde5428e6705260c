"""Wheelsets from Python: the command's numbers, symmetry, arrays, errors."""

from __future__ import annotations

import csv
import io
import json
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import creepage
import numpy as np
import pytest
from conftest import ROOT
from creepage import Wheelset

EXAMPLES = ROOT / "examples" / "wheelset"


def s1002(**more: Any) -> Wheelset:
    options = more if "theory" in more else {"resolution": "fast", **more}
    return Wheelset(wheel="S1002", rail="UIC60", cant=0.02499479, **options)


def test_three_lines_from_profiles_to_a_picture(tmp_path: Path) -> None:
    solution = s1002(axle_load=200e3).solve()
    written = solution.save(tmp_path / "out")
    assert tmp_path / "out" / "wheelset.png" in written
    assert solution.svg().startswith("<svg") and solution.status == "solved"
    assert solution.left is not None and solution.right is not None
    for side, sign in ((solution.left, 1.0), (solution.right, -1.0)):
        # The axle's load in halves, to the balance's end; in the middle the sides are alike.
        assert side["force"]["vertical_n"] == pytest.approx(100e3, abs=10.0)
        mirrored = sign * solution.left["force"]["lateral_n"]
        assert side["force"]["lateral_n"] == pytest.approx(mirrored, abs=10.0)
    assert json.loads((tmp_path / "out" / "report.json").read_text()) == solution.to_dict()


def test_a_file_is_the_same_case() -> None:
    wheelset = Wheelset.from_toml(EXAMPLES / "s1002-on-uic60.toml")
    again = pickle.loads(pickle.dumps(wheelset))
    for one in (wheelset, again):
        y, difference = one.radius_difference()
        middle = np.argmin(abs(y))
        assert abs(difference[middle]) < 1e-6
    found = wheelset.conicity([3e-3, 4e-3])
    alone = s1002(axle_load=1.0).conicity(3e-3)
    # The cant with eight digits for sixteen.
    assert found[0] == pytest.approx(float(alone), rel=1e-4)
    assert 0.005 < found[0] < 0.5


def test_the_conicity_of_wheels_on_their_flanges_warns() -> None:
    with pytest.warns(UserWarning, match="wheel: the flange rides on the rail"):
        found = s1002(axle_load=200e3, back_to_back=1.45).conicity(3e-3)
    assert np.isfinite(found)
    # As far as a wheelset swings, too: at 20 mm the flange lies on the rail.
    with pytest.warns(UserWarning, match="wheel: the flange rides on the rail"):
        s1002(axle_load=200e3).conicity([3e-3, 20e-3])


def test_a_table_is_the_forces_at_its_places() -> None:
    wheelset = s1002(axle_load=200e3)
    table = wheelset.table(y=[0.0, 1e-3], yaw=[0.0])
    assert table["left_lateral_n"].shape == (1, 2)
    right = s1002(axle_load=200e3, y=1e-3).solve().right
    assert right is not None
    # From the neighbour and from nothing: the balance's end and the sweeps', in parts of mu N.
    force = right["force"]["lateral_n"]
    assert table["right_lateral_n"][0, 1] == pytest.approx(force, abs=1e-3 * 0.3 * 100e3)


def test_a_table_goes_over_loads_and_has_every_contact() -> None:
    wheelset = s1002(axle_load=200e3, theory="fastsim")
    table = wheelset.table(y=[0.0, 5.5e-3], axle_load=[100e3, 200e3])
    assert table["left_vertical_n"].shape == (2, 1, 2)
    # Half of the axle load on each rail, to what loads are met.
    assert table["left_vertical_n"][:, 0, 0] == pytest.approx([50e3, 100e3], rel=2e-4)
    loads = table["right_contact_normal_force_n"]
    assert loads.shape == (2, 1, 2, 3)
    # As many as there are, by falling load; the first is what the wheel's own columns have.
    assert (np.isfinite(loads).sum(axis=-1) == table["right_contacts"]).all()
    assert (loads[..., 0] == table["right_normal_force_n"]).all()
    area = table["right_contact_area_m2"][..., 0]
    box = table["right_contact_length_m"][..., 0] * table["right_contact_width_m"][..., 0]
    # An ellipse fills pi/4 of its box, a rectangle all of it.
    assert (area < box).all() and (area > 0.6 * box).all()
    heights = wheelset.table(y=0.0, roll=0.0, z=[2e-4, 3e-4])
    assert heights["left_vertical_n"].shape == (2, 1, 1, 1)
    assert heights["left_vertical_n"][1, 0, 0, 0] > heights["left_vertical_n"][0, 0, 0, 0]
    with pytest.raises(ValueError, match="axle_load"):
        wheelset.table(y=0.0, z=2e-4, axle_load=100e3)


def test_derivatives_are_those_of_the_report() -> None:
    solution = s1002(axle_load=200e3, theory="fastsim").solve(derivatives=True)
    assert solution.derivatives is not None and solution.derivative_errors is not None
    assert solution.derivatives.shape == solution.derivative_errors.shape == (2, 6, 8)
    # Height, roll and pitch rate are found: they have none.
    assert np.isnan(solution.derivatives[:, :, [1, 2, 5]]).all()
    assert np.isfinite(solution.derivatives[:, :, [0, 3, 4, 6, 7]]).all()
    assert solution.right is not None
    lateral = solution.right["derivatives"]["yaw_rad"]["lateral_n"]
    assert solution.derivatives[1, 1, 3] == lateral < 0.0
    assert s1002(axle_load=200e3, theory="fastsim").solve().derivatives is None


def test_errors_name_the_place() -> None:
    with pytest.raises(creepage.CaseError, match="profile"):
        Wheelset(wheel="S1003", rail="UIC60", axle_load=1e5)
    with pytest.raises(creepage.CaseError, match="friction"):
        s1002(axle_load=1e5, friction=-0.1)
    with pytest.raises(creepage.CaseError, match="axle_load"):
        s1002().solve()


def test_what_a_file_does_not_show_is_said(tmp_path: Path) -> None:
    y = np.arange(-60.0, 71.0)
    np.savetxt(tmp_path / "cone.txt", np.column_stack([y, y / 20.0]))
    options: dict[str, Any] = {"rail": "UIC60", "cant": 0.025, "directory": tmp_path}
    with pytest.raises(creepage.CaseError, match="reading"):
        Wheelset(wheel="cone.txt", axle_load=160e3, **options)
    cone = {"z": "up", "y": "field-side"}
    said = Wheelset(wheel="cone.txt", wheel_reading=cone, axle_load=160e3, theory="linear", **options)
    named = Wheelset(wheel="cone-1:20", axle_load=160e3, theory="linear", **options)
    said_right, named_right = said.solve().right, named.solve().right
    assert said_right is not None and named_right is not None
    lateral, standard = (right["force"]["lateral_n"] for right in (said_right, named_right))
    # The file's first point is not the standard's, but both are the same cone at the contact.
    assert lateral == pytest.approx(standard, rel=1e-3)


def test_a_flat_lets_the_wheel_down_and_rolls_out_again() -> None:
    length, depth = 0.1, 0.9e-3
    flat = {"length": length, "depth": depth, "angle": 0.0, "shape": "haversine"}
    wheelset = s1002(axle_load=200e3, flat=flat, pitch=0.0, theory="fastsim")
    round_wheels = s1002(axle_load=200e3, theory="fastsim").solve().to_dict()
    heights = [
        wheelset.at(pitch=pitch).solve().to_dict()["z_m"] - round_wheels["z_m"]
        for pitch in (0.0, 0.05, 0.15)
    ]
    # On the middle of the flat the axle is lower by its depth, but for the elastic approach, which differs by less
    # than that of a hundred kN; beyond its end, 50 mm from the middle, it is not there.
    assert heights[0] == pytest.approx(depth, abs=0.1e-3)
    assert 0.0 < heights[1] < heights[0]
    assert heights[2] == pytest.approx(0.0, abs=1e-6)
    with pytest.raises(creepage.CreepageError, match="vary"):
        wheelset.conicity(3e-3)


def test_wheels_roll_in_steps_as_the_command_has_them(tmp_path: Path) -> None:
    wheels = Wheelset(wheel="S1002", rail="UIC60", cant=0.025, axle_load=100e3, roll=0.0, pitch_rate=65.3, resolution="fast")
    history = {"distance": [0.002, 0.004, 0.006], "y": [0.0, np.nan, 0.0005]}
    found = wheels.roll(history)
    assert found["distance_m"].tolist() == history["distance"]
    assert set(found["status"]) == {"solved"}
    # It drives: rails are pushed back, more and more.
    assert np.all(np.diff(found["left_longitudinal_n"][:2]) < 0)
    case, table = tmp_path / "case.toml", tmp_path / "way.csv"
    case.write_text(wheels.to_toml())
    table.write_text("distance,y\n0.002,0.0\n0.004,\n0.006,0.0005\n")
    words = [sys.executable, "-m", "creepage", "roll", str(case), "--history", str(table)]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    rows = list(csv.DictReader(io.StringIO(done.stdout)))
    assert [float(row["right_lateral_n"]) for row in rows] == found["right_lateral_n"].tolist()
    steady = wheels.roll({"distance": [0.001]}, start="steady")
    assert abs(steady["left_longitudinal_n"][0]) > abs(found["left_longitudinal_n"][0])
    with pytest.raises(ValueError, match="hight is not known"):
        wheels.roll({"distance": [0.1], "hight": [0.0]})
    with pytest.raises(ValueError, match="one length"):
        wheels.roll({"distance": [0.1, 0.2], "y": [0.0]})
    with pytest.raises(creepage.CaseError, match="row 1: .*pitch_rate"):
        Wheelset(wheel="S1002", rail="UIC60", axle_load=100e3).roll({"distance": [0.001]})
