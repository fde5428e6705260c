"""Problems without rolling."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import creepage
import numpy as np
import pytest
from conftest import ROOT

FILES = sorted((ROOT / "examples" / "statics").glob("*.toml"))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_example_solves(path: Path, tmp_path: Path) -> None:
    solution = creepage.statics(path)
    assert all(math.isfinite(value) for value in solution.found.values())
    assert solution.to_dict()["found"] == solution.found
    paths = solution.save(tmp_path)
    assert json.loads(paths[0].read_text()) == solution.to_dict()
    assert paths[2].read_text() == solution.svg()
    assert "Found" in solution.text()


DIE = """
[lower]
shear_modulus = 82e9
poisson = 0.28
[contact]
normal_force = 20e3
semi_axis_rolling = 5e-3
semi_axis_lateral = 10e-3
[statics]
problem = "die"
"""


def test_a_die_is_flat_underneath() -> None:
    die = creepage.statics(DIE)
    x = np.linspace(-4e-3, 4e-3, 9)
    depth = die.displacement(x, 1e-3)[..., 2]
    # A rigid plane: the library's rounding.
    np.testing.assert_allclose(depth, die.found["indentation_m"], rtol=1e-10)
    assert die.pressure(0.0, 0.0) == pytest.approx(die.found["pressure_centre_pa"])
    assert die.pressure(x[:, None], np.zeros(3)).shape == (9, 3)
    with pytest.raises(ValueError, match="die"):
        die.traction(0.0, 0.0)


def test_balls_pull_inwards_and_are_pressed() -> None:
    ball = creepage.statics(ROOT / "examples" / "statics" / "soft-ball-pressed.toml")
    assert ball.problem == "compression"
    radius = ball.found["contact_radius_m"]
    x, y = np.array([0.5, -0.5]) * radius, np.zeros(2)
    # Symmetric about the axis; the soft ball draws together, and pulls the plate along.
    pull = ball.traction(x, y)
    np.testing.assert_allclose(pull[0], -pull[1], rtol=1e-12)
    assert pull[0, 0] < 0.0
    assert ball.pressure(0.0, 0.0) == pytest.approx(ball.found["peak_pressure_pa"])
    assert ball.pressure(2.0 * radius, 0.0) == 0.0
    with pytest.raises(ValueError, match="approach"):
        ball.displacement(0.0, 0.0)


def test_partial_slip_sticks_in_the_middle() -> None:
    body = {"shear_modulus": 82e9, "poisson": 0.28}
    file: dict[str, dict[str, Any]] = {
        "upper": body,
        "lower": body,
        "contact": {
            "normal_force": 80e3,
            "friction": 0.3,
            "semi_axis_rolling": 6e-3,
            "semi_axis_lateral": 6e-3,
        },
        "statics": {"problem": "partial-slip", "force_x": 12e3},
    }
    solution = creepage.statics(file)
    stuck = solution.found["adhesion_a_m"]
    # Cattaneo: c/a = (1 - F/(mu N))^(1/3).
    assert stuck == pytest.approx(6e-3 * 0.5 ** (1.0 / 3.0), rel=1e-12)
    x = np.linspace(-0.99, 0.99, 12) * stuck
    shift = solution.displacement(x, 0.0)[..., 0]
    np.testing.assert_allclose(shift, solution.found["shift_x_m"], rtol=1e-9)
    assert solution.traction(0.0, 0.0).shape == (2,)
    with pytest.raises(ValueError, match="pressure"):
        solution.pressure(0.0, 0.0)


def test_errors() -> None:
    with pytest.raises(creepage.CaseError, match="lifts off") as caught:
        creepage.statics(DIE + "offset_x = 4e-3\n")
    assert caught.value.section == "statics"
    with pytest.raises(creepage.CaseError, match="normal_force") as caught:
        creepage.statics(DIE.replace("20e3", "nan"))
    assert (caught.value.section, caught.value.key) == ("contact", "normal_force")
    with pytest.raises(creepage.CaseError, match="unknown key"):
        creepage.statics(DIE + "ofset = 3\n")


def test_numbers_in_other_units_are_told() -> None:
    assert creepage.statics(DIE).caution is None
    caution = creepage.statics(DIE.replace("82e9", "82e3")).caution
    assert caution is not None and "exceeds the shear modulus" in caution


def test_a_path_goes_to_and_fro() -> None:
    body = {"shear_modulus": 82e9, "poisson": 0.28}
    solved = creepage.statics({
        "upper": body,
        "lower": body,
        "contact": {"normal_force": 80e3, "friction": 0.3, "semi_axis_rolling": 4e-3, "semi_axis_lateral": 4e-3},
        "statics": {"problem": "shift-path", "along": "x", "steps": [{"force": 19.2e3}, {"force": 0.0}, {"shift": 0.0}]},
    })
    sliding = solved.found["sliding_shift_m"]
    # Mindlin's closed forms at .8 of the limit: there and back at zero force, to seven digits.
    assert abs(solved.steps[0]["shift_m"] / sliding - 0.6580048) < 1e-7
    assert abs(solved.steps[1]["shift_m"] / sliding - 0.0807621) < 1e-7
    assert solved.steps[2]["force_n"] < 0.0
    assert solved.traction(5e-3, 0.0).tolist() == [0.0, 0.0]
    with pytest.raises(ValueError, match="not known"):
        solved.displacement(0.0, 0.0)
    with pytest.raises(creepage.CaseError, match="slide in step 2"):
        creepage.statics({
            "upper": body,
            "lower": body,
            "contact": {"normal_force": 80e3, "friction": 0.3, "semi_axis_rolling": 4e-3, "semi_axis_lateral": 4e-3},
            "statics": {"problem": "shift-path", "along": "y", "steps": [{"force": 1.0}, {"force": 24e3}]},
        })


def test_a_layer_is_sheared_under_a_rectangle() -> None:
    solved = creepage.statics(ROOT / "examples" / "statics" / "clay-sheared.toml")
    # Stored forces of CONTACT 25.2, of which it prints four digits.
    forces = [step["force_n"] for step in solved.steps]
    assert all(abs(found - right) < 0.05 for found, right in zip(forces, [200.0, 262.4, 82.43], strict=False))
    assert solved.traction(0.0, 0.0).tolist() == [solved.found["traction_pa"], 0.0]
    assert solved.traction(0.6e-3, 0.0).tolist() == [0.0, 0.0]
    assert solved.pressure(0.4e-3, -0.4e-3) == pytest.approx(900e6)
    assert solved.steps[3]["plastic_displacement_m"] > solved.steps[0]["plastic_displacement_m"] == 0.0
    with pytest.raises(ValueError, match="not known"):
        solved.displacement(0.0, 0.0)
