"""Laws of friction, layers, wear and fatigue."""

from __future__ import annotations

import creepage
import numpy as np
import pytest
from conftest import STEEL_WHEEL
from creepage import Case


def test_a_law_of_friction_a_layer_and_damage() -> None:
    law = {"law": "exponential", "kinetic": 0.18, "terms": [{"drop": 0.12, "half_speed": 0.1}]}
    grease = {"thickness": 20e-6, "shear_modulus": 106e6}
    contact = {**STEEL_WHEEL, "friction": law, "longitudinal": 2e-3, "speed": 30.0}
    solution = Case(**contact, layer=grease, damage={}, theory="fastsim").solve()
    assert solution.friction == pytest.approx(0.30, abs=1e-15)
    numbers = solution.damage
    assert numbers is not None
    assert numbers["t_gamma_with_spin_n"] == pytest.approx(solution.heat_per_metre, rel=1e-12)
    assert Case(**contact, theory="fastsim").solve().damage is None
    # Row by row too, the same numbers.
    worn = Case(**contact, damage={}, theory="fastsim")
    rows = worn.force(longitudinal=np.array([1e-3, 2e-3]))
    alone = worn.solve().damage
    assert alone is not None and rows.damage["t_gamma_n"].shape == (2,)
    for name, values in rows.damage.items():
        assert values[1] == pytest.approx(alone[name], rel=1e-12), name
    table = creepage.batch({"longitudinal": [1e-3, 2e-3]}, case=worn)
    assert list(table["t_gamma_n"]) == list(rows.damage["t_gamma_n"])
    assert list(rows.to_dict()["wlrm_damage"]) == list(table["wlrm_damage"])
    with pytest.raises(ValueError, match="t_gamma_n"):
        creepage.batch({"longitudinal": [1e-3], "t_gamma_n": [0.0]}, case=worn)
    # Greased on one side: less force than without, and a moment.
    across = {"across": [[-5e-3, 0.1], [5e-3, 0.3]]}
    greased = Case(**STEEL_WHEEL, friction=across, xi=50.0, theory="fastsim").solve()
    assert greased.dimensionless.fx < 0.9
    assert greased.dimensionless.mz < 0.0
    with pytest.raises(creepage.CaseError, match="two to seven"):
        Case(**STEEL_WHEEL, friction={"across": [[0.0, 0.3]]})
