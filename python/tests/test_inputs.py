"""Arrays of every kind: the right answer or an exception, never a crash."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from typing import Any

import creepage
import numpy as np
import pandas as pd
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from numpy.typing import NDArray

LINEAR = creepage.linear(1.3, 0.28)
GAIN = LINEAR.derivative()


def check(xi: Any, plain: NDArray[np.float64]) -> None:
    """Linear theory: the force is the creepage times a constant."""
    force = LINEAR.force(xi, 0.0, 0.0)
    assert force.fx.shape == plain.shape
    # One multiplication more or less: rounding.
    np.testing.assert_allclose(force.fx, GAIN[0, 0] * plain, rtol=1e-13)


NUMBERS = np.linspace(-1.0, 1.0, 24)


def unaligned() -> NDArray[np.float64]:
    raw = np.zeros(24 * 8 + 1, np.uint8)
    array = raw[1:].view(np.float64)
    array[:] = NUMBERS
    assert not array.flags.aligned
    return array


def read_only() -> NDArray[np.float64]:
    array = NUMBERS.copy()
    array.flags.writeable = False
    return array


@pytest.mark.parametrize(
    "make",
    [
        lambda: NUMBERS.reshape(4, 6).T,
        lambda: np.asfortranarray(NUMBERS.reshape(4, 6)),
        lambda: NUMBERS[::-1],
        lambda: NUMBERS[3::5],
        lambda: NUMBERS.reshape(2, 3, 4)[:, ::2, 1:],
        lambda: np.broadcast_to(NUMBERS[:3], (5, 3)),
        lambda: NUMBERS.astype(">f8"),
        lambda: NUMBERS.astype(np.float32),
        lambda: NUMBERS.astype(np.float16),
        lambda: NUMBERS.astype(np.longdouble),
        lambda: np.arange(5),
        lambda: np.arange(5, dtype=np.uint8),
        lambda: np.array([True, False]),
        lambda: np.matrix([[0.1, 0.2]]),
        lambda: pd.Series(NUMBERS, index=range(100, 124)),
        lambda: pd.DataFrame(NUMBERS.reshape(8, 3)),
        lambda: np.ma.masked_array(NUMBERS),
        lambda: NUMBERS.tolist(),
        lambda: tuple(NUMBERS),
        lambda: np.array([]),
        lambda: np.zeros((3, 0, 2)),
        lambda: np.array([[[0.5]]]),
        unaligned,
        read_only,
    ],
)
@pytest.mark.filterwarnings("ignore:the matrix subclass")
def test_every_kind_of_array_is_read_in_its_order(make: Callable[[], Any]) -> None:
    array = make()
    check(array, np.asarray(array, dtype=np.float64))


@pytest.mark.parametrize(
    "wrong",
    [
        "0.5",
        ["0.5", "0.6"],
        None,
        [None, 0.5],
        1j,
        np.array([1.0 + 0j]),
        object(),
        np.array([0.5], dtype=object),
        np.datetime64("2026-01-01"),
        np.zeros(3, dtype=[("x", float)]),
        {"xi": 0.5},
        np.ma.masked_less([0.1, 0.2], 0.15),
        b"0.5",
        10**400,
        [10**400],
        lambda: 0.5,
    ],
    ids=lambda wrong: type(wrong).__name__,
)
def test_what_is_no_number_is_refused(wrong: Any) -> None:
    for theory in (LINEAR, creepage.exact(1.0, 0.28, resolution="fast")):
        with pytest.raises((TypeError, OverflowError)):
            theory.force(wrong, 0.0, 0.0)
        with pytest.raises((TypeError, OverflowError)):
            theory.force([0.1, 0.2], 0.0, wrong)
        with pytest.raises((TypeError, OverflowError)):
            theory.derivative(wrong)
        if wrong is not None:
            with pytest.raises((TypeError, OverflowError)):
                theory.field(0.1, x=wrong)


def test_ragged_lists_are_refused() -> None:
    with pytest.raises(ValueError, match="inhomogeneous"):
        LINEAR.force([[1.0], [1.0, 2.0]])


def test_shapes_that_do_not_fit_are_refused() -> None:
    with pytest.raises(ValueError, match="broadcast"):
        LINEAR.force(np.zeros(3), np.zeros(4))
    with pytest.raises(ValueError, match="broadcast"):
        LINEAR.force(np.zeros((2, 3)), np.zeros((3, 2)), np.zeros(1))


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e101])
def test_the_first_bad_element_is_named(bad: float) -> None:
    eta = np.zeros((300, 400))
    eta[200, 7] = eta[123, 45] = eta[250:, :] = bad
    with pytest.raises(creepage.InvalidValue) as caught:
        LINEAR.force(0.5, eta, 0.0)
    error = caught.value
    assert (error.quantity, error.index) == ("eta", (123, 45))
    assert error.value == bad or np.isnan(bad)
    assert str(error).startswith("eta = ")
    assert str(error).endswith("must be between -1e100 and 1e100, at index [123, 45]")
    copy = pickle.loads(pickle.dumps(error))
    assert (str(copy), copy.index, copy.valid) == (str(error), error.index, error.valid)


def test_nan_is_never_silent() -> None:
    with pytest.raises(creepage.InvalidValue):
        creepage.coefficients(np.nan, 0.28)
    with pytest.raises(creepage.InvalidValue):
        LINEAR.derivative([0.0, np.nan])
    with pytest.raises(creepage.InvalidValue, match=r"index \[1\]"):
        LINEAR.force(pd.Series([0.5, None], dtype="Float64"))
    with pytest.raises(ValueError, match="finite"):
        LINEAR.field(0.1, x=np.nan, y=0.0)
    with pytest.raises(creepage.InvalidValue):
        LINEAR.field(np.nan)


@pytest.mark.parametrize("points", [0, 10**6])
def test_absurd_meshes_are_refused(points: int) -> None:
    with pytest.raises(ValueError, match="points"):
        LINEAR.field(0.5, points=points)


@pytest.mark.parametrize("shape", [(10**13,), (10**6, 10**7)])
def test_more_than_memory_is_an_exception(shape: tuple[int, ...]) -> None:
    with pytest.raises(MemoryError):
        LINEAR.force(np.broadcast_to(np.zeros(1), shape))
    with pytest.raises(MemoryError):
        LINEAR.force(np.zeros((10**6, 1)), np.zeros((1, 10**7)))


def test_a_million_cases() -> None:
    xi = np.linspace(-1.0, 1.0, 1_000_000)
    check(xi, xi)


@settings(max_examples=150, deadline=None, derandomize=True)
@given(hnp.mutually_broadcastable_shapes(num_shapes=3, max_dims=4, max_side=4), st.data())
def test_broadcasting_is_numpys(shapes: hnp.BroadcastableShapes, data: st.DataObject) -> None:
    elements = st.floats(-5.0, 5.0)
    xi, eta, chi = (
        data.draw(hnp.arrays(np.float64, shape, elements=elements)) for shape in shapes.input_shapes
    )
    force = LINEAR.force(xi, eta, chi)
    full = np.stack(np.broadcast_arrays(xi, eta, chi), axis=-1)
    expected = full @ GAIN.T
    for k, part in enumerate((force.fx, force.fy, force.mz)):
        assert np.shape(part) == shapes.result_shape
        # Three products in another order.
        np.testing.assert_allclose(part, expected[..., k], atol=1e-13)
