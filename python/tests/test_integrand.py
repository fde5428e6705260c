"""Chapter 5 with an integrand of one's own (5.22)."""

from __future__ import annotations

import pickle

import creepage
import numpy as np
import pytest

CREEPAGES = ([0.5, 0.9, 0.0], [0.2, -0.4, 0.0], [0.1, 0.7, 1.2])


def product(x: float, y: float, a: float, b: float, t: float, s: float) -> tuple[float, ...]:
    """That of the thesis."""
    return t * s, s, t, 0.0, 1.0, 0.0


def test_the_product_is_the_thesis() -> None:
    thesis = creepage.Variational(1.0, 0.28).force(*CREEPAGES)
    own = creepage.Variational(1.0, 0.28, integrand=product).force(*CREEPAGES)
    # The same minimum, whose iteration ends within 1e-6 of it.
    assert own.fx == pytest.approx(thesis.fx, abs=1e-5)
    assert own.fy == pytest.approx(thesis.fy, abs=1e-5)


def test_another_integrand_is_another_minimum() -> None:
    def damped(x: float, y: float, a: float, b: float, t: float, s: float) -> tuple[float, ...]:
        rest = 1.0 + s
        return (
            t * s / rest,
            s / rest,
            t / rest**2,
            0.0,
            1.0 / rest**2,
            -2.0 * t / rest**3,
        )

    force = creepage.Variational(1.0, 0.28, integrand=damped).force(0.5, 0.2, 0.1)
    thesis = creepage.Variational(1.0, 0.28).force(0.5, 0.2, 0.1)
    assert force.converged is True
    # Another approximation of the same problem: as near as chapter 5 is to the full theory.
    assert 1e-5 < np.hypot(force.fx - thesis.fx, force.fy - thesis.fy) < 0.05


def test_a_wrong_derivative_is_refused() -> None:
    with pytest.raises(creepage.InvalidOption) as caught:
        creepage.Variational(1.0, 0.28, integrand=lambda x, y, a, b, t, s: (t * s, t, t, 0, 1, 0))
    assert caught.value.option == "integrand"


def test_what_the_function_raises_is_raised() -> None:
    def fails(x: float, y: float, a: float, b: float, t: float, s: float) -> tuple[float, ...]:
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        creepage.Variational(1.0, 0.28, integrand=fails)


def test_it_may_fail_later() -> None:
    calls = 0

    def fails(x: float, y: float, a: float, b: float, t: float, s: float) -> tuple[float, ...]:
        nonlocal calls
        calls += 1
        if calls > 2000:
            raise RuntimeError("late")
        return product(x, y, a, b, t, s)

    theory = creepage.Variational(1.0, 0.28, integrand=fails)
    for ask in (lambda: theory.force(0.5), lambda: theory.force([0.5, 0.9])):
        with pytest.raises(RuntimeError, match="late"):
            ask()
            ask()


def test_it_goes_through_pickle() -> None:
    theory = creepage.Variational(1.0, 0.28, integrand=product)
    again = pickle.loads(pickle.dumps(theory))
    assert again.force(0.5).fx == theory.force(0.5).fx
    assert "integrand=" in repr(theory)


def test_the_weight_multiplies_an_integrand_of_one_s_own() -> None:
    def weighed(x: float, y: float, a: float, b: float, t: float, s: float) -> tuple[float, ...]:
        w = 1.0 - (x / a) ** 2 - (y / b) ** 2
        return w * t * s, w * s, w * t, 0.0, w, 0.0

    thesis = creepage.Variational(1.0, 0.28).force(0.5, 0.2, 0.1)
    own = creepage.Variational(1.0, 0.28, integrand=weighed, weight="uniform")
    assert own.force(0.5, 0.2, 0.1).fx == pytest.approx(thesis.fx, abs=1e-5)
    twice = creepage.Variational(1.0, 0.28, integrand=weighed).force(0.5, 0.2, 0.1)
    assert abs(twice.fx - thesis.fx) > 1e-4
