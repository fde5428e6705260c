"""A contact along the curve of a groove."""

from __future__ import annotations

from typing import Any

import pytest
from creepage import Body, CaseError, Gap, GapCase

BODY = Body(shear_modulus=80e9, poisson=0.28)


def groove(**more: Any) -> GapCase:
    gap = Gap.groove(10e-3, 10.05e-3, rolling=420e-3)
    pressed = {"friction": 0.3, "normal_force": 10e3, "longitudinal": 0.0, "resolution": "fast"}
    return GapCase(gap=gap, upper=BODY, lower=BODY, **{**pressed, **more})


def test_the_curve_presses_harder_than_the_plane() -> None:
    curved, plane = groove(surface="curved").solve(), groove().solve()
    more = curved.to_dict()["curved"]
    assert plane.to_dict()["curved"] is None
    assert more["vertical_n"] == pytest.approx(10e3, rel=1e-3)
    assert more["plane_peak_pressure_pa"] == pytest.approx(plane.contact["peak_pressure_pa"], rel=0.02)
    assert curved.contact["peak_pressure_pa"] > 1.02 * plane.contact["peak_pressure_pa"]


def test_what_is_not_solved_along_a_curve_is_refused() -> None:
    with pytest.raises(CaseError, match="exact alone"):
        groove(surface="curved", theory="fastsim", resolution=None).solve()
    with pytest.raises(CaseError, match="inner"):
        GapCase(
            gap=Gap.groove(2.0, 1.0, rolling=1.0),
            upper=BODY,
            lower=BODY,
            friction=0.3,
            normal_force=1.0,
            longitudinal=0.0,
        )
