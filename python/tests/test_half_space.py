"""The load-displacement equations, both ways."""

import numpy as np
import pytest

import creepage


def half(a: float = 1.0, b: float = 1.0, poisson: float = 0.28, **more: float) -> creepage.HalfSpace:
    return creepage.HalfSpace(
        semi_axis_rolling=a, semi_axis_lateral=b, poisson=poisson, degree=6, **more
    )


def test_hertz_s_pressure_makes_a_paraboloid() -> None:
    _, _, w = half().displacement(z=[0.1])
    approach = 0.72 * 0.1 * np.pi / 2  # (1 - sigma) G f00 pi/2, closed form of the circle
    np.testing.assert_allclose(w, [approach, 0, 0, -approach / 2, 0, -approach / 2], atol=1e-15)


def test_the_shear_modulus_is_a_unit() -> None:
    plain = half(6e-3, 4e-3).displacement(x=[0.1, 2.0, 3.0])
    steel = half(6e-3, 4e-3, shear_modulus=82e9).displacement(x=[0.1 * 82e9, 2.0 * 82e9, 3.0 * 82e9])
    for one, two in zip(plain, steel, strict=True):
        np.testing.assert_allclose(one, two, rtol=1e-13, atol=1e-18)


def test_the_inverse_takes_back_what_was_caused() -> None:
    space = half(2.0, 1.0, 0.3)
    given = np.array([0.2, -0.1, 0.3, 0.05, 0.02, -0.07])
    for edge in ("singular", "vanishing"):
        u, v, w = space.displacement(x=given, y=given[::-1].copy(), z=given, edge=edge)
        x, y, z = space.traction(u=u, v=v, w=w, edge=edge)
        # Rounding of blocks of a condition of some ten.
        np.testing.assert_allclose(x[:6], given, atol=1e-12)
        np.testing.assert_allclose(y[:6], given[::-1], atol=1e-12)
        np.testing.assert_allclose(z[:6], given, atol=1e-12)
        assert np.abs(x[6:]).max(initial=0.0) < 1e-12


def test_a_shift_of_the_circle() -> None:
    # Mindlin's twist and shift: F_x = 2 G a u / (1 - sigma/2), closed form of the circle.
    space = half(poisson=0.25)
    x, y, z = space.traction(u=[1.0])
    fx, fy, n, mz = space.resultants(x=x, y=y, z=z, edge="singular")
    assert (fx, fy, n, mz) == pytest.approx((2 / 0.875, 0, 0, 0), abs=1e-13)


def test_displacements_at_points_are_the_polynomials_inside() -> None:
    space = half(1.5, 1.0)
    u, _, _ = space.displacement(x=[0.1, 0.02, 0.03])
    px, py = np.array([0.0, 0.4, -0.9]), np.array([0.2, -0.3, 0.5])
    terms = np.stack([px**0, px, py, px**2, px * py, py**2, px**3, px**2 * py, px * py**2, py**3])
    found = space.displacement_at(px, py, x=[0.1, 0.02, 0.03])
    np.testing.assert_allclose(found[:, 0], u @ terms[: len(u)], rtol=1e-11)
    assert found.shape == (3, 3)
    # Unlike bodies: the pressure alone moves the surfaces along each other.
    assert abs(space.displacement_at(0.5, 0.0, z=[0.1], kappa=0.2)[0]) > 1e-4
    assert space.traction_at(0.0, 0.0, z=[0.1])[2] == pytest.approx(0.1)


def test_what_is_none_is_refused() -> None:
    space = half()
    with pytest.raises(ValueError, match="no traction that vanishes"):
        space.traction(u=[1.0], edge="vanishing")
    with pytest.raises(ValueError, match="complete degree"):
        space.displacement(x=[1.0, 2.0])
    with pytest.raises(ValueError, match="prepared up to"):
        space.displacement(x=[1.0] * 28)
    with pytest.raises(ValueError, match="must be"):
        space.displacement(x=[1.0], edge="sharp")  # type: ignore[arg-type]
    with pytest.raises(creepage.InvalidValue):
        half(poisson=0.6)
    with pytest.raises(ValueError):
        space.displacement(x=[float("nan")])
