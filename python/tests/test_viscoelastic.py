"""Viscoelastic cylinders: the numbers of the library, arrays, errors."""

from __future__ import annotations

from typing import Any

import creepage
import numpy as np
import pytest
from creepage import viscoelastic_cylinders

POLYMER: dict[str, Any] = {"shear_modulus": 1143e6, "poisson": 0.4, "ratio": 1.0, "radius": 50e-3, "load": 600e3}


def test_peaks_lie_between_the_elastic_ones() -> None:
    speed = np.array([1.0 / 3.0, 1.0, 5.0])
    found = viscoelastic_cylinders(**POLYMER, time=9e-3, speed=speed, force=108e3)
    # V tau = 3, 9, 45 mm: derived by closed form and quadrature, to the last digit.
    assert found.peak_pressure == pytest.approx([65.79321e6, 78.73363e6, 84.71802e6], rel=1e-6)
    assert found.creepage == pytest.approx([0.0141732, 0.0138060, 0.0117141], rel=2e-5)
    assert found.rolling_resistance == pytest.approx(600e3 * found.pressure_centre / 50e-3, rel=1e-12)
    alone = viscoelastic_cylinders(**POLYMER, time=9e-3, speed=1.0)
    assert isinstance(alone.leading_edge, float) and alone.creepage == 0.0
    assert alone.to_dict()["leading_edge"] == pytest.approx(5.837944e-3, rel=1e-6)


def test_nonsense_is_refused() -> None:
    with pytest.raises(creepage.InvalidValue, match="half-width"):
        viscoelastic_cylinders(**POLYMER, time=1e-9, speed=1.0)
    with pytest.raises(creepage.InvalidValue, match="friction times the load"):
        viscoelastic_cylinders(**POLYMER, time=9e-3, speed=1.0, force=180e3)
