"""Creepage coefficients, Carter's theory, Hertz."""

from __future__ import annotations

import math

import creepage
import numpy as np
import pytest


def test_coefficients_of_a_circle() -> None:
    found = creepage.coefficients(1.0, 0.0)
    # Closed forms for sigma = 0 (4.3), to the accuracy that the library states.
    assert found.c11 == pytest.approx(32.0 / (3.0 * math.pi), rel=1e-6)
    assert found.c22 == pytest.approx(found.c11, rel=1e-6)
    assert found.c23 == pytest.approx(4.0 / 3.0, rel=1e-6)
    assert found.c33 == pytest.approx(512.0 / (135.0 * math.pi), rel=1e-6)
    assert type(found.c11) is float


def test_coefficients_as_the_thesis_approximates_them() -> None:
    converged = creepage.coefficients(1.0, 0.25)
    thesis = creepage.coefficients(1.0, 0.25, degree=5)
    high = creepage.coefficients(1.0, 0.25, degree=40)
    assert thesis.c11 != converged.c11
    # The thesis gives three digits.
    assert thesis.c11 == pytest.approx(converged.c11, rel=5e-3)
    for name, value in converged.to_dict().items():
        off, farther = (abs(of.to_dict()[name] - value) for of in (high, thesis))
        assert off < farther
    assert creepage.coefficients([0.5, 1.0], 0.25, degree=5).c11[1] == thesis.c11
    with pytest.raises(creepage.InvalidValue, match="between 2 and 100"):
        creepage.coefficients(1.0, 0.25, degree=1)


def test_coefficients_broadcast() -> None:
    found = creepage.coefficients(np.array([[0.5], [1.0]]), [0.0, 0.25, 0.5])
    assert found.c11.shape == (2, 3)
    one = creepage.coefficients(0.5, 0.25)
    assert found.to_dict()["c33"][0, 1] == one.c33
    with pytest.raises(creepage.InvalidValue) as caught:
        creepage.coefficients([1.0, 1e9], 0.28)
    assert (caught.value.quantity, caught.value.index) == ("a_over_b", (1,))


def test_carter() -> None:
    half = creepage.carter(2.0)
    assert (half.force, half.trailing_edge) == (0.75, 0.0)
    many = creepage.carter(np.linspace(-6.0, 6.0, 241))
    assert many.force.max() == 1.0
    slope = np.gradient(many.force, many.creepage)
    # Second differences of a parabola: exact, but at the three kinks and the ends.
    kinks = np.isin(np.round(many.creepage, 2), [-4.0, 0.0, 4.0])
    kinks[[0, -1]] = True
    np.testing.assert_allclose(slope[~kinks], many.derivative[~kinks], atol=1e-12)


def test_carters_field_carries_its_force() -> None:
    count = 20_000
    x = (2.0 * np.arange(count) + 1.0) / count - 1.0
    for value in (0.5, 2.0, 5.0):
        found = creepage.carter(value)
        traction, slip, region = found.field(x)
        total = traction.sum() * (2.0 / count) / (math.pi / 2)
        # Force over mu N with N = pi/2 a p0; midpoints err by some h^1.5 at the square roots.
        assert total == pytest.approx(found.force, abs=1e-4)
        assert (slip[region == creepage.Region.ADHESION] == 0.0).all()
        assert found.field(1.5)[2] == creepage.Region.OUTSIDE


def test_hertz_of_two_cylinders_crossed_is_a_circle() -> None:
    wheel = creepage.Body(poisson=0.28, shear_modulus=82e9, radius_rolling=0.3)
    rail = creepage.Body(poisson=0.28, shear_modulus=82e9, radius_lateral=0.3)
    contact = creepage.hertz(wheel, rail, 80e3)
    assert contact.a_over_b == pytest.approx(1.0, abs=1e-9)
    # A ball of radius R on a plane: a^3 = 3 N R (1 - sigma) / (4 G) for like bodies.
    radius = (3.0 * 80e3 * 0.3 * (1.0 - 0.28) / (4.0 * 82e9)) ** (1.0 / 3.0)
    assert contact.semi_axis_rolling == pytest.approx(radius, rel=1e-9)
    peak = 1.5 * 80e3 / (math.pi * radius**2)
    assert contact.peak_pressure == pytest.approx(peak, rel=1e-9)
    assert contact.to_dict()["rho"] == contact.rho


def test_hertz_refuses_bodies_without_an_ellipse() -> None:
    flat = creepage.Body(poisson=0.28, shear_modulus=82e9)
    with pytest.raises(creepage.CaseError, match="single point|line contact"):
        creepage.hertz(flat, flat, 80e3)
    with pytest.raises(creepage.CaseError) as caught:
        creepage.hertz(flat, flat, -1.0, semi_axis_rolling=1e-3, semi_axis_lateral=1e-3)
    assert (caught.value.section, caught.value.key) == ("contact", "normal_force")


def test_line_contact_gives_carter_its_scale() -> None:
    young = creepage.Body(poisson=0.28, young_modulus=82e9 * 2.56, radius_rolling=0.5)
    shear = creepage.Body(poisson=0.28, shear_modulus=82e9, radius_rolling=0.5)
    contact = creepage.line_contact(young, shear, 1e6)
    assert contact.rho == pytest.approx(1.0)  # the diameter
    assert contact.peak_pressure == pytest.approx(2e6 / (math.pi * contact.half_width))
    assert contact.to_dict()["half_width"] == contact.half_width
    found = contact.carter(1e-3, 0.3)
    assert found.creepage == pytest.approx(1e-3 / (0.3 * contact.half_width))
    with pytest.raises(ValueError, match="friction"):
        contact.carter(1e-3, 0.0)
    with pytest.raises(creepage.InvalidValue):
        creepage.line_contact(young, shear, math.nan)
    with pytest.raises(ValueError, match="either"):
        creepage.line_contact(creepage.Body(poisson=0.3), shear, 1e6)
