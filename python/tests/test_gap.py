"""Contacts of any shape from Python: the command's numbers, arrays in place of files, errors."""

from __future__ import annotations

import csv
import json
import pickle
from pathlib import Path
from typing import Any

import creepage
import numpy as np
import pytest
from conftest import LOAD, ROOT, STEEL, wheel
from creepage import Body, Gap, GapCase

EXAMPLES = ROOT / "examples" / "gap"
MATERIAL = Body(**STEEL)
BALL = Gap.polynomial([(2, 0, 1.0 / 0.92), (0, 2, 1.0 / 0.6)])
"""The wheel of the examples on its rail, as an undeformed distance."""


def case(gap: Gap = BALL, **more: Any) -> GapCase:
    pressed = {"friction": 0.3} if "approach" in more else LOAD
    return GapCase(gap=gap, upper=MATERIAL, lower=MATERIAL, **pressed, **more)


def test_an_ellipse_is_the_case_of_hertz() -> None:
    motion: dict[str, Any] = {"longitudinal": 1e-3, "lateral": 4e-4, "spin": 0.1}
    found = case(**motion).solve()
    hertz = wheel(**motion).solve(resolution="standard")
    assert found.status == "solved" and found.force_error is not None
    assert found.contact["peak_pressure_pa"] == pytest.approx(
        hertz.contact.peak_pressure, abs=found.contact["peak_pressure_error_pa"]
    )
    units = (0.3 * 80e3, 0.3 * 80e3, 0.3 * 80e3 * hertz.length)
    bars = [hertz.details[f"{name}_error"] for name in ("fx", "fy", "mz")]
    for a, b, own, bar, unit in zip(
        found.force, hertz.force, found.force_error, bars, units, strict=True
    ):
        assert abs(a - b) <= own + bar * unit


def test_an_ellipse_and_areas_have_the_same_quantities() -> None:
    """The list is that of report.json, with error bars; both contacts are the same bodies."""
    motion: dict[str, Any] = {"longitudinal": 1e-3, "lateral": 4e-4, "spin": 0.1}
    areas, hertz = case(**motion).solve(), wheel(**motion).solve(resolution="standard")
    for found in (areas, hertz):
        report = found.to_dict()
        for path, one in found.quantities.items():
            section, _, key = path.rpartition(".")
            place = report
            for name in section.split(".") if section else []:
                place = place[name]
            assert place[key] == one.value and one.label, path
    force = hertz.quantities["lower_body.lateral_n"]
    assert force.unit == "N" and force.value == hertz.force.lateral
    for path in ("contact.peak_pressure_pa", "contact.area_m2", "lower_body.lateral_n"):
        a, b = areas.quantities[path], hertz.quantities[path]
        assert a.value is not None and b.value is not None and a.error is not None and b.error is not None
        assert (a.label, a.unit) == (b.label, b.unit)
        # 95 of 100 errors are within one bar; three leave room.
        assert abs(a.value - b.value) <= 3.0 * (a.error + b.error), path


def test_arrays_are_the_points_of_a_file() -> None:
    text = (EXAMPLES / "two-patches.toml").read_text()
    by_file = GapCase.from_toml(EXAMPLES / "two-patches.toml")
    with (EXAMPLES / "two-patches.csv").open() as rows:
        points = np.array([[float(v) for v in row] for row in list(csv.reader(rows))[1:]])
    gap = Gap.section(points[:, 0], points[:, 1], radius_rolling=0.46)
    assert '"section"' not in text
    by_arrays = case(gap, lateral=0.0, spin=0.05, longitudinal_force=10e3)
    one, other = by_file.solve("fastsim"), by_arrays.solve("fastsim")
    assert len(one.contact["patches"]) == 2
    assert one.force == other.force and one.contact == other.contact
    assert pickle.loads(pickle.dumps(by_arrays)).solve("fastsim").force == other.force
    varying = Gap.section(points[:, 0], points[:, 1], radius_rolling=np.full(len(points), 0.46))
    again = case(varying, lateral=0.0, spin=0.05, longitudinal_force=10e3).solve("fastsim")
    # The same curve by another formula.
    assert again.force == pytest.approx(list(one.force), rel=1e-4, abs=0.1)


def test_a_grid_of_an_ellipse() -> None:
    x, y = np.linspace(-12e-3, 12e-3, 49), np.linspace(-10e-3, 10e-3, 41)
    gap = Gap.grid(x, y, x[:, None] ** 2 / 0.92 + y[None, :] ** 2 / 0.6)
    one, other = (case(g, longitudinal=1e-3).solve("fastsim") for g in (BALL, gap))
    # A cubic through points of a parabola is that parabola; what is left are the numbers' own errors.
    assert other.contact["area_m2"] == pytest.approx(one.contact["area_m2"], rel=2e-3)
    assert other.force.longitudinal == pytest.approx(one.force.longitudinal, rel=2e-3)


def test_many_on_all_cores(tmp_path: Path) -> None:
    loads = (20e3, 40e3, 80e3)
    one_by_one = [
        GapCase(
            gap=BALL, upper=MATERIAL, lower=MATERIAL, friction=0.3, normal_force=n, longitudinal=1e-3
        )
        for n in loads
    ]
    apart = case(BALL, approach=-1e-6, longitudinal=1e-3)
    *solved, refused = GapCase.solve_all([*one_by_one, apart], "linear")
    assert isinstance(refused, creepage.CaseError) and refused.section == "contact"
    for alone, together in zip(one_by_one, solved, strict=True):
        assert isinstance(together, creepage.GapSolution)
        assert together.force == alone.solve("linear").force
    written = solved[0].save(tmp_path / "out")  # type: ignore[union-attr]
    assert json.loads(written[0].read_text())["theory"] == "linear"


def test_a_file_of_points_is_not_written_over(tmp_path: Path) -> None:
    y = [1e-3 * k for k in range(-20, 21)]
    points = tmp_path / "points.csv"
    points.write_text("y,gap\n" + "".join(f"{a},{a * a / 0.6}\n" for a in y))
    before = points.read_text()
    (tmp_path / "gap.toml").write_text(
        "upper = { shear_modulus = 82e9, poisson = 0.28 }\n"
        "lower = { shear_modulus = 82e9, poisson = 0.28 }\n"
        "gap = { section = 'points.csv', radius_rolling = 0.46 }\n"
        "contact = { normal_force = 80e3, friction = 0.3 }\n"
        "creepage = { longitudinal = 1e-3 }\n"
        "solve = { theory = 'linear' }\n"
    )
    solution = GapCase.from_toml(tmp_path / "gap.toml").solve()
    with pytest.raises(FileExistsError, match=r"points\.csv would be written over what was read"):
        solution.save(tmp_path)
    assert points.read_text() == before
    assert (tmp_path / "out" / "points.csv") in solution.save(tmp_path / "out")


def test_what_is_no_case_is_refused() -> None:
    with pytest.raises(creepage.CaseError, match="no meaning beside") as caught:
        GapCase(gap=BALL, upper=Body(**STEEL, radius_rolling=0.46), lower=MATERIAL, **LOAD)
    assert caught.value.section == "upper"
    with pytest.raises(creepage.CaseError, match="column y has 2 numbers, but column gap has 3"):
        case(Gap.section([0.0, 1.0], [0.0, 1.0, 2.0], radius_rolling=0.46), spin=0.1)
    with pytest.raises(creepage.CaseError, match="exactly one of") as caught:
        case(Gap({}), spin=0.1)
    assert caught.value.section == "gap"
    with pytest.raises(ValueError, match="shape"):
        Gap.grid([0.0, 1.0], [0.0, 1.0], [[0.0, 1.0]])
    with pytest.raises(creepage.CaseError, match="needs an ellipse"):
        case(longitudinal=1e-3).solve("polach")
    with pytest.raises(creepage.NotReachable):
        case(longitudinal_force=0.0, lateral=0.0, moment=120.0).solve("fastsim")


def test_a_slip_from_place_to_place() -> None:
    """One that is the same everywhere is a creepage, on an ellipse, on any shape and in steps."""
    gap = Gap.polynomial([(2, 0, 1.087), (0, 2, 1.667)])
    uniform = {"x": [0.0], "y": [0.0], "longitudinal": [-1e-3], "lateral": [0.0]}
    y = np.linspace(-8e-3, 8e-3, 9)
    groove = {"x": np.zeros(9), "y": y, "longitudinal": -50 * y**2, "lateral": np.zeros(9)}
    bodies = {"upper": MATERIAL, "lower": MATERIAL}
    common: dict[str, Any] = {**bodies, "normal_force": 80e3, "friction": 0.3, "resolution": "fast"}
    axes: dict[str, Any] = {"semi_axis_rolling": 6e-3, "semi_axis_lateral": 4e-3}
    kinds: list[tuple[Any, dict[str, Any]]] = [(creepage.Case, axes), (GapCase, {"gap": gap})]
    for kind, shape in kinds:
        whole = kind(longitudinal=-1.5e-3, **shape, **common).solve().force.longitudinal
        split = kind(longitudinal=-0.5e-3, slip=uniform, **shape, **common).solve().force.longitudinal
        assert split == pytest.approx(whole, abs=0.01)  # solved to some 1e-7 of mu N, 24 kN
        curved = kind(longitudinal=-0.5e-3, slip=groove, **shape, **common).solve().force.longitudinal
        assert abs(curved - whole) > 240
    case = creepage.Case(longitudinal=0.0, slip=uniform, **axes, **common)
    rolled = creepage.Rolling(case).step(0.05, longitudinal=-0.5e-3).force.longitudinal
    plain = creepage.Case(longitudinal=-1.5e-3, **axes, **common)
    assert rolled == pytest.approx(plain.solve().force.longitudinal, abs=240)
    with pytest.raises(creepage.CaseError, match="no point at"):
        creepage.Case(
            longitudinal=0.0,
            slip={"x": [0.0, 1e-3], "y": [0.0, 1e-3], "longitudinal": [0, 0], "lateral": [0, 0]},
            **axes,
            **common,
        )
    with pytest.raises(ValueError, match="shape"):
        GapCase(gap=gap, longitudinal=0.0, slip={"x": [[0.0]]}, **common)
