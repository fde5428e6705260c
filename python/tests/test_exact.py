"""What only the full theory can be asked."""

from __future__ import annotations

import pickle

import creepage
import numpy as np
import pytest

EXACT = creepage.exact(1.3, 0.28, resolution="fast")


def test_a_finer_force_lies_within_the_error_bar() -> None:
    creepage_ = np.random.default_rng(1967).uniform(-1.5, 1.5, (3, 60))
    coarse = EXACT.force(*creepage_)
    fine = creepage.exact(1.3, 0.28, resolution="standard").force(*creepage_)
    for off, bar in (
        (coarse.fx - fine.fx, coarse.fx_error + fine.fx_error),
        (coarse.fy - fine.fy, coarse.fy_error + fine.fy_error),
        (coarse.mz - fine.mz, coarse.mz_error + fine.mz_error),
    ):
        # The bar is made to hold in 95 % of cases; 60 of them may have a few more outside.
        assert (np.abs(off) <= bar).mean() >= 0.9
        assert np.abs(off).max() < 0.015  # the coarse one's worst, as the library states


def test_resolution_by_numbers_is_that_by_name() -> None:
    named = EXACT.force(0.5, 0.1, 0.2)
    counted = creepage.exact(1.3, 0.28, resolution=(14, 12)).force(0.5, 0.1, 0.2)
    assert counted.fx == named.fx
    assert EXACT.elements[0] > EXACT.elements[1]


def test_automatic_reaches_its_accuracy() -> None:
    force = creepage.automatic(1.3, 0.28, accuracy=0.002).force([0.5, 2.0], 0.0, [0.0, 0.5])
    assert (force.fx_error <= 0.002).all()
    assert (force.fy_error <= 0.002).all()


def test_the_elements_carry_force_and_load() -> None:
    field = EXACT.element_field(0.5, 0.2, 0.3)
    along, across = EXACT.elements
    assert field.traction.shape == (along * across, 2)
    assert field.share.sum() == pytest.approx(1.0, abs=1e-12)
    force = EXACT.force(0.5, 0.2, 0.3)
    total = (field.traction / field.bound[:, None] * field.share[:, None]).sum(axis=0)
    # The finer grid's force, not extrapolated: 14 elements along err by (1/14)^2 times a factor of order
    # one.
    assert total[0] == pytest.approx(force.fx, abs=1 / 14**2)
    assert total[1] == pytest.approx(force.fy, abs=1 / 14**2)
    assert field.power.min() >= -1e-9  # friction takes energy
    assert field.adhesion.any() and not field.adhesion.all()
    # The quadrilaterals' area is that of the ellipse but for what their straight sides cut off.
    x, y = np.moveaxis(field.corners, 2, 0)
    area = np.abs((x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum()) / 2
    assert area == pytest.approx(np.pi * np.prod(field.semi_axes), rel=0.02)
    assert field.adhesion[(field.beyond < 0).all(axis=1)].all()
    assert not field.adhesion[(field.beyond > 0).all(axis=1)].any()


def test_find_inverts_the_force() -> None:
    force = EXACT.force(0.4, 0.2, 0.1)
    found = EXACT.find(fx=force.fx, fy=force.fy, chi=0.1)
    # To 1e-7 of mu N by the library's tolerance, over a slope of about one half.
    assert found.xi == pytest.approx(0.4, abs=1e-5)
    assert found.eta == pytest.approx(0.2, abs=1e-5)
    assert found.chi == 0.1
    assert found.steps > 0
    assert found.to_dict()["fx"] == pytest.approx(force.fx, abs=1e-7)


def test_find_refuses_what_cannot_be() -> None:
    with pytest.raises(creepage.NotReachable, match="not reachable") as caught:
        EXACT.find(fx=1.5, eta=0.0, chi=0.0)
    assert len(caught.value.nearest) == len(caught.value.at) == 3
    copy = pickle.loads(pickle.dumps(caught.value))
    assert (str(copy), copy.at) == (str(caught.value), caught.value.at)
    with pytest.raises(TypeError, match="2 of the six"):
        EXACT.find(fx=0.5, eta=0.0)
    with pytest.raises(creepage.InvalidValue):
        EXACT.find(fx=float("nan"), eta=0.0, chi=0.0)
