"""Every theory, with floats and with arrays."""

from __future__ import annotations

import pickle

import creepage
import numpy as np
import pytest
from creepage import Status
from hypothesis import given, settings
from hypothesis import strategies as st


def test_an_array_is_its_floats(theory: creepage.Theory) -> None:
    xi = np.array([[0.3], [-0.8], [2.0]])
    eta = np.array([0.1, -0.5])
    force = theory.force(xi, eta, 0.2)
    assert force.fx.shape == force.status.shape == (3, 2)
    for i in range(3):
        for k in range(2):
            one = theory.force(float(xi[i, 0]), float(eta[k]), 0.2)
            # The same code on the same numbers, whatever thread runs it: bit for bit.
            assert one.fx == force.fx[i, k]
            assert one.fy == force.fy[i, k]
            assert one.mz == force.mz[i, k]
            assert one.status == force.status[i, k]


def test_floats_in_floats_out(theory: creepage.Theory) -> None:
    force = theory.force(0.5, 0.2, 0.1)
    assert isinstance(force.fx, float) and isinstance(force.magnitude, float)
    assert isinstance(force.status, Status)
    assert force.converged is True
    assert force.magnitude == pytest.approx(np.hypot(force.fx, force.fy), rel=1e-15)
    nothing = theory.force()
    assert (nothing.fx, nothing.fy, nothing.mz) == (0.0, 0.0, 0.0)


def test_zero_dimensions_count_as_floats(theory: creepage.Theory) -> None:
    force = theory.force(np.float32(0.5), np.array(0.25), np.int64(0))
    assert isinstance(force.fx, float)
    assert force.fx == theory.force(0.5, 0.25, 0).fx


def test_reversed_creepage_reverses_the_force(theory: creepage.Theory) -> None:
    creepage_ = np.array([[0.4, -0.3, 0.5], [1.5, 0.2, -0.1]])
    one, other = theory.force(*creepage_.T), theory.force(*-creepage_.T)
    for part in ("fx", "fy", "mz"):
        # (4.28); rounding of sums over some thousand cells.
        np.testing.assert_allclose(getattr(one, part), -getattr(other, part), atol=1e-10)


def test_to_dict_has_numbers_and_words(theory: creepage.Theory) -> None:
    one = theory.force(0.5, 0.0, 0.0).to_dict()
    assert one["status"] == "solved"
    many = theory.force([0.5, 0.6]).to_dict()
    assert list(many["status"]) == ["solved", "solved"]
    assert many["fx"][0] == one["fx"]
    assert ("fx_error" in one) == (theory.name in ("exact", "automatic"))


def test_derivative_is_that_of_the_force(theory: creepage.Theory) -> None:
    if not isinstance(theory, creepage.DifferentiableTheory):
        assert theory.name in ("variational", "automatic")
        return
    at = np.array([0.31, 0.17, 0.11])
    # Central differences: the step's square, against rounding and kinks of the cells.
    step, tolerance = (1e-3, 2e-2) if theory.name in ("exact", "fastrip") else (1e-5, 2e-3)
    columns = []
    for direction in np.eye(3):
        up = theory.force(*(at + step * direction).tolist())
        down = theory.force(*(at - step * direction).tolist())
        pairs = ((up.fx, down.fx), (up.fy, down.fy), (up.mz, down.mz))
        columns.append([(u - d) / (2 * step) for u, d in pairs])
    found = theory.derivative(*at)
    assert found.shape == (3, 3)
    np.testing.assert_allclose(found, np.array(columns).T, atol=tolerance)
    many = theory.derivative(at[0], np.array([at[1], 0.5]), at[2])
    assert many.shape == (2, 3, 3)
    np.testing.assert_array_equal(many[0], found)


def test_field_carries_the_force(theory: creepage.Theory) -> None:
    points = 80
    force = theory.force(0.8, -0.2, 0.3)
    field = theory.field(0.8, -0.2, 0.3, points=points)
    assert field.position.shape == field.traction.shape == (points, points, 2)
    a, b = theory.semi_axes
    assert a * b == pytest.approx(1.0)
    assert a / b == pytest.approx(1.3)
    # Traction over mu p0; N = 2/3 pi a b p0.
    cell = 4.0 / points**2
    total = field.traction.sum(axis=(0, 1)) * cell / (2.0 / 3.0 * np.pi)
    # A sum over cells cut by the edge, where the linear theory's traction has no bound: h^0.5.
    np.testing.assert_allclose(total, [force.fx, force.fy], atol=0.05)
    inside = np.hypot(field.position[..., 0] / a, field.position[..., 1] / b) < 1.0
    np.testing.assert_array_equal(field.inside, inside)
    assert not field.traction[~inside].any()
    assert not (field.adhesion & ~inside).any()


def test_field_at_positions(theory: creepage.Theory) -> None:
    field = theory.field(0.8, x=[0.0, 0.3, 9.0], y=0.1)
    assert field.position.tolist() == [[0.0, 0.1], [0.3, 0.1], [9.0, 0.1]]
    assert field.region[2] == creepage.Region.OUTSIDE
    assert theory.field(0.8, x=0.1, y=0.1).traction.shape == (2,)
    columns = field.to_dict()
    assert columns["region"][2] == "outside"
    assert columns["traction_x"].shape == (3,)


def test_pickle_makes_the_same_theory(theory: creepage.Theory) -> None:
    copy = pickle.loads(pickle.dumps(theory))
    assert type(copy) is type(theory)
    assert repr(copy) == repr(theory)
    assert copy.force(0.7, 0.1, 0.2).fx == theory.force(0.7, 0.1, 0.2).fx


def test_repr_is_the_call() -> None:
    theory = creepage.fastsim(1.0, 0.25, grid=(10, 12), flexibility="three")
    words = "creepage.fastsim(a_over_b=1.0, poisson=0.25, grid=(10, 12), flexibility='three')"
    assert repr(theory) == words
    again = eval(words, {"creepage": creepage})
    assert again.force(0.5).fx == theory.force(0.5).fx


def test_theories_by_name() -> None:
    assert creepage.theory("shen_hedrick_elkins", 1.0, 0.28).name == "shen-hedrick-elkins"
    with pytest.raises(creepage.UnknownTheory, match="did you mean 'fastsim'") as caught:
        creepage.theory("fastsin", 1.0, 0.28)
    assert caught.value.name == "fastsin"
    with pytest.raises(TypeError, match="degree"):
        creepage.theory("fastsim", 1.0, 0.28, degree=3)
    with pytest.raises(TypeError):
        creepage.Theory()


@pytest.mark.parametrize("name", list(creepage.THEORIES))
@pytest.mark.parametrize(
    "arguments", [(np.nan, 0.28), (0.0, 0.28), (-1.0, 0.28), (np.inf, 0.28), (1e99, 0.28)]
)
def test_senseless_shapes_are_refused(name: str, arguments: tuple[float, float]) -> None:
    with pytest.raises(creepage.InvalidValue, match="a_over_b") as caught:
        creepage.theory(name, *arguments)
    assert caught.value.quantity == "a_over_b"
    assert caught.value.index is None
    assert isinstance(caught.value, ValueError)


@pytest.mark.parametrize("name", [name for name in creepage.THEORIES if name != "saturated"])
@pytest.mark.parametrize("poisson", [np.nan, -0.1, 0.6, -np.inf])
def test_senseless_materials_are_refused(name: str, poisson: float) -> None:
    with pytest.raises(creepage.InvalidValue, match="poisson"):
        creepage.theory(name, 1.0, poisson)


@pytest.mark.parametrize(
    ("name", "options", "kind"),
    [
        ("exact", {"resolution": "finest"}, creepage.InvalidOption),
        ("exact", {"resolution": (2, 2)}, creepage.InvalidValue),
        ("exact", {"resolution": 3.5}, TypeError),
        ("automatic", {"accuracy": 0.0}, creepage.InvalidValue),
        ("fastsim", {"bound": "round"}, creepage.InvalidOption),
        ("fastsim", {"bound": "kept"}, creepage.InvalidOption),
        ("fastsim", {"reduction": (0.0, 1.0, 0.0)}, creepage.InvalidValue),
        ("fastsim", {"bound": 3}, TypeError),
        ("fastsim", {"grid": (0, 5)}, creepage.InvalidValue),
        ("fastsim", {"grid": (10**9, 5)}, creepage.InvalidValue),
        ("fastsim", {"grid": (-1, 5)}, TypeError),
        ("fastsim", {"grid": (1, 2, 3)}, TypeError),
        ("fastrip", {"variant": ""}, creepage.InvalidOption),
        ("polach", {"reduction": (0.5, 0.7)}, creepage.InvalidValue),
        ("variational", {"degree": 13}, creepage.InvalidOption),
        ("variational", {"degree": -1}, OverflowError),
        ("variational", {"mesh": (1, 1)}, creepage.InvalidOption),
        ("variational", {"weight": "heavy"}, creepage.InvalidOption),
        ("variational", {"bound": "loose"}, creepage.InvalidOption),
        ("variational", {"bound": "elliptic"}, creepage.InvalidOption),
    ],
)
def test_senseless_options_are_refused(
    name: str, options: dict[str, object], kind: type[Exception]
) -> None:
    with pytest.raises(kind):
        creepage.theory(name, 1.0, 0.28, **options)


def test_the_bound_of_the_numerical_theory() -> None:
    at = (0.5, 0.1, 0.3)
    force = {
        (ratio, bound): creepage.variational(ratio, 0.28, bound=bound).force(*at).fx
        for ratio in (1.0, 4.0)
        for bound in (None, "automatic", "unchecked", "kept")
    }
    for ratio, same, other in ((1.0, "unchecked", "kept"), (4.0, "kept", "unchecked")):
        assert force[ratio, None] == force[ratio, "automatic"] == force[ratio, same]
        assert force[ratio, None] != force[ratio, other]
    assert "bound='kept'" in repr(creepage.variational(1.0, 0.28, bound="kept"))


def test_options_change_the_theory() -> None:
    one = creepage.fastsim(1.0, 0.28, grid=(8, 8)).force(0.5, 0.0, 0.5).fy
    assert one != creepage.fastsim(1.0, 0.28).force(0.5, 0.0, 0.5).fy
    clean, dirty = (creepage.polach(1.0, 0.28, reduction=r) for r in ((1.0, 1.0), (0.6, 0.3)))
    assert dirty.force(0.1).fx < clean.force(0.1).fx


@settings(max_examples=200, deadline=None, derandomize=True)
@given(st.tuples(*[st.floats(allow_nan=True, allow_infinity=True)] * 3))
def test_any_three_floats_give_a_force_or_an_exception(at: tuple[float, float, float]) -> None:
    for theory in (LINEAR, FASTSIM, POLACH, STRIP):
        if all(abs(part) <= 1e100 for part in at):
            force = theory.force(*at)
            assert np.isfinite([force.fx, force.fy, force.mz]).all()
        else:
            with pytest.raises(creepage.InvalidValue):
                theory.force(*at)
            with pytest.raises(creepage.InvalidValue):
                theory.force(np.array([at[0]]), at[1], at[2])


LINEAR = creepage.linear(1.3, 0.28)
FASTSIM = creepage.fastsim(1.3, 0.28, grid=(5, 5))
POLACH = creepage.polach(1.3, 0.28)
STRIP = creepage.strip(1.3, 0.28)


def test_a_name_is_a_type() -> None:
    """What a type checker knows of the class, a user need not ask."""
    exact = creepage.theory("exact", a_over_b=1.0, poisson=0.28)
    assert exact.force([0.1, 0.2]).fx_error.shape == (2,)
    polach = creepage.theory("polach", a_over_b=1.0, poisson=0.28)
    assert np.shape(polach.derivative(0.1, 0.0, 0.0)) == (3, 3)
