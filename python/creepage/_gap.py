"""Contacts of any shape: the undeformed distance of two bodies in, contact areas and forces out."""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _creepage
from ._contact import Body, columns, floats, instance, number
from ._report import FromFile, ReportedList
from ._report_parts import AreaContact
from ._solution import DimensionlessCreepage, SiCreepage, SiForce
from ._toml import dumps


class Gap:
    """The undeformed distance h(x, y) of two bodies in the plane of contact, in metres.

    x is the rolling direction. Pressed together by an approach, undeformed bodies would penetrate
    by the approach less h.
    """

    def __init__(self, section: Mapping[str, Any]) -> None:
        """section: as `[gap]` of a case file. Usually one of the class methods makes it."""
        self._section = dict(section)

    @classmethod
    def polynomial(cls, terms: Sequence[tuple[int, int, float]]) -> Gap:
        """h = sum of coefficient x^i y^j over the terms (i, j, coefficient)."""
        return cls({"polynomial": [_term(term) for term in terms]})

    @classmethod
    def section(
        cls,
        y: ArrayLike,
        gap: ArrayLike,
        *,
        radius_rolling: ArrayLike,
        x: ArrayLike | None = None,
    ) -> Gap:
        """h = gap(y) + (x - x(y))^2/(2 R): points across, and the radius along the rolling direction,
        a number or one a point. x: place of the least distance along x, zero if not given."""
        radius = floats("radius_rolling", radius_rolling)
        points = {"y": y, "gap": gap} | ({} if x is None else {"x": x})
        if radius.ndim == 0:
            return cls({"section": columns(points), "radius_rolling": float(radius)})
        return cls({"section": columns({**points, "radius_rolling": radius})})

    @classmethod
    def grid(cls, x: ArrayLike, y: ArrayLike, gap: ArrayLike) -> Gap:
        """gap[i, j] at (x[i], y[j]): a rectangular grid, both axes rising."""
        values = floats("gap", gap)
        places = np.meshgrid(floats("x", x), floats("y", y), indexing="ij")
        if values.shape != places[0].shape:
            raise ValueError(f"gap has the shape {values.shape}, x and y ask for {places[0].shape}")
        points = {"x": places[0], "y": places[1], "gap": values}
        return cls({"grid": columns({name: array.ravel() for name, array in points.items()})})

    @classmethod
    def groove(cls, inner: float, outer: float, *, rolling: float) -> Gap:
        """A round upper body of radius inner across and rolling along, in a straight groove of radius outer (m); with
        `GapCase(surface="curved")` the contact follows the groove."""
        radii = {"inner": inner, "outer": outer, "rolling": rolling}
        for name, value in radii.items():
            number(name, value)
        return cls({"groove": {name: float(value) for name, value in radii.items()}})

    def to_dict(self) -> dict[str, Any]:
        """As `[gap]` of a case file has it."""
        return dict(self._section)

    def __eq__(self, other: object) -> bool:
        """The same section of a case file."""
        return self._section == other._section if isinstance(other, Gap) else NotImplemented

    def __hash__(self) -> int:
        return hash(dumps({"gap": self._section}))

    def __repr__(self) -> str:
        return f"<creepage.Gap by {next(iter(self._section), 'nothing')}>"


def _term(term: Any) -> tuple[int, int, float]:
    """Exponents and coefficient. Raises TypeError and ValueError for other values."""
    try:
        i, j, coefficient = term
    except (TypeError, ValueError):
        raise ValueError(f"a term is (i, j, coefficient), not {term!r}") from None
    for name, value in (("exponent", i), ("exponent", j), ("coefficient", coefficient)):
        number(name, value)
        if name == "exponent" and not (value >= 0 and float(value).is_integer()):
            raise ValueError(
                f"exponent {value} in the term {term!r} is not valid: it must be a whole number "
                "that is not negative"
            )
    return int(i), int(j), float(coefficient)


@dataclass(frozen=True, slots=True, eq=False)
class GapSolution(ReportedList):
    """A contact of any shape, solved; all in SI units."""

    status: str
    """ "solved", or why not."""
    caution: str | None
    """Cautions about the solution, in words."""
    force: SiForce
    """On the lower body, the moment about the origin of coordinates."""
    force_error: SiForce | None
    """Error bars of the force; None by a theory without."""
    contact: AreaContact
    """Load, approach, area, peak pressure with error bars; also a dictionary, with `patches`, as in report.json."""
    _report: dict[str, Any]
    _solved: _creepage.SolvedGapData
    _again: Callable[[], Any]

    @property
    def theory(self) -> str:
        """Its name."""
        return str(self._report["theory"])

    @property
    def creepage(self) -> SiCreepage:
        """Given or found, at the origin of coordinates."""
        own = self._report["creepage"]
        return SiCreepage(own["longitudinal"], own["lateral"], own["spin_rad_per_m"])

    @property
    def dimensionless_creepage(self) -> DimensionlessCreepage:
        """The same in units of the contact."""
        own = self._report["creepage"]
        return DimensionlessCreepage(own["xi"], own["eta"], own["chi"])

    @property
    def dimensionless(self) -> tuple[float, float, float]:
        """Force and moment over mu N and mu N c."""
        own = self._report["dimensionless"]
        return (own["fx"], own["fy"], own["mz"])

    @property
    def friction(self) -> float:
        """Coefficient of friction mu."""
        return float(self._report["friction"])

    @property
    def friction_used(self) -> float:
        """The used share of the friction force mu N."""
        return float(self._report["friction_used"])

    @property
    def adhesion_share(self) -> float:
        """Adhesion area over contact area, 0 to 1."""
        return float(self._report["areas"]["adhesion_share"])

    @property
    def adhesion_area(self) -> float:
        """m^2."""
        return float(self._report["areas"]["adhesion_m2"])

    @property
    def slip_area(self) -> float:
        """m^2."""
        return float(self._report["areas"]["slip_m2"])

    @property
    def heat_per_metre(self) -> float:
        """Energy turned to heat per metre rolled, from force and creepage (J/m)."""
        return float(self._report["frictional_power_per_metre_j_per_m"])

    @property
    def heat_per_metre_by_slip(self) -> float | None:
        """The same from traction and slip over the contact (J/m), where the theory gives it."""
        heat: float | None = self._report["frictional_power_per_metre_by_slip_j_per_m"]
        return heat

    @property
    def speed(self) -> float | None:
        """Rolling velocity (m/s), where the case has it."""
        speed: float | None = self._report["rolling_velocity_m_per_s"]
        return speed

    @property
    def power(self) -> float | None:
        """Frictional power (W), where the rolling velocity is known."""
        power: float | None = self._report["frictional_power_w"]
        return power

    @property
    def heat(self) -> dict[str, Any] | None:
        """Temperatures as `heat` of `report.json` has them; None where the case asks for none."""
        heat: dict[str, Any] | None = self.to_dict()["heat"]
        return heat


class GapCase(FromFile):
    """One rolling contact of bodies of any shape, in SI units.

    Creepages, spin and moment are those at the origin of the gap's coordinates. Raises CaseError,
    which names section and key.
    """

    def __init__(
        self,
        *,
        gap: Gap,
        upper: Body,
        lower: Body,
        friction: float | Mapping[str, Any],
        normal_force: float | None = None,
        approach: float | None = None,
        longitudinal: float | None = None,
        lateral: float | None = None,
        spin: float | None = None,
        speed: float | None = None,
        longitudinal_force: float | None = None,
        lateral_force: float | None = None,
        moment: float | None = None,
        layer: Mapping[str, float] | None = None,
        damage: Mapping[str, Any] | None = None,
        heat: Mapping[str, Any] | None = None,
        surface: str = "plane",
        slip: Mapping[str, ArrayLike] | None = None,
        theory: str = "exact",
        **options: Any,
    ) -> None:
        """upper, lower: materials, without radii. Exactly one of normal_force (N) and approach (m).
        What differs from Case is the shape alone; surface: "plane", or "curved" for a groove; theory is one of exact, fastsim, fastrip,
        linear, saturated.
        """
        bodies = (("upper", upper), ("lower", lower))
        instance("gap", gap, Gap)
        for name, body in bodies:
            instance(name, body, Body)
        file: dict[str, Mapping[str, Any]] = {name: body.section(False) for name, body in bodies}
        file["gap"] = gap.to_dict()
        file["contact"] = {
            "normal_force": normal_force,
            "approach": approach,
            "friction": friction,
        }
        if surface != "plane":
            file["contact"] = {**file["contact"], "surface": surface}
        if slip is not None:
            file["contact"] = {**file["contact"], "slip": columns(slip)}
        file["creepage"] = {
            "longitudinal": longitudinal,
            "lateral": lateral,
            "spin": spin,
            "speed": speed,
        }
        file["wanted"] = {
            "longitudinal_force": longitudinal_force,
            "lateral_force": lateral_force,
            "moment": moment,
        }
        more = (("layer", layer), ("damage", damage), ("heat", heat))
        file |= {name: section for name, section in more if section is not None}
        file["solve"] = {"theory": theory, **options}
        self._read(dumps(file), Path())

    def _read(self, text: str, directory: Path) -> None:
        super()._read(text, directory)
        self._data = _creepage.GapData(text, directory)

    def solve(self, theory: str | None = None) -> GapSolution:
        """Presses the bodies together and rolls them, by the case's own theory or by the one of that
        name. Raises CaseError where there is no contact, NotReachable where no creepage gives the
        wanted forces. A caution is warned of."""
        return _solution(self._data.solve(theory), partial(self.solve, theory), stacklevel=3)

    @staticmethod
    def solve_all(
        cases: Sequence[GapCase], theory: str | None = None
    ) -> list[GapSolution | Exception]:
        """Many cases on all cores, in their order. What cannot be solved stands as the exception that
        `solve` raises."""
        for k, case in enumerate(cases):
            instance(f"cases[{k}]", case, GapCase)
        answers = _creepage.solve_gaps([case._data for case in cases], theory)
        return [
            _solution(answer, partial(case.solve, theory), stacklevel=4)
            if isinstance(answer, _creepage.SolvedGapData)
            else answer
            for case, answer in zip(cases, answers, strict=True)
        ]


def _solution(
    solved: _creepage.SolvedGapData, again: Callable[[], Any], stacklevel: int
) -> GapSolution:
    report = json.loads(solved.json())
    if report["caution"] is not None:
        warnings.warn(report["caution"], UserWarning, stacklevel=stacklevel)
    lower = report["lower_body"]
    names = ("longitudinal", "lateral", "moment")
    units = ("n", "n", "n_m")
    force = SiForce(*(lower[f"{name}_{unit}"] for name, unit in zip(names, units, strict=True)))
    errors = [lower[f"{name}_error_{unit}"] for name, unit in zip(names, units, strict=True)]
    error = None if None in errors else SiForce(*errors)
    contact = AreaContact(report["contact"])
    return GapSolution(report["status"], report["caution"], force, error, contact, report, solved, again)
