"""Vehicles on other engines: the examples with a small map, short."""

from __future__ import annotations

import importlib.util
import math
import re
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import creepage
import numpy as np
import pytest
from conftest import ROOT

pytest.importorskip("scipy")


def example(name: str) -> ModuleType:
    """An example as a module."""
    path = ROOT / "python" / "examples" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def reference() -> Any:
    """The wheelset on springs."""
    return example("reference_wheelset")


@pytest.fixture(scope="module")
def solver(reference: Any) -> creepage.WheelsetSolver:
    """By coarse elements: seconds instead of minutes."""
    wheelset: creepage.Wheelset = reference.wheelset("exact", resolution="fast")
    return wheelset.solver()


def test_a_map_moves_the_wheelset_as_the_solver_does(
    reference: Any, solver: creepage.WheelsetSolver, contact_map: creepage.ContactMap
) -> None:
    push = reference.asked(contact_map, friction=reference.FRICTION)
    path = reference.stepped(push, 30.0, np.array([6e-4, 0.0, 0.0, 0.0]), 0.1)
    # A small swing below the critical speed, within the small map.
    assert np.abs(path[:, 0]).max() < 1e-3 and path[:, 0].min() < 0.0
    rms, _ = reference.compared(push, solver, path[::10], 30.0)
    # A map of a coarse table of seven shapes errs by some per cent of mu N.
    assert rms < 0.05


def test_the_exact_table_has_the_forces_of_the_solver(reference: Any, solver: creepage.WheelsetSolver) -> None:
    table = reference.exact_table(solver, (5, 5, 5), 8e-4)
    push, exact = table.push(), reference.followed(solver)
    for y, slip in ((2e-4, 0.0), (-4e-4, 1.3e-3)):
        at = np.array([y, -slip, 0.0, 0.0])
        found, right = push(at, 38.0), exact(np.array([y, 0.0, slip * 38.0, 0.0]), 38.0)
        # Splines through five nodes of a force that saturates.
        assert np.abs(np.subtract(found, right)).max() < 0.08 * 0.4 * 100e3
    # A table is odd: at rest in the middle there is no force.
    assert np.abs(push(np.zeros(4), 38.0)).max() < 1e-6 * 100e3


@pytest.mark.parametrize("name", ["polach", "linear"])
def test_one_ellipse_a_wheel_has_the_kinematics_of_the_solver(
    reference: Any, solver: creepage.WheelsetSolver, name: str
) -> None:
    push = reference.ellipse_table(solver, name, (3, 7, 7), 8e-4).push()
    exact = reference.followed(solver)
    slip, turn = 1e-4, 1e-4
    states = ([4e-4, 0.0, 0.0, 0.0], [0.0, 0.0, 38.0 * slip, 0.0], [0.0, 0.0, 0.0, 38.0 * turn])
    aside, slipping, turning = (
        [np.array(one(np.array(at), 38.0)) for one in (push, exact)] for at in states
    )
    # The moment by the radii's difference over that by turning is kinematics: how stiff the contacts are drops out. What does
    # not is spin's part, some per cent.
    found, right = (aside[k][1] / turning[k][1] for k in (0, 1))
    assert found == pytest.approx(right, rel=0.1)
    # Creep forces act against the slip, as the solver's do.
    assert slipping[0][0] < 0.0 and slipping[1][0] < 0.0


def test_exudyn_runs_a_vehicle_on_a_map(contact_map: creepage.ContactMap, tmp_path: Path) -> None:
    pytest.importorskip("exudyn", reason="exudyn is not installed here")
    vehicle = example("exudyn_vehicle")
    rest = contact_map.solve(y=0.0, axle_load=vehicle.AXLE_LOAD, speed=vehicle.SPEED, friction=vehicle.FRICTION)
    run = vehicle.simulate(vehicle.by_map(contact_map), rest, 0.15)
    y = vehicle.histories(run, contact_map).y
    assert np.isfinite(y).all() and 1e-6 < np.abs(y).max() < 1e-3
    # Half the step, nearly the same: the method is of order four, the map's second derivatives jump.
    finer = vehicle.simulate(vehicle.by_map(contact_map), rest, 0.15, 2e-4)
    assert run.coordinates[-1][:24] == pytest.approx(finer.coordinates[-1][:24], abs=2e-6)
    solver = creepage.Wheelset(
        wheel="S1002", rail="UIC60", cant=math.atan(1 / 40), axle_load=100e3, friction=0.3
    ).solver("exact", resolution="fast")
    missed = vehicle.compared(run, contact_map, solver, 8)
    # As above.
    assert missed["lateral force"][0] < 0.05 and missed["load"][0] < 0.02
    vehicle.picture(run, vehicle.histories(run, contact_map), tmp_path / "run.png")
    assert (tmp_path / "run.png").read_bytes().startswith(b"\x89PNG")


def test_the_recipe_for_jax_has_the_slopes_of_the_map(contact_map: creepage.ContactMap) -> None:
    jax = pytest.importorskip("jax", reason="jax is not installed here")
    page = (ROOT / "book" / "pages" / "how-to" / "vehicle.md").read_text()
    recipe = re.search(r"^```python\n(import jax.*?)^```", page, re.M | re.S)
    assert recipe is not None
    names: dict[str, Any] = {"contacts": contact_map}
    exec(recipe.group(1), names)  # noqa: S102
    at = np.array([3e-4, 1e-3, 0.01, 0.002])
    forward, backward = jax.jacfwd(names["wrench"])(at), jax.jacrev(names["wrench"])(at)
    own = names["slopes"](at)
    assert np.allclose(forward, own, rtol=1e-12) and np.allclose(backward, own, rtol=1e-12)
    both = jax.jit(jax.vmap(names["wrench"]))(np.stack([at, -at]))
    # Both sides are mirror images: lateral force and yaw moment change sign.
    assert np.allclose(both[0, [1, 5]], -both[1, [1, 5]], atol=1.0)
