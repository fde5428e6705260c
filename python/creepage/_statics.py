"""Problems without rolling, by the files of `creepage statics`."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from . import _creepage
from ._report import ReportedList
from ._results import Floats
from ._toml import Source, text_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


@dataclass(frozen=True, slots=True, eq=False)
class StaticsSolution(ReportedList):
    """One problem without rolling, solved, in SI units; x and y are along the ellipse's axes."""

    problem: str
    """ "die", "shift", "twist", "partial-slip", "shift-path", "compression" or "sheared-rectangle"."""
    given: dict[str, float]
    """What the problem was given, by names that carry their units."""
    found: dict[str, float]
    """What an engineer wants to know of it, by names that carry their units."""
    steps: list[dict[str, float]]
    """Of a path: force, shift, share of the area that adheres and energy turned to heat after each step, of a
    rectangle what has yielded and slid in place of the share; else empty."""
    caution: str | None
    """What looks like a number in another unit; else None."""
    _solved: _creepage.SolvedStatics
    _again: Callable[[], Any]

    def traction(self, x: ArrayLike, y: ArrayLike) -> Floats:
        """Tangential traction on the lower body (Pa) at (x, y) (m), shape (..., 2).

        Infinite on the edge where nothing slips. Raises ValueError for a die.
        """
        return self._solved.traction(x, y)

    def pressure(self, x: ArrayLike, y: ArrayLike) -> Floats:
        """Pressure under a die, between balls or on a rectangle (Pa), at (x, y) (m).

        Raises ValueError for other problems.
        """
        return self._solved.pressure(x, y)

    def displacement(self, x: ArrayLike, y: ArrayLike) -> Floats:
        """Displacement (m) at (x, y) (m), shape (..., 3): of the half-space under a die, of the
        bodies relative to each other else. Raises ValueError for paths and for balls, of which it is not known.
        """
        return self._solved.displacement(x, y)


def statics(source: Source | Mapping[str, Mapping[str, Any]]) -> StaticsSolution:
    """Solves a problem without rolling: a die, a shift, a twist, a shift with partial slip, one to and fro,
    unlike balls pressed together, or a layer sheared under a rectangle.

    source: the path of a statics file, its text (a string with line breaks), or its sections as
    a mapping. Raises CaseError for what is no problem, and where the bodies slide or the die
    lifts off; OSError for what cannot be read.
    """
    text = text_of(source)
    solved = _creepage.SolvedStatics(text)
    report = json.loads(solved.json())
    return StaticsSolution(
        report["problem"], report["given"], report["found"], report.get("steps", []), report["caution"],
        solved, partial(statics, text),
    )
