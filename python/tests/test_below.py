"""Stress and displacement inside the bodies."""

import creepage
import numpy as np
import pytest

STEEL = creepage.Body(shear_modulus=82e9, poisson=0.28, radius_rolling=0.46, radius_lateral="flat")
RAIL = creepage.Body(shear_modulus=82e9, poisson=0.28, radius_rolling="flat", radius_lateral=0.3)


def solved(theory: str = "saturated") -> creepage.Solution:
    case = creepage.Case(
        upper=STEEL, lower=RAIL, normal_force=80e3, friction=0.3, longitudinal=0.1, theory=theory
    )
    return case.solve()


def test_the_surfaces_approach_by_hertz() -> None:
    solution = solved()
    below = [solution.below(0.0, 0.0, 0.0, body) for body in ("lower", "upper")]
    approach = solution.contact.approach
    # Like bodies: each gives way by half; friction along x moves the middle of neither down.
    for one in below:
        assert one.displacement[2] == pytest.approx(0.5 * approach, rel=1e-9)
        assert one.stress[2] == pytest.approx(-solution.contact.peak_pressure, rel=1e-9)
    # The traction pushes the lower body along x, and its reaction the upper one back.
    assert below[0].displacement[0] > 0 and below[1].displacement[0] == pytest.approx(
        -below[0].displacement[0], rel=1e-12
    )


def test_points_broadcast_and_far_away_nothing_moves() -> None:
    below = solved("fastsim").below(np.linspace(-0.01, 0.01, 5), 0.0, [[1e-3], [1e3]])
    assert below.stress.shape == (2, 5, 6) and below.displacement.shape == (2, 5, 3)
    assert np.abs(below.displacement[1]).max() < 1e-4 * np.abs(below.displacement[0]).max()
    assert below.settled_depth > 0


def test_what_is_no_point_is_refused() -> None:
    with pytest.raises(creepage.InvalidValue):
        solved().below(0.0, 0.0, -1e-3)
    with pytest.raises(ValueError, match="must be"):
        solved().below(0.0, 0.0, 1e-3, "middle")  # type: ignore[arg-type]
