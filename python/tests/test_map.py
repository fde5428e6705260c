"""Contact maps: built small, kept in a file, asked as the exact solver is."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import creepage
import numpy as np
import pytest


def test_it_answers_as_the_solver_does(
    mapped: creepage.Wheelset, contact_map: creepage.ContactMap
) -> None:
    state: dict[str, Any] = {"y": 0.0004, "yaw": 0.002, "axle_load": 90e3}
    exact = mapped.solver().solve(**state)
    found = contact_map.solve(**state)
    limit = 0.3 * 45e3
    # A coarse table of few shapes errs by some per cent of mu N.
    assert np.abs(found.right.force - exact.right.force).max() < 0.08 * limit
    assert np.abs(found.left.force - exact.left.force).max() < 0.08 * limit
    assert found.z == pytest.approx(exact.z, abs=1e-6)
    assert found.roll == pytest.approx(exact.roll, abs=5e-6)
    assert found.pitch_rate == pytest.approx(exact.pitch_rate, rel=2e-4)
    assert found.status == "solved"
    patch, right = found.right.patches[0], exact.right.patches[0]
    assert patch.normal_force == pytest.approx(right.normal_force, rel=5e-3)
    assert patch.peak_pressure == pytest.approx(right.peak_pressure, rel=2e-2)
    assert all(error.states >= 0 for error in found.error)


def test_its_file_and_arrays_have_the_same_bits(
    contact_map: creepage.ContactMap, tmp_path: Path
) -> None:
    path = tmp_path / "wheelset.nc"
    contact_map.save(path)
    read = creepage.ContactMap.load(path)
    one = read.solve(y=0.0003, axle_load=90e3)
    many = contact_map.solve_many(y=np.array([0.0003, 0.05]), axle_load=90e3)
    assert np.array_equal(many.right[0], np.r_[one.right.force, one.right.moment])
    assert many.status[0] == "solved" and "outside the map" in many.status[1]
    assert np.isnan(many.right[1]).all()
    assert read.error == contact_map.error
    copy = pickle.loads(pickle.dumps(contact_map))
    assert copy == contact_map == read
    assert pickle.loads(pickle.dumps(one)) == one == copy.solve(y=0.0003, axle_load=90e3)


def test_outside_is_an_error_that_names_the_bound(contact_map: creepage.ContactMap) -> None:
    outside: list[dict[str, Any]] = [
        {"y": 0.01}, {"yaw": 0.1}, {"friction": 0.9}, {"axle_load": 400e3}
    ]
    for wrong in outside:
        with pytest.raises(ValueError, match="outside the map"):
            contact_map.solve(**wrong)
    with pytest.raises(ValueError, match="exclude each other"):
        contact_map.solve(z=0.0, axle_load=90e3)


def test_derivatives_follow(contact_map: creepage.ContactMap) -> None:
    found = contact_map.solve(y=0.0003, axle_load=90e3, derivatives=True)
    assert found.derivatives is not None and found.derivatives.shape == (2, 6, 8)
    h = 1e-7
    ahead, behind = (
        contact_map.solve(y=0.0003 + step, axle_load=90e3).right.force[1] for step in (h, -h)
    )
    assert found.derivatives[1, 1, 0] == pytest.approx((ahead - behind) / (2 * h), rel=2e-2)


def test_what_is_in_no_map_is_refused_before_a_table_is_built(mapped: creepage.Wheelset) -> None:
    raised = creepage.Wheelset(wheel="S1002", rail="UIC60", cant=0.025, z=0.0)
    with pytest.raises(ValueError, match="needs axle_load or wheel_load for a contact map"):
        creepage.ContactMap.build(raised)
    with pytest.raises(ValueError, match="loads must be rising"):
        creepage.ContactMap.build(mapped, loads=[5.0, 4.0])
