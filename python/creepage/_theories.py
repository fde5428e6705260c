"""The theories by name."""

from __future__ import annotations

import difflib
import inspect
from collections.abc import Mapping
from typing import Any

from . import _creepage
from ._errors import InvalidOption, UnknownTheory

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


def resolved(
    make: type[Any], given: Mapping[str, Any], options: Mapping[str, Any]
) -> tuple[type[Any], dict[str, Any]]:
    """The class for options of a case and of a call, and all of them.

    The full theory that is as fine as an accuracy needs is a class of its own here.
    """
    together = {**given, **options}
    if make is not _creepage.Exact:
        return make, together
    if together.get("resolution") == "auto":
        return _creepage.Automatic, {
            "accuracy": 1e-3,
            **{name: value for name, value in together.items() if name != "resolution"},
        }
    if "accuracy" in given and "resolution" in options:
        del together["accuracy"]  # that of the resolution which the call replaces
    if "accuracy" in together:
        raise InvalidOption('accuracy: needs resolution = "auto"', "accuracy")
    return make, together


def options_of(name: str, given: Mapping[str, Any]) -> dict[str, Any]:
    """Those of the given options that the theory has."""
    known = inspect.signature(find(name)).parameters
    return {option: value for option, value in given.items() if option in known}
