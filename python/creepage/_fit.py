"""Friction fitted to measured forces."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _creepage
from ._contact import floats
from ._results import Comparable, Floats

COLUMNS = (
    "longitudinal",
    "lateral",
    "spin",
    "longitudinal_force",
    "lateral_force",
    "longitudinal_coefficient",
    "lateral_coefficient",
    "normal_force",
    "uncertainty",
)
"""The names of the columns of `creepage fit`."""


@dataclass(frozen=True, slots=True)
class Fitted:
    """A number found, and how uncertain it is."""

    value: float
    standard_error: float
    interval: tuple[float, float]
    """What it lies in with a probability of 95 %, if the points scatter normally about the theory."""


@dataclass(frozen=True, slots=True, eq=False)
class FrictionFit(Comparable):
    """Friction found from measured forces, and each point beside the theory."""

    theory: str
    friction: Fitted
    """The coefficient of friction."""
    slope: Fitted | None
    """The factor of the initial slope, where it was asked for."""
    correlation: float | None
    """Correlation of both."""
    scatter: float
    """Root mean square distance of the points that count, over the normal force."""
    reached: float
    """Largest force over mu N among the points that count."""
    cautions: tuple[str, ...]
    """Cautions about it: points left out, rows that cannot be read, numbers that the points hardly determine."""
    rows: tuple[int, ...]
    """Indices of the arrays given that are points; others hold no finite number and were left out."""
    bad: tuple[int, ...]
    """Indices of points that do not belong to the others and were left out."""
    fitted: Floats
    """Longitudinal and lateral force (N) by the theory, a row for each of `rows`."""
    deviations: Floats
    """Distance of each of `rows` from the theory, in standard deviations of the points."""


def _numbers(report: Mapping[str, Any]) -> Fitted:
    low, high = report["interval_95"]
    return Fitted(report["value"], report["standard_error"], (low, high))


def fit(
    data: _creepage.CaseData,
    theory: str,
    options: dict[str, Any],
    columns: Mapping[str, ArrayLike],
    slope: bool,
) -> FrictionFit:
    """Fits a case to columns by name."""
    arrays = {name: floats(name, values) for name, values in columns.items()}
    given = np.broadcast_arrays(*arrays.values())
    pairs = [(name, array.ravel().tolist()) for name, array in zip(arrays, given, strict=True)]
    text, left_out = data.fit(theory, options, pairs, slope)
    report = json.loads(text)
    points = report["points"]
    return FrictionFit(
        theory=report["theory"],
        friction=_numbers(report["friction"]),
        slope=_numbers(report["slope"]) if report["slope"] else None,
        correlation=report["correlation"],
        scatter=report["scatter_over_normal_force"],
        reached=report["largest_force_over_mu_n"],
        cautions=(*report["cautions"], *left_out),
        rows=tuple(point["row"] - 1 for point in points),
        bad=tuple(point["row"] - 1 for point in points if point["use"] == "bad"),
        fitted=np.array([point["fitted_n"] for point in points]),
        deviations=np.array([point["deviations"] for point in points]),
    )
