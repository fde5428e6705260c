"""Temperatures: the section, its numbers, what is refused."""

from __future__ import annotations

from typing import Any

import pytest
from creepage import Body, Case, CaseError, Gap, GapCase

STEEL = Body(shear_modulus=82e9, poisson=0.28)
ERTZ: dict[str, Any] = {
    "normal_force": 100e3,
    "semi_axis_rolling": 5.878886e-3,
    "semi_axis_lateral": 10.540448e-3,
    "longitudinal": 0.033333,
}
HEAT: dict[str, Any] = {"upper": {"material": "steel"}, "lower": {"material": "steel", "bulk_temperature": 150.0}}


def test_the_flash_of_a_sliding_wheel() -> None:
    sliding: dict[str, Any] = {"upper": STEEL, "lower": STEEL, "friction": 0.3, **ERTZ}
    solution = Case(**sliding, speed=30.0, heat=HEAT, theory="fastsim").solve()
    heat = solution.heat
    assert heat is not None
    # The creepage makes the surfaces pass at different speeds: a fourth of it in the shares.
    assert abs(heat["contact_temperature_unrubbed_c"] - 75.0 * (1.0 + 0.033333 / 4.0)) < 0.01
    # 152.69 K by a march in closed form; fastsim's slip varies otherwise along the contact.
    assert abs(heat["flash_max_k"] / 152.69 - 1.0) < 0.03
    into = heat["into_upper_w"] + heat["into_lower_w"]
    assert abs(into - heat["friction_w"]) < 1e-6 * heat["friction_w"]
    assert Case(**sliding, theory="fastsim").solve().heat is None


def test_friction_falls_with_the_temperature() -> None:
    law = {"cold": 0.3, "hot": 0.12, "temperatures": [100.0, 130.0]}
    bodies: dict[str, Any] = {"upper": STEEL, "lower": STEEL}
    hot = Case(**bodies, friction=law, speed=30.0, heat=HEAT, theory="fastsim", **ERTZ).solve()
    # The contact is at 75 degrees before it is rubbed: friction falls early.
    assert 0.4 <= hot.dimensionless.fx <= 0.9
    with pytest.raises(CaseError, match="needs \\[heat\\]"):
        Case(upper=STEEL, lower=STEEL, friction=law, speed=30.0, **ERTZ)


def test_what_is_refused() -> None:
    with pytest.raises(CaseError, match="speed, which \\[heat\\] needs"):
        Case(upper=STEEL, lower=STEEL, friction=0.3, heat=HEAT, **ERTZ)
    gap = Gap.polynomial([(2, 0, 1.015), (0, 2, 0.4215)])
    with pytest.raises(CaseError, match="conductivity"):
        GapCase(
            gap=gap,
            upper=STEEL,
            lower=STEEL,
            friction=0.3,
            normal_force=1e5,
            longitudinal=0.0,
            speed=1.0,
            heat={"upper": {}, "lower": {}},
        )
