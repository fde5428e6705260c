"""The theories by name."""

from __future__ import annotations

import difflib
import json
from collections.abc import Mapping
from typing import Any, Literal, overload

from . import _creepage
from ._errors import UnknownTheory

THEORIES: dict[str, type[_creepage.Theory]] = {
    "exact": _creepage.Exact,
    "variational": _creepage.Variational,
    "fastrip": _creepage.Fastrip,
    "fastsim": _creepage.Fastsim,
    "strip": _creepage.Strip,
    "polach": _creepage.Polach,
    "shen-hedrick-elkins": _creepage.ShenHedrickElkins,
    "vermeulen-johnson": _creepage.VermeulenJohnson,
    "linear": _creepage.Linear,
    "saturated": _creepage.Saturated,
    "automatic": _creepage.Automatic,
}
"""The classes by the names of case files, the general ones first."""


@overload
def theory(
    name: Literal["exact"], a_over_b: float, poisson: float, **options: Any
) -> _creepage.Exact: ...
@overload
def theory(
    name: Literal["automatic"], a_over_b: float, poisson: float, **options: Any
) -> _creepage.Automatic: ...
@overload
def theory(
    name: Literal["variational"], a_over_b: float, poisson: float, **options: Any
) -> _creepage.Variational: ...
@overload
def theory(
    name: Literal["fastsim"], a_over_b: float, poisson: float, **options: Any
) -> _creepage.Fastsim: ...
@overload
def theory(
    name: Literal["fastrip"], a_over_b: float, poisson: float, **options: Any
) -> _creepage.Fastrip: ...
@overload
def theory(
    name: Literal[
        "strip", "polach", "shen-hedrick-elkins", "vermeulen-johnson", "linear", "saturated"
    ],
    a_over_b: float,
    poisson: float,
    **options: Any,
) -> _creepage.DifferentiableTheory: ...
@overload
def theory(name: str, a_over_b: float, poisson: float, **options: Any) -> _creepage.Theory: ...
def theory(name: str, a_over_b: float, poisson: float, **options: Any) -> _creepage.Theory:
    """The theory of that name, prepared: `theory("fastsim", 1.5, 0.28, grid=(10, 10))`.

    a_over_b: ratio of the semi-axes, along over across the rolling direction. poisson: combined
    Poisson's ratio. Underscores do for hyphens. Raises UnknownTheory, TypeError for an option
    that the theory does not have, and what its class raises.
    """
    prepared: _creepage.Theory = find(name)(a_over_b=a_over_b, poisson=poisson, **options)
    return prepared


def find(name: str) -> type[Any]:
    """The class of that name."""
    known = THEORIES.get(name.replace("_", "-"))
    if known is None:
        near = difflib.get_close_matches(name, THEORIES, n=1)
        hint = f"did you mean {near[0]!r}?" if near else f"known are {', '.join(THEORIES)}"
        raise UnknownTheory(f"unknown theory {name!r}: {hint}", name)
    return known


def chosen(
    data: _creepage.CaseData, name: str | None, options: Mapping[str, Any]
) -> tuple[str, dict[str, Any]]:
    """The theory of a case and its options: the case's own theory with the options of the case, any
    other with its usual ones; those of a call go before both.
    """
    given = json.loads(data.theory())
    own = given.pop("theory")
    if name is not None and find(name) is not find(own):
        return name, dict(options)
    if "resolution" in options:
        given.pop("accuracy", None)  # that of the resolution which the call replaces
    return own, {**given, **options}


def prepared(
    data: _creepage.CaseData, name: str, options: Mapping[str, Any]
) -> _creepage.Theory:
    """The theory of that name for the contact of a case."""
    make, together = find(name), dict(options)
    if make is _creepage.Exact and together.get("resolution") == "auto":
        make = _creepage.Automatic
        del together["resolution"]
    unlike = (_creepage.Exact, _creepage.Automatic, _creepage.Variational)
    if make in unlike and data.kappa_over_mu != 0.0:
        together = {"kappa_over_mu": data.kappa_over_mu, **together}
    theory: _creepage.Theory = make(a_over_b=data.a_over_b, poisson=data.poisson, **together)
    return theory
