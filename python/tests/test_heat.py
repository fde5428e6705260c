"""Temperatures: the section, its numbers, what is refused."""

import pytest
from creepage import Body, Case, CaseError, GapCase, Gap

STEEL = Body(shear_modulus=82e9, poisson=0.28)
ERTZ = {
    "normal_force": 100e3,
    "semi_axis_rolling": 5.878886e-3,
    "semi_axis_lateral": 10.540448e-3,
    "longitudinal": 0.033333,
}
HEAT = {"upper": {"material": "steel"}, "lower": {"material": "steel", "bulk_temperature": 150.0}}


def test_the_flash_of_a_sliding_wheel() -> None:
    solution = Case(upper=STEEL, lower=STEEL, friction=0.3, speed=30.0, heat=HEAT, theory="fastsim", **ERTZ).solve()
    heat = solution.heat
    assert heat is not None
    assert heat["contact_temperature_unrubbed_c"] == 75.0
    # 152.69 K by a march in closed form; fastsim's slip varies otherwise along the contact.
    assert abs(heat["flash_max_k"] / 152.69 - 1.0) < 0.03
    assert abs(heat["into_upper_w"] + heat["into_lower_w"] - heat["friction_w"]) < 1e-6 * heat["friction_w"]
    assert Case(upper=STEEL, lower=STEEL, friction=0.3, theory="fastsim", **ERTZ).solve().heat is None


def test_friction_falls_with_the_temperature() -> None:
    law = {"cold": 0.3, "hot": 0.12, "temperatures": [100.0, 130.0]}
    hot = Case(upper=STEEL, lower=STEEL, friction=law, speed=30.0, heat=HEAT, theory="fastsim", **ERTZ).solve()
    assert 0.12 * 100e3 <= hot.force.fx <= 0.9 * 0.3 * 100e3
    with pytest.raises(CaseError, match="needs \\[heat\\]"):
        Case(upper=STEEL, lower=STEEL, friction=law, speed=30.0, **ERTZ)


def test_what_is_refused() -> None:
    with pytest.raises(CaseError, match="speed, which \\[heat\\] needs"):
        Case(upper=STEEL, lower=STEEL, friction=0.3, heat=HEAT, **ERTZ)
    gap = Gap.polynomial([(2, 0, 1.015), (0, 2, 0.4215)])
    with pytest.raises(CaseError, match="conductivity"):
        GapCase(gap=gap, upper=STEEL, lower=STEEL, friction=0.3, normal_force=1e5, speed=1.0, heat={"upper": {}, "lower": {}})
