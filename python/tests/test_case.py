"""Cases in SI units."""

from __future__ import annotations

import csv
import json
import math
import pickle
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import creepage
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from conftest import LOAD, RAIL, ROOT, STEEL, WHEEL, wheel
from creepage import Body, Case


def test_the_front_door_and_the_file_are_one_case(wheel_on_rail: Case) -> None:
    case = wheel(longitudinal=-1.5e-3)
    assert case.creepage == wheel_on_rail.creepage
    assert case.contact == wheel_on_rail.contact
    assert case.dimensionless == wheel_on_rail.dimensionless
    solution = case.solve()
    assert solution.force == wheel_on_rail.solve(resolution="standard").force
    # Printed in the library's documentation.
    assert solution.force.longitudinal == pytest.approx(-14.56e3, abs=20.0)
    assert Case.from_toml(case.to_toml()).creepage == case.creepage
    assert pickle.loads(pickle.dumps(case)).contact == case.contact


EXAMPLES = sorted((ROOT / "examples").glob("*.toml"))


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_example_solves(path: Path) -> None:
    case = Case.from_toml(str(path))
    solution = case.solve(resolution="fast")
    assert solution.status == creepage.Status.SOLVED
    limit = solution.friction * solution.contact.normal_force
    # A wanted force may be none.
    assert math.hypot(*solution.force[:2]) <= limit * 1.01
    # By the forces, the heat of coupled bodies in free rolling is lost in rounding of the grid.
    coupled = "coupled = true" in path.read_text()
    heat = solution.heat_per_metre_by_slip if coupled else solution.heat_per_metre
    assert heat is not None and heat > 0.0
    assert (solution.known is not None) == ("\n[wanted]" in path.read_text())
    assert repr(case).startswith("<creepage.Case N = ")


def test_as_fine_as_an_accuracy_needs() -> None:
    case = wheel(longitudinal=-1.5e-3, resolution="auto", accuracy=0.004)
    assert repr(case.theory()).startswith("creepage.automatic(")
    solution = case.solve()
    assert solution.to_dict()["theory"] == "exact"  # as in the report of the command
    assert solution.details["fx_error"] <= 0.004
    assert solution.heat_per_metre_by_slip is not None
    # What a call says goes before the file.
    elements = [case.solve(accuracy=wanted).details["elements"] for wanted in (0.9, 1e-9)]
    assert elements[0] < elements[1]
    caution = case.solve(accuracy=1e-9).caution
    assert caution is not None and "above the prescribed accuracy" in caution
    assert solution.caution is None
    assert repr(case.theory(resolution="fast")).startswith("creepage.exact(")
    assert "accuracy=0.001" in repr(wheel(xi=1.0, resolution="auto").theory())
    assert case.solve("fastsim").force != solution.force
    with pytest.raises(creepage.InvalidOption, match="auto"):
        wheel(xi=1.0, accuracy=0.01).solve()
    with pytest.raises(creepage.InvalidOption):
        wheel(xi=1.0).solve(accuracy=0.01)
    wanted = wheel(fx=0.5, eta=0.0, chi=0.2, resolution="auto", accuracy=0.004).solve()
    assert wanted.dimensionless.fx == pytest.approx(0.5, abs=1e-6)
    assert wanted.details["fx_error"] <= 0.004


@pytest.mark.parametrize("name", list(creepage.THEORIES))
def test_si_units_are_the_dimensionless_ones_scaled(name: str) -> None:
    case = wheel(longitudinal=1e-3, lateral=4e-4, spin=0.1)
    solution = case.solve(name)
    force = case.theory(name).force(*case.dimensionless)
    limit = 0.3 * 80e3
    # The same code; the products may round once.
    assert solution.force.longitudinal == pytest.approx(limit * force.fx, rel=1e-14)
    assert solution.force.lateral == pytest.approx(limit * force.fy, rel=1e-14)
    assert solution.force.moment == pytest.approx(limit * solution.length * force.mz, rel=1e-12)
    heat = sum(f * c for f, c in zip(solution.force, solution.creepage, strict=True))
    assert solution.heat_per_metre == pytest.approx(heat, rel=1e-12)
    area = math.pi * solution.contact.semi_axis_rolling * solution.contact.semi_axis_lateral
    assert solution.adhesion_area + solution.slip_area == pytest.approx(area, rel=1e-12)
    assert solution.adhesion_area == pytest.approx(solution.adhesion_share * area)
    assert solution.theory.name == name


def test_the_report_is_that_of_the_command(tmp_path: Path) -> None:
    solution = wheel(lateral=1e-3).solve("fastsim")
    paths = solution.save(tmp_path / "new" / "out")
    assert [path.name for path in paths] == [
        "report.json",
        "points.csv",
        "contact.svg",
        "contact.png",
        "contact.vtk",
    ]
    assert json.loads(paths[0].read_text()) == solution.to_dict()
    assert paths[2].read_text() == solution.svg() == solution._repr_svg_()
    assert paths[3].read_bytes().startswith(b"\x89PNG")
    with paths[1].open() as rows:
        assert len(list(csv.reader(rows))) - 1 == len(solution.points().region)
    assert "fastsim" in solution.text()
    with pytest.raises(OSError, match="file"):
        (tmp_path / "file").touch()
        solution.save(tmp_path / "file")


def test_options_of_case_and_call() -> None:
    case = wheel(chi=1.0, theory="fastsim", grid=(10, 12), bound="parabolic")
    assert "grid=[10, 12]" in repr(case.theory())
    assert "bound='parabolic'" in repr(case.theory())
    # Another theory has its usual options, whatever those of the case are called.
    assert not {"grid", "bound"} & set(repr(case.theory("fastrip")).replace("=", " ").split())
    at = case.dimensionless
    usual = creepage.fastrip(case.contact.a_over_b, case.contact.poisson).force(*at)
    assert case.solve("fastrip").dimensionless.fx == usual.fx
    assert "grid=(5, 5)" in repr(case.theory(grid=(5, 5)))
    assert case.solve().force != case.solve(grid=(5, 5)).force
    assert case.solve("exact").details["fx_error"] > 0.0
    # A bound is an option of two theories, in words of their own.
    assert "bound" not in repr(case.theory("variational"))
    assert "bound='kept'" in repr(wheel(xi=1.0, theory="variational", bound="kept").theory())
    with pytest.raises(creepage.InvalidOption, match="not valid for fastsim"):
        wheel(xi=1.0, theory="fastsim", bound="kept").solve()
    for factors in ((0.6, 0.3), [1, 1]):
        dirty = wheel(xi=0.1, theory="polach", reduction=factors)
        force = creepage.polach(dirty.contact.a_over_b, dirty.contact.poisson, reduction=factors)
        assert dirty.solve().dimensionless.fx == force.force(0.1).fx
    with pytest.raises(creepage.InvalidValue, match="0 < slip <= adhesion") as refused:
        wheel(xi=0.1, theory="polach", reduction=(0.5, 0.7)).solve()
    assert refused.value.quantity == "reduction"
    with pytest.raises(TypeError):
        case.solve("linear", grid=(5, 5))
    with pytest.raises(creepage.UnknownTheory):
        case.solve("linaer")


def test_dimensionless_creepage_and_a_given_ellipse() -> None:
    body = Body(young_modulus=210e9, poisson=0.3)
    case = Case(
        upper=body, lower=body, **LOAD, xi=0.5, eta=-0.25,
        semi_axis_rolling=6e-3, semi_axis_lateral=4e-3,
    )  # fmt: skip
    assert case.dimensionless == (0.5, -0.25, 0.0)
    assert case.contact.a_over_b == pytest.approx(1.5)
    assert case.friction == 0.3
    assert case.theory_name == "exact"


@pytest.mark.parametrize(
    ("change", "section", "key", "message"),
    [
        ({"friction": -0.3}, "contact", "friction", "greater than zero"),
        ({"normal_force": math.nan}, "contact", "normal_force", "NaN"),
        ({"longitudinal": math.inf}, "creepage", "longitudinal", "inf"),
        ({"xi": 0.5}, "creepage", "longitudinal", "exclude each other"),
        ({"upper": Body(poisson=0.28)}, "upper", "shear_modulus", "needs"),
        ({"upper": Body(**STEEL, radius_rolling=0.0)}, "upper", "radius_rolling", "metres"),
        ({"semi_axis_rolling": 1e-3}, "contact", "semi_axis_lateral", "missing"),
        ({"angle": 30.0}, "contact", "angle", "turns the contact ellipse"),
        ({"girth": 3}, None, "girth", "unknown key"),
    ],
)
def test_errors_name_section_and_key(
    change: dict[str, Any], section: str | None, key: str | None, message: str
) -> None:
    given = {"upper": WHEEL, "lower": RAIL, **LOAD, "longitudinal": 1e-3}
    with pytest.raises(creepage.CaseError, match=message) as caught:
        Case(**{**given, **change})
    assert (caught.value.section, caught.value.key) == (section, key)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


def test_what_is_no_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        Case.from_toml(tmp_path / "none.toml")
    with pytest.raises(creepage.CaseError, match="TOML"):
        Case.from_toml("[upper\n")
    with pytest.raises(creepage.CaseError, match="did you mean `friction`"):
        Case.from_toml(wheel(xi=1.0).to_toml().replace("friction", "fricton"))
    with pytest.raises(TypeError, match="mapping"):
        Case.from_dict({"upper": 3})  # type: ignore[dict-item]
    with pytest.raises(TypeError, match="must be a number"):
        wheel(xi=[[object()]])
    with pytest.raises(TypeError, match="xi must be a number, got 'much'"):
        wheel(xi="much")


def test_a_solution_is_pickled_by_its_question() -> None:
    solution = wheel(lateral=1e-3).solve("fastsim", grid=(9, 9))
    copy = pickle.loads(pickle.dumps(solution))
    assert (copy.force, copy.theory.name) == (solution.force, "fastsim")
    assert str(solution) == solution.text()
    assert repr(solution).startswith("<creepage.Solution fastsim: solved, SiForce(")


@pytest.mark.parametrize("name", ["linear", "polach", "fastsim"])
def test_a_solution_computes_only_what_is_asked_for(name: str) -> None:
    case = wheel(longitudinal=1e-3, spin=0.1)

    def least(work: Callable[[], object]) -> float:
        def seconds() -> float:
            start = time.process_time()
            work()
            return time.process_time() - start

        return min(seconds() for _ in range(20))

    # A report traces the areas of adhesion, which costs a hundred times as much as the force.
    assert least(lambda: case.solve(name).force) < 0.1 * least(lambda: case.solve(name).text())


def test_numpy_numbers_do_for_a_case() -> None:
    case = wheel(longitudinal=np.float32(0.0009765625), theory="fastsim", grid=np.array([9, 9]))
    assert case.creepage.longitudinal == 2.0**-10
    assert "grid=[9, 9]" in repr(case.theory())


def test_pictures(wheel_on_rail: Case, tmp_path: Path) -> None:
    solution = wheel_on_rail.solve()
    axes = solution.plot()
    assert "mm" in axes.get_xlabel()
    assert axes.patches
    plt.savefig(tmp_path / "contact.png")
    field = solution.field(points=5)
    assert field.plot(plt.subplots()[1]).get_aspect() == 1.0
    with pytest.raises(ValueError, match="grid"):
        solution.points().plot()
    plt.close("all")


def test_creep_curves(wheel_on_rail: Case) -> None:
    curve = wheel_on_rail.curve("longitudinal", theories=["exact", "fastsim"])
    exact = curve.forces["exact"][0]
    assert curve.values.shape == exact.shape == (101,)
    assert curve.values[0] == 0.0 and curve.values[-1] < wheel_on_rail.creepage.longitudinal
    assert (np.diff(exact) < 1e-6).all()  # towards saturation, on the negative side
    assert exact[-1] == pytest.approx(-0.3 * 80e3, rel=1e-3)
    assert np.abs(exact - curve.forces["fastsim"][0]).max() < 0.06 * 0.3 * 80e3
    table = pd.DataFrame(curve.to_dict())
    assert len(table) == 202
    assert table.longitudinal_n.iloc[100] == exact[-1]
    assert curve.plot().get_lines()[0].get_label() == "exact"
    plt.close("all")


@pytest.mark.parametrize("vary", ["lateral", "spin"])
def test_a_curve_meets_the_case(vary: Any) -> None:
    case = wheel(lateral=4e-4, spin=0.1, theory="fastrip")
    curve = case.curve(vary, [0.0, getattr(case.creepage, vary)])
    force = case.solve().force
    # Creepage goes to SI and back: rounding.
    assert curve.forces["fastrip"][:, 1] == pytest.approx(list(force), rel=1e-9)
    assert curve.plot().get_ylabel().startswith("lateral")
    assert case.curve(vary).values[-1] > 0.0
    with pytest.raises(ValueError, match="shape"):
        case.curve(vary, 3.0)
    with pytest.raises(creepage.InvalidValue):
        case.curve(vary, [0.0, math.nan])
    plt.close("all")
