"""One case solved, in SI units."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _creepage
from ._contact import Hertz
from ._results import Field, Force, ScalarForce, Status

if TYPE_CHECKING:
    import os

    from matplotlib.axes import Axes


class SiCreepage(NamedTuple):
    """Creepage of the upper body relative to the lower, over the rolling velocity."""

    longitudinal: float
    lateral: float
    spin: float
    """rad/m."""


class SiForce(NamedTuple):
    """Tangential force and moment of the upper body on the lower."""

    longitudinal: float
    """N."""
    lateral: float
    """N."""
    moment: float
    """N m."""


@dataclass(frozen=True, slots=True, eq=False)
class Solution:
    """One case solved by one theory, in SI units."""

    theory: _creepage.Theory
    """The theory, prepared for this contact; ask it for more."""
    status: Status
    caution: str | None
    """What the theory leaves out of the case though it matters, in words."""
    force: SiForce
    """On the lower body; the upper body feels the reverse."""
    dimensionless: ScalarForce
    """The same in units of mu N and mu N c."""
    creepage: SiCreepage
    contact: Hertz
    friction: float
    adhesion_share: float
    """Adhesion area over contact area, 0 to 1."""
    adhesion_area: float
    """m^2."""
    slip_area: float
    """m^2."""
    heat_per_metre: float
    """Energy turned to heat per metre rolled, from force and creepage (J/m)."""
    heat_per_metre_by_slip: float | None
    """The same from traction and slip over the contact (J/m), where the theory gives it; the two
    differ by the error of its discretization."""
    speed: float | None
    """Rolling velocity (m/s), where the case has it."""
    power: float | None
    """Frictional power (W), where the rolling velocity is known."""
    known: tuple[str, ...] | None
    """Which of xi, eta, chi, fx, fy, mz were given, where forces were wanted."""
    details: dict[str, float]
    """What only this theory says, such as error bars, by name."""
    _report: dict[str, Any]
    _solved: _creepage.SolvedCase

    @classmethod
    def from_report(
        cls, report: dict[str, Any], theory: _creepage.Theory, solved: _creepage.SolvedCase
    ) -> Solution:
        """From what `report.json` holds."""
        status = Status[report["status"].upper()]
        force, creepage = report["lower_body"], report["creepage"]
        own, areas = report["dimensionless"], report["areas"]
        names = ("longitudinal_n", "lateral_n", "moment_n_m")
        return cls(
            theory=theory,
            status=status,
            caution=report["caution"],
            force=SiForce(*(force[name] for name in names)),
            dimensionless=Force(own["fx"], own["fy"], own["mz"], status),
            creepage=SiCreepage(
                creepage["longitudinal"], creepage["lateral"], creepage["spin_rad_per_m"]
            ),
            contact=Hertz.from_report(report["contact"]),
            friction=report["friction"],
            adhesion_share=areas["adhesion_share"],
            adhesion_area=areas["adhesion_m2"],
            slip_area=areas["slip_m2"],
            heat_per_metre=report["frictional_power_per_metre_j_per_m"],
            heat_per_metre_by_slip=report["frictional_power_per_metre_by_slip_j_per_m"],
            speed=report["rolling_velocity_m_per_s"],
            power=report["frictional_power_w"],
            known=None if report["known"] is None else tuple(report["known"]),
            details={name: detail["value"] for name, detail in report["details"].items()},
            _report=report,
            _solved=solved,
        )

    @property
    def length(self) -> float:
        """The unit of length, c = sqrt(a b) (m)."""
        contact = self.contact
        return float(np.sqrt(contact.semi_axis_rolling * contact.semi_axis_lateral))

    def to_dict(self) -> dict[str, Any]:
        """What `report.json` holds; the names carry their units."""
        report: dict[str, Any] = json.loads(json.dumps(self._report))
        return report

    def field(self, points: int = 50) -> Field:
        """Traction and slip at points x points cells, dimensionless."""
        creepage = self._report["creepage"]
        return self.theory.field(creepage["xi"], creepage["eta"], creepage["chi"], points=points)

    def points(self) -> Field:
        """Traction and slip at the theory's own points, dimensionless."""
        return self._solved.points()

    def text(self) -> str:
        """A short report for a terminal."""
        return self._solved.text()

    def svg(self) -> str:
        """The contact seen from above: adhesion, slip and traction."""
        return self._solved.svg()

    _repr_svg_ = svg

    def save(self, directory: str | os.PathLike[str]) -> list[Path]:
        """Writes report.json, points.csv, contact.svg, .png and .vtk into the directory.

        It is made when missing; files of those names are replaced, all of them or none. Gives
        their paths. Raises OSError.
        """
        return [Path(path) for path in self._solved.write(Path(directory))]

    def plot(self, ax: Axes | None = None) -> Axes:
        """Areas of adhesion and slip and the traction, in millimetres. Needs matplotlib."""
        from ._plot import plot_solution

        return plot_solution(self, ax)
