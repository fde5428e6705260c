"""Cases of unlike bodies: warnings, coupling, heat."""

from __future__ import annotations

import math
import pickle
from collections.abc import Callable
from typing import Any

import creepage
import numpy as np
import pytest
from conftest import LOAD, RAIL, ROOT, wheel
from creepage import Body, Case


def unlike(**more: Any) -> Case:
    """An upper body as soft as aluminium: kappa/mu = -0.37."""
    soft = Body(shear_modulus=27e9, poisson=0.28, radius_rolling=0.46)
    return Case(upper=soft, lower=RAIL, **LOAD, longitudinal=-1e-3, resolution="fast", **more)


def test_the_full_theory_counts_unlike_bodies() -> None:
    case = unlike()
    kappa_over_mu = case.contact.kappa / case.friction
    theory = case.theory()
    assert f"kappa_over_mu={kappa_over_mu}" in repr(theory)
    like = creepage.exact(case.contact.a_over_b, case.contact.poisson, resolution="fast")
    at = case.dimensionless
    solution = case.solve()
    assert solution.caution is None
    assert solution.details["kappa_over_mu"] == pytest.approx(kappa_over_mu, rel=1e-12)
    assert solution.dimensionless.fx == theory.force(*at).fx
    # Both ways of the pressure's slip, and none.
    shape = (case.contact.a_over_b, case.contact.poisson)
    other = creepage.exact(*shape, resolution="fast", kappa_over_mu=-kappa_over_mu)
    assert abs(theory.force(*at).fx - like.force(*at).fx) > 0.05
    assert abs(other.force(*at).fx - theory.force(*at).fx) > 0.1
    # What the solution is asked for beyond its force is of the same bodies.
    field = solution.field(points=4)
    np.testing.assert_array_equal(field.traction, theory.field(*at, points=4).traction)
    assert (field.traction != like.field(*at, points=4).traction).any()
    curve = case.curve("longitudinal", [case.creepage.longitudinal])
    # Creepage goes to SI and back: rounding.
    assert curve.forces["exact"][:, 0] == pytest.approx(list(solution.force), rel=1e-9, abs=1e-6)
    assert pickle.loads(pickle.dumps(theory)).force(*at).fx == theory.force(*at).fx
    auto = case.solve(resolution="auto", accuracy=0.05)
    assert auto.details["kappa_over_mu"] == solution.details["kappa_over_mu"]
    for value in (math.nan, math.inf, 1e9):
        with pytest.raises(creepage.InvalidValue, match="kappa_over_mu"):
            creepage.exact(1.0, 0.28, kappa_over_mu=value)
        with pytest.raises(creepage.InvalidValue, match="kappa_over_mu"):
            creepage.automatic(1.0, 0.28, kappa_over_mu=value)


def test_other_theories_warn_between_unlike_bodies() -> None:
    case = unlike()
    words = r"fastsim takes the bodies for like ones \(kappa/mu = -0\.370\)"
    for ask in (
        lambda: case.theory("fastsim"),
        lambda: case.curve(theories=["fastsim"]),
        lambda: case.solve("fastsim"),
    ):
        with pytest.warns(creepage.UnlikeBodiesWarning, match=words) as caught:
            ask()
        assert [warning.filename for warning in caught] == [__file__]
    with pytest.warns(creepage.UnlikeBodiesWarning):
        solution = case.solve("fastsim")
    assert solution.caution is not None and solution.caution.startswith("fastsim takes")
    assert solution.to_dict()["caution"] == solution.caution
    assert "CAUTION" in solution.text()
    assert wheel(longitudinal=-1e-3).solve("fastsim").caution is None


def test_coupled_bodies() -> None:
    text = (ROOT / "examples" / "steel-on-polymer-coupled.toml").read_text()
    start, end = text.index("[wanted]"), text.index("[solve]")
    text = text[:start] + "longitudinal = 1e-3\n" + text[end:]
    case = Case.from_toml(text)
    coupled, one_way = case.solve(), case.solve(coupled=False)
    # What coupling moves is told where error bars are smaller.
    told = case.solve(coupled=False, resolution="standard").caution
    assert coupled.details["peak_over_hertz"] > 1.05 and "peak_over_hertz" not in one_way.details
    assert coupled.caution is None and "coupled = true" in str(told)
    curve = case.curve("longitudinal", [0.0, case.creepage.longitudinal])
    # Creepage goes to SI and back: rounding; about half a newton of 195 N is what coupling moves.
    assert curve.forces["exact"][:, 1] == pytest.approx(list(coupled.force), rel=1e-6, abs=1e-6)
    assert abs(coupled.force.longitudinal - one_way.force.longitudinal) > 0.5
    with pytest.raises(creepage.InvalidValue):
        case.curve("longitudinal", [0.0, math.nan])
    unlike_bodies = {"kappa_over_mu": 0.5, "coupled": True}
    asks: tuple[Callable[[], object], ...] = (
        case.theory,
        lambda: creepage.theory("exact", 1.0, 0.3, **unlike_bodies),
    )
    for ask in asks:
        with pytest.raises(creepage.InvalidOption, match="`coupled` needs a case") as caught:
            ask()
        assert caught.value.option == "coupled"


def test_heat_by_force_and_by_slip() -> None:
    case = wheel(longitudinal=-1.5e-3, spin=0.1, speed=20.0)
    solution = case.solve(resolution="fast")
    report = solution.to_dict()
    assert solution.speed == report["rolling_velocity_m_per_s"] == 20.0
    assert solution.power == report["frictional_power_w"]
    assert solution.power == pytest.approx(20.0 * solution.heat_per_metre, rel=1e-12)
    by_slip = solution.heat_per_metre_by_slip
    assert by_slip == report["frictional_power_per_metre_by_slip_j_per_m"]
    # Documented: within 0.2 % of each other.
    assert by_slip == pytest.approx(solution.heat_per_metre, rel=2e-3)
    plain = wheel(longitudinal=-1.5e-3).solve("linear")
    assert plain.speed is None and plain.power is None
    assert plain.known is None and plain.heat_per_metre_by_slip is None


def test_chapter_5_counts_unlike_bodies_as_a_case_does() -> None:
    case = Case(
        upper=Body(shear_modulus=27e9, poisson=0.28, radius_rolling=0.46),
        lower=RAIL,
        **LOAD,
        longitudinal=-1e-3,
        theory="variational",
    )
    kappa_over_mu = case.contact.kappa / case.friction
    shape = (case.contact.a_over_b, case.contact.poisson)
    own = creepage.Variational(*shape, kappa_over_mu=kappa_over_mu).force(*case.dimensionless)
    assert own.fx == pytest.approx(case.solve().dimensionless.fx, rel=1e-12)
    like = creepage.Variational(*shape).force(*case.dimensionless)
    assert abs(own.fx - like.fx) > 0.02
    # So does the theory that a case prepares.
    prepared = case.theory("variational").force(*case.dimensionless)
    assert prepared.fx == pytest.approx(own.fx, rel=1e-12)
