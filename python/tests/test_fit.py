"""Friction fitted to measured forces."""

import numpy as np
import pytest

import creepage

STEEL = {"shear_modulus": 82e9, "poisson": 0.28}


def wheel(friction: float) -> creepage.Case:
    return creepage.Case.from_dict(
        {
            "upper": {**STEEL, "radius_rolling": 0.46, "radius_lateral": "flat"},
            "lower": {**STEEL, "radius_rolling": "flat", "radius_lateral": 0.3},
            "contact": {"normal_force": 80e3, "friction": friction},
            "creepage": {"longitudinal": 0.0},
            "solve": {"theory": "fastsim"},
        }
    )


CREEPAGES = np.linspace(0.5e-3, 6e-3, 12)


def test_friction_that_made_the_points_is_found() -> None:
    forces = wheel(0.24).force(longitudinal=CREEPAGES).longitudinal
    found = wheel(0.3).fit(longitudinal=CREEPAGES, longitudinal_force=forces, slope=True)
    # What the last Gauss-Newton step leaves open.
    assert found.friction.value == pytest.approx(0.24, rel=1e-4)
    assert found.slope is not None and found.slope.value == pytest.approx(1.0, rel=1e-3)
    assert found.bad == () and found.fitted.shape == (12, 2)
    np.testing.assert_allclose(found.fitted[:, 0], forces, rtol=1e-3)


def test_bad_points_and_gaps_are_named() -> None:
    forces = wheel(0.24).force(longitudinal=CREEPAGES).longitudinal.copy()
    forces[3], forces[7] = np.nan, 0.0
    with pytest.warns(creepage.AccuracyWarning, match="row 4") as told:
        found = wheel(0.3).fit(longitudinal=CREEPAGES, longitudinal_force=forces)
    assert "row 8" in str(told[0].message)
    assert found.bad == (7,) and 3 not in found.rows
    assert found.friction.value == pytest.approx(0.24, rel=1e-3)


def test_what_cannot_be_fitted_is_refused() -> None:
    case = wheel(0.3)
    with pytest.raises(ValueError, match="force is needed"):
        case.fit(longitudinal=CREEPAGES)
    with pytest.raises(ValueError, match="at least 3"):
        case.fit(longitudinal=[1e-3], longitudinal_force=[1e3])
    with pytest.raises(ValueError, match="do not determine mu"):
        case.fit(longitudinal=CREEPAGES, longitudinal_force=CREEPAGES * 1e6, theory="linear")
    with pytest.raises(TypeError):
        case.fit(longitudinal=CREEPAGES, longitudinal_force=CREEPAGES, no_option=1)
    masked = np.ma.array(CREEPAGES * 1e6, mask=[True] + [False] * 11)
    with pytest.raises(TypeError, match="longitudinal_force must not have masked"):
        case.fit(longitudinal=CREEPAGES, longitudinal_force=masked)
    with pytest.raises(TypeError, match="longitudinal must be real numbers"):
        case.fit(longitudinal=["1e-3", "2e-3", "3e-3"], longitudinal_force=[1e3, 2e3, 3e3])
